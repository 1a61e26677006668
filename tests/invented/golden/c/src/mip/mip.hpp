/**
 * @file
 * The whole library in C++17, except ostream.hpp. It takes longer to compile than the headers of
 * single descriptor sets.
 */
#ifndef MIP_MIP_HPP
#define MIP_MIP_HPP

#include "mip/3d.hpp"
#include "mip/3d_commands.hpp"
#include "mip/client.hpp"
#include "mip/core.hpp"
#include "mip/device.hpp"
#include "mip/measurements.hpp"
#include "mip/shared.hpp"
#include "mip/tools.hpp"
#include "mip/tools_commands.hpp"
#include "mip/types.hpp"

#endif
