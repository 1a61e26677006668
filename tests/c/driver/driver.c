/*
 * The conformance driver: one JSON object per line in, one per line out.
 *
 * It contains no message definitions. The registry finds the layout of a field, and the reflection
 * tables locate its values.
 */
#include "driver.h"

#include "mip/reflect.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const REQUEST = "request";

/* -------------------------------------------------------------------------------- hexadecimal */

static int hex_digit(uint32_t c) {
    return c >= '0' && c <= '9'   ? (int)(c - '0')
           : c >= 'a' && c <= 'f' ? (int)(c - 'a') + 10
           : c >= 'A' && c <= 'F' ? (int)(c - 'A') + 10
                                  : -1;
}

static bool hex(const struct json *j, size_t from, uint8_t *bytes, size_t size) {
    for (size_t i = 0; i < size; i++) {
        const int high = hex_digit(j->text[from + 2 * i]);
        const int low = hex_digit(j->text[from + 2 * i + 1]);
        if (high < 0 || low < 0) {
            return false;
        }
        bytes[i] = (uint8_t)(high << 4 | low);
    }
    return true;
}

uint8_t *bytes_of(struct arena *arena, const struct json *j, size_t *size) {
    if (j == NULL || j->kind != JSON_STRING || j->size % 2 != 0) {
        return NULL;
    }
    *size = j->size / 2;
    uint8_t *bytes = (uint8_t *)arena_take(arena, *size);
    return hex(j, 0, bytes, *size) ? bytes : NULL;
}

/* ------------------------------------------------------------------------------------- numbers */

struct scalar {
    size_t size;
    enum { UNSIGNED,
           SIGNED,
           FLOAT } kind;
};

static struct scalar scalar_of(uint8_t scalar) {
    static const struct scalar scalars[] = {
        [MIP_SCALAR_U8] = {1, UNSIGNED},
        [MIP_SCALAR_U16] = {2, UNSIGNED},
        [MIP_SCALAR_U32] = {4, UNSIGNED},
        [MIP_SCALAR_U64] = {8, UNSIGNED},
        [MIP_SCALAR_S8] = {1, SIGNED},
        [MIP_SCALAR_S16] = {2, SIGNED},
        [MIP_SCALAR_S32] = {4, SIGNED},
        [MIP_SCALAR_S64] = {8, SIGNED},
        [MIP_SCALAR_FLOAT] = {4, FLOAT},
        [MIP_SCALAR_DOUBLE] = {8, FLOAT},
        [MIP_SCALAR_BOOL] = {1, UNSIGNED},
        [MIP_SCALAR_CHAR] = {1, UNSIGNED},
    };
    return scalars[scalar];
}

/* The bits of a number in memory. */
static uint64_t load(const void *from, size_t size) {
    uint8_t byte;
    uint16_t half;
    uint32_t word;
    uint64_t twice;
    switch (size) {
    case 1:
        memcpy(&byte, from, 1);
        return byte;
    case 2:
        memcpy(&half, from, 2);
        return half;
    case 4:
        memcpy(&word, from, 4);
        return word;
    default:
        memcpy(&twice, from, 8);
        return twice;
    }
}

static void store(void *to, size_t size, uint64_t bits) {
    const uint8_t byte = (uint8_t)bits;
    const uint16_t half = (uint16_t)bits;
    const uint32_t word = (uint32_t)bits;
    switch (size) {
    case 1:
        memcpy(to, &byte, 1);
        break;
    case 2:
        memcpy(to, &half, 2);
        break;
    case 4:
        memcpy(to, &word, 4);
        break;
    default:
        memcpy(to, &bits, 8);
        break;
    }
}

static uint64_t number_of(const struct mip_parameter *p, const uint8_t *record) {
    return load(record + p->offset, scalar_of(p->scalar).size);
}

static void put_number(struct output *out, uint8_t kind, const uint8_t *from) {
    const struct scalar s = scalar_of(kind);
    const uint64_t bits = load(from, s.size);
    const uint64_t sign = UINT64_C(1) << (8 * s.size - 1);
    if (s.kind == FLOAT) {
        put(out, "\"0x");
        for (size_t i = s.size; i-- > 0;) {
            const uint8_t byte = (uint8_t)(bits >> 8 * i);
            put_hex(out, &byte, 1);
        }
        put_char(out, '"');
    } else if (s.kind == SIGNED && (bits & sign) != 0) {
        put_char(out, '-');
        put_unsigned(out, (sign - 1) - (bits & (sign - 1)) + 1);
    } else {
        put_unsigned(out, bits);
    }
}

static const char *get_number(const struct json *j, uint8_t kind, uint8_t *to) {
    const struct scalar s = scalar_of(kind);
    const uint64_t most = UINT64_MAX >> (64 - 8 * s.size);
    if (s.kind == FLOAT) {
        uint8_t bytes[8];
        if (j->kind != JSON_STRING || j->size != 2 + 2 * s.size || !hex(j, 2, bytes, s.size)) {
            return "range";
        }
        uint64_t bits = 0;
        for (size_t i = 0; i < s.size; i++) {
            bits = bits << 8 | bytes[i];
        }
        store(to, s.size, bits);
        return NULL;
    }
    if (j->kind != JSON_INTEGER && j->kind != JSON_BOOL) {
        return REQUEST;
    }
    const uint64_t limit = s.kind == UNSIGNED ? (j->negative ? 0 : most) : most / 2 + (j->negative ? 1 : 0);
    if (j->huge || j->magnitude > limit) {
        return "range";
    }
    store(to, s.size, j->negative ? 0 - j->magnitude : j->magnitude);
    return NULL;
}

const char *get_whole(const struct json *j, uint32_t *number) {
    if (j == NULL || j->kind != JSON_INTEGER || j->huge || j->magnitude > UINT32_MAX || (j->negative && j->magnitude > 0)) {
        return REQUEST;
    }
    *number = (uint32_t)j->magnitude;
    return NULL;
}

/* ------------------------------------------------------------------------------------ decoding */

static void put_record(struct output *out, const struct mip_record *r, const uint8_t *record, unsigned present);

static size_t items_of(const struct mip_parameter *p, const struct mip_parameter *all, const uint8_t *record) {
    switch (p->length) {
    case MIP_LENGTH_COUNTED:
        return (size_t)number_of(&all[p->by], record);
    case MIP_LENGTH_REST:
        return record[p->count_offset];
    default:
        return p->capacity;
    }
}

static void put_item(struct output *out, const struct mip_parameter *p, const uint8_t *at) {
    if (p->kind == MIP_KIND_STRUCT) {
        put_record(out, p->record, at, 0);
    } else if (p->elements > 1) {
        const size_t size = scalar_of(p->scalar).size;
        for (size_t i = 0; i < p->elements; i++) {
            put_char(out, i == 0 ? '[' : ',');
            put_number(out, p->scalar, at + i * size);
        }
        put_char(out, ']');
    } else {
        put_number(out, p->scalar, at);
    }
}

static const struct mip_case *case_of(const struct mip_parameter *p, const struct mip_parameter *all, const uint8_t *record) {
    const uint64_t tag = number_of(&all[p->by], record);
    for (size_t i = 0; i < p->count; i++) {
        if (p->cases[i].value == tag) {
            return &p->cases[i];
        }
    }
    return NULL;
}

static void put_value(struct output *out, const struct mip_parameter *p, const struct mip_parameter *all, const uint8_t *record) {
    const uint8_t *at = record + p->offset;
    if (p->kind == MIP_KIND_UNION) {
        const struct mip_case *c = case_of(p, all, record);
        put_char(out, '{');
        if (c != NULL && c->parameter != NULL) {
            put_string(out, c->parameter->name, strlen(c->parameter->name));
            put_char(out, ':');
            put_value(out, c->parameter, c->parameter, at);
        }
        put_char(out, '}');
    } else if (p->kind == MIP_KIND_TEXT) {
        put_string(out, (const char *)at, items_of(p, all, record));
    } else if (p->kind == MIP_KIND_BITS) {
        for (size_t i = 0; i < p->item_size; i++) {
            put_char(out, i == 0 ? '[' : ',');
            put_unsigned(out, at[i]);
        }
        put_char(out, ']');
    } else if (p->length == MIP_LENGTH_ONE) {
        put_item(out, p, at);
    } else {
        const size_t count = items_of(p, all, record);
        put_char(out, '[');
        for (size_t i = 0; i < count; i++) {
            put(out, i == 0 ? "" : ",");
            put_item(out, p, at + i * p->item_size);
        }
        put_char(out, ']');
    }
}

static void put_record(struct output *out, const struct mip_record *r, const uint8_t *record, unsigned present) {
    bool first = true;
    put_char(out, '{');
    for (size_t i = 0; i < r->count; i++) {
        const struct mip_parameter *p = &r->parameters[i];
        if (p->kind != MIP_KIND_CONSTANT && p->group <= present) {
            put(out, first ? "" : ",");
            put_string(out, p->name, strlen(p->name));
            put_char(out, ':');
            put_value(out, p, r->parameters, record);
            first = false;
        }
    }
    put_char(out, '}');
}

void put_values(struct output *out, const struct mip_codec *codec, const uint8_t *value) {
    const struct mip_reflection *r = mip_reflect(codec);
    put_record(out, r->record, value, r->optional ? value[r->present_offset] : 0);
}

void put_name(struct output *out, const struct mip_entry *entry, uint8_t set) {
    put(out, ",\"name\":\"");
    put(out, mip_registry_set_name(entry, set));
    put_char(out, '.');
    put(out, entry->name);
    put_char(out, '"');
}

void put_field(struct output *out, struct arena *arena, const struct mip_field *field) {
    static const char *const roles[] = {"command", "response", "data"};
    const struct mip_entry *entry = mip_registry_find(field);
    mip_error error = MIP_OK;
    put(out, "{\"descriptor\":");
    put_unsigned(out, field->descriptor);
    if (entry != NULL) {
        size_t trailing;
        uint8_t *value = (uint8_t *)arena_take(arena, entry->codec->size);
        error = mip_decode(entry->codec, value, field, &trailing);
        if (error == MIP_OK) {
            put_name(out, entry, field->descriptor_set);
            put(out, ",\"role\":\"");
            put(out, roles[entry->role]);
            put(out, "\",\"values\":");
            put_values(out, entry->codec, value);
            put(out, ",\"trailing\":");
            put_unsigned(out, trailing);
            put_char(out, '}');
            return;
        }
        put(out, ",\"error\":\"");
        put(out, mip_error_name(error));
        put_char(out, '"');
    }
    put(out, ",\"raw\":\"");
    put_hex(out, field->data, field->size);
    put(out, "\"}");
}

static const char *decode(struct output *out, struct arena *arena, const struct json *request) {
    size_t size;
    const uint8_t *bytes = bytes_of(arena, json_get(request, "packet"), &size);
    struct mip_packet packet;
    if (bytes == NULL) {
        return REQUEST;
    }
    const mip_error error = mip_packet_check(bytes, size, &packet);
    if (error != MIP_OK) {
        return mip_error_name(error);
    }
    put(out, "{\"set\":");
    put_unsigned(out, packet.descriptor_set);
    put(out, ",\"fields\":[");
    struct mip_walk walk = mip_walk_packet(&packet);
    struct mip_field field;
    bool first = true;
    while (mip_walk_next(&walk, &field)) {
        put(out, first ? "" : ",");
        put_field(out, arena, &field);
        first = false;
    }
    if (walk.error != MIP_OK) {
        put(out, first ? "" : ",");
        put(out, "{\"error\":\"field_length\"}");
    }
    put(out, "]}");
    return NULL;
}

/* ------------------------------------------------------------------------------------ encoding */

static const char *get_value(const struct json *values, const struct mip_parameter *p, const struct mip_parameter *all, uint8_t *record);

static bool is_known(const struct mip_record *r, const struct json *key) {
    for (size_t i = 0; i < r->count; i++) {
        if (r->parameters[i].kind != MIP_KIND_CONSTANT && json_equals(key, r->parameters[i].name)) {
            return true;
        }
    }
    return false;
}

static const char *get_record(const struct json *values, const struct mip_record *r, uint8_t *record) {
    if (values->kind != JSON_OBJECT) {
        return REQUEST;
    }
    for (const struct json *item = values->first; item != NULL; item = item->next) {
        if (!is_known(r, item->key)) {
            return "unknown";
        }
    }
    for (size_t i = 0; i < r->count; i++) {
        const char *error = get_value(values, &r->parameters[i], r->parameters, record);
        if (error != NULL) {
            return error;
        }
    }
    return NULL;
}

static const char *get_item(const struct json *j, const struct mip_parameter *p, uint8_t *at) {
    if (p->kind == MIP_KIND_STRUCT) {
        return get_record(j, p->record, at);
    }
    if (p->elements == 1) {
        return get_number(j, p->scalar, at);
    }
    if (j->kind != JSON_LIST) {
        return REQUEST;
    }
    if (j->size != p->elements) {
        return "count";
    }
    for (const struct json *item = j->first; item != NULL; item = item->next) {
        const char *error = get_number(item, p->scalar, at);
        if (error != NULL) {
            return error;
        }
        at += scalar_of(p->scalar).size;
    }
    return NULL;
}

static const char *get_text(const struct json *j, char *to) {
    for (size_t i = 0; i < j->size; i++) {
        if (j->text[i] > 0xFF) {
            return "range";
        }
        const uint8_t byte = (uint8_t)j->text[i];
        memcpy(to + i, &byte, 1);
    }
    return NULL;
}

static const char *get_items(const struct json *j, const struct mip_parameter *p, uint8_t *record) {
    uint8_t *at = record + p->offset;
    const bool text = p->kind == MIP_KIND_TEXT;
    if (j->kind != (text ? JSON_STRING : JSON_LIST)) {
        return REQUEST;
    }
    const bool fixed = p->length == MIP_LENGTH_FIXED;
    if (j->size > p->capacity || (fixed && !text && j->size != p->capacity)) {
        return "count";
    }
    if (p->length == MIP_LENGTH_REST) {
        record[p->count_offset] = (uint8_t)j->size;
    }
    if (text) {
        if (fixed) { // like mip_copy_text, but the text may contain a NUL
            memset(at, ' ', p->capacity);
        }
        return get_text(j, (char *)at);
    }
    for (const struct json *item = j->first; item != NULL; item = item->next) {
        const char *error = get_item(item, p, at);
        if (error != NULL) {
            return error;
        }
        at += p->item_size;
    }
    return NULL;
}

static const char *get_bits(const struct json *j, const struct mip_parameter *p, uint8_t *at) {
    if (j->kind != JSON_LIST || j->size != p->item_size) {
        return "count";
    }
    for (const struct json *item = j->first; item != NULL; item = item->next) {
        const char *error = get_number(item, MIP_SCALAR_U8, at++);
        if (error != NULL) {
            return error;
        }
    }
    return NULL;
}

static const char *get_union(const struct json *j, const struct mip_parameter *p, const struct mip_parameter *all, uint8_t *record) {
    const struct mip_case *c = case_of(p, all, record);
    const struct mip_parameter *member = c != NULL ? c->parameter : NULL;
    if (j->kind != JSON_OBJECT) {
        return REQUEST;
    }
    if ((member == NULL) != (j->size == 0)) {
        return "tag";
    }
    for (const struct json *item = j->first; item != NULL; item = item->next) {
        if (!json_equals(item->key, member->name)) {
            return "tag";
        }
    }
    return member != NULL ? get_value(j, member, member, record + p->offset) : NULL;
}

static const char *get_value(const struct json *values, const struct mip_parameter *p, const struct mip_parameter *all, uint8_t *record) {
    const struct json *j = json_get(values, p->name);
    uint8_t *at = record + p->offset;
    if (p->kind == MIP_KIND_CONSTANT) {
        return NULL;
    }
    if (j == NULL) {
        return "missing";
    }
    switch (p->kind) {
    case MIP_KIND_COUNTER: {
        const struct json *items = json_get(values, all[p->by].name);
        const bool list = items != NULL && (items->kind == JSON_LIST || items->kind == JSON_STRING);
        const bool whole = j->kind == JSON_INTEGER || j->kind == JSON_BOOL;
        if (!whole) {
            return REQUEST;
        }
        if (!list || j->huge || j->magnitude != items->size || (j->negative && j->magnitude > 0)) {
            return "count";
        }
        return get_number(j, p->scalar, at);
    }
    case MIP_KIND_UNION:
        return get_union(j, p, all, record);
    case MIP_KIND_BITS:
        return get_bits(j, p, at);
    default:
        return p->length == MIP_LENGTH_ONE ? get_item(j, p, at) : get_items(j, p, record);
    }
}

static bool is_there(const struct json *values, const struct mip_parameter *p) {
    return p->kind == MIP_KIND_CONSTANT || json_get(values, p->name) != NULL;
}

/* Fills the structure of a field. Parameters of one group are all present or all absent. */
static const char *get_field(const struct json *values, const struct mip_reflection *r, uint8_t *record) {
    const struct mip_record *all = r->record;
    unsigned required = 0;
    bool ended = false;
    for (const struct json *item = values->first; item != NULL; item = item->next) {
        if (!is_known(all, item->key)) {
            return "unknown";
        }
    }
    for (size_t i = 0; i < all->count;) {
        const struct mip_parameter *first = &all->parameters[i];
        size_t end = i + 1;
        bool whole = is_there(values, first);
        bool some = first->kind != MIP_KIND_CONSTANT && whole;
        while (first->group > 0 && end < all->count && all->parameters[end].group == first->group) {
            const struct mip_parameter *p = &all->parameters[end++];
            const bool there = is_there(values, p);
            whole = whole && there;
            some = some || (p->kind != MIP_KIND_CONSTANT && there);
        }
        if (first->group > 0 && !whole && first->group <= required) {
            return "missing";
        }
        if (first->group > 0 && (ended || !whole)) {
            ended = true;
            if (some) {
                return "missing";
            }
            i = end;
            continue;
        }
        for (; i < end; i++) {
            const char *error = get_value(values, &all->parameters[i], all->parameters, record);
            if (error != NULL) {
                return error;
            }
        }
        if (r->selector && end == 1) {
            const uint64_t function = number_of(first, record);
            required = function < r->required_size ? r->required[function] : 0;
        }
        if (first->group > 0) {
            record[r->present_offset] = first->group;
        }
    }
    return NULL;
}

/* Copies a string with a NUL at its end. False if it is too long, or not ASCII. */
static bool as_text(const struct json *j, char *text, size_t room) {
    if (j->size >= room) {
        return false;
    }
    for (size_t i = 0; i < j->size; i++) {
        if (j->text[i] == 0 || j->text[i] > 0x7F) {
            return false;
        }
        text[i] = (char)j->text[i];
    }
    text[j->size] = '\0';
    return true;
}

const char *get_named(struct arena *arena, const struct json *field, uint8_t set, const struct mip_entry **entry, uint8_t **record) {
    const struct json *descriptor = json_get(field, "descriptor");
    const struct json *name = json_get(field, "name");
    const struct json *values = json_get(field, "values");
    uint8_t number = 0;
    if (field->kind != JSON_OBJECT || (descriptor != NULL && get_number(descriptor, MIP_SCALAR_U8, &number) != NULL)) {
        return REQUEST;
    }
    if (name == NULL || name->kind != JSON_STRING || values == NULL || values->kind != JSON_OBJECT) {
        return REQUEST;
    }
    /* The name must be the one in this set, even if the type occurs in others. */
    char text[64];
    uint8_t of = 0;
    *entry = as_text(name, text, sizeof(text)) ? mip_registry_by_name(text, &of) : NULL;
    if (*entry == NULL || !mip_set_has(set, of) || (descriptor != NULL && (*entry)->descriptor != number)) {
        return "unknown";
    }
    *record = (uint8_t *)arena_take(arena, (*entry)->codec->size);
    return get_field(values, mip_reflect((*entry)->codec), *record);
}

static const char *add_field(struct arena *arena, const struct json *field, struct mip_builder *builder, uint8_t set) {
    const struct json *descriptor = json_get(field, "descriptor");
    const struct json *raw = json_get(field, "raw");
    uint8_t number = 0;
    if (field->kind != JSON_OBJECT || (descriptor != NULL && get_number(descriptor, MIP_SCALAR_U8, &number) != NULL)) {
        return REQUEST;
    }
    if (raw != NULL) {
        size_t size;
        const uint8_t *bytes = bytes_of(arena, raw, &size);
        if (bytes == NULL || descriptor == NULL) {
            return REQUEST;
        }
        const mip_error error = mip_builder_add(builder, number, bytes, size);
        return error == MIP_OK ? NULL : mip_error_name(error);
    }
    const struct mip_entry *entry;
    uint8_t *record;
    const char *wrong = get_named(arena, field, set, &entry, &record);
    if (wrong != NULL) {
        return wrong;
    }
    const mip_error error = mip_encode(entry->codec, record, builder);
    return error == MIP_OK ? NULL : mip_error_name(error);
}

static const char *encode(struct output *out, struct arena *arena, const struct json *request) {
    const struct json *set = json_get(request, "set");
    const struct json *fields = json_get(request, "fields");
    uint8_t number;
    uint8_t *buffer = (uint8_t *)arena_take(arena, MIP_MAX_PACKET);
    struct mip_builder builder;
    if (set == NULL || fields == NULL || fields->kind != JSON_LIST || get_number(set, MIP_SCALAR_U8, &number) != NULL) {
        return REQUEST;
    }
    const mip_error started = mip_builder_start(&builder, buffer, MIP_MAX_PACKET, number);
    if (started != MIP_OK) {
        return mip_error_name(started);
    }
    for (const struct json *field = fields->first; field != NULL; field = field->next) {
        const char *error = add_field(arena, field, &builder, number);
        if (error != NULL) {
            return error;
        }
    }
    const struct mip_packet packet = mip_builder_finish(&builder);
    put(out, "{\"packet\":\"");
    put_hex(out, packet.bytes, packet.size);
    put(out, "\"}");
    return NULL;
}

/* ------------------------------------------------------------------------------------- parsing */

static void put_packet(struct output *out, const struct mip_packet *packet, bool *first) {
    put(out, *first ? "\"" : ",\"");
    put_hex(out, packet->bytes, packet->size);
    put_char(out, '"');
    *first = false;
}

static const char *parse(struct output *out, struct arena *arena, const struct json *request) {
    const struct json *chunk = json_get(request, "chunk");
    size_t left;
    const uint8_t *at = bytes_of(arena, json_get(request, "stream"), &left);
    if (at == NULL || chunk == NULL || chunk->kind != JSON_INTEGER || chunk->negative || chunk->magnitude == 0) {
        return REQUEST;
    }
    struct mip_parser *parser = (struct mip_parser *)arena_take(arena, sizeof(struct mip_parser));
    struct mip_packet packet;
    bool first = true;
    mip_parser_init(parser);
    put(out, "{\"packets\":[");
    while (left > 0) {
        const size_t size = chunk->huge || chunk->magnitude > left ? left : (size_t)chunk->magnitude;
        const uint8_t *data = at;
        size_t rest = size;
        while (mip_parser_next(parser, &data, &rest, &packet)) {
            put_packet(out, &packet, &first);
        }
        at += size;
        left -= size;
    }
    while (mip_parser_flush(parser, &packet)) {
        put_packet(out, &packet, &first);
    }
    put(out, "],\"skipped\":");
    put_unsigned(out, parser->skipped);
    put_char(out, '}');
    return NULL;
}

/* ---------------------------------------------------------------------------------------- main */

static void answer(struct output *out, const char *line, size_t size) {
    struct arena arena = {NULL};
    const struct json *request = json_parse(&arena, line, size);
    const struct json *op = json_get(request, "op");
    const char *error = json_equals(op, "parse")    ? parse(out, &arena, request)
                        : json_equals(op, "decode") ? decode(out, &arena, request)
                        : json_equals(op, "encode") ? encode(out, &arena, request)
                        : json_equals(op, "client") ? play(out, &arena, request)
                        : json_equals(op, "live")   ? play_live(out, &arena, request)
                                                    : REQUEST;
    if (error != NULL) {
        out->size = 0;
        put(out, "{\"error\":\"");
        put(out, error);
        put(out, "\"}");
    }
    arena_free(&arena);
}

int main(void) {
    struct output line = {NULL, 0, 0};
    struct output out = {NULL, 0, 0};
    int c = 0;
    while (c != EOF) {
        line.size = 0;
        while ((c = getchar()) != EOF && c != '\n') {
            put_char(&line, (char)c);
        }
        if (c == EOF && line.size == 0) {
            break;
        }
        out.size = 0;
        answer(&out, line.text != NULL ? line.text : "", line.size);
        put_char(&out, '\n');
        fwrite(out.text, 1, out.size, stdout);
        fflush(stdout);
    }
    free(line.text);
    free(out.text);
    return 0;
}
