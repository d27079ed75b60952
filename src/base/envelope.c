/* Heads of files. Invariant: what skv_envelope_open has let through is, to the last byte, what
 * skv_envelope_seal has seen. */
#include "base/envelope.h"

#include <string.h>

enum { LETTER_AT = 3, SIZE_AT = 16, CHECKSUM_AT = 24, HEAD = 32 };

/* As PNG's: a byte beyond ASCII and both line ends, so that whoever takes it for text ruins it
 * where it shows. */
static const uint8_t magic[8] = {0x89, 'S', 'K', 0, '\r', '\n', 0x1a, '\n'};

/* Of all bytes but its own. */
static uint64_t checksum(const uint8_t *bytes, size_t size)
{
    uint64_t hash = skv_hash_bytes(SKV_HASH_BEGIN, bytes, CHECKSUM_AT);
    return skv_hash_bytes(hash, bytes + HEAD, size - HEAD);
}

unsigned skv_envelope_version(const uint8_t *bytes, size_t size)
{
    skv_reader reader = {.bytes = bytes, .size = size, .at = sizeof magic};
    return size < HEAD ? 0 : (unsigned)skv_get(&reader, 4);
}

void skv_envelope_put(skv_writer *w, const skv_envelope *kind, unsigned flags)
{
    for (int i = 0; i < (int)sizeof magic; i++)
        skv_put(w, i == LETTER_AT ? (uint8_t)kind->letter : magic[i], 1);
    skv_put(w, kind->version, 4);
    skv_put(w, flags, 4);
    skv_put(w, 0, 8);
    skv_put(w, 0, 8);
}

void skv_envelope_seal(uint8_t *bytes, size_t size)
{
    if (size < HEAD)
        return;
    skv_put(&(skv_writer){bytes, SIZE_AT}, size, 8);
    skv_put(&(skv_writer){bytes, CHECKSUM_AT}, checksum(bytes, size), 8);
}

bool skv_envelope_is_sealed(const uint8_t *bytes, size_t size)
{
    skv_reader reader = {.bytes = bytes, .size = size, .at = SIZE_AT};
    return size >= HEAD && skv_get(&reader, 8) == size &&
           skv_get(&reader, 8) == checksum(bytes, size);
}

bool skv_envelope_is(const skv_envelope *kind, const uint8_t *bytes, size_t size)
{
    bool same = size >= sizeof magic;
    for (int i = 0; same && i < (int)sizeof magic; i++)
        same = bytes[i] == (i == LETTER_AT ? (uint8_t)kind->letter : magic[i]);
    return same;
}

skv_result skv_envelope_open(skv_reader *r, const skv_envelope *kind, unsigned *flags,
                             skv_error *error)
{
    r->at = sizeof magic;
    unsigned version = (unsigned)skv_get(r, 4);
    *flags = (unsigned)skv_get(r, 4);
    uint64_t size = skv_get(r, 8);
    skv_get(r, 8); /* the checksum */
    if (!r->failed && (version > kind->version || version < kind->oldest))
        return skv_fail(error, SKV_ERROR_FORMAT,
                        "%s: its version is %u, this library reads %u; use the library that wrote "
                        "it",
                        kind->name, version, kind->version);
    if (r->failed || size > r->size)
        return skv_fail(error, SKV_ERROR_FORMAT, "%s: it is cut short; take the whole of it",
                        kind->name);
    if (*flags & ~kind->flags || !skv_envelope_is_sealed(r->bytes, r->size))
        return skv_fail(error, SKV_ERROR_FORMAT, "%s: it is damaged; take another copy",
                        kind->name);
    return SKV_OK;
}
