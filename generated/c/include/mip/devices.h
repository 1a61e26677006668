/**
 * @file
 * The devices. Plain tables: a program that names one device links only that.
 */
#ifndef MIP_DEVICES_H
#define MIP_DEVICES_H

#include "mip/constants.h"
#include "mip/profile.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/devices.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * 3DM-CV7-GNSS/INS: Inertial navigation system with two RTK-capable GNSS receivers, magnetometer
 * and pressure sensor.
 *
 * Model number 6292. Manual: MicroStrain 3DM-CV7-GNSS/INS Documentation, 8500-0099.
 */
extern const struct mip_device mip_device_cv7_gnss_ins;

/**
 * 3DM-GX5-15: Vertical reference unit with an inertial sensor, a pressure sensor and an estimation
 * filter.
 *
 * Model number 6254. Manual: LORD Sensing 3DM-GX5-15 Data Communications Protocol, 8500-0067 rev.
 * E.
 */
extern const struct mip_device mip_device_gx5_15;

#ifdef __cplusplus
}
#endif

#endif
