/* The kernels by instruction set. Invariant: only what the processor has is given out; and all of
 * them compute the same. */
#include "solver/rows/rows_internal.h"

#include <string.h>

static const skv_row_kernels *best(void)
{
#if defined(SKV_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2"))
        return &skv_row_kernels_avx2;
#endif
    return &skv_row_kernels_base;
}

const skv_row_kernels *skv_row_kernels_for(skv_instruction_set set)
{
    static const char *const names[] = {"", "scalar", "sse2", "avx2", "neon", "wasm"};
    const skv_row_kernels *const had[] = {best(), &skv_row_kernels_base, &skv_row_kernels_scalar};
    if (set == SKV_ISA_BEST)
        return had[0];
    for (size_t i = 0; i < sizeof had / sizeof *had; i++)
        if (strcmp(had[i]->isa, names[set]) == 0)
            return had[i];
    return NULL;
}

const char *skv_rows_instruction_set(skv_instruction_set set)
{
    const skv_row_kernels *kernels = skv_row_kernels_for(set);
    return kernels ? kernels->isa : NULL;
}
