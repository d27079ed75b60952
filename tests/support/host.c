/* A host program that lends its threads. Invariant: no thread is left when a call returns. */
#include "support/host.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { MOST = 8 };

typedef struct job {
    void (*member)(void *team);
    void *team;
} job;

static void *work(void *argument)
{
    const job *j = argument;
    j->member(j->team);
    return NULL;
}

void host_run(int threads, void (*member)(void *team), void *team)
{
    assert_in_range(threads, 0, MOST);
    job j = {member, team};
    pthread_t thread[MOST];
    for (int t = 0; t < threads; t++)
        assert_int_equal(pthread_create(&thread[t], NULL, work, &j), 0);
    for (int t = 0; t < threads; t++)
        pthread_join(thread[t], NULL);
}
