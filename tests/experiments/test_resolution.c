/* The same scene at twice the particles behaves the same, within the bands of docs/lab.md: 2000 and
 * 4000 particles. What scatters from one start to the next is a mean over several. */
#include "experiments/experiment.h"

#include "starts.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

/* An experiment with few particles and with twice as many; of each the starts in turn. */
typedef struct pair {
    findings coarse[START_COUNT], fine[START_COUNT];
    int starts;
} pair;

static void run_one(const experiment *e, int particles, findings *found)
{
    char text[16];
    snprintf(text, sizeof text, "%d", particles);
    skv_setting setting = {"particles", text};
    skv_lab_options options = skv_default_lab_options();
    options.settings = &setting;
    options.setting_count = 1;
    options.threads = 1;
    assert_int_equal(skv_experiment_measure(e, &options, found, NULL), SKV_OK);
}

static pair run_twice(const experiment *e, int starts)
{
    pair p = {.starts = starts};
    const int few = 2000;
    for (int i = 0; i < starts; i++) {
        run_one(e, start_particles(few, i), &p.coarse[i]);
        run_one(e, start_particles(2 * few, i), &p.fine[i]);
        assert_true(p.fine[i].particles > 1.8 * p.coarse[i].particles);
    }
    return p;
}

static void free_pair(pair *p)
{
    for (int i = 0; i < p->starts; i++) {
        skv_findings_free(&p->coarse[i]);
        skv_findings_free(&p->fine[i]);
    }
}

/* Compares a quantity's means; `band` is a share, or absolute. */
static void check(const experiment *e, const pair *p, int which, double band, bool absolute)
{
    double coarse = 0, fine = 0;
    for (int i = 0; i < p->starts; i++) {
        coarse += p->coarse[i].measured[which] / p->starts;
        fine += p->fine[i].measured[which] / p->starts;
    }
    double difference = absolute ? fine - coarse : fine / coarse - 1;
    printf("%s, %s: %g and %g, %+.4f of %g\n", e->info.name, e->quantities[which].name, coarse,
           fine, difference, band);
    assert_true(fabs(difference) <= band);
}

static void periods_stay(void **unused)
{
    (void)unused;
    pair slosh = run_twice(&skv_exp_slosh, 1);
    check(&skv_exp_slosh, &slosh, 0, 0.015, false);
    check(&skv_exp_slosh, &slosh, 1, 0.1, true);
    free_pair(&slosh);
    pair tube = run_twice(&skv_exp_u_tube, START_COUNT);
    check(&skv_exp_u_tube, &tube, 0, 0.015, false);
    free_pair(&tube);
}

static void the_front_stays(void **unused)
{
    (void)unused;
    pair p = run_twice(&skv_exp_dam_break, 1);
    double square = 0;
    int points = skv_exp_dam_break.quantities[0].points;
    for (int i = 0; i < points; i++) {
        double difference = p.fine->point[i] - p.coarse->point[i];
        square += difference * difference / points;
    }
    printf("dam-break: fronts differ by %.4f (rms)\n", sqrt(square));
    assert_true(points > 10 && sqrt(square) <= 0.08);
    free_pair(&p);
}

static void levels_and_settling_stay(void **unused)
{
    (void)unused;
    pair pool = run_twice(&skv_exp_hydrostatics, 1);
    check(&skv_exp_hydrostatics, &pool, 6, 0.02, false);
    free_pair(&pool);
    pair rest = run_twice(&skv_exp_rest, START_COUNT);
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
