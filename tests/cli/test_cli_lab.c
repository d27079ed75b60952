/* What lab reports: the JSON contract, the table, the plots, and the exit status. */
#include <math.h>
#include <setjmp.h>
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

static json_t *parse(const program_result *result)
{
    json_error_t error;
    json_t *array = json_loads(result->out, JSON_REJECT_DUPLICATES, &error);
    if (!json_is_array(array))
        fail_msg("%s in '%s', stderr '%s'", error.text, result->out, result->err);
    return array;
}

static void test_contract(void **state)
{
    static const char *const keys[] = {"experiment", "quantity", "unit",      "measured",
                                       "theory",     "ratio",    "tolerance", "pass"};
    program_result result = SKVALP(*state, "lab", "rest", "hydrostatics", "rest", "--set",
                                   "particles=600", "--starts", "1", "--threads", "1", "--json");
    json_t *array = parse(&result);
    /* The order of the command line, each experiment once. */
    assert_int_equal(json_array_size(array), 11);
    bool all = true;
    for (size_t i = 0; i < 11; i++) {
        const json_t *row = json_array_get(array, i);
        assert_int_equal(json_object_size(row), 8);
        for (int k = 0; k < 8; k++)
            assert_non_null(json_object_get(row, keys[k]));
        assert_string_equal(json_string_value(json_object_get(row, "experiment")),
                            i < 4 ? "rest" : "hydrostatics");
        double measured = json_number_value(json_object_get(row, "measured"));
        double theory = json_number_value(json_object_get(row, "theory"));
        double tolerance = json_number_value(json_object_get(row, "tolerance"));
        const json_t *ratio = json_object_get(row, "ratio");
        double miss = measured;
        assert_true(json_is_null(ratio) == (theory == 0));
        if (theory != 0) {
            assert_true(fabs(json_number_value(ratio) * theory / measured - 1) < 1e-6);
            miss = measured / theory - 1;
        }
        bool pass = json_is_true(json_object_get(row, "pass"));
        assert_true(pass == (fabs(miss) <= tolerance));
        all = all && pass;
    }
    assert_int_equal(result.status, all ? 0 : 1);
    assert_int_equal(count_lines(result.err), all ? 0 : 1);
    json_decref(array);
    program_free(&result);
}

static void test_status(void **state)
{
    /* One that passes, and one that does not: the thesis' law is no pressure gauge. */
    program_result good =
        SKVALP(*state, "lab", "momentum", "--set", "particles=300", "--threads", "1", "--quiet");
    assert_int_equal(good.status, 0);
    assert_string_equal(good.out, "");
    assert_string_equal(good.err, "");
    program_free(&good);
    program_result bad = SKVALP(*state, "lab", "hydrostatics", "--set", "particles=600", "--law",
                                "clavet", "--threads", "1");
    assert_int_equal(bad.status, 1);
    assert_non_null(strstr(bad.out, "MISS"));
    assert_non_null(strstr(bad.out, "+-    2 %")); /* of pressure */
    assert_non_null(strstr(bad.err, "figures miss"));
    assert_int_equal(count_lines(bad.err), 1);
    program_free(&bad);
}

/* A slot too narrow for its particles stops the orifice alone: those before and after it run. */
static void test_a_refusal_stops_one_experiment_only(void **state)
{
    program_result table =
        SKVALP(*state, "lab", "orifice", "momentum", "--threads", "1", "--set", "particles=400");
    assert_int_equal(table.status, 2);
    assert_int_equal(count_lines(table.err), 1);
    assert_non_null(strstr(table.err, "lab: 1 of 2 experiments not run; orifice.slot: 0.1 m"));
    assert_non_null(strstr(table.out, "Jet from an orifice: not run; orifice.slot: 0.1 m"));
    assert_non_null(strstr(table.out, "momentum drift"));
    program_free(&table);
    program_result rows = SKVALP(*state, "lab", "orifice", "momentum", "vessels", "--threads", "1",
                                 "--set", "particles=400", "--set", "vessels.head=1", "--json");
    assert_int_equal(rows.status, 2);
    assert_non_null(strstr(rows.err, "lab: 2 of 3 experiments not run; orifice.slot: 0.1 m"));
    json_t *array = parse(&rows);
    assert_int_equal(json_array_size(array), 1);
    json_decref(array);
    program_free(&rows);
    /* Alone it says why, and nothing else. */
    program_result alone = SKVALP(*state, "lab", "orifice", "--set", "particles=400");
    assert_int_equal(alone.status, 2);
    assert_string_equal(alone.out, "");
    assert_int_equal(strncmp(alone.err, "skvalp: orifice.slot: 0.1 m", 27), 0);
    program_free(&alone);
}

/* The rows of droplet with a number of particles, and with further arguments. */
static json_t *droplet(void **state, const char *particles, const char *option, const char *value)
{
    program_result result = SKVALP(*state, "lab", "droplet", "--json", "--threads", "1", "--set",
                                   particles, option, value);
    json_t *array = parse(&result);
    assert_int_equal(json_array_size(array), 3);
    program_free(&result);
    return array;
}

static double number_of(const json_t *array, const char *key)
{
    return json_number_value(json_object_get(json_array_get(array, 0), key));
}

/* Three starts are the runs with 300, 303 and 297 particles: their mean and standard deviation. */
static void test_starts(void **state)
{
    static const char *const particles[] = {"particles=300", "particles=303", "particles=297"};
    double measured[3], ratio[3], mean = 0, squares = 0, misses = 0;
    int passed = 0;
    json_t *all = droplet(state, particles[0], "--starts", "3");
    for (int i = 0; i < 3; i++) {
        json_t *one = droplet(state, particles[i], "--starts", "1");
        json_t *plain = droplet(state, particles[i], "--law", "calibrated");
        assert_true(json_equal(one, plain));
        assert_int_equal(json_object_size(json_array_get(one, 0)), 8);
        measured[i] = number_of(one, "measured");
        ratio[i] = number_of(one, "ratio");
        mean += measured[i] / 3;
        misses += (ratio[i] - 1) * (ratio[i] - 1);
        passed += json_is_true(json_object_get(json_array_get(one, 0), "pass"));
        json_decref(one);
        json_decref(plain);
    }
    for (int i = 0; i < 3; i++)
        squares += (measured[i] - mean) * (measured[i] - mean);
    const json_t *row = json_array_get(all, 0);
    assert_int_equal(json_object_size(row), 12);
    assert_true(number_of(all, "starts") == 3 && number_of(all, "passed") == passed);
    assert_true(squares > 0);
    assert_true(fabs(number_of(all, "measured") - mean) < 1e-9);
    assert_true(fabs(number_of(all, "measured_deviation") - sqrt(squares / 2)) < 1e-9);
    /* Its theory is 1. */
    assert_true(fabs(number_of(all, "ratio_deviation") - sqrt(squares / 2)) < 1e-9);
    assert_true(json_is_true(json_object_get(row, "pass")) ==
                (sqrt(misses / 3) <= number_of(all, "tolerance")));
    /* Nothing escapes, and there is no ratio to that. */
    assert_true(json_is_null(json_object_get(json_array_get(all, 1), "ratio_deviation")));
    json_decref(all);
}

/* Starts that would all be the same, or of which one cannot be, are refused before any runs. */
static void test_starts_that_cannot_be(void **state)
{
    static const char *const settings[] = {"fluid.spacing=0.01", "particles=200"};
    static const char *const said[] = {"--starts: they differ in their number of particles",
                                       "particles: 198 is out of range"};
    for (int i = 0; i < 2; i++) {
        program_result result =
            SKVALP(*state, "lab", "droplet", "--starts", "3", "--set", settings[i], "--json");
        assert_int_equal(result.status, 2);
        assert_string_equal(result.out, "");
        assert_non_null(strstr(result.err, said[i]));
        program_free(&result);
    }
}

/* How many starts the first row of an experiment is judged by, 0 where nothing is said of it. */
static int starts_of(void **state, const char *name, const char *setting)
{
    program_result result =
        SKVALP(*state, "lab", name, "--json", "--threads", "1", "--set", setting);
    json_t *array = parse(&result);
    int starts = (int)number_of(array, "starts");
    json_decref(array);
    program_free(&result);
    return starts;
}

/* What scatters has eight starts, less those that it has no room for, unless there is nothing for
 * them to differ in. */
static void test_what_scatters_has_several_starts(void **state)
{
    if (long_tests())
        assert_int_equal(starts_of(state, "rest", "particles=300"), 8);
    assert_int_equal(starts_of(state, "momentum", "particles=300"), 0);
    /* Fewer than 200 particles are not allowed, so four have more. */
    assert_int_equal(starts_of(state, "rest", "particles=200"), 5);
    assert_int_equal(starts_of(state, "rest", "fluid.spacing=0.04"), 0);
}

static void test_same_on_any_number_of_threads(void **state)
{
    program_result one =
        SKVALP(*state, "lab", "droplet", "--set", "particles=500", "--threads", "1", "--json");
    program_result three =
        SKVALP(*state, "lab", "droplet", "--set", "particles=500", "--threads", "3", "--json");
    assert_string_equal(one.out, three.out);
    program_free(&one);
    program_free(&three);
}

static void test_plots(void **state)
{
    for (int again = 0; again < 2; again++) {
        program_result result = SKVALP(*state, "lab", "slosh", "--threads", "1", "--set",
                                       "particles=400", "--plot", "plots", "--quiet");
        assert_true(result.status == 0 || result.status == 1);
        program_free(&result);
    }
    assert_int_equal(folder_entries(*state), 1);
    char *svg = file_read(*state, "plots/slosh.svg"), *csv = file_read(*state, "plots/slosh.csv");
    assert_non_null(strstr(svg, "Sloshing tank"));
    assert_non_null(strstr(svg, "</svg>"));
    assert_non_null(strstr(csv, "measured,0,"));
    assert_non_null(strstr(csv, "theory: small waves,0,"));
    free(svg);
    free(csv);
}

/* A folder that cannot take the plots is noticed before anything is computed: all the experiments
 * at their full size would take minutes. */
static void test_plots_need_a_folder(void **state)
{
    file_write(*state, "taken", "");
    program_result result = SKVALP(*state, "lab", "--plot", "taken", "--json");
    assert_int_equal(result.status, 2);
    assert_string_equal(result.out, "");
    assert_non_null(strstr(result.err, "taken: Not a directory; name another folder"));
    program_free(&result);
    result = SKVALP(*state, "lab", "--plot", "nowhere/below", "--json");
    assert_int_equal(result.status, 2);
    assert_string_equal(result.out, "");
    assert_non_null(strstr(result.err, "nowhere/below"));
    program_free(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_contract, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_status, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_a_refusal_stops_one_experiment_only, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_starts, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_starts_that_cannot_be, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_what_scatters_has_several_starts, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_same_on_any_number_of_threads, folder_setup,
                                        folder_teardown),
        cmocka_unit_test_setup_teardown(test_plots, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_plots_need_a_folder, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
