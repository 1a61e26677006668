/**
 * @file
 *
 * GNSS corrections data (0x93). What the device receives of RTK corrections. Data are sent as they
 * are received.
 */
#ifndef MIP_GNSS_CORRECTIONS_H
#define MIP_GNSS_CORRECTIONS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/gnss_corrections.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_GNSS_CORRECTIONS_SET 0x93

/** Properties of a base station, as its RTCM message gives them. */
typedef uint16_t mip_gnss_corrections_base_station_indicators;
/** Bit 0. GPS is supported. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_GPS 0x0001U
/** Bit 1. GLONASS is supported. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_GLONASS 0x0002U
/** Bit 2. Galileo is supported. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_GALILEO 0x0004U
/** Bit 3. BeiDou is supported. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_BEIDOU 0x0008U
/** Bit 4. Reference station indicator. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_REF_STATION 0x0010U
/** Bit 5. Single receiver oscillator indicator. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_SINGLE_RECEIVER 0x0020U
/** Bit 6. First bit of the quarter cycle indicator. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_QUARTER_CYCLE_BIT1 0x0040U
/** Bit 7. Second bit of the quarter cycle indicator. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_QUARTER_CYCLE_BIT2 0x0080U
/** Bits 6 to 7. Quarter cycle indicator. Overlaps other bits. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INDICATORS_QUARTER_CYCLE_BITS 0x00C0U

/** Which values are valid. */
typedef uint16_t mip_gnss_corrections_base_station_info_flags;
/** Bit 0. Time of week. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_TOW 0x0001U
/** Bit 1. Week number. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. Position. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_ECEF_POSITION 0x0004U
/** Bit 3. Antenna height. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_HEIGHT 0x0008U
/** Bit 4. Station. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_STATION_ID 0x0010U
/** Bit 5. Indicators. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_INDICATORS 0x0020U
/** Bits 0 to 5. All of them. Overlaps other bits. */
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_FLAGS 0x003FU

/** Corrections that came during an epoch. */
typedef uint16_t mip_gnss_corrections_rtk_epoch_status;
/** Bit 0. Antenna location. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_ANTENNA_LOCATION_RECEIVED 0x0001U
/** Bit 1. Antenna description. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_ANTENNA_DESCRIPTION_RECEIVED 0x0002U
/** Bit 2. GPS corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_GPS_RECEIVED 0x0004U
/** Bit 3. GLONASS corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_GLONASS_RECEIVED 0x0008U
/** Bit 4. Galileo corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_GALILEO_RECEIVED 0x0010U
/** Bit 5. BeiDou corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_BEIDOU_RECEIVED 0x0020U
/** Bit 6. GPS corrections come in MSM messages, not in the RTCM messages 1001-1004. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_USING_GPS_MSM_MESSAGES 0x0040U
/** Bit 7. GLONASS corrections come in MSM messages, not in the RTCM messages 1009-1012. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_USING_GLONASS_MSM_MESSAGES 0x0080U
/** Bit 8. The status of the dongle could not be read. */
#define MIP_GNSS_CORRECTIONS_RTK_EPOCH_STATUS_DONGLE_STATUS_READ_FAILED 0x0100U

/** Which values are valid. */
typedef uint16_t mip_gnss_corrections_rtk_corrections_status_flags;
/** Bit 0. Time of week. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_TOW 0x0001U
/** Bit 1. Week number. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_WEEK_NUMBER 0x0002U
/** Bit 2. Epoch status. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_EPOCH_STATUS 0x0004U
/** Bit 3. Status of the dongle. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_DONGLE_STATUS 0x0008U
/** Bit 4. Latency of GPS corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_GPS_LATENCY 0x0010U
/** Bit 5. Latency of GLONASS corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_GLONASS_LATENCY 0x0020U
/** Bit 6. Latency of Galileo corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_GALILEO_LATENCY 0x0040U
/** Bit 7. Latency of BeiDou corrections. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_BEIDOU_LATENCY 0x0080U
/** Bits 0 to 7. All of them. Overlaps other bits. */
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_FLAGS 0x00FFU

/**
 * Base station info: data (0x93,0x30).
 *
 * The base station of the corrections, from an RTCM message 1005 or 1006.
 *
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30)
 */
struct mip_gnss_corrections_base_station_info {
    /**
     * GPS time of week at which the message was received. Unit: s. Valid if
     * MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_TOW in valid_flags is set.
     */
    double time_of_week;
    /**
     * GPS week number. Unit: week. Valid if
     * MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_WEEK_NUMBER in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Position of the station. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
     * MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_ECEF_POSITION in valid_flags is set.
     */
    double ecef_pos[3];
    /**
     * Height of the antenna above the marker that was surveyed. Unit: m. Valid if
     * MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_HEIGHT in valid_flags is set.
     */
    float height;
    /**
     * Number of the station. Range: 0 to 4095. Valid if
     * MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_STATION_ID in valid_flags is set.
     */
    uint16_t station_id;
    /**
     * Properties of the station. Valid if MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_FLAGS_INDICATORS
     * in valid_flags is set.
     */
    mip_gnss_corrections_base_station_indicators indicators;
    /** Which values are valid. */
    mip_gnss_corrections_base_station_info_flags valid_flags;
};

#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_DESCRIPTOR 0x30
#define MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_NAME "gnss_corrections.base_station_info"

extern const struct mip_codec mip_gnss_corrections_base_station_info_codec;
mip_error mip_gnss_corrections_base_station_info_decode(
    struct mip_gnss_corrections_base_station_info *value, const struct mip_field *field);
mip_error mip_gnss_corrections_base_station_info_encode(
    const struct mip_gnss_corrections_base_station_info *value, struct mip_builder *builder);

/**
 * RTK corrections status: data (0x93,0x31).
 *
 * Which corrections come, and how old they are.
 *
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31)
 */
struct mip_gnss_corrections_rtk_corrections_status {
    /**
     * GPS time of week. Unit: s. Valid if MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_TOW in
     * valid_flags is set.
     */
    double time_of_week;
    /**
     * GPS week number. Unit: week. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_WEEK_NUMBER in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * Corrections that came during this epoch. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_EPOCH_STATUS in valid_flags is set.
     */
    mip_gnss_corrections_rtk_epoch_status epoch_status;
    /**
     * Status flags of the RTK dongle; of use only with a dongle. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_DONGLE_STATUS in valid_flags is set.
     *
     * The manual does not define the flags.
     */
    uint32_t dongle_status;
    /**
     * Latency of the last GPS correction. Unit: s. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_GPS_LATENCY in valid_flags is set.
     */
    float gps_correction_latency;
    /**
     * Latency of the last GLONASS correction. Unit: s. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_GLONASS_LATENCY in valid_flags is set.
     */
    float glonass_correction_latency;
    /**
     * Latency of the last Galileo correction. Unit: s. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_GALILEO_LATENCY in valid_flags is set.
     */
    float galileo_correction_latency;
    /**
     * Latency of the last BeiDou correction. Unit: s. Valid if
     * MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_FLAGS_BEIDOU_LATENCY in valid_flags is set.
     */
    float beidou_correction_latency;
    /** Reserved. */
    uint32_t reserved[4];
    /** Which values are valid. */
    mip_gnss_corrections_rtk_corrections_status_flags valid_flags;
};

#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_DESCRIPTOR 0x31
#define MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_NAME "gnss_corrections.rtk_corrections_status"

extern const struct mip_codec mip_gnss_corrections_rtk_corrections_status_codec;
mip_error mip_gnss_corrections_rtk_corrections_status_decode(
    struct mip_gnss_corrections_rtk_corrections_status *value, const struct mip_field *field);
mip_error mip_gnss_corrections_rtk_corrections_status_encode(
    const struct mip_gnss_corrections_rtk_corrections_status *value, struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
