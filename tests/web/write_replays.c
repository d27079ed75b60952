/* Writes replays for tests that play them elsewhere: write_replays FOLDER. They are made anew with
 * every build, so that none has to be kept for the bits of today. skewed.skvr says another hash
 * than it gets. */
#include <skvalp/player.h>
#include <stdio.h>

/* One command every fourth frame. */
typedef struct game {
    const char *file, *scene;
    int count;
    skv_command commands[6];
} game;

static const game games[] = {
    {"game",
     "dam-break",
     6,
     {{.kind = SKV_COMMAND_POUR, .water = {0.6f, 0.7f, 0.9f, 0.7f, 0.04f, 0.5f, 0, 1, 0}},
      {.kind = SKV_COMMAND_PAINT, .paint = {1, {{0.8f, 0.1f, 0.8f, 0.3f, 0.02f, false}}}},
      {.kind = SKV_COMMAND_SET, .set = {"fluid.viscosity", "0.001"}},
      {.kind = SKV_COMMAND_GRAVITY, .vector = {3, -9}},
      {.kind = SKV_COMMAND_MARK},
      {.kind = SKV_COMMAND_PUSH, .vector = {0, 0.5f}}}},
    {"wind",
     "pool",
     2,
     {{.kind = SKV_COMMAND_FORCE,
       .force = {.place = -1,
                 .force = {.area = {.kind = SKV_AREA_BOX, .x1 = 1, .y1 = 0.5f},
                           .wind_x = 2,
                           .wind_y = 1,
                           .drag = 10}}},
      {.kind = SKV_COMMAND_FORCE,
       .force = {.place = 0,
                 .force = {.area = {.kind = SKV_AREA_BOX, .x1 = 1, .y1 = 1}, .ax = 3}}}}},
    {"skewed", "pool", 1, {{.kind = SKV_COMMAND_CHECK, .hash = 1}}},
};

static bool put(const char *bytes, size_t size, void *file)
{
    return fwrite(bytes, 1, size, file) == size;
}

static bool record(const game *given, FILE *file)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    skv_scene *scene;
    skv_player *player;
    bool done = skv_scene_load(given->scene, &options, &scene, NULL) == SKV_OK &&
                skv_player_create(scene, NULL, &player, NULL) == SKV_OK;
    for (int i = 0; done && i < 24; i++)
        done = (i % 4 != 0 || i / 4 >= given->count ||
                skv_player_apply(player, &given->commands[i / 4], NULL) == SKV_OK) &&
               skv_player_step(player, NULL) == SKV_OK;
    return done && skv_player_save(player, put, file, NULL) == SKV_OK;
}

int main(int argc, char **argv)
{
    for (size_t i = 0; i < sizeof games / sizeof *games; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s.skvr", argc == 2 ? argv[1] : "", games[i].file);
        FILE *file = argc == 2 ? fopen(path, "wb") : NULL;
        if (!file || !record(&games[i], file) || fclose(file) != 0) {
            fprintf(stderr, "write_replays: %s cannot be written\n", path);
            return 1;
        }
    }
    return 0;
}
