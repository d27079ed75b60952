/* The oracle's formulas. Invariant: double precision and all pairs; clarity before speed. */
#include "support/oracle.h"

#include "solver/wall_image.h"

#include <math.h>

static double radius_of(const oracle *o)
{
    return o->s * o->eta;
}

static double pair_at(const oracle *o, int i, int j, double *ux, double *uy)
{
    double dx = o->px[j] - o->px[i], dy = o->py[j] - o->py[i], r = hypot(dx, dy);
    *ux = dx / r;
    *uy = dy / r;
    if (o->walled && (o->px[i] < o->wall_x) != (o->px[j] < o->wall_x))
        return 0;
    return fmax(0, 1 - r / radius_of(o));
}

/* The laws' density kernels at distance x, in h, and their slopes there. */
static double kernel(bool clavet, double x)
{
    return clavet ? pow(1 - x, 2) : pow(1 - x, 3) * (1 + 3 * x);
}

static double kernel_slope(bool clavet, double x)
{
    return clavet ? -2 * (1 - x) : -12 * x * pow(1 - x, 2);
}

/* The slope in the units of the push, which is q for Clavet's kernel and x q^2 for the other. */
static double force(bool clavet, double x)
{
    return kernel_slope(clavet, x) / (clavet ? -2 : -12);
}

static bool has_image(const oracle *o, int i)
{
    return o->images && o->image[i] < 1;
}

/* D of a particle that has gone by (dx, dy). */
static double image_distance(const oracle *o, int i, double dx, double dy)
{
    return o->image[i] + (dx * o->facing_x[i] + dy * o->facing_y[i]) / radius_of(o);
}

/* q of the image of j, seen by i after it has gone by (dx, dy): the way that changes is that along
 * the wall or that out of it. */
static double image_at(const oracle *o, int i, int j, double dx, double dy, bool along)
{
    if (!has_image(o, i) || !has_image(o, j))
        return 0;
    double x = o->px[j] - o->px[i] - (along ? dx : 0), y = o->py[j] - o->py[i] - (along ? dy : 0);
    double h = radius_of(o), out = along ? o->image[i] : image_distance(o, i, dx, dy);
    return fmax(0, 1 - sqrt(x * x / h / h + y * y / h / h + 4 * out * o->image[j]));
}

/* q of its own image. */
static double own_image(const oracle *o, int i, double dx, double dy)
{
    return has_image(o, i) ? fmax(0, 1 - 2 * image_distance(o, i, dx, dy)) : 0;
}

/* Hexagonal lattice with one point per s^2: distances of all points within h of the middle one. */
static int lattice_distances(double eta, double *x)
{
    double side = sqrt(2 / sqrt(3)) / eta;
    int count = 0, far = (int)(2 / side) + 1; /* more than what lies within h */
    for (int a = -far; a <= far; a++) {
        for (int b = -far; b <= far; b++) {
            double r = hypot(side * (a + 0.5 * b), side * b * sqrt(0.75));
            if ((a || b) && r < 1)
                x[count++] = r;
        }
    }
    return count;
}

enum { LATTICE_MAX = 100 };

double oracle_lattice_density(bool clavet, double eta)
{
    double x[LATTICE_MAX], sum = 0;
    for (int i = lattice_distances(eta, x); i-- > 0;)
        sum += kernel(clavet, x[i]);
    return sum;
}

static double lattice_response(double eta)
{
    double x[LATTICE_MAX], sum = 0;
    for (int i = lattice_distances(eta, x); i-- > 0;)
        sum += pow(force(false, x[i]), 2);
    return sum;
}

static double lattice_near_density(double eta)
{
    double x[LATTICE_MAX], sum = 0;
    for (int i = lattice_distances(eta, x); i-- > 0;)
        sum += pow(1 - x[i], 3);
    return sum;
}

double oracle_rest_density(const oracle *o)
{
    return o->clavet ? o->rest_density_clavet : oracle_lattice_density(false, o->eta);
}

/* Algorithm 2. */
static void pull_by_hand(const oracle *o, double x, double y, double *vx, double *vy)
{
    const oracle_hand *hand = o->hand;
    if (!hand)
        return;
    double rx = (hand->x - x) / hand->radius, ry = (hand->y - y) / hand->radius;
    double fade = pow(fmax(0, 1 - rx * rx - ry * ry), 2), at_half = 0.5 * 0.75 * 0.75;
    double pull = o->dt * hand->attraction * fade / at_half;
    double slow = fmin(0.5, o->dt * hand->friction) * fade;
    double carry = fmin(0.5, o->dt * hand->follow) * fade;
    *vx += pull * rx - slow * *vx + carry * (hand->vx - *vx);
    *vy += pull * ry - slow * *vy + carry * (hand->vy - *vy);
}

void oracle_external_forces(oracle *o, const oracle_hand *hand)
{
    o->hand = hand;
    for (int i = 0; i < o->n; i++) {
        o->vx[i] += o->dt * o->g_x;
        o->vy[i] += o->dt * o->g_y;
        pull_by_hand(o, o->x[i], o->y[i], &o->vx[i], &o->vy[i]);
    }
}

void oracle_viscosity(oracle *o)
{
    for (int i = 0; i < o->n; i++)
        o->dx[i] = o->dy[i] = 0;
    for (int i = 0; i < o->n; i++) {
        for (int j = i + 1; j < o->n; j++) {
            double ux, uy, q = pair_at(o, i, j, &ux, &uy);
            double u = (o->vx[i] - o->vx[j]) * ux + (o->vy[i] - o->vy[j]) * uy;
            if (q <= 0 || u <= 0)
                continue;
            double full = q * fmin(0.5, o->dt * (o->sigma + o->beta * u)) * u;
            o->dx[i] -= 0.5 * full * ux;
            o->dy[i] -= 0.5 * full * uy;
            o->dx[j] += 0.5 * full * ux;
            o->dy[j] += 0.5 * full * uy;
        }
    }
}

void oracle_advance(oracle *o, double max_speed)
{
    for (int i = 0; i < o->n; i++) {
        double speed = hypot(o->vx[i], o->vy[i]);
        double scale = speed > max_speed ? max_speed / speed : 1;
        o->vx[i] *= scale;
        o->vy[i] *= scale;
        o->dx[i] = o->dt * o->vx[i];
        o->dy[i] = o->dt * o->vy[i];
        o->wx[i] = o->wy[i] = o->pressure[i] = 0;
    }
}

/* F1 beside a flat wall at the image's distance. How steeply the solid's share falls there is a
 * fit, which tests/world/test_images.c compares. */
static double flat_slope(const oracle *o, int i)
{
    double slope = has_image(o, i) ? (double)skv_flat_slope((float)o->image[i]) : 0;
    return slope * 3.14159265358979 / 5 * o->eta * o->eta / 12;
}

/* What the pressure pushes in a substep that starts warm, at the depth that it is made for. */
static double deep_push(const oracle *o)
{
    double step = o->omega * radius_of(o) / 12 * 0.04 * oracle_rest_density(o);
    return o->iterations * step / lattice_response(o->eta) / (1 - o->warm_start);
}

void oracle_take_pairs(oracle *o, double lag)
{
    for (int i = 0; i < o->n; i++) {
        double way_x = o->dt * o->vx[i] + o->wx[i], way_y = o->dt * o->vy[i] + o->wy[i];
        double slow = fmin(1, pow(hypot(way_x, way_y) / (0.010 * radius_of(o)), 2));
        o->px[i] = o->x[i] - lag * slow * way_x;
        o->py[i] = o->y[i] - lag * slow * way_y;
    }
}

/* What the density of a pair and of its images, each with its q, gains until they are where the
 * particles are: their slopes times what their distances will have changed by, of which r dr is the
 * same. */
static double gain_ahead(const oracle *o, int i, int j, double q, double image)
{
    double h = radius_of(o), x = o->px[j] - o->px[i], y = o->py[j] - o->py[i];
    double way_x = o->x[j] - o->x[i] - x, way_y = o->y[j] - o->y[i] - y;
    double change = (x * way_x + y * way_y) / h / h;
    double gain = kernel_slope(o->clavet, 1 - q) * change / (1 - q);
    return gain + (image > 0 ? kernel_slope(o->clavet, 1 - image) * change / (1 - image) : 0);
}

void oracle_density(oracle *o, bool gradient)
{
    for (int i = 0; i < o->n; i++) {
        double own = own_image(o, i, 0, 0);
        o->density[i] = o->wall_density[i] + kernel(o->clavet, 1 - own);
        o->near_density[i] = o->wall_near[i] + pow(own, 3);
        if (gradient) {
            double flat = o->images ? flat_slope(o, i) : 0;
            o->gx[i] = -o->f1x[i] - flat * o->facing_x[i];
            o->gy[i] = -o->f1y[i] - flat * o->facing_y[i];
        }
        for (int j = 0; j < o->n; j++) {
            if (j == i)
                continue;
            double ux, uy, q = pair_at(o, i, j, &ux, &uy);
            if (q <= 0)
                continue;
            double image = image_at(o, i, j, 0, 0, true);
            o->density[i] += kernel(o->clavet, 1 - q) + kernel(o->clavet, 1 - image);
            o->density[i] += gain_ahead(o, i, j, q, image);
            o->near_density[i] += pow(q, 3) + pow(image, 3);
            o->gx[i] += gradient ? force(o->clavet, 1 - q) * ux : 0;
            o->gy[i] += gradient ? force(o->clavet, 1 - q) * uy : 0;
        }
        /* A fifth of what it is at a flat surface does not count. */
        double size = hypot(o->gx[i], o->gy[i]), bulk = o->clavet ? 0 : 0.2 * o->eta * o->eta / 15;
        double share = size > bulk ? 1 - bulk / size : 0;
        share *= o->clavet ? 1 : fmax(0, 1 - o->dt * o->dt * o->warm[i] / (0.25 * deep_push(o)));
        o->gx[i] *= gradient ? share : 1;
        o->gy[i] *= gradient ? share : 1;
    }
}

static void pressure_clavet(oracle *o, int i)
{
    double h = radius_of(o), excess = o->density[i] - o->rest_density_clavet;
    double strength = o->density[i] * 0.5 * o->k_near_clavet * o->near_density[i];
    double limit = strength > 0.2 ? 0.2 / strength : 1;
    o->lambda[i] = limit * 0.5 * o->k * h * excess;
    o->near_lambda[i] = limit * 0.5 * o->k_near_clavet * h * o->near_density[i];
}

/* Accelerations become displacements of dt^2 each, shared out over the iterations. */
static void pressure_calibrated(oracle *o, int i, bool first)
{
    double rest = oracle_rest_density(o), response = lattice_response(o->eta);
    double fill = o->density[i] / rest, softer = 1 / fmax(1, fill);
    double share = o->dt * o->dt / o->iterations * softer;
    double lambda = o->omega * radius_of(o) / 12 * rest * fmax(0, fill - 1) / response * softer;
    double warm = o->warm_start * fmin(o->dt * o->dt * o->warm[i], 0.7 * deep_push(o));
    lambda += first ? fmin(warm, 6 * lambda) : 0;
    o->warm[i] = (first ? 0 : o->warm[i]) + lambda / (o->dt * o->dt);
    double held = fmin(1, fmax(0, (fill - 0.25) / 0.25));
    double pull = 1.785 * o->k_coh / 2 * rest * fmax(0, 0.95 - fill) * held;
    double usual = lattice_near_density(o->eta) / rest;
    double crowd = o->k_near / 2 * fmax(0, o->near_density[i] - usual * o->density[i]);
    o->lambda[i] = lambda - share * (pull + 4 * usual * crowd);
    o->near_lambda[i] = share * crowd;
}

void oracle_pressure(oracle *o, bool first)
{
    for (int i = 0; i < o->n; i++)
        o->clavet ? pressure_clavet(o, i) : pressure_calibrated(o, i, first);
}

/* With images: the energy's slope by differences of what they add to the densities, along the wall
 * or out of it, P and N being the energy's slopes in these; along one axis. */
static double push_off_images(const oracle *o, int i, int axis, bool along)
{
    const double small = 1e-6 * radius_of(o);
    double dx = axis == 0 ? small : 0, dy = axis == 1 ? small : 0, sum = 0;
    for (int j = 0; j < o->n; j++) {
        double ux, uy;
        if (j == i || pair_at(o, i, j, &ux, &uy) <= 0)
            continue;
        double ahead = image_at(o, i, j, dx, dy, along),
               behind = image_at(o, i, j, -dx, -dy, along);
        sum +=
            (o->lambda[i] + o->lambda[j]) * (kernel(false, 1 - ahead) - kernel(false, 1 - behind)) +
            4 * (o->near_lambda[i] + o->near_lambda[j]) * (pow(ahead, 3) - pow(behind, 3));
    }
    if (!along) {
        double ahead = own_image(o, i, dx, dy), behind = own_image(o, i, -dx, -dy);
        sum += o->lambda[i] * (kernel(false, 1 - ahead) - kernel(false, 1 - behind)) +
               4 * o->near_lambda[i] * (pow(ahead, 3) - pow(behind, 3));
    }
    return -radius_of(o) / 12 * sum / (2 * small);
}

/* The walls' part; a pull is freed of what holds against gravity and a hand, with clavet's law only
 * where the density is below three quarters of the lattice's. */
static void push_off_walls(oracle *o, int i)
{
    double x = o->lambda[i] * o->f1x[i] + o->near_lambda[i] * o->f2x[i];
    double y = o->lambda[i] * o->f1y[i] + o->near_lambda[i] * o->f2y[i];
    double nx = o->f1x[i], ny = o->f1y[i];
    if (has_image(o, i)) {
        x += push_off_images(o, i, 0, false);
        y += push_off_images(o, i, 1, false);
        nx = o->facing_x[i];
        ny = o->facing_y[i];
    }
    double gx = 0, gy = 0;
    pull_by_hand(o, o->x[i], o->y[i], &gx, &gy);
    gx += o->dt * o->g_x;
    gy += o->dt * o->g_y;
    double g = hypot(gx, gy), up = g > 0 ? -(x * gx + y * gy) / g : 0;
    double loose = 0.75 * oracle_lattice_density(true, o->eta) - o->rest_density_clavet;
    bool is_loose = !o->clavet || o->lambda[i] < 0.5 * o->k * radius_of(o) * loose;
    double freed = o->images ? 1 - o->adhesion : 1;
    if (is_loose && up > 0 && x * nx + y * ny < 0) {
        x += freed * up * gx / g;
        y += freed * up * gy / g;
    }
    o->dx[i] = x;
    o->dy[i] = y;
}

/* How dense it is, to the lattice at rest, its own kernel of 1 included; at least 1, at most for a
 * density of ten times the lattice's. */
static double relative_density(const oracle *o, int i)
{
    double rest = oracle_lattice_density(false, o->eta);
    return (1 + fmax(rest, fmin(o->density[i], 10 * rest))) / (1 + rest);
}

/* What a wall makes of the virial. */
static double wall_virial(const oracle *o, int i, double virial)
{
    double h = radius_of(o), part = o->clavet ? 1 : 1.0 / 6;
    double full = 3.14159265358979 / 5 * o->eta * o->eta;
    if (has_image(o, i))
        return 2 * h * (o->lambda[i] * full / 6 + 2.0 / 3 * o->near_lambda[i] * full / 2);
    return virial + h * (part * o->lambda[i] * o->wall_density[i] +
                         2.0 / 3 * o->near_lambda[i] * o->wall_near[i]);
}

void oracle_displacement(oracle *o, bool last)
{
    double h = radius_of(o);
    for (int i = 0; i < o->n; i++) {
        push_off_walls(o, i);
        for (int axis = 0; axis < 2 && has_image(o, i); axis++)
            (axis ? o->dy : o->dx)[i] += push_off_images(o, i, axis, true);
        double virial = 0;
        for (int j = 0; j < o->n; j++) {
            if (j == i)
                continue;
            double ux, uy, q = pair_at(o, i, j, &ux, &uy);
            if (q <= 0)
                continue;
            double size = (o->lambda[i] + o->lambda[j]) * force(o->clavet, 1 - q) +
                          (o->near_lambda[i] + o->near_lambda[j]) * q * q;
            o->dx[i] -= size * ux;
            o->dy[i] -= size * uy;
            virial += (1 - q) * h * size;
        }
        o->pressure[i] += o->fluid_density / (4 * o->dt * o->dt) * wall_virial(o, i, virial);
        if (last && has_image(o, i))
            o->pressure[i] *= relative_density(o, i);
    }
}

/* The component `k` of F r^ = (1 - |d|)^2 d at a place d, in h, relative to a particle. */
static double steered(const double d[2], int k)
{
    return pow(1 - hypot(d[0], d[1]), 2) * d[k];
}

/* The energy 0.255 k_coh h/2 sum |g|^2, of the g that count, and its slope, with the slopes of g by
 * differences. */
void oracle_tension(oracle *o)
{
    const double small = 1e-6;
    double h = radius_of(o), scale = o->dt * o->dt * 0.255 * o->k_coh;
    for (int i = 0; i < o->n; i++) {
        for (int j = 0; j < o->n; j++) {
            double ux, uy, q = j == i ? 0 : pair_at(o, i, j, &ux, &uy);
            if (q <= 0)
                continue;
            double g[2] = {o->gx[i] - o->gx[j], o->gy[i] - o->gy[j]}, push[2];
            for (int axis = 0; axis < 2; axis++) {
                double ahead[2] = {(1 - q) * ux, (1 - q) * uy}, behind[2] = {ahead[0], ahead[1]};
                ahead[axis] += small;
                behind[axis] -= small;
                push[axis] = 0;
                for (int k = 0; k < 2; k++)
                    push[axis] += g[k] * (steered(ahead, k) - steered(behind, k)) / (2 * small);
            }
            o->dx[i] += scale * push[0];
            o->dy[i] += scale * push[1];
            if (!has_image(o, i))
                o->pressure[i] -= o->fluid_density / (4 * o->dt * o->dt) * scale * h * (1 - q) *
                                  (push[0] * ux + push[1] * uy);
        }
    }
}

void oracle_contact(oracle *o)
{
    double soft = 1 - pow(1 - o->softness_a_frame, 60 * o->dt);
    /* With images friction does not wait for contact. */
    double rub = o->images ? 0 : 1 - pow(1 - o->friction_a_frame, 60 * o->dt);
    for (int i = 0; i < o->n; i++) {
        double tx = -o->normal_y[i], ty = o->normal_x[i];
        double moved_x = o->wx[i] + o->dt * o->vx[i], moved_y = o->wy[i] + o->dt * o->vy[i];
        double slide = o->depth[i] > 0 ? moved_x * tx + moved_y * ty : 0;
        o->dx[i] = soft * o->depth[i] * o->normal_x[i] - rub * slide * tx;
        o->dy[i] = soft * o->depth[i] * o->normal_y[i] - rub * slide * ty;
    }
}

void oracle_correct(oracle *o)
{
    for (int i = 0; i < o->n; i++) {
        o->x[i] += o->dx[i];
        o->y[i] += o->dy[i];
        o->wx[i] += o->dx[i];
        o->wy[i] += o->dy[i];
    }
}

void oracle_velocity(oracle *o)
{
    for (int i = 0; i < o->n; i++) {
        o->vx[i] += o->wx[i] / o->dt;
        o->vy[i] += o->wy[i] / o->dt;
    }
}
