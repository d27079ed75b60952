/* What --help and help print. The options come from their table, the settings from the scene
 * layer's registry, so neither can fall behind. */
#include "commands.h"

#include <string.h>

#include "skvalp/experiments.h"

void help_print(void)
{
    puts("skvalp - a real-time 2D particle fluid\n"
         "\n"
         "usage: skvalp COMMAND [OPTION...]\n"
         "\n"
         "  run SCENE     simulate a scene; write numbers, tables, pictures, a video\n"
         "  check SCENE   load a scene and say what it is, or what is wrong with it\n"
         "  scenes        list the built-in scenes\n"
         "  lab           measure the fluid and compare it with the textbook\n"
         "  bench         measure what a step costs\n"
         "  replay FILE   play a game again, from a file or a link, and see that it goes as it "
         "went\n"
         "  share FILE    make a link of a game, or of a scene\n"
         "  help set      list the fields that --set can change\n"
         "\n"
         "SCENE is a built-in name, a .json or a .png. 'skvalp COMMAND --help' lists the options.\n"
         "Exit status: 0 done, 1 a check failed, 2 bad usage or bad input.");
}

void help_print_command(command which)
{
    switch (which) {
    case COMMAND_RUN:
        puts("usage: skvalp run SCENE [OPTION...]\n\nSimulates a scene and reports on it.\n");
        break;
    case COMMAND_SCENES:
        puts("usage: skvalp scenes [OPTION...]\n\nLists the built-in scenes.\n");
        break;
    case COMMAND_CHECK:
        puts("usage: skvalp check SCENE [OPTION...]\n\n"
             "Loads and validates a scene without running it.\n");
        break;
    case COMMAND_BENCH:
        puts("usage: skvalp bench [OPTION...]\n\n"
             "Measures what a step costs: at rest and in motion, with both pressure laws, from\n"
             "thousands to a million particles, on one thread and on all, beside the reference\n"
             "solver. Takes minutes; wants the machine to itself.\n");
        break;
    case COMMAND_REPLAY:
        puts("usage: skvalp replay FILE.skvr|LINK [OPTION...]\n\n"
             "Plays a replay and compares every hash written down in it. Exit status 1 if the "
             "world\n"
             "goes another way than when it was recorded. 'skvalp run FILE.skvr' makes pictures,\n"
             "videos and tables of it.\n");
        break;
    case COMMAND_SHARE:
        puts("usage: skvalp share FILE.skvr|SCENE [OPTION...]\n\n"
             "Plays a replay to its end, as replay does, and prints a link that holds all of it: "
             "the\n"
             "scene, and what was done since. Of a scene alone the link holds the scene.\n");
        break;
    case COMMAND_LAB:
        puts("usage: skvalp lab [EXPERIMENT...] [OPTION...]\n\n"
             "Runs experiments, all of them if none is named, and compares what is measured with\n"
             "theory. Exit status 1 if a figure misses what it must reach.\n");
        break;
    }
    options_print_help(which, stdout);
    if (which == COMMAND_LAB)
        help_print_lab();
}

/* "gravity  0.5..100 m/s^2, default 9.81", and below it what it means. */
static void print_field(const skv_field *field)
{
    printf("%s  ", field->path);
    switch (field->type) {
    case SKV_FIELD_NUMBER:
    case SKV_FIELD_INTEGER:
        printf("%.10g..%.10g%s%s", field->minimum, field->maximum, *field->unit ? " " : "",
               field->unit);
        break;
    case SKV_FIELD_TEXT:
        printf("text, at most %.10g bytes", field->maximum);
        break;
    case SKV_FIELD_CHOICE:
        fputs(field->choices, stdout);
        break;
    case SKV_FIELD_BOOLEAN:
        fputs("true|false", stdout);
        break;
    }
    printf("%s%s\n    %s\n", *field->default_text ? ", default " : "", field->default_text,
           field->help);
}

void help_print_settings(void)
{
    puts("Fields of a scene, for scene files and for --set PATH=VALUE. With --set the brackets of "
         "a\n"
         "list hold a number, counted from 0: --set water[0].x1=0.3\n");
    for (int i = 0; skv_scene_field(i); i++)
        print_field(skv_scene_field(i));
}

void help_print_lab(void)
{
    puts("\nExperiments:");
    for (int i = 0; skv_experiment_info(i); i++) {
        const skv_experiment *info = skv_experiment_info(i);
        printf("  %-14s %s\n", info->name, info->description);
    }
    puts("\nParameters, for --set PATH=VALUE:");
    for (int i = 0; skv_lab_parameter(i); i++)
        print_field(skv_lab_parameter(i));
}
