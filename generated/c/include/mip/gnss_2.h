/**
 * @file
 *
 * GNSS receiver 2 data (0x92). Measurements and status of the second internal GNSS receiver.
 */
#ifndef MIP_GNSS_2_H
#define MIP_GNSS_2_H

#include "mip/protocol.h"
#include "mip/gnss_1.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/gnss_2.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_GNSS_2_SET 0x92

/**
 * GNSS LLH position: data (0x92,0x03).
 *
 * GNSS position as latitude, longitude and height.
 *
 * Has the layout of mip_gnss_1_gnss_llh_position. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x92,0x03)
 */
#define mip_gnss_2_gnss_llh_position mip_gnss_1_gnss_llh_position
#define mip_gnss_2_gnss_llh_position_codec mip_gnss_1_gnss_llh_position_codec
#define mip_gnss_2_gnss_llh_position_decode mip_gnss_1_gnss_llh_position_decode
#define mip_gnss_2_gnss_llh_position_encode mip_gnss_1_gnss_llh_position_encode
#define MIP_GNSS_2_GNSS_LLH_POSITION_DESCRIPTOR 0x03
#define MIP_GNSS_2_GNSS_LLH_POSITION_NAME "gnss_2.gnss_llh_position"

/**
 * GNSS ECEF position: data (0x92,0x04).
 *
 * GNSS position in Earth-fixed coordinates.
 *
 * Has the layout of mip_gnss_1_gnss_ecef_position. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x92,0x04)
 */
#define mip_gnss_2_gnss_ecef_position mip_gnss_1_gnss_ecef_position
#define mip_gnss_2_gnss_ecef_position_codec mip_gnss_1_gnss_ecef_position_codec
#define mip_gnss_2_gnss_ecef_position_decode mip_gnss_1_gnss_ecef_position_decode
#define mip_gnss_2_gnss_ecef_position_encode mip_gnss_1_gnss_ecef_position_encode
#define MIP_GNSS_2_GNSS_ECEF_POSITION_DESCRIPTOR 0x04
#define MIP_GNSS_2_GNSS_ECEF_POSITION_NAME "gnss_2.gnss_ecef_position"

/**
 * NED velocity: data (0x92,0x05).
 *
 * GNSS velocity in the local level frame.
 *
 * Has the layout of mip_gnss_1_ned_velocity. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x92,0x05)
 */
#define mip_gnss_2_ned_velocity mip_gnss_1_ned_velocity
#define mip_gnss_2_ned_velocity_codec mip_gnss_1_ned_velocity_codec
#define mip_gnss_2_ned_velocity_decode mip_gnss_1_ned_velocity_decode
#define mip_gnss_2_ned_velocity_encode mip_gnss_1_ned_velocity_encode
#define MIP_GNSS_2_NED_VELOCITY_DESCRIPTOR 0x05
#define MIP_GNSS_2_NED_VELOCITY_NAME "gnss_2.ned_velocity"

/**
 * GNSS ECEF velocity: data (0x92,0x06).
 *
 * GNSS velocity in Earth-fixed coordinates.
 *
 * Has the layout of mip_gnss_1_gnss_ecef_velocity. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06)
 */
#define mip_gnss_2_gnss_ecef_velocity mip_gnss_1_gnss_ecef_velocity
#define mip_gnss_2_gnss_ecef_velocity_codec mip_gnss_1_gnss_ecef_velocity_codec
#define mip_gnss_2_gnss_ecef_velocity_decode mip_gnss_1_gnss_ecef_velocity_decode
#define mip_gnss_2_gnss_ecef_velocity_encode mip_gnss_1_gnss_ecef_velocity_encode
#define MIP_GNSS_2_GNSS_ECEF_VELOCITY_DESCRIPTOR 0x06
#define MIP_GNSS_2_GNSS_ECEF_VELOCITY_NAME "gnss_2.gnss_ecef_velocity"

/**
 * DOP: data (0x92,0x07).
 *
 * Dilution of precision of the satellite geometry.
 *
 * Has the layout of mip_gnss_1_dop. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: DOP (0x92,0x07)
 */
#define mip_gnss_2_dop mip_gnss_1_dop
#define mip_gnss_2_dop_codec mip_gnss_1_dop_codec
#define mip_gnss_2_dop_decode mip_gnss_1_dop_decode
#define mip_gnss_2_dop_encode mip_gnss_1_dop_encode
#define MIP_GNSS_2_DOP_DESCRIPTOR 0x07
#define MIP_GNSS_2_DOP_NAME "gnss_2.dop"

/**
 * UTC time: data (0x92,0x08).
 *
 * Coordinated universal time as the receiver knows it.
 *
 * Has the layout of mip_gnss_1_utc_time. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: UTC Time (0x92,0x08)
 */
#define mip_gnss_2_utc_time mip_gnss_1_utc_time
#define mip_gnss_2_utc_time_codec mip_gnss_1_utc_time_codec
#define mip_gnss_2_utc_time_decode mip_gnss_1_utc_time_decode
#define mip_gnss_2_utc_time_encode mip_gnss_1_utc_time_encode
#define MIP_GNSS_2_UTC_TIME_DESCRIPTOR 0x08
#define MIP_GNSS_2_UTC_TIME_NAME "gnss_2.utc_time"

/**
 * GPS time: data (0x92,0x09).
 *
 * GPS time as the receiver knows it.
 *
 * Has the layout of mip_gnss_1_gps_time. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GPS Time (0x92,0x09)
 */
#define mip_gnss_2_gps_time mip_gnss_1_gps_time
#define mip_gnss_2_gps_time_codec mip_gnss_1_gps_time_codec
#define mip_gnss_2_gps_time_decode mip_gnss_1_gps_time_decode
#define mip_gnss_2_gps_time_encode mip_gnss_1_gps_time_encode
#define MIP_GNSS_2_GPS_TIME_DESCRIPTOR 0x09
#define MIP_GNSS_2_GPS_TIME_NAME "gnss_2.gps_time"

/**
 * Fix info: data (0x92,0x0B).
 *
 * Type of the position fix and what it is made of.
 *
 * Has the layout of mip_gnss_1_fix_info. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B)
 */
#define mip_gnss_2_fix_info mip_gnss_1_fix_info
#define mip_gnss_2_fix_info_codec mip_gnss_1_fix_info_codec
#define mip_gnss_2_fix_info_decode mip_gnss_1_fix_info_decode
#define mip_gnss_2_fix_info_encode mip_gnss_1_fix_info_encode
#define MIP_GNSS_2_FIX_INFO_DESCRIPTOR 0x0B
#define MIP_GNSS_2_FIX_INFO_NAME "gnss_2.fix_info"

/**
 * GNSS hardware status: data (0x92,0x0D).
 *
 * State of the receiver and of its antenna.
 *
 * Has the layout of mip_gnss_1_gnss_hardware_status. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x92,0x0D)
 */
#define mip_gnss_2_gnss_hardware_status mip_gnss_1_gnss_hardware_status
#define mip_gnss_2_gnss_hardware_status_codec mip_gnss_1_gnss_hardware_status_codec
#define mip_gnss_2_gnss_hardware_status_decode mip_gnss_1_gnss_hardware_status_decode
#define mip_gnss_2_gnss_hardware_status_encode mip_gnss_1_gnss_hardware_status_encode
#define MIP_GNSS_2_GNSS_HARDWARE_STATUS_DESCRIPTOR 0x0D
#define MIP_GNSS_2_GNSS_HARDWARE_STATUS_NAME "gnss_2.gnss_hardware_status"

/**
 * Clock info 2: data (0x92,0x10).
 *
 * Bias and drift of the receiver clock.
 *
 * Has the layout of mip_gnss_1_clock_info_2. Supported by 3DM-CV7-GNSS/INS.
 *
 * It supersedes an older field, which the manual does not define.
 *
 * - 3dm-cv7-gnss-ins: Clock Info 2 (0x92,0x10)
 */
#define mip_gnss_2_clock_info_2 mip_gnss_1_clock_info_2
#define mip_gnss_2_clock_info_2_codec mip_gnss_1_clock_info_2_codec
#define mip_gnss_2_clock_info_2_decode mip_gnss_1_clock_info_2_decode
#define mip_gnss_2_clock_info_2_encode mip_gnss_1_clock_info_2_encode
#define MIP_GNSS_2_CLOCK_INFO_2_DESCRIPTOR 0x10
#define MIP_GNSS_2_CLOCK_INFO_2_NAME "gnss_2.clock_info_2"

/**
 * GPS leap seconds: data (0x92,0x11).
 *
 * Difference between GPS time and UTC.
 *
 * Has the layout of mip_gnss_1_gps_leap_seconds. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x92,0x11)
 */
#define mip_gnss_2_gps_leap_seconds mip_gnss_1_gps_leap_seconds
#define mip_gnss_2_gps_leap_seconds_codec mip_gnss_1_gps_leap_seconds_codec
#define mip_gnss_2_gps_leap_seconds_decode mip_gnss_1_gps_leap_seconds_decode
#define mip_gnss_2_gps_leap_seconds_encode mip_gnss_1_gps_leap_seconds_encode
#define MIP_GNSS_2_GPS_LEAP_SECONDS_DESCRIPTOR 0x11
#define MIP_GNSS_2_GPS_LEAP_SECONDS_NAME "gnss_2.gps_leap_seconds"

/**
 * SBAS info: data (0x92,0x12).
 *
 * Status of the satellite based augmentation.
 *
 * Has the layout of mip_gnss_1_sbas_info. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: SBAS Info (0x92,0x12)
 */
#define mip_gnss_2_sbas_info mip_gnss_1_sbas_info
#define mip_gnss_2_sbas_info_codec mip_gnss_1_sbas_info_codec
#define mip_gnss_2_sbas_info_decode mip_gnss_1_sbas_info_decode
#define mip_gnss_2_sbas_info_encode mip_gnss_1_sbas_info_encode
#define MIP_GNSS_2_SBAS_INFO_DESCRIPTOR 0x12
#define MIP_GNSS_2_SBAS_INFO_NAME "gnss_2.sbas_info"

/**
 * Satellite status: data (0x92,0x20).
 *
 * Where one satellite stands, and its health.
 *
 * Has the layout of mip_gnss_1_satellite_status. Supported by 3DM-CV7-GNSS/INS.
 *
 * An epoch is sent as one field for each satellite; index and count number the fields.
 *
 * - 3dm-cv7-gnss-ins: Satellite Status (0x92,0x20)
 */
#define mip_gnss_2_satellite_status mip_gnss_1_satellite_status
#define mip_gnss_2_satellite_status_codec mip_gnss_1_satellite_status_codec
#define mip_gnss_2_satellite_status_decode mip_gnss_1_satellite_status_decode
#define mip_gnss_2_satellite_status_encode mip_gnss_1_satellite_status_encode
#define MIP_GNSS_2_SATELLITE_STATUS_DESCRIPTOR 0x20
#define MIP_GNSS_2_SATELLITE_STATUS_NAME "gnss_2.satellite_status"

/**
 * Raw: data (0x92,0x22).
 *
 * Raw observation of one signal of one satellite.
 *
 * Has the layout of mip_gnss_1_raw. Supported by 3DM-CV7-GNSS/INS.
 *
 * An epoch is sent as one field for each signal; index and count number the fields.
 *
 * The greatest lock time depends on the receiver.
 *
 * - 3dm-cv7-gnss-ins: Raw (0x92,0x22)
 */
#define mip_gnss_2_raw mip_gnss_1_raw
#define mip_gnss_2_raw_codec mip_gnss_1_raw_codec
#define mip_gnss_2_raw_decode mip_gnss_1_raw_decode
#define mip_gnss_2_raw_encode mip_gnss_1_raw_encode
#define MIP_GNSS_2_RAW_DESCRIPTOR 0x22
#define MIP_GNSS_2_RAW_NAME "gnss_2.raw"

/**
 * GPS ephemeris: data (0x92,0x61).
 *
 * Broadcast orbit and clock of one GPS satellite.
 *
 * Has the layout of mip_gnss_1_gps_ephemeris. Supported by 3DM-CV7-GNSS/INS.
 *
 * iodec changes with the clock data; the manual has it roll over at 4.
 *
 * - 3dm-cv7-gnss-ins: GPS Ephemeris (0x92,0x61)
 */
#define mip_gnss_2_gps_ephemeris mip_gnss_1_gps_ephemeris
#define mip_gnss_2_gps_ephemeris_codec mip_gnss_1_gps_ephemeris_codec
#define mip_gnss_2_gps_ephemeris_decode mip_gnss_1_gps_ephemeris_decode
#define mip_gnss_2_gps_ephemeris_encode mip_gnss_1_gps_ephemeris_encode
#define MIP_GNSS_2_GPS_EPHEMERIS_DESCRIPTOR 0x61
#define MIP_GNSS_2_GPS_EPHEMERIS_NAME "gnss_2.gps_ephemeris"

/**
 * GLONASS ephemeris: data (0x92,0x62).
 *
 * Broadcast orbit and clock of one GLONASS satellite.
 *
 * Has the layout of mip_gnss_1_glonass_ephemeris. Supported by 3DM-CV7-GNSS/INS.
 *
 * The interface control document of GLONASS explains p and ft.
 *
 * A period of four years has 1461 days; the manual does not say how nt, a u8, counts them.
 *
 * - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x92,0x62)
 */
#define mip_gnss_2_glonass_ephemeris mip_gnss_1_glonass_ephemeris
#define mip_gnss_2_glonass_ephemeris_codec mip_gnss_1_glonass_ephemeris_codec
#define mip_gnss_2_glonass_ephemeris_decode mip_gnss_1_glonass_ephemeris_decode
#define mip_gnss_2_glonass_ephemeris_encode mip_gnss_1_glonass_ephemeris_encode
#define MIP_GNSS_2_GLONASS_EPHEMERIS_DESCRIPTOR 0x62
#define MIP_GNSS_2_GLONASS_EPHEMERIS_NAME "gnss_2.glonass_ephemeris"

/**
 * Galileo ephemeris: data (0x92,0x63).
 *
 * Broadcast orbit and clock of one Galileo satellite.
 *
 * Has the layout of mip_gnss_1_galileo_ephemeris. Supported by 3DM-CV7-GNSS/INS.
 *
 * The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
 * corrections hold here.
 *
 * iodec changes with the clock data; the manual has it roll over at 4.
 *
 * - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x92,0x63)
 */
#define mip_gnss_2_galileo_ephemeris mip_gnss_1_galileo_ephemeris
#define mip_gnss_2_galileo_ephemeris_codec mip_gnss_1_galileo_ephemeris_codec
#define mip_gnss_2_galileo_ephemeris_decode mip_gnss_1_galileo_ephemeris_decode
#define mip_gnss_2_galileo_ephemeris_encode mip_gnss_1_galileo_ephemeris_encode
#define MIP_GNSS_2_GALILEO_EPHEMERIS_DESCRIPTOR 0x63
#define MIP_GNSS_2_GALILEO_EPHEMERIS_NAME "gnss_2.galileo_ephemeris"

/**
 * BeiDou ephemeris: data (0x92,0x64).
 *
 * Broadcast orbit and clock of one BeiDou satellite.
 *
 * Has the layout of mip_gnss_1_beidou_ephemeris. Supported by 3DM-CV7-GNSS/INS.
 *
 * The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
 * corrections hold here.
 *
 * iodec changes with the clock data; the manual has it roll over at 4.
 *
 * - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x92,0x64)
 */
#define mip_gnss_2_beidou_ephemeris mip_gnss_1_beidou_ephemeris
#define mip_gnss_2_beidou_ephemeris_codec mip_gnss_1_beidou_ephemeris_codec
#define mip_gnss_2_beidou_ephemeris_decode mip_gnss_1_beidou_ephemeris_decode
#define mip_gnss_2_beidou_ephemeris_encode mip_gnss_1_beidou_ephemeris_encode
#define MIP_GNSS_2_BEIDOU_EPHEMERIS_DESCRIPTOR 0x64
#define MIP_GNSS_2_BEIDOU_EPHEMERIS_NAME "gnss_2.beidou_ephemeris"

#ifdef __cplusplus
}
#endif

#endif
