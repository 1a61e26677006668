/* STM32 with the HAL: DMA fills a ring, and an interrupt runs at its half and end, and when the line is idle. In CubeMX:
 * USART2 with its global interrupt, and its RX by DMA, circular. If the memory is cached, exclude the ring. Call
 * run_on_board in main. */
#include "mip/device.h"

#include "main.h"

/* In application.c. */
void application_run(const struct mip_port *port, bool (*set_baud)(void *user, uint32_t baud), void (*rest)(void));

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

static void rest_a_while(void) {
    __WFI();
}

void run_on_board(void);
void run_on_board(void) {
    static const struct mip_port port = {port_read, port_write, port_now, NULL};
    application_run(&port, set_baud, rest_a_while);
}
