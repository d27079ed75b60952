/* Bytes as letters that no address, mail or chat changes: base64url (RFC 4648), without padding. */
#ifndef SKV_LINK_LETTERS_H
#define SKV_LINK_LETTERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* So many letters, and at most so many bytes. */
size_t skv_letters_of(size_t bytes);
size_t skv_bytes_of(size_t letters);

void skv_letters_write(const uint8_t *bytes, size_t size, char *letters);

/* White space is passed over. False if these are no letters, or end within a byte. */
bool skv_letters_read(const char *letters, uint8_t *bytes, size_t *size);

#endif
