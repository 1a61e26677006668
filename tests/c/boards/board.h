/* What stands in for boards in tests, on POSIX threads: the UART is a TCP connection to the address in MIP_PLACE. Ends after
 * twenty accelerations. */
#ifndef BOARD_H
#define BOARD_H

#include "mip/line.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static struct mip_line uart_line;

/* The interrupt of the UART: bytes have arrived. */
static void uart_arrived(const uint8_t *bytes, size_t size);

static inline void *uart_receive(void *unused) {
    uint8_t bytes[32];
    size_t count = 0;
    (void)unused;
    while (uart_line.port.read(uart_line.port.user, bytes, sizeof(bytes), &count)) {
        if (count > 0) {
            uart_arrived(bytes, count);
        }
        count = 0;
    }
    exit(4);
}

static inline void uart_open(void) {
    pthread_t thread;
    if (!mip_line_open(&uart_line, getenv("MIP_PLACE"), 115200) ||
        pthread_create(&thread, NULL, uart_receive, NULL) != 0) {
        exit(2);
    }
}

static inline bool uart_write(const uint8_t *bytes, size_t size) {
    return uart_line.port.write(uart_line.port.user, bytes, size);
}

static inline uint32_t board_now(void) {
    return uart_line.port.now(uart_line.port.user);
}

static inline void board_sleep(uint32_t milliseconds) {
    const struct timespec time = {(time_t)(milliseconds / 1000), (long)(milliseconds % 1000) * 1000000};
    nanosleep(&time, NULL);
}

void application_take(const float accel[3]);
void application_take(const float accel[3]) {
    static unsigned count;
    printf("%.3f\n", (double)accel[2]);
    if (++count == 20) {
        fflush(stdout);
        _Exit(0);
    }
}

/* Bytes between two threads: a buffer, a queue of records, or a semaphore. */
struct fifo {
    pthread_mutex_t mutex;
    pthread_cond_t filled;
    size_t size;
    uint8_t bytes[1024];
};

#define FIFO {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, 0, {0}}

static inline size_t fifo_put(struct fifo *to, const void *bytes, size_t size) {
    pthread_mutex_lock(&to->mutex);
    const size_t fits = size < sizeof(to->bytes) - to->size ? size : sizeof(to->bytes) - to->size;
    memcpy(to->bytes + to->size, bytes, fits);
    to->size += fits;
    pthread_cond_signal(&to->filled);
    pthread_mutex_unlock(&to->mutex);
    return fits;
}

static inline size_t fifo_get(struct fifo *from, void *bytes, size_t size, uint32_t wait) {
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += (long)(wait % 1000) * 1000000;
    until.tv_sec += wait / 1000 + until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    pthread_mutex_lock(&from->mutex);
    while (wait > 0 && from->size == 0 && pthread_cond_timedwait(&from->filled, &from->mutex, &until) == 0) {
    }
    const size_t count = size < from->size ? size : from->size;
    memcpy(bytes, from->bytes, count);
    from->size -= count;
    memmove(from->bytes, from->bytes + count, from->size);
    pthread_mutex_unlock(&from->mutex);
    return count;
}

#endif
