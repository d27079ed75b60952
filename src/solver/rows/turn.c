/* How unlike particles turn about each other, solver/turn.h, and push each other apart, in the
 * rows. Rare, so one pair after the other and once for all instruction sets. Invariant: a row adds
 * to its own displacements and to those that it adds to the next row's, pair by pair in the order
 * of places. */
#include "solver/turn.h"

#include "solver/rows/rows_internal.h"

#include <math.h>
#include <string.h>

typedef struct turning {
    const skv_rows *rows;
    const skv_row_particles *p;
    const skv_constants *c;
    const skv_boundary *boundary;
} turning;

/* Turns a and b, if they are unlike and one lies wrong, in the displacements `to` of b. */
static void turn_pair(const turning *t, int a, int b, const skv_row_moves *to)
{
    const skv_row_particles *p = t->p;
    const skv_row_acting *acting = &t->rows->acting;
    float own = p->lightness[a], other = p->lightness[b];
    if (own == other)
        return;
    float x = p->x[b] - p->x[a], y = p->y[b] - p->y[a], square = x * x + y * y;
    const float reach = t->c->turn_reach;
    if (!(square < reach * reach && square > 0))
        return;
    float lighter = own > other ? own : other;
    /* Above 0 where a is the heavier one, then where b lies below. */
    float contrast = SKV_TURN_CONTRAST * (other - own) / lighter;
    contrast = contrast > 1 ? 1 : contrast < -1 ? -1 : contrast;
    float below = contrast * (x * acting->gravity_x + y * acting->gravity_y);
    if (!(below > 0))
        return;
    if (skv_boundary_has_thin(t->boundary) &&
        skv_boundary_occluded(t->boundary, p->x[a], p->y[a], 0, p->x[b], p->y[b], 0))
        return;
    float sense =
        skv_turn_sense((uint32_t)(p->number[a] & ~ROW_HELD), (uint32_t)(p->number[b] & ~ROW_HELD));
    float turn = SKV_TURN * acting->turn_sense * sense * below * (reach - sqrtf(square)) /
                 (reach * lighter * square);
    float dx = turn * y, dy = turn * x;
    t->rows->own_move.x[a] += dx;
    t->rows->own_move.y[a] -= dy;
    to->x[b] -= dx;
    to->y[b] += dy;
}

/* Which bits of the lightness differ from those in first..end: of several at once, if a compiler
 * knows how. */
static uint32_t difference(const float *lightness, uint32_t bits, int first, int end)
{
    uint32_t off = 0;
    for (int j = first; j < end; j++) {
        uint32_t other;
        memcpy(&other, lightness + j, sizeof other);
        off |= other ^ bits;
    }
    return off;
}

void skv_rows_turn_unlike(const skv_rows *s, int row, const skv_constants *c,
                          const skv_boundary *boundary)
{
    const turning t = {s, &s->set[s->current], c, boundary};
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_TILE) {
        const int tile = i / ROW_TILE, begin = s->next_begin[tile], end = s->next_end[tile];
        const int own_end = s->own_end[tile];
        uint32_t bits;
        memcpy(&bits, t.p->lightness + i, sizeof bits);
        if (!(difference(t.p->lightness, bits, i, own_end) |
              difference(t.p->lightness, bits, begin, end)))
            continue;
        for (int a = i; a < i + ROW_TILE && a < s->row_end[row]; a++) {
            for (int b = a + 1; b < own_end; b++)
                turn_pair(&t, a, b, &s->own_move);
            for (int b = begin; b < end; b++)
                turn_pair(&t, a, b, &s->next_move);
        }
    }
}

/* Number of the fluid of the particle in a place. */
static int fluid_at(const skv_rows *s, int place)
{
    return s->frame->particles->fluid[s->set[s->current].number[place] & ~ROW_HELD];
}

/* Pushes a and b apart, in the displacements `to` of b, if they are of two fluids. */
static void push_pair(const skv_rows *s, const skv_boundary *boundary, int a, int b,
                      const skv_row_moves *to)
{
    const skv_row_particles *p = &s->set[s->current];
    const int own = fluid_at(s, a), other = fluid_at(s, b);
    float x = p->x[b] - p->x[a], y = p->y[b] - p->y[a], square = x * x + y * y;
    if (own == other || !(square < 1 && square > 0))
        return;
    if (skv_boundary_has_thin(boundary) &&
        skv_boundary_occluded(boundary, p->x[a], p->y[a], 0, p->x[b], p->y[b], 0))
        return;
    const skv_row_frame *frame = s->frame;
    const skv_liquid *liquids = frame->particles->liquids;
    float strength = skv_maxf(liquids[own].interface_push, liquids[other].interface_push);
    float lighter = skv_minf(skv_row_mass(s, a), skv_row_mass(s, b)), q = 1 - sqrtf(square);
    /* F over r, as the unit vector is (x, y) over r; m/s^2 in h a substep squared. */
    float push = frame->lambda / 2 * strength * lighter * (q * q);
    s->own_move.x[a] -= push * x;
    s->own_move.y[a] -= push * y;
    to->x[b] += push * x;
    to->y[b] += push * y;
}

/* Whether there is another fluid than that of place i in first..end. */
static bool has_other(const skv_rows *s, int i, int first, int end)
{
    const int own = fluid_at(s, i);
    for (int j = first; j < end; j++)
        if (fluid_at(s, j) != own)
            return true;
    return false;
}

void skv_rows_push_unlike(const skv_rows *s, int row, const skv_boundary *boundary)
{
    for (int i = s->row_start[row]; i < s->row_end[row]; i += ROW_TILE) {
        const int tile = i / ROW_TILE, begin = s->next_begin[tile], end = s->next_end[tile];
        const int own_end = s->own_end[tile];
        if (!has_other(s, i, i, own_end) && !has_other(s, i, begin, end))
            continue;
        for (int a = i; a < i + ROW_TILE && a < s->row_end[row]; a++) {
            for (int b = a + 1; b < own_end; b++)
                push_pair(s, boundary, a, b, &s->own_move);
            for (int b = begin; b < end; b++)
                push_pair(s, boundary, a, b, &s->next_move);
        }
    }
}
