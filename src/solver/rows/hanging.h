/* What hangs from a wall, and how much of the wall's pull it is let fall from. Included by
 * kernels.c alone. Invariant: what rests below a surface keeps all of the pull.
 */
#ifndef SKV_ROW_HANGING_H
#define SKV_ROW_HANGING_H

#include "solver/rows/tiles.h"

/* Below this square gravity counts as none, h a substep squared. */
#define SKV_NO_GRAVITY_SQUARED 1e-30f

/* Cohesions of the fluids of eight particles at i in a row, over the constants'; of dummies that.
 * One function: rarely needed. */
static __attribute__((noinline)) v8 cohesions(const skv_rows *s, int row, int i)
{
    const int *number = s->set[s->current].number;
    const skv_solver_particles *p = s->frame->particles;
    float each[ROW_LANES];
    for (int l = 0; l < ROW_LANES; l++)
        each[l] = i + l < s->row_end[row] ? p->cohesion[p->fluid[number[i + l] & ~ROW_HELD]] : 1;
    return v8_load(each);
}

/* One function: it is long, and rarely needed. */
static __attribute__((noinline)) void add_forces(const skv_rows *s, float x, float y, float *u,
                                                 float *v)
{
    skv_apply_external_forces(s->acting.forces, s->acting.force_count, x, y, u, v);
}

/* What fluid gains in a substep that rests where a particle is. */
V8_INLINE void find_fall(const skv_rows *s, int i, float *gx, float *gy)
{
    const skv_row_particles *p = &s->set[s->current];
    *gx = *gy = 0;
    if (s->acting.force_count > 0)
        add_forces(s, p->x[i], p->y[i], gx, gy);
    *gx += s->acting.gravity_x;
    *gy += s->acting.gravity_y;
}

/* How much of a wall's pull each particle is let fall from: all of it where it hangs, none where it
 * rests below a surface, or water would be driven along walls that lean over it. It hangs if what
 * its gradient exceeds the bulk's unevenness by points against what has it fall; from twice that
 * unevenness on wholly. Rises smoothly, so rounding decides nothing. In the gradient's place, which
 * has been read; where there is none it is 0 already. */
static void find_hanging(const skv_rows *s, int row, const skv_constants *c)
{
    const v8 zero = v8_set(0), one = v8_set(1), tiny = v8_set(SKV_NO_GRAVITY_SQUARED);
    const v8 bulk = v8_set(c->tension_from);
    const int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        if (!s->graded[i / ROW_LANES])
            continue;
        float fall_x[ROW_LANES] = {0}, fall_y[ROW_LANES] = {0};
        for (int l = 0; l < ROW_LANES && i + l < end; l++)
            find_fall(s, i + l, &fall_x[l], &fall_y[l]);
        v8 x = v8_load(fall_x), y = v8_load(fall_y);
        v8 size = v8_sqrt(v8_max(v8_add(v8_mul(x, x), v8_mul(y, y)), tiny));
        v8 down =
            v8_add(v8_mul(v8_load(s->gradient_x + i), x), v8_mul(v8_load(s->gradient_y + i), y));
        if (skv_is_massive(s)) /* gradients are of the mean mass */
            down = v8_mul(down, v8_load(s->mean_lightness + i));
        if (skv_has_cohesions(s)) /* and of their fluids' cohesion */
            down = v8_div(down, cohesions(s, row, i));
        v8 up = v8_div(v8_sub(zero, down), v8_mul(size, bulk));
        v8_store(s->hanging + i, v8_min(v8_max(up, zero), one));
    }
}

/* Takes from a wall's pull a share of what would hold a particle up against (gx, gy), the direction
 * in which external forces would have it fall, or drops would hang from ceilings for ever. (nx, ny)
 * points out of the wall. Leaving out all of the pull heats the fluid where its surface meets a
 * wall, since it has no energy then. */
V8_INLINE void let_fall(float gx, float gy, float nx, float ny, float share, float *x, float *y)
{
    float down = *x * gx + *y * gy, square = gx * gx + gy * gy;
    if (*x * nx + *y * ny < 0 && down < 0 && square > SKV_NO_GRAVITY_SQUARED) {
        float taken = share * (down / square);
        *x -= taken * gx;
        *y -= taken * gy;
    }
}

#endif
