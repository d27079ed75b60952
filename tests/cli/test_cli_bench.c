/* What bench reports: the JSON contract, figures that agree with each other, and the files. No
 * test asserts a time, only that there is one. SKV_LONG_TESTS=1 measures all that --quick does. */
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <jansson.h>

#include "program.h"
#include "support/long.h"

static double number(const json_t *row, const char *key)
{
    const json_t *value = json_object_get(row, key);
    if (!json_is_number(value))
        fail_msg("%s is no number", key);
    return json_number_value(value);
}

static bool close_to(double a, double b)
{
    return fabs(a - b) <= 1e-6 * fabs(b);
}

/* Pools with company, which are measured without the reference solver. */
static const char *const companies[] = {"oil-on-water", "ten-bodies", "half-jelly", "bell-of-air"};
enum { COMPANIES = 4 };

static bool has_company(const json_t *row)
{
    const char *scene = json_string_value(json_object_get(row, "scene"));
    for (int i = 0; i < COMPANIES; i++)
        if (strcmp(scene, companies[i]) == 0)
            return true;
    return false;
}

/* A row's figures are there, positive, and follow from each other. */
static void check_row(const json_t *row)
{
    const char *scene = json_string_value(json_object_get(row, "scene"));
    const char *law = json_string_value(json_object_get(row, "law"));
    assert_true(strcmp(scene, "pool") == 0 || strcmp(scene, "dam-break") == 0 || has_company(row));
    assert_true(strcmp(law, "calibrated") == 0 || strcmp(law, "clavet") == 0);
    assert_true(json_is_boolean(json_object_get(row, "viscosity")));
    assert_true(json_is_string(json_object_get(row, "instruction_set")));
    double particles = number(row, "particles"), ns = number(row, "ns_per_particle_substep");
    assert_true(number(row, "threads") >= 1 && number(row, "substeps") >= 1);
    assert_true(number(row, "neighbours") > 5 && number(row, "neighbours") < 60);
    assert_true(ns > 0 && number(row, "bytes_per_particle") > 0);
    assert_true(close_to(number(row, "ms_per_step") * 1e6, ns * particles));
    assert_true(number(row, "ms_per_step_median") >= number(row, "ms_per_step"));
    assert_true(close_to(number(row, "ms_per_frame"),
                         number(row, "ms_per_step") * number(row, "substeps")));
    if (has_company(row)) {
        assert_true(json_is_null(json_object_get(row, "reference_ns_per_particle_substep")));
        assert_true(json_is_null(json_object_get(row, "ratio")));
    } else {
        double reference = number(row, "reference_ns_per_particle_substep");
        assert_true(reference > 0 && close_to(number(row, "ratio"), reference / ns));
    }

    /* The phases are a part of the time. */
    const char *name;
    json_t *phase, *phases = json_object_get(row, "phases");
    double sum = 0;
    assert_true(json_is_object(phases) && json_object_size(phases) > 0);
    json_object_foreach(phases, name, phase)
    {
        assert_true(json_number_value(phase) >= 0);
        sum += json_number_value(phase);
    }
    assert_true(sum > 0 && sum <= ns * 1.0001);
}

/* Runs bench and returns its array. */
static json_t *measure(const char *folder, const char *const *arguments)
{
    program_result result = program_run(folder, arguments);
    assert_int_equal(result.status, 0);
    assert_string_equal(result.err, "");
    json_t *array = json_loads(result.out, JSON_REJECT_DUPLICATES, NULL);
    assert_true(json_is_array(array) && json_array_size(array) > 0);
    for (size_t i = 0; i < json_array_size(array); i++)
        check_row(json_array_get(array, i));
    program_free(&result);
    return array;
}

/* How many rows there are of a scene, a law and a number of threads. */
static int count_rows(const json_t *array, const char *scene, const char *law, int threads)
{
    int count = 0;
    for (size_t i = 0; i < json_array_size(array); i++) {
        const json_t *row = json_array_get(array, i);
        count += strcmp(json_string_value(json_object_get(row, "scene")), scene) == 0 &&
                 strcmp(json_string_value(json_object_get(row, "law")), law) == 0 &&
                 (int)number(row, "threads") == threads;
    }
    return count;
}

static void test_contract(void **state)
{
    json_t *array =
        measure(*state, (const char *const[]){"skvalp", "bench", "--quick", "--json", "--particles",
                                              "1000", "--threads", "2", NULL});
    for (int threads = 1; threads <= 2; threads++) {
        assert_int_equal(count_rows(array, "pool", "calibrated", threads), 1);
        assert_int_equal(count_rows(array, "pool", "clavet", threads), 1);
        assert_int_equal(count_rows(array, "dam-break", "calibrated", threads), 1);
        assert_int_equal(count_rows(array, "dam-break", "clavet", threads), 1);
        for (int i = 0; i < COMPANIES; i++)
            assert_int_equal(count_rows(array, companies[i], "calibrated", threads), 1);
    }
    assert_int_equal(json_array_size(array), 8 + 2 * COMPANIES);
    for (size_t i = 0; i < json_array_size(array); i++)
        assert_in_range((int)number(json_array_get(array, i), "particles"), 900, 1100);
    json_decref(array);
}

static int count_character(const char *text, const char *end, char wanted)
{
    int count = 0;
    for (; *text && text != end; text++)
        count += *text == wanted;
    return count;
}

static int count_text(const char *text, const char *wanted)
{
    int count = 0;
    for (; (text = strstr(text, wanted)); text += strlen(wanted))
        count++;
    return count;
}

static void check_csv(const char *csv, int rows)
{
    assert_int_equal(count_lines(csv), 1 + rows);
    assert_memory_equal(csv, "cpu,compiler,instruction_set,scene,law,", 39);
    int commas = count_character(csv, strchr(csv, '\n'), ',');
    for (const char *line = csv; *line; line = strchr(line, '\n') + 1)
        assert_int_equal(count_character(line, strchr(line, '\n'), ','), commas);
    assert_non_null(strstr(csv, ",dam-break,clavet,on,"));
}

/* Both panels are drawn, six lines each, and no figure went astray. */
static void check_plot(const char *svg)
{
    const char end[] = "</svg>\n";
    assert_memory_equal(svg, "<svg ", 5);
    assert_string_equal(svg + strlen(svg) - strlen(end), end);
    assert_int_equal(count_text(svg, "<polyline"), 12);
    assert_int_equal(count_text(svg, "<text"), count_text(svg, "</text>"));
    assert_null(strstr(svg, "nan"));
    assert_null(strstr(svg, "inf"));
    assert_non_null(strstr(svg, "prefers-color-scheme: dark"));
}

/* Both methods take as long as there is, and have kept their water in the pool. */
static void check_rivals(const char *text)
{
    const char *table = strstr(text, "### Beside FLIP");
    assert_non_null(table);
    static const char *const methods[] = {"| skvalp", "| FLIP"};
    for (int i = 0; i < 2; i++) {
        const char *row = strstr(table, methods[i]);
        double particles, steps, shortest, median, level, speed;
        assert_non_null(row);
        assert_int_equal(sscanf(row, "| %*s | %*s | %lf | %lf | %lf | %lf | %lf | %lf", &particles,
                                &steps, &shortest, &median, &level, &speed),
                         6);
        assert_true(particles > 900 && steps >= 2 && shortest > 0 && median >= shortest);
        assert_true(level > 0.9 && level < 1.15 && speed < 0.2);
    }
}

/* What is in the pool costs something, and is told beside the pool without it. */
static void check_companies(const char *text)
{
    const char *row = strstr(text, "### Cost of a substep: a pool with company");
    static const char *const titles[] = {"| water alone", "| oil on water", "| ten bodies of 0.1 m",
                                         "| half of it jelly", "| a bell of air"};
    for (int i = 0; i < 1 + COMPANIES && row; i++) {
        row = strstr(row, titles[i]);
        double ns, over;
        if (!row)
            continue;
        assert_int_equal(
            sscanf(row, "| %*[^|]| %*d | %*d | %lf | %*f | %*f | %*f | %*f | %lf", &ns, &over), 2);
        assert_true(ns > 0 && over > 0 && (i > 0 || over == 1));
    }
    assert_non_null(row);
}

static void test_files(void **state)
{
    program_result result = SKVALP(*state, "bench", "--quick", "--particles", "1000", "--threads",
                                   "2", "--markdown", "--csv", "bench.csv", "--plot", "bench.svg");
    assert_int_equal(result.status, 0);
    assert_string_equal(result.err, "");
    assert_non_null(strstr(result.out, "### Cost of a substep: pool"));
    assert_non_null(strstr(result.out, "### Cost of a substep: dam break"));
    check_companies(result.out);
    assert_non_null(strstr(result.out, "### A frame of 1/60 s, ms"));
    assert_non_null(strstr(result.out, "1000 | in real time |"));
    assert_non_null(strstr(result.out, "### Phases"));
    const char *frames = strstr(result.out, "### A frame of the app");
    assert_non_null(frames);
    assert_non_null(strstr(frames, "| step and publish"));
    assert_non_null(strstr(frames, "| from a key to its picture"));
    assert_non_null(strstr(frames, "| the face's calls"));
    check_rivals(result.out);
    program_free(&result);

    assert_int_equal(folder_entries(*state), 2);
    char *csv = file_read(*state, "bench.csv"), *svg = file_read(*state, "bench.svg");
    check_csv(csv, 8 + 2 * COMPANIES);
    check_plot(svg);
    free(csv);
    free(svg);

    if (!long_tests())
        return;
    result =
        SKVALP(*state, "bench", "--quick", "--particles", "1000", "--threads", "1", "--csv", "-");
    assert_int_equal(result.status, 0);
    assert_memory_equal(result.out, "cpu,", 4);
    program_free(&result);
}

static void test_interrupt(void **state)
{
    pid_t pid = program_start(*state, (const char *const[]){"skvalp", "bench", "--csv", "bench.csv",
                                                            "--plot", "bench.svg", NULL});
    folder_await(*state, 2);
    kill(-pid, SIGINT);
    assert_int_equal(program_wait(pid), 130);
    assert_int_equal(folder_entries(*state), 0);
}

/* What is in real time lies between the numbers that take less than a frame and those that take
 * more. */
static void check_budget(const char *text)
{
    const char *table = strstr(text, "A frame of 1/60 s, ms");
    const char *row = table ? strstr(table, "at rest ") : NULL;
    double ms[4], most, sizes[4] = {3000, 10000, 30000, 100000};
    if (!row) {
        fail_msg("no such table");
        return;
    }
    assert_int_equal(
        sscanf(row, "at rest %*d %lf %lf %lf %lf %lf", &ms[0], &ms[1], &ms[2], &ms[3], &most), 5);
    for (int i = 0; i < 4; i++)
        assert_true(ms[i] < 1000 / 60.0 ? sizes[i] < 1.06 * most : sizes[i] > 0.94 * most);
}

/* Every table, with the thesis'. */
static void test_quick(void **state)
{
    if (!long_tests())
        skip();
    program_result result =
        SKVALP(*state, "bench", "--quick", "--threads", "1", "--csv", "quick.csv");
    assert_int_equal(result.status, 0);
    assert_non_null(strstr(result.out, "Table 4.1 of the thesis"));
    assert_non_null(strstr(result.out, "Table 4.2 of the thesis"));
    check_budget(result.out);
    program_free(&result);
    char *csv = file_read(*state, "quick.csv");
    check_csv(csv, count_lines(csv) - 1);
    assert_non_null(strstr(csv, ",100000,"));
    free(csv);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_contract, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_files, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_interrupt, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_quick, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
