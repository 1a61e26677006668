/* What the programs of the benchmark share: `PROGRAM FILE FUNCTION ROUNDS` runs one function over the bytes of a file,
 * and prints the fewest nanoseconds of processor time that a round took and what it found. */
#ifndef ROUNDS_H
#define ROUNDS_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct row {
    const char *name;
    size_t (*run)(const uint8_t *data, size_t size);
};

#define ROW(name) {#name, name}
/** A function of its own, so that valgrind can count the instructions of one. */
#define FUNCTION(name)                             \
    size_t name(const uint8_t *data, size_t size); \
    size_t name(const uint8_t *data, size_t size)

/** Keeps the compiler from removing a computation; takes no instruction itself. */
static inline void use(const void *value) {
    __asm__ volatile("" : : "r"(value) : "memory");
}

#if defined(BOARD) && defined(__riscv)
/** The number of instructions. */
static inline double now(void) {
    uint32_t count;
    __asm__ volatile("rdinstret %0" : "=r"(count));
    return (double)count;
}
#elif defined(BOARD)
/** On QEMU's mps2-an386 with `-icount shift=0`, each instruction takes a nanosecond, and the counter of this timer
 * decreases every 40 ns. */
static inline double now(void) {
    volatile uint32_t *const timer = (volatile uint32_t *)(uintptr_t)0x40000000;
    if (timer[0] == 0) { /* stopped */
        timer[2] = UINT32_MAX;
        timer[1] = UINT32_MAX;
        timer[0] = 1;
    }
    return 40.0 * (double)(UINT32_MAX - timer[1]);
}
#else
static inline double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}
#endif

static inline int run_rounds(const struct row *rows, size_t count, int arguments, char **given) {
    given += arguments - 4; /* some emulators add a name before the program's */
    FILE *file = arguments >= 4 ? fopen(given[1], "rb") : NULL;
    if (file == NULL) {
        return 2;
    }
    fseek(file, 0, SEEK_END);
    const size_t size = (size_t)ftell(file);
    uint8_t *data = malloc(size);
    rewind(file);
    if (data == NULL || fread(data, 1, size, file) != size) {
        return 2;
    }
    fclose(file);
    for (size_t row = 0; row < count; row++) {
        if (strcmp(rows[row].name, given[2]) == 0) {
            double best = 1e18;
            size_t found = 0;
            for (long round = strtol(given[3], NULL, 10); round > 0; round--) {
                const double begin = now();
                found = rows[row].run(data, size);
                const double time = now() - begin;
                best = time < best ? time : best;
            }
            printf("%.0f %zu\n", best, found);
            free(data);
            return 0;
        }
    }
    return 2;
}

#endif
