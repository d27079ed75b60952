/* The textbook's formulas. Invariant: nothing here knows a world. */
#include "experiments/theory.h"

#include "base/exact.h"

#include <math.h>

#define PI 3.14159265358979323846

double skv_theory_pressure(double density, double gravity, double depth)
{
    return density * gravity * depth;
}

double skv_theory_u_tube_period(double gravity, double length)
{
    return 2 * PI * sqrt(length / (2 * gravity));
}

double skv_theory_slosh_period(double gravity, double width, double depth)
{
    double k = PI / width;
    double square = skv_exp(-2 * skv_min(k * depth, 50)); /* of tanh: e^-x over e^x */
    return 2 * PI / sqrt(gravity * k * (1 - square) / (1 + square));
}

const dam_point skv_theory_dam[DAM_POINTS] = {
    {0.41, 1.11, {1.122, 1.111, 1.100, 1.093, 1.082, 1.074}},
    {0.84, 1.22, {1.412, 1.403, 1.396, 1.391, 1.351, 1.316}},
    {1.19, 1.44, {1.729, 1.718, 1.707, 1.696, 1.683, 1.663}},
    {1.43, 1.67, {1.980, 1.968, 1.956, 1.942, 1.921, 1.908}},
    {1.63, 1.89, {2.207, 2.194, 2.181, 2.167, 2.139, 2.121}},
    {1.83, 2.11, {2.451, 2.436, 2.421, 2.406, 2.373, 2.349}},
    {1.98, 2.33, {2.641, 2.626, 2.610, 2.594, 2.560, 2.529}},
    {2.20, 2.56, {2.934, 2.918, 2.900, 2.883, 2.849, 2.807}},
    {2.32, 2.78, {3.099, 3.082, 3.064, 3.046, 3.012, 2.966}},
    {2.51, 3.00, {3.370, 3.351, 3.333, 3.313, 3.276, 3.228}},
    {2.65, 3.22, {3.576, 3.556, 3.536, 3.516, 3.475, 3.430}},
    {2.83, 3.44, {3.847, 3.825, 3.803, 3.783, 3.738, 3.696}},
    {2.98, 3.67, {4.079, 4.056, 4.032, 4.010, 3.962, 3.920}},
    {3.11, 3.89, {4.284, 4.260, 4.235, 4.211, 4.161, 4.116}},
    {3.33, 4.11, {4.638, 4.611, 4.585, 4.557, 4.503, 4.452}},
};

const double skv_theory_dam_heights[DAM_HEIGHTS] = {0.01, 0.02, 0.03, 0.04, 0.06, 0.08};

double skv_theory_dam_front(int point, double height)
{
    const double *heights = skv_theory_dam_heights, *fronts = skv_theory_dam[point].ideal;
    int i = 1;
    while (i < DAM_HEIGHTS - 1 && heights[i] < height)
        i++;
    double share = (height - heights[i - 1]) / (heights[i] - heights[i - 1]);
    return fronts[i - 1] + fmin(fmax(share, 0), 1) * (fronts[i] - fronts[i - 1]);
}

double skv_theory_jet_speed(double gravity, double head)
{
    return sqrt(2 * gravity * head);
}

double skv_theory_contraction(void)
{
    return PI / (PI + 2);
}

double skv_theory_buoyancy(double density, double gravity, double area)
{
    return density * gravity * area;
}
