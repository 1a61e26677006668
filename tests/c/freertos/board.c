/* The functions of FreeRTOS and of the board for examples/freertos.c: tasks are threads, and the UART is a TCP connection
 * to the address in MIP_PLACE. Ends after twenty accelerations. */
#define _GNU_SOURCE
#include "FreeRTOS.h"
#include "mip/line.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void uart_send(const uint8_t *bytes, size_t size);
void uart_interrupt(const uint8_t *bytes, size_t size);
void application_take(const float accel[3]);

struct mutex {
    pthread_mutex_t of;
};

struct stream {
    pthread_mutex_t mutex;
    pthread_cond_t filled;
    size_t size;
    uint8_t bytes[1024];
};

struct start {
    void (*run)(void *);
    void *argument;
};

static struct mip_line line;

SemaphoreHandle_t xSemaphoreCreateRecursiveMutex(void) {
    static struct mutex made;
    pthread_mutexattr_t how;
    pthread_mutexattr_init(&how);
    pthread_mutexattr_settype(&how, PTHREAD_MUTEX_RECURSIVE);
    pthread_mutex_init(&made.of, &how);
    return &made;
}

BaseType_t xSemaphoreTakeRecursive(SemaphoreHandle_t mutex, TickType_t wait) {
    (void)wait;
    return pthread_mutex_lock(&mutex->of) == 0;
}

BaseType_t xSemaphoreGiveRecursive(SemaphoreHandle_t mutex) {
    return pthread_mutex_unlock(&mutex->of) == 0;
}

StreamBufferHandle_t xStreamBufferCreate(size_t size, size_t trigger) {
    static struct stream made = {.mutex = PTHREAD_MUTEX_INITIALIZER, .filled = PTHREAD_COND_INITIALIZER};
    return size == sizeof(made.bytes) && trigger == 1 ? &made : NULL;
}

size_t xStreamBufferSendFromISR(StreamBufferHandle_t s, const void *bytes, size_t size, BaseType_t *woken) {
    pthread_mutex_lock(&s->mutex);
    const size_t fits = size < sizeof(s->bytes) - s->size ? size : sizeof(s->bytes) - s->size;
    memcpy(s->bytes + s->size, bytes, fits);
    s->size += fits;
    *woken = 1;
    pthread_cond_signal(&s->filled);
    pthread_mutex_unlock(&s->mutex);
    return fits;
}

size_t xStreamBufferReceive(StreamBufferHandle_t s, void *bytes, size_t size, TickType_t wait) {
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += (long)wait * 1000000;
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    pthread_mutex_lock(&s->mutex);
    while (s->size == 0 && pthread_cond_timedwait(&s->filled, &s->mutex, &until) == 0) {
    }
    const size_t count = size < s->size ? size : s->size;
    memcpy(bytes, s->bytes, count);
    s->size -= count;
    memmove(s->bytes, s->bytes + count, s->size);
    pthread_mutex_unlock(&s->mutex);
    return count;
}

static void *begin(void *of) {
    struct start start = *(struct start *)of;
    free(of);
    start.run(start.argument);
    return NULL;
}

BaseType_t xTaskCreate(void (*run)(void *), const char *name, unsigned short stack, void *argument, UBaseType_t priority,
                       TaskHandle_t *task) {
    struct start *start = malloc(sizeof(*start));
    pthread_t thread;
    (void)name, (void)stack, (void)priority, (void)task;
    if (line.error == NULL && line.name == NULL && !mip_line_open(&line, getenv("MIP_PLACE"), 115200)) {
        exit(2); /* it must be open before the first task runs */
    }
    if (start == NULL) {
        return 0;
    }
    start->run = run;
    start->argument = argument;
    return pthread_create(&thread, NULL, begin, start) == 0 && pthread_detach(thread) == 0;
}

void vTaskDelay(TickType_t ticks) {
    const struct timespec time = {(time_t)(ticks / 1000), (long)(ticks % 1000) * 1000000};
    nanosleep(&time, NULL);
}

void vTaskDelete(TaskHandle_t task) {
    (void)task;
    pthread_exit(NULL);
}

TickType_t xTaskGetTickCount(void) {
    return line.port.now(line.port.user);
}

void uart_send(const uint8_t *bytes, size_t size) {
    if (!line.port.write(line.port.user, bytes, size)) {
        exit(3);
    }
}

void application_take(const float accel[3]) {
    static unsigned count;
    printf("%.3f\n", (double)accel[2]);
    if (++count == 20) {
        fflush(stdout);
        _Exit(0);
    }
}

/* Receives, in place of the interrupt. */
void vTaskStartScheduler(void) {
    uint8_t bytes[32];
    size_t count = 0;
    while (line.port.read(line.port.user, bytes, sizeof(bytes), &count)) {
        uart_interrupt(bytes, count);
        count = 0;
    }
    exit(4);
}
