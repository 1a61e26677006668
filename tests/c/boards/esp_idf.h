/* What examples/esp_idf.c uses of ESP-IDF. */
#ifndef ESP_IDF_H
#define ESP_IDF_H

#include "board.h"

typedef enum { UART_DATA,
               UART_FIFO_OVF,
               UART_BUFFER_FULL } uart_event_type_t;
typedef struct {
    uart_event_type_t type;
} uart_event_t;
typedef struct {
    int baud_rate, data_bits, stop_bits;
} uart_config_t;
typedef struct fifo *QueueHandle_t;

enum { UART_NUM_1 = 1,
       UART_DATA_8_BITS = 3,
       UART_STOP_BITS_1 = 1,
       UART_PIN_NO_CHANGE = -1,
       ESP_OK = 0,
       pdTRUE = 1 };

#define pdMS_TO_TICKS(milliseconds) ((uint32_t)(milliseconds))
#define vTaskDelay board_sleep
#define esp_timer_get_time() ((int64_t)board_now() * 1000)
#define xQueueReceive(queue, event, wait) (fifo_get(queue, event, sizeof(*(event)), wait) > 0)
#define xQueueReset(queue) fifo_get(queue, (char[sizeof((queue)->bytes)]){0}, sizeof((queue)->bytes), 0)
#define ESP_ERROR_CHECK(done) ((done) == ESP_OK ? (void)0 : abort())
#define uart_param_config(port, line) ((line)->baud_rate == 115200 ? ESP_OK : -1)
#define uart_set_pin(port, tx, rx, rts, cts) ESP_OK
#define uart_set_baudrate(port, baud) ((baud) > 0 ? ESP_OK : -1)
#define uart_write_bytes(port, bytes, size) (uart_write(bytes, size) ? (int)(size) : -1)
#define uart_read_bytes(port, bytes, size, wait) ((int)fifo_get(&uart_bytes, bytes, size, wait))
#define uart_flush_input(port) (xQueueReset(&uart_bytes) > 1024)

static struct fifo uart_bytes = FIFO, uart_events = FIFO;

static int uart_get_buffered_data_len(int port, size_t *size) {
    (void)port;
    pthread_mutex_lock(&uart_bytes.mutex);
    *size = uart_bytes.size;
    pthread_mutex_unlock(&uart_bytes.mutex);
    return ESP_OK;
}

static int uart_driver_install(int port, int rx, int tx, int count, QueueHandle_t *queue, int flags) {
    (void)port, (void)rx, (void)tx, (void)count, (void)flags;
    *queue = &uart_events;
    uart_open();
    return ESP_OK;
}

static void uart_arrived(const uint8_t *bytes, size_t size) {
    const uart_event_t event = {fifo_put(&uart_bytes, bytes, size) == size ? UART_DATA : UART_BUFFER_FULL};
    (void)fifo_put(&uart_events, &event, sizeof(event));
}

void app_main(void);
int main(void) {
    app_main();
}

#endif
