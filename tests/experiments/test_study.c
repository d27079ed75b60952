/* Studies: which runs a plan has, what they are called, and their tables there and back. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/study.h>

/* ---- Helpers --------------------------------------------------------------------------------- */

typedef struct text {
    char bytes[1 << 18];
    size_t length;
} text;

static bool take(const char *piece, size_t length, void *user)
{
    text *t = user;
    assert_true(t->length + length < sizeof t->bytes);
    memcpy(t->bytes + t->length, piece, length);
    t->length += length;
    t->bytes[t->length] = '\0';
    return true;
}

static bool refuse(const char *piece, size_t length, void *user)
{
    (void)piece, (void)length, (void)user;
    return false;
}

static int number_of(const char *name)
{
    int number = -1;
    assert_int_equal(skv_experiment_find(name, &number, NULL), SKV_OK);
    return number;
}

/* A study of the dam break with up to two sweeps. */
static skv_result make(const char *path, const char *values, const char *second,
                       const char *second_values, skv_study **study, skv_error *error)
{
    const skv_setting sweeps[] = {{path, values}, {second, second_values}};
    skv_study_plan plan = {
        .experiment = number_of("dam-break"), .sweeps = sweeps, .sweep_count = second ? 2 : 1};
    return skv_study_create(&plan, study, error);
}

static skv_study *made(const char *path, const char *values, const char *second,
                       const char *second_values)
{
    skv_study *study = NULL;
    skv_error error = {.text = ""};
    if (make(path, values, second, second_values, &study, &error) != SKV_OK)
        fail_msg("%s=%s: %s", path, values, error.text);
    return study;
}

/* The values that a parameter takes, with spaces between them. */
static const char *values_of(const char *path, const char *values)
{
    static char all[2048];
    skv_study *study = made(path, values, NULL, NULL);
    size_t length = 0;
    for (int run = 0; run < skv_study_runs(study); run++) {
        skv_setting setting;
        assert_true(skv_study_run_setting(study, run, 0, &setting));
        assert_false(skv_study_run_setting(study, run, 1, &setting));
        assert_string_equal(setting.path, path);
        length += (size_t)snprintf(all + length, sizeof all - length, "%s%s", run ? " " : "",
                                   setting.value);
    }
    skv_study_destroy(study);
    return all;
}

/* Rows that no experiment would measure: numbers that need all their digits, and none. */
static void fill(skv_study_row *rows, double measured)
{
    for (int i = 0; i < 2; i++)
        rows[i] = (skv_study_row){.row = {.measured = measured / (i + 3),
                                          .theory = i ? 1.0 / 3 : 0,
                                          .ratio = i ? 0.1 + 0.2 : (double)NAN,
                                          .tolerance = 5e-324,
                                          .pass = i == 1},
                                  .starts = 1,
                                  .passed = i,
                                  .measured_deviation = (double)NAN,
                                  .ratio_deviation = (double)NAN};
}

/* ---- Runs ------------------------------------------------------------------------------------ */

static void test_values(void **state)
{
    (void)state;
    assert_string_equal(values_of("fluid.viscosity", "0.01:0.05:5"), "0.01 0.02 0.03 0.04 0.05");
    assert_string_equal(values_of("fluid.viscosity", "0.05:0.01:3"), "0.05 0.03 0.01");
    assert_string_equal(values_of("fluid.viscosity", "1e-2,0.0200,-0"), "0.01 0.02 0");
    assert_string_equal(values_of("fluid.viscosity", "1e-6:1e-5:2"), "1e-06 1e-05");
    assert_string_equal(values_of("dam-break.width", "0.1:0.2:4"),
                        "0.1 0.133333333333 0.166666666667 0.2");
    /* All digits that were given are kept. */
    assert_string_equal(values_of("dam-break.width", "0.10000000000000002,0.3"),
                        "0.10000000000000002 0.3");
    assert_string_equal(values_of("particles", "1000:2000:4"), "1000 1333 1667 2000");
    assert_string_equal(values_of("fluid.law", "clavet,calibrated"), "clavet calibrated");
    assert_string_equal(values_of("fluid.wall_images", "true,false"), "true false");
}

/* The last sweep is the fastest; what all runs have comes first, and a path's last value counts. */
static void test_runs(void **state)
{
    (void)state;
    const skv_setting settings[] = {{"scale", "2"}, {"fluid.law", "clavet"}, {"scale", "0.50"}};
    const skv_setting sweeps[] = {{"substeps", "8,4"}, {"particles", "400:600:3"}};
    skv_study_plan plan = {number_of("dam-break"), settings, 3, sweeps, 2, 16};
    skv_study *study = NULL;
    assert_int_equal(skv_study_create(&plan, &study, NULL), SKV_OK);
    assert_int_equal(skv_study_runs(study), 6);
    assert_int_equal(skv_study_experiment(study), number_of("dam-break"));
    char name[SKV_RUN_NAME];
    skv_study_run_name(study, 1, name);
    assert_string_equal(name, "dam-break,substeps=8,particles=500,starts=16");
    skv_study_run_name(study, 3, name);
    assert_string_equal(name, "dam-break,substeps=4,particles=400,starts=16");
    static const char *const paths[] = {"fluid.law", "scale", "substeps", "particles"};
    static const char *const values[] = {"clavet", "0.5", "4", "600"};
    skv_setting setting;
    for (int i = 0; i < 4; i++) {
        assert_true(skv_study_run_setting(study, 5, i, &setting));
        assert_string_equal(setting.path, paths[i]);
        assert_string_equal(setting.value, values[i]);
    }
    assert_false(skv_study_run_setting(study, 5, 4, &setting));
    /* Other values make a study that is alike; other settings, starts or sweeps one that is not. */
    skv_study *other = NULL;
    const skv_setting more[] = {{"substeps", "4"}, {"particles", "500"}};
    for (int i = 0; i < 5; i++) {
        skv_study_plan next = {number_of("dam-break"), settings, 3, more, 2, 16};
        next.starts = i == 1 ? 8 : 16;
        next.sweep_count = i == 2 ? 1 : 2;
        next.setting_count = i == 3 ? 2 : 3;
        next.experiment = i == 4 ? number_of("rest") : next.experiment;
        assert_int_equal(skv_study_create(&next, &other, NULL), SKV_OK);
        assert_int_equal(skv_study_is_alike(study, other), i == 0);
        skv_study_destroy(other);
    }
    skv_study_destroy(study);
}

/* The longest names, of most sweeps with most digits, still fit, with an ending behind them. */
static void test_the_longest_name_fits(void **state)
{
    (void)state;
    const char *digits = "0.0012345678901234567";
    const skv_setting sweeps[] = {{"fluid.clavet_near_stiffness", digits},
                                  {"fluid.viscosity_quadratic", digits},
                                  {"fluid.clavet_stiffness", digits},
                                  {"fluid.viscosity_linear", digits}};
    skv_study_plan plan = {.experiment = number_of("hydrostatics"),
                           .sweeps = sweeps,
                           .sweep_count = SKV_MAX_SWEEPS,
                           .starts = 99};
    skv_study *study = NULL;
    char name[SKV_RUN_NAME];
    assert_int_equal(skv_study_create(&plan, &study, NULL), SKV_OK);
    skv_study_run_name(study, 0, name);
    assert_non_null(strstr(name, "0.0012345678901234567,starts=99"));
    assert_true(strlen(name) + strlen(".csv") < SKV_RUN_NAME);
    skv_study_destroy(study);
}

static void test_what_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *path, *values, *said;
    } cases[] = {
        {"fluid.visosity", "1,2", "fluid.visosity: the lab has no such parameter"},
        {"slosh.depth", "1,2", "slosh.depth: it is a parameter of slosh and changes nothing"},
        {"fluid.viscosity", "0:1:5", "fluid.viscosity: 1 is out of range"},
        {"fluid.viscosity", "0:0.01:0", "fluid.viscosity: '0' is no number of values"},
        {"fluid.viscosity", "0:0.01:1", "from 2 on"},
        {"fluid.viscosity", "0:0.01:2.5", "from 2 on"},
        {"fluid.viscosity", "0:0.01:-3", "from 2 on"},
        {"fluid.viscosity", "0:0.01:many", "from 2 on"},
        {"fluid.viscosity", "0:0.01:1000000000", "1000000000 runs, and 100000 are allowed"},
        {"fluid.viscosity", "0:0.01:1e300", "100000 are allowed"},
        {"fluid.viscosity", "0:0.01", "is no range; say FROM:TO:NUMBER"},
        {"fluid.viscosity", "0:0.01:3:4", "from 2 on"},
        {"fluid.viscosity", ":0.01:3", "fluid.viscosity: "},
        {"fluid.viscosity", "", "is empty"},
        {"fluid.viscosity", "0.01,", "is empty"},
        {"fluid.viscosity", "0.01,nan", "nan is not a number"},
        {"fluid.viscosity", "0.01,1e-2", "0.01 comes twice"},
        {"fluid.viscosity", "0.01:0.01:2", "0.01 comes twice"},
        {"particles", "400:402:5", "comes twice"},
        {"particles", "400.5", "particles: "},
        {"fluid.law", "calibrated:clavet:2", "fluid.law: 'calibrated:clavet:2' is a range"},
        {"fluid.law", "newton", "newton is not known"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_study *study = NULL;
        skv_error error = {.text = ""};
        skv_result result = make(cases[i].path, cases[i].values, NULL, NULL, &study, &error);
        assert_true(result == SKV_ERROR_VALUE || result == SKV_ERROR_LIMIT);
        assert_null(study);
        if (!strstr(error.text, cases[i].said))
            fail_msg("%s=%s says '%s'", cases[i].path, cases[i].values, error.text);
    }
    skv_study *study = NULL;
    assert_int_equal(make("particles", "300:90000:1000", "substeps", "0:999:1000", &study, NULL),
                     SKV_ERROR_LIMIT);
    assert_int_equal(make("particles", "300", "particles", "400", &study, NULL), SKV_ERROR_VALUE);
    const skv_setting both = {"particles", "400"};
    skv_study_plan plan = {0, &both, 1, &both, 1, 0};
    assert_int_equal(skv_study_create(&plan, &study, NULL), SKV_ERROR_VALUE);
    plan.experiment = 99;
    assert_int_equal(skv_study_create(&plan, &study, NULL), SKV_ERROR_VALUE);
    int found = 0;
    assert_int_equal(skv_experiment_find("dam-brake", &found, NULL), SKV_ERROR_VALUE);
}

/* ---- Tables ---------------------------------------------------------------------------------- */

static void write_run(const skv_study *study, int run, double measured, text *out)
{
    skv_study_row rows[2];
    fill(rows, measured);
    out->length = 0;
    assert_int_equal(skv_study_write(study, run, rows, take, out, NULL), SKV_OK);
}

/* The table of all is the tables of the runs below one head, in the runs' order, whatever order
 * they came in: every number has come back with its bits. */
static void test_tables_come_back(void **state)
{
    (void)state;
    static text one, all, expected;
    skv_study *study = made("fluid.law", "clavet,calibrated", "particles", "400:600:3");
    const char *head = "skvalp,experiment,fluid.law,particles,quantity,unit,measured,theory,ratio,"
                       "tolerance,pass,starts,passed,measured_deviation,ratio_deviation\n";
    take(head, strlen(head), &expected);
    for (int run = 0; run < 6; run++) {
        write_run(study, run, 1e-7 * (run + 1), &one);
        assert_memory_equal(one.bytes, head, strlen(head));
        if (run != 4)
            take(one.bytes + strlen(head), one.length - strlen(head), &expected);
    }
    for (int run = 5; run >= 0; run--) {
        write_run(study, run, 1e-7 * (run + 1), &one);
        if (run != 4)
            assert_int_equal(skv_study_read(study, run, one.bytes, one.length, NULL), SKV_OK);
    }
    assert_int_equal(skv_study_table(study, take, &all, NULL), SKV_OK);
    assert_string_equal(all.bytes, expected.bytes);
    assert_non_null(strstr(all.bytes, ",clavet,400,\"front Z(T), rms deviation\",,"
                                      "3.3333333333333334e-08,0,,5e-324,false,1,0,,\n"));
    assert_non_null(strstr(all.bytes, ",T when Z = 2,,2.5e-08,0.3333333333333333,"
                                      "0.30000000000000004,5e-324,true,1,1,,\n"));
    assert_int_equal(skv_study_table(study, refuse, NULL, NULL), SKV_ERROR_FILE);
    skv_study_destroy(study);
}

/* A table that was cut anywhere, or is another run's, or has something added or changed. */
static void test_damaged_tables_are_refused(void **state)
{
    (void)state;
    static text whole, other;
    skv_study *study = made("particles", "400,600", NULL, NULL);
    skv_error error = {.text = ""};
    write_run(study, 0, 1, &whole);
    write_run(study, 1, 1, &other);
    for (size_t length = 0; length < whole.length; length++) {
        /* What lies behind must not be read. */
        char *cut = malloc(length + 1);
        assert_non_null(cut);
        memcpy(cut, whole.bytes, length);
        assert_int_equal(skv_study_read(study, 0, cut, length, &error), SKV_ERROR_FORMAT);
        assert_memory_equal(error.text, "line ", 5);
        assert_non_null(strstr(error.text, "it is cut"));
        free(cut);
    }
    static const struct {
        const char *from, *to, *said;
    } changes[] = {
        {"skvalp,", "skvalq,", "line 1: it is not the head"},
        {",dam-break,", "9,dam-break,",
         "line 2: it is another run's, another version's, or changed"},
        {",0.3333333333333333,0,", ",0.333333333333x333,0,", "line 2: a number is none"},
        {",0.3333333333333333,0,", ",0.33333333333333330,0,", "line 2: it is changed"},
        {",0.3333333333333333,0,", ",inf,0,", "line 2: a number is none"},
        {"false", "maybe", "line 2: it says neither"},
        {",1,0,,\n", ",1,0,,,\n", "line 2: it is changed"},
        {",1,0,,\n", ",-1,0,,\n", "line 2: its number of starts is none"},
        {",1,1,,\n", ",1,1,,\n\n", "line 4: there is more"},
    };
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        static char changed[4096];
        const char *at = strstr(whole.bytes, changes[i].from);
        assert_non_null(at);
        snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - whole.bytes), whole.bytes,
                 changes[i].to, at + strlen(changes[i].from));
        assert_int_equal(skv_study_read(study, 0, changed, strlen(changed), &error),
                         SKV_ERROR_FORMAT);
        if (!strstr(error.text, changes[i].said))
            fail_msg("%s: '%s'", changes[i].to, error.text);
    }
    assert_int_equal(skv_study_read(study, 0, other.bytes, other.length, NULL), SKV_ERROR_FORMAT);
    assert_int_equal(skv_study_read(study, 0, whole.bytes, whole.length, NULL), SKV_OK);
    skv_study_destroy(study);
}

/* A table from another number of starts than was asked for is not this run's. */
static void test_starts_are_told_apart(void **state)
{
    (void)state;
    static text whole;
    skv_study_plan plan = {.experiment = number_of("dam-break"), .starts = 3};
    skv_study *study = NULL;
    skv_error error = {.text = ""};
    assert_int_equal(skv_study_create(&plan, &study, NULL), SKV_OK);
    assert_int_equal(skv_study_runs(study), 1);
    write_run(study, 0, 1, &whole);
    assert_int_equal(skv_study_read(study, 0, whole.bytes, whole.length, &error), SKV_ERROR_FORMAT);
    assert_string_equal(error.text, "line 2: it is of another number of starts");
    skv_study_destroy(study);
}

/* ---- Pictures -------------------------------------------------------------------------------- */

static int count(const char *all, const char *part)
{
    int found = 0;
    for (const char *at = all; (at = strstr(at, part)); at++)
        found++;
    return found;
}

/* Two quantities, two laws: four panels along the particles, with a dot a run and one in the
 * legend; theory is a line where there is one. Runs that lack leave a gap. */
static void test_picture(void **state)
{
    (void)state;
    static text one, picture;
    skv_study *study = made("fluid.law", "clavet,calibrated", "particles", "500,300,400");
    for (int run = 0; run < 5; run++) {
        write_run(study, run, run + 1, &one);
        assert_int_equal(skv_study_read(study, run, one.bytes, one.length, NULL), SKV_OK);
    }
    assert_int_equal(skv_study_plot(study, take, &picture, NULL), SKV_OK);
    assert_memory_equal(picture.bytes, "<svg ", 5);
    assert_int_equal(count(picture.bytes, "<g transform="), 4);
    assert_int_equal(count(picture.bytes, "<circle class='dots'"), 2 * 5 + 4);
    assert_int_equal(count(picture.bytes, "<polyline class='theory'"), 2);
    assert_int_equal(count(picture.bytes, ">Dam break: fluid.law=clavet<"), 2);
    assert_int_equal(count(picture.bytes, ">Dam break: fluid.law=calibrated<"), 2);
    assert_int_equal(count(picture.bytes, ">particles<"), 4);
    assert_int_equal(count(picture.bytes, ">T when Z = 2<"), 2);
    /* From left to right, though the values were given in another order. */
    const char *line = strstr(picture.bytes, "<polyline class='theory'");
    double x[3];
    assert_int_equal(
        sscanf(line, "<polyline class='theory' points='%lf,%*f %lf,%*f %lf", &x[0], &x[1], &x[2]),
        3);
    assert_true(x[0] < x[1] && x[1] < x[2]);
    assert_int_equal(skv_study_plot(study, refuse, NULL, NULL), SKV_ERROR_FILE);
    skv_study_destroy(study);
}

/* Of what was measured and of what was swept: as the faces write them, not as tables do. */
static void test_axes_have_units_for_people(void **state)
{
    (void)state;
    static text picture;
    skv_study *study = NULL;
    const skv_setting sweep = {"gravity", "9.81,20"};
    skv_study_plan plan = {
        .experiment = number_of("hydrostatics"), .sweeps = &sweep, .sweep_count = 1};
    assert_int_equal(skv_study_create(&plan, &study, NULL), SKV_OK);
    assert_int_equal(skv_study_plot(study, take, &picture, NULL), SKV_OK);
    assert_int_equal(count(picture.bytes, ">gravity (m/s²)<"), 7);
    assert_int_equal(count(picture.bytes, ">volume kept (m²)<"), 1);
    assert_int_equal(count(picture.bytes, "^"), 0);
    skv_study_destroy(study);
}

static void test_pictures_that_cannot_be(void **state)
{
    (void)state;
    static text picture;
    skv_error error = {.text = ""};
    skv_study *study = made("fluid.law", "clavet,calibrated", NULL, NULL);
    assert_int_equal(skv_study_plot(study, take, &picture, &error), SKV_ERROR_VALUE);
    assert_non_null(strstr(error.text, "no number is swept"));
    skv_study_destroy(study);
    study = made("particles", "300,400", "substeps", "1:25:25");
    assert_int_equal(skv_study_plot(study, take, &picture, &error), SKV_ERROR_LIMIT);
    assert_non_null(strstr(error.text, "50 panels, and 48 are allowed"));
    skv_study_destroy(study);
    assert_int_equal(picture.length, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_runs),
        cmocka_unit_test(test_the_longest_name_fits),
        cmocka_unit_test(test_what_is_refused),
        cmocka_unit_test(test_tables_come_back),
        cmocka_unit_test(test_damaged_tables_are_refused),
        cmocka_unit_test(test_starts_are_told_apart),
        cmocka_unit_test(test_picture),
        cmocka_unit_test(test_axes_have_units_for_people),
        cmocka_unit_test(test_pictures_that_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
