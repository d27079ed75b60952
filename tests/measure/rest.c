/* A body of water at rest, put there by hand: positions and pressures that are known exactly. */
#include "rest.h"

#include "support/fixture.h"
#include "world/world_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

skv_world *rest_pool(float spacing, float depth)
{
    skv_world *world = fixture_tank(SKV_LAW_CALIBRATED, spacing, 1);
    /* A little off the wall: no row begins with a particle that is too close to it. */
    float x0 = 0.07f * spacing;
    assert_true(fixture_fill(world, x0, 0, 1.6f, depth) > 500);
    return world;
}

void rest_set_pressure(skv_world *world, double at_origin, double slope_x, double slope_y)
{
    skv_state *s = &world->state;
    for (int i = 0; i < s->count; i++)
        s->pressure[i] = (float)(at_origin + slope_x * (double)s->x[i] + slope_y * (double)s->y[i]);
}

void rest_set_velocity(skv_world *world, double centre_x, double centre_y, double spin,
                       double stretch)
{
    skv_state *s = &world->state;
    for (int i = 0; i < s->count; i++) {
        double dx = (double)s->x[i] - centre_x, dy = (double)s->y[i] - centre_y;
        s->vx[i] = (float)(-spin * dy + stretch * dx);
        s->vy[i] = (float)(spin * dx - stretch * dy);
    }
}

void rest_set_wave(skv_world *world, const float *still, double depth, double amplitude, double k,
                   double phase)
{
    skv_state *s = &world->state;
    for (int i = 0; i < s->count; i++) {
        double rise = amplitude * sin(k * (double)s->x[i] - phase);
        s->y[i] = (float)((double)still[i] * (1 + rise / depth));
    }
}

void rest_shift(skv_world *world, float dx, float dy, double seconds)
{
    skv_state *s = &world->state;
    for (int i = 0; i < s->count; i++) {
        s->x[i] += dx;
        s->y[i] += dy;
    }
    world->time += seconds;
}

void rest_remove(skv_world *world, int index)
{
    skv_state *s = &world->state;
    for (int i = index + 1; i < s->count; i++)
        skv_state_move(s, i, i - 1);
    s->count--;
}
