/* The smallest program: a column of water falls over in a closed tank. Prints how high its centre
 * of mass lies, then a hash of all particles, the same on every machine.
 *   cc hello.c $(pkg-config --cflags --libs skvalp) -o hello */
#include <skvalp/skvalp.h>

#include <inttypes.h>
#include <stdio.h>

int main(void)
{
    skv_error error;
    skv_world *world;
    skv_world_def def = skv_default_world_def(); /* 1.6 x 0.9 m, water */
    def.fluid.spacing = 0.02f;
    if (skv_world_create(&def, &world, &error) != SKV_OK) {
        fprintf(stderr, "hello: %s\n", error.text);
        return 1;
    }

    skv_fill_def column = skv_default_fill_def(); /* a box, from the lower left corner */
    column.x1 = 0.4f;
    column.y1 = 0.6f;
    skv_result result = skv_world_fill(world, &column, NULL, &error);
    for (int frame = 0; frame < 30 && result == SKV_OK; frame++)
        result = skv_world_step(world, 1.0f / 60, &error);
    if (result != SKV_OK) {
        fprintf(stderr, "hello: %s\n", error.text);
        skv_world_destroy(world);
        return 1;
    }

    printf("skvalp %s: %d particles, centre of mass at %.3f m, hash %016" PRIx64 "\n",
           skv_version(), skv_world_particle_count(world), skv_world_stats(world).centre_y,
           skv_world_hash(world));
    skv_world_destroy(world);
    return 0;
}
