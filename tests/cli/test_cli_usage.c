/* Bad usage: exit status 2, exactly one line on stderr that names the place and the remedy, nothing
 * on stdout, no file left. And the commands that only print. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>
#include <jansson.h>

#include "program.h"
#include "skvalp/scene.h"

static const struct {
    const char *arguments[8];
    const char *says[2]; /* both must be in the line */
} bad[] = {
    {{NULL}, {"no command", "skvalp --help"}},
    {{"rnu", "pool"}, {"rnu: no such command", "run?"}},
    {{"xyzzy"}, {"xyzzy: no such command", "--help"}},
    {{"bnech"}, {"bnech: no such command", "bench?"}},
    {{"help", "me"}, {"help:", "help set"}},
    {{"lab", "u-tub"}, {"there is no experiment 'u-tub'", "u-tube?"}},
    {{"lab", "xyzzy"}, {"there is no experiment 'xyzzy'", "lab --help"}},
    {{"lab", "--set", "gravty=3"}, {"gravty", "lab --help"}},
    {{"lab", "--set", "gravity=-3"}, {"gravity: -3 is", "0.5 to 100 m/s^2"}},
    {{"lab", "--set", "gravity"}, {"'gravity' is not PATH=VALUE", "help"}},
    {{"lab", "--plot", "-"}, {"--plot: '-'", "name a folder"}},
    {{"lab", "--plot", "none/a"}, {"none/a", "name another folder"}},
    {{"lab", "--seconds", "1"}, {"--seconds: 'lab' does not take it", "lab --help"}},
    {{"lab", "u-tube", "--set", "particles=200"}, {"u-tube.arm", "take particles=600 or more"}},
    {{"bench", "pool"}, {"bench: it takes no name", "use run"}},
    {{"bench", "--seconds", "1"}, {"--seconds: 'bench' does not take it", "bench --help"}},
    {{"bench", "--particles", "10"}, {"--particles: '10' is out of range", "1000 to 2000000"}},
    {{"bench", "--plot", "-"}, {"--plot: '-'", "name a file"}},
    {{"bench", "--plot", "none/a.svg"}, {"none/a.svg: cannot be written", "folder that exists"}},
    {{"bench", "--json", "--markdown"}, {"--markdown: it and --json", "omit one"}},
    {{"bench", "--csv", "-", "--markdown"}, {"--markdown: it and --csv -", "omit one"}},
    {{"bench", "--csv", "-", "--json"}, {"--csv: '-' and --json", "name a file"}},
    {{"bench", "--csv", "a", "--plot", "./a"}, {"./a: two outputs", "second file"}},
    {{"run", "pool", "--plot", "a.svg"}, {"--plot: 'run' does not take it", "run --help"}},
    {{"run"}, {"run: SCENE is missing", "skvalp scenes"}},
    {{"check"}, {"check: SCENE is missing", "skvalp scenes"}},
    {{"scenes", "pool"}, {"scenes:", "'pool'"}},
    {{"run", "pool", "waves"}, {"one scene at a time", "'waves'"}},
    {{"run", "no-such-scene"}, {"no-such-scene", ""}},
    {{"run", "no-such-file.json"}, {"no-such-file.json", ""}},
    {{"run", "no-such-file.png"}, {"no-such-file.png", ""}},
    {{"run", "pool", "--secnds", "1"}, {"--secnds: no such option", "--seconds?"}},
    {{"run", "pool", "--sec", "1"}, {"--sec: no such option", "--seconds?"}},
    {{"run", "pool", "--partcles=5"}, {"--partcles: no such option", "--particles?"}},
    {{"run", "pool", "--qqqqqqqq"}, {"--qqqqqqqq: no such option", "run --help"}},
    {{"check", "pool", "--png", "a.png"}, {"--png: 'check' does not take it", "check --help"}},
    {{"scenes", "--threads", "1"}, {"--threads: 'scenes' does not take it", "scenes --help"}},
    {{"run", "pool", "-x"}, {"-x: no such option", "two dashes"}},
    {{"run", "pool", "--json=1"}, {"--json: it takes no value", "=1"}},
    {{"run", "pool", "--seconds"}, {"--seconds: the value is missing", "--seconds T"}},
    {{"run", "pool", "--seconds", "--json"}, {"--seconds: the value is missing", "--seconds T"}},
    {{"run", "pool", "--seconds", "nan"}, {"--seconds: 'nan' is not a number", "0 to 86400"}},
    {{"run", "pool", "--seconds", "inf"}, {"--seconds: 'inf' is not a number", "0 to 86400"}},
    {{"run", "pool", "--seconds", ""}, {"--seconds: it is empty", "--seconds T"}},
    {{"run", "pool", "--particles="}, {"--particles: it is empty", "--particles N"}},
    {{"bench", "--threads", ""}, {"--threads: it is empty", "--threads K"}},
    {{"run", "pool", "--law", ""}, {"--law: it is empty", "--law LAW"}},
    {{"run", "pool", "--size="}, {"--size: it is empty", "--size WxH"}},
    {{"run", "pool", "--view="}, {"--view: it is empty", "--view VIEW"}},
    {{"run", "pool", "--set", ""}, {"--set: it is empty", "--set PATH=VALUE"}},
    {{""}, {"the command is empty", "skvalp --help"}},
    {{"run", ""}, {"run: the name is empty", "name a scene or a file"}},
    {{"check", ""}, {"check: the name is empty", "name a scene or a file"}},
    {{"replay", ""}, {"replay: the name is empty", "name a scene or a file"}},
    {{"lab", ""}, {"lab: the name is empty", "name an experiment"}},
    {{"run", "\xc2\x9b"
             "2J.json"},
     {"?2J.json: cannot be opened", ""}},
    {{"run", "pool", "--seconds", " 1"}, {"--seconds: ' 1' is not a number", "0 to 86400"}},
    {{"run", "pool", "--seconds", "0x10"}, {"--seconds: '0x10' is not a number", "0 to 86400"}},
    {{"run", "pool", "--seconds", "1s"}, {"--seconds: '1s' is not a number", "0 to 86400"}},
    {{"run", "pool", "--seconds", "-1"}, {"--seconds: '-1' is out of range", "0 to 86400"}},
    {{"run", "pool", "--seconds", "1e9"}, {"--seconds: '1e9' is out of range", "0 to 86400"}},
    {{"run", "pool", "--seconds", "1e999"}, {"--seconds: '1e999' is not a", "0 to 86400"}},
    {{"run", "pool", "--particles", "0"}, {"--particles: '0' is out of range", "1 to 2000000"}},
    {{"run", "pool", "--particles", "3000000"}, {"is out of range", "1 to 2000000"}},
    {{"run", "pool", "--particles", "1e3"}, {"is not a whole number", "1 to 2000000"}},
    {{"run", "pool", "--particles", "99999999999999999999"}, {"is out of", "1 to 2000000"}},
    {{"run", "pool", "--threads", "-1"}, {"--threads: '-1' is out of range", "0 to 64"}},
    {{"run", "pool", "--threads", "65"}, {"--threads: '65' is out of range", "0 to 64"}},
    {{"run", "pool", "--law", "water"}, {"--law: 'water'", "calibrated or clavet"}},
    {{"run", "pool", "--set", "fluid.spacing"}, {"--set: 'fluid.spacing'", "help set"}},
    {{"run", "pool", "--set", "=1"}, {"--set: '=1'", "help set"}},
    {{"run", "pool", "--set", "fluid.spcing=0.01"}, {"fluid.spcing", ""}},
    {{"run", "pool", "--set", "fluid.spacing=wide"}, {"fluid.spacing", ""}},
    {{"run", "pool", "--set", "fluid.spacing=-1"}, {"fluid.spacing", ""}},
    {{"run", "pool", "--at", "1"}, {"--at: there is no snapshot", "--snapshot FILE.skv"}},
    {{"run", "pool", "--snapshot", "a.skv", "--at", "3", "--seconds", "2"},
     {"--at", "past the end"}},
    {{"run", "nowhere.skv"}, {"nowhere.skv: cannot be opened", "--snapshot"}},
    {{"run", "pool", "--trace-every", "0.1"}, {"--trace-every: there is no trace", "--trace FILE"}},
    {{"run", "pool", "--trace", "t.csv", "--trace-every", "0"}, {"'0' is out of range", "0.001"}},
    {{"run", "pool", "--size", "640x480"}, {"--size: there is no picture", "--png"}},
    {{"run", "pool", "--tracers"}, {"--tracers: there is no picture", "--png"}},
    {{"run", "pool", "--png", "a.png", "--size", "640"}, {"--size: '640'", "1280x720"}},
    {{"run", "pool", "--png", "a.png", "--size", "8x8"}, {"'8x8' is out of range", "16 to 8192"}},
    {{"run", "pool", "--png", "a.png", "--size", "99999999999x16"}, {"is out of range", "8192"}},
    {{"run", "pool", "--video", "a.mp4", "--size", "641x480"}, {"odd", "640x480"}},
    {{"run", "pool", "--video", "a.avi"}, {"--video: 'a.avi'", "FILE.mp4"}},
    {{"run", "pool", "--png", "-"}, {"--png: '-'", "name a file"}},
    {{"run", "pool", "--png", ""}, {"--png: it is empty", "--png FILE"}},
    {{"run", "pool", "--csv", "-", "--json"}, {"--csv: '-' and --json", "name a file"}},
    {{"run", "pool", "--trace", "-", "--json"}, {"--trace: '-' and --json", "name a file"}},
    {{"run", "pool", "--trace", "-", "--csv", "-"}, {"--trace: '-' and --csv", "name a file"}},
    {{"run", "pool", "--csv", "a", "--trace", "./a"}, {"./a: two outputs", "second file"}},
    {{"run", "pool", "--csv", "none/a.csv"},
     {"none/a.csv: cannot be written", "folder that exists"}},
    {{"run", "pool", "--trace", "none/a.csv"}, {"none/a.csv: cannot be", "folder that exists"}},
    {{"run", "pool", "--png", "none/a.png"}, {"none/a.png: cannot be", "folder that exists"}},
    {{"run", "pool", "--video", "none/a.mp4"}, {"none/a.mp4: cannot be", "folder that exists"}},
    {{"run", "pool", "--csv", "."}, {".: cannot be written", "not a folder"}},
    {{"run", "pool", "--csv", "/proc/a.csv"}, {"/proc/a.csv: cannot be written", ""}},
    {{"run", "pool\nskvalp: two lines", "--seconds", "0"}, {"pool?skvalp", ""}},
};

static void test_bad_usage(void **state)
{
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const char *arguments[10] = {"skvalp"};
        for (int k = 0; k < 8; k++)
            arguments[k + 1] = bad[i].arguments[k];
        program_result result = program_run(*state, arguments);
        const char *line = result.err;
        if (result.status != 2 || count_lines(line) != 1 || line[strlen(line) - 1] != '\n' ||
            strncmp(line, "skvalp: ", 8) != 0 || !strstr(line, bad[i].says[0]) ||
            !strstr(line, bad[i].says[1]) || *result.out || folder_entries(*state) != 0) {
            fail_msg("case %zu (%s %s %s): status %d, stdout '%s', %d files, stderr '%s'", i,
                     arguments[1], arguments[1] ? arguments[2] : "",
                     arguments[1] && arguments[2] ? arguments[3] : "", result.status, result.out,
                     folder_entries(*state), line);
        }
        program_free(&result);
    }
}

/* What succeeds with text on stdout and nothing on stderr. */
static void expect_text(const char *folder, const char *const *arguments, const char *says)
{
    program_result result = program_run(folder, arguments);
    assert_int_equal(result.status, 0);
    assert_string_equal(result.err, "");
    assert_non_null(strstr(result.out, says));
    program_free(&result);
}

static void test_help(void **state)
{
    expect_text(*state, (const char *const[]){"skvalp", "--version", NULL}, skv_version());
    expect_text(*state, (const char *const[]){"skvalp", "--help", NULL}, "check SCENE");
    expect_text(*state, (const char *const[]){"skvalp", "help", NULL}, "check SCENE");
    expect_text(*state, (const char *const[]){"skvalp", "help", "set", NULL}, "fluid.law");
    expect_text(*state, (const char *const[]){"skvalp", "run", "--help", NULL}, "--trace-every S");
    expect_text(*state, (const char *const[]){"skvalp", "run", "x", "-h", NULL}, "--seconds T");
    expect_text(*state, (const char *const[]){"skvalp", "scenes", "--help", NULL}, "--json");
    expect_text(*state, (const char *const[]){"skvalp", "help", "bench", NULL}, "--plot FILE.svg");

    expect_text(*state, (const char *const[]){"skvalp", "lab", "--help", NULL}, "u-tube.arm");
    expect_text(*state, (const char *const[]){"skvalp", "help", "lab", NULL}, "calibrated|clavet");

    program_result help = SKVALP(*state, "check", "--help");
    assert_null(strstr(help.out, "--png"));
    program_free(&help);
}

static void test_scenes(void **state)
{
    program_result list = SKVALP(*state, "scenes");
    assert_int_equal(list.status, 0);
    assert_string_equal(list.err, "");
    assert_null(strchr(list.out, '\033'));
    char *line = strtok(list.out, "\n");
    const char *first_title = NULL;
    for (int i = 0; skv_builtin_scene(i); i++, line = strtok(NULL, "\n")) {
        const skv_scene_info *scene = skv_builtin_scene(i);
        assert_non_null(line);
        assert_memory_equal(line, scene->name, strlen(scene->name));
        const char *title = strstr(line + strlen(scene->name), scene->title);
        assert_non_null(title);
        /* Aligned: every title begins in the same column. */
        long column = title - line;
        static long first_column;
        first_column = first_title ? first_column : column;
        first_title = title;
        assert_int_equal(column, first_column);
    }
    assert_null(line);
    assert_non_null(first_title);
    program_free(&list);

    list = SKVALP(*state, "scenes", "--json");
    json_t *array = json_loads(list.out, JSON_REJECT_DUPLICATES, NULL);
    assert_true(json_is_array(array));
    for (int i = 0; i < (int)json_array_size(array); i++) {
        const skv_scene_info *scene = skv_builtin_scene(i);
        json_t *entry = json_array_get(array, (size_t)i);
        assert_string_equal(json_string_value(json_object_get(entry, "name")), scene->name);
        assert_string_equal(json_string_value(json_object_get(entry, "title")), scene->title);
        assert_string_equal(json_string_value(json_object_get(entry, "description")),
                            scene->description);
    }
    assert_null(skv_builtin_scene((int)json_array_size(array)));
    json_decref(array);
    program_free(&list);
}

/* That they are sound with as many particles as each has is said by scene/test_builtin. */
static void test_check(void **state)
{
    for (int i = 0; skv_builtin_scene(i); i++) {
        const char *name = skv_builtin_scene(i)->name;
        program_result result =
            SKVALP(*state, "check", name, "--particles", "400", "--threads", "1");
        assert_int_equal(result.status, 0);
        assert_int_equal(count_lines(result.out), 1);
        assert_memory_equal(result.out, name, strlen(name));
        assert_non_null(strstr(result.out, "particles"));
        program_free(&result);
    }
    program_result result =
        SKVALP(*state, "check", "pool", "--particles", "400", "--threads", "2", "--quiet");
    assert_int_equal(result.status, 0);
    assert_string_equal(result.out, "");
    program_free(&result);

    /* Broken on line 3. */
    file_write(*state, "broken.json", "{\n\"name\": \"x\",\n\"fluid\": {,}\n}\n");
    result = SKVALP(*state, "check", "broken.json");
    assert_int_equal(result.status, 2);
    assert_int_equal(count_lines(result.err), 1);
    assert_non_null(strstr(result.err, "skvalp: broken.json:3"));
    assert_string_equal(result.out, "");
    program_free(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_bad_usage, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_help, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_scenes, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_check, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
