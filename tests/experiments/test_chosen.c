/* The number of particles that a person chooses: an experiment's world begins with it, or with as
 * many as its narrowest passage needs. */
#include <skvalp/experiments.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* Stops at the first frame, whose particles it counts. */
static bool count(const skv_lab_moment *moment, void *user)
{
    int *particles = user;
    *particles = moment->frame->particles.count;
    return false;
}

/* With how many particles an experiment begins. */
static int begin(int experiment, int chosen, const skv_setting *setting)
{
    int particles = 0;
    skv_lab_options options = skv_default_lab_options();
    options.particles = chosen;
    options.settings = setting;
    options.setting_count = setting ? 1 : 0;
    options.threads = 1;
    options.observe = count;
    options.user = &particles;
    skv_report *report;
    skv_error error = {0};
    if (skv_experiment_run(experiment, &options, &report, &error) != SKV_STOPPED)
        fail_msg("%s with %d: %s", skv_experiment_info(experiment)->name, chosen, error.text);
    return particles;
}

static int number_of(const char *name)
{
    int i = 0;
    while (strcmp(skv_experiment_info(i)->name, name) != 0)
        i++;
    return i;
}

static void each_begins_with_what_is_chosen(void **unused)
{
    (void)unused;
    int raised = 0;
    for (int i = 0; skv_experiment_info(i); i++) {
        assert_true(skv_experiment_particles(i, 0) >= 4000); /* as each says by itself */
        assert_int_equal(skv_experiment_particles(i, 7001), 7001);
        int fewest = skv_experiment_particles(i, 1);
        assert_in_range(fewest, 200, 6000); /* 5800 in the three tanks of torricelli */
        raised += fewest > 200;
        assert_int_equal(begin(i, 1, NULL), fewest);
        assert_int_equal(skv_experiment_particles(i, fewest + 7), fewest + 7);
        assert_int_equal(begin(i, fewest + 7, NULL), fewest + 7);
    }
    assert_true(raised >= 3);
    assert_int_equal(skv_experiment_particles(-1, 3500), 0);
    /* Whose slot is so small that it has more than the setting says. */
    assert_int_equal(skv_experiment_particles(number_of("orifice"), 0), 10000);
}

/* An arm half as wide needs four times as many, of which the bend is a smaller part. */
static void what_is_needed_follows_the_set_up(void **unused)
{
    (void)unused;
    int tube = number_of("u-tube");
    const skv_setting narrow = {"u-tube.arm", "0.06"};
    int plain = begin(tube, 1, NULL), fewest = begin(tube, 1, &narrow);
    assert_in_range(plain, 500, 600);
    assert_in_range(fewest, 1.5 * plain, 4 * plain);
    assert_int_equal(begin(tube, 3000, &narrow), 3000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_begins_with_what_is_chosen),
        cmocka_unit_test(what_is_needed_follows_the_set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
