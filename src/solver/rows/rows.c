/* How a fluid moves, by rows: a call of the solver in substeps, and a substep as a list of passes.
 * Invariant: the result does not depend on how many threads take the steps. */
#include "base/platform.h"
#include "solver/rows/pipeline.h"
#include "solver/rows/solids.h"

#include <string.h>

/* Books the time since `*start` under a phase, on one thread only. */
static void book(skv_rows *rows, int thread, int phase, double *start)
{
    if (thread != 0)
        return;
    double now = skv_clock();
    rows->seconds[phase] += now - *start;
    *start = now;
}

static void advance(const skv_row_worker *w, int row)
{
    const skv_row_run *shared = w->shared;
    shared->kernels->advance(shared->rows, row, shared->constants, shared->boundary,
                             &w->own->walls);
}

/* What one thread does when all have sorted. */
static void begin_relaxation(void *context)
{
    skv_row_run *shared = context;
    skv_rows_turn_over(shared->rows);
    shared->rows->gauged = --shared->to_take == 0;
    skv_pool_asks_to_stop(shared->pool); /* after this substep */
}

static void sort(const skv_row_worker *w, bool first)
{
    skv_row_run *shared = w->shared;
    skv_rows_sort(shared->rows, w->thread, shared->pool);
    skv_pool_gather(shared->pool, begin_relaxation, shared);
    if (!first)
        return;
    for (int row = w->own->first; row < w->own->end; row++)
        skv_rows_separate_coincident(shared->rows, row);
    skv_pool_barrier(shared->pool);
}

/* A substep on one of the threads: the passes in the order in which a row goes through them. The
 * rows follow each other closely, so that what a pass has found is still in the cache for the next
 * one; a row is displaced one row later than its pressure is found, because that needs the pressure
 * of the row above. How threads keep out of each other's way is in pipeline.h. */
static void take_substep(skv_row_worker *w, bool first)
{
    skv_rows *rows = w->shared->rows;
    double start = skv_clock();
    for (int row = w->own->old_first; row < w->own->old_end; row++)
        advance(w, row); /* external forces, speed limit, x += v dt: Algorithms 2 and 4 */
    book(rows, w->thread, ROW_ADVANCE, &start);
    sort(w, first); /* into rows and cells, whose order names the neighbours: Algorithm 5 */
    book(rows, w->thread, ROW_SORT, &start);
    skv_row_begin(w);
    while (w->iteration < w->shared->constants->iterations) { /* Algorithm 6 */
        skv_row_sample(w, w->first);
        if (w->last > w->first)
            skv_row_sample(w, w->last);
        skv_row_density(w, w->last);
        for (int row = w->first; row <= w->last + 1; row++) {
            if (row + 1 < w->last)
                skv_row_sample(w, row + 1); /* what the walls are to them */
            if (row != w->last)
                skv_row_density(w, row);      /* densities, gradient */
            skv_row_pressure(w, row);         /* P and N */
            skv_row_displacement(w, row - 1); /* pairs part or attract each other; tension;
                                                 viscosity: Algorithm 3 */
            skv_row_update(w, row - 1);       /* walls push; x and v change; contact, at last:
                                                 Algorithms 7 and 8 */
        }
        skv_row_update_at_seam(w);
        skv_row_end_iteration(w);
    }
    book(rows, w->thread, ROW_RELAX, &start);
}

/* One thread's part of a call. */
static void member(int thread, int threads, void *context)
{
    skv_row_run *shared = context;
    skv_rows *rows = shared->rows;
    if (thread == 0)
        rows->threads = threads;
    skv_pool_barrier(shared->pool);
    skv_row_worker w = {.shared = shared, .own = &rows->thread[thread], .thread = thread};
    w.own->walls = (skv_row_given){0};
    double start = skv_clock();
    skv_rows_load(rows, thread, shared->frame, shared->constants->viscosity_linear,
                  shared->boundary);
    book(rows, thread, ROW_TRANSFER, &start);
    for (int s = 0; s < shared->substeps && !skv_pool_is_stopped(shared->pool); s++)
        take_substep(&w, s == 0);
    start = skv_clock();
    skv_pool_barrier(shared->pool);
    skv_rows_note_places(rows, thread);
    skv_pool_barrier(shared->pool);
    skv_rows_store(rows, thread, shared->frame);
    book(rows, thread, ROW_TRANSFER, &start);
}

/* Adds what has been booked for a reaction to it, in its units. */
static void tell(skv_reaction *reaction, const skv_impulse_sum *boxed, double h)
{
    skv_impulse given = skv_impulse_value(boxed);
    reaction->dx += given.x * h;
    reaction->dy += given.y * h;
    reaction->moment += given.moment * h * h;
}

skv_impulse skv_rows_step(skv_rows *rows, const skv_row_frame *frame, int substeps,
                          const skv_constants *constants, const skv_row_acting *acting,
                          const skv_boundary *boundary, skv_pool *pool, skv_reaction *reaction,
                          skv_impulse *solid_given)
{
    if (frame->count == 0)
        return (skv_impulse){0};
    rows->held = frame->part != NULL;
    rows->massive = frame->mass != NULL;
    rows->frame = frame;
    rows->dragged = frame->viscous;
    rows->various = frame->viscous && frame->drag;
    rows->acting = *acting;
    rows->reaction = reaction;
    skv_row_run shared = {.rows = rows,
                          .kernels = rows->kernels,
                          .constants = constants,
                          .boundary = boundary,
                          .pool = pool,
                          .frame = frame,
                          .substeps = substeps,
                          .to_take = frame->pressure ? substeps : 0};
    skv_pool_team(pool, member, &shared);
    skv_row_given walls = {0};
    for (int t = 0; t < rows->threads; t++) {
        skv_impulse_join(&walls.all, &rows->thread[t].walls.all);
        skv_impulse_join(&walls.boxed, &rows->thread[t].walls.boxed);
    }
    if (solid_given)
        skv_rows_tell_solids(rows, boundary, solid_given);
    if (reaction)
        tell(reaction, &walls.boxed, (double)boundary->unit);
    return skv_impulse_value(&walls.all);
}

void skv_rows_profile(skv_rows *rows, bool reset, double seconds[4])
{
    memcpy(seconds, rows->seconds, sizeof rows->seconds);
    if (reset)
        memset(rows->seconds, 0, sizeof rows->seconds);
}
