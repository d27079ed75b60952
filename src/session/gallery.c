/* Pictures, handed from one thread to another without a lock.
 *
 * Invariant: only the session's thread paints, and only on a canvas that neither hangs nor is held.
 * A face first counts itself as a holder and then looks whether the canvas still hangs: if so, it
 * was not painted on since, for the painter takes no canvas that has a holder.
 */
#include "session/gallery.h"

#include "base/arrays.h"
#include "base/assert.h"
#include "base/memory.h"
#include "world/parameters.h"

#include <string.h>

skv_opened *skv_opened_create(skv_scene *scene, const char *name, uint32_t number)
{
    skv_opened *opened = skv_calloc(1, sizeof *opened);
    if (opened) {
        *opened = (skv_opened){.users = 1, .number = number, .scene = scene};
        skv_format(opened->name, sizeof opened->name, "%s", name);
        skv_make_plain(opened->name);
    }
    return opened;
}

void skv_opened_leave(skv_opened *opened)
{
    if (!opened || --opened->users > 0)
        return;
    skv_scene_destroy(opened->scene);
    skv_free(opened);
}

/* What no picture says before something was opened. */
static void clear(skv_canvas *canvas)
{
    memset(&canvas->picture, 0, sizeof canvas->picture);
    canvas->picture.name = canvas->picture.title = canvas->picture.description = "";
    canvas->picture.view = canvas->picture.overlays = "";
    canvas->picture.speed = canvas->picture.pace = 1;
    canvas->picture.parameters = skv_default_world_def();
    skv_terrain_destroy(canvas->terrain);
    canvas->terrain = NULL;
    skv_opened_leave(canvas->opened);
    canvas->opened = NULL;
}

void skv_gallery_create(skv_gallery *gallery)
{
    for (int i = 0; i < SKV_CANVASES; i++)
        clear(&gallery->canvases[i]);
}

void skv_gallery_destroy(skv_gallery *gallery)
{
    for (int i = 0; i < SKV_CANVASES; i++) {
        clear(&gallery->canvases[i]);
        skv_free(gallery->canvases[i].block);
        skv_free(gallery->canvases[i].samples);
    }
}

const skv_picture *skv_gallery_acquire(skv_gallery *gallery)
{
    for (;;) {
        int hanging = atomic_load(&gallery->hanging);
        skv_canvas *canvas = &gallery->canvases[hanging];
        atomic_fetch_add(&canvas->holders, 1);
        if (atomic_load(&gallery->hanging) == hanging)
            return &canvas->picture;
        atomic_fetch_sub(&canvas->holders, 1);
    }
}

void skv_gallery_release(skv_gallery *gallery, const skv_picture *picture)
{
    for (int i = 0; i < SKV_CANVASES; i++)
        if (&gallery->canvases[i].picture == picture)
            atomic_fetch_sub(&gallery->canvases[i].holders, 1);
}

static bool reserve(skv_canvas *canvas, int count)
{
    if (count <= canvas->room)
        return true;
    size_t room = (size_t)count + (size_t)count / 4;
    const skv_array arrays[] = {
        SKV_ARRAY(canvas->x, room, 0),        SKV_ARRAY(canvas->y, room, 0),
        SKV_ARRAY(canvas->vx, room, 0),       SKV_ARRAY(canvas->vy, room, 0),
        SKV_ARRAY(canvas->pressure, room, 0), SKV_ARRAY(canvas->clearance, room, 0),
        SKV_ARRAY(canvas->id, room, 0),       SKV_ARRAY(canvas->dye, room, 0),
        SKV_ARRAY(canvas->fluid, room, 0),
    };
    if (!skv_arrays_grow(&canvas->block, arrays, (int)(sizeof arrays / sizeof *arrays)))
        return false;
    canvas->room = (int)room;
    return true;
}

static void copy_particles(skv_canvas *canvas, const skv_particles *from)
{
    size_t bytes = (size_t)from->count * sizeof *canvas->x;
    if (bytes == 0)
        return;
    memcpy(canvas->x, from->x, bytes);
    memcpy(canvas->y, from->y, bytes);
    memcpy(canvas->vx, from->vx, bytes);
    memcpy(canvas->vy, from->vy, bytes);
    memcpy(canvas->pressure, from->pressure, bytes);
    memcpy(canvas->clearance, from->clearance, bytes);
    memcpy(canvas->id, from->id, bytes);
    memcpy(canvas->dye, from->dye, (size_t)from->count);
    if (from->fluid)
        memcpy(canvas->fluid, from->fluid, (size_t)from->count);
}

static void paint_world(skv_canvas *canvas, const skv_world *world)
{
    skv_frame *frame = &canvas->picture.frame;
    *frame = skv_world_frame(world);
    canvas->picture.parameters = skv_world_describe(world);
    copy_particles(canvas, &frame->particles);
    frame->particles = (skv_particles){.count = frame->particles.count,
                                       .x = canvas->x,
                                       .y = canvas->y,
                                       .vx = canvas->vx,
                                       .vy = canvas->vy,
                                       .pressure = canvas->pressure,
                                       .clearance = canvas->clearance,
                                       .id = canvas->id,
                                       .dye = canvas->dye,
                                       .fluid = frame->particles.fluid ? canvas->fluid : NULL};
    memcpy(canvas->fluids, frame->fluids, (size_t)frame->fluid_count * sizeof *frame->fluids);
    frame->fluids = canvas->fluids;
    if (frame->body_count > 0)
        memcpy(canvas->bodies, frame->bodies, (size_t)frame->body_count * sizeof *frame->bodies);
    frame->bodies = canvas->bodies;
    canvas->terrain = skv_terrain_share(frame->terrain);
    frame->terrain = canvas->terrain;
}

static void paint_opened(skv_canvas *canvas, skv_opened *opened)
{
    skv_picture *picture = &canvas->picture;
    opened->users++;
    canvas->opened = opened;
    picture->opened = opened->number;
    picture->scene = opened->scene;
    picture->name = picture->title = opened->name;
    picture->view = opened->view;
    picture->overlays = opened->overlays;
    picture->still = opened->still;
    if (opened->scene) {
        picture->name = skv_scene_name(opened->scene);
        picture->title = skv_scene_title(opened->scene);
        picture->description = skv_scene_description(opened->scene);
    }
}

skv_canvas *skv_gallery_begin(skv_gallery *gallery, const skv_world *world, skv_opened *opened)
{
    int hanging = atomic_load(&gallery->hanging);
    for (int i = 0; i < SKV_CANVASES; i++) {
        skv_canvas *canvas = &gallery->canvases[i];
        if (i == hanging || atomic_load(&canvas->holders) > 0)
            continue;
        if (world && !reserve(canvas, skv_world_particle_count(world)))
            return NULL;
        clear(canvas);
        if (world)
            paint_world(canvas, world);
        if (opened)
            paint_opened(canvas, opened);
        return canvas;
    }
    return NULL;
}

void skv_gallery_hang(skv_gallery *gallery, skv_canvas *canvas)
{
    canvas->picture.number = ++gallery->number;
    atomic_store(&gallery->hanging, (int)(canvas - gallery->canvases));
}

bool skv_canvas_reserve_samples(skv_canvas *canvas, size_t count)
{
    if (count <= canvas->sample_room)
        return true;
    double *samples = skv_calloc(count, sizeof *samples);
    if (!samples)
        return false;
    skv_free(canvas->samples);
    canvas->samples = samples;
    canvas->sample_room = count;
    return true;
}
