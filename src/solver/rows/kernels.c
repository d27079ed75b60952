/* The kernels of the rows: one source for every instruction set.
 *
 * Compiled several times, each with the flags of one instruction set and SKV_ROW_KERNELS naming the
 * table it defines. Invariant: a lane does the same IEEE operations in the same order in each of
 * them, and sums are added up in a fixed order; so all tables give the same bits.
 * Here are the passes over single particles; those over pairs are in pair_density.h and
 * pair_displacement.h, the pressure laws in pressure_laws.h.
 */
#include "solver/rows/hanging.h"
#include "solver/rows/pair_displacement.h"
#include "solver/rows/pressure_laws.h"
#include "solver/rows/solids.h"

/* Where a particle is while its pairs lag behind: there it meets walls. */
V8_INLINE void place_of(const skv_row_particles *p, int i, const skv_constants *c, float *x,
                        float *y)
{
    float lag = lag_of_one(p, i, c->pair_lag, c->lag_rise);
    *x = p->x[i] + lag * p->u[i];
    *y = p->y[i] + lag * p->v[i];
}

/* The same as lag_of_one, of eight. */
V8_INLINE v8 lag_of_eight(v8 u, v8 v, const skv_constants *c)
{
    v8 square = v8_add(v8_mul(u, u), v8_mul(v, v));
    square = v8_min(v8_mul(square, v8_set(c->lag_rise)), v8_set(1));
    return v8_mul(v8_set(c->pair_lag), square);
}

/* Notes of a row's eights how far the density looks ahead of their places, four times the lag, as
 * its sums need it; who may have a gradient; and that nobody has an image, which sampling finds. */
static void prepare(const skv_rows *s, int row, const skv_constants *c)
{
    const skv_row_particles *p = &s->set[s->current];
    const v8 gain = v8_set((float)SKV_SMOOTH_GAIN / SKV_SMOOTH_QUARTICS),
             until = v8_set(c->tension_until), far = v8_set(SKV_FAR);
    int begin = s->row_start[row], end = skv_row_padded_end(s->row_end[row]);
    begin_graded(s, row);
    for (int i = begin; i < end; i += ROW_LANES) {
        v8 u = v8_load(p->u + i), v = v8_load(p->v + i);
        v8 scale = v8_mul(gain, lag_of_eight(u, v, c));
        v8_store(s->ahead_x + i, v8_mul(scale, u));
        v8_store(s->ahead_y + i, v8_mul(scale, v));
        v8_store(s->image + i, far);
        v8 pressed = per_mass(s, i, v8_load(p->warm_lambda + i));
        note_graded(s, row, i / ROW_LANES, v8_any_below(pressed, until));
    }
    memset(s->beside + begin / TILE, 0, (size_t)(end - begin) / TILE);
}

/* The walls at a particle, with room for all; returns the distance. Once for all: each copy is a
 * kilobyte. */
static __attribute__((noinline)) float sample_wall(const skv_row_particles *p, int i,
                                                   const skv_constants *c,
                                                   const skv_boundary *boundary, skv_near_wall *to)
{
    float x, y;
    place_of(p, i, c, &x, &y);
    to->particle = i;
    to->solid = 0;
    if (boundary->solids)
        return skv_rows_sample_solids(boundary, c->images, x, y, to);
    return c->images ? skv_boundary_sample_image(boundary, x, y, &to->at.image)
                     : skv_boundary_sample(boundary, x, y, &to->at.wall);
}

/* Samples the walls for a particle that may be near one; returns whether it is, and so needs the
 * sample. */
V8_INLINE bool sample_one(const skv_rows *s, int i, const skv_constants *c,
                          const skv_boundary *boundary, skv_near_wall *wall)
{
    const skv_row_particles *p = &s->set[s->current];
    p->clearance[i] = sample_wall(p, i, c, boundary, wall);
    /* As whoever has to sample again will see it. */
    if (p->clearance[i] >= 1 || (c->images && wall->at.image.distance >= 1))
        return false;
    if (c->images) {
        s->image[i] = wall->at.image.distance;
        s->beside[i / TILE] = true;
    }
    return true;
}

/* Whether one of the eight particles at i may be closer to a wall. */
V8_INLINE bool any_closer(const skv_row_particles *p, int i, float distance)
{
    return v8_any_below(v8_load(p->clearance + i), v8_set(distance));
}

/* Samples the walls for the particles near one, keeps the samples until the update, and notes the
 * distances of images, how far the density looks ahead, and who may have a gradient. */
static void sample(const skv_rows *s, int row, const skv_constants *c, const skv_boundary *boundary,
                   skv_row_samples *samples)
{
    const skv_row_particles *p = &s->set[s->current];
    int end = s->row_end[row], used = 0;
    if (!c->clavet)
        prepare(s, row, c);
    for (int eight = s->row_start[row]; eight < end; eight += ROW_LANES) {
        if (!any_closer(p, eight, 1))
            continue;
        for (int i = eight; i < eight + ROW_LANES && i < end; i++) {
            skv_near_wall spare[ROW_MOST_WALLS];
            skv_near_wall *wall = used < samples->room ? &samples->sample[used] : spare;
            if (p->clearance[i] < 1 && sample_one(s, i, c, boundary, wall))
                used += skv_near_walls(wall);
        }
    }
    samples->used = used <= samples->room ? used : -1;
}

/* What is done for one particle beside a wall. */
typedef void by_wall(const skv_rows *s, const skv_near_wall *wall, const skv_constants *c,
                     void *context);

/* Does it for all of a row, from its samples; where those found no place they are taken again. */
V8_INLINE void for_walls(const skv_rows *s, int row, const skv_constants *c,
                         const skv_boundary *boundary, const skv_row_samples *samples, by_wall *act,
                         void *context)
{
    const skv_row_particles *p = &s->set[s->current];
    int begin = s->row_start[row], used = samples->used;
    int count = used < 0 ? s->row_end[row] - begin : used;
    for (int n = 0, walls = 1; n < count; n += walls) {
        skv_near_wall taken[ROW_MOST_WALLS], *wall = taken;
        if (used < 0 && (p->clearance[begin + n] >= 1 || (c->images && s->image[begin + n] >= 1)))
            continue;
        if (used < 0)
            sample_wall(p, begin + n, c, boundary, wall);
        else
            walls = skv_near_walls(wall = &samples->sample[n]);
        act(s, wall, c, context);
    }
}

/* Adds what is no pair to a particle's sums. The calibrated law's are those of q^3 and q^4, of
 * which its density is made. */
V8_INLINE void add_to_sums(const skv_rows *s, int i, const skv_constants *c, float density,
                           float near_density)
{
    s->own.density[i] +=
        c->clavet ? density
                  : (SKV_SMOOTH_CUBES * near_density - density) * (1.0f / SKV_SMOOTH_QUARTICS);
    s->own.near_density[i] += near_density;
    if (skv_is_massive(s)) /* it is of the particle's own kind */
        s->own.lightness[i] += near_density * s->set[s->current].lightness[i];
}

/* The solid's share of the sums; with images, a particle's own image and the residual volume,
 * which is a crowd. */
V8_INLINE void add_solid(const skv_rows *s, const skv_near_wall *wall, const skv_constants *c,
                         void *graded)
{
    const skv_row_sums *own = &s->own;
    int i = wall->particle;
    if (!c->images) {
        const skv_wall_sample *solid = &wall->at.wall;
        add_to_sums(s, i, c, solid->r, solid->rn);
        if (graded) {
            own->gradient_x[i] -= solid->f1x;
            own->gradient_y[i] -= solid->f1y;
        }
        return;
    }
    const skv_image_sample *image = &wall->at.image;
    float q = 1 - 2 * image->distance;
    q = q > 0 ? q : 0;
    add_to_sums(s, i, c, image->r + skv_kernel_densityf(SKV_KERNEL_SMOOTH, q),
                c->residual_share * image->r + q * q * q);
    if (graded) {
        float flat = c->image_gradient * skv_flat_slope(image->distance);
        own->gradient_x[i] -= image->f1x + flat * image->nx;
        own->gradient_y[i] -= image->f1y + flat * image->ny;
    }
}

static void pressure(const skv_rows *s, int row, bool later, const skv_constants *c,
                     const skv_boundary *boundary, const skv_row_samples *samples)
{
    bool graded = !c->clavet && !later;
    for_walls(s, row, c, boundary, samples, add_solid, graded ? &graded : NULL);
    if (skv_is_massive(s))
        find_mean_masses(s, row);
    if (graded) /* while the push of the last substep is known */
        keep_gradient(s, row, c);
    if (c->clavet)
        pressure_clavet(s, row, c);
    else
        pressure_calibrated(s, row, later, c);
}

/* Books what a wall of the terrain gives a particle: displacement times mass. */
V8_INLINE void give(const skv_rows *s, const skv_boundary *boundary, float x, float y, float dx,
                    float dy, skv_row_given *walls)
{
    skv_impulse_give(&walls->all, x, y, dx, dy);
    if (s->reaction)
        skv_rows_book_reaction(s, boundary, x, y, dx, dy, walls);
}

/* Friction along the wall and push out of it, Algorithm 7. */
V8_INLINE void touch_wall(const skv_rows *s, int i, const skv_constants *c,
                          const skv_boundary *boundary, skv_row_given *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    float nx, ny;
    float depth = skv_boundary_contact(boundary, p->x[i], p->y[i], &nx, &ny, &p->clearance[i]);
    if (!(depth > 0))
        return;
    /* u, v already hold the whole displacement of the substep. */
    float slide = p->v[i] * nx - p->u[i] * ny;
    float rub = c->friction * slide, push = c->softness * depth;
    float dx = push * nx + rub * ny, dy = push * ny - rub * nx;
    float made = skv_boundary_move(boundary, &p->x[i], &p->y[i], dx, dy, &p->clearance[i]);
    p->u[i] += made * dx;
    p->v[i] += made * dy;
    float mass = skv_row_mass(s, i);
    give(s, boundary, p->x[i], p->y[i], mass * (made * dx), mass * (made * dy), walls);
}

/* The same for all of a row. */
static void touch_walls(const skv_rows *s, int row, const skv_constants *c,
                        const skv_boundary *boundary, skv_row_given *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    const float near = s->acting.contact_distance;
    int end = s->row_end[row];
    for (int eight = s->row_start[row]; eight < end; eight += ROW_LANES) {
        if (!any_closer(p, eight, near))
            continue;
        for (int i = eight; i < eight + ROW_LANES && i < end; i++)
            if (p->clearance[i] >= near || p->number[i] & ROW_HELD)
                continue;
            else if (boundary->solids)
                skv_rows_touch_solids(s, i, c, boundary, walls);
            else
                touch_wall(s, i, c, boundary, walls);
    }
}

/* What the walls of a row push: added up before it is booked. */
typedef struct row_booking {
    skv_impulse sum;
    const skv_boundary *boundary;
    skv_row_given *walls;
} row_booking;

/* Adds what a wall gives a particle: displacement times mass. */
V8_INLINE void add_move(const skv_rows *s, const skv_near_wall *wall, const skv_constants *c,
                        float dx, float dy, skv_push_made made, row_booking *given)
{
    const skv_row_particles *p = &s->set[s->current];
    float x, y;
    int i = wall->particle;
    place_of(p, i, c, &x, &y);
    s->own_move.x[i] += dx;
    s->own_move.y[i] += dy;
    if (!(p->number[i] & ROW_HELD)) {
        given->sum.x += (double)dx;
        given->sum.y += (double)dy;
        given->sum.moment += (double)(x * dy - y * dx);
        if (wall->solid)
            skv_rows_book_push(s, wall, c->images, given->boundary, x, y, dx, dy, made,
                               given->walls);
        else if (s->reaction)
            skv_rows_book_reaction(s, given->boundary, x, y, dx, dy, given->walls);
    }
}

/* Adds the wall's push. */
V8_INLINE void add_push(const skv_rows *s, const skv_near_wall *wall, const skv_constants *c,
                        void *booking)
{
    int i = wall->particle;
    float lambda = s->lambda[i], near_lambda = s->near_lambda[i], dx, dy, gx, gy;
    skv_push_made made = {0, lambda, near_lambda};
    find_fall(s, i, &gx, &gy);
    if (!c->images) {
        /* A wall pushes with the particle's own pressure, once; twice, as if it were a mirrored
         * fluid, heats the fluid. */
        const skv_wall_sample *solid = &wall->at.wall;
        dx = lambda * solid->f1x + near_lambda * solid->f2x;
        dy = lambda * solid->f1y + near_lambda * solid->f2y;
        if (lambda < c->loose_lambda * skv_row_mass(s, i))
            let_fall(gx, gy, solid->f1x, solid->f1y, 1, &dx, &dy);
        /* The virial of a smooth solid, by parts in terms of h R and h Rn. */
        if (s->gauged)
            s->own_move.outward[i] +=
                c->wall_virial * lambda * solid->r + 2.0f / SKV_NEAR_GAIN * near_lambda * solid->rn;
    } else {
        const skv_image_sample *image = &wall->at.image;
        float q = 1 - 2 * image->distance,
              rest = lambda + SKV_NEAR_WEIGHT * c->residual_share * near_lambda;
        q = q > 0 ? q : 0;
        float out = s->own_move.outward[i] + s->next_move.outward[i];
        out += 2 * (lambda * skv_kernel_forcef(SKV_KERNEL_SMOOTH, q) + near_lambda * (q * q));
        made = (skv_push_made){out, rest, 0};
        dx = rest * image->f1x + out * image->nx;
        dy = rest * image->f1y + out * image->ny;
        let_fall(gx, gy, image->nx, image->ny, (1 - c->adhesion) * s->hanging[i], &dx, &dy);
    }
    add_move(s, wall, c, dx, dy, made, booking);
}

/* Takes from a particle's displacement what friction and viscosity hold of its slip along the wall;
 * u, v hold the rest of what it has moved in the substep. */
V8_INLINE void add_slip_friction(const skv_rows *s, const skv_near_wall *wall,
                                 const skv_constants *c, void *booking)
{
    const skv_row_particles *p = &s->set[s->current];
    const skv_image_sample *image = &wall->at.image;
    float size = sqrtf(image->nx * image->nx + image->ny * image->ny);
    if (!(size > 0))
        return;
    int i = wall->particle;
    float tx = -image->ny / size, ty = image->nx / size;
    float mass = skv_row_mass(s, i);
    float moved_x = p->u[i] + (s->own_move.x[i] + s->next_move.x[i]) / mass;
    float moved_y = p->v[i] + (s->own_move.y[i] + s->next_move.y[i]) / mass;
    if (wall->solid) { /* it slips along what moves itself */
        float way_x, way_y;
        skv_rows_way_of_walls(s, wall, c, ((const row_booking *)booking)->boundary, &way_x, &way_y);
        moved_x -= way_x;
        moved_y -= way_y;
    }
    float friction = c->slip_friction, drag = c->wall_drag;
    if (s->various) {
        drag = c->wall_stick * (p->drag[i] * p->lightness[i]);
        friction = drag > 0 ? 0 : c->bare_slip;
    }
    float taken = skv_slip_taken(friction, drag, image->distance);
    float held = taken * (moved_x * tx + moved_y * ty) * mass;
    add_move(s, wall, c, -held * tx, -held * ty, (skv_push_made){0, 0, 0}, booking);
}

/* Zeroes the lanes of those of the eight particles at i that are held. */
V8_INLINE v8 unless_held(const int *numbers, v8 a)
{
    int32_t free[ROW_LANES];
    for (int l = 0; l < ROW_LANES; l++)
        free[l] = numbers[l] & ROW_HELD ? 0 : -1;
    return v8_and(a, v8_load((const float *)(const void *)free));
}

/* What a move is: the advance, or a correction, which changes the velocity; and whether the places
 * lag behind the particles before and after it. */
typedef struct move_kind {
    bool corrects, lagged, lags;
} move_kind;

/* Moves a particle that may meet a wall; returns false, and does nothing, if it meets none. */
static __attribute__((noinline)) bool meet_wall(const skv_rows *s, int i, float dx, float dy,
                                                move_kind kind, const skv_constants *c,
                                                const skv_boundary *boundary, skv_row_given *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    float lag = kind.lagged ? lag_of_one(p, i, c->pair_lag, c->lag_rise) : 0;
    float x = p->x[i] + lag * p->u[i], y = p->y[i] + lag * p->v[i], along_x, along_y;
    skv_cuts cuts = {0};
    float made = boundary->solids
                     ? skv_solids_slide(boundary, !kind.corrects, c->images, &x, &y, dx, dy,
                                        &along_x, &along_y, &p->clearance[i], &cuts)
                     : skv_boundary_slide(boundary, c->images, &x, &y, dx, dy, &along_x, &along_y,
                                          &p->clearance[i]);
    if (!(made < 1))
        return false;
    /* What a wall has cut off the advance leaves the velocity; a correction enters it as far as it
     * was made. */
    float share = kind.corrects ? made : made - 1;
    p->u[i] += share * dx + along_x;
    p->v[i] += share * dy + along_y;
    lag = kind.lags ? lag_of_one(p, i, c->pair_lag, c->lag_rise) : 0;
    p->x[i] = x - lag * p->u[i];
    p->y[i] = y - lag * p->v[i];
    float mass = skv_row_mass(s, i);
    if (boundary->solids)
        skv_rows_book_cuts(s, boundary, i, x, y, &cuts, walls);
    else
        give(s, boundary, x, y, mass * ((made - 1) * dx + along_x),
             mass * ((made - 1) * dy + along_y), walls);
    return true;
}

/* Moves the eight particles at i; those whose way may meet a wall one by one. */
RARE void move_eight(const skv_rows *s, int i, int end, v8 dx, v8 dy, move_kind kind,
                     const skv_constants *c, const skv_boundary *boundary, skv_row_given *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    v8 length = v8_sqrt(v8_add(v8_mul(dx, dx), v8_mul(dy, dy)));
    v8 clear = v8_sub(v8_load(p->clearance + i), v8_mul(v8_set(ROW_WALL_SLOPE), length));
    v8 u = v8_load(p->u + i), v = v8_load(p->v + i);
    /* All of it is added up first: one rounding of the place. */
    v8 x = dx, y = dy;
    if (kind.lagged) {
        v8 lag = lag_of_eight(u, v, c);
        x = v8_add(x, v8_mul(lag, u));
        y = v8_add(y, v8_mul(lag, v));
    }
    if (kind.corrects) {
        u = v8_add(u, dx);
        v = v8_add(v, dy);
    }
    if (kind.lags) {
        v8 lag = lag_of_eight(u, v, c);
        x = v8_sub(x, v8_mul(lag, u));
        y = v8_sub(y, v8_mul(lag, v));
    }
    x = v8_add(v8_load(p->x + i), x);
    y = v8_add(v8_load(p->y + i), y);
    if (!v8_any_below(clear, v8_set(s->acting.wall_margin))) {
        v8_store(p->clearance + i, clear);
        v8_store(p->x + i, x);
        v8_store(p->y + i, y);
        v8_store(p->u + i, u);
        v8_store(p->v + i, v);
        return;
    }
    float move_x[ROW_LANES], move_y[ROW_LANES], left[ROW_LANES], free[4][ROW_LANES];
    v8_store(left, clear);
    v8_store(move_x, dx);
    v8_store(move_y, dy);
    v8_store(free[0], x);
    v8_store(free[1], y);
    v8_store(free[2], u);
    v8_store(free[3], v);
    for (int l = 0; l < ROW_LANES && i + l < end; l++) {
        int k = i + l;
        bool may_meet = left[l] < s->acting.wall_margin;
        if (may_meet && meet_wall(s, k, move_x[l], move_y[l], kind, c, boundary, walls))
            continue;
        p->clearance[k] = may_meet ? p->clearance[k] : left[l];
        p->x[k] = free[0][l];
        p->y[k] = free[1][l];
        p->u[k] = free[2][l];
        p->v[k] = free[3][l];
    }
}

static void update(const skv_rows *s, int row, int iteration, const skv_constants *c,
                   const skv_boundary *boundary, const skv_row_samples *samples,
                   skv_row_given *walls)
{
    row_booking given = {.boundary = boundary, .walls = walls};
    if (iteration == 0 && !c->clavet && boundary->solids)
        skv_rows_book_turns(s, row, c, boundary, samples, walls);
    if (iteration == 0 && c->images)
        find_hanging(s, row, c);
    for_walls(s, row, c, boundary, samples, add_push, &given);
    if (iteration == c->iterations - 1 && (skv_resists_slip(c) || s->various))
        for_walls(s, row, c, boundary, samples, add_slip_friction, &given);
    skv_impulse_add(&walls->all, given.sum.x, given.sum.y, given.sum.moment);
    const bool last = iteration == c->iterations - 1, lag = c->pair_lag > 0;
    const move_kind correction = {.corrects = true, .lagged = lag, .lags = lag && !last};
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8 dx = per_mass(s, i, collected(s->own_move.x + i, s->next_move.x + i));
        v8 dy = per_mass(s, i, collected(s->own_move.y + i, s->next_move.y + i));
        if (s->held) {
            const int *numbers = s->set[s->current].number + i;
            dx = unless_held(numbers, dx);
            dy = unless_held(numbers, dy);
        }
        move_eight(s, i, end, dx, dy, correction, c, boundary, walls);
    }
    if (s->gauged) /* in the memory of what has been read above */
        gauge(s, row, iteration, c);
    if (last)
        touch_walls(s, row, c, boundary, walls);
}

static void advance(const skv_rows *s, int row, const skv_constants *c,
                    const skv_boundary *boundary, skv_row_given *walls)
{
    const skv_row_particles *p = &s->set[s->current];
    const v8 gx = v8_set(s->acting.gravity_x), gy = v8_set(s->acting.gravity_y), one = v8_set(1);
    const v8 limit = v8_set(c->max_speed), tiny = v8_set(TINY_SQUARED);
    int end = s->row_end[row];
    for (int i = s->row_start[row]; i < end; i += ROW_LANES) {
        v8_store(p->u + i, v8_add(v8_load(p->u + i), gx));
        v8_store(p->v + i, v8_add(v8_load(p->v + i), gy));
    }
    if (boundary->solids)
        skv_rows_expect_solids(s, row, boundary);
    for (int i = s->row_start[row]; s->acting.force_count > 0 && i < end; i++)
        add_forces(s, p->x[i], p->y[i], &p->u[i], &p->v[i]);
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
        move_eight(s, i, end, u, v, (move_kind){.lags = c->pair_lag > 0}, c, boundary, walls);
    }
}

const skv_row_kernels SKV_ROW_KERNELS = {
    V8_NAME, advance, sample, density, pressure, displacement, update,
};
