/* What stands in the page's modules for the reference solver, which nobody can choose there:
 * without its passes a first visit takes a fortieth less. Invariant: a world that asks for it is
 * refused.
 */
#include "solver/solver.h"

static skv_result refuse(const skv_solver_def *def, skv_solver **solver, skv_error *error)
{
    (void)def, (void)solver;
    return skv_fail(error, SKV_ERROR_VALUE, "the page has no reference solver; use the fast one");
}

const skv_solver_type skv_reference_solver = {.create = refuse};
