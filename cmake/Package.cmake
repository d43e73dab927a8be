# What `cmake --install` adds so that find_package(trellis) works. tests/consumer uses the result.
# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trellis)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/trellis-config.cmake.in
    ${PROJECT_BINARY_DIR}/trellis-config.cmake
    INSTALL_DESTINATION ${package_dir})
# before 1.0 a minor version may break its users
write_basic_package_version_file(${PROJECT_BINARY_DIR}/trellis-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/trellis-config.cmake
    ${PROJECT_BINARY_DIR}/trellis-config-version.cmake
    DESTINATION ${package_dir})
install(EXPORT trellis
    FILE trellis-targets.cmake
    NAMESPACE trellis::
    DESTINATION ${package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/licenses/trellis)
