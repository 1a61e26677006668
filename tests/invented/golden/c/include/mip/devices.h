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
 * Model A: Supports nearly everything.
 *
 * Model number 4711. Manual: A guide to devices that do not exist, 1.
 */
extern const struct mip_device mip_device_model_a;

/**
 * Model B: Small, and reads the acknowledge code in its own way.
 *
 * Manual: A leaflet about one of them, 2.
 */
extern const struct mip_device mip_device_model_b;

#ifdef __cplusplus
}
#endif

#endif
