/* The oracle's formulas. Invariant: double precision and all pairs; clarity before speed. */
#include "support/oracle.h"

#include <math.h>

static double radius_of(const oracle *o)
{
    return o->s * o->eta;
}

static double pair_at(const oracle *o, int i, int j, double *ux, double *uy)
{
    double dx = o->x[j] - o->x[i], dy = o->y[j] - o->y[i], r = hypot(dx, dy);
    *ux = dx / r;
    *uy = dy / r;
    if (o->walled && (o->x[i] < o->wall_x) != (o->x[j] < o->wall_x))
        return 0;
    return fmax(0, 1 - r / radius_of(o));
}

/* Hexagonal lattice with one point per s^2; sums of q^a (r/h)^b over all points but the centre. */
static double lattice_sum(double eta, int q_power, int r_power)
{
    double side = sqrt(2 / sqrt(3)) / eta, sum = 0;
    for (int a = -30; a <= 30; a++) {
        for (int b = -30; b <= 30; b++) {
            double r = hypot(side * (a + 0.5 * b), side * b * sqrt(0.75));
            if ((a || b) && r < 1)
                sum += pow(1 - r, q_power) * pow(r, r_power);
        }
    }
    return sum;
}

double oracle_lattice_density(double eta)
{
    return lattice_sum(eta, 2, 0);
}

static double effective_stiffness(const oracle *o)
{
    return o->omega * o->iterations * radius_of(o) /
           (o->dt * o->dt * oracle_lattice_density(o->eta));
}

double oracle_rest_density(const oracle *o)
{
    if (o->clavet)
        return o->rest_density_clavet;
    double a = lattice_sum(o->eta, 3, 0) * lattice_sum(o->eta, 2, 1) / lattice_sum(o->eta, 1, 1);
    return oracle_lattice_density(o->eta) + a * o->k_near / effective_stiffness(o);
}

void oracle_external_forces(oracle *o, const oracle_hand *hand)
{
    for (int i = 0; i < o->n; i++) {
        double vx = o->vx[i] + o->dt * o->g_x, vy = o->vy[i] + o->dt * o->g_y;
        if (hand) {
            double rx = (hand->x - o->x[i]) / hand->radius, ry = (hand->y - o->y[i]) / hand->radius;
            double inside = 1 - rx * rx - ry * ry;
            if (inside > 0) {
                double fade = inside * inside, at_half = 0.5 * 0.75 * 0.75;
                double pull = o->dt * hand->attraction * fade / at_half;
                double slow = fmin(0.5, o->dt * hand->friction) * fade;
                double carry = fmin(0.5, o->dt * hand->follow) * fade;
                double ax = pull * rx - slow * vx + carry * (hand->vx - vx);
                double ay = pull * ry - slow * vy + carry * (hand->vy - vy);
                vx += ax;
                vy += ay;
            }
        }
        o->vx[i] = vx;
        o->vy[i] = vy;
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
            double full = fmin(u, o->dt * q * (o->sigma * u + o->beta * u * u));
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

void oracle_density(oracle *o, bool gradient)
{
    for (int i = 0; i < o->n; i++) {
        o->density[i] = o->wall_density[i];
        o->near_density[i] = o->wall_near[i];
        if (gradient) {
            o->gx[i] = -o->f1x[i];
            o->gy[i] = -o->f1y[i];
        }
        for (int j = 0; j < o->n; j++) {
            if (j == i)
                continue;
            double ux, uy, q = pair_at(o, i, j, &ux, &uy);
            o->density[i] += q * q;
            o->near_density[i] += q * q * q;
            o->gx[i] += gradient ? q * ux : 0;
            o->gy[i] += gradient ? q * uy : 0;
        }
    }
}

void oracle_pressure(oracle *o)
{
    double h = radius_of(o), rest = oracle_rest_density(o), stiffness = effective_stiffness(o);
    for (int i = 0; i < o->n; i++) {
        double excess = o->density[i] - rest;
        if (o->clavet) {
            double strength = o->density[i] * 0.5 * o->k_near_clavet * o->near_density[i];
            double limit = strength > 0.2 ? 0.2 / strength : 1;
            o->push[i] = limit * 0.5 * o->k * h * excess;
            o->near_push[i] = limit * 0.5 * o->k_near_clavet * h * o->near_density[i];
        } else {
            double response = o->density[i] + o->gx[i] * o->gx[i] + o->gy[i] * o->gy[i];
            response = fmax(response, oracle_lattice_density(o->eta));
            double fill = o->density[i] / oracle_lattice_density(o->eta);
            if (excess < 0)
                excess *= fmin(1, o->k_coh / stiffness) * fmin(1, fmax(0, 4 * fill - 1));
            o->push[i] = o->omega * h / 2 * excess / response;
            o->near_push[i] =
                o->omega * h / 2 * (o->k_near / stiffness) * o->near_density[i] / response;
        }
    }
}

void oracle_displacement(oracle *o)
{
    double h = radius_of(o);
    for (int i = 0; i < o->n; i++) {
        o->dx[i] = o->push[i] * o->f1x[i] + o->near_push[i] * o->f2x[i];
        o->dy[i] = o->push[i] * o->f1y[i] + o->near_push[i] * o->f2y[i];
        double virial = 0;
        for (int j = 0; j < o->n; j++) {
            if (j == i)
                continue;
            double ux, uy, q = pair_at(o, i, j, &ux, &uy);
            double size =
                (o->push[i] + o->push[j]) * q + (o->near_push[i] + o->near_push[j]) * q * q;
            o->dx[i] -= size * ux;
            o->dy[i] -= size * uy;
            virial += (1 - q) * h * size;
        }
        virial +=
            h * (o->push[i] * o->wall_density[i] + 2.0 / 3 * o->near_push[i] * o->wall_near[i]);
        o->pressure[i] += o->fluid_density / (4 * o->dt * o->dt) * virial;
    }
}

void oracle_contact(oracle *o)
{
    double soft = 1 - pow(1 - o->softness_a_frame, 60 * o->dt);
    double rub = 1 - pow(1 - o->friction_a_frame, 60 * o->dt);
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
