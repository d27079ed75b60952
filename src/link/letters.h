/* Bytes as letters that no address, mail or chat changes: base64url (RFC 4648), without padding. */
#ifndef SKV_LINK_LETTERS_H
#define SKV_LINK_LETTERS_H

#include <stddef.h>
#include <stdint.h>

/* So many letters, and at most so many bytes. */
size_t skv_letters_of(size_t bytes);
size_t skv_bytes_of(size_t letters);

void skv_letters_write(const uint8_t *bytes, size_t size, char *letters);

/* White space is passed over. Null, or where the first character is that is no letter: at the end,
 * if they end within a byte. */
const char *skv_letters_read(const char *letters, uint8_t *bytes, size_t *size);

#endif
