/* Sorting particles into rows and cells: a stable counting sort on all threads.
 *
 * Each thread counts the particles of its old rows per cell, the counts become places (row by row,
 * cell by cell, thread by thread), and each thread moves its particles there. Threads own
 * consecutive old rows, so within a cell the old order is kept: the result does not depend on how
 * many threads there are. Invariant afterwards: rows begin at multiples of eight and end with at
 * least eight dummies that lie far away, so that blocks of eight need no masks at range ends.
 */
#include "solver/direction.h"
#include "solver/rows/rows_internal.h"

#include <string.h>

/* A coordinate's cell; the comparisons also catch a NaN. */
static int cell_of(float position, int first, int last)
{
    if (!(position > (float)first))
        return first;
    return position < (float)last ? (int)position : last;
}

static void count_cells(skv_rows *rows, skv_row_thread *own)
{
    const skv_row_particles *p = &rows->set[rows->current];
    const int last_cell = rows->cells_used - 1, last_row = rows->row_count - ROW_MARGIN - 1;
    for (int row = own->old_first; row < own->old_end; row++) {
        for (int i = rows->row_start[row]; i < rows->row_end[row]; i++) {
            float x = (p->x[i] + (float)ROW_MARGIN) * (float)ROW_CELLS;
            float y = p->y[i] + (float)ROW_MARGIN;
            int cell = cell_of(x, ROW_CELLS, last_cell), to = cell_of(y, 1, last_row);
            rows->key[i] = to * rows->stride + cell;
            own->histogram[rows->key[i]]++;
        }
    }
}

/* Adds up rows first..end-1 over the threads. */
static void count_rows(skv_rows *rows, int first, int end)
{
    for (int row = first; row < end; row++) {
        int size = 0;
        for (int t = 0; t < rows->threads; t++) {
            const int *counts = rows->thread[t].histogram + (size_t)row * (size_t)rows->stride;
            for (int c = 0; c < rows->cells_used; c++)
                size += counts[c];
        }
        rows->row_size[row] = size;
    }
}

/* Lays out the rows and cuts them into one share a thread, equal in particles. */
static void lay_out_rows(skv_rows *rows)
{
    int place = ROW_LANES;
    rows->first = rows->row_count;
    rows->end = 0;
    rows->widest = 0;
    for (int row = 0; row < rows->row_count; row++) {
        int size = rows->row_size[row];
        rows->new_start[row] = place;
        rows->new_end[row] = place + size;
        place = skv_row_padded_end(place + size);
        if (size) {
            rows->first = rows->first < row ? rows->first : row;
            rows->end = row + 1;
            rows->widest = rows->widest > size ? rows->widest : size;
        }
    }
    int row = rows->first;
    int64_t before = 0;
    for (int t = 0; t < rows->threads; t++) {
        int64_t share = (int64_t)rows->count * (t + 1) / rows->threads;
        rows->thread[t].first = row;
        while (row < rows->end && before + rows->row_size[row] / 2 < share)
            before += rows->row_size[row++];
        if (t == rows->threads - 1)
            row = rows->end;
        rows->thread[t].end = row;
    }
}

/* Turns the counts of a row's cells into places, thread by thread. */
static void place_cells(skv_rows *rows, int row)
{
    size_t offset = (size_t)row * (size_t)rows->stride;
    int *start = rows->cell_start + offset, place = rows->new_start[row];
    for (int c = 0; c < rows->cells_used; c++) {
        start[c] = place;
        for (int t = 0; t < rows->threads; t++) {
            int *count = rows->thread[t].histogram + offset + c, size = *count;
            *count = place;
            place += size;
        }
    }
    for (int c = rows->cells_used; c < rows->stride; c++)
        start[c] = place;
}

static void move_particles(skv_rows *rows, skv_row_thread *own)
{
    const skv_row_particles *from = &rows->set[rows->current], *to = &rows->set[!rows->current];
    for (int row = own->old_first; row < own->old_end; row++) {
        for (int i = rows->row_start[row]; i < rows->row_end[row]; i++) {
            int key = rows->key[i], place = own->histogram[key]++;
            to->x[place] = from->x[i];
            to->y[place] = from->y[i];
            to->u[place] = from->u[i];
            to->v[place] = from->v[i];
            to->clear[place] = from->clear[i];
            to->number[place] = from->number[i];
            rows->cell[place] = (uint16_t)(key % rows->stride);
        }
    }
}

static void put_dummies(skv_rows *rows, int row)
{
    const skv_row_particles *p = &rows->set[!rows->current];
    for (int i = rows->new_end[row]; i < skv_row_padded_end(rows->new_end[row]); i++) {
        p->x[i] = p->y[i] = p->clear[i] = ROW_FAR;
        p->u[i] = p->v[i] = 0;
        rows->cell[i] = 0;
    }
}

/* Particles in exactly one place would stay together for ever: the pair has no direction. The later
 * one is put a thousandth of h aside. */
static void part_coincident(skv_rows *rows, int row)
{
    const skv_row_particles *p = &rows->set[rows->current];
    for (int i = rows->row_start[row]; i < rows->row_end[row]; i++) {
        for (int j = i + 1; j < rows->row_end[row] && rows->cell[j] == rows->cell[i]; j++) {
            if (p->x[i] != p->x[j] || p->y[i] != p->y[j])
                continue;
            float ux, uy;
            skv_made_up_direction((uint32_t)p->number[i], (uint32_t)p->number[j], &ux, &uy);
            p->x[j] += 1e-3f * ux;
            p->y[j] += 1e-3f * uy;
            p->clear[j] -= 1e-3f;
        }
    }
}

static int share_of(int count, int thread, int threads)
{
    return (int)((int64_t)count * thread / threads);
}

void skv_rows_sort(skv_rows *rows, int thread, bool first, skv_pool *pool)
{
    skv_row_thread *own = &rows->thread[thread];
    int from = share_of(rows->row_count, thread, rows->threads);
    int to = share_of(rows->row_count, thread + 1, rows->threads);
    count_cells(rows, own);
    skv_pool_barrier(pool);
    count_rows(rows, from, to);
    skv_pool_barrier(pool);
    if (thread == 0)
        lay_out_rows(rows);
    skv_pool_barrier(pool);
    for (int row = from; row < to; row++)
        place_cells(rows, row);
    skv_pool_barrier(pool);
    move_particles(rows, own);
    for (int row = from; row < to; row++)
        put_dummies(rows, row);
    skv_pool_barrier(pool);
    for (int t = 0; t < rows->threads; t++)
        memset(rows->thread[t].histogram + (size_t)from * (size_t)rows->stride, 0,
               (size_t)(to - from) * (size_t)rows->stride * sizeof(int));
    own->old_first = own->first;
    own->old_end = own->end;
    if (thread == 0) {
        int *swap = rows->row_start;
        rows->row_start = rows->new_start;
        rows->new_start = swap;
        swap = rows->row_end;
        rows->row_end = rows->new_end;
        rows->new_end = swap;
        rows->current = !rows->current;
    }
    skv_pool_barrier(pool);
    if (first) {
        for (int row = own->first; row < own->end; row++)
            part_coincident(rows, row);
        skv_pool_barrier(pool);
    }
}
