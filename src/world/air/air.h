/* The air of a world: closed pockets of it push; see air.c. */
#ifndef SKV_WORLD_AIR_H
#define SKV_WORLD_AIR_H

#include "base/bytes.h"
#include "skvalp/air.h"
#include "world/world_internal.h"

/* Labels of cells: none, the atmosphere's, and from there on those of pockets. More pockets than
 * there are labels are passed over. */
enum { SKV_NO_AIR, SKV_ATMOSPHERE, SKV_FIRST_POCKET, SKV_AIR_LABELS = 4096 };

/* Cells beyond each side of the world. */
enum { SKV_AIR_RIM = 2 };

/* What a cell is: bits. The first four say that nothing parts its middle from that of the cell on
 * this side. */
enum {
    SKV_CELL_LEFT = 1,
    SKV_CELL_RIGHT = 2,
    SKV_CELL_DOWN = 4,
    SKV_CELL_UP = 8,
    SKV_CELL_LINKED = 15, /* on all sides */
    SKV_CELL_SOLID = 16,  /* its middle is */
    SKV_CELL_CUT = 32,    /* a wall may pass through it */
    SKV_CELL_CLEAR = 64,  /* no wall is near: the eight around it are linked, too */
    SKV_CELL_BODY = 128   /* a body is near */
};

/* A piece of air that hangs together. */
typedef struct skv_piece {
    double volume;        /* m^2 */
    double x, y;          /* sums of volume times place */
    double amount;        /* the volume that it would have at the pressure of the atmosphere */
    double was_outside;   /* of its volume the part that was the atmosphere's before */
    double push;          /* Pa m */
    int cells, low, high; /* how many, and its lowest and highest rows */
    int bodies;           /* that move freely and face it */
    double coming;        /* by how much bodies change its volume in this substep, m^2 */
    bool outside;         /* it is the atmosphere, or some of it */
    bool yields;          /* it pushes less the larger it is */
} skv_piece;

typedef struct skv_air {
    float pressure; /* of the atmosphere, Pa m */
    float cell;     /* side of a cell, m */
    int columns, rows, cells;
    bool with_bodies; /* they are asked where they are */
    bool surveyed;    /* the walls, of a terrain with this hash */
    uint64_t terrain;

    uint8_t *walls, *bare_walls;         /* what each cell is; with the terrain alone */
    float *room, *bare_room, *open_room; /* cells of volume around its middle; smoothed */
    float *fluid, *share, *push;         /* the same of fluid; share of air, 0..1; its push, Pa m */
    float *work;
    float *held;  /* of its room what counts as air */
    float *clear; /* how far its middle is from the terrain, m */
    uint16_t *label;
    int *scratch; /* three for each cell: what hangs together is found with them */
    int labels;   /* one more than the last in use */
    bool pushes;  /* any fluid */
    skv_piece piece[SKV_AIR_LABELS];
    double left[SKV_AIR_LABELS]; /* by the label of before, the volume that is air now */

    /* What decides the future, and so is in a snapshot. */
    bool begun;
    uint16_t *before;              /* labels, of the last substep */
    double amount[SKV_AIR_LABELS]; /* and what the pockets with them held */
    double lift, wanted_lift;      /* air/lift.c, Pa m */
    void *block;
} skv_air;

/* A substep of `dt`: air pushes the fluid, where `partial` that which moves, and bodies. Without
 * air nothing. */
void skv_air_push(skv_world *world, float dt, bool partial);
/* The same of the fluid while no time passes. */
void skv_air_hold(skv_world *world, float dt);
/* After it: takes from the pressures what lifts them all. */
void skv_air_gauge(skv_world *world, bool partial);

/* Adds to a velocity what air gives a particle in a substep of `dt`, as it pushed last. */
void skv_air_push_one(const skv_world *world, int particle, float dt, float *vx, float *vy);

/* Whether a particle is kept awake by air that may change. */
bool skv_air_stirs(const skv_world *world, int particle);

void skv_air_destroy(skv_air *air);
/* Adds what decides its future to a hash. */
uint64_t skv_air_hash(uint64_t hash, const skv_air *air);

/* In a snapshot (docs/snapshot.md). Reading checks all of it. */
void skv_air_save(skv_writer *writer, const skv_air *air);
skv_result skv_air_check(skv_reader *reader, skv_error *error);
skv_result skv_air_load(const skv_world *world, skv_reader reader, skv_air **air, skv_error *error);
/* Gives a world another, or none, and frees its own. */
void skv_air_take_over(skv_world *world, skv_air *air);

/* ---- Between its files ----------------------------------------------------------------------- */

/* air/grid.c: sees to it that the grid knows the walls and the bodies. */
void skv_air_survey(const skv_world *world, skv_air *air);
/* Adds the shares of an amount at (x, y) to the nine cells around; nothing where walls leave no
 * middle of a cell in sight. */
void skv_air_deposit(const skv_world *world, const skv_air *air, float x, float y, float amount,
                     float *to);
/* How the sum over cells of the shares of what lies at (x, y) times `of` changes as it moves, for
 * each side of a cell; false: it does not. */
bool skv_air_slope(const skv_world *world, const skv_air *air, const float *of, float x, float y,
                   float *slope_x, float *slope_y);
/* The cell that (x, y) lies in, or the nearest one. */
int skv_air_cell_at(const skv_air *air, float x, float y);
/* Spreads what cells have to those beside them: 1/4, 1/2, 1/4 along one axis and then along the
 * other; `back` is the transpose of that. Writes the rows from `first` to `last`. */
void skv_air_smooth(const skv_air *air, const float *from, float *to, bool back, int first,
                    int last);

/* The cell beside one, on the side of a bit; there is one wherever that bit is set. */
static inline int skv_air_beside(const skv_air *air, int cell, int side)
{
    const int steps[4] = {-1, 1, -air->columns, air->columns};
    return cell + steps[side];
}

static inline bool skv_air_is_linked(const skv_air *air, int cell, int side)
{
    return air->walls[cell] >> side & 1;
}

/* Where a cell's middle lies, m. */
static inline float skv_air_middle(const skv_air *air, int column_or_row)
{
    return ((float)(column_or_row - SKV_AIR_RIM) + 0.5f) * air->cell;
}

/* Shares of air from which on a cell counts as some, and counts wholly. Fluid at rest has 0.05 at
 * most; a particle alone leaves 0.81 of its own cell. Between them the push rises evenly. */
#define SKV_AIR_FROM  0.1f
#define SKV_AIR_WHOLE 0.8f

/* Of the push of air the part that a cell has. */
float skv_air_part(float share);

/* Whether a piece is a pocket, and the pressure of one above the atmosphere's, Pa m. */
bool skv_air_is_pocket(const skv_air *air, const skv_piece *piece);
double skv_air_pressure_of(const skv_air *air, const skv_piece *piece);

/* air/pieces.c: labels the cells of all pieces by the shares, from the top of the grid: first where
 * there is more air than not, then what belongs to their edges. */
void skv_air_find_pieces(skv_air *air);

/* air/lift.c: by how much all pressures have to be lifted so that none is below 0, `dt` after the
 * last time; 0: there was none. */
void skv_air_find_lift(const skv_world *world, skv_air *air, double dt);

#endif
