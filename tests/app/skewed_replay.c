/* Writes a replay that does not go the way it says: skewed_replay FILE. */
#include <skvalp/player.h>
#include <stdio.h>

static bool put(const char *bytes, size_t size, void *file)
{
    return fwrite(bytes, 1, size, file) == size;
}

int main(int argc, char **argv)
{
    skv_scene *scene;
    skv_player *player;
    const skv_command wrong = {.kind = SKV_COMMAND_CHECK, .hash = 1};
    FILE *file = argc == 2 ? fopen(argv[1], "wb") : NULL;
    bool done = file && skv_scene_load("pool", NULL, &scene, NULL) == SKV_OK &&
                skv_player_create(scene, NULL, &player, NULL) == SKV_OK &&
                skv_player_apply(player, &wrong, NULL) == SKV_OK &&
                skv_player_step(player, NULL) == SKV_OK &&
                skv_player_save(player, put, file, NULL) == SKV_OK && fclose(file) == 0;
    return done ? 0 : 1;
}
