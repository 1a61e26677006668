/**
 * @file
 * The devices. Plain tables: a program that uses one device links only that one.
 */
#ifndef MIP_PROFILES_H
#define MIP_PROFILES_H

#include "mip/constants.h"
#include "mip/profile.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/profiles.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Model A: Supports nearly everything.
 *
 * Model number 4711. Manual: A guide to devices that do not exist, 1.
 */
extern MIP_API const struct mip_profile mip_profile_model_a;

/**
 * Model B: Small, and reads the acknowledge code in its own way.
 *
 * Manual: A leaflet about one of them, 2.
 */
extern MIP_API const struct mip_profile mip_profile_model_b;

/**
 * Model C: Like the model A, with a radio and without a choice.
 *
 * Also called Model See and c. Generation 3. Model number 4713. Same as the Model A, except as
 * stated here. No manual is known. Uncertain: Whether it has a model number of its own.
 *
 * - sheet: Radio
 */
extern MIP_API const struct mip_profile mip_profile_model_c;

/**
 * Old 1: Known by its name and number.
 *
 * Also called First. Generation 1. Model number 4001. No manual is known. This profile is
 * incomplete: No manual is known; see mip_tools_ping.
 *
 * - sheet: Names
 */
extern MIP_API const struct mip_profile mip_profile_old_1;

/**
 * Old 2: Known by its name and number.
 *
 * Generation 1. Model number 4002. No manual is known. This profile is incomplete: Nothing is known
 * of its data.
 *
 * - sheet: Names
 */
extern MIP_API const struct mip_profile mip_profile_old_2;

#ifdef __cplusplus
}
#endif

#endif
