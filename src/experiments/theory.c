/* The textbook's formulas. Invariant: nothing here knows a world. */
#include "experiments/theory.h"

#include "base/exact.h"

#include <math.h>

double skv_theory_pressure(double density, double gravity, double depth)
{
    return density * gravity * depth;
}

double skv_theory_layered_pressure(double upper, double lower, double gravity, double interface,
                                   double depth)
{
    double above = skv_min(depth, interface);
    return upper * gravity * above + lower * gravity * (depth - above);
}

double skv_theory_u_tube_period(double gravity, double length)
{
    return 2 * SKV_PI * sqrt(length / (2 * gravity));
}

double skv_theory_slosh_period(double gravity, double width, double depth)
{
    double k = SKV_PI / width;
    double square = skv_exp(-2 * skv_min(k * depth, 50)); /* of tanh: e^-x over e^x */
    return 2 * SKV_PI / sqrt(gravity * k * (1 - square) / (1 + square));
}

double skv_theory_slosh_height(double width, double depth, double slope)
{
    double square = skv_exp(-2 * skv_min(SKV_PI / width * depth, 50));
    return slope * SKV_PI / 2 * (1 + square) / (1 - square);
}

const double skv_theory_slosh_depths[SLOSH_DEPTHS] = {0.05, 0.075, 0.1, 0.125, 0.15, 0.175,
                                                      0.2,  0.25,  0.3, 0.4,   0.6,  1};
const double skv_theory_slosh_heights[SLOSH_HEIGHTS] = {0, 0.1, 0.2, 0.3, 0.4, 0.45};
const double skv_theory_slosh_kept[SLOSH_DEPTHS][SLOSH_HEIGHTS] = {
    {0.995, 0.968, 0.897, 0.798, 0.691, 0.640}, {0.990, 0.968, 0.906, 0.817, 0.717, 0.667},
    {0.983, 0.964, 0.910, 0.831, 0.739, 0.692}, {0.973, 0.958, 0.913, 0.847, 0.773, 0.737},
    {0.973, 0.960, 0.925, 0.872, 0.812, 0.782}, {0.979, 0.969, 0.940, 0.896, 0.845, 0.818},
    {0.986, 0.977, 0.953, 0.916, 0.872, 0.847}, {0.995, 0.988, 0.971, 0.943, 0.907, 0.886},
    {0.997, 0.992, 0.978, 0.956, 0.926, 0.909}, {0.993, 0.990, 0.981, 0.965, 0.944, 0.931},
    {0.987, 0.985, 0.979, 0.968, 0.953, 0.944}, {0.984, 0.983, 0.977, 0.968, 0.956, 0.948},
};

/* How far a value is from the number before at[*i] to the one there; 0 and 1 beyond the ends. */
static double share_of(const double *at, int count, double value, int *i)
{
    *i = 1;
    while (*i < count - 1 && at[*i] < value)
        ++*i;
    return fmin(fmax((value - at[*i - 1]) / (at[*i] - at[*i - 1]), 0), 1);
}

double skv_theory_slosh_amplitude(double width, double depth, double slope)
{
    double height = skv_theory_slosh_height(width, depth, slope);
    /* The loss grows as the square of the height. */
    double squares[SLOSH_HEIGHTS];
    for (int i = 0; i < SLOSH_HEIGHTS; i++)
        squares[i] = skv_theory_slosh_heights[i] * skv_theory_slosh_heights[i];
    int i, k;
    double deeper = share_of(skv_theory_slosh_depths, SLOSH_DEPTHS, depth / width, &i);
    double higher = share_of(squares, SLOSH_HEIGHTS, height * height, &k);
    const double *above = skv_theory_slosh_kept[i - 1], *below = skv_theory_slosh_kept[i];
    double low = above[k - 1] + deeper * (below[k - 1] - above[k - 1]);
    double high = above[k] + deeper * (below[k] - above[k]);
    return low + higher * (high - low);
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
    const double *fronts = skv_theory_dam[point].ideal;
    int i;
    double share = share_of(skv_theory_dam_heights, DAM_HEIGHTS, height, &i);
    return fronts[i - 1] + share * (fronts[i] - fronts[i - 1]);
}

double skv_theory_jet_speed(double gravity, double head)
{
    return sqrt(2 * gravity * head);
}

double skv_theory_jet_range(double head, double height)
{
    return 2 * sqrt(head * height);
}

double skv_theory_conjugate(double froude)
{
    return (sqrt(1 + 8 * froude * froude) - 1) / 2;
}

double skv_theory_bore(double stream_froude)
{
    enum { HALVINGS = 60 };
    double square = stream_froude * stream_froude;
    /* The upper end is above the root: (r - 1)^2 <= 2 F^2 r/(r + 1) < 2 F^2. */
    double low = 1, high = 1 + 1.5 * stream_froude;
    for (int i = 0; i < HALVINGS; i++) {
        double r = (low + high) / 2;
        *((r - 1) * (r - 1) * (r + 1) < 2 * r * square ? &low : &high) = r;
    }
    return (low + high) / 2;
}

double skv_theory_contraction(void)
{
    return SKV_PI / (SKV_PI + 2);
}

double skv_theory_buoyancy(double density, double gravity, double area)
{
    return density * gravity * area;
}

double skv_theory_boyle(double pressure, double volume, double other_pressure)
{
    return volume * (pressure / other_pressure);
}

double skv_theory_draught(double density, double body, double height)
{
    return height * body / density;
}

double skv_theory_sag(double density, double gravity, double height, double modulus)
{
    return density * gravity * height * height / (8 * modulus);
}

double skv_theory_atwood(double heavy, double light)
{
    return (heavy - light) / (heavy + light);
}

double skv_theory_growth(double atwood, double gravity, double length, double depth)
{
    return sqrt(atwood) * 2 * SKV_PI / skv_theory_slosh_period(gravity, length / 2, depth);
}
