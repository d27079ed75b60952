/* The hands that hold fluid. Invariant: every hand of a world has been checked. */
#include "world/hands.h"
#include "base/assert.h"
#include "base/exact.h"
#include "world/names.h"
#include "world/world_internal.h"

#include <string.h>

skv_hand skv_default_hand(void)
{
    return (skv_hand){.radius = 0.15f, .attraction = 60, .friction = 6, .follow = 6};
}

skv_result skv_check_hands(const skv_hand *hands, int count, skv_error *error)
{
    if (count < 0 || count > SKV_MAX_HANDS)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d hands; allowed is 0..%d", count, SKV_MAX_HANDS);
    for (int i = 0; i < count; i++) {
        const skv_hand *h = &hands[i];
        if (!skv_within((double)h->x, -1000, 1000) || !skv_within((double)h->y, -1000, 1000) ||
            !skv_within((double)h->vx, -1000, 1000) || !skv_within((double)h->vy, -1000, 1000))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "hand %d: position or velocity is not finite or beyond 1000 m or m/s",
                            i);
        if (!skv_within((double)h->radius, 1e-6, 100) ||
            !skv_within((double)h->attraction, -10000, 10000) ||
            !skv_within((double)h->friction, 0, 10000) || !skv_within((double)h->follow, 0, 10000))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "hand %d: radius (0..100 m], attraction +-10000 m/s^2, friction and "
                            "follow 0..10000 1/s are allowed",
                            i);
        if (!skv_within((double)h->at_x, -100, 100) || !skv_within((double)h->at_y, -100, 100))
            return skv_fail(error, SKV_ERROR_VALUE,
                            "hand %d: where it holds its body is not finite or beyond 100 m", i);
    }
    return SKV_OK;
}

skv_result skv_world_set_hands(skv_world *world, const skv_hand *hands, int count, skv_error *error)
{
    SKV_ASSERT_OR(skv_may_change(world) && (hands || count == 0), SKV_ERROR_VALUE);
    skv_result result = skv_check_hands(hands, count, error);
    if (result == SKV_OK)
        result = skv_acting_name(&world->acting, SKV_ACTING_HAND, count, error);
    if (result != SKV_OK)
        return result;
    if (count)
        memmove(world->acting.hands, hands, (size_t)count * sizeof *hands);
    world->acting.hand_count = count;
    return SKV_OK;
}

const skv_hand *skv_world_hands(const skv_world *world, int *count)
{
    SKV_ASSERT_OR(world && count, NULL);
    *count = world->acting.hand_count;
    return world->acting.hands;
}

skv_external_force skv_hand_force(const skv_hand *hand, float dt)
{
    return (skv_external_force){
        .x = hand->x,
        .y = hand->y,
        .vx = hand->vx,
        .vy = hand->vy,
        .inv_radius = 1 / hand->radius,
        .attraction = dt * hand->attraction,
        /* Half each at most: more than the whole velocity would turn it round. */
        .friction = skv_minf(0.5f, dt * hand->friction),
        .follow = skv_minf(0.5f, dt * hand->follow),
    };
}

static void exchange(skv_port *port, skv_hand *hand)
{
    float *const values[] = {&hand->x,      &hand->y,          &hand->vx,       &hand->vy,
                             &hand->radius, &hand->attraction, &hand->friction, &hand->follow};
    for (int i = 0; i < 8; i++)
        skv_exchange_float(port, values[i]);
}

skv_result skv_exchange_hands(skv_port *port, skv_acting *acting, skv_error *error)
{
    if (!skv_exchange_count(port, &acting->hand_count, SKV_MAX_HANDS))
        return skv_fail(error, SKV_ERROR_LIMIT, "snapshot: it has too many hands");
    for (int i = 0; i < acting->hand_count; i++)
        exchange(port, &acting->hands[i]);
    return skv_check_hands(acting->hands, acting->hand_count, error);
}
