/* Workers: threads that draw without a display, apart from that of the interface. */
#ifndef SKVALP_PLAY_WORKERS_H
#define SKVALP_PLAY_WORKERS_H

#include <glib.h>

/* Runs `work` with `data` on a thread of its own, from the main thread. What it has to tell goes to
 * the main loop. */
void play_workers_start(const char *name, GThreadFunc work, gpointer data);

/* Waits until all have ended, after the main loop: what they do ends early where its owner is gone.
 */
void play_workers_finish(void);

#endif
