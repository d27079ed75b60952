/* Session: the open scene, its world, and what a person does to it. Invariant: scene and world are
 * either both null or both there and belong together; a failed open or reset changes neither. All
 * worlds share one pool, since a new one is made while the old one is still there. */
#include "skvalp/session.h"

#include <math.h>

#include "base/assert.h"
#include "base/memory.h"
#include "session/pointers.h"

#define FRAME_RATE           60.0
#define MOST_FRAMES_A_CALL   4
#define EARTH_GRAVITY        9.81
#define STRONGEST_GRAVITY    1000.0
#define FASTEST_HAND         10.0 /* m/s; faster, the fluid would only tear off */
#define WIDEST_GRIP          100.0
#define DEFAULT_WORLD_WIDTH  1.6
#define DEFAULT_WORLD_HEIGHT 0.9

struct skv_session {
    skv_scene *scene;
    skv_world *world;
    skv_pool *pool;

    bool paused;
    double speed;
    double frames_due; /* a fraction of a frame between calls */

    double direction_x, direction_y; /* of gravity, in units of `strength` */
    double strength;                 /* m/s^2, the scene's own */

    int view_width, view_height;
    skv_pointers pointers;
    double grip; /* m; 0: by the world's size */
};

skv_result skv_session_create(int threads, skv_session **session, skv_error *error)
{
    SKV_ASSERT_OR(session, SKV_ERROR_VALUE);
    *session = NULL;
    skv_session *made = skv_calloc(1, sizeof *made);
    if (!made)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a session");
    skv_result result = skv_pool_create(threads, &made->pool, error);
    if (result != SKV_OK) {
        skv_free(made);
        return result;
    }
    made->speed = 1;
    made->direction_y = -1;
    made->strength = EARTH_GRAVITY;
    made->view_width = 1280;
    made->view_height = 720;
    *session = made;
    return SKV_OK;
}

void skv_session_destroy(skv_session *session)
{
    if (!session)
        return;
    skv_world_destroy(session->world);
    skv_scene_destroy(session->scene);
    skv_pool_destroy(session->pool);
    skv_free(session);
}

/* The world at the scene's start. */
static skv_result make_world(const skv_session *session, const skv_scene *scene, skv_world **world,
                             skv_error *error)
{
    skv_world_def def = skv_scene_world_def(scene);
    def.pool = session->pool;
    skv_result result = skv_world_create(&def, world, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(def.terrain);
        return result;
    }
    result = skv_scene_fill(scene, *world, error);
    if (result != SKV_OK)
        skv_world_destroy(*world);
    return result;
}

/* Puts a fresh world in place of the old one, with the scene's own gravity. */
static void take_world(skv_session *session, skv_world *world)
{
    skv_world_destroy(session->world);
    session->world = world;
    session->frames_due = 0;

    float x, y;
    skv_world_gravity(world, &x, &y);
    double strength = sqrt((double)x * x + (double)y * y);
    session->direction_x = strength > 0 ? x / strength : 0;
    session->direction_y = strength > 0 ? y / strength : 0;
    /* In a weightless scene the arrow keys still do what they say. */
    session->strength = strength > 0 ? strength : EARTH_GRAVITY;
}

skv_result skv_session_open_scene(skv_session *session, skv_scene *scene, skv_error *error)
{
    SKV_ASSERT_OR(session && scene, SKV_ERROR_VALUE);
    skv_world *world = NULL;
    skv_result result = make_world(session, scene, &world, error);
    if (result != SKV_OK)
        return result;
    skv_scene *old = session->scene;
    session->scene = scene;
    take_world(session, world);
    if (old != scene)
        skv_scene_destroy(old);
    skv_session_pointer_cancel_all(session);
    return SKV_OK;
}

skv_result skv_session_open(skv_session *session, const char *name_or_path,
                            const skv_scene_options *options, skv_error *error)
{
    SKV_ASSERT_OR(session && name_or_path, SKV_ERROR_VALUE);
    skv_scene *scene = NULL;
    skv_result result = skv_scene_load(name_or_path, options, &scene, error);
    if (result != SKV_OK)
        return result;
    result = skv_session_open_scene(session, scene, error);
    if (result != SKV_OK)
        skv_scene_destroy(scene);
    return result;
}

const skv_world *skv_session_world(const skv_session *session)
{
    SKV_ASSERT_OR(session, NULL);
    return session->world;
}

const skv_scene *skv_session_scene(const skv_session *session)
{
    SKV_ASSERT_OR(session, NULL);
    return session->scene;
}

skv_result skv_session_reset(skv_session *session, skv_error *error)
{
    SKV_ASSERT_OR(session, SKV_ERROR_VALUE);
    if (!session->scene)
        return skv_fail(error, SKV_ERROR_VALUE, "no scene is open: open one before a reset");
    skv_world *world = NULL;
    skv_result result = make_world(session, session->scene, &world, error);
    if (result != SKV_OK)
        return result;
    take_world(session, world);
    return SKV_OK;
}

/* Playback. */

static skv_result step_frame(skv_session *session, skv_error *error)
{
    skv_hand hands[SKV_MAX_HANDS];
    int count = skv_session_hands(session, hands, SKV_MAX_HANDS);
    skv_result result = skv_world_set_hands(session->world, hands, count, error);
    return result != SKV_OK ? result
                            : skv_world_step(session->world, (float)(1 / FRAME_RATE), error);
}

/* Frames that real time asks for. Displays near 60 Hz count as exactly 60, so that each refresh
 * shows one new frame instead of now and then none or two. */
static double frames_of(double seconds)
{
    double frames = seconds * FRAME_RATE;
    double whole = floor(frames + 0.5);
    return whole >= 1 && fabs(frames - whole) < 0.02 * whole ? whole : frames;
}

/* Whole frames that are due after so much real time. */
static int take_due_frames(skv_session *session, double seconds)
{
    /* The tiny share added makes ten times a tenth of a frame one frame. */
    session->frames_due += frames_of(seconds) * session->speed;
    double whole = floor(session->frames_due + 1e-9);
    if (whole > MOST_FRAMES_A_CALL) {
        whole = MOST_FRAMES_A_CALL;
        session->frames_due = whole;
    }
    session->frames_due = fmax(session->frames_due - whole, 0);
    return (int)whole;
}

skv_result skv_session_advance(skv_session *session, double seconds, int *frames, skv_error *error)
{
    SKV_ASSERT_OR(session, SKV_ERROR_VALUE);
    int stepped = 0;
    skv_result result = SKV_OK;
    if (seconds > 0 && isfinite(seconds)) {
        skv_pointers_pass(&session->pointers, seconds);
        bool playing = session->world && !session->paused;
        int due = playing ? take_due_frames(session, seconds) : 0;
        while (stepped < due && result == SKV_OK) {
            result = step_frame(session, error);
            stepped += result == SKV_OK;
        }
    }
    if (result != SKV_OK) {
        session->paused = true;
        session->frames_due = 0;
    }
    if (frames)
        *frames = stepped;
    return result;
}

void skv_session_set_paused(skv_session *session, bool paused)
{
    SKV_ASSERT(session);
    session->paused = paused;
}

bool skv_session_paused(const skv_session *session)
{
    SKV_ASSERT_OR(session, false);
    return session->paused;
}

skv_result skv_session_step_once(skv_session *session, skv_error *error)
{
    SKV_ASSERT_OR(session, SKV_ERROR_VALUE);
    return session->world ? step_frame(session, error) : SKV_OK;
}

void skv_session_set_speed(skv_session *session, double speed)
{
    SKV_ASSERT(session && isfinite(speed));
    session->speed = fmin(fmax(speed, 0.05), 2);
}

double skv_session_speed(const skv_session *session)
{
    SKV_ASSERT_OR(session, 1);
    return session->speed;
}

/* Gravity. */

static float gravity_component(double value)
{
    return (float)fmin(fmax(value, -STRONGEST_GRAVITY), STRONGEST_GRAVITY);
}

void skv_session_set_gravity_direction(skv_session *session, double x, double y)
{
    SKV_ASSERT(session && isfinite(x) && isfinite(y));
    session->direction_x = x;
    session->direction_y = y;
    if (session->world)
        skv_world_set_gravity(session->world, gravity_component(x * session->strength),
                              gravity_component(y * session->strength), NULL);
}

void skv_session_gravity_direction(const skv_session *session, double *x, double *y)
{
    SKV_ASSERT(session && x && y);
    *x = session->direction_x;
    *y = session->direction_y;
}

/* View and pointers. */

static void world_size(const skv_session *session, double *width, double *height)
{
    *width = DEFAULT_WORLD_WIDTH;
    *height = DEFAULT_WORLD_HEIGHT;
    if (session->world) {
        const skv_terrain *terrain = skv_world_terrain(session->world);
        *width = skv_terrain_width(terrain);
        *height = skv_terrain_height(terrain);
    }
}

void skv_session_set_view(skv_session *session, int width, int height)
{
    SKV_ASSERT(session);
    session->view_width = width;
    session->view_height = height;
}

skv_camera skv_session_camera(const skv_session *session)
{
    SKV_ASSERT_OR(session, (skv_camera){.scale = 1, .width = 1, .height = 1});
    double width, height;
    world_size(session, &width, &height);
    return skv_camera_fit(session->view_width, session->view_height, width, height);
}

void skv_session_pointer_down(skv_session *session, uint64_t pointer, double px, double py,
                              double time)
{
    SKV_ASSERT(session);
    skv_pointers_down(&session->pointers, pointer, px, py, time);
}

void skv_session_pointer_move(skv_session *session, uint64_t pointer, double px, double py,
                              double time)
{
    SKV_ASSERT(session);
    skv_pointers_move(&session->pointers, pointer, px, py, time);
}

void skv_session_pointer_up(skv_session *session, uint64_t pointer)
{
    SKV_ASSERT(session);
    skv_pointers_up(&session->pointers, pointer);
}

void skv_session_pointer_cancel_all(skv_session *session)
{
    SKV_ASSERT(session);
    session->pointers.count = 0;
}

int skv_session_pointer_count(const skv_session *session)
{
    SKV_ASSERT_OR(session, 0);
    return session->pointers.count;
}

void skv_session_set_grip(skv_session *session, double radius)
{
    SKV_ASSERT(session && radius >= 0 && radius <= WIDEST_GRIP);
    session->grip = radius;
}

double skv_session_grip(const skv_session *session)
{
    SKV_ASSERT_OR(session, 0);
    double width, height;
    world_size(session, &width, &height);
    return session->grip > 0 ? session->grip : 0.1 * fmax(width, height);
}

/* A pointer's velocity in metres per simulated second: in slow motion the fluid sees a hand that
 * is faster than the real one. Cut to FASTEST_HAND without changing its direction. */
static void hand_velocity(const skv_session *session, const skv_pointer *pointer, double scale,
                          skv_hand *hand)
{
    double factor = 1 / (scale * session->speed);
    double x = pointer->vx * factor, y = -pointer->vy * factor;
    double length = sqrt(x * x + y * y);
    double cut = length > FASTEST_HAND ? FASTEST_HAND / length : 1;
    hand->vx = (float)(x * cut);
    hand->vy = (float)(y * cut);
}

int skv_session_hands(const skv_session *session, skv_hand *hands, int capacity)
{
    SKV_ASSERT_OR(session && (hands || capacity <= 0), 0);
    skv_camera camera = skv_session_camera(session);
    int count = session->pointers.count;
    for (int i = 0; i < count && i < capacity; i++) {
        const skv_pointer *pointer = &session->pointers.list[i];
        double x, y;
        skv_camera_to_world(&camera, pointer->px, pointer->py, &x, &y);
        hands[i] = skv_default_hand();
        hands[i].x = (float)x;
        hands[i].y = (float)y;
        hands[i].radius = (float)skv_session_grip(session);
        hand_velocity(session, pointer, camera.scale, &hands[i]);
    }
    return count;
}
