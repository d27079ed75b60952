/** @file
 * Result codes, error messages, memory and assertion hooks: what every other header builds on.
 *
 * The library never exits and never prints by itself. A caller's mistake (a null handle, a struct
 * that was not initialised) goes to the assert handler; a failure
 * at run time (memory, a bad file, a value out of range) comes back as a skv_result, and the
 * object that was called stays as it was.
 */
#ifndef SKVALP_BASE_H
#define SKVALP_BASE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Marks what the library offers. A Windows program that links the library as a DLL defines
 * SKVALP_DLL; building that DLL defines SKVALP_BUILDING_DLL. */
#if defined(_WIN32) && defined(SKVALP_BUILDING_DLL)
#define SKV_API __declspec(dllexport)
#elif defined(_WIN32) && defined(SKVALP_DLL)
#define SKV_API __declspec(dllimport)
#elif defined(_WIN32)
#define SKV_API
#else
#define SKV_API __attribute__((visibility("default")))
#endif

/** Lets the compiler compare a printf-style format, argument number `format_at`, with the arguments
 * from number `first` on. */
#if defined(__MINGW32__)
#define SKV_PRINTF(format_at, first) __attribute__((format(gnu_printf, format_at, first)))
#elif defined(__GNUC__)
#define SKV_PRINTF(format_at, first) __attribute__((format(printf, format_at, first)))
#else
#define SKV_PRINTF(format_at, first)
#endif

#define SKV_VERSION_MAJOR 0
#define SKV_VERSION_MINOR 1
#define SKV_VERSION_PATCH 0

/** The library's version as text, "major.minor.patch". Thread-safe. */
SKV_API const char *skv_version(void);

/** What a function that can fail at run time returns. */
typedef enum skv_result {
    SKV_OK = 0,
    SKV_ERROR_MEMORY, /**< an allocation failed */
    SKV_ERROR_FILE,   /**< a file could not be opened, read or written */
    SKV_ERROR_FORMAT, /**< a file's content is not what it claims to be */
    SKV_ERROR_VALUE,  /**< a value is not finite, out of its range or of the wrong kind */
    SKV_ERROR_LIMIT,  /**< more of something than this build or this object holds */
    SKV_ERROR_DEVICE, /**< the graphics device or a helper program is not available */
    SKV_STOPPED       /**< the caller's own callback said to stop: no failure */
} skv_result;

/** A short English name of a result, such as "bad value". Never null. Thread-safe. */
SKV_API const char *skv_result_text(skv_result result);

/** Where a failing function leaves its message: one line, no line feed, that names the file or
 * field, the place in it, and the remedy. Owned by the caller; functions accept a null pointer
 * where the message is not wanted. Untouched on success. */
typedef struct skv_error {
    skv_result code;
    char text[512];
} skv_error;

/** Fills `error` (null is allowed) with a printf-style message and returns `code`, so that a
 * failing function can end with `return skv_fail(error, SKV_ERROR_VALUE, "...");`. The text is
 * cut to fit, words of more than 160 bytes in their middle, and made plain as by skv_make_plain. */
SKV_API skv_result skv_fail(skv_error *error, skv_result code, const char *format, ...)
    SKV_PRINTF(3, 4);

/** Replaces by '?', in place, what a hostile file or its name may hold and no terminal or message
 * should get: control characters (C0, DEL, C1), those that turn the direction of writing,
 * separators of lines and paragraphs, and bytes that are no UTF-8. Scenes refuse such texts, and
 * all that the library says is plain. Thread-safe. */
SKV_API void skv_make_plain(char *text);

/* Definitions. A struct that is handed in whole, skv_world_def and its like, begins with a cookie,
 * which says that it was initialised; without it the call is the caller's mistake and does nothing.
 * In C, skv_default_world_def() and its like give one by value. Other languages call
 * skv_world_def_init(pointer, size) and its like, where `size` is the struct's size in the headers
 * that the program knows: no byte beyond it is written then, nor read later. Members are only added
 * at the end, so a program compiled before they came hands in a smaller struct, and they have their
 * defaults. skv_fluid_def, which lies within another, keeps its size. A size larger than the
 * library's own, of a later library, is a caller's mistake. Plain values, such as skv_area,
 * skv_hand or skv_force, need no cookie: every member counts, and 0 does nothing. */

/** Receives text piece by piece; returns false to stop, which the writing function reports as
 * SKV_ERROR_FILE. It must not change or destroy what is being written. */
typedef bool skv_write(const char *text, size_t length, void *user);

/** Writes a text as one cell of a table of comma-separated values, as RFC 4180 has it: in quotes if
 * it holds a comma, a quote or a line's end, its own quotes doubled. False if `write` says so.
 * Thread-safe. */
SKV_API bool skv_write_cell(const char *text, skv_write *write, void *user);

/** Formats like snprintf in the C locale, whatever the program's locale is: at most `room` bytes
 * with the zero at the end; returns the length that the whole text has. Knows the conversions d i u
 * x X c s f e g and %, the flags - 0 + and # (of x), width, precision and the lengths hh h l ll z;
 * a directive beyond that and what follows it is copied as it stands. Thread-safe. */
SKV_API size_t skv_format(char *text, size_t room, const char *format, ...) SKV_PRINTF(3, 4);
SKV_API size_t skv_format_list(char *text, size_t room, const char *format, va_list arguments)
    SKV_PRINTF(3, 0);

/** Reads all of `text` as a plain decimal number ("-2.5", "1e-3"), whatever the program's locale
 * is, rounded to the nearest double. False, and *value untouched, for anything else: an empty text,
 * spaces, "nan", "0x1p3", what is too large for a double or longer than 60 characters.
 * Thread-safe. */
SKV_API bool skv_parse_number(const char *text, double *value);

/** The one of `count` names that a mistyped one is most like, for "did you mean"; null if none is
 * near. The beginning of a name is near it. Thread-safe. */
SKV_API const char *skv_nearest_name(const char *text, const char *const *names, int count);

/** Memory hooks. `allocate` returns memory aligned to `alignment` (a power of two, at most 4096)
 * or null; `release` takes what allocate returned, never null. Both may be called from the thread
 * that calls a create, add, edit or destroy function, never from a worker thread and never from
 * skv_world_step once the world is warm. They must not call the library. */
typedef struct skv_allocator {
    void *(*allocate)(size_t bytes, size_t alignment, void *user);
    void (*release)(void *memory, void *user);
    void *user;
} skv_allocator;

/** Replaces the allocator for everything that is created afterwards; null restores the default
 * (aligned_alloc and free). Set it before the first object is created: not thread-safe. */
SKV_API void skv_set_allocator(const skv_allocator *allocator);

/** A host program's own threads, lent to a world for its steps. `run` is called on the thread that
 * steps; it calls member(team) `count` times, on as many threads as it likes, and returns when all
 * of these calls have returned. Those that begin while the team gathers, at most 0.1 ms, share the
 * step's work; later ones find the team complete and return at once. So fewer threads than `count`,
 * or one after the other, work too, and give the same bits. Members wait for each other within a
 * step: give them threads that nothing else keeps busy. `run` must not call any function of the
 * world that steps. */
typedef struct skv_task_system {
    int threads; /**< how many members to ask for, 1..SKV_MAX_THREADS */
    void (*run)(void *user, int count, void (*member)(void *team), void *team);
    void *user;
} skv_task_system;

/** Threads of the library's own that several worlds share: skv_world_def.pool. Only one of these
 * worlds may step at a time, and the pool must outlive them. `threads`: 1..SKV_MAX_THREADS, 0: one
 * per physical core. They take no signals that the system or another program sends: a host's
 * handlers run on threads of the host. SKV_ERROR_VALUE out of that range, SKV_ERROR_LIMIT if the
 * system refuses to start so many; `*pool` is null then. Destroying null is allowed. */
typedef struct skv_pool skv_pool;
SKV_API skv_result skv_pool_create(int threads, skv_pool **pool, skv_error *error);
SKV_API void skv_pool_destroy(skv_pool *pool);

/** Sets who is asked between substeps, and between the rounds in which fluid settles, whether to
 * stop; null, the default: nobody. Who says yes gets SKV_STOPPED from the call that ran: a world
 * that stepped is half done then, and may only be restored or destroyed. It is called on one of the
 * pool's threads at a time, and must not call the library. */
typedef bool skv_stop(void *user);
SKV_API void skv_pool_set_stop(skv_pool *pool, skv_stop *stop, void *user);

/** Instruction sets that the fast solver can compute with. The results are the same. */
typedef enum skv_instruction_set {
    SKV_ISA_BEST, /**< the best that the processor has */
    SKV_ISA_SCALAR,
    SKV_ISA_SSE2,
    SKV_ISA_AVX2,
    SKV_ISA_AVX512,
    SKV_ISA_NEON,
    SKV_ISA_WASM
} skv_instruction_set;

/** Receives a failed assertion: the condition as text, the file and the line. If it returns, the
 * function that was misused returns without effect (null, zero or SKV_ERROR_VALUE). */
typedef void skv_assert_handler(const char *condition, const char *file, int line, void *user);

/** Replaces the assert handler; null restores the default, which writes file, line and condition to
 * the standard error and calls abort(). Not thread-safe. */
SKV_API void skv_set_assert_handler(skv_assert_handler *handler, void *user);

#ifdef __cplusplus
}
#endif
#endif
