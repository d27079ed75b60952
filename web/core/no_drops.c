/* What stands for src/session/drop.c where there are no bodies (no_bodies.c). Invariant: nothing
 * comes, and the host is told that somebody wants it. */
#include "base/more.h"
#include "session/command.h"

skv_result skv_drop_apply(const skv_drop *drop, skv_world *world, skv_error *error)
{
    (void)drop, (void)world;
    return skv_want_more(error);
}

void skv_drop_take(const skv_dab *dab, skv_world *world)
{
    (void)dab, (void)world;
}

const char *skv_drop_shape(int i)
{
    return i >= 0 && i < 3 ? "" : NULL;
}

/* Nor is a game opened here in which some come. */
bool skv_drop_code(skv_command *command, const skv_command last[2], skv_coder *coder)
{
    (void)command, (void)last, (void)coder;
    return skv_want_more(NULL) == SKV_OK;
}
