/* Asks a device on a serial port for accelerations, ten times a second, and prints fifty of them.
 *
 * Only the first part depends on the system: on a microcontroller, it is replaced by the UART. */
#define _POSIX_C_SOURCE 200809L

#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/sensor.h"
#include "mip/shared.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

/* ------------------------------------------------------------------------ the port, by POSIX */

/* The port in raw mode, 8N1; -1 if it cannot be opened. */
static int port_open(const char *path, speed_t speed) {
    struct termios mode;
    int port = open(path, O_RDWR | O_NOCTTY);
    if (port < 0) {
        return -1;
    }
    if (tcgetattr(port, &mode) != 0) {
        close(port);
        return -1;
    }
    mode.c_iflag = IGNBRK; /* no flow control, no translation of line ends */
    mode.c_oflag = 0;
    mode.c_lflag = 0;
    mode.c_cflag = CS8 | CREAD | CLOCAL;
    mode.c_cc[VMIN] = 0;  /* a read returns what has come, */
    mode.c_cc[VTIME] = 1; /* or nothing after 0.1 s */
    if (cfsetispeed(&mode, speed) != 0 || cfsetospeed(&mode, speed) != 0 ||
        tcsetattr(port, TCSANOW, &mode) != 0) {
        close(port);
        return -1;
    }
    tcflush(port, TCIOFLUSH); /* what came before is of no use */
    return port;
}

/* Up to `capacity` bytes that have come; 0 after a while without any, -1 if the port is lost. */
static int port_read(int port, uint8_t *bytes, size_t capacity) {
    ssize_t count = read(port, bytes, capacity);
    if (count < 0) {
        return errno == EINTR || errno == EAGAIN ? 0 : -1;
    }
    return (int)count;
}

static bool port_write(int port, const uint8_t *bytes, size_t size) {
    while (size > 0) {
        ssize_t count = write(port, bytes, size);
        if (count < 0 && errno != EINTR) {
            return false;
        }
        if (count > 0) {
            bytes += count;
            size -= (size_t)count;
        }
    }
    return true;
}

/* A clock that is never set; it may wrap around. */
static uint32_t milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_sec * 1000u + (uint32_t)(now.tv_nsec / 1000000);
}

/* ------------------------------------------------------------------------ the device */

struct device {
    int port;
    struct mip_parser parser;
    struct mip_client client;
    /* The latest time stamp, and how many accelerations have come. */
    struct mip_shared_gps_timestamp time;
    unsigned count;
    /* When the latest packet of data came. */
    uint32_t heard;
};

/* A field of data. */
static void on_data(struct device *device, const struct mip_field *field) {
    if (field->descriptor_set != MIP_SENSOR_SET) {
        return;
    }
    device->heard = milliseconds();
    if (field->descriptor == MIP_SHARED_GPS_TIMESTAMP_DESCRIPTOR) {
        if (mip_shared_gps_timestamp_decode(&device->time, field) != MIP_OK) {
            device->time.valid_flags = 0;
        }
    } else if (field->descriptor == MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR) {
        struct mip_sensor_scaled_accel accel;
        if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
            const float *a = accel.scaled_accel;
            device->count++;
            if (mip_has(device->time.valid_flags, MIP_SHARED_GPS_TIMESTAMP_FLAGS_TOW)) {
                printf("%.3f s", device->time.tow);
            } else {
                printf("no time"); /* before the receiver has a fix */
            }
            printf(": %8.4f %8.4f %8.4f g\n", (double)a[0], (double)a[1], (double)a[2]);
        }
    }
}

/* Takes what has come, and lets time pass for waiting commands; false if the port is lost. */
static bool update(struct device *device) {
    uint8_t chunk[256];
    const uint8_t *data = chunk;
    struct mip_packet packet;
    int count = port_read(device->port, chunk, sizeof(chunk));
    size_t size = count > 0 ? (size_t)count : 0;

    while (mip_parser_next(&device->parser, &data, &size, &packet) ||
           mip_client_poll(&device->client, &device->parser, milliseconds(), &packet)) {
        struct mip_walk walk = mip_walk_packet(&packet);
        struct mip_request *answered;
        struct mip_field field;
        while (mip_client_next(&device->client, &walk, &answered, &field)) {
            if (answered == NULL) { /* data go on while a command waits */
                on_data(device, &field);
            }
        }
    }
    return count >= 0;
}

/* Sends one command and waits for its answer; the response, if it has one, is stored. */
static bool command(struct device *device, const char *name, const struct mip_command *command,
                    const void *value, const struct mip_codec *response_codec, void *response) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    struct mip_request request;
    struct mip_packet packet;

    mip_builder_start(&builder, buffer, sizeof(buffer), command->codec->descriptor_set);
    if (mip_client_add(&device->client, &request, &builder, command, value, milliseconds()) !=
        MIP_OK) {
        fprintf(stderr, "%s: the values do not fit\n", name);
        return false;
    }
    if (response_codec != NULL) {
        mip_client_expect(&request, response_codec, response);
    }
    packet = mip_builder_finish(&builder);
    if (!port_write(device->port, packet.bytes, packet.size)) {
        mip_client_cancel(&device->client, &request); /* it must not outlive this function */
        fprintf(stderr, "%s: cannot be sent\n", name);
        return false;
    }
    while (request.state == MIP_REQUEST_WAITING) {
        if (!update(device)) {
            mip_client_cancel(&device->client, &request);
        }
    }
    switch (request.state) {
    case MIP_REQUEST_ACKNOWLEDGED:
        return true;
    case MIP_REQUEST_REFUSED:
        fprintf(stderr, "%s: refused with code %u\n", name, (unsigned)request.code);
        return false;
    case MIP_REQUEST_TIMED_OUT:
        fprintf(stderr, "%s: no answer\n", name);
        return false;
    default:
        fprintf(stderr, "%s: no usable answer\n", name);
        return false;
    }
}

/* ------------------------------------------------------------------------ what we want from it */

#define RATE 10u /* Hz */
#define SAMPLES 50u

static bool configure(struct device *device) {
    struct mip_base_get_device_info_response info;
    struct mip_3dm_get_base_rate ask;
    struct mip_3dm_get_base_rate_response base;
    struct mip_descriptor_rate fields[2];
    struct mip_3dm_message_format format;
    struct mip_3dm_data_stream_control stream;

    mip_3dm_get_base_rate_make(&ask, MIP_SENSOR_SET);
    /* Without data in between, the answers come at once, whatever was set before. */
    if (!command(device, "idle", &mip_base_set_idle_command, NULL, NULL, NULL) ||
        !command(device, "device information", &mip_base_get_device_info_command, NULL,
                 &mip_base_get_device_info_response_codec, &info) ||
        !command(device, "base rate", &mip_3dm_get_base_rate_command, &ask,
                 &mip_3dm_get_base_rate_response_codec, &base)) {
        return false;
    }
    printf("%s, %u Hz\n", info.device_info.model_name, (unsigned)base.rate);
    if (base.rate < RATE) {
        fprintf(stderr, "the device is too slow\n");
        return false;
    }
    fields[0].descriptor = MIP_SHARED_GPS_TIMESTAMP_DESCRIPTOR;
    fields[1].descriptor = MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR;
    fields[0].decimation = fields[1].decimation = (uint16_t)(base.rate / RATE);
    mip_3dm_message_format_write(&format, MIP_SENSOR_SET, 2, fields);
    mip_3dm_data_stream_control_write(&stream, MIP_SENSOR_SET, true);
    return command(device, "message format", &mip_3dm_message_format_command, &format, NULL,
                   NULL) &&
           command(device, "stream", &mip_3dm_data_stream_control_command, &stream, NULL, NULL) &&
           command(device, "resume", &mip_base_resume_command, NULL, NULL, NULL);
}

int main(int argc, char **argv) {
    static struct device device; /* zeroed: no time yet */
    bool good;

    if (argc != 2) {
        fprintf(stderr, "usage: %s PORT\n", argv[0]);
        return 2;
    }
    device.port = port_open(argv[1], B115200);
    if (device.port < 0) {
        perror(argv[1]);
        return 1;
    }
    mip_parser_init(&device.parser);
    mip_client_init(&device.client);

    good = configure(&device);
    device.heard = milliseconds();
    while (good && device.count < SAMPLES) {
        good = update(&device);
        if (milliseconds() - device.heard > 2000) {
            fprintf(stderr, "no data\n");
            good = false;
        }
    }
    close(device.port);
    return good ? 0 : 1;
}
