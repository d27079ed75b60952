/* What acts on the fluid, all kinds together: for the solver, and in snapshots. Invariant: what
 * skv_exchange_acting has read may be a world's. */
#include "world/acting.h"

#include "base/exact.h"
#include "world/area.h"
#include "world/emitters.h"
#include "world/forces.h"
#include "world/hands.h"

#include <math.h>

int skv_make_external_forces(const skv_acting *acting, float h, float dt,
                             skv_external_force forces[SKV_SOLVER_MOST_FORCES])
{
    int count = 0;
    for (int i = 0; i < acting->hand_count; i++)
        if (!acting->hands[i].body)
            forces[count++] = skv_hand_force(&acting->hands[i], dt);
    for (int i = 0; i < acting->force_count; i++)
        forces[count++] = skv_field_force(&acting->forces[i], h, dt);
    for (int i = 0; i < acting->emitter_count; i++)
        if (!acting->streams[i].pauses)
            skv_make_mouth_force(&acting->emitters[i], h, &forces[count++]);
    return count;
}

float skv_acting_strength(const skv_acting *acting)
{
    float sum = 0;
    for (int i = 0; i < acting->force_count; i++)
        sum += skv_force_strength(&acting->forces[i]);
    return sum;
}

float skv_emitted_head(const skv_acting *acting)
{
    float fastest = 0;
    for (int i = 0; i < acting->emitter_count; i++) {
        float speed = skv_emitter_speed(&acting->emitters[i]);
        fastest = skv_maxf(fastest, speed);
    }
    return fastest * fastest / 2;
}

float skv_acting_head(const skv_acting *acting, float width, float height)
{
    float head = 0;
    for (int i = 0; i < acting->force_count; i++) {
        const skv_force *force = &acting->forces[i];
        skv_region r = skv_area_region(&force->area);
        float x = skv_minf(r.x1, width) - skv_maxf(r.x0, 0);
        float y = skv_minf(r.y1, height) - skv_maxf(r.y0, 0);
        if (x > 0 && y > 0)
            head += skv_force_strength(force) * sqrtf(x * x + y * y);
    }
    return head + skv_emitted_head(acting);
}

skv_result skv_exchange_acting(skv_port *port, skv_acting *acting, int fluids, skv_error *error)
{
    skv_result result = skv_exchange_hands(port, acting, error);
    if (result == SKV_OK)
        result = skv_exchange_forces(port, acting, error);
    return result == SKV_OK ? skv_exchange_flow(port, acting, fluids, error) : result;
}
