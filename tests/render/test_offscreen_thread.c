/* A host's thread may draw without a display and outlive the program's end: exit takes down the
 * graphics library first, and what that keeps of a thread has to be gone by then, or the thread's
 * own end frees it twice. Here the thread ends just then. */
#define _DEFAULT_SOURCE 1 /* on_exit */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <pthread.h>
#include <semaphore.h>

#include <skvalp/render.h>

static pthread_t thread;
static sem_t drawn, ends;
static skv_result result;

static void *draw_and_stay(void *none)
{
    skv_offscreen *offscreen = NULL;
    result = skv_offscreen_create(64, 36, &offscreen, NULL);
    skv_offscreen_destroy(offscreen);
    sem_post(&drawn);
    while (sem_wait(&ends))
        continue;
    return none;
}

static void end_thread(int status, void *none)
{
    (void)status, (void)none;
    sem_post(&ends);
    pthread_join(thread, NULL);
}

/* What is asked for first comes last, and here, before all libraries have begun, after their end.
 */
static void ask_for_the_last(void)
{
    on_exit(end_thread, NULL);
}
__attribute__((section(".preinit_array"), used)) static void (*first)(void) = ask_for_the_last;

static void a_thread_may_end_after_the_program(void **state)
{
    (void)state;
    while (sem_wait(&drawn))
        continue;
    assert_int_equal(result, SKV_OK); /* and then main returns */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_thread_may_end_after_the_program)};
    if (sem_init(&drawn, 0, 0) || sem_init(&ends, 0, 0) ||
        pthread_create(&thread, NULL, draw_and_stay, NULL))
        abort();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
