/* The textbook's formulas. Invariant: nothing here knows a world. */
#include "experiments/theory.h"

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
    return 2 * PI / sqrt(gravity * k * tanh(k * depth));
}

const dam_point skv_theory_dam[DAM_POINTS] = {
    {0.41, 1.11}, {0.84, 1.22}, {1.19, 1.44}, {1.43, 1.67}, {1.63, 1.89},
    {1.83, 2.11}, {1.98, 2.33}, {2.20, 2.56}, {2.32, 2.78}, {2.51, 3.00},
    {2.65, 3.22}, {2.83, 3.44}, {2.98, 3.67}, {3.11, 3.89}, {3.33, 4.11},
};

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
