/* Force fields: what may be one, and what it does. Invariant: every force of a world is checked. */
#include "world/forces.h"

#include "base/exact.h"
#include "base/fields.h"
#include "world/area.h"
#include "world/world_internal.h"

#include <math.h>
#include <stddef.h>

/* The numbers of a force beside its area. */
static const struct {
    const char *name, *unit;
    size_t offset;
    double least, most;
} numbers[] = {
#define FORCE_NUMBER(id, member, unit, least, most, help)                                          \
    {#member, unit, offsetof(skv_force, member), least, most},
#include "world/force_rows.h"
};
enum { NUMBERS = sizeof numbers / sizeof *numbers, MOST_REACH = 1000 };

static float *number_of(skv_force *force, int k)
{
    return (float *)(void *)((char *)force + numbers[k].offset);
}

/* Half the diagonal of an area's box, m: how far fluid may be from its middle. */
static float reach_of(const skv_area *area)
{
    skv_region r = skv_area_region(area);
    float x = r.x1 - r.x0, y = r.y1 - r.y0;
    return sqrtf(x * x + y * y) / 2;
}

static skv_result check_force(skv_force force, int index, skv_error *error)
{
    if (!skv_area_is_sane(&force.area))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "force %d: its area is none: not finite, or a polygon of less than 3 "
                        "corners",
                        index);
    for (int k = 0; k < NUMBERS; k++) {
        double value = (double)*number_of(&force, k);
        if (!skv_within(value, numbers[k].least, numbers[k].most)) {
            char text[32];
            skv_format_float(value, text);
            return skv_fail(
                error, SKV_ERROR_VALUE, "force %d: %s %s is out of range; allowed is %g..%g %s",
                index, numbers[k].name, text, numbers[k].least, numbers[k].most, numbers[k].unit);
        }
    }
    if (force.spin != 0 && !(reach_of(&force.area) <= MOST_REACH))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "force %d: its area is too large for a spin; at most %d m are allowed",
                        index, MOST_REACH);
    return SKV_OK;
}

skv_result skv_check_forces(const skv_force *forces, int count, skv_error *error)
{
    if (count < 0 || count > SKV_MAX_FORCES)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d forces; allowed is 0..%d", count,
                        SKV_MAX_FORCES);
    skv_result result = SKV_OK;
    for (int i = 0; i < count && result == SKV_OK; i++)
        result = check_force(forces[i], i, error);
    return result;
}

skv_external_force skv_field_force(const skv_force *force, float h, float dt)
{
    skv_external_force seen = {
        .field = true,
        .region = skv_area_region(&force->area),
        .unit = 1,
        .x = force->toward_x,
        .y = force->toward_y,
        .softness = h * h,
        .attraction = dt * force->attraction,
        .gain_x = dt * force->ax,
        .gain_y = dt * force->ay,
        .vx = force->wind_x,
        .vy = force->wind_y,
        .follow = skv_minf(1, dt * force->drag), /* more would overshoot the wind */
    };
    if (force->spin != 0) {
        seen.spin = force->spin;
        seen.middle_x = (seen.region.x0 + seen.region.x1) / 2;
        seen.middle_y = (seen.region.y0 + seen.region.y1) / 2;
    }
    return seen;
}

static float length(float x, float y)
{
    return sqrtf(x * x + y * y);
}

float skv_force_strength(const skv_force *f)
{
    float wind = length(f->wind_x, f->wind_y);
    if (f->spin != 0)
        wind += fabsf(f->spin) * reach_of(&f->area);
    return length(f->ax, f->ay) + fabsf(f->attraction) + f->drag * wind;
}

void skv_exchange_force(skv_port *port, skv_force *force)
{
    skv_exchange_area(port, &force->area);
    for (int k = 0; k < NUMBERS; k++)
        skv_exchange_float(port, number_of(force, k));
}

skv_result skv_exchange_forces(skv_port *port, skv_acting *acting, skv_error *error)
{
    if (!skv_exchange_count(port, &acting->force_count, SKV_MAX_FORCES))
        return skv_fail(error, SKV_ERROR_LIMIT, "snapshot: it has too many forces");
    for (int i = 0; i < acting->force_count; i++)
        skv_exchange_force(port, &acting->forces[i]);
    return skv_check_forces(acting->forces, acting->force_count, error);
}
