/* Meeting solids: see solids.h. All of it is plain single precision, one particle at a time, so
 * that every solver and every instruction set gets the same bits. */
#include "terrain/solids.h"

#include <string.h>

static float length_of(float x, float y)
{
    return sqrtf(x * x + y * y);
}

static int count_of(const skv_boundary *b)
{
    return b->solids ? b->solids->count : 0;
}

/* How far a point in the world's axes is from the circle around a solid: below 0 within. */
static float outside(const skv_solid *s, float x, float y)
{
    return length_of(x - s->now.x, y - s->now.y) - s->reach;
}

/* Two radii, and what rounding may make of them. */
#define REACHED 2.001f

void skv_solids_arrange(skv_solids *solids, float h)
{
    float low = INFINITY, high = -INFINITY;
    for (int k = 0; k < solids->count; k++) {
        low = skv_minf(low, solids->solid[k].now.x);
        high = skv_maxf(high, solids->solid[k].now.x);
    }
    solids->low = low - h;
    solids->strips_a_metre = SKV_STRIPS / (high - low + 2 * h);
    memset(solids->beside, 0, sizeof solids->beside);
    for (int k = 0; k < solids->count; k++) {
        const skv_solid *s = &solids->solid[k];
        float x = s->now.x, far = s->reach + skv_solid_way(s) + REACHED * h;
        for (int at = skv_strip_of(solids, x - far); at <= skv_strip_of(solids, x + far); at++)
            solids->beside[at] |= (uint64_t)1 << k;
    }
}

/* The share of a film between the terrain and a solid at a place in m: of what is narrow, where the
 * two face each other. */
static float film_at(const skv_boundary *b, const skv_solid *s, float x, float y)
{
    float nx, ny, mx, my, gap = skv_normal_at(b->terrain, x, y, &nx, &ny);
    if (!(gap < skv_film_reach(b->solids->spacing)))
        return 0;
    skv_solid_enter(s, &s->now, &x, &y);
    gap += skv_normal_at(s->shape->terrain, x, y, &mx, &my);
    skv_solid_turn(&s->now, &mx, &my);
    return skv_film_share(gap, b->solids->spacing) * skv_facing(nx, ny, mx, my);
}

/* What is within h, by images or not. False: nothing. */
static bool meet(const skv_boundary *b, bool images, float *distance, float h, float x, float y,
                 skv_part_of_walls *part)
{
    if (images) {
        skv_image_sample image;
        *distance = skv_boundary_sample_image(b, x, y, &image);
        part->distance = image.distance;
        part->nx = image.nx;
        part->ny = image.ny;
        part->r = image.r;
        part->f1x = image.f1x;
        part->f1y = image.f1y;
        return *distance < h && image.distance < 1;
    }
    skv_wall_sample wall;
    *distance = skv_boundary_sample(b, x, y, &wall);
    part->distance = 1;
    part->r = wall.r;
    part->rn = wall.rn;
    part->f1x = wall.f1x;
    part->f1y = wall.f1y;
    part->f2x = wall.f2x;
    part->f2y = wall.f2y;
    return *distance < h;
}

/* Turns a part's vectors from a solid's frame to the asker's axes. */
static void turn_part(const skv_boundary *b, const skv_solid *s, skv_part_of_walls *part)
{
    float *const vectors[] = {&part->nx, &part->ny, &part->f1x, &part->f1y, &part->f2x, &part->f2y};
    for (int v = 0; v < 6; v += 2) {
        skv_solid_turn(&s->now, vectors[v], vectors[v + 1]);
        skv_boundary_swap(b, vectors[v], vectors[v + 1]);
    }
}

/* Makes of the parts' image distances that of the sum of their shares, and of their slopes their
 * shares of its slope. */
static void join_images(const skv_image_law *law, skv_walls_met *met)
{
    double share = 0, fall[SKV_MOST_PARTS] = {0}, slope;
    for (int k = 0; k < met->count; k++)
        share += skv_image_share_at(law, (double)met->part[k].distance, &fall[k]);
    met->sum.distance = (float)skv_image_distance(law, share, &slope);
    for (int k = 0; k < met->count; k++) {
        met->part[k].nx *= (float)(slope * fall[k]);
        met->part[k].ny *= (float)(slope * fall[k]);
    }
}

static void add_up(const skv_boundary *b, bool images, skv_walls_met *met)
{
    met->sum = (skv_part_of_walls){.distance = 1};
    if (met->count == 1) {
        met->sum = met->part[0];
        return;
    }
    if (met->count == 0)
        return;
    if (images)
        join_images(&b->solids->law, met);
    met->sum.solid = -1;
    for (int k = 0; k < met->count; k++) {
        const skv_part_of_walls *part = &met->part[k];
        met->sum.nx += part->nx;
        met->sum.ny += part->ny;
        met->sum.r += part->r;
        met->sum.rn += part->rn;
        met->sum.f1x += part->f1x;
        met->sum.f1y += part->f1y;
        met->sum.f2x += part->f2x;
        met->sum.f2y += part->f2y;
    }
}

void skv_solids_meet(const skv_boundary *b, bool images, float x, float y, skv_walls_met *met)
{
    const float h = (float)b->walls->radius, near = h * b->per_unit;
    const skv_solids *solids = b->solids;
    float wx = x, wy = y, nearest = solids ? 2 * near : INFINITY; /* a bound */
    skv_boundary_to_world(b, &wx, &wy);
    const bool clear = skv_wall_map_is_clear(b->walls, wx, wy);
    met->count = 0;
    if (!clear) {
        met->part[0] = (skv_part_of_walls){0};
        met->count += meet(b, images, &nearest, near, x, y, &met->part[0]);
    }
    uint64_t left = solids ? solids->beside[skv_strip_of(solids, wx)] : 0;
    for (; left && met->count < SKV_MOST_PARTS; left &= left - 1) {
        const int k = __builtin_ctzll(left);
        const skv_solid *s = &solids->solid[k];
        const float least = s->reach + 2 * h, dx = wx - s->now.x, dy = wy - s->now.y;
        if (dx * dx + dy * dy > least * least)
            continue;
        float distance, away = outside(s, wx, wy) * b->per_unit;
        if (!(away < near)) {
            nearest = skv_minf(nearest, away);
            continue;
        }
        float lx = wx, ly = wy;
        skv_solid_enter(s, &s->now, &lx, &ly);
        skv_part_of_walls *part = &met->part[met->count];
        *part = (skv_part_of_walls){.solid = k + 1};
        if (meet(s->shape, images, &distance, h, lx, ly, part)) {
            turn_part(b, s, part);
            met->count++;
        }
        nearest = skv_minf(nearest, distance * b->per_unit);
    }
    /* The terrain is farther than h then, and asked only if nothing else is nearer. */
    if (clear && !(nearest < near))
        nearest = skv_minf(nearest, skv_distance_at(b->terrain, wx, wy) * b->per_unit);
    met->distance = nearest;
    add_up(b, images, met);
}

/* How much of what walls do goes by a part where nothing else tells. */
static float weight_of(const skv_part_of_walls *part)
{
    return length_of(part->nx, part->ny) + length_of(part->f1x, part->f1y);
}

static void find_weights(const skv_walls_met *met, float weight[SKV_MOST_PARTS])
{
    float sum = 0;
    weight[0] = 1; /* all goes by the only one */
    if (met->count == 1)
        return;
    for (int k = 0; k < met->count; k++)
        sum += weight[k] = weight_of(&met->part[k]);
    for (int k = 0; k < met->count; k++)
        weight[k] = sum > 0 ? weight[k] / sum : 1 / (float)met->count;
}

void skv_solids_way(const skv_boundary *b, const skv_walls_met *met, float x, float y, float *dx,
                    float *dy)
{
    float weight[SKV_MOST_PARTS], way_x = 0, way_y = 0;
    find_weights(met, weight);
    skv_boundary_to_world(b, &x, &y);
    for (int k = 0; k < met->count; k++) {
        if (met->part[k].solid == 0)
            continue;
        const skv_solid *s = &b->solids->solid[met->part[k].solid - 1];
        way_x += weight[k] * (s->dx - s->turn * (y - s->now.y));
        way_y += weight[k] * (s->dy + s->turn * (x - s->now.x));
    }
    skv_boundary_swap(b, &way_x, &way_y);
    *dx = way_x * b->per_unit;
    *dy = way_y * b->per_unit;
}

float skv_solids_film(const skv_boundary *b, int solid, float x, float y)
{
    if (solid == 0)
        return 0;
    skv_boundary_to_world(b, &x, &y);
    return film_at(b, &b->solids->solid[solid - 1], x, y);
}

void skv_solids_share(const skv_boundary *b, const skv_walls_met *met, float x, float y,
                      float by_slope, float by_rest, float by_near, float dx, float dy,
                      float share[SKV_MOST_PARTS][2])
{
    float weight[SKV_MOST_PARTS], over_x = dx, over_y = dy;
    find_weights(met, weight);
    for (int k = 0; k < met->count; k++) {
        const skv_part_of_walls *part = &met->part[k];
        share[k][0] = by_slope * part->nx + by_rest * part->f1x + by_near * part->f2x;
        share[k][1] = by_slope * part->ny + by_rest * part->f1y + by_near * part->f2y;
        over_x -= share[k][0];
        over_y -= share[k][1];
    }
    for (int k = 0; k < met->count; k++) {
        share[k][0] += weight[k] * over_x;
        share[k][1] += weight[k] * over_y;
    }
    /* What lies in a film the terrain bears. */
    for (int k = 1; k < met->count && met->part[0].solid == 0; k++) {
        float film = skv_solids_film(b, met->part[k].solid, x, y);
        for (int axis = 0; axis < 2; axis++) {
            float borne = film * share[k][axis];
            share[k][axis] -= borne;
            share[0][axis] += borne;
        }
    }
}

static void note_cut(const skv_boundary *b, skv_cuts *cuts, int solid, float dx, float dy)
{
    skv_boundary_swap(b, &dx, &dy);
    int k = cuts->count++;
    cuts->cut[k].solid = solid;
    cuts->cut[k].dx = dx * b->per_unit;
    cuts->cut[k].dy = dy * b->per_unit;
}

/* Stops the way (dx, dy) from (x, y), all in m, at one solid; returns whether it does. Writes how
 * far the particle is from it then. */
static bool stop(const skv_solid *s, bool advances, bool on, float x, float y, float *dx, float *dy,
                 float *distance)
{
    float to_x = x + *dx, to_y = y + *dy, along_x, along_y;
    float ax = x, ay = y, bx = to_x, by = to_y;
    *distance = outside(s, to_x, to_y);
    /* How far it may go in the solid's frame. */
    if (*distance > length_of(*dx, *dy) + (advances ? skv_solid_way(s) : 0) + s->shape->margin)
        return false;
    skv_solid_enter(s, advances ? &s->before : &s->now, &ax, &ay);
    skv_solid_enter(s, &s->now, &bx, &by);
    float made =
        skv_boundary_slide(s->shape, on, &ax, &ay, bx - ax, by - ay, &along_x, &along_y, distance);
    if (!(made < 1))
        return false;
    skv_solid_leave(s, &s->now, &ax, &ay);
    *dx = ax - x;
    *dy = ay - y;
    return true;
}

float skv_solids_slide(const skv_boundary *b, bool advances, bool on, float *x, float *y, float dx,
                       float dy, float *along_x, float *along_y, float *distance, skv_cuts *cuts)
{
    float px = *x, py = *y, wx = dx, wy = dy, nearest = INFINITY;
    skv_boundary_to_world(b, &px, &py);
    skv_boundary_to_world(b, &wx, &wy);
    cuts->count = 0;
    for (int k = 0; k < count_of(b) && cuts->count < SKV_MOST_PARTS - 1; k++) {
        float way_x = wx, way_y = wy, left;
        if (stop(&b->solids->solid[k], advances, on, px, py, &wx, &wy, &left))
            note_cut(b, cuts, k + 1, wx - way_x, wy - way_y);
        nearest = left < nearest ? left : nearest;
    }
    bool stopped = cuts->count > 0;
    if (stopped) {
        dx = wx * b->per_unit;
        dy = wy * b->per_unit;
        skv_boundary_swap(b, &dx, &dy);
    }
    float made = skv_boundary_slide(b, on, x, y, dx, dy, along_x, along_y, distance);
    nearest *= b->per_unit;
    *distance = nearest < *distance ? nearest : *distance;
    if (made < 1) {
        int k = cuts->count++;
        cuts->cut[k].solid = 0;
        cuts->cut[k].dx = (made - 1) * dx + *along_x;
        cuts->cut[k].dy = (made - 1) * dy + *along_y;
    }
    if (!stopped)
        return made;
    *along_x += made * dx;
    *along_y += made * dy;
    return 0;
}

float skv_solids_contact(const skv_boundary *b, float x, float y, float *nx, float *ny,
                         float *distance, int *solid)
{
    float deepest = skv_boundary_contact(b, x, y, nx, ny, distance);
    *solid = 0;
    skv_boundary_to_world(b, &x, &y);
    for (int k = 0; k < count_of(b); k++) {
        const skv_solid *s = &b->solids->solid[k];
        float away = outside(s, x, y), lx = x, ly = y, mx = 0, my = 0, depth = 0;
        if (away < s->shape->contact_distance) {
            skv_solid_enter(s, &s->now, &lx, &ly);
            depth = skv_boundary_contact(s->shape, lx, ly, &mx, &my, &away) * b->per_unit;
        }
        away *= b->per_unit;
        *distance = away < *distance ? away : *distance;
        if (!(depth > deepest))
            continue;
        deepest = depth;
        *solid = k + 1;
        skv_solid_turn(&s->now, &mx, &my);
        skv_boundary_swap(b, &mx, &my);
        *nx = mx;
        *ny = my;
    }
    return deepest;
}
