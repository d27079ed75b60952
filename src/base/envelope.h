/* The envelope of our binary files: a head of 32 bytes that says what they are, whether they are
 * whole, and whether they are damaged. Snapshots and replays begin with it. */
#ifndef SKV_BASE_ENVELOPE_H
#define SKV_BASE_ENVELOPE_H

#include "base/bytes.h"
#include "skvalp/base.h"

/* A kind of file. */
typedef struct skv_envelope {
    const char *name; /* in messages: "snapshot" */
    char letter;      /* in the magic bytes, which tells kinds apart */
    unsigned version;
    unsigned oldest; /* version that is read, too */
    unsigned flags;  /* all that this version has */
} skv_envelope;

/* Writes the head; the seal belongs to it. */
void skv_envelope_put(skv_writer *writer, const skv_envelope *kind, unsigned flags);
/* Writes size and checksum into the head of bytes that are complete. */
void skv_envelope_seal(uint8_t *bytes, size_t size);

/* Whether they are, to the last byte, as they were sealed. */
bool skv_envelope_is_sealed(const uint8_t *bytes, size_t size);

/* Whether bytes begin as those of a kind do. */
bool skv_envelope_is(const skv_envelope *kind, const uint8_t *bytes, size_t size);
/* The version that they say, 0 if they are too short to say one. */
unsigned skv_envelope_version(const uint8_t *bytes, size_t size);
/* Reads the head of bytes that do, and sees that they are whole and as they were sealed. */
skv_result skv_envelope_open(skv_reader *reader, const skv_envelope *kind, unsigned *flags,
                             skv_error *error);

#endif
