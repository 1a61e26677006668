/* What examples/freertos.c uses of FreeRTOS: tasks are threads. */
#ifndef FREERTOS_H
#define FREERTOS_H

#include "board.h"

typedef long BaseType_t;
typedef unsigned long UBaseType_t;
typedef uint32_t TickType_t;
typedef pthread_mutex_t *SemaphoreHandle_t;
typedef struct fifo *StreamBufferHandle_t;
typedef struct task *TaskHandle_t;

#define pdFALSE ((BaseType_t)0)
#define portMAX_DELAY UINT32_MAX
#define portTICK_PERIOD_MS ((TickType_t)1)
#define pdMS_TO_TICKS(milliseconds) ((TickType_t)(milliseconds))
#define portYIELD_FROM_ISR(woken) ((void)(woken))
#define xSemaphoreTakeRecursive(mutex, wait) (pthread_mutex_lock(mutex) == 0)
#define xSemaphoreGiveRecursive(mutex) (pthread_mutex_unlock(mutex) == 0)
#define xStreamBufferReceive fifo_get
#define vTaskDelay board_sleep
#define vTaskDelete(task) pthread_exit(NULL)
#define xTaskGetTickCount board_now

void uart_send(const uint8_t *bytes, size_t size);
void uart_interrupt(const uint8_t *bytes, size_t size);

static void (*tasks[2])(void *);

static SemaphoreHandle_t xSemaphoreCreateRecursiveMutex(void) {
    static pthread_mutex_t made;
    pthread_mutexattr_t how;
    pthread_mutexattr_init(&how);
    pthread_mutexattr_settype(&how, PTHREAD_MUTEX_RECURSIVE);
    pthread_mutex_init(&made, &how);
    return &made;
}

static StreamBufferHandle_t xStreamBufferCreate(size_t size, size_t trigger) {
    static struct fifo made = FIFO;
    return size == sizeof(made.bytes) && trigger == 1 ? &made : NULL;
}

static size_t xStreamBufferSendFromISR(StreamBufferHandle_t to, const void *bytes, size_t size, BaseType_t *woken) {
    *woken = 1;
    return fifo_put(to, bytes, size);
}

static BaseType_t xTaskCreate(void (*run)(void *), const char *name, unsigned short stack, void *argument,
                              UBaseType_t priority, TaskHandle_t *task) {
    (void)name, (void)stack, (void)argument, (void)priority, (void)task;
    tasks[tasks[0] != NULL] = run;
    return 1;
}

void uart_send(const uint8_t *bytes, size_t size) {
    if (!uart_write(bytes, size)) {
        exit(3);
    }
}

static void uart_arrived(const uint8_t *bytes, size_t size) {
    uart_interrupt(bytes, size);
}

static void *second_task(void *argument) {
    tasks[1](argument);
    return NULL;
}

static void vTaskStartScheduler(void) {
    pthread_t thread;
    uart_open();
    pthread_create(&thread, NULL, second_task, NULL);
    tasks[0](NULL);
}

#endif
