/**
 * @file
 *
 * Displacement commands (0x11). Commands of the DEMOD-DC, a demodulator for displacement sensors.
 * Inertial sensors have none of them.
 */
#ifndef MIP_DISPLACEMENT_H
#define MIP_DISPLACEMENT_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/displacement.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement Displacement commands (0x11)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_DISPLACEMENT_SET 0x11

/** @} */

#ifdef __cplusplus
}
#endif

#endif
