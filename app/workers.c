/* Workers: threads that draw without a display, apart from that of the interface. Invariant: none
 * of them lives when the program ends, for it takes from a thread what it draws with, and libglvnd
 * then frees twice what it keeps of a thread. */
#include "workers.h"

typedef struct worker {
    GThread *thread;
    GThreadFunc work;
    gpointer data;
} worker;

/* Those not joined yet; the main thread's. */
static GList *workers;

static gboolean join(gpointer data)
{
    worker *w = data;
    workers = g_list_remove(workers, w);
    g_thread_join(w->thread);
    g_free(w);
    return G_SOURCE_REMOVE;
}

static gpointer run(gpointer data)
{
    worker *w = data;
    w->work(w->data);
    g_idle_add(join, w);
    return NULL;
}

void play_workers_start(const char *name, GThreadFunc work, gpointer data)
{
    worker *w = g_new(worker, 1);
    *w = (worker){.work = work, .data = data};
    workers = g_list_prepend(workers, w);
    w->thread = g_thread_new(name, run, w);
}

void play_workers_finish(void)
{
    while (workers)
        join(workers->data);
}
