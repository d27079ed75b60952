/* Velocities: external forces, the clamp before the advance, how far pairs lag behind, viscosity,
 * how unlike pairs turn, and the velocity at the end. Invariant: viscosity reads displacements that
 * no particle of the pass writes, so a pair's two impulses are opposite and momentum is kept. */
#include "solver/reference/pair.h"
#include "solver/reference/reference.h"
#include "solver/turn.h"

#include <math.h>

/* The formulas are solver/external_force.h's, for both solvers. They round a change, not the
 * velocity. */
void skv_apply_forces(const skv_reference *f, double x, double y, double *vx, double *vy)
{
    const float before_x = (float)*vx, before_y = (float)*vy;
    float after_x = before_x, after_y = before_y;
    skv_apply_external_forces(f->forces, f->force_count, (float)x, (float)y, &after_x, &after_y);
    *vx += (double)(after_x - before_x);
    *vy += (double)(after_y - before_y);
}

void skv_pass_external_forces(skv_reference *f)
{
    const double dt = (double)f->constants->dt;
    for (int i = 0; i < f->count; i++) {
        f->vx[i] += dt * f->gravity_x;
        f->vy[i] += dt * f->gravity_y;
        skv_apply_forces(f, f->x[i], f->y[i], &f->vx[i], &f->vy[i]);
    }
}

void skv_pass_predict(skv_reference *f)
{
    const double dt = (double)f->constants->dt, most = (double)f->constants->max_speed;
    for (int i = 0; i < f->count; i++) {
        double speed = sqrt(f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]);
        double scale = speed > most ? most / speed : 1;
        f->dx[i] = dt * scale * f->vx[i];
        f->dy[i] = dt * scale * f->vy[i];
        f->moved_x[i] = f->moved_y[i] = 0;
        f->pressure[i] = 0;
    }
}

void skv_pass_lag(skv_reference *f)
{
    const double dt = (double)f->constants->dt, most = (double)f->constants->pair_lag;
    const double rise = (double)f->constants->lag_rise / (dt * dt);
    for (int i = 0; i < f->count; i++) {
        double square = f->moved_x[i] * f->moved_x[i] + f->moved_y[i] * f->moved_y[i];
        double lag = most * skv_min(rise * square, 1);
        f->behind_x[i] = lag * f->moved_x[i];
        f->behind_y[i] = lag * f->moved_y[i];
    }
}

/* 0 if one of them is. */
static double harmonic_mean(double a, double b)
{
    return a > 0 && b > 0 ? 2 * a * b / (a + b) : 0;
}

void skv_pass_viscosity(skv_reference *f)
{
    const double per_way = (double)f->constants->viscosity_quadratic,
                 most = (double)SKV_MOST_VISCOUS;
    for (int i = 0; i < f->count; i++) {
        for (int k = skv_first_partner(f, i); k < skv_end_of_partners(f, i); k++) {
            int j = skv_partner(f, k);
            skv_pair pair;
            if (!skv_pair_of(f, i, j, &pair))
                continue;
            double approach = (f->moved_x[i] - f->moved_x[j]) * pair.ux +
                              (f->moved_y[i] - f->moved_y[j]) * pair.uy;
            if (!(approach > 0))
                continue;
            double lighter = skv_min(f->mass[i], f->mass[j]);
            double share = harmonic_mean(f->drag[i], f->drag[j]) + lighter * per_way * approach;
            share = pair.q * skv_min(share, most * lighter);
            f->dx[i] -= share * approach / 2 * pair.ux;
            f->dy[i] -= share * approach / 2 * pair.uy;
        }
    }
}

void skv_pass_turn(skv_reference *f)
{
    const double dt = (double)f->constants->dt, most = dt * dt * (double)SKV_TURN;
    const double reach = (double)f->constants->turn_reach, all = (double)SKV_TURN_CONTRAST;
    for (int i = 0; i < f->count; i++) {
        for (int k = skv_first_partner(f, i); k < skv_end_of_partners(f, i); k++) {
            int j = skv_partner(f, k);
            skv_pair pair;
            if (f->mass[i] == f->mass[j] || !skv_pair_of(f, i, j, &pair) || 1 - pair.q > reach)
                continue;
            /* Above 0 where i is the heavier one, then where the lighter one lies below. */
            double heavier = skv_max(f->mass[i], f->mass[j]);
            double contrast = all * (f->mass[i] - f->mass[j]) / heavier;
            contrast = skv_min(skv_max(contrast, -1), 1);
            double below = contrast * (pair.ux * f->gravity_x + pair.uy * f->gravity_y);
            double turn = most * skv_max(below, 0) * (1 - (1 - pair.q) / reach);
            turn *=
                skv_min(f->mass[i], f->mass[j]) * (double)skv_turn_sense((uint32_t)i, (uint32_t)j);
            f->dx[i] += turn * pair.uy;
            f->dy[i] -= turn * pair.ux;
        }
    }
}

void skv_pass_push(skv_reference *f)
{
    const double half = (double)f->constants->dt * (double)f->constants->dt / 2;
    for (int i = 0; i < f->count; i++) {
        const double own = (double)f->liquids[f->fluid[i]].interface_push;
        for (int k = skv_first_partner(f, i); k < skv_end_of_partners(f, i); k++) {
            int j = skv_partner(f, k);
            skv_pair pair;
            if (f->fluid[i] == f->fluid[j] || !skv_pair_of(f, i, j, &pair))
                continue;
            double strength = skv_max(own, (double)f->liquids[f->fluid[j]].interface_push);
            double push = half * strength * skv_min(f->mass[i], f->mass[j]) *
                          skv_kernel_force(SKV_KERNEL_SMOOTH, pair.q);
            f->dx[i] -= push * pair.ux;
            f->dy[i] -= push * pair.uy;
        }
    }
}

void skv_pass_velocity(skv_reference *f)
{
    const double dt = (double)f->constants->dt;
    for (int i = 0; i < f->count; i++) {
        f->vx[i] = f->moved_x[i] / dt;
        f->vy[i] = f->moved_y[i] / dt;
    }
}
