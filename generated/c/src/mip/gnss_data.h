/**
 * @file
 *
 * GNSS data. Measurements and status of GNSS receivers. Each receiver has a descriptor set; all
 * have the same fields. Uncertain: Some devices may not send a field in every set: the SDK lists
 * the same fields for all GNSS data sets, the manuals fewer.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_GNSS_DATA_H
#define MIP_GNSS_DATA_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/gnss_data.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_gnss_data GNSS data (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
 * @{ */

/**
 * Descriptor set: GNSS data. Measurements and status of the GNSS receiver of 4-series and 5-series
 * devices.
 */
#define MIP_GNSS_DATA_SET 0x81
/**
 * Descriptor set: GNSS receiver 1 data. Measurements and status of the first internal GNSS
 * receiver.
 */
#define MIP_GNSS_1_SET 0x91
/**
 * Descriptor set: GNSS receiver 2 data. Measurements and status of the second internal GNSS
 * receiver.
 */
#define MIP_GNSS_2_SET 0x92
/**
 * Descriptor set: GNSS corrections data. RTK corrections that the device receives. Data is sent as
 * it is received.
 */
#define MIP_GNSS_CORRECTIONS_SET 0x93
/**
 * Descriptor set: External GNSS data. Data that an external GNSS receiver sends to the device in
 * NMEA sentences. A field may need several sentences; a value that NMEA does not provide is not
 * valid. Times are taken from the sentences.
 */
#define MIP_GNSS_EXTERNAL_SET 0x94
/**
 * Descriptor set: External GNSS data 2. Data that a second external GNSS receiver sends to the
 * device. Uncertain: The name is from a page on the 3DM-CV7-INS that the vendor published for
 * trial; the SDK calls the set GNSS 5.
 */
#define MIP_GNSS_EXTERNAL_2_SET 0x95

/** Validity flags for the position. */
typedef uint16_t mip_gnss_data_llh_position_flags;
/** Bit 0. `latitude` and `longitude` are valid. */
#define MIP_GNSS_DATA_LLH_POSITION_FLAGS_LAT_LON 0x0001U
/** Bit 1. `ellipsoid_height` is valid. */
#define MIP_GNSS_DATA_LLH_POSITION_FLAGS_ELLIPSOID_HEIGHT 0x0002U
/** Bit 2. `msl_height` is valid. */
#define MIP_GNSS_DATA_LLH_POSITION_FLAGS_MSL_HEIGHT 0x0004U
/** Bit 3. `horizontal_accuracy` is valid. */
#define MIP_GNSS_DATA_LLH_POSITION_FLAGS_HORIZONTAL_ACCURACY 0x0008U
/** Bit 4. `vertical_accuracy` is valid. */
#define MIP_GNSS_DATA_LLH_POSITION_FLAGS_VERTICAL_ACCURACY 0x0010U
/** Bits 0 to 4. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_LLH_POSITION_FLAGS_FLAGS 0x001FU

/** Validity flags for the position. */
typedef uint16_t mip_gnss_data_ecef_position_flags;
/** Bit 0. `position` is valid. */
#define MIP_GNSS_DATA_ECEF_POSITION_FLAGS_POSITION 0x0001U
/** Bit 1. `position_accuracy` is valid. */
#define MIP_GNSS_DATA_ECEF_POSITION_FLAGS_POSITION_ACCURACY 0x0002U
/** Bits 0 to 1. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_ECEF_POSITION_FLAGS_FLAGS 0x0003U

/** Validity flags for the velocity. */
typedef uint16_t mip_gnss_data_ned_velocity_flags;
/** Bit 0. `velocity` is valid. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_VELOCITY 0x0001U
/** Bit 1. `speed` is valid. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_SPEED_3D 0x0002U
/** Bit 2. `ground_speed` is valid. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_GROUND_SPEED 0x0004U
/** Bit 3. `heading` is valid. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_HEADING 0x0008U
/** Bit 4. `speed_accuracy` is valid. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_SPEED_ACCURACY 0x0010U
/** Bit 5. `heading_accuracy` is valid. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_HEADING_ACCURACY 0x0020U
/** Bits 0 to 5. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_NED_VELOCITY_FLAGS_FLAGS 0x003FU

/** Validity flags for the velocity. */
typedef uint16_t mip_gnss_data_ecef_velocity_flags;
/** Bit 0. `velocity` is valid. */
#define MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_VELOCITY 0x0001U
/** Bit 1. `velocity_accuracy` is valid. */
#define MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_VELOCITY_ACCURACY 0x0002U
/** Bits 0 to 1. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_FLAGS 0x0003U

/** Validity flags for the dilutions of precision. */
typedef uint16_t mip_gnss_data_dop_flags;
/** Bit 0. `gdop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_GDOP 0x0001U
/** Bit 1. `pdop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_PDOP 0x0002U
/** Bit 2. `hdop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_HDOP 0x0004U
/** Bit 3. `vdop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_VDOP 0x0008U
/** Bit 4. `tdop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_TDOP 0x0010U
/** Bit 5. `ndop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_NDOP 0x0020U
/** Bit 6. `edop` is valid. */
#define MIP_GNSS_DATA_DOP_FLAGS_EDOP 0x0040U
/** Bits 0 to 6. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_DOP_FLAGS_FLAGS 0x007FU

/** Validity flags for the UTC time. */
typedef uint16_t mip_gnss_data_utc_time_flags;
/** Bit 0. Date and time come from GNSS. */
#define MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME 0x0001U
/** Bit 1. The leap seconds between GPS time and UTC are known. */
#define MIP_GNSS_DATA_UTC_TIME_FLAGS_LEAP_SECONDS_KNOWN 0x0002U
/**
 * Bits 0 to 1. Date and time come from GNSS, and the leap seconds are known. Overlaps other bits.
 */
#define MIP_GNSS_DATA_UTC_TIME_FLAGS_FLAGS 0x0003U

/** Validity flags for the time. */
typedef uint16_t mip_gnss_data_gps_time_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_GPS_TIME_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_GPS_TIME_FLAGS_WEEK_NUMBER 0x0002U
/** Bits 0 to 1. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_GPS_TIME_FLAGS_FLAGS 0x0003U

/** Validity flags for the clock parameters. */
typedef uint16_t mip_gnss_data_clock_info_flags;
/** Bit 0. `bias` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_FLAGS_BIAS 0x0001U
/** Bit 1. `drift` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_FLAGS_DRIFT 0x0002U
/** Bit 2. `accuracy_estimate` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_FLAGS_ACCURACY_ESTIMATE 0x0004U
/** Bits 0 to 2. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_CLOCK_INFO_FLAGS_FLAGS 0x0007U

/** Corrections and satellite systems of the fix. */
typedef uint16_t mip_gnss_data_fix_flags;
/** Bit 0. SBAS corrections were used in the fix. */
#define MIP_GNSS_DATA_FIX_FLAGS_SBAS_USED 0x0001U
/** Bit 1. Differential corrections were used in the fix. */
#define MIP_GNSS_DATA_FIX_FLAGS_DGNSS_USED 0x0002U

/** Validity flags for the fix information. */
typedef uint16_t mip_gnss_data_fix_info_flags;
/** Bit 0. `fix_type` is valid. */
#define MIP_GNSS_DATA_FIX_INFO_FLAGS_FIX_TYPE 0x0001U
/** Bit 1. `num_sv` is valid. */
#define MIP_GNSS_DATA_FIX_INFO_FLAGS_NUM_SV 0x0002U
/** Bit 2. `fix_flags` is valid. */
#define MIP_GNSS_DATA_FIX_INFO_FLAGS_FIX_FLAGS 0x0004U
/** Bits 0 to 2. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_FIX_INFO_FLAGS_FLAGS 0x0007U

/** State of a satellite. */
typedef uint16_t mip_gnss_data_sv_flags;
/** Bit 0. The satellite is used in the position fix. */
#define MIP_GNSS_DATA_SV_FLAGS_USED_FOR_NAVIGATION 0x0001U
/** Bit 1. The satellite reports that its signals can be used. */
#define MIP_GNSS_DATA_SV_FLAGS_HEALTHY 0x0002U

/** Validity flags for the satellite info. */
typedef uint16_t mip_gnss_data_sv_info_flags;
/** Bit 0. `channel` is valid. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_CHANNEL 0x0001U
/** Bit 1. `satellite_id` is valid. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_SATELLITE_ID 0x0002U
/** Bit 2. `carrier_noise_ratio` is valid. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_CARRIER_NOISE_RATIO 0x0004U
/** Bit 3. `azimuth` is valid. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_AZIMUTH 0x0008U
/** Bit 4. `elevation` is valid. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_ELEVATION 0x0010U
/** Bit 5. `sv_flags` is valid. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_SV_FLAGS 0x0020U
/** Bits 0 to 5. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_SV_INFO_FLAGS_FLAGS 0x003FU

/** Operating state of a GNSS receiver. */
enum mip_gnss_data_receiver_state MIP_ENUM_8 {
    /** The value `off`. */
    MIP_GNSS_DATA_RECEIVER_STATE_OFF = 0,
    /** The value `on`. */
    MIP_GNSS_DATA_RECEIVER_STATE_ON = 1,
    /** Not known. */
    MIP_GNSS_DATA_RECEIVER_STATE_UNKNOWN = 2
};

/** Electrical condition of a GNSS antenna. */
enum mip_gnss_data_antenna_state MIP_ENUM_8 {
    /** Being initialized. */
    MIP_GNSS_DATA_ANTENNA_STATE_INIT = 1,
    /** Short circuit. */
    MIP_GNSS_DATA_ANTENNA_STATE_SHORT = 2,
    /** Open circuit, no antenna. */
    MIP_GNSS_DATA_ANTENNA_STATE_OPEN = 3,
    /** The value `good`. */
    MIP_GNSS_DATA_ANTENNA_STATE_GOOD = 4,
    /** Not known. */
    MIP_GNSS_DATA_ANTENNA_STATE_UNKNOWN = 5
};

/** State of the antenna's power supply. */
enum mip_gnss_data_antenna_power MIP_ENUM_8 {
    /** The value `off`. */
    MIP_GNSS_DATA_ANTENNA_POWER_OFF = 0,
    /** The value `on`. */
    MIP_GNSS_DATA_ANTENNA_POWER_ON = 1,
    /** Not known. */
    MIP_GNSS_DATA_ANTENNA_POWER_UNKNOWN = 2
};

/** Validity flags for the hardware status. */
typedef uint16_t mip_gnss_data_hardware_status_flags;
/** Bit 0. `receiver_state` is valid. */
#define MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_SENSOR_STATE 0x0001U
/** Bit 1. `antenna_state` is valid. */
#define MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_ANTENNA_STATE 0x0002U
/** Bit 2. `antenna_power` is valid. */
#define MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_ANTENNA_POWER 0x0004U
/** Bits 0 to 2. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_FLAGS 0x0007U

/** Validity flags for the state of the corrections. */
typedef uint16_t mip_gnss_data_dgps_info_flags;
/** Bit 0. `age` is valid. */
#define MIP_GNSS_DATA_DGPS_INFO_FLAGS_AGE 0x0001U
/** Bit 1. `base_station_id` is valid. */
#define MIP_GNSS_DATA_DGPS_INFO_FLAGS_BASE_STATION_ID 0x0002U
/** Bit 2. `base_station_status` is valid. */
#define MIP_GNSS_DATA_DGPS_INFO_FLAGS_BASE_STATION_STATUS 0x0004U
/** Bit 3. `num_channels` is valid. */
#define MIP_GNSS_DATA_DGPS_INFO_FLAGS_NUM_CHANNELS 0x0008U
/** Bits 0 to 3. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_DGPS_INFO_FLAGS_FLAGS 0x000FU

/** Validity flags for a differential correction. */
typedef uint16_t mip_gnss_data_dgps_channel_flags;
/** Bit 0. `satellite_id` is valid. */
#define MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_SATELLITE_ID 0x0001U
/** Bit 1. `age` is valid. */
#define MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_AGE 0x0002U
/** Bit 2. `range_correction` is valid. */
#define MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_RANGE_CORRECTION 0x0004U
/** Bit 3. `range_rate_correction` is valid. */
#define MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_RANGE_RATE_CORRECTION 0x0008U
/** Bits 0 to 3. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_FLAGS 0x000FU

/** Validity flags for the clock parameters. */
typedef uint16_t mip_gnss_data_clock_info_2_flags;
/** Bit 0. `bias` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_BIAS 0x0001U
/** Bit 1. `drift` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_DRIFT 0x0002U
/** Bit 2. `bias_accuracy_estimate` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_BIAS_ACCURACY 0x0004U
/** Bit 3. `drift_accuracy_estimate` is valid. */
#define MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_DRIFT_ACCURACY 0x0008U
/** Bits 0 to 3. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_FLAGS 0x000FU

/** Validity of the leap seconds. Bit 0 is not used. */
typedef uint16_t mip_gnss_data_gps_leap_seconds_flags;
/** Bit 1. `leap_seconds` is valid. */
#define MIP_GNSS_DATA_GPS_LEAP_SECONDS_FLAGS_LEAP_SECONDS 0x0002U

/** Satellite-based augmentation system (SBAS). */
enum mip_gnss_data_sbas_system MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_DATA_SBAS_SYSTEM_UNKNOWN = 0,
    /** WAAS, the North American system. */
    MIP_GNSS_DATA_SBAS_SYSTEM_WAAS = 1,
    /** EGNOS, the European system. */
    MIP_GNSS_DATA_SBAS_SYSTEM_EGNOS = 2,
    /** MSAS, the Japanese system. */
    MIP_GNSS_DATA_SBAS_SYSTEM_MSAS = 3,
    /** GAGAN, the Indian system. */
    MIP_GNSS_DATA_SBAS_SYSTEM_GAGAN = 4
};

/** Services of an SBAS system. */
typedef uint8_t mip_gnss_data_sbas_status;
/** Bit 0. Ranging is available. */
#define MIP_GNSS_DATA_SBAS_STATUS_RANGE_AVAILABLE 0x01U
/** Bit 1. Corrections are available. */
#define MIP_GNSS_DATA_SBAS_STATUS_CORRECTIONS_AVAILABLE 0x02U
/** Bit 2. Integrity information is available. */
#define MIP_GNSS_DATA_SBAS_STATUS_INTEGRITY_AVAILABLE 0x04U
/** Bit 3. The service is in test mode. */
#define MIP_GNSS_DATA_SBAS_STATUS_TEST_MODE 0x08U

/** Validity flags for the SBAS status. */
typedef uint16_t mip_gnss_data_sbas_info_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `sbas_system` is valid. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_SYSTEM 0x0004U
/** Bit 3. `sbas_id` is valid. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_ID 0x0008U
/** Bit 4. `count` is valid. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_COUNT 0x0010U
/** Bit 5. `sbas_status` is valid. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_STATUS 0x0020U
/** Bits 0 to 5. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_SBAS_INFO_FLAGS_FLAGS 0x003FU

/** Validity flags for an SBAS correction. */
typedef uint16_t mip_gnss_data_sbas_correction_flags;
/** Bit 0. `udrei` is valid. */
#define MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_UDREI 0x0001U
/** Bit 1. `pseudorange_correction` is valid. */
#define MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_PSEUDORANGE_CORRECTION 0x0002U
/** Bit 2. `iono_correction` is valid. */
#define MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_IONO_CORRECTION 0x0004U
/** Bits 0 to 2. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_FLAGS 0x0007U

/** Frequency band of GNSS signals. */
enum mip_gnss_data_rf_band MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_DATA_RF_BAND_UNKNOWN = 0,
    /** The value `l1`. */
    MIP_GNSS_DATA_RF_BAND_L1 = 1,
    /** The value `l2`. */
    MIP_GNSS_DATA_RF_BAND_L2 = 2,
    /** The value `l5`. */
    MIP_GNSS_DATA_RF_BAND_L5 = 5
};

/** Severity of jamming. */
enum mip_gnss_data_jamming_state MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_DATA_JAMMING_STATE_UNKNOWN = 0,
    /** Not jammed. */
    MIP_GNSS_DATA_JAMMING_STATE_NONE = 1,
    /** Partly jammed. */
    MIP_GNSS_DATA_JAMMING_STATE_PARTIAL = 2,
    /** Heavily jammed. */
    MIP_GNSS_DATA_JAMMING_STATE_SIGNIFICANT = 3
};

/** Severity of spoofing. */
enum mip_gnss_data_spoofing_state MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_DATA_SPOOFING_STATE_UNKNOWN = 0,
    /** Not spoofed. */
    MIP_GNSS_DATA_SPOOFING_STATE_NONE = 1,
    /** Partly spoofed. */
    MIP_GNSS_DATA_SPOOFING_STATE_PARTIAL = 2,
    /** Heavily spoofed. */
    MIP_GNSS_DATA_SPOOFING_STATE_SIGNIFICANT = 3
};

/** Validity flags for the detection. */
typedef uint16_t mip_gnss_data_rf_error_detection_flags;
/** Bit 0. `rf_band` is valid. */
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_RF_BAND 0x0001U
/** Bit 1. `jamming_state` is valid. */
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_JAMMING_STATE 0x0002U
/** Bit 2. `spoofing_state` is valid. */
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_SPOOFING_STATE 0x0004U
/** Bit 3. `frequency` is valid; set only by firmware that sends the frequency. */
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_FREQUENCY 0x0008U
/** Bits 0 to 3. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_FLAGS 0x000FU

/** Resolution of the carrier phase ambiguities for a heading. */
enum mip_gnss_data_heading_fix_type MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_DATA_HEADING_FIX_TYPE_UNKNOWN = 0,
    /** The ambiguities are real numbers, which is less accurate. */
    MIP_GNSS_DATA_HEADING_FIX_TYPE_FLOAT = 1,
    /** The ambiguities are fixed to whole numbers of cycles. */
    MIP_GNSS_DATA_HEADING_FIX_TYPE_FIXED = 2
};

/** Validity flags for the heading. */
typedef uint16_t mip_gnss_data_heading_flags;
/** Bit 0. `heading` is valid. */
#define MIP_GNSS_DATA_HEADING_FLAGS_HEADING 0x0001U
/** Bit 1. `uncertainty` is valid. */
#define MIP_GNSS_DATA_HEADING_FLAGS_UNCERTAINTY 0x0002U
/** Bit 2. `fix_type` is valid. */
#define MIP_GNSS_DATA_HEADING_FLAGS_FIX_TYPE 0x0004U
/** Bits 0 to 2. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_HEADING_FLAGS_FLAGS 0x0007U

/** Validity flags for the satellite status. */
typedef uint16_t mip_gnss_data_satellite_status_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `gnss_id` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_GNSS_ID 0x0004U
/** Bit 3. `satellite_id` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_SATELLITE_ID 0x0008U
/** Bit 4. `elevation` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_ELEVATION 0x0010U
/** Bit 5. `azimuth` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_AZIMUTH 0x0020U
/** Bit 6. `health` is valid. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_HEALTH 0x0040U
/** Bits 0 to 6. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_FLAGS 0x007FU

/** Tracking quality of a signal. */
enum mip_gnss_data_signal_quality MIP_ENUM_8 {
    /** No signal. */
    MIP_GNSS_DATA_SIGNAL_QUALITY_NONE = 0,
    /** The signal is being searched for. */
    MIP_GNSS_DATA_SIGNAL_QUALITY_SEARCHING = 1,
    /** The signal is acquired. */
    MIP_GNSS_DATA_SIGNAL_QUALITY_ACQUIRED = 2,
    /** The signal is found but cannot be used. */
    MIP_GNSS_DATA_SIGNAL_QUALITY_UNUSABLE = 3,
    /** Time-locked. */
    MIP_GNSS_DATA_SIGNAL_QUALITY_TIME_LOCKED = 4,
    /** The value `fully_locked`. */
    MIP_GNSS_DATA_SIGNAL_QUALITY_FULLY_LOCKED = 5
};

/** Validity flags for the observation. */
typedef uint16_t mip_gnss_data_raw_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `receiver_id` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_RECEIVER_ID 0x0004U
/** Bit 3. `tracking_channel` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_TRACKING_CHANNEL 0x0008U
/** Bit 4. `gnss_id` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_GNSS_ID 0x0010U
/** Bit 5. `satellite_id` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_SATELLITE_ID 0x0020U
/** Bit 6. `signal_id` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_SIGNAL_ID 0x0040U
/** Bit 7. `signal_strength` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_SIGNAL_STRENGTH 0x0080U
/** Bit 8. `quality` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_QUALITY 0x0100U
/** Bit 9. `pseudorange` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_PSEUDORANGE 0x0200U
/** Bit 10. `carrier_phase` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_CARRIER_PHASE 0x0400U
/** Bit 11. `doppler` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_DOPPLER 0x0800U
/** Bit 12. `range_uncertainty` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_RANGE_UNCERTAINTY 0x1000U
/** Bit 13. `phase_uncertainty` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_CARRIER_PHASE_UNCERTAINTY 0x2000U
/** Bit 14. `doppler_uncertainty` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_DOPPLER_UNCERTAINTY 0x4000U
/** Bit 15. `lock_time` is valid. */
#define MIP_GNSS_DATA_RAW_FLAGS_LOCK_TIME 0x8000U
/** Bits 0 to 15. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_RAW_FLAGS_FLAGS 0xFFFFU

/** Properties of a base station, as in its RTCM message. */
typedef uint16_t mip_gnss_data_base_station_indicators;
/** Bit 0. GPS is supported. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_GPS 0x0001U
/** Bit 1. GLONASS is supported. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_GLONASS 0x0002U
/** Bit 2. Galileo is supported. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_GALILEO 0x0004U
/** Bit 3. BeiDou is supported. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_BEIDOU 0x0008U
/** Bit 4. Reference station indicator. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_REFERENCE_STATION 0x0010U
/** Bit 5. Single receiver oscillator indicator. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_SINGLE_RECEIVER 0x0020U
/** Bit 6. First bit of the quarter cycle indicator. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_QUARTER_CYCLE_BIT1 0x0040U
/** Bit 7. Second bit of the quarter cycle indicator. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_QUARTER_CYCLE_BIT2 0x0080U
/** Bits 6 to 7. Quarter cycle indicator. Overlaps other bits. */
#define MIP_GNSS_DATA_BASE_STATION_INDICATORS_QUARTER_CYCLE_BITS 0x00C0U

/** Valid values. */
typedef uint16_t mip_gnss_data_base_station_info_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `ecef_position` is valid. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_ECEF_POSITION 0x0004U
/** Bit 3. `height` is valid. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_HEIGHT 0x0008U
/** Bit 4. `station_id` is valid. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_STATION_ID 0x0010U
/** Bit 5. `indicators` is valid. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_INDICATORS 0x0020U
/** Bits 0 to 5. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_FLAGS 0x003FU

/** Corrections received during an epoch. */
typedef uint16_t mip_gnss_data_rtk_epoch_status;
/** Bit 0. The position of the base station's antenna has arrived. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_ANTENNA_LOCATION_RECEIVED 0x0001U
/** Bit 1. The description of the base station's antenna has arrived. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_ANTENNA_DESCRIPTION_RECEIVED 0x0002U
/** Bit 2. GPS corrections have arrived. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_GPS_RECEIVED 0x0004U
/** Bit 3. GLONASS corrections have arrived. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_GLONASS_RECEIVED 0x0008U
/** Bit 4. Galileo corrections have arrived. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_GALILEO_RECEIVED 0x0010U
/** Bit 5. BeiDou corrections have arrived. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_BEIDOU_RECEIVED 0x0020U
/** Bit 6. GPS corrections are received in MSM messages, not in the RTCM messages 1001-1004. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_USING_GPS_MSM_MESSAGES 0x0040U
/** Bit 7. GLONASS corrections are received in MSM messages, not in the RTCM messages 1009-1012. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_USING_GLONASS_MSM_MESSAGES 0x0080U
/** Bit 8. The status of the dongle could not be read. */
#define MIP_GNSS_DATA_RTK_EPOCH_STATUS_DONGLE_STATUS_READ_FAILED 0x0100U

/** Valid values. */
typedef uint16_t mip_gnss_data_rtk_corrections_status_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `epoch_status` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_EPOCH_STATUS 0x0004U
/** Bit 3. `dongle_status` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_DONGLE_STATUS 0x0008U
/** Bit 4. `gps_correction_latency` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GPS_LATENCY 0x0010U
/** Bit 5. `glonass_correction_latency` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GLONASS_LATENCY 0x0020U
/** Bit 6. `galileo_correction_latency` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GALILEO_LATENCY 0x0040U
/** Bit 7. `beidou_correction_latency` is valid. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_BEIDOU_LATENCY 0x0080U
/** Bits 0 to 7. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_FLAGS 0x00FFU

/** Contents of a GPS, Galileo or BeiDou ephemeris. */
typedef uint16_t mip_gnss_data_ephemeris_flags;
/** Bit 0. The ephemeris is valid. */
#define MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS 0x0001U
/** Bit 1. Data of the modernized navigation message is included. */
#define MIP_GNSS_DATA_EPHEMERIS_FLAGS_MODERN_DATA 0x0002U
/** Bit 2. `isc_l2c` is the correction for L5, not for L2. */
#define MIP_GNSS_DATA_EPHEMERIS_FLAGS_ISC_L5 0x0004U
/**
 * Bits 0 to 2. The ephemeris is valid, with modernized data and the correction for L5. Overlaps
 * other bits.
 */
#define MIP_GNSS_DATA_EPHEMERIS_FLAGS_FLAGS 0x0007U

/** Generation of a GLONASS satellite. */
enum mip_gnss_data_glonass_satellite_type MIP_ENUM_8 {
    /** The value `glonass`. */
    MIP_GNSS_DATA_GLONASS_SATELLITE_TYPE_GLONASS = 0,
    /** The value `glonass_m`. */
    MIP_GNSS_DATA_GLONASS_SATELLITE_TYPE_GLONASS_M = 1
};

/** Validity of the ephemeris. */
typedef uint16_t mip_gnss_data_glonass_ephemeris_flags;
/** Bit 0. The ephemeris is valid. */
#define MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS 0x0001U
/** Bit 0. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_FLAGS 0x0001U

/** Validity flags for the model. */
typedef uint16_t mip_gnss_data_gps_iono_correction_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `alpha` is valid. */
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_ALPHA 0x0004U
/** Bit 3. `beta` is valid. */
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_BETA 0x0008U
/** Bits 0 to 3. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_FLAGS 0x000FU

/** Validity flags for the model. */
typedef uint16_t mip_gnss_data_galileo_iono_correction_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `alpha` is valid. */
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_ALPHA 0x0004U
/** Bit 3. `disturbance_flags` is valid. */
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_DISTURBANCE_FLAGS 0x0008U
/** Bits 0 to 3. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_FLAGS 0x000FU

/** Validity flags for the model. */
typedef uint16_t mip_gnss_data_beidou_iono_correction_flags;
/** Bit 0. `tow` is valid. */
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_TOW 0x0001U
/** Bit 1. `week_number` is valid. */
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. `alpha` is valid. */
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_ALPHA 0x0004U
/** Bit 3. `beta` is valid. */
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_BETA 0x0008U
/** Bit 4. `alpha_correction` is valid. */
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_ALPHA_CORRECTION 0x0010U
/** Bits 0 to 4. All values are valid. Overlaps other bits. */
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_FLAGS 0x001FU

/**
 * GNSS LLH position: data 0x03.
 *
 * GNSS position as latitude, longitude and height.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `pos_llh`.
 *
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x91,0x03)
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x92,0x03)
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
 */
struct mip_gnss_data_llh_position {
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
     * MIP_GNSS_DATA_LLH_POSITION_FLAGS_LAT_LON in valid_flags is set.
     */
    double latitude;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
     * MIP_GNSS_DATA_LLH_POSITION_FLAGS_LAT_LON in valid_flags is set.
     */
    double longitude;
    /**
     * Height above the ellipsoid. Unit: m. Frame: llh. Valid if
     * MIP_GNSS_DATA_LLH_POSITION_FLAGS_ELLIPSOID_HEIGHT in valid_flags is set.
     */
    double ellipsoid_height;
    /**
     * Height above mean sea level. Unit: m. Valid if MIP_GNSS_DATA_LLH_POSITION_FLAGS_MSL_HEIGHT in
     * valid_flags is set.
     */
    double msl_height;
    /**
     * Estimated error of latitude and longitude. Unit: m. Range: at least 0. Valid if
     * MIP_GNSS_DATA_LLH_POSITION_FLAGS_HORIZONTAL_ACCURACY in valid_flags is set.
     */
    float horizontal_accuracy;
    /**
     * Estimated error of the heights. Unit: m. Range: at least 0. Valid if
     * MIP_GNSS_DATA_LLH_POSITION_FLAGS_VERTICAL_ACCURACY in valid_flags is set.
     */
    float vertical_accuracy;
    /** Validity flags for the position. */
    mip_gnss_data_llh_position_flags valid_flags;
};

#define MIP_GNSS_DATA_LLH_POSITION(descriptor_set) MIP_KEY(descriptor_set, 0x03)
#define MIP_GNSS_DATA_LLH_POSITION_DESCRIPTOR 0x03
MIP_FIELD(mip_gnss_data_llh_position, 0x03);

/**
 * GNSS ECEF position: data 0x04.
 *
 * GNSS position in Earth-fixed coordinates.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `pos_ecef`.
 *
 * - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x91,0x04)
 * - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x92,0x04)
 */
struct mip_gnss_data_ecef_position {
    /**
     * Position of the antenna. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
     * MIP_GNSS_DATA_ECEF_POSITION_FLAGS_POSITION in valid_flags is set.
     */
    double position[3];
    /**
     * Estimated error of the position. Unit: m. Range: at least 0. Valid if
     * MIP_GNSS_DATA_ECEF_POSITION_FLAGS_POSITION_ACCURACY in valid_flags is set.
     */
    float position_accuracy;
    /** Validity flags for the position. */
    mip_gnss_data_ecef_position_flags valid_flags;
};

#define MIP_GNSS_DATA_ECEF_POSITION(descriptor_set) MIP_KEY(descriptor_set, 0x04)
#define MIP_GNSS_DATA_ECEF_POSITION_DESCRIPTOR 0x04
MIP_FIELD(mip_gnss_data_ecef_position, 0x04);

/**
 * NED velocity: data 0x05.
 *
 * GNSS velocity in the local level frame.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `vel_ned`.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x91,0x05)
 * - 3dm-cv7-gnss-ins: NED Velocity (0x92,0x05)
 * - 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
 */
struct mip_gnss_data_ned_velocity {
    /**
     * Velocity of the antenna. Elements: north, east, down. Unit: m/s. Frame: ned. At rest and
     * level: north 0, east 0, down 0. Valid if MIP_GNSS_DATA_NED_VELOCITY_FLAGS_VELOCITY in
     * valid_flags is set.
     */
    float velocity[3];
    /**
     * Speed in space. Unit: m/s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_NED_VELOCITY_FLAGS_SPEED_3D in valid_flags is set.
     */
    float speed;
    /**
     * Speed over ground. Unit: m/s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_NED_VELOCITY_FLAGS_GROUND_SPEED in valid_flags is set.
     */
    float ground_speed;
    /**
     * Direction of the motion over ground. Unit: deg. Frame: ned. Positive: clockwise seen from
     * above. Valid if MIP_GNSS_DATA_NED_VELOCITY_FLAGS_HEADING in valid_flags is set.
     */
    float heading;
    /**
     * Estimated error of the speed. Unit: m/s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_NED_VELOCITY_FLAGS_SPEED_ACCURACY in valid_flags is set.
     */
    float speed_accuracy;
    /**
     * Estimated error of the heading. Unit: deg. Range: at least 0. Valid if
     * MIP_GNSS_DATA_NED_VELOCITY_FLAGS_HEADING_ACCURACY in valid_flags is set.
     */
    float heading_accuracy;
    /** Validity flags for the velocity. */
    mip_gnss_data_ned_velocity_flags valid_flags;
};

#define MIP_GNSS_DATA_NED_VELOCITY(descriptor_set) MIP_KEY(descriptor_set, 0x05)
#define MIP_GNSS_DATA_NED_VELOCITY_DESCRIPTOR 0x05
MIP_FIELD(mip_gnss_data_ned_velocity, 0x05);

/**
 * GNSS ECEF velocity: data 0x06.
 *
 * GNSS velocity in Earth-fixed coordinates.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `vel_ecef`.
 *
 * - 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06)
 * - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x91,0x06)
 * - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06)
 */
struct mip_gnss_data_ecef_velocity {
    /**
     * Velocity of the antenna. Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and level: x 0, y
     * 0, z 0. Valid if MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_VELOCITY in valid_flags is set.
     */
    float velocity[3];
    /**
     * Estimated error of the velocity. Unit: m/s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_ECEF_VELOCITY_FLAGS_VELOCITY_ACCURACY in valid_flags is set.
     */
    float velocity_accuracy;
    /** Validity flags for the velocity. */
    mip_gnss_data_ecef_velocity_flags valid_flags;
};

#define MIP_GNSS_DATA_ECEF_VELOCITY(descriptor_set) MIP_KEY(descriptor_set, 0x06)
#define MIP_GNSS_DATA_ECEF_VELOCITY_DESCRIPTOR 0x06
MIP_FIELD(mip_gnss_data_ecef_velocity, 0x06);

/**
 * DOP: data 0x07.
 *
 * Dilution of precision of the satellite geometry.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - 3dm-cv7-gnss-ins: DOP (0x91,0x07)
 * - 3dm-cv7-gnss-ins: DOP (0x92,0x07)
 */
struct mip_gnss_data_dop {
    /**
     * Geometric dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_GDOP in
     * valid_flags is set.
     */
    float gdop;
    /**
     * Position dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_PDOP in
     * valid_flags is set.
     */
    float pdop;
    /**
     * Horizontal dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_HDOP in
     * valid_flags is set.
     */
    float hdop;
    /**
     * Vertical dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_VDOP in
     * valid_flags is set.
     */
    float vdop;
    /**
     * Time dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_TDOP in
     * valid_flags is set.
     */
    float tdop;
    /**
     * Northing dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_NDOP in
     * valid_flags is set.
     */
    float ndop;
    /**
     * Easting dilution. Unit: 1. Range: at least 0. Valid if MIP_GNSS_DATA_DOP_FLAGS_EDOP in
     * valid_flags is set.
     */
    float edop;
    /** Validity flags for the dilutions of precision. */
    mip_gnss_data_dop_flags valid_flags;
};

#define MIP_GNSS_DATA_DOP(descriptor_set) MIP_KEY(descriptor_set, 0x07)
#define MIP_GNSS_DATA_DOP_DESCRIPTOR 0x07
MIP_FIELD(mip_gnss_data_dop, 0x07);

/**
 * UTC time: data 0x08.
 *
 * Coordinated universal time (UTC) according to the receiver.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - 3dm-cv7-gnss-ins: UTC Time (0x91,0x08)
 * - 3dm-cv7-gnss-ins: UTC Time (0x92,0x08)
 * - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
 */
struct mip_gnss_data_utc_time {
    /**
     * Year with four digits. Valid if MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in valid_flags is
     * set.
     */
    uint16_t year;
    /**
     * Month, 1 for January. Range: 1 to 12. Valid if MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in
     * valid_flags is set.
     */
    uint8_t month;
    /**
     * Day of the month. Range: 1 to 31. Valid if MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in
     * valid_flags is set.
     */
    uint8_t day;
    /**
     * Hour of the day. Range: 0 to 23. Valid if MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in
     * valid_flags is set.
     */
    uint8_t hour;
    /**
     * Minute. Range: 0 to 59. Valid if MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in valid_flags
     * is set.
     */
    uint8_t min;
    /**
     * Second. Unit: s. Range: 0 to 59. Valid if MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in
     * valid_flags is set.
     */
    uint8_t sec;
    /**
     * Fraction of the second. Unit: ms. Range: 0 to 999. Valid if
     * MIP_GNSS_DATA_UTC_TIME_FLAGS_GNSS_DATE_TIME in valid_flags is set.
     */
    uint32_t msec;
    /** Validity flags for the time. */
    mip_gnss_data_utc_time_flags valid_flags;
};

#define MIP_GNSS_DATA_UTC_TIME(descriptor_set) MIP_KEY(descriptor_set, 0x08)
#define MIP_GNSS_DATA_UTC_TIME_DESCRIPTOR 0x08
MIP_FIELD(mip_gnss_data_utc_time, 0x08);

/**
 * GPS time: data 0x09.
 *
 * GPS time according to the receiver.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - 3dm-cv7-gnss-ins: GPS Time (0x91,0x09)
 * - 3dm-cv7-gnss-ins: GPS Time (0x92,0x09)
 */
struct mip_gnss_data_gps_time {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_GPS_TIME_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_GPS_TIME_FLAGS_WEEK_NUMBER in valid_flags
     * is set.
     */
    uint16_t week_number;
    /** Validity flags for the time. */
    mip_gnss_data_gps_time_flags valid_flags;
};

#define MIP_GNSS_DATA_GPS_TIME(descriptor_set) MIP_KEY(descriptor_set, 0x09)
#define MIP_GNSS_DATA_GPS_TIME_DESCRIPTOR 0x09
MIP_FIELD(mip_gnss_data_gps_time, 0x09);

/**
 * Clock info: data 0x0A.
 *
 * Bias and drift of the receiver clock.
 *
 * No device is known for certain to support it. Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET,
 * MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET, MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 * Known only from the MicroStrain MIP SDK.
 *
 * Clock info 2 supersedes it and is more detailed.
 *
 * - mip-sdk-4: Clock Info (0x81,0x0A)
 */
struct mip_gnss_data_clock_info {
    /**
     * Bias of the clock. Unit: s. Valid if MIP_GNSS_DATA_CLOCK_INFO_FLAGS_BIAS in valid_flags is
     * set.
     */
    double bias;
    /**
     * Drift of the clock. Unit: s/s. Valid if MIP_GNSS_DATA_CLOCK_INFO_FLAGS_DRIFT in valid_flags
     * is set.
     */
    double drift;
    /**
     * Estimated error of the bias. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_CLOCK_INFO_FLAGS_ACCURACY_ESTIMATE in valid_flags is set.
     */
    double accuracy_estimate;
    /** Validity flags for the clock parameters. */
    mip_gnss_data_clock_info_flags valid_flags;
};

#define MIP_GNSS_DATA_CLOCK_INFO(descriptor_set) MIP_KEY(descriptor_set, 0x0A)
#define MIP_GNSS_DATA_CLOCK_INFO_DESCRIPTOR 0x0A
MIP_FIELD(mip_gnss_data_clock_info, 0x0A);

/**
 * Fix info: data 0x0B.
 *
 * Type of the position fix, with the satellites and corrections used.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
 * - 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B)
 * - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
 */
struct mip_gnss_data_fix_info {
    /**
     * Quantities that the receiver can determine at present. A value of enum mip_gnss_fix_type.
     * Valid if MIP_GNSS_DATA_FIX_INFO_FLAGS_FIX_TYPE in valid_flags is set.
     */
    uint8_t fix_type;
    /**
     * Number of satellites used in the fix. Unit: 1. Valid if MIP_GNSS_DATA_FIX_INFO_FLAGS_NUM_SV
     * in valid_flags is set.
     */
    uint8_t num_sv;
    /**
     * Corrections and satellite systems of the fix. Valid if MIP_GNSS_DATA_FIX_INFO_FLAGS_FIX_FLAGS
     * in valid_flags is set.
     */
    mip_gnss_data_fix_flags fix_flags;
    /** Validity flags for the fix information. */
    mip_gnss_data_fix_info_flags valid_flags;
};

#define MIP_GNSS_DATA_FIX_INFO(descriptor_set) MIP_KEY(descriptor_set, 0x0B)
#define MIP_GNSS_DATA_FIX_INFO_DESCRIPTOR 0x0B
MIP_FIELD(mip_gnss_data_fix_info, 0x0B);

/**
 * Satellite info: data 0x0C.
 *
 * State of one tracked satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Known only from the MicroStrain MIP SDK.
 * Uncertain: It is not known whether a packet contains one of these fields or several.
 *
 * Each satellite is sent as one field, in packets separate from other GNSS data.
 *
 * - mip-sdk-4: Sv Info (0x81,0x0C)
 */
struct mip_gnss_data_sv_info {
    /**
     * Channel of the receiver that tracks the satellite. Valid if
     * MIP_GNSS_DATA_SV_INFO_FLAGS_CHANNEL in valid_flags is set.
     */
    uint8_t channel;
    /**
     * Number of the satellite. Valid if MIP_GNSS_DATA_SV_INFO_FLAGS_SATELLITE_ID in valid_flags is
     * set.
     */
    uint8_t satellite_id;
    /**
     * Carrier to noise density ratio. Unit: dB-Hz. Valid if
     * MIP_GNSS_DATA_SV_INFO_FLAGS_CARRIER_NOISE_RATIO in valid_flags is set.
     */
    uint16_t carrier_noise_ratio;
    /**
     * Direction of the satellite, from true north. Unit: deg. Frame: ned. Positive: clockwise seen
     * from above. Valid if MIP_GNSS_DATA_SV_INFO_FLAGS_AZIMUTH in valid_flags is set.
     */
    int16_t azimuth;
    /**
     * Angle between the horizon and the satellite. Unit: deg. Frame: ned. Range: -90 to 90.
     * Positive: above the horizon. Valid if MIP_GNSS_DATA_SV_INFO_FLAGS_ELEVATION in valid_flags is
     * set.
     */
    int16_t elevation;
    /**
     * State of the satellite. Valid if MIP_GNSS_DATA_SV_INFO_FLAGS_SV_FLAGS in valid_flags is set.
     */
    mip_gnss_data_sv_flags sv_flags;
    /** Validity flags for the satellite info. */
    mip_gnss_data_sv_info_flags valid_flags;
};

#define MIP_GNSS_DATA_SV_INFO(descriptor_set) MIP_KEY(descriptor_set, 0x0C)
#define MIP_GNSS_DATA_SV_INFO_DESCRIPTOR 0x0C
MIP_FIELD(mip_gnss_data_sv_info, 0x0C);

/**
 * GNSS hardware status: data 0x0D.
 *
 * State of the receiver and of its antenna.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `hw_status`.
 *
 * - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x91,0x0D)
 * - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x92,0x0D)
 */
struct mip_gnss_data_hardware_status {
    /**
     * Operating state of the receiver. A value of enum mip_gnss_data_receiver_state. Valid if
     * MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_SENSOR_STATE in valid_flags is set.
     */
    uint8_t receiver_state;
    /**
     * Electrical condition of the antenna. A value of enum mip_gnss_data_antenna_state. Valid if
     * MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_ANTENNA_STATE in valid_flags is set.
     */
    uint8_t antenna_state;
    /**
     * State of the antenna's power supply. A value of enum mip_gnss_data_antenna_power. Valid if
     * MIP_GNSS_DATA_HARDWARE_STATUS_FLAGS_ANTENNA_POWER in valid_flags is set.
     */
    uint8_t antenna_power;
    /** Validity flags for the hardware status. */
    mip_gnss_data_hardware_status_flags valid_flags;
};

#define MIP_GNSS_DATA_HARDWARE_STATUS(descriptor_set) MIP_KEY(descriptor_set, 0x0D)
#define MIP_GNSS_DATA_HARDWARE_STATUS_DESCRIPTOR 0x0D
MIP_FIELD(mip_gnss_data_hardware_status, 0x0D);

/**
 * DGPS info: data 0x0E.
 *
 * State of the differential corrections.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. The size of its data distinguishes it from
 * mip_gnss_data_dgps_info_satellite. Uncertain: Devices could also send
 * mip_gnss_data_dgps_info_satellite, the layout of the SDK, but only this one agrees with the valid
 * flags, which are the same in all sources.
 *
 * The sources contradict each other. This layout is in a manual of the 3DM-GX5-35, in MSCL and in
 * the SDK of 2014.
 *
 * - 3dm-gx5-35: 5.2.12 DGNSS Information (0x81, 0x0E)
 * - mscl: DGPS Info (0x81,0x0E)
 * - mip-sdk-2014: DGPS Info (0x81,0x0E)
 */
struct mip_gnss_data_dgps_info {
    /**
     * Age of the corrections. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_DGPS_INFO_FLAGS_AGE in valid_flags is set. Uncertain: The unit is that of
     * mip_gnss_data_dgps_channel; no source states it here.
     */
    float age;
    /**
     * Number of the base station. Valid if MIP_GNSS_DATA_DGPS_INFO_FLAGS_BASE_STATION_ID in
     * valid_flags is set.
     */
    int16_t base_station_id;
    /**
     * State of the base station: 0 to 5 are factors of the user differential range error, which are
     * 1.0, 0.75, 0.5, 0.3, 0.2 and 0.1; 6 is not monitored, 7 not working. Valid if
     * MIP_GNSS_DATA_DGPS_INFO_FLAGS_BASE_STATION_STATUS in valid_flags is set.
     */
    int16_t base_station_status;
    /**
     * Number of channels that have corrections. Unit: 1. Valid if
     * MIP_GNSS_DATA_DGPS_INFO_FLAGS_NUM_CHANNELS in valid_flags is set.
     */
    uint16_t num_channels;
    /** Validity flags for the state of the corrections. */
    mip_gnss_data_dgps_info_flags valid_flags;
};

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_GNSS_DATA_DGPS_INFO(descriptor_set) MIP_KEY(descriptor_set, 0x0E)
#define MIP_GNSS_DATA_DGPS_INFO_DESCRIPTOR 0x0E
MIP_FIELD(mip_gnss_data_dgps_info, 0x0E);

/**
 * DGPS info for one satellite: data 0x0E.
 *
 * Differential correction for one satellite, in the SDK's layout of DGPS info.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. The size of its data distinguishes it from
 * mip_gnss_data_dgps_info. Known only from the MicroStrain MIP SDK. Uncertain: Possibly no device
 * sends it: the values are those of mip_gnss_data_dgps_channel, but the flags those of
 * mip_gnss_data_dgps_info, so a mistake in the SDK is likely.
 *
 * The sources contradict each other. The manual of the 3DM-GX5-35 and MSCL document
 * mip_gnss_data_dgps_info instead.
 *
 * The flags of `base_station_id`, `base_station_status` and `num_channels` correspond to no value
 * in this layout.
 *
 * - mip-sdk-4: Dgps Info (0x81,0x0E)
 */
struct mip_gnss_data_dgps_info_satellite {
    /** Number of the satellite. */
    uint8_t satellite_id;
    /**
     * Age of the correction. Unit: s. Range: at least 0. Valid if MIP_GNSS_DATA_DGPS_INFO_FLAGS_AGE
     * in valid_flags is set. Uncertain: The unit is that of mip_gnss_data_dgps_channel; no source
     * states it here.
     */
    float age;
    /**
     * Differential correction of the pseudorange. Unit: m. Uncertain: The unit is that of
     * mip_gnss_data_dgps_channel; no source states it here.
     */
    float range_correction;
    /**
     * Rate of change of the correction. Unit: m/s. Uncertain: The unit is that of
     * mip_gnss_data_dgps_channel; no source states it here.
     */
    float range_rate_correction;
    /** Validity flags for the state of the corrections. */
    mip_gnss_data_dgps_info_flags valid_flags;
};

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_GNSS_DATA_DGPS_INFO_SATELLITE(descriptor_set) MIP_KEY(descriptor_set, 0x0E)
#define MIP_GNSS_DATA_DGPS_INFO_SATELLITE_DESCRIPTOR 0x0E
MIP_FIELD(mip_gnss_data_dgps_info_satellite, 0x0E);

/**
 * DGPS channel: data 0x0F.
 *
 * Differential correction for one satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Known only from the MIP SDK of 2014,
 * MicroStrain Communication Library and MicroStrain MIP SDK.
 *
 * Each active satellite is sent as one field, all in one packet.
 *
 * - mip-sdk-4: Dgps Channel (0x81,0x0F)
 * - mscl: DGPS Channel Status (0x81,0x0F)
 * - mip-sdk-2014: DGPS Channel (0x81,0x0F)
 */
struct mip_gnss_data_dgps_channel {
    /**
     * Number of the satellite. Valid if MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_SATELLITE_ID in
     * valid_flags is set.
     */
    uint8_t satellite_id;
    /**
     * Age of the correction. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_AGE in valid_flags is set.
     */
    float age;
    /**
     * Differential correction of the pseudorange. Unit: m. Valid if
     * MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_RANGE_CORRECTION in valid_flags is set.
     */
    float range_correction;
    /**
     * Rate of change of the correction. Unit: m/s. Valid if
     * MIP_GNSS_DATA_DGPS_CHANNEL_FLAGS_RANGE_RATE_CORRECTION in valid_flags is set.
     */
    float range_rate_correction;
    /** Validity flags for a differential correction. */
    mip_gnss_data_dgps_channel_flags valid_flags;
};

#define MIP_GNSS_DATA_DGPS_CHANNEL(descriptor_set) MIP_KEY(descriptor_set, 0x0F)
#define MIP_GNSS_DATA_DGPS_CHANNEL_DESCRIPTOR 0x0F
MIP_FIELD(mip_gnss_data_dgps_channel, 0x0F);

/**
 * Clock info 2: data 0x10.
 *
 * Bias and drift of the receiver clock.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Uncertain: The units are inferred from those
 * of the ephemerides; no source states them.
 *
 * It supersedes clock info.
 *
 * - 3dm-cv7-gnss-ins: Clock Info 2 (0x91,0x10)
 * - 3dm-cv7-gnss-ins: Clock Info 2 (0x92,0x10)
 */
struct mip_gnss_data_clock_info_2 {
    /**
     * Bias of the clock. Unit: s. Valid if MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_BIAS in valid_flags is
     * set.
     */
    double bias;
    /**
     * Drift of the clock. Unit: s/s. Valid if MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_DRIFT in valid_flags
     * is set.
     */
    double drift;
    /**
     * Estimated error of the bias. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_BIAS_ACCURACY in valid_flags is set.
     */
    double bias_accuracy_estimate;
    /**
     * Estimated error of the drift. Unit: s/s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_CLOCK_INFO_2_FLAGS_DRIFT_ACCURACY in valid_flags is set.
     */
    double drift_accuracy_estimate;
    /** Validity flags for the clock parameters. */
    mip_gnss_data_clock_info_2_flags valid_flags;
};

#define MIP_GNSS_DATA_CLOCK_INFO_2(descriptor_set) MIP_KEY(descriptor_set, 0x10)
#define MIP_GNSS_DATA_CLOCK_INFO_2_DESCRIPTOR 0x10
MIP_FIELD(mip_gnss_data_clock_info_2, 0x10);

/**
 * GPS leap seconds: data 0x11.
 *
 * Difference between GPS time and UTC.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x91,0x11)
 * - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x92,0x11)
 */
struct mip_gnss_data_gps_leap_seconds {
    /**
     * GPS time minus UTC. Unit: s. Valid if MIP_GNSS_DATA_GPS_LEAP_SECONDS_FLAGS_LEAP_SECONDS in
     * valid_flags is set.
     */
    uint8_t leap_seconds;
    /** Validity of the leap seconds. */
    mip_gnss_data_gps_leap_seconds_flags valid_flags;
};

#define MIP_GNSS_DATA_GPS_LEAP_SECONDS(descriptor_set) MIP_KEY(descriptor_set, 0x11)
#define MIP_GNSS_DATA_GPS_LEAP_SECONDS_DESCRIPTOR 0x11
MIP_FIELD(mip_gnss_data_gps_leap_seconds, 0x11);

/**
 * SBAS info: data 0x12.
 *
 * Status of the satellite-based augmentation (SBAS).
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - 3dm-cv7-gnss-ins: SBAS Info (0x91,0x12)
 * - 3dm-cv7-gnss-ins: SBAS Info (0x92,0x12)
 */
struct mip_gnss_data_sbas_info {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_SBAS_INFO_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_SBAS_INFO_FLAGS_WEEK_NUMBER in
     * valid_flags is set.
     */
    uint16_t week_number;
    /**
     * System in use. A value of enum mip_gnss_data_sbas_system. Valid if
     * MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_SYSTEM in valid_flags is set.
     */
    uint8_t sbas_system;
    /** SBAS satellite. Valid if MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_ID in valid_flags is set. */
    uint8_t sbas_id;
    /**
     * Number of SBAS corrections. Unit: 1. Valid if MIP_GNSS_DATA_SBAS_INFO_FLAGS_COUNT in
     * valid_flags is set.
     */
    uint8_t count;
    /**
     * Status of the service. Valid if MIP_GNSS_DATA_SBAS_INFO_FLAGS_SBAS_STATUS in valid_flags is
     * set.
     */
    mip_gnss_data_sbas_status sbas_status;
    /** Validity flags for the SBAS status. */
    mip_gnss_data_sbas_info_flags valid_flags;
};

#define MIP_GNSS_DATA_SBAS_INFO(descriptor_set) MIP_KEY(descriptor_set, 0x12)
#define MIP_GNSS_DATA_SBAS_INFO_DESCRIPTOR 0x12
MIP_FIELD(mip_gnss_data_sbas_info, 0x12);

/**
 * SBAS correction: data 0x13.
 *
 * SBAS correction for one satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Known only from the MicroStrain MIP SDK.
 *
 * An epoch is sent as one field for each satellite; `index` and `count` number the fields.
 *
 * For `udrei` 0 to 13, the variances in m^2 are 0.0520, 0.0924, 0.1444, 0.2830, 0.4678, 0.8315,
 * 1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.
 *
 * - mip-sdk-4: Sbas Correction (0x81,0x13)
 */
struct mip_gnss_data_sbas_correction {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /** GPS time of week of the reception. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number. Unit: week. */
    uint16_t week_number;
    /** Constellation. A value of enum mip_gnss_constellation. */
    uint8_t gnss_id;
    /** Satellite within the constellation. */
    uint8_t satellite_id;
    /**
     * Indicator of the range error that remains after fast and long-term corrections, not counting
     * the atmosphere; 14 is not monitored, 15 not usable. Range: 0 to 15. Valid if
     * MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_UDREI in valid_flags is set.
     */
    uint8_t udrei;
    /**
     * Correction of the pseudorange by the augmentation system. Unit: m. Valid if
     * MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_PSEUDORANGE_CORRECTION in valid_flags is set.
     */
    float pseudorange_correction;
    /**
     * Correction of the ionospheric delay. Unit: m. Valid if
     * MIP_GNSS_DATA_SBAS_CORRECTION_FLAGS_IONO_CORRECTION in valid_flags is set.
     */
    float iono_correction;
    /** Validity flags for an SBAS correction. */
    mip_gnss_data_sbas_correction_flags valid_flags;
};

#define MIP_GNSS_DATA_SBAS_CORRECTION(descriptor_set) MIP_KEY(descriptor_set, 0x13)
#define MIP_GNSS_DATA_SBAS_CORRECTION_DESCRIPTOR 0x13
MIP_FIELD(mip_gnss_data_sbas_correction, 0x13);

/**
 * RF error detection: data 0x14.
 *
 * Jamming and spoofing that the receiver detects in one band.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Known only from the MicroStrain MIP SDK.
 *
 * Version 4.0.0 of the SDK reserves the two bytes of `frequency`. Firmware from that time sends 0
 * there and does not set its flag.
 *
 * - mip-sdk-4: Rf Error Detection (0x81,0x14)
 */
struct mip_gnss_data_rf_error_detection {
    /**
     * Band to which the states apply. A value of enum mip_gnss_data_rf_band. Valid if
     * MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_RF_BAND in valid_flags is set.
     */
    uint8_t rf_band;
    /**
     * State of jamming in this band. A value of enum mip_gnss_data_jamming_state. Valid if
     * MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_JAMMING_STATE in valid_flags is set.
     */
    uint8_t jamming_state;
    /**
     * State of spoofing in this band. A value of enum mip_gnss_data_spoofing_state. Valid if
     * MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_SPOOFING_STATE in valid_flags is set.
     */
    uint8_t spoofing_state;
    /**
     * Centre frequency of the band. Unit: MHz. Valid if
     * MIP_GNSS_DATA_RF_ERROR_DETECTION_FLAGS_FREQUENCY in valid_flags is set.
     */
    uint16_t frequency;
    /** Reserved. */
    uint8_t reserved[2];
    /** Validity flags for the detection. */
    mip_gnss_data_rf_error_detection_flags valid_flags;
};

#define MIP_GNSS_DATA_RF_ERROR_DETECTION(descriptor_set) MIP_KEY(descriptor_set, 0x14)
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_DESCRIPTOR 0x14
MIP_FIELD(mip_gnss_data_rf_error_detection, 0x14);

/**
 * GNSS heading: data 0x15.
 *
 * Heading that the receiver computes from its antennas.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Known only from the MicroStrain MIP SDK.
 * Uncertain: The SDK names no device that sends it.
 *
 * - mip-sdk-4: Heading (0x81,0x15)
 */
struct mip_gnss_data_heading {
    /**
     * Heading of the baseline between the antennas, from true north. Unit: deg. Frame: ned.
     * Positive: clockwise seen from above. Valid if MIP_GNSS_DATA_HEADING_FLAGS_HEADING in
     * valid_flags is set. Uncertain: Clockwise from true north is usual; the SDK only states
     * degrees, and no range. Uncertain: No source states from which antenna to which the baseline
     * points. The opposite one differs by 180 degrees.
     */
    float heading;
    /**
     * Uncertainty of the heading. Unit: deg. Range: at least 0. Valid if
     * MIP_GNSS_DATA_HEADING_FLAGS_UNCERTAINTY in valid_flags is set. Uncertain: It is not known
     * whether this is one standard deviation.
     */
    float uncertainty;
    /**
     * Kind of the fix. A value of enum mip_gnss_data_heading_fix_type. Valid if
     * MIP_GNSS_DATA_HEADING_FLAGS_FIX_TYPE in valid_flags is set.
     */
    uint8_t fix_type;
    /** Validity flags for the heading. */
    mip_gnss_data_heading_flags valid_flags;
};

#define MIP_GNSS_DATA_HEADING(descriptor_set) MIP_KEY(descriptor_set, 0x15)
#define MIP_GNSS_DATA_HEADING_DESCRIPTOR 0x15
MIP_FIELD(mip_gnss_data_heading, 0x15);

/**
 * Satellite status: data 0x20.
 *
 * Direction to one satellite, and its health.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * An epoch is sent as one field for each satellite; `index` and `count` number the fields.
 *
 * - 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20)
 * - 3dm-cv7-gnss-ins: Satellite Status (0x92,0x20)
 * - 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
 */
struct mip_gnss_data_satellite_status {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_WEEK_NUMBER in
     * valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Constellation. A value of enum mip_gnss_constellation. Valid if
     * MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_GNSS_ID in valid_flags is set.
     */
    uint8_t gnss_id;
    /**
     * Satellite within the constellation. Valid if
     * MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_SATELLITE_ID in valid_flags is set.
     */
    uint8_t satellite_id;
    /**
     * Angle between the horizon and the satellite, seen from the rover. Unit: deg. Frame: ned.
     * Range: -90 to 90. Positive: above the horizon. Valid if
     * MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_ELEVATION in valid_flags is set.
     */
    float elevation;
    /**
     * Direction of the satellite from the rover, from true north. Unit: deg. Frame: ned. Positive:
     * clockwise seen from above. Valid if MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_AZIMUTH in
     * valid_flags is set.
     */
    float azimuth;
    /**
     * True if the satellite is healthy. Valid if MIP_GNSS_DATA_SATELLITE_STATUS_FLAGS_HEALTH in
     * valid_flags is set.
     */
    mip_bool health;
    /** Validity flags for the satellite status. */
    mip_gnss_data_satellite_status_flags valid_flags;
};

#define MIP_GNSS_DATA_SATELLITE_STATUS(descriptor_set) MIP_KEY(descriptor_set, 0x20)
#define MIP_GNSS_DATA_SATELLITE_STATUS_DESCRIPTOR 0x20
MIP_FIELD(mip_gnss_data_satellite_status, 0x20);

/**
 * Raw: data 0x22.
 *
 * Raw observation of one signal of one satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * An epoch is sent as one field for each signal; `index` and `count` number the fields.
 *
 * The greatest lock time depends on the receiver.
 *
 * - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
 * - 3dm-cv7-gnss-ins: Raw (0x92,0x22)
 */
struct mip_gnss_data_raw {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_RAW_FLAGS_WEEK_NUMBER in valid_flags is
     * set.
     */
    uint16_t week_number;
    /**
     * Receiver, counted from 1; for a measurement from RTCM, the reference station. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_RECEIVER_ID in valid_flags is set.
     */
    uint16_t receiver_id;
    /**
     * Channel that tracks the satellite. Valid if MIP_GNSS_DATA_RAW_FLAGS_TRACKING_CHANNEL in
     * valid_flags is set.
     */
    uint8_t tracking_channel;
    /**
     * Constellation. A value of enum mip_gnss_constellation. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_GNSS_ID in valid_flags is set.
     */
    uint8_t gnss_id;
    /**
     * Satellite within the constellation. Valid if MIP_GNSS_DATA_RAW_FLAGS_SATELLITE_ID in
     * valid_flags is set.
     */
    uint8_t satellite_id;
    /**
     * Signal of the satellite that was tracked. A value of enum mip_gnss_signal. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_SIGNAL_ID in valid_flags is set.
     */
    uint8_t signal_id;
    /**
     * Carrier to noise density ratio. Unit: dB-Hz. Valid if MIP_GNSS_DATA_RAW_FLAGS_SIGNAL_STRENGTH
     * in valid_flags is set.
     */
    float signal_strength;
    /**
     * Tracking quality of the signal. A value of enum mip_gnss_data_signal_quality. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_QUALITY in valid_flags is set.
     */
    uint8_t quality;
    /**
     * Measured distance, with the clock errors of receiver and satellite. Unit: m. Range: at least
     * 0. Valid if MIP_GNSS_DATA_RAW_FLAGS_PSEUDORANGE in valid_flags is set.
     */
    double pseudorange;
    /**
     * Accumulated phase of the carrier; its initial number of cycles is arbitrary. Unit: cycle.
     * Valid if MIP_GNSS_DATA_RAW_FLAGS_CARRIER_PHASE in valid_flags is set.
     */
    double carrier_phase;
    /** Doppler shift. Unit: Hz. Valid if MIP_GNSS_DATA_RAW_FLAGS_DOPPLER in valid_flags is set. */
    float doppler;
    /**
     * Uncertainty of the pseudorange. Unit: m. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_RANGE_UNCERTAINTY in valid_flags is set.
     */
    float range_uncertainty;
    /**
     * Uncertainty of the carrier phase. Unit: cycle. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_CARRIER_PHASE_UNCERTAINTY in valid_flags is set.
     */
    float phase_uncertainty;
    /**
     * Uncertainty of the Doppler shift. Unit: Hz. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RAW_FLAGS_DOPPLER_UNCERTAINTY in valid_flags is set.
     */
    float doppler_uncertainty;
    /**
     * Minimum time for which the carrier phase has been locked. Unit: s. Range: at least 0. Valid
     * if MIP_GNSS_DATA_RAW_FLAGS_LOCK_TIME in valid_flags is set.
     */
    float lock_time;
    /** Validity flags for the observation. */
    mip_gnss_data_raw_flags valid_flags;
};

#define MIP_GNSS_DATA_RAW(descriptor_set) MIP_KEY(descriptor_set, 0x22)
#define MIP_GNSS_DATA_RAW_DESCRIPTOR 0x22
MIP_FIELD(mip_gnss_data_raw, 0x22);

/**
 * Base station info: data 0x30.
 *
 * Base station that sends the corrections, from RTCM message 1005 or 1006.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - mip-sdk-4: Base Station Info (0x81,0x30)
 * - 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30)
 */
struct mip_gnss_data_base_station_info {
    /**
     * GPS time of week at which the message was received. Unit: s. Range: at least 0, less than
     * 604800. Valid if MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_WEEK_NUMBER in
     * valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Position of the station. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
     * MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_ECEF_POSITION in valid_flags is set.
     */
    double ecef_position[3];
    /**
     * Height of the antenna above the surveyed marker. Unit: m. Valid if
     * MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_HEIGHT in valid_flags is set.
     */
    float height;
    /**
     * Number of the station. Range: 0 to 4095. Valid if
     * MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_STATION_ID in valid_flags is set.
     */
    uint16_t station_id;
    /**
     * Properties of the station. Valid if MIP_GNSS_DATA_BASE_STATION_INFO_FLAGS_INDICATORS in
     * valid_flags is set.
     */
    mip_gnss_data_base_station_indicators indicators;
    /** Valid values. */
    mip_gnss_data_base_station_info_flags valid_flags;
};

#define MIP_GNSS_DATA_BASE_STATION_INFO(descriptor_set) MIP_KEY(descriptor_set, 0x30)
#define MIP_GNSS_DATA_BASE_STATION_INFO_DESCRIPTOR 0x30
MIP_FIELD(mip_gnss_data_base_station_info, 0x30);

/**
 * RTK corrections status: data 0x31.
 *
 * Received corrections and their age.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * - mip-sdk-4: Rtk Corrections Status (0x81,0x31)
 * - 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31)
 */
struct mip_gnss_data_rtk_corrections_status {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_WEEK_NUMBER
     * in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Corrections received during this epoch. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_EPOCH_STATUS in valid_flags is set.
     */
    mip_gnss_data_rtk_epoch_status epoch_status;
    /**
     * Status flags of the RTK dongle, meaningful only if one is connected. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_DONGLE_STATUS in valid_flags is set.
     *
     * The same word as in the response to mip_rtk_get_status_flags, in one of its two forms.
     */
    mip_rtk_status_flags dongle_status;
    /**
     * Latency of the last GPS correction. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GPS_LATENCY in valid_flags is set.
     */
    float gps_correction_latency;
    /**
     * Latency of the last GLONASS correction. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GLONASS_LATENCY in valid_flags is set.
     */
    float glonass_correction_latency;
    /**
     * Latency of the last Galileo correction. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_GALILEO_LATENCY in valid_flags is set.
     */
    float galileo_correction_latency;
    /**
     * Latency of the last BeiDou correction. Unit: s. Range: at least 0. Valid if
     * MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_FLAGS_BEIDOU_LATENCY in valid_flags is set.
     */
    float beidou_correction_latency;
    /** Reserved. */
    uint32_t reserved[4];
    /** Valid values. */
    mip_gnss_data_rtk_corrections_status_flags valid_flags;
};

#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS(descriptor_set) MIP_KEY(descriptor_set, 0x31)
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_DESCRIPTOR 0x31
MIP_FIELD(mip_gnss_data_rtk_corrections_status, 0x31);

/**
 * GPS ephemeris: data 0x61.
 *
 * Broadcast orbit and clock of one GPS satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * `iodc` changes with the clock data; according to the manual, it rolls over at 4.
 *
 * - 3dm-cv7-gnss-ins: GPS Ephemeris (0x91,0x61)
 * - 3dm-cv7-gnss-ins: GPS Ephemeris (0x92,0x61)
 */
struct mip_gnss_data_gps_ephemeris {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number. Unit: week. */
    uint16_t week_number;
    /** Satellite within the constellation. */
    uint8_t satellite_id;
    /**
     * Health of satellite and signals. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    uint8_t health;
    /**
     * Issue of data, clock. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t iodc;
    /**
     * Issue of data, ephemeris. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is
     * set.
     */
    uint8_t iode;
    /**
     * Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_oc;
    /**
     * Clock bias. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double af0;
    /**
     * Clock drift. Unit: s/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is
     * set.
     */
    double af1;
    /**
     * Clock drift rate. Unit: s/s^2. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double af2;
    /**
     * Group delay. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_gd;
    /**
     * Inter-signal correction for L1. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double isc_l1ca;
    /**
     * Inter-signal correction for L2, or for L5 if `isc_l5` is set. Unit: s. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double isc_l2c;
    /**
     * Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_oe;
    /**
     * Semi-major axis. Unit: m. Range: greater than 0. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double a;
    /**
     * Rate of the semi-major axis. Unit: m/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double a_dot;
    /**
     * Mean anomaly at the reference time. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double mean_anomaly;
    /**
     * Correction of the mean motion. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    double delta_mean_motion;
    /**
     * Rate of the correction of the mean motion. Unit: rad/s^2. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double delta_mean_motion_dot;
    /**
     * Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double eccentricity;
    /**
     * Angle from the ascending node to the perigee. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double argument_of_perigee;
    /**
     * Longitude of the ascending node. Unit: rad. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    double omega;
    /**
     * Rate of the right ascension. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double omega_dot;
    /**
     * Inclination of the orbit at the reference time. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double inclination;
    /**
     * Rate of the inclination. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double inclination_dot;
    /**
     * Cosine harmonic correction of the inclination. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_ic;
    /**
     * Sine harmonic correction of the inclination. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_is;
    /**
     * Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_uc;
    /**
     * Sine harmonic correction of the argument of latitude. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_us;
    /**
     * Cosine harmonic correction of the orbit radius. Unit: m. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_rc;
    /**
     * Sine harmonic correction of the orbit radius. Unit: m. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_rs;
    /** Contents of the ephemeris. */
    mip_gnss_data_ephemeris_flags valid_flags;
};

#define MIP_GNSS_DATA_GPS_EPHEMERIS(descriptor_set) MIP_KEY(descriptor_set, 0x61)
#define MIP_GNSS_DATA_GPS_EPHEMERIS_DESCRIPTOR 0x61
MIP_FIELD(mip_gnss_data_gps_ephemeris, 0x61);

/**
 * GLONASS ephemeris: data 0x62.
 *
 * Broadcast orbit and clock of one GLONASS satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `glo_ephemeris`.
 *
 * The GLONASS interface control document explains p and ft.
 *
 * A period of four years has 1461 days; no source states how nt, a u8, counts them.
 *
 * - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x91,0x62)
 * - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x92,0x62)
 */
struct mip_gnss_data_glonass_ephemeris {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number. Unit: week. */
    uint16_t week_number;
    /** Satellite within the constellation. */
    uint8_t satellite_id;
    /**
     * GLONASS frequency number. Range: -7 to 24. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    int8_t frequency_number;
    /**
     * Start of the frame within the day. Unit: s. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint32_t tk;
    /**
     * Reference time of the ephemeris. Unit: s. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint32_t tb;
    /**
     * Generation of the satellite (M). A value of enum mip_gnss_data_glonass_satellite_type. Valid
     * if MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t satellite_type;
    /**
     * Relative deviation of the carrier frequency from its nominal value. Unit: 1. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double gamma;
    /**
     * Correction of the satellite time relative to GLONASS time. Unit: s. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double tau_n;
    /**
     * Position of the satellite in PZ-90. Elements: x, y, z. Unit: m. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double position[3];
    /**
     * Velocity of the satellite in PZ-90. Elements: x, y, z. Unit: m/s. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    float velocity[3];
    /**
     * Acceleration of the satellite due to perturbations, in PZ-90. Elements: x, y, z. Unit: m/s^2.
     * Valid if MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    float accel[3];
    /**
     * Health (Bn); nonzero if the satellite is malfunctioning. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t health;
    /**
     * Mode of operation of the satellite. Valid if MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    uint8_t p;
    /**
     * Day within a period of four years. Unit: day. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t nt;
    /**
     * Time difference between L1 and L2. Unit: s. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    float delta_tau_n;
    /**
     * Code of the user range accuracy. Valid if MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    uint8_t ft;
    /**
     * Age of the information. Unit: day. Valid if MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    uint8_t en;
    /**
     * Time between adjacent values of tb. Unit: min. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t p1;
    /**
     * 1 if tb is odd, 0 if it is even. Range: 0 to 1. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t p2;
    /**
     * Number of satellites in the almanac of the frame. Unit: 1. Valid if
     * MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t p3;
    /**
     * Presence of ephemeris parameters. Valid if MIP_GNSS_DATA_GLONASS_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    uint8_t p4;
    /** Validity of the ephemeris. */
    mip_gnss_data_glonass_ephemeris_flags valid_flags;
};

#define MIP_GNSS_DATA_GLONASS_EPHEMERIS(descriptor_set) MIP_KEY(descriptor_set, 0x62)
#define MIP_GNSS_DATA_GLONASS_EPHEMERIS_DESCRIPTOR 0x62
MIP_FIELD(mip_gnss_data_glonass_ephemeris, 0x62);

/**
 * Galileo ephemeris: data 0x63.
 *
 * Broadcast orbit and clock of one Galileo satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * It has the layout of the GPS ephemeris. No source states what the two inter-signal corrections
 * mean here.
 *
 * `iodc` changes with the clock data; according to the manual, it rolls over at 4.
 *
 * - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x91,0x63)
 * - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x92,0x63)
 */
struct mip_gnss_data_galileo_ephemeris {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number. Unit: week. */
    uint16_t week_number;
    /** Satellite within the constellation. */
    uint8_t satellite_id;
    /**
     * Health of satellite and signals. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    uint8_t health;
    /**
     * Issue of data, clock. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t iodc;
    /**
     * Issue of data, ephemeris. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is
     * set.
     */
    uint8_t iode;
    /**
     * Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_oc;
    /**
     * Clock bias. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double af0;
    /**
     * Clock drift. Unit: s/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is
     * set.
     */
    double af1;
    /**
     * Clock drift rate. Unit: s/s^2. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double af2;
    /**
     * Group delay. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_gd;
    /**
     * Value in the position of the GPS inter-signal correction for L1. Unit: s. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double isc_l1ca;
    /**
     * Value in the position of the GPS inter-signal correction for L2 or L5. Unit: s. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double isc_l2c;
    /**
     * Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_oe;
    /**
     * Semi-major axis. Unit: m. Range: greater than 0. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double a;
    /**
     * Rate of the semi-major axis. Unit: m/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double a_dot;
    /**
     * Mean anomaly at the reference time. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double mean_anomaly;
    /**
     * Correction of the mean motion. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    double delta_mean_motion;
    /**
     * Rate of the correction of the mean motion. Unit: rad/s^2. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double delta_mean_motion_dot;
    /**
     * Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double eccentricity;
    /**
     * Angle from the ascending node to the perigee. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double argument_of_perigee;
    /**
     * Longitude of the ascending node. Unit: rad. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    double omega;
    /**
     * Rate of the right ascension. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double omega_dot;
    /**
     * Inclination of the orbit at the reference time. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double inclination;
    /**
     * Rate of the inclination. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double inclination_dot;
    /**
     * Cosine harmonic correction of the inclination. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_ic;
    /**
     * Sine harmonic correction of the inclination. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_is;
    /**
     * Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_uc;
    /**
     * Sine harmonic correction of the argument of latitude. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_us;
    /**
     * Cosine harmonic correction of the orbit radius. Unit: m. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_rc;
    /**
     * Sine harmonic correction of the orbit radius. Unit: m. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_rs;
    /** Contents of the ephemeris. */
    mip_gnss_data_ephemeris_flags valid_flags;
};

#define MIP_GNSS_DATA_GALILEO_EPHEMERIS(descriptor_set) MIP_KEY(descriptor_set, 0x63)
#define MIP_GNSS_DATA_GALILEO_EPHEMERIS_DESCRIPTOR 0x63
MIP_FIELD(mip_gnss_data_galileo_ephemeris, 0x63);

/**
 * BeiDou ephemeris: data 0x64.
 *
 * Broadcast orbit and clock of one BeiDou satellite.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET.
 *
 * It has the layout of the GPS ephemeris. No source states what the two inter-signal corrections
 * mean here.
 *
 * `iodc` changes with the clock data; according to the manual, it rolls over at 4.
 *
 * - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x91,0x64)
 * - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x92,0x64)
 */
struct mip_gnss_data_beidou_ephemeris {
    /** Index of this field within the epoch. */
    uint8_t index;
    /** Number of such fields in the epoch. */
    uint8_t count;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number. Unit: week. */
    uint16_t week_number;
    /** Satellite within the constellation. */
    uint8_t satellite_id;
    /**
     * Health of satellite and signals. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    uint8_t health;
    /**
     * Issue of data, clock. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    uint8_t iodc;
    /**
     * Issue of data, ephemeris. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is
     * set.
     */
    uint8_t iode;
    /**
     * Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_oc;
    /**
     * Clock bias. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double af0;
    /**
     * Clock drift. Unit: s/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is
     * set.
     */
    double af1;
    /**
     * Clock drift rate. Unit: s/s^2. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double af2;
    /**
     * Group delay. Unit: s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_gd;
    /**
     * Value in the position of the GPS inter-signal correction for L1. Unit: s. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double isc_l1ca;
    /**
     * Value in the position of the GPS inter-signal correction for L2 or L5. Unit: s. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double isc_l2c;
    /**
     * Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double t_oe;
    /**
     * Semi-major axis. Unit: m. Range: greater than 0. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double a;
    /**
     * Rate of the semi-major axis. Unit: m/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double a_dot;
    /**
     * Mean anomaly at the reference time. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double mean_anomaly;
    /**
     * Correction of the mean motion. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    double delta_mean_motion;
    /**
     * Rate of the correction of the mean motion. Unit: rad/s^2. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double delta_mean_motion_dot;
    /**
     * Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double eccentricity;
    /**
     * Angle from the ascending node to the perigee. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double argument_of_perigee;
    /**
     * Longitude of the ascending node. Unit: rad. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS
     * in valid_flags is set.
     */
    double omega;
    /**
     * Rate of the right ascension. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double omega_dot;
    /**
     * Inclination of the orbit at the reference time. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double inclination;
    /**
     * Rate of the inclination. Unit: rad/s. Valid if MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in
     * valid_flags is set.
     */
    double inclination_dot;
    /**
     * Cosine harmonic correction of the inclination. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_ic;
    /**
     * Sine harmonic correction of the inclination. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_is;
    /**
     * Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_uc;
    /**
     * Sine harmonic correction of the argument of latitude. Unit: rad. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_us;
    /**
     * Cosine harmonic correction of the orbit radius. Unit: m. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_rc;
    /**
     * Sine harmonic correction of the orbit radius. Unit: m. Valid if
     * MIP_GNSS_DATA_EPHEMERIS_FLAGS_EPHEMERIS in valid_flags is set.
     */
    double c_rs;
    /** Contents of the ephemeris. */
    mip_gnss_data_ephemeris_flags valid_flags;
};

#define MIP_GNSS_DATA_BEIDOU_EPHEMERIS(descriptor_set) MIP_KEY(descriptor_set, 0x64)
#define MIP_GNSS_DATA_BEIDOU_EPHEMERIS_DESCRIPTOR 0x64
MIP_FIELD(mip_gnss_data_beidou_ephemeris, 0x64);

/**
 * GPS ionospheric correction: data 0x71.
 *
 * Ionospheric model that GPS broadcasts.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `gps_iono_corr`. Known only from
 * the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gps Iono Corr (0x81,0x71)
 */
struct mip_gnss_data_gps_iono_correction {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_WEEK_NUMBER in
     * valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Coefficients alpha 0 to 3. Valid if MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_ALPHA in
     * valid_flags is set. Uncertain: No source states the units.
     */
    double alpha[4];
    /**
     * Coefficients beta 0 to 3. Valid if MIP_GNSS_DATA_GPS_IONO_CORRECTION_FLAGS_BETA in
     * valid_flags is set. Uncertain: No source states the units.
     */
    double beta[4];
    /** Validity flags for the model. */
    mip_gnss_data_gps_iono_correction_flags valid_flags;
};

#define MIP_GNSS_DATA_GPS_IONO_CORRECTION(descriptor_set) MIP_KEY(descriptor_set, 0x71)
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_DESCRIPTOR 0x71
MIP_FIELD(mip_gnss_data_gps_iono_correction, 0x71);

/**
 * Galileo ionospheric correction: data 0x73.
 *
 * Ionospheric model that Galileo broadcasts.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `galileo_iono_corr`. Known only
 * from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Galileo Iono Corr (0x81,0x73)
 */
struct mip_gnss_data_galileo_iono_correction {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_WEEK_NUMBER
     * in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * The three coefficients of the model. Valid if
     * MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_ALPHA in valid_flags is set. Uncertain: No source
     * states the units.
     */
    double alpha[3];
    /**
     * Ionospheric storms, one bit (1 to 5) for each of five regions. Valid if
     * MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_FLAGS_DISTURBANCE_FLAGS in valid_flags is set.
     * Uncertain: No source states whether the bits count from 0 or from 1, or the region of each.
     */
    uint8_t disturbance_flags;
    /** Validity flags for the model. */
    mip_gnss_data_galileo_iono_correction_flags valid_flags;
};

#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION(descriptor_set) MIP_KEY(descriptor_set, 0x73)
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_DESCRIPTOR 0x73
MIP_FIELD(mip_gnss_data_galileo_iono_correction, 0x73);

/**
 * BeiDou ionospheric correction: data 0x74.
 *
 * Ionospheric model that BeiDou broadcasts.
 *
 * Occurs in MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Also called `beidou_iono_corr`. Known only
 * from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Beidou Iono Corr (0x81,0x74)
 */
struct mip_gnss_data_beidou_iono_correction {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_WEEK_NUMBER
     * in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Coefficients alpha 0 to 3. Valid if MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_ALPHA in
     * valid_flags is set. Uncertain: No source states the units.
     */
    double alpha[4];
    /**
     * Coefficients beta 0 to 3. Valid if MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_BETA in
     * valid_flags is set. Uncertain: No source states the units.
     */
    double beta[4];
    /**
     * Nine further coefficients of the delay. Valid if
     * MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_FLAGS_ALPHA_CORRECTION in valid_flags is set. Uncertain:
     * No source states the units.
     */
    double alpha_correction[9];
    /** Validity flags for the model. */
    mip_gnss_data_beidou_iono_correction_flags valid_flags;
};

#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION(descriptor_set) MIP_KEY(descriptor_set, 0x74)
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_DESCRIPTOR 0x74
MIP_FIELD(mip_gnss_data_beidou_iono_correction, 0x74);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
