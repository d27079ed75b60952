/* Where everything lies: rows, cells and tiles, and what each buffer holds when.
 *
 * Space is cut into rows one smoothing radius h high, and these into cells of h/4. In memory the
 * particles of a row follow each other, cell by cell, and the rows follow each other, upwards.
 *
 *     in space                              in memory: one array for each quantity
 *
 *    y ^ +--+--+--+--+--+--+--+--+          row_start[R]      row_end[R]       row_start[R+1]
 *      | |  |  |f |  |  |g |  |  | row R+1  v                 v                v
 *    h - +--+--+--+--+--+--+--+--+          |a b c d|e        |0 0 0 ... 0 0 0 |f g
 *      | |  |a |bc|  |d |  |e |  | row R    | tile  | tile    | dummies        | tile
 *    0 + +--+--+--+--+--+--+--+--+
 *        0  h/4       h         2h -> x     cell_start: the first place of each cell
 *
 * Dummies. A row begins at a multiple of eight. Behind its end lie at least eight dummies, up to
 * the next row: far from everything, at rest. So a block of eight that begins in a row ends in it,
 * and no range needs a mask at its end.
 *
 * Tiles. A tile is four particles of a row that follow each other; its number is the first one's
 * place / 4. Its partners are two ranges of places: own_end ends that in its own row, which begins
 * behind its first particle, and next_begin and next_end bound that in the next row. A block is a
 * tile times eight partners.
 *
 * Sums. What a pass adds up over pairs it finds in two parts, so that no two rows' tasks write to
 * one place: `own`, for the partners in the own row and for a tile itself, and `next`, for those in
 * the next row, written by the row below. A particle's sum is own + next.
 *
 * Buffers. What they hold through a substep, whose passes over a row are A, density; L, pressure;
 * B, displacement; U, update; W, the sampling of walls, comes first. Whatever
 * lies in a column to the left has been read for the last time when its place is written anew.
 * "read": it is, here.
 *
 *   buffer            sort      A                    L to B          B to U         store
 *   ----------------------------------------------------------------------------------------
 *   set[current]      read      written by the sort, then turned over; U moves them  read
 *    .warm_lambda                                   renewed
 *   set[!current]     written   the older set's memory, free until the next sort:
 *    .x                         own density          P
 *    .y                         own near density     N
 *    .u                         own gradient x       gradient x      gauge pressure  read
 *    .v                         own gradient y       gradient y     hanging
 *    .clearance                 next density                         next move x
 *    .warm_lambda               next near density                   next move y
 *    .number                    next gradient x                      next outward
 *   spare[0]          key       next gradient y                      own move x      place
 *    [1]                         ahead x (W)                         own move y
 *    [2]                         ahead y (W)         own outward     own outward
 *    [3]                         image (W)           image           image
 *   with masses:
 *   set[current]      read      written by the sort, then turned over; read to the end
 *    .lightness
 *   set[!current]     written   own lightness       of the mean mass
 *    .lightness
 *   spare_lightness             next lightness
 *   with masses that are viscous:
 *   set[current]      read      written by the sort, then turned over; read to the end
 *    .drag
 *   set[!current]     written
 *    .drag
 *
 * Densities are sums of W with the clavet law, of q^4 with the calibrated one, whose W is 4 q^3 - 3
 * q^4 and follows when all pairs are summed up. The gradient belongs to that law and the first
 * iteration, the gauge pressure to the last substep of a call. `outward` is there with walls by
 * images; else it holds the virial. skv_rows_lend_buffers, in memory.c, is this table in code.
 */
#ifndef SKV_ROWS_LAYOUT_H
#define SKV_ROWS_LAYOUT_H

#include "solver/rows/rows.h"
#include "terrain/solids.h"

enum {
    ROW_CELLS = 4, /* cells per smoothing radius along a row */
    ROW_TILE = 4,  /* particles that share the loads of their partners */
    ROW_LANES = 8,
    ROW_MARGIN = 2, /* empty rows, and empty radii of cells, around the world */
    ROW_MAX_THREADS = 64,
    ROW_SUMS = 5,  /* that the density pass adds up, at most */
    ROW_SPARE = 4, /* buffers beside the two sets */
    /* Rows of which a thread keeps pairs: two in turn, and one at its seam; and wall samples: three
     * in turn, and those at both seams. */
    ROW_KEPT_SLOTS = 3,
    ROW_SAMPLE_SLOTS = 5
};

/* Added to the number of a particle that is held. */
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
    float *warm_lambda; /* of the last substep, then of this one: solver.h */
    int *number;        /* index in the frame, and ROW_HELD */
    float *lightness;   /* one over the mass; not there without masses */
    float *drag;        /* as in solver.h, times dt; not there unless one with masses is viscous */
} skv_row_particles;

/* One part of what the density pass adds up. */
typedef struct skv_row_sums {
    float *density, *near_density;
    float *gradient_x, *gradient_y;
    float *lightness; /* q^3 over the partner's mass; with masses */
} skv_row_sums;

/* One part of what the displacement pass adds up. */
typedef struct skv_row_moves {
    float *x, *y;
    float *outward; /* of partners' images, out of the wall; of who has none the virial */
} skv_row_moves;

/* Where the pairs of one row are kept between density and displacement. */
typedef struct skv_row_kept {
    float *pairs; /* ROW_TILE * ROW_LANES floats a block: q */
    int room;     /* blocks */
    int used;     /* blocks of the row kept now; -1: it had no room and is computed again */
} skv_row_kept;

/* A wall sample of a particle near a wall. Where several are one wall, those of each follow it. */
typedef struct skv_near_wall {
    int particle;
    int solid; /* whose the wall is, terrain/solids.h; below 0: of so many */
    union {
        skv_wall_sample wall;
        skv_image_sample image; /* with walls by images */
    } at;
} skv_near_wall;

enum { ROW_MOST_WALLS = 1 + SKV_MOST_PARTS };

/* How many lie at a sample. */
static inline int skv_near_walls(const skv_near_wall *wall)
{
    return wall->solid < 0 ? 1 - wall->solid : 1;
}

/* Where those of one row are kept between the sampling and the update. */
typedef struct skv_row_samples {
    skv_near_wall *sample;
    int room; /* with SKV_MOST_PARTS more behind it */
    int used; /* -1: not all found a place, and all are taken again */
} skv_row_samples;

/* What walls have given particles: all of them, and those whose nearest point of a wall lies in the
 * box of a reaction, about its middle and in the world's axes. */
typedef struct skv_row_given {
    skv_impulse_sum all, boxed;
    skv_impulse_sum solid[SKV_MOST_SOLIDS]; /* each, about its middle and in the rows' axes */
} skv_row_given;

/* What a thread owns, on cache lines of its own. */
typedef struct skv_row_thread {
    /* Particles per cell, of those that this thread sorts; 0 between sorts. */
    _Alignas(64) int *histogram;
    int *row_size;       /* the same per row, in the rows that it has counted in */
    int lowest, highest; /* rows that it has counted particles in */
    int first, end;      /* its rows, as cut by what they cost */
    int old_first, old_end;
    skv_row_kept kept[ROW_KEPT_SLOTS];
    skv_row_samples samples[ROW_SAMPLE_SLOTS];
    void *kept_memory;   /* of both */
    skv_row_given walls; /* what they have given this thread's particles in this call */
} skv_row_thread;

struct skv_rows {
    int row_count, stride; /* rows; cells a row, with a spare radius at its end */
    int cells_used;        /* cells a row that particles can be in: 0..cells_used-1 */
    int row_holds;         /* particles that a row holds at rest, roughly */
    int capacity;          /* particles to have room for */
    int slots;             /* array elements: with room for the dummies */
    int first, end;        /* rows with particles */

    /* Per place. */
    skv_row_particles set[2];
    int current;
    float *spare[ROW_SPARE];
    float *spare_lightness;

    /* Lent, as the table above says. */
    int *key;                          /* the cell a particle moves to, by old place */
    int *place;                        /* of a frame's particle, when it is stored */
    skv_row_sums own, next;            /* of the density */
    skv_row_moves own_move, next_move; /* of the displacement */
    float *lambda, *near_lambda;       /* P and N of the pressure law */
    float *gradient_x, *gradient_y;    /* that the tension evens out */
    float *hanging;                    /* share of a wall's pull that one is let fall from */
    float *image;                      /* D of images, wall_image.h */
    float *ahead_x, *ahead_y;          /* how far the density looks ahead of the places */
    float *pressure;                   /* gauge */
    float *mean_lightness;             /* one over the mean mass; with masses */

    /* Per tile: its ranges of partners; whether one of its particles has an image. */
    int *own_end, *next_begin, *next_end;
    bool *beside;

    /* Per eight places: whether one of them may have a gradient, then whether it has. */
    bool *graded;

    /* Per cell and per row. */
    int *cell_start; /* row_count * stride: place of each cell's first particle */
    int *row_start, *row_end;
    int *row_size;            /* of the sort under way */
    int *new_start, *new_end; /* of the sort under way */
    int *row_blocks;          /* blocks of pairs in a row's ranges */
    int *row_walls;           /* particles near a wall in a row; -1: more than a thread keeps */
    /* Which eights of a row may have a gradient, from the first to before the end. */
    int *graded_begin, *graded_end;

    const struct skv_row_kernels *kernels;
    skv_row_thread *thread;
    int thread_room, threads;          /* threads to have memory for, and at work in this call */
    bool held, gauged;                 /* this substep computes the gauge pressure */
    bool massive;                      /* in this call particles have masses */
    bool dragged, various;             /* and drags; which are their own */
    const struct skv_row_frame *frame; /* of this call */
    skv_row_acting acting;             /* in this call */
    const skv_reaction *reaction;      /* whose box is asked for in this call, or null */
    void *particle_block, *mass_block, *drag_block, *grid_block, *histogram_block;
    skv_solver_memory memory;
    double seconds[ROW_PHASES];
};

/* A row's places, dummies included: its end rounded up so that a block of eight that begins before
 * the end stays inside. */
static inline int skv_row_padded_end(int end)
{
    return (end + 2 * ROW_LANES - 1) & ~(ROW_LANES - 1);
}

/* How far a place lags behind the particle: such a share of its way of the substep. */
static inline float lag_of_one(const skv_row_particles *p, int i, float pair_lag, float lag_rise)
{
    float square = (p->u[i] * p->u[i] + p->v[i] * p->v[i]) * lag_rise;
    return pair_lag * (square < 1 ? square : 1);
}

/* Whether particles have masses in this call. */
static inline bool skv_is_massive(const skv_rows *rows)
{
#ifdef SKV_WITHOUT_FLUIDS
    (void)rows;
    return false;
#else
    return rows->massive;
#endif
}

/* Whether unlike particles push each other in this call. */
static inline bool skv_has_pushed(const skv_rows *rows)
{
#ifdef SKV_WITHOUT_FLUIDS
    (void)rows;
    return false;
#else
    return rows->frame->particles->liquids != NULL;
#endif
}

/* Whether fluids have cohesions of their own in this call. */
static inline bool skv_has_cohesions(const skv_rows *rows)
{
#ifdef SKV_WITHOUT_FLUIDS
    (void)rows;
    return false;
#else
    return rows->frame->particles->cohesion != NULL;
#endif
}

static inline float skv_row_mass(const skv_rows *rows, int i)
{
    return skv_is_massive(rows) ? 1 / rows->set[rows->current].lightness[i] : 1;
}

#endif
