/* Waves break and droplets hold, in one and the same water, as one sees it: on the picture that the
 * renderer draws. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <skvalp/render.h>
#include <skvalp/scene.h>

enum { WIDTH = 640 };

/* What is fluid on a picture, and regions of one kind. */
typedef struct mask {
    int width, height;
    bool *fluid;
    int *region; /* numbered from 1, in the order of finding */
    int *stack;
} mask;

typedef struct stage {
    skv_world *world;
    skv_offscreen *offscreen;
    uint8_t *rgb;
    mask mask;
    double metre; /* pixels */
} stage;

static stage open_stage(const char *name, int particles)
{
    stage s = {0};
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_scene *scene;
    assert_int_equal(skv_scene_load(name, &options, &scene, NULL), SKV_OK);
    assert_int_equal(skv_scene_create_world(scene, 1, &s.world, NULL), SKV_OK);
    skv_scene_destroy(scene);
    /* Both scenes are the default water. */
    const skv_fluid_def *fluid = skv_world_fluid(s.world);
    skv_fluid_def water = skv_default_fluid_def(SKV_LAW_CALIBRATED);
    assert_true(fluid->cohesion == water.cohesion && fluid->law == water.law &&
                fluid->near_stiffness == water.near_stiffness &&
                fluid->viscosity_linear == water.viscosity_linear &&
                fluid->viscosity_quadratic == water.viscosity_quadratic);
    const skv_terrain *terrain = skv_world_terrain(s.world);
    s.metre = WIDTH / (double)skv_terrain_width(terrain);
    mask *m = &s.mask;
    m->width = WIDTH;
    m->height = (int)(s.metre * (double)skv_terrain_height(terrain));
    size_t pixels = (size_t)m->width * (size_t)m->height;
    s.rgb = malloc(3 * pixels);
    m->fluid = malloc(pixels * sizeof *m->fluid);
    m->region = malloc(pixels * sizeof *m->region);
    m->stack = malloc(pixels * sizeof *m->stack);
    assert_int_equal(skv_offscreen_create(m->width, m->height, &s.offscreen, NULL), SKV_OK);
    return s;
}

static void close_stage(stage *s)
{
    skv_offscreen_destroy(s->offscreen);
    skv_world_destroy(s->world);
    free(s->rgb);
    free(s->mask.fluid);
    free(s->mask.region);
    free(s->mask.stack);
}

/* One frame later. Everything but the dark background is fluid, its light outline included: there
 * are no walls in these pictures. */
static void next_mask(stage *s)
{
    mask *m = &s->mask;
    skv_render_style style = skv_default_render_style();
    assert_int_equal(skv_world_step(s->world, 1.0f / 60, NULL), SKV_OK);
    skv_frame frame = skv_world_frame(s->world);
    assert_int_equal(skv_offscreen_render(s->offscreen, &frame, &style, s->rgb, NULL), SKV_OK);
    for (int i = 0; i < m->width * m->height; i++) {
        const uint8_t *c = s->rgb + (size_t)i * 3;
        m->fluid[i] = !(c[0] < 60 && c[1] < 60 && c[2] < 80);
    }
}

/* The area of the region of one kind around a pixel, which is numbered; `border`: whether it
 * reaches the picture's border. */
static int fill_region(mask *m, int start, int number, bool *border)
{
    int top = 0, area = 0;
    bool kind = m->fluid[start];
    *border = false;
    m->region[start] = number;
    m->stack[top++] = start;
    while (top > 0) {
        int at = m->stack[--top], x = at % m->width, y = at / m->width;
        area++;
        const int step_x[4] = {1, -1, 0, 0}, step_y[4] = {0, 0, 1, -1};
        for (int k = 0; k < 4; k++) {
            int i = x + step_x[k], j = y + step_y[k];
            if (i < 0 || j < 0 || i >= m->width || j >= m->height) {
                *border = true;
                continue;
            }
            int to = j * m->width + i;
            if (m->fluid[to] == kind && !m->region[to]) {
                m->region[to] = number;
                m->stack[top++] = to;
            }
        }
    }
    return area;
}

/* The largest background region that fluid encloses, in square metres, and the number of regions of
 * fluid. */
static double find_regions(stage *s, int *bodies)
{
    mask *m = &s->mask;
    int number = 0, largest = 0;
    memset(m->region, 0, (size_t)m->width * (size_t)m->height * sizeof *m->region);
    *bodies = 0;
    for (int i = 0; i < m->width * m->height; i++) {
        if (m->region[i])
            continue;
        bool border;
        int area = fill_region(m, i, ++number, &border);
        *bodies += m->fluid[i];
        if (!m->fluid[i] && !border && area > largest)
            largest = area;
    }
    return largest / (s->metre * s->metre);
}

/* A lip shoots out of the steep front, falls onto the shallow layer and encloses a tube of air as
 * large as twenty particles. */
static void the_wave_plunges(void **unused)
{
    (void)unused;
    const int sizes[] = {3000, 6000};
    for (int k = 0; k < 2; k++) {
        stage s = open_stage("breaking-wave", sizes[k]);
        double largest = 0, when = 0;
        int frames = 0;
        double least = 20 * (double)skv_world_spacing(s.world) * (double)skv_world_spacing(s.world);
        for (int f = 0; f < 60; f++) {
            next_mask(&s);
            int bodies;
            double air = find_regions(&s, &bodies);
            frames += air > least;
            if (air > largest) {
                largest = air;
                when = skv_world_time(s.world);
            }
        }
        printf("%d particles: %.4f m^2 of air (%.0f particles) enclosed at %.2f s, for %d frames\n",
               sizes[k], largest, 20 * largest / least, when, frames);
        assert_true(largest > least);
        assert_true(frames >= 3);
        close_stage(&s);
    }
}

/* The droplet is one piece, and the pool another, until they are one. */
static void the_droplet_holds(void **unused)
{
    (void)unused;
    const int sizes[] = {3000, 6000};
    for (int k = 0; k < 2; k++) {
        stage s = open_stage("splash", sizes[k]);
        int apart = 0, bodies = 2;
        while (apart < 60) {
            next_mask(&s);
            find_regions(&s, &bodies);
            if (bodies == 1)
                break;
            assert_int_equal(bodies, 2);
            apart++;
        }
        printf("%d particles: in one piece for %d frames\n", sizes[k], apart);
        /* It falls for 0.23 s. */
        assert_in_range(apart, 11, 16);
        close_stage(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_wave_plunges),
        cmocka_unit_test(the_droplet_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
