/* The same scene at twice the particles behaves the same, within the bands of docs/lab.md: 2000 and
 * 4000 particles. Without SKV_LONG_TESTS=1 what takes longest is seen at 1000 and 2000, in the same
 * bands. */
#include "experiments/experiment.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

/* The two runs of an experiment. */
typedef struct pair {
    findings coarse, fine;
} pair;

static pair run_twice(const experiment *e, bool is_long)
{
    pair p;
    findings *found[2] = {&p.coarse, &p.fine};
    const char *particles[3] = {"1000", "2000", "4000"};
    int first = is_long && !getenv("SKV_LONG_TESTS") ? 0 : 1;
    for (int i = 0; i < 2; i++) {
        skv_setting setting = {"particles", particles[first + i]};
        skv_lab_options options = skv_default_lab_options();
        options.settings = &setting;
        options.setting_count = 1;
        options.threads = 1;
        assert_int_equal(skv_experiment_measure(e, &options, found[i], NULL), SKV_OK);
    }
    assert_true(p.fine.particles > 1.8 * p.coarse.particles);
    return p;
}

static void free_pair(pair *p)
{
    skv_findings_free(&p->coarse);
    skv_findings_free(&p->fine);
}

/* Compares a quantity; `band` is a share, or absolute. */
static void check(const experiment *e, const pair *p, int which, double band, bool absolute)
{
    double coarse = p->coarse.measured[which], fine = p->fine.measured[which];
    double difference = absolute ? fine - coarse : fine / coarse - 1;
    printf("%s, %s: %g and %g, %+.4f of %g\n", e->info.name, e->quantities[which].name, coarse,
           fine, difference, band);
    assert_true(fabs(difference) <= band);
}

static void periods_stay(void **unused)
{
    (void)unused;
    pair slosh = run_twice(&skv_exp_slosh, true);
    check(&skv_exp_slosh, &slosh, 0, 0.015, false);
    check(&skv_exp_slosh, &slosh, 1, 0.1, true);
    free_pair(&slosh);
    pair tube = run_twice(&skv_exp_u_tube, true);
    check(&skv_exp_u_tube, &tube, 0, 0.015, false);
    free_pair(&tube);
}

static void the_front_stays(void **unused)
{
    (void)unused;
    pair p = run_twice(&skv_exp_dam_break, true);
    double square = 0;
    int points = skv_exp_dam_break.quantities[0].points;
    for (int i = 0; i < points; i++) {
        double difference = p.fine.point[i] - p.coarse.point[i];
        square += difference * difference / points;
    }
    printf("dam-break: fronts differ by %.4f (rms)\n", sqrt(square));
    assert_true(points > 10 && sqrt(square) <= 0.08);
    free_pair(&p);
}

static void levels_and_settling_stay(void **unused)
{
    (void)unused;
    pair pool = run_twice(&skv_exp_hydrostatics, false);
    check(&skv_exp_hydrostatics, &pool, 6, 0.02, false);
    free_pair(&pool);
    pair rest = run_twice(&skv_exp_rest, false);
    check(&skv_exp_rest, &rest, 0, 0.8, true);
    free_pair(&rest);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(periods_stay),
        cmocka_unit_test(the_front_stays),
        cmocka_unit_test(levels_and_settling_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
