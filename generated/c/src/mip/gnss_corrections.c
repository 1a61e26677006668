/* GNSS corrections data. */
#include "mip/gnss_corrections.h"
#include "mip/program.h"

static const uint8_t program_llh_position[] = {
    MIP_DOUBLES(4, MIP_AT(struct mip_gnss_corrections_llh_position, latitude)),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_corrections_llh_position, horizontal_accuracy)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_llh_position, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_llh_position_codec = {
    0x93,
    0x03,
    MIP_DATA,
    42,
    sizeof(struct mip_gnss_corrections_llh_position),
    program_llh_position};

static const uint8_t program_ecef_position[] = {
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_corrections_ecef_position, position)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_corrections_ecef_position, position_accuracy)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_ecef_position, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_ecef_position_codec = {
    0x93,
    0x04,
    MIP_DATA,
    30,
    sizeof(struct mip_gnss_corrections_ecef_position),
    program_ecef_position};

static const uint8_t program_ned_velocity[] = {
    MIP_32_BITS(8, MIP_AT(struct mip_gnss_corrections_ned_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_ned_velocity, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_ned_velocity_codec = {
    0x93,
    0x05,
    MIP_DATA,
    34,
    sizeof(struct mip_gnss_corrections_ned_velocity),
    program_ned_velocity};

static const uint8_t program_ecef_velocity[] = {
    MIP_32_BITS(4, MIP_AT(struct mip_gnss_corrections_ecef_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_ecef_velocity, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_ecef_velocity_codec = {
    0x93,
    0x06,
    MIP_DATA,
    18,
    sizeof(struct mip_gnss_corrections_ecef_velocity),
    program_ecef_velocity};

static const uint8_t program_dop[] = {
    MIP_32_BITS(7, MIP_AT(struct mip_gnss_corrections_dop, gdop)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_dop, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_dop_codec = {
    0x93, 0x07, MIP_DATA, 30, sizeof(struct mip_gnss_corrections_dop), program_dop};

static const uint8_t program_utc_time[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_utc_time, year)),
    MIP_8_BITS(5, MIP_AT(struct mip_gnss_corrections_utc_time, month)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_corrections_utc_time, msec)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_utc_time, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_utc_time_codec = {
    0x93, 0x08, MIP_DATA, 13, sizeof(struct mip_gnss_corrections_utc_time), program_utc_time};

static const uint8_t program_gps_time[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_gps_time, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_corrections_gps_time, week_number)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_gps_time_codec = {
    0x93, 0x09, MIP_DATA, 12, sizeof(struct mip_gnss_corrections_gps_time), program_gps_time};

static const uint8_t program_clock_info[] = {
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_corrections_clock_info, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_clock_info, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_clock_info_codec = {
    0x93, 0x0A, MIP_DATA, 26, sizeof(struct mip_gnss_corrections_clock_info), program_clock_info};

static const uint8_t program_fix_info[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_corrections_fix_info, fix_type)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_corrections_fix_info, fix_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_fix_info_codec = {
    0x93, 0x0B, MIP_DATA, 6, sizeof(struct mip_gnss_corrections_fix_info), program_fix_info};

static const uint8_t program_sv_info[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_corrections_sv_info, channel)),
    MIP_16_BITS(5, MIP_AT(struct mip_gnss_corrections_sv_info, carrier_noise_ratio)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_sv_info_codec = {
    0x93, 0x0C, MIP_DATA, 12, sizeof(struct mip_gnss_corrections_sv_info), program_sv_info};

static const uint8_t program_hardware_status[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_gnss_corrections_hardware_status, receiver_state)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_hardware_status, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_hardware_status_codec = {
    0x93,
    0x0D,
    MIP_DATA,
    5,
    sizeof(struct mip_gnss_corrections_hardware_status),
    program_hardware_status};

static const uint8_t program_dgps_info[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_corrections_dgps_info, age)),
    MIP_16_BITS(4, MIP_AT(struct mip_gnss_corrections_dgps_info, base_station_id)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_dgps_info_codec = {
    0x93, 0x0E, MIP_DATA, 12, sizeof(struct mip_gnss_corrections_dgps_info), program_dgps_info};

static const uint8_t program_dgps_channel[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_corrections_dgps_channel, satellite_id)),
    MIP_32_BITS(3, MIP_AT(struct mip_gnss_corrections_dgps_channel, age)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_dgps_channel, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_dgps_channel_codec = {
    0x93,
    0x0F,
    MIP_DATA,
    15,
    sizeof(struct mip_gnss_corrections_dgps_channel),
    program_dgps_channel};

static const uint8_t program_clock_info_2[] = {
    MIP_DOUBLES(4, MIP_AT(struct mip_gnss_corrections_clock_info_2, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_clock_info_2, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_clock_info_2_codec = {
    0x93,
    0x10,
    MIP_DATA,
    34,
    sizeof(struct mip_gnss_corrections_clock_info_2),
    program_clock_info_2};

static const uint8_t program_gps_leap_seconds[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_corrections_gps_leap_seconds, leap_seconds)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_gps_leap_seconds, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_gps_leap_seconds_codec = {
    0x93,
    0x11,
    MIP_DATA,
    3,
    sizeof(struct mip_gnss_corrections_gps_leap_seconds),
    program_gps_leap_seconds};

static const uint8_t program_sbas_info[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_sbas_info, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_sbas_info, week_number)),
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_corrections_sbas_info, sbas_system)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_sbas_info, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_sbas_info_codec = {
    0x93, 0x12, MIP_DATA, 16, sizeof(struct mip_gnss_corrections_sbas_info), program_sbas_info};

static const uint8_t program_sbas_correction[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_corrections_sbas_correction, index)),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_sbas_correction, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_sbas_correction, week_number)),
    MIP_8_BITS(3, MIP_AT(struct mip_gnss_corrections_sbas_correction, gnss_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_corrections_sbas_correction, pseudorange_correction)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_sbas_correction, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_sbas_correction_codec = {
    0x93,
    0x13,
    MIP_DATA,
    25,
    sizeof(struct mip_gnss_corrections_sbas_correction),
    program_sbas_correction};

static const uint8_t program_rf_error_detection[] = {
    MIP_8_BITS(7, MIP_AT(struct mip_gnss_corrections_rf_error_detection, rf_band)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_rf_error_detection, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_rf_error_detection_codec = {
    0x93,
    0x14,
    MIP_DATA,
    9,
    sizeof(struct mip_gnss_corrections_rf_error_detection),
    program_rf_error_detection};

static const uint8_t program_satellite_status[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_corrections_satellite_status, index)),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_satellite_status, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_satellite_status, week_number)),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_corrections_satellite_status, gnss_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_corrections_satellite_status, elevation)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_corrections_satellite_status, health)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_satellite_status, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_satellite_status_codec = {
    0x93,
    0x20,
    MIP_DATA,
    25,
    sizeof(struct mip_gnss_corrections_satellite_status),
    program_satellite_status};

static const uint8_t program_raw[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_corrections_raw, index)),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_raw, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_corrections_raw, week_number)),
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_corrections_raw, tracking_channel)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_corrections_raw, signal_strength)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_corrections_raw, quality)),
    MIP_DOUBLES(2, MIP_AT(struct mip_gnss_corrections_raw, pseudorange)),
    MIP_32_BITS(5, MIP_AT(struct mip_gnss_corrections_raw, doppler)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_raw, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_raw_codec = {
    0x93, 0x22, MIP_DATA, 61, sizeof(struct mip_gnss_corrections_raw), program_raw};

static const uint8_t program_base_station_info[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_base_station_info, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_base_station_info, week_number)),
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_corrections_base_station_info, ecef_position)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_corrections_base_station_info, height)),
    MIP_16_BITS(3, MIP_AT(struct mip_gnss_corrections_base_station_info, station_id)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_base_station_info_codec = {
    0x93,
    0x30,
    MIP_DATA,
    44,
    sizeof(struct mip_gnss_corrections_base_station_info),
    program_base_station_info};

static const uint8_t program_rtk_corrections_status[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_rtk_corrections_status, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_corrections_rtk_corrections_status, week_number)),
    MIP_32_BITS(9, MIP_AT(struct mip_gnss_corrections_rtk_corrections_status, dongle_status)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_rtk_corrections_status, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_rtk_corrections_status_codec = {
    0x93,
    0x31,
    MIP_DATA,
    50,
    sizeof(struct mip_gnss_corrections_rtk_corrections_status),
    program_rtk_corrections_status};

static const uint8_t program_gps_ephemeris[] = {
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_corrections_gps_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_corrections_gps_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_gps_ephemeris, week_number)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_gnss_corrections_gps_ephemeris, satellite_id)),
    MIP_DOUBLES(25, MIP_FAR_AT(struct mip_gnss_corrections_gps_ephemeris, t_oc)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_gps_ephemeris, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_gps_ephemeris_codec = {
    0x93,
    0x61,
    MIP_DATA,
    0,
    sizeof(struct mip_gnss_corrections_gps_ephemeris),
    program_gps_ephemeris};

static const uint8_t program_glonass_ephemeris[] = {
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, week_number)),
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, satellite_id)),
    MIP_32_BITS(2, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, tk)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, satellite_type)),
    MIP_DOUBLES(5, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, gamma)),
    MIP_32_BITS(6, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, velocity)),
    MIP_8_BITS(3, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, health)),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, delta_tau_n)),
    MIP_8_BITS(6, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, ft)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_glonass_ephemeris, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_glonass_ephemeris_codec = {
    0x93,
    0x62,
    MIP_DATA,
    0,
    sizeof(struct mip_gnss_corrections_glonass_ephemeris),
    program_glonass_ephemeris};

static const uint8_t program_galileo_ephemeris[] = {
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_corrections_galileo_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_corrections_galileo_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_galileo_ephemeris, week_number)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_gnss_corrections_galileo_ephemeris, satellite_id)),
    MIP_DOUBLES(25, MIP_FAR_AT(struct mip_gnss_corrections_galileo_ephemeris, t_oc)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_galileo_ephemeris, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_galileo_ephemeris_codec = {
    0x93,
    0x63,
    MIP_DATA,
    0,
    sizeof(struct mip_gnss_corrections_galileo_ephemeris),
    program_galileo_ephemeris};

static const uint8_t program_beidou_ephemeris[] = {
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_corrections_beidou_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_corrections_beidou_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_beidou_ephemeris, week_number)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_gnss_corrections_beidou_ephemeris, satellite_id)),
    MIP_DOUBLES(25, MIP_FAR_AT(struct mip_gnss_corrections_beidou_ephemeris, t_oc)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_beidou_ephemeris, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_beidou_ephemeris_codec = {
    0x93,
    0x64,
    MIP_DATA,
    0,
    sizeof(struct mip_gnss_corrections_beidou_ephemeris),
    program_beidou_ephemeris};

static const uint8_t program_gps_iono_correction[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_gps_iono_correction, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_gps_iono_correction, week_number)),
    MIP_DOUBLES(8, MIP_AT(struct mip_gnss_corrections_gps_iono_correction, alpha)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_gps_iono_correction, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_gps_iono_correction_codec = {
    0x93,
    0x71,
    MIP_DATA,
    76,
    sizeof(struct mip_gnss_corrections_gps_iono_correction),
    program_gps_iono_correction};

static const uint8_t program_galileo_iono_correction[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_corrections_galileo_iono_correction, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_galileo_iono_correction, week_number)),
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_corrections_galileo_iono_correction, alpha)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_corrections_galileo_iono_correction, disturbance_flags)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_corrections_galileo_iono_correction, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_galileo_iono_correction_codec = {
    0x93,
    0x73,
    MIP_DATA,
    37,
    sizeof(struct mip_gnss_corrections_galileo_iono_correction),
    program_galileo_iono_correction};

static const uint8_t program_beidou_iono_correction[] = {
    MIP_FAR,
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_corrections_beidou_iono_correction, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_beidou_iono_correction, week_number)),
    MIP_DOUBLES(17, MIP_FAR_AT(struct mip_gnss_corrections_beidou_iono_correction, alpha)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_corrections_beidou_iono_correction, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_gnss_corrections_beidou_iono_correction_codec = {
    0x93,
    0x74,
    MIP_DATA,
    0,
    sizeof(struct mip_gnss_corrections_beidou_iono_correction),
    program_beidou_iono_correction};
