/* A second world with the same particles. */
#ifndef BENCH_TWIN_H
#define BENCH_TWIN_H

#include "skvalp/world.h"

/* Makes a world with the particles of `source` as they are now, in the same terrain with the
 * same gravity and substeps, but with another fluid, solver or number of threads. It never sleeps.
 */
skv_result bench_twin(const skv_world *source, const skv_fluid_def *fluid, skv_solver_kind solver,
                      int threads, skv_world **twin, skv_error *error);

#endif
