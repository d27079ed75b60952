/* Threads in WebAssembly: workers of the host, each an instance of the module over the same memory,
 * that have come in through skv_wasm_serve and wait in a seat for work.
 *
 * Invariant: a seat changes hands by its state alone, and only its worker leaves SEAT_TAKEN. Where
 * memory is not shared nobody comes in, no thread can be started, and nothing here ever waits.
 *
 * A host's thread that must not block, such as a page's, must not step on more than one thread.
 */
#include "base/memory.h"
#include "base/platform.h"
#include "base/wasm/host.h"

/* A worker of the host comes in, on a stack of its own, to stay; it returns only if there is no
 * seat left. And how many have come in. */
SKV_EXPORT(skv_wasm_serve) void skv_wasm_serve(void);
SKV_EXPORT(skv_wasm_servants) int skv_wasm_servants(void);

enum { MOST_SEATS = 64 };
/* A seat is EMPTY until a worker comes, IDLE while that waits, CLAIMED while it is told what to do,
 * and TAKEN until that is done. */
typedef enum seat_state { SEAT_EMPTY, SEAT_IDLE, SEAT_CLAIMED, SEAT_TAKEN } seat_state;

typedef struct seat {
    atomic_uint state; /* seat_state */
    void (*work)(void *argument);
    void *argument;
    skv_threads *threads;
} seat;

struct skv_threads {
    atomic_uint running;
    atomic_uint sleepers;
    atomic_uint calls; /* raised to wake them */
};

static seat seats[MOST_SEATS];
static atomic_uint seats_given;

/* Waits until somebody calls wake_all for a word, unless it is not `old` any more. A function of
 * its own: inlined into a loop, V8 11's quick compiler has it wait at address 0, for ever. */
__attribute__((noinline)) static void wait_while(atomic_uint *word, unsigned old)
{
    __builtin_wasm_memory_atomic_wait32((int *)(void *)word, (int)old, -1);
}

static void wake_all(atomic_uint *word)
{
    __builtin_wasm_memory_atomic_notify((int *)(void *)word, ~0u);
}

static void serve(seat *own)
{
    for (;;) {
        for (unsigned state; (state = atomic_load(&own->state)) != SEAT_TAKEN;)
            wait_while(&own->state, state);
        skv_threads *threads = own->threads;
        own->work(own->argument);
        /* Free for others before it is known to be done; after that the group may be gone. */
        atomic_store(&own->state, SEAT_IDLE);
        atomic_fetch_sub(&threads->running, 1);
        wake_all(&threads->running);
    }
}

void skv_wasm_serve(void)
{
    unsigned place = atomic_fetch_add(&seats_given, 1);
    if (place >= MOST_SEATS)
        return;
    atomic_store(&seats[place].state, SEAT_IDLE);
    serve(&seats[place]);
}

int skv_wasm_servants(void)
{
    int count = 0;
    for (int i = 0; i < MOST_SEATS; i++)
        count += atomic_load(&seats[i].state) != SEAT_EMPTY;
    return count;
}

int skv_platform_cores(void)
{
    return 1 + skv_wasm_servants();
}

void skv_platform_yield(void)
{
}

skv_threads *skv_threads_create(void)
{
    return skv_calloc(1, sizeof(skv_threads));
}

bool skv_threads_start(skv_threads *threads, void (*work)(void *argument), void *argument)
{
    for (int i = 0; i < MOST_SEATS; i++) {
        unsigned idle = SEAT_IDLE;
        if (!atomic_compare_exchange_strong(&seats[i].state, &idle, SEAT_CLAIMED))
            continue;
        seats[i].work = work;
        seats[i].argument = argument;
        seats[i].threads = threads;
        atomic_fetch_add(&threads->running, 1);
        atomic_store(&seats[i].state, SEAT_TAKEN);
        wake_all(&seats[i].state);
        return true;
    }
    return false;
}

void skv_threads_join(skv_threads *threads)
{
    if (!threads)
        return;
    for (unsigned running; (running = atomic_load(&threads->running)) > 0;)
        wait_while(&threads->running, running);
    skv_free(threads);
}

/* A sleeper counts itself before it looks at the counter, and who wakes looks for sleepers after
 * the counter has changed: one of the two sees the other. A call between its look and its wait has
 * changed `calls`, so it does not wait. */
void skv_threads_sleep(skv_threads *threads, atomic_uint *counter, unsigned old)
{
    atomic_fetch_add(&threads->sleepers, 1);
    for (;;) {
        unsigned calls = atomic_load(&threads->calls);
        if (atomic_load(counter) != old)
            break;
        wait_while(&threads->calls, calls);
    }
    atomic_fetch_sub(&threads->sleepers, 1);
}

void skv_threads_wake(skv_threads *threads)
{
    if (atomic_load(&threads->sleepers) == 0)
        return;
    atomic_fetch_add(&threads->calls, 1);
    wake_all(&threads->calls);
}
