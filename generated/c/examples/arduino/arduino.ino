// Prints the acceleration along x, in g, that a device sends to the receiving pin of Serial.
#include <mip.h>
#include <mip/sensor.h>

static struct mip_parser parser;

static void show(const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_field field;
    while (mip_walk_next(&walk, &field)) {
        struct mip_sensor_scaled_accel accel;
        if (field.descriptor_set == MIP_SENSOR_SET && field.descriptor == MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR &&
            mip_sensor_scaled_accel_decode(&accel, &field) == MIP_OK) {
            Serial.println(accel.scaled_accel[0]);
        }
    }
}

void setup() {
    Serial.begin(115200);
    mip_parser_init(&parser);
}

// Parsing single bytes would take several times as long.
void loop() {
    uint8_t bytes[32];
    size_t size = 0;
    while (size < sizeof(bytes) && Serial.available() > 0) {
        bytes[size++] = (uint8_t)Serial.read();
    }
    const uint8_t *data = bytes;
    struct mip_packet packet;
    while (mip_parser_next(&parser, &data, &size, &packet)) {
        show(&packet);
    }
}
