/* Memory for the particles. Invariant: count <= capacity, and all arrays lie in one block, so
 * growing either succeeds as a whole or leaves the state as it was. */
#include "world/state.h"

#include "base/arrays.h"
#include "base/memory.h"
#include "skvalp/world.h"

enum {
#define COUNT(type, name, saved) +1
    ARRAYS = SKV_STATE_ARRAYS(COUNT)
#undef COUNT
};

/* Lists the arrays, with `room` and what is `kept` of them; those of fluids if there are any, of
 * which nothing is kept if there were none. */
static int list_arrays(skv_state *state, bool several, size_t room, size_t kept,
                       skv_array arrays[ARRAYS])
{
    int count = 0;
#define LIST(type, name, saved) arrays[count++] = (skv_array)SKV_ARRAY(state->name, room, kept);
    SKV_COMMON_ARRAYS(LIST)
    kept = state->several ? kept : 0;
    if (several) {
        SKV_FLUID_ARRAYS(LIST)
    }
#undef LIST
    return count;
}

static skv_result grow(skv_state *state, int capacity, bool several, skv_error *error)
{
    skv_array arrays[ARRAYS];
    int count = list_arrays(state, several, (size_t)capacity, (size_t)state->count, arrays);
    if (!skv_arrays_grow(&state->block, arrays, count))
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for %d particles", capacity);
    state->capacity = capacity;
    state->several = several;
    return SKV_OK;
}

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
    return grow(state, capacity, state->several, error);
}

skv_result skv_state_admit_fluids(skv_state *state, skv_error *error)
{
    return state->several ? SKV_OK : grow(state, state->capacity, true, error);
}

skv_result skv_state_check_range(const skv_state *state, const char *what, int first, int count,
                                 skv_error *error)
{
    if (first >= 0 && count >= 0 && first <= state->count - count)
        return SKV_OK;
    return skv_fail(error, SKV_ERROR_VALUE, "%s: particles %d.. do not exist; there are %d", what,
                    first, state->count);
}

size_t skv_state_bytes(const skv_state *state)
{
    skv_array arrays[ARRAYS];
    skv_state same = *state;
    int count = list_arrays(&same, state->several, (size_t)state->capacity, 0, arrays);
    return state->capacity ? skv_arrays_bytes(arrays, count) : 0;
}

void skv_state_move(skv_state *state, int from, int to)
{
#define MOVE(type, name, saved) state->name[to] = state->name[from];
    SKV_COMMON_ARRAYS(MOVE)
    if (state->several) {
        SKV_FLUID_ARRAYS(MOVE)
    }
#undef MOVE
}

void skv_state_free(skv_state *state)
{
    skv_free(state->block);
    *state = (skv_state){0};
}
