/* Comparing: a second world beside the first, the same scene with another liquid or resolution. */
#ifndef SKVALP_PLAY_COMPARE_H
#define SKVALP_PLAY_COMPARE_H

#include "window.h"

/* Adds the actions "compare", "toggle-compare", "close-compare" and "compare-linked", and a way to
 * them in the panel of properties, which shows one of the two worlds. */
void play_compare_add(PlayWindow *window);

#endif
