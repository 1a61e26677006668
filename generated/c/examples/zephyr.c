/* Zephyr: the asynchronous UART, whose DMA fills two buffers in turn. In prj.conf: CONFIG_MIP=y,
 * CONFIG_SERIAL=y, CONFIG_UART_ASYNC_API=y, CONFIG_RING_BUFFER=y; in the devicetree: the alias
 * mip-uart. */
#include "mip/device.h"

#include <zephyr/device.h>
#include <zephyr/drivers/uart.h>
#include <zephyr/kernel.h>
#include <zephyr/sys/ring_buffer.h>

/* In application.c. */
void application_run(const struct mip_port *port, bool (*set_baud)(void *user, uint32_t baud),
                     void (*rest)(void));

/* Microseconds without a byte after which a piece is complete. */
#define IDLE 1000

static const struct device *const uart = DEVICE_DT_GET(DT_ALIAS(mip_uart));
RING_BUF_DECLARE(received, 1024);
K_SEM_DEFINE(arrived, 0, 1);
K_SEM_DEFINE(sent, 0, 1);

static void on_uart(const struct device *dev, struct uart_event *event, void *user) {
    static uint8_t buffers[2][64];
    static size_t next;
    (void)user;
    switch (event->type) {
    case UART_RX_RDY: /* what does not fit is lost, which the checksum detects */
        (void)ring_buf_put(&received, event->data.rx.buf + event->data.rx.offset,
                           (uint32_t)event->data.rx.len);
        k_sem_give(&arrived);
        break;
    case UART_RX_BUF_REQUEST:
        (void)uart_rx_buf_rsp(dev, buffers[next++ % 2], sizeof(buffers[0]));
        break;
    case UART_RX_DISABLED: /* at the start, and after an error of the line */
        (void)uart_rx_enable(dev, buffers[next++ % 2], sizeof(buffers[0]), IDLE);
        break;
    case UART_TX_DONE:
    case UART_TX_ABORTED:
        k_sem_give(&sent);
        break;
    default:
        break;
    }
}

static bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    (void)user;
    if (ring_buf_is_empty(&received)) {
        (void)k_sem_take(&arrived, K_MSEC(10));
    }
    *count = ring_buf_get(&received, bytes, (uint32_t)size);
    return true; /* a UART is never lost */
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    return uart_tx(uart, bytes, size, SYS_FOREVER_US) == 0 && k_sem_take(&sent, K_MSEC(1000)) == 0;
}

static uint32_t port_now(void *user) {
    (void)user;
    return k_uptime_get_32();
}

static void rest_a_while(void) {
    k_msleep(100);
}

int main(void) {
    static const struct mip_port port = {port_read, port_write, port_now, NULL};
    struct uart_event start = {.type = UART_RX_DISABLED};
    (void)uart_callback_set(uart, on_uart, NULL);
    on_uart(uart, &start, NULL);
    application_run(&port, NULL, rest_a_while);
}
