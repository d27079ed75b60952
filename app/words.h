/* Words: what the app says of pictures and readings, in the user's language. */
#ifndef SKVALP_PLAY_WORDS_H
#define SKVALP_PLAY_WORDS_H

#include <glib.h>
#include <glib/gi18n.h>
#include <skvalp/session.h>

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

/* The unit, translated, in which a reading in `unit` is shown, as skv_reading_unit says it. */
const char *play_word_of_unit(const char *unit, double *size);

/* A reading in that unit, as skv_format_reading writes it: "24.5 cm vattenpelare". To be freed. */
char *play_words_of_reading(double value, const char *unit);

/* An axis of readings: "pressure (cm of water)". To be freed. */
char *play_words_of_quantity(const char *name, const char *unit, double *size);

/* How much water there is: "12 960 particles". To be freed. */
char *play_words_of_amount(const skv_picture *picture);

/* What a picture shows, to be read out: "2960 particles, at rest". To be freed. */
char *play_words_of_picture(const skv_picture *picture);

/* How fast it goes: "0.4× of real time", "at rest", "paused". To be freed. */
char *play_words_of_pace(const skv_picture *picture);

/* Whether the machine cannot keep up. */
bool play_is_slow(const skv_picture *picture);

#endif
