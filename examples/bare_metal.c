/* A microcontroller reads accelerations from a device at a UART, without an operating system.
 *
 * An interrupt stores each received byte in a ring buffer; the main loop reads them. */
#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/sensor_inline.h"

/* ------------------------------------------------------------------------ provided by the board */

/* The data register of the UART: the received byte, or the byte to send, when there is room. */
uint8_t uart_receive(void);
void uart_send(uint8_t byte);
/* Milliseconds since the start, counted by a timer interrupt. */
uint32_t board_time(void);
/* Sleeps until the next interrupt from the UART or the timer. */
void board_sleep(void);
/* The application's handler for an acceleration, in g. */
void application_take(const float accel[3]);

/* ------------------------------------------------------------------------ the port */

/* One-byte indices wrap around like the ring, and are read atomically. */
static volatile uint8_t ring[256];
static volatile uint8_t ring_end, ring_start;

/* Call this when a byte has been received. */
void uart_interrupt(void);
void uart_interrupt(void) {
    const uint8_t byte = uart_receive();
    const uint8_t next = (uint8_t)(ring_end + 1);
    if (next != ring_start) { /* otherwise the byte is lost, which the checksum detects */
        ring[ring_end] = byte;
        ring_end = next;
    }
}

static bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    (void)user;
    if (ring_start == ring_end) {
        board_sleep(); /* a byte that arrives right now waits for the timer, 1 ms */
    }
    while (*count < size && ring_start != ring_end) {
        bytes[(*count)++] = ring[ring_start];
        ring_start = (uint8_t)(ring_start + 1);
    }
    return true; /* a UART is never lost */
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    for (size_t i = 0; i < size; i++) {
        uart_send(bytes[i]);
    }
    return true;
}

static uint32_t port_now(void *user) {
    (void)user;
    return board_time();
}

static const struct mip_port port = {port_read, port_write, port_now, NULL};

/* ------------------------------------------------------------------------ the device */

static uint32_t last; /* when data last arrived */

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_sensor_scaled_accel accel;
    (void)user;
    if (mip_sensor_scaled_accel_decode_inline(&accel, field) == MIP_OK) {
        last = arrived;
        application_take(accel.scaled_accel);
    }
}

static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
};

/* The device sends accelerations at a tenth of its base rate. */
static bool configure(struct mip_device *device) {
    static const struct mip_descriptor_rate fields[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 10}};
    return mip_succeeded(mip_call_base_set_idle(device)) &&
           mip_succeeded(mip_call_3dm_message_format_write(device, MIP_SENSOR_SET, MIP_ARRAY(fields))) &&
           mip_succeeded(mip_call_3dm_data_stream_control_write(device, MIP_SENSOR_SET, true)) &&
           mip_succeeded(mip_call_base_resume(device));
}

int main(void) {
    static struct mip_device device;
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    for (;;) {
        while (!configure(&device)) {
            /* The device is still starting, or nothing is connected. */
        }
        last = board_time();
        while (board_time() - last < 1000) { /* otherwise the device has restarted */
            mip_device_poll(&device);
            /* The program does its other work here. */
        }
    }
}
