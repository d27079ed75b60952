/* The rows' memory: made before a step, so that a step needs none, and lent from phase to phase.
 *
 * Invariant: what is held follows from the size of the world, the number of particles and that of
 * threads alone, never from what the particles have done; so a step of as many particles on as many
 * threads as the last one allocates nothing.
 */
#include "base/memory.h"
#include "solver/rows/rows_internal.h"

#include <math.h>

enum {
    LINE = 16, /* floats or integers in a cache line */
    LINES_A_PAGE = 64,
    PLACE_ARRAYS = 14 + ROW_SPARE, /* of an element for each place */
    FLOATS_A_BLOCK = ROW_TILE * ROW_LANES,
    ROW_NUMBERS = 9, /* integers kept for each row */
    MAX_CELLS = 1 << 26
};

/* Blocks of pairs to a tile: at rest it has 6 or 7. And a row that is filled half again as much as
 * at rest; twice what a tile has there is room for the crowds of a splash. */
enum { BLOCKS_A_TILE = 12 };
#define CROWDING 1.5

/* The most that a thread keeps. A longer row's pairs would not stay in a cache, where reading them
 * is cheaper than computing them again. */
#define MOST_KEPT ((size_t)8 << 20)

skv_result skv_rows_create(float width, float height, float per_square, skv_instruction_set set,
                           skv_rows **out, skv_error *error)
{
    *out = NULL;
    const skv_row_kernels *kernels = skv_row_kernels_for(set);
    if (!kernels)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "instruction_set: this machine lacks it; its best is %s",
                        skv_row_kernels_for(SKV_ISA_BEST)->isa);
    skv_rows *rows = skv_calloc(1, sizeof *rows);
    if (!rows)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the solver");
    double cells = ceil((double)width * ROW_CELLS) + 2 * ROW_MARGIN * ROW_CELLS + 1;
    double row_count = ceil((double)height) + 2 * ROW_MARGIN + 1;
    if (cells * row_count > MAX_CELLS) {
        skv_free(rows);
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "the world is too large for its smoothing radius; use a larger spacing");
    }
    rows->kernels = kernels;
    rows->cells_used = (int)cells;
    rows->stride = ((int)cells + ROW_CELLS + 2 + ROW_LANES - 1) & ~(ROW_LANES - 1);
    rows->row_count = (int)row_count;
    rows->row_holds = (int)ceil((double)width * (double)per_square);
    size_t in_rows = (size_t)rows->row_count + 2;
    size_t grid = in_rows * (size_t)rows->stride, numbers = grid + ROW_NUMBERS * in_rows;
    int *block = skv_calloc(numbers, sizeof *block);
    if (!block) {
        skv_free(rows);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the solver's grid");
    }
    rows->memory.grid = numbers * sizeof *block;
    rows->grid_block = block;
    rows->cell_start = block;
    int **by_row[] = {&rows->row_start, &rows->row_end,      &rows->new_start,
                      &rows->new_end,   &rows->row_size,     &rows->row_blocks,
                      &rows->row_walls, &rows->graded_begin, &rows->graded_end};
    for (int a = 0; a < ROW_NUMBERS; a++)
        *by_row[a] = block + grid + in_rows * (size_t)a;
    *out = rows;
    return SKV_OK;
}

static void free_threads(skv_rows *rows)
{
    for (int t = 0; t < rows->thread_room; t++)
        skv_free(rows->thread[t].kept_memory);
    skv_free(rows->thread);
    skv_free(rows->histogram_block);
    rows->thread = NULL;
    rows->histogram_block = NULL;
    rows->thread_room = 0;
    rows->memory.histograms = rows->memory.kept = 0;
}

void skv_rows_destroy(skv_rows *rows)
{
    if (!rows)
        return;
    free_threads(rows);
    skv_free(rows->particle_block);
    skv_free(rows->mass_block);
    skv_free(rows->drag_block);
    skv_free(rows->grid_block);
    skv_free(rows);
}

static skv_result reserve_threads(skv_rows *rows, int threads, skv_error *error)
{
    if (threads == rows->thread_room)
        return SKV_OK;
    free_threads(rows);
    size_t cells = (size_t)rows->row_count * (size_t)rows->stride;
    /* A cache line more than it takes, so that no two threads share one. */
    size_t numbers = (cells + (size_t)rows->row_count + 2 * LINE - 1) / LINE * LINE;
    rows->thread = skv_calloc((size_t)threads, sizeof *rows->thread);
    int *histograms = skv_calloc(numbers * (size_t)threads, sizeof *histograms);
    if (!rows->thread || !histograms) {
        skv_free(histograms);
        skv_free(rows->thread);
        rows->thread = NULL;
        skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d threads", threads);
        return SKV_ERROR_MEMORY;
    }
    rows->histogram_block = histograms;
    rows->memory.histograms = numbers * (size_t)threads * sizeof *histograms;
    rows->thread_room = threads;
    for (int t = 0; t < threads; t++) {
        rows->thread[t].histogram = histograms + numbers * (size_t)t;
        rows->thread[t].row_size = rows->thread[t].histogram + cells;
    }
    return SKV_OK;
}

/* The most particles to expect in a row. */
static int fullest_row(const skv_rows *rows)
{
    double most = ceil(CROWDING * rows->row_holds);
    return most < rows->capacity ? (int)most : rows->capacity;
}

/* Room for kept pairs and wall samples; less than wished for costs time, not correctness. */
static skv_result reserve_kept(skv_rows *rows, skv_error *error)
{
    size_t a_block = FLOATS_A_BLOCK * sizeof(float);
    int fullest = fullest_row(rows), apart = fullest + SKV_MOST_PARTS,
        most = (int)(MOST_KEPT / ROW_KEPT_SLOTS / a_block);
    int blocks = (fullest / ROW_TILE + 1) * BLOCKS_A_TILE + 2 * FLOATS_A_BLOCK;
    blocks = blocks < most ? blocks : most;
    for (int t = 0; t < rows->thread_room; t++) {
        skv_row_thread *own = &rows->thread[t];
        if (blocks <= own->kept[0].room && fullest <= own->samples[0].room)
            continue;
        size_t floats = (size_t)blocks * FLOATS_A_BLOCK;
        size_t bytes = ROW_KEPT_SLOTS * floats * sizeof(float) +
                       ROW_SAMPLE_SLOTS * (size_t)apart * sizeof(skv_near_wall);
        float *memory = skv_calloc(bytes, 1);
        if (!memory)
            return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for kept pairs");
        skv_free(own->kept_memory);
        own->kept_memory = memory;
        for (int slot = 0; slot < ROW_KEPT_SLOTS; slot++, memory += floats)
            own->kept[slot] = (skv_row_kept){.pairs = memory, .room = blocks};
        skv_near_wall *samples = (skv_near_wall *)(void *)memory;
        for (int slot = 0; slot < ROW_SAMPLE_SLOTS; slot++, samples += apart)
            own->samples[slot] = (skv_row_samples){samples, fullest, 0};
        rows->memory.kept = (bytes + sizeof own->walls) * (size_t)rows->thread_room;
    }
    return SKV_OK;
}

/* Distance between arrays in one block, in floats. The same place in two arrays must not have the
 * same place in its page, nor nearly: a load would wait for a store to the other, and both would
 * fight for the same cache sets. */
static size_t array_stride(size_t elements)
{
    size_t lines = (elements + LINE - 1) / LINE;
    for (size_t apart = 1; apart < PLACE_ARRAYS; apart++) {
        size_t past = apart * lines % LINES_A_PAGE;
        if (past < 2 || past > LINES_A_PAGE - 2) {
            lines++;
            apart = 0;
        }
    }
    return lines * LINE;
}

static skv_result reserve_particles(skv_rows *rows, int count, skv_error *error)
{
    if (count <= rows->capacity)
        return SKV_OK;
    int more = rows->capacity + rows->capacity / 2, capacity = count > more ? count : more;
    /* A row's dummies and the gap to the next multiple of eight are fewer than two blocks. */
    size_t slots = (size_t)capacity + (size_t)rows->row_count * 2 * ROW_LANES + 4 * ROW_LANES;
    skv_row_particles *a = &rows->set[0], *b = &rows->set[1];
    float **floats[] = {
        &a->x,           &a->y,           &a->u,           &a->v,
        &a->clearance,   &a->warm_lambda, &b->x,           &b->y,
        &b->u,           &b->v,           &b->clearance,   &b->warm_lambda,
        &rows->spare[0], &rows->spare[1], &rows->spare[2], &rows->spare[3],
    };
    int **ints[] = {&a->number, &b->number};
    int **by_tile[] = {&rows->own_end, &rows->next_begin, &rows->next_end};
    enum { FLOATS = sizeof floats / sizeof *floats, INTS = 2, TILE_INTS = 3 };
    size_t stride = array_stride(slots), tiles = array_stride(slots / ROW_TILE + 1);
    /* Flags by eight and by tile. */
    size_t eights = array_stride(slots / ROW_LANES / sizeof(float) + 1);
    size_t fours = array_stride(slots / ROW_TILE / sizeof(float) + 1);
    size_t total = stride * (FLOATS + INTS) + TILE_INTS * tiles + eights + fours;
    float *block = skv_calloc(total, sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    skv_free(rows->particle_block);
    rows->particle_block = block;
    skv_free(rows->mass_block); /* of fewer particles */
    skv_free(rows->drag_block);
    rows->mass_block = rows->drag_block = NULL;
    for (int f = 0; f < FLOATS; f++, block += stride)
        *floats[f] = block;
    for (int i = 0; i < INTS; i++, block += stride)
        *ints[i] = (int *)(void *)block;
    for (int i = 0; i < TILE_INTS; i++, block += tiles)
        *by_tile[i] = (int *)(void *)block;
    rows->graded = (bool *)(void *)block;
    rows->beside = (bool *)(void *)(block + eights);
    rows->capacity = capacity;
    rows->slots = (int)slots;
    rows->memory.particles = total * sizeof *block;
    return SKV_OK;
}

/* Where a world has masses at all, for as many as it has particles. */
static skv_result reserve_masses(skv_rows *rows, skv_error *error)
{
    if (rows->mass_block)
        return SKV_OK;
    enum { FLOATS = 3 };
    size_t stride = array_stride((size_t)rows->slots);
    float *block = skv_calloc(FLOATS * stride, sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the masses of %d particles",
                        rows->capacity);
    rows->mass_block = block;
    rows->set[0].lightness = block;
    rows->set[1].lightness = block + stride;
    rows->spare_lightness = block + 2 * stride;
    rows->memory.particles += FLOATS * stride * sizeof *block;
    return SKV_OK;
}

/* And where these are viscous. */
static skv_result reserve_drags(skv_rows *rows, skv_error *error)
{
    if (rows->drag_block)
        return SKV_OK;
    size_t stride = array_stride((size_t)rows->slots);
    float *block = skv_calloc(2 * stride, sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY,
                        "out of memory for the viscosities of %d particles", rows->capacity);
    rows->drag_block = block;
    rows->set[0].drag = block;
    rows->set[1].drag = block + stride;
    rows->memory.particles += 2 * stride * sizeof *block;
    return SKV_OK;
}

skv_result skv_rows_reserve(skv_rows *rows, int count, int threads, bool masses, bool drags,
                            skv_error *error)
{
    skv_result result = reserve_threads(rows, threads, error);
    if (result == SKV_OK)
        result = reserve_particles(rows, count, error);
    if (result == SKV_OK && masses)
        result = reserve_masses(rows, error);
    if (result == SKV_OK && drags)
        result = reserve_drags(rows, error);
    if (result == SKV_OK)
        result = reserve_kept(rows, error);
    if (result == SKV_OK)
        skv_rows_lend_buffers(rows);
    return result;
}

void skv_rows_lend_buffers(skv_rows *rows)
{
    const skv_row_particles *older = &rows->set[!rows->current];
    float *number = (float *)(void *)older->number, **spare = rows->spare;
    rows->own = (skv_row_sums){older->x, older->y, older->u, older->v, older->lightness};
    rows->next = (skv_row_sums){older->clearance, older->warm_lambda, number, spare[0],
                                rows->spare_lightness};
    /* What the pressure turns the own sums into, place by place, ... */
    rows->lambda = rows->own.density;
    rows->near_lambda = rows->own.near_density;
    rows->gradient_x = rows->own.gradient_x;
    rows->gradient_y = rows->own.gradient_y;
    rows->hanging = rows->gradient_y;
    rows->mean_lightness = rows->own.lightness;
    /* ... so that the next row's are free for the displacement. */
    rows->next_move = (skv_row_moves){older->clearance, older->warm_lambda, number};
    rows->own_move = (skv_row_moves){spare[0], spare[1], spare[2]};
    rows->pressure = older->u;
    rows->image = spare[3];
    rows->ahead_x = spare[1];
    rows->ahead_y = spare[2];
    /* There are no sums while the particles are sorted, and none when they are stored. */
    rows->key = (int *)(void *)spare[0];
    rows->place = (int *)(void *)spare[0];
}

skv_solver_memory skv_rows_memory(const skv_rows *rows)
{
    return rows->memory;
}
