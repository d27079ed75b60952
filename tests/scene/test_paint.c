/* The colours of painted worlds: what each means alone, and at smooth edges. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "scene/paint.h"

#define SIZE 16
#define PI   3.141592653589793

static const rgb white = {255, 255, 255}, black = {0, 0, 0}, blue = {0, 0, 255};

/* a * share + b * (1 - share), as a smooth brush mixes. */
static rgb mix(rgb a, rgb b, double share)
{
    return (rgb){(uint8_t)(a.r * share + b.r * (1 - share) + 0.5),
                 (uint8_t)(a.g * share + b.g * (1 - share) + 0.5),
                 (uint8_t)(a.b * share + b.b * (1 - share) + 0.5)};
}

/* Reads a picture given by a callback. */
static skv_result read(paint_at *at, void *user, skv_painting *painting, skv_error *error)
{
    skv_image image = {SIZE, SIZE, calloc(SIZE * SIZE, 4)};
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            rgb c = at(x, y, user);
            memcpy(image.pixels + 4 * (y * SIZE + x), &(uint8_t[4]){c.r, c.g, c.b, 255}, 4);
        }
    }
    skv_result result = skv_paint_read(&image, "p.png", painting, error);
    free(image.pixels);
    return result;
}

/* ---- Flat areas ------------------------------------------------------------------------------ */

/* Black with a 4 x 4 area of one colour. */
static rgb area(int x, int y, void *user)
{
    return x >= 6 && x < 10 && y >= 6 && y < 10 ? *(rgb *)user : black;
}

static void test_meaning_of_flat_colours(void **state)
{
    (void)state;
    enum { AIR = -1, SOLID = -2, BAD = -3 };
    const struct {
        rgb colour;
        int meaning;
    } cases[] = {
        {{0, 0, 0}, AIR},
        {{40, 40, 40}, AIR},
        {{127, 127, 127}, AIR},
        {{128, 128, 128}, SOLID},
        {{200, 200, 200}, SOLID},
        {{255, 255, 255}, SOLID},
        {{255, 250, 240}, SOLID}, /* floral white */
        {{20, 20, 40}, AIR},      /* night blue: hardly coloured */
        {{0, 0, 255}, SKV_PAINT_FLUID},
        {{0, 0, 128}, SKV_PAINT_FLUID},
        {{30, 144, 255}, SKV_PAINT_FLUID},
        {{100, 149, 237}, SKV_PAINT_FLUID},
        {{135, 206, 235}, SKV_PAINT_FLUID}, /* sky blue */
        {{173, 216, 230}, SKV_PAINT_FLUID}, /* light blue */
        {{0, 255, 255}, SKV_PAINT_FLUID},
        {{64, 224, 208}, SKV_PAINT_FLUID},
        {{75, 0, 255}, SKV_PAINT_FLUID},
        {{0, 255, 0}, SKV_PAINT_EMITTER},
        {{0, 128, 0}, SKV_PAINT_EMITTER},
        {{144, 238, 144}, SKV_PAINT_EMITTER},
        {{154, 205, 50}, SKV_PAINT_EMITTER},
        {{255, 0, 0}, SKV_PAINT_DRAIN},
        {{139, 0, 0}, SKV_PAINT_DRAIN},
        {{250, 128, 114}, SKV_PAINT_DRAIN},
        {{220, 20, 60}, SKV_PAINT_DRAIN},
        {{250, 240, 200}, SOLID}, /* yellowish paper */
        {{245, 222, 179}, SOLID}, /* wheat */
        {{110, 95, 70}, AIR},     /* paper in the shade */
        {{255, 255, 0}, SKV_PAINT_OIL},
        {{255, 215, 0}, SKV_PAINT_OIL},   /* gold */
        {{128, 128, 0}, SKV_PAINT_OIL},   /* olive */
        {{184, 134, 11}, SKV_PAINT_BODY}, /* dark goldenrod */
        {{139, 69, 19}, SKV_PAINT_BODY},  /* brown */
        {{101, 67, 33}, SKV_PAINT_BODY},  /* dark brown */
        {{210, 105, 30}, SKV_PAINT_BODY}, /* chocolate */
        {{255, 165, 0}, SKV_PAINT_BODY},
        {{255, 0, 255}, BAD},
        {{148, 0, 211}, BAD},
        {{0, 255, 200}, BAD},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        skv_painting p;
        skv_error error = {0};
        skv_result result = read(area, (void *)&cases[i].colour, &p, &error);
        if (result != (cases[i].meaning == BAD ? SKV_ERROR_VALUE : SKV_OK))
            fail_msg("case %zu: %s", i, error.text);
        if (result != SKV_OK) {
            assert_null(p.coverage);
            continue;
        }
        int at = 8 * SIZE + 8;
        if (cases[i].meaning >= 0)
            assert_int_equal(p.paint[at], cases[i].meaning);
        else
            assert_int_equal(p.paint[at], SKV_PAINT_NONE);
        assert_int_equal(p.coverage[at], cases[i].meaning == SOLID ? 255 : 0);
        assert_int_equal(p.coverage[0], 0);
        assert_int_equal(p.paint[0], SKV_PAINT_NONE);
        skv_painting_free(&p);
    }
}

static void test_a_wrong_colour_is_named(void **state)
{
    (void)state;
    skv_painting p;
    skv_error error;
    rgb violet = {148, 0, 211};
    assert_int_equal(read(area, &violet, &p, &error), SKV_ERROR_VALUE);
    assert_string_equal(error.text,
                        "p.png: pixel (6, 6) is violet (#9400d3); allowed are light (solid), dark "
                        "(air), blue (fluid), yellow (oil), brown (wood), green (emitter) and red "
                        "(drain)");
}

/* One pixel on black. */
static rgb single(int x, int y, void *user)
{
    return x == 3 && y == 12 ? *(rgb *)user : black;
}

/* Yellow is oil where an area of it was painted, with its soft edge; specks of it are not. */
static rgb oil_in_water(int x, int y, void *user)
{
    (void)user;
    const rgb yellow = {255, 230, 0};
    if (x == 2 && y == 2)
        return yellow;
    if (y < 6)
        return black;
    return x < 7 ? yellow : x == 7 ? mix(yellow, blue, 0.7) : blue;
}

static void test_yellow_is_oil_in_areas(void **state)
{
    (void)state;
    skv_painting p;
    skv_error error;
    assert_int_equal(read(oil_in_water, NULL, &p, &error), SKV_OK);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            int expected = y < 6 ? SKV_PAINT_NONE : x < 8 ? SKV_PAINT_OIL : SKV_PAINT_FLUID;
            if (p.paint[(SIZE - 1 - y) * SIZE + x] != expected)
                fail_msg("(%d, %d) is %d", x, y, p.paint[(SIZE - 1 - y) * SIZE + x]);
            /* A light speck is solid, as one of any colour is. */
            assert_int_equal(p.coverage[(SIZE - 1 - y) * SIZE + x], x == 2 && y == 2 ? 255 : 0);
        }
    assert_true(p.count[SKV_PAINT_OIL] == 8 * (SIZE - 6));
    skv_painting_free(&p);
}

/* Brown lies in water; a soft edge, in steps of an eighth, and specks of it are of what is beside
 * them: no red comes between the two. */
static rgb wood_in_water(int x, int y, void *user)
{
    const rgb wood = *(const rgb *)user;
    if (x == 14 && y > 12)
        return wood;
    return x < 6 ? wood : x < 9 ? mix(wood, blue, (9 - x) / 4.0) : blue;
}

static void test_brown_is_wood_in_areas(void **state)
{
    (void)state;
    const rgb woods[] = {
        {139, 69, 19}, {210, 105, 30}, {255, 128, 0}, {255, 165, 0}, {160, 82, 45}};
    for (int k = 0; k < 5; k++) {
        skv_painting p;
        skv_error error;
        if (read(wood_in_water, (void *)&woods[k], &p, &error) != SKV_OK)
            fail_msg("%d: %s", k, error.text);
        assert_int_equal(p.count[SKV_PAINT_DRAIN] + p.count[SKV_PAINT_EMITTER], 0);
        assert_int_equal(p.count[SKV_PAINT_OIL] + p.count[SKV_PAINT_NONE], 0);
        assert_in_range(p.count[SKV_PAINT_BODY], 6 * SIZE, 9 * SIZE);
        assert_int_equal(p.paint[14], SKV_PAINT_FLUID);
        skv_painting_free(&p);
    }
    skv_painting p;
    rgb red = {255, 0, 0};
    assert_int_equal(read(single, &red, &p, NULL), SKV_OK);
    assert_int_equal(p.count[SKV_PAINT_DRAIN], 1); /* as before, where no wood is near */
    skv_painting_free(&p);
}

/* A speck of a wrong colour is what the most similar pixel beside it is. */
static void test_a_stray_pixel_joins_its_neighbours(void **state)
{
    (void)state;
    skv_painting p;
    skv_error error;
    rgb magenta = {255, 0, 255};
    int at = (SIZE - 1 - 12) * SIZE + 3;
    assert_int_equal(read(single, &magenta, &p, &error), SKV_OK);
    assert_int_equal(p.paint[at], SKV_PAINT_NONE);
    skv_painting_free(&p);
    rgb red = {255, 0, 0};
    assert_int_equal(read(single, &red, &p, &error), SKV_OK);
    assert_int_equal(p.paint[at], SKV_PAINT_DRAIN);
    assert_int_equal(p.count[SKV_PAINT_DRAIN], 1);
    skv_painting_free(&p);
}

/* Red on the left, blue on the right, magenta where user's rows say so. */
static rgb between(int x, int y, void *user)
{
    const char *const *rows = user;
    bool wrong = y >= 6 && y < 10 && x >= 6 && x < 10 && rows[y - 6][x - 6] == 'm';
    return wrong ? (rgb){255, 0, 255} : x < 8 ? (rgb){255, 0, 0} : (rgb){0, 0, 255};
}

/* Specks and thin lines between two paints are their edge's blend; an area of three pixels each way
 * was meant. */
static void test_what_counts_as_a_blend(void **state)
{
    (void)state;
    const struct {
        const char *rows[4];
        bool good;
    } cases[] = {
        {{"  m ", "  m ", "  m ", "  m "}, true},  {{"    ", "  m ", "    ", "    "}, true},
        {{"    ", " mm ", " mm ", "    "}, true},  {{" mm ", " mm ", " mm ", " mm "}, true},
        {{" mmm", " mmm", " mmm", "    "}, false}, {{"mmmm", "mmmm", "mmmm", "mmmm"}, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        skv_painting p;
        skv_result result = read(between, (void *)cases[i].rows, &p, NULL);
        if (result != (cases[i].good ? SKV_OK : SKV_ERROR_VALUE))
            fail_msg("case %zu", i);
        skv_painting_free(&p);
    }
}

/* ---- Edges ----------------------------------------------------------------------------------- */

/* Two colours with a straight edge at x = at + slope * y; each pixel takes their exact shares. */
typedef struct edge {
    rgb left, right;
    double at, slope;
} edge;

static double left_share(const edge *e, int x, int y)
{
    double sum = 0;
    for (int i = 0; i < 16; i++) {
        double share = e->at + e->slope * (y + (i + 0.5) / 16) - x;
        sum += share < 0 ? 0 : share > 1 ? 1 : share;
    }
    return sum / 16;
}

static rgb edge_colour(int x, int y, void *user)
{
    const edge *e = user;
    return mix(e->left, e->right, left_share(e, x, y));
}

/* A smooth edge between white and any fluid colour or black leaves the wall where it was painted,
 * to a few hundredths of a pixel. */
static void test_walls_stay_sub_pixel(void **state)
{
    (void)state;
    const rgb right[] = {{0, 0, 0},       {0, 0, 255},     {0, 90, 255}, {30, 144, 255},
                         {100, 149, 237}, {135, 206, 235}, {0, 0, 128},  {0, 160, 0}};
    double worst = 0;
    for (size_t c = 0; c < sizeof right / sizeof right[0]; c++) {
        for (int i = 0; i < 40; i++) {
            edge e = {white, right[c], 7 + i / 10.0, (i % 7 - 3) * 0.1};
            skv_painting p;
            skv_error error = {0};
            if (read(edge_colour, &e, &p, &error) != SKV_OK)
                fail_msg("%s", error.text);
            for (int y = 1; y < SIZE - 1; y++) {
                for (int x = 0; x < SIZE; x++) {
                    double share = left_share(&e, x, y);
                    double got = p.coverage[(SIZE - 1 - y) * SIZE + x] / 255.0;
                    worst = share - got > worst ? share - got : worst;
                    worst = got - share > worst ? got - share : worst;
                }
            }
            skv_painting_free(&p);
        }
    }
    assert_true(worst < 0.03);
}

static void test_a_surface_to_air_makes_no_wall(void **state)
{
    (void)state;
    for (int i = 0; i < 10; i++) {
        edge e = {black, {0, 90, 255}, 7 + i / 10.0, 0.2};
        skv_painting p;
        assert_int_equal(read(edge_colour, &e, &p, NULL), SKV_OK);
        for (int at = 0; at < SIZE * SIZE; at++)
            assert_int_equal(p.coverage[at], 0);
        assert_true(p.count[SKV_PAINT_FLUID] > 80);
        skv_painting_free(&p);
    }
}

/* Where two paints meet, the blend's hue may mean nothing or something else: it is no mistake. */
static void test_paints_may_touch_smoothly(void **state)
{
    (void)state;
    const rgb paints[] = {{0, 0, 255}, {255, 0, 0}, {0, 255, 0}, {220, 20, 60}, {0, 90, 255}};
    for (int a = 0; a < 5; a++) {
        for (int b = 0; b < 5; b++) {
            for (int i = 0; i < 12; i++) {
                edge e = {paints[a], paints[b], 7 + i / 12.0, (i % 3) * 0.15};
                skv_painting p;
                skv_error error = {0};
                if (read(edge_colour, &e, &p, &error) != SKV_OK)
                    fail_msg("%d to %d at %d: %s", a, b, i, error.text);
                for (int at = 0; at < SIZE * SIZE; at++)
                    assert_int_equal(p.coverage[at], 0);
                assert_int_equal(p.count[SKV_PAINT_NONE], 0);
                skv_painting_free(&p);
            }
        }
    }
}

/* Water in a corner of wall and air: the three meet in blends of all of them. */
static rgb corner(int x, int y, void *user)
{
    double wall = *(double *)user - x, water = 8.4 - y;
    wall = wall < 0 ? 0 : wall > 1 ? 1 : wall;
    water = water < 0 ? 0 : water > 1 ? 1 : water;
    return mix(white, mix(black, blue, water), wall);
}

static void test_three_meet(void **state)
{
    (void)state;
    for (int i = 0; i < 10; i++) {
        double at = 5 + i / 10.0;
        skv_painting p;
        assert_int_equal(read(corner, &at, &p, NULL), SKV_OK);
        for (int y = 0; y < SIZE; y++) {
            double got = p.coverage[y * SIZE + 5] / 255.0, share = at - 5;
            assert_true(got - share < 0.03 && share - got < 0.03);
            assert_int_equal(p.coverage[y * SIZE + 4], 255);
            assert_int_equal(p.coverage[y * SIZE + 6], 0);
        }
        skv_painting_free(&p);
    }
}

/* ---- Compressed pictures --------------------------------------------------------------------- */

enum { LARGE = 64 };

/* What JPEG does to a plane of 8 x 8 blocks: the cosine transform, rounded to multiples of a step
 * that grows with the frequency. */
static void compress_plane(double *plane, int size, double coarseness)
{
    for (int block = 0; block < size / 8 * (size / 8); block++) {
        double *corner = plane + block / (size / 8) * 8 * size + block % (size / 8) * 8;
        double spectrum[64];
        for (int k = 0; k < 64; k++) {
            int u = k % 8, v = k / 8;
            double sum = 0;
            for (int i = 0; i < 64; i++)
                sum += corner[i / 8 * size + i % 8] * cos((2 * (i % 8) + 1) * u * PI / 16) *
                       cos((2 * (i / 8) + 1) * v * PI / 16);
            double step = coarseness * (10 + 9 * (u + v));
            sum *= (u ? 1 : sqrt(0.5)) * (v ? 1 : sqrt(0.5)) / 4;
            spectrum[k] = step * floor(sum / step + 0.5);
        }
        for (int i = 0; i < 64; i++) {
            double sum = 0;
            for (int k = 0; k < 64; k++) {
                int u = k % 8, v = k / 8;
                sum += spectrum[k] * (u ? 1 : sqrt(0.5)) * (v ? 1 : sqrt(0.5)) / 4 *
                       cos((2 * (i % 8) + 1) * u * PI / 16) * cos((2 * (i / 8) + 1) * v * PI / 16);
            }
            corner[i / 8 * size + i % 8] = sum;
        }
    }
}

static uint8_t to_byte(double v)
{
    return (uint8_t)(v < 0 ? 0 : v > 255 ? 255 : v + 0.5);
}

/* A picture as JPEG leaves it: brightness and, at half the size, colour, each compressed. */
static void compress(uint8_t *pixels, double coarseness)
{
    static double luma[LARGE * LARGE], blue_part[LARGE * LARGE / 4], red_part[LARGE * LARGE / 4];
    memset(blue_part, 0, sizeof blue_part);
    memset(red_part, 0, sizeof red_part);
    for (int i = 0; i < LARGE * LARGE; i++) {
        const uint8_t *p = pixels + 4 * i;
        int half_size = i / LARGE / 2 * (LARGE / 2) + i % LARGE / 2;
        luma[i] = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
        blue_part[half_size] += 0.25 * (p[2] - luma[i]) / 1.772;
        red_part[half_size] += 0.25 * (p[0] - luma[i]) / 1.402;
    }
    compress_plane(luma, LARGE, coarseness);
    compress_plane(blue_part, LARGE / 2, 1.5 * coarseness);
    compress_plane(red_part, LARGE / 2, 1.5 * coarseness);
    for (int i = 0; i < LARGE * LARGE; i++) {
        int half_size = i / LARGE / 2 * (LARGE / 2) + i % LARGE / 2;
        double cb = blue_part[half_size], cr = red_part[half_size];
        pixels[4 * i] = to_byte(luma[i] + 1.402 * cr);
        pixels[4 * i + 1] = to_byte(luma[i] - 0.344 * cb - 0.714 * cr);
        pixels[4 * i + 2] = to_byte(luma[i] + 1.772 * cb);
    }
}

/* A pool on a floor, with a fountain and a drain; `shift` moves it against the blocks. */
static rgb painted(int x, int y, int shift)
{
    x -= shift;
    y -= shift;
    if (y > 48 || x < 4 || x > 55)
        return white;
    if (y > 40 && x > 30 && x < 40)
        return (rgb){220, 20, 60};
    if (y > 20)
        return (rgb){30, 90, 255};
    return y < 12 && x > 20 && x < 30 ? (rgb){0, 160, 0} : black;
}

/* However strongly a picture is compressed, none of its edges is taken for a colour that was meant,
 * and away from them everything is what it was. */
static void test_compressed_pictures_are_read(void **state)
{
    (void)state;
    static uint8_t pixels[LARGE * LARGE * 4];
    for (int i = 0; i < 32; i++) {
        int shift = i % 8, right = 0, all = 0;
        for (int at = 0; at < LARGE * LARGE; at++) {
            rgb c = painted(at % LARGE, at / LARGE, shift);
            memcpy(pixels + 4 * at, &(uint8_t[4]){c.r, c.g, c.b, 255}, 4);
        }
        compress(pixels, 0.5 + i / 8);
        skv_image image = {LARGE, LARGE, pixels};
        skv_painting p;
        skv_error error = {0};
        if (skv_paint_read(&image, "p.png", &p, &error) != SKV_OK)
            fail_msg("case %d: %s", i, error.text);
        for (int y = 4; y < LARGE - 4; y++) {
            for (int x = 4; x < LARGE - 4; x++) {
                rgb c = painted(x, y, shift);
                int paint = p.paint[(LARGE - 1 - y) * LARGE + x];
                bool is_paint = c.r != c.b;
                all += is_paint;
                right += is_paint && paint == (c.r > 200   ? SKV_PAINT_DRAIN
                                               : c.b > 200 ? SKV_PAINT_FLUID
                                                           : SKV_PAINT_EMITTER);
            }
        }
        assert_true(right > 0.9 * all);
        skv_painting_free(&p);
    }
}

/* A picture's top row is the world's top row. */
static rgb half(int x, int y, void *user)
{
    (void)user;
    return y < 8 ? white : x < 4 ? blue : black;
}

static void test_the_top_is_up(void **state)
{
    (void)state;
    skv_painting p;
    assert_int_equal(read(half, NULL, &p, NULL), SKV_OK);
    assert_int_equal(p.coverage[15 * SIZE], 255);
    assert_int_equal(p.coverage[0], 0);
    assert_int_equal(p.paint[0], SKV_PAINT_FLUID);
    assert_int_equal(p.paint[5], SKV_PAINT_NONE);
    assert_int_equal(p.count[SKV_PAINT_FLUID], 32);
    skv_painting_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_meaning_of_flat_colours),
        cmocka_unit_test(test_a_wrong_colour_is_named),
        cmocka_unit_test(test_yellow_is_oil_in_areas),
        cmocka_unit_test(test_brown_is_wood_in_areas),
        cmocka_unit_test(test_a_stray_pixel_joins_its_neighbours),
        cmocka_unit_test(test_what_counts_as_a_blend),
        cmocka_unit_test(test_walls_stay_sub_pixel),
        cmocka_unit_test(test_a_surface_to_air_makes_no_wall),
        cmocka_unit_test(test_paints_may_touch_smoothly),
        cmocka_unit_test(test_three_meet),
        cmocka_unit_test(test_compressed_pictures_are_read),
        cmocka_unit_test(test_the_top_is_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
