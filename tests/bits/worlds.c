/* The worlds that are compared bit by bit. Invariant: all that goes into them is made by integer
 * arithmetic and by float operations that are exact or correctly rounded, so that a difference in
 * the hash is one of the library's. */
#include "worlds.h"

#include <skvalp/skvalp.h>

enum { WIDTH = 80, HEIGHT = 50 };

#define PIXEL 0.01f /* m: worlds of 0.8 x 0.5 m */

/* How solid a pixel is; (x, y) is counted from the lower left corner. */
typedef int paint(int x, int y);

typedef struct world_kind {
    const char *name;
    paint *paint; /* null: an empty tank */
    unsigned open_sides;
    skv_law law;
    skv_solver_kind solver;
    float viscosity;
    float fill_x1, fill_y1; /* the fluid's box, from the lower left corner, m */
    int stirred;            /* hands and a changing gravity */
    float gravity_x;
    bool images;  /* walls by images */
    bool bodies;  /* a box and a circle, which hands hold and let go */
    bool air;     /* that is caught below walls and bodies */
    bool springs; /* a block of jelly and one of clay, which fall into it */
    bool fluids;  /* the same of two that push others, one of more and one of no cohesion */
} world_kind;

static int limited(int value)
{
    return value < 0 ? 0 : value > 255 ? 255 : value;
}

/* A straight wall of the given half width, in fifths of a pixel, along 4x - 3y = c or the like:
 * (a, b) has the length 5, so the distance is exact in fifths, and the wall's edges are grey. */
static int slab(int distance, int half_width)
{
    return limited(128 + 51 * (half_width - (distance < 0 ? -distance : distance)));
}

/* Two slanted shelves with grey edges, and a thin one of a single bright line. */
static int paint_shelves(int x, int y)
{
    int solid = 0;
    if (x < 45)
        solid = slab(3 * x + 4 * y - 200, 9);
    if (x > 40 && slab(4 * y - 3 * x + 120, 7) > solid)
        solid = slab(4 * y - 3 * x + 120, 7);
    if (x > 20 && x < 60 && slab(5 * y - 60, 3) > solid)
        solid = slab(5 * y - 60, 3);
    return solid;
}

/* A U: a block in the middle that leaves a channel below it; its edges lie between pixels. */
static int paint_u_tube(int x, int y)
{
    if (x < 30 || x > 49 || y < 8)
        return 0;
    return x == 30 ? 90 : x == 49 ? 170 : y == 8 ? 200 : 255;
}

static const world_kind kinds[] = {
    {.name = "pool/calibrated", .fill_x1 = 1, .fill_y1 = 0.25f},
    {.name = "pool/clavet", .law = SKV_LAW_CLAVET, .fill_x1 = 1, .fill_y1 = 0.25f},
    {.name = "dam/calibrated", .viscosity = 2, .fill_x1 = 0.3f, .fill_y1 = 0.45f, .stirred = 1},
    {.name = "dam/clavet",
     .law = SKV_LAW_CLAVET,
     .viscosity = 2,
     .fill_x1 = 0.3f,
     .fill_y1 = 0.45f,
     .stirred = 1},
    {.name = "shelves/calibrated",
     .paint = paint_shelves,
     .fill_x1 = 0.5f,
     .fill_y1 = 1,
     .gravity_x = 3},
    {.name = "shelves/clavet",
     .law = SKV_LAW_CLAVET,
     .paint = paint_shelves,
     .fill_x1 = 0.5f,
     .fill_y1 = 1,
     .gravity_x = 3},
    {.name = "u-tube/calibrated", .paint = paint_u_tube, .fill_x1 = 0.4f, .fill_y1 = 0.4f},
    {.name = "u-tube/clavet",
     .law = SKV_LAW_CLAVET,
     .paint = paint_u_tube,
     .fill_x1 = 0.4f,
     .fill_y1 = 0.4f},
    {.name = "spill/calibrated",
     .open_sides = SKV_SIDE_RIGHT | SKV_SIDE_TOP,
     .fill_x1 = 0.4f,
     .fill_y1 = 0.3f,
     .stirred = 1},
    {.name = "shelves/images",
     .paint = paint_shelves,
     .viscosity = 2,
     .fill_x1 = 0.5f,
     .fill_y1 = 1,
     .gravity_x = 3,
     .images = true},
    {.name = "u-tube/images",
     .paint = paint_u_tube,
     .fill_x1 = 0.4f,
     .fill_y1 = 0.4f,
     .images = true},
    {.name = "reference/calibrated",
     .solver = SKV_SOLVER_REFERENCE,
     .paint = paint_shelves,
     .viscosity = 2,
     .fill_x1 = 0.3f,
     .fill_y1 = 1,
     .stirred = 1},
    {.name = "reference/clavet",
     .law = SKV_LAW_CLAVET,
     .solver = SKV_SOLVER_REFERENCE,
     .paint = paint_shelves,
     .viscosity = 2,
     .fill_x1 = 0.3f,
     .fill_y1 = 1,
     .stirred = 1},
    {.name = "bodies/calibrated", .fill_x1 = 1, .fill_y1 = 0.25f, .bodies = true},
    {.name = "bodies/clavet",
     .law = SKV_LAW_CLAVET,
     .fill_x1 = 1,
     .fill_y1 = 0.25f,
     .bodies = true},
    {.name = "bodies/reference",
     .solver = SKV_SOLVER_REFERENCE,
     .fill_x1 = 1,
     .fill_y1 = 0.25f,
     .bodies = true},
    {.name = "springs/calibrated", .fill_x1 = 1, .fill_y1 = 0.125f, .springs = true},
    {.name = "springs/clavet",
     .law = SKV_LAW_CLAVET,
     .fill_x1 = 1,
     .fill_y1 = 0.125f,
     .springs = true},
    {.name = "fluids/images", .fill_x1 = 1, .fill_y1 = 0.125f, .images = true, .fluids = true},
    {.name = "fluids/reference",
     .solver = SKV_SOLVER_REFERENCE,
     .fill_x1 = 1,
     .fill_y1 = 0.125f,
     .images = true,
     .fluids = true},
    {.name = "air/bodies",
     .paint = paint_shelves,
     .fill_x1 = 0.5f,
     .fill_y1 = 1,
     .images = true,
     .bodies = true,
     .air = true},
};

int bits_count(void)
{
    return (int)(sizeof kinds / sizeof *kinds);
}

const char *bits_name(int number)
{
    return kinds[number].name;
}

static skv_instruction_set chosen = SKV_ISA_BEST;

const char *bits_instruction_set(void)
{
    return skv_instruction_set_name(chosen);
}

bool bits_choose(const char *instruction_set)
{
    skv_world_def def = skv_default_world_def();
    if (skv_world_def_set(&def, "instruction_set", instruction_set, NULL) != SKV_OK)
        return false;
    chosen = def.instruction_set;
    return skv_instruction_set_name(chosen) != NULL;
}

static skv_terrain *make_terrain(const world_kind *kind)
{
    static uint8_t coverage[WIDTH * HEIGHT];
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            coverage[y * WIDTH + x] = (uint8_t)(kind->paint ? kind->paint(x, y) : 0);
    skv_terrain_def def = skv_default_terrain_def();
    def.width = WIDTH;
    def.height = HEIGHT;
    def.coverage = coverage;
    def.pixel_size = PIXEL;
    def.open_sides = kind->open_sides;
    skv_terrain *terrain;
    return skv_terrain_create(&def, &terrain, NULL) == SKV_OK ? terrain : NULL;
}

/* Jelly, and clay that yields. */
static void list_springy(skv_world_def *def)
{
    def->liquid_count = 2;
    for (int i = 0; i < 2; i++) {
        skv_liquid *liquid = &def->liquids[i];
        *liquid = skv_default_liquid();
        liquid->name[0] = (char)('a' + i);
        liquid->shear_modulus = i ? 10000 : 4000;
        liquid->yield = 0.03125f;
        liquid->plasticity = i ? 50 : 0;
    }
}

static void list_fluids(skv_world_def *def)
{
    def->liquid_count = 2;
    for (int i = 0; i < 2; i++) {
        skv_liquid *liquid = &def->liquids[i];
        *liquid = skv_default_liquid();
        liquid->name[0] = (char)('a' + i);
        liquid->density = i ? 900 : 13600;
        liquid->interface_push = i ? 50 : 0;
        liquid->cohesion = i ? 0 : 300;
    }
}

static void fill_blocks(skv_world *world)
{
    for (int i = 0; i < 2; i++) {
        skv_fill_def fill = skv_default_fill_def();
        fill.x0 = 0.125f + 0.375f * (float)i;
        fill.x1 = fill.x0 + 0.125f;
        fill.y0 = 0.1875f;
        fill.y1 = 0.3125f;
        fill.fluid = i + 1;
        skv_world_fill(world, &fill, NULL, NULL);
    }
}

static skv_world *make_world(const world_kind *kind, int threads)
{
    skv_world_def def = skv_default_world_def();
    def.terrain = make_terrain(kind);
    def.fluid = skv_default_fluid_def(kind->law);
    def.fluid.spacing = 0.0135f;
    def.fluid.viscosity_linear = def.fluid.viscosity_quadratic = kind->viscosity;
    def.gravity_x = kind->gravity_x;
    def.fluid.wall_images = kind->images;
    def.solver = kind->solver;
    def.threads = threads;
    def.instruction_set = chosen;
    if (kind->springs)
        list_springy(&def);
    if (kind->fluids)
        list_fluids(&def);
    skv_world *world = NULL;
    if (!def.terrain)
        return NULL;
    if (skv_world_create(&def, &world, NULL) != SKV_OK) {
        skv_terrain_destroy(def.terrain);
        return NULL;
    }
    skv_fill_def fill = skv_default_fill_def();
    fill.x1 = kind->fill_x1;
    fill.y1 = kind->fill_y1;
    skv_world_fill(world, &fill, NULL, NULL);
    if (kind->springs || kind->fluids)
        fill_blocks(world);
    int added = skv_world_particle_count(world);
    /* A part in motion, and a pair in one place. */
    skv_world_add_velocity(world, added / 2, added / 4, 1.5f, 0.75f, NULL);
    skv_world_add_particle(world, 0.125f, 0.3125f, 0, 0, NULL);
    skv_world_add_particle(world, 0.125f, 0.3125f, 0, 0, NULL);
    if (kind->air)
        skv_world_set_air(world, 8192, NULL);
    return world;
}

/* Two hands that move and let go, and a gravity that turns. */
static void stir(skv_world *world, int frame)
{
    skv_hand hands[2] = {skv_default_hand(), skv_default_hand()};
    hands[0].x = 0.125f + 0.0078125f * (float)frame;
    hands[0].y = 0.25f;
    hands[0].vx = 0.46875f;
    hands[1].x = 0.25f;
    hands[1].y = 0.125f;
    hands[1].radius = 0.1f;
    skv_world_set_hands(world, hands, frame % 16 < 10 ? 1 + frame % 2 : 0, NULL);
    skv_world_set_gravity(world, 0.25f * (float)(frame % 40 - 10), -9.81f, NULL);
}

/* One that is to float, and one that sinks and turns. */
static bool add_bodies(skv_world *world)
{
    skv_body_def box = skv_default_body_def(), ball = skv_default_body_def();
    box.x = 0.25f;
    box.y = 0.28125f;
    box.angle = 0.375f;
    ball.shape = skv_circle(0, 0, 0.0625f);
    ball.x = 0.5f;
    ball.y = 0.375f;
    ball.vx = -1;
    ball.spin = 8;
    ball.density = 1900;
    return skv_world_add_body(world, &box, NULL, NULL, NULL) == SKV_OK &&
           skv_world_add_body(world, &ball, NULL, NULL, NULL) == SKV_OK;
}

/* The box is picked up, carried through the water and thrown. */
static void carry(skv_world *world, int frame)
{
    skv_hand hand = skv_default_hand();
    hand.attraction = 300;
    hand.follow = 40;
    hand.x = 0.25f + 0.015625f * (float)frame;
    hand.y = 0.3125f - 0.0078125f * (float)frame;
    hand.vx = 0.9375f;
    hand.vy = -0.46875f;
    hand.body = 1;
    hand.at_x = 0.03125f;
    hand.at_y = 0.03125f;
    skv_world_set_hands(world, &hand, frame > 1 && frame < 24, NULL);
}

static uint64_t add_bytes(uint64_t hash, const void *data, int size)
{
    const unsigned char *bytes = data;
    for (int i = 0; i < size; i++)
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash;
}

/* FNV-1a over the state, the pressures and the statistics. */
static uint64_t hash_of(const skv_world *world)
{
    uint64_t hash = 0xcbf29ce484222325u, state = skv_world_hash(world);
    hash = add_bytes(hash, &state, sizeof state);
    skv_particles particles = skv_world_particles(world);
    hash = add_bytes(hash, particles.pressure, particles.count * (int)sizeof(float));
    skv_stats stats = skv_world_stats(world);
    skv_packing packing = {0};
    skv_world_packing(world, &packing, NULL);
    const double numbers[] = {
        stats.particles,  stats.escaped,      stats.not_finite, stats.kinetic_energy,
        stats.momentum_x, stats.momentum_y,   stats.rms_speed,  stats.potential_energy,
        stats.max_speed,  packing.neighbours, stats.centre_x,   packing.volume_ratio,
        stats.centre_y,
    };
    return add_bytes(hash, numbers, sizeof numbers);
}

uint64_t bits_hash(int number, int threads, int frames)
{
    const world_kind *kind = &kinds[number];
    skv_world *world = make_world(kind, threads);
    if (!world)
        return 0;
    bool fine = !kind->bodies || add_bodies(world);
    for (int frame = 0; frame < frames; frame++) {
        if (kind->stirred)
            stir(world, frame);
        if (kind->bodies)
            carry(world, frame);
        fine = skv_world_step(world, 1.0f / 60, NULL) == SKV_OK && fine;
    }
    skv_stats stats = skv_world_stats(world);
    uint64_t hash = hash_of(world);
    /* A world that has lost its numbers proves nothing. */
    fine = fine && stats.not_finite == 0 && stats.particles > 100;
    skv_world_destroy(world);
    return fine ? hash : 0;
}
