/* Bodies that an engine of the host's own moves: what it leaves alone moves as any body does, what
 * it holds weighs what it should, however light, and it alone lets them meet walls. */
#include "support/fixture.h"
#include "support/misuse.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define SPACING 0.0155f

static skv_body_def box(float x, float y, float density, bool hosted)
{
    skv_body_def def = skv_default_body_def();
    def.x = x;
    def.y = y;
    def.density = density;
    def.hosted = hosted;
    return def;
}

static skv_world *make_pool(int threads)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, threads);
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 1.6f, 0.3f);
    return world;
}

static skv_result lead(skv_world *world, const skv_body *b, skv_error *error)
{
    return skv_world_lead_body(world, b->id, b->x, b->y, b->angle, b->vx, b->vy, b->spin, error);
}

/* ---- An engine that does nothing ------------------------------------------------------------- */

static void leave_alone(skv_world *world, float dt, void *user)
{
    skv_body body = fixture_body(world, *(skv_body_id *)user);
    (void)dt;
    if (body.hosted)
        assert_int_equal(lead(world, &body, NULL), SKV_OK);
}

static void what_is_left_alone_moves_as_all_do(void **unused)
{
    (void)unused;
    uint64_t hash[3];
    for (int k = 0; k < 3; k++) {
        skv_world *world = make_pool(k == 2 ? 2 : 1);
        skv_body_def def = box(0.5f, 0.35f, 300, k > 0);
        def.spin = 2;
        skv_body_id id = fixture_add_body(world, &def);
        skv_world_set_before_substep(world, leave_alone, &id);
        fixture_run(world, 60);
        hash[k] = skv_world_hash(world);
        assert_true(hash[k] == hash[0]);
        skv_world_destroy(world);
    }
}

/* ---- An engine that holds -------------------------------------------------------------------- */

typedef struct holder {
    skv_body_id id;
    float x, y; /* where */
    float sway; /* m: how far to and fro at most, once a second */
    double time;
    double held; /* N s/m upwards, without what weight takes */
} holder;

static void hold(skv_world *world, float dt, void *user)
{
    holder *h = user;
    skv_body body = fixture_body(world, h->id);
    h->held -= (double)body.moved_mass * (double)body.vy;
    h->time += (double)dt;
    float turn = 6.2831853f * (float)h->time;
    body.x = h->x + h->sway * sinf(turn);
    body.y = h->y;
    body.angle = body.vy = body.spin = 0;
    body.vx = 6.2831853f * h->sway * cosf(turn);
    assert_int_equal(lead(world, &body, NULL), SKV_OK);
}

/* With less than the layer's mass it would be a fifth for 10 kg/m^2. */
static void what_is_held_weighs_what_it_should(void **unused)
{
    (void)unused;
    static const float densities[] = {10, 100, 500, 3000};
    for (int k = 0; k < 4; k++) {
        skv_world *world = make_pool(1);
        skv_body_def def = box(0.8f, 0.15f, densities[k], true);
        holder h = {fixture_add_body(world, &def), 0.8f, 0.15f, 0, 0, 0};
        skv_world_set_before_substep(world, hold, &h);
        fixture_run(world, 180);
        h.held = h.time = 0;
        fixture_run(world, 120);
        double lift = 9.81 * (1000 - (double)densities[k]) * 0.01;
        assert_near(h.held / h.time, -lift, 0.06 * 9.81 * 1000 * 0.01);
        skv_body body = fixture_body(world, h.id);
        assert_near((double)body.force_y / (9.81 * 1000 * 0.01), 1, 0.06);
        assert_true((double)body.moved_mass > 2 + (double)body.mass);
        assert_true(body.moved_inertia > body.inertia);
        skv_world_destroy(world);
    }
}

/* It sweeps the water, and nothing gets into it. */
static void what_is_moved_takes_water_along(void **unused)
{
    (void)unused;
    skv_world *world = make_pool(1);
    skv_body_def def = box(0.8f, 0.15f, 100, true);
    holder h = {fixture_add_body(world, &def), 0.8f, 0.15f, 0.2f, 0, 0};
    int count = skv_world_particle_count(world);
    skv_world_set_before_substep(world, hold, &h);
    for (int frame = 0; frame < 120; frame++) {
        fixture_run(world, 1);
        skv_body body = fixture_body(world, h.id);
        skv_area inside =
            skv_box(body.x - 0.048f, body.y - 0.048f, body.x + 0.048f, body.y + 0.048f);
        assert_int_equal(skv_world_query(world, &inside, NULL, 0), 0);
    }
    assert_int_equal(skv_world_particle_count(world), count);
    assert_true(skv_world_stats(world).kinetic_energy > 1);
    assert_int_equal(skv_world_stats(world).not_finite, 0);
    skv_world_destroy(world);
}

/* Other bodies meet what an engine holds, as they meet all bodies; and itself it meets no wall. */
static void walls_and_others(void **unused)
{
    (void)unused;
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, SPACING, 1);
    skv_world *world, *copy;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    skv_body_def held = box(0.8f, 0.2f, 500, true), own = box(0.8f, 0.35f, 500, false);
    holder h = {fixture_add_body(world, &held), 0.8f, 0.2f, 0, 0, 0};
    skv_body_id rests = fixture_add_body(world, &own);
    skv_world_set_before_substep(world, hold, &h);
    fixture_run(world, 120);
    assert_near((double)fixture_body(world, rests).y, 0.3, 0.002);
    /* A copy and a snapshot know that it is hosted, but not by whom: it falls through the floor,
     * and what lies on it does not. */
    assert_int_equal(skv_world_copy(world, NULL, &copy, NULL), SKV_OK);
    fixture_run(copy, 60);
    assert_true(fixture_body(copy, h.id).hosted && !fixture_body(copy, rests).hosted);
    assert_true((double)fixture_body(copy, h.id).y < -0.1);
    assert_near((double)fixture_body(copy, rests).y, 0.05, 0.01);
    skv_world_destroy(copy);
    skv_world_destroy(world);
}

/* ---- What it may not ------------------------------------------------------------------------- */

static void expect(skv_world *world, const skv_body *body, const char *why)
{
    skv_error error = {0};
    assert_int_equal(lead(world, body, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, why));
}

static void ask_for_too_much(skv_world *world, float dt, void *user)
{
    const skv_body_id *ids = user;
    skv_body body = fixture_body(world, ids[0]), other = fixture_body(world, ids[1]);
    (void)dt;
    expect(world, &other, "is not hosted");
    other.id = 77;
    expect(world, &other, "none named 77");
    other = body;
    other.vx = 101;
    expect(world, &other, "velocity");
    other = body;
    other.y += 0.11f;
    expect(world, &other, "too far");
    other = body;
    other.angle = NAN;
    expect(world, &other, "too far");
}

static void what_an_engine_may_not_is_refused(void **unused)
{
    (void)unused;
    skv_world *world = make_pool(1);
    skv_body_def def = box(0.5f, 0.5f, 500, true);
    skv_error error = {0};
    def.fixed = true;
    assert_int_equal(skv_world_add_body(world, &def, NULL, NULL, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "hosted"));
    def.fixed = false;
    def.pinned = true;
    assert_int_equal(skv_world_add_body(world, &def, NULL, NULL, NULL), SKV_ERROR_VALUE);
    def.pinned = false;
    skv_body_id ids[2] = {fixture_add_body(world, &def)};
    def = box(0.8f, 0.5f, 500, false);
    ids[1] = fixture_add_body(world, &def);
    skv_world_set_before_substep(world, ask_for_too_much, ids);
    fixture_run(world, 1);
    skv_body body = fixture_body(world, ids[0]);
    misuse_begin(NULL);
    assert_int_equal(lead(world, &body, NULL), SKV_ERROR_VALUE); /* between steps */
    assert_int_equal(misuses, 1);
    misuse_end(NULL);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_left_alone_moves_as_all_do),
        cmocka_unit_test(what_is_held_weighs_what_it_should),
        cmocka_unit_test(what_is_moved_takes_water_along),
        cmocka_unit_test(walls_and_others),
        cmocka_unit_test(what_an_engine_may_not_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
