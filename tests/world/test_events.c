/* Events: of what happens while nothing steps so many are kept, and the others are counted. */
#include "support/fixture.h"
#include "world/world_internal.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void events_between_steps_are_bounded(void **unused)
{
    (void)unused;
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, 0.02f, 1);
    skv_area all = skv_box(0, 0, 2, 1);
    int removed, count;
    /* As if this had gone on for long: the list is full but for ten. */
    fixture_fill(world, 0, 0, 0.4f, 0.4f);
    assert_int_equal(skv_world_remove_area(world, &all, &removed, NULL), SKV_OK);
    assert_int_equal(skv_events_reserve(&world->events, SKV_MAX_EVENTS, NULL), SKV_OK);
    assert_int_equal(world->events.capacity, SKV_MAX_EVENTS);
    world->events.count = SKV_MAX_EVENTS - 10;
    const skv_event *list = skv_world_events(world, &count);
    fixture_fill(world, 0, 0, 0.4f, 0.4f);
    assert_int_equal(skv_world_dropped_events(world), 0);
    assert_int_equal(skv_world_remove_area(world, &all, &removed, NULL), SKV_OK);
    assert_true(removed > 100);
    assert_ptr_equal(skv_world_events(world, &count), list);
    assert_int_equal(count, SKV_MAX_EVENTS);
    assert_int_equal(skv_world_dropped_events(world), removed - 10);
    assert_int_equal(list[count - 1].kind, SKV_EVENT_REMOVED);
    /* They belong to the step that comes; the one after begins anew. */
    fixture_run(world, 1);
    assert_int_equal(skv_world_dropped_events(world), removed - 10);
    fixture_run(world, 1);
    skv_world_events(world, &count);
    assert_int_equal(count, 0);
    assert_int_equal(skv_world_dropped_events(world), 0);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(events_between_steps_are_bounded)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
