/* Experiment cards: question, prediction, measurement and comparison, one below the other. */
#ifndef SKVALP_PLAY_CARDS_H
#define SKVALP_PLAY_CARDS_H

#include <adwaita.h>
#include <skvalp/render.h>

/* A box of buttons, one an experiment; they activate "win.experiment" with its number. */
GtkWidget *play_cards_list(void);

/* The card of an experiment, to be shown on a page of its own. Its run ends with the widget. */
GtkWidget *play_card_new(int experiment, const skv_render_style *style);

#endif
