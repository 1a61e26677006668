# Version and generated sources of the mip library, for CMakeLists.txt.
set(MIP_VERSION 0.1.0)
set(MIP_GENERATED_SOURCES
  src/3d.c
  src/devices.c
  src/measurements.c
  src/more.c
  src/protocol.c
  src/reflection.c
  src/registry.c
  src/shared.c
  src/tools.c
  src/types.c
)
