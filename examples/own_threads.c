/* A program that has threads of its own lends them to the fluid. Here a team of three waits for
 * work, as a game's job system does; a world steps on it and on one thread, and the bits are the
 * same. */
#include <skvalp/skvalp.h>

#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>

enum { WORKERS = 3 };

/* The program's own job system: every worker runs the job of each round once. */
typedef struct jobs {
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    int round, running; /* number of the present round; workers still in it */
    bool quit;
    void (*member)(void *team);
    void *team;
} jobs;

static void *work(void *argument)
{
    jobs *j = argument;
    pthread_mutex_lock(&j->mutex);
    for (int seen = 0;; seen++) {
        while (j->round == seen && !j->quit)
            pthread_cond_wait(&j->changed, &j->mutex);
        if (j->quit)
            break;
        pthread_mutex_unlock(&j->mutex);
        j->member(j->team);
        pthread_mutex_lock(&j->mutex);
        if (--j->running == 0)
            pthread_cond_broadcast(&j->changed);
    }
    pthread_mutex_unlock(&j->mutex);
    return NULL;
}

/* What the library calls in every step: run `member` so many times, on as many threads as there
 * are, and come back when all calls have returned. This thread is a member, too. */
static void run(void *user, int count, void (*member)(void *team), void *team)
{
    jobs *j = user;
    (void)count; /* WORKERS + 1, as asked for below */
    pthread_mutex_lock(&j->mutex);
    j->member = member;
    j->team = team;
    j->running = WORKERS;
    j->round++;
    pthread_cond_broadcast(&j->changed);
    pthread_mutex_unlock(&j->mutex);
    member(team);
    pthread_mutex_lock(&j->mutex);
    while (j->running > 0)
        pthread_cond_wait(&j->changed, &j->mutex);
    pthread_mutex_unlock(&j->mutex);
}

/* Half a second of a falling column; 0 if it fails. */
static uint64_t simulate(const skv_world_def *def)
{
    skv_world *world;
    if (skv_world_create(def, &world, NULL) != SKV_OK)
        return 0;
    skv_fill_def column = skv_default_fill_def();
    column.x1 = 0.4f;
    column.y1 = 0.6f;
    skv_result result = skv_world_fill(world, &column, NULL, NULL);
    for (int frame = 0; frame < 30 && result == SKV_OK; frame++)
        result = skv_world_step(world, 1.0f / 60, NULL);
    uint64_t hash = result == SKV_OK ? skv_world_hash(world) : 0;
    printf("%d members: hash %016" PRIx64 "\n", skv_world_threads(world), hash);
    skv_world_destroy(world);
    return hash;
}

int main(void)
{
    jobs own = {.mutex = PTHREAD_MUTEX_INITIALIZER, .changed = PTHREAD_COND_INITIALIZER};
    pthread_t threads[WORKERS];
    for (int i = 0; i < WORKERS; i++)
        if (pthread_create(&threads[i], NULL, work, &own))
            return 1;

    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.02f;
    def.threads = 1;
    uint64_t alone = simulate(&def);
    def.tasks = (skv_task_system){.threads = WORKERS + 1, .run = run, .user = &own};
    uint64_t together = simulate(&def);

    pthread_mutex_lock(&own.mutex);
    own.quit = true;
    pthread_cond_broadcast(&own.changed);
    pthread_mutex_unlock(&own.mutex);
    for (int i = 0; i < WORKERS; i++)
        pthread_join(threads[i], NULL);
    return alone != 0 && alone == together ? 0 : 1;
}
