

/* Device profiles. */
#include "mip/profiles.h"

/* Model A. */

static const struct mip_profile_evidence model_a_evidence[] = {
    {MIP_SUPPORT_YES, "Documented."},
};

static const struct mip_profile_field model_a_fields[] = {
    {0x01, 0x01, "", &model_a_evidence[0]},      {0x01, 0x02, "WRSLDA", &model_a_evidence[0]},
    {0x01, 0x03, "WRA", &model_a_evidence[0]},   {0x01, 0x04, "", &model_a_evidence[0]},
    {0x01, 0x05, "WRSLD", &model_a_evidence[0]}, {0x01, 0x06, "", &model_a_evidence[0]},
    {0x01, 0x07, "", &model_a_evidence[0]},      {0x01, 0x08, "WR", &model_a_evidence[0]},
    {0x01, 0x09, "WRS", &model_a_evidence[0]},   {0x01, 0x0A, "", &model_a_evidence[0]},
    {0x01, 0x0B, "WR", &model_a_evidence[0]},    {0x01, 0x0D, "", &model_a_evidence[0]},
    {0x0C, 0x10, "", &model_a_evidence[0]},      {0x80, 0x01, "", &model_a_evidence[0]},
    {0x80, 0x02, "", &model_a_evidence[0]},      {0x80, 0x03, "", &model_a_evidence[0]},
    {0x80, 0x04, "", &model_a_evidence[0]},      {0x80, 0x05, "", &model_a_evidence[0]},
    {0x80, 0x06, "", &model_a_evidence[0]},      {0x80, 0x08, "", &model_a_evidence[0]},
    {0x80, 0x0A, "", &model_a_evidence[0]},      {0x81, 0x01, "", &model_a_evidence[0]},
    {0x81, 0x03, "", &model_a_evidence[0]},      {0x81, 0x07, "", &model_a_evidence[0]},
    {0xFF, 0xD3, "", &model_a_evidence[0]},
};

static const struct mip_profile_rate model_a_rates[] = {
    {0x80, 1000},
    {0x81, 500},
};

static const uint32_t model_a_baud_rates_1[] = {9600, 115200};

static const struct mip_profile_port model_a_ports[] = {
    {"Main", 0x11, 2, model_a_baud_rates_1, "MIP, NMEA", "MIP, NMEA"},
    {"USB", 0x00, 0, NULL, "MIP", "MIP"},
};

static const struct mip_profile_limit model_a_limits[] = {
    {"segments", 12, "", "In a format.", ""},
    {"range", 2.5, "g", "Of the sensor.", ""},
};

static const char *const model_a_pins_cells[] = {
    "Pin", "Use",    /* heading */
    "1",   "pulse",  /* row 1 */
    "2",   "serial", /* row 2 */
};

static const struct mip_profile_note model_a_notes[] = {
    {"pins", "Pins", "What each pin can do.", model_a_pins_cells, 3, 2},
};

static const struct mip_profile_reading model_a_readings[] = {
    {"tools.status_short.flags", "tools.model_a_faults"},
    {"tools.status_long.flags", "tools.model_a_faults"},
};

static const uint8_t model_a_ack_codes[] = {0, 1, 3};

const struct mip_profile mip_profile_model_a = {
    "model-a",
    "Model A",
    "guide",
    "Supports nearly everything.",
    4711, /* model number */
    0,    /* generation */
    0,    /* other names */
    0,    /* what is not known */
    25,   /* fields */
    0,    /* refused fields */
    0,    /* fields of some firmware */
    2,    /* base rates */
    2,    /* ports */
    2,    /* limits */
    1,    /* notes */
    2,    /* readings */
    3,    /* acknowledge codes */
    NULL,
    NULL,
    model_a_fields,
    NULL,
    NULL,
    model_a_rates,
    model_a_ports,
    model_a_limits,
    model_a_notes,
    model_a_readings,
    model_a_ack_codes,
};

/* Model B. */

static const struct mip_profile_evidence model_b_evidence[] = {
    {MIP_SUPPORT_YES, "Documented."},
};

static const struct mip_profile_field model_b_fields[] = {
    {0x01, 0x01, "", &model_b_evidence[0]},
    {0x01, 0x02, "WR", &model_b_evidence[0]},
    {0x01, 0x04, "", &model_b_evidence[0]},
    {0x80, 0x01, "", &model_b_evidence[0]},
};

static const struct mip_profile_rate model_b_rates[] = {
    {0x80, 0},
};

static const struct mip_profile_reading model_b_readings[] = {
    {"protocol.acknowledge.code", "mode"},
    {"tools.status_short.flags", "tools.model_b_faults"},
    {"tools.status_long.flags", "tools.model_b_faults"},
};

static const uint8_t model_b_ack_codes[] = {0, 1};

const struct mip_profile mip_profile_model_b = {
    "model-b",
    "Model B",
    "leaflet",
    "Small, and reads the acknowledge code in its own way.",
    0, /* model number */
    0, /* generation */
    0, /* other names */
    0, /* what is not known */
    4, /* fields */
    0, /* refused fields */
    0, /* fields of some firmware */
    1, /* base rates */
    0, /* ports */
    0, /* limits */
    0, /* notes */
    3, /* readings */
    2, /* acknowledge codes */
    NULL,
    NULL,
    model_b_fields,
    NULL,
    NULL,
    model_b_rates,
    NULL,
    NULL,
    NULL,
    model_b_readings,
    model_b_ack_codes,
};

/* Model C. */

static const char *const model_c_also[] = {
    "Model See",
    "c",
};

static const struct mip_profile_evidence model_c_evidence[] = {
    {MIP_SUPPORT_YES, "Documented."},
    {MIP_SUPPORT_YES, "Listed by the device (firmware 1.0.07; 2026-11-23)."},
    {MIP_SUPPORT_PROBABLE,
     "Transcribed from the manual by others (Kit of names: Names). It names tools.hello."},
    {MIP_SUPPORT_NO, "Rejected by the device (firmware 1.2)."},
};

static const struct mip_profile_field model_c_fields[] = {
    {0x01, 0x01, "", &model_c_evidence[0]},      {0x01, 0x02, "WRS", &model_c_evidence[0]},
    {0x01, 0x03, "WRA", &model_c_evidence[0]},   {0x01, 0x04, "", &model_c_evidence[0]},
    {0x01, 0x05, "WRSLD", &model_c_evidence[0]}, {0x01, 0x06, "", &model_c_evidence[0]},
    {0x01, 0x07, "", &model_c_evidence[0]},      {0x01, 0x09, "WRS", &model_c_evidence[0]},
    {0x01, 0x0A, "", &model_c_evidence[0]},      {0x01, 0x0B, "WR", &model_c_evidence[0]},
    {0x01, 0x0C, "", &model_c_evidence[2]},      {0x01, 0x0D, "", &model_c_evidence[0]},
    {0x01, 0x0E, "", &model_c_evidence[1]},      {0x80, 0x01, "", &model_c_evidence[0]},
    {0x80, 0x02, "", &model_c_evidence[0]},      {0x80, 0x03, "", &model_c_evidence[0]},
    {0x80, 0x04, "", &model_c_evidence[0]},      {0x80, 0x05, "", &model_c_evidence[0]},
    {0x80, 0x06, "", &model_c_evidence[0]},      {0x80, 0x07, "", &model_c_evidence[0]},
    {0x80, 0x08, "", &model_c_evidence[0]},      {0x80, 0x0A, "", &model_c_evidence[0]},
    {0x81, 0x01, "", &model_c_evidence[0]},      {0x81, 0x07, "", &model_c_evidence[0]},
    {0x92, 0x01, "", &model_c_evidence[2]},      {0xFF, 0xD3, "", &model_c_evidence[0]},
};

static const struct mip_profile_field model_c_refuses[] = {
    {0x01, 0x08, "WR", &model_c_evidence[3]},
};

static const struct mip_profile_firmware model_c_firmware[] = {
    {0x01, 0x06, ">= 1.0, < 1.1"},
    {0x81, 0x01, "> 1.0.07"},
    {0x81, 0x07, "> 1.0.07"},
};

static const struct mip_profile_rate model_c_rates[] = {
    {0x80, 1000},
    {0x81, 250},
};

static const uint32_t model_c_baud_rates_1[] = {9600};

static const struct mip_profile_port model_c_ports[] = {
    {"Main", 0x12, 1, model_c_baud_rates_1, "MIP", "MIP"},
    {"CAN", 0x00, 0, NULL, "", ""},
};

static const struct mip_profile_limit model_c_limits[] = {
    {"segments", 6, "", "In a format.", "< 2.0"},
};

static const struct mip_profile_reading model_c_readings[] = {
    {"tools.status_short.flags", "tools.model_a_faults"},
};

static const uint8_t model_c_ack_codes[] = {0, 1, 3};

const struct mip_profile mip_profile_model_c = {
    "model-c",
    "Model C",
    "",
    "Like the model A, with a radio and without a choice.",
    4713, /* model number */
    3,    /* generation */
    2,    /* other names */
    0,    /* what is not known */
    26,   /* fields */
    1,    /* refused fields */
    3,    /* fields of some firmware */
    2,    /* base rates */
    2,    /* ports */
    1,    /* limits */
    0,    /* notes */
    1,    /* readings */
    3,    /* acknowledge codes */
    model_c_also,
    NULL,
    model_c_fields,
    model_c_refuses,
    model_c_firmware,
    model_c_rates,
    model_c_ports,
    model_c_limits,
    NULL,
    model_c_readings,
    model_c_ack_codes,
};

/* Old 1. */

static const char *const old_1_also[] = {
    "First",
};

static const char *const old_1_incomplete[] = {
    "No manual is known; see `tools.ping`.",
};

static const struct mip_profile_evidence old_1_evidence[] = {
    {MIP_SUPPORT_YES, "Documented."},
    {MIP_SUPPORT_PROBABLE, "Supported by devices of the same generation, Model A and Model B."},
};

static const struct mip_profile_field old_1_fields[] = {
    {0x01, 0x01, "", &old_1_evidence[0]},
    {0x80, 0x02, "", &old_1_evidence[1]},
};

const struct mip_profile mip_profile_old_1 = {
    "old-1",
    "Old 1",
    "",
    "Known by its name and number.",
    4001, /* model number */
    1,    /* generation */
    1,    /* other names */
    1,    /* what is not known */
    2,    /* fields */
    0,    /* refused fields */
    0,    /* fields of some firmware */
    0,    /* base rates */
    0,    /* ports */
    0,    /* limits */
    0,    /* notes */
    0,    /* readings */
    0,    /* acknowledge codes */
    old_1_also,
    old_1_incomplete,
    old_1_fields,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
};

/* Old 2. */

static const char *const old_2_incomplete[] = {
    "Nothing is known of its data.",
};

static const struct mip_profile_evidence old_2_evidence[] = {
    {MIP_SUPPORT_PROBABLE, "Supported by devices of the same generation, Model A and Model B."},
};

static const struct mip_profile_field old_2_fields[] = {
    {0x01, 0x01, "", &old_2_evidence[0]},
    {0x80, 0x02, "", &old_2_evidence[0]},
};

const struct mip_profile mip_profile_old_2 = {
    "old-2",
    "Old 2",
    "",
    "Known by its name and number.",
    4002, /* model number */
    1,    /* generation */
    0,    /* other names */
    1,    /* what is not known */
    2,    /* fields */
    0,    /* refused fields */
    0,    /* fields of some firmware */
    0,    /* base rates */
    0,    /* ports */
    0,    /* limits */
    0,    /* notes */
    0,    /* readings */
    0,    /* acknowledge codes */
    NULL,
    old_2_incomplete,
    old_2_fields,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
    NULL,
};

/* All profiles. */

const struct mip_profile *const mip_profiles[] = {
    &mip_profile_model_a, &mip_profile_model_b, &mip_profile_model_c,
    &mip_profile_old_1,   &mip_profile_old_2,
};
const size_t mip_profile_count = 5;
