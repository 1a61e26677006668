# Version and generated sources of the mip library, for CMakeLists.txt.
set(MIP_VERSION 0.1.0)
set(MIP_GENERATED_SOURCES
  src/mip/3dm.c
  src/mip/aiding.c
  src/mip/base.c
  src/mip/filter.c
  src/mip/filter_data.c
  src/mip/gnss.c
  src/mip/gnss_1.c
  src/mip/gnss_2.c
  src/mip/gnss_corrections.c
  src/mip/gnss_data.c
  src/mip/gnss_external.c
  src/mip/gnss_external_2.c
  src/mip/names.c
  src/mip/profiles.c
  src/mip/protocol.c
  src/mip/reflection.c
  src/mip/registry.c
  src/mip/rtk.c
  src/mip/sensor.c
  src/mip/shared.c
  src/mip/system.c
  src/mip/system_data.c
)
