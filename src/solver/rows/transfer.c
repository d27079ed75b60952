/* Between the frame's arrays and the sorted ones. Invariant: a thread loads and stores the same
 * particles in every call, so no two write to one cache line of the frame. */
#include "solver/rows/rows_internal.h"

/* Rounding must not make a lower bound of a distance too large. */
#define SAFE_BOUND 0.999f

/* How many provisional rows the particles are loaded into: one a thread, but not so many that their
 * dummies, three blocks each, find no place. */
static int provisional_rows(const skv_rows *rows)
{
    return rows->threads < rows->row_count / 2 ? rows->threads : rows->row_count / 2;
}

/* The first of the frame's particles that a thread loads; the threads after the last load none. */
static int share_begin(const skv_rows *rows, const skv_row_frame *frame, int thread)
{
    int shares = provisional_rows(rows);
    return thread < shares ? (int)((int64_t)frame->count * thread / shares) : frame->count;
}

static int part_of(const skv_row_frame *frame, int i)
{
    return frame->part ? frame->part[i] : SKV_MOVES;
}

/* What moves has fallen by a substep's gravity when its densities are measured, and is lifted again
 * in the iterations. What is held in the same water must not lie higher meanwhile: it would push
 * on what moves above it and part from what moves below, and a pool of which a part falls asleep
 * would ring. So it lies as low as the others do on average; it is not stored. */
static void sink_held(const skv_row_particles *p, int k, const skv_row_frame *frame,
                      const skv_boundary *boundary)
{
    skv_boundary_move(boundary, &p->x[k], &p->y[k], frame->sunk_x, frame->sunk_y, &p->clearance[k]);
}

/* The share is one provisional row, in the order of the particles' numbers; the sort of the first
 * substep, which is stable, puts them where they belong. `sigma`: of who has none of their own. */
void skv_rows_load(skv_rows *rows, int thread, const skv_row_frame *frame, float sigma,
                   const skv_boundary *boundary)
{
    const skv_row_particles *p = &rows->set[rows->current];
    skv_row_thread *own = &rows->thread[thread];
    own->old_first = own->old_end = 0;
    if (thread >= provisional_rows(rows))
        return;
    int from = share_begin(rows, frame, thread), to = share_begin(rows, frame, thread + 1);
    /* A multiple of eight, and dummies enough behind each share. */
    int place = (from & ~(ROW_LANES - 1)) + ROW_LANES * (3 * thread + 1);
    rows->row_start[thread] = place;
    for (int i = from; i < to; i++) {
        int part = part_of(frame, i);
        if (part == SKV_ABSENT)
            continue;
        p->x[place] = frame->x[i] * frame->length;
        p->y[place] = frame->y[i] * frame->length;
        p->u[place] = frame->vx[i] * frame->speed;
        p->v[place] = frame->vy[i] * frame->speed;
        p->clearance[place] = frame->clearance[i] * frame->length;
        p->warm_lambda[place] = frame->warm_lambda[i] * frame->lambda;
        p->number[place] = part == SKV_HELD ? i | ROW_HELD : i;
        if (frame->mass) {
            p->lightness[place] = 1 / frame->mass[i];
            if (frame->viscous)
                p->drag[place] = frame->drag ? frame->drag[i] * frame->dt : frame->mass[i] * sigma;
        }
        if (part == SKV_HELD)
            sink_held(p, place, frame, boundary);
        place++;
    }
    rows->row_end[thread] = place;
    for (int k = place; k < skv_row_padded_end(place); k++) {
        p->x[k] = p->y[k] = p->clearance[k] = ROW_FAR;
        p->u[k] = p->v[k] = p->warm_lambda[k] = 0;
    }
    own->old_first = thread;
    own->old_end = thread + 1;
}

void skv_rows_note_places(const skv_rows *rows, int thread)
{
    const int *number = rows->set[rows->current].number;
    for (int row = rows->thread[thread].first; row < rows->thread[thread].end; row++)
        for (int k = rows->row_start[row]; k < rows->row_end[row]; k++)
            rows->place[number[k] & ~ROW_HELD] = k;
}

/* A thread stores what it has loaded and will load again, not the particles of its rows: else the
 * threads would take the frame's cache lines from each other for each number.
 * Divides by what the load has multiplied with: that gives back the same number but for rounding to
 * either side. The reciprocal is itself rounded, and a product with it would be off to the same
 * side in every frame: momentum would drift. */
void skv_rows_store(const skv_rows *rows, int thread, const skv_row_frame *frame)
{
    const skv_row_particles *p = &rows->set[rows->current];
    int end = share_begin(rows, frame, thread + 1);
    for (int i = share_begin(rows, frame, thread); i < end; i++) {
        if (part_of(frame, i) != SKV_MOVES)
            continue;
        int k = rows->place[i];
        frame->x[i] = p->x[k] / frame->length;
        frame->y[i] = p->y[k] / frame->length;
        frame->vx[i] = p->u[k] / frame->speed;
        frame->vy[i] = p->v[k] / frame->speed;
        frame->clearance[i] = p->clearance[k] / frame->length * SAFE_BOUND;
        frame->warm_lambda[i] = p->warm_lambda[k] / frame->lambda;
        if (frame->pressure)
            frame->pressure[i] = rows->pressure[k];
    }
}
