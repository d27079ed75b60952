/* Key frames in order of their positions. Invariant: `bytes` is the sum of their sizes, and no
 * operation that fails leaves a trace. */
#include "session/history.h"

#include "base/memory.h"
#include "skvalp/snapshot.h"
#include "terrain/terrain.h"

#include <string.h>

/* Frames: what is younger may be thinned about evenly, what is older the more the older it is. */
#define NEAR 1800

void skv_history_free(skv_history *history)
{
    for (int i = 0; i < history->count; i++)
        skv_free(history->list[i].bytes);
    skv_free(history->list);
    *history = (skv_history){0};
}

static skv_result reserve(skv_history *history, int more, skv_error *error)
{
    int wanted = history->count + more;
    if (history->list && wanted <= history->capacity)
        return SKV_OK;
    int capacity = wanted > 2 * history->capacity ? wanted : 2 * history->capacity;
    skv_key *list = skv_calloc((size_t)capacity, sizeof *list);
    if (!list)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d key frames", wanted);
    if (history->list)
        memcpy(list, history->list, (size_t)history->count * sizeof *list);
    skv_free(history->list);
    history->list = list;
    history->capacity = capacity;
    return SKV_OK;
}

/* How many lie at or before a position. */
static int count_until(const skv_history *history, skv_position position)
{
    int low = 0, high = history->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (skv_before(position, history->list[middle].position))
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

const skv_key *skv_history_find(const skv_history *history, skv_position position)
{
    int until = count_until(history, position);
    return until ? &history->list[until - 1] : NULL;
}

skv_result skv_history_insert(skv_history *history, const skv_key *key, skv_error *error)
{
    skv_result result = reserve(history, 1, error);
    if (result != SKV_OK)
        return result;
    int at = count_until(history, key->position);
    memmove(&history->list[at + 1], &history->list[at],
            (size_t)(history->count - at) * sizeof *history->list);
    history->list[at] = *key;
    history->count++;
    history->bytes += key->size;
    return SKV_OK;
}

bool skv_history_has(const skv_history *history, skv_position position)
{
    const skv_key *there = skv_history_find(history, position);
    return there && !skv_before(there->position, position);
}

skv_result skv_history_add(skv_history *history, const skv_world *world, skv_position position,
                           skv_error *error)
{
    if (skv_history_has(history, position))
        return SKV_OK;
    skv_key key = {.position = position,
                   .terrain = skv_world_terrain(world)->hash,
                   .size = skv_world_snapshot_size(world, false)};
    key.bytes = skv_calloc(key.size, 1);
    if (!key.bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a key frame of %zu bytes",
                        key.size);
    skv_result result = skv_world_save(world, false, key.bytes, key.size, error);
    if (result == SKV_OK)
        result = skv_history_insert(history, &key, error);
    if (result != SKV_OK)
        skv_free(key.bytes);
    return result;
}

void skv_key_write(const skv_key *key, skv_write *write, void *user)
{
    write((const char *)key, sizeof *key, user);
    write((const char *)key->bytes, key->size, user);
}

skv_result skv_history_take(skv_history *history, const uint8_t **written, skv_error *error)
{
    skv_key key;
    memcpy(&key, *written, sizeof key);
    const uint8_t *state = *written + sizeof key;
    *written = state + key.size;
    if (skv_history_has(history, key.position))
        return SKV_OK;
    key.bytes = skv_calloc(key.size, 1);
    if (!key.bytes)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a key frame of %zu bytes",
                        key.size);
    memcpy(key.bytes, state, key.size);
    skv_result result = skv_history_insert(history, &key, error);
    if (result != SKV_OK)
        skv_free(key.bytes);
    return result;
}

skv_result skv_history_join(skv_history *history, skv_history *later, skv_error *error)
{
    skv_result result = reserve(history, later->count, error);
    if (result != SKV_OK)
        return result;
    if (later->count)
        memcpy(&history->list[history->count], later->list,
               (size_t)later->count * sizeof *later->list);
    history->count += later->count;
    history->bytes += later->bytes;
    skv_free(later->list);
    *later = (skv_history){0};
    return SKV_OK;
}

skv_result skv_history_split(skv_history *history, skv_position position, skv_history *later,
                             skv_error *error)
{
    int kept = count_until(history, position), moved = history->count - kept;
    skv_result result = moved ? reserve(later, moved, error) : SKV_OK;
    if (result != SKV_OK)
        return result;
    for (int i = 0; i < moved; i++) {
        later->list[i] = history->list[kept + i];
        later->bytes += later->list[i].size;
    }
    later->count = moved;
    history->count = kept;
    history->bytes -= later->bytes;
    return SKV_OK;
}

void skv_history_drop_after(skv_history *history, skv_position position)
{
    int kept = count_until(history, position);
    while (history->count > kept) {
        skv_key *key = &history->list[--history->count];
        history->bytes -= key->size;
        skv_free(key->bytes);
    }
}

bool skv_history_thin(skv_history *history)
{
    if (history->count < 3)
        return false;
    const skv_key *keys = history->list;
    int64_t latest = keys[history->count - 1].position.frame;
    int chosen = 0;
    double least = 0;
    for (int i = 1; i < history->count - 1; i++) {
        double gap = (double)(keys[i + 1].position.frame - keys[i - 1].position.frame);
        double loss = gap / (double)(latest - keys[i].position.frame + NEAR);
        if (chosen == 0 || loss < least) {
            chosen = i;
            least = loss;
        }
    }
    history->bytes -= keys[chosen].size;
    skv_free(history->list[chosen].bytes);
    memmove(&history->list[chosen], &history->list[chosen + 1],
            (size_t)(history->count - chosen - 1) * sizeof *history->list);
    history->count--;
    return true;
}
