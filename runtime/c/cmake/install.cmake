# Installs the library, its headers, and packages for find_package and pkg-config. All of it can be moved to another
# folder afterwards, unless CMAKE_INSTALL_LIBDIR or CMAKE_INSTALL_INCLUDEDIR is absolute.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mip)

install(TARGETS mip_protocol EXPORT mipTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${MIP_FOLDER}/src/mip DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN sets EXCLUDE)
if(TARGET mip_protocol_cpp)
  install(TARGETS mip_protocol_cpp EXPORT mipTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
if(TARGET mip_ports)
  install(TARGETS mip_ports EXPORT mipTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(FILES ${MIP_FOLDER}/ports/mip/line.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mip)
endif()
install(EXPORT mipTargets NAMESPACE mip:: DESTINATION ${package})

configure_package_config_file(${MIP_FOLDER}/cmake/mipConfig.cmake.in mipConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(mipConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/mipConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/mipConfigVersion.cmake
  DESTINATION ${package})

# For mip.pc: folders inside of the prefix relative to mip.pc, others as they are.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(MIP_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
  set(MIP_PC_LIBDIR ${CMAKE_INSTALL_LIBDIR})
else()
  file(RELATIVE_PATH up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" up ${up})
  set(MIP_PC_PREFIX "\${pcfiledir}/${up}")
  set(MIP_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
endif()
if(IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(MIP_PC_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR})
else()
  set(MIP_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
configure_file(${MIP_FOLDER}/cmake/mip.pc.in mip.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mip.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
