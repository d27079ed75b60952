/* The format of a snapshot (docs/snapshot.md): writing it, and reading it whoever wrote it.
 *
 * Invariant: what skv_snapshot_read has let through can become the state of a world: every number
 * is finite and in its range, and every length has been compared with the bytes that are there.
 */
#include "world/snapshot.h"

#include "base/assert.h"
#include "base/envelope.h"
#include "terrain/terrain.h"
#include "world/air/air.h"
#include "world/bodies/bodies.h"
#include "world/hands.h"
#include "world/liquids.h"
#include "world/names.h"
#include "world/parameters.h"
#include "world/springs/springs.h"

#include <math.h>
#include <string.h>

enum {
    WITH_TERRAIN = 1,
    SUBSTEPS_FIXED = 2,
    WITH_LOAD = 4,
    WITH_WARM = 8,
    WITH_NAMES = 16,
    WITH_RAMP = 32,          /* of a world on its way, so that others are read by older libraries */
    WITH_FLUIDS = 64,        /* of a world with several fluids, likewise; and SKV_LIQUID_EXTRAS */
    WITH_BODIES = 128,       /* of a world that has had bodies, likewise */
    WITH_HOLDS = 256,        /* of one whose hands hold some, likewise */
    WITH_AIR = 1024,         /* of one whose air pushes, likewise */
    WITH_COMPRESSION = 4096, /* of one whose fluid makes up for its compression, likewise */
    WITH_TOUCHES = 16384,    /* of one whose bodies lie on something, likewise */
    WITH_STILL = 32768       /* of one with a body that sleep watches, likewise */
};

static const skv_envelope kind = {"snapshot", 'V', 1, 1,
                                  WITH_TERRAIN | SUBSTEPS_FIXED | WITH_LOAD | WITH_WARM |
                                      WITH_NAMES | WITH_RAMP | WITH_FLUIDS | WITH_BODIES |
                                      WITH_HOLDS | WITH_AIR | WITH_COMPRESSION | WITH_TOUCHES |
                                      WITH_STILL | SKV_LIQUID_EXTRAS};

/* ---- Writing --------------------------------------------------------------------------------- */

/* Not those that say nothing about the state: the host's, and the material, a name for two others.
 */
static bool is_saved(int parameter)
{
    return parameter != SKV_P_FLUID_MATERIAL && parameter != SKV_P_THREADS &&
           parameter != SKV_P_CAPACITY && parameter != SKV_P_INSTRUCTION_SET;
}

static void put_parameters(skv_writer *w, const skv_world *world)
{
    int saved = 0;
    skv_world_def def = skv_world_describe(world);
    for (int i = 0; i < SKV_P_COUNT; i++)
        saved += is_saved(i);
    skv_put(w, (uint64_t)saved, 2);
    for (int i = 0; i < SKV_P_COUNT; i++) {
        if (!is_saved(i))
            continue;
        skv_put_text(w, skv_world_field(i)->path);
        skv_put_double(w, skv_parameter_load(&def, (skv_parameter)i));
    }
}

static void put_facts(skv_writer *w, const skv_world *world)
{
    skv_put_double(w, world->time);
    skv_put(w, (uint64_t)world->steps, 8);
    skv_put_double(w, world->due);
    skv_put_float(w, world->filled);
    skv_put(w, world->next_id, 4);
    skv_put_double(w, world->sleep.watched);
    skv_put(w, (uint64_t)world->sleep.stepped, 4);
    skv_put(w, (uint64_t)world->load.most, 4);
    skv_put(w, (uint64_t)world->load.wanted, 4);
    skv_put_float(w, world->load.stiffness);
    skv_put_float(w, world->load.peak);
    if (world->compression > 0)
        skv_put_float(w, world->compression);
    if (world->ramp.left > 0) {
        skv_put_double(w, world->ramp.left);
        for (int i = 0; i < SKV_RAMP_NUMBERS; i++)
            skv_put_float(w, world->ramp.now[i]);
    }
    if (world->fluid_count > 1) {
        skv_world_def def = skv_world_describe(world);
        skv_exchange_liquids(&(skv_port){.to = w}, &def, skv_world_liquid_extras(world));
    }
    skv_acting acting = world->acting;
    skv_exchange_acting(&(skv_port){.to = w}, &acting, world->fluid_count, NULL);
    skv_exchange_names(&(skv_port){.to = w}, &acting, NULL);
    if (skv_hands_hold_bodies(&acting))
        skv_exchange_holds(&(skv_port){.to = w}, &acting, NULL);
    if (world->bodies)
        skv_bodies_save(w, world->bodies);
    if (skv_world_is_springy(world))
        skv_springs_save(w, world->springs);
    if (world->air)
        skv_air_save(w, world->air);
}

/* The picture in runs of equal bytes, from the lower left corner on. */
static void put_terrain(skv_writer *w, const skv_terrain *terrain)
{
    skv_put(w, (uint64_t)terrain->width, 4);
    skv_put(w, (uint64_t)terrain->height, 4);
    skv_put_float(w, terrain->pixel_size);
    skv_put(w, terrain->open_sides, 4);
    unsigned run = 0;
    uint8_t value = 0;
    for (int y = 0; y < terrain->height; y++) {
        const uint8_t *row = skv_terrain_row(terrain, y);
        for (int x = 0; x < terrain->width; x++) {
            if (run > 0 && (row[x] != value || run == UINT16_MAX)) {
                skv_put(w, value, 1);
                skv_put(w, run, 2);
                run = 0;
            }
            value = row[x];
            run++;
        }
    }
    skv_put(w, value, 1);
    skv_put(w, run, 2);
}

static void put_float(skv_writer *w, float value)
{
    skv_put_float(w, value);
}

static void put_uint32_t(skv_writer *w, uint32_t value)
{
    skv_put(w, value, 4);
}

static void put_uint8_t(skv_writer *w, uint8_t value)
{
    skv_put(w, value, 1);
}

static void put_particles(skv_writer *w, const skv_world *world)
{
    const skv_state *s = &world->state;
    skv_put(w, (uint64_t)s->count, 4);
    skv_put(w, 0, 4); /* that many arrays a solver had, once */
    unsigned holds = SKV_SAVED | SKV_SAVED_WITH_WARM;
    if (world->fluid_count > 1)
        holds |= SKV_SAVED_WITH_FLUIDS;
#define PUT(type, name, saved)                                                                     \
    for (int i = 0; (holds & (saved)) && i < s->count; i++)                                        \
        put_##type(w, s->name[i]);
    SKV_STATE_ARRAYS(PUT)
#undef PUT
}

static size_t write_all(const skv_world *world, bool with_terrain, uint8_t *bytes)
{
    skv_writer writer = {bytes, 0}, *w = &writer;
    skv_envelope_put(
        w, &kind,
        WITH_LOAD | WITH_WARM | WITH_NAMES | (with_terrain ? WITH_TERRAIN : 0u) |
            (world->ramp.left > 0 ? WITH_RAMP : 0u) | (world->fluid_count > 1 ? WITH_FLUIDS : 0u) |
            (skv_hands_hold_bodies(&world->acting) ? WITH_HOLDS : 0u) |
            (world->bodies ? WITH_BODIES : 0u) |
            (skv_bodies_touch(world->bodies) ? WITH_TOUCHES : 0u) |
            (skv_bodies_are_watched(world->bodies) ? WITH_STILL : 0u) |
            (world->air ? WITH_AIR : 0u) | (world->compression > 0 ? WITH_COMPRESSION : 0u) |
            skv_world_liquid_extras(world) | (world->substeps_fixed ? SUBSTEPS_FIXED : 0u));
    skv_put(w, world->terrain->hash, 8);
    put_parameters(w, world);
    put_facts(w, world);
    if (with_terrain)
        put_terrain(w, world->terrain);
    put_particles(w, world);
    if (bytes)
        skv_envelope_seal(bytes, writer.used);
    return writer.used;
}

size_t skv_world_snapshot_size(const skv_world *world, bool with_terrain)
{
    SKV_ASSERT_OR(world, 0);
    return write_all(world, with_terrain, NULL);
}

skv_result skv_world_save(const skv_world *world, bool with_terrain, void *data, size_t size,
                          skv_error *error)
{
    SKV_ASSERT_OR(skv_may_step(world) && data, SKV_ERROR_VALUE);
    size_t needed = skv_world_snapshot_size(world, with_terrain);
    if (size < needed)
        return skv_fail(error, SKV_ERROR_LIMIT, "snapshot: %zu bytes are too few; it takes %zu",
                        size, needed);
    if (skv_world_stats(world).not_finite)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "snapshot: a particle is not finite; take more substeps");
    write_all(world, with_terrain, data);
    return SKV_OK;
}

/* ---- Reading --------------------------------------------------------------------------------- */

static skv_result refuse(skv_error *error, const char *what)
{
    return skv_fail(error, SKV_ERROR_FORMAT, "snapshot: %s", what);
}

static skv_result read_head(skv_reader *r, skv_snapshot *s, skv_error *error)
{
    unsigned flags;
    if (!skv_envelope_is(&kind, r->bytes, r->size))
        return refuse(error, "this is not one; take a file that Skvalp has saved");
    skv_result result = skv_envelope_open(r, &kind, &flags, error);
    if (result != SKV_OK)
        return result;
    s->terrain_hash = skv_get(r, 8);
    s->with_terrain = flags & WITH_TERRAIN;
    s->substeps_fixed = flags & SUBSTEPS_FIXED;
    s->with_load = flags & WITH_LOAD;
    s->with_names = flags & WITH_NAMES;
    s->with_ramp = flags & WITH_RAMP;
    s->with_fluids = flags & WITH_FLUIDS;
    s->with_holds = flags & WITH_HOLDS;
    s->with_bodies = flags & WITH_BODIES;
    s->with_touches = flags & WITH_TOUCHES;
    s->liquid_extras = flags & SKV_LIQUID_EXTRAS;
    s->with_air = flags & WITH_AIR;
    s->with_compression = flags & WITH_COMPRESSION;
    if ((s->liquid_extras && !s->with_fluids) || (s->with_touches && !s->with_bodies))
        return refuse(error, "it is damaged; take another copy");
    s->holds = SKV_SAVED | (flags & WITH_WARM ? SKV_SAVED_WITH_WARM : 0u) |
               (flags & WITH_FLUIDS ? SKV_SAVED_WITH_FLUIDS : 0u);
    return SKV_OK;
}

/* A parameter that is not in the snapshot has its default. */
static skv_result read_parameters(skv_reader *r, skv_snapshot *s, skv_error *error)
{
    int count = (int)skv_get(r, 2);
    s->def = skv_default_world_def();
    for (int i = 0; i < count && !r->failed; i++) {
        char path[256];
        skv_get_text(r, path);
        double value = skv_get_double(r);
        int found = 0;
        while (found < SKV_P_COUNT &&
               (!is_saved(found) || strcmp(skv_world_field(found)->path, path) != 0))
            found++;
        if (found == SKV_P_COUNT)
            return skv_fail(error, SKV_ERROR_FORMAT,
                            "snapshot: this library knows no parameter \"%.60s\"; use the one that "
                            "wrote it",
                            path);
        /* What is no int must not become one. */
        if (!(fabs(value) <= 1e6))
            return skv_fail(error, SKV_ERROR_VALUE, "snapshot: %s is out of range", path);
        if (found == SKV_P_FLUID_LAW)
            s->def.fluid.law = value == 0 ? SKV_LAW_CALIBRATED : SKV_LAW_CLAVET;
        else
            skv_parameter_store(&s->def, (skv_parameter)found, value);
    }
    return skv_check_world_def(&s->def, error);
}

/* Without it a snapshot is of a world that took what the rule asks for. */
static bool read_load(skv_reader *r, skv_snapshot *s)
{
    int substeps = s->def.substeps;
    s->load = (skv_load){substeps, substeps, (float)substeps, 0};
    if (!s->with_load)
        return true;
    uint64_t most = skv_get(r, 4), wanted = skv_get(r, 4);
    s->load.stiffness = skv_get_float(r);
    s->load.peak = skv_get_float(r);
    s->load.most = (int)(most <= 1000 ? most : 0);
    s->load.wanted = (int)(wanted <= most ? wanted : 0);
    if (!skv_within((double)s->load.stiffness, 0.1, 1000))
        return false;
    int cold = (int)ceil((double)s->load.stiffness);
    int needed = s->substeps_fixed ? cold : skv_warm_substeps(&s->def.fluid, cold);
    return s->load.most >= 1 && s->load.wanted >= 1 && needed <= substeps &&
           skv_within((double)s->load.peak, 0, 1e12);
}

static bool read_compression(skv_reader *r, skv_snapshot *s)
{
    if (!s->with_compression)
        return true;
    s->compression = skv_get_float(r);
    return skv_within((double)s->compression, 0, SKV_MOST_COMPRESSION);
}

/* What acts on the way is a fluid, too. */
static bool read_ramp(skv_reader *r, skv_snapshot *s)
{
    if (!s->with_ramp)
        return true;
    s->ramp.left = skv_get_double(r);
    for (int i = 0; i < SKV_RAMP_NUMBERS; i++)
        s->ramp.now[i] = skv_get_float(r);
    skv_world_def present = s->def;
    present.fluid = skv_ramp_fluid(&s->def.fluid, &s->ramp);
    return skv_within(s->ramp.left, 0, SKV_RAMP_TIME) &&
           skv_check_world_def(&present, NULL) == SKV_OK;
}

static skv_result read_facts(skv_reader *r, skv_snapshot *s, skv_error *error)
{
    s->time = skv_get_double(r);
    uint64_t steps = skv_get(r, 8);
    s->steps = (int64_t)(steps <= INT64_MAX ? steps : 0);
    s->due = skv_get_double(r);
    s->filled = skv_get_float(r);
    s->next_id = (uint32_t)skv_get(r, 4);
    s->watched = skv_get_double(r);
    uint64_t stepped = skv_get(r, 4);
    bool loads = s->def.substeps >= 1 && read_load(r, s) && read_compression(r, s) &&
                 read_ramp(r, s) &&
                 (!s->with_fluids ||
                  skv_exchange_liquids(&(skv_port){.from = r}, &s->def, s->liquid_extras));
    /* More substeps than a frame may have are never owed. */
    if (!skv_within(s->time, 0, 1e12) || steps > INT64_MAX / 2 || !skv_within(s->due, 0, 1000) ||
        !skv_within((double)s->filled, 0, 1e6) || !skv_within(s->watched, 0, 1e3) ||
        stepped > SKV_MAX_PARTICLES || !loads)
        return skv_fail(error, SKV_ERROR_VALUE, "snapshot: it holds values that no world has");
    s->stepped = (int)stepped;
    skv_result result =
        skv_exchange_acting(&(skv_port){.from = r}, &s->acting, s->def.liquid_count + 1, error);
    if (result == SKV_OK && s->with_names)
        result = skv_exchange_names(&(skv_port){.from = r}, &s->acting, error);
    else
        skv_acting_rename(&s->acting);
    if (result == SKV_OK && s->with_holds)
        result = skv_exchange_holds(&(skv_port){.from = r}, &s->acting, error);
    s->bodies = *r;
    if (result == SKV_OK && s->with_bodies)
        result = skv_bodies_check(r, s->def.fluid.spacing, s->with_touches, error);
    s->springs = *r;
    if (result == SKV_OK && (s->liquid_extras & SKV_WITH_SPRINGS))
        result =
            skv_springs_check(r, s->def.fluid.spacing * s->def.fluid.radius_ratio, &s->ends, error);
    s->air = *r;
    if (result == SKV_OK && s->with_air)
        result = skv_air_check(r, error);
    return result;
}

static skv_result read_terrain(skv_reader *r, skv_snapshot *s, skv_error *error)
{
    s->terrain = skv_default_terrain_def();
    uint64_t width = skv_get(r, 4), height = skv_get(r, 4);
    s->terrain.pixel_size = skv_get_float(r);
    s->terrain.open_sides = (unsigned)skv_get(r, 4);
    if (r->failed || width > SKV_TERRAIN_MAX_PIXELS || height > SKV_TERRAIN_MAX_PIXELS)
        return refuse(error, "its terrain is too large");
    s->terrain.width = (int)width;
    s->terrain.height = (int)height;
    s->picture = *r;
    for (uint64_t pixels = 0; pixels < width * height && !r->failed;) {
        skv_get(r, 1);
        uint64_t run = skv_get(r, 2);
        pixels += run;
        if (run == 0 || pixels > width * height)
            return refuse(error, "its terrain's picture is damaged");
    }
    return SKV_OK;
}

bool skv_snapshot_picture(const skv_snapshot *s, uint8_t *coverage)
{
    skv_reader r = s->picture;
    size_t pixels = (size_t)s->terrain.width * (size_t)s->terrain.height, filled = 0;
    while (filled < pixels && !r.failed) {
        int value = (int)skv_get(&r, 1);
        size_t run = (size_t)skv_get(&r, 2);
        if (run == 0 || run > pixels - filled)
            return false;
        memset(coverage + filled, value, run);
        filled += run;
    }
    return !r.failed;
}

static float get_float(skv_reader *r)
{
    return skv_get_float(r);
}

static uint32_t get_uint32_t(skv_reader *r)
{
    return (uint32_t)skv_get(r, 4);
}

static uint8_t get_uint8_t(skv_reader *r)
{
    return (uint8_t)skv_get(r, 1);
}

/* ---- Particles ------------------------------------------------------------------------------- */

/* m/s^2: that of a metre's displacement in the shortest substep, and more than any has. */
#define MOST_WARM_LAMBDA 1e11

/* What a particle may be, attribute by attribute. */
static bool is_sane(const skv_state *one, const skv_snapshot *s, int64_t id_before)
{
    return skv_within((double)*one->x, -100, 100) && skv_within((double)*one->y, -100, 100) &&
           skv_within((double)*one->vx, -SKV_MOST_SPEED, SKV_MOST_SPEED) &&
           skv_within((double)*one->vy, -SKV_MOST_SPEED, SKV_MOST_SPEED) &&
           isfinite(*one->pressure) && skv_within((double)*one->warm_lambda, 0, MOST_WARM_LAMBDA) &&
           isfinite(*one->anchor_x) && isfinite(*one->anchor_y) && *one->id > id_before &&
           *one->id < s->next_id && *one->unrest <= SKV_NEWLY_RESTLESS && *one->dye <= SKV_DYES &&
           *one->fluid <= s->def.liquid_count && (s->def.sleep || *one->unrest != SKV_CALM);
}

/* Bytes of a particle, behind which the reference solver once had two arrays of its own. */
static size_t particle_size(const skv_snapshot *s, size_t arrays)
{
    size_t size = arrays * sizeof(float);
#define ADD(type, name, saved) size += (s->holds & (saved)) ? sizeof(type) : 0;
    SKV_STATE_ARRAYS(ADD)
#undef ADD
    return size;
}

/* Attribute by attribute lies in arrays: the readers of all of them go along. */
static bool check_particles(const skv_snapshot *s)
{
    skv_reader r = s->particles;
#define LOCATE(type, name, saved)                                                                  \
    skv_reader name##_at = r;                                                                      \
    r.at += (s->holds & (saved)) ? (size_t)s->count * sizeof(type) : 0;
    SKV_STATE_ARRAYS(LOCATE)
#undef LOCATE
    int64_t id_before = -1;
    for (int i = 0; i < s->count; i++) {
        skv_state one = {0};
#define READ(type, name, saved)                                                                    \
    type name##_value = (s->holds & (saved)) ? get_##type(&name##_at) : 0;                         \
    one.name = &name##_value;
        SKV_STATE_ARRAYS(READ)
#undef READ
        if (!is_sane(&one, s, id_before))
            return false;
        id_before = *one.id;
    }
    return true;
}

void skv_snapshot_particles(const skv_snapshot *s, skv_state *state)
{
    skv_reader r = s->particles;
#define READ(type, name, saved)                                                                    \
    for (int i = 0; state->name && i < s->count; i++)                                              \
        state->name[i] = (s->holds & (saved)) ? get_##type(&r) : 0;
    SKV_STATE_ARRAYS(READ)
#undef READ
    state->count = s->count;
}

static skv_result read_particles(skv_reader *r, skv_snapshot *s, skv_error *error)
{
    uint64_t count = skv_get(r, 4), arrays = skv_get(r, 4);
    if (count > SKV_MAX_PARTICLES)
        return skv_fail(error, SKV_ERROR_LIMIT, "snapshot: it has more than %d particles",
                        SKV_MAX_PARTICLES);
    bool had = s->def.solver == SKV_SOLVER_REFERENCE;
    if (r->failed || (arrays != 0 && !(had && arrays == 2)))
        return refuse(error, "it is damaged; take another copy");
    s->count = (int)count;
    s->particles = *r;
    if (r->size - r->at != count * particle_size(s, (size_t)arrays))
        return refuse(error, "its length is not that of its particles");
    if (!check_particles(s) || s->ends > s->count)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "snapshot: a particle has values that none can have");
    return SKV_OK;
}

skv_result skv_snapshot_read(const void *data, size_t size, skv_snapshot *s, skv_error *error)
{
    *s = (skv_snapshot){0};
    skv_reader r = {data, size, 0, false};
    skv_result result = read_head(&r, s, error);
    if (result == SKV_OK)
        result = read_parameters(&r, s, error);
    if (result == SKV_OK)
        result = read_facts(&r, s, error);
    if (result == SKV_OK && s->with_terrain)
        result = read_terrain(&r, s, error);
    return result == SKV_OK ? read_particles(&r, s, error) : result;
}
