/* How alike names are. */
#ifndef SKV_BASE_NAMES_H
#define SKV_BASE_NAMES_H

/* Levenshtein distance of two texts, both cut to 127 bytes. */
int skv_edit_distance(const char *a, const char *b);

#endif
