/**
 * @file
 * GNSS data, in C++17: see mip/gnss_data.h.
 */
#ifndef MIP_GNSS_DATA_HPP
#define MIP_GNSS_DATA_HPP

#include "mip/gnss_data_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_gnss_data_llh_position, MIP_GNSS_DATA_LLH_POSITION, 0, "gnss_data.llh_position",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_ecef_position, MIP_GNSS_DATA_ECEF_POSITION, 0, "gnss_data.ecef_position",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_ned_velocity, MIP_GNSS_DATA_NED_VELOCITY, 0, "gnss_data.ned_velocity",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_ecef_velocity, MIP_GNSS_DATA_ECEF_VELOCITY, 0, "gnss_data.ecef_velocity",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_dop, MIP_GNSS_DATA_DOP, 0, "gnss_data.dop", decode_inline)
MIP_LAYOUT(mip_gnss_data_utc_time, MIP_GNSS_DATA_UTC_TIME, 0, "gnss_data.utc_time", decode_inline)
MIP_LAYOUT(mip_gnss_data_gps_time, MIP_GNSS_DATA_GPS_TIME, 0, "gnss_data.gps_time", decode_inline)
MIP_LAYOUT(mip_gnss_data_clock_info, MIP_GNSS_DATA_CLOCK_INFO, 0, "gnss_data.clock_info",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_fix_info, MIP_GNSS_DATA_FIX_INFO, 0, "gnss_data.fix_info", decode_inline)
MIP_LAYOUT(mip_gnss_data_sv_info, MIP_GNSS_DATA_SV_INFO, 0, "gnss_data.sv_info", decode_inline)
MIP_LAYOUT(mip_gnss_data_hardware_status, MIP_GNSS_DATA_HARDWARE_STATUS, 0,
           "gnss_data.hardware_status", decode_inline)
MIP_LAYOUT(mip_gnss_data_dgps_info, MIP_GNSS_DATA_DGPS_INFO, 0, "gnss_data.dgps_info",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_dgps_info_satellite, MIP_GNSS_DATA_DGPS_INFO_SATELLITE, 0,
           "gnss_data.dgps_info_satellite", decode_inline)
MIP_LAYOUT(mip_gnss_data_dgps_channel, MIP_GNSS_DATA_DGPS_CHANNEL, 0, "gnss_data.dgps_channel",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_clock_info_2, MIP_GNSS_DATA_CLOCK_INFO_2, 0, "gnss_data.clock_info_2",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_gps_leap_seconds, MIP_GNSS_DATA_GPS_LEAP_SECONDS, 0,
           "gnss_data.gps_leap_seconds", decode_inline)
MIP_LAYOUT(mip_gnss_data_sbas_info, MIP_GNSS_DATA_SBAS_INFO, 0, "gnss_data.sbas_info",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_sbas_correction, MIP_GNSS_DATA_SBAS_CORRECTION, 0,
           "gnss_data.sbas_correction", decode_inline)
MIP_LAYOUT(mip_gnss_data_rf_error_detection, MIP_GNSS_DATA_RF_ERROR_DETECTION, 0,
           "gnss_data.rf_error_detection", decode_inline)
MIP_LAYOUT(mip_gnss_data_heading, MIP_GNSS_DATA_HEADING, 0, "gnss_data.heading", decode_inline)
MIP_LAYOUT(mip_gnss_data_satellite_status, MIP_GNSS_DATA_SATELLITE_STATUS, 0,
           "gnss_data.satellite_status", decode_inline)
MIP_LAYOUT(mip_gnss_data_raw, MIP_GNSS_DATA_RAW, 0, "gnss_data.raw", decode_inline)
MIP_LAYOUT(mip_gnss_data_base_station_info, MIP_GNSS_DATA_BASE_STATION_INFO, 0,
           "gnss_data.base_station_info", decode_inline)
MIP_LAYOUT(mip_gnss_data_rtk_corrections_status, MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS, 0,
           "gnss_data.rtk_corrections_status", decode_inline)
MIP_LAYOUT(mip_gnss_data_gps_ephemeris, MIP_GNSS_DATA_GPS_EPHEMERIS, 0, "gnss_data.gps_ephemeris",
           decode_inline)
MIP_LAYOUT(mip_gnss_data_glonass_ephemeris, MIP_GNSS_DATA_GLONASS_EPHEMERIS, 0,
           "gnss_data.glonass_ephemeris", decode_inline)
MIP_LAYOUT(mip_gnss_data_galileo_ephemeris, MIP_GNSS_DATA_GALILEO_EPHEMERIS, 0,
           "gnss_data.galileo_ephemeris", decode_inline)
MIP_LAYOUT(mip_gnss_data_beidou_ephemeris, MIP_GNSS_DATA_BEIDOU_EPHEMERIS, 0,
           "gnss_data.beidou_ephemeris", decode_inline)
MIP_LAYOUT(mip_gnss_data_gps_iono_correction, MIP_GNSS_DATA_GPS_IONO_CORRECTION, 0,
           "gnss_data.gps_iono_correction", decode_inline)
MIP_LAYOUT(mip_gnss_data_galileo_iono_correction, MIP_GNSS_DATA_GALILEO_IONO_CORRECTION, 0,
           "gnss_data.galileo_iono_correction", decode_inline)
MIP_LAYOUT(mip_gnss_data_beidou_iono_correction, MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION, 0,
           "gnss_data.beidou_iono_correction", decode_inline)

/** GNSS data */
inline constexpr std::uint8_t gnss_data_set = MIP_GNSS_DATA_SET;
/** GNSS receiver 1 data */
inline constexpr std::uint8_t gnss_1_set = MIP_GNSS_1_SET;
/** GNSS receiver 2 data */
inline constexpr std::uint8_t gnss_2_set = MIP_GNSS_2_SET;
/** GNSS corrections data */
inline constexpr std::uint8_t gnss_corrections_set = MIP_GNSS_CORRECTIONS_SET;
/** External GNSS data */
inline constexpr std::uint8_t gnss_external_set = MIP_GNSS_EXTERNAL_SET;
/** External GNSS data 2 */
inline constexpr std::uint8_t gnss_external_2_set = MIP_GNSS_EXTERNAL_2_SET;

namespace gnss_data {

/** @addtogroup mip_gnss_data
 * @{ */

using ::mip::operator|;
using ::mip::operator&;
using ::mip::operator^;
using ::mip::operator~;
using ::mip::operator|=;
using ::mip::operator&=;
using ::mip::operator^=;
#ifdef MIP_NAMES_H
using ::mip::operator<<;
#endif
using ::mip::get;
using ::mip::has;
using ::mip::to_string;

/** mip_gnss_data_llh_position_flags: gnss_data.llh_position_flags */
enum class llh_position_flags : uint16_t {
    lat_lon = MIP_GNSS_DATA_LLH_POSITION_FLAGS_LAT_LON,
    ellipsoid_height = MIP_GNSS_DATA_LLH_POSITION_FLAGS_ELLIPSOID_HEIGHT,
    msl_height = MIP_GNSS_DATA_LLH_POSITION_FLAGS_MSL_HEIGHT,
    horizontal_accuracy = MIP_GNSS_DATA_LLH_POSITION_FLAGS_HORIZONTAL_ACCURACY,
    vertical_accuracy = MIP_GNSS_DATA_LLH_POSITION_FLAGS_VERTICAL_ACCURACY,
    flags = MIP_GNSS_DATA_LLH_POSITION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, llh_position_flags, mip_names_gnss_data_llh_position_flags)

/** mip_gnss_data_ecef_position_flags: gnss_data.ecef_position_flags */
enum class ecef_position_flags : uint16_t {
    position = MIP_GNSS_DATA_ECEF_POSITION_FLAGS_POSITION,
    position_accuracy = MIP_GNSS_DATA_ECEF_POSITION_FLAGS_POSITION_ACCURACY,
    flags = MIP_GNSS_DATA_ECEF_POSITION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, ecef_position_flags, mip_names_gnss_data_ecef_position_flags)

/** mip_gnss_data_ned_velocity_flags: gnss_data.ned_velocity_flags */
enum class ned_velocity_flags : uint16_t {
    velocity = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_VELOCITY,
    speed_3d = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_SPEED_3D,
    ground_speed = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_GROUND_SPEED,
    heading = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_HEADING,
    speed_accuracy = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_SPEED_ACCURACY,
    heading_accuracy = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_HEADING_ACCURACY,
    flags = MIP_GNSS_DATA_NED_VELOCITY_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, ned_velocity_flags, mip_names_gnss_data_ned_velocity_flags)

/** mip_gnss_data_ecef_velocity_flags: gnss_data.ecef_velocity_flags */
enum class ecef_velocity_flags : uint16_t {
    velocity = MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_VELOCITY,
    velocity_accuracy = MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_VELOCITY_ACCURACY,
    flags = MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, ecef_velocity_flags, mip_names_gnss_data_ecef_velocity_flags)

/** mip_gnss_data_dop_flags: gnss_data.dop_flags */
enum class dop_flags : uint16_t {
    gdop = MIP_GNSS_DATA_DOP_FLAGS_GDOP,
    pdop = MIP_GNSS_DATA_DOP_FLAGS_PDOP,
    hdop = MIP_GNSS_DATA_DOP_FLAGS_HDOP,
    vdop = MIP_GNSS_DATA_DOP_FLAGS_VDOP,
    tdop = MIP_GNSS_DATA_DOP_FLAGS_TDOP,
    ndop = MIP_GNSS_DATA_DOP_FLAGS_NDOP,
    edop = MIP_GNSS_DATA_DOP_FLAGS_EDOP,
    flags = MIP_GNSS_DATA_DOP_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, dop_flags, mip_names_gnss_data_dop_flags)

/** mip_gnss_data_utc_time_flags: gnss_data.utc_time_flags */
enum class utc_time_flags : uint16_t {
    gnss_date_time = MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME,
    leap_seconds_known = MIP_GNSS_DATA_UTC_TIME_FLAGS_LEAP_SECONDS_KNOWN,
    flags = MIP_GNSS_DATA_UTC_TIME_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, utc_time_flags, mip_names_gnss_data_utc_time_flags)

/** mip_gnss_data_gps_time_flags: gnss_data.gps_time_flags */
enum class gps_time_flags : uint16_t {
    tow = MIP_GNSS_DATA_GPS_TIME_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_GPS_TIME_FLAGS_WEEK_NUMBER,
    flags = MIP_GNSS_DATA_GPS_TIME_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, gps_time_flags, mip_names_gnss_data_gps_time_flags)

/** mip_gnss_data_clock_info_flags: gnss_data.clock_info_flags */
enum class clock_info_flags : uint16_t {
    bias = MIP_GNSS_DATA_CLOCK_INFO_FLAGS_BIAS,
    drift = MIP_GNSS_DATA_CLOCK_INFO_FLAGS_DRIFT,
    accuracy_estimate = MIP_GNSS_DATA_CLOCK_INFO_FLAGS_ACCURACY_ESTIMATE,
    flags = MIP_GNSS_DATA_CLOCK_INFO_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, clock_info_flags, mip_names_gnss_data_clock_info_flags)

/** mip_gnss_data_fix_flags: gnss_data.fix_flags */
enum class fix_flags : uint16_t {
    sbas_used = MIP_GNSS_DATA_FIX_FLAGS_SBAS_USED,
    dgnss_used = MIP_GNSS_DATA_FIX_FLAGS_DGNSS_USED,
};
MIP_NAMES_OF(flag_names, fix_flags, mip_names_gnss_data_fix_flags)

/** mip_gnss_data_fix_info_flags: gnss_data.fix_info_flags */
enum class fix_info_flags : uint16_t {
    fix_type = MIP_GNSS_DATA_FIX_INFO_FLAGS_FIX_TYPE,
    num_sv = MIP_GNSS_DATA_FIX_INFO_FLAGS_NUM_SV,
    fix_flags = MIP_GNSS_DATA_FIX_INFO_FLAGS_FIX_FLAGS,
    flags = MIP_GNSS_DATA_FIX_INFO_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, fix_info_flags, mip_names_gnss_data_fix_info_flags)

/** mip_gnss_data_sv_flags: gnss_data.sv_flags */
enum class sv_flags : uint16_t {
    used_for_navigation = MIP_GNSS_DATA_SV_FLAGS_USED_FOR_NAVIGATION,
    healthy = MIP_GNSS_DATA_SV_FLAGS_HEALTHY,
};
MIP_NAMES_OF(flag_names, sv_flags, mip_names_gnss_data_sv_flags)

/** mip_gnss_data_sv_info_flags: gnss_data.sv_info_flags */
enum class sv_info_flags : uint16_t {
    channel = MIP_GNSS_DATA_SV_INFO_FLAGS_CHANNEL,
    satellite_id = MIP_GNSS_DATA_SV_INFO_FLAGS_SATELLITE_ID,
    carrier_noise_ratio = MIP_GNSS_DATA_SV_INFO_FLAGS_CARRIER_NOISE_RATIO,
    azimuth = MIP_GNSS_DATA_SV_INFO_FLAGS_AZIMUTH,
    elevation = MIP_GNSS_DATA_SV_INFO_FLAGS_ELEVATION,
    sv_flags = MIP_GNSS_DATA_SV_INFO_FLAGS_SV_FLAGS,
    flags = MIP_GNSS_DATA_SV_INFO_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, sv_info_flags, mip_names_gnss_data_sv_info_flags)

/** mip_gnss_data_receiver_state: gnss_data.receiver_state */
enum class receiver_state : uint8_t {
    off = MIP_GNSS_DATA_RECEIVER_STATE_OFF,
    on = MIP_GNSS_DATA_RECEIVER_STATE_ON,
    unknown = MIP_GNSS_DATA_RECEIVER_STATE_UNKNOWN,
};
MIP_NAMES_OF(value_names, receiver_state, mip_names_gnss_data_receiver_state)

/** mip_gnss_data_antenna_state: gnss_data.antenna_state */
enum class antenna_state : uint8_t {
    init = MIP_GNSS_DATA_ANTENNA_STATE_INIT,
    short_ = MIP_GNSS_DATA_ANTENNA_STATE_SHORT,
    open = MIP_GNSS_DATA_ANTENNA_STATE_OPEN,
    good = MIP_GNSS_DATA_ANTENNA_STATE_GOOD,
    unknown = MIP_GNSS_DATA_ANTENNA_STATE_UNKNOWN,
};
MIP_NAMES_OF(value_names, antenna_state, mip_names_gnss_data_antenna_state)

/** mip_gnss_data_antenna_power: gnss_data.antenna_power */
enum class antenna_power : uint8_t {
    off = MIP_GNSS_DATA_ANTENNA_POWER_OFF,
    on = MIP_GNSS_DATA_ANTENNA_POWER_ON,
    unknown = MIP_GNSS_DATA_ANTENNA_POWER_UNKNOWN,
};
MIP_NAMES_OF(value_names, antenna_power, mip_names_gnss_data_antenna_power)

/** mip_gnss_data_hardware_status_flags: gnss_data.hardware_status_flags */
enum class hardware_status_flags : uint16_t {
    sensor_state = MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_SENSOR_STATE,
    antenna_state = MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_ANTENNA_STATE,
    antenna_power = MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_ANTENNA_POWER,
    flags = MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, hardware_status_flags, mip_names_gnss_data_hardware_status_flags)

/** mip_gnss_data_dgps_info_flags: gnss_data.dgps_info_flags */
enum class dgps_info_flags : uint16_t {
    age = MIP_GNSS_DATA_DGPS_INFO_FLAGS_AGE,
    base_station_id = MIP_GNSS_DATA_DGPS_INFO_FLAGS_BASE_STATION_ID,
    base_station_status = MIP_GNSS_DATA_DGPS_INFO_FLAGS_BASE_STATION_STATUS,
    num_channels = MIP_GNSS_DATA_DGPS_INFO_FLAGS_NUM_CHANNELS,
    flags = MIP_GNSS_DATA_DGPS_INFO_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, dgps_info_flags, mip_names_gnss_data_dgps_info_flags)

/** mip_gnss_data_dgps_channel_flags: gnss_data.dgps_channel_flags */
enum class dgps_channel_flags : uint16_t {
    satellite_id = MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_SATELLITE_ID,
    age = MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_AGE,
    range_correction = MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_RANGE_CORRECTION,
    range_rate_correction = MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_RANGE_RATE_CORRECTION,
    flags = MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, dgps_channel_flags, mip_names_gnss_data_dgps_channel_flags)

/** mip_gnss_data_clock_info_2_flags: gnss_data.clock_info_2_flags */
enum class clock_info_2_flags : uint16_t {
    bias = MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_BIAS,
    drift = MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_DRIFT,
    bias_accuracy = MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_BIAS_ACCURACY,
    drift_accuracy = MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_DRIFT_ACCURACY,
    flags = MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, clock_info_2_flags, mip_names_gnss_data_clock_info_2_flags)

/** mip_gnss_data_gps_leap_seconds_flags: gnss_data.gps_leap_seconds_flags */
enum class gps_leap_seconds_flags : uint16_t {
    leap_seconds = MIP_GNSS_DATA_GPS_LEAP_SECONDS_FLAGS_LEAP_SECONDS,
};
MIP_NAMES_OF(flag_names, gps_leap_seconds_flags, mip_names_gnss_data_gps_leap_seconds_flags)

/** mip_gnss_data_sbas_system: gnss_data.sbas_system */
enum class sbas_system : uint8_t {
    unknown = MIP_GNSS_DATA_SBAS_SYSTEM_UNKNOWN,
    waas = MIP_GNSS_DATA_SBAS_SYSTEM_WAAS,
    egnos = MIP_GNSS_DATA_SBAS_SYSTEM_EGNOS,
    msas = MIP_GNSS_DATA_SBAS_SYSTEM_MSAS,
    gagan = MIP_GNSS_DATA_SBAS_SYSTEM_GAGAN,
};
MIP_NAMES_OF(value_names, sbas_system, mip_names_gnss_data_sbas_system)

/** mip_gnss_data_sbas_status: gnss_data.sbas_status */
enum class sbas_status : uint8_t {
    range_available = MIP_GNSS_DATA_SBAS_STATUS_RANGE_AVAILABLE,
    corrections_available = MIP_GNSS_DATA_SBAS_STATUS_CORRECTIONS_AVAILABLE,
    integrity_available = MIP_GNSS_DATA_SBAS_STATUS_INTEGRITY_AVAILABLE,
    test_mode = MIP_GNSS_DATA_SBAS_STATUS_TEST_MODE,
};
MIP_NAMES_OF(flag_names, sbas_status, mip_names_gnss_data_sbas_status)

/** mip_gnss_data_sbas_info_flags: gnss_data.sbas_info_flags */
enum class sbas_info_flags : uint16_t {
    tow = MIP_GNSS_DATA_SBAS_INFO_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_SBAS_INFO_FLAGS_WEEK_NUMBER,
    sbas_system = MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_SYSTEM,
    sbas_id = MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_ID,
    count = MIP_GNSS_DATA_SBAS_INFO_FLAGS_COUNT,
    sbas_status = MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_STATUS,
    flags = MIP_GNSS_DATA_SBAS_INFO_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, sbas_info_flags, mip_names_gnss_data_sbas_info_flags)

/** mip_gnss_data_sbas_correction_flags: gnss_data.sbas_correction_flags */
enum class sbas_correction_flags : uint16_t {
    udrei = MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_UDREI,
    pseudorange_correction = MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_PSEUDORANGE_CORRECTION,
    iono_correction = MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_IONO_CORRECTION,
    flags = MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, sbas_correction_flags, mip_names_gnss_data_sbas_correction_flags)

/** mip_gnss_data_rf_band: gnss_data.rf_band */
enum class rf_band : uint8_t {
    unknown = MIP_GNSS_DATA_RF_BAND_UNKNOWN,
    l1 = MIP_GNSS_DATA_RF_BAND_L1,
    l2 = MIP_GNSS_DATA_RF_BAND_L2,
    l5 = MIP_GNSS_DATA_RF_BAND_L5,
};
MIP_NAMES_OF(value_names, rf_band, mip_names_gnss_data_rf_band)

/** mip_gnss_data_jamming_state: gnss_data.jamming_state */
enum class jamming_state : uint8_t {
    unknown = MIP_GNSS_DATA_JAMMING_STATE_UNKNOWN,
    none = MIP_GNSS_DATA_JAMMING_STATE_NONE,
    partial = MIP_GNSS_DATA_JAMMING_STATE_PARTIAL,
    significant = MIP_GNSS_DATA_JAMMING_STATE_SIGNIFICANT,
};
MIP_NAMES_OF(value_names, jamming_state, mip_names_gnss_data_jamming_state)

/** mip_gnss_data_spoofing_state: gnss_data.spoofing_state */
enum class spoofing_state : uint8_t {
    unknown = MIP_GNSS_DATA_SPOOFING_STATE_UNKNOWN,
    none = MIP_GNSS_DATA_SPOOFING_STATE_NONE,
    partial = MIP_GNSS_DATA_SPOOFING_STATE_PARTIAL,
    significant = MIP_GNSS_DATA_SPOOFING_STATE_SIGNIFICANT,
};
MIP_NAMES_OF(value_names, spoofing_state, mip_names_gnss_data_spoofing_state)

/** mip_gnss_data_rf_error_detection_flags: gnss_data.rf_error_detection_flags */
enum class rf_error_detection_flags : uint16_t {
    rf_band = MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_RF_BAND,
    jamming_state = MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_JAMMING_STATE,
    spoofing_state = MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_SPOOFING_STATE,
    frequency = MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_FREQUENCY,
    flags = MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, rf_error_detection_flags, mip_names_gnss_data_rf_error_detection_flags)

/** mip_gnss_data_heading_fix_type: gnss_data.heading_fix_type */
enum class heading_fix_type : uint8_t {
    unknown = MIP_GNSS_DATA_HEADING_FIX_TYPE_UNKNOWN,
    float_ = MIP_GNSS_DATA_HEADING_FIX_TYPE_FLOAT,
    fixed = MIP_GNSS_DATA_HEADING_FIX_TYPE_FIXED,
};
MIP_NAMES_OF(value_names, heading_fix_type, mip_names_gnss_data_heading_fix_type)

/** mip_gnss_data_heading_flags: gnss_data.heading_flags */
enum class heading_flags : uint16_t {
    heading = MIP_GNSS_DATA_HEADING_FLAGS_HEADING,
    uncertainty = MIP_GNSS_DATA_HEADING_FLAGS_UNCERTAINTY,
    fix_type = MIP_GNSS_DATA_HEADING_FLAGS_FIX_TYPE,
    flags = MIP_GNSS_DATA_HEADING_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, heading_flags, mip_names_gnss_data_heading_flags)

/** mip_gnss_data_satellite_status_flags: gnss_data.satellite_status_flags */
enum class satellite_status_flags : uint16_t {
    tow = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_WEEK_NUMBER,
    gnss_id = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_GNSS_ID,
    satellite_id = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_SATELLITE_ID,
    elevation = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_ELEVATION,
    azimuth = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_AZIMUTH,
    health = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_HEALTH,
    flags = MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, satellite_status_flags, mip_names_gnss_data_satellite_status_flags)

/** mip_gnss_data_signal_quality: gnss_data.signal_quality */
enum class signal_quality : uint8_t {
    none = MIP_GNSS_DATA_SIGNAL_QUALITY_NONE,
    searching = MIP_GNSS_DATA_SIGNAL_QUALITY_SEARCHING,
    acquired = MIP_GNSS_DATA_SIGNAL_QUALITY_ACQUIRED,
    unusable = MIP_GNSS_DATA_SIGNAL_QUALITY_UNUSABLE,
    time_locked = MIP_GNSS_DATA_SIGNAL_QUALITY_TIME_LOCKED,
    fully_locked = MIP_GNSS_DATA_SIGNAL_QUALITY_FULLY_LOCKED,
};
MIP_NAMES_OF(value_names, signal_quality, mip_names_gnss_data_signal_quality)

/** mip_gnss_data_raw_flags: gnss_data.raw_flags */
enum class raw_flags : uint16_t {
    tow = MIP_GNSS_DATA_RAW_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_RAW_FLAGS_WEEK_NUMBER,
    receiver_id = MIP_GNSS_DATA_RAW_FLAGS_RECEIVER_ID,
    tracking_channel = MIP_GNSS_DATA_RAW_FLAGS_TRACKING_CHANNEL,
    gnss_id = MIP_GNSS_DATA_RAW_FLAGS_GNSS_ID,
    satellite_id = MIP_GNSS_DATA_RAW_FLAGS_SATELLITE_ID,
    signal_id = MIP_GNSS_DATA_RAW_FLAGS_SIGNAL_ID,
    signal_strength = MIP_GNSS_DATA_RAW_FLAGS_SIGNAL_STRENGTH,
    quality = MIP_GNSS_DATA_RAW_FLAGS_QUALITY,
    pseudorange = MIP_GNSS_DATA_RAW_FLAGS_PSEUDORANGE,
    carrier_phase = MIP_GNSS_DATA_RAW_FLAGS_CARRIER_PHASE,
    doppler = MIP_GNSS_DATA_RAW_FLAGS_DOPPLER,
    range_uncertainty = MIP_GNSS_DATA_RAW_FLAGS_RANGE_UNCERTAINTY,
    carrier_phase_uncertainty = MIP_GNSS_DATA_RAW_FLAGS_CARRIER_PHASE_UNCERTAINTY,
    doppler_uncertainty = MIP_GNSS_DATA_RAW_FLAGS_DOPPLER_UNCERTAINTY,
    lock_time = MIP_GNSS_DATA_RAW_FLAGS_LOCK_TIME,
    flags = MIP_GNSS_DATA_RAW_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, raw_flags, mip_names_gnss_data_raw_flags)

/** mip_gnss_data_base_station_indicators: gnss_data.base_station_indicators */
enum class base_station_indicators : uint16_t {
    gps = MIP_GNSS_DATA_BASE_STATION_INDICATORS_GPS,
    glonass = MIP_GNSS_DATA_BASE_STATION_INDICATORS_GLONASS,
    galileo = MIP_GNSS_DATA_BASE_STATION_INDICATORS_GALILEO,
    beidou = MIP_GNSS_DATA_BASE_STATION_INDICATORS_BEIDOU,
    reference_station = MIP_GNSS_DATA_BASE_STATION_INDICATORS_REFERENCE_STATION,
    single_receiver = MIP_GNSS_DATA_BASE_STATION_INDICATORS_SINGLE_RECEIVER,
    quarter_cycle_bit1 = MIP_GNSS_DATA_BASE_STATION_INDICATORS_QUARTER_CYCLE_BIT1,
    quarter_cycle_bit2 = MIP_GNSS_DATA_BASE_STATION_INDICATORS_QUARTER_CYCLE_BIT2,
    quarter_cycle_bits = MIP_GNSS_DATA_BASE_STATION_INDICATORS_QUARTER_CYCLE_BITS,
};
MIP_NAMES_OF(flag_names, base_station_indicators, mip_names_gnss_data_base_station_indicators)

/** mip_gnss_data_base_station_info_flags: gnss_data.base_station_info_flags */
enum class base_station_info_flags : uint16_t {
    tow = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_WEEK_NUMBER,
    ecef_position = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_ECEF_POSITION,
    height = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_HEIGHT,
    station_id = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_STATION_ID,
    indicators = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_INDICATORS,
    flags = MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, base_station_info_flags, mip_names_gnss_data_base_station_info_flags)

/** mip_gnss_data_rtk_epoch_status: gnss_data.rtk_epoch_status */
enum class rtk_epoch_status : uint16_t {
    antenna_location_received = MIP_GNSS_DATA_RTK_EPOCH_STATUS_ANTENNA_LOCATION_RECEIVED,
    antenna_description_received = MIP_GNSS_DATA_RTK_EPOCH_STATUS_ANTENNA_DESCRIPTION_RECEIVED,
    gps_received = MIP_GNSS_DATA_RTK_EPOCH_STATUS_GPS_RECEIVED,
    glonass_received = MIP_GNSS_DATA_RTK_EPOCH_STATUS_GLONASS_RECEIVED,
    galileo_received = MIP_GNSS_DATA_RTK_EPOCH_STATUS_GALILEO_RECEIVED,
    beidou_received = MIP_GNSS_DATA_RTK_EPOCH_STATUS_BEIDOU_RECEIVED,
    using_gps_msm_messages = MIP_GNSS_DATA_RTK_EPOCH_STATUS_USING_GPS_MSM_MESSAGES,
    using_glonass_msm_messages = MIP_GNSS_DATA_RTK_EPOCH_STATUS_USING_GLONASS_MSM_MESSAGES,
    dongle_status_read_failed = MIP_GNSS_DATA_RTK_EPOCH_STATUS_DONGLE_STATUS_READ_FAILED,
};
MIP_NAMES_OF(flag_names, rtk_epoch_status, mip_names_gnss_data_rtk_epoch_status)

/** mip_gnss_data_rtk_corrections_status_flags: gnss_data.rtk_corrections_status_flags */
enum class rtk_corrections_status_flags : uint16_t {
    tow = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_WEEK_NUMBER,
    epoch_status = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_EPOCH_STATUS,
    dongle_status = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_DONGLE_STATUS,
    gps_latency = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GPS_LATENCY,
    glonass_latency = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GLONASS_LATENCY,
    galileo_latency = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GALILEO_LATENCY,
    beidou_latency = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_BEIDOU_LATENCY,
    flags = MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, rtk_corrections_status_flags,
             mip_names_gnss_data_rtk_corrections_status_flags)

/** mip_gnss_data_ephemeris_flags: gnss_data.ephemeris_flags */
enum class ephemeris_flags : uint16_t {
    ephemeris = MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS,
    modern_data = MIP_GNSS_DATA_EPHEMERIS_FLAGS_MODERN_DATA,
    isc_l5 = MIP_GNSS_DATA_EPHEMERIS_FLAGS_ISC_L5,
    flags = MIP_GNSS_DATA_EPHEMERIS_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, ephemeris_flags, mip_names_gnss_data_ephemeris_flags)

/** mip_gnss_data_glonass_satellite_type: gnss_data.glonass_satellite_type */
enum class glonass_satellite_type : uint8_t {
    glonass = MIP_GNSS_DATA_GLONASS_SATELLITE_TYPE_GLONASS,
    glonass_m = MIP_GNSS_DATA_GLONASS_SATELLITE_TYPE_GLONASS_M,
};
MIP_NAMES_OF(value_names, glonass_satellite_type, mip_names_gnss_data_glonass_satellite_type)

/** mip_gnss_data_glonass_ephemeris_flags: gnss_data.glonass_ephemeris_flags */
enum class glonass_ephemeris_flags : uint16_t {
    ephemeris = MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS,
    flags = MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, glonass_ephemeris_flags, mip_names_gnss_data_glonass_ephemeris_flags)

/** mip_gnss_data_gps_iono_correction_flags: gnss_data.gps_iono_correction_flags */
enum class gps_iono_correction_flags : uint16_t {
    tow = MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_WEEK_NUMBER,
    alpha = MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_ALPHA,
    beta = MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_BETA,
    flags = MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, gps_iono_correction_flags, mip_names_gnss_data_gps_iono_correction_flags)

/** mip_gnss_data_galileo_iono_correction_flags: gnss_data.galileo_iono_correction_flags */
enum class galileo_iono_correction_flags : uint16_t {
    tow = MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_WEEK_NUMBER,
    alpha = MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_ALPHA,
    disturbance_flags = MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_DISTURBANCE_FLAGS,
    flags = MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, galileo_iono_correction_flags,
             mip_names_gnss_data_galileo_iono_correction_flags)

/** mip_gnss_data_beidou_iono_correction_flags: gnss_data.beidou_iono_correction_flags */
enum class beidou_iono_correction_flags : uint16_t {
    tow = MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_TOW,
    week_number = MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_WEEK_NUMBER,
    alpha = MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_ALPHA,
    beta = MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_BETA,
    alpha_correction = MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_ALPHA_CORRECTION,
    flags = MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_FLAGS,
};
MIP_NAMES_OF(flag_names, beidou_iono_correction_flags,
             mip_names_gnss_data_beidou_iono_correction_flags)

struct llh_position_ : ::mip_gnss_data_llh_position {
    using c_type = ::mip_gnss_data_llh_position;
    ::mip::gnss_data::llh_position_flags valid_flags() const {
        return static_cast<::mip::gnss_data::llh_position_flags>(c_type::valid_flags);
    }
};

/** GNSS LLH position. See struct mip_gnss_data_llh_position. */
using llh_position = llh_position_;

struct ecef_position_ : ::mip_gnss_data_ecef_position {
    using c_type = ::mip_gnss_data_ecef_position;
    ::mip::gnss_data::ecef_position_flags valid_flags() const {
        return static_cast<::mip::gnss_data::ecef_position_flags>(c_type::valid_flags);
    }
};

/** GNSS ECEF position. See struct mip_gnss_data_ecef_position. */
using ecef_position = ecef_position_;

struct ned_velocity_ : ::mip_gnss_data_ned_velocity {
    using c_type = ::mip_gnss_data_ned_velocity;
    ::mip::gnss_data::ned_velocity_flags valid_flags() const {
        return static_cast<::mip::gnss_data::ned_velocity_flags>(c_type::valid_flags);
    }
};

/** NED velocity. See struct mip_gnss_data_ned_velocity. */
using ned_velocity = ned_velocity_;

struct ecef_velocity_ : ::mip_gnss_data_ecef_velocity {
    using c_type = ::mip_gnss_data_ecef_velocity;
    ::mip::gnss_data::ecef_velocity_flags valid_flags() const {
        return static_cast<::mip::gnss_data::ecef_velocity_flags>(c_type::valid_flags);
    }
};

/** GNSS ECEF velocity. See struct mip_gnss_data_ecef_velocity. */
using ecef_velocity = ecef_velocity_;

struct dop_ : ::mip_gnss_data_dop {
    using c_type = ::mip_gnss_data_dop;
    ::mip::gnss_data::dop_flags valid_flags() const {
        return static_cast<::mip::gnss_data::dop_flags>(c_type::valid_flags);
    }
};

/** DOP. See struct mip_gnss_data_dop. */
using dop = dop_;

struct utc_time_ : ::mip_gnss_data_utc_time {
    using c_type = ::mip_gnss_data_utc_time;
    ::mip::gnss_data::utc_time_flags valid_flags() const {
        return static_cast<::mip::gnss_data::utc_time_flags>(c_type::valid_flags);
    }
};

/** UTC time. See struct mip_gnss_data_utc_time. */
using utc_time = utc_time_;

struct gps_time_ : ::mip_gnss_data_gps_time {
    using c_type = ::mip_gnss_data_gps_time;
    ::mip::gnss_data::gps_time_flags valid_flags() const {
        return static_cast<::mip::gnss_data::gps_time_flags>(c_type::valid_flags);
    }
};

/** GPS time. See struct mip_gnss_data_gps_time. */
using gps_time = gps_time_;

struct clock_info_ : ::mip_gnss_data_clock_info {
    using c_type = ::mip_gnss_data_clock_info;
    ::mip::gnss_data::clock_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::clock_info_flags>(c_type::valid_flags);
    }
};

/** Clock info. See struct mip_gnss_data_clock_info. */
using clock_info = clock_info_;

struct fix_info_ : ::mip_gnss_data_fix_info {
    using c_type = ::mip_gnss_data_fix_info;
    ::mip::gnss_fix_type fix_type() const {
        return static_cast<::mip::gnss_fix_type>(c_type::fix_type);
    }
    ::mip::gnss_data::fix_flags fix_flags() const {
        return static_cast<::mip::gnss_data::fix_flags>(c_type::fix_flags);
    }
    ::mip::gnss_data::fix_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::fix_info_flags>(c_type::valid_flags);
    }
};

/** Fix info. See struct mip_gnss_data_fix_info. */
using fix_info = fix_info_;

struct sv_info_ : ::mip_gnss_data_sv_info {
    using c_type = ::mip_gnss_data_sv_info;
    ::mip::gnss_data::sv_flags sv_flags() const {
        return static_cast<::mip::gnss_data::sv_flags>(c_type::sv_flags);
    }
    ::mip::gnss_data::sv_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::sv_info_flags>(c_type::valid_flags);
    }
};

/** Satellite info. See struct mip_gnss_data_sv_info. */
using sv_info = sv_info_;

struct hardware_status_ : ::mip_gnss_data_hardware_status {
    using c_type = ::mip_gnss_data_hardware_status;
    ::mip::gnss_data::receiver_state receiver_state() const {
        return static_cast<::mip::gnss_data::receiver_state>(c_type::receiver_state);
    }
    ::mip::gnss_data::antenna_state antenna_state() const {
        return static_cast<::mip::gnss_data::antenna_state>(c_type::antenna_state);
    }
    ::mip::gnss_data::antenna_power antenna_power() const {
        return static_cast<::mip::gnss_data::antenna_power>(c_type::antenna_power);
    }
    ::mip::gnss_data::hardware_status_flags valid_flags() const {
        return static_cast<::mip::gnss_data::hardware_status_flags>(c_type::valid_flags);
    }
};

/** GNSS hardware status. See struct mip_gnss_data_hardware_status. */
using hardware_status = hardware_status_;

struct dgps_info_ : ::mip_gnss_data_dgps_info {
    using c_type = ::mip_gnss_data_dgps_info;
    ::mip::gnss_data::dgps_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::dgps_info_flags>(c_type::valid_flags);
    }
};

/** DGPS info. See struct mip_gnss_data_dgps_info. */
using dgps_info = dgps_info_;

struct dgps_info_satellite_ : ::mip_gnss_data_dgps_info_satellite {
    using c_type = ::mip_gnss_data_dgps_info_satellite;
    ::mip::gnss_data::dgps_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::dgps_info_flags>(c_type::valid_flags);
    }
};

/** DGPS info for one satellite. See struct mip_gnss_data_dgps_info_satellite. */
using dgps_info_satellite = dgps_info_satellite_;

struct dgps_channel_ : ::mip_gnss_data_dgps_channel {
    using c_type = ::mip_gnss_data_dgps_channel;
    ::mip::gnss_data::dgps_channel_flags valid_flags() const {
        return static_cast<::mip::gnss_data::dgps_channel_flags>(c_type::valid_flags);
    }
};

/** DGPS channel. See struct mip_gnss_data_dgps_channel. */
using dgps_channel = dgps_channel_;

struct clock_info_2_ : ::mip_gnss_data_clock_info_2 {
    using c_type = ::mip_gnss_data_clock_info_2;
    ::mip::gnss_data::clock_info_2_flags valid_flags() const {
        return static_cast<::mip::gnss_data::clock_info_2_flags>(c_type::valid_flags);
    }
};

/** Clock info 2. See struct mip_gnss_data_clock_info_2. */
using clock_info_2 = clock_info_2_;

struct gps_leap_seconds_ : ::mip_gnss_data_gps_leap_seconds {
    using c_type = ::mip_gnss_data_gps_leap_seconds;
    ::mip::gnss_data::gps_leap_seconds_flags valid_flags() const {
        return static_cast<::mip::gnss_data::gps_leap_seconds_flags>(c_type::valid_flags);
    }
};

/** GPS leap seconds. See struct mip_gnss_data_gps_leap_seconds. */
using gps_leap_seconds = gps_leap_seconds_;

struct sbas_info_ : ::mip_gnss_data_sbas_info {
    using c_type = ::mip_gnss_data_sbas_info;
    ::mip::gnss_data::sbas_system sbas_system() const {
        return static_cast<::mip::gnss_data::sbas_system>(c_type::sbas_system);
    }
    ::mip::gnss_data::sbas_status sbas_status() const {
        return static_cast<::mip::gnss_data::sbas_status>(c_type::sbas_status);
    }
    ::mip::gnss_data::sbas_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::sbas_info_flags>(c_type::valid_flags);
    }
};

/** SBAS info. See struct mip_gnss_data_sbas_info. */
using sbas_info = sbas_info_;

struct sbas_correction_ : ::mip_gnss_data_sbas_correction {
    using c_type = ::mip_gnss_data_sbas_correction;
    ::mip::gnss_constellation gnss_id() const {
        return static_cast<::mip::gnss_constellation>(c_type::gnss_id);
    }
    ::mip::gnss_data::sbas_correction_flags valid_flags() const {
        return static_cast<::mip::gnss_data::sbas_correction_flags>(c_type::valid_flags);
    }
};

/** SBAS correction. See struct mip_gnss_data_sbas_correction. */
using sbas_correction = sbas_correction_;

struct rf_error_detection_ : ::mip_gnss_data_rf_error_detection {
    using c_type = ::mip_gnss_data_rf_error_detection;
    ::mip::gnss_data::rf_band rf_band() const {
        return static_cast<::mip::gnss_data::rf_band>(c_type::rf_band);
    }
    ::mip::gnss_data::jamming_state jamming_state() const {
        return static_cast<::mip::gnss_data::jamming_state>(c_type::jamming_state);
    }
    ::mip::gnss_data::spoofing_state spoofing_state() const {
        return static_cast<::mip::gnss_data::spoofing_state>(c_type::spoofing_state);
    }
    ::mip::gnss_data::rf_error_detection_flags valid_flags() const {
        return static_cast<::mip::gnss_data::rf_error_detection_flags>(c_type::valid_flags);
    }
};

/** RF error detection. See struct mip_gnss_data_rf_error_detection. */
using rf_error_detection = rf_error_detection_;

struct heading_ : ::mip_gnss_data_heading {
    using c_type = ::mip_gnss_data_heading;
    ::mip::gnss_data::heading_fix_type fix_type() const {
        return static_cast<::mip::gnss_data::heading_fix_type>(c_type::fix_type);
    }
    ::mip::gnss_data::heading_flags valid_flags() const {
        return static_cast<::mip::gnss_data::heading_flags>(c_type::valid_flags);
    }
};

/** GNSS heading. See struct mip_gnss_data_heading. */
using heading = heading_;

struct satellite_status_ : ::mip_gnss_data_satellite_status {
    using c_type = ::mip_gnss_data_satellite_status;
    ::mip::gnss_constellation gnss_id() const {
        return static_cast<::mip::gnss_constellation>(c_type::gnss_id);
    }
    ::mip::gnss_data::satellite_status_flags valid_flags() const {
        return static_cast<::mip::gnss_data::satellite_status_flags>(c_type::valid_flags);
    }
};

/** Satellite status. See struct mip_gnss_data_satellite_status. */
using satellite_status = satellite_status_;

struct raw_ : ::mip_gnss_data_raw {
    using c_type = ::mip_gnss_data_raw;
    ::mip::gnss_constellation gnss_id() const {
        return static_cast<::mip::gnss_constellation>(c_type::gnss_id);
    }
    ::mip::gnss_signal signal_id() const {
        return static_cast<::mip::gnss_signal>(c_type::signal_id);
    }
    ::mip::gnss_data::signal_quality quality() const {
        return static_cast<::mip::gnss_data::signal_quality>(c_type::quality);
    }
    ::mip::gnss_data::raw_flags valid_flags() const {
        return static_cast<::mip::gnss_data::raw_flags>(c_type::valid_flags);
    }
};

/** Raw. See struct mip_gnss_data_raw. */
using raw = raw_;

struct base_station_info_ : ::mip_gnss_data_base_station_info {
    using c_type = ::mip_gnss_data_base_station_info;
    ::mip::gnss_data::base_station_indicators indicators() const {
        return static_cast<::mip::gnss_data::base_station_indicators>(c_type::indicators);
    }
    ::mip::gnss_data::base_station_info_flags valid_flags() const {
        return static_cast<::mip::gnss_data::base_station_info_flags>(c_type::valid_flags);
    }
};

/** Base station info. See struct mip_gnss_data_base_station_info. */
using base_station_info = base_station_info_;

struct rtk_corrections_status_ : ::mip_gnss_data_rtk_corrections_status {
    using c_type = ::mip_gnss_data_rtk_corrections_status;
    ::mip::gnss_data::rtk_epoch_status epoch_status() const {
        return static_cast<::mip::gnss_data::rtk_epoch_status>(c_type::epoch_status);
    }
    ::mip::rtk_status_flags dongle_status() const {
        return static_cast<::mip::rtk_status_flags>(c_type::dongle_status);
    }
    ::mip::gnss_data::rtk_corrections_status_flags valid_flags() const {
        return static_cast<::mip::gnss_data::rtk_corrections_status_flags>(c_type::valid_flags);
    }
};

/** RTK corrections status. See struct mip_gnss_data_rtk_corrections_status. */
using rtk_corrections_status = rtk_corrections_status_;

struct gps_ephemeris_ : ::mip_gnss_data_gps_ephemeris {
    using c_type = ::mip_gnss_data_gps_ephemeris;
    ::mip::gnss_data::ephemeris_flags valid_flags() const {
        return static_cast<::mip::gnss_data::ephemeris_flags>(c_type::valid_flags);
    }
};

/** GPS ephemeris. See struct mip_gnss_data_gps_ephemeris. */
using gps_ephemeris = gps_ephemeris_;

struct glonass_ephemeris_ : ::mip_gnss_data_glonass_ephemeris {
    using c_type = ::mip_gnss_data_glonass_ephemeris;
    ::mip::gnss_data::glonass_satellite_type satellite_type() const {
        return static_cast<::mip::gnss_data::glonass_satellite_type>(c_type::satellite_type);
    }
    ::mip::gnss_data::glonass_ephemeris_flags valid_flags() const {
        return static_cast<::mip::gnss_data::glonass_ephemeris_flags>(c_type::valid_flags);
    }
};

/** GLONASS ephemeris. See struct mip_gnss_data_glonass_ephemeris. */
using glonass_ephemeris = glonass_ephemeris_;

struct galileo_ephemeris_ : ::mip_gnss_data_galileo_ephemeris {
    using c_type = ::mip_gnss_data_galileo_ephemeris;
    ::mip::gnss_data::ephemeris_flags valid_flags() const {
        return static_cast<::mip::gnss_data::ephemeris_flags>(c_type::valid_flags);
    }
};

/** Galileo ephemeris. See struct mip_gnss_data_galileo_ephemeris. */
using galileo_ephemeris = galileo_ephemeris_;

struct beidou_ephemeris_ : ::mip_gnss_data_beidou_ephemeris {
    using c_type = ::mip_gnss_data_beidou_ephemeris;
    ::mip::gnss_data::ephemeris_flags valid_flags() const {
        return static_cast<::mip::gnss_data::ephemeris_flags>(c_type::valid_flags);
    }
};

/** BeiDou ephemeris. See struct mip_gnss_data_beidou_ephemeris. */
using beidou_ephemeris = beidou_ephemeris_;

struct gps_iono_correction_ : ::mip_gnss_data_gps_iono_correction {
    using c_type = ::mip_gnss_data_gps_iono_correction;
    ::mip::gnss_data::gps_iono_correction_flags valid_flags() const {
        return static_cast<::mip::gnss_data::gps_iono_correction_flags>(c_type::valid_flags);
    }
};

/** GPS ionospheric correction. See struct mip_gnss_data_gps_iono_correction. */
using gps_iono_correction = gps_iono_correction_;

struct galileo_iono_correction_ : ::mip_gnss_data_galileo_iono_correction {
    using c_type = ::mip_gnss_data_galileo_iono_correction;
    ::mip::gnss_data::galileo_iono_correction_flags valid_flags() const {
        return static_cast<::mip::gnss_data::galileo_iono_correction_flags>(c_type::valid_flags);
    }
};

/** Galileo ionospheric correction. See struct mip_gnss_data_galileo_iono_correction. */
using galileo_iono_correction = galileo_iono_correction_;

struct beidou_iono_correction_ : ::mip_gnss_data_beidou_iono_correction {
    using c_type = ::mip_gnss_data_beidou_iono_correction;
    ::mip::gnss_data::beidou_iono_correction_flags valid_flags() const {
        return static_cast<::mip::gnss_data::beidou_iono_correction_flags>(c_type::valid_flags);
    }
};

/** BeiDou ionospheric correction. See struct mip_gnss_data_beidou_iono_correction. */
using beidou_iono_correction = beidou_iono_correction_;

/** @} */

} // namespace gnss_data

} // namespace mip

#endif
