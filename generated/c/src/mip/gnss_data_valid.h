/**
 * @file
 * Functions that tell whether values of the fields in mip/gnss_data.h are valid, by their flags.
 * `reading` is the result of mip_reading_of, in mip/timestamps.h: 0 if the device is not known.
 */
#ifndef MIP_GNSS_DATA_VALID_H
#define MIP_GNSS_DATA_VALID_H

#include "mip/gnss_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/gnss_data_valid.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Is `latitude` valid? */
static inline bool
mip_gnss_data_llh_position_latitude_valid(const struct mip_gnss_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `longitude` valid? */
static inline bool
mip_gnss_data_llh_position_longitude_valid(const struct mip_gnss_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `ellipsoid_height` valid? */
static inline bool
mip_gnss_data_llh_position_ellipsoid_height_valid(const struct mip_gnss_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `msl_height` valid? */
static inline bool
mip_gnss_data_llh_position_msl_height_valid(const struct mip_gnss_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `horizontal_accuracy` valid? */
static inline bool mip_gnss_data_llh_position_horizontal_accuracy_valid(
    const struct mip_gnss_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `vertical_accuracy` valid? */
static inline bool
mip_gnss_data_llh_position_vertical_accuracy_valid(const struct mip_gnss_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `position` valid? */
static inline bool
mip_gnss_data_ecef_position_position_valid(const struct mip_gnss_data_ecef_position *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `position_accuracy` valid? */
static inline bool mip_gnss_data_ecef_position_position_accuracy_valid(
    const struct mip_gnss_data_ecef_position *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `velocity` valid? */
static inline bool
mip_gnss_data_ned_velocity_velocity_valid(const struct mip_gnss_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `speed` valid? */
static inline bool
mip_gnss_data_ned_velocity_speed_valid(const struct mip_gnss_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `ground_speed` valid? */
static inline bool
mip_gnss_data_ned_velocity_ground_speed_valid(const struct mip_gnss_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `heading` valid? */
static inline bool
mip_gnss_data_ned_velocity_heading_valid(const struct mip_gnss_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `speed_accuracy` valid? */
static inline bool
mip_gnss_data_ned_velocity_speed_accuracy_valid(const struct mip_gnss_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `heading_accuracy` valid? */
static inline bool
mip_gnss_data_ned_velocity_heading_accuracy_valid(const struct mip_gnss_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `velocity` valid? */
static inline bool
mip_gnss_data_ecef_velocity_velocity_valid(const struct mip_gnss_data_ecef_velocity *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `velocity_accuracy` valid? */
static inline bool mip_gnss_data_ecef_velocity_velocity_accuracy_valid(
    const struct mip_gnss_data_ecef_velocity *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `gdop` valid? */
static inline bool mip_gnss_data_dop_gdop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `pdop` valid? */
static inline bool mip_gnss_data_dop_pdop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `hdop` valid? */
static inline bool mip_gnss_data_dop_hdop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `vdop` valid? */
static inline bool mip_gnss_data_dop_vdop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `tdop` valid? */
static inline bool mip_gnss_data_dop_tdop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `ndop` valid? */
static inline bool mip_gnss_data_dop_ndop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `edop` valid? */
static inline bool mip_gnss_data_dop_edop_valid(const struct mip_gnss_data_dop *value) {
    return mip_has(value->valid_flags, 0x40U);
}

/** Are the values of gnss_data.utc_time valid? */
static inline bool mip_gnss_data_utc_time_valid(const struct mip_gnss_data_utc_time *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `tow` valid? */
static inline bool mip_gnss_data_gps_time_tow_valid(const struct mip_gnss_data_gps_time *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool
mip_gnss_data_gps_time_week_number_valid(const struct mip_gnss_data_gps_time *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `bias` valid? */
static inline bool
mip_gnss_data_clock_info_bias_valid(const struct mip_gnss_data_clock_info *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `drift` valid? */
static inline bool
mip_gnss_data_clock_info_drift_valid(const struct mip_gnss_data_clock_info *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `accuracy_estimate` valid? */
static inline bool
mip_gnss_data_clock_info_accuracy_estimate_valid(const struct mip_gnss_data_clock_info *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `fix_type` valid? */
static inline bool
mip_gnss_data_fix_info_fix_type_valid(const struct mip_gnss_data_fix_info *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `num_sv` valid? */
static inline bool mip_gnss_data_fix_info_num_sv_valid(const struct mip_gnss_data_fix_info *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `fix_flags` valid? */
static inline bool
mip_gnss_data_fix_info_fix_flags_valid(const struct mip_gnss_data_fix_info *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `channel` valid? */
static inline bool mip_gnss_data_sv_info_channel_valid(const struct mip_gnss_data_sv_info *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `satellite_id` valid? */
static inline bool
mip_gnss_data_sv_info_satellite_id_valid(const struct mip_gnss_data_sv_info *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `carrier_noise_ratio` valid? */
static inline bool
mip_gnss_data_sv_info_carrier_noise_ratio_valid(const struct mip_gnss_data_sv_info *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `azimuth` valid? */
static inline bool mip_gnss_data_sv_info_azimuth_valid(const struct mip_gnss_data_sv_info *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `elevation` valid? */
static inline bool
mip_gnss_data_sv_info_elevation_valid(const struct mip_gnss_data_sv_info *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `sv_flags` valid? */
static inline bool mip_gnss_data_sv_info_sv_flags_valid(const struct mip_gnss_data_sv_info *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `receiver_state` valid? */
static inline bool mip_gnss_data_hardware_status_receiver_state_valid(
    const struct mip_gnss_data_hardware_status *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `antenna_state` valid? */
static inline bool mip_gnss_data_hardware_status_antenna_state_valid(
    const struct mip_gnss_data_hardware_status *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `antenna_power` valid? */
static inline bool mip_gnss_data_hardware_status_antenna_power_valid(
    const struct mip_gnss_data_hardware_status *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `age` valid? */
static inline bool mip_gnss_data_dgps_info_age_valid(const struct mip_gnss_data_dgps_info *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `base_station_id` valid? */
static inline bool
mip_gnss_data_dgps_info_base_station_id_valid(const struct mip_gnss_data_dgps_info *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `base_station_status` valid? */
static inline bool
mip_gnss_data_dgps_info_base_station_status_valid(const struct mip_gnss_data_dgps_info *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `num_channels` valid? */
static inline bool
mip_gnss_data_dgps_info_num_channels_valid(const struct mip_gnss_data_dgps_info *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Are the values of gnss_data.dgps_info_satellite valid? */
static inline bool
mip_gnss_data_dgps_info_satellite_valid(const struct mip_gnss_data_dgps_info_satellite *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `satellite_id` valid? */
static inline bool
mip_gnss_data_dgps_channel_satellite_id_valid(const struct mip_gnss_data_dgps_channel *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `age` valid? */
static inline bool
mip_gnss_data_dgps_channel_age_valid(const struct mip_gnss_data_dgps_channel *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `range_correction` valid? */
static inline bool
mip_gnss_data_dgps_channel_range_correction_valid(const struct mip_gnss_data_dgps_channel *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `range_rate_correction` valid? */
static inline bool mip_gnss_data_dgps_channel_range_rate_correction_valid(
    const struct mip_gnss_data_dgps_channel *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `bias` valid? */
static inline bool
mip_gnss_data_clock_info_2_bias_valid(const struct mip_gnss_data_clock_info_2 *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `drift` valid? */
static inline bool
mip_gnss_data_clock_info_2_drift_valid(const struct mip_gnss_data_clock_info_2 *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `bias_accuracy_estimate` valid? */
static inline bool mip_gnss_data_clock_info_2_bias_accuracy_estimate_valid(
    const struct mip_gnss_data_clock_info_2 *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `drift_accuracy_estimate` valid? */
static inline bool mip_gnss_data_clock_info_2_drift_accuracy_estimate_valid(
    const struct mip_gnss_data_clock_info_2 *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Are the values of gnss_data.gps_leap_seconds valid? */
static inline bool
mip_gnss_data_gps_leap_seconds_valid(const struct mip_gnss_data_gps_leap_seconds *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `tow` valid? */
static inline bool mip_gnss_data_sbas_info_tow_valid(const struct mip_gnss_data_sbas_info *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool
mip_gnss_data_sbas_info_week_number_valid(const struct mip_gnss_data_sbas_info *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `sbas_system` valid? */
static inline bool
mip_gnss_data_sbas_info_sbas_system_valid(const struct mip_gnss_data_sbas_info *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `sbas_id` valid? */
static inline bool
mip_gnss_data_sbas_info_sbas_id_valid(const struct mip_gnss_data_sbas_info *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `count` valid? */
static inline bool
mip_gnss_data_sbas_info_count_valid(const struct mip_gnss_data_sbas_info *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `sbas_status` valid? */
static inline bool
mip_gnss_data_sbas_info_sbas_status_valid(const struct mip_gnss_data_sbas_info *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `udrei` valid? */
static inline bool
mip_gnss_data_sbas_correction_udrei_valid(const struct mip_gnss_data_sbas_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `pseudorange_correction` valid? */
static inline bool mip_gnss_data_sbas_correction_pseudorange_correction_valid(
    const struct mip_gnss_data_sbas_correction *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `iono_correction` valid? */
static inline bool mip_gnss_data_sbas_correction_iono_correction_valid(
    const struct mip_gnss_data_sbas_correction *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `rf_band` valid? */
static inline bool mip_gnss_data_rf_error_detection_rf_band_valid(
    const struct mip_gnss_data_rf_error_detection *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `jamming_state` valid? */
static inline bool mip_gnss_data_rf_error_detection_jamming_state_valid(
    const struct mip_gnss_data_rf_error_detection *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `spoofing_state` valid? */
static inline bool mip_gnss_data_rf_error_detection_spoofing_state_valid(
    const struct mip_gnss_data_rf_error_detection *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `frequency` valid? */
static inline bool mip_gnss_data_rf_error_detection_frequency_valid(
    const struct mip_gnss_data_rf_error_detection *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `heading` valid? */
static inline bool mip_gnss_data_heading_heading_valid(const struct mip_gnss_data_heading *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `uncertainty` valid? */
static inline bool
mip_gnss_data_heading_uncertainty_valid(const struct mip_gnss_data_heading *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `fix_type` valid? */
static inline bool mip_gnss_data_heading_fix_type_valid(const struct mip_gnss_data_heading *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `tow` valid? */
static inline bool
mip_gnss_data_satellite_status_tow_valid(const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_satellite_status_week_number_valid(
    const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `gnss_id` valid? */
static inline bool
mip_gnss_data_satellite_status_gnss_id_valid(const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `satellite_id` valid? */
static inline bool mip_gnss_data_satellite_status_satellite_id_valid(
    const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `elevation` valid? */
static inline bool
mip_gnss_data_satellite_status_elevation_valid(const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `azimuth` valid? */
static inline bool
mip_gnss_data_satellite_status_azimuth_valid(const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `health` valid? */
static inline bool
mip_gnss_data_satellite_status_health_valid(const struct mip_gnss_data_satellite_status *value) {
    return mip_has(value->valid_flags, 0x40U);
}

/** Is `tow` valid? */
static inline bool mip_gnss_data_raw_tow_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_raw_week_number_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `receiver_id` valid? */
static inline bool mip_gnss_data_raw_receiver_id_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `tracking_channel` valid? */
static inline bool mip_gnss_data_raw_tracking_channel_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `gnss_id` valid? */
static inline bool mip_gnss_data_raw_gnss_id_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `satellite_id` valid? */
static inline bool mip_gnss_data_raw_satellite_id_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `signal_id` valid? */
static inline bool mip_gnss_data_raw_signal_id_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x40U);
}

/** Is `signal_strength` valid? */
static inline bool mip_gnss_data_raw_signal_strength_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x80U);
}

/** Is `quality` valid? */
static inline bool mip_gnss_data_raw_quality_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x100U);
}

/** Is `pseudorange` valid? */
static inline bool mip_gnss_data_raw_pseudorange_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x200U);
}

/** Is `carrier_phase` valid? */
static inline bool mip_gnss_data_raw_carrier_phase_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x400U);
}

/** Is `doppler` valid? */
static inline bool mip_gnss_data_raw_doppler_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x800U);
}

/** Is `range_uncertainty` valid? */
static inline bool
mip_gnss_data_raw_range_uncertainty_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x1000U);
}

/** Is `phase_uncertainty` valid? */
static inline bool
mip_gnss_data_raw_phase_uncertainty_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x2000U);
}

/** Is `doppler_uncertainty` valid? */
static inline bool
mip_gnss_data_raw_doppler_uncertainty_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x4000U);
}

/** Is `lock_time` valid? */
static inline bool mip_gnss_data_raw_lock_time_valid(const struct mip_gnss_data_raw *value) {
    return mip_has(value->valid_flags, 0x8000U);
}

/** Is `tow` valid? */
static inline bool
mip_gnss_data_base_station_info_tow_valid(const struct mip_gnss_data_base_station_info *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_base_station_info_week_number_valid(
    const struct mip_gnss_data_base_station_info *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `ecef_position` valid? */
static inline bool mip_gnss_data_base_station_info_ecef_position_valid(
    const struct mip_gnss_data_base_station_info *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `height` valid? */
static inline bool
mip_gnss_data_base_station_info_height_valid(const struct mip_gnss_data_base_station_info *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `station_id` valid? */
static inline bool mip_gnss_data_base_station_info_station_id_valid(
    const struct mip_gnss_data_base_station_info *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `indicators` valid? */
static inline bool mip_gnss_data_base_station_info_indicators_valid(
    const struct mip_gnss_data_base_station_info *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `tow` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_tow_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_week_number_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `epoch_status` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_epoch_status_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `dongle_status` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_dongle_status_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `gps_correction_latency` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_gps_correction_latency_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x10U);
}

/** Is `glonass_correction_latency` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_glonass_correction_latency_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x20U);
}

/** Is `galileo_correction_latency` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_galileo_correction_latency_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x40U);
}

/** Is `beidou_correction_latency` valid? */
static inline bool mip_gnss_data_rtk_corrections_status_beidou_correction_latency_valid(
    const struct mip_gnss_data_rtk_corrections_status *value) {
    return mip_has(value->valid_flags, 0x80U);
}

/** Are the values of gnss_data.gps_ephemeris valid? */
static inline bool
mip_gnss_data_gps_ephemeris_valid(const struct mip_gnss_data_gps_ephemeris *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of gnss_data.glonass_ephemeris valid? */
static inline bool
mip_gnss_data_glonass_ephemeris_valid(const struct mip_gnss_data_glonass_ephemeris *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of gnss_data.galileo_ephemeris valid? */
static inline bool
mip_gnss_data_galileo_ephemeris_valid(const struct mip_gnss_data_galileo_ephemeris *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of gnss_data.beidou_ephemeris valid? */
static inline bool
mip_gnss_data_beidou_ephemeris_valid(const struct mip_gnss_data_beidou_ephemeris *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `tow` valid? */
static inline bool
mip_gnss_data_gps_iono_correction_tow_valid(const struct mip_gnss_data_gps_iono_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_gps_iono_correction_week_number_valid(
    const struct mip_gnss_data_gps_iono_correction *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `alpha` valid? */
static inline bool mip_gnss_data_gps_iono_correction_alpha_valid(
    const struct mip_gnss_data_gps_iono_correction *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `beta` valid? */
static inline bool mip_gnss_data_gps_iono_correction_beta_valid(
    const struct mip_gnss_data_gps_iono_correction *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `tow` valid? */
static inline bool mip_gnss_data_galileo_iono_correction_tow_valid(
    const struct mip_gnss_data_galileo_iono_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_galileo_iono_correction_week_number_valid(
    const struct mip_gnss_data_galileo_iono_correction *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `alpha` valid? */
static inline bool mip_gnss_data_galileo_iono_correction_alpha_valid(
    const struct mip_gnss_data_galileo_iono_correction *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `disturbance_flags` valid? */
static inline bool mip_gnss_data_galileo_iono_correction_disturbance_flags_valid(
    const struct mip_gnss_data_galileo_iono_correction *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `tow` valid? */
static inline bool mip_gnss_data_beidou_iono_correction_tow_valid(
    const struct mip_gnss_data_beidou_iono_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool mip_gnss_data_beidou_iono_correction_week_number_valid(
    const struct mip_gnss_data_beidou_iono_correction *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Is `alpha` valid? */
static inline bool mip_gnss_data_beidou_iono_correction_alpha_valid(
    const struct mip_gnss_data_beidou_iono_correction *value) {
    return mip_has(value->valid_flags, 0x4U);
}

/** Is `beta` valid? */
static inline bool mip_gnss_data_beidou_iono_correction_beta_valid(
    const struct mip_gnss_data_beidou_iono_correction *value) {
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `alpha_correction` valid? */
static inline bool mip_gnss_data_beidou_iono_correction_alpha_correction_valid(
    const struct mip_gnss_data_beidou_iono_correction *value) {
    return mip_has(value->valid_flags, 0x10U);
}

#ifdef __cplusplus
}
#endif

#endif
