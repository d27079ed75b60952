/* What air does to walls: the part of a force meter that the fluid's substep does not tell.
 *
 * Each straight piece of wall in the box bears the push of the air before it, as bodies do
 * (world/air/air.c). Where all pressures are lifted (world/air/lift.c), the fluid's push on walls
 * and the air's are by as much too high, so every piece of wall loses the lift again. Invariant:
 * without air nothing is added.
 */
#include "measure/wall_force.h"
#include "terrain/sample.h"
#include "terrain/terrain.h"
#include "world/air/air.h"

#include <math.h>

/* Cells from the wall: there air is that no wall cuts. */
#define AWAY 0.75f

/* Where a wall's piece has its middle, m, and how long it is. */
typedef struct piece {
    float x, y;
    double length;
} piece;

static piece find_piece(const skv_terrain *terrain, const skv_wall_segment *s)
{
    const float m = terrain->pixel_size, edge = SKV_TERRAIN_RIM - 0.5f;
    double x = (double)(s->x1 - s->x0), y = (double)(s->y1 - s->y0);
    return (piece){((s->x0 + s->x1) / 2 - edge) * m, ((s->y0 + s->y1) / 2 - edge) * m,
                   sqrt(x * x + y * y) * (double)m};
}

/* Above the atmosphere's, Pa m. */
static double pressure_before(const skv_air *air, const piece *p, float nx, float ny)
{
    int c = skv_air_cell_at(air, p->x + AWAY * air->cell * nx, p->y + AWAY * air->cell * ny);
    double push = air->label[c] ? air->piece[air->label[c]].push : 0;
    return push * (double)skv_air_part(air->share[c]) - air->lift;
}

static void add_piece(const skv_world *world, const skv_reaction *box, const piece *p,
                      skv_wall_force *force)
{
    float nx, ny;
    double x = (double)p->x, y = (double)p->y;
    if (x < box->x0 || x > box->x1 || y < box->y0 || y > box->y1)
        return;
    skv_normal_at(world->terrain, p->x, p->y, &nx, &ny);
    double push = pressure_before(world->air, p, nx, ny) * p->length;
    double fx = -push * (double)nx, fy = -push * (double)ny;
    force->fx += fx;
    force->fy += fy;
    force->torque += (x - (box->x0 + box->x1) / 2) * fy - (y - (box->y0 + box->y1) / 2) * fx;
}

void skv_force_add_air(const skv_world *world, const skv_reaction *box, skv_wall_force *force)
{
    if (!world->air)
        return;
    const skv_coverage picture = skv_terrain_coverage(world->terrain);
    for (int y = 0; y < picture.rows - 1; y++) {
        for (int x = 0; x < picture.columns - 1; x++) {
            skv_wall_segment found[2];
            int count = skv_cell_segments(&picture, x, y, found);
            for (int k = 0; k < count; k++) {
                piece p = find_piece(world->terrain, &found[k]);
                add_piece(world, box, &p, force);
            }
        }
    }
}
