/* What the fuzz targets share: taking an input apart, and judging an answer.
 *
 * A target is one function over any bytes. libFuzzer calls it with inputs of its own making
 * (scripts/fuzz.sh); replay.c calls it with the committed ones, as a test. A broken promise ends in
 * abort(), as a sanitizer's finding does.
 */
#ifndef SKV_TESTS_FUZZ_H
#define SKV_TESTS_FUZZ_H

#include <skvalp/base.h>

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* An input that is taken apart from its front; what is missing reads as zero. */
typedef struct fuzz_input {
    const uint8_t *data;
    size_t size;
} fuzz_input;

uint8_t fuzz_byte(fuzz_input *in);
/* 0..below-1. */
int fuzz_below(fuzz_input *in, int below);
/* Any float at all: four bytes as they come. */
float fuzz_any_float(fuzz_input *in);
/* from..to in 65536 steps; once in 32 times any float at all instead. */
float fuzz_float(fuzz_input *in, float from, float to);

/* Aborts, and says what was promised, if `kept` is false. */
void fuzz_expect(bool kept, const char *promise);

/* A result's promise: the error is filled if and only if it failed, with one line of text. */
void fuzz_expect_answer(skv_result result, const skv_error *error);

#endif
