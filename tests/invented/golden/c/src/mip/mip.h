/**
 * @file
 * The whole library. It takes longer to compile than the headers of single descriptor sets, but
 * nothing that a program does not use is linked.
 */
#ifndef MIP_MIP_H
#define MIP_MIP_H

#include "mip/3d.h"
#include "mip/3d_commands.h"
#include "mip/3d_inline.h"
#include "mip/client.h"
#include "mip/constants.h"
#include "mip/core.h"
#include "mip/device.h"
#include "mip/measurements.h"
#include "mip/measurements_inline.h"
#include "mip/names.h"
#include "mip/print.h"
#include "mip/profile.h"
#include "mip/profiles.h"
#include "mip/protocol.h"
#include "mip/protocol_inline.h"
#include "mip/reflect.h"
#include "mip/registry.h"
#include "mip/shared.h"
#include "mip/shared_inline.h"
#include "mip/stream.h"
#include "mip/tools.h"
#include "mip/tools_commands.h"
#include "mip/tools_inline.h"
#include "mip/types.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/mip.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifdef __cplusplus
}
#endif

#endif
