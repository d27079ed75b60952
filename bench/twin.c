/* Copies a world, so that solvers and thread counts are compared on the same particles at the same
 * moment. Invariant: a twin's terrain equals the source's in every distance, which is checked: the
 * picture behind a terrain cannot be read back, so only bare tanks have twins. */
#include "twin.h"

#include <string.h>

static bool same_walls(const skv_terrain *a, const skv_terrain *b)
{
    int stride_a, stride_b;
    const float *row_a = skv_terrain_distances(a, &stride_a);
    const float *row_b = skv_terrain_distances(b, &stride_b);
    size_t bytes = (size_t)skv_terrain_pixels_x(a) * sizeof *row_a;
    for (int y = 0; y < skv_terrain_pixels_y(a); y++, row_a += stride_a, row_b += stride_b)
        if (memcmp(row_a, row_b, bytes) != 0)
            return false;
    return true;
}

static skv_result make_tank(const skv_terrain *source, skv_terrain **tank, skv_error *error)
{
    skv_terrain_def def = skv_default_terrain_def();
    def.width = skv_terrain_pixels_x(source);
    def.height = skv_terrain_pixels_y(source);
    def.pixel_size = skv_terrain_pixel_size(source);
    def.open_sides = skv_terrain_open_sides(source);
    skv_result result = skv_terrain_create(&def, tank, error);
    if (result == SKV_OK && !same_walls(source, *tank)) {
        skv_terrain_destroy(*tank);
        return skv_fail(error, SKV_ERROR_VALUE,
                        "bench: the scene has walls inside; measure in a bare tank");
    }
    return result;
}

static skv_result copy_particles(const skv_world *source, skv_world *twin, skv_error *error)
{
    skv_particles all = skv_world_particles(source);
    skv_result result = SKV_OK;
    for (int i = 0; i < all.count && result == SKV_OK; i++)
        result = skv_world_add_particle(twin, all.x[i], all.y[i], all.vx[i], all.vy[i], error);
    return result;
}

skv_result bench_twin(const skv_world *source, const skv_fluid_def *fluid, skv_solver solver,
                      int threads, skv_world **twin, skv_error *error)
{
    *twin = NULL;
    skv_world_def def = skv_default_world_def();
    skv_result result = make_tank(skv_world_terrain(source), &def.terrain, error);
    if (result != SKV_OK)
        return result;
    def.fluid = *fluid;
    skv_world_gravity(source, &def.gravity_x, &def.gravity_y);
    def.substeps = skv_world_substeps(source);
    def.threads = threads;
    def.solver = solver;
    def.sleep = false;
    def.capacity = skv_world_particle_count(source);
    result = skv_world_create(&def, twin, error);
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
