/* Velocities: external forces, pair viscosity, the clamp before the advance, the update after it.
 * Invariant: pair viscosity reads velocities that no particle of the pass writes, so each pair's
 * two impulses are exactly opposite and momentum is kept. */
#include "solver/reference/pair.h"
#include "solver/reference/passes.h"

#include <math.h>

void skv_pass_external_forces(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    float ax = c->dt * sub->gravity_x, ay = c->dt * sub->gravity_y;
    for (int i = begin; i < end; i++) {
        s->vx[i] += ax;
        s->vy[i] += ay;
        skv_apply_external_forces(sub->forces, sub->force_count, s->x[i], s->y[i], &s->vx[i],
                                  &s->vy[i]);
    }
}

void skv_pass_viscosity(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    const skv_neighbours *n = sub->neighbours;
    const float most = SKV_MOST_VISCOUS * c->inv_dt;
    for (int i = begin; i < end; i++) {
        float sum_x = 0, sum_y = 0;
        for (int k = n->start[i]; k < n->start[i + 1]; k++) {
            int j = n->list[k];
            skv_pair pair;
            if (!skv_pair_apart(c, s->x[j] - s->x[i], s->y[j] - s->y[i], s->id[i], s->id[j], &pair))
                continue;
            float u = (s->vx[i] - s->vx[j]) * pair.ux + (s->vy[i] - s->vy[j]) * pair.uy;
            if (!(u > 0))
                continue;
            float rate = c->viscosity_linear + c->viscosity_quadratic * u;
            float impulse = 0.5f * (c->dt * pair.q * (rate < most ? rate : most)) * u;
            sum_x -= impulse * pair.ux;
            sum_y -= impulse * pair.uy;
        }
        s->dx[i] = sum_x;
        s->dy[i] = sum_y;
    }
}

void skv_pass_apply_viscosity(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    for (int i = begin; i < end; i++) {
        s->vx[i] += s->dx[i];
        s->vy[i] += s->dy[i];
    }
}

void skv_pass_predict(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    float limit = c->max_speed * c->max_speed;
    for (int i = begin; i < end; i++) {
        float speed_squared = s->vx[i] * s->vx[i] + s->vy[i] * s->vy[i];
        if (speed_squared > limit) {
            float scale = c->max_speed / sqrtf(speed_squared);
            s->vx[i] *= scale;
            s->vy[i] *= scale;
        }
        s->dx[i] = c->dt * s->vx[i];
        s->dy[i] = c->dt * s->vy[i];
        s->wx[i] = 0;
        s->wy[i] = 0;
        s->pressure[i] = 0;
    }
}

void skv_pass_lag(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    const float rise = c->lag_rise * c->inv_dt * c->inv_dt;
    for (int i = begin; i < end; i++) {
        float way_x = c->dt * s->vx[i] + s->wx[i], way_y = c->dt * s->vy[i] + s->wy[i];
        float square = (way_x * way_x + way_y * way_y) * rise;
        float lag = c->pair_lag * (square < 1 ? square : 1);
        s->behind_x[i] = lag * way_x;
        s->behind_y[i] = lag * way_y;
    }
}

void skv_pass_update_velocity(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    for (int i = begin; i < end; i++) {
        s->vx[i] += s->wx[i] * c->inv_dt;
        s->vy[i] += s->wy[i] * c->inv_dt;
    }
}
