/* The pressure laws of the rows: P, N and the gradient of the tension from what the density has
 * summed up, and the gauge pressure. Included by kernels.c alone. Invariant: what is here reads and
 * writes a particle's own elements only, eight at a time.
 */
#ifndef SKV_ROW_PRESSURE_LAWS_H
#define SKV_ROW_PRESSURE_LAWS_H

#include "solver/rows/pair_density.h"
#include "solver/wall_image.h"

#include <limits.h>

/* What a row's particles have collected. */
V8_INLINE v8 collected(const float *own, const float *next)
{
    return v8_add(v8_load(own), v8_load(next));
}

/* A row of which no eight is known to have a gradient. */
V8_INLINE void begin_graded(const skv_rows *s, int row)
{
    s->graded_begin[row] = INT_MAX;
    s->graded_end[row] = 0;
}

/* Notes whether the next eight of a row may have a gradient. */
V8_INLINE void note_graded(const skv_rows *s, int row, int eight, bool graded)
{
    s->graded[eight] = graded;
    if (!graded)
        return;
    if (s->graded_begin[row] > eight)
        s->graded_begin[row] = eight;
    s->graded_end[row] = eight + 1;
}

/* With masses a quantity of eight particles at i that goes with their mass, per mass. */
V8_INLINE v8 per_mass(const skv_rows *s, int i, v8 a)
{
    return skv_is_massive(s) ? v8_mul(a, v8_load(s->set[s->current].lightness + i)) : a;
}

/* And what is per mass, of theirs. */
V8_INLINE v8 of_mass(const skv_rows *s, int i, v8 a)
{
    return skv_is_massive(s) ? v8_div(a, v8_load(s->set[s->current].lightness + i)) : a;
}

/* Finds the mean mass of a row's particles and what is around each from the sums of lightness,
 * which those of walls have entered: the reciprocal of the mean lightness, weighted with the near
 * density. In the sums' place, as the lightness. */
static void find_mean_masses(const skv_rows *s, int row)
{
    const v8 itself = v8_set(SKV_OWN_WEIGHT);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 sum = collected(s->own.lightness + i, s->next.lightness + i);
        v8 weight = v8_add(collected(s->own.near_density + i, s->next.near_density + i), itself);
        v8_store(s->mean_lightness + i, v8_div(v8_add(sum, per_mass(s, i, itself)), weight));
    }
}

/* What is per mass, of the mean mass. */
V8_INLINE v8 of_mean_mass(const skv_rows *s, int i, v8 a)
{
    return skv_is_massive(s) ? v8_div(a, v8_load(s->mean_lightness + i)) : a;
}

/* What is of the constants' cohesion, of that of the fluids of eight particles at i in a row. */
V8_INLINE v8 of_cohesion(const skv_rows *s, int row, int i, v8 a)
{
    return skv_has_cohesions(s) ? v8_mul(a, cohesions(s, row, i)) : a;
}

/* The gradient that the row's particles have collected, for the tension: what exceeds the
 * unevenness of the bulk, which fades with what has pressed them in the last substep. Of the mean
 * mass, and of the fluid's cohesion. In the sums' place; notes of each eight whether one has any,
 * and where they are. */
static void keep_gradient(const skv_rows *s, int row, const skv_constants *c)
{
    const v8 zero = v8_set(0), one = v8_set(1), tiny = v8_set(TINY_SQUARED);
    const v8 bulk = v8_set(c->tension_from), until = v8_set(c->tension_until);
    const float *warm_lambda = s->set[s->current].warm_lambda;
    begin_graded(s, row);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        const int eight = i / ROW_LANES;
        v8 gx = zero, gy = zero, share = zero;
        if (s->graded[eight]) {
            gx = collected(s->own.gradient_x + i, s->next.gradient_x + i);
            gy = collected(s->own.gradient_y + i, s->next.gradient_y + i);
            v8 size = v8_sqrt(v8_max(v8_add(v8_mul(gx, gx), v8_mul(gy, gy)), tiny));
            v8 pressed = v8_div(per_mass(s, i, v8_load(warm_lambda + i)), until);
            v8 loose = v8_max(v8_sub(one, pressed), zero);
            share = v8_mul(v8_div(v8_max(v8_sub(size, bulk), zero), size), loose);
        }
        note_graded(s, row, eight, v8_any_below(zero, share));
        share = of_cohesion(s, row, i, share);
        v8_store(s->gradient_x + i, of_mean_mass(s, i, v8_mul(share, gx)));
        v8_store(s->gradient_y + i, of_mean_mass(s, i, v8_mul(share, gy)));
    }
}

/* The pressure term's P of eight particles at i, which remember it. Of the first iteration's a part
 * is the last substep's, where the density is too high anyway. */
V8_INLINE v8 warm_lambda(const skv_rows *s, int i, bool later, const skv_constants *c, v8 excess,
                         v8 response)
{
    float *remembered = s->set[s->current].warm_lambda + i;
    v8 before = v8_load(remembered),
       lambda = v8_div(v8_mul(v8_set(c->lambda_scale), excess), response);
    lambda = of_mean_mass(s, i, lambda);
    if (later) {
        v8_store(remembered, v8_add(before, lambda));
    } else {
        v8 most = of_mass(s, i, v8_set(c->warm_limit));
        v8 start = v8_mul(v8_set(c->warm_start), v8_min(before, most));
        lambda = v8_add(lambda, v8_min(start, v8_mul(v8_set(c->warm_most), lambda)));
        v8_store(remembered, lambda);
    }
    return lambda;
}

static void pressure_calibrated(const skv_rows *s, int row, bool later, const skv_constants *c)
{
    const v8 zero = v8_set(0), one = v8_set(1), rest = v8_set(c->rest_density);
    const v8 answer = v8_set(c->response_slope), floor = v8_set(c->response_floor);
    const v8 from = v8_set(c->cohesion_from), slope = v8_set(c->cohesion_slope);
    const v8 below = v8_set(c->cohesion_below), share = v8_set(c->near_share);
    const v8 near_lambda = v8_set(c->near_lambda_scale);
    const v8 pull = v8_set(c->cohesion_scale), balance = v8_set(SKV_NEAR_WEIGHT * c->near_share);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 near_density = collected(s->own.near_density + i, s->next.near_density + i);
        v8 quartic = collected(s->own.density + i, s->next.density + i);
        v8 density = v8_sub(v8_mul(v8_set(SKV_SMOOTH_CUBES), near_density),
                            v8_mul(v8_set(SKV_SMOOTH_QUARTICS), quartic));
        v8 excess = v8_max(v8_sub(density, rest), zero);
        v8 missing = v8_max(v8_sub(below, density), zero);
        v8 crowded = v8_max(v8_sub(near_density, v8_mul(share, density)), zero);
        v8 close = v8_mul(near_lambda, crowded);
        v8 held = v8_min(v8_max(v8_mul(v8_sub(density, from), slope), zero), one);
        v8 response = v8_max(v8_mul(answer, density), floor);
        v8 own = of_cohesion(s, row, i, pull);
        v8 pulled = v8_add(v8_mul(own, v8_mul(held, missing)), v8_mul(balance, close));
        v8 lambda = warm_lambda(s, i, later, c, excess, response);
        lambda = v8_sub(lambda, of_mean_mass(s, i, v8_div(pulled, response)));
        v8_store(s->lambda + i, lambda);
        v8_store(s->near_lambda + i, of_mean_mass(s, i, v8_div(close, response)));
    }
}

static void pressure_clavet(const skv_rows *s, int row, const skv_constants *c)
{
    const v8 one = v8_set(1), rest = v8_set(c->rest_density), limit = v8_set(c->lambda_limit);
    const v8 lambda = v8_set(c->lambda_scale), near_lambda = v8_set(c->near_lambda_scale);
    const v8 tiny = v8_set(1e-30f);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 density = collected(s->own.density + i, s->next.density + i);
        v8 near_density = collected(s->own.near_density + i, s->next.near_density + i);
        v8 n = v8_mul(near_lambda, near_density);
        v8 strength = v8_max(v8_mul(density, n), tiny);
        v8 scale = v8_min(v8_div(limit, strength), one);
        v8 pressed = v8_mul(scale, v8_mul(lambda, v8_sub(density, rest)));
        v8_store(s->lambda + i, of_mean_mass(s, i, pressed));
        v8_store(s->near_lambda + i, of_mean_mass(s, i, v8_mul(scale, n)));
    }
}

/* How dense eight particles at i are, to the lattice at rest, one's own W included: all virials go
 * with it. From what they push, since their densities are gone: P + 4 c N is the pressure alone, in
 * a later or a cold iteration lambda_scale (rho - rho0)/R, and R goes with rho. At least 1. */
static v8 relative_density(const skv_rows *s, int i, const skv_constants *c)
{
    const v8 scale = v8_set(c->response_slope / c->lambda_scale), one = v8_set(1);
    const v8 rest = v8_set(c->rest_density / (c->rest_density + 1));
    v8 lambda = v8_mul(v8_set(SKV_NEAR_WEIGHT * c->near_share), v8_load(s->near_lambda + i));
    lambda = v8_mul(scale, v8_add(lambda, v8_load(s->lambda + i)));
    if (skv_is_massive(s))
        lambda = v8_mul(lambda, v8_load(s->mean_lightness + i));
    v8 excess =
        v8_min(v8_max(lambda, v8_set(0)), v8_set(1 - 1 / SKV_DENSEST)); /* (rho - rho0)/rho */
    return v8_add(one, v8_mul(rest, v8_div(excess, v8_sub(one, excess))));
}

/* Gauge pressure from the virial of the pairs, summed over the iterations. Fluid and images are one
 * body, so beside walls by images it is what the bulk has at such a P and N, and as dense as the
 * last iteration finds it. */
static void gauge(const skv_rows *s, int row, int iteration, const skv_constants *c)
{
    const v8 scale = v8_set(c->pressure_scale), zero = v8_set(0);
    const v8 virial = v8_set(c->image_virial), near_virial = v8_set(c->image_near_virial);
    const float *own = s->own_move.outward, *next = s->next_move.outward;
    const bool last = iteration == c->iterations - 1;
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 before = iteration ? v8_load(s->pressure + i) : zero;
        v8 found = collected(own + i, next + i), full = v8_set(1);
        if (c->images) {
            v8 beside = v8_add(v8_mul(virial, v8_load(s->lambda + i)),
                               v8_mul(near_virial, v8_load(s->near_lambda + i)));
            v8 far = v8_sub(v8_load(s->image + i), v8_set(1));
            far = v8_min(v8_max(far, zero), v8_set(1));
            found = v8_add(beside, v8_mul(far, v8_sub(found, beside)));
            if (last)
                full = v8_add(v8_mul(v8_sub(full, far), relative_density(s, i, c)), far);
        }
        v8_store(s->pressure + i, v8_mul(full, v8_add(before, v8_mul(scale, found))));
    }
}

#endif
