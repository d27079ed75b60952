/* Sets of squares. Invariant: what is asked of a set errs to the safe side only: a set may hold
 * more than what changed, by less than a square, never less. */
#include "terrain/squares.h"

#include "base/exact.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

static int squares_along(int pixels)
{
    return (pixels + SKV_SQUARE - 1) / SKV_SQUARE;
}

static skv_result allocate(int columns, int rows, skv_squares *squares, skv_error *error)
{
    *squares = (skv_squares){columns, rows, skv_calloc((size_t)columns * (size_t)rows, 1)};
    return squares->marks ? SKV_OK
                          : skv_fail(error, SKV_ERROR_MEMORY,
                                     "terrain: no memory for %d x %d squares", columns, rows);
}

skv_result skv_squares_create(int pixels_x, int pixels_y, skv_squares *squares, skv_error *error)
{
    return allocate(squares_along(pixels_x), squares_along(pixels_y), squares, error);
}

void skv_squares_destroy(skv_squares *squares)
{
    skv_free(squares->marks);
    *squares = (skv_squares){0};
}

void skv_squares_add(skv_squares *squares, int x, int y)
{
    squares->marks[(size_t)(y / SKV_SQUARE) * (size_t)squares->columns + (size_t)(x / SKV_SQUARE)] =
        1;
}

bool skv_squares_add_differences(skv_squares *squares, const uint8_t *a, const uint8_t *b,
                                 int pixels_x, int pixels_y)
{
    bool any = false;
    for (int y = 0; y < pixels_y; y++) {
        size_t row = (size_t)y * (size_t)pixels_x;
        if (memcmp(a + row, b + row, (size_t)pixels_x) == 0)
            continue;
        any = true;
        for (int x = 0; x < pixels_x; x += SKV_SQUARE) {
            int width = pixels_x - x < SKV_SQUARE ? pixels_x - x : SKV_SQUARE;
            if (memcmp(a + row + (size_t)x, b + row + (size_t)x, (size_t)width) != 0)
                skv_squares_add(squares, x, y);
        }
    }
    return any;
}

skv_result skv_squares_spread(const skv_squares *squares, double pixels, skv_squares *all,
                              skv_error *error)
{
    int columns = squares->columns, rows = squares->rows;
    int reach = (int)ceil(skv_min(pixels / SKV_SQUARE, columns > rows ? columns : rows));
    skv_result result = allocate(columns, rows, all, error);
    for (int y = 0; y < rows && result == SKV_OK; y++) {
        for (int x = 0; x < columns; x++) {
            if (!squares->marks[(size_t)y * (size_t)columns + (size_t)x])
                continue;
            int left = x > reach ? x - reach : 0, right = x + reach + 1;
            int bottom = y > reach ? y - reach : 0, top = y + reach + 1;
            right = right < columns ? right : columns;
            top = top < rows ? top : rows;
            for (int j = bottom; j < top; j++)
                memset(all->marks + (size_t)j * (size_t)columns + (size_t)left, 1,
                       (size_t)(right - left));
        }
    }
    return result;
}

skv_square_bounds skv_squares_bounds(const skv_squares *squares)
{
    int x0 = squares->columns, y0 = squares->rows, x1 = 0, y1 = 0;
    for (int y = 0; y < squares->rows; y++) {
        for (int x = 0; x < squares->columns; x++) {
            if (!squares->marks[(size_t)y * (size_t)squares->columns + (size_t)x])
                continue;
            x0 = x < x0 ? x : x0;
            y0 = y < y0 ? y : y0;
            x1 = x + 1 > x1 ? x + 1 : x1;
            y1 = y + 1;
        }
    }
    if (x1 == 0)
        return (skv_square_bounds){0};
    return (skv_square_bounds){x0 * SKV_SQUARE, y0 * SKV_SQUARE, x1 * SKV_SQUARE, y1 * SKV_SQUARE};
}

/* The square of a coordinate, kept inside the picture. */
static int square_at(double pixel, int squares)
{
    double square = pixel / SKV_SQUARE;
    return square <= 0 ? 0 : square >= squares ? squares - 1 : (int)square;
}

bool skv_squares_meet(const skv_squares *squares, double x0, double y0, double x1, double y1)
{
    int left = square_at(x0, squares->columns), right = square_at(x1, squares->columns);
    int bottom = square_at(y0, squares->rows), top = square_at(y1, squares->rows);
    for (int y = bottom; y <= top; y++) {
        const uint8_t *row = squares->marks + (size_t)y * (size_t)squares->columns;
        for (int x = left; x <= right; x++)
            if (row[x])
                return true;
    }
    return false;
}
