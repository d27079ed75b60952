/* Paints random worlds. Invariant: a picture follows from the dice alone, and chambers are counted
 * on the finished picture, so that whatever was painted over whatever, two chambers are closed
 * against each other. */
#include "world/painted.h"

#include <math.h>
#include <string.h>

#define WALL_HALF_WIDTH 1.0f /* pixels: walls of two */
#define MAX_CELLS       32   /* of a maze, along one side */

dice dice_from_seed(uint64_t seed)
{
    /* Scrambled once: seeds in a row must not give one stream, shifted. */
    dice d = {.state = seed ^ 0x632be59bd9b4e019u};
    return (dice){.state = dice_bits(&d)};
}

uint64_t dice_bits(dice *d)
{
    d->state += 0x9e3779b97f4a7c15u;
    uint64_t z = d->state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

float dice_float(dice *d, float low, float high)
{
    return low + (high - low) * ((float)(dice_bits(d) >> 40) / 16777216.0f);
}

int dice_int(dice *d, int low, int high)
{
    return low + (int)(dice_bits(d) % (uint64_t)(high - low + 1));
}

const char *painted_kind_name(painted_kind kind)
{
    static const char *const names[] = {"maze", "funnels", "diagonals", "blobs", "mixed"};
    return names[kind];
}

/* Paints one pixel from a signed distance in pixels, negative in the solid; never erases. */
static void paint_pixel(painted *p, int x, int y, float distance)
{
    float covered = p->grey ? 0.5f - distance : (distance <= 0.0f ? 1.0f : 0.0f);
    if (covered <= 0.0f)
        return;
    uint8_t *pixel = &p->coverage[y * p->width + x];
    uint8_t value = (uint8_t)(255.0f * fminf(covered, 1.0f));
    if (value > *pixel)
        *pixel = value;
}

/* A wall along a line, in pixels from the lower left corner. */
static void paint_wall(painted *p, float x0, float y0, float x1, float y1, float half_width)
{
    float dx = x1 - x0, dy = y1 - y0, length2 = dx * dx + dy * dy, reach = half_width + 1;
    /* Pixels that the wall can touch. */
    int left = (int)fmaxf(fminf(x0, x1) - reach, 0), bottom = (int)fmaxf(fminf(y0, y1) - reach, 0);
    float right = fminf(fmaxf(x0, x1) + reach, (float)p->width),
          top = fminf(fmaxf(y0, y1) + reach, (float)p->height);
    for (int y = bottom; (float)y < top; y++) {
        for (int x = left; (float)x < right; x++) {
            float px = (float)x + 0.5f - x0, py = (float)y + 0.5f - y0;
            float t = length2 > 0.0f ? (px * dx + py * dy) / length2 : 0.0f;
            t = fminf(fmaxf(t, 0.0f), 1.0f);
            paint_pixel(p, x, y, hypotf(px - t * dx, py - t * dy) - half_width);
        }
    }
}

/* Which doors of a maze are open: to the right of a cell, and above it. */
typedef struct maze {
    int nx, ny;
    bool right[MAX_CELLS][MAX_CELLS], up[MAX_CELLS][MAX_CELLS];
} maze;

/* Carves a perfect maze, depth first: every cell is reached, by one way only. */
static void carve(maze *m, dice *d)
{
    static const int step_x[4] = {1, -1, 0, 0}, step_y[4] = {0, 0, 1, -1};
    bool seen[MAX_CELLS][MAX_CELLS] = {{false}};
    int stack[MAX_CELLS * MAX_CELLS], depth = 1;
    stack[0] = 0;
    seen[0][0] = true;
    while (depth > 0) {
        int x = stack[depth - 1] % m->nx, y = stack[depth - 1] / m->nx, moves[4], count = 0;
        for (int k = 0; k < 4; k++) {
            int tx = x + step_x[k], ty = y + step_y[k];
            if (tx >= 0 && tx < m->nx && ty >= 0 && ty < m->ny && !seen[ty][tx])
                moves[count++] = k;
        }
        if (count == 0) {
            depth--;
            continue;
        }
        int k = moves[dice_int(d, 0, count - 1)], tx = x + step_x[k], ty = y + step_y[k];
        if (step_x[k])
            m->right[y][x < tx ? x : tx] = true;
        else
            m->up[y < ty ? y : ty][x] = true;
        seen[ty][tx] = true;
        stack[depth++] = ty * m->nx + tx;
    }
}

/* A maze in which some walls have fallen, and some doors are walled up, which makes closed
 * chambers. */
static void paint_maze(painted *p, dice *d)
{
    int cell = dice_int(d, 9, 24), nx = p->width / cell, ny = p->height / cell;
    maze m = {.nx = nx < MAX_CELLS ? nx : MAX_CELLS, .ny = ny < MAX_CELLS ? ny : MAX_CELLS};
    carve(&m, d);
    int fall = dice_int(d, 0, 25), close = dice_int(d, 0, 25); /* per cent */
    float size = (float)cell;
    for (int y = 0; y < m.ny; y++) {
        for (int x = 0; x < m.nx; x++) {
            float x1 = (float)(x + 1) * size, y1 = (float)(y + 1) * size;
            int luck = dice_int(d, 1, 100);
            if (x + 1 < m.nx && (m.right[y][x] ? luck <= close : luck > fall))
                paint_wall(p, x1, y1 - size, x1, y1, WALL_HALF_WIDTH);
            luck = dice_int(d, 1, 100);
            if (y + 1 < m.ny && (m.up[y][x] ? luck <= close : luck > fall))
                paint_wall(p, x1 - size, y1, x1, y1, WALL_HALF_WIDTH);
        }
    }
}

/* Storeys of two slanted walls each, which leave a gap of any width, none included. */
static void paint_funnels(painted *p, dice *d)
{
    float width = (float)p->width, height = (float)p->height;
    int storeys = dice_int(d, 1, 5);
    for (int i = 0; i < storeys; i++) {
        float mouth = height * ((float)i + dice_float(d, 0.3f, 0.7f)) / (float)storeys;
        float rise = dice_float(d, -0.6f, 0.6f) * height / (float)storeys;
        float centre = dice_float(d, 0.2f, 0.8f) * width;
        float gap = dice_int(d, 0, 3) ? dice_float(d, 1.0f, 0.15f * width) : -2.0f;
        paint_wall(p, 0.0f, mouth + rise, centre - 0.5f * gap, mouth, WALL_HALF_WIDTH);
        paint_wall(p, width, mouth + rise, centre + 0.5f * gap, mouth, WALL_HALF_WIDTH);
    }
}

/* Straight thin walls in every direction, most of them from edge to edge: sharp corners and closed
 * polygons. */
static void paint_diagonals(painted *p, dice *d, int most)
{
    float width = (float)p->width, height = (float)p->height;
    int walls = dice_int(d, 2, most);
    for (int i = 0; i < walls; i++) {
        float x = dice_float(d, 0.0f, width), y = dice_float(d, 0.0f, height);
        float angle = dice_float(d, 0.0f, 3.1415927f);
        float length = dice_int(d, 0, 2) ? width + height : dice_float(d, 0.1f, 0.5f) * width;
        float dx = length * cosf(angle), dy = length * sinf(angle);
        paint_wall(p, x - dx, y - dy, x + dx, y + dy, dice_float(d, 1.0f, 1.6f));
    }
}

/* Smooth shapes: where a sum of a few waves is high there is solid. Divided by its slope, the sum
 * is nearly a distance, which makes the grey edge one pixel wide. */
static void paint_blobs(painted *p, dice *d)
{
    enum { WAVES = 6 };
    float kx[WAVES], ky[WAVES], phase[WAVES], level = dice_float(d, 0.6f, 1.6f);
    for (int i = 0; i < WAVES; i++) {
        float wave = dice_float(d, 14.0f, 80.0f), angle = dice_float(d, 0.0f, 6.2831853f);
        kx[i] = 6.2831853f / wave * cosf(angle);
        ky[i] = 6.2831853f / wave * sinf(angle);
        phase[i] = dice_float(d, 0.0f, 6.2831853f);
    }
    for (int y = 0; y < p->height; y++) {
        for (int x = 0; x < p->width; x++) {
            float sum = 0.0f, slope_x = 0.0f, slope_y = 0.0f;
            for (int i = 0; i < WAVES; i++) {
                float a = kx[i] * (float)x + ky[i] * (float)y + phase[i];
                sum += sinf(a);
                slope_x += kx[i] * cosf(a);
                slope_y += ky[i] * cosf(a);
            }
            paint_pixel(p, x, y, (level - sum) / fmaxf(hypotf(slope_x, slope_y), 0.05f));
        }
    }
}

/* Numbers the chambers: flood fill over the eight neighbours. */
static void find_chambers(painted *p)
{
    static _Thread_local int stack[PAINTED_MAX_PIXELS * PAINTED_MAX_PIXELS];
    int pixels = p->width * p->height;
    memset(p->chamber, 0, sizeof p->chamber);
    p->chambers = 0;
    for (int start = 0; start < pixels; start++) {
        if (p->coverage[start] >= 128 || p->chamber[start] || p->chambers == UINT16_MAX)
            continue;
        uint16_t number = (uint16_t)++p->chambers;
        int depth = 0;
        p->chamber[start] = number;
        stack[depth++] = start;
        while (depth > 0) {
            int at = stack[--depth], x = at % p->width, y = at / p->width;
            for (int k = 0; k < 9; k++) {
                int tx = x + k % 3 - 1, ty = y + k / 3 - 1, to = ty * p->width + tx;
                if (tx < 0 || tx >= p->width || ty < 0 || ty >= p->height ||
                    p->coverage[to] >= 128 || p->chamber[to])
                    continue;
                p->chamber[to] = number;
                stack[depth++] = to;
            }
        }
    }
}

void paint(painted *p, dice *d)
{
    p->kind = (painted_kind)dice_int(d, 0, PAINTED_KINDS - 1);
    p->grey = dice_int(d, 0, 1) == 1;
    p->width = dice_int(d, 64, PAINTED_MAX_PIXELS);
    p->height = dice_int(d, 64, PAINTED_MAX_PIXELS);
    memset(p->coverage, 0, sizeof p->coverage);
    switch (p->kind) {
    case PAINTED_MAZE:
        paint_maze(p, d);
        break;
    case PAINTED_FUNNELS:
        paint_funnels(p, d);
        break;
    case PAINTED_DIAGONALS:
        paint_diagonals(p, d, 12);
        break;
    case PAINTED_BLOBS:
        paint_blobs(p, d);
        break;
    case PAINTED_MIXED:
    case PAINTED_KINDS:
        paint_blobs(p, d);
        paint_funnels(p, d);
        paint_diagonals(p, d, 4);
        break;
    }
    find_chambers(p);
}

int painted_chamber(const painted *p, float px, float py)
{
    if (!(px > -4.0f && px < (float)p->width + 4.0f && py > -4.0f && py < (float)p->height + 4.0f))
        return 0;
    int cx = (int)floorf(px), cy = (int)floorf(py), best = 0;
    float nearest = 2.0f;
    for (int y = cy - 2; y <= cy + 2; y++) {
        for (int x = cx - 2; x <= cx + 2; x++) {
            if (x < 0 || x >= p->width || y < 0 || y >= p->height ||
                p->coverage[y * p->width + x] >= 128)
                continue;
            /* To the pixel's square, not to its centre. */
            float dx = fmaxf(fabsf(px - ((float)x + 0.5f)) - 0.5f, 0.0f);
            float dy = fmaxf(fabsf(py - ((float)y + 0.5f)) - 0.5f, 0.0f);
            float distance = hypotf(dx, dy);
            if (distance < nearest) {
                nearest = distance;
                best = p->chamber[y * p->width + x];
            }
        }
    }
    return best;
}
