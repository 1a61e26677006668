/* Searches in the device profiles. */
#include "mip/profile.h"

#include <stdbool.h>
#include <string.h>

const struct mip_device *mip_device_find(const char *id) {
    for (size_t i = 0; i < mip_device_count; i++) {
        if (strcmp(mip_devices[i]->id, id) == 0) {
            return mip_devices[i];
        }
    }
    return NULL;
}

const struct mip_device_field *mip_device_supports(const struct mip_device *device,
                                                   uint8_t descriptor_set, uint8_t descriptor) {
    for (size_t i = 0; i < device->field_count; i++) {
        const struct mip_device_field *f = &device->fields[i];
        const bool shared = f->descriptor_set == 0xFF && descriptor_set >= 0x80;
        if ((f->descriptor_set == descriptor_set || shared) && f->descriptor == descriptor) {
            return f;
        }
    }
    return NULL;
}

double mip_device_base_rate(const struct mip_device *device, uint8_t descriptor_set) {
    for (size_t i = 0; i < device->rate_count; i++) {
        if (device->rates[i].descriptor_set == descriptor_set) {
            return device->rates[i].rate;
        }
    }
    return -1.0;
}

const char *mip_device_reading_of(const struct mip_device *device, const char *of) {
    for (size_t i = 0; i < device->reading_count; i++) {
        if (strcmp(device->readings[i].of, of) == 0) {
            return device->readings[i].type;
        }
    }
    return NULL;
}
