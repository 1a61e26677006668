# Version and sources of the mip library, for all CMake-based build systems.
set(MIP_VERSION 0.1.0)
get_filename_component(MIP_FOLDER ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(MIP_SOURCES
  ${MIP_FOLDER}/src/mip/3d.c
  ${MIP_FOLDER}/src/mip/client.c
  ${MIP_FOLDER}/src/mip/codec.c
  ${MIP_FOLDER}/src/mip/core.c
  ${MIP_FOLDER}/src/mip/device.c
  ${MIP_FOLDER}/src/mip/double.c
  ${MIP_FOLDER}/src/mip/error.c
  ${MIP_FOLDER}/src/mip/label.c
  ${MIP_FOLDER}/src/mip/lookup.c
  ${MIP_FOLDER}/src/mip/measurements.c
  ${MIP_FOLDER}/src/mip/names.c
  ${MIP_FOLDER}/src/mip/number.c
  ${MIP_FOLDER}/src/mip/outcome.c
  ${MIP_FOLDER}/src/mip/parser.c
  ${MIP_FOLDER}/src/mip/print.c
  ${MIP_FOLDER}/src/mip/profile.c
  ${MIP_FOLDER}/src/mip/profiles.c
  ${MIP_FOLDER}/src/mip/program.c
  ${MIP_FOLDER}/src/mip/protocol.c
  ${MIP_FOLDER}/src/mip/reflect.c
  ${MIP_FOLDER}/src/mip/reflection.c
  ${MIP_FOLDER}/src/mip/registry.c
  ${MIP_FOLDER}/src/mip/shared.c
  ${MIP_FOLDER}/src/mip/stream.c
  ${MIP_FOLDER}/src/mip/tools.c
  ${MIP_FOLDER}/src/mip/value.c
)
