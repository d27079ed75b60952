/* Emitters and drains: what may be one, and where its particles appear. */
#ifndef SKV_WORLD_EMITTERS_H
#define SKV_WORLD_EMITTERS_H

#include "world/acting.h"

/* Of a world with so many fluids. */
skv_result skv_check_emitters(const skv_emitter *emitters, int count, int fluids, skv_error *error);
skv_result skv_check_drains(const skv_drain *drains, int count, skv_error *error);

/* change.c: the same, and whether they are too wide for a world's fluid. */
skv_result skv_world_check_emitters(const skv_world *world, const skv_emitter *emitters, int count,
                                    skv_error *error);

/* change.c: whether an emitter goes on as another one without a gap. */
bool skv_emitter_goes_on(const skv_emitter *emitter, const skv_emitter *other);

/* An emitter that begins, when the next particle has this id. */
skv_stream skv_new_stream(skv_particle_id next);

float skv_emitter_speed(const skv_emitter *emitter);

/* The mouth, whose four corners go to `corners`: fluid in it has the emitter's velocity. */
skv_region skv_mouth(const skv_emitter *emitter, float h, float corners[8]);
void skv_make_mouth_force(const skv_emitter *emitter, float h, skv_external_force *force);

enum { SKV_MOST_COLUMNS = 1000 };

/* The rows in which an emitter emits: `columns` particles, `apart` m from each other, a row every
 * `way` m: one particle per spacing squared, whatever the width. */
typedef struct skv_emitter_rows {
    int columns;
    double apart, way;
    double dx, dy; /* unit vector along the velocity */
} skv_emitter_rows;
skv_emitter_rows skv_emitter_lay_out(const skv_emitter *emitter, float spacing);

/* Whether an emitter is too wide for its rows, and in `text` what is wrong with it then: "is ... m
 * wide; ...". */
bool skv_emitter_is_wide(const skv_emitter *emitter, float spacing, char *text, size_t size);

/* Where a particle of a row lies when the row has gone `way` m from the line. */
void skv_emitter_place(const skv_emitter *emitter, const skv_emitter_rows *rows, double way,
                       bool odd, int column, float *x, float *y);

skv_result skv_exchange_flow(skv_port *port, skv_acting *acting, int fluids, skv_error *error);

#endif
