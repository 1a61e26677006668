/* ESP-IDF: the UART driver with its event queue. */
#include "mip/device.h"

#include "driver/uart.h"
#include "esp_timer.h"
#include "freertos/FreeRTOS.h"
#include "freertos/queue.h"
#include "freertos/task.h"

/* In application.c. */
void application_run(const struct mip_port *port, bool (*set_baud)(void *user, uint32_t baud), void (*rest)(void));

enum { PORT = UART_NUM_1, TX_PIN = 17, RX_PIN = 18 };

static QueueHandle_t events;

static bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    uart_event_t event;
    size_t waiting = 0;
    (void)user;
    (void)uart_get_buffered_data_len(PORT, &waiting);
    if (waiting == 0 && xQueueReceive(events, &event, pdMS_TO_TICKS(10)) == pdTRUE &&
        (event.type == UART_FIFO_OVF || event.type == UART_BUFFER_FULL)) {
        (void)uart_flush_input(PORT); /* bytes are lost, which the checksum detects */
        (void)xQueueReset(events);
    }
    const int read = uart_read_bytes(PORT, bytes, (uint32_t)size, 0);
    *count = read > 0 ? (size_t)read : 0;
    return true; /* a UART is never lost */
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    return uart_write_bytes(PORT, bytes, size) == (int)size;
}

static uint32_t port_now(void *user) {
    (void)user;
    return (uint32_t)(esp_timer_get_time() / 1000);
}

static bool set_baud(void *user, uint32_t baud) {
    (void)user;
    return uart_set_baudrate(PORT, baud) == ESP_OK && uart_flush_input(PORT) == ESP_OK;
}

static void rest_a_while(void) {
    vTaskDelay(pdMS_TO_TICKS(100));
}

void app_main(void);
void app_main(void) {
    static const struct mip_port port = {port_read, port_write, port_now, NULL};
    const uart_config_t line = {.baud_rate = 115200, .data_bits = UART_DATA_8_BITS, .stop_bits = UART_STOP_BITS_1};
    ESP_ERROR_CHECK(uart_driver_install(PORT, 1024, 0, 16, &events, 0));
    ESP_ERROR_CHECK(uart_param_config(PORT, &line));
    ESP_ERROR_CHECK(uart_set_pin(PORT, TX_PIN, RX_PIN, UART_PIN_NO_CHANGE, UART_PIN_NO_CHANGE));
    application_run(&port, set_baud, rest_a_while);
}
