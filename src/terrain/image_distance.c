/* The image distance beside a flat wall, tabulated: between the table's distances the share's fall
 * is taken as straight, so that the share is a parabola and has an exact inverse. Invariant: share
 * and distance are each other's inverse, and both slopes are steady.
 */
#include "terrain/image_distance.h"

#include "base/exact.h"

#include <math.h>
#include <string.h>

/* What is nearer than this goes on by a hyperbola. */
#define NEAR 0.03

static const double step = 1.0 / SKV_IMAGE_RADIUS;

/* Blurs the fall by two cells beside each other: a triangle. */
static void blur(double fall[SKV_IMAGE_STEPS + 1])
{
    double sharp[SKV_IMAGE_STEPS + SKV_IMAGE_CELL + 1] = {0};
    memcpy(sharp, fall, (SKV_IMAGE_STEPS + 1) * sizeof *sharp);
    for (int i = 0; i <= SKV_IMAGE_STEPS; i++) {
        double sum = 0;
        for (int k = 1 - SKV_IMAGE_CELL; k < SKV_IMAGE_CELL; k++) {
            int weight = SKV_IMAGE_CELL - (k < 0 ? -k : k);
            sum += weight * sharp[i + k < 0 ? -(i + k) : i + k];
        }
        fall[i] = sum / (SKV_IMAGE_CELL * SKV_IMAGE_CELL);
    }
}

void skv_image_law_make(bool cells, skv_image_law *law)
{
    for (int i = 0; i <= SKV_IMAGE_STEPS; i++)
        law->fall[i] = skv_kernel_fall(i * step);
    if (cells)
        blur(law->fall);
    law->share[SKV_IMAGE_STEPS] = 0;
    for (int i = SKV_IMAGE_STEPS - 1; i >= 0; i--)
        law->share[i] = law->share[i + 1] + 0.5 * step * (law->fall[i] + law->fall[i + 1]);
    double fall;
    law->near_share = skv_image_share(law, NEAR, &fall);
    law->near_slope = 1 / fall;
}

double skv_image_distance(const skv_image_law *law, double share, double *slope)
{
    *slope = 0;
    if (!(share > 0))
        return 1;
    if (share > law->near_share) {
        double part = 1 / (1 + law->near_slope * (share - law->near_share) / NEAR);
        *slope = law->near_slope * part * part;
        return NEAR * part;
    }
    /* The last place with at least that share. */
    int low = 0, high = SKV_IMAGE_STEPS;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (law->share[middle] >= share)
            low = middle;
        else
            high = middle;
    }
    double missing = law->share[low] - share, bend = (law->fall[low + 1] - law->fall[low]) / step;
    double square = law->fall[low] * law->fall[low] + 2 * bend * missing;
    double fall = square > 0 ? sqrt(square) : 0;
    double distance = low * step + 2 * missing / (law->fall[low] + fall);
    /* No image is felt from a radius on. */
    if (!(distance < 1))
        return 1;
    *slope = 1 / fall;
    return distance;
}

/* A deeper one is taken for so deep: its share is finite then. */
#define DEEPEST 1e-4

double skv_image_share_at(const skv_image_law *law, double distance, double *fall)
{
    if (!(distance < NEAR))
        return skv_image_share(law, skv_min(distance, 1), fall);
    double part = skv_max(distance, DEEPEST) / NEAR;
    *fall = 1 / (law->near_slope * part * part);
    return law->near_share + NEAR * (1 / part - 1) / law->near_slope;
}

double skv_image_share(const skv_image_law *law, double distance, double *fall)
{
    int i = (int)(distance / step);
    i = i < SKV_IMAGE_STEPS ? i : SKV_IMAGE_STEPS - 1;
    double way = distance - i * step, bend = (law->fall[i + 1] - law->fall[i]) / step;
    *fall = law->fall[i] + bend * way;
    return law->share[i] - way * (law->fall[i] + 0.5 * bend * way);
}
