/* The rows' inside: shared by the sort (grid.c), the pipeline (rows.c) and the kernels, which are
 * compiled once per instruction set. */
#ifndef SKV_ROWS_INTERNAL_H
#define SKV_ROWS_INTERNAL_H

#include "solver/rows/rows.h"

enum {
    ROW_CELLS = 4, /* cells per smoothing radius along a row */
    ROW_TILE = 4,  /* particles that share the loads of their partners */
    ROW_LANES = 8,
    ROW_MARGIN = 2, /* empty rows, and empty radii of cells, around the world */
    ROW_SUMS = 4,   /* density, near density, gradient x, gradient y */
    ROW_MAX_THREADS = 64,
    ROW_SLOTS = 3 /* rows whose pairs a thread keeps: two in turn, and its last */
};

/* Added to the number of a particle that is held. As a float's bits a number is finite with it,
 * too: numbers are left over where dummies' pressures are read. */
#define ROW_HELD (1 << 30)

/* Where a dummy lies: farther from everything than h, but not so far that its square overflows. */
#define ROW_FAR 1e9f

/* How much the distance to a wall can fall per length of way: it is bilinear, so along a diagonal
 * by up to the square root of two. */
#define ROW_WALL_SLOPE 1.4143f

/* Phases of a substep, for the profile. */
enum { ROW_ADVANCE, ROW_SORT, ROW_RELAX, ROW_TRANSFER, ROW_PHASES };

/* A sorted particle's data. Two sets: a sort reads one and writes the other. */
typedef struct skv_row_particles {
    float *x, *y, *u, *v;
    float *clearance;
    int *number; /* index in the frame, and ROW_HELD */
} skv_row_particles;

/* Where the pairs of one row are kept between density and displacement. */
typedef struct skv_row_kept {
    float *pairs; /* ROW_TILE * ROW_LANES floats a block: q */
    int room;     /* blocks */
    int used;     /* blocks of the row kept now; -1: it had no room and is computed again */
} skv_row_kept;

/* A wall sample of a particle near a wall, kept from the density to the update. */
typedef struct skv_near_wall {
    int particle;
    skv_row_wall wall;
} skv_near_wall;

/* What a thread owns, on cache lines of its own. */
typedef struct skv_row_thread {
    /* Particles per cell, of those that this thread sorts; 0 between sorts. */
    _Alignas(64) int *histogram;
    int *row_size;       /* the same per row, in the rows that it has counted in */
    int lowest, highest; /* rows that it has counted particles in */
    int first, end;      /* its rows, as cut by what they cost */
    int old_first, old_end;
    skv_row_kept kept[ROW_SLOTS];
    float *kept_memory;
    skv_near_wall *near_walls;
    int near_wall_count, near_wall_room;
} skv_row_thread;

struct skv_rows {
    int row_count, stride;      /* rows; cells a row, with a spare radius at its end */
    int cells_used;             /* cells a row that particles can be in: 0..cells_used-1 */
    int count, capacity, slots; /* particles; room for them; array elements */
    int first, end;             /* rows with particles */
    int widest;                 /* particles of the fullest row */

    skv_row_particles set[2];
    int current;
    int *key;        /* the cell a particle moves to, by old place */
    int *place;      /* of a frame's particle, when it is given back */
    int *cell_start; /* row_count * stride: place of each cell's first particle */
    int *row_start, *row_end;
    int *row_size;                        /* of the sort under way */
    int *new_start, *new_end;             /* of the sort under way */
    int *own_end, *next_begin, *next_end; /* partner ranges by tile */
    int *row_blocks;                      /* blocks of pairs in a row's ranges */
    int *wall_first, *wall_count;         /* a row's samples in its thread's near_walls; count -1:
                                             not all found a place */

    /* Accumulators, see rows.h. The displacement pass reuses those of density and near density,
     * which the pressure has consumed by then. `sum`, `push` and `near_push` lie in the set that
     * is not current. */
    float *own[ROW_SUMS], *next[ROW_SUMS], *sum[ROW_SUMS];
    float *viscous_own[2], *viscous_next[2], *viscous_sum[2]; /* null without viscosity */
    float *push, *near_push, *pressure;
    float *gradient[2]; /* that the tension evens out; lie where those of y were summed up */

    skv_row_thread *thread;
    int thread_room, threads; /* threads to have memory for, and at work in this call */
    bool viscous;             /* pair viscosity in the first iteration */
    bool held, gauged;        /* this substep computes the gauge pressure */
    void *block, *viscous_block, *grid_block, *histogram_block;
    size_t particle_bytes;
    double seconds[ROW_PHASES];
};

/* One instruction set's kernels. Each handles one row. */
typedef struct skv_row_kernels {
    const char *isa;
    /* Forces and advance. */
    void (*advance)(const skv_rows *rows, int row, const skv_row_constants *constants,
                    const skv_row_boundary *boundary);
    /* Pass A. `later` false: with the gradient that the calibrated law's tension needs, and
     * viscosity if there is any; true: densities only.
     * Keeps the pairs if there is room. */
    void (*density)(const skv_rows *rows, int row, bool later, const skv_row_constants *constants,
                    const skv_row_boundary *boundary, skv_row_kept *kept);
    /* The pressure law; samples the walls into the thread's near_walls. Returns how many samples,
     * or -1 if not all of them found a place. */
    int (*pressure)(const skv_rows *rows, int row, bool later, const skv_row_constants *constants,
                    const skv_row_boundary *boundary, skv_row_thread *thread);
    /* Pass B; with the tension unless it is `later`. */
    void (*displacement)(const skv_rows *rows, int row, bool later,
                         const skv_row_constants *constants, const skv_row_boundary *boundary,
                         const skv_row_kept *kept);
    /* Carries out the displacement; in the last iteration the contact as well. */
    void (*update)(const skv_rows *rows, int row, int iteration, const skv_row_constants *constants,
                   const skv_row_boundary *boundary, const skv_near_wall *walls, int wall_count);
} skv_row_kernels;

/* isa.c: the kernels that suit this processor, or those that SKVALP_ISA names. */
const skv_row_kernels *skv_row_kernels_chosen(void);

extern const skv_row_kernels skv_row_kernels_scalar;
extern const skv_row_kernels skv_row_kernels_base; /* SSE2, NEON or WebAssembly */
extern const skv_row_kernels skv_row_kernels_avx2;

/* grid.c: sorts all particles; called by every thread of the pool with its index. Then, when all of
 * them have come back, one turns over: the new order becomes the current one. */
void skv_rows_sort(skv_rows *rows, int thread, skv_pool *pool);
void skv_rows_turn_over(skv_rows *rows);

/* Parts the coincident particles of a row. */
void skv_rows_separate_coincident(skv_rows *rows, int row);

/* Finds the two ranges of partners of each tile of a row, and how many blocks of pairs they make:
 * in the own row up to a radius ahead, in the next row within a radius to both sides. Once a
 * substep: in its later iterations the partners stay the same, though they move. */
void skv_rows_find_ranges(skv_rows *rows, int row);

/* A row's places, dummies included: its end rounded up so that a block of eight that begins before
 * the end stays inside. */
static inline int skv_row_padded_end(int end)
{
    return (end + 2 * ROW_LANES - 1) & ~(ROW_LANES - 1);
}

#endif
