/**
 * @file
 * All headers of C++17 in mip/cpp. It takes longer to compile than the headers of single descriptor
 * sets.
 */
#ifndef MIP_MIP_HPP
#define MIP_MIP_HPP

#include "mip/cpp/3dm.hpp"
#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/aiding.hpp"
#include "mip/cpp/aiding_commands.hpp"
#include "mip/cpp/base.hpp"
#include "mip/cpp/base_commands.hpp"
#include "mip/cpp/client.hpp"
#include "mip/cpp/core.hpp"
#include "mip/cpp/device.hpp"
#include "mip/cpp/displacement.hpp"
#include "mip/cpp/displacement_commands.hpp"
#include "mip/cpp/displacement_data.hpp"
#include "mip/cpp/filter.hpp"
#include "mip/cpp/filter_commands.hpp"
#include "mip/cpp/filter_data.hpp"
#include "mip/cpp/gnss.hpp"
#include "mip/cpp/gnss_commands.hpp"
#include "mip/cpp/gnss_data.hpp"
#include "mip/cpp/rtk.hpp"
#include "mip/cpp/rtk_commands.hpp"
#include "mip/cpp/sensor.hpp"
#include "mip/cpp/shared.hpp"
#include "mip/cpp/system.hpp"
#include "mip/cpp/system_commands.hpp"
#include "mip/cpp/system_data.hpp"
#include "mip/cpp/types.hpp"

#endif
