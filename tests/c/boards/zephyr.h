/* What examples/zephyr.c uses of Zephyr. */
#ifndef ZEPHYR_H
#define ZEPHYR_H

#include "board.h"

struct device;
enum uart_event_type { UART_TX_DONE,
                       UART_TX_ABORTED,
                       UART_RX_RDY,
                       UART_RX_BUF_REQUEST,
                       UART_RX_BUF_RELEASED,
                       UART_RX_DISABLED,
                       UART_RX_STOPPED };
struct uart_event_rx {
    uint8_t *buf;
    size_t offset, len;
};
struct uart_event {
    enum uart_event_type type;
    union {
        struct uart_event_rx rx;
    } data;
};
typedef void (*uart_callback_t)(const struct device *dev, struct uart_event *event, void *user);

#define DT_ALIAS(name) NULL
#define DEVICE_DT_GET(node) node
#define RING_BUF_DECLARE(name, bytes) static struct fifo name = FIFO
#define K_SEM_DEFINE(name, initial, limit) static struct fifo name = FIFO
#define K_MSEC(milliseconds) (milliseconds)
#define SYS_FOREVER_US (-1)
#define ring_buf_put fifo_put
#define ring_buf_get(from, bytes, size) ((uint32_t)fifo_get(from, bytes, size, 0))
#define ring_buf_is_empty(of) false
#define k_sem_give(semaphore) ((void)fifo_put(semaphore, "", 1))
#define k_sem_take(semaphore, wait) (fifo_get(semaphore, (char[1]){0}, 1, wait) == 1 ? 0 : -1)
#define k_uptime_get_32 board_now
#define k_msleep board_sleep

static uart_callback_t uart_callback;
static struct uart_event_rx dma, dma_next;

static void uart_event(enum uart_event_type type, struct uart_event_rx rx) {
    struct uart_event event = {type, {rx}};
    uart_callback(NULL, &event, NULL);
}

static int uart_callback_set(const struct device *dev, uart_callback_t callback, void *user) {
    (void)dev, (void)user;
    uart_callback = callback;
    return 0;
}

static int uart_rx_buf_rsp(const struct device *dev, uint8_t *buffer, size_t size) {
    (void)dev;
    dma_next = (struct uart_event_rx){buffer, 0, size};
    return 0;
}

static int uart_rx_enable(const struct device *dev, uint8_t *buffer, size_t size, int32_t timeout) {
    (void)timeout;
    (void)uart_rx_buf_rsp(dev, buffer, size);
    uart_open();
    return 0;
}

static int uart_tx(const struct device *dev, const uint8_t *bytes, size_t size, int32_t timeout) {
    (void)dev, (void)timeout;
    if (!uart_write(bytes, size)) {
        return -1;
    }
    uart_event(UART_TX_DONE, (struct uart_event_rx){NULL, 0, 0});
    return 0;
}

static void uart_arrived(const uint8_t *bytes, size_t size) {
    for (size_t i = 0; i < size; i++) {
        if (dma.offset == dma.len) {
            dma = dma_next;
            uart_event(UART_RX_BUF_REQUEST, dma);
        }
        dma.buf[dma.offset] = bytes[i];
        uart_event(UART_RX_RDY, (struct uart_event_rx){dma.buf, dma.offset++, 1});
    }
}

#endif
