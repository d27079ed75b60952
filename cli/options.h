/* What a command line asks for, read from argv by one table of options that also writes the help.
 */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include <stdio.h>

#include "skvalp/render.h"
#include "skvalp/scene.h"

/* The commands, as bits, so that the table can say which options belong to which. */
typedef enum command {
    COMMAND_RUN = 1,
    COMMAND_SCENES = 2,
    COMMAND_CHECK = 4,
    COMMAND_BENCH = 8,
    COMMAND_LAB = 16,
    COMMAND_REPLAY = 32,
    COMMAND_SHARE = 64
} command;

/* Smallest and largest side of a picture in pixels. */
#define PICTURE_MIN 16
#define PICTURE_MAX 8192

typedef struct cli_options {
    const char *scene;        /* null for `scenes`, `bench` and `lab` */
    const char **experiments; /* of `lab`, as given; none: all of them; owned */
    int experiment_count;
    double seconds;                        /* negative: what the scene says */
    double trace_every;                    /* s; 0: --trace-every was not given */
    int particles;                         /* 0: what the scene says */
    int threads;                           /* 0: one per core */
    int width, height;                     /* of pictures; 0: chosen from the world's shape */
    const char *png, *video, *csv, *trace; /* null: not wanted */
    const char *snapshot;                  /* null: not wanted */
    const char *page;                      /* of `share`; null: none */
    double at;                             /* s, of the snapshot; negative: the end */
    const char *plot;                      /* of `bench` a file, of `lab` a folder; null: none */
    bool json, tracers, quiet, help;
    bool anyway;            /* of replays and states: whatever they ask for */
    skv_render_style style; /* of pictures */
    const char *styled;     /* an option that was given for it; null: none */
    bool quick, markdown;   /* of `bench` */
    bool cards;             /* of `lab` */
    int starts;             /* of `lab`; 0: as many as an experiment needs */
    /* Of studies, in `lab`; null: not wanted. */
    const char *jobs, *gather; /* folders */
    const char *job;           /* a file */
    skv_setting *sweeps;       /* --sweep, in the order of the command line; owned */
    int sweep_count;
    const char *program;   /* as it was called */
    skv_setting *settings; /* --law and --set, in the order of the command line; owned */
    int setting_count;
} cli_options;

/* Reads the arguments that follow the command's name. `result` needs options_free afterwards, also
 * on failure. With --help the rest is not required to make sense. */
skv_result options_parse(command which, int count, char **arguments, cli_options *result,
                         skv_error *error);
void options_free(cli_options *options);

/* The part of the options that changes a scene while it is loaded. */
skv_scene_options options_for_scene(const cli_options *options);

/* Whether a table goes to stdout, which must then hold nothing else. */
bool options_use_stdout(const cli_options *options);

/* Whether a name is longer than this ending and has it, in any letter case. */
bool ends_with(const char *name, const char *ending);

/* One line per option of a command, for its help. */
void options_print_help(command which, FILE *out);

#endif
