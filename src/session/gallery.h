/* The gallery: pictures of a world, made by the session's thread and looked at by the face's. */
#ifndef SKV_SESSION_GALLERY_H
#define SKV_SESSION_GALLERY_H

#include <stdatomic.h>

#include "session/player.h"
#include "skvalp/stage.h"

/* What was opened: what pictures say of it. Counted by those that do, on the session's thread. */
typedef struct skv_opened {
    int users;
    uint32_t number;
    skv_scene *scene; /* or null, and a name of its own */
    char name[128];
    char view[SKV_SHOWN_NAME], overlays[SKV_SHOWN_NAMES];
    bool still;
} skv_opened;

skv_opened *skv_opened_create(skv_scene *scene, const char *name, uint32_t number);
void skv_opened_leave(skv_opened *opened); /* null is allowed */

typedef struct skv_canvas {
    skv_picture picture;
    atomic_int holders;
    skv_opened *opened;
    skv_terrain *terrain;
    void *block; /* of the particles' arrays */
    float *x, *y, *vx, *vy, *pressure, *clearance;
    skv_particle_id *id;
    uint8_t *dye, *fluid;
    skv_liquid fluids[SKV_MAX_FLUIDS];
    skv_body bodies[SKV_MAX_BODIES];
    int room;
    double *samples; /* of the probes' histories */
    size_t sample_room;
} skv_canvas;

/* One that is being painted, one that hangs, and two that may be held. */
enum { SKV_CANVASES = 4 };

typedef struct skv_gallery {
    skv_canvas canvases[SKV_CANVASES];
    atomic_int hanging;
    uint64_t number;
} skv_gallery;

void skv_gallery_create(skv_gallery *gallery);
void skv_gallery_destroy(skv_gallery *gallery);

/* The face's side. */
const skv_picture *skv_gallery_acquire(skv_gallery *gallery);
void skv_gallery_release(skv_gallery *gallery, const skv_picture *picture);

/* The session's side: a canvas to paint on, null if all are held or memory is out; with a copy of
 * the world, null for none, and all else 0. Then it is hung up. */
skv_canvas *skv_gallery_begin(skv_gallery *gallery, const skv_world *world, skv_opened *opened);
void skv_gallery_hang(skv_gallery *gallery, skv_canvas *canvas);

/* Room for so many numbers on a canvas; false if memory is out. */
bool skv_canvas_reserve_samples(skv_canvas *canvas, size_t count);

#endif
