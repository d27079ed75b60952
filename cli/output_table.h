/* The two tables of a run: the trace of every particle, and the time series of the whole. */
#ifndef CLI_OUTPUT_TABLE_H
#define CLI_OUTPUT_TABLE_H

#include "output_file.h"
#include "skvalp/bodies.h"
#include "skvalp/query.h"
#include "skvalp/scene.h"

void trace_head(output_file *file);
void trace_rows(output_file *file, const skv_world *world, double time);

/* The name of a body: the scene's, or else "body 1" and so on, written to `number`. */
const char *body_name(const skv_scene *scene, skv_body_id id, char number[32]);

/* The bodies that a time series has columns of: those that there are at its start. */
typedef struct series_bodies {
    int count;
    skv_body_id id[SKV_MAX_BODIES];
} series_bodies;

/* Behind the columns of all are those of each fluid, if there are several, and of each body.
 * `scene` may be null. The cells of a body that has left are empty. */
void series_head(output_file *file, const skv_world *world, const skv_scene *scene,
                 series_bodies *bodies);
void series_row(output_file *file, const skv_world *world, const series_bodies *bodies,
                const skv_packing *packing, double time);

#endif
