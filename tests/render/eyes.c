/* How eyes see colours. */
#include "render/eyes.h"

#include <math.h>

/* What of linear red, green and blue reaches eyes of full colour vision, and those that lack one
 * kind of cone (Machado, Oliveira and Fernandes 2009). */
static const double eyes[EYES][3][3] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0.152286, 1.052583, -0.204868},
     {0.114503, 0.786281, 0.099216},
     {-0.003882, -0.048116, 1.051998}},
    {{0.367322, 0.860646, -0.227968},
     {0.280085, 0.672501, 0.047413},
     {-0.011820, 0.042940, 0.968881}},
    {{1.255528, -0.076749, -0.178779},
     {-0.078411, 0.930809, 0.147602},
     {0.004733, 0.691367, 0.303900}},
};

static double linear(double c)
{
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

static void times(const double m[3][3], const double in[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m[i][0] * in[0] + m[i][1] * in[1] + m[i][2] * in[2];
}

void color_seen_by(int eye, const float color[3], double lab[3])
{
    static const double to_cones[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                          {0.2119034982, 0.6806995451, 0.1073969566},
                                          {0.0883024619, 0.2817188376, 0.6299787005}};
    static const double to_lab[3][3] = {{0.2104542553, 0.7936177850, -0.0040720468},
                                        {1.9779984951, -2.4285922050, 0.4505937099},
                                        {0.0259040371, 0.7827717662, -0.8086757660}};
    double light[3], seen[3], cones[3];
    for (int k = 0; k < 3; k++)
        light[k] = linear((double)color[k]);
    times(eyes[eye], light, seen);
    for (int k = 0; k < 3; k++)
        seen[k] = fmin(fmax(seen[k], 0), 1);
    times(to_cones, seen, cones);
    for (int k = 0; k < 3; k++)
        cones[k] = cbrt(cones[k]);
    times(to_lab, cones, lab);
}

double colors_apart(int eye, const float a[3], const float b[3])
{
    double x[3], y[3];
    color_seen_by(eye, a, x);
    color_seen_by(eye, b, y);
    return sqrt((x[0] - y[0]) * (x[0] - y[0]) + (x[1] - y[1]) * (x[1] - y[1]) +
                (x[2] - y[2]) * (x[2] - y[2]));
}
