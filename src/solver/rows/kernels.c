/* The kernels of the rows: one source for every instruction set.
 *
 * Compiled several times, each with the flags of one instruction set and SKV_ROW_KERNELS naming the
 * table it defines. Invariant: a lane does the same IEEE operations in the same order in each of
 * them, and sums are added up in a fixed order; so all tables give the same bits.
 * Here are the passes over single particles; those over pairs are in pair_passes.h.
 */
#include "solver/rows/pair_passes.h"
#include "solver/wall_push.h"

/* What a row's particles have collected. */
V8_INLINE v8 collected(const float *own, const float *next)
{
    return v8_add(v8_load(own), v8_load(next));
}

/* Adds the walls' share to particles near one, and keeps the samples for the update. */
static void sample_walls(const skv_rows *s, int row, bool gradient, const skv_boundary *boundary,
                         skv_row_samples *samples)
{
    const skv_row_particles *p = &s->set[s->current];
    const skv_row_sums *own = &s->own;
    int used = 0;
    for (int i = s->row_start[row]; i < s->row_end[row]; i++) {
        if (p->clearance[i] >= 1)
            continue;
        skv_wall_sample wall;
        p->clearance[i] = skv_boundary_sample(boundary, p->x[i], p->y[i], &wall);
        /* As add_wall_push will see it, if it has to sample again. */
        if (p->clearance[i] >= 1)
            continue;
        own->density[i] += wall.r;
        own->near_density[i] += wall.rn;
        if (gradient) {
            own->gradient_x[i] -= wall.f1x;
            own->gradient_y[i] -= wall.f1y;
        }
        if (used < samples->room)
            samples->sample[used] = (skv_near_wall){i, wall};
        used++;
    }
    samples->used = used <= samples->room ? used : -1;
}

/* The gradient that the row's particles have collected, for the tension: what exceeds the
 * unevenness of the bulk, times the tension's strength. In the sums' place. */
static void keep_gradient(const skv_rows *s, int row, const skv_row_constants *c)
{
    const v8 zero = v8_set(0), scale = v8_set(c->tension_scale), bulk = v8_set(c->tension_from);
    const v8 tiny = v8_set(TINY_SQUARED);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 gx = collected(s->own.gradient_x + i, s->next.gradient_x + i);
        v8 gy = collected(s->own.gradient_y + i, s->next.gradient_y + i);
        v8 size = v8_sqrt(v8_max(v8_add(v8_mul(gx, gx), v8_mul(gy, gy)), tiny));
        v8 share = v8_div(v8_mul(scale, v8_max(v8_sub(size, bulk), zero)), size);
        v8_store(s->gradient_x + i, v8_mul(share, gx));
        v8_store(s->gradient_y + i, v8_mul(share, gy));
    }
}

/* The pressure term's P of eight particles at i, which remember it. Of the first iteration's a part
 * is the last substep's, where the density is too high anyway. */
V8_INLINE v8 warm_push(const skv_rows *s, int i, bool later, const skv_row_constants *c, v8 excess,
                       v8 response)
{
    float *remembered = s->set[s->current].warm_push + i;
    v8 before = v8_load(remembered), push = v8_div(v8_mul(v8_set(c->push_scale), excess), response);
    if (later) {
        v8_store(remembered, v8_add(before, push));
    } else {
        v8 share = v8_min(v8_mul(v8_set(c->warm_slope), excess), v8_set(1));
        v8 start = v8_mul(v8_set(c->warm_start), v8_min(before, v8_set(c->warm_limit)));
        push = v8_add(push, v8_mul(share, start));
        v8_store(remembered, push);
    }
    return push;
}

static void pressure_calibrated(const skv_rows *s, int row, bool later, const skv_row_constants *c)
{
    const v8 zero = v8_set(0), one = v8_set(1), rest = v8_set(c->rest_density);
    const v8 answer = v8_set(c->response_slope), floor = v8_set(c->response_floor);
    const v8 from = v8_set(c->cohesion_from), slope = v8_set(c->cohesion_slope);
    const v8 below = v8_set(c->cohesion_below), share = v8_set(c->near_share);
    const v8 near_push = v8_set(c->near_push_scale);
    const v8 pull = v8_set(c->cohesion_scale), balance = v8_set(4 * c->near_share);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 density = collected(s->own.density + i, s->next.density + i);
        v8 near_density = collected(s->own.near_density + i, s->next.near_density + i);
        v8 excess = v8_max(v8_sub(density, rest), zero);
        v8 missing = v8_max(v8_sub(below, density), zero);
        v8 crowded = v8_max(v8_sub(near_density, v8_mul(share, density)), zero);
        v8 close = v8_mul(near_push, crowded);
        v8 held = v8_min(v8_max(v8_mul(v8_sub(density, from), slope), zero), one);
        v8 response = v8_max(v8_mul(answer, density), floor);
        v8 pulled = v8_add(v8_mul(pull, v8_mul(held, missing)), v8_mul(balance, close));
        v8 push = warm_push(s, i, later, c, excess, response);
        v8_store(s->push + i, v8_sub(push, v8_div(pulled, response)));
        v8_store(s->near_push + i, v8_div(close, response));
    }
}

static void pressure_clavet(const skv_rows *s, int row, const skv_row_constants *c)
{
    const v8 one = v8_set(1), rest = v8_set(c->rest_density), limit = v8_set(c->push_limit);
    const v8 push = v8_set(c->push_scale), near_push = v8_set(c->near_push_scale);
    const v8 tiny = v8_set(1e-30f);
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 density = collected(s->own.density + i, s->next.density + i);
        v8 near_density = collected(s->own.near_density + i, s->next.near_density + i);
        v8 n = v8_mul(near_push, near_density);
        v8 strength = v8_max(v8_mul(density, n), tiny);
        v8 scale = v8_min(v8_div(limit, strength), one);
        v8_store(s->push + i, v8_mul(scale, v8_mul(push, v8_sub(density, rest))));
        v8_store(s->near_push + i, v8_mul(scale, n));
    }
}

static void pressure(const skv_rows *s, int row, bool later, const skv_row_constants *c,
                     const skv_boundary *boundary, skv_row_samples *samples)
{
    bool graded = !c->clavet && !later;
    sample_walls(s, row, graded, boundary, samples);
    if (c->clavet)
        pressure_clavet(s, row, c);
    else
        pressure_calibrated(s, row, later, c);
    if (graded)
        keep_gradient(s, row, c);
}

/* Gauge pressure from the virial of the pairs and the walls, summed over the iterations. */
static void gauge(const skv_rows *s, int row, int iteration, const skv_row_constants *c)
{
    const v8 scale = v8_set(c->pressure_scale), zero = v8_set(0);
    const float *own = s->own_move.virial, *next = s->next_move.virial;
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 before = iteration ? v8_load(s->pressure + i) : zero;
        v8_store(s->pressure + i, v8_add(before, v8_mul(scale, collected(own + i, next + i))));
    }
}

/* Friction along the wall and push out of it, Algorithm 7. */
static void touch_walls(const skv_rows *s, int row, const skv_row_constants *c,
                        const skv_boundary *boundary, skv_impulse_sum *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    for (int i = s->row_start[row]; i < s->row_end[row]; i++) {
        if (p->clearance[i] >= c->contact_distance || p->number[i] & ROW_HELD)
            continue;
        float nx, ny;
        float depth = skv_boundary_contact(boundary, p->x[i], p->y[i], &nx, &ny, &p->clearance[i]);
        if (!(depth > 0))
            continue;
        /* u, v already hold the whole displacement of the substep. */
        float slide = p->v[i] * nx - p->u[i] * ny;
        float rub = c->friction * slide, push = c->softness * depth;
        float dx = push * nx + rub * ny, dy = push * ny - rub * nx;
        float made = skv_boundary_move(boundary, &p->x[i], &p->y[i], dx, dy, &p->clearance[i]);
        p->u[i] += made * dx;
        p->v[i] += made * dy;
        skv_impulse_give(walls, p->x[i], p->y[i], made * dx, made * dy);
    }
}

V8_INLINE void add_push(const skv_rows *s, int i, const skv_row_constants *c,
                        const skv_wall_sample *wall, skv_impulse *given)
{
    const skv_row_particles *p = &s->set[s->current];
    float dx, dy;
    skv_wall_push(s->push[i], s->near_push[i], wall->f1x, wall->f1y, wall->f2x, wall->f2y,
                  c->gravity_x, c->gravity_y, c->loose_push, &dx, &dy);
    s->own_move.x[i] += dx;
    s->own_move.y[i] += dy;
    if (!(p->number[i] & ROW_HELD)) {
        given->x += (double)dx;
        given->y += (double)dy;
        given->moment += (double)(p->x[i] * dy - p->y[i] * dx);
    }
    /* The virial of a smooth solid: n0 int r F in terms of h R, n0 int r q^2 about 2/3 h Rn. */
    if (s->gauged)
        s->own_move.virial[i] +=
            c->wall_virial * s->push[i] * wall->r + 2.0f / 3 * s->near_push[i] * wall->rn;
}

/* Adds the walls' push to a row's displacement, from the samples of the pressure pass; where those
 * found no place they are taken again. */
static void add_wall_push(const skv_rows *s, int row, const skv_row_constants *c,
                          const skv_boundary *boundary, const skv_row_samples *samples,
                          skv_impulse_sum *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    skv_impulse given = {0};
    for (int w = 0; w < samples->used; w++)
        add_push(s, samples->sample[w].particle, c, &samples->sample[w].wall, &given);
    for (int i = s->row_start[row]; samples->used < 0 && i < s->row_end[row]; i++) {
        skv_wall_sample wall;
        if (p->clearance[i] >= 1)
            continue;
        skv_boundary_sample(boundary, p->x[i], p->y[i], &wall);
        add_push(s, i, c, &wall, &given);
    }
    skv_impulse_add(walls, given.x, given.y, given.moment);
}

/* Zeroes the lanes of those of the eight particles at i that are held. */
V8_INLINE v8 unless_held(const int *numbers, v8 a)
{
    int32_t free[ROW_LANES];
    for (int l = 0; l < ROW_LANES; l++)
        free[l] = numbers[l] & ROW_HELD ? 0 : -1;
    return v8_and(a, v8_load((const float *)(const void *)free));
}

/* Moves the eight particles at i; those whose way may meet a wall one by one. With `speed` the move
 * is a correction and changes the velocity; without, it is the advance. */
V8_INLINE void move_eight(const skv_rows *s, int i, int end, v8 dx, v8 dy, bool speed,
                          const skv_row_constants *c, const skv_boundary *boundary,
                          skv_impulse_sum *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    v8 length = v8_sqrt(v8_add(v8_mul(dx, dx), v8_mul(dy, dy)));
    v8 clear = v8_sub(v8_load(p->clearance + i), v8_mul(v8_set(ROW_WALL_SLOPE), length));
    if (!v8_any_below(clear, v8_set(c->wall_clearance))) {
        v8_store(p->clearance + i, clear);
        v8_store(p->x + i, v8_add(v8_load(p->x + i), dx));
        v8_store(p->y + i, v8_add(v8_load(p->y + i), dy));
        if (speed) {
            v8_store(p->u + i, v8_add(v8_load(p->u + i), dx));
            v8_store(p->v + i, v8_add(v8_load(p->v + i), dy));
        }
        return;
    }
    float move_x[ROW_LANES], move_y[ROW_LANES], left[ROW_LANES];
    v8_store(left, clear);
    v8_store(move_x, dx);
    v8_store(move_y, dy);
    for (int l = 0; l < ROW_LANES && i + l < end; l++) {
        int k = i + l;
        float made = 1;
        if (left[l] < c->wall_clearance) {
            made = skv_boundary_move(boundary, &p->x[k], &p->y[k], move_x[l], move_y[l],
                                     &p->clearance[k]);
        } else {
            p->clearance[k] = left[l];
            p->x[k] += move_x[l];
            p->y[k] += move_y[l];
        }
        /* What a wall has cut off the advance leaves the velocity; a correction enters it as far as
         * it was made. */
        float share = speed ? made : made - 1;
        p->u[k] += share * move_x[l];
        p->v[k] += share * move_y[l];
        if (made < 1)
            skv_impulse_give(walls, p->x[k], p->y[k], (made - 1) * move_x[l],
                             (made - 1) * move_y[l]);
    }
}

static void update(const skv_rows *s, int row, int iteration, const skv_row_constants *c,
                   const skv_boundary *boundary, const skv_row_samples *samples,
                   skv_impulse_sum *walls)
{
    if (samples->used)
        add_wall_push(s, row, c, boundary, samples, walls);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8 dx = collected(s->own_move.x + i, s->next_move.x + i);
        v8 dy = collected(s->own_move.y + i, s->next_move.y + i);
        if (s->held) {
            const int *numbers = s->set[s->current].number + i;
            dx = unless_held(numbers, dx);
            dy = unless_held(numbers, dy);
        }
        move_eight(s, i, end, dx, dy, true, c, boundary, walls);
    }
    if (s->gauged) /* in the memory of what has been read above */
        gauge(s, row, iteration, c);
    if (iteration == c->iterations - 1)
        touch_walls(s, row, c, boundary, walls);
}

static void advance(const skv_rows *s, int row, const skv_row_constants *c,
                    const skv_boundary *boundary, skv_impulse_sum *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    const v8 gx = v8_set(c->gravity_x), gy = v8_set(c->gravity_y), one = v8_set(1);
    const v8 limit = v8_set(c->max_speed), tiny = v8_set(TINY_SQUARED);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8_store(p->u + i, v8_add(v8_load(p->u + i), gx));
        v8_store(p->v + i, v8_add(v8_load(p->v + i), gy));
    }
    for (int f = 0; f < c->pull_count; f++)
        for (int i = s->row_start[row]; i < end; i++)
            skv_pull_on(&c->pulls[f], p->x[i], p->y[i], &p->u[i], &p->v[i]);
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8 u = v8_load(p->u + i), v = v8_load(p->v + i);
        v8 speed = v8_sqrt(v8_max(v8_add(v8_mul(u, u), v8_mul(v, v)), tiny));
        v8 scale = v8_min(v8_div(limit, speed), one);
        u = v8_mul(u, scale);
        v = v8_mul(v, scale);
        if (s->held) {
            u = unless_held(p->number + i, u);
            v = unless_held(p->number + i, v);
        }
        v8_store(p->u + i, u);
        v8_store(p->v + i, v);
        move_eight(s, i, end, u, v, false, c, boundary, walls);
    }
}

const skv_row_kernels SKV_ROW_KERNELS = {
    V8_NAME, advance, density, pressure, displacement, update,
};
