/* FreeRTOS: one task receives, and calls the handlers; another one sends commands. Compile the
 * library and this program with -DMIP_HOOKS, which adds the lock. */
#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/sensor.h"

#include "FreeRTOS.h"
#include "semphr.h"
#include "stream_buffer.h"
#include "task.h"

/* ------------------------------------------------------------------------ provided by the board */

/* Sends bytes through the UART. */
void uart_send(const uint8_t *bytes, size_t size);
/* The application's handler for an acceleration, in g. */
void application_take(const float accel[3]);

/* ------------------------------------------------------------------------ the port */

static struct mip_device device;
static SemaphoreHandle_t mutex;
static StreamBufferHandle_t received;

/* Call this in the interrupt of the UART, or of its DMA, with the bytes that have arrived. */
void uart_interrupt(const uint8_t *bytes, size_t size);
void uart_interrupt(const uint8_t *bytes, size_t size) {
    BaseType_t woken = pdFALSE;
    (void)xStreamBufferSendFromISR(received, bytes, size, &woken); /* what does not fit is lost */
    portYIELD_FROM_ISR(woken);
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    uart_send(bytes, size);
    return true;
}

static uint32_t port_now(void *user) {
    (void)user;
    return (uint32_t)(xTaskGetTickCount() * portTICK_PERIOD_MS);
}

static void lock(void *user, bool locks) {
    (void)user;
    if (locks) {
        (void)xSemaphoreTakeRecursive(mutex, portMAX_DELAY);
    } else {
        (void)xSemaphoreGiveRecursive(mutex);
    }
}

/* ------------------------------------------------------------------------ the tasks */

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_sensor_scaled_accel accel;
    (void)user, (void)arrived;
    if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
        application_take(accel.scaled_accel);
    }
}

/* The only task that receives. It also ends commands whose replies are overdue. */
static void receive_task(void *unused) {
    (void)unused;
    for (;;) {
        uint8_t bytes[64];
        const size_t size = xStreamBufferReceive(received, bytes, sizeof(bytes), pdMS_TO_TICKS(10));
        (void)mip_device_step(&device, bytes, size);
    }
}

/* Waits for the reply to a command of this task; the other one receives it. */
static bool done(const struct mip_request *request) {
    while (mip_request_result(&device, request).outcome == MIP_WAITING) {
        vTaskDelay(1);
    }
    return mip_succeeded(mip_request_result(&device, request));
}

/* The device sends accelerations at a tenth of its base rate. */
static bool configure(void) {
    static const struct mip_descriptor_rate fields[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 10}};
    static struct mip_request request; /* it must stay at its address while it waits */
    mip_call_base_set_idle(mip_defer(&device, &request));
    if (!done(&request)) {
        return false;
    }
    mip_call_3dm_message_format_write(mip_defer(&device, &request), MIP_SENSOR_SET,
                                      MIP_ARRAY(fields));
    if (!done(&request)) {
        return false;
    }
    mip_call_3dm_data_stream_control_write(mip_defer(&device, &request), MIP_SENSOR_SET, true);
    if (!done(&request)) {
        return false;
    }
    mip_call_base_resume(mip_defer(&device, &request));
    return done(&request);
}

static void command_task(void *unused) {
    (void)unused;
    while (!configure()) {
        vTaskDelay(pdMS_TO_TICKS(100)); /* the device is still starting, or nothing is connected */
    }
    vTaskDelete(NULL);
}

int main(void) {
    static const struct mip_port port = {NULL, port_write, port_now, NULL};
    static const struct mip_hooks hooks = {lock, NULL, NULL};
    static const struct mip_handler handlers[] = {
        {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
    };
    mutex = xSemaphoreCreateRecursiveMutex();
    received = xStreamBufferCreate(1024, 1);
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    device.hooks = &hooks;
    (void)xTaskCreate(receive_task, "receive", 512, NULL, 2, NULL);
    (void)xTaskCreate(command_task, "command", 512, NULL, 1, NULL);
    vTaskStartScheduler();
    return 0;
}
