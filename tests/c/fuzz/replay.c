/*
 * Runs a fuzz target without libFuzzer: the inputs of a file, then COUNT more made from them at random.
 *
 *     replay FILE COUNT [SEED]
 *
 * The file has one input per line, in hexadecimal; empty lines and those that begin with # are comments.
 */
#define _POSIX_C_SOURCE 200809L

#include "fuzz.h"

#include <signal.h>
#include <unistd.h>

#ifndef REPLAY_PATIENCE
#define REPLAY_PATIENCE 60 /* seconds */
#endif

enum { LARGEST = 4096 };
enum { FEW = 256 }; /* inputs that are run within this time; a system call for each would be slow */

struct bytes {
    uint8_t *data;
    size_t size;
};

static struct bytes *inputs;
static size_t input_count;

static struct bytes current;

/* Prints the input before the process ends; calls only what a signal handler may call. */
static void show(int signal_number) {
    static const char digits[] = "0123456789abcdef";
    static char text[2 * LARGEST + 64];
    size_t length = 0;
    const char *words = signal_number == SIGALRM ? "the target does not come back from:\n" : "the target failed with:\n";
    for (; *words != '\0'; words++) {
        text[length++] = *words;
    }
    for (size_t i = 0; i < current.size; i++) {
        text[length++] = digits[current.data[i] >> 4];
        text[length++] = digits[current.data[i] & 15];
    }
    text[length++] = '\n';
    if (write(2, text, length) < 0) {
        _exit(4);
    }
    _exit(3);
}

static void run(const uint8_t *data, size_t size) {
    current.data = (uint8_t *)exactly(size);
    current.size = size;
    if (size > 0) {
        memcpy(current.data, data, size);
    }
    static unsigned long count;
    if (count++ % FEW == 0) {
        alarm(REPLAY_PATIENCE);
    }
    LLVMFuzzerTestOneInput(current.data, size);
    free(current.data);
}

static int digit(int c) {
    return c <= '9' ? c - '0' : c - 'a' + 10;
}

static void read_inputs(const char *path) {
    FILE *file = fopen(path, "r");
    char *line = NULL;
    size_t room = 0;
    CHECK(file != NULL);
    while (getline(&line, &room, file) >= 0) {
        if (line[0] == '#' || line[0] == '\n') {
            continue;
        }
        const size_t size = strspn(line, "0123456789abcdef") / 2;
        struct bytes *more = (struct bytes *)realloc(inputs, (input_count + 1) * sizeof(*inputs));
        CHECK(more != NULL && size <= LARGEST && line[2 * size] == '\n');
        inputs = more;
        inputs[input_count].size = size;
        inputs[input_count].data = (uint8_t *)exactly(size);
        for (size_t i = 0; i < size; i++) {
            inputs[input_count].data[i] = (uint8_t)(digit(line[2 * i]) << 4 | digit(line[2 * i + 1]));
        }
        input_count++;
    }
    free(line);
    fclose(file);
}

static uint64_t state;

/* SplitMix64 of Steele, Lea and Flood: any seed will do, and 2^64 draws until it repeats itself. */
static uint64_t draw(void) {
    state += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t x = state;
    x = (x ^ x >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    x = (x ^ x >> 27) * UINT64_C(0x94D049BB133111EB);
    return x ^ x >> 31;
}

static uint32_t chance(uint32_t below) {
    return (uint32_t)(draw() >> 32) % below;
}

static size_t insert(uint8_t *to, size_t size, const uint8_t *from, size_t count) {
    count = count < LARGEST - size ? count : LARGEST - size;
    const size_t at = chance((uint32_t)size + 1);
    memmove(to + at + count, to + at, size - at);
    memcpy(to + at, from, count);
    return size + count;
}

/* An input with a few changes: bytes, bits, small numbers, a part removed, a part of another one inserted. */
static size_t change(uint8_t *bytes, size_t size) {
    for (uint32_t changes = chance(4) + 1; changes > 0; changes--) {
        const size_t at = size > 0 ? chance((uint32_t)size) : 0;
        const uint64_t drawn = draw();
        uint8_t fresh[8];
        for (size_t i = 0; i < sizeof(fresh); i++) {
            fresh[i] = (uint8_t)(drawn >> 8 * i);
        }
        switch (chance(6)) {
        case 0:
            size = insert(bytes, size, fresh, chance(8) + 1);
            break;
        case 1: {
            const struct bytes *other = &inputs[chance((uint32_t)input_count)];
            const size_t from = chance((uint32_t)other->size + 1);
            size = insert(bytes, size, other->data + from, other->size - from);
            break;
        }
        case 2: {
            const size_t less = size > 0 ? chance((uint32_t)(size - at)) + 1 : 0;
            memmove(bytes + at, bytes + at + less, size - at - less);
            size -= less;
            break;
        }
        case 3:
            bytes[at] = (uint8_t)chance(8);
            break;
        case 4:
            bytes[at] = (uint8_t)(bytes[at] ^ 1U << chance(8));
            break;
        default:
            bytes[at] = fresh[0];
            break;
        }
    }
    return size;
}

int main(int argc, char **argv) {
    CHECK(argc == 3 || argc == 4);
    const unsigned long count = strtoul(argv[2], NULL, 10);
    state = argc == 4 ? strtoull(argv[3], NULL, 10) : 1;
    static const int ends[] = {SIGABRT, SIGALRM, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGTRAP};
    for (size_t i = 0; i < sizeof(ends) / sizeof(ends[0]); i++) {
        signal(ends[i], show);
    }
    read_inputs(argv[1]);
    CHECK(input_count > 0);
    run(NULL, 0);
    for (size_t i = 0; i < input_count; i++) {
        run(inputs[i].data, inputs[i].size);
    }
    for (unsigned long i = 0; i < count; i++) {
        static uint8_t bytes[LARGEST];
        const struct bytes *from = &inputs[chance((uint32_t)input_count)];
        memcpy(bytes, from->data, from->size);
        run(bytes, change(bytes, from->size));
    }
    printf("%zu inputs and %lu that were made from them\n", input_count, count);
    for (size_t i = 0; i < input_count; i++) {
        free(inputs[i].data);
    }
    free(inputs);
    return 0;
}
