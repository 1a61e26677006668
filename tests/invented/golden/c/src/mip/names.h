/**
 * @file
 * The names of all values and bits. Only those that a program uses are linked.
 */
#ifndef MIP_NAMES_H
#define MIP_NAMES_H

#include "mip/constants.h"
#include "mip/reflect.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/names.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** function_selector */
extern MIP_API const struct mip_names mip_names_function_selector;
/** ack_code */
extern MIP_API const struct mip_names mip_names_ack_code;
/** mode */
extern MIP_API const struct mip_names mip_names_mode;
/** wide_code */
extern MIP_API const struct mip_names mip_names_wide_code;
/** state_flags */
extern MIP_API const struct mip_names mip_names_state_flags;
/** health */
extern MIP_API const struct mip_names mip_names_health;
/** tools.shape */
extern MIP_API const struct mip_names mip_names_tools_shape;
/** tools.fill */
extern MIP_API const struct mip_names mip_names_tools_fill;
/** tools.drive */
extern MIP_API const struct mip_names mip_names_tools_drive;
/** tools.pulse_use */
extern MIP_API const struct mip_names mip_names_tools_pulse;
/** tools.serial_use */
extern MIP_API const struct mip_names mip_names_tools_serial_use;
/** tools.model_a_faults */
extern MIP_API const struct mip_names mip_names_tools_a_faults;
/** tools.model_b_faults */
extern MIP_API const struct mip_names mip_names_tools_model_b_faults;

#ifdef __cplusplus
}
#endif

#endif
