/* Taking inputs apart. Invariant: nothing is read beyond the input's end. */
#include "fuzz.h"

#include "base/plain.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

uint8_t fuzz_byte(fuzz_input *in)
{
    if (in->size == 0)
        return 0;
    in->size--;
    return *in->data++;
}

int fuzz_below(fuzz_input *in, int below)
{
    return (fuzz_byte(in) << 8 | fuzz_byte(in)) % below;
}

float fuzz_any_float(fuzz_input *in)
{
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits = bits << 8 | fuzz_byte(in);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

float fuzz_float(fuzz_input *in, float from, float to)
{
    if (fuzz_byte(in) % 32 == 31)
        return fuzz_any_float(in);
    return from + (to - from) * (float)fuzz_below(in, 65536) / 65535.0f;
}

void fuzz_expect(bool kept, const char *promise)
{
    if (kept)
        return;
    fprintf(stderr, "a promise was broken: %s\n", promise);
    abort();
}

void fuzz_expect_answer(skv_result result, const skv_error *error)
{
    if (result == SKV_OK)
        return;
    fuzz_expect(error->code == result, "the error has the result's code");
    fuzz_expect(error->text[0] != '\0', "the error has a text");
    fuzz_expect(skv_plain_complaint(error->text) == NULL, "the error is one line of plain text");
}
