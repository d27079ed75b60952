/* What a world knows of its host: a pointer, a callback before each substep, and a log.
 * Invariant: none of it is part of the world's state; a world without them steps alike. While a
 * callback runs, the world refuses what would change it under the feet of who called. */
#include "base/assert.h"
#include "world/world_internal.h"

#include <stdarg.h>

void skv_world_set_user(skv_world *world, void *user)
{
    SKV_ASSERT(world);
    world->user = user;
}

void *skv_world_user(const skv_world *world)
{
    SKV_ASSERT_OR(world, NULL);
    return world->user;
}

void skv_world_set_before_substep(skv_world *world, skv_before_substep *callback, void *user)
{
    SKV_ASSERT(world);
    world->before_substep = callback;
    world->before_substep_user = user;
}

void skv_world_set_log(skv_world *world, skv_logger *log, void *user)
{
    SKV_ASSERT(world);
    world->log = log;
    world->log_user = user;
}

bool skv_may_step(const skv_world *world)
{
    return world && world->busy == SKV_IDLE;
}

bool skv_may_change(const skv_world *world)
{
    return world && world->busy <= SKV_IN_SUBSTEPS;
}

void skv_world_say(skv_world *world, const char *format, ...)
{
    if (!world->log)
        return;
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    skv_format_list(text, sizeof text, format, arguments);
    va_end(arguments);
    skv_busy before = world->busy;
    world->busy = SKV_READ;
    world->log(text, world->log_user);
    world->busy = before;
}
