/* What the core asks of the system it runs on, and all of it.
 *
 * Besides, the core needs no more of a C library than <math.h>'s sqrt, fabs, ceil, floor and
 * isfinite and <string.h>'s mem... and strcmp: it is freestanding. What is in posix/ implements
 * this for Linux and its kin, windows/platform.c for Windows, wasm/platform.c for WebAssembly
 * without any library.
 */
#ifndef SKV_BASE_PLATFORM_H
#define SKV_BASE_PLATFORM_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

/* Memory for programs that set no hooks of their own, aligned to SKV_ALIGNMENT; null if there is
 * none left. */
void *skv_platform_allocate(size_t bytes);
void skv_platform_release(void *memory);

/* Writes a text of `length` bytes to the standard error, where there is one, and ends the program:
 * a caller's mistake that no assert handler wanted to know of. */
_Noreturn void skv_platform_abort(const char *text, size_t length);

/* Seconds from an arbitrary origin, monotonic; always 0 where there is no clock. */
double skv_clock(void);

/* Physical cores, at least 1. */
int skv_platform_cores(void);

/* Lets another thread run. */
void skv_platform_yield(void);

/* Threads, and a place to wait for those that have nothing to do. */
typedef struct skv_threads skv_threads;

/* An empty group of threads; null if memory is out. */
skv_threads *skv_threads_create(void);

/* Starts a thread that runs `work`; false if the system has none left, or has no threads. */
bool skv_threads_start(skv_threads *threads, void (*work)(void *argument), void *argument);

/* Waits until all threads have returned, then frees the group; null is allowed. */
void skv_threads_join(skv_threads *threads);

/* Sleeps as long as *counter is `old`. */
void skv_threads_sleep(skv_threads *threads, atomic_uint *counter, unsigned old);

/* Wakes the sleepers; to be called after a counter has changed. Costs next to nothing if there are
 * none. */
void skv_threads_wake(skv_threads *threads);

#endif
