/* A terrain's lifetime and plain facts. Invariant: a terrain never changes once it is created, but
 * for the number of those who share it. */
#include "terrain/terrain.h"

#include "base/assert.h"
#include "base/bytes.h"
#include "base/defs.h"
#include "base/exact.h"
#include "base/memory.h"
#include "terrain/contour.h"
#include "terrain/distance.h"

#include <string.h>

enum { TERRAIN_COOKIE = 0x5445 };

/* Metres: the longest side of a world, in which float positions are fine enough, and the smallest
 * pixel, which keeps every product of distances a normal float. */
#define LONGEST_SIDE   16.0
#define SMALLEST_PIXEL 1e-9

#define ALL_SIDES (SKV_SIDE_LEFT | SKV_SIDE_RIGHT | SKV_SIDE_BOTTOM | SKV_SIDE_TOP)

skv_terrain_def skv_default_terrain_def(void)
{
    return (skv_terrain_def){.width = 640,
                             .height = 360,
                             .pixel_size = 0.0025f,
                             .cookie = SKV_COOKIE(TERRAIN_COOKIE, skv_terrain_def)};
}

void skv_terrain_def_init(skv_terrain_def *def, size_t size)
{
    const skv_terrain_def standard = skv_default_terrain_def();
    skv_def_init(def, size, &standard, sizeof standard);
}

static skv_result check_def(const skv_terrain_def *def, skv_error *error)
{
    const int least = SKV_TERRAIN_MIN_PIXELS, most = SKV_TERRAIN_MAX_PIXELS;
    if (def->width < least || def->width > most || def->height < least || def->height > most)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "terrain: the picture has %d x %d pixels; each side must be %d to %d",
                        def->width, def->height, least, most);
    double pixel = (double)def->pixel_size;
    if (!(pixel >= SMALLEST_PIXEL && pixel <= LONGEST_SIDE))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "terrain: pixel_size is %g m; it must be a positive number of metres",
                        pixel);
    int longer = def->width > def->height ? def->width : def->height;
    /* A hair of room, because a float pixel size is rarely the exact quotient. */
    if (pixel * longer > LONGEST_SIDE * (1 + 1e-6))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "terrain: %d pixels of %g m make %g m; a side may have at most %g m",
                        longer, pixel, pixel * longer, LONGEST_SIDE);
    if (def->open_sides & ~(unsigned)ALL_SIDES)
        return skv_fail(error, SKV_ERROR_VALUE,
                        "terrain: open_sides is %#x; it must be a set of skv_side bits",
                        def->open_sides);
    return SKV_OK;
}

/* How far, in pixels above the centre of row `y`, the free region's end lies towards row `beside`:
 * the farthest crossing there; negative if the row has no air. */
static float reach_of_air(const skv_coverage *coverage, int y, int beside)
{
    const int rim = SKV_TERRAIN_RIM;
    const uint8_t *row = coverage->bytes + (size_t)y * (size_t)coverage->columns;
    const uint8_t *other = coverage->bytes + (size_t)beside * (size_t)coverage->columns;
    float reach = -1;
    for (int x = rim; x < coverage->columns - rim; x++) {
        if (!skv_is_solid(row[x]))
            reach = skv_maxf(reach, skv_is_solid(other[x]) ? skv_crossing(row[x], other[x]) : 0.5f);
    }
    return reach;
}

static void find_free_range(skv_terrain *terrain)
{
    const int rim = SKV_TERRAIN_RIM;
    const float first_centre = (float)rim - 0.5f;
    const skv_coverage coverage = skv_terrain_coverage(terrain);
    int bottom = rim, top = coverage.rows - rim - 1;
    float reach = -1;
    terrain->lowest = terrain->highest = 0;
    while (bottom <= top && (reach = reach_of_air(&coverage, bottom, bottom - 1)) < 0)
        bottom++;
    if (bottom > top)
        return;
    terrain->lowest = ((float)bottom - first_centre - reach) * terrain->pixel_size;
    while ((reach = reach_of_air(&coverage, top, top + 1)) < 0)
        top--;
    terrain->highest = ((float)top - first_centre + reach) * terrain->pixel_size;
}

/* The free pixels of a row; one that the wall cuts counts by its centre's distance from it. */
static double free_pixels(const skv_terrain *terrain, int y)
{
    double pixels = 0;
    const float *row =
        terrain->field + SKV_TERRAIN_RIM + (size_t)(y + SKV_TERRAIN_RIM) * (size_t)terrain->columns;
    for (int x = 0; x < terrain->width; x++)
        pixels += (double)skv_maxf(0, skv_minf(1, 0.5f + row[x] * terrain->per_metre));
    return pixels;
}

static double sum_free_area(const skv_terrain *terrain)
{
    double pixels = 0;
    for (int y = 0; y < terrain->height; y++)
        pixels += terrain->row_free[y];
    return pixels * (double)terrain->pixel_size * (double)terrain->pixel_size;
}

/* Of the picture's rows' hashes, after what else the terrain was made from. */
static uint64_t hash_of(const skv_terrain *terrain)
{
    uint8_t bytes[16];
    skv_writer head = {bytes, 0};
    skv_put(&head, (uint32_t)terrain->width, 4);
    skv_put(&head, (uint32_t)terrain->height, 4);
    skv_put_float(&head, terrain->pixel_size);
    skv_put(&head, terrain->open_sides, 4);
    uint64_t hash = skv_hash_bytes(SKV_HASH_BEGIN, bytes, head.used);
    for (int y = 0; y < terrain->height; y++) {
        skv_writer row = {bytes, 0};
        skv_put(&row, terrain->row_hash[y], 8);
        hash = skv_hash_bytes(hash, bytes, row.used);
    }
    return hash;
}

skv_terrain *skv_terrain_allocate(int width, int height)
{
    int columns = width + 2 * SKV_TERRAIN_RIM, rows = height + 2 * SKV_TERRAIN_RIM;
    size_t pixels = (size_t)columns * (size_t)rows;
    skv_terrain *made = skv_calloc(1, sizeof *made);
    if (!made)
        return NULL;
    *made = (skv_terrain){
        .owners = 1,
        .width = width,
        .height = height,
        .columns = columns,
        .rows = rows,
        .field = skv_malloc(pixels, sizeof *made->field),
        .coverage = skv_malloc(pixels, 1),
        .row_hash = skv_malloc((size_t)height, sizeof *made->row_hash),
        .row_free = skv_malloc((size_t)height, sizeof *made->row_free),
    };
    if (made->field && made->coverage && made->row_hash && made->row_free)
        return made;
    skv_terrain_destroy(made);
    return NULL;
}

void skv_terrain_derive(skv_terrain *terrain, const skv_squares *changed)
{
    for (int y = 0; y < terrain->height; y++) {
        int row = y + SKV_TERRAIN_RIM;
        if (changed && !skv_squares_meet(changed, 0, row, terrain->columns, row))
            continue;
        terrain->row_hash[y] =
            skv_hash_bytes(SKV_HASH_BEGIN, skv_terrain_row(terrain, y), (size_t)terrain->width);
        terrain->row_free[y] = free_pixels(terrain, y);
    }
    terrain->hash = hash_of(terrain);
    terrain->free_area = sum_free_area(terrain);
    find_free_range(terrain);
}

skv_result skv_terrain_create(const skv_terrain_def *def, skv_terrain **terrain, skv_error *error)
{
    SKV_ASSERT_OR(terrain, SKV_ERROR_VALUE);
    *terrain = NULL;
    skv_terrain_def own = skv_default_terrain_def();
    SKV_ASSERT_INITIALISED(def, skv_def_open(def, &own, sizeof own), SKV_ERROR_VALUE);
    skv_result result = check_def(def, error);
    if (result != SKV_OK)
        return result;
    skv_terrain *made = skv_terrain_allocate(def->width, def->height);
    if (!made)
        return skv_fail(error, SKV_ERROR_MEMORY, "terrain: no memory for %d x %d pixels",
                        def->width, def->height);
    made->pixel_size = def->pixel_size;
    made->per_metre = 1 / def->pixel_size;
    made->open_sides = def->open_sides;
    skv_coverage coverage = skv_terrain_coverage(made);
    memset(coverage.bytes, 0, (size_t)coverage.columns * (size_t)coverage.rows);
    skv_coverage_fill(def, &coverage);
    result = skv_coverage_check(&coverage, error);
    if (result == SKV_OK)
        result = skv_distance_fill(&coverage, def->pixel_size, NULL, made->field, NULL, error);
    if (result != SKV_OK) {
        skv_terrain_destroy(made);
        return result;
    }
    skv_terrain_derive(made, NULL);
    *terrain = made;
    return SKV_OK;
}

skv_terrain *skv_terrain_share(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, NULL);
    skv_terrain *shared = (skv_terrain *)terrain; /* constant but for its owners */
    atomic_fetch_add(&shared->owners, 1);
    return shared;
}

void skv_terrain_destroy(skv_terrain *terrain)
{
    if (!terrain || atomic_fetch_sub(&terrain->owners, 1) > 1)
        return;
    skv_free(terrain->field);
    skv_free(terrain->coverage);
    skv_free(terrain->row_hash);
    skv_free(terrain->row_free);
    skv_free(terrain);
}

float skv_terrain_width(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return (float)terrain->width * terrain->pixel_size;
}

float skv_terrain_height(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return (float)terrain->height * terrain->pixel_size;
}

int skv_terrain_pixels_x(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return terrain->width;
}

int skv_terrain_pixels_y(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return terrain->height;
}

float skv_terrain_pixel_size(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return terrain->pixel_size;
}

unsigned skv_terrain_open_sides(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return terrain->open_sides;
}

void skv_terrain_free_range(const skv_terrain *terrain, float *lowest, float *highest)
{
    SKV_ASSERT(terrain && lowest && highest);
    *lowest = terrain->lowest;
    *highest = terrain->highest;
}

double skv_terrain_free_area(const skv_terrain *terrain)
{
    SKV_ASSERT_OR(terrain, 0);
    return terrain->free_area;
}

const float *skv_terrain_distances(const skv_terrain *terrain, int *stride)
{
    SKV_ASSERT_OR(terrain && stride, NULL);
    *stride = terrain->columns;
    return terrain->field + (size_t)SKV_TERRAIN_RIM * (size_t)terrain->columns + SKV_TERRAIN_RIM;
}
