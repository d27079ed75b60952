/* Tools: what pointers do to a world, as commands, and what shows of it. */
#ifndef SKV_SESSION_TOOLS_H
#define SKV_SESSION_TOOLS_H

#include "session/packed_log.h"
#include "session/pointers.h"
#include "skvalp/player.h"

/* What people have chosen for pointers that go down. */
typedef struct skv_chosen {
    int tool;
    double brush; /* m; 0: by the world's size */
    int dye;      /* of tools that dye */
    int fluid;    /* of those that pour; the first, where a world lacks it */
    int shape;    /* of those that drop bodies, as skv_drop_shape */
} skv_chosen;

/* What tools are given to work with. */
typedef struct skv_toolbox {
    skv_pointers pointers;
    skv_chosen chosen;
    double world_size; /* m, the longer side */
    int fluids;        /* of the world */
    skv_steps steps;   /* of what pointers do */
    bool hovering;     /* a pointer that is not down is at (hover_x, hover_y) */
    double hover_x, hover_y;

    /* Does a command now; `user` is its. */
    void (*apply)(const skv_command *command, void *user);
    void *user;
} skv_toolbox;

/* How far a piece of time goes: before one frame of several that are stepped at once. */
typedef struct skv_slice {
    double share;     /* of the pointers' way since the last frame stepped, 0..1 */
    double real;      /* real seconds that this 1/60 s of the world takes */
    bool slow_motion; /* it takes longer than a real 1/60 s */
} skv_slice;

/* Events of pointers, those of the view in metres. */
void skv_tools_event(skv_toolbox *box, const skv_pointer_event *event);
void skv_tools_cancel(skv_toolbox *box);

/* What brushes have to draw of the ways that their pointers have gone. */
void skv_tools_draw(skv_toolbox *box);

/* Before a frame of a world is stepped: moves on what hands hold, and draws. Writes the hands that
 * act. */
int skv_tools_frame(skv_toolbox *box, const skv_world *world, const skv_slice *slice,
                    skv_hand hands[SKV_MAX_HANDS]);

/* Whether anything happens while the world rests. */
bool skv_tools_busy(const skv_toolbox *box);

/* What shows. Returns the number. */
int skv_tools_marks(const skv_toolbox *box, skv_mark marks[SKV_MOST_MARKS]);

/* Radius of the tool chosen, m. */
double skv_tools_radius(const skv_toolbox *box, int tool);

#endif
