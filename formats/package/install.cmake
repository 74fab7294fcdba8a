# SPDX-License-Identifier: BSD-3-Clause
# The package: find_package(fca-io) gives fca::core and fca::formats.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fca-io)
install(TARGETS fca-core fca-formats EXPORT fca-io-targets)
install(DIRECTORY lib/include/ formats/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT fca-io-targets NAMESPACE fca:: DESTINATION ${package_dir})
configure_package_config_file(formats/package/fca-io-config.cmake.in ${PROJECT_BINARY_DIR}/fca-io-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fca-io-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fca-io-config.cmake ${PROJECT_BINARY_DIR}/fca-io-config-version.cmake
        DESTINATION ${package_dir})
if(TARGET fca-io)
  install(TARGETS fca-io)
endif()
