# Port of vcpkg: vcpkg install mip --overlay-ports=FOLDER/vcpkg. It builds the folder that it is in.
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/.." ABSOLUTE)

vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DMIP_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME mip CONFIG_PATH lib/cmake/mip)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
