# Version and generated sources of the mip library, for CMakeLists.txt.
set(MIP_VERSION 0.1.0)
set(MIP_GENERATED_SOURCES
  src/3dm.c
  src/aiding.c
  src/base.c
  src/devices.c
  src/filter.c
  src/filter_data.c
  src/gnss.c
  src/gnss_1.c
  src/protocol.c
  src/reflection.c
  src/registry.c
  src/rtk.c
  src/sensor.c
  src/shared.c
  src/system.c
  src/system_data.c
  src/types.c
)
