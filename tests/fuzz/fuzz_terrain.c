/* A terrain of any pixels, asked at any places. */
#include "fuzz.h"

#include <skvalp/terrain.h>

#include <math.h>
#include <stdlib.h>

static void ask(const skv_terrain *terrain, fuzz_input *in)
{
    float width = skv_terrain_width(terrain), height = skv_terrain_height(terrain);
    float x = fuzz_float(in, -width, 2 * width), y = fuzz_float(in, -height, 2 * height);
    float x1 = fuzz_float(in, -width, 2 * width), y1 = fuzz_float(in, -height, 2 * height);
    float margin = fuzz_float(in, 0, width / 8);
    if (!isfinite(x) || !isfinite(y) || !isfinite(x1) || !isfinite(y1) || !isfinite(margin))
        return;
    float nx, ny, distance = skv_terrain_normal(terrain, x, y, &nx, &ny);
    fuzz_expect(distance == skv_terrain_distance(terrain, x, y), "one distance at a place");
    fuzz_expect(!isnan(distance), "a distance is a number");
    fuzz_expect(fabsf(nx * nx + ny * ny - 1) < 1e-3f, "a normal has the length 1");
    float share = skv_terrain_sweep(terrain, x, y, x1, y1, margin);
    fuzz_expect(share >= 0 && share <= 1, "a sweep goes a share of the way");
}

/* Paints any strokes; returns the terrain that is to be destroyed then. */
static skv_terrain *paint(skv_terrain *terrain, fuzz_input *in)
{
    skv_brush_stroke strokes[3];
    int count = fuzz_below(in, 4);
    float width = skv_terrain_width(terrain), height = skv_terrain_height(terrain);
    for (int i = 0; i < count; i++) {
        bool odd = fuzz_byte(in) % 8 == 0;
        strokes[i] = (skv_brush_stroke){
            .x0 = odd ? fuzz_any_float(in) : fuzz_float(in, -width, 2 * width),
            .y0 = fuzz_float(in, -height, 2 * height),
            .x1 = fuzz_float(in, -width, 2 * width),
            .y1 = odd ? fuzz_any_float(in) : fuzz_float(in, -height, 2 * height),
            .radius = odd ? fuzz_any_float(in) : fuzz_float(in, 0, width),
            .erase = fuzz_byte(in) % 2,
        };
    }
    skv_terrain *painted = NULL;
    skv_error error = {0};
    skv_result result = skv_terrain_paint(terrain, strokes, count, &painted, &error);
    fuzz_expect_answer(result, &error);
    fuzz_expect((result == SKV_OK) == (painted != NULL), "a painted terrain exactly if SKV_OK");
    if (painted == NULL)
        return terrain;
    skv_terrain_destroy(terrain);
    return painted;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_input in = {data, size};
    skv_terrain_def def = skv_default_terrain_def();
    def.width = SKV_TERRAIN_MIN_PIXELS + fuzz_below(&in, 48);
    def.height = SKV_TERRAIN_MIN_PIXELS + fuzz_below(&in, 48);
    def.open_sides = fuzz_byte(&in);
    def.pixel_size = fuzz_float(&in, 1e-4f, 0.1f);
    int mode = fuzz_byte(&in) % 4;
    uint8_t *coverage = calloc((size_t)def.width, (size_t)def.height);
    for (int i = 0; i < def.width * def.height && in.size > 64; i++) {
        uint8_t byte = fuzz_byte(&in);
        coverage[i] = mode == 0 ? byte : (uint8_t)((byte >> mode) & 1 ? 255 : 0);
    }
    def.coverage = coverage;
    skv_terrain *terrain = NULL;
    skv_error error = {0};
    skv_result result = skv_terrain_create(&def, &terrain, &error);
    free(coverage);
    fuzz_expect_answer(result, &error);
    fuzz_expect((result == SKV_OK) == (terrain != NULL), "a terrain exactly if SKV_OK");
    if (terrain == NULL)
        return 0;
    float lowest, highest;
    skv_terrain_free_range(terrain, &lowest, &highest);
    fuzz_expect(lowest <= highest, "the free region's lowest point is not above its highest");
    for (int i = 0; i < 32 && in.size > 0; i++)
        if (i % 8 == 7)
            terrain = paint(terrain, &in);
        else
            ask(terrain, &in);
    skv_terrain_destroy(terrain);
    return 0;
}
