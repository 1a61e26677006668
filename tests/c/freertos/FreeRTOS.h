/* What examples/freertos.c uses of FreeRTOS, on POSIX threads. */
#ifndef FREERTOS_H
#define FREERTOS_H

#include <stddef.h>
#include <stdint.h>

typedef long BaseType_t;
typedef unsigned long UBaseType_t;
typedef uint32_t TickType_t;
typedef struct mutex *SemaphoreHandle_t;
typedef struct stream *StreamBufferHandle_t;
typedef struct task *TaskHandle_t;

#define pdFALSE ((BaseType_t)0)
#define portMAX_DELAY UINT32_MAX
#define portTICK_PERIOD_MS ((TickType_t)1)
#define pdMS_TO_TICKS(milliseconds) ((TickType_t)(milliseconds))
#define portYIELD_FROM_ISR(woken) ((void)(woken))

SemaphoreHandle_t xSemaphoreCreateRecursiveMutex(void);
BaseType_t xSemaphoreTakeRecursive(SemaphoreHandle_t mutex, TickType_t wait);
BaseType_t xSemaphoreGiveRecursive(SemaphoreHandle_t mutex);
StreamBufferHandle_t xStreamBufferCreate(size_t size, size_t trigger);
size_t xStreamBufferSendFromISR(StreamBufferHandle_t stream, const void *bytes, size_t size, BaseType_t *woken);
size_t xStreamBufferReceive(StreamBufferHandle_t stream, void *bytes, size_t size, TickType_t wait);
BaseType_t xTaskCreate(void (*run)(void *), const char *name, unsigned short stack, void *argument, UBaseType_t priority,
                       TaskHandle_t *task);
void vTaskDelay(TickType_t ticks);
void vTaskDelete(TaskHandle_t task);
void vTaskStartScheduler(void);
TickType_t xTaskGetTickCount(void);

#endif
