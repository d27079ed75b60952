/* Functions of the host's where the public interface, which is exported as it is, takes a pointer
 * to one. Invariant: the `user` that goes in with such a pointer comes out in the call, so one
 * pointer of a kind serves all of the host's functions.
 */
#include "skvalp/experiments.h"
#include "skvalp/stage.h"

#define HOST(name)   __attribute__((import_module("host"), import_name(#name)))
#define EXPORT(name) __attribute__((export_name(#name)))

typedef double read_clock(void);
typedef void wake_face(void *user);

/* As skv_stage_def.clock and .wake, skv_write, skv_lab_observer. */
HOST(clock) double host_clock(void);
HOST(wake) void host_wake(void *user);
HOST(write) bool host_write(const char *text, size_t length, void *user);
HOST(observe) bool host_observe(const skv_lab_moment *moment, void *user);

EXPORT(skv_wasm_clock) read_clock *skv_wasm_clock(void);
EXPORT(skv_wasm_wake) wake_face *skv_wasm_wake(void);
EXPORT(skv_wasm_write) skv_write *skv_wasm_write(void);
EXPORT(skv_wasm_observe) skv_lab_observer *skv_wasm_observe(void);

read_clock *skv_wasm_clock(void)
{
    return host_clock;
}

wake_face *skv_wasm_wake(void)
{
    return host_wake;
}

skv_write *skv_wasm_write(void)
{
    return host_write;
}

skv_lab_observer *skv_wasm_observe(void)
{
    return host_observe;
}
