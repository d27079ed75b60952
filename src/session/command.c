/* The table of commands. Invariant: a command that was decoded can be applied to any world, which
 * does it or refuses it; numbers are checked by the world, lengths and kinds here. */
#include "session/command.h"

#include "base/assert.h"
#include "base/exact.h"
#include "skvalp/parameters.h"
#include "skvalp/particles.h"
#include "world/forces.h"
#include "world/hands.h"
#include "world/liquids.h"

#include <string.h>

/* ---- Nothing but a place in the log ---------------------------------------------------------- */

static skv_result do_nothing(const skv_command *command, skv_world *world, skv_error *error)
{
    (void)command, (void)world, (void)error;
    return SKV_OK;
}

static bool code_nothing(skv_command *command, const skv_command *last, skv_coder *coder)
{
    (void)command, (void)last, (void)coder;
    return true;
}

static bool code_hash(skv_command *command, const skv_command *last, skv_coder *coder)
{
    (void)last;
    skv_exchange(&coder->port, &command->hash, 8);
    return true;
}

/* ---- Hands ----------------------------------------------------------------------------------- */

static skv_result set_hands(const skv_command *command, skv_world *world, skv_error *error)
{
    return skv_world_set_hands(world, command->hands.list, command->hands.count, error);
}

/* As it goes on, if it goes on as it did. */
static float ahead(float last, float before)
{
    return (float)(2 * (double)last - (double)before);
}

static void code_hand(skv_hand *hand, const skv_hand *last, const skv_hand *before,
                      skv_coder *coder)
{
    skv_code_float(coder, &hand->x, ahead(last->x, before->x), SKV_UNIT_LENGTH);
    skv_code_float(coder, &hand->y, ahead(last->y, before->y), SKV_UNIT_LENGTH);
    skv_code_float(coder, &hand->vx, last->vx, SKV_UNIT_SPEED);
    skv_code_float(coder, &hand->vy, last->vy, SKV_UNIT_SPEED);
    skv_code_float(coder, &hand->radius, last->radius, SKV_UNIT_LENGTH);
    skv_code_float(coder, &hand->attraction, last->attraction, SKV_UNIT_SPEED);
    skv_code_float(coder, &hand->friction, last->friction, SKV_UNIT_SPEED);
    skv_code_float(coder, &hand->follow, last->follow, SKV_UNIT_SPEED);
}

/* The first byte of hands, of which some hold bodies. */
enum { HOLDING = 128 };

static uint64_t begin_hands(const skv_hands *hands)
{
    uint64_t begin = (uint64_t)hands->count;
    for (int i = 0; i < hands->count; i++)
        if (hands->list[i].body)
            begin |= HOLDING;
    return begin;
}

static bool code_hands(skv_command *command, const skv_command *last, skv_coder *coder)
{
    uint64_t begin = begin_hands(&command->hands), count;
    skv_exchange(&coder->port, &begin, 1);
    count = begin & ~(uint64_t)HOLDING;
    if (count > SKV_MAX_HANDS)
        return false;
    command->hands.count = (int)count;
    for (int i = 0; i < command->hands.count; i++) {
        skv_hand *hand = &command->hands.list[i];
        code_hand(hand, &last[0].hands.list[i], &last[1].hands.list[i], coder);
        if (begin & HOLDING)
            skv_exchange_held(&coder->port, hand);
    }
    return true;
}

/* ---- Gravity and pushes ---------------------------------------------------------------------- */

static skv_result set_gravity(const skv_command *command, skv_world *world, skv_error *error)
{
    return skv_world_set_gravity(world, command->vector.x, command->vector.y, error);
}

static skv_result push(const skv_command *command, skv_world *world, skv_error *error)
{
    return skv_world_add_velocity(world, 0, skv_world_particle_count(world), command->vector.x,
                                  command->vector.y, error);
}

static bool code_gravity(skv_command *command, const skv_command *last, skv_coder *coder)
{
    skv_code_float(coder, &command->vector.x, last->vector.x, SKV_UNIT_GRAVITY);
    skv_code_float(coder, &command->vector.y, last->vector.y, SKV_UNIT_GRAVITY);
    return true;
}

static bool code_push(skv_command *command, const skv_command *last, skv_coder *coder)
{
    skv_code_float(coder, &command->vector.x, last->vector.x, SKV_UNIT_SPEED);
    skv_code_float(coder, &command->vector.y, last->vector.y, SKV_UNIT_SPEED);
    return true;
}

/* ---- Parameters ------------------------------------------------------------------------------ */

static skv_result set_parameter(const skv_command *command, skv_world *world, skv_error *error)
{
    return skv_world_set(world, command->set.path, command->set.text, error);
}

static bool code_set(skv_command *command, const skv_command *last, skv_coder *coder)
{
    (void)last;
    return skv_code_text(coder, command->set.path, sizeof command->set.path) &&
           skv_code_text(coder, command->set.text, sizeof command->set.text);
}

/* ---- Water ----------------------------------------------------------------------------------- */

static skv_area area_of(const skv_dab *dab)
{
    return skv_swept_circle(dab->x0, dab->y0, dab->x1, dab->y1, dab->radius);
}

static skv_result pour(const skv_command *command, skv_world *world, skv_error *error)
{
    const skv_dab *dab = &command->water;
    skv_area area = area_of(dab);
    skv_fill_def fill = skv_default_fill_def();
    fill.x0 = skv_minf(dab->x0, dab->x1) - dab->radius;
    fill.y0 = skv_minf(dab->y0, dab->y1) - dab->radius;
    fill.x1 = skv_maxf(dab->x0, dab->x1) + dab->radius;
    fill.y1 = skv_maxf(dab->y0, dab->y1) + dab->radius;
    fill.vx = dab->vx;
    fill.vy = dab->vy;
    fill.dye = dab->dye;
    fill.fluid = dab->fluid;
    fill.area = &area;
    fill.aligned = true;
    return skv_world_fill(world, &fill, NULL, error);
}

static skv_result take(const skv_command *command, skv_world *world, skv_error *error)
{
    skv_area area = area_of(&command->water);
    return skv_world_remove_area(world, &area, NULL, error);
}

/* A brush goes on where it was. */
static bool code_water(skv_command *command, const skv_command *last, skv_coder *coder)
{
    skv_dab *dab = &command->water;
    const skv_dab *was = &last->water;
    skv_code_float(coder, &dab->x0, was->x1, SKV_UNIT_LENGTH);
    skv_code_float(coder, &dab->y0, was->y1, SKV_UNIT_LENGTH);
    skv_code_float(coder, &dab->x1, ahead(dab->x0, was->x0), SKV_UNIT_LENGTH);
    skv_code_float(coder, &dab->y1, ahead(dab->y0, was->y0), SKV_UNIT_LENGTH);
    skv_code_float(coder, &dab->radius, was->radius, SKV_UNIT_LENGTH);
    skv_code_float(coder, &dab->vx, was->vx, SKV_UNIT_SPEED);
    skv_code_float(coder, &dab->vy, was->vy, SKV_UNIT_SPEED);
    return true;
}

static bool code_dyed_water(skv_command *command, const skv_command *last, skv_coder *coder)
{
    skv_exchange_contents(&coder->port, &command->water.dye, &command->water.fluid);
    return code_water(command, last, coder);
}

/* ---- Walls ----------------------------------------------------------------------------------- */

static skv_result paint(const skv_command *command, skv_world *world, skv_error *error)
{
    skv_terrain *painted = NULL;
    const skv_strokes *strokes = &command->paint;
    skv_result result =
        skv_terrain_paint(skv_world_terrain(world), strokes->list, strokes->count, &painted, error);
    if (result == SKV_OK)
        result = skv_world_set_terrain(world, painted, NULL, error);
    if (result != SKV_OK)
        skv_terrain_destroy(painted);
    return result;
}

static void code_stroke(skv_brush_stroke *stroke, const skv_brush_stroke *was, skv_coder *coder)
{
    uint64_t erase = stroke->erase;
    skv_code_float(coder, &stroke->x0, was->x1, SKV_UNIT_LENGTH);
    skv_code_float(coder, &stroke->y0, was->y1, SKV_UNIT_LENGTH);
    skv_code_float(coder, &stroke->x1, ahead(stroke->x0, was->x0), SKV_UNIT_LENGTH);
    skv_code_float(coder, &stroke->y1, ahead(stroke->y0, was->y0), SKV_UNIT_LENGTH);
    skv_code_float(coder, &stroke->radius, was->radius, SKV_UNIT_LENGTH);
    skv_exchange(&coder->port, &erase, 1);
    stroke->erase = erase != 0;
}

static bool code_strokes(skv_command *command, const skv_command *last, skv_coder *coder)
{
    uint64_t count = (uint64_t)command->paint.count;
    skv_exchange(&coder->port, &count, 1);
    if (count > SKV_MOST_STROKES)
        return false;
    command->paint.count = (int)count;
    const skv_brush_stroke *was = &last->paint.list[0];
    for (int i = 0; i < command->paint.count; i++) {
        code_stroke(&command->paint.list[i], was, coder);
        was = &command->paint.list[i];
    }
    return true;
}

/* ---- Emitters and drains --------------------------------------------------------------------- */

static skv_result emit(const skv_command *command, skv_world *world, skv_error *error)
{
    skv_emitter list[SKV_MAX_EMITTERS + 1];
    int count;
    const skv_emitter *old = skv_world_emitters(world, &count);
    for (int i = 0; i < count; i++)
        list[i] = old[i];
    list[count] = command->source;
    return skv_world_set_emitters(world, list, count + 1, error);
}

static bool code_source(skv_command *command, const skv_command *last, skv_coder *coder)
{
    skv_emitter *source = &command->source;
    skv_code_float(coder, &source->x, last->source.x, SKV_UNIT_LENGTH);
    skv_code_float(coder, &source->y, last->source.y, SKV_UNIT_LENGTH);
    skv_code_float(coder, &source->vx, last->source.vx, SKV_UNIT_SPEED);
    skv_code_float(coder, &source->vy, last->source.vy, SKV_UNIT_SPEED);
    skv_code_float(coder, &source->width, last->source.width, SKV_UNIT_LENGTH);
    skv_exchange_contents(&coder->port, &source->dye, &source->fluid);
    return true;
}

static skv_result drain(const skv_command *command, skv_world *world, skv_error *error)
{
    skv_drain list[SKV_MAX_DRAINS + 1];
    int count;
    const skv_drain *old = skv_world_drains(world, &count);
    for (int i = 0; i < count; i++)
        list[i] = old[i];
    list[count] = (skv_drain){.area = area_of(&command->water)};
    return skv_world_set_drains(world, list, count + 1, error);
}

/* Whether a brush on its way comes over a point. */
static bool covers(const skv_dab *dab, float x, float y)
{
    double dx = (double)dab->x1 - (double)dab->x0, dy = (double)dab->y1 - (double)dab->y0;
    double px = (double)x - (double)dab->x0, py = (double)y - (double)dab->y0;
    double length = dx * dx + dy * dy;
    double share = length > 0 ? skv_min(skv_max((px * dx + py * dy) / length, 0), 1) : 0;
    px -= share * dx;
    py -= share * dy;
    return px * px + py * py <= (double)dab->radius * (double)dab->radius;
}

/* The middle of an area; a polygon has none that one could aim at. */
static bool is_covered(const skv_area *area, const skv_dab *dab)
{
    bool two = area->kind == SKV_AREA_BOX || area->kind == SKV_AREA_SWEPT_CIRCLE;
    float x = two ? 0.5f * (area->x0 + area->x1) : area->x0;
    float y = two ? 0.5f * (area->y0 + area->y1) : area->y0;
    return area->kind != SKV_AREA_POLYGON && covers(dab, x, y);
}

static skv_result close_emitters(const skv_dab *dab, skv_world *world, skv_error *error)
{
    skv_emitter list[SKV_MAX_EMITTERS];
    int count, left = 0;
    const skv_emitter *old = skv_world_emitters(world, &count);
    for (int i = 0; i < count; i++)
        if (!covers(dab, old[i].x, old[i].y))
            list[left++] = old[i];
    return left < count ? skv_world_set_emitters(world, list, left, error) : SKV_OK;
}

static skv_result close_drains(const skv_dab *dab, skv_world *world, skv_error *error)
{
    skv_drain list[SKV_MAX_DRAINS];
    int count, left = 0;
    const skv_drain *old = skv_world_drains(world, &count);
    for (int i = 0; i < count; i++)
        if (!is_covered(&old[i].area, dab))
            list[left++] = old[i];
    return left < count ? skv_world_set_drains(world, list, left, error) : SKV_OK;
}

/* Fans show where they are; the forces of a scene, which need not, stay. */
static skv_result close_fans(const skv_dab *dab, skv_world *world, skv_error *error)
{
    skv_force list[SKV_MAX_FORCES];
    int count, left = 0;
    const skv_force *old = skv_world_forces(world, &count);
    for (int i = 0; i < count; i++)
        if (old[i].area.kind != SKV_AREA_SWEPT_CIRCLE || !is_covered(&old[i].area, dab))
            list[left++] = old[i];
    return left < count ? skv_world_set_forces(world, list, left, error) : SKV_OK;
}

static skv_result close_all(const skv_command *command, skv_world *world, skv_error *error)
{
    skv_result result = close_emitters(&command->water, world, error);
    if (result == SKV_OK)
        result = close_drains(&command->water, world, error);
    if (result == SKV_OK)
        result = close_fans(&command->water, world, error);
    if (result == SKV_OK)
        skv_drop_take(&command->water, world);
    return result;
}

/* What the brush comes over, and what is to come from taps under it. */
static skv_result dye(const skv_command *command, skv_world *world, skv_error *error)
{
    const skv_dab *dab = &command->water;
    skv_area area = area_of(dab);
    skv_result result = skv_world_dye_area(world, &area, dab->dye, NULL, error);
    skv_emitter list[SKV_MAX_EMITTERS];
    int count;
    const skv_emitter *old = skv_world_emitters(world, &count);
    bool changed = false;
    for (int i = 0; i < count; i++) {
        list[i] = old[i];
        if (list[i].dye != dab->dye && covers(dab, list[i].x, list[i].y)) {
            list[i].dye = dab->dye;
            changed = true;
        }
    }
    if (result == SKV_OK && changed)
        result = skv_world_set_emitters(world, list, count, error);
    return result;
}

/* ---- Forces ---------------------------------------------------------------------------------- */

static skv_result change_force(const skv_command *command, skv_world *world, skv_error *error)
{
    const skv_force_change *change = &command->force;
    skv_force list[SKV_MAX_FORCES + 1];
    int count;
    const skv_force *old = skv_world_forces(world, &count);
    bool more = change->place == -1 && !change->remove;
    if (!more && (change->place < 0 || change->place >= count))
        return skv_fail(error, SKV_ERROR_VALUE, "no force has the place %d; there are %d",
                        change->place, count);
    for (int i = 0; i < count; i++)
        list[i] = old[i];
    if (change->remove) {
        count--;
        for (int i = change->place; i < count; i++)
            list[i] = old[i + 1];
    } else {
        list[more ? count++ : change->place] = change->force;
    }
    return skv_world_set_forces(world, list, count, error);
}

/* Plainly always: they are few. */
static bool code_force(skv_command *command, const skv_command *last, skv_coder *coder)
{
    (void)last;
    skv_force_change *change = &command->force;
    uint64_t place = (uint64_t)change->place + 1, remove = change->remove;
    skv_exchange(&coder->port, &place, 1);
    skv_exchange(&coder->port, &remove, 1);
    change->place = (int)place - 1;
    change->remove = remove != 0;
    if (!change->remove)
        skv_exchange_force(&coder->port, &change->force);
    return true;
}

/* ---- Bodies ---------------------------------------------------------------------------------- */

static skv_result drop(const skv_command *command, skv_world *world, skv_error *error)
{
    return skv_drop_apply(&command->drop, world, error);
}

/* ---- The table ------------------------------------------------------------------------------- */

/* `code` writes or reads what belongs to a command; `last` are the last one of its kind and the one
 * before, which packed ones are told by. It is false if what was read is none. */
static const struct row {
    skv_result (*apply)(const skv_command *, skv_world *, skv_error *);
    bool (*code)(skv_command *, const skv_command last[2], skv_coder *);
} rows[SKV_COMMAND_KINDS] = {
    [SKV_COMMAND_MARK] = {do_nothing, code_nothing},
    [SKV_COMMAND_CHECK] = {do_nothing, code_hash},
    [SKV_COMMAND_HANDS] = {set_hands, code_hands},
    [SKV_COMMAND_GRAVITY] = {set_gravity, code_gravity},
    [SKV_COMMAND_PUSH] = {push, code_push},
    [SKV_COMMAND_SET] = {set_parameter, code_set},
    [SKV_COMMAND_POUR] = {pour, code_dyed_water},
    [SKV_COMMAND_TAKE] = {take, code_water},
    [SKV_COMMAND_PAINT] = {paint, code_strokes},
    [SKV_COMMAND_EMIT] = {emit, code_source},
    [SKV_COMMAND_DRAIN] = {drain, code_water},
    [SKV_COMMAND_CLOSE] = {close_all, code_water},
    [SKV_COMMAND_DYE] = {dye, code_dyed_water},
    [SKV_COMMAND_FORCE] = {change_force, code_force},
    [SKV_COMMAND_DROP] = {drop, skv_drop_code},
};

bool skv_command_changes_balance(skv_command_kind kind)
{
    return kind == SKV_COMMAND_GRAVITY || kind == SKV_COMMAND_SET || kind == SKV_COMMAND_POUR ||
           kind == SKV_COMMAND_TAKE || kind == SKV_COMMAND_PAINT || kind == SKV_COMMAND_CLOSE ||
           kind == SKV_COMMAND_FORCE || kind == SKV_COMMAND_DROP;
}

skv_result skv_command_apply(const skv_command *command, skv_world *world, skv_error *error)
{
    SKV_ASSERT_OR((unsigned)command->kind < SKV_COMMAND_KINDS, SKV_ERROR_VALUE);
    return rows[command->kind].apply(command, world, error);
}

static bool decode_rest(skv_command *command, const skv_command *last, skv_coder *coder)
{
    return rows[command->kind].code(command, last, coder) && !coder->port.from->failed;
}

static const skv_command none[2];

void skv_command_encode(const skv_command *command, skv_writer *writer)
{
    skv_command copy = *command;
    skv_coder coder = {.port.to = writer};
    skv_put(writer, (uint64_t)command->kind, 1);
    rows[command->kind].code(&copy, none, &coder);
}

bool skv_command_decode(skv_command *command, skv_reader *reader)
{
    skv_coder coder = {.port.from = reader};
    memset(command, 0, sizeof *command);
    unsigned kind = (unsigned)skv_get(reader, 1);
    if (reader->failed || kind >= SKV_COMMAND_KINDS)
        return false;
    command->kind = (skv_command_kind)kind;
    return decode_rest(command, none, &coder);
}

/* ---- Packed ---------------------------------------------------------------------------------- */

static void remember(skv_packer *packer, const skv_command *command)
{
    skv_command *last = packer->last[command->kind];
    last[1] = last[0];
    last[0] = *command;
}

void skv_command_pack(const skv_command *command, skv_packer *packer, skv_writer *writer)
{
    skv_command copy = *command;
    skv_coder coder = {.port.to = writer, .units = packer->units};
    rows[command->kind].code(&copy, packer->last[command->kind], &coder);
    remember(packer, command);
}

bool skv_command_unpack(skv_command_kind kind, skv_command *command, skv_packer *packer,
                        skv_reader *reader)
{
    skv_coder coder = {.port.from = reader, .units = packer->units};
    memset(command, 0, sizeof *command);
    command->kind = kind;
    if (!decode_rest(command, packer->last[kind], &coder))
        return false;
    remember(packer, command);
    return true;
}
