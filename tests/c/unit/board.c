/* The board of examples/bare_metal.c, and a device at its UART. Bytes arrive by interrupt, eleven per
 * millisecond, even while the program sends. The device starts late, and restarts once. */
#include "check.h"

#include "mip/3dm.h"
#include "mip/base.h"
#include "mip/sensor.h"

uint8_t uart_receive(void);
void uart_send(uint8_t byte);
void uart_interrupt(void);
uint32_t board_time(void);
void board_sleep(void);
void application_take(const float accel[3]);

static uint32_t now = UINT32_MAX - 3000; /* wraps around on the way */
static uint8_t data_register;
static uint8_t line[4096];
static size_t line_start, line_end;

/* ------------------------------------------------------------------------ the device */

static struct mip_parser parser;
static unsigned commands, samples, sent, restarts;
static bool format, stream, running;

static void transmit(struct mip_builder *b) {
    const struct mip_packet p = mip_builder_finish(b);
    CHECK(line_end + p.size <= sizeof(line));
    memcpy(line + line_end, p.bytes, p.size);
    line_end += p.size;
}

static void obey(const struct mip_field *command, struct mip_builder *answer) {
    struct mip_3dm_message_format formats;
    const uint8_t good[] = {command->descriptor, 0};
    const bool asked = mip_field_key(command) != MIP_BASE_PING; /* else it is part of a barrier */
    commands += asked;
    if (commands + !asked < 3) {
        return; /* still starting */
    }
    switch (mip_field_key(command)) {
    case MIP_BASE_SET_IDLE:
        running = false;
        break;
    case MIP_3DM_MESSAGE_FORMAT:
        CHECK(mip_3dm_message_format_decode(&formats, command) == MIP_OK);
        format = formats.num_descriptors == 1 && formats.descriptors[0].decimation == 10;
        break;
    case MIP_3DM_DATA_STREAM_CONTROL:
        stream = true;
        break;
    case MIP_BASE_RESUME:
        running = true;
        break;
    case MIP_BASE_PING:
        break;
    default:
        CHECK(false);
    }
    CHECK(mip_builder_add(answer, 0xF1, good, sizeof(good)) == MIP_OK);
}

static void measure(void) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder b;
    const struct mip_sensor_scaled_accel accel = {{1.0F, 2.0F, (float)sent}};
    if (format && stream && running && now % 10 == 0) {
        sent++;
        mip_builder_start(&b, bytes, sizeof(bytes), MIP_SENSOR_SET);
        CHECK(mip_sensor_scaled_accel_encode(&accel, &b) == MIP_OK);
        transmit(&b);
    }
    if (sent == 300 && restarts == 0) { /* a power cycle: the settings are lost */
        restarts++;
        format = stream = false;
    }
}

/* ------------------------------------------------------------------------ the board */

static void a_byte_comes(void) {
    if (line_start < line_end) {
        data_register = line[line_start++];
        uart_interrupt();
    }
    if (line_start == line_end) {
        line_start = line_end = 0;
    }
}

uint8_t uart_receive(void) {
    return data_register;
}

void uart_send(uint8_t byte) {
    const uint8_t *data = &byte;
    size_t size = 1;
    struct mip_packet packet;
    while (mip_parser_next(&parser, &data, &size, &packet)) {
        struct mip_walk walk = mip_walk_packet(&packet);
        struct mip_field field;
        uint8_t bytes[MIP_MAX_PACKET];
        struct mip_builder answer;
        CHECK(mip_builder_start(&answer, bytes, sizeof(bytes), packet.descriptor_set) == MIP_OK);
        while (mip_walk_next(&walk, &field)) {
            obey(&field, &answer);
        }
        if (answer.length > MIP_HEADER_SIZE) {
            transmit(&answer);
        }
    }
    a_byte_comes();
}

uint32_t board_time(void) {
    return now;
}

void board_sleep(void) {
    static unsigned slept;
    CHECK(++slept < 100000); /* the program is done before that */
    now++;
    measure();
    for (int i = 0; i < 11; i++) {
        a_byte_comes();
    }
}

void application_take(const float accel[3]) {
    CHECK(accel[0] > 0.99F && accel[0] < 1.01F && accel[1] > 1.99F && accel[1] < 2.01F);
    CHECK((unsigned)(accel[2] + 0.5F) == samples); /* none is missing */
    if (++samples == 600) {
        CHECK(restarts == 1 && commands == 2 + 4 + 4 && parser.skipped == 0);
        exit(0);
    }
}
