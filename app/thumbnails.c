/* Thumbnails: a small world of each scene, played for a moment and drawn without a display.
 * Invariant: nothing of it happens on the thread of the interface. */
#include "thumbnails.h"

#include <skvalp/scene.h>

#include "workers.h"

#define WIDTH     320
#define HEIGHT    180
#define PARTICLES 1500
#define FRAMES    36 /* of 1/60 s: the water has begun to move, and is still where it belongs */

typedef struct job {
    char **names;
    skv_render_style style;
    GCancellable *stop;
    PlayShowThumbnail *show;
    gpointer user;
} job;

/* One that is ready, on its way to the main loop. */
typedef struct ready {
    GCancellable *stop;
    char *name;
    GdkTexture *texture;
    PlayShowThumbnail *show;
    gpointer user;
} ready;

static gboolean on_ready(gpointer data)
{
    ready *made = data;
    if (!g_cancellable_is_cancelled(made->stop))
        made->show(made->name, made->texture, made->user);
    g_object_unref(made->stop);
    g_object_unref(made->texture);
    g_free(made->name);
    g_free(made);
    return G_SOURCE_REMOVE;
}

static skv_world *play_a_moment(const char *name, GCancellable *stop)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = PARTICLES;
    skv_scene *scene;
    skv_world *world = NULL;
    if (skv_scene_load(name, &options, &scene, NULL) != SKV_OK)
        return NULL;
    if (skv_scene_create_world(scene, 1, &world, NULL) != SKV_OK)
        world = NULL;
    skv_scene_destroy(scene);
    for (int i = 0; world && i < FRAMES && !g_cancellable_is_cancelled(stop); i++)
        if (skv_world_step(world, 1.0F / 60, NULL) != SKV_OK)
            break;
    return world;
}

static GdkTexture *draw(skv_offscreen *offscreen, const char *name, const skv_render_style *style,
                        GCancellable *stop)
{
    skv_world *world = play_a_moment(name, stop);
    if (!world)
        return NULL;
    guint8 *rgb = g_malloc((gsize)WIDTH * HEIGHT * 3);
    skv_frame frame = skv_world_frame(world);
    GdkTexture *texture = NULL;
    if (skv_offscreen_render(offscreen, &frame, style, rgb, NULL) == SKV_OK) {
        GBytes *bytes = g_bytes_new_take(rgb, (gsize)WIDTH * HEIGHT * 3);
        texture = gdk_memory_texture_new(WIDTH, HEIGHT, GDK_MEMORY_R8G8B8, bytes, (gsize)WIDTH * 3);
        g_bytes_unref(bytes);
    } else {
        g_free(rgb);
    }
    skv_world_destroy(world);
    return texture;
}

static void make_all(const job *work)
{
    skv_offscreen *offscreen;
    if (skv_offscreen_create(WIDTH, HEIGHT, &offscreen, NULL) != SKV_OK)
        return; /* names and descriptions do */
    for (int i = 0; work->names[i] && !g_cancellable_is_cancelled(work->stop); i++) {
        GdkTexture *texture = draw(offscreen, work->names[i], &work->style, work->stop);
        if (!texture)
            continue;
        ready *made = g_new(ready, 1);
        *made = (ready){g_object_ref(work->stop), g_strdup(work->names[i]), texture, work->show,
                        work->user};
        g_idle_add(on_ready, made);
    }
    skv_offscreen_destroy(offscreen);
}

static gpointer run(gpointer data)
{
    job *work = data;
    make_all(work);
    g_strfreev(work->names);
    g_object_unref(work->stop);
    g_free(work);
    return NULL;
}

void play_thumbnails_make(const char *const *names, const skv_render_style *style,
                          GCancellable *stop, PlayShowThumbnail *show, gpointer user)
{
    job *work = g_new(job, 1);
    *work = (job){g_strdupv((char **)names), *style, g_object_ref(stop), show, user};
    play_workers_start("thumbnails", run, work);
}
