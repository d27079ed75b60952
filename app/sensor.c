/* The sensor, read on a thread of its own, for a read may take long. Invariant: it acts only on
 * what plays at its own end: who looks at the past, or at a replay, is not disturbed. */
#include "sensor.h"

#include <math.h>
#include <skvalp/tilt.h>

#include "settings.h"

#define PERIOD    (G_USEC_PER_SEC / 50)
#define STILLNESS 0.02 /* of the scene's gravity: less is the sensor's own noise */
#define STRONGEST 2.0
#define FASTEST   10.0 /* m/s, that a session takes */

struct PlaySensor {
    PlayView *view;
    skv_tilt *tilt; /* the thread's while it runs */
    GThread *thread;
    gint ends, up;
    double strength;
    GMutex lock;
    skv_tilt_reading news; /* the last gravity, and all pushes since the main loop looked */
    bool woken;            /* it will */
};

/* What was felt, on the main loop. */
static gboolean on_news(gpointer data)
{
    PlaySensor *sensor = data;
    g_mutex_lock(&sensor->lock);
    skv_tilt_reading felt = sensor->news;
    sensor->news = (skv_tilt_reading){0};
    sensor->woken = false;
    g_mutex_unlock(&sensor->lock);
    const skv_picture *picture = play_view_picture(sensor->view);
    if (picture->paused || picture->seeking || picture->moment < picture->end)
        return G_SOURCE_REMOVE;
    double x = felt.gravity_x * sensor->strength, y = felt.gravity_y * sensor->strength;
    if (hypot(x - picture->tilt_x, y - picture->tilt_y) > STILLNESS)
        skv_stage_set_gravity(play_view_stage(sensor->view), play_view_side(sensor->view), x, y);
    x = CLAMP(felt.push_x * sensor->strength, -FASTEST, FASTEST);
    y = CLAMP(felt.push_y * sensor->strength, -FASTEST, FASTEST);
    if (x != 0 || y != 0)
        skv_stage_push(play_view_stage(sensor->view), play_view_side(sensor->view), x, y);
    return G_SOURCE_REMOVE;
}

static void tell(PlaySensor *sensor, const skv_tilt_reading *reading)
{
    g_mutex_lock(&sensor->lock);
    sensor->news.gravity_x = reading->gravity_x;
    sensor->news.gravity_y = reading->gravity_y;
    sensor->news.push_x += reading->push_x;
    sensor->news.push_y += reading->push_y;
    if (!sensor->woken)
        g_idle_add_full(G_PRIORITY_DEFAULT, on_news, sensor, NULL);
    sensor->woken = true;
    g_mutex_unlock(&sensor->lock);
}

static gpointer work(gpointer data)
{
    PlaySensor *sensor = data;
    gint64 last = 0;
    while (!g_atomic_int_get(&sensor->ends)) {
        gint64 now = g_get_monotonic_time();
        double seconds = last ? (double)(now - last) / G_USEC_PER_SEC : 0;
        skv_orientation up = (skv_orientation)g_atomic_int_get(&sensor->up);
        skv_tilt_reading reading;
        if (skv_tilt_read(sensor->tilt, seconds, up, &reading))
            tell(sensor, &reading);
        last = now;
        g_usleep(PERIOD);
    }
    return NULL;
}

static void stop(PlaySensor *sensor)
{
    g_atomic_int_set(&sensor->ends, 1);
    g_clear_pointer(&sensor->thread, g_thread_join);
    while (g_idle_remove_by_data(sensor))
        continue;
    sensor->woken = false;
}

static void start(PlaySensor *sensor)
{
    g_atomic_int_set(&sensor->ends, 0);
    sensor->thread = g_thread_new("sensor", work, sensor);
}

static void free_sensor(gpointer data)
{
    PlaySensor *sensor = data;
    stop(sensor);
    skv_tilt_close(sensor->tilt);
    g_mutex_clear(&sensor->lock);
    g_free(sensor);
}

PlaySensor *play_sensor_of(PlayView *view)
{
    return g_object_get_data(G_OBJECT(view), "sensor");
}

void play_sensor_attach(PlayView *view)
{
    skv_tilt *tilt;
    if (skv_tilt_open(g_getenv("SKVALP_SENSORS"), &tilt, NULL) != SKV_OK)
        return;
    PlaySensor *sensor = g_new0(PlaySensor, 1);
    sensor->view = view;
    sensor->tilt = tilt;
    g_mutex_init(&sensor->lock);
    g_object_set_data_full(G_OBJECT(view), "sensor", sensor, free_sensor);
    sensor->strength = CLAMP(play_settings_number("tilt-strength", 10) / 10.0, 0, STRONGEST);
    sensor->up = CLAMP(play_settings_number("tilt-up", 0), 0, SKV_ORIENTATION_RIGHT);
    if (play_settings_number("tilt", 0))
        start(sensor);
}

gboolean play_sensor_is_on(const PlaySensor *sensor)
{
    return sensor->thread != NULL;
}

void play_sensor_set_on(PlaySensor *sensor, gboolean on)
{
    if (on && !sensor->thread)
        start(sensor);
    else if (!on && sensor->thread)
        stop(sensor);
    play_settings_set_number("tilt", on);
}

double play_sensor_strength(const PlaySensor *sensor)
{
    return sensor->strength;
}

void play_sensor_set_strength(PlaySensor *sensor, double strength)
{
    sensor->strength = CLAMP(strength, 0, STRONGEST);
    play_settings_set_number("tilt-strength", (int)lround(sensor->strength * 10));
}

int play_sensor_up(PlaySensor *sensor)
{
    return g_atomic_int_get(&sensor->up);
}

void play_sensor_set_up(PlaySensor *sensor, int up)
{
    g_atomic_int_set(&sensor->up, up);
    play_settings_set_number("tilt-up", up);
}
