# Version and generated sources of the mip library, for CMakeLists.txt.
set(MIP_VERSION 0.1.0)
set(MIP_GENERATED_SOURCES
  src/mip/3d.c
  src/mip/copy.c
  src/mip/measurements.c
  src/mip/more.c
  src/mip/names.c
  src/mip/profiles.c
  src/mip/protocol.c
  src/mip/reflection.c
  src/mip/registry.c
  src/mip/shared.c
  src/mip/tools.c
)
