/* Which cells of air hang together.
 *
 * Rows are cut into runs of cells that are linked, from the top row down and from the right to the
 * left. A run that is linked to one of the row above belongs to the same piece. So the first run of
 * each piece tells its turn: pieces are numbered by their highest cells.
 *
 * Invariant: what comes of it depends on no order of looking, but for the numbers of the pieces.
 */
#include "world/air/air.h"

#include <string.h>

/* Cells of a piece are more than half air. */
#define HALF 0.5f

/* Its edges are cells with more air than this, and two cells wide. */
#define EDGE_FROM SKV_AIR_FROM
enum { EDGE = 2 };

/* Cells from `right` down to `left`; `parent` is a run of the same piece that comes no later. */
typedef struct run {
    int right, left, parent;
} run;

static int root_of(run *runs, int k)
{
    while (runs[k].parent != k)
        k = runs[k].parent = runs[runs[k].parent].parent;
    return k;
}

static bool may_join(const skv_air *air, int cell, float least)
{
    return air->share[cell] > least && !(air->walls[cell] & SKV_CELL_SOLID);
}

/* Adds the runs of a row to `runs`; returns how many there are then. */
static int cut_row(const skv_air *air, int row, run *runs, int count)
{
    int low = row * air->columns, c = low + air->columns - 1;
    while (c >= low) {
        if (!may_join(air, c, HALF)) {
            c--;
            continue;
        }
        int right = c;
        while (c > low && skv_air_is_linked(air, c - 1, 1) && may_join(air, c - 1, HALF))
            c--;
        runs[count] = (run){right, c, count};
        count++;
        c--;
    }
    return count;
}

/* Whether a run is linked to cells of the one above. */
static bool meets(const skv_air *air, const run *below, const run *above)
{
    int left = above->left - air->columns, right = above->right - air->columns;
    left = left > below->left ? left : below->left;
    right = right < below->right ? right : below->right;
    for (int c = right; c >= left; c--)
        if (skv_air_is_linked(air, c, 3))
            return true;
    return false;
}

/* Joins the runs of a row, from `row` to `count`, with those above, from `above` to `row`. */
static void join_rows(const skv_air *air, run *runs, int above, int row, int count)
{
    for (int k = row, j = above; k < count && j < row;) {
        if (meets(air, &runs[k], &runs[j])) {
            int a = root_of(runs, k), b = root_of(runs, j);
            runs[a > b ? a : b].parent = a > b ? b : a;
        }
        if (runs[k].left > runs[j].left - air->columns)
            k++;
        else
            j++;
    }
}

/* Numbers the pieces and labels their cells; those that have no number left get none. */
static void label_runs(skv_air *air, run *runs, int count)
{
    int labels = SKV_FIRST_POCKET;
    for (int k = 0; k < count; k++) {
        run *r = &runs[k];
        int first = root_of(runs, k), label = SKV_NO_AIR;
        if (first != k)
            label = air->label[runs[first].right];
        else if (labels < SKV_AIR_LABELS)
            label = labels++;
        for (int c = r->left; c <= r->right; c++)
            air->label[c] = (uint16_t)label;
    }
    air->labels = labels;
}

/* The lowest of the labels that are linked to a cell. */
static int label_around(const skv_air *air, int cell)
{
    const int column = cell % air->columns, row = cell / air->columns;
    const bool there[4] = {column > 0, column < air->columns - 1, row > 0, row < air->rows - 1};
    int least = SKV_NO_AIR;
    for (int side = 0; side < 4; side++) {
        if (!there[side])
            continue;
        int from = skv_air_beside(air, cell, side), label = air->label[from];
        if (label && skv_air_is_linked(air, from, side ^ 1) && (!least || label < least))
            least = label;
    }
    return least;
}

/* Labels what belongs to the edges of pieces. */
static void label_edges(skv_air *air)
{
    int *cell = air->scratch, *label = air->scratch + air->cells, count = 0;
    for (int c = 0; c < air->cells; c++)
        if (!air->label[c] && may_join(air, c, EDGE_FROM))
            cell[count++] = c;
    for (int ring = 0; ring < EDGE; ring++) {
        for (int k = 0; k < count; k++)
            label[k] = air->label[cell[k]] ? air->label[cell[k]] : label_around(air, cell[k]);
        for (int k = 0; k < count; k++)
            air->label[cell[k]] = (uint16_t)label[k];
    }
}

void skv_air_find_pieces(skv_air *air)
{
    run *runs = (run *)air->scratch;
    int above = 0, row = 0, count = 0;
    memset(air->label, 0, (size_t)air->cells * sizeof *air->label);
    for (int r = air->rows - 1; r >= 0; r--) {
        count = cut_row(air, r, runs, count);
        join_rows(air, runs, above, row, count);
        above = row;
        row = count;
    }
    label_runs(air, runs, count);
    label_edges(air);
}
