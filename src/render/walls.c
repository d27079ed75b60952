/* Walls: uploads the terrain's distances as a half-float texture. Invariant: `fingerprint` belongs
 * to what the texture and the figures hold. */
#include "render/walls.h"

#include <string.h>

#include "base/memory.h"

/* More texels than a screen has pixels show nothing more. */
#define LARGEST_TEXTURE 4096
#define SAMPLES_A_SIDE  64

void skv_walls_create(skv_walls *walls)
{
    *walls = (skv_walls){.texture = skv_gl_texture()};
}

void skv_walls_destroy(skv_walls *walls)
{
    glDeleteTextures(1, &walls->texture);
    *walls = (skv_walls){0};
}

static uint64_t mix(uint64_t hash, const void *value, size_t size)
{
    const unsigned char *bytes = value;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash;
}

/* A terrain's address says little: another one may come to lie there. Distances change over a wide
 * area when any wall changes, so a coarse grid of samples notices every edit that can be seen. */
static uint64_t fingerprint(const skv_terrain *terrain)
{
    int stride, width = skv_terrain_pixels_x(terrain), height = skv_terrain_pixels_y(terrain);
    const float *distances = skv_terrain_distances(terrain, &stride);
    float pixel_size = skv_terrain_pixel_size(terrain);
    uint64_t hash = 0xcbf29ce484222325u;
    hash = mix(hash, &width, sizeof width);
    hash = mix(hash, &height, sizeof height);
    hash = mix(hash, &pixel_size, sizeof pixel_size);
    for (int j = 0; j < SAMPLES_A_SIDE; j++)
        for (int i = 0; i < SAMPLES_A_SIDE; i++) {
            size_t row = (size_t)((2 * j + 1) * (int64_t)height / (2 * SAMPLES_A_SIDE));
            size_t column = (size_t)((2 * i + 1) * (int64_t)width / (2 * SAMPLES_A_SIDE));
            hash = mix(hash, &distances[row * (size_t)stride + column], sizeof(float));
        }
    return hash ? hash : 1;
}

static int texels(int pixels)
{
    GLint limit = LARGEST_TEXTURE;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    limit = limit < LARGEST_TEXTURE ? limit : LARGEST_TEXTURE;
    return pixels < limit ? pixels : limit;
}

/* One row of the texture; pictures larger than it are sampled at the texels' centres. */
static void fill_row(const skv_terrain *terrain, int row, int columns, int rows, float *out)
{
    if (columns == skv_terrain_pixels_x(terrain) && rows == skv_terrain_pixels_y(terrain)) {
        int stride;
        const float *distances = skv_terrain_distances(terrain, &stride);
        memcpy(out, distances + (size_t)row * (size_t)stride, (size_t)columns * sizeof *out);
        return;
    }
    float step_x = skv_terrain_width(terrain) / (float)columns;
    float y = ((float)row + 0.5f) * skv_terrain_height(terrain) / (float)rows;
    for (int i = 0; i < columns; i++)
        out[i] = skv_terrain_distance(terrain, ((float)i + 0.5f) * step_x, y);
}

skv_result skv_walls_update(skv_walls *walls, const skv_terrain *terrain, skv_error *error)
{
    uint64_t wanted = fingerprint(terrain);
    if (wanted == walls->fingerprint)
        return SKV_OK;
    int columns = texels(skv_terrain_pixels_x(terrain));
    int rows = texels(skv_terrain_pixels_y(terrain));
    float *row = skv_calloc((size_t)columns, sizeof *row);
    if (!row)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the picture of the walls");

    glBindTexture(GL_TEXTURE_2D, walls->texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, columns, rows, 0, GL_RED, GL_FLOAT, NULL);
    int64_t free_texels = 0;
    for (int j = 0; j < rows; j++) {
        fill_row(terrain, j, columns, rows, row);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, j, columns, 1, GL_RED, GL_FLOAT, row);
        for (int i = 0; i < columns; i++)
            free_texels += row[i] > 0;
    }
    skv_free(row);
    walls->free_area = (double)free_texels / ((double)columns * rows) * skv_terrain_width(terrain) *
                       skv_terrain_height(terrain);
    skv_terrain_free_range(terrain, &walls->lowest, &walls->highest);
    walls->fingerprint = wanted;
    return SKV_OK;
}
