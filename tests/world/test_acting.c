/* What acts, one by one: names hold while others come and go, each does what it does in a list of
 * all, and names go with snapshots. */
#include "base/envelope.h"
#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { KINDS = 4 };
static const int most[KINDS] = {SKV_MAX_HANDS, SKV_MAX_FORCES, SKV_MAX_EMITTERS, SKV_MAX_DRAINS};

/* Members of which each is told from others by the place where it acts. */
static skv_hand hand_at(float x)
{
    skv_hand hand = skv_default_hand();
    hand.x = x, hand.y = 0.1f;
    return hand;
}

static skv_force force_at(float x)
{
    return (skv_force){.area = skv_circle(x, 0.1f, 0.1f), .ax = 3, .ay = 15};
}

static skv_emitter emitter_at(float x)
{
    return (skv_emitter){.x = x, .y = 0.8f, .vy = -1, .width = 0.08f};
}

static skv_drain drain_at(float x)
{
    return (skv_drain){.area = skv_circle(x, 0, 0.04f), .rate = 0.03f + 0.02f * x};
}

static skv_result add(skv_world *world, int kind, float x, skv_acting_id *id, skv_error *error)
{
    const skv_hand hand = hand_at(x);
    const skv_force force = force_at(x);
    const skv_emitter emitter = emitter_at(x);
    const skv_drain drain = drain_at(x);
    return kind == SKV_ACTING_HAND      ? skv_world_add_hand(world, &hand, id, error)
           : kind == SKV_ACTING_FORCE   ? skv_world_add_force(world, &force, id, error)
           : kind == SKV_ACTING_EMITTER ? skv_world_add_emitter(world, &emitter, id, error)
                                        : skv_world_add_drain(world, &drain, id, error);
}

static skv_result change(skv_world *world, int kind, skv_acting_id id, float x, skv_error *error)
{
    const skv_hand hand = hand_at(x);
    const skv_force force = force_at(x);
    const skv_emitter emitter = emitter_at(x);
    const skv_drain drain = drain_at(x);
    return kind == SKV_ACTING_HAND      ? skv_world_change_hand(world, id, &hand, error)
           : kind == SKV_ACTING_FORCE   ? skv_world_change_force(world, id, &force, error)
           : kind == SKV_ACTING_EMITTER ? skv_world_change_emitter(world, id, &emitter, error)
                                        : skv_world_change_drain(world, id, &drain, error);
}

/* The places of all members of a kind, in the order of the list. */
static int places_of(const skv_world *world, int kind, float x[16])
{
    int count = 0;
    if (kind == SKV_ACTING_HAND)
        for (const skv_hand *all = skv_world_hands(world, &count), *h = all; h < all + count; h++)
            x[h - all] = h->x;
    else if (kind == SKV_ACTING_FORCE)
        for (const skv_force *all = skv_world_forces(world, &count), *f = all; f < all + count; f++)
            x[f - all] = f->area.x0;
    else if (kind == SKV_ACTING_EMITTER)
        for (const skv_emitter *all = skv_world_emitters(world, &count), *e = all; e < all + count;
             e++)
            x[e - all] = e->x;
    else
        for (const skv_drain *all = skv_world_drains(world, &count), *d = all; d < all + count; d++)
            x[d - all] = d->area.x0;
    return count;
}

static void expect_places(const skv_world *world, int kind, int count, const float *expected)
{
    float x[16];
    assert_int_equal(places_of(world, kind, x), count);
    for (int i = 0; i < count; i++) {
        assert_true(x[i] == expected[i]);
        skv_acting_kind found = SKV_ACTING_HAND;
        skv_acting_id id = skv_world_acting_id(world, (skv_acting_kind)kind, i);
        assert_int_equal(skv_world_acting_index(world, id, &found), i);
        assert_int_equal(found, kind);
    }
    assert_int_equal(skv_world_acting_id(world, (skv_acting_kind)kind, count), 0);
    assert_int_equal(skv_world_acting_id(world, (skv_acting_kind)kind, -1), 0);
}

static void names_hold_while_others_come_and_go(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.03f, 1);
    for (int kind = 0; kind < KINDS; kind++) {
        skv_acting_id id[4], other;
        skv_error error;
        for (int i = 0; i < 3; i++) {
            assert_int_equal(add(world, kind, 0.3f + 0.3f * (float)i, &id[i], NULL), SKV_OK);
            assert_int_equal(skv_world_acting_index(world, id[i], NULL), i);
            assert_true(id[i] != 0 && (i == 0 || id[i] > id[i - 1]));
        }
        assert_true(skv_world_remove_acting(world, id[0]));
        expect_places(world, kind, 2, (const float[]){0.3f + 0.3f, 0.3f + 0.6f});
        assert_int_equal(skv_world_acting_index(world, id[0], NULL), -1);
        assert_int_equal(skv_world_acting_index(world, id[2], NULL), 1);
        assert_false(skv_world_remove_acting(world, id[0]));
        assert_int_equal(change(world, kind, id[1], 1.25f, NULL), SKV_OK);
        expect_places(world, kind, 2, (const float[]){1.25f, 0.3f + 0.6f});
        /* A name that is gone, none, or one of another kind. */
        const skv_acting_id wrong[] = {id[0], 0, id[2] ^ 1, id[2] + 4, UINT32_MAX};
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
            assert_int_equal(change(world, kind, wrong[w], 1, &error), SKV_ERROR_VALUE);
            assert_non_null(strstr(error.text, "there is none named"));
        }
        assert_false(skv_world_remove_acting(world, 0));
        /* What may not act changes nothing; a name that is gone is not given again. */
        assert_int_equal(change(world, kind, id[2], NAN, &error), SKV_ERROR_VALUE);
        other = 1;
        assert_int_equal(add(world, kind, INFINITY, &other, &error), SKV_ERROR_VALUE);
        assert_int_equal(other, 0);
        expect_places(world, kind, 2, (const float[]){1.25f, 0.3f + 0.6f});
        assert_int_equal(add(world, kind, 0.75f, &id[3], NULL), SKV_OK);
        assert_true(id[3] > id[2]);
        while (places_of(world, kind, (float[16]){0}) < most[kind])
            assert_int_equal(add(world, kind, 0.5f, NULL, NULL), SKV_OK);
        assert_int_equal(add(world, kind, 0.5f, &other, &error), SKV_ERROR_LIMIT);
        assert_int_equal(other, 0);
    }
    skv_world_destroy(world);
}

/* What is in the same place keeps its name when all of a kind are set at once. */
static void a_whole_list_keeps_names_by_place(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.03f, 1);
    const skv_force forces[] = {force_at(0.2f), force_at(0.5f), force_at(0.9f)};
    assert_int_equal(skv_world_set_forces(world, forces, 2, NULL), SKV_OK);
    skv_acting_id first = skv_world_acting_id(world, SKV_ACTING_FORCE, 0);
    skv_acting_id second = skv_world_acting_id(world, SKV_ACTING_FORCE, 1);
    assert_int_equal(skv_world_set_forces(world, forces + 1, 2, NULL), SKV_OK);
    assert_int_equal(skv_world_acting_id(world, SKV_ACTING_FORCE, 0), first);
    assert_int_equal(skv_world_acting_id(world, SKV_ACTING_FORCE, 1), second);
    assert_int_equal(skv_world_set_forces(world, forces, 1, NULL), SKV_OK);
    assert_int_equal(skv_world_acting_index(world, second, NULL), -1);
    assert_int_equal(skv_world_set_forces(world, forces, 3, NULL), SKV_OK);
    assert_true(skv_world_acting_id(world, SKV_ACTING_FORCE, 1) > second);
    skv_world_destroy(world);
}

/* Three of each kind in a pool: set at once, or added one by one with one more that goes again. Its
 * substeps are given: by the rule there would be more for what is there for a moment. */
static skv_world *busy_pool(bool one_by_one)
{
    skv_world_def def = fixture_def(SKV_LAW_CALIBRATED, SKV_SOLVER_FAST, 0, 0.03f, 1);
    def.substeps = 8;
    skv_world *world;
    assert_int_equal(skv_world_create(&def, &world, NULL), SKV_OK);
    fixture_fill(world, 0, 0, 1.6f, 0.3f);
    skv_hand hands[3];
    skv_force forces[3];
    skv_emitter emitters[3];
    skv_drain drains[3];
    for (int i = 0; i < 3; i++) {
        float x = 0.3f + 0.4f * (float)i;
        hands[i] = hand_at(x), forces[i] = force_at(x);
        emitters[i] = emitter_at(x), drains[i] = drain_at(x);
    }
    if (!one_by_one) {
        assert_int_equal(skv_world_set_hands(world, hands, 3, NULL), SKV_OK);
        assert_int_equal(skv_world_set_forces(world, forces, 3, NULL), SKV_OK);
        assert_int_equal(skv_world_set_emitters(world, emitters, 3, NULL), SKV_OK);
        assert_int_equal(skv_world_set_drains(world, drains, 3, NULL), SKV_OK);
        return world;
    }
    for (int kind = 0; kind < KINDS; kind++) {
        skv_acting_id extra, moved;
        assert_int_equal(add(world, kind, 1.5f, &extra, NULL), SKV_OK);
        assert_int_equal(add(world, kind, 0.3f, NULL, NULL), SKV_OK);
        assert_int_equal(add(world, kind, 0.1f, &moved, NULL), SKV_OK);
        assert_int_equal(add(world, kind, 0.3f + 0.4f * 2, NULL, NULL), SKV_OK);
        assert_int_equal(change(world, kind, moved, 0.3f + 0.4f, NULL), SKV_OK);
        assert_true(skv_world_remove_acting(world, extra));
    }
    return world;
}

static void one_by_one_is_as_all_at_once(void **unused)
{
    (void)unused;
    skv_world *all = busy_pool(false), *single = busy_pool(true);
    fixture_run(all, 40);
    fixture_run(single, 40);
    assert_true(skv_world_flow(all).emitted > 20 && skv_world_flow(all).drained > 5);
    assert_true(skv_world_hash(all) == skv_world_hash(single));
    skv_world_destroy(all);
    skv_world_destroy(single);
}

/* The others' streams go on where they were: as if the one that goes had closed instead. */
static void what_stays_goes_on_without_a_gap(void **unused)
{
    (void)unused;
    uint64_t hash[2];
    for (int closes = 0; closes < 2; closes++) {
        skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.03f, 1);
        skv_acting_id tap[2], drain[2];
        for (int i = 0; i < 2; i++) {
            assert_int_equal(add(world, SKV_ACTING_EMITTER, 0.4f + 0.6f * (float)i, &tap[i], NULL),
                             SKV_OK);
            assert_int_equal(add(world, SKV_ACTING_DRAIN, 0.2f + 0.8f * (float)i, &drain[i], NULL),
                             SKV_OK);
            fixture_run(world, 7); /* out of step with each other */
        }
        fixture_run(world, 33); /* in the middle of a row */
        int count;
        skv_emitter closed = *skv_world_emitters(world, &count);
        closed.vy = 0;
        const skv_drain dry = {.area = skv_circle(0.2f, 0.85f, 0.001f), .rate = 0.05f};
        if (closes) {
            assert_int_equal(skv_world_change_emitter(world, tap[0], &closed, NULL), SKV_OK);
            assert_int_equal(skv_world_change_drain(world, drain[0], &dry, NULL), SKV_OK);
        } else {
            assert_true(skv_world_remove_acting(world, tap[0]));
            double may = world->acting.drainable[1];
            assert_true(skv_world_remove_acting(world, drain[0]));
            assert_true(may != 0 && world->acting.drainable[0] == may);
        }
        int64_t before = skv_world_flow(world).emitted;
        int found = 0;
        for (int frame = 0; frame < 40; frame++) {
            fixture_run(world, 1);
            const skv_event *events = skv_world_events(world, &count);
            for (int e = 0; e < count; e++) {
                assert_true(events[e].kind != SKV_EVENT_EMITTED || events[e].source == tap[1]);
                found += events[e].kind == SKV_EVENT_EMITTED;
            }
        }
        assert_true(found > 10 && skv_world_flow(world).emitted == before + found);
        assert_true(skv_world_flow(world).drained > 5);
        hash[closes] = skv_world_hash(world);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
}

/* In the middle of a row an emitter is given what it has, and another place. */
static void an_emitter_begins_anew_only_where_it_changes(void **unused)
{
    (void)unused;
    int64_t emitted[3];
    uint64_t hash[3];
    for (int way = 0; way < 3; way++) {
        skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.03f, 1);
        skv_acting_id tap;
        assert_int_equal(add(world, SKV_ACTING_EMITTER, 0.8f, &tap, NULL), SKV_OK);
        for (int frame = 0; frame < 60; frame++) {
            fixture_run(world, 1);
            if (way > 0)
                assert_int_equal(change(world, SKV_ACTING_EMITTER, tap,
                                        way == 2 && frame % 2 ? 0.81f : 0.8f, NULL),
                                 SKV_OK);
        }
        emitted[way] = skv_world_flow(world).emitted;
        hash[way] = skv_world_hash(world);
        skv_world_destroy(world);
    }
    assert_true(hash[0] == hash[1]);
    assert_true(emitted[0] > 50 && emitted[2] < emitted[0] / 2);
}

static void names_go_with_snapshots(void **unused)
{
    (void)unused;
    skv_world *world = busy_pool(true), *copy;
    skv_acting_id id[KINDS][3];
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < 3; i++)
            id[kind][i] = skv_world_acting_id(world, (skv_acting_kind)kind, i);
    size_t size = skv_world_snapshot_size(world, false);
    uint8_t *bytes = malloc(size);
    assert_int_equal(skv_world_save(world, false, bytes, size, NULL), SKV_OK);
    assert_int_equal(skv_world_copy(world, fixture_host(1), &copy, NULL), SKV_OK);
    for (int kind = 0; kind < KINDS; kind++)
        assert_true(skv_world_remove_acting(world, id[kind][1]));
    assert_int_equal(skv_world_restore(world, bytes, size, NULL), SKV_OK);
    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < 3; i++) {
            assert_int_equal(skv_world_acting_index(world, id[kind][i], NULL), i);
            assert_int_equal(skv_world_acting_index(copy, id[kind][i], NULL), i);
        }
    }
    /* Names given later are the same in both, and new. */
    for (int kind = 0; kind < KINDS; kind++) {
        skv_acting_id mine, theirs;
        assert_int_equal(add(world, kind, 1.2f, &mine, NULL), SKV_OK);
        assert_int_equal(add(copy, kind, 1.2f, &theirs, NULL), SKV_OK);
        assert_true(mine == theirs && mine > id[kind][2]);
    }
    free(bytes);
    skv_world_destroy(copy);
    skv_world_destroy(world);
}

/* One from before there were names: without flag 16, and without the names, which lie before the
 * particles of 38 bytes each. Those that it holds are named anew, in their order. */
static void an_older_snapshot_is_named_anew(void **unused)
{
    (void)unused;
    enum { NAMES = 4 + 4 * 3 * KINDS, FLAGS_AT = 12, WITH_NAMES = 16 };
    skv_world *world = busy_pool(true), *twin = busy_pool(true);
    size_t size = skv_world_snapshot_size(world, false);
    size_t particles = 8 + 38 * (size_t)skv_world_particle_count(world);
    uint8_t *bytes = malloc(size);
    assert_int_equal(skv_world_save(world, false, bytes, size, NULL), SKV_OK);
    assert_true(bytes[FLAGS_AT] & WITH_NAMES);
    bytes[FLAGS_AT] &= (uint8_t)~WITH_NAMES;
    memmove(bytes + size - particles - NAMES, bytes + size - particles, particles);
    skv_envelope_seal(bytes, size - NAMES);
    assert_int_equal(skv_world_restore(world, bytes, size - NAMES, NULL), SKV_OK);
    for (int kind = 0; kind < KINDS; kind++) {
        expect_places(world, kind, 3, (const float[]){0.3f, 0.3f + 0.4f, 0.3f + 0.4f * 2});
        for (int i = 0; i < 3; i++)
            assert_true(skv_world_acting_id(world, (skv_acting_kind)kind, i) != 0);
        assert_true(
            skv_world_remove_acting(world, skv_world_acting_id(world, (skv_acting_kind)kind, 1)));
        assert_true(
            skv_world_remove_acting(twin, skv_world_acting_id(twin, (skv_acting_kind)kind, 1)));
    }
    fixture_run(world, 10);
    fixture_run(twin, 10);
    assert_true(skv_world_hash(world) == skv_world_hash(twin));
    /* Names that no world gives: of another kind, not ascending, beyond the last one given. */
    size = skv_world_snapshot_size(twin, false);
    free(bytes);
    bytes = malloc(size);
    assert_int_equal(skv_world_save(twin, false, bytes, size, NULL), SKV_OK);
    particles = 8 + 38 * (size_t)skv_world_particle_count(twin);
    size_t first = size - particles - 4 * 2 * KINDS; /* two of each kind are left */
    const uint8_t kept[8] = {bytes[first], bytes[first + 1], bytes[first + 2], bytes[first + 3],
                             bytes[first + 4]};
    const uint8_t wrong[] = {(uint8_t)(kept[0] ^ 1), (uint8_t)(kept[4] + 4), 0};
    for (size_t w = 0; w < sizeof wrong; w++) {
        bytes[first] = wrong[w];
        skv_envelope_seal(bytes, size);
        skv_error error;
        assert_int_equal(skv_world_restore(twin, bytes, size, &error), SKV_ERROR_VALUE);
        assert_non_null(strstr(error.text, "names"));
    }
    bytes[first] = kept[0];
    skv_envelope_seal(bytes, size);
    assert_int_equal(skv_world_restore(twin, bytes, size, NULL), SKV_OK);
    free(bytes);
    skv_world_destroy(world);
    skv_world_destroy(twin);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_hold_while_others_come_and_go),
        cmocka_unit_test(a_whole_list_keeps_names_by_place),
        cmocka_unit_test(one_by_one_is_as_all_at_once),
        cmocka_unit_test(what_stays_goes_on_without_a_gap),
        cmocka_unit_test(an_emitter_begins_anew_only_where_it_changes),
        cmocka_unit_test(names_go_with_snapshots),
        cmocka_unit_test(an_older_snapshot_is_named_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
