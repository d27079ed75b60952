/* Algorithm 10 of the thesis. Its field is positive inside solid; the sign is turned at the end. */
#include "manhattan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Calls for the four neighbours of element i that lie in the field. */
static int neighbours_of(const manhattan *m, int i, int found[4])
{
    int x = i % m->width, y = i / m->width, count = 0;
    if (x > 0)
        found[count++] = i - 1;
    if (x < m->width - 1)
        found[count++] = i + 1;
    if (y > 0)
        found[count++] = i - m->width;
    if (y < m->height - 1)
        found[count++] = i + m->width;
    return count;
}

static bool is_edge(const manhattan *m, const bool *solid, int i)
{
    int near[4], count = neighbours_of(m, i, near);
    for (int k = 0; k < count; k++) {
        if (solid[i] && !solid[near[k]])
            return true;
    }
    return false;
}

/* One pass: from the edge pixels, which are 0, in whole steps through the pixels of one kind. */
static void spread(manhattan *m, const bool *solid, bool kind, float step)
{
    int pixels = m->width * m->height, head = 0, tail = 0;
    bool *seen = calloc((size_t)pixels, sizeof *seen);
    int *queue = calloc((size_t)pixels, sizeof *queue);
    for (int i = 0; i < pixels; i++) {
        if (is_edge(m, solid, i)) {
            m->raw[i] = 0;
            seen[i] = true;
            queue[tail++] = i;
        }
    }
    while (head < tail) {
        int i = queue[head++], near[4], count = neighbours_of(m, i, near);
        for (int k = 0; k < count; k++) {
            if (seen[near[k]] || solid[near[k]] != kind)
                continue;
            m->raw[near[k]] = m->raw[i] + step;
            seen[near[k]] = true;
            queue[tail++] = near[k];
        }
    }
    free(queue);
    free(seen);
}

/* The 9x9 kernel: the sum of d_j times the unit vector from j to i, without j = i. */
static void make_normals(manhattan *m)
{
    for (int i = 0; i < m->width * m->height; i++) {
        int x = i % m->width, y = i / m->width;
        double sx = 0, sy = 0;
        for (int v = -4; v <= 4; v++) {
            for (int u = -4; u <= 4; u++) {
                int jx = x + u, jy = y + v;
                jx = jx < 0 ? 0 : jx >= m->width ? m->width - 1 : jx;
                jy = jy < 0 ? 0 : jy >= m->height ? m->height - 1 : jy;
                double length = sqrt(u * u + v * v);
                double d = (double)m->raw[jy * m->width + jx] + 0.5;
                sx -= length > 0 ? d * u / length : 0;
                sy -= length > 0 ? d * v / length : 0;
            }
        }
        double length = sqrt(sx * sx + sy * sy);
        bool known = length > 1e-6;
        m->nx[i] = known ? (float)(sx / length) : 0;
        m->ny[i] = known ? (float)(sy / length) : 0;
    }
}

manhattan manhattan_create(int width, int height, const uint8_t *coverage)
{
    manhattan m = {.width = width + 2, .height = height + 2};
    size_t pixels = (size_t)m.width * (size_t)m.height;
    m.raw = calloc(pixels, sizeof *m.raw);
    m.corrected = calloc(pixels, sizeof *m.corrected);
    m.nx = calloc(pixels, sizeof *m.nx);
    m.ny = calloc(pixels, sizeof *m.ny);
    bool *solid = calloc(pixels, sizeof *solid);
    for (int y = 0; y < m.height; y++) {
        for (int x = 0; x < m.width; x++) {
            bool frame = x == 0 || y == 0 || x > width || y > height;
            solid[y * m.width + x] = frame || coverage[(y - 1) * width + x - 1] >= 128;
        }
    }
    spread(&m, solid, true, 1);
    spread(&m, solid, false, -1);
    free(solid);
    make_normals(&m);
    for (size_t i = 0; i < pixels; i++) {
        float straight = fmaxf(fabsf(m.nx[i]), fabsf(m.ny[i]));
        m.corrected[i] = -(m.raw[i] + 0.5f) * (straight > 0 ? straight : 1);
        m.raw[i] = -m.raw[i];
    }
    return m;
}

void manhattan_destroy(manhattan *m)
{
    free(m->raw);
    free(m->corrected);
    free(m->nx);
    free(m->ny);
    *m = (manhattan){0};
}
