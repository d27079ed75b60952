/* Painted worlds: colours to coverage and paint.
 *
 * A painter's edges are blends: of light and dark (a sub-pixel wall), of paint and light (water at
 * a wall), of paint and dark (a surface), of two paints. Grey has no chroma, so the chroma of a
 * blend tells how much paint is in it, and its darkest channel what is left for light:
 *
 *     paint share b = chroma(p) / chroma(B)         B: the purest paint around p
 *     solid share   = (min(p) - b min(B)) / 255
 *
 * Invariant: every pixel gets its meaning from the picture's pixels at most REACH or MEANT away, so
 * the result does not depend on the order in which they are read.
 */
#include "scene/paint.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

#define COLOURED_CHROMA 40   /* from here on a pixel can be coloured, */
#define COLOURED        0.2  /* and with this share of chroma in its highest channel it is */
#define TINTED          0.45 /* where no paint is meant: paper, wood and lamplight are yellowish */
#define YELLOW          45   /* degrees: oranges and browns have less */
#define LIGHT           128  /* from here on a grey pixel is light */
#define FLAT            24   /* channels that differ by less belong to one flat area */
#define MEANT           3    /* pixels each way: a flat area as large was painted on purpose */
#define PURE            0.75 /* a blend of brown and blue has less chroma in its highest channel */
#define BROWNISH        0.13 /* 8 degrees beside red */
#define BLURRED         4    /* pixels over which a JPEG blurs a colour's edge */
#define REACH           2    /* pixels to where a stray colour finds what it belongs to */

/* What a pixel is on its own, beside a skv_paint. */
enum { WRONG = SKV_PAINTS };

/* In a painting that is being read: the place belongs to a flat area of oil or of a body. What else
 * is yellow or brown, as edges between green and red are, was not meant. */
#define FLAT_AREA 0x80
/* There, too: how near a place is to a flat area of a body, from BLURRED + 1 steps within one down
 * to none. */
#define NEAR_STEP 0x10
#define NEARNESS  0x70

/* Where there are no bodies a picture with brown is not read to the end: web/core/no_fluids.c. */
#ifdef SKV_WITHOUT_BODIES
enum { BODIES = 0 };
#else
enum { BODIES = 1 };
#endif

typedef struct colour {
    int r, g, b;
} colour;

/* Position in the picture, top row first. */
typedef struct place {
    const skv_image *image;
    const uint8_t *paint; /* of the painting, row 0 at the bottom */
    int x, y;
} place;

static colour colour_at(const skv_image *image, int x, int y)
{
    const uint8_t *p = image->pixels + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
    return (colour){p[0], p[1], p[2]};
}

static int lowest(colour c)
{
    int low = c.r < c.g ? c.r : c.g;
    return low < c.b ? low : c.b;
}

static int highest(colour c)
{
    int high = c.r > c.g ? c.r : c.g;
    return high > c.b ? high : c.b;
}

static int chroma(colour c)
{
    return highest(c) - lowest(c);
}

static int value(colour c)
{
    return (c.r + c.g + c.b + 1) / 3;
}

/* Hue in degrees, 0..360; the chroma is not 0. */
static double hue(colour c)
{
    double range = chroma(c), h;
    if (highest(c) == c.r)
        h = 60.0 * (c.g - c.b) / range;
    else if (highest(c) == c.g)
        h = 120.0 + 60.0 * (c.b - c.r) / range;
    else
        h = 240.0 + 60.0 * (c.r - c.g) / range;
    return h < 0.0 ? h + 360.0 : h;
}

/* A pixel's meaning by its own colour: a skv_paint or WRONG. */
static int classify(colour c)
{
    if (chroma(c) < COLOURED_CHROMA || chroma(c) < COLOURED * highest(c))
        return SKV_PAINT_NONE;
    double h = hue(c);
    if (h <= 15.0 || h >= 330.0)
        return SKV_PAINT_DRAIN;
    if (h < 75.0)
        return chroma(c) < TINTED * highest(c) ? SKV_PAINT_NONE
               : h < YELLOW                    ? SKV_PAINT_BODY
                                               : SKV_PAINT_OIL;
    if (h <= 165.0)
        return SKV_PAINT_EMITTER;
    if (h >= 170.0 && h <= 270.0)
        return SKV_PAINT_FLUID;
    return WRONG;
}

/* The 3 x 3 neighbourhood of a place, cut at the picture's sides; the place itself is included. */
#define FOR_NEIGHBOURS(p, nx, ny)                                                                  \
    for (int ny = (p).y > 0 ? (p).y - 1 : 0; ny <= (p).y + 1 && ny < (p).image->height; ny++)      \
        for (int nx = (p).x > 0 ? (p).x - 1 : 0; nx <= (p).x + 1 && nx < (p).image->width; nx++)

static int difference(colour a, colour b)
{
    int r = abs(a.r - b.r), g = abs(a.g - b.g), blue = abs(a.b - b.b);
    int most = r > g ? r : g;
    return most > blue ? most : blue;
}

/* ---- Flat areas ------------------------------------------------------------------------------ */

/* Whether the block from (x0, y0) on lies in the picture and is of p's colour, which is of that
 * class. */
static bool is_block(place p, int class, int x0, int y0)
{
    if (x0 < 0 || y0 < 0 || x0 + MEANT > p.image->width || y0 + MEANT > p.image->height)
        return false;
    colour own = colour_at(p.image, p.x, p.y);
    for (int i = 0; i < MEANT * MEANT; i++) {
        colour c = colour_at(p.image, x0 + i % MEANT, y0 + i / MEANT);
        if (classify(c) != class || difference(own, c) >= FLAT)
            return false;
    }
    return true;
}

/* Whether somebody meant the class of a place: it belongs to an area of it. Less is what smooth
 * edges between paints and lossy compression leave. */
static bool is_meant(place p, int class)
{
    for (int i = 0; i < MEANT * MEANT; i++) {
        if (is_block(p, class, p.x - i % MEANT, p.y - i / MEANT))
            return true;
    }
    return false;
}

static size_t index_of(const skv_image *image, int x, int y)
{
    return (size_t)(image->height - 1 - y) * (size_t)image->width + (size_t)x;
}

/* A pixel's meaning, but that yellow and brown count in flat areas alone, and near a brown one red
 * in pure ones: it lies between brown and blue, and JPEGs have it beside brown. */
static int class_at(place p, int x, int y)
{
    colour own = colour_at(p.image, x, y);
    int class = classify(own);
    if ((class == SKV_PAINT_OIL || class == SKV_PAINT_BODY) &&
        !(p.paint[index_of(p.image, x, y)] & FLAT_AREA))
        return WRONG;
    place at = {p.image, p.paint, x, y};
    bool pale = chroma(own) < PURE * highest(own) || own.g - own.b > BROWNISH * chroma(own);
    if (BODIES && class == SKV_PAINT_DRAIN && p.paint[index_of(p.image, x, y)] & NEARNESS &&
        (pale || !is_meant(at, class)))
        return WRONG;
    return class;
}

/* ---- Wrong colours --------------------------------------------------------------------------- */

/* What a pixel of a wrong hue is: what the most similar pixel around it is, or what it looks like
 * if all around it are as unsure, or WRONG. */
static int resolve(place p)
{
    colour own = colour_at(p.image, p.x, p.y);
    int nearest = WRONG, least = 256;
    if (is_meant(p, WRONG))
        return WRONG;
    for (int i = 0; i < (2 * REACH + 1) * (2 * REACH + 1); i++) {
        int x = p.x + i % (2 * REACH + 1) - REACH, y = p.y + i / (2 * REACH + 1) - REACH;
        if (x < 0 || y < 0 || x >= p.image->width || y >= p.image->height)
            continue;
        colour c = colour_at(p.image, x, y);
        int class = class_at(p, x, y);
        if (class != WRONG && difference(own, c) < least) {
            least = difference(own, c);
            nearest = class;
        }
    }
    return nearest == WRONG ? classify(own) : nearest;
}

static const char *name_colour(colour c)
{
    double h = hue(c);
    return h < 170.0 ? "is between green and blue" : h < 300.0 ? "is violet" : "is magenta";
}

static skv_result fail_wrong(place p, const char *label, skv_error *error)
{
    colour c = colour_at(p.image, p.x, p.y);
    return skv_fail(error, SKV_ERROR_VALUE,
                    "%s: pixel (%d, %d) %s (#%02x%02x%02x); allowed are light (solid), dark "
                    "(air), blue (fluid), yellow (oil), brown (wood), green (emitter) and red "
                    "(drain)",
                    label, p.x, p.y, name_colour(c), (unsigned)c.r, (unsigned)c.g, (unsigned)c.b);
}

/* ---- Coverage -------------------------------------------------------------------------------- */

/* What the neighbourhood holds besides the pixel: the purest paint in it, light and dark. */
typedef struct surroundings {
    colour purest;
    int purest_chroma; /* 0: there is no paint */
    bool light, dark;
} surroundings;

/* `only`: the paint to look for, or SKV_PAINT_NONE for any. */
static surroundings look_around(place p, int only)
{
    surroundings s = {0};
    FOR_NEIGHBOURS(p, x, y)
    {
        colour c = colour_at(p.image, x, y);
        int class = class_at(p, x, y);
        if (class == SKV_PAINT_NONE) {
            s.light = s.light || value(c) >= LIGHT;
            s.dark = s.dark || value(c) < LIGHT;
        } else if (class != WRONG && (only == SKV_PAINT_NONE || class == only) &&
                   chroma(c) > s.purest_chroma) {
            s.purest = c;
            s.purest_chroma = chroma(c);
        }
    }
    return s;
}

static uint8_t clamp_byte(double v)
{
    return v <= 0.0 ? 0 : v >= 255.0 ? 255 : (uint8_t)(v + 0.5);
}

/* How much of a pixel is solid. Away from any edge it is all or nothing, so that a wall painted in
 * light grey, or a background in dark grey, is as solid or as free as it looks. */
static uint8_t solid_share(place p, int class)
{
    colour own = colour_at(p.image, p.x, p.y);
    surroundings around = look_around(p, class);
    if (class != SKV_PAINT_NONE && !around.light)
        return 0;
    if (around.purest_chroma > 0 && chroma(own) > 0) {
        double b = (double)chroma(own) / around.purest_chroma;
        double share = lowest(own) - (b < 1.0 ? b : 1.0) * lowest(around.purest);
        if (class != SKV_PAINT_NONE || around.light)
            return clamp_byte(share);
    }
    if (around.light && around.dark)
        return (uint8_t)value(own);
    return value(own) >= LIGHT ? 255 : 0;
}

/* ---- Reading --------------------------------------------------------------------------------- */

/* Whether all pixels around a place are the same: most of any picture, and quick to tell. */
static bool is_uniform(place p)
{
    uint32_t own, other;
    size_t stride = (size_t)p.image->width;
    const uint8_t *centre = p.image->pixels + 4 * ((size_t)p.y * stride + (size_t)p.x);
    memcpy(&own, centre, 4);
    FOR_NEIGHBOURS(p, x, y)
    {
        memcpy(&other, p.image->pixels + 4 * ((size_t)y * stride + (size_t)x), 4);
        if (other != own)
            return false;
    }
    return true;
}

/* A uniform place is read the short way, with what solid_share would find. */
static uint8_t uniform_share(place p, int class)
{
    bool light = value(colour_at(p.image, p.x, p.y)) >= LIGHT;
    return class == SKV_PAINT_NONE && light ? 255 : 0;
}

/* Marks the places of flat areas of yellow and brown, as large as what is meant; returns whether
 * any is brown. */
static bool mark_flat(const skv_image *image, uint8_t *paint)
{
    bool brown = false;
    for (int y = 0; y + MEANT <= image->height; y++)
        for (int x = 0; x + MEANT <= image->width; x++) {
            int class = classify(colour_at(image, x, y));
            if ((class != SKV_PAINT_OIL && class != SKV_PAINT_BODY) ||
                !is_block((place){image, paint, x, y}, class, x, y))
                continue;
            int mark = FLAT_AREA | (class == SKV_PAINT_BODY ? (BLURRED + 1) * NEAR_STEP : 0);
            brown |= class == SKV_PAINT_BODY;
            for (int i = 0; i < MEANT * MEANT; i++)
                paint[index_of(image, x + i % MEANT, y + i / MEANT)] |= (uint8_t)mark;
        }
    return brown;
}

/* Makes a place a step less near than what is nearest around it. */
static void come_near(place p, uint8_t *paint)
{
    uint8_t *own = &paint[index_of(p.image, p.x, p.y)];
    FOR_NEIGHBOURS(p, x, y)
    {
        int nearness = (paint[index_of(p.image, x, y)] & NEARNESS) - NEAR_STEP;
        if (nearness > (*own & NEARNESS))
            *own = (uint8_t)((*own & ~NEARNESS) | nearness);
    }
}

/* Spreads nearness: there and back over the picture. */
static void mark_near(const skv_image *image, uint8_t *paint)
{
    const int last_x = image->width - 1, last_y = image->height - 1;
    for (int back = 0; back < 2; back++)
        for (int y = 0; y <= last_y; y++)
            for (int x = 0; x <= last_x; x++)
                come_near((place){image, paint, back ? last_x - x : x, back ? last_y - y : y},
                          paint);
}

static skv_result read_pixels(const skv_image *image, const char *label, skv_painting *painting,
                              skv_error *error)
{
    for (int y = 0; y < image->height; y++) {
        size_t row = (size_t)(image->height - 1 - y) * (size_t)image->width;
        for (int x = 0; x < image->width; x++) {
            place p = {image, painting->paint, x, y};
            int class = class_at(p, x, y);
            if (class == WRONG)
                class = resolve(p);
            if (class == WRONG)
                return fail_wrong(p, label, error);
            painting->paint[row + (size_t)x] |= (uint8_t)class;
            painting->count[class]++;
            painting->coverage[row + (size_t)x] =
                is_uniform(p) ? uniform_share(p, class) : solid_share(p, class);
        }
    }
    return SKV_OK;
}

skv_result skv_paint_read(const skv_image *image, const char *label, skv_painting *painting,
                          skv_error *error)
{
    *painting = (skv_painting){.width = image->width, .height = image->height};
    size_t pixels = (size_t)image->width * (size_t)image->height;
    painting->coverage = skv_calloc(pixels, 1);
    painting->paint = skv_calloc(pixels, 1);
    bool room = painting->coverage != NULL && painting->paint != NULL;
    skv_result result =
        room ? SKV_OK : skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
    if (room) {
        bool brown = mark_flat(image, painting->paint);
        if (BODIES && brown)
            mark_near(image, painting->paint);
        result = read_pixels(image, label, painting, error);
        for (size_t i = 0; i < pixels; i++)
            painting->paint[i] &= (uint8_t)~(FLAT_AREA | NEARNESS);
    }
    if (result != SKV_OK)
        skv_painting_free(painting);
    return result;
}

void skv_painting_free(skv_painting *painting)
{
    skv_free(painting->coverage);
    skv_free(painting->paint);
    *painting = (skv_painting){0};
}
