/* Task pool: runs one function over a range of indices on several threads.
 *
 * The range is cut into chunks that do not depend on the number of threads; which thread runs
 * which chunk must not matter to the result. With one thread nothing is created at all.
 */
#ifndef SKV_BASE_POOL_H
#define SKV_BASE_POOL_H

#include "skvalp/base.h"

typedef struct skv_pool skv_pool;

/* Handles indices begin..end-1. */
typedef void skv_task(int begin, int end, void *context);

/* Creates a pool of `threads` threads, the caller's included; 0: one per physical core. */
skv_result skv_pool_create(int threads, skv_pool **pool, skv_error *error);
void skv_pool_destroy(skv_pool *pool);
int skv_pool_threads(const skv_pool *pool);

/* Runs `task` over 0..count-1 and returns when all of it is done; without a pool (null) on the
 * calling thread. Not reentrant. */
void skv_pool_run(skv_pool *pool, int count, skv_task *task, void *context);

#endif
