/* skvalp scenes: lists what is built in. */
#include "commands.h"

#include <string.h>

#include "json.h"

static void print_json(void)
{
    putchar('[');
    for (int i = 0; skv_builtin_scene(i); i++) {
        const skv_scene_info *scene = skv_builtin_scene(i);
        fputs(i ? ",\n {\"name\": " : "\n {\"name\": ", stdout);
        json_text(stdout, scene->name);
        fputs(", \"title\": ", stdout);
        json_text(stdout, scene->title);
        fputs(", \"description\": ", stdout);
        json_text(stdout, scene->description);
        putchar('}');
    }
    puts("\n]");
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
    (void)error;
    if (options->json)
        print_json();
    else
        print_table();
    return STATUS_DONE;
}
