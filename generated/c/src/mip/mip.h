/**
 * @file
 * The whole library, without mip/extra and mip/cpp. It takes longer to compile than the headers of
 * single descriptor sets, but nothing that a program does not use is linked.
 */
#ifndef MIP_MIP_H
#define MIP_MIP_H

#include "mip/3dm.h"
#include "mip/3dm_commands.h"
#include "mip/3dm_inline.h"
#include "mip/aiding.h"
#include "mip/aiding_commands.h"
#include "mip/aiding_inline.h"
#include "mip/base.h"
#include "mip/base_commands.h"
#include "mip/base_inline.h"
#include "mip/client.h"
#include "mip/connect.h"
#include "mip/constants.h"
#include "mip/core.h"
#include "mip/device.h"
#include "mip/displacement.h"
#include "mip/displacement_commands.h"
#include "mip/displacement_data.h"
#include "mip/displacement_data_inline.h"
#include "mip/displacement_data_valid.h"
#include "mip/displacement_inline.h"
#include "mip/filter.h"
#include "mip/filter_commands.h"
#include "mip/filter_data.h"
#include "mip/filter_data_inline.h"
#include "mip/filter_data_valid.h"
#include "mip/filter_inline.h"
#include "mip/gnss.h"
#include "mip/gnss_commands.h"
#include "mip/gnss_data.h"
#include "mip/gnss_data_inline.h"
#include "mip/gnss_data_valid.h"
#include "mip/gnss_inline.h"
#include "mip/protocol.h"
#include "mip/protocol_inline.h"
#include "mip/rtk.h"
#include "mip/rtk_commands.h"
#include "mip/rtk_inline.h"
#include "mip/rtk_valid.h"
#include "mip/sensor.h"
#include "mip/sensor_inline.h"
#include "mip/sensor_valid.h"
#include "mip/shared.h"
#include "mip/shared_inline.h"
#include "mip/shared_valid.h"
#include "mip/system.h"
#include "mip/system_commands.h"
#include "mip/system_data.h"
#include "mip/system_data_inline.h"
#include "mip/system_inline.h"
#include "mip/timestamps.h"
#include "mip/types.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/mip.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifdef __cplusplus
}
#endif

#endif
