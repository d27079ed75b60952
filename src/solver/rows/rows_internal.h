/* What the rows' files do for each other. What they work on is in layout.h. */
#ifndef SKV_ROWS_INTERNAL_H
#define SKV_ROWS_INTERNAL_H

#include "solver/rows/layout.h"

/* One instruction set's kernels. Each handles one row; what walls give its particles is added to
 * `walls`. */
typedef struct skv_row_kernels {
    const char *isa;
    /* Forces and advance. */
    void (*advance)(const skv_rows *rows, int row, const skv_constants *constants,
                    const skv_boundary *boundary, skv_row_given *walls);
    /* W: samples the walls, and finds the image distances beside them. */
    void (*sample)(const skv_rows *rows, int row, const skv_constants *constants,
                   const skv_boundary *boundary, skv_row_samples *samples);
    /* A. `later` false: with the gradient that the calibrated law's tension needs; true: densities
     * only. Keeps the pairs if there is room. */
    void (*density)(const skv_rows *rows, int row, bool later, const skv_constants *constants,
                    const skv_boundary *boundary, skv_row_kept *kept);
    /* L: the walls' share of the sums, and the pressure law. */
    void (*pressure)(const skv_rows *rows, int row, bool later, const skv_constants *constants,
                     const skv_boundary *boundary, const skv_row_samples *samples);
    /* B; with tension and pair viscosity unless it is `later`. */
    void (*displacement)(const skv_rows *rows, int row, bool later, const skv_constants *constants,
                         const skv_boundary *boundary, const skv_row_kept *kept);
    /* U: carries out the displacement; in the last iteration the contact as well. */
    void (*update)(const skv_rows *rows, int row, int iteration, const skv_constants *constants,
                   const skv_boundary *boundary, const skv_row_samples *samples,
                   skv_row_given *walls);
} skv_row_kernels;

/* isa.c: the kernels of an instruction set; null if this machine lacks it. */
const skv_row_kernels *skv_row_kernels_for(skv_instruction_set set);

extern const skv_row_kernels skv_row_kernels_scalar;
extern const skv_row_kernels skv_row_kernels_base; /* SSE2, NEON or WebAssembly */
extern const skv_row_kernels skv_row_kernels_avx2;
extern const skv_row_kernels skv_row_kernels_avx512;

/* reaction.c: books what a wall gives a particle at (x, y) for the reaction that is asked for. */
void skv_rows_book_reaction(const skv_rows *rows, const skv_boundary *boundary, float x, float y,
                            float dx, float dy, skv_row_given *walls);

/* turn.c: adds how unlike pairs of a row, and of it and the next, turn to their displacements. */
void skv_rows_turn_unlike(const skv_rows *rows, int row, const skv_constants *constants,
                          const skv_boundary *boundary);

/* turn.c, too: the same of how they push each other apart, where they do. */
void skv_rows_push_unlike(const skv_rows *rows, int row, const skv_boundary *boundary);

/* memory.c: who borrows which buffer, now that the other set's particles are not needed any more;
 * after each sort. */
void skv_rows_lend_buffers(skv_rows *rows);

/* transfer.c: a thread's share of the frame's particles, into provisional rows, which the first
 * sort reads, and back from the sorted ones; between these two every thread notes where the
 * particles of its rows lie. */
void skv_rows_load(skv_rows *rows, int thread, const skv_row_frame *frame, float sigma,
                   const skv_boundary *boundary);
void skv_rows_note_places(const skv_rows *rows, int thread);
void skv_rows_store(const skv_rows *rows, int thread, const skv_row_frame *frame);

/* sort.c: sorts all particles; called by every thread of the pool with its index. Then, when all of
 * them have come back, one turns over: the new order becomes the current one. */
void skv_rows_sort(skv_rows *rows, int thread, skv_pool *pool);
void skv_rows_turn_over(skv_rows *rows);

/* Parts the coincident particles of a row. */
void skv_rows_separate_coincident(skv_rows *rows, int row);

/* Finds the two ranges of partners of each tile of a row, and how many blocks of pairs they make:
 * in the own row up to a radius ahead, in the next row within a radius to both sides. Once a
 * substep: in its later iterations the partners stay the same, though they move. */
void skv_rows_find_ranges(skv_rows *rows, int row);

#endif
