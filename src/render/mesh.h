/* Mesh: a frame's particles on a coarse grid of cells of two spacings, where what no single
 * particle knows is found at a cost of a few operations a particle: how the fluid around it moves,
 * what its neighbours' pressure is on average, how deep below the surface it is. */
#ifndef SKV_RENDER_MESH_H
#define SKV_RENDER_MESH_H

#include "skvalp/frame.h"

typedef struct skv_mesh {
    int columns, rows, capacity; /* cells; room for so many */
    float cell;                  /* m; cell (0, 0) is centred at half a cell outside the world */
    float per_cell;              /* particles in a cell full of fluid */
    float shift;                 /* of the values' cells, to the left and downwards; cells */
    const skv_frame *frame;      /* while it is in use */
    uint64_t walls_key;          /* of the walls that `room` is about ... */
    bool bodies;                 /* ... and it is about bodies, too */
    /* A value a cell: */
    float *room;   /* for fluid about its centre beside walls, 0..1 */
    float *weight; /* particles, spread over the four cells around them */
    float *vx, *vy;
    float *value, *trust; /* sums over particles of what is averaged, and of its weight */
    float *depth;         /* m of fluid on the shortest way to air; FLT_MAX in walls */
} skv_mesh;

void skv_mesh_destroy(skv_mesh *mesh);

/* Fits the mesh to a frame and empties it. `walls_key` is another number whenever the frame's
 * terrain is another. SKV_ERROR_MEMORY. */
skv_result skv_mesh_begin(skv_mesh *mesh, const skv_frame *frame, uint64_t walls_key,
                          skv_error *error);

/* Where a point is between four cells. */
typedef struct skv_mesh_place {
    int cell; /* the lower left one */
    float right, up;
} skv_mesh_place;
skv_mesh_place skv_mesh_locate(const skv_mesh *mesh, float x, float y);

/* Adds the particles' number and momentum. */
void skv_mesh_add_motion(skv_mesh *mesh);
/* Empties it of values, whose cells lie `shift` of one, 0..1, to the left and below the others;
 * adds one particle's with a weight. */
void skv_mesh_begin_values(skv_mesh *mesh, float shift);
void skv_mesh_add_value(skv_mesh *mesh, float x, float y, float value, float trust);

/* Finds how deep the fluid is, from the cells' fill; needs the motion. */
void skv_mesh_find_depth(skv_mesh *mesh);

/* The averages about a point; `fallback` where there is nothing. Density: particles by those that
 * have room there. */
float skv_mesh_value(const skv_mesh *mesh, float x, float y, float fallback);
float skv_mesh_density(const skv_mesh *mesh, float x, float y);
float skv_mesh_depth(const skv_mesh *mesh, float x, float y);
/* The fluid's velocity; false, and zero, where there is hardly any. */
bool skv_mesh_velocity(const skv_mesh *mesh, float x, float y, float *vx, float *vy);

#endif
