#include "mip/device.h"
#include "mip/gnss_data.h"

/* For both receivers: the field contains the receiver's set. */
static void on_position(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_gnss_data_llh_position position;
    (void)user;
    (void)arrived;
    if (mip_gnss_data_llh_position_decode(&position, field) == MIP_OK) {
        plot(field->descriptor_set == MIP_GNSS_1_SET ? 1 : 2, position.latitude,
             position.longitude);
    }
}

/* Only the first matching entry is used, so the external receiver is ignored. */
const struct mip_handler receivers[] = {
    {&mip_gnss_data_llh_position_codec, MIP_GNSS_EXTERNAL_SET, NULL, NULL},
    {&mip_gnss_data_llh_position_codec, MIP_ANY_SET, on_position, NULL},
};

/* Does the same without a device. */
bool is_position_of_a_receiver(const struct mip_field *field) {
    switch (mip_field_key(field)) {
    case MIP_GNSS_DATA_LLH_POSITION(MIP_GNSS_1_SET):
    case MIP_GNSS_DATA_LLH_POSITION(MIP_GNSS_2_SET):
        return true;
    default: /* in another set? */
        return mip_field_is(field, &mip_gnss_data_llh_position_codec);
    }
}
