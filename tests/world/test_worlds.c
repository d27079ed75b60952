/* Nothing escapes random painted worlds under five seconds of violent sloshing: gravity of two to
 * three g that turns every quarter to half second, and hands that jerk the fluid about. A particle
 * stays in the closed chamber in which it started, stays finite, and none is lost.
 *
 * Worlds are named by their seed. 6 of them by default, 100 with SKV_LONG_TESTS=1;
 * SKV_WORLD=N runs world N alone and says more. */
#include "skvalp/skvalp.h"
#include "support/long.h"
#include "world/painted.h"

#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define WORLDS         4
#define MANY_WORLDS    100
#define FRAMES         300
#define MAX_PARTICLES  600
#define FRAMES_A_CHECK 10

/* One world and what is known of it. */
typedef struct trial {
    uint64_t seed;
    dice dice;
    painted picture;
    skv_world *world;
    float pixel; /* m */
    skv_solver_kind solver;
    int particles;
    int chamber[MAX_PARTICLES]; /* in which each particle started */
    char failure[640];          /* empty: none so far */
} trial;

#define FAIL(t, ...)                                                                               \
    do {                                                                                           \
        snprintf((t)->failure, sizeof(t)->failure, __VA_ARGS__);                                   \
        return false;                                                                              \
    } while (0)

/* Where fluid is at the start: some stripes full, some empty, so that there is room to slosh. */
typedef struct stripes {
    float x, y, phase;
} stripes;

static bool inside_stripes(float x, float y, void *user)
{
    const stripes *s = user;
    float along = s->x * x + s->y * y + s->phase;
    return along - floorf(along) < 0.6f;
}

static skv_fill_def fill_stripes(stripes *s)
{
    skv_fill_def fill = skv_default_fill_def();
    fill.inside = inside_stripes;
    fill.user = s;
    return fill;
}

/* The spacing, by bisection, at which the fill gives a few hundred particles. */
static float choose_spacing(const skv_terrain *terrain, stripes *s, int wanted)
{
    skv_fill_def fill = fill_stripes(s);
    float low = 0.004f, high = 0.1f;
    for (int i = 0; i < 12; i++) {
        float middle = 0.5f * (low + high);
        if (skv_fill_count(terrain, middle, &fill) > wanted)
            low = middle;
        else
            high = middle;
    }
    return high;
}

static bool set_up(trial *t)
{
    skv_error error;
    paint(&t->picture, &t->dice);
    skv_terrain_def terrain_def = skv_default_terrain_def();
    int longer = t->picture.width > t->picture.height ? t->picture.width : t->picture.height;
    t->pixel = 1.6f / (float)longer;
    terrain_def.width = t->picture.width;
    terrain_def.height = t->picture.height;
    terrain_def.coverage = t->picture.coverage;
    terrain_def.pixel_size = t->pixel;
    skv_terrain *terrain = NULL;
    if (skv_terrain_create(&terrain_def, &terrain, &error) != SKV_OK)
        FAIL(t, "terrain: %s", error.text);

    stripes s = {dice_float(&t->dice, -3.0f, 3.0f), dice_float(&t->dice, 0.5f, 3.0f),
                 dice_float(&t->dice, 0.0f, 1.0f)};
    skv_world_def def = skv_default_world_def();
    skv_law law = dice_int(&t->dice, 0, 3) ? SKV_LAW_CALIBRATED : SKV_LAW_CLAVET;
    def.terrain = terrain;
    def.fluid = skv_default_fluid_def(law);
    def.fluid.spacing = choose_spacing(terrain, &s, dice_int(&t->dice, 300, MAX_PARTICLES - 1));
    t->solver = dice_int(&t->dice, 0, 2) ? SKV_SOLVER_FAST : SKV_SOLVER_REFERENCE;
    def.solver = t->solver;
    def.threads = 1;
    def.capacity = MAX_PARTICLES;
    /* Half of the worlds know of the violence that comes, the others step as for plain water. */
    if (dice_int(&t->dice, 0, 1))
        def.gravity_y = -3.0f * 9.81f;
    /* And some take steps that are far too long: ugly, but it must hold. */
    if (dice_int(&t->dice, 0, 7) == 0)
        def.substeps = dice_int(&t->dice, 1, 2);
    if (skv_world_create(&def, &t->world, &error) != SKV_OK) {
        skv_terrain_destroy(terrain);
        FAIL(t, "world: %s", error.text);
    }
    skv_fill_def fill = fill_stripes(&s);
    fill.limit = MAX_PARTICLES;
    skv_placed placed;
    if (skv_world_fill(t->world, &fill, &placed, &error) != SKV_OK)
        FAIL(t, "fill: %s", error.text);
    t->particles = placed.added;
    if (t->particles == 0)
        FAIL(t, "the fill found no room");
    skv_particles p = skv_world_particles(t->world);
    for (int i = 0; i < p.count; i++)
        t->chamber[i] = painted_chamber(&t->picture, p.x[i] / t->pixel, p.y[i] / t->pixel);
    return true;
}

/* Turns gravity and moves the hands. */
static bool shake(trial *t, float *gx, float *gy)
{
    float angle = dice_float(&t->dice, 0.0f, 6.2831853f);
    float strength = dice_float(&t->dice, 2.0f, 3.0f) * 9.81f;
    *gx = strength * cosf(angle);
    *gy = strength * sinf(angle);
    skv_error error;
    if (skv_world_set_gravity(t->world, *gx, *gy, &error) != SKV_OK)
        FAIL(t, "gravity: %s", error.text);
    const skv_terrain *terrain = skv_world_terrain(t->world);
    skv_hand hands[3];
    int count = dice_int(&t->dice, 0, 3);
    for (int i = 0; i < count; i++) {
        hands[i] = skv_default_hand();
        hands[i].x = dice_float(&t->dice, 0.0f, skv_terrain_width(terrain));
        hands[i].y = dice_float(&t->dice, 0.0f, skv_terrain_height(terrain));
        hands[i].vx = dice_float(&t->dice, -8.0f, 8.0f);
        hands[i].vy = dice_float(&t->dice, -8.0f, 8.0f);
    }
    if (skv_world_set_hands(t->world, hands, count, &error) != SKV_OK)
        FAIL(t, "hands: %s", error.text);
    return true;
}

static bool check(trial *t, int frame)
{
    skv_stats stats = skv_world_stats(t->world);
    skv_particles p = skv_world_particles(t->world);
    if (stats.particles != t->particles || p.count != t->particles)
        FAIL(t, "frame %d: %d particles became %d", frame, t->particles, p.count);
    if (stats.not_finite != 0)
        FAIL(t, "frame %d: %d particles not finite", frame, stats.not_finite);
    if (stats.escaped != 0)
        FAIL(t, "frame %d: %d particles escaped", frame, stats.escaped);
    if (!isfinite(stats.kinetic_energy) || !isfinite(stats.potential_energy) ||
        !isfinite(stats.momentum_x) || !isfinite(stats.momentum_y))
        FAIL(t, "frame %d: energy or momentum not finite", frame);
    int left = 0, first = -1;
    for (int i = 0; i < p.count; i++) {
        float px = p.x[i] / t->pixel, py = p.y[i] / t->pixel;
        if (painted_chamber(&t->picture, px, py) != t->chamber[i]) {
            first = left++ ? first : i;
        }
    }
    if (left)
        FAIL(t,
             "frame %d: %d particles left their chamber, first number %d (chamber %d -> %d) at "
             "pixel (%.2f, %.2f), distance %.2f px, speed %.2f m/s",
             frame, left, first, t->chamber[first],
             painted_chamber(&t->picture, p.x[first] / t->pixel, p.y[first] / t->pixel),
             (double)(p.x[first] / t->pixel), (double)(p.y[first] / t->pixel),
             (double)(skv_terrain_distance(skv_world_terrain(t->world), p.x[first], p.y[first]) /
                      t->pixel),
             (double)hypotf(p.vx[first], p.vy[first]));
    return true;
}

static bool slosh(trial *t)
{
    int next = 0;
    float gx = 0.0f, gy = 0.0f;
    for (int frame = 1; frame <= FRAMES; frame++) {
        if (frame > next) {
            if (!shake(t, &gx, &gy))
                return false;
            next = frame + dice_int(&t->dice, 15, 30);
        }
        if (skv_world_step(t->world, 1.0f / 60.0f, NULL) != SKV_OK)
            FAIL(t, "frame %d: the step failed", frame);
        if (frame % FRAMES_A_CHECK == 0 && !check(t, frame))
            return false;
    }
    return true;
}

/* Runs one world; prints what went wrong. */
static bool run_world(uint64_t seed, bool talk)
{
    trial *t = calloc(1, sizeof *t);
    if (!t)
        abort();
    t->seed = seed;
    t->dice = dice_from_seed(seed);
    bool good = set_up(t) && slosh(t);
    if (!good || talk)
        print_message("world %llu (%s, %s, %d x %d pixels, %d chambers, %d particles, law %s, "
                      "%s solver, spacing %.1f px, %d substeps): %s\n",
                      (unsigned long long)seed, painted_kind_name(t->picture.kind),
                      t->picture.grey ? "grey" : "black and white", t->picture.width,
                      t->picture.height, t->picture.chambers, t->particles,
                      t->world ? skv_law_name(skv_world_fluid(t->world)->law) : "-",
                      t->solver == SKV_SOLVER_FAST ? "fast" : "reference",
                      t->world ? (double)(skv_world_spacing(t->world) / t->pixel) : 0.0,
                      t->world ? skv_world_substeps_per_frame(t->world) : 0,
                      good ? "fine" : t->failure);
    skv_world_destroy(t->world);
    free(t);
    return good;
}

/* Two threads share the worlds: the library has no global state that could mind. */
typedef struct queue {
    atomic_int next, bad;
    int end;
    bool talk;
} queue;

static void *work(void *argument)
{
    queue *q = argument;
    for (int seed = atomic_fetch_add(&q->next, 1); seed < q->end;
         seed = atomic_fetch_add(&q->next, 1))
        if (!run_world((uint64_t)seed, q->talk))
            atomic_fetch_add(&q->bad, 1);
    return NULL;
}

static void test_nothing_escapes(void **state)
{
    (void)state;
    const char *one = getenv("SKV_WORLD");
    int first = one ? atoi(one) : 0;
    int count = one ? 1 : long_tests() ? MANY_WORLDS : WORLDS;
    queue q = {.end = first + count, .talk = one != NULL};
    atomic_init(&q.next, first);
    atomic_init(&q.bad, 0);
    pthread_t second;
    bool helped = pthread_create(&second, NULL, work, &q) == 0;
    work(&q);
    if (helped)
        pthread_join(second, NULL);
    int bad = atomic_load(&q.bad);
    if (bad)
        fail_msg("something went wrong in %d of %d worlds; SKV_WORLD=N runs one", bad, count);
}

/* The generator itself: walls cut the picture, and a chamber is found from a point in it. */
static void test_pictures_have_chambers(void **state)
{
    (void)state;
    painted *p = calloc(1, sizeof *p);
    assert_non_null(p);
    int closed = 0, kinds[PAINTED_KINDS] = {0};
    for (uint64_t seed = 0; seed < 60; seed++) {
        dice d = dice_from_seed(seed);
        paint(p, &d);
        kinds[p->kind]++;
        closed += p->chambers > 1;
        int solid = 0;
        for (int i = 0; i < p->width * p->height; i++) {
            bool free_pixel = p->coverage[i] < 128;
            solid += !free_pixel;
            assert_true((p->chamber[i] != 0) == free_pixel);
            if (free_pixel) {
                int x = i % p->width, y = i / p->width;
                assert_int_equal(painted_chamber(p, (float)x + 0.5f, (float)y + 0.5f),
                                 p->chamber[i]);
            }
        }
        assert_in_range(solid, 1, p->width * p->height - 1);
    }
    for (int k = 0; k < PAINTED_KINDS; k++)
        assert_in_range(kinds[k], 3, 60);
    assert_in_range(closed, 20, 60);
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures_have_chambers),
        cmocka_unit_test(test_nothing_escapes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
