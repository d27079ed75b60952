/* What run reports: the JSON contract, the same hash however it is run, and the two tables. */
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

/* Parses stdout as exactly one JSON object without duplicate keys. */
static json_t *parse(const program_result *result)
{
    json_error_t error;
    json_t *object = json_loads(result->out, JSON_REJECT_DUPLICATES, &error);
    if (!json_is_object(object))
        fail_msg("%s in '%s', stderr '%s'", error.text, result->out, result->err);
    return object;
}

static json_t *run_json(const char *folder, const char *const *arguments)
{
    program_result result = program_run(folder, arguments);
    assert_int_equal(result.status, 0);
    assert_string_equal(result.err, "");
    json_t *object = parse(&result);
    program_free(&result);
    return object;
}
#define RUN_JSON(folder, ...)                                                                      \
    run_json((folder), (const char *const[]){"skvalp", "run", __VA_ARGS__, "--json", NULL})

static double number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    if (!json_is_number(value))
        fail_msg("%s is no number", key);
    return json_number_value(value);
}

static void test_contract(void **state)
{
    static const char *const keys[] = {
        "scene",   "particles", "substeps",    "steps",      "sim_seconds",    "hash",
        "escaped", "nan",       "ms_per_step", "neighbours", "kinetic_energy", "volume_ratio",
        "emitted", "drained",   "left",        "replaced",   "blocked",        "fluids",
        "springs", "bodies",    "pockets",     "awake"};
    json_t *object = RUN_JSON(*state, "dam-break", "--seconds", "0.5", "--particles", "500");
    assert_int_equal(json_object_size(object), sizeof keys / sizeof keys[0]);
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        assert_non_null(json_object_get(object, keys[i]));
    assert_string_equal(json_string_value(json_object_get(object, "scene")), "dam-break");
    static const char *const whole[] = {"particles", "substeps", "steps",   "escaped",
                                        "nan",       "emitted",  "drained", "left",
                                        "replaced",  "blocked",  "awake"};
    for (size_t i = 0; i < sizeof whole / sizeof whole[0]; i++)
        assert_true(json_is_integer(json_object_get(object, whole[i])));
    assert_in_range((int)number(object, "particles"), 450, 550);
    assert_int_equal((int)number(object, "steps"), 30 * (int)number(object, "substeps"));
    assert_true(number(object, "sim_seconds") == 0.5);
    assert_true(number(object, "ms_per_step") > 0);
    assert_true(number(object, "neighbours") > 5 && number(object, "neighbours") < 60);
    assert_int_equal((int)number(object, "escaped"), 0);
    assert_int_equal((int)number(object, "emitted"), 0);
    assert_int_equal((int)number(object, "nan"), 0);
    assert_int_equal((int)number(object, "springs"), 0);
    assert_int_equal((int)number(object, "awake"), (int)number(object, "particles"));
    assert_true(number(object, "kinetic_energy") > 0);
    assert_true(number(object, "volume_ratio") > 0.5 && number(object, "volume_ratio") < 1.5);
    const char *hash = json_string_value(json_object_get(object, "hash"));
    assert_int_equal(strlen(hash), 16);
    assert_int_equal(strspn(hash, "0123456789abcdef"), 16);
    json_decref(object);
}

/* No step, no time a step: null, not NaN. */
static void test_nothing_to_do(void **state)
{
    json_t *object = RUN_JSON(*state, "pool", "--seconds", "0", "--particles", "300");
    assert_int_equal((int)number(object, "steps"), 0);
    assert_true(number(object, "sim_seconds") == 0);
    assert_true(json_is_null(json_object_get(object, "ms_per_step")));
    json_decref(object);
}

/* What has come to rest is told as such. */
static void test_asleep(void **state)
{
    json_t *object = RUN_JSON(*state, "pool", "--seconds", "60", "--particles", "300");
    assert_int_equal((int)number(object, "particles"), 300);
    assert_int_equal((int)number(object, "awake"), 0);
    json_decref(object);
}

/* The end need not lie on a frame. */
static void test_exact_end(void **state)
{
    json_t *object = RUN_JSON(*state, "pool", "--seconds=0.11", "--particles=300");
    assert_true(fabs(number(object, "sim_seconds") - 0.11) < 1e-9);
    /* Six whole frames and six tenths of one. */
    assert_true(number(object, "steps") > 6 * number(object, "substeps"));
    assert_true(number(object, "steps") <= 7 * number(object, "substeps"));
    json_decref(object);
}

static void hash_of(const char *folder, const char *const *extra, char *hash)
{
    const char *arguments[16] = {"skvalp", "run",         "dam-break", "--seconds",
                                 "0.5",    "--particles", "400",       "--json"};
    for (int i = 0; extra[i]; i++)
        arguments[8 + i] = extra[i];
    json_t *object = run_json(folder, arguments);
    snprintf(hash, 17, "%s", json_string_value(json_object_get(object, "hash")));
    json_decref(object);
}
#define HASH(hash, ...) hash_of(*state, (const char *const[]){__VA_ARGS__, NULL}, hash)

static void test_same_hash(void **state)
{
    char first[17], other[17];
    HASH(first, "--threads", "1");
    HASH(other, "--threads", "1");
    assert_string_equal(first, other);
    static const char *const threads[] = {"0", "2", "3", "7"};
    for (int i = 0; i < 4; i++) {
        HASH(other, "--threads", threads[i]);
        assert_string_equal(first, other);
    }
    /* Looking does not change the run. */
    HASH(other, "--csv", "a.csv", "--trace", "t.csv", "--trace-every", "0.25");
    assert_string_equal(first, other);
    /* But what is simulated does. */
    HASH(other, "--law", "clavet");
    assert_string_not_equal(first, other);
    char set[17];
    HASH(set, "--set", "fluid.law=clavet");
    assert_string_equal(other, set);
    HASH(set, "--law=calibrated", "--set=fluid.law=clavet");
    assert_string_equal(other, set);
}

/* A run that goes on from a state, with no scene at hand, ends as one that was not interrupted. */
static void test_going_on(void **state)
{
    static const struct {
        const char *at, *rest;
    } cases[] = {{"0", "0.5"}, {"0.25", "0.25"}, {"0.1", "0.4"}};
    char whole[17], with[17];
    HASH(whole, "--threads", "1");
    for (int i = 0; i < 3; i++) {
        HASH(with, "--snapshot", "a.skv", "--at", cases[i].at);
        assert_string_equal(whole, with);
        json_t *object =
            RUN_JSON(*state, "a.skv", "--seconds", cases[i].rest, "--threads", i ? "2" : "1");
        assert_string_equal(json_string_value(json_object_get(object, "hash")), whole);
        json_decref(object);
    }
    program_result result = SKVALP(*state, "run", "a.skv", "--particles", "9");
    assert_int_equal(result.status, 2);
    assert_non_null(strstr(result.err, "goes on as it is"));
    program_free(&result);
    result = SKVALP(*state, "run", "a.skv", "--csv", "a.skv");
    assert_int_equal(result.status, 2);
    assert_non_null(strstr(result.err, "would be lost"));
    program_free(&result);
}

/* Numbers of one CSV line; returns how many. */
static int read_row(const char *line, double *values, int capacity)
{
    int count = 0;
    const char *end = line + strcspn(line, "\n");
    while (line < end && count < capacity) {
        char *after;
        values[count++] = strtod(line, &after);
        assert_true(after > line && (*after == ',' || *after == '\n'));
        line = after + 1;
    }
    return count;
}

static const char *next_line(const char *line)
{
    const char *feed = strchr(line, '\n');
    assert_non_null(feed);
    return feed + 1;
}

/* Rows of a trace come as blocks of one per particle, at the expected moments. */
static void expect_trace(const char *text, int particles, const double *times, int moments)
{
    double row[9];
    assert_memory_equal(text, "t,id,x,y,vx,vy,pressure,fluid\n", 30);
    const char *line = next_line(text);
    for (int m = 0; m < moments; m++) {
        for (int i = 0; i < particles; i++, line = next_line(line)) {
            assert_int_equal(read_row(line, row, 9), 8);
            assert_true(row[7] == 0);
            assert_true(fabs(row[0] - times[m]) < 1e-8);
            assert_int_equal((int)row[1], i);
            assert_true(row[2] > 0 && row[2] < 1.6 && row[3] > 0 && row[3] < 0.9);
            assert_true(isfinite(row[4]) && isfinite(row[5]) && isfinite(row[6]));
            /* It begins settled: there is pressure at once. */
            if (m == 0)
                assert_true(fabs(row[6]) < 3 * 1000 * 9.81 * 0.45 && row[6] != 0);
        }
    }
    assert_int_equal(*line, '\0');
}

static void test_trace(void **state)
{
    static const struct {
        const char *seconds, *every;
        int moments;
        double times[8];
    } cases[] = {
        {"0.5", "0.1", 6, {0, 0.1, 0.2, 0.3, 0.4, 0.5}},        /* on frames, the end on a moment */
        {"0.5", "0.2", 4, {0, 0.2, 0.4, 0.5}},                  /* the end is no moment */
        {"0.05", "0.01", 6, {0, 0.01, 0.02, 0.03, 0.04, 0.05}}, /* between frames */
        {"0.1", "7", 2, {0, 0.1}},                              /* start and end only */
        {"0", "0.1", 1, {0}},                                   /* which are the same */
        {"0.025", "0.025", 2, {0, 0.025}},                      /* the end between frames */
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        json_t *object =
            RUN_JSON(*state, "pool", "--particles", "200", "--seconds", cases[i].seconds, "--trace",
                     "t.csv", "--trace-every", cases[i].every);
        char *text = file_read(*state, "t.csv");
        assert_non_null(text);
        expect_trace(text, (int)number(object, "particles"), cases[i].times, cases[i].moments);
        free(text);
        json_decref(object);
    }
}

/* Reading back gives the very floats: kinetic energy from the trace is that of the JSON. */
static void test_trace_is_the_state(void **state)
{
    json_t *object = RUN_JSON(*state, "dam-break", "--particles", "200", "--seconds", "0.2",
                              "--trace", "t.csv", "--trace-every", "0.2");
    char *text = file_read(*state, "t.csv");
    int particles = (int)number(object, "particles");
    const char *line = next_line(text);
    for (int i = 0; i < particles; i++)
        line = next_line(line);
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < particles; i++, line = next_line(line)) {
        double row[9];
        assert_int_equal(read_row(line, row, 9), 8);
        for (int k = 2; k < 6; k++) {
            float value = (float)row[k];
            unsigned char bytes[4];
            memcpy(bytes, &value, 4);
            for (int b = 0; b < 4; b++)
                hash = (hash ^ bytes[b]) * 1099511628211u;
        }
    }
    char expected[17];
    snprintf(expected, sizeof expected, "%016llx", (unsigned long long)hash);
    assert_string_equal(json_string_value(json_object_get(object, "hash")), expected);
    free(text);
    json_decref(object);
}

/* A row of the series is what the last block of the trace adds up to. */
static void expect_sums(const double *row, const char *trace, int particles)
{
    double x = 0, y = 0, vx = 0, vy = 0, squares = 0;
    const char *line = next_line(trace);
    for (int i = 0; i < particles; i++) /* the start */
        line = next_line(line);
    for (int i = 0; i < particles; i++, line = next_line(line)) {
        double one[9];
        assert_int_equal(read_row(line, one, 9), 8);
        x += one[2] / particles;
        y += one[3] / particles;
        vx += one[4];
        vy += one[5];
        squares += one[4] * one[4] + one[5] * one[5];
    }
    double mass = 2 * row[2] / squares;
    assert_true(fabs(row[4] / (mass * vx) - 1) < 1e-5);
    assert_true(fabs(row[5] / (mass * vy) - 1) < 1e-5);
    assert_true(fabs(row[6] / sqrt(squares / particles) - 1) < 1e-5);
    assert_true(fabs(row[9] / x - 1) < 1e-5);
    assert_true(fabs(row[10] / y - 1) < 1e-5);
}

static void test_series(void **state)
{
    json_t *object = RUN_JSON(*state, "dam-break", "--particles", "200", "--seconds", "0.25",
                              "--csv", "s.csv", "--trace", "t.csv", "--trace-every", "7");
    char *text = file_read(*state, "s.csv");
    static const char head[] =
        "t,particles,kinetic_energy,potential_energy,momentum_x,momentum_y,rms_speed,max_speed,"
        "volume_ratio,centre_x,centre_y\n";
    assert_memory_equal(text, head, sizeof head - 1);
    const char *line = next_line(text);
    double row[12];
    for (int frame = 0; frame <= 15; frame++, line = next_line(line)) {
        assert_int_equal(read_row(line, row, 12), 11);
        assert_true(fabs(row[0] - frame / 60.0) < 1e-8);
        assert_true(row[1] == number(object, "particles"));
    }
    assert_int_equal(*line, '\0');
    double kinetic = number(object, "kinetic_energy");
    assert_true(fabs(row[2] - kinetic) <= 1e-8 * kinetic);
    char *trace = file_read(*state, "t.csv");
    expect_sums(row, trace, (int)row[1]);
    free(trace);
    free(text);
    json_decref(object);
}

/* "-" gives the table and nothing else. */
static void test_tables_on_stdout(void **state)
{
    program_result result =
        SKVALP(*state, "run", "pool", "--particles", "200", "--seconds", "0.1", "--csv", "-");
    assert_int_equal(result.status, 0);
    assert_string_equal(result.err, "");
    assert_int_equal(count_lines(result.out), 1 + 7);
    assert_memory_equal(result.out, "t,particles,", 12);
    program_free(&result);
    result = SKVALP(*state, "run", "pool", "--particles", "200", "--seconds", "0", "--trace", "-");
    assert_int_equal(result.status, 0);
    assert_memory_equal(result.out, "t,id,x,y,vx,vy,pressure,fluid\n0,0,", 34);
    program_free(&result);
    assert_int_equal(folder_entries(*state), 0);
}

static const char fluids_scene[] =
    "{\"particles\": 300, \"fluids\": [{\"name\": \"oil\"}, {\"name\": \"milk\"}],"
    "\"water\": [{\"shape\": \"box\", \"y1\": 0.2}, {\"shape\": \"box\", \"y0\": 0.2, \"y1\": 0.3,"
    "\"fluid\": \"oil\"}], \"emitters\": [{\"x\": 0.8, \"y\": 0.7, \"vy\": -1, \"fluid\": "
    "\"oil\"}]}";

/* Sums of the rows of a fluid at the end, beside what the result says of it. */
static void expect_fluid(const json_t *fluid, const char *trace, int number_of, double end)
{
    double row[9], x = 0, y = 0;
    int count = 0;
    for (const char *line = next_line(trace); *line; line = next_line(line)) {
        assert_int_equal(read_row(line, row, 9), 8);
        if (fabs(row[0] - end) > 1e-8 || (int)row[7] != number_of)
            continue;
        count++;
        x += row[2];
        y += row[3];
    }
    assert_int_equal((int)number(fluid, "particles"), count);
    if (count == 0) {
        assert_true(json_is_null(json_object_get(fluid, "centre_x")));
        return;
    }
    assert_true(fabs(number(fluid, "centre_x") - x / count) < 1e-6);
    assert_true(fabs(number(fluid, "centre_y") - y / count) < 1e-6);
}

/* Each fluid has columns of its own in the time series; their last row is what the result says. */
static void test_columns_of_fluids(void **state)
{
    static const char scene[] =
        "{\"particles\": 300, \"fluids\": [{\"name\": \"oil, \\\"old\\\"\", \"material\": "
        "\"oil\"}, {\"name\": \"none\"}], \"water\": [{\"shape\": \"box\", \"y1\": 0.2}, "
        "{\"shape\": \"box\", \"y0\": 0.2, \"y1\": 0.3, \"fluid\": \"oil, \\\"old\\\"\"}]}";
    file_write(*state, "two.json", scene);
    json_t *object = RUN_JSON(*state, "two.json", "--seconds", "0.25", "--csv", "s.csv");
    char *text = file_read(*state, "s.csv");
    assert_non_null(strstr(text, ",centre_y,water.particles,water.kinetic_energy,water.centre_x,"
                                 "water.centre_y,\"oil, \"\"old\"\".particles\",\"oil, "));
    const char *last = text, *empty = ",0,0,,\n";
    for (const char *line = next_line(text); *line; line = next_line(line))
        last = line;
    double row[19];
    assert_int_equal(read_row(last, row, 19), 19); /* those that are not empty, before the end */
    assert_string_equal(last + strlen(last) - strlen(empty), empty);
    for (size_t i = 0; i < 2; i++) {
        static const char *const keys[] = {"particles", "kinetic_energy", "centre_x", "centre_y"};
        const json_t *fluid = json_array_get(json_object_get(object, "fluids"), i);
        for (size_t k = 0; k < 4; k++)
            assert_true(fabs(row[11 + 4 * i + k] - number(fluid, keys[k])) <
                        1e-6 * (1e-3 + row[11 + 4 * i + k]));
    }
    free(text);
    json_decref(object);
}

/* Each body has columns of its own, too, which stay empty once it has left through an open side. */
static void test_columns_of_bodies(void **state)
{
    file_write(*state, "bodies.json",
               "{\"particles\": 300, \"water\": [{\"shape\": \"box\", \"y1\": 0.2}], "
               "\"world\": {\"open\": {\"right\": true}}, \"bodies\": [{\"name\": \"cork\", "
               "\"shape\": \"circle\", \"x\": 0.5, \"y\": 0.5, \"radius\": 0.06}, {\"shape\": "
               "\"circle\", \"x\": 1.4, \"y\": 0.7, \"radius\": 0.06, \"vx\": 5}]}");
    json_t *object = RUN_JSON(*state, "bodies.json", "--seconds", "0.25", "--csv", "b.csv");
    char *text = file_read(*state, "b.csv");
    assert_non_null(strstr(text,
                           ",centre_y,cork.x,cork.y,cork.angle,cork.vx,cork.vy,cork.spin,"
                           "body 2.x,body 2.y,body 2.angle,body 2.vx,body 2.vy,body 2.spin\n"));
    const char *first = next_line(text), *last = text, *empty = ",,,,,,\n";
    double row[23];
    assert_int_equal(read_row(first, row, 23), 23);
    assert_true(fabs(row[11] - 0.5) < 1e-6 && fabs(row[17] - 1.4) < 1e-6 && row[20] == 5);
    for (const char *line = first; *line; line = next_line(line))
        last = line;
    assert_int_equal(read_row(last, row, 17), 17); /* those that are not empty, before the end */
    assert_string_equal(last + strlen(last) - strlen(empty), empty);
    static const char *const keys[] = {"x", "y", "angle", "vx", "vy", "spin"};
    const json_t *bodies = json_object_get(object, "bodies");
    assert_int_equal(json_array_size(bodies), 1);
    for (size_t k = 0; k < 6; k++)
        assert_true(fabs(row[11 + k] - number(json_array_get(bodies, 0), keys[k])) < 1e-6);
    free(text);
    json_decref(object);
}

/* Each fluid is told of, in the result and in the trace, and a link and a state keep it. */
static void test_fluids(void **state)
{
    file_write(*state, "three.json", fluids_scene);
    json_t *object = RUN_JSON(*state, "three.json", "--seconds", "0.5", "--trace", "t.csv",
                              "--snapshot", "s.skv");
    char *trace = file_read(*state, "t.csv");
    json_t *fluids = json_object_get(object, "fluids");
    static const char *const names[] = {"water", "oil", "milk"};
    double energy = 0;
    assert_int_equal(json_array_size(fluids), 3);
    for (size_t i = 0; i < 3; i++) {
        const json_t *fluid = json_array_get(fluids, i);
        assert_string_equal(json_string_value(json_object_get(fluid, "name")), names[i]);
        expect_fluid(fluid, trace, (int)i, 0.5);
        energy += number(fluid, "kinetic_energy");
    }
    assert_true(number(json_array_get(fluids, 1), "particles") > 90);
    assert_true(fabs(energy - number(object, "kinetic_energy")) < 1e-6 * energy);
    json_t *again = RUN_JSON(*state, "s.skv", "--seconds", "0");
    assert_string_equal(json_string_value(json_object_get(again, "hash")),
                        json_string_value(json_object_get(object, "hash")));
    assert_int_equal(json_array_size(json_object_get(again, "fluids")), 3);
    json_decref(again);
    json_decref(object);
    free(trace);
    object = RUN_JSON(*state, "three.json", "--seconds", "0");
    program_result link = SKVALP(*state, "share", "three.json");
    assert_int_equal(link.status, 0);
    link.out[strcspn(link.out, "\n")] = '\0';
    program_result replay = SKVALP(*state, "replay", link.out);
    assert_int_equal(replay.status, 0);
    assert_non_null(strstr(replay.out, json_string_value(json_object_get(object, "hash"))));
    program_free(&link);
    program_free(&replay);
    json_decref(object);
}

static void test_summary(void **state)
{
    program_result result = SKVALP(*state, "run", "--seconds", "0.1", "pool", "--particles", "200");
    assert_int_equal(result.status, 0);
    assert_string_equal(result.err, "");
    assert_non_null(strstr(result.out, "0.1 s simulated"));
    assert_non_null(strstr(result.out, "hash "));
    program_free(&result);
    result =
        SKVALP(*state, "run", "--quiet", "--seconds", "0.1", "--particles", "200", "--", "pool");
    assert_int_equal(result.status, 0);
    assert_string_equal(result.out, "");
    program_free(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_contract, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_nothing_to_do, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_asleep, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_exact_end, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_same_hash, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_going_on, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_trace, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_trace_is_the_state, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_series, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_tables_on_stdout, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_columns_of_fluids, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_columns_of_bodies, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_fluids, folder_setup, folder_teardown),
        cmocka_unit_test_setup_teardown(test_summary, folder_setup, folder_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
