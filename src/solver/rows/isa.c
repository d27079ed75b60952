/* The kernels by instruction set. Invariant: only what the processor has is given out; and all of
 * them compute the same. */
#include "solver/rows/rows_internal.h"

#include <string.h>

enum { MOST = 4 };

/* Writes the kernels that this machine can run, the best first, and returns their number. */
static int list_kernels(const skv_row_kernels *list[MOST])
{
    int count = 0;
#if defined(SKV_HAVE_AVX512)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        list[count++] = &skv_row_kernels_avx512;
#endif
#if defined(SKV_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2"))
        list[count++] = &skv_row_kernels_avx2;
#endif
    list[count++] = &skv_row_kernels_base;
#if defined(SKV_HAVE_SCALAR)
    list[count++] = &skv_row_kernels_scalar;
#endif
    return count;
}

const skv_row_kernels *skv_row_kernels_for(skv_instruction_set set)
{
    static const char *const names[] = {"", "scalar", "sse2", "avx2", "avx512", "neon", "wasm"};
    const skv_row_kernels *list[MOST];
    int count = list_kernels(list);
    if (set == SKV_ISA_BEST)
        return list[0];
    for (int i = 0; i < count; i++)
        if (strcmp(list[i]->isa, names[set]) == 0)
            return list[i];
    return NULL;
}

const char *skv_rows_instruction_set(skv_instruction_set set)
{
    const skv_row_kernels *kernels = skv_row_kernels_for(set);
    return kernels ? kernels->isa : NULL;
}
