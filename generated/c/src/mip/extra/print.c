/* Prints packets and fields, using the registry and the reflection tables. */
#include "mip/extra/print.h"

#include "mip/extra/reflect.h"
#include "mip/extra/registry.h"

#include <string.h>

static void put(const struct mip_print *print, const char *text) {
    mip_print_string(print, text);
}

/** Prints a number with this many hexadecimal digits. */
static void put_digits(const struct mip_print *print, uint64_t value, unsigned digits) {
    while (digits-- > 0) {
        print->put(print->user, &"0123456789ABCDEF"[value >> 4 * digits & 15], 1);
    }
}

static void put_number(const struct mip_print *print, const char *before, uint64_t value,
                       unsigned digits, const char *after) {
    put(print, before);
    put_digits(print, value, digits);
    put(print, after);
}

static void indent(const struct mip_print *print, unsigned depth) {
    while (depth-- > 0) {
        put(print, "  ");
    }
}

/** Prints a line of bytes. */
static void put_bytes(const struct mip_print *print, unsigned depth, const char *what,
                      const uint8_t *bytes, size_t size) {
    indent(print, depth);
    put(print, what);
    for (size_t i = 0; i < size; i++) {
        put_number(print, " ", bytes[i], 2, "");
    }
    put(print, "\n");
}

/* ------------------------------------------------------------------------------------- numbers */

/** Returns the bits of a number in memory. */
static uint64_t load(const uint8_t *from, size_t size) {
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

static size_t size_of(uint8_t scalar) {
    switch (scalar) {
    case MIP_SCALAR_U16:
    case MIP_SCALAR_S16:
        return 2;
    case MIP_SCALAR_U32:
    case MIP_SCALAR_S32:
    case MIP_SCALAR_FLOAT:
        return 4;
    case MIP_SCALAR_U64:
    case MIP_SCALAR_S64:
        return 8;
    case MIP_SCALAR_DOUBLE:
        return sizeof(double);
    default:
        return 1;
    }
}

/** Reads a whole number, such as a counter or a selector. */
static uint64_t number_of(const struct mip_parameter *p, const uint8_t *record) {
    return load(record + p->offset, size_of(p->scalar));
}

static void put_character(const struct mip_print *print, uint8_t c) {
    const char character = (char)c;
    if (c < 0x20 || c > 0x7E) {
        put_number(print, "\\x", c, 2, "");
        return;
    }
    put(print, c == '"' || c == '\\' ? "\\" : "");
    print->put(print->user, &character, 1);
}

static void put_text(const struct mip_print *print, const uint8_t *text, size_t size) {
    put(print, "\"");
    for (size_t i = 0; i < size; i++) {
        put_character(print, text[i]);
    }
    put(print, "\"");
}

/** Prints a number that has no names. */
static void put_scalar(const struct mip_print *print, uint8_t scalar, const uint8_t *at) {
    const size_t size = size_of(scalar);
    const uint64_t bits = load(at, size);
    const uint64_t sign = UINT64_C(1) << (8 * size - 1);
    float single;
    double real;
    switch (scalar) {
    case MIP_SCALAR_FLOAT:
        memcpy(&single, at, sizeof(single));
        mip_print_float(print, single);
        return;
    case MIP_SCALAR_DOUBLE:
        memcpy(&real, at, sizeof(real));
        mip_print_double(print, real);
        return;
    case MIP_SCALAR_CHAR:
        put_text(print, at, 1);
        return;
    case MIP_SCALAR_BOOL:
        put(print, bits != 0 ? "true" : "false");
        if (bits > 1) {
            put(print, " (");
            mip_print_unsigned(print, bits);
            put(print, ")");
        }
        return;
    case MIP_SCALAR_S8:
    case MIP_SCALAR_S16:
    case MIP_SCALAR_S32:
    case MIP_SCALAR_S64:
        if ((bits & sign) != 0) {
            put(print, "-");
            mip_print_unsigned(print, sign - (bits - sign));
            return;
        }
        break;
    default:
        break;
    }
    mip_print_unsigned(print, bits);
}

/* --------------------------------------------------------------------------------------- names */

/** Prints a value of an enumeration: "write (1)", or the number alone. */
static void put_value(const struct mip_print *print, const struct mip_names *names,
                      uint64_t value) {
    const char *name = mip_value_name(names, value);
    if (name != NULL) {
        put(print, name);
        put(print, " (");
    }
    mip_print_unsigned(print, value);
    put(print, name != NULL ? ")" : "");
}

/** Do these bits mean something in a state, given as a bit? */
static bool in_state(const struct mip_named_bits *bits, unsigned state) {
    return bits->states == 0 || (bits->states & state) != 0;
}

/** Returns the bits of a byte that have no name in a state. */
static unsigned nameless(const struct mip_names *names, uint8_t byte, size_t index,
                         unsigned state) {
    unsigned left = byte;
    for (size_t i = 0; i < names->count; i++) {
        const struct mip_named_bits *b = &names->bits[i];
        for (size_t bit = 8 * index; bit < 8 * index + 8; bit++) {
            if (in_state(b, state) && bit >= b->first && bit < (size_t)b->first + b->width) {
                left &= ~(1U << bit % 8);
            }
        }
    }
    return left;
}

/** Prints the bits of a bitfield, least significant byte first: "0x8305 = ready | mode: fast (3) |
 * 0x8000". */
static void put_flags(const struct mip_print *print, const struct mip_names *names,
                      const uint8_t *bytes, size_t size, unsigned state) {
    const char *between = " = ";
    unsigned more = 0;
    put(print, "0x");
    for (size_t i = size; i-- > 0;) {
        put_digits(print, bytes[i], 2);
        more |= nameless(names, bytes[i], i, state);
    }
    for (size_t i = 0; i < names->count; i++) {
        const struct mip_named_bits *b = &names->bits[i];
        const bool number = b->width > 1 || b->names != NULL;
        const bool inside = (size_t)b->first + b->width <= 8 * size;
        const uint64_t value = inside ? mip_get_bits(bytes, MIP_BITS(b->first, b->width)) : 0;
        if (!inside || !in_state(b, state) || (!number && value == 0)) {
            continue;
        }
        put(print, between);
        put(print, mip_names_label(names, i));
        between = " | ";
        if (number) {
            put(print, ": ");
        }
        if (b->names != NULL) {
            put_value(print, b->names, value);
        } else if (number) {
            mip_print_unsigned(print, value);
        }
    }
    if (more != 0) {
        put(print, between);
        put(print, "0x");
        for (size_t i = size; i-- > 0;) {
            put_digits(print, nameless(names, bytes[i], i, state), 2);
        }
    }
}

/** Returns the names of a number, which may depend on the device or another parameter. */
static const struct mip_names *names_of(const struct mip_print *print,
                                        const struct mip_parameter *p,
                                        const struct mip_parameter *all, const uint8_t *record) {
    for (size_t i = 0; p->readings != NULL && i < p->count; i++) {
        const struct mip_reading *r = &p->readings[i];
        const bool holds = r->device == NULL
                               ? number_of(&all[r->by], record) == r->value
                               : print->device != NULL && strcmp(r->device, print->device) == 0;
        if (holds) {
            return r->names;
        }
    }
    return p->names;
}

/* -------------------------------------------------------------------------------------- values */

static void put_one(const struct mip_print *print, const struct mip_parameter *p,
                    const struct mip_names *names, const uint8_t *at, unsigned state) {
    const size_t size = size_of(p->scalar);
    const uint64_t bits = names != NULL ? load(at, size) : 0;
    if (names == NULL) {
        put_scalar(print, p->scalar, at);
    } else if (names->bits == NULL) {
        put_value(print, names, bits);
    } else {
        uint8_t bytes[8];
        for (size_t i = 0; i < sizeof(bytes); i++) {
            bytes[i] = (uint8_t)(bits >> 8 * i);
        }
        put_flags(print, names, bytes, size, state);
    }
}

/** Prints one item: a number, or a vector. */
static void put_item(const struct mip_print *print, const struct mip_parameter *p,
                     const struct mip_names *names, const uint8_t *at, unsigned state) {
    if (p->elements == 1) {
        put_one(print, p, names, at, state);
        return;
    }
    for (size_t i = 0; i < p->elements; i++) {
        put(print, i == 0 ? "[" : ", ");
        put_one(print, p, names, at + i * size_of(p->scalar), state);
    }
    put(print, "]");
}

static size_t items_of(const struct mip_parameter *p, const struct mip_parameter *all,
                       const uint8_t *record) {
    const uint64_t count = p->length == MIP_LENGTH_COUNTED ? number_of(&all[p->by], record)
                           : p->length == MIP_LENGTH_REST  ? record[p->count_offset]
                                                           : p->capacity;
    return count < p->capacity ? (size_t)count : p->capacity;
}

/** Are the bytes of an array together one bitfield? On some devices they are. */
static bool is_bitfield(const struct mip_parameter *p, const struct mip_names *names) {
    return p->length == MIP_LENGTH_FIXED && p->item_size == 1 && names != NULL &&
           names->bits != NULL && names->size == p->capacity;
}

/** Prints the rest of a line, after the name of a parameter. */
static void put_items(const struct mip_print *print, const struct mip_parameter *p,
                      const struct mip_parameter *all, const uint8_t *record) {
    const struct mip_names *names = names_of(print, p, all, record);
    const uint8_t *at = record + p->offset;
    const size_t count = items_of(p, all, record);
    const bool has_bits = names != NULL && names->bits != NULL;
    const uint64_t number = has_bits ? number_of(&all[p->by], record) : 0;
    const unsigned state = number < 16 ? 1U << number : 0;
    if (p->kind == MIP_KIND_CONSTANT) {
        mip_print_unsigned(print, p->value);
    } else if (p->kind == MIP_KIND_TEXT) {
        put_text(print, at, count);
    } else if (p->kind == MIP_KIND_BITS || is_bitfield(p, names)) {
        put_flags(print, names, at, count * p->item_size, state);
    } else if (p->length == MIP_LENGTH_ONE) {
        put_item(print, p, names, at, state);
    } else {
        put(print, "[");
        for (size_t i = 0; i < count; i++) {
            put(print, i == 0 ? "" : ", ");
            put_item(print, p, names, at + i * p->item_size, state);
        }
        put(print, "]");
    }
    if (p->unit[0] != '\0' && strcmp(p->unit, "1") != 0) {
        put(print, " ");
        put(print, p->unit);
    }
}

static void put_record(const struct mip_print *print, unsigned depth, const struct mip_record *r,
                       const uint8_t *record, unsigned present);

static void put_structures(const struct mip_print *print, unsigned depth,
                           const struct mip_parameter *p, const struct mip_parameter *all,
                           const uint8_t *record) {
    const size_t count = items_of(p, all, record);
    for (size_t i = 0; i < count; i++) {
        indent(print, depth);
        put(print, p->name);
        if (p->length != MIP_LENGTH_ONE) {
            put(print, "[");
            mip_print_unsigned(print, i);
            put(print, "]");
        }
        put(print, ":\n");
        put_record(print, depth + 1, p->record, record + p->offset + i * p->item_size, 0);
    }
}

/** Returns the alternative that is present; NULL if there is none. */
static const struct mip_parameter *selected(const struct mip_parameter *p,
                                            const struct mip_parameter *all,
                                            const uint8_t *record) {
    for (size_t i = 0; i < p->count; i++) {
        if (p->cases[i].value == number_of(&all[p->by], record)) {
            return p->cases[i].parameter;
        }
    }
    return NULL;
}

static void put_parameter(const struct mip_print *print, unsigned depth,
                          const struct mip_parameter *p, const struct mip_parameter *all,
                          const uint8_t *record) {
    if (p->kind == MIP_KIND_STRUCT && items_of(p, all, record) > 0) {
        put_structures(print, depth, p, all, record);
        return;
    }
    indent(print, depth);
    put(print, p->name);
    put(print, ":");
    if (p->kind == MIP_KIND_UNION) {
        const struct mip_parameter *member = selected(p, all, record);
        put(print, member != NULL ? "\n" : " none\n");
        if (member != NULL) {
            put_parameter(print, depth + 1, member, member, record + p->offset);
        }
        return;
    }
    put(print, " ");
    if (p->kind == MIP_KIND_STRUCT) {
        put(print, "none");
    } else {
        put_items(print, p, all, record);
    }
    put(print, "\n");
}

static void put_record(const struct mip_print *print, unsigned depth, const struct mip_record *r,
                       const uint8_t *record, unsigned present) {
    for (size_t i = 0; i < r->count; i++) {
        if (r->parameters[i].group <= present) {
            put_parameter(print, depth, &r->parameters[i], r->parameters, record);
        }
    }
}

/** Returns the number of a structure's present parameters, at least those that the function
 * requires. */
static unsigned present_of(const struct mip_reflection *r, const uint8_t *value) {
    const unsigned present = r->optional ? value[r->present_offset] : 0;
    const unsigned function = r->selector ? value[r->record->parameters[0].offset] : 0;
    const unsigned required = function < r->required_size ? r->required[function] : 0;
    return present > required ? present : required;
}

static void put_values(const struct mip_print *print, unsigned depth, const struct mip_codec *codec,
                       const uint8_t *value) {
    const struct mip_reflection *r = mip_reflect(codec);
    if (r != NULL) {
        put_record(print, depth, r->record, value, present_of(r, value));
    }
}

/* ------------------------------------------------------------------------- fields and packets */

static void put_error(const struct mip_print *print, unsigned depth, const char *error) {
    indent(print, depth);
    put(print, "error: ");
    put(print, error);
    put(print, "\n");
}

static void put_field(const struct mip_print *print, unsigned depth,
                      const struct mip_field *field) {
    static const char *const roles[] = {": command (0x", ": response (0x", ": data (0x"};
    const struct mip_entry *entry = mip_registry_find(field);
    union mip_any_value value;
    size_t trailing;
    mip_error error;
    indent(print, depth);
    if (entry != NULL) {
        put(print, mip_registry_set_name(entry, field->descriptor_set));
        put(print, ".");
    }
    put(print, entry != NULL ? entry->name : "unknown");
    put_number(print, entry != NULL ? roles[entry->role] : " (0x", field->descriptor_set, 2, "");
    put_number(print, ",0x", field->descriptor, 2, ")\n");
    if (entry == NULL) {
        if (mip_registry_next(field->descriptor_set, field->descriptor, NULL) != NULL) {
            put_error(print, depth + 1, "layout");
        }
        put_bytes(print, depth + 1, "raw:", field->data, field->size);
        return;
    }
    error = mip_decode(entry->codec, &value, field, &trailing);
    if (error != MIP_OK) {
        put_error(print, depth + 1, mip_error_name(error));
        put_bytes(print, depth + 1, "raw:", field->data, field->size);
        return;
    }
    put_values(print, depth + 1, entry->codec, value.bytes);
    if (trailing > 0) {
        put_bytes(print, depth + 1, "trailing:", field->data + field->size - trailing, trailing);
    }
}

void mip_print_packet(const struct mip_print *print, const struct mip_packet *packet) {
    const struct mip_set *set = mip_registry_set(packet->descriptor_set);
    struct mip_walk walk = mip_walk_packet(packet);
    const uint8_t *at = walk.at;
    struct mip_field field;
    put_number(print, "packet (0x", packet->descriptor_set, 2, ")");
    put(print, set != NULL ? " " : "");
    put(print, set != NULL ? set->name : "");
    put(print, ", ");
    mip_print_unsigned(print, packet->size);
    put(print, " bytes\n");
    while (mip_walk_next(&walk, &field)) {
        put_field(print, 1, &field);
        at = walk.at;
    }
    if (walk.error != MIP_OK) {
        put_error(print, 1, mip_error_name(walk.error));
        put_bytes(print, 1, "raw:", at, (size_t)(walk.end - at));
    }
}

void mip_print_field(const struct mip_print *print, const struct mip_field *field) {
    put_field(print, 0, field);
}

/* ------------------------------------------------------------------------------------- buffers */

static void keep(void *user, const char *text, size_t size) {
    struct mip_text *to = (struct mip_text *)user;
    if (to->length < to->room) {
        const size_t left = to->room - to->length - 1;
        const size_t fits = size < left ? size : left;
        memcpy(to->buffer + to->length, text, fits);
        to->buffer[to->length + fits] = '\0';
    }
    to->length += size;
}

struct mip_print mip_print_to_text(struct mip_text *text, char *buffer, size_t room) {
    struct mip_print print;
    text->buffer = buffer;
    text->room = room;
    text->length = 0;
    if (room > 0) {
        buffer[0] = '\0';
    }
    print.put = keep;
    print.user = text;
    print.device = NULL;
    return print;
}
