/* What the command line prints as JSON. */
#ifndef CLI_OUTPUT_JSON_H
#define CLI_OUTPUT_JSON_H

#include <jansson.h>

#include "skvalp/base.h"

/* A string; bytes that are no UTF-8 become U+FFFD. */
json_t *output_text(const char *text);

/* A number of twelve digits, written without a point if it is whole; null where JSON has none for
 * it (infinities, NaN). */
json_t *output_number(double value);

/* Prints a value, which is released, and ends the line. What was made without memory (null) fails.
 */
skv_result output_json(json_t *value, skv_error *error);

/* Prints a list, one element a line: begin, then each with its number from 0, then end. */
void output_list_begin(void);
skv_result output_list_add(int number, json_t *value, skv_error *error);
void output_list_end(void);

#endif
