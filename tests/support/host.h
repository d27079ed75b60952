/* A host program that lends its threads. */
#ifndef SKV_TEST_HOST_H
#define SKV_TEST_HOST_H

/* Calls member(team) on `threads` fresh threads at the same time, at most 8; returns when all are
 * done. */
void host_run(int threads, void (*member)(void *team), void *team);

#endif
