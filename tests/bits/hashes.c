/* Prints one line "name frames hash" for each of the worlds. Arguments: the instruction set or
 * "best", threads, frames; without the last two it prints the instruction set in use, and with
 * "fast" behind them it leaves out the reference solver's, which knows neither threads nor
 * instruction sets. Invariant: worlds.c alone decides about the numbers. */
#include "worlds.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    if (argc > 1 && !bits_choose(argv[1])) {
        fprintf(stderr, "bits_hashes: no instruction set %s\n", argv[1]);
        return 2;
    }
    if (argc == 2) {
        puts(bits_instruction_set());
        return 0;
    }
    bool fast = argc == 5 && strcmp(argv[4], "fast") == 0;
    int threads = argc > 3 ? atoi(argv[2]) : 0, frames = argc > 3 ? atoi(argv[3]) : 0;
    if (threads < 1 || frames < 1 || (argc > 4 && !fast)) {
        fprintf(stderr, "usage: bits_hashes INSTRUCTION-SET [THREADS FRAMES [fast]]\n");
        return 2;
    }
    for (int i = 0; i < bits_count(); i++)
        if (!fast || !strstr(bits_name(i), "reference"))
            printf("%s %d %016" PRIx64 "\n", bits_name(i), frames, bits_hash(i, threads, frames));
    return 0;
}
