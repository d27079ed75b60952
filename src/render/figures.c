/* Figures: a stroke font of what numbers and units need. Invariant: a glyph is a list of polylines
 * on a grid of 4 by 6, each corner two digits, x and y. */
#include "render/figures.h"

#include <string.h>

#define GRID_HEIGHT 6
#define ADVANCE     5.8f /* from glyph to glyph */

static const struct {
    char character;
    const char *lines;
} glyphs[] = {
    {'0', "103041453616050110"},
    {'1', "152620 1030"},
    {'2', "05163645440040"},
    {'3', "0516364544334241301001 1333"},
    {'4', "30360242"},
    {'5', "460603334241301001"},
    {'6', "4536160501103041423303"},
    {'7', "064610"},
    {'8', "13040516364544331302011030414233"},
    {'9', "0110304145361605041343"},
    {'.', "2020"},
    {',', "2110"},
    {'-', "0343"},
    {'/', "0046"},
    {'c', "4334140301103041"},
    {'m', "0004 03142320 23344340"},
    {'s', "4414031232413000"},
    {'a', "4440 4334140301103041"},
    {'k', "0006 3401 1330"},
    {'P', "00063645443303"},
};

static const char *lines_of(char character)
{
    for (size_t i = 0; i < sizeof glyphs / sizeof *glyphs; i++)
        if (glyphs[i].character == character)
            return glyphs[i].lines;
    return "";
}

/* A corner and the next one are a line, unless the pen was lifted between them. */
static bool is_line(const char *corner)
{
    return corner[0] != ' ' && corner[1] && corner[2] && corner[2] != ' ';
}

static const char *next_corner(const char *corner)
{
    return corner + (corner[0] == ' ' ? 1 : 2);
}

int skv_figures_count(const char *text)
{
    int count = 0;
    for (; *text; text++)
        for (const char *at = lines_of(*text); *at; at = next_corner(at))
            count += is_line(at);
    return count;
}

float skv_figures_width(const char *text, float height)
{
    return (float)strlen(text) * ADVANCE * height / GRID_HEIGHT;
}

void skv_figures_add(skv_strokes *strokes, const char *text, float x, float y, float height,
                     const uint8_t color[4])
{
    float unit = height / GRID_HEIGHT;
    for (; *text; text++, x += ADVANCE * unit)
        for (const char *at = lines_of(*text); *at; at = next_corner(at)) {
            if (!is_line(at))
                continue;
            skv_stroke line = {.x0 = x + unit * (float)(at[0] - '0'),
                               .y0 = y + unit * (float)(at[1] - '0'),
                               .x1 = x + unit * (float)(at[2] - '0'),
                               .y1 = y + unit * (float)(at[3] - '0'),
                               .radius = 0.09f * height};
            memcpy(line.color, color, sizeof line.color);
            skv_strokes_add(strokes, line);
        }
}
