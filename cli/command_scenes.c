/* skvalp scenes: lists what is built in. */
#include "commands.h"

#include <string.h>

#include "output_json.h"

static skv_result print_json(skv_error *error)
{
    skv_result result = SKV_OK;
    output_list_begin();
    for (int i = 0; skv_builtin_scene(i) && result == SKV_OK; i++) {
        const skv_scene_info *scene = skv_builtin_scene(i);
        result = output_list_add(i,
                                 json_pack("{so so so}", "name", output_text(scene->name), "title",
                                           output_text(scene->title), "description",
                                           output_text(scene->description)),
                                 error);
    }
    output_list_end();
    return result;
}

static void print_table(void)
{
    int width = 0;
    for (int i = 0; skv_builtin_scene(i); i++) {
        int length = (int)strlen(skv_builtin_scene(i)->name);
        width = length > width ? length : width;
    }
    for (int i = 0; skv_builtin_scene(i); i++)
        printf("%-*s  %s\n", width, skv_builtin_scene(i)->name, skv_builtin_scene(i)->title);
}

int scenes_command(const cli_options *options, skv_error *error)
{
    if (options->json)
        return print_json(error) ? STATUS_BAD : STATUS_DONE;
    print_table();
    return STATUS_DONE;
}
