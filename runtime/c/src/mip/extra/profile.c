/* Searches in the device profiles. */
#include "mip/extra/profile.h"

#include <stdbool.h>
#include <string.h>

/** Is the text this name, ignoring spaces around it? */
static bool is_name(const char *name, const char *text) {
    while (*text == ' ') {
        text++;
    }
    while (*name != '\0' && *name == *text) {
        name++;
        text++;
    }
    while (*text == ' ') {
        text++;
    }
    return *name == '\0' && *text == '\0';
}

static bool is_called(const struct mip_profile *profile, const char *text) {
    for (size_t i = 0; i < profile->also_count; i++) {
        if (is_name(profile->also[i], text)) {
            return true;
        }
    }
    return is_name(profile->id, text) || is_name(profile->title, text);
}

const struct mip_profile *mip_profile_find(const char *name) {
    for (size_t i = 0; i < mip_profile_count; i++) {
        if (is_called(mip_profiles[i], name)) {
            return mip_profiles[i];
        }
    }
    return NULL;
}

const struct mip_profile *mip_profile_by_model(uint16_t model_number) {
    for (size_t i = 0; i < mip_profile_count; i++) {
        if (model_number != 0 && mip_profiles[i]->model_number == model_number) {
            return mip_profiles[i];
        }
    }
    return NULL;
}

uint16_t mip_model_number(const char *text, size_t size) {
    uint32_t number = 0;
    size_t at = 0;
    while (at < size && text[at] == ' ') {
        at++;
    }
    for (; at < size && text[at] >= '0' && text[at] <= '9'; at++) {
        number = 10 * number + (uint32_t)(text[at] - '0');
        if (number > UINT16_MAX) {
            return 0;
        }
    }
    const bool ends =
        at == size || text[at] == '.' || text[at] == '-' || text[at] == ' ' || text[at] == '\0';
    return (uint16_t)(ends ? number : 0);
}

static const struct mip_profile_field *find_in(const struct mip_profile_field *fields, size_t count,
                                               uint8_t descriptor_set, uint8_t descriptor) {
    for (size_t i = 0; i < count; i++) {
        if (fields[i].descriptor_set == descriptor_set && fields[i].descriptor == descriptor) {
            return &fields[i];
        }
    }
    return NULL;
}

static const struct mip_profile_field *find_stated(const struct mip_profile *profile,
                                                   uint8_t descriptor_set, uint8_t descriptor) {
    const struct mip_profile_field *f =
        find_in(profile->fields, profile->field_count, descriptor_set, descriptor);
    return f != NULL
               ? f
               : find_in(profile->refuses, profile->refused_count, descriptor_set, descriptor);
}

const struct mip_profile_field *mip_profile_find_field(const struct mip_profile *profile,
                                                       uint8_t descriptor_set, uint8_t descriptor) {
    const struct mip_profile_field *f = find_stated(profile, descriptor_set, descriptor);
    if (f == NULL) {
        f = find_in(profile->absent_sets, profile->absent_count, descriptor_set, 0);
    }
    return f != NULL || descriptor_set < 0x80 ? f : find_stated(profile, 0xFF, descriptor);
}

enum mip_support mip_profile_support(const struct mip_profile *profile, uint8_t descriptor_set,
                                     uint8_t descriptor) {
    const struct mip_profile_field *f = mip_profile_find_field(profile, descriptor_set, descriptor);
    if (f != NULL) {
        return (enum mip_support)f->evidence->answer;
    }
    return profile->incomplete_count > 0 ? MIP_SUPPORT_UNKNOWN : MIP_SUPPORT_NO;
}

const char *mip_profile_firmware_of(const struct mip_profile *profile, uint8_t descriptor_set,
                                    uint8_t descriptor) {
    for (size_t i = 0; i < profile->firmware_count; i++) {
        const struct mip_profile_firmware *f = &profile->firmware[i];
        if (f->descriptor_set == descriptor_set && f->descriptor == descriptor) {
            return f->versions;
        }
    }
    return NULL;
}

double mip_profile_base_rate(const struct mip_profile *profile, uint8_t descriptor_set) {
    for (size_t i = 0; i < profile->rate_count; i++) {
        if (profile->rates[i].descriptor_set == descriptor_set) {
            return profile->rates[i].rate;
        }
    }
    return -1.0;
}

const char *mip_profile_reading_of(const struct mip_profile *profile, const char *of) {
    for (size_t i = 0; i < profile->reading_count; i++) {
        if (strcmp(profile->readings[i].of, of) == 0) {
            return profile->readings[i].type;
        }
    }
    return NULL;
}
