/* Sessions for tests. Invariant: after each call here everything asked for has been done. */
#include "support.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support/fixture.h"

static double still(void)
{
    return 0;
}

skv_player *session_open_player(size_t history)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = 300;
    skv_scene *scene;
    skv_player *player;
    skv_player_def def = skv_default_player_def();
    def.threads = 1;
    if (history)
        def.history = history;
    assert_int_equal(skv_scene_load("pool", &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_player_create(scene, &def, &player, NULL), SKV_OK);
    return player;
}

int session_setup(void **state)
{
    *state = session_open_pool(200, false);
    return 0;
}

int session_setup_thread(void **state)
{
    *state = session_open_pool(200, true);
    return 0;
}

int session_teardown(void **state)
{
    skv_session_destroy(*state);
    return 0;
}

skv_session *session_open_pool(int particles, bool own_thread)
{
    skv_session *session = NULL;
    skv_stage_def def = skv_default_stage_def();
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    def.threads = 1;
    def.own_thread = own_thread;
    def.clock = still;
    assert_int_equal(skv_session_create(&def, &session, NULL), SKV_OK);
    skv_session_set_view(session, 1600, 900);
    skv_session_open(session, "pool", &options);
    skv_session_wait(session);
    skv_outcome report;
    assert_int_equal(session_report(session, &report), SKV_OK);
    return session;
}

void session_look(skv_session *session, skv_picture *picture)
{
    const skv_picture *newest = skv_session_acquire(session);
    *picture = *newest;
    skv_session_release(session, newest);
}

int64_t session_moment(skv_session *session)
{
    skv_picture picture;
    session_look(session, &picture);
    return picture.moment;
}

int session_advance(skv_session *session, double seconds)
{
    int64_t before = session_moment(session);
    skv_session_advance(session, seconds, 0);
    skv_session_wait(session);
    return (int)(session_moment(session) - before);
}

uint64_t session_hash(skv_session *session)
{
    const skv_picture *picture = skv_session_acquire(session);
    uint64_t hash = fixture_hash(&picture->frame.particles);
    skv_session_release(session, picture);
    return hash;
}

void session_point(skv_session *session, skv_phase phase, skv_device device, uint64_t pointer,
                   double px, double py, double time)
{
    skv_session_pointer(session, &(skv_pointer_event){.phase = phase,
                                                      .device = device,
                                                      .pointer = pointer,
                                                      .px = px,
                                                      .py = py,
                                                      .time = time});
    skv_session_wait(session);
}

int session_report(skv_session *session, skv_outcome *report)
{
    return skv_session_next_outcome(session, report) ? (int)report->error.code : -1;
}
