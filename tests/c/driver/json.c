#include "json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------------------------------- memory */

struct block {
    struct block *next;
};

static void *must(void *memory) {
    if (memory == NULL) {
        fputs("out of memory\n", stderr);
        abort();
    }
    return memory;
}

void *arena_take(struct arena *arena, size_t size) {
    struct block *block = (struct block *)must(calloc(1, sizeof(struct block) + size));
    block->next = arena->blocks;
    arena->blocks = block;
    return block + 1;
}

void arena_free(struct arena *arena) {
    while (arena->blocks != NULL) {
        struct block *next = arena->blocks->next;
        free(arena->blocks);
        arena->blocks = next;
    }
}

/* --------------------------------------------------------------------------------------- reading */

#define MAX_DEPTH 64

struct input {
    struct arena *arena;
    const unsigned char *at;
    const unsigned char *end;
    int depth;
};

static struct json *value(struct input *in);

static void space(struct input *in) {
    while (in->at < in->end && strchr(" \t\r\n", *in->at) != NULL && *in->at != '\0') {
        in->at++;
    }
}

static int peek(const struct input *in) {
    return in->at < in->end ? *in->at : -1;
}

static bool accept(struct input *in, char c) {
    if (peek(in) != (unsigned char)c) {
        return false;
    }
    in->at++;
    return true;
}

static struct json *make(struct input *in, enum json_kind kind) {
    struct json *j = (struct json *)arena_take(in->arena, sizeof(struct json));
    j->kind = kind;
    return j;
}

static struct json *word(struct input *in, const char *text, enum json_kind kind, uint64_t is) {
    const size_t size = strlen(text);
    if ((size_t)(in->end - in->at) < size || memcmp(in->at, text, size) != 0) {
        return NULL;
    }
    in->at += size;
    struct json *j = make(in, kind);
    j->magnitude = is;
    return j;
}

static bool digit(const struct input *in) {
    return peek(in) >= '0' && peek(in) <= '9';
}

static struct json *number(struct input *in) {
    struct json *j = make(in, JSON_INTEGER);
    j->negative = accept(in, '-');
    if (!digit(in)) {
        return NULL;
    }
    const bool zero = peek(in) == '0';
    for (int count = 0; digit(in); count++, in->at++) {
        const unsigned d = (unsigned)(*in->at - '0');
        if (zero && count > 0) {
            return NULL;
        }
        if (j->magnitude > (UINT64_MAX - d) / 10) {
            j->huge = true;
        } else {
            j->magnitude = j->magnitude * 10 + d;
        }
    }
    if (accept(in, '.')) {
        j->kind = JSON_FRACTION;
        if (!digit(in)) {
            return NULL;
        }
        while (digit(in)) {
            in->at++;
        }
    }
    if (accept(in, 'e') || accept(in, 'E')) {
        j->kind = JSON_FRACTION;
        if (!accept(in, '+')) {
            accept(in, '-');
        }
        if (!digit(in)) {
            return NULL;
        }
        while (digit(in)) {
            in->at++;
        }
    }
    return j;
}

static bool four_digits(struct input *in, uint32_t *unit) {
    *unit = 0;
    for (int i = 0; i < 4; i++) {
        const int c = peek(in);
        const char *digits = "0123456789abcdef";
        const char *found = c > 0 ? strchr(digits, c >= 'A' && c <= 'F' ? c + 32 : c) : NULL;
        if (found == NULL) {
            return false;
        }
        *unit = *unit << 4 | (uint32_t)(found - digits);
        in->at++;
    }
    return true;
}

static bool escape(struct input *in, uint32_t *code) {
    static const char letters[] = "\"\\/bfnrt";
    static const char meanings[] = "\"\\/\b\f\n\r\t";
    const int c = peek(in);
    if (c < 0) {
        return false;
    }
    in->at++;
    if (c != 'u') {
        const char *found = c != 0 ? strchr(letters, c) : NULL;
        *code = found != NULL ? (uint32_t)meanings[found - letters] : 0;
        return found != NULL;
    }
    if (!four_digits(in, code)) {
        return false;
    }
    if (*code >= 0xD800 && *code < 0xDC00 && in->end - in->at >= 6 && in->at[0] == '\\' && in->at[1] == 'u') {
        const unsigned char *mark = in->at;
        uint32_t low;
        in->at += 2;
        if (!four_digits(in, &low)) {
            return false;
        }
        if (low >= 0xDC00 && low < 0xE000) {
            *code = 0x10000 + ((*code - 0xD800) << 10) + (low - 0xDC00);
        } else {
            in->at = mark;
        }
    }
    return true;
}

static bool utf_8(struct input *in, uint32_t *code) {
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const unsigned char c = *in->at;
    const int length = c < 0x80 ? 1 : c < 0xC0 ? 0
                                  : c < 0xE0   ? 2
                                  : c < 0xF0   ? 3
                                  : c < 0xF8   ? 4
                                               : 0;
    if (length == 0 || in->end - in->at < length) {
        return false;
    }
    *code = length == 1 ? c : c & (0x7FU >> length);
    for (int i = 1; i < length; i++) {
        if ((in->at[i] & 0xC0) != 0x80) {
            return false;
        }
        *code = *code << 6 | (in->at[i] & 0x3FU);
    }
    in->at += length;
    return *code >= least[length] && *code <= 0x10FFFF && !(*code >= 0xD800 && *code < 0xE000);
}

static struct json *string(struct input *in) {
    if (!accept(in, '"')) {
        return NULL;
    }
    struct json *j = make(in, JSON_STRING);
    size_t room = 32;
    j->text = (uint32_t *)arena_take(in->arena, room * sizeof(uint32_t));
    for (;;) {
        uint32_t code;
        if (in->at >= in->end || *in->at < 0x20) {
            return NULL;
        }
        if (accept(in, '"')) {
            return j;
        }
        if (accept(in, '\\') ? !escape(in, &code) : !utf_8(in, &code)) {
            return NULL;
        }
        if (j->size == room) {
            uint32_t *more = (uint32_t *)arena_take(in->arena, 2 * room * sizeof(uint32_t));
            memcpy(more, j->text, room * sizeof(uint32_t));
            j->text = more;
            room *= 2;
        }
        j->text[j->size++] = code;
    }
}

static void append(struct json *parent, struct json *item) {
    if (parent->last != NULL) {
        parent->last->next = item;
    } else {
        parent->first = item;
    }
    parent->last = item;
    parent->size++;
}

static struct json *container(struct input *in, enum json_kind kind, char end) {
    struct json *j = make(in, kind);
    in->at++;
    space(in);
    if (accept(in, end)) {
        return j;
    }
    do {
        struct json *key = NULL;
        space(in);
        if (kind == JSON_OBJECT) {
            key = string(in);
            space(in);
            if (key == NULL || !accept(in, ':')) {
                return NULL;
            }
        }
        struct json *item = value(in);
        if (item == NULL) {
            return NULL;
        }
        item->key = key;
        append(j, item);
        space(in);
    } while (accept(in, ','));
    return accept(in, end) ? j : NULL;
}

static struct json *value(struct input *in) {
    struct json *j;
    space(in);
    if (++in->depth > MAX_DEPTH) {
        return NULL;
    }
    switch (peek(in)) {
    case '{':
        j = container(in, JSON_OBJECT, '}');
        break;
    case '[':
        j = container(in, JSON_LIST, ']');
        break;
    case '"':
        j = string(in);
        break;
    case 't':
        j = word(in, "true", JSON_BOOL, 1);
        break;
    case 'f':
        j = word(in, "false", JSON_BOOL, 0);
        break;
    case 'n':
        j = word(in, "null", JSON_NULL, 0);
        break;
    default:
        j = number(in);
        break;
    }
    in->depth--;
    return j;
}

struct json *json_parse(struct arena *arena, const char *text, size_t size) {
    struct input in = {arena, (const unsigned char *)text, (const unsigned char *)text + size, 0};
    struct json *j = value(&in);
    space(&in);
    return in.at == in.end ? j : NULL;
}

bool json_equals(const struct json *string, const char *text) {
    const size_t size = strlen(text);
    if (string == NULL || string->kind != JSON_STRING || string->size != size) {
        return false;
    }
    for (size_t i = 0; i < size; i++) {
        if (string->text[i] != (unsigned char)text[i]) {
            return false;
        }
    }
    return true;
}

const struct json *json_get(const struct json *object, const char *key) {
    const struct json *found = NULL;
    if (object != NULL && object->kind == JSON_OBJECT) {
        for (const struct json *item = object->first; item != NULL; item = item->next) {
            found = json_equals(item->key, key) ? item : found;
        }
    }
    return found;
}

/* --------------------------------------------------------------------------------------- writing */

static void put_bytes(struct output *out, const char *text, size_t size) {
    if (size == 0) {
        return;
    }
    if (out->capacity - out->size < size) {
        out->capacity = 2 * out->capacity + size;
        out->text = (char *)must(realloc(out->text, out->capacity));
    }
    memcpy(out->text + out->size, text, size);
    out->size += size;
}

void put(struct output *out, const char *text) {
    put_bytes(out, text, strlen(text));
}

void put_char(struct output *out, char c) {
    put_bytes(out, &c, 1);
}

void put_unsigned(struct output *out, uint64_t number) {
    char digits[20];
    size_t at = sizeof(digits);
    do {
        digits[--at] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    put_bytes(out, digits + at, sizeof(digits) - at);
}

void put_hex(struct output *out, const uint8_t *bytes, size_t size) {
    static const char digits[] = "0123456789abcdef";
    for (size_t i = 0; i < size; i++) {
        put_char(out, digits[bytes[i] >> 4]);
        put_char(out, digits[bytes[i] & 15]);
    }
}

void put_string(struct output *out, const char *bytes, size_t size) {
    put_char(out, '"');
    for (size_t i = 0; i < size; i++) {
        const uint8_t byte = (uint8_t)bytes[i];
        if (byte == '"' || byte == '\\') {
            put_char(out, '\\');
            put_char(out, bytes[i]);
        } else if (byte >= 0x20 && byte < 0x7F) {
            put_char(out, bytes[i]);
        } else {
            put(out, "\\u00");
            put_hex(out, &byte, 1);
        }
    }
    put_char(out, '"');
}
