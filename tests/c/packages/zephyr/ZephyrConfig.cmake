# Stands in for Zephyr, as far as a module sees it: options of prj.conf, modules by their module.yml, the library app.
project(Zephyr-Kernel LANGUAGES C)

file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/prj.conf options REGEX "^CONFIG_[A-Z0-9_]+=y$")
foreach(option ${options})
  string(REPLACE "=y" "" option ${option})
  set(${option} y)
endforeach()

add_library(zephyr_interface INTERFACE)
add_library(zephyr_libraries INTERFACE)

function(zephyr_include_directories)
  target_include_directories(zephyr_interface INTERFACE ${ARGN})
endfunction()

macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC)
  target_link_libraries(${name} PRIVATE zephyr_interface)
  target_link_libraries(zephyr_libraries INTERFACE ${name})
endmacro()

function(zephyr_library_sources)
  target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()

foreach(module ${ZEPHYR_EXTRA_MODULES})
  file(STRINGS ${module}/zephyr/module.yml lines REGEX "^  cmake: ")
  string(REPLACE "  cmake: " "" folder ${lines})
  add_subdirectory(${module}/${folder} modules)
endforeach()

add_library(app STATIC)
file(WRITE ${CMAKE_BINARY_DIR}/empty.c "extern int nothing;\n")
add_executable(program ${CMAKE_BINARY_DIR}/empty.c)
target_link_libraries(app PUBLIC zephyr_interface zephyr_libraries)
target_link_libraries(program app)
