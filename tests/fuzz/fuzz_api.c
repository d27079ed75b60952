/* A host that calls the library in any order with any values: each byte of the input is a call.
 *
 * Whatever is called, every particle stays finite and none escapes, the facts agree with each
 * other, and what is refused changes nothing.
 */
#include "fuzz.h"

#include <skvalp/acting.h>
#include <skvalp/parameters.h>
#include <skvalp/query.h>
#include <skvalp/snapshot.h>
#include <skvalp/world.h>

#include <math.h>
#include <stdlib.h>

/* Small, so that a second of fuzzing is some ten inputs even under the sanitizers. */
enum { MOST_PARTICLES = 150, MOST_CALLS = 40, FLUIDS = 3 };

typedef struct host {
    fuzz_input in;
    skv_world *world;
    float width, height;
} host;

static skv_terrain *make_terrain(fuzz_input *in)
{
    skv_terrain_def def = skv_default_terrain_def();
    def.width = 16 + fuzz_below(in, 24);
    def.height = 16 + fuzz_below(in, 24);
    def.pixel_size = 0.01f;
    def.open_sides = fuzz_byte(in) % 16;
    uint8_t *coverage = calloc((size_t)def.width, (size_t)def.height);
    int boxes = fuzz_byte(in) % 5;
    for (int b = 0; b < boxes; b++) {
        int x0 = fuzz_below(in, def.width), y0 = fuzz_below(in, def.height);
        int w = 1 + fuzz_below(in, 8), h = 1 + fuzz_below(in, 8);
        uint8_t grey = fuzz_byte(in);
        for (int y = y0; y < y0 + h && y < def.height; y++)
            for (int x = x0; x < x0 + w && x < def.width; x++)
                coverage[y * def.width + x] = grey;
    }
    def.coverage = coverage;
    skv_terrain *terrain = NULL;
    fuzz_expect(skv_terrain_create(&def, &terrain, NULL) == SKV_OK, "a small terrain is made");
    free(coverage);
    return terrain;
}

static skv_world *make_world(fuzz_input *in)
{
    skv_world_def def = skv_default_world_def();
    def.fluid = skv_default_fluid_def(fuzz_byte(in) % 3 ? SKV_LAW_CALIBRATED : SKV_LAW_CLAVET);
    def.fluid.spacing = fuzz_float(in, 0.01f, 0.03f);
    def.fluid.viscosity = fuzz_byte(in) % 4 ? 0 : fuzz_float(in, 0, 0.05f);
    def.fluid.cohesion = fuzz_float(in, 0, 500);
    def.gravity_x = fuzz_float(in, -20, 20);
    def.gravity_y = fuzz_float(in, -20, 20);
    def.substeps = fuzz_below(in, 12);
    def.threads = 1;
    def.liquid_count = FLUIDS - 1;
    for (int i = 0; i < def.liquid_count; i++) {
        def.liquids[i] = skv_default_liquid();
        def.liquids[i].name[0] = (char)('a' + i);
        def.liquids[i].cohesion = i ? 0 : -1;
    }
    def.sleep = fuzz_byte(in) % 2;
    def.solver = fuzz_byte(in) % 4 ? SKV_SOLVER_FAST : SKV_SOLVER_REFERENCE;
    def.terrain = make_terrain(in);
    skv_world *world = NULL;
    skv_error error = {0};
    skv_result result = skv_world_create(&def, &world, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect((result == SKV_OK) == (world != NULL), "a world exactly if SKV_OK");
    if (world == NULL)
        skv_terrain_destroy(def.terrain);
    return world;
}

static void add_particle(host *h)
{
    float x = fuzz_float(&h->in, -0.1f, h->width + 0.1f);
    float y = fuzz_float(&h->in, -0.1f, h->height + 0.1f);
    float vx = fuzz_float(&h->in, -5, 5), vy = fuzz_float(&h->in, -5, 5);
    int before = skv_world_particle_count(h->world);
    skv_error error = {0};
    skv_result result = skv_world_add_particle(h->world, x, y, vx, vy, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(skv_world_particle_count(h->world) == before + (result == SKV_OK),
                "one particle more exactly if SKV_OK");
}

static void fill(host *h)
{
    skv_fill_def def = skv_default_fill_def();
    def.x0 = fuzz_float(&h->in, 0, h->width);
    def.y0 = fuzz_float(&h->in, 0, h->height);
    def.x1 = fuzz_float(&h->in, def.x0, h->width);
    def.y1 = fuzz_float(&h->in, def.y0, h->height);
    def.limit = MOST_PARTICLES / 2;
    int before = skv_world_particle_count(h->world);
    skv_placed placed = {0};
    skv_error error = {0};
    skv_result result = skv_world_fill(h->world, &def, &placed, &error);
    fuzz_expect_answer(result, &error);
    if (result == SKV_OK)
        fuzz_expect(skv_world_particle_count(h->world) == before + placed.added,
                    "added is counted");
    else
        fuzz_expect(skv_world_particle_count(h->world) == before, "all or nothing");
}

/* Particles come and go by what is counted alone. */
static void account(const host *h, const skv_flow *flow, int before)
{
    skv_flow now = skv_world_flow(h->world);
    int64_t change = now.emitted - flow->emitted - (now.drained - flow->drained) -
                     (now.left - flow->left) - (now.replaced - flow->replaced);
    fuzz_expect(skv_world_particle_count(h->world) - before == change, "the balance is even");
}

static void step(host *h)
{
    static const float frames[] = {1.0f / 60, 1.0f / 60, 1.0f / 30, 1e-6f, 0.1f};
    float dt = frames[fuzz_below(&h->in, 5)];
    if (fuzz_byte(&h->in) % 8 == 7)
        dt = fuzz_any_float(&h->in);
    double before = skv_world_time(h->world);
    skv_flow flow = skv_world_flow(h->world);
    int there = skv_world_particle_count(h->world);
    skv_error error = {0};
    skv_result result = skv_world_step(h->world, dt, &error);
    fuzz_expect_answer(result, &error);
    account(h, &flow, there);
    fuzz_expect(result == SKV_OK || skv_world_time(h->world) == before, "a refused step is none");
}

static void hold(host *h)
{
    skv_hand hands[3];
    int count = fuzz_byte(&h->in) % 4;
    for (int i = 0; i < count; i++) {
        hands[i] = skv_default_hand();
        hands[i].x = fuzz_float(&h->in, 0, h->width);
        hands[i].y = fuzz_float(&h->in, 0, h->height);
        hands[i].vx = fuzz_float(&h->in, -5, 5);
        hands[i].vy = fuzz_float(&h->in, -5, 5);
        hands[i].radius = fuzz_float(&h->in, 0, 0.5f);
        hands[i].attraction = fuzz_float(&h->in, -100, 1000);
    }
    skv_error error = {0};
    fuzz_expect_answer(skv_world_set_hands(h->world, hands, count, &error), &error);
}

static void blow(host *h)
{
    skv_force forces[2];
    int count = fuzz_byte(&h->in) % 3;
    for (int i = 0; i < count; i++) {
        float x = fuzz_float(&h->in, 0, h->width), y = fuzz_float(&h->in, 0, h->height);
        forces[i] = (skv_force){.area = fuzz_byte(&h->in) % 2 ? skv_box(0, 0, x, y)
                                                              : skv_circle(x, y, 0.1f),
                                .ax = fuzz_float(&h->in, -100, 100),
                                .ay = fuzz_float(&h->in, -100, 1100),
                                .toward_x = x,
                                .toward_y = y,
                                .attraction = fuzz_float(&h->in, -100, 100),
                                .wind_x = fuzz_float(&h->in, -10, 10),
                                .drag = fuzz_float(&h->in, -1, 100),
                                .spin = fuzz_float(&h->in, -101, 100)};
    }
    skv_error error = {0};
    fuzz_expect_answer(skv_world_set_forces(h->world, forces, count, &error), &error);
}

static skv_area any_area(host *h)
{
    float x = fuzz_float(&h->in, -0.05f, h->width), y = fuzz_float(&h->in, -0.05f, h->height);
    float size = fuzz_float(&h->in, -0.05f, 0.3f);
    const float corners[] = {x, y, x + size, y, x, y + size};
    const skv_area areas[] = {skv_circle(x, y, size), skv_box(x, y, x + size, y - size),
                              skv_polygon(corners, 3), skv_swept_circle(x, y, y, x, size)};
    return areas[fuzz_below(&h->in, 4)];
}

static void emit(host *h)
{
    skv_emitter emitters[3];
    int count = fuzz_byte(&h->in) % 4;
    for (int i = 0; i < count; i++)
        emitters[i] = (skv_emitter){.x = fuzz_float(&h->in, -0.1f, h->width + 0.1f),
                                    .y = fuzz_float(&h->in, -0.1f, h->height + 0.1f),
                                    .vx = fuzz_float(&h->in, -4, 4),
                                    .vy = fuzz_byte(&h->in) % 4 ? fuzz_float(&h->in, -4, 4) : 0,
                                    .width = fuzz_float(&h->in, 0, 0.4f),
                                    .dye = fuzz_below(&h->in, SKV_DYES + 2)};
    skv_error error = {0};
    skv_result result = skv_world_set_emitters(h->world, emitters, count, &error);
    fuzz_expect_answer(result, &error);
    int now;
    skv_world_emitters(h->world, &now);
    bool replaces = fuzz_byte(&h->in) % 2;
    fuzz_expect(skv_world_set(h->world, "emission.limit", "150", NULL) == SKV_OK &&
                    skv_world_set(h->world, "emission.replaces", replaces ? "true" : "false",
                                  NULL) == SKV_OK,
                "what a full world does can be set");
    fuzz_expect(result != SKV_OK || now == count, "the emitters are those that were set");
}

static void drain(host *h)
{
    skv_drain drains[2];
    int count = fuzz_byte(&h->in) % 3;
    for (int i = 0; i < count; i++) {
        drains[i].area = any_area(h);
        drains[i].rate = fuzz_byte(&h->in) % 2 ? 0 : fuzz_float(&h->in, -0.1f, 2);
    }
    skv_error error = {0};
    fuzz_expect_answer(skv_world_set_drains(h->world, drains, count, &error), &error);
}

static void dye(host *h)
{
    skv_area area = any_area(h);
    int color = fuzz_below(&h->in, SKV_DYES + 3) - 1, dyed = 0;
    uint64_t before = skv_world_hash(h->world);
    skv_error error = {0};
    skv_result result = skv_world_dye_area(h->world, &area, color, &dyed, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(dyed <= skv_world_query(h->world, &area, NULL, 0), "who is dyed lies in the area");
    fuzz_expect((skv_world_hash(h->world) != before) == (dyed > 0), "the hash knows colours");
    uint8_t colors[2] = {fuzz_byte(&h->in) % 6, fuzz_byte(&h->in) % 6};
    int first = fuzz_below(&h->in, MOST_PARTICLES) - 1;
    fuzz_expect_answer(skv_world_set_dyes(h->world, first, 2, colors, &error), &error);
}

/* Particles of a fluid come, others change theirs. */
static void mix(host *h)
{
    skv_fill_def def = skv_default_fill_def();
    def.x1 = fuzz_float(&h->in, 0, h->width);
    def.limit = MOST_PARTICLES / 4;
    def.fluid = fuzz_below(&h->in, FLUIDS + 2) - 1;
    bool known = skv_world_liquid(h->world, def.fluid) != NULL;
    skv_placed placed = {0};
    skv_error error = {0};
    int before = skv_world_fluid_stats(h->world, known ? def.fluid : 0).particles;
    skv_result result = skv_world_fill(h->world, &def, &placed, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(result != SKV_OK ||
                    (known &&
                     skv_world_fluid_stats(h->world, def.fluid).particles == before + placed.added),
                "what is filled is of its fluid");
    uint8_t fluids[2] = {fuzz_byte(&h->in) % (FLUIDS + 1), fuzz_byte(&h->in) % (FLUIDS + 1)};
    int first = fuzz_below(&h->in, MOST_PARTICLES) - 1;
    fuzz_expect_answer(skv_world_set_fluids(h->world, first, 2, fluids, &error), &error);
}

/* A copy goes the same way. */
static void fork_world(host *h)
{
    skv_world *copy;
    skv_error error = {0};
    skv_world_def lent = skv_default_world_def();
    lent.threads = 1;
    skv_result result = skv_world_copy(h->world, &lent, &copy, &error);
    fuzz_expect_answer(result, &error);
    if (result != SKV_OK)
        return;
    fuzz_expect(skv_world_step(copy, 1.0f / 60, NULL) == SKV_OK &&
                    skv_world_step(h->world, 1.0f / 60, NULL) == SKV_OK,
                "both go on");
    fuzz_expect(skv_world_hash(copy) == skv_world_hash(h->world), "a copy goes the same way");
    skv_world_destroy(copy);
}

static void push(host *h)
{
    skv_error error = {0};
    int first = fuzz_below(&h->in, 200) - 2, count = fuzz_below(&h->in, 200) - 2;
    float vx = fuzz_float(&h->in, -10, 10), vy = fuzz_float(&h->in, -10, 10);
    fuzz_expect_answer(skv_world_add_velocity(h->world, first, count, vx, vy, &error), &error);
}

static void turn_gravity(host *h)
{
    skv_error error = {0};
    float gx = fuzz_float(&h->in, -30, 30), gy = fuzz_float(&h->in, -30, 30);
    fuzz_expect_answer(skv_world_set_gravity(h->world, gx, gy, &error), &error);
}

static void look(host *h)
{
    int indices[16], total;
    float x = fuzz_float(&h->in, 0, h->width), y = fuzz_float(&h->in, 0, h->height);
    skv_area circle = skv_circle(x, y, fuzz_float(&h->in, 0, 1));
    total = skv_world_query(h->world, &circle, indices, 16);
    fuzz_expect(total >= 0 && total <= skv_world_particle_count(h->world), "at most all are found");
    for (int i = 1; i < total && i < 16; i++)
        fuzz_expect(indices[i] > indices[i - 1], "indices ascend");
}

static void add_many(host *h)
{
    enum { MOST = 64 };
    skv_particle particles[MOST];
    skv_particle_id ids[MOST];
    int count = fuzz_below(&h->in, MOST), before = skv_world_particle_count(h->world);
    float x = fuzz_float(&h->in, -0.1f, h->width), y = fuzz_float(&h->in, -0.1f, h->height);
    float apart = fuzz_float(&h->in, 0, 0.1f);
    for (int i = 0; i < count; i++)
        particles[i] =
            (skv_particle){x + apart * (float)(i % 8), y + apart * (float)(i / 8), 1, -1};
    skv_placed placed = {0};
    skv_error error = {0};
    skv_result result = skv_world_add_particles(h->world, particles, count, ids, &placed, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(skv_world_particle_count(h->world) == before + placed.added, "added is counted");
    for (int i = 0; result == SKV_OK && i < count; i++)
        fuzz_expect((skv_world_index(h->world, ids[i]) >= 0) == (ids[i] != SKV_NO_PARTICLE),
                    "who has an id is there");
}

static void take_away(host *h)
{
    float x = fuzz_float(&h->in, 0, h->width), y = fuzz_float(&h->in, 0, h->height);
    float size = fuzz_float(&h->in, -0.05f, 0.3f);
    const float corners[] = {x, y, x + size, y, x, y + size};
    const skv_area areas[] = {skv_circle(x, y, size), skv_box(x, y, x + size, y - size),
                              skv_polygon(corners, 3)};
    const skv_area *area = &areas[fuzz_below(&h->in, 3)];
    int there = skv_world_query(h->world, area, NULL, 0), removed = 0;
    int before = skv_world_particle_count(h->world);
    uint32_t revision = skv_world_revision(h->world);
    skv_error error = {0};
    skv_result result = skv_world_remove_area(h->world, area, &removed, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(result != SKV_OK || removed == there, "all that are there are removed");
    fuzz_expect(skv_world_particle_count(h->world) == before - removed, "removed is counted");
    fuzz_expect((skv_world_revision(h->world) != revision) == (removed > 0), "views go stale");
}

static void draw(host *h)
{
    skv_brush_stroke stroke = {
        .x0 = fuzz_float(&h->in, -0.1f, h->width + 0.1f),
        .y0 = fuzz_float(&h->in, -0.1f, h->height + 0.1f),
        .x1 = fuzz_float(&h->in, -0.1f, h->width + 0.1f),
        .y1 = fuzz_float(&h->in, -0.1f, h->height + 0.1f),
        .radius = fuzz_float(&h->in, 0, 0.05f),
        .erase = fuzz_byte(&h->in) % 2,
    };
    int before = skv_world_particle_count(h->world), removed = 0;
    skv_terrain *painted = NULL;
    skv_error error = {0};
    skv_result result =
        skv_terrain_paint(skv_world_terrain(h->world), &stroke, 1, &painted, &error);
    fuzz_expect_answer(result, &error);
    if (result != SKV_OK)
        return;
    result = skv_world_set_terrain(h->world, painted, &removed, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(result == SKV_OK, "a painted terrain fits its world");
    fuzz_expect(skv_world_particle_count(h->world) == before - removed, "removed is counted");
}

static void aim(host *h)
{
    float x0 = fuzz_any_float(&h->in), y0 = fuzz_float(&h->in, -1, h->height + 1);
    float x1 = fuzz_float(&h->in, -1, h->width + 1), y1 = fuzz_any_float(&h->in);
    skv_ray ray = skv_world_ray(h->world, x0, y0, x1, y1);
    fuzz_expect(ray.wall.share >= 0 && ray.wall.share <= 1, "a share of the way to the wall");
    fuzz_expect(ray.fluid.share >= 0 && ray.fluid.share <= 1, "a share of the way to fluid");
    fuzz_expect(ray.fluid.particle < skv_world_particle_count(h->world), "a particle that exists");
}

static skv_hand some_hand(fuzz_input *in)
{
    skv_hand hand = skv_default_hand();
    hand.x = fuzz_float(in, -1, 2);
    hand.radius = fuzz_float(in, 0, 0.5f);
    return hand;
}

/* One thing that acts, by its name: added, changed and removed; also by names that were never
 * given. */
static void handle(host *h)
{
    skv_acting_id id = 0;
    skv_error error = {0};
    skv_hand hand = some_hand(&h->in);
    skv_result result = skv_world_add_hand(h->world, &hand, &id, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect((result == SKV_OK) == (id != 0), "a name exactly if SKV_OK");
    skv_acting_id other = fuzz_byte(&h->in) % 2 ? id : (skv_acting_id)fuzz_below(&h->in, 65536);
    skv_acting_kind kind = SKV_ACTING_HAND;
    int there = skv_world_acting_index(h->world, other, &kind), count;
    skv_hand changed = some_hand(&h->in);
    skv_error refusal = {0};
    result = skv_world_change_hand(h->world, other, &changed, &refusal);
    fuzz_expect_answer(result, &refusal);
    fuzz_expect(result != SKV_OK || (there >= 0 && kind == SKV_ACTING_HAND),
                "only a hand that is there changes");
    fuzz_expect(skv_world_remove_acting(h->world, other) == (there >= 0), "who is there can go");
    fuzz_expect(skv_world_acting_index(h->world, other, NULL) < 0, "and is gone then");
    skv_world_hands(h->world, &count);
    for (int i = 0; i < count; i++)
        fuzz_expect(skv_world_acting_index(
                        h->world, skv_world_acting_id(h->world, SKV_ACTING_HAND, i), &kind) == i &&
                        kind == SKV_ACTING_HAND,
                    "names and places agree");
}

/* Particles go elsewhere, by their ids, which may be gone. */
static void move_particles(host *h)
{
    enum { MOST = 4 };
    skv_particle_id ids[MOST];
    float x[MOST], y[MOST];
    int count = fuzz_below(&h->in, MOST + 1), before = skv_world_particle_count(h->world);
    for (int i = 0; i < count; i++) {
        ids[i] = (skv_particle_id)fuzz_below(&h->in, 300);
        x[i] = fuzz_float(&h->in, -0.05f, h->width + 0.05f);
        y[i] = fuzz_float(&h->in, -0.05f, h->height + 0.05f);
    }
    uint64_t hash = skv_world_hash(h->world);
    skv_error error = {0};
    skv_result result = skv_world_set_positions(h->world, ids, count, x, y, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(skv_world_particle_count(h->world) == before, "moving removes nobody");
    fuzz_expect(result == SKV_OK || skv_world_hash(h->world) == hash, "a refusal moves nobody");
}

/* A number of a world that runs. */
static void set_number(host *h)
{
    int number = 0, parameter;
    while (skv_world_field(number))
        number++;
    parameter = fuzz_below(&h->in, number);
    const skv_field *field = skv_world_field(parameter);
    double range = field->maximum - field->minimum;
    double value = field->minimum + range * (double)fuzz_float(&h->in, -0.1f, 1.1f);
    double before = skv_world_number(h->world, parameter);
    skv_error error = {0};
    skv_result result = skv_world_set_number(h->world, parameter, value, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect(result != SKV_OK || skv_world_can_change(field->path), "what can't change stays");
    fuzz_expect(result == SKV_OK || skv_world_number(h->world, parameter) == before,
                "a refusal changes nothing");
}

static void judge(const host *h)
{
    skv_particles p = skv_world_particles(h->world);
    fuzz_expect(p.count == skv_world_particle_count(h->world), "one number of particles");
    fuzz_expect(skv_world_awake_count(h->world) <= p.count, "no more awake than there are");
    for (int i = 0; i < p.count; i++)
        fuzz_expect((i == 0 || p.id[i] > p.id[i - 1]) && p.dye[i] <= SKV_DYES &&
                        p.fluid[i] < FLUIDS,
                    "ids ascend, and every colour and every fluid is one");
    skv_stats stats = skv_world_stats(h->world);
    fuzz_expect(stats.not_finite == 0, "every position and velocity is finite");
    fuzz_expect(stats.escaped == 0, "no particle escapes");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static void (*const calls[])(host *) = {
        step, step,      step, add_particle, fill, add_many, hold,  push, turn_gravity,
        look, take_away, aim,  blow,         draw, emit,     drain, dye,  fork_world};
    /* From a byte on with which no committed input calls: so they stay what they were. */
    static void (*const later[])(host *) = {handle, move_particles, set_number, mix};
    enum { LATER = 251 };
    host h = {.in = {data, size}};
    h.world = make_world(&h.in);
    if (h.world == NULL)
        return 0;
    h.width = skv_terrain_width(skv_world_terrain(h.world));
    h.height = skv_terrain_height(skv_world_terrain(h.world));
    for (int i = 0; i < MOST_CALLS && h.in.size > 0; i++) {
        uint8_t byte = fuzz_byte(&h.in);
        int call = byte % (int)(sizeof calls / sizeof *calls);
        if (skv_world_particle_count(h.world) > MOST_PARTICLES && call >= 3 && call <= 5)
            call = 0;
        if (byte >= LATER)
            later[byte % (int)(sizeof later / sizeof *later)](&h);
        else
            calls[call](&h);
        judge(&h);
    }
    skv_world_destroy(h.world);
    return 0;
}
