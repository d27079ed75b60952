/* Memory for the particles. Invariant: count <= capacity, and all arrays lie in one block, so
 * growing either succeeds as a whole or leaves the state as it was. */
#include "world/state.h"

#include "base/arrays.h"
#include "base/memory.h"
#include "skvalp/world.h"

skv_result skv_state_reserve(skv_state *state, int count, skv_error *error)
{
    if (count <= state->capacity)
        return SKV_OK;
    if (count > SKV_MAX_PARTICLES)
        return skv_fail(error, SKV_ERROR_LIMIT, "%d particles are too many; at most %d are allowed",
                        count, SKV_MAX_PARTICLES);
    int capacity = count > state->capacity * 2 ? count : state->capacity * 2;
    if (capacity > SKV_MAX_PARTICLES)
        capacity = SKV_MAX_PARTICLES;
    size_t room = (size_t)capacity, kept = (size_t)state->count;
#define ENTRY(type, name, saved) SKV_ARRAY(state->name, room, kept),
    const skv_array arrays[] = {SKV_STATE_ARRAYS(ENTRY)};
#undef ENTRY
    if (!skv_arrays_grow(&state->block, arrays, sizeof arrays / sizeof *arrays))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", count);
    state->capacity = capacity;
    return SKV_OK;
}

size_t skv_state_bytes(const skv_state *state)
{
    size_t room = (size_t)state->capacity;
#define ENTRY(type, name, saved) SKV_ARRAY(state->name, room, 0),
    const skv_array arrays[] = {SKV_STATE_ARRAYS(ENTRY)};
#undef ENTRY
    return room ? skv_arrays_bytes(arrays, sizeof arrays / sizeof *arrays) : 0;
}

void skv_state_move(skv_state *state, int from, int to)
{
#define MOVE(type, name, saved) state->name[to] = state->name[from];
    SKV_STATE_ARRAYS(MOVE)
#undef MOVE
}

void skv_state_free(skv_state *state)
{
    skv_free(state->block);
    *state = (skv_state){0};
}
