/* skvalp check: loads a scene, builds its world once, and says what it is. */
#include "commands.h"

void print_notices(const skv_scene *scene)
{
    for (int i = 0; skv_scene_notice(scene, i); i++)
        fprintf(stderr, "skvalp: note: %s\n", skv_scene_notice(scene, i));
}

static void print_summary(const skv_scene *scene, const skv_world *world)
{
    const skv_terrain *terrain = skv_world_terrain(world);
    int notices = 0;
    while (skv_scene_notice(scene, notices))
        notices++;
    printf("%s: ok, %.4g x %.4g m, %d x %d pixels, %d particles, spacing %.3g mm, %d substeps a "
           "frame, %d notice%s\n",
           skv_scene_name(scene), (double)skv_terrain_width(terrain),
           (double)skv_terrain_height(terrain), skv_terrain_pixels_x(terrain),
           skv_terrain_pixels_y(terrain), skv_world_particle_count(world),
           1000.0 * (double)skv_world_spacing(world), skv_world_substeps_per_frame(world), notices,
           notices == 1 ? "" : "s");
}

int check_command(const cli_options *options, skv_error *error)
{
    skv_scene_options wanted = options_for_scene(options);
    skv_scene *scene = NULL;
    skv_world *world = NULL;
    skv_result result = skv_scene_load(options->scene, &wanted, &scene, error);
    if (!result)
        result = skv_scene_create_world(scene, options->threads, &world, error);
    if (!result && !options->quiet) {
        print_notices(scene);
        print_summary(scene, world);
    }
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    return result ? STATUS_BAD : STATUS_DONE;
}
