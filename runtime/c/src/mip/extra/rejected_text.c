/* The reason for which a device has rejected a field, in words. */
#include "mip/extra/registry.h"
#include "mip/extra/rejected.h"

#include <stdbool.h>

/** A text that is written as far as it fits. */
struct writer {
    char *text;
    size_t size;
    size_t length;
};

static void add(struct writer *writer, const char *text) {
    for (; *text != '\0'; text++) {
        if (writer->length + 1 < writer->size) {
            writer->text[writer->length] = *text;
            writer->text[writer->length + 1] = '\0';
        }
        writer->length++;
    }
}

static void add_number(struct writer *writer, unsigned number) {
    char digits[4] = {0};
    size_t at = 3;
    do {
        digits[--at] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0 && at > 0);
    add(writer, &digits[at]);
}

static void add_hexadecimal(struct writer *writer, uint8_t number) {
    const char digits[] = "0123456789ABCDEF";
    const char text[] = {'0', 'x', digits[number >> 4], digits[number & 0xF], '\0'};
    add(writer, text);
}

static void add_name(struct writer *writer, uint8_t descriptor_set, uint8_t descriptor) {
    const struct mip_entry *entry =
        descriptor != 0 ? mip_registry_next(descriptor_set, descriptor, NULL) : NULL;
    const struct mip_set *set = mip_registry_set(descriptor_set);
    if (entry != NULL) {
        add(writer, mip_registry_set_name(entry, descriptor_set));
        add(writer, ".");
        add(writer, entry->name);
        return;
    }
    if (set != NULL) {
        add(writer, set->name);
    } else {
        add(writer, "set ");
        add_hexadecimal(writer, descriptor_set);
    }
    if (descriptor != 0) {
        add(writer, " ");
        add_hexadecimal(writer, descriptor);
    }
}

static void add_absence(struct writer *writer, const struct mip_rejected *rejected,
                        const struct mip_profile *profile) {
    const struct mip_profile_field *field =
        profile != NULL
            ? mip_profile_find_field(profile, rejected->descriptor_set, rejected->descriptor)
            : NULL;
    if (field != NULL && field->evidence->absence[0] != '\0') {
        add(writer, " ");
        add(writer, field->evidence->absence);
        return;
    }
    add(writer, " does not send ");
    add_name(writer, rejected->descriptor_set, rejected->descriptor);
}

size_t mip_rejected_text(const struct mip_rejected *rejected, const struct mip_known_device *known,
                         char *text, size_t size) {
    const char *title = known->profile != NULL ? known->profile->title : "the device";
    struct writer writer = {text, size, 0};
    if (size > 0) {
        text[0] = '\0';
    }
    switch ((enum mip_rejection)rejected->reason) {
    case MIP_REJECTION_UNKNOWN:
        break;
    case MIP_REJECTION_ABSENT:
        add(&writer, title);
        add_absence(&writer, rejected, known->profile);
        break;
    case MIP_REJECTION_DECIMATION:
        add(&writer, "the decimation of ");
        add_name(&writer, rejected->descriptor_set, rejected->descriptor);
        add(&writer, " is 0");
        break;
    case MIP_REJECTION_TOO_MANY:
        add_number(&writer, rejected->count);
        add(&writer, " fields are listed, at most ");
        add_number(&writer, rejected->most);
        add(&writer, " are possible");
        break;
    case MIP_REJECTION_UNDEFINED:
        add_hexadecimal(&writer, rejected->descriptor);
        add(&writer, " is not a field of ");
        add_name(&writer, rejected->descriptor_set, 0);
        break;
    case MIP_REJECTION_OTHER_COMMAND:
        add(&writer, title);
        add(&writer, " has ");
        add_name(&writer, rejected->descriptor_set, rejected->descriptor);
        add(&writer, " instead");
        break;
    case MIP_REJECTION_UNLISTED:
        add(&writer, title);
        add(&writer, " is not known to send ");
        add_name(&writer, rejected->descriptor_set, rejected->descriptor);
        break;
    }
    return writer.length;
}
