/* What the figures were measured on, and by. */
#ifndef BENCH_MACHINE_H
#define BENCH_MACHINE_H

#include <stddef.h>

/* What passes: time, or processor time of the whole program or of the thread that asks. */
typedef enum bench_clock { BENCH_CLOCK, BENCH_PROCESS, BENCH_THREAD } bench_clock;

/* s, from any origin. */
double bench_seconds(bench_clock clock);

/* The processor's name as the system tells it; "unknown" if it does not. */
void bench_name_cpu(char *text, size_t size);
/* The compiler that built this program, with its version. */
void bench_name_compiler(char *text, size_t size);

/* How many processes wanted to run in the last minute, on average; NaN if the system does not say.
 */
double bench_load(void);

#endif
