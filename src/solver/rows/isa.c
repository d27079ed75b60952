/* Choosing the kernels: the widest instruction set that the processor has, or the one named by the
 * environment variable SKVALP_ISA (sse2, avx2 or scalar), for tests. The results are the same. */
#include "base/platform.h"
#include "solver/rows/rows_internal.h"

#include <string.h>

static const skv_row_kernels *widest(void)
{
#if defined(SKV_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2"))
        return &skv_row_kernels_avx2;
#endif
    return &skv_row_kernels_base;
}

const skv_row_kernels *skv_row_kernels_chosen(void)
{
    const skv_row_kernels *best = widest();
    const char *wish = skv_platform_variable("SKVALP_ISA");
    if (!wish)
        return best;
    if (strcmp(wish, "scalar") == 0)
        return &skv_row_kernels_scalar;
    if (strcmp(wish, skv_row_kernels_base.isa) == 0)
        return &skv_row_kernels_base;
    return best;
}

const char *skv_rows_isa(void)
{
    return skv_row_kernels_chosen()->isa;
}
