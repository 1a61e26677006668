/* GNSS data. */
#include "mip/gnss_data.h"
#include "mip/core/program.h"

static const uint8_t program_llh_position[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(4, MIP_AT(struct mip_gnss_data_llh_position, latitude)),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_data_llh_position, horizontal_accuracy)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_llh_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_llh_position, 0x81, 0x03, MIP_DATA, 42, 5, MIP_SHAPE(4, 2, 1),
          program_llh_position + 5, NULL);

static const uint8_t program_ecef_position[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_data_ecef_position, position)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_data_ecef_position, position_accuracy)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_ecef_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_ecef_position, 0x81, 0x04, MIP_DATA, 30, 5, MIP_SHAPE(3, 1, 1),
          program_ecef_position + 5, NULL);

static const uint8_t program_ned_velocity[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_32_BITS(8, MIP_AT(struct mip_gnss_data_ned_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_ned_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_ned_velocity, 0x81, 0x05, MIP_DATA, 34, 5, MIP_SHAPE(0, 8, 1),
          program_ned_velocity + 5, NULL);

static const uint8_t program_ecef_velocity[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_32_BITS(4, MIP_AT(struct mip_gnss_data_ecef_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_ecef_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_ecef_velocity, 0x81, 0x06, MIP_DATA, 18, 5, MIP_SHAPE(0, 4, 1),
          program_ecef_velocity + 5, NULL);

static const uint8_t program_dop[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_32_BITS(7, MIP_AT(struct mip_gnss_data_dop, gdop)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_dop, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_dop, 0x81, 0x07, MIP_DATA, 30, 5, MIP_SHAPE(0, 7, 1), program_dop + 5,
          NULL);

static const uint8_t program_utc_time[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_utc_time, year)),
    MIP_8_BITS(5, MIP_AT(struct mip_gnss_data_utc_time, month)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_data_utc_time, msec)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_utc_time, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_utc_time, 0x81, 0x08, MIP_DATA, 13, 5, 0, program_utc_time + 5, NULL);

static const uint8_t program_gps_time[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_gps_time, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_data_gps_time, week_number)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_gps_time, 0x81, 0x09, MIP_DATA, 12, 5, MIP_SHAPE(1, 0, 2),
          program_gps_time + 5, NULL);

static const uint8_t program_clock_info[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_data_clock_info, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_clock_info, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_clock_info, 0x81, 0x0A, MIP_DATA, 26, 5, MIP_SHAPE(3, 0, 1),
          program_clock_info + 5, NULL);

static const uint8_t program_fix_info[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_fix_info, fix_type)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_data_fix_info, fix_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_fix_info, 0x81, 0x0B, MIP_DATA, 6, 5, 0, program_fix_info + 5, NULL);

static const uint8_t program_sv_info[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_sv_info, channel)),
    MIP_16_BITS(5, MIP_AT(struct mip_gnss_data_sv_info, carrier_noise_ratio)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_sv_info, 0x81, 0x0C, MIP_DATA, 12, 5, 0, program_sv_info + 5, NULL);

static const uint8_t program_hardware_status[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(3, MIP_AT(struct mip_gnss_data_hardware_status, receiver_state)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_hardware_status, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_hardware_status, 0x81, 0x0D, MIP_DATA, 5, 5, 0, program_hardware_status + 5,
          NULL);

static const uint8_t program_dgps_info[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_SIZES(0, 14),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_data_dgps_info, age)),
    MIP_16_BITS(4, MIP_AT(struct mip_gnss_data_dgps_info, base_station_id)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_dgps_info, 0x81, 0x0E, MIP_DATA, 0, 5, 0, program_dgps_info + 5,
          &mip_layout);

static const uint8_t program_dgps_info_satellite[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_SIZES(15, 253),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_dgps_info_satellite, satellite_id)),
    MIP_32_BITS(3, MIP_AT(struct mip_gnss_data_dgps_info_satellite, age)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_dgps_info_satellite, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_dgps_info_satellite, 0x81, 0x0E, MIP_DATA, 0, 5, 0,
          program_dgps_info_satellite + 5, &mip_layout);

static const uint8_t program_dgps_channel[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_dgps_channel, satellite_id)),
    MIP_32_BITS(3, MIP_AT(struct mip_gnss_data_dgps_channel, age)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_dgps_channel, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_dgps_channel, 0x81, 0x0F, MIP_DATA, 15, 5, 0, program_dgps_channel + 5,
          NULL);

static const uint8_t program_clock_info_2[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(4, MIP_AT(struct mip_gnss_data_clock_info_2, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_clock_info_2, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_clock_info_2, 0x81, 0x10, MIP_DATA, 34, 5, MIP_SHAPE(4, 0, 1),
          program_clock_info_2 + 5, NULL);

static const uint8_t program_gps_leap_seconds[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_gps_leap_seconds, leap_seconds)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_gps_leap_seconds, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_gps_leap_seconds, 0x81, 0x11, MIP_DATA, 3, 5, 0,
          program_gps_leap_seconds + 5, NULL);

static const uint8_t program_sbas_info[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_sbas_info, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_sbas_info, week_number)),
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_data_sbas_info, sbas_system)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_sbas_info, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_sbas_info, 0x81, 0x12, MIP_DATA, 16, 5, 0, program_sbas_info + 5, NULL);

static const uint8_t program_sbas_correction[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_sbas_correction, index)),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_sbas_correction, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_sbas_correction, week_number)),
    MIP_8_BITS(3, MIP_AT(struct mip_gnss_data_sbas_correction, gnss_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_data_sbas_correction, pseudorange_correction)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_sbas_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_sbas_correction, 0x81, 0x13, MIP_DATA, 25, 5, 0,
          program_sbas_correction + 5, NULL);

static const uint8_t program_rf_error_detection[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(3, MIP_AT(struct mip_gnss_data_rf_error_detection, rf_band)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_rf_error_detection, frequency)),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_rf_error_detection, reserved)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_rf_error_detection, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_rf_error_detection, 0x81, 0x14, MIP_DATA, 9, 5, 0,
          program_rf_error_detection + 5, NULL);

static const uint8_t program_heading[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_data_heading, heading)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_heading, fix_type)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_heading, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_heading, 0x81, 0x15, MIP_DATA, 11, 5, 0, program_heading + 5, NULL);

static const uint8_t program_satellite_status[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_satellite_status, index)),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_satellite_status, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_satellite_status, week_number)),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_satellite_status, gnss_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_gnss_data_satellite_status, elevation)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_satellite_status, health)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_satellite_status, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_satellite_status, 0x81, 0x20, MIP_DATA, 25, 5, 0,
          program_satellite_status + 5, NULL);

static const uint8_t program_raw[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_8_BITS(2, MIP_AT(struct mip_gnss_data_raw, index)),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_raw, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_data_raw, week_number)),
    MIP_8_BITS(4, MIP_AT(struct mip_gnss_data_raw, tracking_channel)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_data_raw, signal_strength)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_raw, quality)),
    MIP_DOUBLES(2, MIP_AT(struct mip_gnss_data_raw, pseudorange)),
    MIP_32_BITS(5, MIP_AT(struct mip_gnss_data_raw, doppler)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_raw, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_raw, 0x81, 0x22, MIP_DATA, 61, 5, 0, program_raw + 5, NULL);

static const uint8_t program_base_station_info[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_base_station_info, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_base_station_info, week_number)),
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_data_base_station_info, ecef_position)),
    MIP_32_BITS(1, MIP_AT(struct mip_gnss_data_base_station_info, height)),
    MIP_16_BITS(3, MIP_AT(struct mip_gnss_data_base_station_info, station_id)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_base_station_info, 0x81, 0x30, MIP_DATA, 44, 5, 0,
          program_base_station_info + 5, NULL);

static const uint8_t program_rtk_corrections_status[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_rtk_corrections_status, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_gnss_data_rtk_corrections_status, week_number)),
    MIP_32_BITS(9, MIP_AT(struct mip_gnss_data_rtk_corrections_status, dongle_status)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_rtk_corrections_status, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_rtk_corrections_status, 0x81, 0x31, MIP_DATA, 50, 5, 0,
          program_rtk_corrections_status + 5, NULL);

static const uint8_t program_gps_ephemeris[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_data_gps_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_data_gps_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_gps_ephemeris, week_number)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_gnss_data_gps_ephemeris, satellite_id)),
    MIP_DOUBLES(25, MIP_FAR_AT(struct mip_gnss_data_gps_ephemeris, t_oc)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_gps_ephemeris, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_gps_ephemeris, 0x81, 0x61, MIP_DATA, 0, 5, 0, program_gps_ephemeris + 5,
          &mip_program);

static const uint8_t program_glonass_ephemeris[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, week_number)),
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, satellite_id)),
    MIP_32_BITS(2, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, tk)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, satellite_type)),
    MIP_DOUBLES(5, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, gamma)),
    MIP_32_BITS(6, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, velocity)),
    MIP_8_BITS(3, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, health)),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, delta_tau_n)),
    MIP_8_BITS(6, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, ft)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_glonass_ephemeris, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_glonass_ephemeris, 0x81, 0x62, MIP_DATA, 0, 5, 0,
          program_glonass_ephemeris + 5, &mip_program);

static const uint8_t program_galileo_ephemeris[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_data_galileo_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_data_galileo_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_galileo_ephemeris, week_number)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_gnss_data_galileo_ephemeris, satellite_id)),
    MIP_DOUBLES(25, MIP_FAR_AT(struct mip_gnss_data_galileo_ephemeris, t_oc)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_galileo_ephemeris, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_galileo_ephemeris, 0x81, 0x63, MIP_DATA, 0, 5, 0,
          program_galileo_ephemeris + 5, &mip_program);

static const uint8_t program_beidou_ephemeris[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_gnss_data_beidou_ephemeris, index)),
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_data_beidou_ephemeris, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_beidou_ephemeris, week_number)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_gnss_data_beidou_ephemeris, satellite_id)),
    MIP_DOUBLES(25, MIP_FAR_AT(struct mip_gnss_data_beidou_ephemeris, t_oc)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_beidou_ephemeris, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_beidou_ephemeris, 0x81, 0x64, MIP_DATA, 0, 5, 0,
          program_beidou_ephemeris + 5, &mip_program);

static const uint8_t program_gps_iono_correction[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_gps_iono_correction, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_gps_iono_correction, week_number)),
    MIP_DOUBLES(8, MIP_AT(struct mip_gnss_data_gps_iono_correction, alpha)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_gps_iono_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_gps_iono_correction, 0x81, 0x71, MIP_DATA, 76, 5, 0,
          program_gps_iono_correction + 5, NULL);

static const uint8_t program_galileo_iono_correction[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_DOUBLES(1, MIP_AT(struct mip_gnss_data_galileo_iono_correction, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_galileo_iono_correction, week_number)),
    MIP_DOUBLES(3, MIP_AT(struct mip_gnss_data_galileo_iono_correction, alpha)),
    MIP_8_BITS(1, MIP_AT(struct mip_gnss_data_galileo_iono_correction, disturbance_flags)),
    MIP_16_BITS(1, MIP_AT(struct mip_gnss_data_galileo_iono_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_galileo_iono_correction, 0x81, 0x73, MIP_DATA, 37, 5, 0,
          program_galileo_iono_correction + 5, NULL);

static const uint8_t program_beidou_iono_correction[] = {
    MIP_MORE_SETS(0x91, 0x92, 0x93, 0x94, 0x95),
    MIP_FAR,
    MIP_DOUBLES(1, MIP_FAR_AT(struct mip_gnss_data_beidou_iono_correction, tow)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_beidou_iono_correction, week_number)),
    MIP_DOUBLES(17, MIP_FAR_AT(struct mip_gnss_data_beidou_iono_correction, alpha)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_gnss_data_beidou_iono_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_gnss_data_beidou_iono_correction, 0x81, 0x74, MIP_DATA, 0, 5, 0,
          program_beidou_iono_correction + 5, &mip_program);
