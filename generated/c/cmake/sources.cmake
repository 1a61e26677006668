# Version and sources of the mip library, for all build systems that are written in CMake.
set(MIP_VERSION 0.1.0)
get_filename_component(MIP_FOLDER ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(MIP_SOURCES
  ${MIP_FOLDER}/src/mip/3dm.c
  ${MIP_FOLDER}/src/mip/aiding.c
  ${MIP_FOLDER}/src/mip/base.c
  ${MIP_FOLDER}/src/mip/checksum.c
  ${MIP_FOLDER}/src/mip/client.c
  ${MIP_FOLDER}/src/mip/core.c
  ${MIP_FOLDER}/src/mip/devices.c
  ${MIP_FOLDER}/src/mip/error.c
  ${MIP_FOLDER}/src/mip/filter.c
  ${MIP_FOLDER}/src/mip/filter_data.c
  ${MIP_FOLDER}/src/mip/gnss.c
  ${MIP_FOLDER}/src/mip/gnss_1.c
  ${MIP_FOLDER}/src/mip/layout.c
  ${MIP_FOLDER}/src/mip/lookup.c
  ${MIP_FOLDER}/src/mip/parser.c
  ${MIP_FOLDER}/src/mip/profile.c
  ${MIP_FOLDER}/src/mip/protocol.c
  ${MIP_FOLDER}/src/mip/reflect.c
  ${MIP_FOLDER}/src/mip/reflection.c
  ${MIP_FOLDER}/src/mip/registry.c
  ${MIP_FOLDER}/src/mip/rtk.c
  ${MIP_FOLDER}/src/mip/sensor.c
  ${MIP_FOLDER}/src/mip/shared.c
  ${MIP_FOLDER}/src/mip/system.c
  ${MIP_FOLDER}/src/mip/system_data.c
  ${MIP_FOLDER}/src/mip/types.c
)
