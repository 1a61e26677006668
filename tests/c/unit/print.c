/*
 * Prints what each line of the input asks for: WHAT DEVICE ROOM BYTES, "field 3dm-gx5-15 100 75650101..."; the device may
 * be "-". The answer is the length of the whole text, that of the text in a buffer of ROOM bytes, and this text.
 */
#include "check.h"

#include "mip/extra/print.h"
#include "mip/extra/reflect.h"
#include "mip/extra/registry.h"

static void print(const struct mip_print *to, const char *what, const uint8_t *bytes, size_t size) {
    struct mip_packet packet = {bytes, size, size > 2 ? bytes[2] : (uint8_t)0};
    struct mip_walk walk = mip_walk_packet(&packet);
    struct mip_field field;
    if (strcmp(what, "packet") == 0) {
        mip_print_packet(to, &packet);
    } else if (strcmp(what, "float") == 0) {
        float value;
        mip_get_float(&value, bytes);
        mip_print_float(to, value);
    } else if (strcmp(what, "double") == 0) {
        double value;
        mip_get_double(&value, bytes);
        mip_print_double(to, value);
    } else if (strcmp(what, "signed") == 0) {
        mip_print_signed(to, (int64_t)mip_get_64(bytes));
    } else {
        CHECK(strcmp(what, "field") == 0 && mip_walk_next(&walk, &field));
        mip_print_field(to, &field);
    }
}

int main(void) {
    static char line[1 << 18];
    static char digits[1 << 18];
    for (size_t i = 0; i < mip_registry_size; i++) {
        CHECK(mip_registry[i].codec->size <= sizeof(union mip_any_value));
    }
    while (fgets(line, sizeof(line), stdin) != NULL) {
        char what[16];
        char device[64];
        size_t room;
        digits[0] = '\0';
        CHECK(sscanf(line, "%15s %63s %zu %s", what, device, &room, digits) >= 3);
        /* Exactly as large as they may be, so that the sanitizer sees the first byte beyond. */
        uint8_t *bytes = (uint8_t *)malloc(digits[0] != '\0' ? strlen(digits) / 2 : 1);
        char *buffer = room > 0 ? (char *)malloc(room) : NULL;
        CHECK(bytes != NULL && (buffer != NULL || room == 0));
        const size_t size = octets(digits, bytes);
        struct mip_text text;
        struct mip_print to = mip_print_to_text(&text, buffer, room);
        to.device = strcmp(device, "-") == 0 ? NULL : device;
        print(&to, what, bytes, size);
        const size_t held = room > 0 ? strlen(buffer) : 0;
        printf("%zu %zu\n", text.length, held);
        fwrite(buffer != NULL ? buffer : "", 1, held, stdout);
        free(bytes);
        free(buffer);
    }
    return 0;
}
