/* Pace: how many frames are due, and how far the machine keeps up. */
#ifndef SKV_SESSION_PACE_H
#define SKV_SESSION_PACE_H

#include <stdbool.h>

typedef struct skv_pace {
    double speed;        /* simulated over real seconds, as wished */
    double due;          /* frames, a fraction between calls */
    double step_cost;    /* s a frame, averaged; 0: not known */
    double drawing;      /* s a picture, averaged */
    double real, wished; /* s since the last measurement: that passed; simulated if none is lost */
    double simulated;
    double factor; /* simulated over wished: below 1 the machine is too slow */
} skv_pace;

skv_pace skv_pace_start(void);

/* s that stepping may take at once: two frames. A thread beside the face may go on for as long as
 * it takes to draw, `interval` between two pictures of the face; where the face waits for the
 * steps, `drawing` goes off that, but a third of the time at least is the world's. */
double skv_pace_budget(bool beside, double interval, double drawing);

/* Lets real time pass; the frames to step now. `budget`: seconds that stepping may take. */
int skv_pace_pass(skv_pace *pace, double seconds, double budget);

/* The same while no frame can be stepped. */
void skv_pace_wait(skv_pace *pace, double seconds);

/* Notes what a frame took to step, and what a picture took to draw, s. */
void skv_pace_stepped(skv_pace *pace, double seconds);
void skv_pace_drawn(skv_pace *pace, double seconds);

/* Nothing is due, as after a pause. */
void skv_pace_rest(skv_pace *pace);

#endif
