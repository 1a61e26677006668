/* Runs the programs that describe layouts; mip/core/program.h defines their steps. */
#include "mip/core/program.h"

#include <string.h>

/** A field that is being read or written, and the state of its optional parameters. */
struct stream {
    uint8_t *at;
    uint8_t *end;
    /** The beginning of the last group of parameters. */
    uint8_t *mark;
    /** A mip_error. */
    uint8_t error;
    /** The number of parameters that the function requires, and the number present: read, or to be
     * written. */
    uint8_t required;
    uint8_t present;
    /** The last parameter of the group. */
    uint8_t last;
    bool writing;
    /** Do offsets have two bytes? Does the structure contain the number of present parameters? */
    bool far;
    bool counts;
    /** May the group be absent? Is only a part of it present? Has the run ended before MIP_END? */
    bool optional;
    bool cut;
    bool stopped;
    /** Are parameters omitted? Their memory is checked, so that a value is not silently omitted. */
    bool absent;
};

/** Ends the run; returns false, so that callers can return that. */
static bool fail(struct stream *s, mip_error error) {
    if (error == MIP_ERROR_TRUNCATED && s->optional) {
        s->cut = true;
    } else {
        s->error = (uint8_t)error;
    }
    s->stopped = true;
    return false;
}

/** Returns the next bytes of the field, or NULL if there are too few. */
static uint8_t *take(struct stream *s, size_t size) {
    uint8_t *bytes = s->at;
    if (size > (size_t)(s->end - bytes)) {
        fail(s, s->writing ? MIP_ERROR_LENGTH : MIP_ERROR_TRUNCATED);
        return NULL;
    }
    s->at = bytes + size;
    return bytes;
}

/** Copies a number of 1, 2, 4 or 8 bytes, high byte first. */
static void get_number(uint8_t *bytes, uint8_t *memory, size_t size) {
    mip_move(bytes, memory, 4U + (size > 1) + (size > 2) + (size > 4), 1, true);
}

/** Returns the next offset in the program. */
static size_t place(const struct stream *s, const uint8_t **program) {
    size_t offset = *(*program)++;
    if (s->far) {
        offset = offset << 8 | *(*program)++;
    }
    return offset;
}

/** Returns the number of elements of an array, from or for its counter; more than `capacity` on an
 * error. */
static size_t count(struct stream *s, uint8_t *counter, size_t size, size_t capacity, size_t wire,
                    bool rest) {
    const size_t left = (size_t)(s->end - s->at) / wire;
    uint8_t bytes[8];
    size_t number = 0;
    if (rest && !s->writing) {
        number = left < capacity ? left : capacity;
        *counter = (uint8_t)number;
        return number;
    }
    get_number(bytes, counter, size);
    for (size_t i = 0; i < size; i++) {
        number = number > capacity ? number : number << 8 | bytes[i];
    }
    if (number > capacity || (number > left && !s->writing)) {
        fail(s, MIP_ERROR_COUNT);
        return capacity + 1;
    }
    return number;
}

/** Begins a group of parameters. Returns false if it is absent. */
static bool group(struct stream *s, unsigned count) {
    const uint8_t before = s->last;
    const uint8_t last = (uint8_t)(before + count);
    s->last = last;
    if (s->writing) {
        if (s->present > before && s->present < last) {
            return fail(s, MIP_ERROR_MISSING);
        }
        s->absent = s->present < last;
        return true;
    } else {
        s->present = before;
        s->mark = s->at;
        s->optional = last > s->required;
        s->stopped = s->optional && s->at == s->end;
    }
    return !s->stopped;
}

/** Reads and checks, or writes, a constant. */
static bool constant(struct stream *s, const uint8_t *bytes, size_t size) {
    uint8_t *wire = take(s, size);
    for (size_t i = 0; wire != NULL && i < size; i++) {
        if (s->writing) {
            wire[i] = bytes[i];
        } else if (wire[i] != bytes[i]) {
            return fail(s, MIP_ERROR_CONSTANT);
        }
    }
    return wire != NULL;
}

/** Returns the program of the case that a tag selects; NULL if there is none. */
static const uint8_t *selected(const uint8_t *program, uint8_t *tag, size_t size, size_t cases) {
    uint8_t bytes[8];
    get_number(bytes, tag, size);
    for (; cases > 0; cases--) {
        bool same = true;
        for (size_t i = 0; i < size; i++) {
            same = *program++ == bytes[i] && same;
        }
        const size_t length = *program++;
        if (same) {
            return program;
        }
        program += length;
    }
    return NULL;
}

/** Runs a program for the structure at `base`. Returns false if it ended early, which also ends the
 * enclosing programs. */
static bool run(struct stream *s, const uint8_t *p, uint8_t *base) {
    size_t times = 1;
    for (;;) {
        const unsigned step = *p++;
        if (step >= MIP_NUMBERS(MIP_KIND_DOUBLE, 0)) { /* numbers */
            const unsigned kind = step >> 5;
            size_t n = step & 31;
            n = (n > 0 ? n : *p++) * times;
            times = 1;
            uint8_t *memory = base + place(s, &p);
            if (s->absent) {
                const size_t size = kind == MIP_KIND_DOUBLE ? sizeof(double) : 1U << (kind & 3);
                for (size_t i = 0; i < n * size; i++) {
                    if (memory[i] != 0) {
                        return fail(s, MIP_ERROR_MISSING);
                    }
                }
                continue;
            }
            uint8_t *wire = take(s, n << (kind & 3));
            if (wire == NULL) {
                return false;
            }
            mip_move(wire, memory, kind, n, s->writing);
            continue;
        }
        switch (step) {
        case MIP_STEP_FAR:
            s->far = true;
            break;
        case MIP_STEP_LAYOUT:
            p += 3 + 2 * p[2];
            break;
        case MIP_STEP_OPTIONAL: {
            const uint8_t functions = *p++;
            s->counts = true;
            if (functions > 0) {
                uint8_t *wire = take(s, 1);
                if (wire == NULL) {
                    return false;
                }
                mip_move(wire, base + 1, 4, 1, s->writing);
                const uint8_t index = (uint8_t)(base[1] - 1U);
                s->required = index < functions ? p[index] : 0;
                p += functions;
            } else {
                s->last = *p++;
            }
            if (s->writing) {
                s->present = base[0] > s->required ? base[0] : s->required;
            }
            break;
        }
        case MIP_STEP_CONSTANT:
            if (!s->absent && !constant(s, p + 1, p[0])) {
                return false;
            }
            p += 1 + p[0];
            break;
        case MIP_STEP_COUNTED:
        case MIP_STEP_REST: {
            const uint8_t *of = p;
            p += 3;
            times = count(s, base + place(s, &p), of[0], of[1], of[2], step == MIP_STEP_REST);
            if (times > of[1]) {
                return false;
            }
            break;
        }
        case MIP_STEP_EACH: {
            const uint8_t *of = p;
            p += 4;
            uint8_t *item = base + place(s, &p);
            for (size_t n = of[0] * times; n > 0; n--) {
                if (!run(s, p, item)) {
                    return false;
                }
                item += (size_t)of[1] << 8 | of[2];
            }
            p += of[3];
            times = 1;
            break;
        }
        case MIP_STEP_SWITCH: { /* always the last step: nothing follows the cases */
            const size_t size = *p++;
            const size_t cases = *p++;
            uint8_t *tag = base + place(s, &p);
            p = selected(p, tag, size, cases);
            if (p == NULL) {
                return true;
            }
            break;
        }
        case MIP_STEP_RESERVED:
            if (s->absent) {
                return false;
            }
            break;
        case MIP_STEP_END:
            return true;
        default: /* a group */
            if (!group(s, step > MIP_STEP_GROUP ? step - MIP_STEP_GROUP : *p++)) {
                return false;
            }
        }
    }
}

static bool matches(const struct mip_codec *codec, const struct mip_field *field) {
    const uint8_t *p = codec->program; /* it begins with MIP_LAYOUT */
    if (field->size < p[1] || field->size > p[2]) {
        return false;
    }
    for (size_t left = p[3]; left > 0; left--) { /* offsets in the data, and the bytes there */
        p += 2;
        if (p[2] < field->size && field->data[p[2]] != p[3]) {
            return false;
        }
    }
    return true;
}

static mip_error read_field(const struct mip_codec *codec, void *value,
                            const struct mip_field *field, size_t *trailing) {
    struct stream s;
    /* The field is only read. */
    uint8_t *data = (uint8_t *)(uintptr_t)field->data;
    uint8_t *end = data + field->size;
    do {
        memset(value, 0, codec->size);
        memset(&s, 0, sizeof(s));
        s.at = data;
        s.end = end;
        run(&s, codec->program, (uint8_t *)value);
        end = s.mark; /* an incomplete group is ignored */
    } while (s.cut);
    if (s.error == MIP_OK && s.counts) {
        const bool empty = s.optional && s.at == s.mark; /* an empty union counts as absent */
        *(uint8_t *)value = s.stopped || empty ? s.present : s.last;
    }
    if (s.error != MIP_OK) {
        memset(value, 0, codec->size);
    }
    if (trailing != NULL) {
        *trailing = (size_t)(data + field->size - s.at);
    }
    return (mip_error)s.error;
}

static mip_error write_field(const struct mip_codec *codec, const void *value, uint8_t *data,
                             size_t room, size_t *size) {
    struct stream s;
    memset(&s, 0, sizeof(s));
    s.at = data;
    s.end = data + room;
    s.writing = true;
    /* The structure is only read. */
    run(&s, codec->program, (uint8_t *)(uintptr_t)value);
    if (s.error == MIP_OK && s.present > s.last) {
        s.error = MIP_ERROR_MISSING;
    }
    *size = (size_t)(s.at - data);
    return (mip_error)s.error;
}

const struct mip_interpreter mip_program = {NULL, read_field, write_field};
const struct mip_interpreter mip_layout = {matches, read_field, write_field};
