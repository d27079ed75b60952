/* Contact with walls (Algorithm 7 with errata 7): friction along the wall, then a push out of the
 * contact distance. Invariant: a particle out of contact gets no displacement. */
#include "solver/passes.h"

#include <stddef.h>

void skv_pass_contact(skv_state *s, const skv_constants *c, int begin, int end)
{
    for (int i = begin; i < end; i++) {
        s->dx[i] = 0;
        s->dy[i] = 0;
        if (!(s->depth[i] > 0))
            continue;
        float tx = -s->normal_y[i], ty = s->normal_x[i];
        /* The particle's displacement in this substep so far, along the wall. */
        float slide = (s->wx[i] + c->dt * s->vx[i]) * tx + (s->wy[i] + c->dt * s->vy[i]) * ty;
        float rub = c->friction * slide, push = c->softness * s->depth[i];
        s->dx[i] = push * s->normal_x[i] - rub * tx;
        s->dy[i] = push * s->normal_y[i] - rub * ty;
    }
}
