/* Chips: one for every instrument, with its reading; a tap opens its plot. */
#ifndef SKVALP_PLAY_CHIPS_H
#define SKVALP_PLAY_CHIPS_H

#include "view.h"

typedef struct PlayChips PlayChips;

/* Chips in a box, which shows while there are any. */
PlayChips *play_chips_new(PlayView *view, GtkBox *tray);
void play_chips_free(PlayChips *chips);

/* Brings them in line with the picture. */
void play_chips_show(PlayChips *chips);

/* The number by which an instrument is known, until it is asked for again. */
const char *play_chip_number(guint32 probe);

#endif
