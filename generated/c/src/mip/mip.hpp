/**
 * @file
 * The whole library in C++17, except ostream.hpp. It takes longer to compile than the headers of
 * single descriptor sets.
 */
#ifndef MIP_MIP_HPP
#define MIP_MIP_HPP

#include "mip/3dm.hpp"
#include "mip/3dm_commands.hpp"
#include "mip/aiding.hpp"
#include "mip/aiding_commands.hpp"
#include "mip/base.hpp"
#include "mip/base_commands.hpp"
#include "mip/client.hpp"
#include "mip/core.hpp"
#include "mip/device.hpp"
#include "mip/displacement.hpp"
#include "mip/displacement_commands.hpp"
#include "mip/displacement_data.hpp"
#include "mip/filter.hpp"
#include "mip/filter_commands.hpp"
#include "mip/filter_data.hpp"
#include "mip/gnss.hpp"
#include "mip/gnss_commands.hpp"
#include "mip/gnss_data.hpp"
#include "mip/rejected.hpp"
#include "mip/rtk.hpp"
#include "mip/rtk_commands.hpp"
#include "mip/sensor.hpp"
#include "mip/shared.hpp"
#include "mip/system.hpp"
#include "mip/system_commands.hpp"
#include "mip/system_data.hpp"
#include "mip/types.hpp"

#endif
