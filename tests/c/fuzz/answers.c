/*
 * What C makes of streams: each line is the size of pieces and a stream, as streams.c prints them. For each stream, a
 * line has its packets, each with its fields, and then how many bytes were skipped. A field is
 *
 *     NAME=BYTES+TRAILING    what its decoded value is encoded to, and the number of bytes that are left
 *     NAME!ERROR             why it cannot be decoded
 *     DESCRIPTOR             unknown
 *
 * and `!` stands for the end of a packet with a malformed field. The programs of other languages print the same.
 */
#include "fuzz.h"

#include "mip/registry.h"

static void print(const uint8_t *bytes, size_t size) {
    for (size_t i = 0; i < size; i++) {
        putchar("0123456789abcdef"[bytes[i] >> 4]);
        putchar("0123456789abcdef"[bytes[i] & 15]);
    }
}

static void print_field(const struct mip_field *field) {
    const struct mip_entry *entry = mip_registry_find(field);
    if (entry == NULL) {
        printf("%u ", field->descriptor);
        return;
    }
    printf("%s.%s", mip_registry_set_name(entry, field->descriptor_set), entry->name);
    void *value = exactly(entry->codec->size);
    size_t trailing = 0;
    const mip_error error = mip_decode(entry->codec, value, field, &trailing);
    if (error == MIP_OK) {
        uint8_t buffer[MIP_MAX_PACKET];
        struct mip_builder b;
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), field->descriptor_set) == MIP_OK);
        CHECK(mip_encode(entry->codec, value, &b) == MIP_OK);
        putchar('=');
        print(buffer + MIP_HEADER_SIZE + 2, b.length - MIP_HEADER_SIZE - 2);
        printf("+%zu ", trailing);
    } else {
        printf("!%s ", mip_error_name(error));
    }
    free(value);
}

static void print_packet(const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_field field;
    print(packet->bytes, packet->size);
    putchar(' ');
    while (mip_walk_next(&walk, &field)) {
        print_field(&field);
    }
    if (walk.error != MIP_OK) {
        printf("! ");
    }
}

static void answer(size_t piece, const uint8_t *bytes, size_t size) {
    struct mip_parser parser;
    struct mip_packet packet;
    struct input in = {bytes, size};
    mip_parser_init(&parser);
    while (in.left > 0) {
        size_t left = piece > 0 ? piece : size;
        uint8_t *own = input_bytes(&in, &left);
        const uint8_t *at = own;
        while (mip_parser_next(&parser, &at, &left, &packet)) {
            print_packet(&packet);
        }
        free(own);
    }
    while (mip_parser_flush(&parser, &packet)) {
        print_packet(&packet);
    }
    printf("%llu\n", (unsigned long long)parser.skipped);
}

int main(void) {
    unsigned piece;
    while (scanf("%u", &piece) == 1 && getchar() == ' ') {
        uint8_t bytes[4096];
        size_t size = 0;
        unsigned byte;
        int c = getchar();
        while (c != '\n' && ungetc(c, stdin) == c && scanf("%2x", &byte) == 1) {
            CHECK(size < sizeof(bytes));
            bytes[size++] = (uint8_t)byte;
            c = getchar();
        }
        answer(piece, bytes, size);
    }
    return 0;
}
