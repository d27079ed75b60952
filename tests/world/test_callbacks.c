/* What a host's callbacks may do to the world that calls them: whatever they try, the world is what
 * it would be without, or with what is allowed; and the default assert handler says what is wrong.
 */
#include "support/fixture.h"
#include "support/host.h"
#include "support/misuse.h"

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

/* What no callback may do; returns how many calls were refused. */
static int try_to_go_on(skv_world *world)
{
    static uint8_t bytes[1 << 22];
    skv_world *copy;
    skv_terrain *painted;
    const skv_brush_stroke wall = {0.2f, 0.2f, 1.2f, 0.7f, 0.05f, false};
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &wall, 1, &painted, NULL), SKV_OK);
    int before = misuses;
    assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_settle(world, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_save(world, false, bytes, sizeof bytes, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_restore(world, bytes, sizeof bytes, NULL), SKV_ERROR_VALUE);
    assert_int_equal(skv_world_copy(world, NULL, &copy, NULL), SKV_ERROR_VALUE);
    assert_null(copy);
    assert_int_equal(skv_world_set_terrain(world, painted, NULL, NULL), SKV_ERROR_VALUE);
    skv_world_destroy(world);
    skv_terrain_destroy(painted);
    return misuses - before;
}

enum { GOES_ON = 7, CHANGES = 25 };

/* The names of a hand, a force, an emitter and a drain, which are added unless that is refused. */
static void name_one_each(skv_world *world, skv_acting_id names[SKV_ACTING_DRAIN + 1])
{
    const skv_hand hand = skv_default_hand();
    const skv_force force = {.area = skv_box(0, 0, 1, 1)};
    const skv_emitter emitter = {.x = 1, .y = 0.7f, .width = 0.1f};
    const skv_drain drain = {.area = skv_box(1.5f, 0, 1.6f, 0.02f)};
    for (int kind = 0; kind <= SKV_ACTING_DRAIN; kind++)
        names[kind] = skv_world_acting_id(world, (skv_acting_kind)kind, 0);
    if (!names[SKV_ACTING_HAND])
        skv_world_add_hand(world, &hand, &names[SKV_ACTING_HAND], NULL);
    if (!names[SKV_ACTING_FORCE])
        skv_world_add_force(world, &force, &names[SKV_ACTING_FORCE], NULL);
    if (!names[SKV_ACTING_EMITTER])
        skv_world_add_emitter(world, &emitter, &names[SKV_ACTING_EMITTER], NULL);
    if (!names[SKV_ACTING_DRAIN])
        skv_world_add_drain(world, &drain, &names[SKV_ACTING_DRAIN], NULL);
}

/* What changes the world, one call of each; returns how many were refused. */
static int try_to_change(skv_world *world)
{
    const skv_particle particle = {0.8f, 0.6f, 0, 0};
    const skv_particle_id id = 3;
    const float speed = 0.1f;
    const uint8_t dye = 2;
    skv_area spot = skv_circle(0.05f, 0.05f, 0.03f);
    skv_fill_def fill = skv_default_fill_def();
    fill.x0 = 1.2f, fill.y0 = 0.5f, fill.x1 = 1.3f, fill.y1 = 0.6f;
    skv_hand hand = skv_default_hand();
    const skv_force force = {.area = skv_box(0, 0, 1, 1), .ax = 1};
    const skv_emitter emitter = {.x = 1, .y = 0.7f, .vy = -1, .width = 0.1f};
    const skv_drain drain = {.area = skv_box(1.5f, 0, 1.6f, 0.02f)};
    const float place = 0.75f;
    skv_acting_id names[SKV_ACTING_DRAIN + 1];
    name_one_each(world, names);
    int before = misuses;
    const skv_result results[CHANGES] = {
        skv_world_add_particle(world, 0.7f, 0.7f, 0, 0, NULL),
        skv_world_add_particles(world, &particle, 1, NULL, NULL, NULL),
        skv_world_fill(world, &fill, NULL, NULL),
        skv_world_add_velocity(world, 0, 1, 0.1f, 0, NULL),
        skv_world_set_velocities(world, 1, 1, &speed, &speed, NULL),
        skv_world_set_dyes(world, 0, 1, &dye, NULL),
        skv_world_dye_area(world, &spot, 1, NULL, NULL),
        skv_world_remove(world, &id, 1, NULL, NULL),
        skv_world_remove_area(world, &spot, NULL, NULL),
        skv_world_set_gravity(world, 1, -9, NULL),
        skv_world_set_hands(world, &hand, 1, NULL),
        skv_world_set_forces(world, &force, 1, NULL),
        skv_world_set_emitters(world, &emitter, 1, NULL),
        skv_world_set_drains(world, &drain, 1, NULL),
        skv_world_set(world, "fluid.viscosity", "0.0001", NULL),
        skv_world_set_number(world, skv_world_parameter("fluid.adhesion"), 0.5, NULL),
        skv_world_set_positions(world, &id, 1, &place, &place, NULL),
        skv_world_add_hand(world, &hand, NULL, NULL),
        skv_world_add_force(world, &force, NULL, NULL),
        skv_world_add_emitter(world, &emitter, NULL, NULL),
        skv_world_add_drain(world, &drain, NULL, NULL),
        skv_world_change_hand(world, names[SKV_ACTING_HAND], &hand, NULL),
        skv_world_change_force(world, names[SKV_ACTING_FORCE], &force, NULL),
        skv_world_change_emitter(world, names[SKV_ACTING_EMITTER], &emitter, NULL),
        skv_world_change_drain(world, names[SKV_ACTING_DRAIN], &drain, NULL),
    };
    int refused = misuses - before;
    for (int i = 0; i < CHANGES; i++)
        assert_int_equal(results[i], refused ? SKV_ERROR_VALUE : SKV_OK);
    return refused;
}

/* All that a callback may only read. */
static void read_all(const skv_world *world)
{
    skv_area spot = skv_circle(0.1f, 0.1f, 0.05f);
    skv_packing packing;
    int count;
    skv_world_query(world, &spot, NULL, 0);
    skv_world_ray(world, 0, 0.8f, 1.5f, 0);
    skv_world_events(world, &count);
    assert_int_equal(skv_world_stats(world).not_finite, 0);
    assert_int_equal(skv_world_packing(world, &packing, NULL), SKV_OK);
    assert_true(skv_world_snapshot_size(world, true) > 0);
}

/* ---- A logger -------------------------------------------------------------------------------- */

typedef struct meddler {
    skv_world *world;
    int calls;
} meddler;

static void meddle_when_told(const char *text, void *user)
{
    meddler *m = user;
    assert_true(strlen(text) > 0);
    m->calls++;
    read_all(m->world);
    assert_int_equal(try_to_change(m->world), CHANGES);
    assert_int_equal(try_to_go_on(m->world), GOES_ON);
}

/* It is called while a fill has made room and not yet used it. */
static void a_logger_reads_at_most(void **unused)
{
    (void)unused;
    uint64_t hash[2];
    for (int meddles = 0; meddles < 2; meddles++) {
        skv_world_def def = skv_default_world_def();
        def.fluid.spacing = 0.03f;
        def.capacity = 50;
        def.threads = 1;
        skv_world *world;
        assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
        meddler m = {world, 0};
        if (meddles)
            skv_world_set_log(world, meddle_when_told, &m);
        int filled = fixture_fill(world, 0, 0, 0.8f, 0.4f);
        assert_int_equal(skv_world_particle_count(world), filled);
        assert_int_equal(m.calls, meddles);
        fixture_run(world, 2);
        hash[meddles] = skv_world_hash(world);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
}

/* ---- skv_inside ------------------------------------------------------------------------------ */

static bool meddle_when_asked(float x, float y, void *user)
{
    meddler *m = user;
    if (m->calls++ % 50 == 0) {
        read_all(m->world);
        assert_int_equal(try_to_change(m->world), CHANGES);
        assert_int_equal(try_to_go_on(m->world), GOES_ON);
    }
    return x + y < 1;
}

static bool below_the_slope(float x, float y, void *user)
{
    (void)user;
    return x + y < 1;
}

static void inside_reads_at_most(void **unused)
{
    (void)unused;
    uint64_t hash[2];
    int added[2];
    for (int meddles = 0; meddles < 2; meddles++) {
        skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.03f, 1);
        meddler m = {world, 0};
        skv_fill_def fill = skv_default_fill_def();
        fill.inside = meddles ? meddle_when_asked : below_the_slope;
        fill.user = &m;
        skv_placed placed;
        assert_int_equal(skv_world_fill(world, &fill, &placed, NULL), SKV_OK);
        added[meddles] = placed.added;
        assert_int_equal(m.calls > 100, meddles);
        /* It is over: the same is allowed again. */
        assert_int_equal(try_to_change(world), 0);
        fixture_run(world, 2);
        hash[meddles] = skv_world_hash(world);
        skv_world_destroy(world);
    }
    assert_int_equal(added[0], added[1]);
    assert_true(hash[0] == hash[1]);
}

static bool change_the_terrain(float x, float y, void *user)
{
    meddler *m = user;
    const skv_brush_stroke wall = {0.2f, 0.2f + 0.001f * (float)m->calls, 1.2f, 0.7f, 0.05f, false};
    skv_terrain *painted;
    (void)x, (void)y;
    if (m->calls++ < 5) {
        assert_int_equal(skv_terrain_paint(skv_world_terrain(m->world), &wall, 1, &painted, NULL),
                         SKV_OK);
        assert_int_equal(skv_world_set_terrain(m->world, painted, NULL, NULL), SKV_OK);
    }
    return true;
}

/* Counting has no world to guard; the terrain it looks at may be given up meanwhile. */
static void a_count_keeps_its_terrain(void **unused)
{
    (void)unused;
    skv_world *world = fixture_dam(SKV_LAW_CALIBRATED, 0.05f, 1);
    skv_fill_def fill = skv_default_fill_def();
    int all = skv_fill_count(skv_world_terrain(world), 0.05f, &fill);
    meddler m = {world, 0};
    fill.inside = change_the_terrain;
    fill.user = &m;
    assert_int_equal(skv_fill_count(skv_world_terrain(world), 0.05f, &fill), all);
    assert_int_equal(misuses, 0);
    skv_world_destroy(world);
}

/* ---- Before a substep ------------------------------------------------------------------------ */

static void change_and_go_on(skv_world *world, float dt, void *user)
{
    meddler *m = user;
    (void)dt;
    m->calls++;
    read_all(world);
    assert_int_equal(try_to_change(world), 0);
    assert_int_equal(try_to_go_on(world), GOES_ON);
}

static void before_a_substep_the_world_may_change_but_not_go_on(void **unused)
{
    (void)unused;
    for (int solver = SKV_SOLVER_FAST; solver <= SKV_SOLVER_REFERENCE; solver++) {
        skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, (skv_solver_kind)solver, 0, 0.05f, 1);
        skv_world *world = fixture_dam_of(&def);
        meddler m = {world, 0};
        skv_world_set_before_substep(world, change_and_go_on, &m);
        fixture_run(world, 2);
        assert_int_equal(m.calls, skv_world_substep_count(world));
        assert_int_equal(skv_world_stats(world).not_finite, 0);
        skv_world_set_before_substep(world, NULL, NULL);
        assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
        skv_world_destroy(world);
    }
}

/* ---- A host's threads ------------------------------------------------------------------------ */

static void meddle_with_tasks(void *user, int count, void (*member)(void *team), void *team)
{
    meddler *m = user;
    if (m->world && m->calls++ % 10 == 0) {
        assert_int_equal(try_to_change(m->world), CHANGES);
        assert_int_equal(try_to_go_on(m->world), GOES_ON);
    }
    host_run(count, member, team);
}

static void lent_threads_change_nothing(void **unused)
{
    (void)unused;
    meddler m = {NULL, 0};
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.01f; /* so fine that other walls are work for more than one thread */
    def.tasks = (skv_task_system){2, meddle_with_tasks, &m};
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    int filled = fixture_fill(world, 0, 0, 0.4f, 0.2f);
    m.world = world;
    assert_int_equal(skv_world_settle(world, NULL), SKV_OK);
    fixture_run(world, 2);
    assert_true(m.calls > 10);
    m.calls = 0;
    const skv_brush_stroke wall = {1.1f, 0.55f, 1.3f, 0.55f, 0.3f, false};
    skv_terrain *painted;
    assert_int_equal(skv_terrain_paint(skv_world_terrain(world), &wall, 1, &painted, NULL), SKV_OK);
    assert_int_equal(skv_world_set_terrain(world, painted, NULL, NULL), SKV_OK);
    assert_true(m.calls > 0);
    assert_int_equal(skv_world_particle_count(world), filled);
    m.world = NULL;
    skv_world_destroy(world);
}

/* ---- The default assert handler -------------------------------------------------------------- */

/* What a child says that makes a mistake, and that it aborts. */
static void catch_last_words(void (*mistake)(void), char *text, size_t room)
{
    int ends[2], status;
    assert_int_equal(pipe(ends), 0);
    fflush(NULL);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        signal(SIGABRT, SIG_DFL);
        dup2(ends[1], STDERR_FILENO);
        mistake();
        _exit(0);
    }
    close(ends[1]);
    size_t length = 0;
    for (ssize_t got; length + 1 < room; length += (size_t)got)
        if ((got = read(ends[0], text + length, room - 1 - length)) <= 0)
            break;
    text[length] = '\0';
    close(ends[0]);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
}

static void create_from_zeros(void)
{
    skv_world *world;
    skv_world_def def;
    memset(&def, 0, sizeof def);
    skv_world_create(&def, &world, NULL);
}

static void fill_from_zeros(void)
{
    skv_fill_def def;
    memset(&def, 0, sizeof def);
    skv_world_fill(fixture_dam(SKV_LAW_CALIBRATED, 0.05f, 1), &def, NULL, NULL);
}

static void step_nothing(void)
{
    skv_world_step(NULL, 1.0f / 60, NULL);
}

static void the_default_handler_says_what_is_wrong(void **unused)
{
    (void)unused;
    const struct {
        void (*mistake)(void);
        const char *file, *condition;
    } mistakes[] = {
        {create_from_zeros, "world.c:", "def was initialised by its _init"},
        {fill_from_zeros, "fill.c:", "def was initialised by its _init"},
        {step_nothing, "step.c:", "skv_may_step(world)"},
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        char text[1024];
        catch_last_words(mistakes[i].mistake, text, sizeof text);
        assert_ptr_equal(strstr(text, "skvalp: "), text);
        if (!strstr(text, mistakes[i].file) || !strstr(text, mistakes[i].condition))
            fail_msg("it says only: %s", text);
        assert_ptr_equal(strchr(text, '\n'), text + strlen(text) - 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_logger_reads_at_most, misuse_begin, misuse_end),
        cmocka_unit_test_setup_teardown(inside_reads_at_most, misuse_begin, misuse_end),
        cmocka_unit_test_setup_teardown(a_count_keeps_its_terrain, misuse_begin, misuse_end),
        cmocka_unit_test_setup_teardown(before_a_substep_the_world_may_change_but_not_go_on,
                                        misuse_begin, misuse_end),
        cmocka_unit_test_setup_teardown(lent_threads_change_nothing, misuse_begin, misuse_end),
        cmocka_unit_test(the_default_handler_says_what_is_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
