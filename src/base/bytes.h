/* Bytes of a file format: little-endian on every machine, written and read in order. */
#ifndef SKV_BASE_BYTES_H
#define SKV_BASE_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Where bytes go. Without `bytes` they are only counted. */
typedef struct skv_writer {
    uint8_t *bytes; /* there must be room for all that is put */
    size_t used;
} skv_writer;

void skv_put(skv_writer *writer, uint64_t value, int bytes); /* the lowest `bytes`, 1..8 */
void skv_put_float(skv_writer *writer, float value);
void skv_put_double(skv_writer *writer, double value);
void skv_put_text(skv_writer *writer, const char *text); /* at most 255 bytes */

/* Where they come from. What would be past the end reads as 0 and sets `failed`. */
typedef struct skv_reader {
    const uint8_t *bytes;
    size_t size, at;
    bool failed;
} skv_reader;

uint64_t skv_get(skv_reader *reader, int bytes);
float skv_get_float(skv_reader *reader);
double skv_get_double(skv_reader *reader);
void skv_get_text(skv_reader *reader, char text[256]);

/* A writer or a reader, the other one null: what is put and got in the same order is said once. */
typedef struct skv_port {
    skv_writer *to;
    skv_reader *from;
} skv_port;

void skv_exchange(skv_port *port, uint64_t *value, int bytes);
void skv_exchange_float(skv_port *port, float *value);
void skv_exchange_double(skv_port *port, double *value);
/* A number of things, 4 bytes; false, and 0, if more than `most` are read. */
bool skv_exchange_count(skv_port *port, int *count, int most);

/* FNV-1a, 64 bits: begin with SKV_HASH_BEGIN. Notices damage, not an attacker. */
#define SKV_HASH_BEGIN 14695981039346656037u
uint64_t skv_hash_bytes(uint64_t hash, const void *data, size_t size);

#endif
