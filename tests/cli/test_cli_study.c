/* Studies on the command line: the list of jobs, the jobs, and the gathering of their tables. What
 * several workers make of a list is in test_cli_parallel.sh. */
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "program.h"

#define SWEEP "--sweep", "particles=200:210:3"

static program_result list(const char *folder, const char *jobs)
{
    return SKVALP(folder, "lab", "momentum", SWEEP, "--jobs", jobs);
}

/* Runs a list as a shell does. */
static void run_list(const char *folder, const char *text)
{
    file_write(folder, "jobs.txt", text);
    program_result shell = program_run(folder, (const char *const[]){"sh", "-e", "jobs.txt", NULL});
    assert_string_equal(shell.err, "");
    assert_string_equal(shell.out, "");
    assert_int_equal(shell.status, 0);
    program_free(&shell);
}

/* A folder whose study is done, with the gathered table. */
static char *done(const char *folder, const char *jobs)
{
    program_result printed = list(folder, jobs);
    assert_int_equal(printed.status, 0);
    /* The program is called as its test calls it. */
    char *script = malloc(65536);
    assert_non_null(script);
    int length = snprintf(script, 65536, "PATH='%s':$PATH\n%s", SKV_BINARY_DIR, printed.out);
    assert_true(length < 65536);
    run_list(folder, script);
    free(script);
    program_free(&printed);
    program_result gathered = SKVALP(folder, "lab", "--gather", jobs);
    assert_int_equal(gathered.status, 0);
    assert_string_equal(gathered.err, "");
    free(gathered.err);
    return gathered.out;
}

/* One command a line, with all settings, and a file that is called after its values. Nothing is
 * run, and the list is the same each time. */
static void test_list(void **state)
{
    for (int again = 0; again < 2; again++) {
        program_result printed = SKVALP(*state, "lab", "u-tube", "--law", "clavet", "--sweep",
                                        "substeps=4,8", "--set", "scale=0.50", "--sweep",
                                        "u-tube.arm=0.1:0.2:3", "--starts", "2", "--jobs", "runs/");
        assert_int_equal(printed.status, 0);
        assert_string_equal(printed.err, "");
        assert_int_equal(count_lines(printed.out), 6);
        assert_non_null(strstr(
            printed.out,
            "skvalp lab u-tube --set fluid.law=clavet --set scale=0.5 --set substeps=4 --set "
            "u-tube.arm=0.15 --starts 2 --threads 1 "
            "--job=runs/u-tube,substeps=4,u-tube.arm=0.15,starts=2.csv\n"));
        program_free(&printed);
        assert_int_equal(folder_entries(*state), 1);
        assert_true(file_exists(*state, "runs/study.txt"));
    }
}

/* A folder's name that a shell would take apart; the table is that of plain ones. */
static void test_quotes(void **state)
{
    static const char *const folders[] = {"plain", "it's a \"$HOME\" {} `ls`; *", "--odd"};
    char *expected = done(*state, folders[0]);
    assert_int_equal(count_lines(expected), 4);
    assert_non_null(strstr(expected, ",momentum,205,momentum drift in 10 s,,"));
    char *other = done(*state, folders[1]);
    assert_string_equal(other, expected);
    free(other);
    program_result odd = SKVALP(*state, "lab", "momentum", SWEEP, "--jobs=--odd");
    assert_non_null(strstr(odd.out, " --job=--odd/momentum,particles=200.csv\n"));
    program_free(&odd);
    free(expected);
}

/* A whole table is left as it is, even where another would come out; what is no table is, too, and
 * said. */
static void test_a_job_is_done_once(void **state)
{
    free(done(*state, "runs"));
    static const char *const job[] = {
        "skvalp", "lab",           "momentum",
        "--set",  "particles=205", "--job=runs/momentum,particles=205.csv",
        NULL};
    const char *name = "runs/momentum,particles=205.csv";
    /* The same table with another verdict. */
    char *table = file_read(*state, name), *pass = strstr(table, ",true,");
    assert_non_null(pass);
    char changed[2048];
    snprintf(changed, sizeof changed, "%.*s,false,%s", (int)(pass - table), table, pass + 6);
    file_write(*state, name, changed);
    program_result again = program_run(*state, job);
    assert_int_equal(again.status, 0);
    assert_string_equal(again.out, "");
    char *after = file_read(*state, name);
    assert_string_equal(after, changed);
    program_free(&again);
    free(after);
    static const char *const wrong[] = {"", "notes of mine\n"};
    for (int i = 0; i < 3; i++) {
        snprintf(changed, sizeof changed, "%.*s", (int)strlen(table) - 2, table);
        const char *text = i < 2 ? wrong[i] : changed;
        file_write(*state, name, text);
        again = program_run(*state, job);
        assert_int_equal(again.status, 2);
        assert_int_equal(count_lines(again.err), 1);
        assert_non_null(strstr(again.err, "particles=205.csv: line "));
        assert_non_null(strstr(again.err, "; remove it and run its job again"));
        after = file_read(*state, name);
        assert_string_equal(after, text);
        program_free(&again);
        free(after);
    }
    free(table);
}

/* A figure that misses what it must reach is a finding; a set-up that cannot be is an error, and
 * leaves nothing. */
static void test_what_a_job_finds(void **state)
{
    program_result miss = SKVALP(*state, "lab", "hydrostatics", "--set", "particles=600", "--law",
                                 "clavet", "--job", "miss.csv");
    assert_int_equal(miss.status, 0);
    assert_string_equal(miss.out, "");
    char *table = file_read(*state, "miss.csv");
    assert_non_null(strstr(table, ",false,1,0,,\n"));
    assert_int_equal(count_lines(table), 8);
    free(table);
    program_free(&miss);
    program_result none =
        SKVALP(*state, "lab", "orifice", "--set", "particles=400", "--job", "none.csv");
    assert_int_equal(none.status, 2);
    assert_non_null(strstr(none.err, "orifice.slot: 0.1 m"));
    program_free(&none);
    assert_int_equal(folder_entries(*state), 1);
}

static void test_gather(void **state)
{
    char *table = done(*state, "runs");
    /* Into a file, with a picture; of a part of the study, and in another order. */
    program_result files =
        SKVALP(*state, "lab", "--gather", "runs", "--csv", "table.csv", "--plot", "pictures");
    assert_int_equal(files.status, 0);
    assert_string_equal(files.out, "");
    char *written = file_read(*state, "table.csv");
    char *picture = file_read(*state, "pictures/momentum.svg");
    assert_string_equal(written, table);
    assert_non_null(strstr(picture, ">momentum drift in 10 s<"));
    program_free(&files);
    free(written);
    free(picture);
    program_result part =
        SKVALP(*state, "lab", "momentum", "--sweep", "particles=210,200", "--gather", "runs");
    assert_int_equal(part.status, 0);
    const char *first = strstr(part.out, ",momentum,210,"), *last = strstr(table, ",momentum,210,");
    assert_int_equal(count_lines(part.out), 3);
    assert_true(first && first < strstr(part.out, ",momentum,200,"));
    assert_memory_equal(first, last, strcspn(last, "\n"));
    program_free(&part);
    /* A picture that cannot be drawn leaves nothing. */
    program_result none = SKVALP(*state, "lab", "momentum", "--sweep", "fluid.law=clavet",
                                 "--gather", "runs", "--csv", "new.csv", "--plot", "new");
    assert_int_equal(none.status, 2);
    assert_non_null(strstr(none.err, "skvalp: plot: no number is swept"));
    assert_false(file_exists(*state, "new.csv"));
    assert_false(file_exists(*state, "new"));
    program_free(&none);
    /* What lacks is named, and the rest is there. */
    char path[4096];
    snprintf(path, sizeof path, "%s/runs/momentum,particles=205.csv", (const char *)*state);
    assert_int_equal(remove(path), 0);
    program_result lack = SKVALP(*state, "lab", "--gather", "runs");
    assert_int_equal(lack.status, 1);
    assert_int_equal(count_lines(lack.out), 3);
    assert_string_equal(lack.err,
                        "skvalp: note: runs/momentum,particles=205.csv: not there yet\n"
                        "skvalp: lab: 1 of 3 runs lack; run the jobs again, those that are done "
                        "end at once\n");
    program_free(&lack);
    /* Every file that is none is named, and no table is written. */
    assert_int_equal(mkfifo(path, 0600), 0);
    file_write(*state, "runs/momentum,particles=210.csv", "x,y\n");
    program_result bad =
        SKVALP(*state, "lab", "--gather", "runs", "--csv", "new.csv", "--plot", "new");
    assert_int_equal(bad.status, 2);
    assert_int_equal(count_lines(bad.err), 2);
    assert_non_null(strstr(bad.err, "skvalp: runs/momentum,particles=205.csv: it is no file"));
    assert_non_null(strstr(bad.err, "skvalp: runs/momentum,particles=210.csv: line 1: "));
    assert_false(file_exists(*state, "new.csv"));
    assert_false(file_exists(*state, "new"));
    program_free(&bad);
    free(table);
}

/* The same study with other values shares its folder; another study does not. */
static void test_a_folder_is_of_one_study(void **state)
{
    free(done(*state, "runs"));
    program_result more =
        SKVALP(*state, "lab", "momentum", "--sweep", "particles=205,300", "--jobs", "runs");
    assert_int_equal(more.status, 0);
    program_free(&more);
    program_result gathered = SKVALP(*state, "lab", "--gather", "runs");
    assert_int_equal(gathered.status, 1);
    assert_int_equal(count_lines(gathered.out), 2);
    assert_non_null(strstr(gathered.err, "1 of 2 runs lack"));
    program_free(&gathered);
    char *before = file_read(*state, "runs/study.txt");
    program_result other =
        SKVALP(*state, "lab", "momentum", SWEEP, "--set", "momentum.spin=0", "--jobs", "runs");
    assert_int_equal(other.status, 2);
    assert_string_equal(other.out, "");
    assert_non_null(strstr(other.err, "runs: it is the folder of another study"));
    program_free(&other);
    char *after = file_read(*state, "runs/study.txt");
    assert_string_equal(after, before);
    free(after);
    free(before);
    file_write(*state, "runs/study.txt", "momentum\n--sweep=particles=\n");
    for (int gather = 0; gather < 2; gather++) {
        program_result damaged =
            gather ? SKVALP(*state, "lab", "--gather", "runs") : list(*state, "runs");
        assert_int_equal(damaged.status, 2);
        assert_string_equal(damaged.out, "");
        assert_non_null(strstr(damaged.err, "skvalp: runs/study.txt: particles: "));
        program_free(&damaged);
    }
}

/* One line, exit status 2, and no trace, before anything runs. */
static void test_bad_usage(void **state)
{
    static const struct {
        const char *arguments[9], *said;
    } cases[] = {
        {{"momentum", SWEEP}, "--sweep: it makes a study; add --jobs DIR"},
        {{SWEEP, "--jobs", "runs"}, "a study is of one experiment, but 0 are named"},
        {{"rest", "slosh", SWEEP, "--jobs", "runs"}, "but 2 are named; name one"},
        {{"moment", SWEEP, "--jobs", "runs"}, "did you mean momentum?"},
        {{"momentum", "--jobs", "runs"}, "--jobs: nothing is swept; add --sweep"},
        {{"momentum", "--sweep", "particles", "--jobs", "runs"},
         "--sweep: 'particles' is not PATH=VALUE; see 'skvalp lab --help'"},
        {{"momentum", "--sweep", "particle=300,400", "--jobs", "runs"}, "no such parameter"},
        {{"momentum", "--sweep", "particles=300:400:0", "--jobs", "runs"}, "from 2 on"},
        {{"momentum", "--sweep", "particles=30:400:2", "--jobs", "runs"}, "30 is out of range"},
        {{"momentum", "--sweep", "scale=1:2:1000000000", "--jobs", "runs"}, "100000 are allowed"},
        {{"momentum", SWEEP, "--jobs", "taken"}, "taken: Not a directory; name another"},
        {{"momentum", SWEEP, "--jobs", "no/where"}, "no/where: "},
        {{"momentum", SWEEP, "--jobs", "a\nb"}, "--jobs: the folder's name has a line break"},
        {{"momentum", SWEEP, "--jobs", "-"}, "--jobs: '-' is not supported; name a folder"},
        {{"momentum", SWEEP, "--jobs", "runs", "--json"}, "nothing is written for --json"},
        {{"momentum", SWEEP, "--jobs", "runs", "--gather", "runs"}, "at a time; omit"},
        {{"momentum", SWEEP, "--job", "run.csv"}, "--job: it is one run; say --set"},
        {{"--job", "run.csv"}, "but 0 are named"},
        {{"momentum", "--job", "no/where.csv"}, "no/where.csv: cannot be written"},
        {{"momentum", "--csv", "rows.csv"}, "--csv: it is where --gather writes"},
        {{"--gather", "runs"}, "runs: there is no study.txt; name the folder"},
        {{"momentum", "--gather", "runs"}, "add --sweep, or omit the rest"},
    };
    file_write(*state, "taken", "");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *arguments[12] = {"skvalp", "lab"};
        memcpy(arguments + 2, cases[i].arguments, sizeof cases[i].arguments);
        program_result result = program_run(*state, arguments);
        assert_int_equal(result.status, 2);
        assert_string_equal(result.out, "");
        assert_int_equal(count_lines(result.err), 1);
        if (!strstr(result.err, cases[i].said))
            fail_msg("'%s' is not said by '%s'", cases[i].said, result.err);
        program_free(&result);
        assert_int_equal(folder_entries(*state), 1);
    }
}

/* Ctrl+C in the middle of a run leaves the folder as it was. */
static void test_interrupted(void **state)
{
    for (int i = 0; i < 2; i++) {
        pid_t job =
            program_start(*state, (const char *const[]){"skvalp", "lab", "momentum", "--set",
                                                        "particles=100000", "--job=run.csv", NULL});
        folder_await(*state, 1);
        assert_int_equal(kill(job, i ? SIGTERM : SIGINT), 0);
        assert_int_equal(program_wait(job), 128 + (i ? SIGTERM : SIGINT));
        assert_int_equal(folder_entries(*state), 0);
    }
}

/* A temporary file that somebody else removes, as a machine may that sees no locks of this one;
 * once more if the job was done before that. */
static void test_swept_away(void **state)
{
    int swept = 0;
    while (swept == 0) {
        pid_t job =
            program_start(*state, (const char *const[]){"skvalp", "lab", "momentum", "--set",
                                                        "particles=2000", "--job=run.csv", NULL});
        folder_await(*state, 1);
        kill(job, SIGSTOP);
        program_result removed = program_run(
            *state, (const char *const[]){"find", ".", "-type", "f", "-delete", "-print", NULL});
        swept = strstr(removed.out, "/.skvalp-") ? 1 : 0;
        program_free(&removed);
        kill(job, SIGCONT);
        assert_int_equal(program_wait(job), 0);
    }
    assert_int_equal(folder_entries(*state), 1);
    char *table = file_read(*state, "run.csv");
    assert_int_equal(count_lines(table), 2);
    free(table);
}

#define IN_A_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_setup, folder_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_A_FOLDER(test_list),
        IN_A_FOLDER(test_quotes),
        IN_A_FOLDER(test_a_job_is_done_once),
        IN_A_FOLDER(test_what_a_job_finds),
        IN_A_FOLDER(test_gather),
        IN_A_FOLDER(test_a_folder_is_of_one_study),
        IN_A_FOLDER(test_bad_usage),
        IN_A_FOLDER(test_interrupted),
        IN_A_FOLDER(test_swept_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
