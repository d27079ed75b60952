/* The rows' lifetime, and a substep as a pipeline over them.
 *
 * Who may run when, for row R of one iteration (A density, L pressure, B displacement, U update):
 * L(R) needs A(R) and A(R-1); B(R) needs L(R) and L(R+1); U(R) needs B(R) and B(R-1), and moves
 * what A and B of rows R and R-1 read. A thread runs A(R) L(R) B(R-1) U(R-1) for its rows in turn.
 * At the seam between two threads the upper one needs A of the lower one's last row, so that is run
 * before the rest; the lower one needs L of the upper one's first row; and the upper one's first
 * row is updated after B of the lower one's last. A thread waits for its two neighbours only, and
 * only there: they may be at work on different iterations.
 *
 * Invariant: every order that these rules allow gives the same bits.
 */
#include "base/memory.h"
#include "base/platform.h"
#include "solver/rows/rows_internal.h"

#include <math.h>
#include <stdatomic.h>
#include <string.h>

/* Rounding must not make a lower bound of a distance too large. */
#define SAFE_BOUND 0.999f

enum {
    LINE = 16, /* integers in a cache line */
    FLOATS_A_BLOCK = ROW_TILE * ROW_LANES,
    ROW_NUMBERS = 8, /* integers kept for each row */
    MAX_CELLS = 1 << 26
};

/* What the members of a team share. */
typedef struct run {
    skv_rows *rows;
    const skv_row_kernels *kernels;
    const skv_row_constants *constants;
    const skv_row_boundary *boundary;
    skv_pool *pool;
    const skv_row_frame *frame;
    int substeps;
    int to_take; /* substeps that have not begun to relax */
    skv_progress progress[ROW_MAX_THREADS];
} run;

skv_result skv_rows_create(float width, float height, skv_rows **out, skv_error *error)
{
    *out = NULL;
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
    rows->cells_used = (int)cells;
    rows->stride = ((int)cells + ROW_CELLS + 2 + ROW_LANES - 1) & ~(ROW_LANES - 1);
    rows->row_count = (int)row_count;
    size_t in_rows = (size_t)rows->row_count + 2;
    size_t grid = in_rows * (size_t)rows->stride;
    int *block = skv_calloc(grid + ROW_NUMBERS * in_rows, sizeof *block);
    if (!block) {
        skv_free(rows);
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the solver's grid");
    }
    rows->grid_block = block;
    rows->cell_start = block;
    int **by_row[] = {&rows->row_start, &rows->row_end,    &rows->new_start,  &rows->new_end,
                      &rows->row_size,  &rows->row_blocks, &rows->wall_first, &rows->wall_count};
    for (int a = 0; a < ROW_NUMBERS; a++)
        *by_row[a] = block + grid + in_rows * (size_t)a;
    *out = rows;
    return SKV_OK;
}

static void free_threads(skv_rows *rows)
{
    for (int t = 0; t < rows->thread_room; t++) {
        skv_free(rows->thread[t].kept_memory);
        skv_free(rows->thread[t].near_walls);
    }
    skv_free(rows->thread);
    skv_free(rows->histogram_block);
    rows->thread = NULL;
    rows->histogram_block = NULL;
    rows->thread_room = 0;
}

void skv_rows_destroy(skv_rows *rows)
{
    if (!rows)
        return;
    free_threads(rows);
    skv_free(rows->block);
    skv_free(rows->viscous_block);
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
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d threads", threads);
    }
    rows->histogram_block = histograms;
    rows->thread_room = threads;
    for (int t = 0; t < threads; t++) {
        rows->thread[t].histogram = histograms + numbers * (size_t)t;
        rows->thread[t].row_size = rows->thread[t].histogram + cells;
    }
    return SKV_OK;
}

/* Room for kept pairs and wall samples; less than wished for costs time, not correctness. */
static skv_result reserve_kept(skv_rows *rows, skv_error *error)
{
    /* A tile at rest has 6 or 7 blocks; rows of twice the usual density have their place. */
    int blocks = (rows->widest + ROW_TILE) / ROW_TILE * 12 + 64;
    /* The analyser can't know that skv_fail never says SKV_OK. */
    int walls =
        rows->count / rows->thread_room / 2 + 256; /* NOLINT(clang-analyzer-core.DivideZero) */
    for (int t = 0; t < rows->thread_room; t++) {
        skv_row_thread *own = &rows->thread[t];
        if (blocks > own->kept[0].room) {
            int room = blocks + blocks / 2;
            float *memory = skv_calloc((size_t)room * FLOATS_A_BLOCK * ROW_SLOTS, sizeof *memory);
            if (!memory)
                return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for kept pairs");
            skv_free(own->kept_memory);
            own->kept_memory = memory;
            for (int slot = 0; slot < ROW_SLOTS; slot++) {
                own->kept[slot].pairs = memory + (size_t)slot * (size_t)room * FLOATS_A_BLOCK;
                own->kept[slot].room = room;
            }
        }
        if (walls > own->near_wall_room) {
            skv_near_wall *near_walls = skv_calloc((size_t)walls, sizeof *near_walls);
            if (!near_walls)
                return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for wall samples");
            skv_free(own->near_walls);
            own->near_walls = near_walls;
            own->near_wall_room = walls;
        }
    }
    return SKV_OK;
}

/* Distance between arrays in one block, in floats: 5 cache lines more than a number of pages. The
 * same place in two arrays must not have the same place in its page: a load would wait for a store
 * to the other, and both would fight for the same cache sets. */
static size_t array_stride(size_t elements)
{
    size_t pages = (elements + 1023) / 1024;
    return pages * 1024 + 5 * 16;
}

static skv_result reserve_particles(skv_rows *rows, int count, skv_error *error)
{
    if (count <= rows->capacity)
        return SKV_OK;
    int capacity = count > rows->capacity * 2 ? count : rows->capacity * 2;
    /* A row's dummies and the gap to the next multiple of eight are fewer than two blocks. */
    size_t slots = (size_t)capacity + (size_t)rows->row_count * 2 * ROW_LANES + 4 * ROW_LANES;
    float **floats[] = {
        &rows->set[0].x,         &rows->set[0].y, &rows->set[0].u,         &rows->set[0].v,
        &rows->set[0].clearance, &rows->set[1].x, &rows->set[1].y,         &rows->set[1].u,
        &rows->set[1].v,         &rows->own[0],   &rows->own[1],           &rows->own[2],
        &rows->own[3],           &rows->next[0],  &rows->next[1],          &rows->next[2],
        &rows->next[3],          &rows->pressure, &rows->set[1].clearance,
    };
    enum { FLOATS = sizeof floats / sizeof *floats };
    size_t stride = array_stride(slots), tiles = array_stride(slots / ROW_TILE + 1);
    size_t total = stride * (FLOATS + 2) + 3 * tiles;
    float *block = skv_calloc(total, sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    skv_free(rows->block);
    rows->block = block;
    for (int a = 0; a < FLOATS; a++, block += stride)
        *floats[a] = block;
    int **ints[] = {&rows->set[0].number, &rows->set[1].number};
    for (int a = 0; a < 2; a++, block += stride)
        *ints[a] = (int *)(void *)block;
    /* The sort is over when the sums begin. */
    rows->key = (int *)(void *)rows->own[0];
    rows->place = (int *)(void *)rows->own[0];
    int **by_tile[] = {&rows->own_end, &rows->next_begin, &rows->next_end};
    for (int a = 0; a < 3; a++, block += tiles)
        *by_tile[a] = (int *)(void *)block;
    rows->capacity = capacity;
    rows->slots = (int)slots;
    rows->particle_bytes = total * sizeof *block;
    skv_free(rows->viscous_block);
    rows->viscous_block = NULL;
    return SKV_OK;
}

static skv_result reserve_viscous(skv_rows *rows, bool viscous, skv_error *error)
{
    rows->viscous = viscous;
    if (!viscous || rows->viscous_block)
        return SKV_OK;
    size_t stride = array_stride((size_t)rows->slots);
    float *block = skv_calloc(6 * stride, sizeof *block);
    if (!block)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for viscosity");
    rows->viscous_block = block;
    for (int a = 0; a < 2; a++) {
        rows->viscous_own[a] = block + stride * (size_t)a;
        rows->viscous_next[a] = block + stride * (size_t)(a + 2);
        rows->viscous_sum[a] = block + stride * (size_t)(a + 4);
    }
    return SKV_OK;
}

skv_result skv_rows_reserve(skv_rows *rows, int count, int threads, bool viscous, skv_error *error)
{
    skv_result result = reserve_threads(rows, threads, error);
    if (result == SKV_OK)
        result = reserve_particles(rows, count, error);
    if (result == SKV_OK)
        result = reserve_viscous(rows, viscous, error);
    rows->count = count;
    /* The widest row is known from the last sort; before the first one, guess. */
    if (rows->widest == 0)
        rows->widest = count / 8;
    if (result == SKV_OK)
        result = reserve_kept(rows, error);
    return result;
}

/* How many provisional rows the particles are taken in with: one a thread, but not so many that
 * their dummies, three blocks each, find no place. */
static int provisional_rows(const skv_rows *rows)
{
    return rows->threads < rows->row_count / 2 ? rows->threads : rows->row_count / 2;
}

/* The first of the frame's members that a thread takes in; the threads after the last take none. */
static int share_begin(const skv_rows *rows, const skv_row_frame *frame, int thread)
{
    int shares = provisional_rows(rows);
    return thread < shares ? (int)((int64_t)frame->count * thread / shares) : frame->count;
}

/* Takes a share of the particles in as one provisional row, in the order of their numbers; the sort
 * of the first substep, which is stable, puts them where they belong. */
static void load_particles(skv_rows *rows, int thread, const skv_row_frame *frame)
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
    for (int k = from; k < to; k++, place++) {
        int member = frame->members ? frame->members[k] : k, i = member < 0 ? ~member : member;
        p->x[place] = frame->x[i] * frame->length;
        p->y[place] = frame->y[i] * frame->length;
        p->u[place] = frame->vx[i] * frame->speed;
        p->v[place] = frame->vy[i] * frame->speed;
        p->clearance[place] = frame->clearance[i] * frame->length;
        p->number[place] = member < 0 ? i | ROW_HELD : i;
    }
    rows->row_end[thread] = place;
    for (int k = place; k < skv_row_padded_end(place); k++) {
        p->x[k] = p->y[k] = p->clearance[k] = ROW_FAR;
        p->u[k] = p->v[k] = 0;
    }
    own->old_first = thread;
    own->old_end = thread + 1;
}

/* Notes where the particles of a thread's rows lie. The relaxation is over: its sums' memory is
 * free. */
static void note_places(const skv_rows *rows, int thread)
{
    const int *number = rows->set[rows->current].number;
    for (int row = rows->thread[thread].first; row < rows->thread[thread].end; row++)
        for (int k = rows->row_start[row]; k < rows->row_end[row]; k++)
            rows->place[number[k] & ~ROW_HELD] = k;
}

/* Each thread gives back what it has taken in and will take in again: were it the particles of its
 * rows, the threads would write to the same cache lines, and take them from each other for each
 * number.
 * Divides by what load_particles has multiplied with: that gives back the same number but for
 * rounding to either side. The reciprocal is itself rounded, and a product with it would be off to
 * the same side in every frame: momentum would drift. */
static void store_particles(const skv_rows *rows, int thread, const skv_row_frame *frame)
{
    const skv_row_particles *p = &rows->set[rows->current];
    int end = share_begin(rows, frame, thread + 1);
    for (int m = share_begin(rows, frame, thread); m < end; m++) {
        int i = frame->members ? frame->members[m] : m;
        if (i < 0)
            continue;
        int k = rows->place[i];
        frame->x[i] = p->x[k] / frame->length;
        frame->y[i] = p->y[k] / frame->length;
        frame->vx[i] = p->u[k] / frame->speed;
        frame->vy[i] = p->v[k] / frame->speed;
        frame->clearance[i] = p->clearance[k] / frame->length * SAFE_BOUND;
        frame->pressure[i] = rows->pressure[k];
    }
}

/* The rows of one thread through one iteration; see the top of the file. */
typedef struct worker {
    run *shared;
    skv_row_thread *own;
    int thread, iteration;
    int lower, upper; /* the threads that own the rows below and above, or -1 */
    unsigned turn;    /* iterations since the team began */
    bool later;
} worker;

/* What neighbours wait for, in the order in which a thread comes to it in each turn. */
typedef enum milestone { LAST_SUMMED = 1, FIRST_PRESSED, LAST_DISPLACED, FIRST_UPDATED } milestone;
enum { MILESTONES = FIRST_UPDATED };

static void reach(const worker *w, milestone m)
{
    skv_pool_reach(w->shared->pool, &w->shared->progress[w->thread], w->turn * MILESTONES + m);
}

static void await(const worker *w, int neighbour, milestone m)
{
    if (neighbour >= 0)
        skv_pool_await(w->shared->pool, &w->shared->progress[neighbour], w->turn * MILESTONES + m);
}

/* Waits until a neighbour has finished the turn before. */
static void await_last_turn(const worker *w, int neighbour)
{
    if (neighbour >= 0)
        skv_pool_await(w->shared->pool, &w->shared->progress[neighbour], w->turn * MILESTONES);
}

static void run_density(const worker *w, int row)
{
    skv_rows *rows = w->shared->rows;
    int slot = row == w->own->end - 1 ? ROW_SLOTS - 1 : row & 1;
    if (!w->later)
        skv_rows_find_ranges(rows, row);
    w->shared->kernels->density(rows, row, w->later, w->shared->constants, w->shared->boundary,
                                &w->own->kept[slot]);
}

static void run_pressure(const worker *w, int row)
{
    skv_rows *rows = w->shared->rows;
    rows->wall_first[row] = w->own->near_wall_count;
    rows->wall_count[row] = w->shared->kernels->pressure(rows, row, w->later, w->shared->constants,
                                                         w->shared->boundary, w->own);
}

static void run_displacement(const worker *w, int row)
{
    int slot = row == w->own->end - 1 ? ROW_SLOTS - 1 : row & 1;
    w->shared->kernels->displacement(w->shared->rows, row, w->later, w->shared->constants,
                                     w->shared->boundary, &w->own->kept[slot]);
}

static void run_update(const worker *w, int row)
{
    skv_rows *rows = w->shared->rows;
    w->shared->kernels->update(rows, row, w->iteration, w->shared->constants, w->shared->boundary,
                               w->own->near_walls + rows->wall_first[row], rows->wall_count[row]);
}

/* The next thread with rows, upwards (step 1) or downwards (-1), or -1. */
static int neighbour(const skv_rows *rows, int thread, int step)
{
    for (int t = thread + step; t >= 0 && t < rows->threads; t += step)
        if (rows->thread[t].first < rows->thread[t].end)
            return t;
    return -1;
}

/* Row `first`'s `next` sums come from nobody: the row below it is empty. */
static void clear_lowest(skv_rows *rows)
{
    int begin = rows->row_start[rows->first];
    size_t bytes = (size_t)(skv_row_padded_end(rows->row_end[rows->first]) - begin) * sizeof(float);
    for (int a = 0; a < ROW_SUMS; a++)
        memset(rows->next[a] + begin, 0, bytes);
    for (int a = 0; rows->viscous && a < 2; a++)
        memset(rows->viscous_next[a] + begin, 0, bytes);
}

static void relax_rows(const worker *w)
{
    int first = w->own->first, last = w->own->end - 1;
    int free =
        w->lower < 0 ? first : first + 1; /* the first row that the thread below leaves alone */
    if (w->lower < 0)
        clear_lowest(w->shared->rows);
    w->own->near_wall_count = 0;
    await_last_turn(w, w->upper);
    run_density(w, last);
    reach(w, LAST_SUMMED);
    for (int row = first; row <= last; row++) {
        if (row < last)
            run_density(w, row);
        if (row == first)
            await(w, w->lower, LAST_SUMMED);
        run_pressure(w, row);
        if (row == first)
            reach(w, FIRST_PRESSED);
        else
            run_displacement(w, row - 1);
        if (row > free)
            run_update(w, row - 1);
    }
    await(w, w->upper, FIRST_PRESSED);
    run_displacement(w, last);
    reach(w, LAST_DISPLACED);
    if (last >= free)
        run_update(w, last);
    await(w, w->lower, LAST_DISPLACED);
    if (first < free)
        run_update(w, first);
}

/* Books the time since `*start` under a phase, on one thread only. */
static void book(skv_rows *rows, int thread, int phase, double *start)
{
    if (thread != 0)
        return;
    double now = skv_clock();
    rows->seconds[phase] += now - *start;
    *start = now;
}

static void begin_relaxation(void *context)
{
    run *shared = context;
    skv_rows_turn_over(shared->rows);
    shared->rows->gauged = --shared->to_take == 0;
}

static void sort(const worker *w, bool first)
{
    run *shared = w->shared;
    skv_rows_sort(shared->rows, w->thread, shared->pool);
    skv_pool_gather(shared->pool, begin_relaxation, shared);
    if (!first)
        return;
    for (int row = w->own->first; row < w->own->end; row++)
        skv_rows_separate_coincident(shared->rows, row);
    skv_pool_barrier(shared->pool);
}

static void relax(worker *w)
{
    const skv_rows *rows = w->shared->rows;
    bool idle = w->own->first == w->own->end;
    w->lower = neighbour(rows, w->thread, -1);
    w->upper = neighbour(rows, w->thread, 1);
    for (w->iteration = 0; w->iteration < w->shared->constants->iterations; w->iteration++) {
        w->later = w->iteration > 0;
        if (!idle)
            relax_rows(w);
        reach(w, FIRST_UPDATED);
        w->turn++;
    }
}

static void take_substep(worker *w, bool first)
{
    run *shared = w->shared;
    skv_rows *rows = shared->rows;
    double start = skv_clock();
    for (int row = w->own->old_first; row < w->own->old_end; row++)
        shared->kernels->advance(rows, row, shared->constants, shared->boundary);
    book(rows, w->thread, ROW_ADVANCE, &start);
    sort(w, first);
    book(rows, w->thread, ROW_SORT, &start);
    relax(w);
    book(rows, w->thread, ROW_RELAX, &start);
}

static void member(int thread, int threads, void *context)
{
    run *shared = context;
    if (thread == 0)
        shared->rows->threads = threads;
    skv_pool_barrier(shared->pool);
    worker w = {.shared = shared, .own = &shared->rows->thread[thread], .thread = thread};
    double start = skv_clock();
    load_particles(shared->rows, thread, shared->frame);
    book(shared->rows, thread, ROW_TRANSFER, &start);
    for (int s = 0; s < shared->substeps; s++)
        take_substep(&w, s == 0);
    start = skv_clock();
    skv_pool_barrier(shared->pool);
    note_places(shared->rows, thread);
    skv_pool_barrier(shared->pool);
    store_particles(shared->rows, thread, shared->frame);
    book(shared->rows, thread, ROW_TRANSFER, &start);
}

void skv_rows_step(skv_rows *rows, const skv_row_frame *frame, int substeps,
                   const skv_row_constants *constants, const skv_row_boundary *boundary,
                   skv_pool *pool)
{
    if (frame->count == 0)
        return;
    rows->count = frame->count;
    rows->held = frame->members != NULL;
    run shared = {.rows = rows,
                  .kernels = skv_row_kernels_chosen(),
                  .constants = constants,
                  .boundary = boundary,
                  .pool = pool,
                  .frame = frame,
                  .substeps = substeps,
                  .to_take = substeps};
    skv_pool_team(pool, member, &shared);
}

void skv_rows_profile(skv_rows *rows, bool reset, double seconds[4])
{
    memcpy(seconds, rows->seconds, sizeof rows->seconds);
    if (reset)
        memset(rows->seconds, 0, sizeof rows->seconds);
}

size_t skv_rows_bytes(const skv_rows *rows)
{
    return rows->particle_bytes;
}
