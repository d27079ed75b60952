/* Vertices: what each particle of a frame adds to the picture. */
#ifndef SKV_RENDER_VERTICES_H
#define SKV_RENDER_VERTICES_H

#include "render/look.h"
#include "render/mesh.h"
#include "skvalp/render.h"

/* The most light that a tint takes, in powers of e: what is left of it then is 4.7 of 255. */
#define SKV_TINT_LIGHT 4.0f

typedef struct skv_vertex {
    float x, y;   /* m */
    float value;  /* what the view shows, times `second` unless there is foam */
    float second; /* how much this particle knows of it; with foam, of which all know all: 0..1 */
    uint16_t tint[4]; /* light that dyes take, by colour, and how much they cover; in units of
                         SKV_TINT_LIGHT and 1, of 65535 */
    uint8_t fluid[4]; /* its number, and nothing else */
} skv_vertex;

typedef struct skv_vertices {
    int count, capacity;
    skv_vertex *list;
    float *trusts;   /* of `capacity` */
    skv_mesh mesh;   /* with the motion of the frame */
    bool foamy;      /* the vertices have foam */
    bool tinted;     /* whether any of them is dyed */
    int last_fluid;  /* the highest number of a fluid that shows; 0: the first alone */
    double slope[3]; /* to be added to the values: per metre to the right, up, at the origin */
} skv_vertices;

void skv_vertices_destroy(skv_vertices *vertices);

/* Fills in what a view shows: water: depth in multiples of how far light goes; else shares of the
 * legend's scale. `colors`: those of dyes. `foam`: whether to look for it. `walls_key`
 * as in skv_mesh_begin. SKV_ERROR_MEMORY. */
skv_result skv_vertices_fill(skv_vertices *vertices, const skv_frame *frame, skv_view view,
                             const skv_legend *legend, const skv_colors *colors, bool foam,
                             uint64_t walls_key, skv_error *error);

#endif
