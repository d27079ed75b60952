/* A step: particles fall and move, give their velocities to the faces of a grid, which is made free
 * of divergence where there is fluid, and take back what changed.
 *
 * Invariant: no face of a wall lets anything through; a particle stays within the tank.
 */
#include "flip.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GRAVITY 9.81f
/* Cells are two particles wide. A particle takes on a share of the grid's own velocity, and else
 * its change. A sweep goes farther than it must. A cell with twice its particles would be empty
 * after four steps; without that fluid loses a third of its volume within seconds. */
#define CELL    2.0
#define PIC     0.05f
#define OVER    1.9f
#define PARTING 0.25f

struct flip {
    int columns, rows, count;
    float cell, width, height, rest; /* m; rest: particles in a full cell */
    float parting;                   /* m/s: how fast a cell with twice as many is emptied */
    float *x, *y, *vx, *vy;
    /* Faces: left ones, (columns + 1) * rows; lower ones, columns * (rows + 1). What they weigh,
     * and what they had before the pressure. */
    float *u, *v, *weight_u, *weight_v, *old_u, *old_v;
    float *density; /* of cells */
};

static float *room_for(int count)
{
    return calloc((size_t)count, sizeof(float));
}

static void lay(flip *f, double width, double depth, double apart)
{
    int across = (int)(width / apart), up = (int)(depth / apart);
    f->count = 0;
    for (int j = 0; j < up; j++)
        for (int i = 0; i < across; i++, f->count++) {
            f->x[f->count] = (float)((i + 0.5) * width / across);
            f->y[f->count] = (float)((j + 0.5) * depth / up);
        }
}

flip *flip_create(double width, double height, double water_width, double depth, int particles)
{
    flip *f = calloc(1, sizeof *f);
    if (!f)
        return NULL;
    double apart = sqrt(water_width * depth / particles);
    f->columns = (int)(width / (CELL * apart));
    f->cell = (float)(width / f->columns);
    f->rows = (int)(height / (double)f->cell);
    f->width = (float)width;
    f->height = f->cell * (float)f->rows;
    f->rest = (float)((double)(f->cell * f->cell) / (apart * apart));
    int cells = f->columns * f->rows, us = cells + f->rows, vs = cells + f->columns;
    float **arrays[] = {&f->x, &f->y, &f->vx, &f->vy};
    bool complete = true;
    for (int i = 0; i < 4; i++)
        complete &= (*arrays[i] = room_for(particles + particles / 8)) != NULL;
    float **faces[] = {&f->u, &f->weight_u, &f->old_u, &f->v, &f->weight_v, &f->old_v};
    for (int i = 0; i < 6; i++)
        complete &= (*faces[i] = room_for(i < 3 ? us : vs)) != NULL;
    complete &= (f->density = room_for(cells)) != NULL;
    if (!complete) {
        flip_destroy(f);
        return NULL;
    }
    lay(f, water_width, depth, apart);
    return f;
}

void flip_destroy(flip *f)
{
    if (!f)
        return;
    float *arrays[] = {f->x,        f->y,        f->vx,    f->vy,    f->u,      f->v,
                       f->weight_u, f->weight_v, f->old_u, f->old_v, f->density};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
    free(f);
}

int flip_particles(const flip *f)
{
    return f->count;
}

static void keep_inside(float *place, float *speed, float low, float high)
{
    if (*place >= low && *place <= high)
        return;
    *place = *place < low ? low : high;
    *speed = 0;
}

static void move(flip *f, float dt)
{
    float edge = 0.01f * f->cell;
    for (int i = 0; i < f->count; i++) {
        f->vy[i] -= GRAVITY * dt;
        f->x[i] += f->vx[i] * dt;
        f->y[i] += f->vy[i] * dt;
        keep_inside(&f->x[i], &f->vx[i], edge, f->width - edge);
        keep_inside(&f->y[i], &f->vy[i], edge, f->height - edge);
    }
}

/* Four neighbours on a grid of points, and what each counts. */
typedef struct corners {
    int at[4];
    float share[4];
} corners;

/* Of a place in cells, on a grid of so many points each way. */
static corners find_corners(float x, float y, int across, int up)
{
    x = fminf(fmaxf(x, 0), (float)(across - 1) - 1e-3f);
    y = fminf(fmaxf(y, 0), (float)(up - 1) - 1e-3f);
    int i = (int)x, j = (int)y, at = j * across + i;
    float right = x - (float)i, above = y - (float)j;
    return (corners){
        {at, at + 1, at + across, at + across + 1},
        {(1 - right) * (1 - above), right * (1 - above), (1 - right) * above, right * above}};
}

static corners at_left_faces(const flip *f, int i)
{
    return find_corners(f->x[i] / f->cell, f->y[i] / f->cell - 0.5f, f->columns + 1, f->rows);
}

static corners at_lower_faces(const flip *f, int i)
{
    return find_corners(f->x[i] / f->cell - 0.5f, f->y[i] / f->cell, f->columns, f->rows + 1);
}

static corners at_cells(const flip *f, int i)
{
    return find_corners(f->x[i] / f->cell - 0.5f, f->y[i] / f->cell - 0.5f, f->columns, f->rows);
}

static void add(const corners *c, float value, float *sums, float *weights)
{
    for (int k = 0; k < 4; k++) {
        sums[c->at[k]] += c->share[k] * value;
        weights[c->at[k]] += c->share[k];
    }
}

/* Particles to faces, and to cells how many are there. */
static void give(flip *f)
{
    int cells = f->columns * f->rows, us = cells + f->rows, vs = cells + f->columns;
    memset(f->u, 0, (size_t)us * sizeof(float));
    memset(f->weight_u, 0, (size_t)us * sizeof(float));
    memset(f->v, 0, (size_t)vs * sizeof(float));
    memset(f->weight_v, 0, (size_t)vs * sizeof(float));
    memset(f->density, 0, (size_t)cells * sizeof(float));
    for (int i = 0; i < f->count; i++) {
        corners left = at_left_faces(f, i), lower = at_lower_faces(f, i);
        add(&left, f->vx[i], f->u, f->weight_u);
        add(&lower, f->vy[i], f->v, f->weight_v);
        corners own = at_cells(f, i);
        for (int k = 0; k < 4; k++)
            f->density[own.at[k]] += own.share[k];
    }
    for (int i = 0; i < us; i++)
        f->u[i] = f->weight_u[i] > 0 ? f->u[i] / f->weight_u[i] : 0;
    for (int i = 0; i < vs; i++)
        f->v[i] = f->weight_v[i] > 0 ? f->v[i] / f->weight_v[i] : 0;
}

static void close_walls(flip *f)
{
    for (int j = 0; j < f->rows; j++)
        f->u[j * (f->columns + 1)] = f->u[j * (f->columns + 1) + f->columns] = 0;
    for (int i = 0; i < f->columns; i++)
        f->v[i] = f->v[f->rows * f->columns + i] = 0;
}

/* What flows out of a cell of fluid is taken from its open faces. */
static void balance(flip *f, int i, int j)
{
    float density = f->density[j * f->columns + i];
    if (density <= 0)
        return;
    float *left = &f->u[j * (f->columns + 1) + i], *right = left + 1;
    float *below = &f->v[j * f->columns + i], *above = below + f->columns;
    int l = i > 0, r = i + 1 < f->columns, b = j > 0, a = j + 1 < f->rows;
    float out = *right - *left + *above - *below;
    if (density > f->rest)
        out -= f->parting * (density / f->rest - 1);
    float push = OVER * out / (float)(l + r + b + a);
    *left += l ? push : 0;
    *right -= r ? push : 0;
    *below += b ? push : 0;
    *above -= a ? push : 0;
}

static void project(flip *f, float dt)
{
    f->parting = PARTING * f->cell / dt;
    int cells = f->columns * f->rows;
    close_walls(f);
    memcpy(f->old_u, f->u, (size_t)(cells + f->rows) * sizeof(float));
    memcpy(f->old_v, f->v, (size_t)(cells + f->columns) * sizeof(float));
    for (int sweep = 0; sweep < FLIP_SWEEPS; sweep++)
        for (int j = 0; j < f->rows; j++)
            for (int i = 0; i < f->columns; i++)
                balance(f, i, j);
}

/* Faces to a particle: the grid's velocity, and by how much it changed. */
static void look(const corners *c, const float *now, const float *old, const float *weight,
                 float *velocity)
{
    float sum = 0, change = 0, total = 0;
    for (int k = 0; k < 4; k++) {
        float share = weight[c->at[k]] > 0 ? c->share[k] : 0;
        sum += share * now[c->at[k]];
        change += share * (now[c->at[k]] - old[c->at[k]]);
        total += share;
    }
    if (total > 0)
        *velocity = PIC * sum / total + (1 - PIC) * (*velocity + change / total);
}

static void take(flip *f)
{
    for (int i = 0; i < f->count; i++) {
        corners left = at_left_faces(f, i), lower = at_lower_faces(f, i);
        look(&left, f->u, f->old_u, f->weight_u, &f->vx[i]);
        look(&lower, f->v, f->old_v, f->weight_v, &f->vy[i]);
    }
}

void flip_step(flip *f, float dt)
{
    move(f, dt);
    give(f);
    project(f, dt);
    take(f);
}

void flip_measure(const flip *f, double *speed, double *height)
{
    double squares = 0, sum = 0;
    for (int i = 0; i < f->count; i++) {
        squares += (double)(f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]);
        sum += (double)f->y[i];
    }
    *speed = sqrt(squares / f->count);
    *height = sum / f->count;
}
