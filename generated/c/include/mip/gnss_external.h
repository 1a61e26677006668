/**
 * @file
 *
 * External GNSS data (0x94). What an external GNSS receiver tells the device by NMEA sentences. A
 * field may need several sentences; a value that NMEA does not give is not valid. Times are those
 * of the sentences.
 */
#ifndef MIP_GNSS_EXTERNAL_H
#define MIP_GNSS_EXTERNAL_H

#include "mip/protocol.h"
#include "mip/gnss_1.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/gnss_external.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_GNSS_EXTERNAL_SET 0x94

/**
 * GNSS LLH position: data (0x94,0x03).
 *
 * GNSS position as latitude, longitude and height.
 *
 * Has the layout of mip_gnss_1_gnss_llh_position. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
 */
#define mip_gnss_external_gnss_llh_position mip_gnss_1_gnss_llh_position
#define mip_gnss_external_gnss_llh_position_codec mip_gnss_1_gnss_llh_position_codec
#define mip_gnss_external_gnss_llh_position_decode mip_gnss_1_gnss_llh_position_decode
#define mip_gnss_external_gnss_llh_position_encode mip_gnss_1_gnss_llh_position_encode
#define MIP_GNSS_EXTERNAL_GNSS_LLH_POSITION_DESCRIPTOR 0x03
#define MIP_GNSS_EXTERNAL_GNSS_LLH_POSITION_NAME "gnss_external.gnss_llh_position"

/**
 * NED velocity: data (0x94,0x05).
 *
 * GNSS velocity in the local level frame.
 *
 * Has the layout of mip_gnss_1_ned_velocity. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
 */
#define mip_gnss_external_ned_velocity mip_gnss_1_ned_velocity
#define mip_gnss_external_ned_velocity_codec mip_gnss_1_ned_velocity_codec
#define mip_gnss_external_ned_velocity_decode mip_gnss_1_ned_velocity_decode
#define mip_gnss_external_ned_velocity_encode mip_gnss_1_ned_velocity_encode
#define MIP_GNSS_EXTERNAL_NED_VELOCITY_DESCRIPTOR 0x05
#define MIP_GNSS_EXTERNAL_NED_VELOCITY_NAME "gnss_external.ned_velocity"

/**
 * UTC time: data (0x94,0x08).
 *
 * Coordinated universal time as the receiver knows it.
 *
 * Has the layout of mip_gnss_1_utc_time. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
 */
#define mip_gnss_external_utc_time mip_gnss_1_utc_time
#define mip_gnss_external_utc_time_codec mip_gnss_1_utc_time_codec
#define mip_gnss_external_utc_time_decode mip_gnss_1_utc_time_decode
#define mip_gnss_external_utc_time_encode mip_gnss_1_utc_time_encode
#define MIP_GNSS_EXTERNAL_UTC_TIME_DESCRIPTOR 0x08
#define MIP_GNSS_EXTERNAL_UTC_TIME_NAME "gnss_external.utc_time"

/**
 * Fix info: data (0x94,0x0B).
 *
 * Type of the position fix and what it is made of.
 *
 * Has the layout of mip_gnss_1_fix_info. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
 */
#define mip_gnss_external_fix_info mip_gnss_1_fix_info
#define mip_gnss_external_fix_info_codec mip_gnss_1_fix_info_codec
#define mip_gnss_external_fix_info_decode mip_gnss_1_fix_info_decode
#define mip_gnss_external_fix_info_encode mip_gnss_1_fix_info_encode
#define MIP_GNSS_EXTERNAL_FIX_INFO_DESCRIPTOR 0x0B
#define MIP_GNSS_EXTERNAL_FIX_INFO_NAME "gnss_external.fix_info"

/**
 * Satellite status: data (0x94,0x20).
 *
 * Where one satellite stands, and its health.
 *
 * Has the layout of mip_gnss_1_satellite_status. Supported by 3DM-CV7-GNSS/INS.
 *
 * An epoch is sent as one field for each satellite; index and count number the fields.
 *
 * - 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
 */
#define mip_gnss_external_satellite_status mip_gnss_1_satellite_status
#define mip_gnss_external_satellite_status_codec mip_gnss_1_satellite_status_codec
#define mip_gnss_external_satellite_status_decode mip_gnss_1_satellite_status_decode
#define mip_gnss_external_satellite_status_encode mip_gnss_1_satellite_status_encode
#define MIP_GNSS_EXTERNAL_SATELLITE_STATUS_DESCRIPTOR 0x20
#define MIP_GNSS_EXTERNAL_SATELLITE_STATUS_NAME "gnss_external.satellite_status"

#ifdef __cplusplus
}
#endif

#endif
