/* Walls: uploads the terrain's distances as a half-float texture. Invariant: the texture and the
 * figures are those of `shown`, which is held: a terrain never changes, so the same one needs no
 * look, and of another version only rows from the first to the last that differ are uploaded. */
#include "render/walls.h"

#include <string.h>

#include "base/memory.h"

/* More texels than a screen has pixels show nothing more. */
#define LARGEST_TEXTURE 4096

/* Texels that are uploaded at a time: most pictures at once, without much memory for large ones. */
#define BAND (1 << 19)

void skv_walls_create(skv_walls *walls)
{
    *walls = (skv_walls){.texture = skv_gl_texture()};
}

void skv_walls_destroy(skv_walls *walls)
{
    glDeleteTextures(1, &walls->texture);
    skv_terrain_destroy(walls->shown);
    *walls = (skv_walls){0};
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

static bool has_same_size(const skv_terrain *a, const skv_terrain *b)
{
    return a && skv_terrain_pixels_x(a) == skv_terrain_pixels_x(b) &&
           skv_terrain_pixels_y(a) == skv_terrain_pixels_y(b);
}

/* The rows that differ from those that are shown, from the first to beyond the last: all of them if
 * nothing of this size is. `two` has room for two rows. */
static void find_changed(const skv_walls *walls, const skv_terrain *terrain, int columns, int rows,
                         float *two, int *first, int *end)
{
    *first = 0;
    *end = rows;
    if (!has_same_size(walls->shown, terrain))
        return;
    int last = -1;
    *first = rows;
    for (int j = 0; j < rows; j++) {
        fill_row(terrain, j, columns, rows, two);
        fill_row(walls->shown, j, columns, rows, two + columns);
        if (memcmp(two, two + columns, (size_t)columns * sizeof *two) != 0) {
            *first = j < *first ? j : *first;
            last = j;
        }
    }
    *end = last + 1;
}

/* Brings the texture up to date by way of `band`, which has room for so many rows, two at least. */
static void upload(const skv_walls *walls, const skv_terrain *terrain, float *band, int room)
{
    int columns = texels(skv_terrain_pixels_x(terrain));
    int rows = texels(skv_terrain_pixels_y(terrain));
    int first, end;
    find_changed(walls, terrain, columns, rows, band, &first, &end);
    glBindTexture(GL_TEXTURE_2D, walls->texture);
    if (!has_same_size(walls->shown, terrain))
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, columns, rows, 0, GL_RED, GL_FLOAT, NULL);
    for (int count; first < end; first += count) {
        count = end - first < room ? end - first : room;
        for (int j = 0; j < count; j++)
            fill_row(terrain, first + j, columns, rows, band + (size_t)j * (size_t)columns);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, columns, count, GL_RED, GL_FLOAT, band);
    }
}

skv_result skv_walls_update(skv_walls *walls, const skv_terrain *terrain, skv_error *error)
{
    if (terrain == walls->shown)
        return SKV_OK;
    int columns = texels(skv_terrain_pixels_x(terrain));
    int room = BAND / columns > 2 ? BAND / columns : 2;
    float *band = skv_calloc((size_t)room * (size_t)columns, sizeof *band);
    if (!band)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for the picture of the walls");
    upload(walls, terrain, band, room);
    skv_free(band);
    skv_terrain_destroy(walls->shown);
    walls->shown = skv_terrain_share(terrain);
    walls->version++;
    walls->free_area = skv_terrain_free_area(terrain);
    skv_terrain_free_range(terrain, &walls->lowest, &walls->highest);
    return SKV_OK;
}
