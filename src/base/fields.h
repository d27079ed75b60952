/* What all lists of fields share: finding a path, reading a value, and the words for both. */
#ifndef SKV_BASE_FIELDS_H
#define SKV_BASE_FIELDS_H

#include "skvalp/fields.h"

/* Room for any path, indices included. */
#define SKV_PATH_SIZE 128

/* The field with a path, or -1. */
int skv_field_find(const skv_field *fields, int count, const char *path);

/* What belongs to an unknown path: "; did you mean fluid.spacing?", or the names allowed there. */
void skv_field_suggest(const skv_field *fields, int count, const char *path, char *text,
                       size_t size);

/* What a field allows: "allowed is a number from 0.0005 to 0.1 m". */
void skv_field_allowed(const skv_field *field, char *text, size_t size);

/* The index of a choice in "a|b|c", or -1; how many there are. */
int skv_field_choice(const char *choices, const char *text);
int skv_field_choices(const char *choices);

/* What is wrong with a number for a number's or whole number's field, "is out of range"; null if
 * nothing is. */
const char *skv_field_complaint(const skv_field *field, double number);

/* Reads a value from text: a number, a choice's index, 0 or 1. What is wrong with it, or null. Not
 * for texts. */
const char *skv_field_read(const skv_field *field, const char *text, double *number);

/* The reverse: a number, a choice's name, true or false. */
void skv_field_write(const skv_field *field, double number, char *text, size_t size);

/* Fails with "PATH: WHAT WRONG; what is allowed". */
skv_result skv_field_refuse(const skv_field *field, const char *what, const char *wrong,
                            skv_error *error);

/* A number as a person writes it; at most 32 bytes. */
void skv_format_number(double value, char text[32]);
/* The same of a float, with as many digits as tell it from its neighbours, so that what is out of a
 * range by little does not read as its bound. */
void skv_format_float(double value, char text[32]);

#endif
