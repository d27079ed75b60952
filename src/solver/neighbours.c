/* The grid and the lists. Invariant: start[i] .. start[i+1] bounds particle i's list, and
 * start[count] never exceeds list_capacity. */
#include "solver/neighbours.h"

#include "base/memory.h"

#include <string.h>

enum { MIN_LIST_PER_PARTICLE = 48, MAX_CELLS = 1 << 26 };

skv_result skv_neighbours_create(skv_neighbours *n, float x0, float y0, float x1, float y1, float h,
                                 skv_error *error)
{
    memset(n, 0, sizeof *n);
    n->origin_x = x0;
    n->origin_y = y0;
    n->inv_cell = 1 / h;
    double columns = (double)(x1 - x0) / h + 1, rows = (double)(y1 - y0) / h + 1;
    if (columns * rows > (double)MAX_CELLS)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "the world is too large for a smoothing radius of %g m; use a larger "
                        "spacing",
                        (double)h);
    n->columns = (int)columns;
    n->rows = (int)rows;
    n->cell_start = skv_calloc((size_t)n->columns * n->rows + 1, sizeof *n->cell_start);
    if (!n->cell_start)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the neighbour grid");
    return SKV_OK;
}

void skv_neighbours_destroy(skv_neighbours *n)
{
    skv_free(n->cell_start);
    skv_free(n->sorted);
    skv_free(n->cell);
    skv_free(n->start);
    skv_free(n->list);
    memset(n, 0, sizeof *n);
}

static skv_result reserve_particles(skv_neighbours *n, int count, skv_error *error)
{
    int capacity = count > 2 * n->particle_capacity ? count : 2 * n->particle_capacity;
    int *sorted = skv_calloc((size_t)capacity, sizeof *sorted);
    int *cell = skv_calloc((size_t)capacity, sizeof *cell);
    int *start = skv_calloc((size_t)capacity + 1, sizeof *start);
    if (!sorted || !cell || !start) {
        skv_free(sorted);
        skv_free(cell);
        skv_free(start);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    }
    skv_free(n->sorted);
    skv_free(n->cell);
    skv_free(n->start);
    n->sorted = sorted;
    n->cell = cell;
    n->start = start;
    n->particle_capacity = capacity;
    return SKV_OK;
}

skv_result skv_neighbours_reserve(skv_neighbours *n, int count, skv_error *error)
{
    if (count > n->particle_capacity) {
        skv_result result = reserve_particles(n, count, error);
        if (result != SKV_OK)
            return result;
    }
    int64_t needed = (int64_t)n->wanted + n->wanted / 2;
    if (needed < (int64_t)count * MIN_LIST_PER_PARTICLE)
        needed = (int64_t)count * MIN_LIST_PER_PARTICLE;
    if (needed <= n->list_capacity)
        return SKV_OK;
    if (needed > INT32_MAX / 2)
        needed = INT32_MAX / 2;
    int *list = skv_calloc((size_t)needed, sizeof *list);
    if (!list)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for neighbour lists");
    skv_free(n->list);
    n->list = list;
    n->list_capacity = (int)needed;
    return SKV_OK;
}

/* A coordinate's cell along one axis; the comparisons also catch a NaN. */
static int cell_along(float position, float origin, float inv_cell, int cells)
{
    float f = (position - origin) * inv_cell;
    if (!(f > 0))
        return 0;
    return f < (float)(cells - 1) ? (int)f : cells - 1;
}

static void sort_into_cells(skv_neighbours *n, const skv_state *state)
{
    int cells = n->columns * n->rows;
    memset(n->cell_start, 0, ((size_t)cells + 1) * sizeof *n->cell_start);
    for (int i = 0; i < state->count; i++) {
        int column = cell_along(state->x[i], n->origin_x, n->inv_cell, n->columns);
        int row = cell_along(state->y[i], n->origin_y, n->inv_cell, n->rows);
        n->cell[i] = row * n->columns + column;
        n->cell_start[n->cell[i] + 1]++;
    }
    for (int c = 0; c < cells; c++)
        n->cell_start[c + 1] += n->cell_start[c];
    /* Filling from the back turns each end into a start and keeps a cell's indices ascending. */
    for (int i = state->count - 1; i >= 0; i--)
        n->sorted[--n->cell_start[n->cell[i] + 1]] = i;
    memmove(n->cell_start, n->cell_start + 1, (size_t)cells * sizeof *n->cell_start);
    n->cell_start[cells] = state->count;
}

typedef struct build {
    skv_neighbours *n;
    const skv_state *state;
    float h_squared;
} build;

/* Walks the candidates of particle i in the three rows of three cells around it; stores those
 * within the radius if `out` is given. Returns their number. */
static int gather(const build *b, int i, int *out)
{
    const skv_neighbours *n = b->n;
    const float *restrict x = b->state->x, *restrict y = b->state->y;
    int column = n->cell[i] % n->columns, row = n->cell[i] / n->columns;
    int first = column > 0 ? column - 1 : 0;
    int last = column + 1 < n->columns ? column + 1 : column;
    int found = 0;
    for (int r = row > 0 ? row - 1 : 0; r <= row + 1 && r < n->rows; r++) {
        int begin = n->cell_start[r * n->columns + first];
        int end = n->cell_start[r * n->columns + last + 1];
        for (int k = begin; k < end; k++) {
            int j = n->sorted[k];
            float dx = x[j] - x[i], dy = y[j] - y[i];
            if (!(dx * dx + dy * dy < b->h_squared) || j == i)
                continue;
            if (n->occluded && n->occluded(n->occluded_context, x[i], y[i], x[j], y[j]))
                continue;
            if (out)
                out[found] = j;
            found++;
        }
    }
    return found;
}

static void count_pass(int begin, int end, void *context)
{
    const build *b = context;
    for (int i = begin; i < end; i++)
        b->n->start[i + 1] = gather(b, i, NULL);
}

static void fill_pass(int begin, int end, void *context)
{
    const build *b = context;
    for (int i = begin; i < end; i++) {
        /* An empty range may stem from a cut list: nothing may be written then. */
        if (b->n->start[i + 1] > b->n->start[i])
            gather(b, i, b->n->list + b->n->start[i]);
    }
}

void skv_neighbours_build(skv_neighbours *n, const skv_state *state, float h, skv_pool *pool)
{
    if (state->count == 0)
        return;
    build b = {n, state, h * h};
    sort_into_cells(n, state);
    skv_pool_run(pool, state->count, count_pass, &b);
    n->start[0] = 0;
    int64_t wanted = 0;
    for (int i = 0; i < state->count; i++) {
        int length = n->start[i + 1];
        wanted += length;
        bool fits = (int64_t)n->start[i] + length <= n->list_capacity;
        n->start[i + 1] = n->start[i] + (fits ? length : 0);
    }
    n->wanted = wanted < INT32_MAX / 2 ? (int)wanted : INT32_MAX / 2;
    skv_pool_run(pool, state->count, fill_pass, &b);
}
