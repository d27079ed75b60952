/* Overlays, by what they are to show: strokes are gathered and measured, none is drawn. Arrows and
 * streamlines follow the velocity, grid and ruler lie at whole lengths, tracers on particles. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "render/figures.h"
#include "render/overlays.h"

enum { WIDTH = 800, HEIGHT = 450 };

/* A tank of 1.6 x 0.9 m full of particles on a square lattice, 500 pixels a metre, whose velocities
 * a test sets. */
typedef struct stage {
    skv_world *world;
    skv_frame frame;
    skv_camera camera;
    skv_vertices vertices;
    skv_legend legend;
    skv_overlay_scene scene;
    skv_strokes strokes;
    float *x, *y, *vx, *vy;
    skv_particle_id *id;
} stage;

/* The velocity at a place, m/s. */
typedef void flow_at(double x, double y, double *vx, double *vy);

static void fill(stage *s, flow_at *flow)
{
    double spacing = (double)s->frame.spacing;
    int columns = (int)(1.6 / spacing), rows = (int)(0.9 / spacing), count = columns * rows;
    s->x = calloc(4 * (size_t)count, sizeof *s->x);
    s->id = calloc((size_t)count, sizeof *s->id);
    s->y = s->x + count;
    s->vx = s->y + count;
    s->vy = s->vx + count;
    for (int i = 0; i < count; i++) {
        double x = (i % columns + 0.5) * spacing, y = (i / columns + 0.5) * spacing, vx, vy;
        flow(x, y, &vx, &vy);
        s->x[i] = (float)x;
        s->y[i] = (float)y;
        s->vx[i] = (float)vx;
        s->vy[i] = (float)vy;
        s->id[i] = (skv_particle_id)i;
    }
    s->frame.particles = (skv_particles){.count = count,
                                         .x = s->x,
                                         .y = s->y,
                                         .vx = s->vx,
                                         .vy = s->vy,
                                         .pressure = s->x,
                                         .id = s->id};
}

/* In place, for the vertices know where the frame is. */
static void open_stage(stage *s, flow_at *flow)
{
    *s = (stage){.camera = skv_camera_fit(WIDTH, HEIGHT, 1.6, 0.9)};
    skv_world_def def = skv_default_world_def();
    skv_render_style style = skv_default_render_style();
    assert_int_equal(skv_world_create(&def, &s->world, NULL), SKV_OK);
    s->frame = skv_world_frame(s->world);
    fill(s, flow);
    s->legend = skv_render_legend(&s->frame, &style);
    assert_int_equal(skv_vertices_fill(&s->vertices, &s->frame, SKV_VIEW_WATER, &s->legend,
                                       skv_look_colors(SKV_PALETTE_DARK), false, 1, NULL),
                     SKV_OK);
}

/* Gathers what one overlay draws. */
static void draw(stage *s, unsigned overlay)
{
    s->scene = (skv_overlay_scene){.frame = &s->frame,
                                   .camera = &s->camera,
                                   .vertices = &s->vertices,
                                   .colors = skv_look_colors(SKV_PALETTE_DARK),
                                   .view = SKV_VIEW_WATER,
                                   .legend = &s->legend};
    s->strokes.count = 0;
    assert_int_equal(skv_overlays_add(&s->strokes, &s->scene, overlay, NULL), SKV_OK);
}

static void close_stage(stage *s)
{
    skv_free(s->strokes.list);
    skv_vertices_destroy(&s->vertices);
    skv_world_destroy(s->world);
    free(s->x);
    free(s->id);
}

static double length_of(const skv_stroke *t)
{
    return hypot((double)t->x1 - (double)t->x0, (double)t->y1 - (double)t->y0);
}

static void uniform(double x, double y, double *vx, double *vy)
{
    (void)x, (void)y;
    *vx = 0.6;
    *vy = 0.3;
}

static void faster(double x, double y, double *vx, double *vy)
{
    uniform(x, y, vx, vy);
    *vx *= 0.5;
    *vy *= 0.5;
}

static void still(double x, double y, double *vx, double *vy)
{
    (void)x, (void)y;
    *vx = *vy = 0;
}

/* About the tank's middle, 1 rad/s. */
static void rotation(double x, double y, double *vx, double *vy)
{
    *vx = -(y - 0.45);
    *vy = x - 0.8;
}

/* Three strokes an arrow: its shaft along the velocity, centred on a point of a square grid, and as
 * long as it is fast; the barbs at its head. */
static void arrows_point_along_the_flow(void **state)
{
    (void)state;
    double length[2];
    flow_at *const flows[2] = {uniform, faster};
    for (int k = 0; k < 2; k++) {
        stage s;
        open_stage(&s, flows[k]);
        draw(&s, SKV_OVERLAY_ARROWS);
        assert_true(s.strokes.count > 300 && s.strokes.count % 3 == 0);
        for (int i = 0; i < s.strokes.count; i += 3) {
            const skv_stroke *t = &s.strokes.list[i];
            double dx = (double)t->x1 - (double)t->x0, dy = (double)t->y1 - (double)t->y0;
            length[k] = length_of(t);
            assert_true(fabs(dx * 0.3 - dy * 0.6) < 1e-3 * length[k] && dx > 0);
            /* 1/16 m apart: 30 lines of the drawing, to the next halving of a metre. */
            double x = 0.5 * ((double)t->x0 + (double)t->x1) / 500 * 16 - 0.5;
            double y = 0.5 * ((double)t->y0 + (double)t->y1) / 500 * 16 - 0.5;
            assert_true(fabs(x - round(x)) < 1e-3 && fabs(y - round(y)) < 1e-3);
            for (int b = 1; b <= 2; b++) {
                assert_true(t[b].x0 == t->x1 && t[b].y0 == t->y1);
                double back = ((double)t[b].x1 - (double)t[b].x0) * dx +
                              ((double)t[b].y1 - (double)t[b].y0) * dy;
                assert_true(back < 0);
            }
        }
        close_stage(&s);
    }
    assert_true(fabs(length[0] / length[1] - 2) < 0.02);
    /* Where nothing moves there are dots. */
    stage s;
    open_stage(&s, still);
    draw(&s, SKV_OVERLAY_ARROWS);
    assert_true(s.strokes.count > 100);
    for (int i = 0; i < s.strokes.count; i++)
        assert_true(length_of(&s.strokes.list[i]) == 0);
    close_stage(&s);
}

/* Of a rigid rotation all streamlines are circles about its middle, and their pieces hang together.
 */
static void streamlines_of_a_rotation_are_circles(void **state)
{
    (void)state;
    stage s;
    open_stage(&s, rotation);
    draw(&s, SKV_OVERLAY_STREAMLINES);
    assert_true(s.strokes.count > 1000);
    int joined = 0;
    /* Three distances of beginnings, 1/16 m, in 16 pieces. */
    const double longest = 500 * 3.0 / 16 / 16;
    for (int i = 0; i < s.strokes.count; i++) {
        const skv_stroke *t = &s.strokes.list[i];
        double ax = (double)t->x0 / 500 - 0.8, ay = (double)t->y0 / 500 - 0.45;
        double bx = (double)t->x1 / 500 - 0.8, by = (double)t->y1 / 500 - 0.45;
        double from = hypot(ax, ay), to = hypot(bx, by);
        /* Beside walls the mesh knows one side of a place alone. */
        if (from < 0.05 || from > 0.4)
            continue;
        if (fabs(from - to) > 0.005 * length_of(t) / 500 + 1e-6 || length_of(t) > longest)
            fail_msg("from a radius of %g to %g m in a piece of %g m", from, to,
                     length_of(t) / 500);
        joined += i > 0 && t[-1].x1 == t->x0 && t[-1].y1 == t->y0;
    }
    assert_true(joined > s.strokes.count / 4);
    close_stage(&s);
    /* Nothing flows: no line. */
    open_stage(&s, still);
    draw(&s, SKV_OVERLAY_STREAMLINES);
    assert_int_equal(s.strokes.count, 0);
    close_stage(&s);
}

/* Every tick is a whole number of centimetres from the world's corner. */
static void rulers_tell_the_truth(void **state)
{
    (void)state;
    const double zooms[] = {1, 3.7};
    for (int k = 0; k < 2; k++) {
        stage s;
        open_stage(&s, still);
        skv_camera_zoom(&s.camera, zooms[k], 300, 200);
        double scale = s.camera.scale;
        double left = s.camera.origin_x, bottom = s.camera.height - s.camera.origin_y;
        draw(&s, SKV_OVERLAY_GRID);
        double step = skv_overlay_step(&s.camera, 24);
        assert_true(s.strokes.count >= 5);
        for (int i = 0; i < s.strokes.count; i++) {
            const skv_stroke *t = &s.strokes.list[i];
            bool upright = t->x0 == t->x1;
            double at = (upright ? (double)t->x0 - left : (double)t->y0 - bottom) / scale / step;
            assert_true(upright || t->y0 == t->y1);
            assert_true(fabs(at - round(at)) < 0.5 / scale / step);
        }
        draw(&s, SKV_OVERLAY_RULER);
        step = skv_overlay_step(&s.camera, 40);
        int long_ticks = 0;
        for (int i = 0; i < s.strokes.count; i++) {
            const skv_stroke *t = &s.strokes.list[i];
            double length = length_of(t);
            bool upright = t->x0 == t->x1;
            /* Ticks are thin and 4, 7 or 10 lines long; figures and plates are not. */
            if (fabs((double)t->radius - 0.6) > 1e-4 || fabs(length - 10) > 1e-3)
                continue;
            double at = (upright ? (double)t->x0 - left : (double)t->y0 - bottom) / scale / step;
            assert_true(fabs(at - round(at)) < 0.5 / scale / step);
            long_ticks++;
        }
        assert_true(long_ticks >= 4);
        close_stage(&s);
    }
}

/* Strokes that are no longer than a point. */
static int dots_of(const stage *s)
{
    int dots = 0;
    for (int i = 0; i < s->strokes.count; i++)
        dots += length_of(&s->strokes.list[i]) == 0;
    return dots;
}

/* From so near that a step is half a centimetre, a figure has a decimal point, or a comma. */
static void decimals_are_of_a_language(void **state)
{
    (void)state;
    stage s;
    open_stage(&s, still);
    skv_camera_zoom(&s.camera, 40 / 0.005 / s.camera.scale, 300, 200);
    draw(&s, SKV_OVERLAY_RULER);
    int count = s.strokes.count;
    assert_true(dots_of(&s) > 0);
    s.scene.comma = true;
    s.strokes.count = 0;
    assert_int_equal(skv_overlays_add(&s.strokes, &s.scene, SKV_OVERLAY_RULER, NULL), SKV_OK);
    assert_int_equal(dots_of(&s), 0);
    assert_int_equal(s.strokes.count, count);
    close_stage(&s);
}

/* Each figure of a scale is drawn whole, however large or small; a middle one that would reach into
 * the last is left out. */
static void scales_have_their_figures(void **state)
{
    (void)state;
    static const struct {
        double high;
        const char *figures[2];
    } scales[] = {{0.8, {"0.4", "0.8 m/s"}},        {0.00002, {"", "0.00002 m/s"}},
                  {2469.125, {"1235", "2469 m/s"}}, {30000, {"15000", "30000 m/s"}},
                  {123456, {"", "123456 m/s"}},     {1e9, {"", "1000000000 m/s"}}};
    stage s;
    open_stage(&s, still);
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        s.legend = (skv_legend){.shown = true, .unit = "m/s", .high = scales[i].high};
        draw(&s, SKV_OVERLAY_LEGEND);
        int count = 1 + SKV_LEGEND_COLORS + skv_figures_count("0");
        for (int k = 0; k < 2; k++)
            count += skv_figures_count(scales[i].figures[k]);
        assert_int_equal(s.strokes.count, count);
    }
    close_stage(&s);
}

/* One particle in ten, each on its particle; the same ones wherever they are. */
static void tracers_mark_a_tenth(void **state)
{
    (void)state;
    stage s;
    open_stage(&s, uniform);
    draw(&s, SKV_OVERLAY_TRACERS);
    int count = s.frame.particles.count;
    assert_true(abs(s.strokes.count * 10 - count) < count / 5);
    int next = 0;
    for (int i = 0; i < s.strokes.count; i++) {
        const skv_stroke *t = &s.strokes.list[i];
        while (next < count &&
               (fabsf(s.x[next] * 500 - t->x0) > 0.01f || fabsf(s.y[next] * 500 - t->y0) > 0.01f))
            next++;
        assert_true(next < count && length_of(t) == 0);
    }
    int before = s.strokes.count;
    for (int i = 0; i < count; i++)
        s.x[i] = 1.6f - s.x[i];
    draw(&s, SKV_OVERLAY_TRACERS);
    assert_int_equal(s.strokes.count, before);
    close_stage(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrows_point_along_the_flow),
        cmocka_unit_test(streamlines_of_a_rotation_are_circles),
        cmocka_unit_test(rulers_tell_the_truth),
        cmocka_unit_test(decimals_are_of_a_language),
        cmocka_unit_test(scales_have_their_figures),
        cmocka_unit_test(tracers_mark_a_tenth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
