/* base64url. Invariant: there is one text for every bytes; another one is not read. */
#include "link/letters.h"

#include <string.h>

static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

size_t skv_letters_of(size_t bytes)
{
    return (bytes * 4 + 2) / 3;
}

size_t skv_bytes_of(size_t letters)
{
    return letters * 3 / 4;
}

void skv_letters_write(const uint8_t *bytes, size_t size, char *letters)
{
    unsigned held = 0;
    int bits = 0;
    for (size_t i = 0; i < size; i++) {
        held = (held << 8 | bytes[i]) & 0xffff;
        for (bits += 8; bits >= 6; bits -= 6)
            *letters++ = alphabet[held >> (bits - 6) & 63];
    }
    if (bits > 0)
        *letters = alphabet[held << (6 - bits) & 63];
}

const char *skv_letters_read(const char *letters, uint8_t *bytes, size_t *size)
{
    unsigned held = 0;
    int bits = 0;
    *size = 0;
    for (; *letters; letters++) {
        if (strchr(" \t\r\n", *letters))
            continue;
        const char *found = strchr(alphabet, *letters);
        if (!found)
            return letters;
        held = (held << 6 | (unsigned)(found - alphabet)) & 0xffff;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes[(*size)++] = (uint8_t)(held >> bits);
        }
    }
    /* What is left of the last letter is no byte: 2 or 4 bits, all 0. */
    return bits < 6 && (held & ((1U << bits) - 1)) == 0 ? NULL : letters;
}
