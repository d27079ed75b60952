/* What the stage's tests share. Invariant: after each call here but stage_make all that was asked
 * for has been done. */
#ifndef SKV_TESTS_SESSION_STAGE_SUPPORT_H
#define SKV_TESTS_SESSION_STAGE_SUPPORT_H

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

#endif
