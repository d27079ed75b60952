/* The passes of an iteration, each over one row of the calling thread, in step with the threads
 * that own the rows next to its own.
 *
 * Who may run when, for row R of one iteration (W walls, A density, L pressure, B displacement, U
 * update): A(R) needs W(R) and W(R+1); L(R) needs A(R) and A(R-1); B(R) needs L(R) and L(R+1); U(R)
 * needs B(R) and B(R-1), and moves what A and B of rows R and R-1 read. Within a thread's rows the
 * caller's order sees to that. At the seam between two threads the lower one needs W of the upper
 * one's first row, and the upper one A of the lower one's last row, so these are run before the
 * rest; the lower one needs L of the upper one's first row; and the upper one's first row is
 * updated after B of the lower one's last. A thread waits for its two neighbours only, and only
 * there: they may be at work on different iterations.
 *
 * Invariant: every order that these rules allow gives the same bits.
 */
#ifndef SKV_ROWS_PIPELINE_H
#define SKV_ROWS_PIPELINE_H

#include "solver/rows/rows_internal.h"

/* A call of skv_rows_step: what its threads share. */
typedef struct skv_row_run {
    skv_rows *rows;
    const skv_row_kernels *kernels;
    const skv_constants *constants;
    const skv_boundary *boundary;
    skv_pool *pool;
    const skv_row_frame *frame;
    int substeps;
    int to_take; /* substeps that have not begun to relax */
    skv_progress progress[ROW_MAX_THREADS];
} skv_row_run;

/* One of the threads, at its rows. */
typedef struct skv_row_worker {
    skv_row_run *shared;
    skv_row_thread *own;
    int thread;
    int first, last;  /* its rows; none if last < first */
    int lower, upper; /* the threads that own the rows below and above, or -1 */
    int iteration;
    unsigned turn; /* iterations since the team began */
} skv_row_worker;

/* Before the iterations of a substep, when the rows have been shared out. */
void skv_row_begin(skv_row_worker *worker);

/* The passes. A row that is not the worker's is left alone. Order: W of the first and of the last
 * row, A of the last row; then for each row R from the first to one after the last W(R+1) and A(R)
 * but for the last, L(R), B(R-1), U(R-1); then the update at the seam. The first row's U is left to
 * the latter where there is a seam below it. */
void skv_row_sample(const skv_row_worker *worker, int row);
void skv_row_density(const skv_row_worker *worker, int row);
void skv_row_pressure(const skv_row_worker *worker, int row);
void skv_row_displacement(const skv_row_worker *worker, int row);
void skv_row_update(const skv_row_worker *worker, int row);
void skv_row_update_at_seam(const skv_row_worker *worker);

/* After an iteration. */
void skv_row_end_iteration(skv_row_worker *worker);

#endif
