/* Requests accelerations from a device on a serial port, ten times a second, and prints fifty.
 *
 * Only the first part depends on the system: on a microcontroller, it is replaced by the UART. */
#define _POSIX_C_SOURCE 200809L

#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/sensor.h"
#include "mip/shared.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
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
    mode.c_cc[VMIN] = 0; /* a read returns what there is, and does not wait: port_read does */
    mode.c_cc[VTIME] = 0;
    if (cfsetispeed(&mode, speed) != 0 || cfsetospeed(&mode, speed) != 0 ||
        tcsetattr(port, TCSANOW, &mode) != 0) {
        close(port);
        return -1;
    }
    tcflush(port, TCIOFLUSH); /* discard old data */
    return port;
}

static bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    struct pollfd port = {*(const int *)user, POLLIN, 0};
    const int ready = poll(&port, 1, 100);
    ssize_t got;
    if (ready <= 0) {
        return ready == 0 || errno == EINTR; /* nothing for a while */
    }
    got = read(port.fd, bytes, size);
    if (got < 0) {
        return errno == EINTR || errno == EAGAIN;
    }
    *count = (size_t)got;
    return got > 0 || (port.revents & POLLHUP) == 0; /* the terminal may have been hung up */
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    while (size > 0) {
        ssize_t count = write(*(const int *)user, bytes, size);
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
static uint32_t milliseconds(void *user) {
    struct timespec now;
    (void)user;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_sec * 1000u + (uint32_t)(now.tv_nsec / 1000000);
}

/* ------------------------------------------------------------------------ received data */

struct samples {
    /* Where they come from, their number, and when the last one arrived. */
    const struct mip_device *device;
    unsigned count;
    uint32_t arrived;
};

/* The time stamp in a packet; all zeros, which is not valid, if it has none. */
static struct mip_shared_gps_timestamp time_of(const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_shared_gps_timestamp time = {0};
    struct mip_field field;
    while (mip_walk_next(&walk, &field)) {
        if (mip_shared_gps_timestamp_decode(&time, &field) == MIP_OK) {
            break;
        }
    }
    return time;
}

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    struct samples *samples = (struct samples *)user;
    struct mip_shared_gps_timestamp time;
    struct mip_sensor_scaled_accel accel;
    const float *a = accel.scaled_accel;
    if (mip_sensor_scaled_accel_decode(&accel, field) != MIP_OK) {
        return;
    }
    samples->count++;
    samples->arrived = arrived;
    time = time_of(samples->device->packet);
    if (mip_has(time.valid_flags, MIP_SHARED_GPS_TIMESTAMP_FLAGS_TOW)) {
        printf("%.3f s", time.tow);
    } else {
        printf("no time"); /* before the receiver has a fix */
    }
    printf(": %8.4f %8.4f %8.4f g\n", (double)a[0], (double)a[1], (double)a[2]);
}

static struct samples samples;
static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, &samples},
};

/* ------------------------------------------------------------------------ configuration */

#define RATE 10u /* Hz */
#define SAMPLES 50u

/* Has the command been carried out? If not, says why. */
static bool done(const char *what, struct mip_result result) {
    if (!mip_succeeded(result)) {
        const char *why = mip_result_reason(result);
        fprintf(stderr, "%s: %s%s%s", what, mip_outcome_name(result.outcome),
                *why != '\0' ? ", " : "", why);
        if (result.outcome == MIP_REFUSED) {
            fprintf(stderr, " (code %u)", (unsigned)result.code);
        }
        fputc('\n', stderr);
    }
    return mip_succeeded(result);
}

static bool configure(struct mip_device *device) {
    struct mip_base_get_device_info_response info;
    struct mip_3dm_get_base_rate_response base;
    struct mip_descriptor_rate fields[] = {{MIP_SHARED_GPS_TIMESTAMP_DESCRIPTOR, 0},
                                           {MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 0}};

    /* Without data in between, the answers arrive at once, whatever was set before. */
    if (!done("idle", mip_call_base_set_idle(device)) ||
        !done("device information", mip_call_base_get_device_info(device, &info)) ||
        !done("base rate", mip_call_3dm_get_base_rate(device, MIP_SENSOR_SET, &base))) {
        return false;
    }
    printf("%s, %u Hz\n", info.device_info.model_name, (unsigned)base.rate);
    if (base.rate < RATE) {
        fprintf(stderr, "the device is too slow\n");
        return false;
    }
    fields[0].decimation = fields[1].decimation = (uint16_t)(base.rate / RATE);
    return done("format", mip_call_3dm_message_format_write(device, MIP_SENSOR_SET, 2, fields)) &&
           done("stream", mip_call_3dm_data_stream_control_write(device, MIP_SENSOR_SET, true)) &&
           done("resume", mip_call_base_resume(device));
}

int main(int argc, char **argv) {
    int fd;
    struct mip_port port = {port_read, port_write, milliseconds, &fd};
    struct mip_device device;
    bool good;

    if (argc != 2) {
        fprintf(stderr, "usage: %s PORT\n", argv[0]);
        return 2;
    }
    fd = port_open(argv[1], B115200);
    if (fd < 0) {
        perror(argv[1]);
        return 1;
    }
    mip_device_init(&device, &port, handlers, sizeof(handlers) / sizeof(handlers[0]));
    samples.device = &device;
    good = configure(&device);
    samples.arrived = milliseconds(NULL);
    while (good && samples.count < SAMPLES) {
        if (!mip_device_poll(&device)) {
            fprintf(stderr, "the port is gone\n");
            good = false;
        } else if (milliseconds(NULL) - samples.arrived > 2000) {
            fprintf(stderr, "no data\n");
            good = false;
        }
    }
    close(fd);
    return good ? 0 : 1;
}
