/* STM32 with the HAL: DMA fills a ring, and an interrupt runs at its half and end, and when the line is idle. In CubeMX:
 * USART2 with its global interrupt, and its RX by DMA, circular. If the memory is cached, exclude the ring. Call
 * application_run in main. */
#include "mip/connect.h"
#include "mip/sensor.h"

#include "main.h"

/* The application's handler for an acceleration, in g. */
void application_take(const float accel[3]);

extern UART_HandleTypeDef huart2;

static uint8_t ring[1024];
static size_t ring_start;
static volatile uint16_t ring_end;
static volatile bool stopped = true;

void HAL_UARTEx_RxEventCallback(UART_HandleTypeDef *uart, uint16_t size) {
    if (uart == &huart2) {
        ring_end = (uint16_t)(size % sizeof(ring));
    }
}

void HAL_UART_ErrorCallback(UART_HandleTypeDef *uart) {
    if (uart == &huart2) {
        stopped = true; /* an overrun or noise, after which the HAL no longer receives */
    }
}

static bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    (void)user;
    if (stopped) {
        (void)HAL_UART_AbortReceive(&huart2);
        ring_start = ring_end = 0;
        stopped = HAL_UARTEx_ReceiveToIdle_DMA(&huart2, ring, sizeof(ring)) != HAL_OK;
    }
    if (ring_start == ring_end) {
        __WFI(); /* until the next interrupt: that of the clock comes each millisecond */
    }
    while (*count < size && ring_start != ring_end) {
        bytes[(*count)++] = ring[ring_start];
        ring_start = (ring_start + 1) % sizeof(ring);
    }
    return true; /* a UART is never lost */
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    return HAL_UART_Transmit(&huart2, bytes, (uint16_t)size, 1000) == HAL_OK;
}

static uint32_t port_now(void *user) {
    (void)user;
    return HAL_GetTick();
}

static bool set_baud(void *user, uint32_t baud) {
    (void)user;
    stopped = true;
    huart2.Init.BaudRate = baud;
    return HAL_UART_AbortReceive(&huart2) == HAL_OK && HAL_UART_Init(&huart2) == HAL_OK;
}

static void on_accel(void *user, const struct mip_field *field, uint32_t time) {
    struct mip_sensor_scaled_accel accel;
    (void)user, (void)time;
    if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
        application_take(accel.scaled_accel);
    }
}

void application_run(void);
void application_run(void) {
    static const struct mip_port port = {port_read, port_write, port_now, NULL};
    static const struct mip_handler handlers[] = {{&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL}};
    static struct mip_device device;
    struct mip_base_get_device_info_response info;
    struct mip_rate rates[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 100, 0}};
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    while (!mip_succeeded(mip_device_connect(&device, set_baud, &info)) ||
           !mip_succeeded(mip_device_stream(&device, MIP_SENSOR_SET, MIP_ARRAY(rates)))) {
        /* The device is still starting, or nothing is connected. */
    }
    for (;;) {
        (void)mip_device_poll(&device);
    }
}
