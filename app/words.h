/* Words: what the app says of pictures and readings, in the user's language. */
#ifndef SKVALP_PLAY_WORDS_H
#define SKVALP_PLAY_WORDS_H

#include <glib.h>
#include <glib/gi18n.h>
#include <skvalp/controls.h>
#include <skvalp/numbers.h>

/* Finds the translations: those installed beside the program, or those of its build folder. */
void play_words_load(void);

/* A text of the library's tables, translated; null and "" stay what they are. */
const char *play_word(const char *text);

/* The title of a parameter, "Wall friction" of "fluid.wall_friction": as written in the library, or
 * translated. To be freed. */
char *play_english_title_of_path(const char *path);
char *play_title_of_path(const char *path);

/* Whether readings are in SI units; at first they are in those that people know. */
void play_words_set_si(bool si);
bool play_words_si(void);

/* A number as people here read it, with so many decimals or significant digits. */
skv_digits play_number(double value, int decimals);
skv_digits play_number_short(double value, int digits);
const skv_numerals *play_numerals(void);

/* The unit of a reading in an SI unit. */
skv_unit play_unit_of(const char *si);

/* A reading in that unit: "24,5 cm vatten". To be freed. */
char *play_words_of_reading(double value, const char *si);

/* The channel that a kind of instrument is read for; and what one reads there, or why it doesn't:
 * "no water here". To be freed. */
int play_main_channel(skv_instrument_kind kind);
char *play_words_of_probe(const skv_probe *probe);

/* Words of the library's with two "%s", for numbers. To be freed. */
char *play_words_with(const char *words, double first, double second);

/* A number with a unit as it is: "2,4 s". To be freed. */
char *play_quantity(double value, int decimals, const char *unit);

/* An axis of readings in `*size` of the SI unit: "pressure (cm of water)". To be freed. */
char *play_words_of_quantity(const char *name, const char *si, double *size);

/* How much water there is: "12 960 particles". To be freed. */
char *play_words_of_amount(const skv_picture *picture);

/* What a picture of a stage shows, to be read out: "2960 particles, at rest". To be freed. */
char *play_words_of_picture(const skv_stage *stage, const skv_picture *picture);

/* How fast it goes: "0.4× of real time", "at rest", "paused". To be freed. */
char *play_words_of_pace(const skv_stage *stage);

#endif
