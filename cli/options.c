/* Reads argv by one table of options.
 *
 * Invariant: the table is the only place that knows an option; parsing, range messages, suggestions
 * and help all walk it. Values are checked here as far as they can be without a scene, so that bad
 * usage ends before any work begins.
 */
#include "options.h"

#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef enum kind {
    KIND_FLAG,    /* bool */
    KIND_NUMBER,  /* double, minimum..maximum */
    KIND_INTEGER, /* int, minimum..maximum */
    KIND_FILE,    /* const char * */
    KIND_SIZE,    /* WxH into width and height */
    KIND_LAW,     /* a setting of fluid.law */
    KIND_SETTING, /* path=value */
    KIND_SWEEP,   /* path=values */
    KIND_STYLE    /* names of a part of the style */
} kind;

typedef struct option_rule {
    const char *name;     /* without the dashes */
    const char *argument; /* as the help calls it; null for a flag */
    unsigned commands;
    kind kind;
    size_t offset; /* into cli_options; of KIND_STYLE an skv_style_part */
    double minimum, maximum;
    const char *unit;
    const char *help;
} option_rule;

#define AT(field)      offsetof(cli_options, field)
#define SCENE_COMMANDS (COMMAND_RUN | COMMAND_CHECK | COMMAND_SHARE)
#define ALL_COMMANDS                                                                               \
    (SCENE_COMMANDS | COMMAND_SCENES | COMMAND_BENCH | COMMAND_LAB | COMMAND_REPLAY)

static const option_rule rules[] = {
    {"seconds", "T", COMMAND_RUN, KIND_NUMBER, AT(seconds), 0, 86400, " s",
     "simulated time; default: what the scene suggests"},
    {"particles", "N", SCENE_COMMANDS, KIND_INTEGER, AT(particles), 1, SKV_MAX_PARTICLES, "",
     "wanted number of particles; default: the scene's"},
    {"threads", "K", SCENE_COMMANDS | COMMAND_REPLAY, KIND_INTEGER, AT(threads), 0, SKV_MAX_THREADS,
     "", "threads to compute on; 0, the default: one per core"},
    {"law", "LAW", SCENE_COMMANDS | COMMAND_LAB, KIND_LAW, 0, 0, 0, "",
     "pressure law: calibrated or clavet; same as --set fluid.law=LAW"},
    {"set", "PATH=VALUE", SCENE_COMMANDS, KIND_SETTING, 0, 0, 0, "",
     "override a field of the scene, see 'skvalp help set'; may be repeated"},
    {"png", "FILE", COMMAND_RUN, KIND_FILE, AT(png), 0, 0, "", "write a picture of the end"},
    {"video", "FILE.mp4", COMMAND_RUN, KIND_FILE, AT(video), 0, 0, "",
     "write a video, 60 pictures a second (needs ffmpeg)"},
    {"size", "WxH", COMMAND_RUN, KIND_SIZE, 0, PICTURE_MIN, PICTURE_MAX, "",
     "pixels of picture and video; default: the world's shape, longer side 1280"},
    {"view", "VIEW", COMMAND_RUN, KIND_STYLE, SKV_STYLE_VIEW, 0, 0, "", "what the fluid shows"},
    {"overlay", "A,B", COMMAND_RUN, KIND_STYLE, SKV_STYLE_OVERLAY, 0, 0, "",
     "what is drawn over it"},
    {"palette", "NAME", COMMAND_RUN, KIND_STYLE, SKV_STYLE_PALETTE, 0, 0, "", "colours"},
    {"detail", "NAME", COMMAND_RUN, KIND_STYLE, SKV_STYLE_DETAIL, 0, 0, "",
     "how much a picture may cost"},
    {"range", "X", COMMAND_RUN, KIND_NUMBER, AT(style.range), 0, 1e9, "",
     "upper end of the view's scale: Pa m, m/s; 0, the default: what suits the scene"},
    {"tracers", NULL, COMMAND_RUN, KIND_FLAG, AT(tracers), 0, 0, "",
     "the same as --overlay tracers, beside others"},
    {"csv", "FILE", COMMAND_RUN, KIND_FILE, AT(csv), 0, 0, "",
     "write energies, momentum, speeds and volume of every frame; - is stdout"},
    {"trace", "FILE.csv", COMMAND_RUN, KIND_FILE, AT(trace), 0, 0, "",
     "write t,id,x,y,vx,vy,pressure,fluid of every particle; - is stdout"},
    {"trace-every", "S", COMMAND_RUN, KIND_NUMBER, AT(trace_every), 0.001, 86400, " s",
     "time between the moments of --trace; default 0.1"},
    {"snapshot", "FILE.skv", COMMAND_RUN, KIND_FILE, AT(snapshot), 0, 0, "",
     "write the state, for a run that goes on from it"},
    {"at", "S", COMMAND_RUN, KIND_NUMBER, AT(at), 0, 86400, " s",
     "time of --snapshot; default: the end"},
    {"quick", NULL, COMMAND_BENCH, KIND_FLAG, AT(quick), 0, 0, "",
     "up to 100000 particles and fewer rounds: under a minute"},
    {"particles", "N", COMMAND_BENCH, KIND_INTEGER, AT(particles), 1000, SKV_MAX_PARTICLES, "",
     "measure this number of particles only"},
    {"threads", "K", COMMAND_BENCH, KIND_INTEGER, AT(threads), 0, SKV_MAX_THREADS, "",
     "what is measured beside one thread; 0, the default: one per core"},
    {"csv", "FILE", COMMAND_BENCH, KIND_FILE, AT(csv), 0, 0, "",
     "write all figures, with the processor's name; - is stdout"},
    {"plot", "FILE.svg", COMMAND_BENCH, KIND_FILE, AT(plot), 0, 0, "",
     "draw the cost of a particle against their number"},
    {"markdown", NULL, COMMAND_BENCH, KIND_FLAG, AT(markdown), 0, 0, "",
     "print the tables as Markdown"},
    {"set", "PATH=VALUE", COMMAND_LAB, KIND_SETTING, 0, 0, 0, "",
     "change a parameter of the experiments, listed below; may be repeated"},
    {"plot", "DIR", COMMAND_LAB, KIND_FILE, AT(plot), 0, 0, "",
     "write each experiment's curve with the theory over it as DIR/NAME.svg and NAME.csv"},
    {"starts", "N", COMMAND_LAB, KIND_INTEGER, AT(starts), 1, 99, "",
     "run each experiment from N slightly different starts; default: 8 if it scatters, else 1"},
    {"cards", NULL, COMMAND_LAB, KIND_FLAG, AT(cards), 0, 0, "",
     "print the experiments' cards for a class as Markdown, and run nothing"},
    {"sweep", "PATH=VALUES", COMMAND_LAB, KIND_SWEEP, 0, 0, 0, "",
     "a study: take FROM:TO:NUMBER or A,B,C for a parameter; may be repeated"},
    {"jobs", "DIR", COMMAND_LAB, KIND_FILE, AT(jobs), 0, 0, "",
     "print a command for each run of a study, which leaves its table in DIR"},
    {"gather", "DIR", COMMAND_LAB, KIND_FILE, AT(gather), 0, 0, "",
     "make one table of those that a study has left in DIR, and with --plot one picture"},
    {"csv", "FILE", COMMAND_LAB, KIND_FILE, AT(csv), 0, 0, "",
     "where --gather writes; default: stdout"},
    {"job", "FILE.csv", COMMAND_LAB, KIND_FILE, AT(job), 0, 0, "",
     "one run of a study: leave its table in FILE, unless it is there already"},
    {"threads", "K", COMMAND_LAB, KIND_INTEGER, AT(threads), 0, SKV_MAX_THREADS, "",
     "threads to compute on; 0, the default: one per core"},
    {"page", "ADDRESS", COMMAND_SHARE, KIND_FILE, AT(page), 0, 0, "",
     "a web page that hosts Skvalp, to which the link leads; default: the app, by skvalp:"},
    {"json", NULL, COMMAND_RUN | COMMAND_SCENES | COMMAND_BENCH | COMMAND_LAB | COMMAND_REPLAY,
     KIND_FLAG, AT(json), 0, 0, "", "print the result as JSON"},
    {"anyway", NULL, COMMAND_RUN | COMMAND_REPLAY | COMMAND_SHARE, KIND_FLAG, AT(anyway), 0, 0, "",
     "open a state, replay or link even if it asks for hours or very many particles"},
    {"quiet", NULL, ALL_COMMANDS, KIND_FLAG, AT(quiet), 0, 0, "",
     "print errors and what was asked for, nothing else"},
    {"help", NULL, ALL_COMMANDS, KIND_FLAG, AT(help), 0, 0, "", "show this help"},
};
enum { RULE_COUNT = (int)(sizeof rules / sizeof rules[0]) };

static const char *command_name(command which)
{
    switch (which) {
    case COMMAND_RUN:
        return "run";
    case COMMAND_SCENES:
        return "scenes";
    case COMMAND_CHECK:
        return "check";
    case COMMAND_BENCH:
        return "bench";
    case COMMAND_LAB:
        return "lab";
    case COMMAND_REPLAY:
        return "replay";
    case COMMAND_SHARE:
        return "share";
    }
    return "";
}

static skv_result unknown_option(command which, const char *name, skv_error *error)
{
    const char *candidates[RULE_COUNT];
    int count = 0;
    for (int i = 0; i < RULE_COUNT; i++) {
        if (rules[i].commands & which) {
            candidates[count++] = rules[i].name;
        } else if (strcmp(rules[i].name, name) == 0) {
            return skv_fail(error, SKV_ERROR_VALUE,
                            "--%s: '%s' does not take it; see 'skvalp %s --help'", name,
                            command_name(which), command_name(which));
        }
    }
    const char *nearest = skv_nearest_name(name, candidates, count);
    if (nearest) {
        return skv_fail(error, SKV_ERROR_VALUE, "--%s: no such option; did you mean --%s?", name,
                        nearest);
    }
    return skv_fail(error, SKV_ERROR_VALUE, "--%s: no such option; see 'skvalp %s --help'", name,
                    command_name(which));
}

static skv_result out_of_range(const option_rule *rule, const char *text, skv_error *error)
{
    return skv_fail(error, SKV_ERROR_VALUE,
                    "--%s: '%s' is out of range; allowed is %.10g to %.10g%s", rule->name, text,
                    rule->minimum, rule->maximum, rule->unit);
}

static skv_result parse_number(const option_rule *rule, const char *text, double *value,
                               skv_error *error)
{
    if (!skv_parse_number(text, value)) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--%s: '%s' is not a number; allowed is %.10g to %.10g%s", rule->name, text,
                        rule->minimum, rule->maximum, rule->unit);
    }
    if (!(*value >= rule->minimum && *value <= rule->maximum))
        return out_of_range(rule, text, error);
    return SKV_OK;
}

static skv_result parse_integer(const option_rule *rule, const char *text, int *value,
                                skv_error *error)
{
    size_t sign = *text == '-' || *text == '+';
    size_t digits = strspn(text + sign, "0123456789");
    if (digits == 0 || text[sign + digits] != '\0') {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--%s: '%s' is not a whole number; allowed is %.10g to %.10g", rule->name,
                        text, rule->minimum, rule->maximum);
    }
    errno = 0;
    long long number = strtoll(text, NULL, 10);
    if (errno || (double)number < rule->minimum || (double)number > rule->maximum)
        return out_of_range(rule, text, error);
    *value = (int)number;
    return SKV_OK;
}

static skv_result parse_size(const option_rule *rule, const char *text, cli_options *result,
                             skv_error *error)
{
    size_t first = strspn(text, "0123456789");
    size_t second = text[first] == 'x' ? strspn(text + first + 1, "0123456789") : 0;
    if (first == 0 || second == 0 || text[first + 1 + second] != '\0') {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--size: '%s' is not WIDTHxHEIGHT; say for example 1280x720", text);
    }
    double width = strtod(text, NULL), height = strtod(text + first + 1, NULL);
    if (!(fmin(width, height) >= rule->minimum && fmax(width, height) <= rule->maximum))
        return out_of_range(rule, text, error);
    result->width = (int)width;
    result->height = (int)height;
    return SKV_OK;
}

/* Splits "path=value" and adds it to a list that has room; the path is owned. */
static skv_result split_setting(const char *option, const char *text, skv_setting *list, int *count,
                                skv_error *error)
{
    const char *equals = strchr(text, '=');
    if (!equals || equals == text)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--%s: '%s' is not PATH=VALUE; see 'skvalp %s' for the paths", option, text,
                        strcmp(option, "set") == 0 ? "help set" : "lab --help");
    size_t size = strlen(text) + 1;
    char *path = malloc(size);
    if (!path)
        return skv_fail(error, SKV_ERROR_MEMORY, "--%s: out of memory", option);
    memcpy(path, text, size);
    path[equals - text] = '\0';
    list[(*count)++] = (skv_setting){.path = path, .value = path + (equals - text) + 1};
    return SKV_OK;
}

static skv_result parse_setting(const char *text, cli_options *result, skv_error *error)
{
    return split_setting("set", text, result->settings, &result->setting_count, error);
}

static skv_result parse_sweep(const char *text, cli_options *result, skv_error *error)
{
    return split_setting("sweep", text, result->sweeps, &result->sweep_count, error);
}

static skv_result parse_law(const char *text, cli_options *result, skv_error *error)
{
    char setting[64];
    if (strcmp(text, skv_law_name(SKV_LAW_CALIBRATED)) != 0 &&
        strcmp(text, skv_law_name(SKV_LAW_CLAVET)) != 0) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--law: '%s' is no pressure law; allowed is %s or %s", text,
                        skv_law_name(SKV_LAW_CALIBRATED), skv_law_name(SKV_LAW_CLAVET));
    }
    snprintf(setting, sizeof setting, "fluid.law=%s", text);
    return parse_setting(setting, result, error);
}

static skv_result parse_style(const option_rule *rule, const char *text, cli_options *result,
                              skv_error *error)
{
    skv_error cause;
    result->styled = rule->name;
    skv_result set =
        skv_render_style_set(&result->style, (skv_style_part)rule->offset, text, &cause);
    return set ? skv_fail(error, set, "--%s", cause.text) : SKV_OK;
}

/* Puts the value of an option where it belongs. */
static skv_result apply(const option_rule *rule, const char *text, cli_options *result,
                        skv_error *error)
{
    if (!*text)
        return skv_fail(error, SKV_ERROR_VALUE, "--%s: it is empty; say --%s %s", rule->name,
                        rule->name, rule->argument);
    void *field = (char *)result + rule->offset;
    switch (rule->kind) {
    case KIND_FLAG: /* has no value */
        break;
    case KIND_NUMBER:
        return parse_number(rule, text, field, error);
    case KIND_INTEGER:
        return parse_integer(rule, text, field, error);
    case KIND_FILE:
        *(const char **)field = text;
        return SKV_OK;
    case KIND_SIZE:
        return parse_size(rule, text, result, error);
    case KIND_LAW:
        return parse_law(text, result, error);
    case KIND_SETTING:
        return parse_setting(text, result, error);
    case KIND_SWEEP:
        return parse_sweep(text, result, error);
    case KIND_STYLE:
        return parse_style(rule, text, result, error);
    }
    return SKV_ERROR_VALUE;
}

/* Reads the option at arguments[*i], which begins with "--", and its value, which may follow. */
static skv_result parse_option(command which, int count, char **arguments, int *i,
                               cli_options *result, skv_error *error)
{
    const char *name = arguments[*i] + 2;
    size_t length = strcspn(name, "=");
    const option_rule *rule = NULL;
    for (int k = 0; k < RULE_COUNT && !rule; k++) {
        bool same = strlen(rules[k].name) == length && strncmp(rules[k].name, name, length) == 0;
        rule = same && (rules[k].commands & which) ? &rules[k] : NULL;
    }
    if (!rule) {
        char bare[64];
        snprintf(bare, sizeof bare, "%.*s", (int)(length < 60 ? length : 60), name);
        return unknown_option(which, bare, error);
    }
    const char *value = name[length] == '=' ? name + length + 1 : NULL;
    if (rule->kind == KIND_FLAG) {
        if (value)
            return skv_fail(error, SKV_ERROR_VALUE, "--%s: it takes no value; omit '=%s'",
                            rule->name, value);
        *(bool *)((char *)result + rule->offset) = true;
        return SKV_OK;
    }
    if (!value) {
        if (*i + 1 >= count || strncmp(arguments[*i + 1], "--", 2) == 0)
            return skv_fail(error, SKV_ERROR_VALUE, "--%s: the value is missing; say --%s %s",
                            rule->name, rule->name, rule->argument);
        value = arguments[++*i];
    }
    return apply(rule, value, result, error);
}

static bool is_dash(const char *name)
{
    return name && strcmp(name, "-") == 0;
}

bool options_use_stdout(const cli_options *options)
{
    return is_dash(options->csv) || is_dash(options->trace);
}

bool ends_with(const char *name, const char *ending)
{
    size_t length = strlen(name), cut = strlen(ending);
    return length > cut && strcasecmp(name + length - cut, ending) == 0;
}

/* Whether a name has an ending, and one that says something else. */
static bool ends_otherwise(const char *name, const char *ending)
{
    const char *slash = strrchr(name, '/');
    const char *dot = strrchr(slash ? slash : name, '.');
    return dot && dot[1] && !ends_with(name, ending);
}

/* What no single option can know: whether they fit together. */
static skv_result check_together(command which, const cli_options *given, skv_error *error)
{
    bool pictures = given->png || given->video;
    if (which == COMMAND_REPLAY && !given->scene)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "replay: FILE is missing; name a .skvr that was saved, or a link");
    if ((SCENE_COMMANDS & which) && !given->scene) {
        return skv_fail(
            error, SKV_ERROR_VALUE,
            "%s: SCENE is missing; name a built-in scene (see 'skvalp scenes'), a .json "
            "or a .png",
            command_name(which));
    }
    if (given->at >= 0 && !given->snapshot)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--at: there is no snapshot; add --snapshot FILE.skv");
    if (given->trace_every > 0 && !given->trace) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--trace-every: there is no trace; add --trace FILE.csv");
    }
    const char *wasted = given->width             ? "size"
                         : given->tracers         ? "tracers"
                         : given->style.range > 0 ? "range"
                                                  : given->styled;
    if (wasted && !pictures) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--%s: there is no picture; add --png FILE or --video FILE.mp4", wasted);
    }
    if (given->png && ends_otherwise(given->png, ".png")) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--png: '%s' is no .png, and no other kind of picture is written; name it "
                        "FILE.png",
                        given->png);
    }
    if (which == COMMAND_BENCH && given->plot && ends_otherwise(given->plot, ".svg")) {
        return skv_fail(error, SKV_ERROR_VALUE, "--plot: '%s' is no .svg; name it FILE.svg",
                        given->plot);
    }
    if (given->video && !ends_with(given->video, ".mp4")) {
        return skv_fail(error, SKV_ERROR_VALUE, "--video: '%s' is no .mp4; name it FILE.mp4",
                        given->video);
    }
    if (given->video && (given->width % 2 || given->height % 2)) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--size: %dx%d has an odd side, which no mp4 can hold; say %dx%d",
                        given->width, given->height, given->width & ~1, given->height & ~1);
    }
    if (is_dash(given->csv) + is_dash(given->trace) + given->json > 1) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--%s: '-' and --%s would both write to stdout; name a file for one",
                        is_dash(given->trace) ? "trace" : "csv", given->json ? "json" : "csv");
    }
    if (given->cards && (given->json || given->plot || given->starts > 1)) {
        return skv_fail(error, SKV_ERROR_VALUE, "--cards: nothing is run for --%s; omit one",
                        given->json   ? "json"
                        : given->plot ? "plot"
                                      : "starts");
    }
    if (given->markdown && (given->json || is_dash(given->csv))) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "--markdown: it and %s would both write to stdout; omit one",
                        given->json ? "--json" : "--csv -");
    }
    if (is_dash(given->plot))
        return skv_fail(error, SKV_ERROR_VALUE, "--plot: '-' is not supported; name a %s",
                        which == COMMAND_LAB ? "folder" : "file");
    if (is_dash(given->png))
        return skv_fail(error, SKV_ERROR_VALUE, "--png: '-' is not supported; name a file");
    return SKV_OK;
}

/* Takes what is no option: a scene, a file or an experiment. */
static skv_result take_name(command which, const char *text, cli_options *result, skv_error *error)
{
    if (!((SCENE_COMMANDS | COMMAND_REPLAY | COMMAND_LAB) & which)) {
        return skv_fail(
            error, SKV_ERROR_VALUE, "%s: it takes no name, but got '%s'; to %s one, use %s",
            command_name(which), text, which == COMMAND_BENCH ? "simulate" : "look into",
            which == COMMAND_BENCH ? "run" : "check");
    }
    if (!*text) {
        return skv_fail(error, SKV_ERROR_VALUE, "%s: the name is empty; name %s",
                        command_name(which),
                        which == COMMAND_LAB ? "an experiment" : "a scene or a file");
    }
    if (which == COMMAND_LAB) {
        result->experiments[result->experiment_count++] = text;
        return SKV_OK;
    }
    if (result->scene) {
        return skv_fail(error, SKV_ERROR_VALUE,
                        "%s: one scene at a time, but got '%s' and '%s'; omit one",
                        command_name(which), result->scene, text);
    }
    result->scene = text;
    return SKV_OK;
}

skv_result options_parse(command which, int count, char **arguments, cli_options *result,
                         skv_error *error)
{
    *result = (cli_options){.seconds = -1, .at = -1, .style = skv_default_render_style()};
    result->settings = calloc((size_t)count + 1, sizeof *result->settings);
    result->sweeps = calloc((size_t)count + 1, sizeof *result->sweeps);
    result->experiments = calloc((size_t)count + 1, sizeof *result->experiments);
    if (!result->settings || !result->sweeps || !result->experiments)
        return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", command_name(which));
    bool only_names = false;
    for (int i = 0; i < count; i++) {
        const char *text = arguments[i];
        if (!only_names && strcmp(text, "--") == 0) {
            only_names = true;
        } else if (!only_names && strcmp(text, "-h") == 0) {
            result->help = true;
        } else if (!only_names && strncmp(text, "--", 2) == 0) {
            skv_result parsed = parse_option(which, count, arguments, &i, result, error);
            if (parsed)
                return parsed;
        } else if (!only_names && text[0] == '-') {
            return skv_fail(error, SKV_ERROR_VALUE,
                            "%s: no such option; options have two dashes, see 'skvalp %s --help'",
                            text, command_name(which));
        } else {
            skv_result taken = take_name(which, text, result, error);
            if (taken)
                return taken;
        }
    }
    return result->help ? SKV_OK : check_together(which, result, error);
}

void options_free(cli_options *options)
{
    for (int i = 0; i < options->setting_count; i++)
        free((char *)options->settings[i].path);
    for (int i = 0; i < options->sweep_count; i++)
        free((char *)options->sweeps[i].path);
    free(options->settings);
    free(options->sweeps);
    free(options->experiments);
    options->settings = options->sweeps = NULL;
    options->experiments = NULL;
    options->setting_count = options->sweep_count = options->experiment_count = 0;
}

skv_scene_options options_for_scene(const cli_options *options)
{
    skv_scene_options result = skv_default_scene_options();
    result.particles = options->particles;
    result.settings = options->settings;
    result.setting_count = options->setting_count;
    return result;
}

void options_print_help(command which, FILE *out)
{
    for (int i = 0; i < RULE_COUNT; i++) {
        if (rules[i].commands & which) {
            char left[40];
            snprintf(left, sizeof left, "--%s %s", rules[i].name,
                     rules[i].argument ? rules[i].argument : "");
            fprintf(out, "  %-19s %s", left, rules[i].help);
            const skv_style_choice *choice;
            for (int k = 0; rules[i].kind == KIND_STYLE &&
                            (choice = skv_style_choice_at((skv_style_part)rules[i].offset, k));
                 k++)
                fprintf(out, "%s%s", k ? ", " : ": ", choice->name);
            fputc('\n', out);
        }
    }
}
