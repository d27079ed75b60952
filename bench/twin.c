/* Copies a world, so that solvers and thread counts are compared on the same particles at the same
 * moment. Invariant: a twin shares the source's terrain and has its particles. */
#include "twin.h"
#include "skvalp/particles.h"

static skv_result copy_particles(const skv_world *source, skv_world *twin, skv_error *error)
{
    skv_particles all = skv_world_particles(source);
    skv_result result = SKV_OK;
    for (int i = 0; i < all.count && result == SKV_OK; i++)
        result = skv_world_add_particle(twin, all.x[i], all.y[i], all.vx[i], all.vy[i], error);
    return result;
}

skv_result bench_twin(const skv_world *source, const skv_fluid_def *fluid, skv_solver_kind solver,
                      int threads, skv_world **twin, skv_error *error)
{
    *twin = NULL;
    skv_world_def def = skv_default_world_def();
    def.terrain = skv_terrain_share(skv_world_terrain(source));
    def.fluid = *fluid;
    skv_world_gravity(source, &def.gravity_x, &def.gravity_y);
    def.substeps = skv_world_substeps_per_frame(source);
    def.threads = threads;
    def.solver = solver;
    def.sleep = false;
    def.capacity = skv_world_particle_count(source);
    skv_result result = skv_world_create(&def, twin, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(def.terrain);
        return result;
    }
    result = copy_particles(source, *twin, error);
    if (result != SKV_OK) {
        skv_world_destroy(*twin);
        *twin = NULL;
    }
    return result;
}
