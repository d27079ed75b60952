/* What the core needs of <string.h> where there is no C library; defined in wasm/platform.c. */
#ifndef SKV_WASM_STRING_H
#define SKV_WASM_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *memory, int value, size_t size);
void *memchr(const void *memory, int value, size_t size);
int memcmp(const void *a, const void *b, size_t size);
int strcmp(const char *a, const char *b);
size_t strlen(const char *text);

#endif
