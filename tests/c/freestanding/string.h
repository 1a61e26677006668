/* The only functions of the C library that the binding may use, for targets without one. */
#ifndef STRING_H
#define STRING_H
#include <stddef.h>
void *memcpy(void *to, const void *from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int value, size_t size);
void *memchr(const void *from, int value, size_t size);
int strcmp(const char *a, const char *b);
#endif
