/* A scene file in memory, and settings on top: the answer is a scene that makes a world, or one
 * line. Compiled for each kind of file: FUZZ_FORMAT is "json" or "png", or "set" for a built-in
 * scene with the input as settings, a "path=value" in each line. */
#include "fuzz.h"

#include <skvalp/query.h>
#include <skvalp/scene.h>
#include <skvalp/world.h>

#include <stdlib.h>
#include <string.h>

enum { MAX_SETTINGS = 16 };

/* Small worlds are as hostile as large ones, and quicker: a coarse grain and few particles. */
static const skv_setting coarse[] = {{"world.pixel", "0.02"}};
enum { COARSE = sizeof coarse / sizeof *coarse, PARTICLES = 100 };

/* What a hostile file may ask for and get, but a fuzzer has no time for. */
static bool is_small(const skv_world *world)
{
    const skv_terrain *terrain = skv_world_terrain(world);
    return (double)skv_terrain_pixels_x(terrain) * skv_terrain_pixels_y(terrain) < 300000 &&
           skv_world_substeps_per_frame(world) < 50;
}

static void try_world(const skv_scene *scene)
{
    skv_world *world = NULL;
    skv_error error = {0};
    skv_result result = skv_scene_create_world(scene, 1, &world, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect((result == SKV_OK) == (world != NULL), "a world exactly if the result is SKV_OK");
    if (world == NULL)
        return;
    fuzz_expect(skv_world_particle_count(world) == skv_scene_particles(scene),
                "the world has the particles that the scene tells");
    if (is_small(world)) {
        fuzz_expect_answer(skv_world_step(world, 1.0f / 60, &error), &error);
        skv_stats stats = skv_world_stats(world);
        fuzz_expect(stats.not_finite == 0, "every position and velocity is finite");
    }
    skv_world_destroy(world);
}

static void try_scene(skv_result result, skv_scene *scene, const skv_error *error)
{
    fuzz_expect_answer(result, error);
    fuzz_expect((result == SKV_OK) == (scene != NULL), "a scene exactly if the result is SKV_OK");
    if (scene != NULL)
        try_world(scene);
    skv_scene_destroy(scene);
}

/* Cuts `text` into settings; returns their number. */
static int split(char *text, skv_setting *settings)
{
    int count = 0;
    for (char *line = strtok(text, "\n"); line != NULL && count < MAX_SETTINGS;
         line = strtok(NULL, "\n")) {
        char *equals = strchr(line, '=');
        if (equals == NULL)
            continue;
        *equals = '\0';
        settings[count++] = (skv_setting){line, equals + 1};
    }
    return count;
}

static void try_settings(const uint8_t *data, size_t size, skv_scene_options *options)
{
    static const char *const scenes[] = {"pool", "dam-break", "waves"};
    char *text = calloc(1, size + 1);
    skv_setting settings[MAX_SETTINGS + COARSE];
    memcpy(text, data, size);
    memcpy(settings, coarse, sizeof coarse);
    options->settings = settings;
    options->setting_count = COARSE + split(text, settings + COARSE);
    skv_scene *scene = NULL;
    skv_error error = {0};
    const char *name = scenes[size % (sizeof scenes / sizeof *scenes)];
    skv_result result = skv_scene_load(name, options, &scene, &error);
    try_scene(result, scene, &error);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = PARTICLES;
    if (strcmp(FUZZ_FORMAT, "set") == 0) {
        try_settings(data, size, &options);
        return 0;
    }
    if (strcmp(FUZZ_FORMAT, "json") == 0) {
        options.settings = coarse;
        options.setting_count = COARSE;
    }
    skv_scene *scene = NULL;
    skv_error error = {0};
    skv_result result =
        skv_scene_load_memory(data, size, FUZZ_FORMAT, "fuzz", &options, &scene, &error);
    try_scene(result, scene, &error);
    return 0;
}
