/* The worlds whose bits must be the same everywhere. They need the core library alone, so the same
 * source runs natively, on an emulated processor and in WebAssembly. */
#ifndef TESTS_BITS_WORLDS_H
#define TESTS_BITS_WORLDS_H

#include <stdbool.h>
#include <stdint.h>

/* How many worlds there are, and their names. */
int bits_count(void);
const char *bits_name(int number);

/* The instruction set in use: the best, unless another is chosen; false if there is none of that
 * name here. */
const char *bits_instruction_set(void);
bool bits_choose(const char *instruction_set);

/* Makes world `number`, steps it `frames` times on so many threads, and returns a hash of all that
 * can be read of it; 0 if that failed. */
uint64_t bits_hash(int number, int threads, int frames);

#endif
