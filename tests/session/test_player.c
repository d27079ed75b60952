/* The player: a log that gives every moment again, bit by bit: rewinding, undo, redo, replays. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "session/support.h"
#include "support/kept.h"
#include "support/long.h"
#include <skvalp/query.h>
#include <skvalp/snapshot.h>

enum { FRAMES = 200 };

/* What a person does in frame `f`, if anything: hands that come and go, a turning gravity, edits.
 */
static bool command_at(int f, skv_command *command)
{
    memset(command, 0, sizeof *command);
    if (f % 2 == 0 && f >= 20 && f < 80) {
        command->kind = SKV_COMMAND_HANDS;
        command->hands.count = f < 78 ? 1 + (f > 50) : 0;
        for (int i = 0; i < command->hands.count; i++) {
            command->hands.list[i] = skv_default_hand();
            command->hands.list[i].x = 0.2f + 0.01f * (float)(f - 20) + 0.3f * (float)i;
            command->hands.list[i].y = 0.15f;
            command->hands.list[i].vx = 0.6f;
        }
        return true;
    }
    switch (f) {
    case 5:
    case 100:
    case 130:
        command->kind = SKV_COMMAND_MARK;
        return true;
    case 6:
        command->kind = SKV_COMMAND_SET;
        strcpy(command->set.path, "fluid.viscosity");
        strcpy(command->set.text, "0.001");
        return true;
    case 101:
        command->kind = SKV_COMMAND_GRAVITY;
        command->vector.x = 3;
        command->vector.y = -9;
        return true;
    case 115:
        command->kind = SKV_COMMAND_PUSH;
        command->vector.y = 1;
        return true;
    case 121:
        command->kind = SKV_COMMAND_EMIT;
        command->source = (skv_emitter){1.2f, 0.7f, 0, -1, 0.08f, 2, 1};
        return true;
    case 125:
        command->kind = SKV_COMMAND_DYE;
        command->water = (skv_dab){.x0 = 0.2f, .y0 = 0.1f, .x1 = 1.2f, .y1 = 0.7f, .radius = 0.1f};
        command->water.dye = 3;
        return true;
    case 127:
    case 128:
    case 147: /* comes, turns, and goes */
        command->kind = SKV_COMMAND_FORCE;
        command->force = (skv_force_change){f == 127 ? -1 : 0, f == 147, {.drag = 5}};
        command->force.force.area = skv_swept_circle(0.3f, 0.2f, 0.9f, 0.2f, 0.1f);
        command->force.force.wind_x = f == 127 ? 2 : -2;
        return true;
    case 131:
    case 141:
        command->kind = f == 131 ? SKV_COMMAND_POUR : SKV_COMMAND_TAKE;
        command->water.x0 = command->water.x1 = 0.8f;
        command->water.y0 = command->water.y1 = f == 131 ? 0.7f : 0.1f;
        command->water.radius = 0.08f;
        command->water.fluid = f == 131;
        command->water.vx = f == 131 ? 0.5f : 0;
        return true;
    case 151:
    case 153:
    case 171:
        command->kind = SKV_COMMAND_PAINT;
        command->paint.count = f == 153 ? 2 : 1;
        for (int i = 0; i < command->paint.count; i++)
            command->paint.list[i] =
                (skv_brush_stroke){0.4f + 0.3f * (float)i, 0.05f, 0.5f, 0.3f, 0.02f, f == 171};
        return true;
    default:
        return false;
    }
}

static void play(skv_player *player, int from, int to, uint64_t *hashes)
{
    for (int f = from; f < to; f++) {
        skv_command command;
        skv_error error = {0};
        if (command_at(f, &command) && skv_player_apply(player, &command, &error) != SKV_OK)
            fail_msg("frame %d: %s", f, error.text);
        assert_int_equal(skv_player_step(player, &error), SKV_OK);
        if (hashes)
            hashes[f + 1] = skv_world_hash(skv_player_world(player));
    }
}

static void seek(skv_player *player, int64_t frame)
{
    assert_int_equal(skv_player_seek(player, frame, NULL), SKV_OK);
    while (skv_player_seeking(player))
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
}

static void settle(skv_player *player)
{
    while (skv_player_seeking(player))
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
}

static uint64_t hash(const skv_player *player)
{
    return skv_world_hash(skv_player_world(player));
}

static void test_every_moment_comes_back(void **state)
{
    (void)state;
    uint64_t hashes[FRAMES + 1];
    skv_player *player = open_player(0);
    hashes[0] = hash(player);
    play(player, 0, FRAMES, hashes);
    assert_int_equal(skv_player_end(player), FRAMES);
    const int moments[] = {0,  1,  FRAMES, 60,  59,  58,  131, 132, 14,
                           15, 16, 199,    172, 160, 152, 155, 5,   7};
    for (size_t i = 0; i < sizeof moments / sizeof *moments; i++) {
        seek(player, moments[i]);
        assert_int_equal(skv_player_frame(player), moments[i]);
        assert_int_equal(hash(player), hashes[moments[i]]);
    }
    /* Onward from there, along the log. */
    seek(player, 33);
    for (int f = 33; f < FRAMES; f++) {
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        assert_int_equal(hash(player), hashes[f + 1]);
    }
    assert_int_equal(skv_player_mismatch(player), -1);
    skv_player_destroy(player);
}

/* A moment that is picked and played on from cuts the future; redo brings it back. */
static void test_another_future(void **state)
{
    (void)state;
    uint64_t hashes[FRAMES + 1];
    skv_player *player = open_player(0);
    play(player, 0, FRAMES, hashes);
    seek(player, 90);
    assert_false(skv_player_can_redo(player));
    assert_int_equal(skv_player_cut(player, NULL), SKV_OK);
    assert_int_equal(skv_player_end(player), 90);
    assert_true(skv_player_can_redo(player));
    for (int i = 0; i < 40; i++)
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    assert_int_equal(skv_player_end(player), 130);
    assert_int_not_equal(hash(player), hashes[130]);
    assert_int_equal(skv_player_redo(player, NULL), SKV_OK);
    settle(player);
    assert_int_equal(skv_player_frame(player), FRAMES);
    assert_int_equal(hash(player), hashes[FRAMES]);
    assert_false(skv_player_can_redo(player));
    seek(player, 110);
    assert_int_equal(hash(player), hashes[110]);
    /* A command cuts by itself. */
    skv_command push = {.kind = SKV_COMMAND_PUSH};
    push.vector.y = 1;
    assert_int_equal(skv_player_apply(player, &push, NULL), SKV_OK);
    assert_int_equal(skv_player_end(player), 110);
    assert_int_not_equal(hash(player), hashes[110]);
    skv_player_destroy(player);
}

static void test_undo_and_redo(void **state)
{
    (void)state;
    uint64_t hashes[FRAMES + 1];
    skv_player *player = open_player(0);
    play(player, 0, FRAMES, hashes);
    const int marks[] = {130, 100, 5};
    for (int i = 0; i < 3; i++) {
        assert_true(skv_player_can_undo(player));
        assert_int_equal(skv_player_undo(player, NULL), SKV_OK);
        settle(player);
        assert_int_equal(skv_player_frame(player), marks[i]);
        assert_int_equal(skv_player_end(player), marks[i]);
        assert_int_equal(hash(player), hashes[marks[i]]);
    }
    assert_false(skv_player_can_undo(player));
    assert_int_equal(skv_player_undo(player, NULL), SKV_OK); /* nothing happens */
    assert_int_equal(skv_player_frame(player), 5);
    /* Played on in between: the other way is still there. */
    for (int i = 0; i < 20; i++)
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    const int ends[] = {100, 130, FRAMES};
    for (int i = 0; i < 3; i++) {
        assert_true(skv_player_can_redo(player));
        assert_int_equal(skv_player_redo(player, NULL), SKV_OK);
        settle(player);
        assert_int_equal(skv_player_frame(player), ends[i]);
        assert_int_equal(hash(player), hashes[ends[i]]);
    }
    assert_int_equal(skv_player_redo(player, NULL), SKV_OK);
    assert_int_equal(hash(player), hashes[FRAMES]);
    /* A new edit is the end of what was undone. */
    skv_player_undo(player, NULL);
    settle(player);
    assert_true(skv_player_can_redo(player));
    assert_int_equal(skv_player_apply(player, &(skv_command){.kind = SKV_COMMAND_MARK}, NULL),
                     SKV_OK);
    assert_false(skv_player_can_redo(player));
    skv_player_destroy(player);
}

static void test_what_is_refused_is_not_logged(void **state)
{
    (void)state;
    skv_player *player = open_player(0);
    skv_error error = {0};
    skv_command bad = {.kind = SKV_COMMAND_SET};
    strcpy(bad.set.path, "fluid.viscosity");
    strcpy(bad.set.text, "thick");
    assert_int_equal(skv_player_apply(player, &bad, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "fluid.viscosity"));
    bad = (skv_command){.kind = SKV_COMMAND_HANDS};
    bad.hands.count = 1;
    assert_int_equal(skv_player_apply(player, &bad, &error), SKV_ERROR_VALUE);
    play(player, 0, 20, NULL);
    uint64_t there = hash(player);
    seek(player, 0);
    seek(player, 20);
    assert_int_equal(hash(player), there);
    skv_player_destroy(player);
}

/* With little memory the past gets coarse, and the start stays. */
static void test_history_keeps_its_limit(void **state)
{
    (void)state;
    enum { LIMIT = 100000 };
    uint64_t hashes[FRAMES + 1];
    skv_player *player = open_player(LIMIT);
    hashes[0] = hash(player);
    for (int f = 0; f < FRAMES; f++) {
        play(player, f, f + 1, hashes);
        assert_true(skv_player_history(player) <= LIMIT);
    }
    assert_true(skv_player_history(player) > LIMIT / 2);
    const int moments[] = {0, 150, 60, 199, 1};
    for (size_t i = 0; i < sizeof moments / sizeof *moments; i++) {
        seek(player, moments[i]);
        assert_int_equal(hash(player), hashes[moments[i]]);
        assert_true(skv_player_history(player) <= LIMIT);
    }
    skv_player_destroy(player);
}

/* ---- Replays --------------------------------------------------------------------------------- */

static bool refuse(const char *bytes, size_t size, void *user)
{
    (void)bytes, (void)size, (void)user;
    return false;
}

static kept save(const skv_player *player)
{
    kept saved = {0};
    assert_int_equal(skv_player_save(player, kept_add, &saved, NULL), SKV_OK);
    return saved;
}

/* It begins where the other one was, with its scene, and without what led there. */
static void test_a_moment_is_kept(void **state)
{
    (void)state;
    uint64_t hashes[FRAMES + 1];
    kept saved = {0};
    skv_player *player = open_player(0);
    play(player, 0, FRAMES, hashes);
    seek(player, FRAMES / 2);
    assert_int_equal(skv_player_save_moment(player, refuse, NULL, NULL), SKV_ERROR_FILE);
    assert_int_equal(skv_player_save_moment(player, kept_add, &saved, NULL), SKV_OK);
    skv_player_destroy(player);
    assert_int_equal(skv_player_load(saved.bytes, saved.size, NULL, &player, NULL), SKV_OK);
    assert_string_equal(skv_scene_name(skv_player_scene(player)), "pool");
    assert_true(skv_player_frame(player) == 0 && skv_player_end(player) == 0);
    assert_int_equal(hash(player), hashes[FRAMES / 2]);
    kept_clear(&saved);
    skv_player_destroy(player);
}

static void test_a_replay_goes_the_same_way(void **state)
{
    (void)state;
    uint64_t hashes[FRAMES + 1];
    skv_player *player = open_player(0);
    play(player, 0, FRAMES, hashes);
    assert_int_equal(skv_player_save(player, refuse, NULL, NULL), SKV_ERROR_FILE);
    kept saved = save(player);
    skv_player_destroy(player);
    assert_int_equal(skv_player_load(saved.bytes, saved.size, NULL, &player, NULL), SKV_OK);
    assert_string_equal(skv_scene_name(skv_player_scene(player)), "pool");
    assert_int_equal(skv_player_frame(player), 0);
    assert_int_equal(skv_player_end(player), FRAMES);
    assert_true(skv_player_can_undo(player) == false); /* nothing was done before the start */
    for (int f = 0; f < FRAMES; f++) {
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        assert_int_equal(hash(player), hashes[f + 1]);
    }
    assert_int_equal(skv_player_mismatch(player), -1);
    /* The same file again, from the replay. */
    kept again = save(player);
    assert_true(again.size >= saved.size);
    /* Whoever takes over goes on. */
    assert_true(skv_player_can_undo(player));
    assert_int_equal(skv_player_undo(player, NULL), SKV_OK);
    settle(player);
    assert_int_equal(hash(player), hashes[130]);
    skv_player_destroy(player);
    kept_clear(&again);
    kept_clear(&saved);
}

static kept share(const skv_player *player)
{
    kept shared = {0};
    skv_error error = {0};
    if (skv_player_share(player, kept_add, &shared, &error) != SKV_OK)
        fail_msg("%s", error.text);
    return shared;
}

/* The start made from its scene, and the log packed: another process gets there, too. */
static void test_what_is_shared_goes_the_same_way(void **state)
{
    (void)state;
    uint64_t hashes[FRAMES + 1];
    skv_player *player, *other;
    player = open_player(0);
    play(player, 0, FRAMES, hashes);
    kept saved = save(player), shared = share(player);
    assert_true(shared.size < 2000 && saved.size > 10000);
    seek(player, 120);
    kept past = share(player);
    skv_player_destroy(player);
    assert_int_equal(skv_player_load(past.bytes, past.size, NULL, &other, NULL), SKV_OK);
    assert_int_equal(skv_player_end(other), 120);
    skv_player_destroy(other);
    kept_clear(&past);
    /* Saved and shared again, from either. */
    const kept *from[] = {&saved, &shared};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(skv_player_load(from[i]->bytes, from[i]->size, NULL, &other, NULL),
                         SKV_OK);
        for (int f = 0; f < FRAMES; f++) {
            assert_int_equal(hash(other), f == 0 ? hash(other) : hashes[f]);
            assert_int_equal(skv_player_step(other, NULL), SKV_OK);
        }
        assert_int_equal(hash(other), hashes[FRAMES]);
        seek(other, FRAMES); /* the last check stands after the last frame */
        assert_int_equal(skv_player_mismatch(other), -1);
        kept again = share(other);
        assert_int_equal(again.size, shared.size);
        assert_memory_equal(again.bytes, shared.bytes, shared.size);
        kept_clear(&again);
        skv_player_destroy(other);
    }
    kept_clear(&saved);
    kept_clear(&shared);
}

/* A log that is packed holds any float bit for bit, near or far, round or not. */
static void test_packing_loses_nothing(void **state)
{
    (void)state;
    static const float odd[] = {0.1f, -0.0f, 1e-40f, 999.9f, -77.7f, 0.0001220703125f, 5, 0.1f};
    skv_player *player = open_player(0), *other;
    for (int i = 0; i < 8; i++) {
        skv_command command = {.kind = SKV_COMMAND_TAKE};
        command.water =
            (skv_dab){odd[i], odd[(i + 1) % 8], odd[(i + 2) % 8], 0.25f, 0.01f, 0, 0, 0, 0};
        assert_int_equal(skv_player_apply(player, &command, NULL), SKV_OK);
        command = (skv_command){.kind = SKV_COMMAND_EMIT};
        command.source = (skv_emitter){.x = 0.1f, .y = 0.25f, .vx = odd[i] * 1e-30f, .width = 0.1f};
        assert_int_equal(skv_player_apply(player, &command, NULL), SKV_OK);
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    }
    kept saved = save(player);
    assert_int_equal(skv_player_load(saved.bytes, saved.size, NULL, &other, NULL), SKV_OK);
    kept again = save(other);
    assert_int_equal(again.size, saved.size);
    assert_memory_equal(again.bytes, saved.bytes, saved.size);
    while (skv_player_frame(other) < skv_player_end(other))
        assert_int_equal(skv_player_step(other, NULL), SKV_OK);
    assert_int_equal(hash(other), hash(player));
    skv_player_destroy(player);
    skv_player_destroy(other);
    kept_clear(&saved);
    kept_clear(&again);
}

static void test_a_state_is_a_replay_of_nothing(void **state)
{
    (void)state;
    skv_player *player = open_player(0);
    play(player, 0, 30, NULL);
    const skv_world *world = skv_player_world(player);
    size_t size = skv_world_snapshot_size(world, true);
    char *bytes = malloc(size);
    assert_int_equal(skv_world_save(world, true, bytes, size, NULL), SKV_OK);
    uint64_t there = hash(player);
    skv_player_destroy(player);
    skv_pool *pool;
    skv_player_def def = skv_default_player_def();
    assert_int_equal(skv_pool_create(2, &pool, NULL), SKV_OK);
    def.pool = pool;
    assert_int_equal(skv_player_load(bytes, size, &def, &player, NULL), SKV_OK);
    assert_int_equal(hash(player), there);
    assert_int_equal(skv_player_end(player), 0);
    skv_error error = {0};
    assert_int_equal(skv_player_share(player, kept_add, NULL, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "save it as a file"));
    assert_int_equal(skv_world_threads(skv_player_world(player)), 2);
    assert_int_equal(skv_player_step(player, NULL), SKV_OK);
    skv_player_destroy(player);
    skv_pool_destroy(pool);
    free(bytes);
}

static void expect_refused(const char *bytes, size_t size, const char *why)
{
    skv_player *player;
    skv_error error = {0};
    assert_int_not_equal(skv_player_load(bytes, size, NULL, &player, &error), SKV_OK);
    assert_null(player);
    if (!strstr(error.text, why))
        fail_msg("\"%s\" does not say \"%s\"", error.text, why);
}

static void test_hostile_replays_are_refused(void **state)
{
    (void)state;
    skv_player *player = open_player(0);
    play(player, 0, 90, NULL);
    kept saved = save(player);
    skv_player_destroy(player);
    expect_refused("nonsense", 8, "not one");
    expect_refused(saved.bytes, 20, "cut short");
    expect_refused(saved.bytes, saved.size - 1, "cut short");
    for (size_t at = 8; at < saved.size; at += 1 + saved.size / 50) {
        saved.bytes[at] = (char)(saved.bytes[at] ^ 4);
        expect_refused(saved.bytes, saved.size, "replay: ");
        saved.bytes[at] = (char)(saved.bytes[at] ^ 4);
    }
    kept_clear(&saved);
}

/* Sleep and viscosity have memories of their own, and a tank at rest is most of all at rest. */
static void test_sleepers_come_back(void **state)
{
    (void)state;
    enum { LONG = 900 };
    static uint64_t hashes[LONG + 1];
    skv_player *player = open_player(0);
    const skv_world *world = skv_player_world(player);
    skv_command thick = {.kind = SKV_COMMAND_SET}, push = {.kind = SKV_COMMAND_PUSH};
    strcpy(thick.set.path, "fluid.viscosity");
    strcpy(thick.set.text, "0.01");
    push.vector.x = 0.1f;
    int least = skv_world_particle_count(world);
    for (int f = 0; f < LONG; f++) {
        if (f == 3)
            assert_int_equal(skv_player_apply(player, &thick, NULL), SKV_OK);
        if (f == 700)
            assert_int_equal(skv_player_apply(player, &push, NULL), SKV_OK);
        assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        hashes[f + 1] = hash(player);
        least = skv_world_awake_count(world) < least ? skv_world_awake_count(world) : least;
    }
    assert_int_equal(least, 0); /* it did sleep */
    const int moments[] = {698, 400, 250, 250 + 7, 100, 701};
    for (size_t i = 0; i < sizeof moments / sizeof *moments; i++) {
        seek(player, moments[i]);
        for (int f = moments[i]; f < LONG && f < moments[i] + 40; f++) {
            assert_int_equal(hash(player), hashes[f]);
            assert_int_equal(skv_player_step(player, NULL), SKV_OK);
        }
    }
    skv_player_destroy(player);
}

/* Half a minute of 10 000 particles in 64 MiB, close enough together to go back at once. */
static void test_half_a_minute_fits(void **state)
{
    (void)state;
    skv_scene_options options = skv_default_scene_options();
    options.particles = 10000;
    skv_scene *scene;
    skv_player *player;
    assert_int_equal(skv_scene_load("pool", &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_player_create(scene, NULL, &player, NULL), SKV_OK);
    const skv_world *world = skv_player_world(player);
    size_t key = skv_world_snapshot_size(world, false);
    print_message("%d particles: a key frame of %zu bytes, 30 s of them %.1f MiB\n",
                  skv_world_particle_count(world), key, (double)(120 * key) / (1 << 20));
    assert_true(120 * key <= skv_default_player_def().history);
    skv_player_destroy(player);
}

/* A walk through time at random: seeks, undo, redo, cuts and edits in any order. The log that it
 * ends with gives the world that it ends with. */
static void test_a_random_walk(void **state)
{
    (void)state;
    skv_player *player = open_player(400000);
    uint32_t random = 1;
    skv_error error = {0};
    for (int turn = 0; turn < 1500 / ONE_OF; turn++) {
        random = random * 1664525u + 1013904223u;
        skv_command command;
        skv_result result = SKV_OK;
        int frame = (int)(random >> 16) % FRAMES;
        switch (random >> 8 & 15) {
        case 0:
            result = skv_player_undo(player, &error);
            break;
        case 1:
            result = skv_player_redo(player, &error);
            break;
        case 2:
            result = skv_player_seek(player, frame, &error);
            break;
        case 3:
            result = skv_player_cut(player, &error);
            break;
        case 4:
        case 5:
            if (command_at(frame, &command))
                result = skv_player_apply(player, &command, &error);
            if (result == SKV_ERROR_VALUE && command.kind == SKV_COMMAND_FORCE)
                result = SKV_OK; /* in this order there is none to replace */
            break;
        default:
            result = skv_player_step(player, &error);
            break;
        }
        while (result == SKV_OK && skv_player_seeking(player))
            result = skv_player_step(player, &error);
        if (result != SKV_OK)
            fail_msg("turn %d: %s", turn, error.text);
    }
    seek(player, skv_player_end(player));
    assert_int_equal(skv_player_mismatch(player), -1);
    uint64_t there = hash(player);
    int64_t end = skv_player_end(player);
    kept saved = save(player);
    skv_player_destroy(player);
    assert_int_equal(skv_player_load(saved.bytes, saved.size, NULL, &player, NULL), SKV_OK);
    assert_int_equal(skv_player_end(player), end);
    seek(player, end);
    assert_int_equal(hash(player), there);
    assert_int_equal(skv_player_mismatch(player), -1);
    print_message("a walk that ends at frame %d\n", (int)end);
    skv_player_destroy(player);
    kept_clear(&saved);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_moment_comes_back),
        cmocka_unit_test(test_sleepers_come_back),
        cmocka_unit_test(test_half_a_minute_fits),
        cmocka_unit_test(test_another_future),
        cmocka_unit_test(test_undo_and_redo),
        cmocka_unit_test(test_what_is_refused_is_not_logged),
        cmocka_unit_test(test_history_keeps_its_limit),
        cmocka_unit_test(test_a_moment_is_kept),
        cmocka_unit_test(test_a_replay_goes_the_same_way),
        cmocka_unit_test(test_what_is_shared_goes_the_same_way),
        cmocka_unit_test(test_packing_loses_nothing),
        cmocka_unit_test(test_a_state_is_a_replay_of_nothing),
        cmocka_unit_test(test_hostile_replays_are_refused),
        cmocka_unit_test(test_a_random_walk),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
