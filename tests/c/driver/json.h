/* JSON, as much of it as one line of the conformance protocol needs. */
#ifndef DRIVER_JSON_H
#define DRIVER_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum json_kind { JSON_NULL,
                 JSON_BOOL,
                 JSON_INTEGER,
                 JSON_FRACTION,
                 JSON_STRING,
                 JSON_LIST,
                 JSON_OBJECT };

struct json {
    enum json_kind kind;
    /* Of whole numbers: the magnitude; `huge` if it does not fit. Of true and false: 1 and 0. */
    uint64_t magnitude;
    bool negative;
    bool huge;
    /* Of strings: code points. */
    uint32_t *text;
    /* Of strings: characters; of lists and objects: elements. */
    size_t size;
    /* Of lists and objects. */
    struct json *first;
    struct json *last;
    /* Inside of a list or an object. */
    struct json *next;
    struct json *key;
};

/* Memory that is freed all at once. */
struct arena {
    struct block *blocks;
};
void *arena_take(struct arena *arena, size_t size);
void arena_free(struct arena *arena);

/* NULL if the text is not exactly one value. */
struct json *json_parse(struct arena *arena, const char *text, size_t size);

/* The last member of that name; NULL if there is none, or if it is not an object. */
const struct json *json_get(const struct json *object, const char *key);
bool json_equals(const struct json *string, const char *text);

/* A string that grows. */
struct output {
    char *text;
    size_t size;
    size_t capacity;
};
void put(struct output *out, const char *text);
void put_char(struct output *out, char c);
void put_unsigned(struct output *out, uint64_t value);
void put_hex(struct output *out, const uint8_t *bytes, size_t size);
/* A string of JSON, one character for each byte. */
void put_string(struct output *out, const char *bytes, size_t size);

#endif
