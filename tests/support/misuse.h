/* How often the library was misused: an assert handler that counts. */
#ifndef SKV_TEST_MISUSE_H
#define SKV_TEST_MISUSE_H

/* Since misuse_begin. */
extern int misuses;

/* A test's set-up and tear-down, or calls within one: from 0 on misuse is counted; it ends the
 * program again. Both return 0; the pointer says nothing. */
int misuse_begin(void **unused);
int misuse_end(void **unused);

#endif
