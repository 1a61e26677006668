/**
 * @file
 *
 * GNSS data (0x81). Measurements and status of the GNSS receiver of 4-series and 5-series devices.
 * Uncertain: Which devices send the fields that no manual lists for this set. The SDK gives all
 * GNSS data sets the same fields.
 */
#ifndef MIP_GNSS_DATA_H
#define MIP_GNSS_DATA_H

#include "mip/protocol.h"
#include "mip/gnss_1.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/gnss_data.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_GNSS_DATA_SET 0x81

/**
 * GNSS LLH position: data (0x81,0x03).
 *
 * GNSS position as latitude, longitude and height.
 *
 * Has the layout of mip_gnss_1_llh_position. Also called `pos_llh`. May be supported by 3DM-GX5-35
 * and 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_llh_position mip_gnss_1_llh_position
#define mip_gnss_data_llh_position_codec mip_gnss_1_llh_position_codec
#define mip_gnss_data_llh_position_decode mip_gnss_1_llh_position_decode
#define mip_gnss_data_llh_position_encode mip_gnss_1_llh_position_encode
#define MIP_GNSS_DATA_LLH_POSITION_DESCRIPTOR 0x03
#define MIP_GNSS_DATA_LLH_POSITION_NAME "gnss_data.llh_position"

/**
 * GNSS ECEF position: data (0x81,0x04).
 *
 * GNSS position in Earth-fixed coordinates.
 *
 * Has the layout of mip_gnss_1_ecef_position. Also called `pos_ecef`. May be supported by
 * 3DM-GX5-35 and 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_ecef_position mip_gnss_1_ecef_position
#define mip_gnss_data_ecef_position_codec mip_gnss_1_ecef_position_codec
#define mip_gnss_data_ecef_position_decode mip_gnss_1_ecef_position_decode
#define mip_gnss_data_ecef_position_encode mip_gnss_1_ecef_position_encode
#define MIP_GNSS_DATA_ECEF_POSITION_DESCRIPTOR 0x04
#define MIP_GNSS_DATA_ECEF_POSITION_NAME "gnss_data.ecef_position"

/**
 * NED velocity: data (0x81,0x05).
 *
 * GNSS velocity in the local level frame.
 *
 * Has the layout of mip_gnss_1_ned_velocity. Also called `vel_ned`. May be supported by 3DM-GX5-35
 * and 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_ned_velocity mip_gnss_1_ned_velocity
#define mip_gnss_data_ned_velocity_codec mip_gnss_1_ned_velocity_codec
#define mip_gnss_data_ned_velocity_decode mip_gnss_1_ned_velocity_decode
#define mip_gnss_data_ned_velocity_encode mip_gnss_1_ned_velocity_encode
#define MIP_GNSS_DATA_NED_VELOCITY_DESCRIPTOR 0x05
#define MIP_GNSS_DATA_NED_VELOCITY_NAME "gnss_data.ned_velocity"

/**
 * GNSS ECEF velocity: data (0x81,0x06).
 *
 * GNSS velocity in Earth-fixed coordinates.
 *
 * Has the layout of mip_gnss_1_ecef_velocity. Also called `vel_ecef`. Supported by 3DM-GX5-35. May
 * be supported by 3DM-GX5-45.
 *
 * - 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06)
 */
#define mip_gnss_data_ecef_velocity mip_gnss_1_ecef_velocity
#define mip_gnss_data_ecef_velocity_codec mip_gnss_1_ecef_velocity_codec
#define mip_gnss_data_ecef_velocity_decode mip_gnss_1_ecef_velocity_decode
#define mip_gnss_data_ecef_velocity_encode mip_gnss_1_ecef_velocity_encode
#define MIP_GNSS_DATA_ECEF_VELOCITY_DESCRIPTOR 0x06
#define MIP_GNSS_DATA_ECEF_VELOCITY_NAME "gnss_data.ecef_velocity"

/**
 * DOP: data (0x81,0x07).
 *
 * Dilution of precision of the satellite geometry.
 *
 * Has the layout of mip_gnss_1_dop. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known from the
 * MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_dop mip_gnss_1_dop
#define mip_gnss_data_dop_codec mip_gnss_1_dop_codec
#define mip_gnss_data_dop_decode mip_gnss_1_dop_decode
#define mip_gnss_data_dop_encode mip_gnss_1_dop_encode
#define MIP_GNSS_DATA_DOP_DESCRIPTOR 0x07
#define MIP_GNSS_DATA_DOP_NAME "gnss_data.dop"

/**
 * UTC time: data (0x81,0x08).
 *
 * Coordinated universal time as the receiver knows it.
 *
 * Has the layout of mip_gnss_1_utc_time. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known from
 * the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_utc_time mip_gnss_1_utc_time
#define mip_gnss_data_utc_time_codec mip_gnss_1_utc_time_codec
#define mip_gnss_data_utc_time_decode mip_gnss_1_utc_time_decode
#define mip_gnss_data_utc_time_encode mip_gnss_1_utc_time_encode
#define MIP_GNSS_DATA_UTC_TIME_DESCRIPTOR 0x08
#define MIP_GNSS_DATA_UTC_TIME_NAME "gnss_data.utc_time"

/**
 * GPS time: data (0x81,0x09).
 *
 * GPS time as the receiver knows it.
 *
 * Has the layout of mip_gnss_1_gps_time. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known from
 * the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_gps_time mip_gnss_1_gps_time
#define mip_gnss_data_gps_time_codec mip_gnss_1_gps_time_codec
#define mip_gnss_data_gps_time_decode mip_gnss_1_gps_time_decode
#define mip_gnss_data_gps_time_encode mip_gnss_1_gps_time_encode
#define MIP_GNSS_DATA_GPS_TIME_DESCRIPTOR 0x09
#define MIP_GNSS_DATA_GPS_TIME_NAME "gnss_data.gps_time"

/**
 * Clock info: data (0x81,0x0A).
 *
 * Bias and drift of the receiver clock.
 *
 * Has the layout of mip_gnss_1_clock_info. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known
 * from the MicroStrain MIP SDK only.
 *
 * Clock info 2 replaces it and tells more.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_clock_info mip_gnss_1_clock_info
#define mip_gnss_data_clock_info_codec mip_gnss_1_clock_info_codec
#define mip_gnss_data_clock_info_decode mip_gnss_1_clock_info_decode
#define mip_gnss_data_clock_info_encode mip_gnss_1_clock_info_encode
#define MIP_GNSS_DATA_CLOCK_INFO_DESCRIPTOR 0x0A
#define MIP_GNSS_DATA_CLOCK_INFO_NAME "gnss_data.clock_info"

/**
 * Fix info: data (0x81,0x0B).
 *
 * Type of the position fix and what it is made of.
 *
 * Has the layout of mip_gnss_1_fix_info. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known from
 * the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_fix_info mip_gnss_1_fix_info
#define mip_gnss_data_fix_info_codec mip_gnss_1_fix_info_codec
#define mip_gnss_data_fix_info_decode mip_gnss_1_fix_info_decode
#define mip_gnss_data_fix_info_encode mip_gnss_1_fix_info_encode
#define MIP_GNSS_DATA_FIX_INFO_DESCRIPTOR 0x0B
#define MIP_GNSS_DATA_FIX_INFO_NAME "gnss_data.fix_info"

/**
 * Satellite info: data (0x81,0x0C).
 *
 * One satellite that is tracked.
 *
 * Has the layout of mip_gnss_1_sv_info. Supported by 3DM-GX5-45. May be supported by 3DM-GX5-35.
 * Known from the MicroStrain MIP SDK only. Uncertain: Whether a packet holds one of these fields or
 * several.
 *
 * The satellites come as one field each, in packets apart from other GNSS data.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_sv_info mip_gnss_1_sv_info
#define mip_gnss_data_sv_info_codec mip_gnss_1_sv_info_codec
#define mip_gnss_data_sv_info_decode mip_gnss_1_sv_info_decode
#define mip_gnss_data_sv_info_encode mip_gnss_1_sv_info_encode
#define MIP_GNSS_DATA_SV_INFO_DESCRIPTOR 0x0C
#define MIP_GNSS_DATA_SV_INFO_NAME "gnss_data.sv_info"

/**
 * GNSS hardware status: data (0x81,0x0D).
 *
 * State of the receiver and of its antenna.
 *
 * Has the layout of mip_gnss_1_hardware_status. Also called `hw_status`. Supported by 3DM-GX5-45.
 * May be supported by 3DM-GX5-35. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_hardware_status mip_gnss_1_hardware_status
#define mip_gnss_data_hardware_status_codec mip_gnss_1_hardware_status_codec
#define mip_gnss_data_hardware_status_decode mip_gnss_1_hardware_status_decode
#define mip_gnss_data_hardware_status_encode mip_gnss_1_hardware_status_encode
#define MIP_GNSS_DATA_HARDWARE_STATUS_DESCRIPTOR 0x0D
#define MIP_GNSS_DATA_HARDWARE_STATUS_NAME "gnss_data.hardware_status"

/**
 * DGPS info: data (0x81,0x0E).
 *
 * State of the differential corrections.
 *
 * Has the layout of mip_gnss_1_dgps_info. Supported by 3DM-GX5-35 and 3DM-GX5-45. Uncertain: The
 * layout is that of a manual of the 3DM-GX5-35 and of MSCL, another library of the vendor. It
 * agrees with the valid flags. Uncertain: The SDK has another one, u8, three floats and u16, which
 * is that of mip_gnss_1_dgps_channel and does not agree with its own valid flags (age, base station
 * id, base station status, number of channels).
 *
 * - 3dm-gx5-35: 5.2.12 DGNSS Information (0x81, 0x0E)
 * - mip-sdk-4: Dgps Info (0x81,0x0E)
 */
#define mip_gnss_data_dgps_info mip_gnss_1_dgps_info
#define mip_gnss_data_dgps_info_codec mip_gnss_1_dgps_info_codec
#define mip_gnss_data_dgps_info_decode mip_gnss_1_dgps_info_decode
#define mip_gnss_data_dgps_info_encode mip_gnss_1_dgps_info_encode
#define MIP_GNSS_DATA_DGPS_INFO_DESCRIPTOR 0x0E
#define MIP_GNSS_DATA_DGPS_INFO_NAME "gnss_data.dgps_info"

/**
 * DGPS channel: data (0x81,0x0F).
 *
 * Differential correction for one satellite.
 *
 * Has the layout of mip_gnss_1_dgps_channel. Supported by 3DM-GX5-45. May be supported by
 * 3DM-GX5-35. Known from the MicroStrain MIP SDK only.
 *
 * The active satellites come as one field each, all in one packet.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_dgps_channel mip_gnss_1_dgps_channel
#define mip_gnss_data_dgps_channel_codec mip_gnss_1_dgps_channel_codec
#define mip_gnss_data_dgps_channel_decode mip_gnss_1_dgps_channel_decode
#define mip_gnss_data_dgps_channel_encode mip_gnss_1_dgps_channel_encode
#define MIP_GNSS_DATA_DGPS_CHANNEL_DESCRIPTOR 0x0F
#define MIP_GNSS_DATA_DGPS_CHANNEL_NAME "gnss_data.dgps_channel"

/**
 * Clock info 2: data (0x81,0x10).
 *
 * Bias and drift of the receiver clock.
 *
 * Has the layout of mip_gnss_1_clock_info_2. No device profile lists it. Known from the MicroStrain
 * MIP SDK only.
 *
 * It supersedes clock info.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_clock_info_2 mip_gnss_1_clock_info_2
#define mip_gnss_data_clock_info_2_codec mip_gnss_1_clock_info_2_codec
#define mip_gnss_data_clock_info_2_decode mip_gnss_1_clock_info_2_decode
#define mip_gnss_data_clock_info_2_encode mip_gnss_1_clock_info_2_encode
#define MIP_GNSS_DATA_CLOCK_INFO_2_DESCRIPTOR 0x10
#define MIP_GNSS_DATA_CLOCK_INFO_2_NAME "gnss_data.clock_info_2"

/**
 * GPS leap seconds: data (0x81,0x11).
 *
 * Difference between GPS time and UTC.
 *
 * Has the layout of mip_gnss_1_gps_leap_seconds. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_gps_leap_seconds mip_gnss_1_gps_leap_seconds
#define mip_gnss_data_gps_leap_seconds_codec mip_gnss_1_gps_leap_seconds_codec
#define mip_gnss_data_gps_leap_seconds_decode mip_gnss_1_gps_leap_seconds_decode
#define mip_gnss_data_gps_leap_seconds_encode mip_gnss_1_gps_leap_seconds_encode
#define MIP_GNSS_DATA_GPS_LEAP_SECONDS_DESCRIPTOR 0x11
#define MIP_GNSS_DATA_GPS_LEAP_SECONDS_NAME "gnss_data.gps_leap_seconds"

/**
 * SBAS info: data (0x81,0x12).
 *
 * Status of the satellite based augmentation.
 *
 * Has the layout of mip_gnss_1_sbas_info. No device profile lists it. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_sbas_info mip_gnss_1_sbas_info
#define mip_gnss_data_sbas_info_codec mip_gnss_1_sbas_info_codec
#define mip_gnss_data_sbas_info_decode mip_gnss_1_sbas_info_decode
#define mip_gnss_data_sbas_info_encode mip_gnss_1_sbas_info_encode
#define MIP_GNSS_DATA_SBAS_INFO_DESCRIPTOR 0x12
#define MIP_GNSS_DATA_SBAS_INFO_NAME "gnss_data.sbas_info"

/**
 * SBAS correction: data (0x81,0x13).
 *
 * SBAS correction for one satellite.
 *
 * Has the layout of mip_gnss_1_sbas_correction. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * An epoch is sent as one field for each satellite; index and count number the fields.
 *
 * udrei 0 to 13 are these variances in m^2: 0.0520, 0.0924, 0.1444, 0.2830, 0.4678, 0.8315, 1.2992,
 * 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_sbas_correction mip_gnss_1_sbas_correction
#define mip_gnss_data_sbas_correction_codec mip_gnss_1_sbas_correction_codec
#define mip_gnss_data_sbas_correction_decode mip_gnss_1_sbas_correction_decode
#define mip_gnss_data_sbas_correction_encode mip_gnss_1_sbas_correction_encode
#define MIP_GNSS_DATA_SBAS_CORRECTION_DESCRIPTOR 0x13
#define MIP_GNSS_DATA_SBAS_CORRECTION_NAME "gnss_data.sbas_correction"

/**
 * RF error detection: data (0x81,0x14).
 *
 * Jamming and spoofing as the receiver detects them in one band.
 *
 * Has the layout of mip_gnss_1_rf_error_detection. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_rf_error_detection mip_gnss_1_rf_error_detection
#define mip_gnss_data_rf_error_detection_codec mip_gnss_1_rf_error_detection_codec
#define mip_gnss_data_rf_error_detection_decode mip_gnss_1_rf_error_detection_decode
#define mip_gnss_data_rf_error_detection_encode mip_gnss_1_rf_error_detection_encode
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_DESCRIPTOR 0x14
#define MIP_GNSS_DATA_RF_ERROR_DETECTION_NAME "gnss_data.rf_error_detection"

/**
 * Satellite status: data (0x81,0x20).
 *
 * Where one satellite stands, and its health.
 *
 * Has the layout of mip_gnss_1_satellite_status. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * An epoch is sent as one field for each satellite; index and count number the fields.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_satellite_status mip_gnss_1_satellite_status
#define mip_gnss_data_satellite_status_codec mip_gnss_1_satellite_status_codec
#define mip_gnss_data_satellite_status_decode mip_gnss_1_satellite_status_decode
#define mip_gnss_data_satellite_status_encode mip_gnss_1_satellite_status_encode
#define MIP_GNSS_DATA_SATELLITE_STATUS_DESCRIPTOR 0x20
#define MIP_GNSS_DATA_SATELLITE_STATUS_NAME "gnss_data.satellite_status"

/**
 * Raw: data (0x81,0x22).
 *
 * Raw observation of one signal of one satellite.
 *
 * Has the layout of mip_gnss_1_raw. No device profile lists it. Known from the MicroStrain MIP SDK
 * only.
 *
 * An epoch is sent as one field for each signal; index and count number the fields.
 *
 * The greatest lock time depends on the receiver.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_raw mip_gnss_1_raw
#define mip_gnss_data_raw_codec mip_gnss_1_raw_codec
#define mip_gnss_data_raw_decode mip_gnss_1_raw_decode
#define mip_gnss_data_raw_encode mip_gnss_1_raw_encode
#define MIP_GNSS_DATA_RAW_DESCRIPTOR 0x22
#define MIP_GNSS_DATA_RAW_NAME "gnss_data.raw"

/**
 * Base station info: data (0x81,0x30).
 *
 * The base station of the corrections, from an RTCM message 1005 or 1006.
 *
 * Has the layout of mip_gnss_1_base_station_info. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_base_station_info mip_gnss_1_base_station_info
#define mip_gnss_data_base_station_info_codec mip_gnss_1_base_station_info_codec
#define mip_gnss_data_base_station_info_decode mip_gnss_1_base_station_info_decode
#define mip_gnss_data_base_station_info_encode mip_gnss_1_base_station_info_encode
#define MIP_GNSS_DATA_BASE_STATION_INFO_DESCRIPTOR 0x30
#define MIP_GNSS_DATA_BASE_STATION_INFO_NAME "gnss_data.base_station_info"

/**
 * RTK corrections status: data (0x81,0x31).
 *
 * Which corrections come, and how old they are.
 *
 * Has the layout of mip_gnss_1_rtk_corrections_status. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_rtk_corrections_status mip_gnss_1_rtk_corrections_status
#define mip_gnss_data_rtk_corrections_status_codec mip_gnss_1_rtk_corrections_status_codec
#define mip_gnss_data_rtk_corrections_status_decode mip_gnss_1_rtk_corrections_status_decode
#define mip_gnss_data_rtk_corrections_status_encode mip_gnss_1_rtk_corrections_status_encode
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_DESCRIPTOR 0x31
#define MIP_GNSS_DATA_RTK_CORRECTIONS_STATUS_NAME "gnss_data.rtk_corrections_status"

/**
 * GPS ephemeris: data (0x81,0x61).
 *
 * Broadcast orbit and clock of one GPS satellite.
 *
 * Has the layout of mip_gnss_1_gps_ephemeris. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * `iodc` changes with the clock data; the manual has it roll over at 4.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_gps_ephemeris mip_gnss_1_gps_ephemeris
#define mip_gnss_data_gps_ephemeris_codec mip_gnss_1_gps_ephemeris_codec
#define mip_gnss_data_gps_ephemeris_decode mip_gnss_1_gps_ephemeris_decode
#define mip_gnss_data_gps_ephemeris_encode mip_gnss_1_gps_ephemeris_encode
#define MIP_GNSS_DATA_GPS_EPHEMERIS_DESCRIPTOR 0x61
#define MIP_GNSS_DATA_GPS_EPHEMERIS_NAME "gnss_data.gps_ephemeris"

/**
 * GLONASS ephemeris: data (0x81,0x62).
 *
 * Broadcast orbit and clock of one GLONASS satellite.
 *
 * Has the layout of mip_gnss_1_glonass_ephemeris. Also called `glo_ephemeris`. No device profile
 * lists it. Known from the MicroStrain MIP SDK only.
 *
 * The interface control document of GLONASS explains p and ft.
 *
 * A period of four years has 1461 days; the manual does not say how nt, a u8, counts them.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_glonass_ephemeris mip_gnss_1_glonass_ephemeris
#define mip_gnss_data_glonass_ephemeris_codec mip_gnss_1_glonass_ephemeris_codec
#define mip_gnss_data_glonass_ephemeris_decode mip_gnss_1_glonass_ephemeris_decode
#define mip_gnss_data_glonass_ephemeris_encode mip_gnss_1_glonass_ephemeris_encode
#define MIP_GNSS_DATA_GLONASS_EPHEMERIS_DESCRIPTOR 0x62
#define MIP_GNSS_DATA_GLONASS_EPHEMERIS_NAME "gnss_data.glonass_ephemeris"

/**
 * Galileo ephemeris: data (0x81,0x63).
 *
 * Broadcast orbit and clock of one Galileo satellite.
 *
 * Has the layout of mip_gnss_1_galileo_ephemeris. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
 * corrections hold here.
 *
 * `iodc` changes with the clock data; the manual has it roll over at 4.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_galileo_ephemeris mip_gnss_1_galileo_ephemeris
#define mip_gnss_data_galileo_ephemeris_codec mip_gnss_1_galileo_ephemeris_codec
#define mip_gnss_data_galileo_ephemeris_decode mip_gnss_1_galileo_ephemeris_decode
#define mip_gnss_data_galileo_ephemeris_encode mip_gnss_1_galileo_ephemeris_encode
#define MIP_GNSS_DATA_GALILEO_EPHEMERIS_DESCRIPTOR 0x63
#define MIP_GNSS_DATA_GALILEO_EPHEMERIS_NAME "gnss_data.galileo_ephemeris"

/**
 * BeiDou ephemeris: data (0x81,0x64).
 *
 * Broadcast orbit and clock of one BeiDou satellite.
 *
 * Has the layout of mip_gnss_1_beidou_ephemeris. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
 * corrections hold here.
 *
 * `iodc` changes with the clock data; the manual has it roll over at 4.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_beidou_ephemeris mip_gnss_1_beidou_ephemeris
#define mip_gnss_data_beidou_ephemeris_codec mip_gnss_1_beidou_ephemeris_codec
#define mip_gnss_data_beidou_ephemeris_decode mip_gnss_1_beidou_ephemeris_decode
#define mip_gnss_data_beidou_ephemeris_encode mip_gnss_1_beidou_ephemeris_encode
#define MIP_GNSS_DATA_BEIDOU_EPHEMERIS_DESCRIPTOR 0x64
#define MIP_GNSS_DATA_BEIDOU_EPHEMERIS_NAME "gnss_data.beidou_ephemeris"

/**
 * GPS ionospheric correction: data (0x81,0x71).
 *
 * Model of the ionosphere that GPS broadcasts.
 *
 * Has the layout of mip_gnss_1_gps_iono_correction. Also called `gps_iono_corr`. No device profile
 * lists it. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_gps_iono_correction mip_gnss_1_gps_iono_correction
#define mip_gnss_data_gps_iono_correction_codec mip_gnss_1_gps_iono_correction_codec
#define mip_gnss_data_gps_iono_correction_decode mip_gnss_1_gps_iono_correction_decode
#define mip_gnss_data_gps_iono_correction_encode mip_gnss_1_gps_iono_correction_encode
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_DESCRIPTOR 0x71
#define MIP_GNSS_DATA_GPS_IONO_CORRECTION_NAME "gnss_data.gps_iono_correction"

/**
 * Galileo ionospheric correction: data (0x81,0x73).
 *
 * Model of the ionosphere that Galileo broadcasts.
 *
 * Has the layout of mip_gnss_1_galileo_iono_correction. Also called `galileo_iono_corr`. No device
 * profile lists it. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_galileo_iono_correction mip_gnss_1_galileo_iono_correction
#define mip_gnss_data_galileo_iono_correction_codec mip_gnss_1_galileo_iono_correction_codec
#define mip_gnss_data_galileo_iono_correction_decode mip_gnss_1_galileo_iono_correction_decode
#define mip_gnss_data_galileo_iono_correction_encode mip_gnss_1_galileo_iono_correction_encode
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_DESCRIPTOR 0x73
#define MIP_GNSS_DATA_GALILEO_IONO_CORRECTION_NAME "gnss_data.galileo_iono_correction"

/**
 * BeiDou ionospheric correction: data (0x81,0x74).
 *
 * Model of the ionosphere that BeiDou broadcasts.
 *
 * Has the layout of mip_gnss_1_beidou_iono_correction. Also called `beidou_iono_corr`. No device
 * profile lists it. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Gnss Data (0x81)
 */
#define mip_gnss_data_beidou_iono_correction mip_gnss_1_beidou_iono_correction
#define mip_gnss_data_beidou_iono_correction_codec mip_gnss_1_beidou_iono_correction_codec
#define mip_gnss_data_beidou_iono_correction_decode mip_gnss_1_beidou_iono_correction_decode
#define mip_gnss_data_beidou_iono_correction_encode mip_gnss_1_beidou_iono_correction_encode
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_DESCRIPTOR 0x74
#define MIP_GNSS_DATA_BEIDOU_IONO_CORRECTION_NAME "gnss_data.beidou_iono_correction"

#ifdef __cplusplus
}
#endif

#endif
