/* Booking what walls give for the reaction that is asked for. Invariant: it goes by the nearest
 * point of a wall of the terrain, in the world's axes. */
#include "solver/rows/rows_internal.h"

void skv_rows_book_reaction(const skv_rows *rows, const skv_boundary *boundary, float x, float y,
                            float dx, float dy, skv_row_given *walls)
{
    const skv_reaction *box = rows->reaction;
    float nx, ny;
    skv_boundary_to_world(boundary, &x, &y);
    skv_boundary_swap(boundary, &dx, &dy);
    float distance = skv_terrain_normal(boundary->terrain, x, y, &nx, &ny);
    double at_x = (double)(x - distance * nx), at_y = (double)(y - distance * ny);
    if (at_x < box->x0 || at_x > box->x1 || at_y < box->y0 || at_y > box->y1)
        return;
    double arm_x = at_x - (box->x0 + box->x1) / 2, arm_y = at_y - (box->y0 + box->y1) / 2;
    double moment = (arm_x * (double)dy - arm_y * (double)dx) * (double)boundary->per_unit;
    skv_impulse_add(&walls->boxed, (double)dx, (double)dy, moment);
}
