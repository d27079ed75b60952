/* How the picture looks, by what can be counted: contrast, round drops of the right area, a calm
 * pool, pressures that are true up to the walls. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl3.h>
#include <cmocka.h>

#include "render/picture.h"
#include "render/renderer.h"
#include <skvalp/query.h>

static const char *palette_name(int palette)
{
    return skv_style_choice_at(SKV_STYLE_PALETTE, palette)->name;
}

/* View pixels, y down, in a picture that shows the whole of a world. */
static skv_camera camera_of(const skv_frame *frame, const picture *p)
{
    return skv_camera_fit(p->width, p->height, (double)skv_terrain_width(frame->terrain),
                          (double)skv_terrain_height(frame->terrain));
}

/* Luminances of all pixels that lie surely in walls, or surely in fluid: within 0.35 spacings of a
 * particle and not at a wall's edge. Returns their number; free them. */
static int luminances(const skv_frame *frame, const picture *p, bool of_walls, double **found)
{
    skv_camera camera = camera_of(frame, p);
    int pixels = p->width * p->height, count = 0;
    bool *fluid = calloc((size_t)pixels, sizeof *fluid);
    double reach = 0.35 * (double)frame->spacing * camera.scale;
    for (int i = 0; i < frame->particles.count; i++) {
        double px, py;
        skv_camera_to_view(&camera, (double)frame->particles.x[i], (double)frame->particles.y[i],
                           &px, &py);
        for (int y = (int)(py - reach); y <= (int)(py + reach); y++)
            for (int x = (int)(px - reach); x <= (int)(px + reach); x++)
                if (x >= 0 && y >= 0 && x < p->width && y < p->height &&
                    hypot(x + 0.5 - px, y + 0.5 - py) <= reach)
                    fluid[y * p->width + x] = true;
    }
    *found = malloc((size_t)pixels * sizeof **found);
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            double wx, wy;
            skv_camera_to_world(&camera, x + 0.5, y + 0.5, &wx, &wy);
            double wall =
                camera.scale * (double)skv_terrain_distance(frame->terrain, (float)wx, (float)wy);
            if (of_walls ? wall < -3 : fluid[y * p->width + x] && wall > 2)
                (*found)[count++] = luminance(at(p, x, y));
        }
    free(fluid);
    return count;
}

/* The contrast that all but a few hundredths of the fluid have with all but a few of the walls. */
static double least_contrast(const skv_frame *frame, const picture *p)
{
    double *fluid, *walls;
    int fluids = luminances(frame, p, false, &fluid), solid = luminances(frame, p, true, &walls);
    assert_true(fluids > 1000 && solid > 1000);
    median(fluid, fluids);
    median(walls, solid);
    const int few = 50;
    double darkest_fluid = fluid[fluids / few], brightest_fluid = fluid[fluids - 1 - fluids / few];
    double darkest_wall = walls[solid / few], brightest_wall = walls[solid - 1 - solid / few];
    double least = darkest_fluid > brightest_wall   ? contrast(darkest_fluid, brightest_wall)
                   : brightest_fluid < darkest_wall ? contrast(brightest_fluid, darkest_wall)
                                                    : 1;
    free(fluid);
    free(walls);
    return least;
}

/* Water against walls in grey, from the shallowest to the deepest; in all views in the dark. */
static void fluid_stands_out_against_walls(void **state)
{
    (void)state;
    const char *const scenes[] = {"communicating", "u-tube"};
    const skv_view views[] = {SKV_VIEW_WATER, SKV_VIEW_FLUID, SKV_VIEW_PRESSURE, SKV_VIEW_SPEED,
                              SKV_VIEW_DENSITY};
    for (int s = 0; s < 2; s++) {
        skv_world *world = make_world(scenes[s], 2000, 2);
        skv_frame frame = skv_world_frame(world);
        for (int palette = SKV_PALETTE_DARK; palette <= SKV_PALETTE_CONTRAST; palette++)
            for (int v = 0; v < (palette == SKV_PALETTE_DARK ? 5 : 2); v++) {
                skv_render_style style = skv_default_render_style();
                style.palette = (skv_palette)palette;
                style.view = views[v];
                picture p = shoot_frame(&frame, &style, 640, 360);
                double least = least_contrast(&frame, &p);
                printf("%s, %s, %s: contrast %.2f\n", scenes[s], palette_name(palette),
                       skv_style_choice_at(SKV_STYLE_VIEW, (int)views[v])->name, least);
                assert_true(least >= 3);
                free(p.rgb);
            }
        skv_world_destroy(world);
    }
}

/* Where fluid shows a scale, whose bright end is as bright as light walls, a line parts them: it
 * has that contrast with both. */
static void a_line_parts_scales_from_walls(void **state)
{
    (void)state;
    skv_world *world = make_world("communicating", 2000, 2);
    skv_frame frame = skv_world_frame(world);
    for (int palette = SKV_PALETTE_LIGHT; palette <= SKV_PALETTE_CONTRAST; palette++) {
        skv_render_style style = skv_default_render_style();
        style.palette = (skv_palette)palette;
        style.view = SKV_VIEW_PRESSURE;
        style.range = 200; /* everything at the bright end */
        picture p = shoot_frame(&frame, &style, 1280, 720);
        /* Down through the floor, where the pool on the left ends. */
        double fluid = luminance(at(&p, 150, 660)), wall = luminance(at(&p, 150, 712)), line = 1;
        for (int y = 660; y < 712; y++)
            line = fmin(line, luminance(at(&p, 150, y)));
        printf("%s: the line's contrast is %.2f with fluid, %.2f with walls\n",
               palette_name(palette), contrast(fluid, line), contrast(wall, line));
        assert_true(contrast(fluid, line) >= 3 && contrast(wall, line) >= 3);
        free(p.rgb);
    }
    skv_world_destroy(world);
}

/* A frame of our own: particles wherever we want them, in an empty tank. */
typedef struct stage {
    skv_terrain *terrain;
    float x[64], y[64], zero[64];
    skv_particle_id id[64];
    skv_frame frame;
} stage;

static void open_stage(stage *s, int count, float spacing)
{
    skv_terrain_def def = skv_default_terrain_def(); /* 1.6 x 0.9 m */
    assert_int_equal(skv_terrain_create(&def, &s->terrain, NULL), SKV_OK);
    memset(s->zero, 0, sizeof s->zero);
    for (int i = 0; i < count; i++)
        s->id[i] = (skv_particle_id)i;
    s->frame = (skv_frame){.particles = {.count = count,
                                         .x = s->x,
                                         .y = s->y,
                                         .vx = s->zero,
                                         .vy = s->zero,
                                         .pressure = s->zero,
                                         .clearance = s->zero,
                                         .id = s->id},
                           .awake = count,
                           .terrain = s->terrain,
                           .spacing = spacing,
                           .smoothing_radius = 2 * spacing,
                           .density = 1000,
                           .gravity_y = -9.81f};
}

/* How much of each pixel a drop covers, as its colour tells on black. */
static double coverage(const uint8_t *rgb)
{
    return fmin(rgb[2] / 232.0, 1);
}

/* Area in spacings squared; in eight directions from its middle a round drop reaches as far. */
static void check_drop(const picture *p, double px, double py, double spacing)
{
    int reach = (int)ceil(1.5 * spacing) + 2;
    double area = 0, sectors[8] = {0}, mx = 0, my = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int y = (int)py - reach; y <= (int)py + reach; y++)
            for (int x = (int)px - reach; x <= (int)px + reach; x++) {
                double c = coverage(at(p, x, y)), dx = x + 0.5 - px, dy = y + 0.5 - py;
                if (pass == 0) {
                    area += c;
                    mx += c * dx;
                    my += c * dy;
                    continue;
                }
                for (int k = 0; k < 16; k++) { /* a pixel may lie in several */
                    double sx = dx + (k % 4 - 1.5) / 4, sy = dy + (k / 4 - 1.5) / 4;
                    double turn = (atan2(sy, sx) + 3.14159265 + 0.39269908) / 0.78539816;
                    sectors[(int)turn % 8] += c / 16;
                }
            }
    double least = 1e9, most = 0;
    for (int k = 0; k < 8; k++) {
        least = fmin(least, sectors[k]);
        most = fmax(most, sectors[k]);
    }
    printf("spacing %5.1f px: area %.3f spacings squared, sectors %.2f to %.2f of the mean\n",
           spacing, area / (spacing * spacing), 8 * least / area, 8 * most / area);
    assert_true(fabs(area / (spacing * spacing) - 1) < (spacing > 8 ? 0.04 : 0.06));
    assert_true(hypot(mx, my) / area < 0.35);
    assert_true(8 * least / area > 0.93 && 8 * most / area < 1.08);
}

static void lone_drops_are_round_and_of_their_area(void **state)
{
    (void)state;
    const double pixels[] = {6, 9.7, 14, 23.3, 48, 91};
    for (size_t i = 0; i < sizeof pixels / sizeof *pixels; i++) {
        stage s;
        open_stage(&s, 4, (float)(pixels[i] / 800));
        const double places[4][2] = {{320, 180}, {960.3, 180.7}, {320.5, 540.25}, {900.6, 500.4}};
        for (int k = 0; k < 4; k++) {
            s.x[k] = (float)(places[k][0] / 800);
            s.y[k] = (float)((720 - places[k][1]) / 800);
        }
        skv_render_style style = skv_default_render_style();
        style.palette = SKV_PALETTE_CONTRAST; /* flat on black */
        picture p = shoot_frame(&s.frame, &style, 1280, 720);
        for (int k = 0; k < 4; k++)
            check_drop(&p, places[k][0], places[k][1], pixels[i]);
        free(p.rgb);
        skv_terrain_destroy(s.terrain);
    }
}

/* As much is drawn as there is. */
static void the_area_drawn_is_the_fluids(void **state)
{
    (void)state;
    const struct {
        const char *scene;
        int particles, frames;
    } cases[] = {{"pool", 3000, 60}, {"pool", 800, 120}, {"splash", 3000, 10}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        skv_world *world = make_world(cases[i].scene, cases[i].particles, cases[i].frames);
        skv_frame frame = skv_world_frame(world);
        skv_packing packing;
        assert_int_equal(skv_world_packing(world, &packing, NULL), SKV_OK);
        skv_render_style style = skv_default_render_style();
        picture p = shoot_frame(&frame, &style, 960, 540);
        double metres = 1.6 / 960, drawn = 0;
        for (int k = 0; k < 960 * 540; k++)
            drawn += p.rgb[3 * k + 2] > 110;
        double there = frame.particles.count * (double)frame.spacing * (double)frame.spacing *
                       packing.volume_ratio;
        double ratio = drawn * metres * metres / there;
        printf("%s, %d particles: %.3f of the area is drawn\n", cases[i].scene,
               frame.particles.count, ratio);
        assert_true(ratio > 0.99 && ratio < 1.02);
        free(p.rgb);
        skv_world_destroy(world);
    }
}

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* How much a pool's pictures differ from frame to frame: the mean difference of their bytes, and
 * the number of those that differ by more than eight. Of water in the worst frame of a second; of
 * the pressure in its median, for once in a while a particle finds a better place, and the lines
 * about it ring for half a second. */
static void measure_flicker(int particles, double unrest[2], double changed[2])
{
    enum { FRAMES = 60 };
    skv_world *world = make_world("pool", particles, 180);
    const skv_view views[] = {SKV_VIEW_WATER, SKV_VIEW_PRESSURE};
    picture before[2];
    double difference[2][FRAMES] = {{0}}, number[2][FRAMES] = {{0}};
    skv_render_style style = skv_default_render_style();
    for (int f = 0; f <= FRAMES; f++) {
        for (int v = 0; v < 2; v++) {
            style.view = views[v];
            picture now = shoot(world, &style, 640, 360);
            for (int k = 0; f > 0 && k < 640 * 360 * 3; k++) {
                int byte = abs(now.rgb[k] - before[v].rgb[k]);
                difference[v][f - 1] += byte / (640.0 * 360 * 3);
                number[v][f - 1] += byte > 8;
            }
            if (f > 0)
                free(before[v].rgb);
            before[v] = now;
        }
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
    }
    for (int v = 0; v < 2; v++) {
        int last = v == 0 ? FRAMES - 1 : FRAMES / 2;
        qsort(difference[v], FRAMES, sizeof **difference, compare_numbers);
        qsort(number[v], FRAMES, sizeof **number, compare_numbers);
        unrest[v] = difference[v][last];
        changed[v] = number[v][last];
        free(before[v].rgb);
    }
    skv_world_destroy(world);
}

/* From one frame to the next nothing flickers where the fluid rests. A particle finds a better
 * place in the water of one pool of three, in whichever second one looks: two of three are calm, of
 * which the third is looked at only if it decides. */
static void a_calm_pool_does_not_flicker(void **state)
{
    (void)state;
    enum { POOLS = 3, CALM = 2 };
    static const int particles[POOLS] = {1900, 2100, 2000};
    int calm[2] = {0}, unchanged[2] = {0};
    bool decided = false;
    for (int i = 0; i < POOLS && !decided; i++) {
        double unrest[2], changed[2];
        measure_flicker(particles[i], unrest, changed);
        decided = true;
        for (int v = 0; v < 2; v++) {
            printf("flicker: %.4f, %.0f bytes\n", unrest[v], changed[v]);
            calm[v] += unrest[v] < 0.03;
            unchanged[v] += changed[v] < 100;
            decided = decided && calm[v] >= CALM && unchanged[v] >= CALM;
        }
    }
    assert_true(decided);
}

/* The place on a scale, 0..1, that a colour stands for; negative if it is none of its colours. */
static double place_of(const skv_legend *legend, const uint8_t *rgb)
{
    double best = 1e9, place = -1;
    for (int i = 0; i + 1 < SKV_LEGEND_COLORS; i++)
        for (int k = 0; k < 8; k++) {
            double t = k / 8.0, off = 0;
            for (int c = 0; c < 3; c++)
                off +=
                    pow(legend->colors[i][c] * (1 - t) + legend->colors[i + 1][c] * t - rgb[c], 2);
            if (off < best) {
                best = off;
                place = (i + t) / (SKV_LEGEND_COLORS - 1);
            }
        }
    return best < 40 ? place : -1;
}

/* The median, over a rectangle, of the pressure drawn by that of fluid at rest. */
static double pressure_ratio(const picture *p, const skv_legend *legend, double surface, int x0,
                             int y0, int x1, int y1)
{
    double *ratios = malloc((size_t)(x1 - x0) * (size_t)(y1 - y0) * sizeof *ratios);
    int count = 0;
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++) {
            double place = place_of(legend, at(p, x, y));
            double depth = (y + 0.5 - surface) * 1.6 / p->width;
            if (place >= 0)
                ratios[count++] = place * legend->high * legend->depth / depth;
        }
    double ratio = median(ratios, count);
    free(ratios);
    return ratio;
}

static void pressure_is_true_up_to_the_walls(void **state)
{
    (void)state;
    /* At these numbers the walls cut the cells of the picture's averages in different ways. */
    const int particles[] = {700, 1000, 1050, 1200, 3000};
    for (int n = 0; n < 5; n++) {
        skv_world *world = make_world("pool", particles[n], 240);
        skv_frame frame = skv_world_frame(world);
        skv_render_style style = skv_default_render_style();
        style.view = SKV_VIEW_PRESSURE;
        picture p = shoot_frame(&frame, &style, 960, 540);
        skv_legend legend = skv_render_legend(&frame, &style);
        double surface = 0;
        for (int x = 200; x < 760; x++) {
            int y = 0;
            while (at(&p, x, y)[2] < 110)
                y++;
            surface += y / 560.0;
        }
        const struct {
            const char *name;
            int x0, y0, x1, y1;
        } places[] = {{"middle", 300, 380, 660, 460},
                      {"floor", 60, 534, 900, 539},
                      {"floor, 30 pixels", 60, 509, 900, 539},
                      {"left side", 1, 380, 6, 500},
                      {"right side", 954, 380, 959, 500}};
        for (int i = 0; i < 5; i++) {
            double ratio = pressure_ratio(&p, &legend, surface, places[i].x0, places[i].y0,
                                          places[i].x1, places[i].y1);
            printf("%d particles, %s: %.3f of the pressure at rest\n", frame.particles.count,
                   places[i].name, ratio);
            assert_true(fabs(ratio - 1) < 0.03);
        }
        free(p.rgb);
        skv_world_destroy(world);
    }
}

/* A moment looks the same whether one watched it come or not, and in a context that took the place
 * of one that was lost. */
static void a_picture_depends_on_the_frame_alone(void **state)
{
    (void)state;
    skv_world *world = make_world("dam-break", 1000, 20);
    const skv_view views[] = {SKV_VIEW_WATER, SKV_VIEW_PRESSURE, SKV_VIEW_SPEED, SKV_VIEW_DENSITY};
    skv_offscreen *watching;
    picture seen = {320, 180, malloc(320 * 180 * 3)};
    assert_int_equal(skv_offscreen_create(320, 180, &watching, NULL), SKV_OK);
    skv_render_style style = skv_default_render_style();
    for (int f = 0; f < 12; f++) {
        assert_int_equal(skv_world_step(world, 1.0f / 60, NULL), SKV_OK);
        skv_frame frame = skv_world_frame(world);
        style.view = views[f % 4];
        assert_int_equal(skv_offscreen_render(watching, &frame, &style, seen.rgb, NULL), SKV_OK);
        if (f < 8)
            continue;
        picture fresh = shoot(world, &style, 320, 180);
        assert_int_equal(largest_difference(&fresh, &seen), 0);
        free(fresh.rgb);
    }
    skv_offscreen_destroy(watching);
    free(seen.rgb);
    skv_world_destroy(world);
}

static picture draw_with(skv_renderer *renderer, const skv_frame *frame,
                         const skv_render_style *style, const skv_camera *camera)
{
    picture p = {camera->width, camera->height,
                 malloc((size_t)camera->width * (size_t)camera->height * 3)};
    uint8_t *rgba = malloc((size_t)p.width * (size_t)p.height * 4);
    skv_error error;
    if (skv_renderer_draw(renderer, frame, camera, style, NULL, 0, &error) != SKV_OK)
        fail_msg("%s", error.text);
    glReadPixels(0, 0, p.width, p.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    for (int y = 0; y < p.height; y++)
        for (int x = 0; x < p.width; x++)
            memcpy(p.rgb + (y * p.width + x) * 3, rgba + ((p.height - 1 - y) * p.width + x) * 4, 3);
    free(rgba);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return p;
}

static double mean_difference(const picture *a, const picture *b)
{
    double sum = 0;
    for (int i = 0; i < a->width * a->height * 3; i++)
        sum += abs(a->rgb[i] - b->rgb[i]);
    return sum / (a->width * a->height * 3);
}

/* Sums in bytes give nearly the picture that sums in half floats do. */
static void bytes_show_the_same(void **state)
{
    (void)state;
    skv_world *world = make_world("dam-break", 1500, 50);
    skv_frame frame = skv_world_frame(world);
    skv_offscreen *context;
    skv_renderer *halves, *bytes;
    assert_int_equal(skv_offscreen_create(480, 270, &context, NULL), SKV_OK);
    assert_int_equal(skv_renderer_create_with(true, &halves, NULL), SKV_OK);
    assert_int_equal(skv_renderer_create_with(false, &bytes, NULL), SKV_OK);
    skv_camera camera = skv_camera_fit(480, 270, 1.6, 0.9);
    for (int view = SKV_VIEW_WATER; view <= SKV_VIEW_FLUID; view++) {
        skv_render_style style = skv_default_render_style();
        style.view = (skv_view)view;
        style.detail = SKV_DETAIL_FULL;
        picture a = draw_with(halves, &frame, &style, &camera);
        picture b = draw_with(bytes, &frame, &style, &camera);
        printf("%s: bytes differ by %.2f on average\n",
               skv_style_choice_at(SKV_STYLE_VIEW, view)->name, mean_difference(&a, &b));
        assert_true(mean_difference(&a, &b) < 2.5);
        free(a.rgb);
        free(b.rgb);
    }
    skv_renderer_destroy(halves);
    skv_renderer_destroy(bytes);
    skv_offscreen_destroy(context);
    skv_world_destroy(world);
}

/* Left to itself a renderer is plain where the processor draws, and only there. */
static void software_is_drawn_plainly(void **state)
{
    (void)state;
    skv_world *world = make_world("dam-break", 1000, 40);
    skv_frame frame = skv_world_frame(world);
    skv_offscreen *context;
    skv_renderer *renderer;
    assert_int_equal(skv_offscreen_create(480, 270, &context, NULL), SKV_OK);
    assert_int_equal(skv_renderer_create(&renderer, NULL), SKV_OK);
    const char *name = (const char *)glGetString(GL_RENDERER);
    bool software =
        strstr(name, "llvmpipe") || strstr(name, "softpipe") || strstr(name, "SwiftShader");
    skv_camera camera = skv_camera_fit(480, 270, 1.6, 0.9);
    skv_render_style style = skv_default_render_style();
    picture chosen = draw_with(renderer, &frame, &style, &camera);
    style.detail = software ? SKV_DETAIL_PLAIN : SKV_DETAIL_FULL;
    picture same = draw_with(renderer, &frame, &style, &camera);
    style.detail = software ? SKV_DETAIL_FULL : SKV_DETAIL_PLAIN;
    picture other = draw_with(renderer, &frame, &style, &camera);
    assert_int_equal(largest_difference(&chosen, &same), 0);
    assert_true(largest_difference(&chosen, &other) > 20);
    free(chosen.rgb);
    free(same.rgb);
    free(other.rgb);
    skv_renderer_destroy(renderer);
    skv_offscreen_destroy(context);
    skv_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fluid_stands_out_against_walls),
        cmocka_unit_test(a_line_parts_scales_from_walls),
        cmocka_unit_test(lone_drops_are_round_and_of_their_area),
        cmocka_unit_test(the_area_drawn_is_the_fluids),
        cmocka_unit_test(a_calm_pool_does_not_flicker),
        cmocka_unit_test(pressure_is_true_up_to_the_walls),
        cmocka_unit_test(a_picture_depends_on_the_frame_alone),
        cmocka_unit_test(bytes_show_the_same),
        cmocka_unit_test(software_is_drawn_plainly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
