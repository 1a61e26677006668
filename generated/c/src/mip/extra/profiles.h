/**
 * @file
 * The devices. Plain tables: a program that uses one device links only that one.
 */
#ifndef MIP_PROFILES_H
#define MIP_PROFILES_H

#include "mip/connect.h"
#include "mip/extra/profile.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/extra/profiles.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * 3DM-CV5-10: Inertial measurement unit.
 *
 * Also called 3DM-CV5-IMU. Generation 5. Model number 6259. Sensors: accelerometer, gyroscope. GNSS
 * receivers: none. GNSS antennas: none. Sets known completely from the manual: MIP_BASE_SET.
 * Manual: 3DM-CV5-10 Data Communications Protocol Manual, 8500-0070 revision E, 2018, known from
 * its contents. This profile is incomplete: Of the manual, only the table of contents is known, up
 * to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`. Uncertain: The sensors are
 * inferred from the name of the model; that it has no magnetometer also from MSCL, which offers it
 * no north compensation.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cv5_10;

/**
 * 3DM-CV5-15: Attitude reference.
 *
 * Also called 3DM-CV5-AR. Generation 5. Model number 6258. Sensors: accelerometer, gyroscope,
 * pressure sensor. GNSS receivers: none. GNSS antennas: none. Sets known completely from the
 * manual: MIP_BASE_SET. Manual: 3DM-CV5-15 Data Communications Protocol Manual, revision D, 2018,
 * known from its contents. This profile is incomplete: Of the manual, only the table of contents is
 * known, up to mip_3dm_filter_message_format. It lists the sets `base`, `3dm`, `filter`, `system`,
 * `sensor` and `filter_data`.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cv5_15;

/**
 * 3DM-CV5-25: Attitude and heading reference system.
 *
 * Also called 3DM-CV5-AHRS. Generation 5. Model number 6257. Sensors: accelerometer, gyroscope,
 * magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known.
 * This profile is incomplete: No manual is known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cv5_25;

/**
 * 3DM-CV7-AHRS: Attitude and heading reference system.
 *
 * Generation 7. Model number 6286. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7 Documentation
 * (AHRS and AR), online, known from some pages. This profile is incomplete: Only some pages of its
 * manual are known; the device has further commands and data. Uncertain: MSCL offers only the
 * values `none` and `manual` of mip_filter_magnetic_declination_source; the manual also has `wmm`.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cv7_ahrs;

/**
 * 3DM-CV7-AR: Attitude reference.
 *
 * Generation 7. Model number 6287. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
 * receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7 Documentation (AHRS and AR),
 * online, known from some pages. This profile is incomplete: Only some pages of its manual are
 * known; the device has further commands and data. Uncertain: MSCL offers only the values `none`
 * and `manual` of mip_filter_magnetic_declination_source; the manual also has `wmm`.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cv7_ar;

/**
 * 3DM-CV7-GNSS/INS: Inertial navigation system with two RTK-capable GNSS receivers, magnetometer
 * and pressure sensor.
 *
 * Generation 7. Model number 6292. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: 2. GNSS antennas: 2. Manual: MicroStrain 3DM-CV7-GNSS/INS Documentation,
 * 8500-0099. Uncertain: The manual warns of a bug in the NMEA input, and does not describe it.
 *
 * - mip-sdk-4: Device models
 */
extern MIP_API const struct mip_profile mip_profile_cv7_gnss_ins;

/**
 * 3DM-CV7-INS: Inertial navigation system without an internal GNSS receiver.
 *
 * Generation 7. Model number 6291. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7-INS Documentation,
 * online, known from some pages. This profile is incomplete: Only some pages of its manual are
 * known; the device has further commands and data. This profile is incomplete: It has the data sets
 * 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF. Uncertain: Only a test site of the vendor names the set
 * 0x95. Uncertain: The base rate of the set 0x94 is inferred from the 3DM-CV7-GNSS/INS.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cv7_ins;

/**
 * 3DM-CX5-10: Inertial measurement unit.
 *
 * Also called 3DM-CX5-IMU. Generation 5. Model number 6275. Sensors: accelerometer, gyroscope. GNSS
 * receivers: none. GNSS antennas: none. Sets known completely from the manual: MIP_BASE_SET.
 * Manual: 3DM-CX5-10 Data Communications Protocol Manual, 8500-0087 revision A, 2017, known from
 * its contents. This profile is incomplete: Of the manual, only the table of contents is known, up
 * to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`. Uncertain: The sensors are
 * inferred from the name of the model; that it has no magnetometer also from MSCL, which offers it
 * no north compensation.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx5_10;

/**
 * 3DM-CX5-15: Attitude reference.
 *
 * Also called 3DM-CX5-AR. Generation 5. Model number 6274. Sensors: accelerometer, gyroscope,
 * pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
 * incomplete: No manual is known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx5_15;

/**
 * 3DM-CX5-25: Attitude and heading reference system.
 *
 * Also called 3DM-CX5-AHRS. Generation 5. Model number 6273. Sensors: accelerometer, gyroscope,
 * magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. Manual: 3DM-CX5-25 Data
 * Communications Protocol Manual, 8500-0085 revision A, 2017, known from its title. This profile is
 * incomplete: Of the manual, only the title is known. It has 149 pages.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx5_25;

/**
 * 3DM-CX5-45: Inertial navigation system with GNSS.
 *
 * Also called 3DM-CX5-GNSS/INS. Generation 5. Model number 6271. Sensors: accelerometer, gyroscope,
 * magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: 3DM-CX5-45 Data
 * Communications Protocol Manual, 8500-0089 revision A, 2017, known from its title. This profile is
 * incomplete: Of the manual, only the title is known. It has 196 pages, and describes the data from
 * page 131.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx5_45;

/**
 * 3DM-CX7-AHRS: Attitude and heading reference system.
 *
 * Generation 7. Model number 6701. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
 * incomplete: No manual is known. Uncertain: Only MSCL lists it; the SDK does not.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx7_ahrs;

/**
 * 3DM-CX7-AR: Attitude reference.
 *
 * Generation 7. Model number 6700. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
 * receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
 * is known. Uncertain: Only MSCL lists it; the SDK does not.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx7_ar;

/**
 * 3DM-CX7-INS: Inertial navigation system.
 *
 * Generation 7. Model number 6702. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
 * incomplete: No manual is known. Uncertain: Only MSCL lists it; the SDK does not.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_cx7_ins;

/**
 * 3DM-DH3: Device of generation 3.
 *
 * Generation 3. Model number 6219. No manual is known. This profile is incomplete: No manual is
 * known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_dh3;

/**
 * 3DM-GQ4-45: Tactical grade inertial navigation system with GNSS.
 *
 * Generation 4. Model number 6250. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-GQ4-45 Data Communications
 * Protocol, of September 26, 2015, known from its table of contents. This profile is incomplete:
 * The manual's table of contents is known only up to the commands of the set `3dm`. The unknown
 * part includes the sets `filter` and `system`. This profile is incomplete: It has the data sets
 * 0x80, 0x81 and 0x82, but none of their fields are known. Uncertain: It may accept raw RTCM by a
 * command whose layout is not known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gq4_45;

/**
 * 3DM-GQ7-GNSS/INS: Inertial navigation system with two GNSS receivers.
 *
 * Also called 3DM-GQ7. Generation 7. Model number 6284. Sensors: accelerometer, gyroscope,
 * magnetometer, pressure sensor. GNSS receivers: 2. GNSS antennas: 2. Manual: MicroStrain 3DM-GQ7
 * Documentation, online, known from some pages. This profile is incomplete: Only some pages of its
 * manual are known; the device has further commands and data. This profile is incomplete: The baud
 * rates of the Aux port are not known, nor all of its protocols. Uncertain: The values of
 * mip_filter_magnetic_declination_source are those that MSCL offers. Uncertain: According to MSCL,
 * firmware from 1.0 to below 1.1 has only the values `all_internal` and `external` of
 * mip_filter_gnss_source.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gq7;

/**
 * 3DM-GV7-AHRS: Attitude and heading reference system.
 *
 * Generation 7. Model number 6288. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
 * incomplete: No manual is known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gv7_ahrs;

/**
 * 3DM-GV7-AR: Attitude reference.
 *
 * Generation 7. Model number 6289. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
 * receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
 * is known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gv7_ar;

/**
 * 3DM-GV7-INS: Inertial navigation system.
 *
 * Generation 7. Model number 6290. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
 * incomplete: No manual is known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gv7_ins;

/**
 * 3DM-GX3-15: Inertial sensor of generation 3.
 *
 * Generation 3. Model number 6227. Sensors: accelerometer, gyroscope. GNSS receivers: none. GNSS
 * antennas: none. No manual is known. This profile is incomplete: Its manual (8500-0024, revision
 * 002 of 2012, for firmware 2.0.00 and later) is not known. Uncertain: The sensors are inferred
 * from the name of the model; that it has no magnetometer also from MSCL, which offers it no north
 * compensation.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx3_15;

/**
 * 3DM-GX3-25: Inertial sensor of generation 3.
 *
 * Generation 3. Model number 6223. Sensors: accelerometer, gyroscope, magnetometer. GNSS receivers:
 * none. GNSS antennas: none. No manual is known. This profile is incomplete: Its manual (8500-0024,
 * revision 002 of 2012, for firmware 2.0.00 and later) is not known. Uncertain: The sensors are
 * inferred from the name of the model.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx3_25;

/**
 * 3DM-GX3-35: Inertial sensor of generation 3.
 *
 * Generation 3. Model number 6225. Sensors: accelerometer, gyroscope, magnetometer. GNSS receivers:
 * 1. GNSS antennas: 1. No manual is known. This profile is incomplete: Its manual (1.00 of
 * 2011-01-04) is not known. Uncertain: The sensors are inferred from the name of the model.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 * - mip-sdk-2014: Example of the 3DM-GX3-35
 */
extern MIP_API const struct mip_profile mip_profile_gx3_35;

/**
 * 3DM-GX3-45: Inertial sensor of generation 3.
 *
 * Generation 3. Model number 6228. Sensors: accelerometer, gyroscope, magnetometer. GNSS receivers:
 * 1. GNSS antennas: 1. No manual is known. This profile is incomplete: No manual is known.
 * Uncertain: The SDK of 2014 has the model number 6226. Uncertain: The sensors are inferred from
 * the name of the model.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 * - mip-sdk-2014: Example of the 3DM-GX3-45
 */
extern MIP_API const struct mip_profile mip_profile_gx3_45;

/**
 * 3DM-GX4-15: Device of generation 4.
 *
 * Generation 4. Model number 6233. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
 * receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
 * is known. Uncertain: The sensors are inferred from the name of the model; that it has no
 * magnetometer also from MSCL, which offers it no north compensation.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx4_15;

/**
 * 3DM-GX4-25: Device of generation 4.
 *
 * Generation 4. Model number 6234. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
 * incomplete: Its manual (of 2014-12-23) is not known. Uncertain: A third-party ROS driver uses the
 * model number 6253 for it, which is that of the 3DM-GX5-25. Uncertain: The sensors are inferred
 * from the name of the model.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx4_25;

/**
 * 3DM-GX4-45: Device of generation 4.
 *
 * Generation 4. Model number 6236. Sensors: accelerometer, gyroscope, magnetometer, pressure
 * sensor. GNSS receivers: 1. GNSS antennas: 1. No manual is known. This profile is incomplete: No
 * manual is known. Uncertain: The sensors are inferred from the name of the model.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx4_45;

/**
 * 3DM-GX4-IMU: Inertial sensor inside the 3DM-GX4-45, which replies in the direct mode.
 *
 * Generation 4. Model number 6237. No manual is known. This profile is incomplete: No manual is
 * known.
 *
 * - mip-sdk-2014: GX4 IMU
 */
extern MIP_API const struct mip_profile mip_profile_gx4_imu;

/**
 * 3DM-GX5-15: Vertical reference unit with an inertial sensor, a pressure sensor and an estimation
 * filter.
 *
 * Also called 3DM-GX5-AR. Generation 5. Model number 6254. Sensors: accelerometer, gyroscope,
 * pressure sensor. GNSS receivers: none. GNSS antennas: none. Manual: LORD Sensing 3DM-GX5-15 Data
 * Communications Protocol, 8500-0067 rev. E.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx5_15;

/**
 * 3DM-GX5-25: Attitude and heading reference system.
 *
 * Also called 3DM-GX5-AHRS. Generation 5. Model number 6253. Sensors: accelerometer, gyroscope,
 * magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known.
 * This profile is incomplete: Its manual (8500-0065) is not known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx5_25;

/**
 * 3DM-GX5-35: Attitude and heading reference system (AHRS) with GNSS.
 *
 * Also called 3DM-GX5-GNSS/AHRS. Generation 5. Model number 6252. Sensors: accelerometer,
 * gyroscope, magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD
 * 3DM-GX5-35 DCP Manual, revision unknown, known from some pages. This profile is incomplete: Only
 * some pages of its manual are known; the device has further commands and data. Uncertain: The base
 * rates are those that the manual states for all 3DM-GX5.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx5_35;

/**
 * 3DM-GX5-45: Inertial navigation system with GNSS, magnetometer and pressure sensor.
 *
 * Also called 3DM-GX5-GNSS/INS. Generation 5. Model number 6251. Sensors: accelerometer, gyroscope,
 * magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-GX5-45 DCP
 * Manual, 8500-0064 rev. C, known from some pages. This profile is incomplete: Only some pages of
 * its manual are known; the device has further commands and data. This profile is incomplete: Only
 * four fields of the filter data are listed; the manual documents 27 or more. Uncertain: The values
 * of mip_filter_gnss_source are those that MSCL offers. Uncertain: The base rates are those that
 * the manuals of the 3DM-GX5-35 and the 3DM-GX5-45 state for all 3DM-GX5. Uncertain: An example in
 * the manual has a base rate of 100 Hz for the sensor data. Uncertain: The manual states the length
 * of mip_3dm_device_status_basic_without_state_response and offsets of
 * mip_3dm_device_status_diagnostic_gx4_response; MSCL differs.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_gx5_45;

/**
 * 3DM-MV5-AR: Device of generation 5.
 *
 * Also called 3DM-MV5-15. Generation 5. Model number 6243. Sensors: accelerometer, gyroscope. GNSS
 * receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
 * is known. Uncertain: The sensors are inferred from the name of the model.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_mv5_ar;

/**
 * 3DM-RQ1-45-LT: Ruggedized tactical grade inertial navigation system with GPS.
 *
 * Also called 3DM-RQ1-45_LT. Generation 4. Model number 6232. GNSS receivers: 1. GNSS antennas: 1.
 * Manual: LORD 3DM-RQ1-45 Data Communications Protocol, of June 25, 2013, known from its table of
 * contents. This profile is incomplete: The manual's table of contents is known only up to
 * mip_filter_set_initial_heading. The unknown part includes the set `system`. This profile is
 * incomplete: It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.
 * Uncertain: The SDK writes the name with an underscore before LT and ST.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_rq1_45_lt;

/**
 * 3DM-RQ1-45-ST: Ruggedized tactical grade inertial navigation system with GPS.
 *
 * Also called 3DM-RQ1-45_ST. Generation 4. Model number 6239. GNSS receivers: 1. GNSS antennas: 1.
 * Manual: LORD 3DM-RQ1-45 Data Communications Protocol, of June 25, 2013, known from its table of
 * contents. This profile is incomplete: The manual's table of contents is known only up to
 * mip_filter_set_initial_heading. The unknown part includes the set `system`. This profile is
 * incomplete: It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.
 * Uncertain: The SDK writes the name with an underscore before LT and ST.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_rq1_45_st;

/**
 * 3DM-RQ1-IMU: Inertial sensor inside the 3DM-RQ1-45, which replies in the direct mode.
 *
 * Generation 4. Model number 6238. No manual is known. This profile is incomplete: No manual is
 * known.
 *
 * - mip-sdk-2014: RQ1 IMU
 */
extern MIP_API const struct mip_profile mip_profile_rq1_imu;

/**
 * 3DM-RTK: Modem for GNSS corrections.
 *
 * Generation 7. Model number 6285. No manual is known. This profile is incomplete: No manual is
 * known.
 *
 * - mip-sdk-4: Device models
 * - mscl: MIP node features
 */
extern MIP_API const struct mip_profile mip_profile_rtk;

/**
 * DEMOD-DC: Digital demodulator for displacement sensors.
 *
 * Also called Digital Demod. Model number 6130. No manual is known. This profile is incomplete: No
 * manual is known; everything here is from MSCL.
 *
 * - mscl: Displacement node
 */
extern MIP_API const struct mip_profile mip_profile_demod_dc;

/** Returns the model number in the device information, for example for mip_reading_of_model; 0 if
 * it has none. Links no profiles. */
static inline uint16_t mip_device_model(const struct mip_base_get_device_info_response *identity) {
    uint16_t number = mip_model_number(identity->device_info.model_number,
                                       sizeof(identity->device_info.model_number));
    number = number != 0 ? number
                         : mip_model_number(identity->device_info.serial_number,
                                            sizeof(identity->device_info.serial_number));
    return number;
}

/** Finds the profile of a device by its device information. NULL if there is none, for example for
 * a newer device. Links the profiles of all devices. */
static inline const struct mip_profile *
mip_device_profile(const struct mip_base_get_device_info_response *identity) {
    return mip_profile_by_model(mip_device_model(identity));
}

#ifdef __cplusplus
}
#endif

#endif
