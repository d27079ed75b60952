/* The two tables of a run: the trace of every particle, and the time series of the whole. */
#ifndef CLI_OUTPUT_TABLE_H
#define CLI_OUTPUT_TABLE_H

#include "output_file.h"
#include "skvalp/query.h"

void trace_head(output_file *file);
void trace_rows(output_file *file, const skv_world *world, double time);

/* Of several fluids each has columns of its own behind those of all. */
void series_head(output_file *file, const skv_world *world);
void series_row(output_file *file, const skv_world *world, const skv_packing *packing, double time);

#endif
