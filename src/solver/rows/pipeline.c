/* Passing work on from row to row, and waiting at the seams between threads; see pipeline.h.
 * Invariant: a thread waits only for what its neighbour reaches without waiting for it. */
#include "solver/rows/pipeline.h"

#include <string.h>

/* What neighbours wait for, in the order in which a thread comes to it in each turn. */
typedef enum milestone {
    FIRST_SAMPLED = 1,
    LAST_SUMMED,
    FIRST_PRESSED,
    LAST_DISPLACED,
    FIRST_UPDATED
} milestone;
enum { MILESTONES = FIRST_UPDATED };

static void reach(const skv_row_worker *w, milestone m)
{
    skv_pool_reach(w->shared->pool, &w->shared->progress[w->thread], w->turn * MILESTONES + m);
}

static void await(const skv_row_worker *w, int neighbour, milestone m)
{
    if (neighbour >= 0)
        skv_pool_await(w->shared->pool, &w->shared->progress[neighbour], w->turn * MILESTONES + m);
}

static bool owns(const skv_row_worker *w, int row)
{
    return w->first <= row && row <= w->last;
}

/* The next thread with rows, upwards (step 1) or downwards (-1), or -1. */
static int neighbour(const skv_rows *rows, int thread, int step)
{
    for (int t = thread + step; t >= 0 && t < rows->threads; t += step)
        if (rows->thread[t].first < rows->thread[t].end)
            return t;
    return -1;
}

/* The lowest row's `next` sums come from nobody: the row below it is empty. Nobody adds to them, so
 * once a substep is enough. */
static void clear_lowest(skv_rows *rows)
{
    int begin = rows->row_start[rows->first];
    size_t bytes = (size_t)(skv_row_padded_end(rows->row_end[rows->first]) - begin) * sizeof(float);
    const skv_row_sums *next = &rows->next;
    float *sums[ROW_SUMS] = {next->density, next->near_density, next->gradient_x, next->gradient_y,
                             next->lightness};
    for (int a = 0; a < (skv_is_massive(rows) ? ROW_SUMS : ROW_SUMS - 1); a++)
        memset(sums[a] + begin, 0, bytes);
}

void skv_row_begin(skv_row_worker *w)
{
    skv_rows *rows = w->shared->rows;
    w->first = w->own->first;
    w->last = w->own->end - 1;
    w->lower = neighbour(rows, w->thread, -1);
    w->upper = neighbour(rows, w->thread, 1);
    w->iteration = 0;
    if (w->first <= w->last && w->lower < 0)
        clear_lowest(rows);
}

/* Where a thread keeps a row's pairs: the last row's, which come first, beside those of two rows in
 * turn. */
static skv_row_kept *kept_of(const skv_row_worker *w, int row)
{
    return &w->own->kept[row == w->last ? ROW_KEPT_SLOTS - 1 : row & 1];
}

/* The same for its wall samples: the last row is sampled early, the first row's may be needed last,
 * and between the sampling of a row and its update come those of the next two. */
static skv_row_samples *samples_of(const skv_row_worker *w, int row)
{
    int slot = row == w->first  ? ROW_SAMPLE_SLOTS - 1
               : row == w->last ? ROW_SAMPLE_SLOTS - 2
                                : row % (ROW_SAMPLE_SLOTS - 2);
    return &w->own->samples[slot];
}

void skv_row_sample(const skv_row_worker *w, int row)
{
    if (!owns(w, row))
        return;
    const skv_row_run *shared = w->shared;
    skv_row_samples *samples = samples_of(w, row);
    shared->kernels->sample(shared->rows, row, shared->constants, shared->boundary, samples);
    shared->rows->row_walls[row] = samples->used;
    if (row == w->first)
        reach(w, FIRST_SAMPLED);
}

void skv_row_density(const skv_row_worker *w, int row)
{
    if (!owns(w, row))
        return;
    const skv_row_run *shared = w->shared;
    bool later = w->iteration > 0;
    if (row == w->last)
        await(w, w->upper, FIRST_SAMPLED);
    if (!later)
        skv_rows_find_ranges(shared->rows, row);
    shared->kernels->density(shared->rows, row, later, shared->constants, shared->boundary,
                             kept_of(w, row));
    if (row == w->last)
        reach(w, LAST_SUMMED);
}

void skv_row_pressure(const skv_row_worker *w, int row)
{
    if (!owns(w, row))
        return;
    const skv_row_run *shared = w->shared;
    if (row == w->first)
        await(w, w->lower, LAST_SUMMED);
    shared->kernels->pressure(shared->rows, row, w->iteration > 0, shared->constants,
                              shared->boundary, samples_of(w, row));
    if (row == w->first)
        reach(w, FIRST_PRESSED);
}

void skv_row_displacement(const skv_row_worker *w, int row)
{
    if (!owns(w, row))
        return;
    const skv_row_run *shared = w->shared;
    if (row == w->last)
        await(w, w->upper, FIRST_PRESSED);
    shared->kernels->displacement(shared->rows, row, w->iteration > 0, shared->constants,
                                  shared->boundary, kept_of(w, row));
    if (w->iteration == 0 && skv_is_massive(shared->rows))
        skv_rows_turn_unlike(shared->rows, row, shared->constants, shared->boundary);
    if (w->iteration == 0 && skv_has_pushed(shared->rows))
        skv_rows_push_unlike(shared->rows, row, shared->boundary);
    if (row == w->last)
        reach(w, LAST_DISPLACED);
}

static void update(const skv_row_worker *w, int row)
{
    const skv_row_run *shared = w->shared;
    shared->kernels->update(shared->rows, row, w->iteration, shared->constants, shared->boundary,
                            samples_of(w, row), &w->own->walls);
}

static bool is_at_seam(const skv_row_worker *w, int row)
{
    return row == w->first && w->lower >= 0;
}

void skv_row_update(const skv_row_worker *w, int row)
{
    if (owns(w, row) && !is_at_seam(w, row))
        update(w, row);
}

void skv_row_update_at_seam(const skv_row_worker *w)
{
    if (!owns(w, w->first) || !is_at_seam(w, w->first))
        return;
    await(w, w->lower, LAST_DISPLACED);
    update(w, w->first);
}

void skv_row_end_iteration(skv_row_worker *w)
{
    reach(w, FIRST_UPDATED);
    w->turn++;
    w->iteration++;
}
