/* What examples/stm32.c uses of the STM32 HAL. Interrupts occur only where the program waits. */
#ifndef STM32_H
#define STM32_H

#include "board.h"

typedef enum { HAL_OK,
               HAL_ERROR } HAL_StatusTypeDef;
typedef struct {
    struct {
        uint32_t BaudRate;
    } Init;
} UART_HandleTypeDef;

#define HAL_UART_AbortReceive(uart) HAL_OK
#define HAL_UART_Init(uart) HAL_OK
#define HAL_UART_Transmit(uart, bytes, size, wait) (uart_write(bytes, size) ? HAL_OK : HAL_ERROR)
#define HAL_GetTick board_now

void HAL_UARTEx_RxEventCallback(UART_HandleTypeDef *uart, uint16_t size);
void HAL_UART_ErrorCallback(UART_HandleTypeDef *uart);

UART_HandleTypeDef huart2;
static pthread_mutex_t cpu = PTHREAD_MUTEX_INITIALIZER;
static uint8_t *dma;
static size_t dma_at, dma_size;

static HAL_StatusTypeDef HAL_UARTEx_ReceiveToIdle_DMA(UART_HandleTypeDef *uart, uint8_t *bytes, uint16_t size) {
    (void)uart;
    dma = bytes, dma_at = 0, dma_size = size;
    return HAL_OK;
}

static void __WFI(void) {
    pthread_mutex_unlock(&cpu);
    board_sleep(1);
    pthread_mutex_lock(&cpu);
}

static void uart_arrived(const uint8_t *bytes, size_t size) {
    static unsigned count;
    pthread_mutex_lock(&cpu);
    for (size_t i = 0; i < size; i++) {
        dma[dma_at++] = bytes[i];
        if (dma_at == dma_size || i + 1 == size) {
            HAL_UARTEx_RxEventCallback(&huart2, (uint16_t)dma_at);
        }
        dma_at %= dma_size;
    }
    if (++count == 20) {
        HAL_UART_ErrorCallback(&huart2); /* the line was noisy */
    }
    pthread_mutex_unlock(&cpu);
}

void run_on_board(void);
int main(void) {
    pthread_mutex_lock(&cpu);
    uart_open();
    run_on_board();
}

#endif
