/* What a fresh project does with the library, to see that it is found, whole and the right one:
 * prints its version and the hash of a small world after three frames. Invariant: every way of
 * building it prints the same. */
#include <skvalp/skvalp.h>

#include <inttypes.h>
#include <stdio.h>

int main(void)
{
    skv_world_def def = skv_default_world_def();
    skv_world *world;
    skv_error error;
    def.fluid.spacing = 0.02f;
    def.threads = 2;
    if (skv_world_create(&def, &world, &error) ||
        skv_world_fill(world, 0, 0, 0.5f, 0.5f, NULL, NULL, -1, NULL, &error)) {
        fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    for (int frame = 0; frame < 3; frame++)
        if (skv_world_step(world, 1.0f / 60, &error))
            return 1;
    printf("%s %d %016" PRIx64 "\n", skv_version(), skv_world_particle_count(world),
           skv_world_hash(world));
    skv_world_destroy(world);
    return 0;
}
