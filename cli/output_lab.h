/* What lab prints of an experiment: a table, or rows of JSON. */
#ifndef CLI_OUTPUT_LAB_H
#define CLI_OUTPUT_LAB_H

#include "lab_starts.h"

/* The table of an experiment: `report` is that of its first start. */
void lab_table(const skv_experiment *info, const skv_report *report, const lab_figure *figures);

/* An object of the list of rows, which has `number` before it. */
skv_result lab_json(int number, const lab_figure *figure, skv_error *error);

#endif
