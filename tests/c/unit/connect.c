/* The first minutes with a device, at a scripted port; with the library of the real specification. */
#include "check.h"

#include "mip/connect.h"
#include "mip/extra/profiles.h"

/* A device: its baud rate, and its faults. */
struct fake {
    uint32_t baud, rate, clock, base_rate;
    /* Replies that it loses, and to which command (0: all); a command that it NACKs; data that it sends. */
    unsigned lose, lose_of, refuse, data;
    /* Unless 0, the descriptor with which a message format must begin. */
    uint8_t begin;
    /* True if it has the older commands for some sets, in place of the others. */
    bool older;
    /* The fastest rate of the port. Reads and writes until the port is gone. */
    uint32_t fastest;
    unsigned reads_left, writes_left;
    /* What it was sent: commands, rates tried, and the last format. */
    unsigned commands[300], count, rates, barriers;
    uint32_t tried[20];
    uint8_t format[MIP_MAX_PAYLOAD];
    size_t format_size;
    /* The stream that was switched on. */
    uint8_t stream;
    uint8_t out[2 * MIP_MAX_PACKET];
    size_t out_size;
};

static struct fake fake;
static struct mip_device device;
static struct mip_base_get_device_info_response info;

static bool fake_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    struct fake *f = (struct fake *)user;
    f->clock += 10;
    if (f->reads_left == 0 || --f->reads_left == 0) {
        return false;
    }
    if (f->data > 0 && f->out_size == 0) {
        static const uint8_t data[] = {0x75, 0x65, 0x80, 0x00, 0x5A, 0x03};
        f->data--;
        memcpy(f->out, data, sizeof(data));
        f->out_size = sizeof(data);
    }
    *count = f->out_size < size ? f->out_size : size;
    for (size_t i = 0; i < *count; i++) { /* at a wrong rate, noise */
        bytes[i] = f->rate == f->baud ? f->out[i] : (uint8_t)(f->out[i] ^ 0x5A);
    }
    f->out_size -= *count;
    memmove(f->out, f->out + *count, f->out_size);
    return true;
}

static bool fake_write(void *user, const uint8_t *bytes, size_t size) {
    struct fake *f = (struct fake *)user;
    const unsigned command = bytes[2] * 0x100u + bytes[5];
    const bool known = f->older ? command != 0x0C0E && command != 0x0C0F && command != 0x0C07
                                : command < 0x0C06 || command > 0x0C0B;
    const bool misses = f->begin != 0 && ((command == 0x0C0F && bytes[9] != f->begin) ||
                                          (command == 0x0C08 && bytes[8] != f->begin));
    const uint8_t acknowledge[2] = {bytes[5], (uint8_t)(command == f->refuse || !known || misses)};
    struct mip_builder answer;
    uint8_t data[82];
    if (f->writes_left == 0 || --f->writes_left == 0) {
        return false;
    }
    CHECK(f->count < 300 && size >= 8);
    f->barriers += command == 0x0101 && bytes[3] > 2;
    if (command == 0x0101 && bytes[3] > 2 && f->rate == f->baud) { /* a barrier */
        CHECK(mip_builder_start(&answer, f->out + f->out_size, MIP_MAX_PACKET, 0x01) == MIP_OK);
        for (unsigned left = bytes[3]; left > 0; left -= 2) {
            CHECK(mip_builder_add(&answer, 0xF1, "\x01\0", 2) == MIP_OK);
        }
        f->out_size += mip_builder_finish(&answer).size;
        return true;
    }
    if (command == 0x0101 && bytes[3] > 2) {
        return true;
    }
    f->commands[f->count++] = command;
    if (f->rate != f->baud) {
        memset(f->out, 0x75, 40); /* noise */
        f->out_size = 40;
        return true;
    }
    if (f->lose > 0 && !misses && (f->lose_of == 0 || f->lose_of == command)) {
        f->lose--;
        return true;
    }
    CHECK(mip_builder_start(&answer, f->out + f->out_size, MIP_MAX_PACKET, bytes[2]) == MIP_OK);
    CHECK(mip_builder_add(&answer, 0xF1, acknowledge, 2) == MIP_OK);
    memset(data, ' ', sizeof(data));
    if (acknowledge[1] == 0 && command == 0x0103) {
        memcpy(data, "\x04\xB2", 2);
        memcpy(data + 2, "3DM-CV7-GNSS/INS", 16);
        memcpy(data + 18, "6292-9999", 9);
        CHECK(mip_builder_add(&answer, 0x81, data, 82) == MIP_OK);
    }
    if (acknowledge[1] == 0 && command == 0x0C0E) {
        data[0] = bytes[6];
        mip_put_16(data + 1, (uint16_t)f->base_rate);
        CHECK(mip_builder_add(&answer, 0x8E, data, 3) == MIP_OK);
    }
    if (acknowledge[1] == 0 && (command == 0x0C06 || command == 0x0C0B)) {
        mip_put_16(data, (uint16_t)f->base_rate);
        CHECK(mip_builder_add(&answer, command == 0x0C06 ? 0x83 : 0x8A, data, 2) == MIP_OK);
    }
    if (command == 0x0C0F || command == 0x0C08 || command == 0x0C0A) {
        f->format_size = bytes[4] - 2u;
        memcpy(f->format, bytes + 6, f->format_size);
    }
    if (command == 0x0C11) {
        f->stream = bytes[7];
    }
    f->out_size += mip_builder_finish(&answer).size;
    return true;
}

static uint32_t fake_now(void *user) {
    return ((struct fake *)user)->clock;
}

static bool fake_set_baud(void *user, uint32_t baud) {
    struct fake *f = (struct fake *)user;
    f->tried[f->rates++] = baud;
    if (baud > f->fastest) {
        return false;
    }
    f->rate = baud;
    f->out_size = 0;
    return true;
}

static const struct mip_port port = {fake_read, fake_write, fake_now, &fake};

/* A new device at a port of 115200 Bd. */
static void start(uint32_t baud) {
    memset(&fake, 0, sizeof(fake));
    fake.baud = baud;
    fake.rate = 115200;
    fake.base_rate = 1000;
    fake.fastest = 10000000;
    fake.reads_left = fake.writes_left = 10000;
    mip_device_init(&device, &port, 0, NULL);
}

static enum mip_outcome found(bool (*set_baud)(void *user, uint32_t baud)) {
    const struct mip_result result = mip_device_connect(&device, set_baud, &info);
    CHECK(device.client.timeout == MIP_DEFAULT_TIMEOUT && device.observer == NULL);
    return result.outcome;
}

static void connects(void) {
    start(115200);
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.rates == 1 && fake.tried[0] == 115200);
    CHECK(fake.count == 3 && fake.commands[0] == 0x0101 && fake.commands[1] == 0x0102 && fake.commands[2] == 0x0103);
    CHECK(strcmp(info.device_info.model_name, "3DM-CV7-GNSS/INS") == 0);
    CHECK(mip_device_profile(&info) != NULL);
    CHECK(strcmp(mip_device_profile(&info)->id, "3dm-cv7-gnss-ins") == 0);

    /* The model number comes first; a serial number identifies a model, too; otherwise the device is unknown. */
    memset(info.device_info.model_number, ' ', sizeof(info.device_info.model_number));
    CHECK(mip_device_profile(&info) == NULL);
    memcpy(info.device_info.serial_number, "  6292.1", 9);
    CHECK(mip_device_profile(&info) != NULL);

    /* At another rate: the usual one first, then from the fastest down, without those that the port does not have. */
    start(9600);
    fake.fastest = 230400;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.rate == 9600);
    CHECK(fake.tried[0] == 115200 && fake.tried[1] > fake.fastest && fake.tried[fake.rates - 1] == 9600);
    for (unsigned i = 2; i < fake.rates; i++) {
        CHECK(fake.tried[i] < fake.tried[i - 1]);
    }

    /* The rate cannot be set. */
    start(115200);
    CHECK(found(NULL) == MIP_ACKNOWLEDGED);
    start(115200);
    fake.fastest = 0;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.rates > 3);
    start(9600);
    CHECK(found(NULL) == MIP_TIMED_OUT);
}

static void patient(void) {
    /* The first answers of each command are lost. */
    start(115200);
    fake.lose = 1;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.rates == 1);
    start(115200);
    fake.lose = 2;
    fake.lose_of = 0x0102;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.count == 5);
    start(115200);
    fake.lose = 3;
    fake.lose_of = 0x0102;
    CHECK(found(fake_set_baud) == MIP_TIMED_OUT && fake.count == 4);

    /* A device that does not answer a ping, but sends data; one that NACKs it. */
    start(57600);
    fake.lose = 1000;
    fake.lose_of = 0x0101;
    fake.data = 1000;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.rate == 57600);
    start(115200);
    fake.refuse = 0x0101;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED);
    start(115200);
    fake.refuse = 0x0103;
    CHECK(found(fake_set_baud) == MIP_REFUSED);

    /* No barrier precedes a ping, even the next time; one precedes the command after lost replies. */
    start(1);
    for (unsigned i = 1; i <= 2; i++) {
        CHECK(found(fake_set_baud) == MIP_TIMED_OUT && fake.count == 2 * fake.rates && fake.barriers == 0);
        fake.rates = fake.count = 0;
    }
    fake.baud = 9600;
    CHECK(found(fake_set_baud) == MIP_ACKNOWLEDGED && fake.rate == 9600 && fake.barriers == 1);
    CHECK(device.client.missed == 0 && device.client.behind == 0);
    CHECK(found(NULL) == MIP_ACKNOWLEDGED && fake.barriers == 1);

    /* A silent port, a port that cannot write, and one that is gone: no further rate is tried. */
    start(1);
    CHECK(found(fake_set_baud) == MIP_TIMED_OUT && fake.rates > 3 && fake.count == 2 * fake.rates);
    start(1);
    fake.writes_left = 1;
    CHECK(found(fake_set_baud) == MIP_NOT_SENT && fake.rates == 1);
    start(1);
    fake.reads_left = 5;
    CHECK(found(fake_set_baud) == MIP_CLOSED && fake.rates == 1);
    for (unsigned reads = 1; reads < 6; reads++) {
        start(115200);
        fake.reads_left = reads;
        CHECK(found(fake_set_baud) == (reads > 3 ? MIP_ACKNOWLEDGED : MIP_CLOSED));
    }
}

/* Does the device have this rate? If not, which one is nearest? */
static bool has(uint32_t base, float wanted, unsigned decimation, float nearest) {
    struct mip_rate rate = {0x04, 0, 0};
    start(115200);
    fake.base_rate = base;
    rate.wanted = wanted;
    const struct mip_result result = mip_device_stream(&device, 0x80, 1, &rate);
    CHECK(memcmp(&rate.nearest, &nearest, sizeof(nearest)) == 0 && rate.descriptor == 0x04);
    CHECK(mip_rate_fits(&rate) == (result.outcome != MIP_NO_SUCH_RATE));
    if (result.outcome == MIP_NO_SUCH_RATE) {
        CHECK(fake.count == 1); /* nothing was changed */
        return false;
    }
    CHECK(result.outcome == MIP_ACKNOWLEDGED && fake.count == 4 && fake.commands[0] == 0x0C0E);
    CHECK(fake.commands[1] == 0x0C0F && fake.commands[2] == 0x0C11 && fake.commands[3] == 0x0106);
    CHECK(fake.format_size == 6 && fake.format[0] == 1 && fake.format[1] == 0x80 && fake.format[2] == 1);
    CHECK(fake.format[3] == 0x04 && mip_get_16(fake.format + 4) == decimation);
    return true;
}

static void streams(void) {
    CHECK(has(1000, 1000, 1, 1000) && has(1000, 100, 10, 100) && has(1000, 62.5F, 16, 62.5F) && has(500, 0, 1, 500));
    CHECK(has(1000, 0.1F, 10000, 0.1F) && has(1000, 1000.0F / 3, 3, 1000.0F / 3) && has(0, 0, 1, 0));
    CHECK(!has(1000, 300, 0, 1000.0F / 3) && !has(1000, 2000, 0, 1000) && !has(1000, 90, 0, 1000.0F / 11));
    CHECK(!has(1000, -1, 0, 1000.0F / 65535) && !has(1000, 0.001F, 0, 1000.0F / 65535));
    CHECK(has(0, 4, 1, 0) && !has(0, -1, 0, 0)); /* data is sent as it arrives */
    for (unsigned by = 1; by <= 65535; by += 1 + by / 50) { /* the rate reported as the nearest is available */
        CHECK(has(1000, 1000.0F / (float)by, by, 1000.0F / (float)by));
    }

    /* Several: one that is not available is reported, and nothing is changed; with the nearest, it works. */
    struct mip_rate rates[84] = {{0xD3, 333.33F, 0}, {0x04, 0, 0}, {0x05, 70, 0}};
    start(115200);
    CHECK(mip_device_stream(&device, 0x80, 3, rates).outcome == MIP_NO_SUCH_RATE && fake.count == 1);
    CHECK(mip_rate_fits(&rates[0]) && mip_rate_fits(&rates[1]) && !mip_rate_fits(&rates[2]));
    CHECK(rates[2].nearest > 71 && rates[2].nearest < 72);
    rates[2].wanted = rates[2].nearest;
    CHECK(mip_device_stream(&device, 0x80, 3, rates).outcome == MIP_ACKNOWLEDGED);
    CHECK(fake.format_size == 12 && mip_get_16(fake.format + 10) == 14);

    /* As many as fit, and one more. */
    start(115200);
    CHECK(mip_device_stream(&device, 0x80, 83, rates).outcome == MIP_NO_SUCH_RATE || fake.count > 1);
    start(115200);
    const struct mip_result many = mip_device_stream(&device, 0x80, 84, rates);
    CHECK(many.outcome == MIP_NOT_SENT && many.error == MIP_ERROR_COUNT && fake.count == 0);

    /* Each command may fail, or succeed only after repetition. */
    static const unsigned commands[] = {0x0C0E, 0x0C0F, 0x0C11, 0x0106};
    for (unsigned i = 0; i < 4; i++) {
        start(115200);
        fake.refuse = commands[i];
        CHECK(mip_device_stream(&device, 0x80, 2, rates).outcome == MIP_REFUSED);
        CHECK(fake.count == (i == 0 ? 2 : i + 1)); /* it may be an older device */
        start(115200);
        fake.lose = 2;
        fake.lose_of = commands[i];
        CHECK(mip_device_stream(&device, 0x80, 2, rates).outcome == MIP_ACKNOWLEDGED && fake.count == 6);
        start(115200);
        fake.reads_left = i + 1;
        CHECK(mip_device_stream(&device, 0x80, 2, rates).outcome == MIP_CLOSED);
    }
}

/* The first timestamp of the set that the device accepts; without one, the other fields are sent. */
static void times(void) {
    static const uint8_t stamps[] = {0xD5, 0xD7, 0x12, 0xD3};
    for (unsigned i = 0; i < sizeof(stamps); i++) {
        struct mip_rate rates[] = {{0x04, 50, 0}, {MIP_TIMESTAMP, 100, 0}};
        start(115200);
        fake.begin = stamps[i];
        CHECK(mip_device_stream(&device, 0x80, 1, rates).outcome == MIP_REFUSED && fake.count == 2);
        struct mip_rate timed[] = {rates[1], rates[0]};
        start(115200);
        fake.begin = stamps[i];
        CHECK(mip_device_stream(&device, 0x80, 2, timed).outcome == MIP_ACKNOWLEDGED && fake.count == 4 + i);
        CHECK(fake.format_size == 9 && fake.format[3] == stamps[i] && mip_get_16(fake.format + 4) == 10);
        CHECK(fake.format[6] == 0x04 && mip_get_16(fake.format + 7) == 20);
        CHECK(timed[0].descriptor == MIP_TIMESTAMP); /* for another device */
        start(115200);
        fake.begin = 0x11; /* of another set */
        CHECK(mip_device_stream(&device, 0x80, 2, timed).outcome == MIP_REFUSED && fake.count == 6);
        CHECK(mip_device_stream(&device, 0x80, 1, timed).outcome == MIP_REFUSED); /* the format is not cleared */
        start(115200);
        fake.begin = 0x04; /* no timestamp is accepted; the command without one is repeated */
        fake.lose = i % 3;
        fake.lose_of = 0x0C0F;
        CHECK(mip_device_stream(&device, 0x80, 2, timed).outcome == MIP_ACKNOWLEDGED && fake.count == 8 + i % 3);
        CHECK(fake.format_size == 6 && fake.format[3] == 0x04 && mip_get_16(fake.format + 4) == 20);
        CHECK(timed[0].descriptor == MIP_TIMESTAMP && timed[1].descriptor == 0x04);
        start(115200);
        fake.older = true;
        fake.begin = stamps[i];
        CHECK(mip_device_stream(&device, 0x80, 2, timed).outcome == MIP_ACKNOWLEDGED && fake.count == 5 + i);
    }
    CHECK(has(1000, 333.33F, 3, 1000.0F / 3) && !has(1000, 333.2F, 3, 1000.0F / 3));
}

/* Older devices have commands for each of their sets, and streams with numbers. */
static void older(void) {
    static const struct {
        uint8_t set;
        unsigned commands[5];
    } sets[] = {{0x80, {0x0C0E, 0x0C06, 0x0C08, 0x0C11, 0x0106}}, {0x82, {0x0C0E, 0x0C0B, 0x0C0A, 0x0C11, 0x0106}}};
    struct mip_rate rates[] = {{0x05, 100, 0}};
    for (unsigned i = 0; i < 2; i++) {
        start(115200);
        fake.older = true;
        CHECK(mip_device_stream(&device, sets[i].set, 1, rates).outcome == MIP_ACKNOWLEDGED && fake.count == 5);
        CHECK(memcmp(fake.commands, sets[i].commands, sizeof(sets[i].commands)) == 0);
        CHECK(fake.format_size == 5 && memcmp(fake.format, "\x01\x01\x05\x00\x0A", 5) == 0);
        CHECK(fake.stream == (i == 0 ? 1 : 3));
    }
    /* A set that it does not have, and one for which there is no older command: the first reply is reported. */
    start(115200);
    fake.older = true;
    CHECK(mip_device_stream(&device, 0x81, 1, rates).outcome == MIP_REFUSED && fake.count == 2);
    start(115200);
    fake.older = true;
    CHECK(mip_device_stream(&device, 0xA0, 1, rates).outcome == MIP_REFUSED && fake.count == 1);
}

static void retries(void) {
    const struct mip_result late = {MIP_TIMED_OUT, 0, MIP_OK, false};
    const struct mip_result no = {MIP_REFUSED, 2, MIP_OK, false};
    struct mip_retry retry = MIP_RETRY;
    CHECK(mip_again(&retry, late) && !mip_again(&retry, no) && !mip_again(&retry, late) && !mip_again(&retry, late));
    struct mip_retry once = {1, ~0u};
    CHECK(!mip_again(&once, late));
    struct mip_retry refused = {9, 1u << MIP_REFUSED};
    CHECK(mip_again(&refused, no) && !mip_again(&refused, late));
}

int main(void) {
    connects();
    patient();
    streams();
    times();
    older();
    retries();
    return 0;
}
