

/* Device profiles. */
#include "mip/extra/profiles.h"

/* 3DM-CV5-10. */

static const char *const cv5_10_also[] = {
    "3DM-CV5-IMU",
};

static const char *const cv5_10_incomplete[] = {
    "Of the manual, only the table of contents is known, up to the set `3dm`. It lists only the "
    "sets `base`, `3dm` and `sensor`.",
};

static const struct mip_profile_evidence cv5_10_evidence[] = {
    {MIP_SUPPORT_YES, "Documented (3DM-CV5-10 Data Communications Protocol Manual: Contents).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-CX5-10.", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (MicroStrain Communication Library: Issue 145).", ""},
    {MIP_SUPPORT_NO, "Not in the manual, whose list of the set is complete.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires a pressure sensor, which the device lacks.",
     "has no pressure sensor"},
};

static const struct mip_profile_field cv5_10_fields[] = {
    {0x01, 0x01, "", &cv5_10_evidence[0]},       {0x01, 0x02, "", &cv5_10_evidence[0]},
    {0x01, 0x03, "", &cv5_10_evidence[0]},       {0x01, 0x04, "", &cv5_10_evidence[0]},
    {0x01, 0x05, "", &cv5_10_evidence[0]},       {0x01, 0x06, "", &cv5_10_evidence[0]},
    {0x01, 0x72, "WRA", &cv5_10_evidence[0]},    {0x01, 0x7E, "", &cv5_10_evidence[0]},
    {0x0C, 0x01, "", &cv5_10_evidence[0]},       {0x0C, 0x06, "", &cv5_10_evidence[0]},
    {0x0C, 0x08, "WRSLD", &cv5_10_evidence[0]},  {0x0C, 0x11, "WRSLD", &cv5_10_evidence[2]},
    {0x0C, 0x30, "SLD", &cv5_10_evidence[1]},    {0x0C, 0x37, "WRSLDA", &cv5_10_evidence[2]},
    {0x0C, 0x38, "WRSLDA", &cv5_10_evidence[2]}, {0x0C, 0x39, "", &cv5_10_evidence[2]},
    {0x0C, 0x3E, "WRSLD", &cv5_10_evidence[2]},  {0x0C, 0x40, "WRSLD", &cv5_10_evidence[2]},
    {0x0C, 0x50, "WRSLD", &cv5_10_evidence[2]},  {0x0C, 0x51, "WRSLD", &cv5_10_evidence[2]},
    {0x0C, 0x64, "", &cv5_10_evidence[2]},       {0x80, 0x04, "", &cv5_10_evidence[1]},
    {0x80, 0x05, "", &cv5_10_evidence[1]},       {0x80, 0x07, "", &cv5_10_evidence[2]},
    {0x80, 0x08, "", &cv5_10_evidence[2]},       {0x80, 0x12, "", &cv5_10_evidence[2]},
};

static const struct mip_profile_field cv5_10_refuses[] = {
    {0x01, 0x07, "", &cv5_10_evidence[4]}, {0x01, 0x08, "", &cv5_10_evidence[4]},
    {0x01, 0x09, "", &cv5_10_evidence[4]}, {0x0C, 0x02, "", &cv5_10_evidence[5]},
    {0x0C, 0x07, "", &cv5_10_evidence[5]}, {0x0C, 0x09, "", &cv5_10_evidence[5]},
    {0x0C, 0x20, "", &cv5_10_evidence[5]}, {0x0C, 0x21, "", &cv5_10_evidence[5]},
    {0x0C, 0x22, "", &cv5_10_evidence[5]}, {0x0C, 0x23, "", &cv5_10_evidence[5]},
    {0x0C, 0x24, "", &cv5_10_evidence[5]}, {0x0C, 0x34, "", &cv5_10_evidence[5]},
    {0x0C, 0x3A, "", &cv5_10_evidence[6]}, {0x0C, 0x3B, "", &cv5_10_evidence[6]},
    {0x0C, 0x62, "", &cv5_10_evidence[5]}, {0x80, 0x01, "", &cv5_10_evidence[3]},
    {0x80, 0x03, "", &cv5_10_evidence[6]}, {0x80, 0x06, "", &cv5_10_evidence[6]},
    {0x80, 0x16, "", &cv5_10_evidence[7]}, {0x80, 0x17, "", &cv5_10_evidence[7]},
};

static const struct mip_profile_field cv5_10_absent_sets[] = {
    {0x81, 0, "", &cv5_10_evidence[5]},
    {0x91, 0, "", &cv5_10_evidence[5]},
    {0x92, 0, "", &cv5_10_evidence[5]},
    {0x93, 0, "", &cv5_10_evidence[5]},
};

static const struct mip_profile_reading cv5_10_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cv5_10 = {
    "3dm-cv5-10",
    "3DM-CV5-10",
    "3dm-cv5-10",
    "Inertial measurement unit.",
    6259, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    26,   /* fields */
    20,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    cv5_10_also,
    cv5_10_incomplete,
    cv5_10_fields,
    cv5_10_refuses,
    cv5_10_absent_sets,
    NULL,
    NULL,
    cv5_10_readings,
};

/* 3DM-CV5-15. */

static const char *const cv5_15_also[] = {
    "3DM-CV5-AR",
};

static const char *const cv5_15_incomplete[] = {
    "Of the manual, only the table of contents is known, up to `3dm.filter_message_format`. It "
    "lists the sets `base`, `3dm`, `filter`, `system`, `sensor` and `filter_data`.",
};

static const struct mip_profile_evidence cv5_15_evidence[] = {
    {MIP_SUPPORT_YES, "Documented (3DM-CV5-15 Data Communications Protocol Manual: Contents).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15.", ""},
    {MIP_SUPPORT_NO, "Not in the manual, whose list of the set is complete.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cv5_15_fields[] = {
    {0x01, 0x01, "", &cv5_15_evidence[0]},       {0x01, 0x02, "", &cv5_15_evidence[0]},
    {0x01, 0x03, "", &cv5_15_evidence[0]},       {0x01, 0x04, "", &cv5_15_evidence[0]},
    {0x01, 0x05, "", &cv5_15_evidence[0]},       {0x01, 0x06, "", &cv5_15_evidence[0]},
    {0x01, 0x07, "", &cv5_15_evidence[0]},       {0x01, 0x72, "WRA", &cv5_15_evidence[0]},
    {0x01, 0x7E, "", &cv5_15_evidence[0]},       {0x0C, 0x01, "", &cv5_15_evidence[0]},
    {0x0C, 0x03, "", &cv5_15_evidence[0]},       {0x0C, 0x06, "", &cv5_15_evidence[0]},
    {0x0C, 0x08, "WRSLD", &cv5_15_evidence[0]},  {0x0C, 0x0A, "WRSLD", &cv5_15_evidence[0]},
    {0x0C, 0x0B, "", &cv5_15_evidence[0]},       {0x0C, 0x11, "WRSLD", &cv5_15_evidence[3]},
    {0x0C, 0x30, "SLD", &cv5_15_evidence[1]},    {0x0C, 0x37, "WRSLDA", &cv5_15_evidence[3]},
    {0x0C, 0x38, "WRSLDA", &cv5_15_evidence[3]}, {0x0C, 0x39, "", &cv5_15_evidence[1]},
    {0x0C, 0x3E, "WRSLD", &cv5_15_evidence[3]},  {0x0C, 0x40, "WRSLD", &cv5_15_evidence[3]},
    {0x0C, 0x50, "WRSLD", &cv5_15_evidence[3]},  {0x0C, 0x51, "WRSLD", &cv5_15_evidence[3]},
    {0x0C, 0x64, "", &cv5_15_evidence[3]},       {0x0D, 0x01, "", &cv5_15_evidence[2]},
    {0x0D, 0x02, "", &cv5_15_evidence[3]},       {0x0D, 0x03, "", &cv5_15_evidence[3]},
    {0x0D, 0x11, "WRSLD", &cv5_15_evidence[1]},  {0x0D, 0x14, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x17, "", &cv5_15_evidence[3]},       {0x0D, 0x18, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x19, "WRSLD", &cv5_15_evidence[1]},  {0x0D, 0x1A, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x1B, "WRSLD", &cv5_15_evidence[3]},  {0x0D, 0x1D, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x1F, "", &cv5_15_evidence[3]},       {0x0D, 0x20, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x21, "WRSLD", &cv5_15_evidence[3]},  {0x0D, 0x23, "", &cv5_15_evidence[3]},
    {0x0D, 0x26, "WRSLD", &cv5_15_evidence[3]},  {0x0D, 0x28, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x41, "WRSLD", &cv5_15_evidence[3]},  {0x0D, 0x44, "WRSLD", &cv5_15_evidence[3]},
    {0x0D, 0x4B, "WRSLD", &cv5_15_evidence[3]},  {0x7F, 0x10, "WRSLD", &cv5_15_evidence[3]},
    {0x80, 0x04, "", &cv5_15_evidence[1]},       {0x80, 0x05, "", &cv5_15_evidence[1]},
    {0x80, 0x07, "", &cv5_15_evidence[3]},       {0x80, 0x08, "", &cv5_15_evidence[3]},
    {0x80, 0x09, "", &cv5_15_evidence[3]},       {0x80, 0x0A, "", &cv5_15_evidence[3]},
    {0x80, 0x0C, "", &cv5_15_evidence[3]},       {0x80, 0x10, "", &cv5_15_evidence[3]},
    {0x80, 0x11, "", &cv5_15_evidence[3]},       {0x80, 0x12, "", &cv5_15_evidence[1]},
    {0x80, 0x17, "", &cv5_15_evidence[3]},       {0x82, 0x03, "", &cv5_15_evidence[3]},
    {0x82, 0x04, "", &cv5_15_evidence[3]},       {0x82, 0x05, "", &cv5_15_evidence[1]},
    {0x82, 0x06, "", &cv5_15_evidence[3]},       {0x82, 0x0A, "", &cv5_15_evidence[3]},
    {0x82, 0x0B, "", &cv5_15_evidence[3]},       {0x82, 0x0D, "", &cv5_15_evidence[3]},
    {0x82, 0x0E, "", &cv5_15_evidence[1]},       {0x82, 0x0F, "", &cv5_15_evidence[3]},
    {0x82, 0x10, "", &cv5_15_evidence[1]},       {0x82, 0x11, "", &cv5_15_evidence[1]},
    {0x82, 0x12, "", &cv5_15_evidence[3]},       {0x82, 0x13, "", &cv5_15_evidence[3]},
    {0x82, 0x14, "", &cv5_15_evidence[3]},       {0x82, 0x1C, "", &cv5_15_evidence[1]},
    {0x82, 0x21, "", &cv5_15_evidence[3]},
};

static const struct mip_profile_field cv5_15_refuses[] = {
    {0x01, 0x08, "", &cv5_15_evidence[4]}, {0x01, 0x09, "", &cv5_15_evidence[4]},
    {0x0C, 0x02, "", &cv5_15_evidence[5]}, {0x0C, 0x07, "", &cv5_15_evidence[5]},
    {0x0C, 0x09, "", &cv5_15_evidence[5]}, {0x0C, 0x20, "", &cv5_15_evidence[5]},
    {0x0C, 0x21, "", &cv5_15_evidence[5]}, {0x0C, 0x22, "", &cv5_15_evidence[5]},
    {0x0C, 0x23, "", &cv5_15_evidence[5]}, {0x0C, 0x24, "", &cv5_15_evidence[5]},
    {0x0C, 0x34, "", &cv5_15_evidence[5]}, {0x0C, 0x3A, "", &cv5_15_evidence[6]},
    {0x0C, 0x3B, "", &cv5_15_evidence[6]}, {0x0C, 0x62, "", &cv5_15_evidence[5]},
    {0x0D, 0x27, "", &cv5_15_evidence[6]}, {0x0D, 0x2B, "", &cv5_15_evidence[6]},
    {0x0D, 0x2C, "", &cv5_15_evidence[6]}, {0x0D, 0x42, "", &cv5_15_evidence[6]},
    {0x0D, 0x43, "", &cv5_15_evidence[6]}, {0x0D, 0x45, "", &cv5_15_evidence[6]},
    {0x0D, 0x46, "", &cv5_15_evidence[6]}, {0x0D, 0x4C, "", &cv5_15_evidence[6]},
    {0x0D, 0x4D, "", &cv5_15_evidence[6]}, {0x0D, 0x54, "", &cv5_15_evidence[5]},
    {0x0D, 0x64, "", &cv5_15_evidence[5]}, {0x80, 0x03, "", &cv5_15_evidence[6]},
    {0x80, 0x06, "", &cv5_15_evidence[6]}, {0x82, 0x1A, "", &cv5_15_evidence[6]},
    {0x82, 0x1B, "", &cv5_15_evidence[6]}, {0x82, 0x25, "", &cv5_15_evidence[6]},
    {0x82, 0x26, "", &cv5_15_evidence[6]}, {0x82, 0x28, "", &cv5_15_evidence[6]},
    {0x82, 0x29, "", &cv5_15_evidence[6]}, {0x82, 0x2A, "", &cv5_15_evidence[6]},
    {0x82, 0x2C, "", &cv5_15_evidence[6]}, {0x82, 0x34, "", &cv5_15_evidence[5]},
    {0x82, 0x35, "", &cv5_15_evidence[5]}, {0x82, 0x49, "", &cv5_15_evidence[7]},
};

static const struct mip_profile_field cv5_15_absent_sets[] = {
    {0x81, 0, "", &cv5_15_evidence[5]},
    {0x91, 0, "", &cv5_15_evidence[5]},
    {0x92, 0, "", &cv5_15_evidence[5]},
    {0x93, 0, "", &cv5_15_evidence[5]},
};

static const struct mip_profile_reading cv5_15_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cv5_15 = {
    "3dm-cv5-15",
    "3DM-CV5-15",
    "3dm-cv5-15",
    "Attitude reference.",
    6258, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    73,   /* fields */
    38,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    cv5_15_also,
    cv5_15_incomplete,
    cv5_15_fields,
    cv5_15_refuses,
    cv5_15_absent_sets,
    NULL,
    NULL,
    cv5_15_readings,
};

/* 3DM-CV5-25. */

static const char *const cv5_25_also[] = {
    "3DM-CV5-AHRS",
};

static const char *const cv5_25_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence cv5_25_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cv5_25_fields[] = {
    {0x01, 0x01, "", &cv5_25_evidence[0]},       {0x01, 0x02, "", &cv5_25_evidence[0]},
    {0x01, 0x03, "", &cv5_25_evidence[1]},       {0x01, 0x04, "", &cv5_25_evidence[2]},
    {0x01, 0x05, "", &cv5_25_evidence[3]},       {0x01, 0x06, "", &cv5_25_evidence[0]},
    {0x01, 0x07, "", &cv5_25_evidence[2]},       {0x01, 0x72, "WRA", &cv5_25_evidence[3]},
    {0x01, 0x7E, "", &cv5_25_evidence[3]},       {0x0C, 0x01, "", &cv5_25_evidence[3]},
    {0x0C, 0x03, "", &cv5_25_evidence[3]},       {0x0C, 0x06, "", &cv5_25_evidence[0]},
    {0x0C, 0x08, "WRSLD", &cv5_25_evidence[0]},  {0x0C, 0x0A, "WRSLD", &cv5_25_evidence[0]},
    {0x0C, 0x0B, "", &cv5_25_evidence[0]},       {0x0C, 0x11, "WRSLD", &cv5_25_evidence[3]},
    {0x0C, 0x30, "SLD", &cv5_25_evidence[0]},    {0x0C, 0x37, "WRSLDA", &cv5_25_evidence[3]},
    {0x0C, 0x38, "WRSLDA", &cv5_25_evidence[3]}, {0x0C, 0x39, "", &cv5_25_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &cv5_25_evidence[3]}, {0x0C, 0x3B, "WRSLDA", &cv5_25_evidence[3]},
    {0x0C, 0x3E, "WRSLD", &cv5_25_evidence[3]},  {0x0C, 0x40, "WRSLD", &cv5_25_evidence[3]},
    {0x0C, 0x50, "WRSLD", &cv5_25_evidence[3]},  {0x0C, 0x51, "WRSLD", &cv5_25_evidence[3]},
    {0x0C, 0x64, "", &cv5_25_evidence[3]},       {0x0D, 0x01, "", &cv5_25_evidence[1]},
    {0x0D, 0x02, "", &cv5_25_evidence[3]},       {0x0D, 0x03, "", &cv5_25_evidence[3]},
    {0x0D, 0x11, "WRSLD", &cv5_25_evidence[0]},  {0x0D, 0x14, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x17, "", &cv5_25_evidence[3]},       {0x0D, 0x18, "WRSLD", &cv5_25_evidence[1]},
    {0x0D, 0x19, "WRSLD", &cv5_25_evidence[0]},  {0x0D, 0x1A, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x1B, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x1D, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x1F, "", &cv5_25_evidence[3]},       {0x0D, 0x20, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x21, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x23, "", &cv5_25_evidence[3]},
    {0x0D, 0x26, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x27, "WS", &cv5_25_evidence[3]},
    {0x0D, 0x28, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x29, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x2B, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x2C, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x41, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x42, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x43, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x44, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x45, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x46, "WRSLD", &cv5_25_evidence[3]},
    {0x0D, 0x47, "WRSLD", &cv5_25_evidence[3]},  {0x0D, 0x4B, "WRSLD", &cv5_25_evidence[3]},
    {0x7F, 0x10, "WRSLD", &cv5_25_evidence[3]},  {0x80, 0x04, "", &cv5_25_evidence[0]},
    {0x80, 0x05, "", &cv5_25_evidence[0]},       {0x80, 0x06, "", &cv5_25_evidence[3]},
    {0x80, 0x07, "", &cv5_25_evidence[3]},       {0x80, 0x08, "", &cv5_25_evidence[3]},
    {0x80, 0x09, "", &cv5_25_evidence[3]},       {0x80, 0x0A, "", &cv5_25_evidence[3]},
    {0x80, 0x0C, "", &cv5_25_evidence[3]},       {0x80, 0x10, "", &cv5_25_evidence[3]},
    {0x80, 0x11, "", &cv5_25_evidence[3]},       {0x80, 0x12, "", &cv5_25_evidence[0]},
    {0x80, 0x17, "", &cv5_25_evidence[3]},       {0x82, 0x03, "", &cv5_25_evidence[3]},
    {0x82, 0x04, "", &cv5_25_evidence[3]},       {0x82, 0x05, "", &cv5_25_evidence[0]},
    {0x82, 0x06, "", &cv5_25_evidence[3]},       {0x82, 0x0A, "", &cv5_25_evidence[3]},
    {0x82, 0x0B, "", &cv5_25_evidence[3]},       {0x82, 0x0D, "", &cv5_25_evidence[3]},
    {0x82, 0x0E, "", &cv5_25_evidence[0]},       {0x82, 0x0F, "", &cv5_25_evidence[3]},
    {0x82, 0x10, "", &cv5_25_evidence[0]},       {0x82, 0x11, "", &cv5_25_evidence[0]},
    {0x82, 0x12, "", &cv5_25_evidence[3]},       {0x82, 0x13, "", &cv5_25_evidence[3]},
    {0x82, 0x14, "", &cv5_25_evidence[3]},       {0x82, 0x15, "", &cv5_25_evidence[3]},
    {0x82, 0x1C, "", &cv5_25_evidence[0]},       {0x82, 0x21, "", &cv5_25_evidence[3]},
    {0x82, 0x25, "", &cv5_25_evidence[3]},       {0x82, 0x26, "", &cv5_25_evidence[3]},
    {0x82, 0x28, "", &cv5_25_evidence[3]},       {0x82, 0x29, "", &cv5_25_evidence[3]},
};

static const struct mip_profile_field cv5_25_refuses[] = {
    {0x0C, 0x02, "", &cv5_25_evidence[4]}, {0x0C, 0x07, "", &cv5_25_evidence[4]},
    {0x0C, 0x09, "", &cv5_25_evidence[4]}, {0x0C, 0x20, "", &cv5_25_evidence[4]},
    {0x0C, 0x21, "", &cv5_25_evidence[4]}, {0x0C, 0x22, "", &cv5_25_evidence[4]},
    {0x0C, 0x23, "", &cv5_25_evidence[4]}, {0x0C, 0x24, "", &cv5_25_evidence[4]},
    {0x0C, 0x34, "", &cv5_25_evidence[4]}, {0x0C, 0x62, "", &cv5_25_evidence[4]},
    {0x0D, 0x54, "", &cv5_25_evidence[4]}, {0x0D, 0x64, "", &cv5_25_evidence[4]},
    {0x82, 0x34, "", &cv5_25_evidence[4]}, {0x82, 0x35, "", &cv5_25_evidence[4]},
    {0x82, 0x49, "", &cv5_25_evidence[5]},
};

static const struct mip_profile_field cv5_25_absent_sets[] = {
    {0x81, 0, "", &cv5_25_evidence[4]},
    {0x91, 0, "", &cv5_25_evidence[4]},
    {0x92, 0, "", &cv5_25_evidence[4]},
    {0x93, 0, "", &cv5_25_evidence[4]},
};

static const struct mip_profile_reading cv5_25_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cv5_25 = {
    "3dm-cv5-25",
    "3DM-CV5-25",
    "",
    "Attitude and heading reference system.",
    6257, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    90,   /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    cv5_25_also,
    cv5_25_incomplete,
    cv5_25_fields,
    cv5_25_refuses,
    cv5_25_absent_sets,
    NULL,
    NULL,
    cv5_25_readings,
};

/* 3DM-CV7-AHRS. */

static const char *const cv7_ahrs_incomplete[] = {
    "Only some pages of its manual are known; the device has further commands and data.",
};

static const struct mip_profile_evidence cv7_ahrs_evidence[] = {
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and "
     "Specifications).",
     ""},
    {MIP_SUPPORT_YES, "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
     ""},
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS "
     "messages).",
     ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public "
     "program).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (Public programs of users: Program for a 3DM-CV7).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY, "Used by programs for this model (PX4: Driver of the vendor's sensors).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO,
     "Rejected by the device (firmware 1.0.07; ROS driver of the vendor: Issue 257).", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (ROS driver of the vendor: Issue 350).", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
};

static const struct mip_profile_field cv7_ahrs_fields[] = {
    {0x01, 0x01, "", &cv7_ahrs_evidence[5]},       {0x01, 0x02, "", &cv7_ahrs_evidence[5]},
    {0x01, 0x03, "", &cv7_ahrs_evidence[6]},       {0x01, 0x04, "", &cv7_ahrs_evidence[0]},
    {0x01, 0x05, "", &cv7_ahrs_evidence[7]},       {0x01, 0x06, "", &cv7_ahrs_evidence[5]},
    {0x01, 0x07, "", &cv7_ahrs_evidence[0]},       {0x01, 0x08, "", &cv7_ahrs_evidence[10]},
    {0x01, 0x09, "WRSLD", &cv7_ahrs_evidence[0]},  {0x01, 0x72, "WRA", &cv7_ahrs_evidence[10]},
    {0x01, 0x7E, "", &cv7_ahrs_evidence[1]},       {0x0C, 0x0D, "", &cv7_ahrs_evidence[10]},
    {0x0C, 0x0E, "", &cv7_ahrs_evidence[0]},       {0x0C, 0x0F, "WRSLD", &cv7_ahrs_evidence[5]},
    {0x0C, 0x10, "", &cv7_ahrs_evidence[10]},      {0x0C, 0x11, "WRSLD", &cv7_ahrs_evidence[2]},
    {0x0C, 0x28, "WRSLD", &cv7_ahrs_evidence[8]},  {0x0C, 0x2A, "", &cv7_ahrs_evidence[1]},
    {0x0C, 0x2B, "WRSLD", &cv7_ahrs_evidence[5]},  {0x0C, 0x2C, "", &cv7_ahrs_evidence[10]},
    {0x0C, 0x2D, "", &cv7_ahrs_evidence[10]},      {0x0C, 0x2E, "WRSLD", &cv7_ahrs_evidence[3]},
    {0x0C, 0x2F, "WRSLD", &cv7_ahrs_evidence[3]},  {0x0C, 0x30, "SLD", &cv7_ahrs_evidence[5]},
    {0x0C, 0x31, "WRSLD", &cv7_ahrs_evidence[5]},  {0x0C, 0x32, "WRSLD", &cv7_ahrs_evidence[10]},
    {0x0C, 0x33, "WRSLD", &cv7_ahrs_evidence[10]}, {0x0C, 0x37, "WRSLDA", &cv7_ahrs_evidence[10]},
    {0x0C, 0x38, "WRSLD", &cv7_ahrs_evidence[2]},  {0x0C, 0x39, "", &cv7_ahrs_evidence[2]},
    {0x0C, 0x3A, "WRSLD", &cv7_ahrs_evidence[2]},  {0x0C, 0x3B, "WRSLD", &cv7_ahrs_evidence[2]},
    {0x0C, 0x41, "WRSLD", &cv7_ahrs_evidence[3]},  {0x0C, 0x42, "WR", &cv7_ahrs_evidence[10]},
    {0x0C, 0x50, "WRSLD", &cv7_ahrs_evidence[0]},  {0x0C, 0x51, "WRSLD", &cv7_ahrs_evidence[10]},
    {0x0C, 0x52, "WRSLD", &cv7_ahrs_evidence[9]},  {0x0C, 0x53, "", &cv7_ahrs_evidence[10]},
    {0x0C, 0x54, "WRSLD", &cv7_ahrs_evidence[0]},  {0x0D, 0x01, "", &cv7_ahrs_evidence[2]},
    {0x0D, 0x03, "", &cv7_ahrs_evidence[2]},       {0x0D, 0x1A, "WRSLD", &cv7_ahrs_evidence[10]},
    {0x0D, 0x1B, "WRSLD", &cv7_ahrs_evidence[10]}, {0x0D, 0x1D, "WRSLD", &cv7_ahrs_evidence[10]},
    {0x0D, 0x20, "WRSLD", &cv7_ahrs_evidence[10]}, {0x0D, 0x28, "WRSLD", &cv7_ahrs_evidence[10]},
    {0x0D, 0x43, "WRSLD", &cv7_ahrs_evidence[2]},  {0x0D, 0x50, "WRSLD", &cv7_ahrs_evidence[4]},
    {0x0D, 0x53, "WRSLD", &cv7_ahrs_evidence[8]},  {0x13, 0x01, "WRSLD", &cv7_ahrs_evidence[2]},
    {0x13, 0x1F, "WRSLD", &cv7_ahrs_evidence[2]},  {0x13, 0x31, "", &cv7_ahrs_evidence[2]},
    {0x13, 0x32, "", &cv7_ahrs_evidence[2]},       {0x80, 0x04, "", &cv7_ahrs_evidence[2]},
    {0x80, 0x05, "", &cv7_ahrs_evidence[4]},       {0x80, 0x06, "", &cv7_ahrs_evidence[0]},
    {0x80, 0x07, "", &cv7_ahrs_evidence[10]},      {0x80, 0x08, "", &cv7_ahrs_evidence[10]},
    {0x80, 0x09, "", &cv7_ahrs_evidence[10]},      {0x80, 0x0A, "", &cv7_ahrs_evidence[4]},
    {0x80, 0x0C, "", &cv7_ahrs_evidence[1]},       {0x80, 0x14, "", &cv7_ahrs_evidence[10]},
    {0x80, 0x17, "", &cv7_ahrs_evidence[0]},       {0x80, 0x18, "", &cv7_ahrs_evidence[3]},
    {0x82, 0x03, "", &cv7_ahrs_evidence[4]},       {0x82, 0x04, "", &cv7_ahrs_evidence[4]},
    {0x82, 0x05, "", &cv7_ahrs_evidence[4]},       {0x82, 0x06, "", &cv7_ahrs_evidence[2]},
    {0x82, 0x0A, "", &cv7_ahrs_evidence[9]},       {0x82, 0x0B, "", &cv7_ahrs_evidence[10]},
    {0x82, 0x0D, "", &cv7_ahrs_evidence[4]},       {0x82, 0x0E, "", &cv7_ahrs_evidence[4]},
    {0x82, 0x10, "", &cv7_ahrs_evidence[4]},       {0x82, 0x12, "", &cv7_ahrs_evidence[10]},
    {0x82, 0x13, "", &cv7_ahrs_evidence[4]},       {0x82, 0x1C, "", &cv7_ahrs_evidence[0]},
    {0x82, 0x21, "", &cv7_ahrs_evidence[10]},      {0x82, 0x50, "", &cv7_ahrs_evidence[1]},
    {0xA0, 0x01, "", &cv7_ahrs_evidence[10]},      {0xA0, 0x02, "", &cv7_ahrs_evidence[3]},
    {0xA0, 0x03, "", &cv7_ahrs_evidence[10]},      {0xFF, 0xD0, "", &cv7_ahrs_evidence[3]},
    {0xFF, 0xD3, "", &cv7_ahrs_evidence[3]},       {0xFF, 0xD4, "", &cv7_ahrs_evidence[10]},
    {0xFF, 0xD5, "", &cv7_ahrs_evidence[10]},      {0xFF, 0xD6, "", &cv7_ahrs_evidence[10]},
    {0xFF, 0xD7, "", &cv7_ahrs_evidence[10]},      {0xFF, 0xD8, "", &cv7_ahrs_evidence[10]},
};

static const struct mip_profile_field cv7_ahrs_refuses[] = {
    {0x0C, 0x02, "", &cv7_ahrs_evidence[13]}, {0x0C, 0x07, "", &cv7_ahrs_evidence[13]},
    {0x0C, 0x09, "", &cv7_ahrs_evidence[13]}, {0x0C, 0x20, "", &cv7_ahrs_evidence[13]},
    {0x0C, 0x21, "", &cv7_ahrs_evidence[13]}, {0x0C, 0x22, "", &cv7_ahrs_evidence[13]},
    {0x0C, 0x23, "", &cv7_ahrs_evidence[13]}, {0x0C, 0x24, "", &cv7_ahrs_evidence[13]},
    {0x0C, 0x34, "", &cv7_ahrs_evidence[13]}, {0x0C, 0x62, "", &cv7_ahrs_evidence[13]},
    {0x0D, 0x54, "", &cv7_ahrs_evidence[13]}, {0x0D, 0x64, "", &cv7_ahrs_evidence[13]},
    {0x81, 0x03, "", &cv7_ahrs_evidence[11]}, {0x81, 0x0B, "", &cv7_ahrs_evidence[11]},
    {0x82, 0x34, "", &cv7_ahrs_evidence[11]}, {0x82, 0x35, "", &cv7_ahrs_evidence[13]},
    {0x82, 0x43, "", &cv7_ahrs_evidence[11]}, {0x82, 0x49, "", &cv7_ahrs_evidence[12]},
    {0x91, 0x03, "", &cv7_ahrs_evidence[11]}, {0x91, 0x0B, "", &cv7_ahrs_evidence[11]},
    {0x91, 0x12, "", &cv7_ahrs_evidence[12]}, {0x91, 0x14, "", &cv7_ahrs_evidence[12]},
    {0x92, 0x0B, "", &cv7_ahrs_evidence[12]}, {0x92, 0x12, "", &cv7_ahrs_evidence[12]},
    {0x92, 0x14, "", &cv7_ahrs_evidence[12]},
};

static const struct mip_profile_field cv7_ahrs_absent_sets[] = {
    {0x81, 0, "", &cv7_ahrs_evidence[13]},
    {0x91, 0, "", &cv7_ahrs_evidence[13]},
    {0x92, 0, "", &cv7_ahrs_evidence[13]},
    {0x93, 0, "", &cv7_ahrs_evidence[13]},
};

static const struct mip_profile_firmware cv7_ahrs_firmware[] = {
    {0x0C, 0x50, "<= 1.0.07"},
    {0x0C, 0x54, "> 1.0.07"},
};

static const struct mip_profile_rate cv7_ahrs_rates[] = {
    {0x80, 1000},
    {0x82, 1000},
    {0xA0, 1000},
};

static const struct mip_profile_reading cv7_ahrs_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cv7_ahrs = {
    "3dm-cv7-ahrs",
    "3DM-CV7-AHRS",
    "3dm-cv7",
    "Attitude and heading reference system.",
    6286, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    88,   /* fields */
    25,   /* refused fields */
    4,    /* absent sets */
    2,    /* fields of some firmware */
    3,    /* base rates */
    8,    /* readings */
    NULL,
    cv7_ahrs_incomplete,
    cv7_ahrs_fields,
    cv7_ahrs_refuses,
    cv7_ahrs_absent_sets,
    cv7_ahrs_firmware,
    cv7_ahrs_rates,
    cv7_ahrs_readings,
};

/* 3DM-CV7-AR. */

static const char *const cv7_ar_incomplete[] = {
    "Only some pages of its manual are known; the device has further commands and data.",
};

static const struct mip_profile_evidence cv7_ar_evidence[] = {
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and "
     "Specifications).",
     ""},
    {MIP_SUPPORT_YES, "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
     ""},
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS "
     "messages).",
     ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public "
     "program).",
     ""},
    {MIP_SUPPORT_YES, "Listed by the device (MicroStrain Communication Library: Issue 258).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY, "Used by programs for this model (PX4: Driver of the vendor's sensors).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (MicroStrain Communication Library: Issue 258).", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cv7_ar_fields[] = {
    {0x01, 0x01, "", &cv7_ar_evidence[6]},      {0x01, 0x02, "", &cv7_ar_evidence[6]},
    {0x01, 0x03, "", &cv7_ar_evidence[6]},      {0x01, 0x04, "", &cv7_ar_evidence[0]},
    {0x01, 0x05, "", &cv7_ar_evidence[9]},      {0x01, 0x06, "", &cv7_ar_evidence[6]},
    {0x01, 0x07, "", &cv7_ar_evidence[0]},      {0x01, 0x08, "", &cv7_ar_evidence[5]},
    {0x01, 0x09, "WRSLD", &cv7_ar_evidence[0]}, {0x01, 0x72, "WRA", &cv7_ar_evidence[9]},
    {0x01, 0x7E, "", &cv7_ar_evidence[1]},      {0x0C, 0x0D, "", &cv7_ar_evidence[9]},
    {0x0C, 0x0E, "", &cv7_ar_evidence[0]},      {0x0C, 0x0F, "WRSLD", &cv7_ar_evidence[6]},
    {0x0C, 0x10, "", &cv7_ar_evidence[9]},      {0x0C, 0x11, "WRSLD", &cv7_ar_evidence[2]},
    {0x0C, 0x28, "WRSLD", &cv7_ar_evidence[7]}, {0x0C, 0x2A, "", &cv7_ar_evidence[1]},
    {0x0C, 0x2B, "WRSLD", &cv7_ar_evidence[6]}, {0x0C, 0x2C, "", &cv7_ar_evidence[9]},
    {0x0C, 0x2D, "", &cv7_ar_evidence[9]},      {0x0C, 0x2E, "WRSLD", &cv7_ar_evidence[3]},
    {0x0C, 0x2F, "WRSLD", &cv7_ar_evidence[3]}, {0x0C, 0x30, "SLD", &cv7_ar_evidence[6]},
    {0x0C, 0x31, "WRSLD", &cv7_ar_evidence[6]}, {0x0C, 0x32, "WRSLD", &cv7_ar_evidence[9]},
    {0x0C, 0x33, "WRSLD", &cv7_ar_evidence[9]}, {0x0C, 0x37, "WRSLDA", &cv7_ar_evidence[9]},
    {0x0C, 0x38, "WRSLD", &cv7_ar_evidence[2]}, {0x0C, 0x39, "", &cv7_ar_evidence[2]},
    {0x0C, 0x41, "WRSLD", &cv7_ar_evidence[3]}, {0x0C, 0x42, "WR", &cv7_ar_evidence[9]},
    {0x0C, 0x50, "WRSLD", &cv7_ar_evidence[0]}, {0x0C, 0x51, "WRSLD", &cv7_ar_evidence[9]},
    {0x0C, 0x52, "WRSLD", &cv7_ar_evidence[8]}, {0x0C, 0x53, "", &cv7_ar_evidence[9]},
    {0x0C, 0x54, "WRSLD", &cv7_ar_evidence[0]}, {0x0D, 0x01, "", &cv7_ar_evidence[2]},
    {0x0D, 0x03, "", &cv7_ar_evidence[2]},      {0x0D, 0x1A, "WRSLD", &cv7_ar_evidence[9]},
    {0x0D, 0x1B, "WRSLD", &cv7_ar_evidence[9]}, {0x0D, 0x1D, "WRSLD", &cv7_ar_evidence[9]},
    {0x0D, 0x20, "WRSLD", &cv7_ar_evidence[9]}, {0x0D, 0x28, "WRSLD", &cv7_ar_evidence[9]},
    {0x0D, 0x50, "WRSLD", &cv7_ar_evidence[4]}, {0x0D, 0x53, "WRSLD", &cv7_ar_evidence[7]},
    {0x13, 0x01, "WRSLD", &cv7_ar_evidence[2]}, {0x13, 0x1F, "WRSLD", &cv7_ar_evidence[2]},
    {0x13, 0x31, "", &cv7_ar_evidence[2]},      {0x13, 0x32, "", &cv7_ar_evidence[2]},
    {0x80, 0x04, "", &cv7_ar_evidence[2]},      {0x80, 0x05, "", &cv7_ar_evidence[4]},
    {0x80, 0x07, "", &cv7_ar_evidence[9]},      {0x80, 0x08, "", &cv7_ar_evidence[9]},
    {0x80, 0x09, "", &cv7_ar_evidence[9]},      {0x80, 0x0A, "", &cv7_ar_evidence[4]},
    {0x80, 0x0C, "", &cv7_ar_evidence[1]},      {0x80, 0x14, "", &cv7_ar_evidence[9]},
    {0x80, 0x17, "", &cv7_ar_evidence[0]},      {0x80, 0x18, "", &cv7_ar_evidence[3]},
    {0x82, 0x03, "", &cv7_ar_evidence[4]},      {0x82, 0x04, "", &cv7_ar_evidence[4]},
    {0x82, 0x05, "", &cv7_ar_evidence[4]},      {0x82, 0x06, "", &cv7_ar_evidence[2]},
    {0x82, 0x0A, "", &cv7_ar_evidence[8]},      {0x82, 0x0B, "", &cv7_ar_evidence[9]},
    {0x82, 0x0D, "", &cv7_ar_evidence[4]},      {0x82, 0x0E, "", &cv7_ar_evidence[4]},
    {0x82, 0x10, "", &cv7_ar_evidence[4]},      {0x82, 0x12, "", &cv7_ar_evidence[9]},
    {0x82, 0x13, "", &cv7_ar_evidence[4]},      {0x82, 0x1C, "", &cv7_ar_evidence[0]},
    {0x82, 0x21, "", &cv7_ar_evidence[9]},      {0x82, 0x50, "", &cv7_ar_evidence[1]},
    {0xA0, 0x01, "", &cv7_ar_evidence[5]},      {0xA0, 0x02, "", &cv7_ar_evidence[3]},
    {0xA0, 0x03, "", &cv7_ar_evidence[5]},      {0xFF, 0xD0, "", &cv7_ar_evidence[3]},
    {0xFF, 0xD3, "", &cv7_ar_evidence[3]},      {0xFF, 0xD4, "", &cv7_ar_evidence[5]},
    {0xFF, 0xD5, "", &cv7_ar_evidence[5]},      {0xFF, 0xD6, "", &cv7_ar_evidence[5]},
    {0xFF, 0xD7, "", &cv7_ar_evidence[5]},      {0xFF, 0xD8, "", &cv7_ar_evidence[5]},
};

static const struct mip_profile_field cv7_ar_refuses[] = {
    {0x0C, 0x02, "", &cv7_ar_evidence[11]},      {0x0C, 0x07, "", &cv7_ar_evidence[11]},
    {0x0C, 0x09, "", &cv7_ar_evidence[11]},      {0x0C, 0x20, "", &cv7_ar_evidence[11]},
    {0x0C, 0x21, "", &cv7_ar_evidence[11]},      {0x0C, 0x22, "", &cv7_ar_evidence[11]},
    {0x0C, 0x23, "", &cv7_ar_evidence[11]},      {0x0C, 0x24, "", &cv7_ar_evidence[11]},
    {0x0C, 0x34, "", &cv7_ar_evidence[11]},      {0x0C, 0x3A, "", &cv7_ar_evidence[12]},
    {0x0C, 0x3B, "", &cv7_ar_evidence[12]},      {0x0C, 0x62, "", &cv7_ar_evidence[11]},
    {0x0D, 0x19, "WRSLD", &cv7_ar_evidence[10]}, {0x0D, 0x27, "", &cv7_ar_evidence[12]},
    {0x0D, 0x2B, "", &cv7_ar_evidence[12]},      {0x0D, 0x2C, "", &cv7_ar_evidence[12]},
    {0x0D, 0x42, "", &cv7_ar_evidence[12]},      {0x0D, 0x43, "", &cv7_ar_evidence[12]},
    {0x0D, 0x44, "WRSLD", &cv7_ar_evidence[10]}, {0x0D, 0x45, "", &cv7_ar_evidence[12]},
    {0x0D, 0x46, "", &cv7_ar_evidence[12]},      {0x0D, 0x4B, "WRSLD", &cv7_ar_evidence[10]},
    {0x0D, 0x4C, "", &cv7_ar_evidence[12]},      {0x0D, 0x4D, "", &cv7_ar_evidence[12]},
    {0x0D, 0x54, "", &cv7_ar_evidence[11]},      {0x0D, 0x64, "", &cv7_ar_evidence[11]},
    {0x80, 0x03, "", &cv7_ar_evidence[12]},      {0x80, 0x06, "", &cv7_ar_evidence[12]},
    {0x82, 0x1A, "", &cv7_ar_evidence[12]},      {0x82, 0x1B, "", &cv7_ar_evidence[12]},
    {0x82, 0x25, "", &cv7_ar_evidence[12]},      {0x82, 0x26, "", &cv7_ar_evidence[12]},
    {0x82, 0x28, "", &cv7_ar_evidence[12]},      {0x82, 0x29, "", &cv7_ar_evidence[12]},
    {0x82, 0x2A, "", &cv7_ar_evidence[12]},      {0x82, 0x2C, "", &cv7_ar_evidence[12]},
    {0x82, 0x34, "", &cv7_ar_evidence[11]},      {0x82, 0x35, "", &cv7_ar_evidence[11]},
    {0x82, 0x49, "", &cv7_ar_evidence[13]},
};

static const struct mip_profile_field cv7_ar_absent_sets[] = {
    {0x81, 0, "", &cv7_ar_evidence[11]},
    {0x91, 0, "", &cv7_ar_evidence[11]},
    {0x92, 0, "", &cv7_ar_evidence[11]},
    {0x93, 0, "", &cv7_ar_evidence[11]},
};

static const struct mip_profile_firmware cv7_ar_firmware[] = {
    {0x0C, 0x50, "<= 1.0.07"},
    {0x0C, 0x54, "> 1.0.07"},
};

static const struct mip_profile_rate cv7_ar_rates[] = {
    {0x80, 1000},
    {0x82, 1000},
    {0xA0, 1000},
};

static const struct mip_profile_reading cv7_ar_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cv7_ar = {
    "3dm-cv7-ar",
    "3DM-CV7-AR",
    "3dm-cv7",
    "Attitude reference.",
    6287, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    84,   /* fields */
    39,   /* refused fields */
    4,    /* absent sets */
    2,    /* fields of some firmware */
    3,    /* base rates */
    8,    /* readings */
    NULL,
    cv7_ar_incomplete,
    cv7_ar_fields,
    cv7_ar_refuses,
    cv7_ar_absent_sets,
    cv7_ar_firmware,
    cv7_ar_rates,
    cv7_ar_readings,
};

/* 3DM-CV7-GNSS/INS. */

static const struct mip_profile_evidence cv7_gnss_ins_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
};

static const struct mip_profile_field cv7_gnss_ins_fields[] = {
    {0x01, 0x01, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x02, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x04, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x06, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x07, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x08, "", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x09, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x72, "W", &cv7_gnss_ins_evidence[0]},
    {0x01, 0x7E, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x04, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x0C, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x0D, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x0E, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x0F, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x10, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x11, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x22, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x28, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x2A, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x2B, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x2C, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x2D, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x2E, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x2F, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x30, "SLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x31, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x32, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x33, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x37, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x38, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x39, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x3A, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x3B, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x40, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x41, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x42, "WR", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x43, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x50, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x51, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x52, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x53, "", &cv7_gnss_ins_evidence[0]},
    {0x0C, 0x54, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x01, "", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x13, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x15, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x17, "", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x1A, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x1B, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x1C, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x1D, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x1F, "", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x20, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x28, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x43, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x50, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x52, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x53, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x54, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x55, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x56, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x61, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x63, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0D, 0x64, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0E, 0x01, "", &cv7_gnss_ins_evidence[0]},
    {0x0E, 0x02, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x0E, 0x20, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x01, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x1F, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x21, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x22, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x23, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x28, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x29, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x2A, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x31, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x32, "", &cv7_gnss_ins_evidence[0]},
    {0x13, 0x33, "", &cv7_gnss_ins_evidence[0]},
    {0x7F, 0x02, "WRSLD", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x04, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x06, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x07, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x08, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x09, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x0A, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x0C, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x12, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x14, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x17, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x18, "", &cv7_gnss_ins_evidence[0]},
    {0x80, 0x40, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x01, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x02, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x04, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x06, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x07, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x08, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x09, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x0A, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x0B, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x0C, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x0D, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x0E, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x10, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x11, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x12, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x13, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x15, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x1C, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x21, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x34, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x35, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x36, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x37, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x40, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x41, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x42, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x43, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x46, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x47, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x48, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x49, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x50, "", &cv7_gnss_ins_evidence[0]},
    {0x82, 0x51, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x04, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x06, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x07, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x08, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x09, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x0B, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x0D, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x10, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x11, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x12, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x20, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x22, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x61, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x62, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x63, "", &cv7_gnss_ins_evidence[0]},
    {0x91, 0x64, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x04, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x06, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x07, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x08, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x09, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x0B, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x0D, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x10, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x11, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x12, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x20, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x22, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x61, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x62, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x63, "", &cv7_gnss_ins_evidence[0]},
    {0x92, 0x64, "", &cv7_gnss_ins_evidence[0]},
    {0x93, 0x30, "", &cv7_gnss_ins_evidence[0]},
    {0x93, 0x31, "", &cv7_gnss_ins_evidence[0]},
    {0x94, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0x94, 0x05, "", &cv7_gnss_ins_evidence[0]},
    {0x94, 0x08, "", &cv7_gnss_ins_evidence[0]},
    {0x94, 0x0B, "", &cv7_gnss_ins_evidence[0]},
    {0x94, 0x20, "", &cv7_gnss_ins_evidence[0]},
    {0xA0, 0x01, "", &cv7_gnss_ins_evidence[0]},
    {0xA0, 0x02, "", &cv7_gnss_ins_evidence[0]},
    {0xA0, 0x03, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD0, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD3, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD4, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD5, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD6, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD7, "", &cv7_gnss_ins_evidence[0]},
    {0xFF, 0xD8, "", &cv7_gnss_ins_evidence[0]},
};

static const struct mip_profile_rate cv7_gnss_ins_rates[] = {
    {0x80, 1000}, {0x82, 1000}, {0x91, 5}, {0x92, 5}, {0x93, 0}, {0x94, 0}, {0xA0, 1000},
};

static const struct mip_profile_reading cv7_gnss_ins_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cv7_gnss_ins = {
    "3dm-cv7-gnss-ins",
    "3DM-CV7-GNSS/INS",
    "3dm-cv7-gnss-ins",
    "Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure "
    "sensor.",
    6292, /* model number */
    7,    /* generation */
    0,    /* other names */
    0,    /* what is not known */
    183,  /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    0,    /* fields of some firmware */
    7,    /* base rates */
    8,    /* readings */
    NULL,
    NULL,
    cv7_gnss_ins_fields,
    NULL,
    NULL,
    NULL,
    cv7_gnss_ins_rates,
    cv7_gnss_ins_readings,
};

/* 3DM-CV7-INS. */

static const char *const cv7_ins_incomplete[] = {
    "Only some pages of its manual are known; the device has further commands and data.",
    "It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF.",
};

static const struct mip_profile_evidence cv7_ins_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_YES, "Documented (MicroStrain 3DM-CV7-INS Documentation: Field pages).", ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-CV7-INS Documentation: Index of the set 0x94, on a test site).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY, "Used by programs for this model (PX4: Driver of the vendor's sensors).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (Public programs of users: Notes on a 3DM-CV7-INS, 2026).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cv7_ins_fields[] = {
    {0x01, 0x01, "", &cv7_ins_evidence[3]},       {0x01, 0x02, "", &cv7_ins_evidence[3]},
    {0x01, 0x03, "", &cv7_ins_evidence[3]},       {0x01, 0x04, "", &cv7_ins_evidence[5]},
    {0x01, 0x05, "", &cv7_ins_evidence[9]},       {0x01, 0x06, "", &cv7_ins_evidence[3]},
    {0x01, 0x07, "", &cv7_ins_evidence[5]},       {0x01, 0x08, "", &cv7_ins_evidence[9]},
    {0x01, 0x09, "WRSLD", &cv7_ins_evidence[6]},  {0x01, 0x72, "WRA", &cv7_ins_evidence[9]},
    {0x01, 0x7E, "", &cv7_ins_evidence[9]},       {0x0C, 0x04, "", &cv7_ins_evidence[9]},
    {0x0C, 0x0C, "WRSLD", &cv7_ins_evidence[9]},  {0x0C, 0x0D, "", &cv7_ins_evidence[9]},
    {0x0C, 0x0E, "", &cv7_ins_evidence[3]},       {0x0C, 0x0F, "WRSLD", &cv7_ins_evidence[3]},
    {0x0C, 0x10, "", &cv7_ins_evidence[9]},       {0x0C, 0x11, "WRSLD", &cv7_ins_evidence[5]},
    {0x0C, 0x28, "WRSLD", &cv7_ins_evidence[6]},  {0x0C, 0x2A, "", &cv7_ins_evidence[9]},
    {0x0C, 0x2B, "WRSLD", &cv7_ins_evidence[9]},  {0x0C, 0x2C, "", &cv7_ins_evidence[9]},
    {0x0C, 0x2D, "", &cv7_ins_evidence[9]},       {0x0C, 0x2E, "WRSLD", &cv7_ins_evidence[9]},
    {0x0C, 0x2F, "WRSLD", &cv7_ins_evidence[9]},  {0x0C, 0x30, "SLD", &cv7_ins_evidence[3]},
    {0x0C, 0x31, "WRSLD", &cv7_ins_evidence[5]},  {0x0C, 0x32, "WRSLD", &cv7_ins_evidence[9]},
    {0x0C, 0x33, "WRSLD", &cv7_ins_evidence[9]},  {0x0C, 0x37, "WRSLDA", &cv7_ins_evidence[9]},
    {0x0C, 0x38, "WRSLDA", &cv7_ins_evidence[9]}, {0x0C, 0x39, "", &cv7_ins_evidence[3]},
    {0x0C, 0x3A, "WRSLDA", &cv7_ins_evidence[9]}, {0x0C, 0x3B, "WRSLDA", &cv7_ins_evidence[9]},
    {0x0C, 0x41, "WRSLD", &cv7_ins_evidence[6]},  {0x0C, 0x42, "WR", &cv7_ins_evidence[6]},
    {0x0C, 0x50, "WRSLD", &cv7_ins_evidence[9]},  {0x0C, 0x51, "WRSLD", &cv7_ins_evidence[9]},
    {0x0C, 0x52, "WRSLD", &cv7_ins_evidence[5]},  {0x0C, 0x53, "", &cv7_ins_evidence[9]},
    {0x0C, 0x54, "WRSLD", &cv7_ins_evidence[9]},  {0x0D, 0x01, "", &cv7_ins_evidence[3]},
    {0x0D, 0x03, "", &cv7_ins_evidence[9]},       {0x0D, 0x05, "", &cv7_ins_evidence[9]},
    {0x0D, 0x13, "WRSLD", &cv7_ins_evidence[0]},  {0x0D, 0x15, "WRSLD", &cv7_ins_evidence[5]},
    {0x0D, 0x17, "", &cv7_ins_evidence[9]},       {0x0D, 0x1A, "WRSLD", &cv7_ins_evidence[9]},
    {0x0D, 0x1B, "WRSLD", &cv7_ins_evidence[9]},  {0x0D, 0x1C, "WRSLD", &cv7_ins_evidence[9]},
    {0x0D, 0x1D, "WRSLD", &cv7_ins_evidence[9]},  {0x0D, 0x1F, "", &cv7_ins_evidence[9]},
    {0x0D, 0x20, "WRSLD", &cv7_ins_evidence[0]},  {0x0D, 0x28, "WRSLD", &cv7_ins_evidence[9]},
    {0x0D, 0x43, "WRSLD", &cv7_ins_evidence[6]},  {0x0D, 0x50, "WRSLD", &cv7_ins_evidence[3]},
    {0x0D, 0x52, "WRSLD", &cv7_ins_evidence[1]},  {0x0D, 0x53, "WRSLD", &cv7_ins_evidence[7]},
    {0x0D, 0x55, "WRSLD", &cv7_ins_evidence[6]},  {0x0D, 0x56, "WRSLD", &cv7_ins_evidence[9]},
    {0x13, 0x01, "WRSLD", &cv7_ins_evidence[1]},  {0x13, 0x1F, "WRSLD", &cv7_ins_evidence[9]},
    {0x13, 0x21, "", &cv7_ins_evidence[9]},       {0x13, 0x22, "", &cv7_ins_evidence[3]},
    {0x13, 0x23, "", &cv7_ins_evidence[9]},       {0x13, 0x28, "", &cv7_ins_evidence[9]},
    {0x13, 0x29, "", &cv7_ins_evidence[3]},       {0x13, 0x2A, "", &cv7_ins_evidence[3]},
    {0x13, 0x31, "", &cv7_ins_evidence[3]},       {0x13, 0x32, "", &cv7_ins_evidence[9]},
    {0x13, 0x33, "", &cv7_ins_evidence[9]},       {0x80, 0x04, "", &cv7_ins_evidence[8]},
    {0x80, 0x05, "", &cv7_ins_evidence[8]},       {0x80, 0x06, "", &cv7_ins_evidence[5]},
    {0x80, 0x07, "", &cv7_ins_evidence[9]},       {0x80, 0x08, "", &cv7_ins_evidence[9]},
    {0x80, 0x09, "", &cv7_ins_evidence[9]},       {0x80, 0x0A, "", &cv7_ins_evidence[9]},
    {0x80, 0x0C, "", &cv7_ins_evidence[9]},       {0x80, 0x14, "", &cv7_ins_evidence[9]},
    {0x80, 0x17, "", &cv7_ins_evidence[5]},       {0x80, 0x18, "", &cv7_ins_evidence[9]},
    {0x82, 0x01, "", &cv7_ins_evidence[4]},       {0x82, 0x02, "", &cv7_ins_evidence[4]},
    {0x82, 0x03, "", &cv7_ins_evidence[5]},       {0x82, 0x04, "", &cv7_ins_evidence[9]},
    {0x82, 0x05, "", &cv7_ins_evidence[4]},       {0x82, 0x06, "", &cv7_ins_evidence[9]},
    {0x82, 0x07, "", &cv7_ins_evidence[9]},       {0x82, 0x08, "", &cv7_ins_evidence[5]},
    {0x82, 0x09, "", &cv7_ins_evidence[5]},       {0x82, 0x0A, "", &cv7_ins_evidence[5]},
    {0x82, 0x0B, "", &cv7_ins_evidence[9]},       {0x82, 0x0C, "", &cv7_ins_evidence[9]},
    {0x82, 0x0D, "", &cv7_ins_evidence[5]},       {0x82, 0x0E, "", &cv7_ins_evidence[5]},
    {0x82, 0x10, "", &cv7_ins_evidence[4]},       {0x82, 0x12, "", &cv7_ins_evidence[9]},
    {0x82, 0x13, "", &cv7_ins_evidence[9]},       {0x82, 0x15, "", &cv7_ins_evidence[9]},
    {0x82, 0x1C, "", &cv7_ins_evidence[9]},       {0x82, 0x21, "", &cv7_ins_evidence[9]},
    {0x82, 0x36, "", &cv7_ins_evidence[6]},       {0x82, 0x37, "", &cv7_ins_evidence[9]},
    {0x82, 0x40, "", &cv7_ins_evidence[6]},       {0x82, 0x41, "", &cv7_ins_evidence[9]},
    {0x82, 0x42, "", &cv7_ins_evidence[6]},       {0x82, 0x43, "", &cv7_ins_evidence[9]},
    {0x82, 0x46, "", &cv7_ins_evidence[6]},       {0x82, 0x50, "", &cv7_ins_evidence[1]},
    {0x82, 0x51, "", &cv7_ins_evidence[9]},       {0x94, 0x03, "", &cv7_ins_evidence[2]},
    {0x94, 0x04, "", &cv7_ins_evidence[2]},       {0x94, 0x05, "", &cv7_ins_evidence[2]},
    {0x94, 0x06, "", &cv7_ins_evidence[2]},       {0x94, 0x07, "", &cv7_ins_evidence[2]},
    {0x94, 0x08, "", &cv7_ins_evidence[2]},       {0x94, 0x0B, "", &cv7_ins_evidence[2]},
    {0x94, 0x10, "", &cv7_ins_evidence[2]},       {0x94, 0x11, "", &cv7_ins_evidence[2]},
    {0x94, 0x14, "", &cv7_ins_evidence[2]},       {0x94, 0x20, "", &cv7_ins_evidence[2]},
    {0xA0, 0x01, "", &cv7_ins_evidence[9]},       {0xA0, 0x02, "", &cv7_ins_evidence[4]},
    {0xA0, 0x03, "", &cv7_ins_evidence[9]},       {0xFF, 0xD0, "", &cv7_ins_evidence[9]},
    {0xFF, 0xD3, "", &cv7_ins_evidence[4]},       {0xFF, 0xD4, "", &cv7_ins_evidence[9]},
    {0xFF, 0xD5, "", &cv7_ins_evidence[9]},       {0xFF, 0xD6, "", &cv7_ins_evidence[9]},
    {0xFF, 0xD7, "", &cv7_ins_evidence[9]},       {0xFF, 0xD8, "", &cv7_ins_evidence[9]},
};

static const struct mip_profile_field cv7_ins_refuses[] = {
    {0x0C, 0x02, "", &cv7_ins_evidence[10]}, {0x0C, 0x07, "", &cv7_ins_evidence[10]},
    {0x0C, 0x09, "", &cv7_ins_evidence[10]}, {0x0C, 0x20, "", &cv7_ins_evidence[10]},
    {0x0C, 0x21, "", &cv7_ins_evidence[10]}, {0x0C, 0x22, "", &cv7_ins_evidence[10]},
    {0x0C, 0x23, "", &cv7_ins_evidence[10]}, {0x0C, 0x24, "", &cv7_ins_evidence[10]},
    {0x0C, 0x34, "", &cv7_ins_evidence[10]}, {0x0C, 0x62, "", &cv7_ins_evidence[10]},
    {0x0D, 0x54, "", &cv7_ins_evidence[10]}, {0x0D, 0x64, "", &cv7_ins_evidence[10]},
    {0x82, 0x34, "", &cv7_ins_evidence[10]}, {0x82, 0x35, "", &cv7_ins_evidence[10]},
    {0x82, 0x49, "", &cv7_ins_evidence[11]},
};

static const struct mip_profile_field cv7_ins_absent_sets[] = {
    {0x81, 0, "", &cv7_ins_evidence[10]},
    {0x91, 0, "", &cv7_ins_evidence[10]},
    {0x92, 0, "", &cv7_ins_evidence[10]},
    {0x93, 0, "", &cv7_ins_evidence[10]},
};

static const struct mip_profile_rate cv7_ins_rates[] = {
    {0x94, 0},
};

static const struct mip_profile_reading cv7_ins_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cv7_ins = {
    "3dm-cv7-ins",
    "3DM-CV7-INS",
    "3dm-cv7-ins",
    "Inertial navigation system without an internal GNSS receiver.",
    6291, /* model number */
    7,    /* generation */
    0,    /* other names */
    2,    /* what is not known */
    132,  /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    1,    /* base rates */
    8,    /* readings */
    NULL,
    cv7_ins_incomplete,
    cv7_ins_fields,
    cv7_ins_refuses,
    cv7_ins_absent_sets,
    NULL,
    cv7_ins_rates,
    cv7_ins_readings,
};

/* 3DM-CX5-10. */

static const char *const cx5_10_also[] = {
    "3DM-CX5-IMU",
};

static const char *const cx5_10_incomplete[] = {
    "Of the manual, only the table of contents is known, up to the set `3dm`. It lists only the "
    "sets `base`, `3dm` and `sensor`.",
};

static const struct mip_profile_evidence cx5_10_evidence[] = {
    {MIP_SUPPORT_YES, "Documented (3DM-CX5-10 Data Communications Protocol Manual: Contents).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-CX5-10.", ""},
    {MIP_SUPPORT_NO, "Not in the manual, whose list of the set is complete.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires a pressure sensor, which the device lacks.",
     "has no pressure sensor"},
};

static const struct mip_profile_field cx5_10_fields[] = {
    {0x01, 0x01, "", &cx5_10_evidence[0]},       {0x01, 0x02, "", &cx5_10_evidence[0]},
    {0x01, 0x03, "", &cx5_10_evidence[0]},       {0x01, 0x04, "", &cx5_10_evidence[0]},
    {0x01, 0x05, "", &cx5_10_evidence[0]},       {0x01, 0x06, "", &cx5_10_evidence[0]},
    {0x01, 0x72, "WRA", &cx5_10_evidence[0]},    {0x01, 0x7E, "", &cx5_10_evidence[0]},
    {0x0C, 0x01, "", &cx5_10_evidence[0]},       {0x0C, 0x06, "", &cx5_10_evidence[0]},
    {0x0C, 0x08, "WRSLD", &cx5_10_evidence[0]},  {0x0C, 0x11, "WRSLD", &cx5_10_evidence[0]},
    {0x0C, 0x30, "SLD", &cx5_10_evidence[1]},    {0x0C, 0x37, "WRSLDA", &cx5_10_evidence[2]},
    {0x0C, 0x38, "WRSLDA", &cx5_10_evidence[2]}, {0x0C, 0x39, "", &cx5_10_evidence[2]},
    {0x0C, 0x3E, "WRSLD", &cx5_10_evidence[2]},  {0x0C, 0x40, "WRSLD", &cx5_10_evidence[2]},
    {0x0C, 0x50, "WRSLD", &cx5_10_evidence[2]},  {0x0C, 0x51, "WRSLD", &cx5_10_evidence[2]},
    {0x0C, 0x64, "", &cx5_10_evidence[2]},       {0x80, 0x04, "", &cx5_10_evidence[1]},
    {0x80, 0x05, "", &cx5_10_evidence[1]},       {0x80, 0x07, "", &cx5_10_evidence[2]},
    {0x80, 0x08, "", &cx5_10_evidence[2]},       {0x80, 0x12, "", &cx5_10_evidence[2]},
};

static const struct mip_profile_field cx5_10_refuses[] = {
    {0x01, 0x07, "", &cx5_10_evidence[3]}, {0x01, 0x08, "", &cx5_10_evidence[3]},
    {0x01, 0x09, "", &cx5_10_evidence[3]}, {0x0C, 0x02, "", &cx5_10_evidence[4]},
    {0x0C, 0x07, "", &cx5_10_evidence[4]}, {0x0C, 0x09, "", &cx5_10_evidence[4]},
    {0x0C, 0x20, "", &cx5_10_evidence[4]}, {0x0C, 0x21, "", &cx5_10_evidence[4]},
    {0x0C, 0x22, "", &cx5_10_evidence[4]}, {0x0C, 0x23, "", &cx5_10_evidence[4]},
    {0x0C, 0x24, "", &cx5_10_evidence[4]}, {0x0C, 0x34, "", &cx5_10_evidence[4]},
    {0x0C, 0x3A, "", &cx5_10_evidence[5]}, {0x0C, 0x3B, "", &cx5_10_evidence[5]},
    {0x0C, 0x62, "", &cx5_10_evidence[4]}, {0x80, 0x03, "", &cx5_10_evidence[5]},
    {0x80, 0x06, "", &cx5_10_evidence[5]}, {0x80, 0x16, "", &cx5_10_evidence[6]},
    {0x80, 0x17, "", &cx5_10_evidence[6]},
};

static const struct mip_profile_field cx5_10_absent_sets[] = {
    {0x81, 0, "", &cx5_10_evidence[4]},
    {0x91, 0, "", &cx5_10_evidence[4]},
    {0x92, 0, "", &cx5_10_evidence[4]},
    {0x93, 0, "", &cx5_10_evidence[4]},
};

static const struct mip_profile_reading cx5_10_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cx5_10 = {
    "3dm-cx5-10",
    "3DM-CX5-10",
    "3dm-cx5-10",
    "Inertial measurement unit.",
    6275, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    26,   /* fields */
    19,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    cx5_10_also,
    cx5_10_incomplete,
    cx5_10_fields,
    cx5_10_refuses,
    cx5_10_absent_sets,
    NULL,
    NULL,
    cx5_10_readings,
};

/* 3DM-CX5-15. */

static const char *const cx5_15_also[] = {
    "3DM-CX5-AR",
};

static const char *const cx5_15_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence cx5_15_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cx5_15_fields[] = {
    {0x01, 0x01, "", &cx5_15_evidence[0]},       {0x01, 0x02, "", &cx5_15_evidence[0]},
    {0x01, 0x03, "", &cx5_15_evidence[1]},       {0x01, 0x04, "", &cx5_15_evidence[2]},
    {0x01, 0x05, "", &cx5_15_evidence[3]},       {0x01, 0x06, "", &cx5_15_evidence[0]},
    {0x01, 0x07, "", &cx5_15_evidence[2]},       {0x01, 0x72, "WRA", &cx5_15_evidence[3]},
    {0x01, 0x7E, "", &cx5_15_evidence[3]},       {0x0C, 0x01, "", &cx5_15_evidence[3]},
    {0x0C, 0x03, "", &cx5_15_evidence[3]},       {0x0C, 0x06, "", &cx5_15_evidence[0]},
    {0x0C, 0x08, "WRSLD", &cx5_15_evidence[0]},  {0x0C, 0x0A, "WRSLD", &cx5_15_evidence[0]},
    {0x0C, 0x0B, "", &cx5_15_evidence[0]},       {0x0C, 0x11, "WRSLD", &cx5_15_evidence[3]},
    {0x0C, 0x30, "SLD", &cx5_15_evidence[0]},    {0x0C, 0x37, "WRSLDA", &cx5_15_evidence[3]},
    {0x0C, 0x38, "WRSLDA", &cx5_15_evidence[3]}, {0x0C, 0x39, "", &cx5_15_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &cx5_15_evidence[3]},  {0x0C, 0x40, "WRSLD", &cx5_15_evidence[3]},
    {0x0C, 0x50, "WRSLD", &cx5_15_evidence[3]},  {0x0C, 0x51, "WRSLD", &cx5_15_evidence[3]},
    {0x0C, 0x64, "", &cx5_15_evidence[3]},       {0x0D, 0x01, "", &cx5_15_evidence[1]},
    {0x0D, 0x02, "", &cx5_15_evidence[3]},       {0x0D, 0x03, "", &cx5_15_evidence[3]},
    {0x0D, 0x11, "WRSLD", &cx5_15_evidence[0]},  {0x0D, 0x14, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x17, "", &cx5_15_evidence[3]},       {0x0D, 0x18, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x19, "WRSLD", &cx5_15_evidence[0]},  {0x0D, 0x1A, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x1B, "WRSLD", &cx5_15_evidence[3]},  {0x0D, 0x1D, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x1F, "", &cx5_15_evidence[3]},       {0x0D, 0x20, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x21, "WRSLD", &cx5_15_evidence[3]},  {0x0D, 0x23, "", &cx5_15_evidence[3]},
    {0x0D, 0x26, "WRSLD", &cx5_15_evidence[3]},  {0x0D, 0x28, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x41, "WRSLD", &cx5_15_evidence[3]},  {0x0D, 0x44, "WRSLD", &cx5_15_evidence[3]},
    {0x0D, 0x4B, "WRSLD", &cx5_15_evidence[3]},  {0x7F, 0x10, "WRSLD", &cx5_15_evidence[3]},
    {0x80, 0x04, "", &cx5_15_evidence[0]},       {0x80, 0x05, "", &cx5_15_evidence[0]},
    {0x80, 0x07, "", &cx5_15_evidence[3]},       {0x80, 0x08, "", &cx5_15_evidence[3]},
    {0x80, 0x09, "", &cx5_15_evidence[3]},       {0x80, 0x0A, "", &cx5_15_evidence[3]},
    {0x80, 0x0C, "", &cx5_15_evidence[3]},       {0x80, 0x10, "", &cx5_15_evidence[3]},
    {0x80, 0x11, "", &cx5_15_evidence[3]},       {0x80, 0x12, "", &cx5_15_evidence[0]},
    {0x80, 0x17, "", &cx5_15_evidence[3]},       {0x82, 0x03, "", &cx5_15_evidence[3]},
    {0x82, 0x04, "", &cx5_15_evidence[3]},       {0x82, 0x05, "", &cx5_15_evidence[0]},
    {0x82, 0x06, "", &cx5_15_evidence[3]},       {0x82, 0x0A, "", &cx5_15_evidence[3]},
    {0x82, 0x0B, "", &cx5_15_evidence[3]},       {0x82, 0x0D, "", &cx5_15_evidence[3]},
    {0x82, 0x0E, "", &cx5_15_evidence[0]},       {0x82, 0x0F, "", &cx5_15_evidence[3]},
    {0x82, 0x10, "", &cx5_15_evidence[0]},       {0x82, 0x11, "", &cx5_15_evidence[0]},
    {0x82, 0x12, "", &cx5_15_evidence[3]},       {0x82, 0x13, "", &cx5_15_evidence[3]},
    {0x82, 0x14, "", &cx5_15_evidence[3]},       {0x82, 0x1C, "", &cx5_15_evidence[0]},
    {0x82, 0x21, "", &cx5_15_evidence[3]},
};

static const struct mip_profile_field cx5_15_refuses[] = {
    {0x0C, 0x02, "", &cx5_15_evidence[4]}, {0x0C, 0x07, "", &cx5_15_evidence[4]},
    {0x0C, 0x09, "", &cx5_15_evidence[4]}, {0x0C, 0x20, "", &cx5_15_evidence[4]},
    {0x0C, 0x21, "", &cx5_15_evidence[4]}, {0x0C, 0x22, "", &cx5_15_evidence[4]},
    {0x0C, 0x23, "", &cx5_15_evidence[4]}, {0x0C, 0x24, "", &cx5_15_evidence[4]},
    {0x0C, 0x34, "", &cx5_15_evidence[4]}, {0x0C, 0x3A, "", &cx5_15_evidence[5]},
    {0x0C, 0x3B, "", &cx5_15_evidence[5]}, {0x0C, 0x62, "", &cx5_15_evidence[4]},
    {0x0D, 0x27, "", &cx5_15_evidence[5]}, {0x0D, 0x2B, "", &cx5_15_evidence[5]},
    {0x0D, 0x2C, "", &cx5_15_evidence[5]}, {0x0D, 0x42, "", &cx5_15_evidence[5]},
    {0x0D, 0x43, "", &cx5_15_evidence[5]}, {0x0D, 0x45, "", &cx5_15_evidence[5]},
    {0x0D, 0x46, "", &cx5_15_evidence[5]}, {0x0D, 0x4C, "", &cx5_15_evidence[5]},
    {0x0D, 0x4D, "", &cx5_15_evidence[5]}, {0x0D, 0x54, "", &cx5_15_evidence[4]},
    {0x0D, 0x64, "", &cx5_15_evidence[4]}, {0x80, 0x03, "", &cx5_15_evidence[5]},
    {0x80, 0x06, "", &cx5_15_evidence[5]}, {0x82, 0x1A, "", &cx5_15_evidence[5]},
    {0x82, 0x1B, "", &cx5_15_evidence[5]}, {0x82, 0x25, "", &cx5_15_evidence[5]},
    {0x82, 0x26, "", &cx5_15_evidence[5]}, {0x82, 0x28, "", &cx5_15_evidence[5]},
    {0x82, 0x29, "", &cx5_15_evidence[5]}, {0x82, 0x2A, "", &cx5_15_evidence[5]},
    {0x82, 0x2C, "", &cx5_15_evidence[5]}, {0x82, 0x34, "", &cx5_15_evidence[4]},
    {0x82, 0x35, "", &cx5_15_evidence[4]}, {0x82, 0x49, "", &cx5_15_evidence[6]},
};

static const struct mip_profile_field cx5_15_absent_sets[] = {
    {0x81, 0, "", &cx5_15_evidence[4]},
    {0x91, 0, "", &cx5_15_evidence[4]},
    {0x92, 0, "", &cx5_15_evidence[4]},
    {0x93, 0, "", &cx5_15_evidence[4]},
};

static const struct mip_profile_reading cx5_15_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cx5_15 = {
    "3dm-cx5-15",
    "3DM-CX5-15",
    "",
    "Attitude reference.",
    6274, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    73,   /* fields */
    36,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    cx5_15_also,
    cx5_15_incomplete,
    cx5_15_fields,
    cx5_15_refuses,
    cx5_15_absent_sets,
    NULL,
    NULL,
    cx5_15_readings,
};

/* 3DM-CX5-25. */

static const char *const cx5_25_also[] = {
    "3DM-CX5-AHRS",
};

static const char *const cx5_25_incomplete[] = {
    "Of the manual, only the title is known. It has 149 pages.",
};

static const struct mip_profile_evidence cx5_25_evidence[] = {
    {MIP_SUPPORT_YES, "Documented (3DM-CX5-25 Data Communications Protocol Manual: Title).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cx5_25_fields[] = {
    {0x01, 0x01, "", &cx5_25_evidence[1]},       {0x01, 0x02, "", &cx5_25_evidence[1]},
    {0x01, 0x03, "", &cx5_25_evidence[2]},       {0x01, 0x04, "", &cx5_25_evidence[3]},
    {0x01, 0x05, "", &cx5_25_evidence[4]},       {0x01, 0x06, "", &cx5_25_evidence[1]},
    {0x01, 0x07, "", &cx5_25_evidence[3]},       {0x01, 0x72, "WRA", &cx5_25_evidence[4]},
    {0x01, 0x7E, "", &cx5_25_evidence[4]},       {0x0C, 0x01, "", &cx5_25_evidence[4]},
    {0x0C, 0x03, "", &cx5_25_evidence[4]},       {0x0C, 0x06, "", &cx5_25_evidence[1]},
    {0x0C, 0x08, "WRSLD", &cx5_25_evidence[1]},  {0x0C, 0x0A, "WRSLD", &cx5_25_evidence[1]},
    {0x0C, 0x0B, "", &cx5_25_evidence[1]},       {0x0C, 0x11, "WRSLD", &cx5_25_evidence[4]},
    {0x0C, 0x30, "SLD", &cx5_25_evidence[1]},    {0x0C, 0x37, "WRSLDA", &cx5_25_evidence[4]},
    {0x0C, 0x38, "WRSLDA", &cx5_25_evidence[4]}, {0x0C, 0x39, "", &cx5_25_evidence[1]},
    {0x0C, 0x3A, "WRSLDA", &cx5_25_evidence[4]}, {0x0C, 0x3B, "WRSLDA", &cx5_25_evidence[4]},
    {0x0C, 0x3E, "WRSLD", &cx5_25_evidence[4]},  {0x0C, 0x40, "WRSLD", &cx5_25_evidence[4]},
    {0x0C, 0x50, "WRSLD", &cx5_25_evidence[4]},  {0x0C, 0x51, "WRSLD", &cx5_25_evidence[4]},
    {0x0C, 0x64, "", &cx5_25_evidence[4]},       {0x0D, 0x01, "", &cx5_25_evidence[2]},
    {0x0D, 0x02, "", &cx5_25_evidence[4]},       {0x0D, 0x03, "", &cx5_25_evidence[4]},
    {0x0D, 0x11, "WRSLD", &cx5_25_evidence[1]},  {0x0D, 0x14, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x17, "", &cx5_25_evidence[4]},       {0x0D, 0x18, "WRSLD", &cx5_25_evidence[2]},
    {0x0D, 0x19, "WRSLD", &cx5_25_evidence[1]},  {0x0D, 0x1A, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x1B, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x1D, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x1F, "", &cx5_25_evidence[4]},       {0x0D, 0x20, "WRSLD", &cx5_25_evidence[0]},
    {0x0D, 0x21, "WRSLD", &cx5_25_evidence[0]},  {0x0D, 0x23, "", &cx5_25_evidence[4]},
    {0x0D, 0x26, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x27, "WS", &cx5_25_evidence[4]},
    {0x0D, 0x28, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x29, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x2B, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x2C, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x41, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x42, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x43, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x44, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x45, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x46, "WRSLD", &cx5_25_evidence[4]},
    {0x0D, 0x47, "WRSLD", &cx5_25_evidence[4]},  {0x0D, 0x4B, "WRSLD", &cx5_25_evidence[4]},
    {0x7F, 0x10, "WRSLD", &cx5_25_evidence[4]},  {0x80, 0x04, "", &cx5_25_evidence[1]},
    {0x80, 0x05, "", &cx5_25_evidence[1]},       {0x80, 0x06, "", &cx5_25_evidence[4]},
    {0x80, 0x07, "", &cx5_25_evidence[4]},       {0x80, 0x08, "", &cx5_25_evidence[4]},
    {0x80, 0x09, "", &cx5_25_evidence[4]},       {0x80, 0x0A, "", &cx5_25_evidence[4]},
    {0x80, 0x0C, "", &cx5_25_evidence[4]},       {0x80, 0x10, "", &cx5_25_evidence[4]},
    {0x80, 0x11, "", &cx5_25_evidence[4]},       {0x80, 0x12, "", &cx5_25_evidence[1]},
    {0x80, 0x17, "", &cx5_25_evidence[4]},       {0x82, 0x03, "", &cx5_25_evidence[4]},
    {0x82, 0x04, "", &cx5_25_evidence[4]},       {0x82, 0x05, "", &cx5_25_evidence[1]},
    {0x82, 0x06, "", &cx5_25_evidence[4]},       {0x82, 0x0A, "", &cx5_25_evidence[4]},
    {0x82, 0x0B, "", &cx5_25_evidence[4]},       {0x82, 0x0D, "", &cx5_25_evidence[4]},
    {0x82, 0x0E, "", &cx5_25_evidence[1]},       {0x82, 0x0F, "", &cx5_25_evidence[4]},
    {0x82, 0x10, "", &cx5_25_evidence[1]},       {0x82, 0x11, "", &cx5_25_evidence[1]},
    {0x82, 0x12, "", &cx5_25_evidence[4]},       {0x82, 0x13, "", &cx5_25_evidence[4]},
    {0x82, 0x14, "", &cx5_25_evidence[4]},       {0x82, 0x15, "", &cx5_25_evidence[4]},
    {0x82, 0x1C, "", &cx5_25_evidence[1]},       {0x82, 0x21, "", &cx5_25_evidence[4]},
    {0x82, 0x25, "", &cx5_25_evidence[4]},       {0x82, 0x26, "", &cx5_25_evidence[4]},
    {0x82, 0x28, "", &cx5_25_evidence[4]},       {0x82, 0x29, "", &cx5_25_evidence[4]},
};

static const struct mip_profile_field cx5_25_refuses[] = {
    {0x0C, 0x02, "", &cx5_25_evidence[5]}, {0x0C, 0x07, "", &cx5_25_evidence[5]},
    {0x0C, 0x09, "", &cx5_25_evidence[5]}, {0x0C, 0x20, "", &cx5_25_evidence[5]},
    {0x0C, 0x21, "", &cx5_25_evidence[5]}, {0x0C, 0x22, "", &cx5_25_evidence[5]},
    {0x0C, 0x23, "", &cx5_25_evidence[5]}, {0x0C, 0x24, "", &cx5_25_evidence[5]},
    {0x0C, 0x34, "", &cx5_25_evidence[5]}, {0x0C, 0x62, "", &cx5_25_evidence[5]},
    {0x0D, 0x54, "", &cx5_25_evidence[5]}, {0x0D, 0x64, "", &cx5_25_evidence[5]},
    {0x82, 0x34, "", &cx5_25_evidence[5]}, {0x82, 0x35, "", &cx5_25_evidence[5]},
    {0x82, 0x49, "", &cx5_25_evidence[6]},
};

static const struct mip_profile_field cx5_25_absent_sets[] = {
    {0x81, 0, "", &cx5_25_evidence[5]},
    {0x91, 0, "", &cx5_25_evidence[5]},
    {0x92, 0, "", &cx5_25_evidence[5]},
    {0x93, 0, "", &cx5_25_evidence[5]},
};

static const struct mip_profile_reading cx5_25_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cx5_25 = {
    "3dm-cx5-25",
    "3DM-CX5-25",
    "3dm-cx5-25",
    "Attitude and heading reference system.",
    6273, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    90,   /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    cx5_25_also,
    cx5_25_incomplete,
    cx5_25_fields,
    cx5_25_refuses,
    cx5_25_absent_sets,
    NULL,
    NULL,
    cx5_25_readings,
};

/* 3DM-CX5-45. */

static const char *const cx5_45_also[] = {
    "3DM-CX5-GNSS/INS",
};

static const char *const cx5_45_incomplete[] = {
    "Of the manual, only the title is known. It has 196 pages, and describes the data from page "
    "131.",
};

static const struct mip_profile_evidence cx5_45_evidence[] = {
    {MIP_SUPPORT_YES, "Documented (3DM-CX5-45 Data Communications Protocol Manual: Title).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ArduPilot: AP_ExternalAHRS_MicroStrain5).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-45.", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
     ""},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field cx5_45_fields[] = {
    {0x01, 0x01, "", &cx5_45_evidence[1]},       {0x01, 0x02, "", &cx5_45_evidence[1]},
    {0x01, 0x03, "", &cx5_45_evidence[2]},       {0x01, 0x04, "", &cx5_45_evidence[4]},
    {0x01, 0x05, "", &cx5_45_evidence[5]},       {0x01, 0x06, "", &cx5_45_evidence[1]},
    {0x01, 0x07, "", &cx5_45_evidence[4]},       {0x01, 0x72, "WRA", &cx5_45_evidence[5]},
    {0x01, 0x7E, "", &cx5_45_evidence[5]},       {0x0C, 0x01, "", &cx5_45_evidence[5]},
    {0x0C, 0x02, "", &cx5_45_evidence[5]},       {0x0C, 0x03, "", &cx5_45_evidence[5]},
    {0x0C, 0x06, "", &cx5_45_evidence[1]},       {0x0C, 0x07, "", &cx5_45_evidence[2]},
    {0x0C, 0x08, "WRSLD", &cx5_45_evidence[1]},  {0x0C, 0x09, "WRSLD", &cx5_45_evidence[1]},
    {0x0C, 0x0A, "WRSLD", &cx5_45_evidence[1]},  {0x0C, 0x0B, "", &cx5_45_evidence[1]},
    {0x0C, 0x11, "WRSLD", &cx5_45_evidence[5]},  {0x0C, 0x21, "WRSLD", &cx5_45_evidence[5]},
    {0x0C, 0x22, "WRSLD", &cx5_45_evidence[5]},  {0x0C, 0x23, "WRSLD", &cx5_45_evidence[5]},
    {0x0C, 0x24, "WR", &cx5_45_evidence[5]},     {0x0C, 0x30, "SLD", &cx5_45_evidence[1]},
    {0x0C, 0x37, "WRSLDA", &cx5_45_evidence[5]}, {0x0C, 0x38, "WRSLDA", &cx5_45_evidence[5]},
    {0x0C, 0x39, "", &cx5_45_evidence[2]},       {0x0C, 0x3A, "WRSLDA", &cx5_45_evidence[5]},
    {0x0C, 0x3B, "WRSLDA", &cx5_45_evidence[5]}, {0x0C, 0x3E, "WRSLD", &cx5_45_evidence[5]},
    {0x0C, 0x40, "WRSLD", &cx5_45_evidence[5]},  {0x0C, 0x50, "WRSLD", &cx5_45_evidence[5]},
    {0x0C, 0x51, "WRSLD", &cx5_45_evidence[5]},  {0x0C, 0x64, "", &cx5_45_evidence[5]},
    {0x0D, 0x01, "", &cx5_45_evidence[1]},       {0x0D, 0x02, "", &cx5_45_evidence[5]},
    {0x0D, 0x03, "", &cx5_45_evidence[5]},       {0x0D, 0x10, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x11, "WRSLD", &cx5_45_evidence[1]},  {0x0D, 0x12, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x13, "WRSLD", &cx5_45_evidence[1]},  {0x0D, 0x14, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x15, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x16, "", &cx5_45_evidence[5]},
    {0x0D, 0x17, "", &cx5_45_evidence[5]},       {0x0D, 0x18, "WRSLD", &cx5_45_evidence[1]},
    {0x0D, 0x19, "WRSLD", &cx5_45_evidence[1]},  {0x0D, 0x1A, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x1B, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x1C, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x1D, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x1E, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x1F, "", &cx5_45_evidence[5]},       {0x0D, 0x20, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x21, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x22, "", &cx5_45_evidence[5]},
    {0x0D, 0x23, "", &cx5_45_evidence[5]},       {0x0D, 0x27, "WS", &cx5_45_evidence[5]},
    {0x0D, 0x28, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x29, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x2B, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x2C, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x42, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x43, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x44, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x45, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x46, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x47, "WRSLD", &cx5_45_evidence[5]},
    {0x0D, 0x4B, "WRSLD", &cx5_45_evidence[5]},  {0x0D, 0x53, "WRSLD", &cx5_45_evidence[5]},
    {0x7F, 0x10, "WRSLD", &cx5_45_evidence[5]},  {0x80, 0x04, "", &cx5_45_evidence[0]},
    {0x80, 0x05, "", &cx5_45_evidence[0]},       {0x80, 0x06, "", &cx5_45_evidence[0]},
    {0x80, 0x07, "", &cx5_45_evidence[5]},       {0x80, 0x08, "", &cx5_45_evidence[5]},
    {0x80, 0x09, "", &cx5_45_evidence[5]},       {0x80, 0x0A, "", &cx5_45_evidence[3]},
    {0x80, 0x0C, "", &cx5_45_evidence[5]},       {0x80, 0x10, "", &cx5_45_evidence[5]},
    {0x80, 0x11, "", &cx5_45_evidence[5]},       {0x80, 0x12, "", &cx5_45_evidence[1]},
    {0x80, 0x17, "", &cx5_45_evidence[3]},       {0x81, 0x03, "", &cx5_45_evidence[3]},
    {0x81, 0x04, "", &cx5_45_evidence[5]},       {0x81, 0x05, "", &cx5_45_evidence[3]},
    {0x81, 0x06, "", &cx5_45_evidence[5]},       {0x81, 0x07, "", &cx5_45_evidence[3]},
    {0x81, 0x08, "", &cx5_45_evidence[5]},       {0x81, 0x09, "", &cx5_45_evidence[5]},
    {0x81, 0x0A, "", &cx5_45_evidence[5]},       {0x81, 0x0B, "", &cx5_45_evidence[1]},
    {0x81, 0x0C, "", &cx5_45_evidence[5]},       {0x81, 0x0D, "", &cx5_45_evidence[5]},
    {0x81, 0x0E, "", &cx5_45_evidence[5]},       {0x81, 0x0F, "", &cx5_45_evidence[5]},
    {0x82, 0x01, "", &cx5_45_evidence[1]},       {0x82, 0x02, "", &cx5_45_evidence[1]},
    {0x82, 0x03, "", &cx5_45_evidence[3]},       {0x82, 0x04, "", &cx5_45_evidence[5]},
    {0x82, 0x05, "", &cx5_45_evidence[1]},       {0x82, 0x06, "", &cx5_45_evidence[6]},
    {0x82, 0x07, "", &cx5_45_evidence[6]},       {0x82, 0x08, "", &cx5_45_evidence[6]},
    {0x82, 0x09, "", &cx5_45_evidence[6]},       {0x82, 0x0A, "", &cx5_45_evidence[6]},
    {0x82, 0x0B, "", &cx5_45_evidence[6]},       {0x82, 0x0C, "", &cx5_45_evidence[6]},
    {0x82, 0x0D, "", &cx5_45_evidence[6]},       {0x82, 0x0E, "", &cx5_45_evidence[5]},
    {0x82, 0x0F, "", &cx5_45_evidence[6]},       {0x82, 0x10, "", &cx5_45_evidence[1]},
    {0x82, 0x11, "", &cx5_45_evidence[1]},       {0x82, 0x12, "", &cx5_45_evidence[6]},
    {0x82, 0x13, "", &cx5_45_evidence[6]},       {0x82, 0x14, "", &cx5_45_evidence[5]},
    {0x82, 0x15, "", &cx5_45_evidence[6]},       {0x82, 0x1C, "", &cx5_45_evidence[6]},
    {0x82, 0x20, "", &cx5_45_evidence[6]},       {0x82, 0x21, "", &cx5_45_evidence[6]},
    {0x82, 0x25, "", &cx5_45_evidence[6]},       {0x82, 0x26, "", &cx5_45_evidence[6]},
    {0x82, 0x28, "", &cx5_45_evidence[6]},       {0x82, 0x29, "", &cx5_45_evidence[6]},
};

static const struct mip_profile_field cx5_45_refuses[] = {
    {0x82, 0x49, "", &cx5_45_evidence[7]},
};

static const struct mip_profile_field cx5_45_absent_sets[] = {
    {0x92, 0, "", &cx5_45_evidence[8]},
};

static const struct mip_profile_reading cx5_45_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_cx5_45 = {
    "3dm-cx5-45",
    "3DM-CX5-45",
    "3dm-cx5-45",
    "Inertial navigation system with GNSS.",
    6271, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    124,  /* fields */
    1,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    cx5_45_also,
    cx5_45_incomplete,
    cx5_45_fields,
    cx5_45_refuses,
    cx5_45_absent_sets,
    NULL,
    NULL,
    cx5_45_readings,
};

/* 3DM-CX7-AHRS. */

static const char *const cx7_ahrs_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence cx7_ahrs_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cx7_ahrs_fields[] = {
    {0x01, 0x01, "", &cx7_ahrs_evidence[1]},       {0x01, 0x02, "", &cx7_ahrs_evidence[1]},
    {0x01, 0x03, "", &cx7_ahrs_evidence[1]},       {0x01, 0x04, "", &cx7_ahrs_evidence[1]},
    {0x01, 0x05, "", &cx7_ahrs_evidence[2]},       {0x01, 0x06, "", &cx7_ahrs_evidence[1]},
    {0x01, 0x07, "", &cx7_ahrs_evidence[1]},       {0x01, 0x08, "", &cx7_ahrs_evidence[2]},
    {0x01, 0x09, "WRSLD", &cx7_ahrs_evidence[2]},  {0x01, 0x72, "WRA", &cx7_ahrs_evidence[2]},
    {0x01, 0x7E, "", &cx7_ahrs_evidence[2]},       {0x0C, 0x0D, "", &cx7_ahrs_evidence[2]},
    {0x0C, 0x0E, "", &cx7_ahrs_evidence[1]},       {0x0C, 0x0F, "WRSLD", &cx7_ahrs_evidence[1]},
    {0x0C, 0x10, "", &cx7_ahrs_evidence[2]},       {0x0C, 0x11, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0C, 0x28, "WRSLD", &cx7_ahrs_evidence[0]},  {0x0C, 0x2A, "", &cx7_ahrs_evidence[2]},
    {0x0C, 0x2B, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0C, 0x2C, "", &cx7_ahrs_evidence[2]},
    {0x0C, 0x2D, "", &cx7_ahrs_evidence[2]},       {0x0C, 0x2E, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0C, 0x2F, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0C, 0x30, "SLD", &cx7_ahrs_evidence[1]},
    {0x0C, 0x31, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0C, 0x32, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0C, 0x33, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0C, 0x37, "WRSLDA", &cx7_ahrs_evidence[2]},
    {0x0C, 0x38, "WRSLDA", &cx7_ahrs_evidence[2]}, {0x0C, 0x39, "", &cx7_ahrs_evidence[2]},
    {0x0C, 0x3A, "WRSLDA", &cx7_ahrs_evidence[2]}, {0x0C, 0x3B, "WRSLDA", &cx7_ahrs_evidence[2]},
    {0x0C, 0x41, "WRSLD", &cx7_ahrs_evidence[0]},  {0x0C, 0x42, "WR", &cx7_ahrs_evidence[2]},
    {0x0C, 0x50, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0C, 0x51, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0C, 0x52, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0C, 0x53, "", &cx7_ahrs_evidence[2]},
    {0x0C, 0x54, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0D, 0x01, "", &cx7_ahrs_evidence[2]},
    {0x0D, 0x03, "", &cx7_ahrs_evidence[2]},       {0x0D, 0x1A, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0D, 0x1B, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0D, 0x1D, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0D, 0x20, "WRSLD", &cx7_ahrs_evidence[2]},  {0x0D, 0x28, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x0D, 0x43, "WRSLD", &cx7_ahrs_evidence[0]},  {0x0D, 0x50, "WRSLD", &cx7_ahrs_evidence[0]},
    {0x0D, 0x53, "WRSLD", &cx7_ahrs_evidence[0]},  {0x13, 0x01, "WRSLD", &cx7_ahrs_evidence[2]},
    {0x13, 0x1F, "WRSLD", &cx7_ahrs_evidence[2]},  {0x13, 0x31, "", &cx7_ahrs_evidence[2]},
    {0x13, 0x32, "", &cx7_ahrs_evidence[2]},       {0x80, 0x04, "", &cx7_ahrs_evidence[2]},
    {0x80, 0x05, "", &cx7_ahrs_evidence[2]},       {0x80, 0x06, "", &cx7_ahrs_evidence[2]},
    {0x80, 0x07, "", &cx7_ahrs_evidence[2]},       {0x80, 0x08, "", &cx7_ahrs_evidence[2]},
    {0x80, 0x09, "", &cx7_ahrs_evidence[2]},       {0x80, 0x0A, "", &cx7_ahrs_evidence[2]},
    {0x80, 0x0C, "", &cx7_ahrs_evidence[2]},       {0x80, 0x14, "", &cx7_ahrs_evidence[2]},
    {0x80, 0x17, "", &cx7_ahrs_evidence[2]},       {0x80, 0x18, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x03, "", &cx7_ahrs_evidence[2]},       {0x82, 0x04, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x05, "", &cx7_ahrs_evidence[2]},       {0x82, 0x06, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x0A, "", &cx7_ahrs_evidence[2]},       {0x82, 0x0B, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x0D, "", &cx7_ahrs_evidence[2]},       {0x82, 0x0E, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x10, "", &cx7_ahrs_evidence[2]},       {0x82, 0x12, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x13, "", &cx7_ahrs_evidence[2]},       {0x82, 0x1C, "", &cx7_ahrs_evidence[2]},
    {0x82, 0x21, "", &cx7_ahrs_evidence[2]},       {0xA0, 0x01, "", &cx7_ahrs_evidence[2]},
    {0xA0, 0x02, "", &cx7_ahrs_evidence[2]},       {0xA0, 0x03, "", &cx7_ahrs_evidence[2]},
    {0xFF, 0xD0, "", &cx7_ahrs_evidence[2]},       {0xFF, 0xD3, "", &cx7_ahrs_evidence[2]},
    {0xFF, 0xD4, "", &cx7_ahrs_evidence[2]},       {0xFF, 0xD5, "", &cx7_ahrs_evidence[2]},
    {0xFF, 0xD6, "", &cx7_ahrs_evidence[2]},       {0xFF, 0xD7, "", &cx7_ahrs_evidence[2]},
    {0xFF, 0xD8, "", &cx7_ahrs_evidence[2]},
};

static const struct mip_profile_field cx7_ahrs_refuses[] = {
    {0x0C, 0x02, "", &cx7_ahrs_evidence[3]}, {0x0C, 0x07, "", &cx7_ahrs_evidence[3]},
    {0x0C, 0x09, "", &cx7_ahrs_evidence[3]}, {0x0C, 0x20, "", &cx7_ahrs_evidence[3]},
    {0x0C, 0x21, "", &cx7_ahrs_evidence[3]}, {0x0C, 0x22, "", &cx7_ahrs_evidence[3]},
    {0x0C, 0x23, "", &cx7_ahrs_evidence[3]}, {0x0C, 0x24, "", &cx7_ahrs_evidence[3]},
    {0x0C, 0x34, "", &cx7_ahrs_evidence[3]}, {0x0C, 0x62, "", &cx7_ahrs_evidence[3]},
    {0x0D, 0x54, "", &cx7_ahrs_evidence[3]}, {0x0D, 0x64, "", &cx7_ahrs_evidence[3]},
    {0x82, 0x34, "", &cx7_ahrs_evidence[3]}, {0x82, 0x35, "", &cx7_ahrs_evidence[3]},
    {0x82, 0x49, "", &cx7_ahrs_evidence[4]},
};

static const struct mip_profile_field cx7_ahrs_absent_sets[] = {
    {0x81, 0, "", &cx7_ahrs_evidence[3]},
    {0x91, 0, "", &cx7_ahrs_evidence[3]},
    {0x92, 0, "", &cx7_ahrs_evidence[3]},
    {0x93, 0, "", &cx7_ahrs_evidence[3]},
};

static const struct mip_profile_reading cx7_ahrs_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cx7_ahrs = {
    "3dm-cx7-ahrs",
    "3DM-CX7-AHRS",
    "",
    "Attitude and heading reference system.",
    6701, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    87,   /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    8,    /* readings */
    NULL,
    cx7_ahrs_incomplete,
    cx7_ahrs_fields,
    cx7_ahrs_refuses,
    cx7_ahrs_absent_sets,
    NULL,
    NULL,
    cx7_ahrs_readings,
};

/* 3DM-CX7-AR. */

static const char *const cx7_ar_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence cx7_ar_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cx7_ar_fields[] = {
    {0x01, 0x01, "", &cx7_ar_evidence[1]},       {0x01, 0x02, "", &cx7_ar_evidence[1]},
    {0x01, 0x03, "", &cx7_ar_evidence[1]},       {0x01, 0x04, "", &cx7_ar_evidence[1]},
    {0x01, 0x05, "", &cx7_ar_evidence[2]},       {0x01, 0x06, "", &cx7_ar_evidence[1]},
    {0x01, 0x07, "", &cx7_ar_evidence[1]},       {0x01, 0x08, "", &cx7_ar_evidence[2]},
    {0x01, 0x09, "WRSLD", &cx7_ar_evidence[2]},  {0x01, 0x72, "WRA", &cx7_ar_evidence[2]},
    {0x01, 0x7E, "", &cx7_ar_evidence[2]},       {0x0C, 0x0D, "", &cx7_ar_evidence[2]},
    {0x0C, 0x0E, "", &cx7_ar_evidence[1]},       {0x0C, 0x0F, "WRSLD", &cx7_ar_evidence[1]},
    {0x0C, 0x10, "", &cx7_ar_evidence[2]},       {0x0C, 0x11, "WRSLD", &cx7_ar_evidence[2]},
    {0x0C, 0x28, "WRSLD", &cx7_ar_evidence[0]},  {0x0C, 0x2A, "", &cx7_ar_evidence[2]},
    {0x0C, 0x2B, "WRSLD", &cx7_ar_evidence[2]},  {0x0C, 0x2C, "", &cx7_ar_evidence[2]},
    {0x0C, 0x2D, "", &cx7_ar_evidence[2]},       {0x0C, 0x2E, "WRSLD", &cx7_ar_evidence[2]},
    {0x0C, 0x2F, "WRSLD", &cx7_ar_evidence[2]},  {0x0C, 0x30, "SLD", &cx7_ar_evidence[1]},
    {0x0C, 0x31, "WRSLD", &cx7_ar_evidence[2]},  {0x0C, 0x32, "WRSLD", &cx7_ar_evidence[2]},
    {0x0C, 0x33, "WRSLD", &cx7_ar_evidence[2]},  {0x0C, 0x37, "WRSLDA", &cx7_ar_evidence[2]},
    {0x0C, 0x38, "WRSLDA", &cx7_ar_evidence[2]}, {0x0C, 0x39, "", &cx7_ar_evidence[2]},
    {0x0C, 0x41, "WRSLD", &cx7_ar_evidence[0]},  {0x0C, 0x42, "WR", &cx7_ar_evidence[2]},
    {0x0C, 0x50, "WRSLD", &cx7_ar_evidence[2]},  {0x0C, 0x51, "WRSLD", &cx7_ar_evidence[2]},
    {0x0C, 0x52, "WRSLD", &cx7_ar_evidence[2]},  {0x0C, 0x53, "", &cx7_ar_evidence[2]},
    {0x0C, 0x54, "WRSLD", &cx7_ar_evidence[2]},  {0x0D, 0x01, "", &cx7_ar_evidence[2]},
    {0x0D, 0x03, "", &cx7_ar_evidence[2]},       {0x0D, 0x1A, "WRSLD", &cx7_ar_evidence[2]},
    {0x0D, 0x1B, "WRSLD", &cx7_ar_evidence[2]},  {0x0D, 0x1D, "WRSLD", &cx7_ar_evidence[2]},
    {0x0D, 0x20, "WRSLD", &cx7_ar_evidence[2]},  {0x0D, 0x28, "WRSLD", &cx7_ar_evidence[2]},
    {0x0D, 0x50, "WRSLD", &cx7_ar_evidence[0]},  {0x0D, 0x53, "WRSLD", &cx7_ar_evidence[0]},
    {0x13, 0x01, "WRSLD", &cx7_ar_evidence[2]},  {0x13, 0x1F, "WRSLD", &cx7_ar_evidence[2]},
    {0x13, 0x31, "", &cx7_ar_evidence[2]},       {0x13, 0x32, "", &cx7_ar_evidence[2]},
    {0x80, 0x04, "", &cx7_ar_evidence[2]},       {0x80, 0x05, "", &cx7_ar_evidence[2]},
    {0x80, 0x07, "", &cx7_ar_evidence[2]},       {0x80, 0x08, "", &cx7_ar_evidence[2]},
    {0x80, 0x09, "", &cx7_ar_evidence[2]},       {0x80, 0x0A, "", &cx7_ar_evidence[2]},
    {0x80, 0x0C, "", &cx7_ar_evidence[2]},       {0x80, 0x14, "", &cx7_ar_evidence[2]},
    {0x80, 0x17, "", &cx7_ar_evidence[2]},       {0x80, 0x18, "", &cx7_ar_evidence[2]},
    {0x82, 0x03, "", &cx7_ar_evidence[2]},       {0x82, 0x04, "", &cx7_ar_evidence[2]},
    {0x82, 0x05, "", &cx7_ar_evidence[2]},       {0x82, 0x06, "", &cx7_ar_evidence[2]},
    {0x82, 0x0A, "", &cx7_ar_evidence[2]},       {0x82, 0x0B, "", &cx7_ar_evidence[2]},
    {0x82, 0x0D, "", &cx7_ar_evidence[2]},       {0x82, 0x0E, "", &cx7_ar_evidence[2]},
    {0x82, 0x10, "", &cx7_ar_evidence[2]},       {0x82, 0x12, "", &cx7_ar_evidence[2]},
    {0x82, 0x13, "", &cx7_ar_evidence[2]},       {0x82, 0x1C, "", &cx7_ar_evidence[2]},
    {0x82, 0x21, "", &cx7_ar_evidence[2]},       {0xA0, 0x01, "", &cx7_ar_evidence[2]},
    {0xA0, 0x02, "", &cx7_ar_evidence[2]},       {0xA0, 0x03, "", &cx7_ar_evidence[2]},
    {0xFF, 0xD0, "", &cx7_ar_evidence[2]},       {0xFF, 0xD3, "", &cx7_ar_evidence[2]},
    {0xFF, 0xD4, "", &cx7_ar_evidence[2]},       {0xFF, 0xD5, "", &cx7_ar_evidence[2]},
    {0xFF, 0xD6, "", &cx7_ar_evidence[2]},       {0xFF, 0xD7, "", &cx7_ar_evidence[2]},
    {0xFF, 0xD8, "", &cx7_ar_evidence[2]},
};

static const struct mip_profile_field cx7_ar_refuses[] = {
    {0x0C, 0x02, "", &cx7_ar_evidence[3]}, {0x0C, 0x07, "", &cx7_ar_evidence[3]},
    {0x0C, 0x09, "", &cx7_ar_evidence[3]}, {0x0C, 0x20, "", &cx7_ar_evidence[3]},
    {0x0C, 0x21, "", &cx7_ar_evidence[3]}, {0x0C, 0x22, "", &cx7_ar_evidence[3]},
    {0x0C, 0x23, "", &cx7_ar_evidence[3]}, {0x0C, 0x24, "", &cx7_ar_evidence[3]},
    {0x0C, 0x34, "", &cx7_ar_evidence[3]}, {0x0C, 0x3A, "", &cx7_ar_evidence[4]},
    {0x0C, 0x3B, "", &cx7_ar_evidence[4]}, {0x0C, 0x62, "", &cx7_ar_evidence[3]},
    {0x0D, 0x27, "", &cx7_ar_evidence[4]}, {0x0D, 0x2B, "", &cx7_ar_evidence[4]},
    {0x0D, 0x2C, "", &cx7_ar_evidence[4]}, {0x0D, 0x42, "", &cx7_ar_evidence[4]},
    {0x0D, 0x43, "", &cx7_ar_evidence[4]}, {0x0D, 0x45, "", &cx7_ar_evidence[4]},
    {0x0D, 0x46, "", &cx7_ar_evidence[4]}, {0x0D, 0x4C, "", &cx7_ar_evidence[4]},
    {0x0D, 0x4D, "", &cx7_ar_evidence[4]}, {0x0D, 0x54, "", &cx7_ar_evidence[3]},
    {0x0D, 0x64, "", &cx7_ar_evidence[3]}, {0x80, 0x03, "", &cx7_ar_evidence[4]},
    {0x80, 0x06, "", &cx7_ar_evidence[4]}, {0x82, 0x1A, "", &cx7_ar_evidence[4]},
    {0x82, 0x1B, "", &cx7_ar_evidence[4]}, {0x82, 0x25, "", &cx7_ar_evidence[4]},
    {0x82, 0x26, "", &cx7_ar_evidence[4]}, {0x82, 0x28, "", &cx7_ar_evidence[4]},
    {0x82, 0x29, "", &cx7_ar_evidence[4]}, {0x82, 0x2A, "", &cx7_ar_evidence[4]},
    {0x82, 0x2C, "", &cx7_ar_evidence[4]}, {0x82, 0x34, "", &cx7_ar_evidence[3]},
    {0x82, 0x35, "", &cx7_ar_evidence[3]}, {0x82, 0x49, "", &cx7_ar_evidence[5]},
};

static const struct mip_profile_field cx7_ar_absent_sets[] = {
    {0x81, 0, "", &cx7_ar_evidence[3]},
    {0x91, 0, "", &cx7_ar_evidence[3]},
    {0x92, 0, "", &cx7_ar_evidence[3]},
    {0x93, 0, "", &cx7_ar_evidence[3]},
};

static const struct mip_profile_reading cx7_ar_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cx7_ar = {
    "3dm-cx7-ar",
    "3DM-CX7-AR",
    "",
    "Attitude reference.",
    6700, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    83,   /* fields */
    36,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    8,    /* readings */
    NULL,
    cx7_ar_incomplete,
    cx7_ar_fields,
    cx7_ar_refuses,
    cx7_ar_absent_sets,
    NULL,
    NULL,
    cx7_ar_readings,
};

/* 3DM-CX7-INS. */

static const char *const cx7_ins_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence cx7_ins_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field cx7_ins_fields[] = {
    {0x01, 0x01, "", &cx7_ins_evidence[1]},       {0x01, 0x02, "", &cx7_ins_evidence[1]},
    {0x01, 0x03, "", &cx7_ins_evidence[1]},       {0x01, 0x04, "", &cx7_ins_evidence[1]},
    {0x01, 0x05, "", &cx7_ins_evidence[2]},       {0x01, 0x06, "", &cx7_ins_evidence[1]},
    {0x01, 0x07, "", &cx7_ins_evidence[1]},       {0x01, 0x08, "", &cx7_ins_evidence[2]},
    {0x01, 0x09, "WRSLD", &cx7_ins_evidence[2]},  {0x01, 0x72, "WRA", &cx7_ins_evidence[2]},
    {0x01, 0x7E, "", &cx7_ins_evidence[2]},       {0x0C, 0x04, "", &cx7_ins_evidence[2]},
    {0x0C, 0x0C, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x0D, "", &cx7_ins_evidence[2]},
    {0x0C, 0x0E, "", &cx7_ins_evidence[1]},       {0x0C, 0x0F, "WRSLD", &cx7_ins_evidence[1]},
    {0x0C, 0x10, "", &cx7_ins_evidence[2]},       {0x0C, 0x11, "WRSLD", &cx7_ins_evidence[2]},
    {0x0C, 0x28, "WRSLD", &cx7_ins_evidence[0]},  {0x0C, 0x2A, "", &cx7_ins_evidence[2]},
    {0x0C, 0x2B, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x2C, "", &cx7_ins_evidence[2]},
    {0x0C, 0x2D, "", &cx7_ins_evidence[2]},       {0x0C, 0x2E, "WRSLD", &cx7_ins_evidence[2]},
    {0x0C, 0x2F, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x30, "SLD", &cx7_ins_evidence[1]},
    {0x0C, 0x31, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x32, "WRSLD", &cx7_ins_evidence[2]},
    {0x0C, 0x33, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x37, "WRSLDA", &cx7_ins_evidence[2]},
    {0x0C, 0x38, "WRSLDA", &cx7_ins_evidence[2]}, {0x0C, 0x39, "", &cx7_ins_evidence[2]},
    {0x0C, 0x3A, "WRSLDA", &cx7_ins_evidence[2]}, {0x0C, 0x3B, "WRSLDA", &cx7_ins_evidence[2]},
    {0x0C, 0x41, "WRSLD", &cx7_ins_evidence[0]},  {0x0C, 0x42, "WR", &cx7_ins_evidence[2]},
    {0x0C, 0x50, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x51, "WRSLD", &cx7_ins_evidence[2]},
    {0x0C, 0x52, "WRSLD", &cx7_ins_evidence[2]},  {0x0C, 0x53, "", &cx7_ins_evidence[2]},
    {0x0C, 0x54, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x01, "", &cx7_ins_evidence[2]},
    {0x0D, 0x03, "", &cx7_ins_evidence[2]},       {0x0D, 0x05, "", &cx7_ins_evidence[2]},
    {0x0D, 0x13, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x15, "WRSLD", &cx7_ins_evidence[2]},
    {0x0D, 0x17, "", &cx7_ins_evidence[2]},       {0x0D, 0x1A, "WRSLD", &cx7_ins_evidence[2]},
    {0x0D, 0x1B, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x1C, "WRSLD", &cx7_ins_evidence[2]},
    {0x0D, 0x1D, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x1F, "", &cx7_ins_evidence[2]},
    {0x0D, 0x20, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x28, "WRSLD", &cx7_ins_evidence[2]},
    {0x0D, 0x43, "WRSLD", &cx7_ins_evidence[0]},  {0x0D, 0x50, "WRSLD", &cx7_ins_evidence[0]},
    {0x0D, 0x52, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x53, "WRSLD", &cx7_ins_evidence[0]},
    {0x0D, 0x55, "WRSLD", &cx7_ins_evidence[2]},  {0x0D, 0x56, "WRSLD", &cx7_ins_evidence[2]},
    {0x13, 0x01, "WRSLD", &cx7_ins_evidence[2]},  {0x13, 0x1F, "WRSLD", &cx7_ins_evidence[2]},
    {0x13, 0x21, "", &cx7_ins_evidence[2]},       {0x13, 0x22, "", &cx7_ins_evidence[2]},
    {0x13, 0x23, "", &cx7_ins_evidence[2]},       {0x13, 0x28, "", &cx7_ins_evidence[2]},
    {0x13, 0x29, "", &cx7_ins_evidence[2]},       {0x13, 0x2A, "", &cx7_ins_evidence[2]},
    {0x13, 0x31, "", &cx7_ins_evidence[2]},       {0x13, 0x32, "", &cx7_ins_evidence[2]},
    {0x13, 0x33, "", &cx7_ins_evidence[2]},       {0x80, 0x04, "", &cx7_ins_evidence[2]},
    {0x80, 0x05, "", &cx7_ins_evidence[2]},       {0x80, 0x06, "", &cx7_ins_evidence[2]},
    {0x80, 0x07, "", &cx7_ins_evidence[2]},       {0x80, 0x08, "", &cx7_ins_evidence[2]},
    {0x80, 0x09, "", &cx7_ins_evidence[2]},       {0x80, 0x0A, "", &cx7_ins_evidence[2]},
    {0x80, 0x0C, "", &cx7_ins_evidence[2]},       {0x80, 0x14, "", &cx7_ins_evidence[2]},
    {0x80, 0x17, "", &cx7_ins_evidence[2]},       {0x80, 0x18, "", &cx7_ins_evidence[2]},
    {0x82, 0x01, "", &cx7_ins_evidence[2]},       {0x82, 0x02, "", &cx7_ins_evidence[2]},
    {0x82, 0x03, "", &cx7_ins_evidence[2]},       {0x82, 0x04, "", &cx7_ins_evidence[2]},
    {0x82, 0x05, "", &cx7_ins_evidence[2]},       {0x82, 0x06, "", &cx7_ins_evidence[2]},
    {0x82, 0x07, "", &cx7_ins_evidence[2]},       {0x82, 0x08, "", &cx7_ins_evidence[2]},
    {0x82, 0x09, "", &cx7_ins_evidence[2]},       {0x82, 0x0A, "", &cx7_ins_evidence[2]},
    {0x82, 0x0B, "", &cx7_ins_evidence[2]},       {0x82, 0x0C, "", &cx7_ins_evidence[2]},
    {0x82, 0x0D, "", &cx7_ins_evidence[2]},       {0x82, 0x0E, "", &cx7_ins_evidence[2]},
    {0x82, 0x10, "", &cx7_ins_evidence[2]},       {0x82, 0x12, "", &cx7_ins_evidence[2]},
    {0x82, 0x13, "", &cx7_ins_evidence[2]},       {0x82, 0x15, "", &cx7_ins_evidence[2]},
    {0x82, 0x1C, "", &cx7_ins_evidence[2]},       {0x82, 0x21, "", &cx7_ins_evidence[2]},
    {0x82, 0x36, "", &cx7_ins_evidence[2]},       {0x82, 0x37, "", &cx7_ins_evidence[2]},
    {0x82, 0x40, "", &cx7_ins_evidence[2]},       {0x82, 0x41, "", &cx7_ins_evidence[2]},
    {0x82, 0x42, "", &cx7_ins_evidence[2]},       {0x82, 0x43, "", &cx7_ins_evidence[2]},
    {0x82, 0x46, "", &cx7_ins_evidence[2]},       {0x82, 0x50, "", &cx7_ins_evidence[2]},
    {0x82, 0x51, "", &cx7_ins_evidence[2]},       {0x94, 0x03, "", &cx7_ins_evidence[2]},
    {0x94, 0x05, "", &cx7_ins_evidence[2]},       {0x94, 0x08, "", &cx7_ins_evidence[2]},
    {0x94, 0x0B, "", &cx7_ins_evidence[2]},       {0x94, 0x20, "", &cx7_ins_evidence[2]},
    {0xA0, 0x01, "", &cx7_ins_evidence[2]},       {0xA0, 0x02, "", &cx7_ins_evidence[2]},
    {0xA0, 0x03, "", &cx7_ins_evidence[2]},       {0xFF, 0xD0, "", &cx7_ins_evidence[2]},
    {0xFF, 0xD3, "", &cx7_ins_evidence[2]},       {0xFF, 0xD4, "", &cx7_ins_evidence[2]},
    {0xFF, 0xD5, "", &cx7_ins_evidence[2]},       {0xFF, 0xD6, "", &cx7_ins_evidence[2]},
    {0xFF, 0xD7, "", &cx7_ins_evidence[2]},       {0xFF, 0xD8, "", &cx7_ins_evidence[2]},
};

static const struct mip_profile_field cx7_ins_refuses[] = {
    {0x0C, 0x02, "", &cx7_ins_evidence[3]}, {0x0C, 0x07, "", &cx7_ins_evidence[3]},
    {0x0C, 0x09, "", &cx7_ins_evidence[3]}, {0x0C, 0x20, "", &cx7_ins_evidence[3]},
    {0x0C, 0x21, "", &cx7_ins_evidence[3]}, {0x0C, 0x22, "", &cx7_ins_evidence[3]},
    {0x0C, 0x23, "", &cx7_ins_evidence[3]}, {0x0C, 0x24, "", &cx7_ins_evidence[3]},
    {0x0C, 0x34, "", &cx7_ins_evidence[3]}, {0x0C, 0x62, "", &cx7_ins_evidence[3]},
    {0x0D, 0x54, "", &cx7_ins_evidence[3]}, {0x0D, 0x64, "", &cx7_ins_evidence[3]},
    {0x82, 0x34, "", &cx7_ins_evidence[3]}, {0x82, 0x35, "", &cx7_ins_evidence[3]},
    {0x82, 0x49, "", &cx7_ins_evidence[4]},
};

static const struct mip_profile_field cx7_ins_absent_sets[] = {
    {0x81, 0, "", &cx7_ins_evidence[3]},
    {0x91, 0, "", &cx7_ins_evidence[3]},
    {0x92, 0, "", &cx7_ins_evidence[3]},
    {0x93, 0, "", &cx7_ins_evidence[3]},
};

static const struct mip_profile_reading cx7_ins_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_cx7_ins = {
    "3dm-cx7-ins",
    "3DM-CX7-INS",
    "",
    "Inertial navigation system.",
    6702, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    126,  /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    8,    /* readings */
    NULL,
    cx7_ins_incomplete,
    cx7_ins_fields,
    cx7_ins_refuses,
    cx7_ins_absent_sets,
    NULL,
    NULL,
    cx7_ins_readings,
};

/* 3DM-DH3. */

static const char *const dh3_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence dh3_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
};

static const struct mip_profile_field dh3_fields[] = {
    {0x01, 0x01, "", &dh3_evidence[0]}, {0x01, 0x02, "", &dh3_evidence[0]},
    {0x01, 0x03, "", &dh3_evidence[0]}, {0x01, 0x04, "", &dh3_evidence[0]},
    {0x01, 0x06, "", &dh3_evidence[0]}, {0x0C, 0x11, "WRSLD", &dh3_evidence[0]},
};

static const struct mip_profile_reading dh3_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_dh3 = {
    "3dm-dh3", "3DM-DH3",      "",         "Device of generation 3.",
    6219, /* model number */
    3,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    6,    /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,      dh3_incomplete, dh3_fields, NULL,
    NULL,      NULL,           NULL,       dh3_readings,
};

/* 3DM-GQ4-45. */

static const char *const gq4_45_incomplete[] = {
    "The manual's table of contents is known only up to the commands of the set `3dm`. The unknown "
    "part includes the sets `filter` and `system`.",
    "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.",
};

static const struct mip_profile_evidence gq4_45_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-RQ1-45-LT and 3DM-GX4-45.",
     ""},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field gq4_45_fields[] = {
    {0x01, 0x01, "", &gq4_45_evidence[0]},       {0x01, 0x02, "", &gq4_45_evidence[0]},
    {0x01, 0x03, "", &gq4_45_evidence[0]},       {0x01, 0x04, "", &gq4_45_evidence[0]},
    {0x01, 0x05, "", &gq4_45_evidence[0]},       {0x01, 0x06, "", &gq4_45_evidence[0]},
    {0x01, 0x72, "WRA", &gq4_45_evidence[0]},    {0x01, 0x7E, "", &gq4_45_evidence[0]},
    {0x0C, 0x01, "", &gq4_45_evidence[0]},       {0x0C, 0x02, "", &gq4_45_evidence[0]},
    {0x0C, 0x03, "", &gq4_45_evidence[0]},       {0x0C, 0x06, "", &gq4_45_evidence[0]},
    {0x0C, 0x07, "", &gq4_45_evidence[0]},       {0x0C, 0x08, "WRSLD", &gq4_45_evidence[0]},
    {0x0C, 0x09, "WRSLD", &gq4_45_evidence[0]},  {0x0C, 0x0A, "WRSLD", &gq4_45_evidence[0]},
    {0x0C, 0x0B, "", &gq4_45_evidence[0]},       {0x0C, 0x11, "WRSLD", &gq4_45_evidence[0]},
    {0x0C, 0x20, "", &gq4_45_evidence[0]},       {0x0C, 0x21, "WRSLD", &gq4_45_evidence[0]},
    {0x0C, 0x22, "WRSLD", &gq4_45_evidence[0]},  {0x0C, 0x30, "SLD", &gq4_45_evidence[0]},
    {0x0C, 0x37, "WRSLDA", &gq4_45_evidence[0]}, {0x0C, 0x38, "WRSLDA", &gq4_45_evidence[0]},
    {0x0C, 0x39, "", &gq4_45_evidence[0]},       {0x0C, 0x3A, "WRSLDA", &gq4_45_evidence[0]},
    {0x0C, 0x3B, "WRSLDA", &gq4_45_evidence[0]}, {0x0C, 0x3E, "WRSLD", &gq4_45_evidence[0]},
    {0x0C, 0x40, "WRSLD", &gq4_45_evidence[0]},  {0x0C, 0x50, "WRSLD", &gq4_45_evidence[0]},
    {0x0C, 0x51, "WRSLD", &gq4_45_evidence[0]},  {0x0C, 0x64, "", &gq4_45_evidence[0]},
    {0x0D, 0x01, "", &gq4_45_evidence[1]},       {0x0D, 0x02, "", &gq4_45_evidence[1]},
    {0x0D, 0x03, "", &gq4_45_evidence[1]},       {0x0D, 0x10, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x11, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x12, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x13, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x14, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x15, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x16, "", &gq4_45_evidence[1]},
    {0x0D, 0x17, "", &gq4_45_evidence[1]},       {0x0D, 0x18, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x19, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x1A, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x1B, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x1C, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x1D, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x1E, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x1F, "", &gq4_45_evidence[1]},       {0x0D, 0x20, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x21, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x22, "", &gq4_45_evidence[1]},
    {0x0D, 0x23, "", &gq4_45_evidence[1]},       {0x0D, 0x42, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x43, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x44, "WRSLD", &gq4_45_evidence[1]},
    {0x0D, 0x45, "WRSLD", &gq4_45_evidence[1]},  {0x0D, 0x46, "WRSLD", &gq4_45_evidence[1]},
    {0x7F, 0x10, "WRSLD", &gq4_45_evidence[1]},  {0x80, 0x04, "", &gq4_45_evidence[1]},
    {0x80, 0x05, "", &gq4_45_evidence[1]},       {0x80, 0x06, "", &gq4_45_evidence[1]},
    {0x81, 0x03, "", &gq4_45_evidence[1]},       {0x81, 0x05, "", &gq4_45_evidence[1]},
    {0x81, 0x09, "", &gq4_45_evidence[1]},       {0x82, 0x01, "", &gq4_45_evidence[1]},
    {0x82, 0x02, "", &gq4_45_evidence[1]},       {0x82, 0x05, "", &gq4_45_evidence[1]},
};

static const struct mip_profile_field gq4_45_refuses[] = {
    {0x82, 0x49, "", &gq4_45_evidence[2]},
};

static const struct mip_profile_field gq4_45_absent_sets[] = {
    {0x92, 0, "", &gq4_45_evidence[3]},
};

static const struct mip_profile_reading gq4_45_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gq4_45 = {
    "3dm-gq4-45",
    "3DM-GQ4-45",
    "3dm-gq4-45",
    "Tactical grade inertial navigation system with GNSS.",
    6250, /* model number */
    4,    /* generation */
    0,    /* other names */
    2,    /* what is not known */
    70,   /* fields */
    1,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    gq4_45_incomplete,
    gq4_45_fields,
    gq4_45_refuses,
    gq4_45_absent_sets,
    NULL,
    NULL,
    gq4_45_readings,
};

/* 3DM-GQ7-GNSS/INS. */

static const char *const gq7_also[] = {
    "3DM-GQ7",
};

static const char *const gq7_incomplete[] = {
    "Only some pages of its manual are known; the device has further commands and data.",
    "The baud rates of the Aux port are not known, nor all of its protocols.",
};

static const struct mip_profile_evidence gq7_evidence[] = {
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the ROS messages).",
     ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-GQ7 Documentation: Protocol Support and Specifications).", ""},
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_YES,
     "Documented (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the wiki of the ROS "
     "driver).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY, "Used by programs for this model (PX4: Driver of the vendor's sensors).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
};

static const struct mip_profile_field gq7_fields[] = {
    {0x01, 0x01, "", &gq7_evidence[4]},       {0x01, 0x02, "", &gq7_evidence[4]},
    {0x01, 0x03, "", &gq7_evidence[0]},       {0x01, 0x04, "", &gq7_evidence[1]},
    {0x01, 0x05, "", &gq7_evidence[7]},       {0x01, 0x06, "", &gq7_evidence[4]},
    {0x01, 0x07, "", &gq7_evidence[1]},       {0x01, 0x08, "", &gq7_evidence[7]},
    {0x01, 0x09, "WRSLD", &gq7_evidence[1]},  {0x01, 0x72, "WRA", &gq7_evidence[7]},
    {0x01, 0x7E, "", &gq7_evidence[7]},       {0x0C, 0x04, "", &gq7_evidence[2]},
    {0x0C, 0x0C, "WRSLD", &gq7_evidence[5]},  {0x0C, 0x0D, "", &gq7_evidence[7]},
    {0x0C, 0x0E, "", &gq7_evidence[1]},       {0x0C, 0x0F, "WRSLD", &gq7_evidence[4]},
    {0x0C, 0x10, "", &gq7_evidence[5]},       {0x0C, 0x11, "WRSLD", &gq7_evidence[7]},
    {0x0C, 0x22, "WRSLD", &gq7_evidence[5]},  {0x0C, 0x28, "WRSLD", &gq7_evidence[5]},
    {0x0C, 0x2A, "", &gq7_evidence[7]},       {0x0C, 0x2B, "WRSLD", &gq7_evidence[7]},
    {0x0C, 0x2C, "", &gq7_evidence[7]},       {0x0C, 0x2D, "", &gq7_evidence[7]},
    {0x0C, 0x2E, "WRSLD", &gq7_evidence[7]},  {0x0C, 0x2F, "WRSLD", &gq7_evidence[7]},
    {0x0C, 0x30, "SLD", &gq7_evidence[4]},    {0x0C, 0x31, "WRSLD", &gq7_evidence[2]},
    {0x0C, 0x32, "WRSLD", &gq7_evidence[7]},  {0x0C, 0x33, "WRSLD", &gq7_evidence[7]},
    {0x0C, 0x37, "WRSLDA", &gq7_evidence[7]}, {0x0C, 0x38, "WRSLDA", &gq7_evidence[7]},
    {0x0C, 0x39, "", &gq7_evidence[2]},       {0x0C, 0x3A, "WRSLDA", &gq7_evidence[7]},
    {0x0C, 0x3B, "WRSLDA", &gq7_evidence[7]}, {0x0C, 0x41, "WRSLD", &gq7_evidence[5]},
    {0x0C, 0x42, "WR", &gq7_evidence[0]},     {0x0C, 0x43, "WRSLD", &gq7_evidence[5]},
    {0x0C, 0x50, "WRSLD", &gq7_evidence[1]},  {0x0C, 0x51, "WRSLD", &gq7_evidence[7]},
    {0x0C, 0x52, "WRSLD", &gq7_evidence[7]},  {0x0C, 0x53, "", &gq7_evidence[7]},
    {0x0C, 0x54, "WRSLD", &gq7_evidence[1]},  {0x0D, 0x01, "", &gq7_evidence[4]},
    {0x0D, 0x03, "", &gq7_evidence[7]},       {0x0D, 0x05, "", &gq7_evidence[2]},
    {0x0D, 0x15, "WRSLD", &gq7_evidence[2]},  {0x0D, 0x17, "", &gq7_evidence[7]},
    {0x0D, 0x1A, "WRSLD", &gq7_evidence[7]},  {0x0D, 0x1B, "WRSLD", &gq7_evidence[7]},
    {0x0D, 0x1C, "WRSLD", &gq7_evidence[7]},  {0x0D, 0x1D, "WRSLD", &gq7_evidence[7]},
    {0x0D, 0x1E, "WRSLD", &gq7_evidence[2]},  {0x0D, 0x1F, "", &gq7_evidence[7]},
    {0x0D, 0x20, "WRSLD", &gq7_evidence[2]},  {0x0D, 0x28, "WRSLD", &gq7_evidence[7]},
    {0x0D, 0x43, "WRSLD", &gq7_evidence[2]},  {0x0D, 0x50, "WRSLD", &gq7_evidence[4]},
    {0x0D, 0x52, "WRSLD", &gq7_evidence[2]},  {0x0D, 0x53, "WRSLD", &gq7_evidence[5]},
    {0x0D, 0x54, "WRSLD", &gq7_evidence[4]},  {0x0D, 0x55, "WRSLD", &gq7_evidence[5]},
    {0x0D, 0x56, "WRSLD", &gq7_evidence[5]},  {0x0D, 0x61, "WRSLD", &gq7_evidence[5]},
    {0x0D, 0x63, "WRSLD", &gq7_evidence[4]},  {0x0D, 0x64, "WRSLD", &gq7_evidence[2]},
    {0x0E, 0x01, "", &gq7_evidence[7]},       {0x0E, 0x02, "WRSLD", &gq7_evidence[5]},
    {0x0E, 0x10, "WRSLD", &gq7_evidence[5]},  {0x13, 0x01, "WRSLD", &gq7_evidence[7]},
    {0x13, 0x1F, "WRSLD", &gq7_evidence[7]},  {0x13, 0x31, "", &gq7_evidence[7]},
    {0x80, 0x04, "", &gq7_evidence[3]},       {0x80, 0x05, "", &gq7_evidence[3]},
    {0x80, 0x06, "", &gq7_evidence[3]},       {0x80, 0x07, "", &gq7_evidence[3]},
    {0x80, 0x08, "", &gq7_evidence[3]},       {0x80, 0x09, "", &gq7_evidence[7]},
    {0x80, 0x0A, "", &gq7_evidence[3]},       {0x80, 0x0C, "", &gq7_evidence[7]},
    {0x80, 0x12, "", &gq7_evidence[3]},       {0x80, 0x14, "", &gq7_evidence[0]},
    {0x80, 0x17, "", &gq7_evidence[3]},       {0x80, 0x18, "", &gq7_evidence[3]},
    {0x80, 0x40, "", &gq7_evidence[3]},       {0x82, 0x01, "", &gq7_evidence[3]},
    {0x82, 0x02, "", &gq7_evidence[3]},       {0x82, 0x03, "", &gq7_evidence[3]},
    {0x82, 0x04, "", &gq7_evidence[7]},       {0x82, 0x05, "", &gq7_evidence[3]},
    {0x82, 0x06, "", &gq7_evidence[7]},       {0x82, 0x07, "", &gq7_evidence[7]},
    {0x82, 0x08, "", &gq7_evidence[3]},       {0x82, 0x09, "", &gq7_evidence[3]},
    {0x82, 0x0A, "", &gq7_evidence[3]},       {0x82, 0x0B, "", &gq7_evidence[7]},
    {0x82, 0x0C, "", &gq7_evidence[7]},       {0x82, 0x0D, "", &gq7_evidence[3]},
    {0x82, 0x0E, "", &gq7_evidence[3]},       {0x82, 0x10, "", &gq7_evidence[3]},
    {0x82, 0x12, "", &gq7_evidence[7]},       {0x82, 0x13, "", &gq7_evidence[7]},
    {0x82, 0x15, "", &gq7_evidence[7]},       {0x82, 0x1C, "", &gq7_evidence[3]},
    {0x82, 0x21, "", &gq7_evidence[7]},       {0x82, 0x34, "", &gq7_evidence[3]},
    {0x82, 0x35, "", &gq7_evidence[7]},       {0x82, 0x36, "", &gq7_evidence[3]},
    {0x82, 0x37, "", &gq7_evidence[3]},       {0x82, 0x40, "", &gq7_evidence[3]},
    {0x82, 0x41, "", &gq7_evidence[3]},       {0x82, 0x42, "", &gq7_evidence[3]},
    {0x82, 0x43, "", &gq7_evidence[3]},       {0x82, 0x46, "", &gq7_evidence[3]},
    {0x82, 0x47, "", &gq7_evidence[7]},       {0x82, 0x48, "", &gq7_evidence[7]},
    {0x82, 0x49, "", &gq7_evidence[3]},       {0x91, 0x03, "", &gq7_evidence[2]},
    {0x91, 0x04, "", &gq7_evidence[3]},       {0x91, 0x05, "", &gq7_evidence[3]},
    {0x91, 0x06, "", &gq7_evidence[3]},       {0x91, 0x07, "", &gq7_evidence[6]},
    {0x91, 0x08, "", &gq7_evidence[7]},       {0x91, 0x09, "", &gq7_evidence[7]},
    {0x91, 0x0B, "", &gq7_evidence[2]},       {0x91, 0x0D, "", &gq7_evidence[7]},
    {0x91, 0x10, "", &gq7_evidence[7]},       {0x91, 0x11, "", &gq7_evidence[6]},
    {0x91, 0x12, "", &gq7_evidence[3]},       {0x91, 0x14, "", &gq7_evidence[3]},
    {0x91, 0x20, "", &gq7_evidence[7]},       {0x91, 0x22, "", &gq7_evidence[7]},
    {0x91, 0x61, "", &gq7_evidence[7]},       {0x91, 0x62, "", &gq7_evidence[7]},
    {0x91, 0x63, "", &gq7_evidence[7]},       {0x91, 0x64, "", &gq7_evidence[7]},
    {0x92, 0x03, "", &gq7_evidence[3]},       {0x92, 0x04, "", &gq7_evidence[3]},
    {0x92, 0x05, "", &gq7_evidence[3]},       {0x92, 0x06, "", &gq7_evidence[3]},
    {0x92, 0x07, "", &gq7_evidence[6]},       {0x92, 0x08, "", &gq7_evidence[7]},
    {0x92, 0x09, "", &gq7_evidence[7]},       {0x92, 0x0B, "", &gq7_evidence[4]},
    {0x92, 0x0D, "", &gq7_evidence[2]},       {0x92, 0x10, "", &gq7_evidence[7]},
    {0x92, 0x11, "", &gq7_evidence[6]},       {0x92, 0x12, "", &gq7_evidence[3]},
    {0x92, 0x14, "", &gq7_evidence[3]},       {0x92, 0x20, "", &gq7_evidence[7]},
    {0x92, 0x22, "", &gq7_evidence[7]},       {0x92, 0x61, "", &gq7_evidence[7]},
    {0x92, 0x62, "", &gq7_evidence[7]},       {0x92, 0x63, "", &gq7_evidence[7]},
    {0x92, 0x64, "", &gq7_evidence[7]},       {0x93, 0x30, "", &gq7_evidence[3]},
    {0x93, 0x31, "", &gq7_evidence[3]},       {0xA0, 0x01, "", &gq7_evidence[0]},
    {0xA0, 0x02, "", &gq7_evidence[7]},       {0xA0, 0x03, "", &gq7_evidence[7]},
    {0xFF, 0xD0, "", &gq7_evidence[7]},       {0xFF, 0xD3, "", &gq7_evidence[3]},
    {0xFF, 0xD4, "", &gq7_evidence[7]},       {0xFF, 0xD5, "", &gq7_evidence[7]},
    {0xFF, 0xD6, "", &gq7_evidence[7]},       {0xFF, 0xD7, "", &gq7_evidence[7]},
    {0xFF, 0xD8, "", &gq7_evidence[7]},
};

static const struct mip_profile_firmware gq7_firmware[] = {
    {0x0C, 0x50, "<= 1.0.10"}, {0x0C, 0x54, "> 1.0.10"}, {0x0E, 0x02, "> 1.0.10"},
    {0xA0, 0x01, "> 1.0.10"},  {0xA0, 0x02, "> 1.0.10"}, {0xA0, 0x03, "> 1.0.10"},
};

static const struct mip_profile_rate gq7_rates[] = {
    {0x80, 1000}, {0x82, 1000}, {0xA0, 1000}, {0x91, 2}, {0x92, 2}, {0x93, 0},
};

static const struct mip_profile_reading gq7_readings[] = {
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "gq7_continuous_built_in_test"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "gq7_continuous_built_in_test"},
};

const struct mip_profile mip_profile_gq7 = {
    "3dm-gq7",  "3DM-GQ7-GNSS/INS",
    "3dm-gq7",  "Inertial navigation system with two GNSS receivers.",
    6284, /* model number */
    7,    /* generation */
    1,    /* other names */
    2,    /* what is not known */
    167,  /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    6,    /* fields of some firmware */
    6,    /* base rates */
    6,    /* readings */
    gq7_also,   gq7_incomplete,
    gq7_fields, NULL,
    NULL,       gq7_firmware,
    gq7_rates,  gq7_readings,
};

/* 3DM-GV7-AHRS. */

static const char *const gv7_ahrs_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gv7_ahrs_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field gv7_ahrs_fields[] = {
    {0x01, 0x01, "", &gv7_ahrs_evidence[0]},       {0x01, 0x02, "", &gv7_ahrs_evidence[0]},
    {0x01, 0x03, "", &gv7_ahrs_evidence[0]},       {0x01, 0x04, "", &gv7_ahrs_evidence[3]},
    {0x01, 0x05, "", &gv7_ahrs_evidence[4]},       {0x01, 0x06, "", &gv7_ahrs_evidence[0]},
    {0x01, 0x07, "", &gv7_ahrs_evidence[3]},       {0x01, 0x08, "", &gv7_ahrs_evidence[4]},
    {0x01, 0x09, "WRSLD", &gv7_ahrs_evidence[4]},  {0x01, 0x72, "WRA", &gv7_ahrs_evidence[4]},
    {0x01, 0x7E, "", &gv7_ahrs_evidence[4]},       {0x0C, 0x0D, "", &gv7_ahrs_evidence[4]},
    {0x0C, 0x0E, "", &gv7_ahrs_evidence[0]},       {0x0C, 0x0F, "WRSLD", &gv7_ahrs_evidence[0]},
    {0x0C, 0x10, "", &gv7_ahrs_evidence[4]},       {0x0C, 0x11, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x0C, 0x28, "WRSLD", &gv7_ahrs_evidence[1]},  {0x0C, 0x2A, "", &gv7_ahrs_evidence[4]},
    {0x0C, 0x2B, "WRSLD", &gv7_ahrs_evidence[0]},  {0x0C, 0x2C, "", &gv7_ahrs_evidence[4]},
    {0x0C, 0x2D, "", &gv7_ahrs_evidence[4]},       {0x0C, 0x2E, "WRSLD", &gv7_ahrs_evidence[0]},
    {0x0C, 0x2F, "WRSLD", &gv7_ahrs_evidence[0]},  {0x0C, 0x30, "SLD", &gv7_ahrs_evidence[0]},
    {0x0C, 0x31, "WRSLD", &gv7_ahrs_evidence[0]},  {0x0C, 0x32, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x0C, 0x33, "WRSLD", &gv7_ahrs_evidence[4]},  {0x0C, 0x37, "WRSLDA", &gv7_ahrs_evidence[4]},
    {0x0C, 0x38, "WRSLDA", &gv7_ahrs_evidence[4]}, {0x0C, 0x39, "", &gv7_ahrs_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &gv7_ahrs_evidence[4]}, {0x0C, 0x3B, "WRSLDA", &gv7_ahrs_evidence[4]},
    {0x0C, 0x41, "WRSLD", &gv7_ahrs_evidence[2]},  {0x0C, 0x42, "WR", &gv7_ahrs_evidence[4]},
    {0x0C, 0x50, "WRSLD", &gv7_ahrs_evidence[4]},  {0x0C, 0x51, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x0C, 0x52, "WRSLD", &gv7_ahrs_evidence[4]},  {0x0C, 0x53, "", &gv7_ahrs_evidence[4]},
    {0x0C, 0x54, "WRSLD", &gv7_ahrs_evidence[4]},  {0x0D, 0x01, "", &gv7_ahrs_evidence[0]},
    {0x0D, 0x03, "", &gv7_ahrs_evidence[4]},       {0x0D, 0x1A, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x0D, 0x1B, "WRSLD", &gv7_ahrs_evidence[4]},  {0x0D, 0x1D, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x0D, 0x20, "WRSLD", &gv7_ahrs_evidence[4]},  {0x0D, 0x28, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x0D, 0x43, "WRSLD", &gv7_ahrs_evidence[1]},  {0x0D, 0x50, "WRSLD", &gv7_ahrs_evidence[0]},
    {0x0D, 0x53, "WRSLD", &gv7_ahrs_evidence[1]},  {0x13, 0x01, "WRSLD", &gv7_ahrs_evidence[4]},
    {0x13, 0x1F, "WRSLD", &gv7_ahrs_evidence[4]},  {0x13, 0x31, "", &gv7_ahrs_evidence[4]},
    {0x13, 0x32, "", &gv7_ahrs_evidence[4]},       {0x80, 0x04, "", &gv7_ahrs_evidence[4]},
    {0x80, 0x05, "", &gv7_ahrs_evidence[4]},       {0x80, 0x06, "", &gv7_ahrs_evidence[4]},
    {0x80, 0x07, "", &gv7_ahrs_evidence[4]},       {0x80, 0x08, "", &gv7_ahrs_evidence[4]},
    {0x80, 0x09, "", &gv7_ahrs_evidence[4]},       {0x80, 0x0A, "", &gv7_ahrs_evidence[4]},
    {0x80, 0x0C, "", &gv7_ahrs_evidence[4]},       {0x80, 0x14, "", &gv7_ahrs_evidence[4]},
    {0x80, 0x17, "", &gv7_ahrs_evidence[4]},       {0x80, 0x18, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x03, "", &gv7_ahrs_evidence[4]},       {0x82, 0x04, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x05, "", &gv7_ahrs_evidence[0]},       {0x82, 0x06, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x0A, "", &gv7_ahrs_evidence[4]},       {0x82, 0x0B, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x0D, "", &gv7_ahrs_evidence[4]},       {0x82, 0x0E, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x10, "", &gv7_ahrs_evidence[0]},       {0x82, 0x12, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x13, "", &gv7_ahrs_evidence[4]},       {0x82, 0x1C, "", &gv7_ahrs_evidence[4]},
    {0x82, 0x21, "", &gv7_ahrs_evidence[4]},       {0xA0, 0x01, "", &gv7_ahrs_evidence[4]},
    {0xA0, 0x02, "", &gv7_ahrs_evidence[1]},       {0xA0, 0x03, "", &gv7_ahrs_evidence[4]},
    {0xFF, 0xD0, "", &gv7_ahrs_evidence[0]},       {0xFF, 0xD3, "", &gv7_ahrs_evidence[0]},
    {0xFF, 0xD4, "", &gv7_ahrs_evidence[4]},       {0xFF, 0xD5, "", &gv7_ahrs_evidence[4]},
    {0xFF, 0xD6, "", &gv7_ahrs_evidence[4]},       {0xFF, 0xD7, "", &gv7_ahrs_evidence[4]},
    {0xFF, 0xD8, "", &gv7_ahrs_evidence[4]},
};

static const struct mip_profile_field gv7_ahrs_refuses[] = {
    {0x0C, 0x02, "", &gv7_ahrs_evidence[5]}, {0x0C, 0x07, "", &gv7_ahrs_evidence[5]},
    {0x0C, 0x09, "", &gv7_ahrs_evidence[5]}, {0x0C, 0x20, "", &gv7_ahrs_evidence[5]},
    {0x0C, 0x21, "", &gv7_ahrs_evidence[5]}, {0x0C, 0x22, "", &gv7_ahrs_evidence[5]},
    {0x0C, 0x23, "", &gv7_ahrs_evidence[5]}, {0x0C, 0x24, "", &gv7_ahrs_evidence[5]},
    {0x0C, 0x34, "", &gv7_ahrs_evidence[5]}, {0x0C, 0x62, "", &gv7_ahrs_evidence[5]},
    {0x0D, 0x54, "", &gv7_ahrs_evidence[5]}, {0x0D, 0x64, "", &gv7_ahrs_evidence[5]},
    {0x82, 0x34, "", &gv7_ahrs_evidence[5]}, {0x82, 0x35, "", &gv7_ahrs_evidence[5]},
    {0x82, 0x49, "", &gv7_ahrs_evidence[6]},
};

static const struct mip_profile_field gv7_ahrs_absent_sets[] = {
    {0x81, 0, "", &gv7_ahrs_evidence[5]},
    {0x91, 0, "", &gv7_ahrs_evidence[5]},
    {0x92, 0, "", &gv7_ahrs_evidence[5]},
    {0x93, 0, "", &gv7_ahrs_evidence[5]},
};

static const struct mip_profile_reading gv7_ahrs_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_gv7_ahrs = {
    "3dm-gv7-ahrs",
    "3DM-GV7-AHRS",
    "",
    "Attitude and heading reference system.",
    6288, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    87,   /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    8,    /* readings */
    NULL,
    gv7_ahrs_incomplete,
    gv7_ahrs_fields,
    gv7_ahrs_refuses,
    gv7_ahrs_absent_sets,
    NULL,
    NULL,
    gv7_ahrs_readings,
};

/* 3DM-GV7-AR. */

static const char *const gv7_ar_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gv7_ar_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field gv7_ar_fields[] = {
    {0x01, 0x01, "", &gv7_ar_evidence[0]},       {0x01, 0x02, "", &gv7_ar_evidence[0]},
    {0x01, 0x03, "", &gv7_ar_evidence[0]},       {0x01, 0x04, "", &gv7_ar_evidence[3]},
    {0x01, 0x05, "", &gv7_ar_evidence[4]},       {0x01, 0x06, "", &gv7_ar_evidence[0]},
    {0x01, 0x07, "", &gv7_ar_evidence[3]},       {0x01, 0x08, "", &gv7_ar_evidence[4]},
    {0x01, 0x09, "WRSLD", &gv7_ar_evidence[4]},  {0x01, 0x72, "WRA", &gv7_ar_evidence[4]},
    {0x01, 0x7E, "", &gv7_ar_evidence[4]},       {0x0C, 0x0D, "", &gv7_ar_evidence[4]},
    {0x0C, 0x0E, "", &gv7_ar_evidence[0]},       {0x0C, 0x0F, "WRSLD", &gv7_ar_evidence[0]},
    {0x0C, 0x10, "", &gv7_ar_evidence[4]},       {0x0C, 0x11, "WRSLD", &gv7_ar_evidence[4]},
    {0x0C, 0x28, "WRSLD", &gv7_ar_evidence[1]},  {0x0C, 0x2A, "", &gv7_ar_evidence[4]},
    {0x0C, 0x2B, "WRSLD", &gv7_ar_evidence[0]},  {0x0C, 0x2C, "", &gv7_ar_evidence[4]},
    {0x0C, 0x2D, "", &gv7_ar_evidence[4]},       {0x0C, 0x2E, "WRSLD", &gv7_ar_evidence[0]},
    {0x0C, 0x2F, "WRSLD", &gv7_ar_evidence[0]},  {0x0C, 0x30, "SLD", &gv7_ar_evidence[0]},
    {0x0C, 0x31, "WRSLD", &gv7_ar_evidence[0]},  {0x0C, 0x32, "WRSLD", &gv7_ar_evidence[4]},
    {0x0C, 0x33, "WRSLD", &gv7_ar_evidence[4]},  {0x0C, 0x37, "WRSLDA", &gv7_ar_evidence[4]},
    {0x0C, 0x38, "WRSLDA", &gv7_ar_evidence[4]}, {0x0C, 0x39, "", &gv7_ar_evidence[0]},
    {0x0C, 0x41, "WRSLD", &gv7_ar_evidence[2]},  {0x0C, 0x42, "WR", &gv7_ar_evidence[4]},
    {0x0C, 0x50, "WRSLD", &gv7_ar_evidence[4]},  {0x0C, 0x51, "WRSLD", &gv7_ar_evidence[4]},
    {0x0C, 0x52, "WRSLD", &gv7_ar_evidence[4]},  {0x0C, 0x53, "", &gv7_ar_evidence[4]},
    {0x0C, 0x54, "WRSLD", &gv7_ar_evidence[4]},  {0x0D, 0x01, "", &gv7_ar_evidence[0]},
    {0x0D, 0x03, "", &gv7_ar_evidence[4]},       {0x0D, 0x1A, "WRSLD", &gv7_ar_evidence[4]},
    {0x0D, 0x1B, "WRSLD", &gv7_ar_evidence[4]},  {0x0D, 0x1D, "WRSLD", &gv7_ar_evidence[4]},
    {0x0D, 0x20, "WRSLD", &gv7_ar_evidence[4]},  {0x0D, 0x28, "WRSLD", &gv7_ar_evidence[4]},
    {0x0D, 0x50, "WRSLD", &gv7_ar_evidence[1]},  {0x0D, 0x53, "WRSLD", &gv7_ar_evidence[1]},
    {0x13, 0x01, "WRSLD", &gv7_ar_evidence[4]},  {0x13, 0x1F, "WRSLD", &gv7_ar_evidence[4]},
    {0x13, 0x31, "", &gv7_ar_evidence[4]},       {0x13, 0x32, "", &gv7_ar_evidence[4]},
    {0x80, 0x04, "", &gv7_ar_evidence[4]},       {0x80, 0x05, "", &gv7_ar_evidence[4]},
    {0x80, 0x07, "", &gv7_ar_evidence[4]},       {0x80, 0x08, "", &gv7_ar_evidence[4]},
    {0x80, 0x09, "", &gv7_ar_evidence[4]},       {0x80, 0x0A, "", &gv7_ar_evidence[4]},
    {0x80, 0x0C, "", &gv7_ar_evidence[4]},       {0x80, 0x14, "", &gv7_ar_evidence[4]},
    {0x80, 0x17, "", &gv7_ar_evidence[4]},       {0x80, 0x18, "", &gv7_ar_evidence[4]},
    {0x82, 0x03, "", &gv7_ar_evidence[4]},       {0x82, 0x04, "", &gv7_ar_evidence[4]},
    {0x82, 0x05, "", &gv7_ar_evidence[0]},       {0x82, 0x06, "", &gv7_ar_evidence[4]},
    {0x82, 0x0A, "", &gv7_ar_evidence[4]},       {0x82, 0x0B, "", &gv7_ar_evidence[4]},
    {0x82, 0x0D, "", &gv7_ar_evidence[4]},       {0x82, 0x0E, "", &gv7_ar_evidence[4]},
    {0x82, 0x10, "", &gv7_ar_evidence[0]},       {0x82, 0x12, "", &gv7_ar_evidence[4]},
    {0x82, 0x13, "", &gv7_ar_evidence[4]},       {0x82, 0x1C, "", &gv7_ar_evidence[4]},
    {0x82, 0x21, "", &gv7_ar_evidence[4]},       {0xA0, 0x01, "", &gv7_ar_evidence[4]},
    {0xA0, 0x02, "", &gv7_ar_evidence[1]},       {0xA0, 0x03, "", &gv7_ar_evidence[4]},
    {0xFF, 0xD0, "", &gv7_ar_evidence[0]},       {0xFF, 0xD3, "", &gv7_ar_evidence[0]},
    {0xFF, 0xD4, "", &gv7_ar_evidence[4]},       {0xFF, 0xD5, "", &gv7_ar_evidence[4]},
    {0xFF, 0xD6, "", &gv7_ar_evidence[4]},       {0xFF, 0xD7, "", &gv7_ar_evidence[4]},
    {0xFF, 0xD8, "", &gv7_ar_evidence[4]},
};

static const struct mip_profile_field gv7_ar_refuses[] = {
    {0x0C, 0x02, "", &gv7_ar_evidence[5]}, {0x0C, 0x07, "", &gv7_ar_evidence[5]},
    {0x0C, 0x09, "", &gv7_ar_evidence[5]}, {0x0C, 0x20, "", &gv7_ar_evidence[5]},
    {0x0C, 0x21, "", &gv7_ar_evidence[5]}, {0x0C, 0x22, "", &gv7_ar_evidence[5]},
    {0x0C, 0x23, "", &gv7_ar_evidence[5]}, {0x0C, 0x24, "", &gv7_ar_evidence[5]},
    {0x0C, 0x34, "", &gv7_ar_evidence[5]}, {0x0C, 0x3A, "", &gv7_ar_evidence[6]},
    {0x0C, 0x3B, "", &gv7_ar_evidence[6]}, {0x0C, 0x62, "", &gv7_ar_evidence[5]},
    {0x0D, 0x27, "", &gv7_ar_evidence[6]}, {0x0D, 0x2B, "", &gv7_ar_evidence[6]},
    {0x0D, 0x2C, "", &gv7_ar_evidence[6]}, {0x0D, 0x42, "", &gv7_ar_evidence[6]},
    {0x0D, 0x43, "", &gv7_ar_evidence[6]}, {0x0D, 0x45, "", &gv7_ar_evidence[6]},
    {0x0D, 0x46, "", &gv7_ar_evidence[6]}, {0x0D, 0x4C, "", &gv7_ar_evidence[6]},
    {0x0D, 0x4D, "", &gv7_ar_evidence[6]}, {0x0D, 0x54, "", &gv7_ar_evidence[5]},
    {0x0D, 0x64, "", &gv7_ar_evidence[5]}, {0x80, 0x03, "", &gv7_ar_evidence[6]},
    {0x80, 0x06, "", &gv7_ar_evidence[6]}, {0x82, 0x1A, "", &gv7_ar_evidence[6]},
    {0x82, 0x1B, "", &gv7_ar_evidence[6]}, {0x82, 0x25, "", &gv7_ar_evidence[6]},
    {0x82, 0x26, "", &gv7_ar_evidence[6]}, {0x82, 0x28, "", &gv7_ar_evidence[6]},
    {0x82, 0x29, "", &gv7_ar_evidence[6]}, {0x82, 0x2A, "", &gv7_ar_evidence[6]},
    {0x82, 0x2C, "", &gv7_ar_evidence[6]}, {0x82, 0x34, "", &gv7_ar_evidence[5]},
    {0x82, 0x35, "", &gv7_ar_evidence[5]}, {0x82, 0x49, "", &gv7_ar_evidence[7]},
};

static const struct mip_profile_field gv7_ar_absent_sets[] = {
    {0x81, 0, "", &gv7_ar_evidence[5]},
    {0x91, 0, "", &gv7_ar_evidence[5]},
    {0x92, 0, "", &gv7_ar_evidence[5]},
    {0x93, 0, "", &gv7_ar_evidence[5]},
};

static const struct mip_profile_reading gv7_ar_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_gv7_ar = {
    "3dm-gv7-ar",
    "3DM-GV7-AR",
    "",
    "Attitude reference.",
    6289, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    83,   /* fields */
    36,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    8,    /* readings */
    NULL,
    gv7_ar_incomplete,
    gv7_ar_fields,
    gv7_ar_refuses,
    gv7_ar_absent_sets,
    NULL,
    NULL,
    gv7_ar_readings,
};

/* 3DM-GV7-INS. */

static const char *const gv7_ins_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gv7_ins_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver of the vendor: Example configurations).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field gv7_ins_fields[] = {
    {0x01, 0x01, "", &gv7_ins_evidence[0]},       {0x01, 0x02, "", &gv7_ins_evidence[0]},
    {0x01, 0x03, "", &gv7_ins_evidence[0]},       {0x01, 0x04, "", &gv7_ins_evidence[3]},
    {0x01, 0x05, "", &gv7_ins_evidence[4]},       {0x01, 0x06, "", &gv7_ins_evidence[0]},
    {0x01, 0x07, "", &gv7_ins_evidence[3]},       {0x01, 0x08, "", &gv7_ins_evidence[4]},
    {0x01, 0x09, "WRSLD", &gv7_ins_evidence[1]},  {0x01, 0x72, "WRA", &gv7_ins_evidence[4]},
    {0x01, 0x7E, "", &gv7_ins_evidence[4]},       {0x0C, 0x04, "", &gv7_ins_evidence[4]},
    {0x0C, 0x0C, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x0D, "", &gv7_ins_evidence[4]},
    {0x0C, 0x0E, "", &gv7_ins_evidence[0]},       {0x0C, 0x0F, "WRSLD", &gv7_ins_evidence[0]},
    {0x0C, 0x10, "", &gv7_ins_evidence[4]},       {0x0C, 0x11, "WRSLD", &gv7_ins_evidence[4]},
    {0x0C, 0x28, "WRSLD", &gv7_ins_evidence[1]},  {0x0C, 0x2A, "", &gv7_ins_evidence[4]},
    {0x0C, 0x2B, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x2C, "", &gv7_ins_evidence[4]},
    {0x0C, 0x2D, "", &gv7_ins_evidence[4]},       {0x0C, 0x2E, "WRSLD", &gv7_ins_evidence[4]},
    {0x0C, 0x2F, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x30, "SLD", &gv7_ins_evidence[0]},
    {0x0C, 0x31, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x32, "WRSLD", &gv7_ins_evidence[4]},
    {0x0C, 0x33, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x37, "WRSLDA", &gv7_ins_evidence[4]},
    {0x0C, 0x38, "WRSLDA", &gv7_ins_evidence[4]}, {0x0C, 0x39, "", &gv7_ins_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &gv7_ins_evidence[4]}, {0x0C, 0x3B, "WRSLDA", &gv7_ins_evidence[4]},
    {0x0C, 0x41, "WRSLD", &gv7_ins_evidence[1]},  {0x0C, 0x42, "WR", &gv7_ins_evidence[1]},
    {0x0C, 0x50, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x51, "WRSLD", &gv7_ins_evidence[4]},
    {0x0C, 0x52, "WRSLD", &gv7_ins_evidence[4]},  {0x0C, 0x53, "", &gv7_ins_evidence[4]},
    {0x0C, 0x54, "WRSLD", &gv7_ins_evidence[4]},  {0x0D, 0x01, "", &gv7_ins_evidence[0]},
    {0x0D, 0x03, "", &gv7_ins_evidence[4]},       {0x0D, 0x05, "", &gv7_ins_evidence[4]},
    {0x0D, 0x13, "WRSLD", &gv7_ins_evidence[1]},  {0x0D, 0x15, "WRSLD", &gv7_ins_evidence[4]},
    {0x0D, 0x17, "", &gv7_ins_evidence[4]},       {0x0D, 0x1A, "WRSLD", &gv7_ins_evidence[4]},
    {0x0D, 0x1B, "WRSLD", &gv7_ins_evidence[4]},  {0x0D, 0x1C, "WRSLD", &gv7_ins_evidence[4]},
    {0x0D, 0x1D, "WRSLD", &gv7_ins_evidence[4]},  {0x0D, 0x1F, "", &gv7_ins_evidence[4]},
    {0x0D, 0x20, "WRSLD", &gv7_ins_evidence[4]},  {0x0D, 0x28, "WRSLD", &gv7_ins_evidence[4]},
    {0x0D, 0x43, "WRSLD", &gv7_ins_evidence[1]},  {0x0D, 0x50, "WRSLD", &gv7_ins_evidence[0]},
    {0x0D, 0x52, "WRSLD", &gv7_ins_evidence[0]},  {0x0D, 0x53, "WRSLD", &gv7_ins_evidence[2]},
    {0x0D, 0x55, "WRSLD", &gv7_ins_evidence[1]},  {0x0D, 0x56, "WRSLD", &gv7_ins_evidence[4]},
    {0x13, 0x01, "WRSLD", &gv7_ins_evidence[0]},  {0x13, 0x1F, "WRSLD", &gv7_ins_evidence[4]},
    {0x13, 0x21, "", &gv7_ins_evidence[4]},       {0x13, 0x22, "", &gv7_ins_evidence[0]},
    {0x13, 0x23, "", &gv7_ins_evidence[4]},       {0x13, 0x28, "", &gv7_ins_evidence[4]},
    {0x13, 0x29, "", &gv7_ins_evidence[0]},       {0x13, 0x2A, "", &gv7_ins_evidence[0]},
    {0x13, 0x31, "", &gv7_ins_evidence[0]},       {0x13, 0x32, "", &gv7_ins_evidence[4]},
    {0x13, 0x33, "", &gv7_ins_evidence[4]},       {0x80, 0x04, "", &gv7_ins_evidence[4]},
    {0x80, 0x05, "", &gv7_ins_evidence[4]},       {0x80, 0x06, "", &gv7_ins_evidence[4]},
    {0x80, 0x07, "", &gv7_ins_evidence[4]},       {0x80, 0x08, "", &gv7_ins_evidence[4]},
    {0x80, 0x09, "", &gv7_ins_evidence[4]},       {0x80, 0x0A, "", &gv7_ins_evidence[4]},
    {0x80, 0x0C, "", &gv7_ins_evidence[4]},       {0x80, 0x14, "", &gv7_ins_evidence[4]},
    {0x80, 0x17, "", &gv7_ins_evidence[4]},       {0x80, 0x18, "", &gv7_ins_evidence[4]},
    {0x82, 0x01, "", &gv7_ins_evidence[0]},       {0x82, 0x02, "", &gv7_ins_evidence[0]},
    {0x82, 0x03, "", &gv7_ins_evidence[4]},       {0x82, 0x04, "", &gv7_ins_evidence[4]},
    {0x82, 0x05, "", &gv7_ins_evidence[0]},       {0x82, 0x06, "", &gv7_ins_evidence[4]},
    {0x82, 0x07, "", &gv7_ins_evidence[4]},       {0x82, 0x08, "", &gv7_ins_evidence[4]},
    {0x82, 0x09, "", &gv7_ins_evidence[4]},       {0x82, 0x0A, "", &gv7_ins_evidence[4]},
    {0x82, 0x0B, "", &gv7_ins_evidence[4]},       {0x82, 0x0C, "", &gv7_ins_evidence[4]},
    {0x82, 0x0D, "", &gv7_ins_evidence[4]},       {0x82, 0x0E, "", &gv7_ins_evidence[4]},
    {0x82, 0x10, "", &gv7_ins_evidence[0]},       {0x82, 0x12, "", &gv7_ins_evidence[4]},
    {0x82, 0x13, "", &gv7_ins_evidence[4]},       {0x82, 0x15, "", &gv7_ins_evidence[4]},
    {0x82, 0x1C, "", &gv7_ins_evidence[4]},       {0x82, 0x21, "", &gv7_ins_evidence[4]},
    {0x82, 0x36, "", &gv7_ins_evidence[1]},       {0x82, 0x37, "", &gv7_ins_evidence[4]},
    {0x82, 0x40, "", &gv7_ins_evidence[1]},       {0x82, 0x41, "", &gv7_ins_evidence[4]},
    {0x82, 0x42, "", &gv7_ins_evidence[1]},       {0x82, 0x43, "", &gv7_ins_evidence[4]},
    {0x82, 0x46, "", &gv7_ins_evidence[1]},       {0x82, 0x50, "", &gv7_ins_evidence[4]},
    {0x82, 0x51, "", &gv7_ins_evidence[4]},       {0x94, 0x03, "", &gv7_ins_evidence[4]},
    {0x94, 0x05, "", &gv7_ins_evidence[4]},       {0x94, 0x08, "", &gv7_ins_evidence[4]},
    {0x94, 0x0B, "", &gv7_ins_evidence[4]},       {0x94, 0x20, "", &gv7_ins_evidence[4]},
    {0xA0, 0x01, "", &gv7_ins_evidence[4]},       {0xA0, 0x02, "", &gv7_ins_evidence[4]},
    {0xA0, 0x03, "", &gv7_ins_evidence[4]},       {0xFF, 0xD0, "", &gv7_ins_evidence[4]},
    {0xFF, 0xD3, "", &gv7_ins_evidence[0]},       {0xFF, 0xD4, "", &gv7_ins_evidence[4]},
    {0xFF, 0xD5, "", &gv7_ins_evidence[4]},       {0xFF, 0xD6, "", &gv7_ins_evidence[4]},
    {0xFF, 0xD7, "", &gv7_ins_evidence[4]},       {0xFF, 0xD8, "", &gv7_ins_evidence[4]},
};

static const struct mip_profile_field gv7_ins_refuses[] = {
    {0x0C, 0x02, "", &gv7_ins_evidence[5]}, {0x0C, 0x07, "", &gv7_ins_evidence[5]},
    {0x0C, 0x09, "", &gv7_ins_evidence[5]}, {0x0C, 0x20, "", &gv7_ins_evidence[5]},
    {0x0C, 0x21, "", &gv7_ins_evidence[5]}, {0x0C, 0x22, "", &gv7_ins_evidence[5]},
    {0x0C, 0x23, "", &gv7_ins_evidence[5]}, {0x0C, 0x24, "", &gv7_ins_evidence[5]},
    {0x0C, 0x34, "", &gv7_ins_evidence[5]}, {0x0C, 0x62, "", &gv7_ins_evidence[5]},
    {0x0D, 0x54, "", &gv7_ins_evidence[5]}, {0x0D, 0x64, "", &gv7_ins_evidence[5]},
    {0x82, 0x34, "", &gv7_ins_evidence[5]}, {0x82, 0x35, "", &gv7_ins_evidence[5]},
    {0x82, 0x49, "", &gv7_ins_evidence[6]},
};

static const struct mip_profile_field gv7_ins_absent_sets[] = {
    {0x81, 0, "", &gv7_ins_evidence[5]},
    {0x91, 0, "", &gv7_ins_evidence[5]},
    {0x92, 0, "", &gv7_ins_evidence[5]},
    {0x93, 0, "", &gv7_ins_evidence[5]},
};

static const struct mip_profile_reading gv7_ins_readings[] = {
    {"base.comm_speed.port", "comm_interface"},
    {"base.built_in_test_response.result", "cv7_built_in_test"},
    {"base.continuous_built_in_test_response.result", "cv7_inertial_continuous_built_in_test"},
    {"base.comm_speed_response.port", "comm_interface"},
    {"filter_data.status.filter_state", "filter_data.cv7_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.cv7_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.cv7_status_flags"},
    {"system_data.built_in_test.result", "cv7_inertial_continuous_built_in_test"},
};

const struct mip_profile mip_profile_gv7_ins = {
    "3dm-gv7-ins",
    "3DM-GV7-INS",
    "",
    "Inertial navigation system.",
    6290, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    126,  /* fields */
    15,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    8,    /* readings */
    NULL,
    gv7_ins_incomplete,
    gv7_ins_fields,
    gv7_ins_refuses,
    gv7_ins_absent_sets,
    NULL,
    NULL,
    gv7_ins_readings,
};

/* 3DM-GX3-15. */

static const char *const gx3_15_incomplete[] = {
    "Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",
};

static const struct mip_profile_evidence gx3_15_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX3-35.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires a pressure sensor, which the device lacks.",
     "has no pressure sensor"},
};

static const struct mip_profile_field gx3_15_fields[] = {
    {0x01, 0x01, "", &gx3_15_evidence[1]},      {0x01, 0x02, "", &gx3_15_evidence[1]},
    {0x01, 0x03, "", &gx3_15_evidence[1]},      {0x01, 0x04, "", &gx3_15_evidence[1]},
    {0x01, 0x05, "", &gx3_15_evidence[1]},      {0x01, 0x06, "", &gx3_15_evidence[1]},
    {0x0C, 0x01, "", &gx3_15_evidence[1]},      {0x0C, 0x06, "", &gx3_15_evidence[1]},
    {0x0C, 0x08, "WRSLD", &gx3_15_evidence[1]}, {0x0C, 0x11, "WRSLD", &gx3_15_evidence[1]},
    {0x0C, 0x35, "WRSLD", &gx3_15_evidence[0]}, {0x0C, 0x36, "WR", &gx3_15_evidence[1]},
    {0x0C, 0x61, "WRSLD", &gx3_15_evidence[1]}, {0x0C, 0x64, "", &gx3_15_evidence[1]},
    {0x80, 0x04, "", &gx3_15_evidence[1]},      {0x80, 0x05, "", &gx3_15_evidence[1]},
};

static const struct mip_profile_field gx3_15_refuses[] = {
    {0x0C, 0x02, "", &gx3_15_evidence[2]}, {0x0C, 0x07, "", &gx3_15_evidence[2]},
    {0x0C, 0x09, "", &gx3_15_evidence[2]}, {0x0C, 0x20, "", &gx3_15_evidence[2]},
    {0x0C, 0x21, "", &gx3_15_evidence[2]}, {0x0C, 0x22, "", &gx3_15_evidence[2]},
    {0x0C, 0x23, "", &gx3_15_evidence[2]}, {0x0C, 0x24, "", &gx3_15_evidence[2]},
    {0x0C, 0x34, "", &gx3_15_evidence[2]}, {0x0C, 0x3A, "", &gx3_15_evidence[3]},
    {0x0C, 0x3B, "", &gx3_15_evidence[3]}, {0x0C, 0x62, "", &gx3_15_evidence[2]},
    {0x80, 0x03, "", &gx3_15_evidence[3]}, {0x80, 0x06, "", &gx3_15_evidence[3]},
    {0x80, 0x16, "", &gx3_15_evidence[4]}, {0x80, 0x17, "", &gx3_15_evidence[4]},
};

static const struct mip_profile_field gx3_15_absent_sets[] = {
    {0x81, 0, "", &gx3_15_evidence[2]},
    {0x91, 0, "", &gx3_15_evidence[2]},
    {0x92, 0, "", &gx3_15_evidence[2]},
    {0x93, 0, "", &gx3_15_evidence[2]},
};

static const struct mip_profile_reading gx3_15_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx3_15 = {
    "3dm-gx3-15",
    "3DM-GX3-15",
    "",
    "Inertial sensor of generation 3.",
    6227, /* model number */
    3,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    16,   /* fields */
    16,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    gx3_15_incomplete,
    gx3_15_fields,
    gx3_15_refuses,
    gx3_15_absent_sets,
    NULL,
    NULL,
    gx3_15_readings,
};

/* 3DM-GX3-25. */

static const char *const gx3_25_incomplete[] = {
    "Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",
};

static const struct mip_profile_evidence gx3_25_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MIP SDK of 2014: Examples, one for each model).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX3-35.", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (ROS driver of the vendor: Issue 347).", ""},
    {MIP_SUPPORT_NO,
     "Rejected by the device (firmware 2.0.06; ROS driver of the vendor: Issue 213).", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a pressure sensor, which the device lacks.",
     "has no pressure sensor"},
};

static const struct mip_profile_field gx3_25_fields[] = {
    {0x01, 0x01, "", &gx3_25_evidence[2]},      {0x01, 0x02, "", &gx3_25_evidence[2]},
    {0x01, 0x03, "", &gx3_25_evidence[2]},      {0x01, 0x04, "", &gx3_25_evidence[2]},
    {0x01, 0x05, "", &gx3_25_evidence[2]},      {0x01, 0x06, "", &gx3_25_evidence[2]},
    {0x0C, 0x01, "", &gx3_25_evidence[2]},      {0x0C, 0x06, "", &gx3_25_evidence[2]},
    {0x0C, 0x08, "WRSLD", &gx3_25_evidence[2]}, {0x0C, 0x11, "WRSLD", &gx3_25_evidence[2]},
    {0x0C, 0x35, "WRSLD", &gx3_25_evidence[0]}, {0x0C, 0x36, "WR", &gx3_25_evidence[2]},
    {0x0C, 0x61, "WRSLD", &gx3_25_evidence[1]}, {0x0C, 0x64, "", &gx3_25_evidence[2]},
    {0x80, 0x04, "", &gx3_25_evidence[2]},      {0x80, 0x05, "", &gx3_25_evidence[2]},
    {0x80, 0x06, "", &gx3_25_evidence[2]},
};

static const struct mip_profile_field gx3_25_refuses[] = {
    {0x0C, 0x02, "", &gx3_25_evidence[5]},      {0x0C, 0x07, "", &gx3_25_evidence[5]},
    {0x0C, 0x09, "", &gx3_25_evidence[5]},      {0x0C, 0x0C, "WRSLD", &gx3_25_evidence[3]},
    {0x0C, 0x20, "", &gx3_25_evidence[5]},      {0x0C, 0x21, "", &gx3_25_evidence[5]},
    {0x0C, 0x22, "WRSLD", &gx3_25_evidence[3]}, {0x0C, 0x23, "", &gx3_25_evidence[5]},
    {0x0C, 0x24, "", &gx3_25_evidence[5]},      {0x0C, 0x34, "", &gx3_25_evidence[5]},
    {0x0C, 0x43, "WRSLD", &gx3_25_evidence[3]}, {0x0C, 0x62, "", &gx3_25_evidence[5]},
    {0x0D, 0x10, "WRSLD", &gx3_25_evidence[3]}, {0x0D, 0x13, "WRSLD", &gx3_25_evidence[3]},
    {0x0D, 0x43, "WRSLD", &gx3_25_evidence[3]}, {0x0D, 0x54, "WRSLD", &gx3_25_evidence[3]},
    {0x0E, 0x02, "WRSLD", &gx3_25_evidence[3]}, {0x0E, 0x10, "WRSLD", &gx3_25_evidence[3]},
    {0x80, 0x16, "", &gx3_25_evidence[6]},      {0x80, 0x17, "", &gx3_25_evidence[6]},
    {0x81, 0x03, "", &gx3_25_evidence[4]},      {0x81, 0x05, "", &gx3_25_evidence[4]},
    {0x81, 0x0B, "", &gx3_25_evidence[4]},      {0x82, 0x01, "", &gx3_25_evidence[3]},
    {0x82, 0x02, "", &gx3_25_evidence[3]},      {0x82, 0x03, "", &gx3_25_evidence[3]},
    {0x82, 0x08, "", &gx3_25_evidence[3]},      {0x82, 0x09, "", &gx3_25_evidence[3]},
    {0x82, 0x0A, "", &gx3_25_evidence[3]},      {0x82, 0x0E, "", &gx3_25_evidence[3]},
    {0x82, 0x10, "", &gx3_25_evidence[3]},      {0x82, 0x36, "", &gx3_25_evidence[3]},
    {0x82, 0x37, "", &gx3_25_evidence[3]},      {0x82, 0x40, "", &gx3_25_evidence[3]},
    {0x82, 0x41, "", &gx3_25_evidence[3]},      {0x82, 0x43, "", &gx3_25_evidence[4]},
    {0x91, 0x03, "", &gx3_25_evidence[4]},      {0x91, 0x05, "", &gx3_25_evidence[4]},
    {0x91, 0x0B, "", &gx3_25_evidence[4]},
};

static const struct mip_profile_field gx3_25_absent_sets[] = {
    {0x81, 0, "", &gx3_25_evidence[5]},
    {0x91, 0, "", &gx3_25_evidence[5]},
    {0x92, 0, "", &gx3_25_evidence[5]},
    {0x93, 0, "", &gx3_25_evidence[5]},
};

static const struct mip_profile_reading gx3_25_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
};

const struct mip_profile mip_profile_gx3_25 = {
    "3dm-gx3-25",
    "3DM-GX3-25",
    "",
    "Inertial sensor of generation 3.",
    6223, /* model number */
    3,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    17,   /* fields */
    39,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    3,    /* readings */
    NULL,
    gx3_25_incomplete,
    gx3_25_fields,
    gx3_25_refuses,
    gx3_25_absent_sets,
    NULL,
    NULL,
    gx3_25_readings,
};

/* 3DM-GX3-35. */

static const char *const gx3_35_incomplete[] = {
    "Its manual (1.00 of 2011-01-04) is not known.",
};

static const struct mip_profile_evidence gx3_35_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MIP SDK of 2014: Examples, one for each model).", ""},
    {MIP_SUPPORT_NO, "Requires a pressure sensor, which the device lacks.",
     "has no pressure sensor"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field gx3_35_fields[] = {
    {0x01, 0x01, "", &gx3_35_evidence[0]},      {0x01, 0x02, "", &gx3_35_evidence[0]},
    {0x01, 0x03, "", &gx3_35_evidence[0]},      {0x01, 0x04, "", &gx3_35_evidence[0]},
    {0x01, 0x05, "", &gx3_35_evidence[0]},      {0x01, 0x06, "", &gx3_35_evidence[0]},
    {0x0C, 0x01, "", &gx3_35_evidence[0]},      {0x0C, 0x02, "", &gx3_35_evidence[0]},
    {0x0C, 0x06, "", &gx3_35_evidence[0]},      {0x0C, 0x07, "", &gx3_35_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx3_35_evidence[0]}, {0x0C, 0x09, "WRSLD", &gx3_35_evidence[0]},
    {0x0C, 0x11, "WRSLD", &gx3_35_evidence[0]}, {0x0C, 0x34, "WRSLD", &gx3_35_evidence[0]},
    {0x0C, 0x35, "WRSLD", &gx3_35_evidence[0]}, {0x0C, 0x36, "WR", &gx3_35_evidence[0]},
    {0x0C, 0x60, "WRSLD", &gx3_35_evidence[0]}, {0x0C, 0x61, "WRSLD", &gx3_35_evidence[0]},
    {0x0C, 0x62, "SLD", &gx3_35_evidence[1]},   {0x0C, 0x64, "", &gx3_35_evidence[0]},
    {0x7F, 0x10, "WRSLD", &gx3_35_evidence[0]}, {0x80, 0x04, "", &gx3_35_evidence[0]},
    {0x80, 0x05, "", &gx3_35_evidence[0]},      {0x80, 0x06, "", &gx3_35_evidence[0]},
    {0x81, 0x03, "", &gx3_35_evidence[0]},      {0x81, 0x05, "", &gx3_35_evidence[0]},
    {0x81, 0x09, "", &gx3_35_evidence[0]},
};

static const struct mip_profile_field gx3_35_refuses[] = {
    {0x80, 0x16, "", &gx3_35_evidence[2]},
    {0x80, 0x17, "", &gx3_35_evidence[2]},
};

static const struct mip_profile_field gx3_35_absent_sets[] = {
    {0x92, 0, "", &gx3_35_evidence[3]},
};

static const struct mip_profile_reading gx3_35_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx3_35 = {
    "3dm-gx3-35",
    "3DM-GX3-35",
    "",
    "Inertial sensor of generation 3.",
    6225, /* model number */
    3,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    27,   /* fields */
    2,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    gx3_35_incomplete,
    gx3_35_fields,
    gx3_35_refuses,
    gx3_35_absent_sets,
    NULL,
    NULL,
    gx3_35_readings,
};

/* 3DM-GX3-45. */

static const char *const gx3_45_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gx3_45_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX3-35.", ""},
    {MIP_SUPPORT_NO, "Requires a pressure sensor, which the device lacks.",
     "has no pressure sensor"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field gx3_45_fields[] = {
    {0x01, 0x01, "", &gx3_45_evidence[0]},      {0x01, 0x02, "", &gx3_45_evidence[0]},
    {0x01, 0x03, "", &gx3_45_evidence[0]},      {0x01, 0x04, "", &gx3_45_evidence[0]},
    {0x01, 0x05, "", &gx3_45_evidence[0]},      {0x01, 0x06, "", &gx3_45_evidence[2]},
    {0x0C, 0x01, "", &gx3_45_evidence[2]},      {0x0C, 0x02, "", &gx3_45_evidence[2]},
    {0x0C, 0x06, "", &gx3_45_evidence[0]},      {0x0C, 0x07, "", &gx3_45_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx3_45_evidence[0]}, {0x0C, 0x09, "WRSLD", &gx3_45_evidence[0]},
    {0x0C, 0x0A, "WRSLD", &gx3_45_evidence[0]}, {0x0C, 0x0B, "", &gx3_45_evidence[0]},
    {0x0C, 0x11, "WRSLD", &gx3_45_evidence[0]}, {0x0C, 0x35, "WRSLD", &gx3_45_evidence[2]},
    {0x0C, 0x36, "WR", &gx3_45_evidence[2]},    {0x0C, 0x64, "", &gx3_45_evidence[2]},
    {0x0D, 0x01, "", &gx3_45_evidence[0]},      {0x0D, 0x02, "", &gx3_45_evidence[0]},
    {0x0D, 0x03, "", &gx3_45_evidence[0]},      {0x0D, 0x04, "", &gx3_45_evidence[0]},
    {0x0D, 0x10, "WRSLD", &gx3_45_evidence[0]}, {0x0D, 0x11, "WRSLD", &gx3_45_evidence[0]},
    {0x0D, 0x12, "WRSLD", &gx3_45_evidence[0]}, {0x0D, 0x13, "WRSLD", &gx3_45_evidence[0]},
    {0x0D, 0x14, "WRSLD", &gx3_45_evidence[0]}, {0x0D, 0x15, "WRSLD", &gx3_45_evidence[0]},
    {0x0D, 0x18, "WRSLD", &gx3_45_evidence[0]}, {0x0D, 0x19, "WRSLD", &gx3_45_evidence[0]},
    {0x0D, 0x1A, "WRSLD", &gx3_45_evidence[0]}, {0x0D, 0x1B, "WRSLD", &gx3_45_evidence[0]},
    {0x0D, 0x1D, "WRSLD", &gx3_45_evidence[0]}, {0x0D, 0x44, "WRSLD", &gx3_45_evidence[1]},
    {0x0D, 0x45, "WRSLD", &gx3_45_evidence[1]}, {0x7F, 0x10, "WRSLD", &gx3_45_evidence[0]},
    {0x80, 0x04, "", &gx3_45_evidence[0]},      {0x80, 0x05, "", &gx3_45_evidence[0]},
    {0x80, 0x06, "", &gx3_45_evidence[0]},      {0x81, 0x03, "", &gx3_45_evidence[0]},
    {0x81, 0x05, "", &gx3_45_evidence[0]},      {0x81, 0x09, "", &gx3_45_evidence[0]},
    {0x82, 0x01, "", &gx3_45_evidence[0]},      {0x82, 0x02, "", &gx3_45_evidence[0]},
    {0x82, 0x05, "", &gx3_45_evidence[0]},
};

static const struct mip_profile_field gx3_45_refuses[] = {
    {0x0D, 0x29, "", &gx3_45_evidence[3]}, {0x0D, 0x47, "", &gx3_45_evidence[3]},
    {0x80, 0x16, "", &gx3_45_evidence[3]}, {0x80, 0x17, "", &gx3_45_evidence[3]},
    {0x82, 0x21, "", &gx3_45_evidence[3]}, {0x82, 0x49, "", &gx3_45_evidence[4]},
};

static const struct mip_profile_field gx3_45_absent_sets[] = {
    {0x92, 0, "", &gx3_45_evidence[5]},
};

static const struct mip_profile_reading gx3_45_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx3_45 = {
    "3dm-gx3-45",
    "3DM-GX3-45",
    "",
    "Inertial sensor of generation 3.",
    6228, /* model number */
    3,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    45,   /* fields */
    6,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    gx3_45_incomplete,
    gx3_45_fields,
    gx3_45_refuses,
    gx3_45_absent_sets,
    NULL,
    NULL,
    gx3_45_readings,
};

/* 3DM-GX4-15. */

static const char *const gx4_15_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gx4_15_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX4-25.", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field gx4_15_fields[] = {
    {0x01, 0x01, "", &gx4_15_evidence[0]},       {0x01, 0x02, "", &gx4_15_evidence[0]},
    {0x01, 0x03, "", &gx4_15_evidence[0]},       {0x01, 0x04, "", &gx4_15_evidence[0]},
    {0x01, 0x05, "", &gx4_15_evidence[0]},       {0x01, 0x06, "", &gx4_15_evidence[1]},
    {0x01, 0x7E, "", &gx4_15_evidence[1]},       {0x0C, 0x01, "", &gx4_15_evidence[0]},
    {0x0C, 0x03, "", &gx4_15_evidence[0]},       {0x0C, 0x06, "", &gx4_15_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx4_15_evidence[0]},  {0x0C, 0x0A, "WRSLD", &gx4_15_evidence[0]},
    {0x0C, 0x0B, "", &gx4_15_evidence[0]},       {0x0C, 0x11, "WRSLD", &gx4_15_evidence[0]},
    {0x0C, 0x30, "SLD", &gx4_15_evidence[1]},    {0x0C, 0x37, "WRSLDA", &gx4_15_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &gx4_15_evidence[0]}, {0x0C, 0x39, "", &gx4_15_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &gx4_15_evidence[1]},  {0x0C, 0x40, "WRSLD", &gx4_15_evidence[1]},
    {0x0C, 0x50, "WRSLD", &gx4_15_evidence[1]},  {0x0C, 0x51, "WRSLD", &gx4_15_evidence[0]},
    {0x0C, 0x64, "", &gx4_15_evidence[0]},       {0x0D, 0x01, "", &gx4_15_evidence[0]},
    {0x0D, 0x02, "", &gx4_15_evidence[0]},       {0x0D, 0x03, "", &gx4_15_evidence[0]},
    {0x0D, 0x14, "WRSLD", &gx4_15_evidence[0]},  {0x0D, 0x19, "WRSLD", &gx4_15_evidence[0]},
    {0x0D, 0x1A, "WRSLD", &gx4_15_evidence[0]},  {0x0D, 0x1B, "WRSLD", &gx4_15_evidence[0]},
    {0x0D, 0x1D, "WRSLD", &gx4_15_evidence[0]},  {0x0D, 0x20, "WRSLD", &gx4_15_evidence[0]},
    {0x0D, 0x21, "WRSLD", &gx4_15_evidence[0]},  {0x0D, 0x23, "", &gx4_15_evidence[0]},
    {0x0D, 0x26, "WRSLD", &gx4_15_evidence[0]},  {0x0D, 0x44, "WRSLD", &gx4_15_evidence[0]},
    {0x7F, 0x10, "WRSLD", &gx4_15_evidence[0]},  {0x80, 0x04, "", &gx4_15_evidence[0]},
    {0x80, 0x05, "", &gx4_15_evidence[0]},       {0x80, 0x07, "", &gx4_15_evidence[1]},
    {0x80, 0x08, "", &gx4_15_evidence[1]},       {0x80, 0x09, "", &gx4_15_evidence[1]},
    {0x80, 0x0A, "", &gx4_15_evidence[1]},       {0x80, 0x0C, "", &gx4_15_evidence[1]},
    {0x80, 0x10, "", &gx4_15_evidence[1]},       {0x80, 0x11, "", &gx4_15_evidence[1]},
    {0x80, 0x12, "", &gx4_15_evidence[1]},       {0x80, 0x17, "", &gx4_15_evidence[1]},
    {0x82, 0x03, "", &gx4_15_evidence[1]},       {0x82, 0x04, "", &gx4_15_evidence[1]},
    {0x82, 0x05, "", &gx4_15_evidence[0]},       {0x82, 0x06, "", &gx4_15_evidence[1]},
    {0x82, 0x0A, "", &gx4_15_evidence[1]},       {0x82, 0x0B, "", &gx4_15_evidence[1]},
    {0x82, 0x0D, "", &gx4_15_evidence[1]},       {0x82, 0x0E, "", &gx4_15_evidence[1]},
    {0x82, 0x0F, "", &gx4_15_evidence[1]},       {0x82, 0x10, "", &gx4_15_evidence[1]},
    {0x82, 0x11, "", &gx4_15_evidence[1]},       {0x82, 0x12, "", &gx4_15_evidence[1]},
    {0x82, 0x13, "", &gx4_15_evidence[1]},
};

static const struct mip_profile_field gx4_15_refuses[] = {
    {0x0C, 0x02, "", &gx4_15_evidence[2]}, {0x0C, 0x07, "", &gx4_15_evidence[2]},
    {0x0C, 0x09, "", &gx4_15_evidence[2]}, {0x0C, 0x20, "", &gx4_15_evidence[2]},
    {0x0C, 0x21, "", &gx4_15_evidence[2]}, {0x0C, 0x22, "", &gx4_15_evidence[2]},
    {0x0C, 0x23, "", &gx4_15_evidence[2]}, {0x0C, 0x24, "", &gx4_15_evidence[2]},
    {0x0C, 0x34, "", &gx4_15_evidence[2]}, {0x0C, 0x3A, "", &gx4_15_evidence[3]},
    {0x0C, 0x3B, "", &gx4_15_evidence[3]}, {0x0C, 0x62, "", &gx4_15_evidence[2]},
    {0x0D, 0x27, "", &gx4_15_evidence[3]}, {0x0D, 0x2B, "", &gx4_15_evidence[3]},
    {0x0D, 0x2C, "", &gx4_15_evidence[3]}, {0x0D, 0x42, "", &gx4_15_evidence[3]},
    {0x0D, 0x43, "", &gx4_15_evidence[3]}, {0x0D, 0x45, "", &gx4_15_evidence[3]},
    {0x0D, 0x46, "", &gx4_15_evidence[3]}, {0x0D, 0x4C, "", &gx4_15_evidence[3]},
    {0x0D, 0x4D, "", &gx4_15_evidence[3]}, {0x0D, 0x54, "", &gx4_15_evidence[2]},
    {0x0D, 0x64, "", &gx4_15_evidence[2]}, {0x80, 0x03, "", &gx4_15_evidence[3]},
    {0x80, 0x06, "", &gx4_15_evidence[3]}, {0x82, 0x1A, "", &gx4_15_evidence[3]},
    {0x82, 0x1B, "", &gx4_15_evidence[3]}, {0x82, 0x25, "", &gx4_15_evidence[3]},
    {0x82, 0x26, "", &gx4_15_evidence[3]}, {0x82, 0x28, "", &gx4_15_evidence[3]},
    {0x82, 0x29, "", &gx4_15_evidence[3]}, {0x82, 0x2A, "", &gx4_15_evidence[3]},
    {0x82, 0x2C, "", &gx4_15_evidence[3]}, {0x82, 0x34, "", &gx4_15_evidence[2]},
    {0x82, 0x35, "", &gx4_15_evidence[2]}, {0x82, 0x49, "", &gx4_15_evidence[4]},
};

static const struct mip_profile_field gx4_15_absent_sets[] = {
    {0x81, 0, "", &gx4_15_evidence[2]},
    {0x91, 0, "", &gx4_15_evidence[2]},
    {0x92, 0, "", &gx4_15_evidence[2]},
    {0x93, 0, "", &gx4_15_evidence[2]},
};

static const struct mip_profile_reading gx4_15_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx4_15 = {
    "3dm-gx4-15",
    "3DM-GX4-15",
    "",
    "Device of generation 4.",
    6233, /* model number */
    4,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    61,   /* fields */
    36,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    gx4_15_incomplete,
    gx4_15_fields,
    gx4_15_refuses,
    gx4_15_absent_sets,
    NULL,
    NULL,
    gx4_15_readings,
};

/* 3DM-GX4-25. */

static const char *const gx4_25_incomplete[] = {
    "Its manual (of 2014-12-23) is not known.",
};

static const struct mip_profile_evidence gx4_25_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (Public programs of users: Driver imu_3dm_gx4).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-25.", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (MicroStrain Communication Library: Issue 30).", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field gx4_25_fields[] = {
    {0x01, 0x01, "", &gx4_25_evidence[0]},       {0x01, 0x02, "", &gx4_25_evidence[0]},
    {0x01, 0x03, "", &gx4_25_evidence[0]},       {0x01, 0x04, "", &gx4_25_evidence[0]},
    {0x01, 0x05, "", &gx4_25_evidence[0]},       {0x01, 0x06, "", &gx4_25_evidence[1]},
    {0x01, 0x7E, "", &gx4_25_evidence[2]},       {0x0C, 0x01, "", &gx4_25_evidence[0]},
    {0x0C, 0x03, "", &gx4_25_evidence[0]},       {0x0C, 0x06, "", &gx4_25_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx4_25_evidence[0]},  {0x0C, 0x0A, "WRSLD", &gx4_25_evidence[0]},
    {0x0C, 0x0B, "", &gx4_25_evidence[0]},       {0x0C, 0x11, "WRSLD", &gx4_25_evidence[0]},
    {0x0C, 0x30, "SLD", &gx4_25_evidence[2]},    {0x0C, 0x37, "WRSLDA", &gx4_25_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &gx4_25_evidence[0]}, {0x0C, 0x39, "", &gx4_25_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &gx4_25_evidence[0]}, {0x0C, 0x3B, "WRSLDA", &gx4_25_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &gx4_25_evidence[2]},  {0x0C, 0x40, "WRSLD", &gx4_25_evidence[1]},
    {0x0C, 0x50, "WRSLD", &gx4_25_evidence[2]},  {0x0C, 0x51, "WRSLD", &gx4_25_evidence[0]},
    {0x0C, 0x64, "", &gx4_25_evidence[0]},       {0x0D, 0x01, "", &gx4_25_evidence[0]},
    {0x0D, 0x02, "", &gx4_25_evidence[0]},       {0x0D, 0x03, "", &gx4_25_evidence[0]},
    {0x0D, 0x11, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x14, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x17, "", &gx4_25_evidence[0]},       {0x0D, 0x18, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x19, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x1A, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x1B, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x1D, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x1F, "", &gx4_25_evidence[0]},       {0x0D, 0x20, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x21, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x23, "", &gx4_25_evidence[0]},
    {0x0D, 0x26, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x41, "WRSLD", &gx4_25_evidence[1]},
    {0x0D, 0x42, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x43, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x44, "WRSLD", &gx4_25_evidence[0]},  {0x0D, 0x45, "WRSLD", &gx4_25_evidence[0]},
    {0x0D, 0x46, "WRSLD", &gx4_25_evidence[0]},  {0x7F, 0x10, "WRSLD", &gx4_25_evidence[0]},
    {0x80, 0x04, "", &gx4_25_evidence[0]},       {0x80, 0x05, "", &gx4_25_evidence[0]},
    {0x80, 0x06, "", &gx4_25_evidence[0]},       {0x80, 0x07, "", &gx4_25_evidence[2]},
    {0x80, 0x08, "", &gx4_25_evidence[2]},       {0x80, 0x09, "", &gx4_25_evidence[2]},
    {0x80, 0x0A, "", &gx4_25_evidence[2]},       {0x80, 0x0C, "", &gx4_25_evidence[2]},
    {0x80, 0x10, "", &gx4_25_evidence[2]},       {0x80, 0x11, "", &gx4_25_evidence[2]},
    {0x80, 0x12, "", &gx4_25_evidence[2]},       {0x80, 0x17, "", &gx4_25_evidence[1]},
    {0x82, 0x03, "", &gx4_25_evidence[1]},       {0x82, 0x04, "", &gx4_25_evidence[2]},
    {0x82, 0x05, "", &gx4_25_evidence[0]},       {0x82, 0x06, "", &gx4_25_evidence[1]},
    {0x82, 0x0A, "", &gx4_25_evidence[1]},       {0x82, 0x0B, "", &gx4_25_evidence[1]},
    {0x82, 0x0D, "", &gx4_25_evidence[2]},       {0x82, 0x0E, "", &gx4_25_evidence[2]},
    {0x82, 0x0F, "", &gx4_25_evidence[2]},       {0x82, 0x10, "", &gx4_25_evidence[2]},
    {0x82, 0x11, "", &gx4_25_evidence[2]},       {0x82, 0x12, "", &gx4_25_evidence[2]},
    {0x82, 0x13, "", &gx4_25_evidence[2]},       {0x82, 0x14, "", &gx4_25_evidence[2]},
    {0x82, 0x15, "", &gx4_25_evidence[2]},
};

static const struct mip_profile_field gx4_25_refuses[] = {
    {0x0C, 0x02, "", &gx4_25_evidence[4]}, {0x0C, 0x07, "", &gx4_25_evidence[4]},
    {0x0C, 0x09, "", &gx4_25_evidence[4]}, {0x0C, 0x20, "", &gx4_25_evidence[4]},
    {0x0C, 0x21, "", &gx4_25_evidence[4]}, {0x0C, 0x22, "", &gx4_25_evidence[4]},
    {0x0C, 0x23, "", &gx4_25_evidence[4]}, {0x0C, 0x24, "", &gx4_25_evidence[4]},
    {0x0C, 0x34, "", &gx4_25_evidence[4]}, {0x0C, 0x62, "", &gx4_25_evidence[4]},
    {0x0D, 0x54, "", &gx4_25_evidence[4]}, {0x0D, 0x64, "", &gx4_25_evidence[4]},
    {0x82, 0x07, "", &gx4_25_evidence[3]}, {0x82, 0x34, "", &gx4_25_evidence[4]},
    {0x82, 0x35, "", &gx4_25_evidence[4]}, {0x82, 0x49, "", &gx4_25_evidence[5]},
};

static const struct mip_profile_field gx4_25_absent_sets[] = {
    {0x81, 0, "", &gx4_25_evidence[4]},
    {0x91, 0, "", &gx4_25_evidence[4]},
    {0x92, 0, "", &gx4_25_evidence[4]},
    {0x93, 0, "", &gx4_25_evidence[4]},
};

static const struct mip_profile_rate gx4_25_rates[] = {
    {0x80, 1000},
    {0x82, 500},
};

static const struct mip_profile_reading gx4_25_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx4_25 = {
    "3dm-gx4-25",
    "3DM-GX4-25",
    "",
    "Device of generation 4.",
    6234, /* model number */
    4,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    75,   /* fields */
    16,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    2,    /* base rates */
    6,    /* readings */
    NULL,
    gx4_25_incomplete,
    gx4_25_fields,
    gx4_25_refuses,
    gx4_25_absent_sets,
    NULL,
    gx4_25_rates,
    gx4_25_readings,
};

/* 3DM-GX4-45. */

static const char *const gx4_45_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gx4_45_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-25.", ""},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field gx4_45_fields[] = {
    {0x01, 0x01, "", &gx4_45_evidence[0]},       {0x01, 0x02, "", &gx4_45_evidence[0]},
    {0x01, 0x03, "", &gx4_45_evidence[0]},       {0x01, 0x04, "", &gx4_45_evidence[0]},
    {0x01, 0x05, "", &gx4_45_evidence[0]},       {0x01, 0x06, "", &gx4_45_evidence[1]},
    {0x01, 0x7E, "", &gx4_45_evidence[1]},       {0x0C, 0x01, "", &gx4_45_evidence[0]},
    {0x0C, 0x02, "", &gx4_45_evidence[0]},       {0x0C, 0x03, "", &gx4_45_evidence[0]},
    {0x0C, 0x06, "", &gx4_45_evidence[0]},       {0x0C, 0x07, "", &gx4_45_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx4_45_evidence[0]},  {0x0C, 0x09, "WRSLD", &gx4_45_evidence[0]},
    {0x0C, 0x0A, "WRSLD", &gx4_45_evidence[0]},  {0x0C, 0x0B, "", &gx4_45_evidence[0]},
    {0x0C, 0x11, "WRSLD", &gx4_45_evidence[0]},  {0x0C, 0x30, "SLD", &gx4_45_evidence[1]},
    {0x0C, 0x37, "WRSLDA", &gx4_45_evidence[0]}, {0x0C, 0x38, "WRSLDA", &gx4_45_evidence[0]},
    {0x0C, 0x39, "", &gx4_45_evidence[0]},       {0x0C, 0x3A, "WRSLDA", &gx4_45_evidence[0]},
    {0x0C, 0x3B, "WRSLDA", &gx4_45_evidence[0]}, {0x0C, 0x3E, "WRSLD", &gx4_45_evidence[1]},
    {0x0C, 0x40, "WRSLD", &gx4_45_evidence[1]},  {0x0C, 0x50, "WRSLD", &gx4_45_evidence[1]},
    {0x0C, 0x51, "WRSLD", &gx4_45_evidence[0]},  {0x0C, 0x64, "", &gx4_45_evidence[0]},
    {0x0D, 0x01, "", &gx4_45_evidence[0]},       {0x0D, 0x02, "", &gx4_45_evidence[0]},
    {0x0D, 0x03, "", &gx4_45_evidence[0]},       {0x0D, 0x10, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x11, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x12, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x13, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x14, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x15, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x16, "", &gx4_45_evidence[0]},
    {0x0D, 0x17, "", &gx4_45_evidence[0]},       {0x0D, 0x18, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x19, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x1A, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x1B, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x1C, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x1D, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x1E, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x1F, "", &gx4_45_evidence[0]},       {0x0D, 0x20, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x21, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x22, "", &gx4_45_evidence[0]},
    {0x0D, 0x23, "", &gx4_45_evidence[0]},       {0x0D, 0x42, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x43, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x44, "WRSLD", &gx4_45_evidence[0]},
    {0x0D, 0x45, "WRSLD", &gx4_45_evidence[0]},  {0x0D, 0x46, "WRSLD", &gx4_45_evidence[0]},
    {0x7F, 0x10, "WRSLD", &gx4_45_evidence[0]},  {0x80, 0x04, "", &gx4_45_evidence[0]},
    {0x80, 0x05, "", &gx4_45_evidence[0]},       {0x80, 0x06, "", &gx4_45_evidence[0]},
    {0x80, 0x07, "", &gx4_45_evidence[1]},       {0x80, 0x08, "", &gx4_45_evidence[1]},
    {0x80, 0x09, "", &gx4_45_evidence[1]},       {0x80, 0x0A, "", &gx4_45_evidence[1]},
    {0x80, 0x0C, "", &gx4_45_evidence[1]},       {0x80, 0x10, "", &gx4_45_evidence[1]},
    {0x80, 0x11, "", &gx4_45_evidence[1]},       {0x80, 0x12, "", &gx4_45_evidence[1]},
    {0x80, 0x17, "", &gx4_45_evidence[1]},       {0x81, 0x03, "", &gx4_45_evidence[0]},
    {0x81, 0x05, "", &gx4_45_evidence[0]},       {0x81, 0x09, "", &gx4_45_evidence[0]},
    {0x82, 0x01, "", &gx4_45_evidence[0]},       {0x82, 0x02, "", &gx4_45_evidence[0]},
    {0x82, 0x03, "", &gx4_45_evidence[1]},       {0x82, 0x04, "", &gx4_45_evidence[1]},
    {0x82, 0x05, "", &gx4_45_evidence[0]},       {0x82, 0x06, "", &gx4_45_evidence[1]},
    {0x82, 0x0A, "", &gx4_45_evidence[1]},       {0x82, 0x0B, "", &gx4_45_evidence[1]},
    {0x82, 0x0D, "", &gx4_45_evidence[1]},       {0x82, 0x0E, "", &gx4_45_evidence[1]},
    {0x82, 0x0F, "", &gx4_45_evidence[1]},       {0x82, 0x10, "", &gx4_45_evidence[1]},
    {0x82, 0x11, "", &gx4_45_evidence[1]},       {0x82, 0x12, "", &gx4_45_evidence[1]},
    {0x82, 0x13, "", &gx4_45_evidence[1]},       {0x82, 0x14, "", &gx4_45_evidence[1]},
    {0x82, 0x15, "", &gx4_45_evidence[1]},
};

static const struct mip_profile_field gx4_45_refuses[] = {
    {0x82, 0x49, "", &gx4_45_evidence[2]},
};

static const struct mip_profile_field gx4_45_absent_sets[] = {
    {0x92, 0, "", &gx4_45_evidence[3]},
};

static const struct mip_profile_reading gx4_45_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.device_status_basic_response.system_state", "3dm.gx4_system_state"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx4_45 = {
    "3dm-gx4-45",
    "3DM-GX4-45",
    "",
    "Device of generation 4.",
    6236, /* model number */
    4,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    89,   /* fields */
    1,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    NULL,
    gx4_45_incomplete,
    gx4_45_fields,
    gx4_45_refuses,
    gx4_45_absent_sets,
    NULL,
    NULL,
    gx4_45_readings,
};

/* 3DM-GX4-IMU. */

static const char *const gx4_imu_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence gx4_imu_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-GX4-25.", ""},
};

static const struct mip_profile_field gx4_imu_fields[] = {
    {0x01, 0x01, "", &gx4_imu_evidence[0]},       {0x01, 0x02, "", &gx4_imu_evidence[0]},
    {0x01, 0x03, "", &gx4_imu_evidence[0]},       {0x01, 0x04, "", &gx4_imu_evidence[0]},
    {0x01, 0x05, "", &gx4_imu_evidence[0]},       {0x01, 0x06, "", &gx4_imu_evidence[1]},
    {0x0C, 0x01, "", &gx4_imu_evidence[0]},       {0x0C, 0x06, "", &gx4_imu_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx4_imu_evidence[0]},  {0x0C, 0x37, "WRSLDA", &gx4_imu_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &gx4_imu_evidence[0]}, {0x0C, 0x39, "", &gx4_imu_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &gx4_imu_evidence[0]}, {0x0C, 0x3B, "WRSLDA", &gx4_imu_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &gx4_imu_evidence[0]},  {0x0C, 0x64, "", &gx4_imu_evidence[0]},
    {0x7F, 0x10, "WRSLD", &gx4_imu_evidence[0]},
};

static const struct mip_profile_reading gx4_imu_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx4_imu = {
    "3dm-gx4-imu",
    "3DM-GX4-IMU",
    "",
    "Inertial sensor inside the 3DM-GX4-45, which replies in the direct mode.",
    6237, /* model number */
    4,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    17,   /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    gx4_imu_incomplete,
    gx4_imu_fields,
    NULL,
    NULL,
    NULL,
    NULL,
    gx4_imu_readings,
};

/* 3DM-GX5-15. */

static const char *const gx5_15_also[] = {
    "3DM-GX5-AR",
};

static const struct mip_profile_evidence gx5_15_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (MicroStrain Communication Library: Issue 301).", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
};

static const struct mip_profile_field gx5_15_fields[] = {
    {0x01, 0x01, "", &gx5_15_evidence[0]},       {0x01, 0x02, "", &gx5_15_evidence[0]},
    {0x01, 0x03, "", &gx5_15_evidence[0]},       {0x01, 0x04, "", &gx5_15_evidence[0]},
    {0x01, 0x05, "", &gx5_15_evidence[0]},       {0x01, 0x06, "", &gx5_15_evidence[0]},
    {0x01, 0x07, "", &gx5_15_evidence[0]},       {0x01, 0x72, "WRA", &gx5_15_evidence[0]},
    {0x01, 0x7E, "", &gx5_15_evidence[0]},       {0x0C, 0x01, "", &gx5_15_evidence[0]},
    {0x0C, 0x03, "", &gx5_15_evidence[0]},       {0x0C, 0x06, "", &gx5_15_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx5_15_evidence[0]},  {0x0C, 0x0A, "WRSLD", &gx5_15_evidence[0]},
    {0x0C, 0x0B, "", &gx5_15_evidence[0]},       {0x0C, 0x11, "WRSLD", &gx5_15_evidence[0]},
    {0x0C, 0x30, "SLD", &gx5_15_evidence[0]},    {0x0C, 0x37, "WRSLDA", &gx5_15_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &gx5_15_evidence[0]}, {0x0C, 0x39, "", &gx5_15_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &gx5_15_evidence[0]},  {0x0C, 0x40, "WRSLD", &gx5_15_evidence[0]},
    {0x0C, 0x50, "WRSLD", &gx5_15_evidence[0]},  {0x0C, 0x51, "WRSLD", &gx5_15_evidence[0]},
    {0x0C, 0x64, "", &gx5_15_evidence[0]},       {0x0D, 0x01, "", &gx5_15_evidence[0]},
    {0x0D, 0x02, "", &gx5_15_evidence[0]},       {0x0D, 0x03, "", &gx5_15_evidence[0]},
    {0x0D, 0x11, "WRSLD", &gx5_15_evidence[0]},  {0x0D, 0x14, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x17, "", &gx5_15_evidence[0]},       {0x0D, 0x18, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x19, "WRSLD", &gx5_15_evidence[0]},  {0x0D, 0x1A, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x1B, "WRSLD", &gx5_15_evidence[0]},  {0x0D, 0x1D, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x1F, "", &gx5_15_evidence[0]},       {0x0D, 0x20, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x21, "WSLD", &gx5_15_evidence[0]},   {0x0D, 0x23, "", &gx5_15_evidence[0]},
    {0x0D, 0x26, "WRSLD", &gx5_15_evidence[0]},  {0x0D, 0x28, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x41, "WRSLD", &gx5_15_evidence[0]},  {0x0D, 0x44, "WRSLD", &gx5_15_evidence[0]},
    {0x0D, 0x4B, "WRSLD", &gx5_15_evidence[0]},  {0x7F, 0x10, "WRSLD", &gx5_15_evidence[0]},
    {0x80, 0x04, "", &gx5_15_evidence[0]},       {0x80, 0x05, "", &gx5_15_evidence[0]},
    {0x80, 0x07, "", &gx5_15_evidence[0]},       {0x80, 0x08, "", &gx5_15_evidence[0]},
    {0x80, 0x09, "", &gx5_15_evidence[0]},       {0x80, 0x0A, "", &gx5_15_evidence[0]},
    {0x80, 0x0C, "", &gx5_15_evidence[0]},       {0x80, 0x10, "", &gx5_15_evidence[0]},
    {0x80, 0x11, "", &gx5_15_evidence[0]},       {0x80, 0x12, "", &gx5_15_evidence[0]},
    {0x80, 0x17, "", &gx5_15_evidence[0]},       {0x82, 0x03, "", &gx5_15_evidence[0]},
    {0x82, 0x04, "", &gx5_15_evidence[0]},       {0x82, 0x05, "", &gx5_15_evidence[0]},
    {0x82, 0x06, "", &gx5_15_evidence[0]},       {0x82, 0x0A, "", &gx5_15_evidence[0]},
    {0x82, 0x0B, "", &gx5_15_evidence[0]},       {0x82, 0x0D, "", &gx5_15_evidence[0]},
    {0x82, 0x0E, "", &gx5_15_evidence[0]},       {0x82, 0x0F, "", &gx5_15_evidence[0]},
    {0x82, 0x10, "", &gx5_15_evidence[0]},       {0x82, 0x11, "", &gx5_15_evidence[0]},
    {0x82, 0x12, "", &gx5_15_evidence[0]},       {0x82, 0x13, "", &gx5_15_evidence[0]},
    {0x82, 0x14, "", &gx5_15_evidence[0]},       {0x82, 0x1C, "", &gx5_15_evidence[0]},
    {0x82, 0x21, "", &gx5_15_evidence[0]},
};

static const struct mip_profile_field gx5_15_refuses[] = {
    {0x0C, 0x02, "", &gx5_15_evidence[2]}, {0x0C, 0x07, "", &gx5_15_evidence[2]},
    {0x0C, 0x09, "", &gx5_15_evidence[2]}, {0x0C, 0x20, "", &gx5_15_evidence[2]},
    {0x0C, 0x21, "", &gx5_15_evidence[2]}, {0x0C, 0x22, "", &gx5_15_evidence[2]},
    {0x0C, 0x23, "", &gx5_15_evidence[2]}, {0x0C, 0x24, "", &gx5_15_evidence[2]},
    {0x0C, 0x34, "", &gx5_15_evidence[2]}, {0x0C, 0x3A, "", &gx5_15_evidence[3]},
    {0x0C, 0x3B, "", &gx5_15_evidence[3]}, {0x0C, 0x62, "", &gx5_15_evidence[2]},
    {0x0D, 0x27, "", &gx5_15_evidence[3]}, {0x0D, 0x2B, "", &gx5_15_evidence[3]},
    {0x0D, 0x2C, "", &gx5_15_evidence[3]}, {0x0D, 0x42, "", &gx5_15_evidence[3]},
    {0x0D, 0x43, "", &gx5_15_evidence[3]}, {0x0D, 0x45, "", &gx5_15_evidence[3]},
    {0x0D, 0x46, "", &gx5_15_evidence[3]}, {0x0D, 0x4C, "", &gx5_15_evidence[3]},
    {0x0D, 0x4D, "", &gx5_15_evidence[3]}, {0x0D, 0x54, "", &gx5_15_evidence[2]},
    {0x0D, 0x64, "", &gx5_15_evidence[2]}, {0x80, 0x01, "", &gx5_15_evidence[1]},
    {0x80, 0x02, "", &gx5_15_evidence[1]}, {0x80, 0x03, "", &gx5_15_evidence[3]},
    {0x80, 0x06, "", &gx5_15_evidence[3]}, {0x82, 0x1A, "", &gx5_15_evidence[3]},
    {0x82, 0x1B, "", &gx5_15_evidence[3]}, {0x82, 0x25, "", &gx5_15_evidence[3]},
    {0x82, 0x26, "", &gx5_15_evidence[3]}, {0x82, 0x28, "", &gx5_15_evidence[3]},
    {0x82, 0x29, "", &gx5_15_evidence[3]}, {0x82, 0x2A, "", &gx5_15_evidence[3]},
    {0x82, 0x2C, "", &gx5_15_evidence[3]}, {0x82, 0x34, "", &gx5_15_evidence[2]},
    {0x82, 0x35, "", &gx5_15_evidence[2]}, {0x82, 0x49, "", &gx5_15_evidence[4]},
};

static const struct mip_profile_field gx5_15_absent_sets[] = {
    {0x81, 0, "", &gx5_15_evidence[2]},
    {0x91, 0, "", &gx5_15_evidence[2]},
    {0x92, 0, "", &gx5_15_evidence[2]},
    {0x93, 0, "", &gx5_15_evidence[2]},
};

static const struct mip_profile_rate gx5_15_rates[] = {
    {0x80, 1000},
    {0x82, 500},
};

static const struct mip_profile_reading gx5_15_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx5_15 = {
    "3dm-gx5-15",
    "3DM-GX5-15",
    "3dm-gx5-15",
    "Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter.",
    6254, /* model number */
    5,    /* generation */
    1,    /* other names */
    0,    /* what is not known */
    73,   /* fields */
    38,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    2,    /* base rates */
    7,    /* readings */
    gx5_15_also,
    NULL,
    gx5_15_fields,
    gx5_15_refuses,
    gx5_15_absent_sets,
    NULL,
    gx5_15_rates,
    gx5_15_readings,
};

/* 3DM-GX5-25. */

static const char *const gx5_25_also[] = {
    "3DM-GX5-AHRS",
};

static const char *const gx5_25_incomplete[] = {
    "Its manual (8500-0065) is not known.",
};

static const struct mip_profile_evidence gx5_25_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Transcribed from the manual by others (Public programs of users: Parser of 3DM-GX5-25 data "
     "in MATLAB, 2018).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver microstrain_mips: Table of tested functions).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver microstrain_mips: Conditions by model).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.", ""},
    {MIP_SUPPORT_NO, "Rejected by the device (ROS driver of the vendor: Issue 238).", ""},
    {MIP_SUPPORT_NO,
     "Rejected by the device (firmware 1.1.76; ROS driver of the vendor: Issue 368).", ""},
    {MIP_SUPPORT_NO,
     "Rejected by the device (ROS driver of the vendor: Issue 59; MicroStrain Communication "
     "Library: Issue 200).",
     ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
};

static const struct mip_profile_field gx5_25_fields[] = {
    {0x01, 0x01, "", &gx5_25_evidence[1]},       {0x01, 0x02, "", &gx5_25_evidence[1]},
    {0x01, 0x03, "", &gx5_25_evidence[2]},       {0x01, 0x04, "", &gx5_25_evidence[5]},
    {0x01, 0x05, "", &gx5_25_evidence[6]},       {0x01, 0x06, "", &gx5_25_evidence[1]},
    {0x01, 0x07, "", &gx5_25_evidence[5]},       {0x01, 0x72, "WRA", &gx5_25_evidence[6]},
    {0x01, 0x7E, "", &gx5_25_evidence[6]},       {0x0C, 0x01, "", &gx5_25_evidence[6]},
    {0x0C, 0x03, "", &gx5_25_evidence[6]},       {0x0C, 0x06, "", &gx5_25_evidence[1]},
    {0x0C, 0x08, "WRSLD", &gx5_25_evidence[1]},  {0x0C, 0x0A, "WRSLD", &gx5_25_evidence[1]},
    {0x0C, 0x0B, "", &gx5_25_evidence[1]},       {0x0C, 0x11, "WRSLD", &gx5_25_evidence[3]},
    {0x0C, 0x30, "SLD", &gx5_25_evidence[1]},    {0x0C, 0x37, "WRSLDA", &gx5_25_evidence[3]},
    {0x0C, 0x38, "WRSLDA", &gx5_25_evidence[3]}, {0x0C, 0x39, "", &gx5_25_evidence[1]},
    {0x0C, 0x3A, "WRSLDA", &gx5_25_evidence[3]}, {0x0C, 0x3B, "WRSLDA", &gx5_25_evidence[3]},
    {0x0C, 0x3E, "WRSLD", &gx5_25_evidence[3]},  {0x0C, 0x40, "WRSLD", &gx5_25_evidence[6]},
    {0x0C, 0x50, "WRSLD", &gx5_25_evidence[6]},  {0x0C, 0x51, "WRSLD", &gx5_25_evidence[3]},
    {0x0C, 0x64, "", &gx5_25_evidence[3]},       {0x0D, 0x01, "", &gx5_25_evidence[2]},
    {0x0D, 0x02, "", &gx5_25_evidence[3]},       {0x0D, 0x03, "", &gx5_25_evidence[3]},
    {0x0D, 0x11, "WRSLD", &gx5_25_evidence[1]},  {0x0D, 0x14, "WRSLD", &gx5_25_evidence[3]},
    {0x0D, 0x17, "", &gx5_25_evidence[6]},       {0x0D, 0x18, "WRSLD", &gx5_25_evidence[2]},
    {0x0D, 0x19, "WRSLD", &gx5_25_evidence[1]},  {0x0D, 0x1A, "WRSLD", &gx5_25_evidence[3]},
    {0x0D, 0x1B, "WRSLD", &gx5_25_evidence[3]},  {0x0D, 0x1D, "WRSLD", &gx5_25_evidence[3]},
    {0x0D, 0x1E, "WRSLD", &gx5_25_evidence[3]},  {0x0D, 0x1F, "", &gx5_25_evidence[6]},
    {0x0D, 0x20, "WRSLD", &gx5_25_evidence[3]},  {0x0D, 0x21, "WRSLD", &gx5_25_evidence[3]},
    {0x0D, 0x23, "", &gx5_25_evidence[6]},       {0x0D, 0x26, "WRSLD", &gx5_25_evidence[3]},
    {0x0D, 0x27, "WS", &gx5_25_evidence[6]},     {0x0D, 0x28, "WRSLD", &gx5_25_evidence[6]},
    {0x0D, 0x29, "WRSLD", &gx5_25_evidence[6]},  {0x0D, 0x2B, "WRSLD", &gx5_25_evidence[6]},
    {0x0D, 0x2C, "WRSLD", &gx5_25_evidence[6]},  {0x0D, 0x41, "WRSLD", &gx5_25_evidence[6]},
    {0x0D, 0x42, "WRSLD", &gx5_25_evidence[4]},  {0x0D, 0x43, "WRSLD", &gx5_25_evidence[6]},
    {0x0D, 0x44, "WRSLD", &gx5_25_evidence[3]},  {0x0D, 0x45, "WRSLD", &gx5_25_evidence[4]},
    {0x0D, 0x46, "WRSLD", &gx5_25_evidence[6]},  {0x0D, 0x47, "WRSLD", &gx5_25_evidence[6]},
    {0x0D, 0x4B, "WRSLD", &gx5_25_evidence[6]},  {0x7F, 0x10, "WRSLD", &gx5_25_evidence[3]},
    {0x80, 0x04, "", &gx5_25_evidence[0]},       {0x80, 0x05, "", &gx5_25_evidence[0]},
    {0x80, 0x06, "", &gx5_25_evidence[0]},       {0x80, 0x07, "", &gx5_25_evidence[0]},
    {0x80, 0x08, "", &gx5_25_evidence[0]},       {0x80, 0x09, "", &gx5_25_evidence[0]},
    {0x80, 0x0A, "", &gx5_25_evidence[0]},       {0x80, 0x0C, "", &gx5_25_evidence[0]},
    {0x80, 0x10, "", &gx5_25_evidence[0]},       {0x80, 0x11, "", &gx5_25_evidence[0]},
    {0x80, 0x12, "", &gx5_25_evidence[0]},       {0x80, 0x17, "", &gx5_25_evidence[0]},
    {0x82, 0x03, "", &gx5_25_evidence[0]},       {0x82, 0x04, "", &gx5_25_evidence[0]},
    {0x82, 0x05, "", &gx5_25_evidence[0]},       {0x82, 0x06, "", &gx5_25_evidence[0]},
    {0x82, 0x0A, "", &gx5_25_evidence[0]},       {0x82, 0x0B, "", &gx5_25_evidence[0]},
    {0x82, 0x0D, "", &gx5_25_evidence[0]},       {0x82, 0x0E, "", &gx5_25_evidence[0]},
    {0x82, 0x0F, "", &gx5_25_evidence[0]},       {0x82, 0x10, "", &gx5_25_evidence[0]},
    {0x82, 0x11, "", &gx5_25_evidence[0]},       {0x82, 0x12, "", &gx5_25_evidence[0]},
    {0x82, 0x13, "", &gx5_25_evidence[0]},       {0x82, 0x14, "", &gx5_25_evidence[0]},
    {0x82, 0x15, "", &gx5_25_evidence[0]},       {0x82, 0x1C, "", &gx5_25_evidence[0]},
    {0x82, 0x21, "", &gx5_25_evidence[0]},       {0x82, 0x25, "", &gx5_25_evidence[0]},
    {0x82, 0x26, "", &gx5_25_evidence[0]},       {0x82, 0x28, "", &gx5_25_evidence[0]},
    {0x82, 0x29, "", &gx5_25_evidence[0]},
};

static const struct mip_profile_field gx5_25_refuses[] = {
    {0x0C, 0x02, "", &gx5_25_evidence[10]}, {0x0C, 0x07, "", &gx5_25_evidence[10]},
    {0x0C, 0x09, "", &gx5_25_evidence[10]}, {0x0C, 0x20, "", &gx5_25_evidence[10]},
    {0x0C, 0x21, "", &gx5_25_evidence[10]}, {0x0C, 0x22, "", &gx5_25_evidence[10]},
    {0x0C, 0x23, "", &gx5_25_evidence[10]}, {0x0C, 0x24, "", &gx5_25_evidence[10]},
    {0x0C, 0x34, "", &gx5_25_evidence[10]}, {0x0C, 0x41, "WRSLD", &gx5_25_evidence[7]},
    {0x0C, 0x62, "", &gx5_25_evidence[10]}, {0x0D, 0x54, "", &gx5_25_evidence[10]},
    {0x0D, 0x64, "", &gx5_25_evidence[10]}, {0x80, 0x18, "", &gx5_25_evidence[8]},
    {0x81, 0x03, "", &gx5_25_evidence[7]},  {0x81, 0x0B, "", &gx5_25_evidence[7]},
    {0x82, 0x01, "", &gx5_25_evidence[8]},  {0x82, 0x02, "", &gx5_25_evidence[9]},
    {0x82, 0x08, "", &gx5_25_evidence[8]},  {0x82, 0x34, "", &gx5_25_evidence[10]},
    {0x82, 0x35, "", &gx5_25_evidence[10]}, {0x82, 0x43, "", &gx5_25_evidence[7]},
    {0x82, 0x49, "", &gx5_25_evidence[7]},  {0x91, 0x03, "", &gx5_25_evidence[7]},
    {0x91, 0x0B, "", &gx5_25_evidence[7]},  {0x92, 0x0B, "", &gx5_25_evidence[8]},
    {0x92, 0x12, "", &gx5_25_evidence[8]},  {0x92, 0x14, "", &gx5_25_evidence[8]},
    {0x93, 0x31, "", &gx5_25_evidence[7]},
};

static const struct mip_profile_field gx5_25_absent_sets[] = {
    {0x81, 0, "", &gx5_25_evidence[10]},
    {0x91, 0, "", &gx5_25_evidence[10]},
    {0x92, 0, "", &gx5_25_evidence[10]},
    {0x93, 0, "", &gx5_25_evidence[10]},
};

static const struct mip_profile_reading gx5_25_readings[] = {
    {"base.built_in_test_response.result", "gx5_built_in_test"},
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx5_25 = {
    "3dm-gx5-25",
    "3DM-GX5-25",
    "",
    "Attitude and heading reference system.",
    6253, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    91,   /* fields */
    29,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    gx5_25_also,
    gx5_25_incomplete,
    gx5_25_fields,
    gx5_25_refuses,
    gx5_25_absent_sets,
    NULL,
    NULL,
    gx5_25_readings,
};

/* 3DM-GX5-35. */

static const char *const gx5_35_also[] = {
    "3DM-GX5-GNSS/AHRS",
};

static const char *const gx5_35_incomplete[] = {
    "Only some pages of its manual are known; the device has further commands and data.",
};

static const struct mip_profile_evidence gx5_35_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.", ""},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field gx5_35_fields[] = {
    {0x01, 0x01, "", &gx5_35_evidence[0]},       {0x01, 0x02, "", &gx5_35_evidence[1]},
    {0x01, 0x03, "", &gx5_35_evidence[0]},       {0x01, 0x04, "", &gx5_35_evidence[0]},
    {0x01, 0x05, "", &gx5_35_evidence[2]},       {0x01, 0x06, "", &gx5_35_evidence[1]},
    {0x01, 0x07, "", &gx5_35_evidence[0]},       {0x01, 0x72, "WRA", &gx5_35_evidence[0]},
    {0x01, 0x7E, "", &gx5_35_evidence[2]},       {0x0C, 0x01, "", &gx5_35_evidence[0]},
    {0x0C, 0x02, "", &gx5_35_evidence[2]},       {0x0C, 0x06, "", &gx5_35_evidence[1]},
    {0x0C, 0x07, "", &gx5_35_evidence[0]},       {0x0C, 0x08, "WRSLD", &gx5_35_evidence[0]},
    {0x0C, 0x09, "WRSLD", &gx5_35_evidence[0]},  {0x0C, 0x11, "WRSLD", &gx5_35_evidence[0]},
    {0x0C, 0x21, "WRSLD", &gx5_35_evidence[0]},  {0x0C, 0x22, "WRSLD", &gx5_35_evidence[0]},
    {0x0C, 0x23, "WRSLD", &gx5_35_evidence[0]},  {0x0C, 0x24, "WR", &gx5_35_evidence[0]},
    {0x0C, 0x30, "SLD", &gx5_35_evidence[0]},    {0x0C, 0x37, "WRSLDA", &gx5_35_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &gx5_35_evidence[2]}, {0x0C, 0x39, "", &gx5_35_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &gx5_35_evidence[2]}, {0x0C, 0x3B, "WRSLDA", &gx5_35_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &gx5_35_evidence[2]},  {0x0C, 0x40, "WRSLD", &gx5_35_evidence[2]},
    {0x0C, 0x50, "WRSLD", &gx5_35_evidence[2]},  {0x0C, 0x51, "WRSLD", &gx5_35_evidence[0]},
    {0x0C, 0x64, "", &gx5_35_evidence[0]},       {0x7F, 0x10, "WRSLD", &gx5_35_evidence[0]},
    {0x80, 0x04, "", &gx5_35_evidence[0]},       {0x80, 0x05, "", &gx5_35_evidence[0]},
    {0x80, 0x06, "", &gx5_35_evidence[0]},       {0x80, 0x07, "", &gx5_35_evidence[0]},
    {0x80, 0x08, "", &gx5_35_evidence[2]},       {0x80, 0x09, "", &gx5_35_evidence[2]},
    {0x80, 0x0A, "", &gx5_35_evidence[2]},       {0x80, 0x0C, "", &gx5_35_evidence[2]},
    {0x80, 0x10, "", &gx5_35_evidence[2]},       {0x80, 0x11, "", &gx5_35_evidence[0]},
    {0x80, 0x12, "", &gx5_35_evidence[0]},       {0x80, 0x17, "", &gx5_35_evidence[0]},
    {0x81, 0x03, "", &gx5_35_evidence[2]},       {0x81, 0x04, "", &gx5_35_evidence[2]},
    {0x81, 0x05, "", &gx5_35_evidence[2]},       {0x81, 0x06, "", &gx5_35_evidence[0]},
    {0x81, 0x07, "", &gx5_35_evidence[2]},       {0x81, 0x08, "", &gx5_35_evidence[2]},
    {0x81, 0x09, "", &gx5_35_evidence[2]},       {0x81, 0x0A, "", &gx5_35_evidence[2]},
    {0x81, 0x0B, "", &gx5_35_evidence[2]},       {0x81, 0x0C, "", &gx5_35_evidence[2]},
    {0x81, 0x0D, "", &gx5_35_evidence[2]},       {0x81, 0x0E, "", &gx5_35_evidence[0]},
    {0x81, 0x0F, "", &gx5_35_evidence[2]},
};

static const struct mip_profile_field gx5_35_absent_sets[] = {
    {0x92, 0, "", &gx5_35_evidence[3]},
};

static const struct mip_profile_rate gx5_35_rates[] = {
    {0x80, 500},
    {0x81, 4},
};

static const struct mip_profile_reading gx5_35_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
};

const struct mip_profile mip_profile_gx5_35 = {
    "3dm-gx5-35",
    "3DM-GX5-35",
    "3dm-gx5-35",
    "Attitude and heading reference system (AHRS) with GNSS.",
    6252, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    57,   /* fields */
    0,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    2,    /* base rates */
    3,    /* readings */
    gx5_35_also,
    gx5_35_incomplete,
    gx5_35_fields,
    NULL,
    gx5_35_absent_sets,
    NULL,
    gx5_35_rates,
    gx5_35_readings,
};

/* 3DM-GX5-45. */

static const char *const gx5_45_also[] = {
    "3DM-GX5-GNSS/INS",
};

static const char *const gx5_45_incomplete[] = {
    "Only some pages of its manual are known; the device has further commands and data.",
    "Only four fields of the filter data are listed; the manual documents 27 or more.",
};

static const struct mip_profile_evidence gx5_45_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_YES, "Documented (LORD 3DM-GX5-45 DCP Manual: Single pages).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples "
     "of the versions 1 to 3).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ROS driver microstrain_mips: Table of tested functions).",
     ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (ArduPilot: AP_ExternalAHRS_MicroStrain5).", ""},
    {MIP_SUPPORT_ASSUMED,
     "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-35.", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
     ""},
    {MIP_SUPPORT_NO, "Rejected by the device (MicroStrain Communication Library: Issue 43).", ""},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field gx5_45_fields[] = {
    {0x01, 0x01, "", &gx5_45_evidence[2]},       {0x01, 0x02, "", &gx5_45_evidence[2]},
    {0x01, 0x03, "", &gx5_45_evidence[0]},       {0x01, 0x04, "", &gx5_45_evidence[7]},
    {0x01, 0x05, "", &gx5_45_evidence[8]},       {0x01, 0x06, "", &gx5_45_evidence[1]},
    {0x01, 0x07, "", &gx5_45_evidence[1]},       {0x01, 0x72, "WRA", &gx5_45_evidence[8]},
    {0x01, 0x7E, "", &gx5_45_evidence[0]},       {0x0C, 0x01, "", &gx5_45_evidence[8]},
    {0x0C, 0x02, "", &gx5_45_evidence[0]},       {0x0C, 0x03, "", &gx5_45_evidence[0]},
    {0x0C, 0x06, "", &gx5_45_evidence[0]},       {0x0C, 0x07, "", &gx5_45_evidence[0]},
    {0x0C, 0x08, "WRSLD", &gx5_45_evidence[0]},  {0x0C, 0x09, "WRSLD", &gx5_45_evidence[0]},
    {0x0C, 0x0A, "WRSLD", &gx5_45_evidence[0]},  {0x0C, 0x0B, "", &gx5_45_evidence[0]},
    {0x0C, 0x11, "WRSLD", &gx5_45_evidence[4]},  {0x0C, 0x20, "", &gx5_45_evidence[0]},
    {0x0C, 0x21, "WRSLD", &gx5_45_evidence[8]},  {0x0C, 0x22, "WRSLD", &gx5_45_evidence[8]},
    {0x0C, 0x23, "WRSLD", &gx5_45_evidence[8]},  {0x0C, 0x24, "WR", &gx5_45_evidence[8]},
    {0x0C, 0x30, "SLD", &gx5_45_evidence[0]},    {0x0C, 0x37, "WRSLDA", &gx5_45_evidence[4]},
    {0x0C, 0x38, "WRSLDA", &gx5_45_evidence[4]}, {0x0C, 0x39, "", &gx5_45_evidence[3]},
    {0x0C, 0x3A, "WRSLDA", &gx5_45_evidence[0]}, {0x0C, 0x3B, "WRSLDA", &gx5_45_evidence[4]},
    {0x0C, 0x3E, "WRSLD", &gx5_45_evidence[4]},  {0x0C, 0x40, "WRSLD", &gx5_45_evidence[0]},
    {0x0C, 0x50, "WRSLD", &gx5_45_evidence[8]},  {0x0C, 0x51, "WRSLD", &gx5_45_evidence[4]},
    {0x0C, 0x64, "", &gx5_45_evidence[0]},       {0x0D, 0x01, "", &gx5_45_evidence[2]},
    {0x0D, 0x02, "", &gx5_45_evidence[4]},       {0x0D, 0x03, "", &gx5_45_evidence[0]},
    {0x0D, 0x10, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x11, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x12, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x13, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x14, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x15, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x16, "", &gx5_45_evidence[0]},       {0x0D, 0x17, "", &gx5_45_evidence[0]},
    {0x0D, 0x18, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x19, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x1A, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x1B, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x1C, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x1D, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x1E, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x1F, "", &gx5_45_evidence[0]},
    {0x0D, 0x20, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x21, "WSLD", &gx5_45_evidence[0]},
    {0x0D, 0x22, "", &gx5_45_evidence[0]},       {0x0D, 0x23, "", &gx5_45_evidence[0]},
    {0x0D, 0x26, "WRSLD", &gx5_45_evidence[4]},  {0x0D, 0x27, "WS", &gx5_45_evidence[0]},
    {0x0D, 0x28, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x29, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x2B, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x2C, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x42, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x43, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x44, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x45, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x46, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x47, "WRSLD", &gx5_45_evidence[0]},
    {0x0D, 0x4B, "WRSLD", &gx5_45_evidence[0]},  {0x0D, 0x53, "WRSLD", &gx5_45_evidence[5]},
    {0x7F, 0x10, "WRSLD", &gx5_45_evidence[0]},  {0x80, 0x04, "", &gx5_45_evidence[0]},
    {0x80, 0x05, "", &gx5_45_evidence[0]},       {0x80, 0x06, "", &gx5_45_evidence[0]},
    {0x80, 0x07, "", &gx5_45_evidence[8]},       {0x80, 0x08, "", &gx5_45_evidence[8]},
    {0x80, 0x09, "", &gx5_45_evidence[8]},       {0x80, 0x0A, "", &gx5_45_evidence[6]},
    {0x80, 0x0C, "", &gx5_45_evidence[8]},       {0x80, 0x10, "", &gx5_45_evidence[8]},
    {0x80, 0x11, "", &gx5_45_evidence[8]},       {0x80, 0x12, "", &gx5_45_evidence[2]},
    {0x80, 0x17, "", &gx5_45_evidence[6]},       {0x81, 0x03, "", &gx5_45_evidence[6]},
    {0x81, 0x04, "", &gx5_45_evidence[8]},       {0x81, 0x05, "", &gx5_45_evidence[6]},
    {0x81, 0x06, "", &gx5_45_evidence[8]},       {0x81, 0x07, "", &gx5_45_evidence[6]},
    {0x81, 0x08, "", &gx5_45_evidence[8]},       {0x81, 0x09, "", &gx5_45_evidence[8]},
    {0x81, 0x0A, "", &gx5_45_evidence[8]},       {0x81, 0x0B, "", &gx5_45_evidence[2]},
    {0x81, 0x0C, "", &gx5_45_evidence[0]},       {0x81, 0x0D, "", &gx5_45_evidence[0]},
    {0x81, 0x0E, "", &gx5_45_evidence[0]},       {0x81, 0x0F, "", &gx5_45_evidence[0]},
    {0x82, 0x01, "", &gx5_45_evidence[2]},       {0x82, 0x02, "", &gx5_45_evidence[2]},
    {0x82, 0x03, "", &gx5_45_evidence[6]},       {0x82, 0x04, "", &gx5_45_evidence[0]},
    {0x82, 0x05, "", &gx5_45_evidence[0]},       {0x82, 0x06, "", &gx5_45_evidence[9]},
    {0x82, 0x07, "", &gx5_45_evidence[9]},       {0x82, 0x08, "", &gx5_45_evidence[9]},
    {0x82, 0x09, "", &gx5_45_evidence[9]},       {0x82, 0x0A, "", &gx5_45_evidence[9]},
    {0x82, 0x0B, "", &gx5_45_evidence[9]},       {0x82, 0x0C, "", &gx5_45_evidence[9]},
    {0x82, 0x0D, "", &gx5_45_evidence[9]},       {0x82, 0x0E, "", &gx5_45_evidence[0]},
    {0x82, 0x0F, "", &gx5_45_evidence[9]},       {0x82, 0x10, "", &gx5_45_evidence[2]},
    {0x82, 0x11, "", &gx5_45_evidence[2]},       {0x82, 0x12, "", &gx5_45_evidence[9]},
    {0x82, 0x13, "", &gx5_45_evidence[9]},       {0x82, 0x14, "", &gx5_45_evidence[0]},
    {0x82, 0x15, "", &gx5_45_evidence[9]},       {0x82, 0x1C, "", &gx5_45_evidence[9]},
    {0x82, 0x20, "", &gx5_45_evidence[9]},       {0x82, 0x21, "", &gx5_45_evidence[9]},
    {0x82, 0x25, "", &gx5_45_evidence[9]},       {0x82, 0x26, "", &gx5_45_evidence[9]},
    {0x82, 0x28, "", &gx5_45_evidence[9]},       {0x82, 0x29, "", &gx5_45_evidence[9]},
};

static const struct mip_profile_field gx5_45_refuses[] = {
    {0x80, 0x01, "", &gx5_45_evidence[10]},
    {0x82, 0x49, "", &gx5_45_evidence[11]},
};

static const struct mip_profile_field gx5_45_absent_sets[] = {
    {0x92, 0, "", &gx5_45_evidence[12]},
};

static const struct mip_profile_rate gx5_45_rates[] = {
    {0x80, 500},
    {0x81, 4},
    {0x82, 500},
};

static const struct mip_profile_reading gx5_45_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_gx5_45 = {
    "3dm-gx5-45",
    "3DM-GX5-45",
    "3dm-gx5-45",
    "Inertial navigation system with GNSS, magnetometer and pressure sensor.",
    6251, /* model number */
    5,    /* generation */
    1,    /* other names */
    2,    /* what is not known */
    126,  /* fields */
    2,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    3,    /* base rates */
    6,    /* readings */
    gx5_45_also,
    gx5_45_incomplete,
    gx5_45_fields,
    gx5_45_refuses,
    gx5_45_absent_sets,
    NULL,
    gx5_45_rates,
    gx5_45_readings,
};

/* 3DM-MV5-AR. */

static const char *const mv5_ar_also[] = {
    "3DM-MV5-15",
};

static const char *const mv5_ar_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence mv5_ar_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
    {MIP_SUPPORT_NO, "Requires a receiver, which the device lacks.", "has no GNSS receiver"},
    {MIP_SUPPORT_NO, "Requires a magnetometer, which the device lacks.", "has no magnetometer"},
};

static const struct mip_profile_field mv5_ar_fields[] = {
    {0x01, 0x01, "", &mv5_ar_evidence[0]}, {0x01, 0x02, "", &mv5_ar_evidence[0]},
    {0x01, 0x03, "", &mv5_ar_evidence[0]}, {0x01, 0x04, "", &mv5_ar_evidence[0]},
    {0x01, 0x06, "", &mv5_ar_evidence[0]}, {0x0C, 0x11, "WRSLD", &mv5_ar_evidence[0]},
};

static const struct mip_profile_field mv5_ar_refuses[] = {
    {0x0C, 0x02, "", &mv5_ar_evidence[1]}, {0x0C, 0x07, "", &mv5_ar_evidence[1]},
    {0x0C, 0x09, "", &mv5_ar_evidence[1]}, {0x0C, 0x20, "", &mv5_ar_evidence[1]},
    {0x0C, 0x21, "", &mv5_ar_evidence[1]}, {0x0C, 0x22, "", &mv5_ar_evidence[1]},
    {0x0C, 0x23, "", &mv5_ar_evidence[1]}, {0x0C, 0x24, "", &mv5_ar_evidence[1]},
    {0x0C, 0x34, "", &mv5_ar_evidence[1]}, {0x0C, 0x3A, "", &mv5_ar_evidence[2]},
    {0x0C, 0x3B, "", &mv5_ar_evidence[2]}, {0x0C, 0x62, "", &mv5_ar_evidence[1]},
};

static const struct mip_profile_field mv5_ar_absent_sets[] = {
    {0x81, 0, "", &mv5_ar_evidence[1]},
    {0x91, 0, "", &mv5_ar_evidence[1]},
    {0x92, 0, "", &mv5_ar_evidence[1]},
    {0x93, 0, "", &mv5_ar_evidence[1]},
};

static const struct mip_profile_reading mv5_ar_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_mv5_ar = {
    "3dm-mv5-ar",
    "3DM-MV5-AR",
    "",
    "Device of generation 5.",
    6243, /* model number */
    5,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    6,    /* fields */
    12,   /* refused fields */
    4,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    mv5_ar_also,
    mv5_ar_incomplete,
    mv5_ar_fields,
    mv5_ar_refuses,
    mv5_ar_absent_sets,
    NULL,
    NULL,
    mv5_ar_readings,
};

/* 3DM-RQ1-45-LT. */

static const char *const rq1_45_lt_also[] = {
    "3DM-RQ1-45_LT",
};

static const char *const rq1_45_lt_incomplete[] = {
    "The manual's table of contents is known only up to `filter.set_initial_heading`. The unknown "
    "part includes the set `system`.",
    "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.",
};

static const struct mip_profile_evidence rq1_45_lt_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field rq1_45_lt_fields[] = {
    {0x01, 0x01, "", &rq1_45_lt_evidence[0]},       {0x01, 0x02, "", &rq1_45_lt_evidence[0]},
    {0x01, 0x03, "", &rq1_45_lt_evidence[0]},       {0x01, 0x04, "", &rq1_45_lt_evidence[0]},
    {0x01, 0x05, "", &rq1_45_lt_evidence[0]},       {0x01, 0x06, "", &rq1_45_lt_evidence[0]},
    {0x01, 0x7E, "", &rq1_45_lt_evidence[0]},       {0x0C, 0x01, "", &rq1_45_lt_evidence[0]},
    {0x0C, 0x02, "", &rq1_45_lt_evidence[0]},       {0x0C, 0x03, "", &rq1_45_lt_evidence[0]},
    {0x0C, 0x06, "", &rq1_45_lt_evidence[0]},       {0x0C, 0x07, "", &rq1_45_lt_evidence[0]},
    {0x0C, 0x08, "WRSLD", &rq1_45_lt_evidence[0]},  {0x0C, 0x09, "WRSLD", &rq1_45_lt_evidence[0]},
    {0x0C, 0x0A, "WRSLD", &rq1_45_lt_evidence[0]},  {0x0C, 0x0B, "", &rq1_45_lt_evidence[0]},
    {0x0C, 0x11, "WRSLD", &rq1_45_lt_evidence[0]},  {0x0C, 0x20, "", &rq1_45_lt_evidence[0]},
    {0x0C, 0x30, "SLD", &rq1_45_lt_evidence[0]},    {0x0C, 0x37, "WRSLDA", &rq1_45_lt_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &rq1_45_lt_evidence[0]}, {0x0C, 0x39, "", &rq1_45_lt_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &rq1_45_lt_evidence[0]}, {0x0C, 0x3B, "WRSLDA", &rq1_45_lt_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &rq1_45_lt_evidence[0]},  {0x0C, 0x40, "WRSLD", &rq1_45_lt_evidence[0]},
    {0x0C, 0x50, "WRSLD", &rq1_45_lt_evidence[0]},  {0x0C, 0x64, "", &rq1_45_lt_evidence[0]},
    {0x0D, 0x01, "", &rq1_45_lt_evidence[0]},       {0x0D, 0x02, "", &rq1_45_lt_evidence[0]},
    {0x0D, 0x03, "", &rq1_45_lt_evidence[0]},       {0x0D, 0x10, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x11, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x12, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x13, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x14, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x15, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x16, "", &rq1_45_lt_evidence[1]},
    {0x0D, 0x17, "", &rq1_45_lt_evidence[1]},       {0x0D, 0x18, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x19, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x1A, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x1B, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x1C, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x1D, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x1E, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x1F, "", &rq1_45_lt_evidence[1]},       {0x0D, 0x20, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x21, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x22, "", &rq1_45_lt_evidence[1]},
    {0x0D, 0x23, "", &rq1_45_lt_evidence[1]},       {0x0D, 0x42, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x43, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x44, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x0D, 0x45, "WRSLD", &rq1_45_lt_evidence[1]},  {0x0D, 0x46, "WRSLD", &rq1_45_lt_evidence[1]},
    {0x7F, 0x10, "WRSLD", &rq1_45_lt_evidence[1]},  {0x80, 0x04, "", &rq1_45_lt_evidence[1]},
    {0x80, 0x05, "", &rq1_45_lt_evidence[1]},       {0x80, 0x06, "", &rq1_45_lt_evidence[1]},
    {0x81, 0x03, "", &rq1_45_lt_evidence[1]},       {0x81, 0x05, "", &rq1_45_lt_evidence[1]},
    {0x81, 0x09, "", &rq1_45_lt_evidence[1]},       {0x82, 0x01, "", &rq1_45_lt_evidence[1]},
    {0x82, 0x02, "", &rq1_45_lt_evidence[1]},       {0x82, 0x05, "", &rq1_45_lt_evidence[1]},
};

static const struct mip_profile_field rq1_45_lt_refuses[] = {
    {0x82, 0x49, "", &rq1_45_lt_evidence[2]},
};

static const struct mip_profile_field rq1_45_lt_absent_sets[] = {
    {0x92, 0, "", &rq1_45_lt_evidence[3]},
};

static const struct mip_profile_reading rq1_45_lt_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.device_status_basic_response.system_state", "3dm.gx4_system_state"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_rq1_45_lt = {
    "3dm-rq1-45-lt",
    "3DM-RQ1-45-LT",
    "3dm-rq1-45",
    "Ruggedized tactical grade inertial navigation system with GPS.",
    6232, /* model number */
    4,    /* generation */
    1,    /* other names */
    2,    /* what is not known */
    66,   /* fields */
    1,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    rq1_45_lt_also,
    rq1_45_lt_incomplete,
    rq1_45_lt_fields,
    rq1_45_lt_refuses,
    rq1_45_lt_absent_sets,
    NULL,
    NULL,
    rq1_45_lt_readings,
};

/* 3DM-RQ1-45-ST. */

static const char *const rq1_45_st_also[] = {
    "3DM-RQ1-45_ST",
};

static const char *const rq1_45_st_incomplete[] = {
    "The manual's table of contents is known only up to `filter.set_initial_heading`. The unknown "
    "part includes the set `system`.",
    "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.",
};

static const struct mip_profile_evidence rq1_45_st_evidence[] = {
    {MIP_SUPPORT_YES, "Documented.", ""},
    {MIP_SUPPORT_ASSUMED, "Supported by nearly identical devices, 3DM-RQ1-45-LT.", ""},
    {MIP_SUPPORT_NO, "Requires 2 antennas, which the device lacks.",
     "has fewer than 2 GNSS antennas"},
    {MIP_SUPPORT_NO, "Requires 2 receivers, which the device lacks.",
     "has fewer than 2 GNSS receivers"},
};

static const struct mip_profile_field rq1_45_st_fields[] = {
    {0x01, 0x01, "", &rq1_45_st_evidence[0]},       {0x01, 0x02, "", &rq1_45_st_evidence[0]},
    {0x01, 0x03, "", &rq1_45_st_evidence[0]},       {0x01, 0x04, "", &rq1_45_st_evidence[0]},
    {0x01, 0x05, "", &rq1_45_st_evidence[0]},       {0x01, 0x06, "", &rq1_45_st_evidence[0]},
    {0x01, 0x7E, "", &rq1_45_st_evidence[0]},       {0x0C, 0x01, "", &rq1_45_st_evidence[0]},
    {0x0C, 0x02, "", &rq1_45_st_evidence[0]},       {0x0C, 0x03, "", &rq1_45_st_evidence[0]},
    {0x0C, 0x06, "", &rq1_45_st_evidence[0]},       {0x0C, 0x07, "", &rq1_45_st_evidence[0]},
    {0x0C, 0x08, "WRSLD", &rq1_45_st_evidence[0]},  {0x0C, 0x09, "WRSLD", &rq1_45_st_evidence[0]},
    {0x0C, 0x0A, "WRSLD", &rq1_45_st_evidence[0]},  {0x0C, 0x0B, "", &rq1_45_st_evidence[0]},
    {0x0C, 0x11, "WRSLD", &rq1_45_st_evidence[0]},  {0x0C, 0x20, "", &rq1_45_st_evidence[0]},
    {0x0C, 0x30, "SLD", &rq1_45_st_evidence[0]},    {0x0C, 0x37, "WRSLDA", &rq1_45_st_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &rq1_45_st_evidence[0]}, {0x0C, 0x39, "", &rq1_45_st_evidence[0]},
    {0x0C, 0x3A, "WRSLDA", &rq1_45_st_evidence[0]}, {0x0C, 0x3B, "WRSLDA", &rq1_45_st_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &rq1_45_st_evidence[0]},  {0x0C, 0x40, "WRSLD", &rq1_45_st_evidence[0]},
    {0x0C, 0x50, "WRSLD", &rq1_45_st_evidence[0]},  {0x0C, 0x64, "", &rq1_45_st_evidence[0]},
    {0x0D, 0x01, "", &rq1_45_st_evidence[0]},       {0x0D, 0x02, "", &rq1_45_st_evidence[0]},
    {0x0D, 0x03, "", &rq1_45_st_evidence[0]},       {0x0D, 0x10, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x11, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x12, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x13, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x14, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x15, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x16, "", &rq1_45_st_evidence[1]},
    {0x0D, 0x17, "", &rq1_45_st_evidence[1]},       {0x0D, 0x18, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x19, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x1A, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x1B, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x1C, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x1D, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x1E, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x1F, "", &rq1_45_st_evidence[1]},       {0x0D, 0x20, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x21, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x22, "", &rq1_45_st_evidence[1]},
    {0x0D, 0x23, "", &rq1_45_st_evidence[1]},       {0x0D, 0x42, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x43, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x44, "WRSLD", &rq1_45_st_evidence[1]},
    {0x0D, 0x45, "WRSLD", &rq1_45_st_evidence[1]},  {0x0D, 0x46, "WRSLD", &rq1_45_st_evidence[1]},
    {0x7F, 0x10, "WRSLD", &rq1_45_st_evidence[1]},  {0x80, 0x04, "", &rq1_45_st_evidence[1]},
    {0x80, 0x05, "", &rq1_45_st_evidence[1]},       {0x80, 0x06, "", &rq1_45_st_evidence[1]},
    {0x81, 0x03, "", &rq1_45_st_evidence[1]},       {0x81, 0x05, "", &rq1_45_st_evidence[1]},
    {0x81, 0x09, "", &rq1_45_st_evidence[1]},       {0x82, 0x01, "", &rq1_45_st_evidence[1]},
    {0x82, 0x02, "", &rq1_45_st_evidence[1]},       {0x82, 0x05, "", &rq1_45_st_evidence[1]},
};

static const struct mip_profile_field rq1_45_st_refuses[] = {
    {0x82, 0x49, "", &rq1_45_st_evidence[2]},
};

static const struct mip_profile_field rq1_45_st_absent_sets[] = {
    {0x92, 0, "", &rq1_45_st_evidence[3]},
};

static const struct mip_profile_reading rq1_45_st_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.device_status_basic_response.system_state", "3dm.gx4_system_state"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_rq1_45_st = {
    "3dm-rq1-45-st",
    "3DM-RQ1-45-ST",
    "3dm-rq1-45",
    "Ruggedized tactical grade inertial navigation system with GPS.",
    6239, /* model number */
    4,    /* generation */
    1,    /* other names */
    2,    /* what is not known */
    66,   /* fields */
    1,    /* refused fields */
    1,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    7,    /* readings */
    rq1_45_st_also,
    rq1_45_st_incomplete,
    rq1_45_st_fields,
    rq1_45_st_refuses,
    rq1_45_st_absent_sets,
    NULL,
    NULL,
    rq1_45_st_readings,
};

/* 3DM-RQ1-IMU. */

static const char *const rq1_imu_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence rq1_imu_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
     ""},
    {MIP_SUPPORT_ASSUMED, "Supported by devices of the same generation, 3DM-GX4-25.", ""},
};

static const struct mip_profile_field rq1_imu_fields[] = {
    {0x01, 0x01, "", &rq1_imu_evidence[0]},       {0x01, 0x02, "", &rq1_imu_evidence[0]},
    {0x01, 0x03, "", &rq1_imu_evidence[0]},       {0x01, 0x04, "", &rq1_imu_evidence[0]},
    {0x01, 0x05, "", &rq1_imu_evidence[0]},       {0x01, 0x06, "", &rq1_imu_evidence[1]},
    {0x0C, 0x01, "", &rq1_imu_evidence[0]},       {0x0C, 0x06, "", &rq1_imu_evidence[0]},
    {0x0C, 0x08, "WRSLD", &rq1_imu_evidence[0]},  {0x0C, 0x37, "WRSLDA", &rq1_imu_evidence[0]},
    {0x0C, 0x38, "WRSLDA", &rq1_imu_evidence[0]}, {0x0C, 0x39, "", &rq1_imu_evidence[0]},
    {0x0C, 0x3E, "WRSLD", &rq1_imu_evidence[0]},  {0x0C, 0x64, "", &rq1_imu_evidence[0]},
    {0x7F, 0x10, "WRSLD", &rq1_imu_evidence[0]},
};

static const struct mip_profile_reading rq1_imu_readings[] = {
    {"3dm.data_stream_control.descriptor_set", "3dm.legacy_data_stream"},
    {"3dm.data_stream_control_response.descriptor_set", "3dm.legacy_data_stream"},
    {"sensor.gps_timestamp.valid_flags", "gx5_sensor_gps_timestamp_flags"},
    {"filter_data.status.filter_state", "filter_data.gx5_filter_state"},
    {"filter_data.status.dynamics_mode", "filter_data.gx5_dynamics_mode"},
    {"filter_data.status.status_flags", "filter_data.gx5_status_flags"},
};

const struct mip_profile mip_profile_rq1_imu = {
    "3dm-rq1-imu",
    "3DM-RQ1-IMU",
    "",
    "Inertial sensor inside the 3DM-RQ1-45, which replies in the direct mode.",
    6238, /* model number */
    4,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    15,   /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    6,    /* readings */
    NULL,
    rq1_imu_incomplete,
    rq1_imu_fields,
    NULL,
    NULL,
    NULL,
    NULL,
    rq1_imu_readings,
};

/* 3DM-RTK. */

static const char *const rtk_incomplete[] = {
    "No manual is known.",
};

static const struct mip_profile_evidence rtk_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: MIP node features).", ""},
};

static const struct mip_profile_field rtk_fields[] = {
    {0x01, 0x01, "", &rtk_evidence[0]},      {0x01, 0x02, "", &rtk_evidence[0]},
    {0x01, 0x03, "", &rtk_evidence[0]},      {0x01, 0x04, "", &rtk_evidence[0]},
    {0x01, 0x05, "", &rtk_evidence[0]},      {0x01, 0x06, "", &rtk_evidence[0]},
    {0x01, 0x09, "WRSLD", &rtk_evidence[0]}, {0x01, 0x7E, "", &rtk_evidence[0]},
    {0x0C, 0x30, "SLD", &rtk_evidence[0]},   {0x0F, 0x01, "", &rtk_evidence[0]},
    {0x0F, 0x07, "", &rtk_evidence[0]},      {0x7F, 0x10, "WRSLD", &rtk_evidence[0]},
};

static const struct mip_profile_reading rtk_readings[] = {
    {"base.built_in_test_response.result", "cv7_built_in_test"},
};

const struct mip_profile mip_profile_rtk = {
    "3dm-rtk", "3DM-RTK",      "",         "Modem for GNSS corrections.",
    6285, /* model number */
    7,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    12,   /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    1,    /* readings */
    NULL,      rtk_incomplete, rtk_fields, NULL,
    NULL,      NULL,           NULL,       rtk_readings,
};

/* DEMOD-DC. */

static const char *const demod_dc_also[] = {
    "Digital Demod",
};

static const char *const demod_dc_incomplete[] = {
    "No manual is known; everything here is from MSCL.",
};

static const struct mip_profile_evidence demod_dc_evidence[] = {
    {MIP_SUPPORT_LIKELY,
     "Used by programs for this model (MicroStrain Communication Library: Displacement node).", ""},
};

static const struct mip_profile_field demod_dc_fields[] = {
    {0x01, 0x01, "", &demod_dc_evidence[0]},  {0x01, 0x02, "", &demod_dc_evidence[0]},
    {0x01, 0x03, "", &demod_dc_evidence[0]},  {0x01, 0x04, "", &demod_dc_evidence[0]},
    {0x01, 0x06, "", &demod_dc_evidence[0]},  {0x11, 0x01, "", &demod_dc_evidence[0]},
    {0x11, 0x02, "R", &demod_dc_evidence[0]}, {0x11, 0x04, "W", &demod_dc_evidence[0]},
    {0x90, 0x01, "", &demod_dc_evidence[0]},  {0x90, 0x02, "", &demod_dc_evidence[0]},
    {0x90, 0x04, "", &demod_dc_evidence[0]},
};

const struct mip_profile mip_profile_demod_dc = {
    "demod-dc",
    "DEMOD-DC",
    "",
    "Digital demodulator for displacement sensors.",
    6130, /* model number */
    0,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    11,   /* fields */
    0,    /* refused fields */
    0,    /* absent sets */
    0,    /* fields of some firmware */
    0,    /* base rates */
    0,    /* readings */
    demod_dc_also,
    demod_dc_incomplete,
    demod_dc_fields,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
};

/* All profiles. */

const struct mip_profile *const mip_profiles[] = {
    &mip_profile_cv5_10, &mip_profile_cv5_15,       &mip_profile_cv5_25,    &mip_profile_cv7_ahrs,
    &mip_profile_cv7_ar, &mip_profile_cv7_gnss_ins, &mip_profile_cv7_ins,   &mip_profile_cx5_10,
    &mip_profile_cx5_15, &mip_profile_cx5_25,       &mip_profile_cx5_45,    &mip_profile_cx7_ahrs,
    &mip_profile_cx7_ar, &mip_profile_cx7_ins,      &mip_profile_dh3,       &mip_profile_gq4_45,
    &mip_profile_gq7,    &mip_profile_gv7_ahrs,     &mip_profile_gv7_ar,    &mip_profile_gv7_ins,
    &mip_profile_gx3_15, &mip_profile_gx3_25,       &mip_profile_gx3_35,    &mip_profile_gx3_45,
    &mip_profile_gx4_15, &mip_profile_gx4_25,       &mip_profile_gx4_45,    &mip_profile_gx4_imu,
    &mip_profile_gx5_15, &mip_profile_gx5_25,       &mip_profile_gx5_35,    &mip_profile_gx5_45,
    &mip_profile_mv5_ar, &mip_profile_rq1_45_lt,    &mip_profile_rq1_45_st, &mip_profile_rq1_imu,
    &mip_profile_rtk,    &mip_profile_demod_dc,
};
const size_t mip_profile_count = 38;
