/* The few lines of JSON that the command line prints. */
#ifndef CLI_JSON_H
#define CLI_JSON_H

#include <stdio.h>

/* A string with its quotes; bytes that are no UTF-8 become U+FFFD. */
void json_text(FILE *out, const char *text);

/* A number, or null where JSON has none for it (infinities, NaN). */
void json_number(FILE *out, double value);

#endif
