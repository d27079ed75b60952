/* The grid and the lists. Invariant: start[i] .. start[i+1] bounds particle i's list, and
 * start[count] never exceeds list_capacity. */
#include "solver/reference/neighbours.h"

#include "base/arrays.h"
#include "base/memory.h"

#include <string.h>

enum { MIN_LIST_PER_PARTICLE = 48, MAX_CELLS = 1 << 26 };

skv_result skv_neighbours_create(skv_neighbours *n, float x0, float y0, float x1, float y1, float h,
                                 const skv_boundary *boundary, skv_error *error)
{
    memset(n, 0, sizeof *n);
    n->origin_x = x0;
    n->origin_y = y0;
    n->inv_cell = 1 / h;
    n->boundary = boundary;
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
    skv_free(n->particle_block);
    skv_free(n->list_block);
    memset(n, 0, sizeof *n);
}

static skv_result reserve_particles(skv_neighbours *n, int count, skv_error *error)
{
    int capacity = count > 2 * n->particle_capacity ? count : 2 * n->particle_capacity;
    size_t room = (size_t)capacity;
    const skv_array arrays[] = {
        SKV_ARRAY(n->sorted, room, 0),
        SKV_ARRAY(n->cell, room, 0),
        SKV_ARRAY(n->start, room + 1, 0),
    };
    if (!skv_arrays_grow(&n->particle_block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
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
    const skv_array list = SKV_ARRAY(n->list, (size_t)needed, 0);
    if (!skv_arrays_grow(&n->list_block, &list, 1))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for neighbour lists");
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

static void sort_into_cells(skv_neighbours *n, const float *x, const float *y, int count)
{
    int cells = n->columns * n->rows;
    memset(n->cell_start, 0, ((size_t)cells + 1) * sizeof *n->cell_start);
    for (int i = 0; i < count; i++) {
        int column = cell_along(x[i], n->origin_x, n->inv_cell, n->columns);
        int row = cell_along(y[i], n->origin_y, n->inv_cell, n->rows);
        n->cell[i] = row * n->columns + column;
        n->cell_start[n->cell[i] + 1]++;
    }
    for (int c = 0; c < cells; c++)
        n->cell_start[c + 1] += n->cell_start[c];
    /* Filling from the back turns each end into a start and keeps a cell's indices ascending. */
    for (int i = count - 1; i >= 0; i--)
        n->sorted[--n->cell_start[n->cell[i] + 1]] = i;
    memmove(n->cell_start, n->cell_start + 1, (size_t)cells * sizeof *n->cell_start);
    n->cell_start[cells] = count;
}

/* Walks the candidates of particle i in the three rows of three cells around it, and writes those
 * within the radius to its list, as long as it finds room. Returns their number. */
static int gather(skv_neighbours *n, const float *x, const float *y, float h_squared, int i)
{
    /* Asked each time: walls that are drawn come and go. */
    const skv_boundary *thin =
        n->boundary && skv_boundary_has_thin(n->boundary) ? n->boundary : NULL;
    int column = n->cell[i] % n->columns, row = n->cell[i] / n->columns;
    int first = column > 0 ? column - 1 : 0;
    int last = column + 1 < n->columns ? column + 1 : column;
    int found = 0, room = n->list_capacity - n->start[i], *list = n->list + n->start[i];
    for (int r = row > 0 ? row - 1 : 0; r <= row + 1 && r < n->rows; r++) {
        int begin = n->cell_start[r * n->columns + first];
        int end = n->cell_start[r * n->columns + last + 1];
        for (int k = begin; k < end; k++) {
            int j = n->sorted[k];
            float dx = x[j] - x[i], dy = y[j] - y[i];
            bool near = (dx * dx + dy * dy < h_squared) & (j != i);
            if (thin)
                near = near && !skv_boundary_occluded(thin, x[i], y[i], 0, x[j], y[j], 0);
            /* Who is not near is written over: no processor can guess who is. */
            if (found < room)
                list[found] = j;
            found += near;
        }
    }
    return found;
}

void skv_neighbours_build(skv_neighbours *n, const float *x, const float *y, int count, float h)
{
    if (count == 0)
        return;
    sort_into_cells(n, x, y, count);
    n->start[0] = 0;
    int64_t wanted = 0;
    for (int i = 0; i < count; i++) {
        int length = gather(n, x, y, h * h, i);
        wanted += length;
        bool fits = length <= n->list_capacity - n->start[i];
        n->start[i + 1] = n->start[i] + (fits ? length : 0);
    }
    n->wanted = wanted < INT32_MAX / 2 ? (int)wanted : INT32_MAX / 2;
}
