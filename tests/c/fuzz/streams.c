/*
 * Prints each input of parser.c, or with FIELDS of fields.c, as a stream: the size of the pieces in which it arrives
 * (0: all at once), and its bytes. Linked with replay.c, it makes what the programs named `answers` read.
 */
#include "fuzz.h"

static void print(unsigned piece, const uint8_t *bytes, size_t size) {
    printf("%u ", piece);
    for (size_t i = 0; i < size; i++) {
        putchar("0123456789abcdef"[bytes[i] >> 4]);
        putchar("0123456789abcdef"[bytes[i] & 15]);
    }
    putchar('\n');
}

#ifdef FIELDS
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    uint8_t bytes[4 + 255 + 2] = {0x75, 0x65};
    struct input in = {data, size};
    const bool payload = input_byte(&in) >= 128;
    bytes[2] = input_byte(&in);
    const uint8_t descriptor = input_byte(&in);
    (void)input_byte(&in); /* how much room a builder lacks */
    const size_t head = payload ? 4 : 6;
    const size_t count = in.left < 259 - head ? in.left : 259 - head;
    const size_t end = head + count;
    bytes[3] = (uint8_t)(end - 4);
    if (!payload) {
        bytes[4] = bytes[3];
        bytes[5] = descriptor;
    }
    if (count > 0) {
        memcpy(bytes + head, in.at, count);
    }
    for (size_t i = 0; i < end; i++) {
        bytes[end] = (uint8_t)(bytes[end] + bytes[i]);
        bytes[end + 1] = (uint8_t)(bytes[end + 1] + bytes[end]);
    }
    print(0, bytes, end + 2);
    return 0;
}
#else
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct input in = {data, size};
    const uint8_t piece = input_byte(&in) % 128;
    (void)input_byte(&in); /* what happens between the pieces */
    print(piece, in.at, in.left);
    return 0;
}
#endif
