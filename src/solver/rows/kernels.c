/* The kernels of the rows: one source for every instruction set.
 *
 * Compiled several times, each with the flags of one instruction set and SKV_ROW_KERNELS naming the
 * table it defines. Invariant: a lane does the same IEEE operations in the same order in each of
 * them, and sums are added up in a fixed order; so all tables give the same bits.
 * Here are the passes over single particles; those over pairs are in pair_passes.h.
 */
#include "solver/rows/pair_passes.h"
#include "solver/wall_push.h"

/* own + next + tile: what a row's particles have collected. */
V8_INLINE v8 collected(const float *own, const float *next, const float *in_tile)
{
    return v8_add(v8_add(v8_load(own), v8_load(next)), v8_load(in_tile));
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
 * unevenness of the bulk, times the tension's strength. */
static void keep_gradient(const skv_rows *s, int begin, int end, const skv_row_constants *c,
                          const skv_row_tile_sums *in_tile)
{
    const v8 zero = v8_set(0), scale = v8_set(c->tension_scale), bulk = v8_set(c->tension_from);
    const v8 tiny = v8_set(TINY_SQUARED);
    const skv_row_sums *own = &s->own, *next = &s->next, *tiled = &in_tile->sums;
    for (int i = begin, t = i - in_tile->begin; i < end; i += ROW_LANES, t += ROW_LANES) {
        v8 gx = collected(own->gradient_x + i, next->gradient_x + i, tiled->gradient_x + t);
        v8 gy = collected(own->gradient_y + i, next->gradient_y + i, tiled->gradient_y + t);
        v8 size = v8_sqrt(v8_max(v8_add(v8_mul(gx, gx), v8_mul(gy, gy)), tiny));
        v8 share = v8_div(v8_mul(scale, v8_max(v8_sub(size, bulk), zero)), size);
        v8_store(s->gradient_x + i, v8_mul(share, gx));
        v8_store(s->gradient_y + i, v8_mul(share, gy));
    }
}

/* Eight particles' densities. */
V8_INLINE void load_densities(const skv_rows *s, int i, const skv_row_tile_sums *in_tile,
                              v8 *density, v8 *near_density)
{
    const skv_row_sums *own = &s->own, *next = &s->next, *tiled = &in_tile->sums;
    int t = i - in_tile->begin;
    *density = collected(own->density + i, next->density + i, tiled->density + t);
    *near_density =
        collected(own->near_density + i, next->near_density + i, tiled->near_density + t);
}

static void pressure_calibrated(const skv_rows *s, int begin, int end, const skv_row_constants *c,
                                const skv_row_tile_sums *in_tile)
{
    const v8 zero = v8_set(0), one = v8_set(1), rest = v8_set(c->rest_density);
    const v8 answer = v8_set(c->response_slope), floor = v8_set(c->response_floor);
    const v8 from = v8_set(c->cohesion_from), slope = v8_set(c->cohesion_slope);
    const v8 below = v8_set(c->cohesion_below), share = v8_set(c->near_share);
    const v8 push = v8_set(c->push_scale), near_push = v8_set(c->near_push_scale);
    const v8 pull = v8_set(c->cohesion_scale), balance = v8_set(4 * c->near_share);
    for (int i = begin; i < end; i += ROW_LANES) {
        v8 density, near_density;
        load_densities(s, i, in_tile, &density, &near_density);
        v8 excess = v8_max(v8_sub(density, rest), zero);
        v8 missing = v8_max(v8_sub(below, density), zero);
        v8 crowded = v8_max(v8_sub(near_density, v8_mul(share, density)), zero);
        v8 close = v8_mul(near_push, crowded);
        v8 held = v8_min(v8_max(v8_mul(v8_sub(density, from), slope), zero), one);
        v8 response = v8_max(v8_mul(answer, density), floor);
        v8 size = v8_sub(v8_mul(push, excess), v8_mul(pull, v8_mul(held, missing)));
        size = v8_sub(size, v8_mul(balance, close));
        v8_store(s->push + i, v8_div(size, response));
        v8_store(s->near_push + i, v8_div(close, response));
    }
}

static void pressure_clavet(const skv_rows *s, int begin, int end, const skv_row_constants *c,
                            const skv_row_tile_sums *in_tile)
{
    const v8 one = v8_set(1), rest = v8_set(c->rest_density), limit = v8_set(c->push_limit);
    const v8 push = v8_set(c->push_scale), near_push = v8_set(c->near_push_scale);
    const v8 tiny = v8_set(1e-30f);
    for (int i = begin; i < end; i += ROW_LANES) {
        v8 density, near_density;
        load_densities(s, i, in_tile, &density, &near_density);
        v8 n = v8_mul(near_push, near_density);
        v8 strength = v8_max(v8_mul(density, n), tiny);
        v8 scale = v8_min(v8_div(limit, strength), one);
        v8_store(s->push + i, v8_mul(scale, v8_mul(push, v8_sub(density, rest))));
        v8_store(s->near_push + i, v8_mul(scale, n));
    }
}

/* Eight numbers to the particles' places in a frame's array, or from there; held ones have none. */
static void scatter(const skv_rows *s, float *to, int i, int end, v8 a)
{
    const int *number = s->set[s->current].number + i;
    float lane[ROW_LANES];
    v8_store(lane, a);
    for (int l = 0; l < ROW_LANES && i + l < end; l++)
        if (!(number[l] & ROW_HELD))
            to[number[l]] = lane[l];
}

static v8 gather(const skv_rows *s, const float *from, int i, int end)
{
    const int *number = s->set[s->current].number + i;
    float lane[ROW_LANES] = {0};
    for (int l = 0; l < ROW_LANES && i + l < end; l++)
        lane[l] = number[l] & ROW_HELD ? 0 : from[number[l]];
    return v8_load(lane);
}

/* Adds up what viscosity has found for the particles. */
static void keep_impulses(const skv_rows *s, int begin, int end, const skv_row_tile_sums *in_tile)
{
    const skv_row_sums *own = &s->own, *next = &s->next, *tiled = &in_tile->sums;
    for (int i = begin, t = i - in_tile->begin; i < end; i += ROW_LANES, t += ROW_LANES) {
        v8 u = collected(own->viscous_u + i, next->viscous_u + i, tiled->viscous_u + t);
        v8 v = collected(own->viscous_v + i, next->viscous_v + i, tiled->viscous_v + t);
        if (skv_rows_keep_tile_sums(s)) {
            scatter(s, s->impulse_u, i, end, u);
            scatter(s, s->impulse_v, i, end, v);
        } else {
            v8_store(s->impulse_u + i, u);
            v8_store(s->impulse_v + i, v);
        }
    }
}

/* What the sums of the particles at begin..end-1 amount to. Where pressures and gradients are
 * written, viscosity's sums may lie: those come first. */
static void add_up(const skv_rows *s, int begin, int end, bool later, const skv_row_constants *c,
                   const skv_row_tile_sums *in_tile)
{
    if (s->viscous && !later)
        keep_impulses(s, begin, end, in_tile);
    if (c->clavet)
        pressure_clavet(s, begin, end, c, in_tile);
    else
        pressure_calibrated(s, begin, end, c, in_tile);
    if (s->graded && !later)
        keep_gradient(s, begin, end, c, in_tile);
}

static void pressure(const skv_rows *s, int row, bool later, const skv_row_constants *c,
                     const skv_boundary *boundary, const skv_row_kept *kept,
                     skv_row_samples *samples)
{
    sample_walls(s, row, s->graded && !later, boundary, samples);
    int begin = s->row_start[row], end = s->row_end[row];
    if (kept->has_tile_sums) {
        bool by_row = skv_rows_keep_tile_sums(s) && !later;
        const skv_row_tile_sums in_tile = tile_sums(s, row, by_row ? SIX_SUMS : 0, kept);
        add_up(s, begin, end, later, c, &in_tile);
        return;
    }
    float memory[ROW_SUMS * ROW_LANES] = {0};
    skv_row_tile_sums again = {sums_at(memory, ROW_LANES), begin};
    for (; again.begin < end; again.begin += ROW_LANES) {
        int i = again.begin, to = i + ROW_LANES < end ? i + ROW_LANES : end;
        sum_tiles_again(s, i, end, c, boundary, &again.sums);
        add_up(s, i, to, later, c, &again);
    }
}

/* Gauge pressure from the virial of the pairs and the walls, summed over the iterations. */
static void gauge(const skv_rows *s, int row, int iteration, const skv_row_constants *c)
{
    const v8 scale = v8_set(c->pressure_scale), zero = v8_set(0);
    const float *own = s->own_move.virial, *next = s->next_move.virial,
                *in_tile = s->tile_move.virial;
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_LANES) {
        v8 before = iteration ? v8_load(s->pressure + i) : zero;
        v8_store(s->pressure + i,
                 v8_add(before, v8_mul(scale, collected(own + i, next + i, in_tile + i))));
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

/* The displacement that a row's eight particles at i have collected. */
V8_INLINE void collected_move(const skv_rows *s, int i, int end, bool viscous, v8 *dx, v8 *dy)
{
    const skv_row_moves *own = &s->own_move, *next = &s->next_move, *tiled = &s->tile_move;
    *dx = collected(own->x + i, next->x + i, tiled->x + i);
    *dy = collected(own->y + i, next->y + i, tiled->y + i);
    if (!viscous)
        return;
    bool by_number = skv_rows_keep_tile_sums(s);
    v8 u = by_number ? gather(s, s->impulse_u, i, end) : v8_load(s->impulse_u + i);
    v8 v = by_number ? gather(s, s->impulse_v, i, end) : v8_load(s->impulse_v + i);
    *dx = v8_add(*dx, u);
    *dy = v8_add(*dy, v);
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
    bool viscous = s->viscous && iteration == 0;
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8 dx, dy;
        collected_move(s, i, end, viscous, &dx, &dy);
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
