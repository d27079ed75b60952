/* Sleep: regions whose particles have been still for a while are not stepped; see sleep.c. */
#ifndef SKV_CALM_SLEEP_H
#define SKV_CALM_SLEEP_H

#include "skvalp/base.h"

typedef struct skv_world skv_world;

/* A particle's unrest. New unrest becomes unrest at the next look round, and only after the one
 * that follows can the particle be calm: it is watched for a whole window at least. */
typedef enum skv_unrest {
    SKV_CALM,
    SKV_RESTLESS,
    SKV_NEWLY_RESTLESS,
    SKV_LEAVING /* is taken out before anything else happens */
} skv_unrest;

/* What is known of a tile: its state, and what its particles did. */
typedef struct skv_tile {
    int state; /* sleep.c */
    int count;
    float moved_x, moved_y; /* sum of the ways since the last look round, m */
    float speed_x, speed_y; /* sum of the velocities, m/s */
    float farthest;         /* longest way, m, squared */
} skv_tile;

typedef struct skv_sleep {
    bool allowed;
    skv_tile *tiles;
    int calm;       /* particles that are */
    int stepped;    /* particles that the last substeps moved, and those added since */
    double watched; /* s since the last look round */
} skv_sleep;

/* Makes the tiles of a world whose tiling is known. */
skv_result skv_sleep_create(skv_world *world, bool allowed, skv_error *error);
void skv_sleep_destroy(skv_world *world);

/* A particle has been added, or something has been done to it. */
void skv_sleep_wake(skv_world *world, int particle);
void skv_sleep_wake_all(skv_world *world);

/* Marks a particle as leaving; it no longer counts as calm or stepped. */
void skv_sleep_leave(skv_world *world, int particle);

/* Wakes what lies within h of places where something is done: between begin and end, `disturb`
 * takes the places, those of particles. */
void skv_sleep_begin_disturbance(skv_world *world);
void skv_sleep_disturb(skv_world *world, int particle);
void skv_sleep_end_disturbance(skv_world *world);

/* Before substeps of `dt` seconds in all: chooses who takes part. Returns how many move, and in
 * `partial` whether the particles' `part` says who, because not all do. */
int skv_sleep_plan(skv_world *world, float dt, bool *partial);

/* After them: who has moved, and who has come to rest. */
void skv_sleep_watch(skv_world *world, float dt);

#endif
