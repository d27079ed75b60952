/* What the stage's tests share. Invariant: after each call here but stage_make all that was asked
 * for has been done. */
#ifndef SKV_TESTS_SESSION_SUPPORT_H
#define SKV_TESTS_SESSION_SUPPORT_H

#include <skvalp/stage.h>

double stage_still(void);
skv_stage *stage_make(bool own_thread, double (*clock)(void));

/* A stage with a pool in a view of 1600 x 900 pixels: 1000 of them are a metre. */
skv_stage *stage_open_pool(int particles, bool own_thread);
const skv_picture *stage_look(skv_stage *stage, int side);
uint64_t stage_hash(skv_stage *stage, int side);

/* All worlds are at one moment; which. */
int64_t stage_moment(skv_stage *stage);
void stage_pass(skv_stage *stage, double seconds);
void stage_pass_frames(skv_stage *stage, int frames);

/* What was to be compared is there, or is not. */
skv_outcome stage_compared(skv_stage *stage);
void stage_ask_compare(skv_stage *stage, int particles, const char *path, const char *value);
void stage_compare(skv_stage *stage, int particles, const char *path, const char *value);
void stage_point(skv_stage *stage, int side, skv_phase phase, double px, double py, double time);
void stage_draw_wall(skv_stage *stage, int side, double px);

/* A player of 300 particles in a pool, with a fluid "oil" beside water; `history` in bytes, 0: as
 * by default. */
skv_player *open_player(size_t history);

/* Set up and tear down tests of such a pool of 200 particles. */
int stage_setup(void **state);
int stage_setup_thread(void **state);
int stage_teardown(void **state);

/* Lets real time pass, and waits; returns the frames stepped. */
int stage_advance(skv_stage *stage, double seconds);

void stage_copy(skv_stage *stage, skv_picture *picture); /* all but what it points at */

/* A pointer of a device, at a view pixel. */
void stage_touch(skv_stage *stage, skv_phase phase, skv_device device, uint64_t pointer, double px,
                 double py, double time);

/* Another stage, on which the link to what this one has played is open, at the same moment. Fails
 * the test unless its worlds are as here. */
skv_stage *stage_open_shared(skv_stage *stage);

/* The next report's result; -1 if there is none. */
int stage_report(skv_stage *stage, skv_outcome *report);

#endif
