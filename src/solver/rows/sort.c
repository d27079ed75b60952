/* Sorting particles into rows and cells: a stable counting sort on all threads.
 *
 * Each thread counts the particles of its old rows per cell, the counts become places (row by row,
 * cell by cell, thread by thread), and each thread moves its particles there. Threads own
 * consecutive old rows, so within a cell the old order is kept: the result does not depend on how
 * many threads there are. Invariant afterwards: rows begin at multiples of eight and end with at
 * least eight dummies that lie far away, so that blocks of eight need no masks at range ends.
 */
#include "base/simd.h"
#include "solver/direction.h"
#include "solver/rows/rows_internal.h"

#include <string.h>

/* What one thing costs in the pair passes, for cutting the rows into equal shares: a block of four
 * by eight pairs, a particle, a particle near a wall. Measured; only the balance depends on it. */
enum { BLOCK_COST = 3, PARTICLE_COST = 1, WALL_COST = 10 };

/* A coordinate's cell; the comparisons also catch a NaN. */
static int cell_of(float position, int first, int last)
{
    if (!(position > (float)first))
        return first;
    return position < (float)last ? (int)position : last;
}

/* The cell within its row of a particle at x. */
static int column_of(const skv_rows *rows, float x)
{
    return cell_of((x + (float)ROW_MARGIN) * (float)ROW_CELLS, ROW_CELLS, rows->cells_used - 1);
}

static int *histogram_row(const skv_rows *rows, int thread, int row)
{
    return rows->thread[thread].histogram + (size_t)row * (size_t)rows->stride;
}

/* Whether a thread has counted particles in a row. Most have gone nowhere, so for nearly all rows
 * that is one thread. */
static bool has_counted(const skv_rows *rows, int thread, int row)
{
    return rows->thread[thread].lowest <= row && row <= rows->thread[thread].highest;
}

static void count_cells(skv_rows *rows, skv_row_thread *own)
{
    const skv_row_particles *p = &rows->set[rows->current];
    const int last_row = rows->row_count - ROW_MARGIN - 1;
    int lowest = rows->row_count, highest = -1;
    for (int row = own->old_first; row < own->old_end; row++) {
        for (int i = rows->row_start[row]; i < rows->row_end[row]; i++) {
            int to = cell_of(p->y[i] + (float)ROW_MARGIN, 1, last_row);
            lowest = to < lowest ? to : lowest;
            highest = to > highest ? to : highest;
            rows->key[i] = to * rows->stride + column_of(rows, p->x[i]);
            own->histogram[rows->key[i]]++;
        }
    }
    own->lowest = lowest;
    own->highest = highest;
}

/* Adds up the cells of the rows that a thread has counted in. */
static void count_rows(const skv_rows *rows, const skv_row_thread *own)
{
    for (int row = own->lowest; row <= own->highest; row++) {
        const int *counts = own->histogram + (size_t)row * (size_t)rows->stride;
        int size = 0;
        for (int c = 0; c < rows->stride; c++)
            size += counts[c];
        own->row_size[row] = size;
    }
}

static int size_of(const skv_rows *rows, int row)
{
    int size = 0;
    for (int t = 0; t < rows->threads; t++)
        size += has_counted(rows, t, row) ? rows->thread[t].row_size[row] : 0;
    return size;
}

/* What a row is likely to cost: what it had to do in the last substep, and its particles now. */
static int cost_of(const skv_rows *rows, int row)
{
    int walls = rows->row_walls[row] > 0 ? rows->row_walls[row] : 0;
    return BLOCK_COST * rows->row_blocks[row] + PARTICLE_COST * rows->row_size[row] +
           WALL_COST * walls;
}

/* Cuts the rows into one share a thread, about equal in cost. */
static void share_out(skv_rows *rows)
{
    int64_t total = 0, before = 0;
    for (int row = rows->first; row < rows->end; row++)
        total += cost_of(rows, row);
    int row = rows->first;
    for (int t = 0; t < rows->threads; t++) {
        int64_t share = total * (t + 1) / rows->threads;
        rows->thread[t].first = row;
        while (row < rows->end && before + cost_of(rows, row) / 2 < share)
            before += cost_of(rows, row++);
        if (t == rows->threads - 1)
            row = rows->end;
        rows->thread[t].end = row;
    }
}

static void lay_out_rows(void *context)
{
    skv_rows *rows = context;
    int place = ROW_LANES;
    rows->first = rows->row_count;
    rows->end = 0;
    for (int row = 0; row < rows->row_count; row++) {
        int size = rows->row_size[row] = size_of(rows, row);
        rows->new_start[row] = place;
        rows->new_end[row] = place + size;
        place = skv_row_padded_end(place + size);
        if (size) {
            rows->first = rows->first < row ? rows->first : row;
            rows->end = row + 1;
        } else {
            rows->row_blocks[row] = rows->row_walls[row] = 0;
        }
    }
    share_out(rows);
}

/* Turns the counts of a row's cells into places, thread by thread; eight empty cells at a time. */
static void place_cells(skv_rows *rows, int row)
{
    int *start = rows->cell_start + (size_t)row * (size_t)rows->stride;
    int place = rows->new_start[row], *counts[ROW_MAX_THREADS], counted = 0;
    for (int t = 0; t < rows->threads; t++)
        if (has_counted(rows, t, row))
            counts[counted++] = histogram_row(rows, t, row);
    for (int c = 0; c < rows->stride; c += ROW_LANES) {
        int any = 0;
        for (int t = 0; t < counted; t++)
            for (int k = 0; k < ROW_LANES; k++)
                any |= counts[t][c + k];
        for (int k = 0; k < ROW_LANES; k++)
            start[c + k] = place;
        for (int k = 0; any && k < ROW_LANES; k++) {
            start[c + k] = place;
            for (int t = 0; t < counted; t++) {
                int size = counts[t][c + k];
                counts[t][c + k] = place;
                place += size;
            }
        }
    }
}

static void move_particles(skv_rows *rows, skv_row_thread *own)
{
    const skv_row_particles *from = &rows->set[rows->current], *to = &rows->set[!rows->current];
    const bool massive = skv_is_massive(rows), dragged = rows->dragged;
    for (int row = own->old_first; row < own->old_end; row++) {
        for (int i = rows->row_start[row]; i < rows->row_end[row]; i++) {
            int place = own->histogram[rows->key[i]]++;
            to->x[place] = from->x[i];
            to->y[place] = from->y[i];
            to->u[place] = from->u[i];
            to->v[place] = from->v[i];
            to->clearance[place] = from->clearance[i];
            to->warm_lambda[place] = from->warm_lambda[i];
            to->number[place] = from->number[i];
            if (massive)
                to->lightness[place] = from->lightness[i];
            if (dragged)
                to->drag[place] = from->drag[i];
        }
    }
    if (own->lowest <= own->highest)
        memset(own->histogram + (size_t)own->lowest * (size_t)rows->stride, 0,
               (size_t)(own->highest - own->lowest + 1) * (size_t)rows->stride * sizeof(int));
}

static void put_dummies(skv_rows *rows, int row)
{
    const skv_row_particles *p = &rows->set[!rows->current];
    for (int i = rows->new_end[row]; i < skv_row_padded_end(rows->new_end[row]); i++) {
        p->x[i] = p->y[i] = p->clearance[i] = ROW_FAR;
        p->u[i] = p->v[i] = 0;
        p->warm_lambda[i] = ROW_FAR; /* nobody looks for a gradient because of them */
        if (skv_is_massive(rows))
            p->lightness[i] = 1;
        if (rows->dragged)
            p->drag[i] = 0;
    }
}

/* After how many of a row's particles one of the same cell may still come. */
static int farthest_in_cell(const skv_rows *rows, const int *start)
{
    int most = 0;
    for (int c = 0; c < rows->cells_used; c++)
        most = start[c + 1] - start[c] > most ? start[c + 1] - start[c] : most;
    return most - 1;
}

/* Whether one of eight particles, whose x these are, may lie where one of the `most` after it does.
 * Who is a millionth of h apart does not. */
static bool may_coincide(const float *x, int most)
{
    v8 least = v8_set(1), own = v8_load(x);
    for (; most > 0; most--) {
        v8 way = v8_sub(v8_load(x + most), own);
        least = v8_min(least, v8_mul(way, way));
    }
    return v8_any_below(least, v8_set(1e-12f));
}

/* Particles in exactly one place would stay together for ever: the pair has no direction. The later
 * one is put a thousandth of h aside, to whichever side leaves it in its cell. */
void skv_rows_separate_coincident(skv_rows *rows, int row)
{
    const skv_row_particles *p = &rows->set[rows->current];
    const int *start = rows->cell_start + (size_t)row * (size_t)rows->stride;
    const int end = rows->row_end[row], most = farthest_in_cell(rows, start);
    for (int i = rows->row_start[row]; i < end; i++) {
        /* Eight at once; but behind the end dummies lie in one place. */
        while (i % ROW_LANES == 0 && i + ROW_LANES + most < end && !may_coincide(p->x + i, most))
            i += ROW_LANES;
        int cell = column_of(rows, p->x[i]);
        for (int j = i + 1; j < start[cell + 1]; j++) {
            if (p->x[i] != p->x[j] || p->y[i] != p->y[j])
                continue;
            float ux, uy;
            skv_fallback_direction((uint32_t)p->number[i], (uint32_t)p->number[j], &ux, &uy);
            float moved = p->x[j] + 1e-3f * ux;
            p->x[j] = column_of(rows, moved) == cell ? moved : p->x[j] - 1e-3f * ux;
            p->y[j] += 1e-3f * uy;
            p->clearance[j] -= 1e-3f;
        }
    }
}

void skv_rows_turn_over(skv_rows *rows)
{
    int *swap = rows->row_start;
    rows->row_start = rows->new_start;
    rows->new_start = swap;
    swap = rows->row_end;
    rows->row_end = rows->new_end;
    rows->new_end = swap;
    rows->current = !rows->current;
    skv_rows_lend_buffers(rows);
}

void skv_rows_sort(skv_rows *rows, int thread, skv_pool *pool)
{
    skv_row_thread *own = &rows->thread[thread];
    count_cells(rows, own);
    count_rows(rows, own);
    skv_pool_gather(pool, lay_out_rows, rows);
    /* The empty row after the last is looked into as well. */
    int end = thread == rows->threads - 1 ? own->end + 1 : own->end;
    for (int row = own->first; row < end; row++)
        place_cells(rows, row);
    skv_pool_barrier(pool);
    move_particles(rows, own);
    for (int row = own->first; row < end; row++)
        put_dummies(rows, row);
    own->old_first = own->first;
    own->old_end = own->end;
}

void skv_rows_find_ranges(skv_rows *rows, int row)
{
    const skv_row_particles *p = &rows->set[rows->current];
    const int *own = rows->cell_start + (size_t)row * (size_t)rows->stride;
    const int *next = own + rows->stride;
    int end = rows->row_end[row], blocks = 0;
    for (int i = rows->row_start[row]; i < end; i += ROW_TILE) {
        int last = i + ROW_TILE - 1 < end ? i + ROW_TILE - 1 : end - 1, tile = i / ROW_TILE;
        int from = column_of(rows, p->x[i]) - ROW_CELLS;
        int to = column_of(rows, p->x[last]) + ROW_CELLS + 1;
        rows->own_end[tile] = own[to];
        rows->next_begin[tile] = next[from];
        rows->next_end[tile] = next[to];
        int ahead = rows->own_end[tile] - (i + 1);
        blocks += 1 + (ahead > ROW_LANES ? (ahead - 1) / ROW_LANES : 0) +
                  (rows->next_end[tile] - rows->next_begin[tile] + ROW_LANES - 1) / ROW_LANES;
    }
    rows->row_blocks[row] = blocks;
}
