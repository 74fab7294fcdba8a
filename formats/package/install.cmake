# SPDX-License-Identifier: BSD-3-Clause
# The package: find_package(fca-io) gives fca::core, fca::formats and fca::toolkit. One export for each, so that a program that
# wants only the core need not have what the others need.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fca-io)
install(TARGETS fca-core EXPORT fca-io-core-targets COMPONENT dev)
install(TARGETS fca-formats EXPORT fca-io-formats-targets COMPONENT dev)
install(TARGETS fca-toolkit EXPORT fca-io-toolkit-targets COMPONENT dev)
install(EXPORT fca-io-core-targets NAMESPACE fca:: DESTINATION ${package_dir} COMPONENT dev)
install(EXPORT fca-io-formats-targets NAMESPACE fca:: DESTINATION ${package_dir} COMPONENT dev)
install(EXPORT fca-io-toolkit-targets NAMESPACE fca:: DESTINATION ${package_dir} COMPONENT dev)
install(DIRECTORY lib/include/ formats/include/ cli/toolkit/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)

configure_package_config_file(formats/package/fca-io-config.cmake.in ${PROJECT_BINARY_DIR}/fca-io-config.cmake
                              INSTALL_DESTINATION ${package_dir})
# Before 1.0, a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fca-io-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fca-io-config.cmake ${PROJECT_BINARY_DIR}/fca-io-config-version.cmake
        DESTINATION ${package_dir} COMPONENT dev)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT dev)
if(TARGET fca-io)
  install(TARGETS fca-io COMPONENT command)
  install(TARGETS fca-storage-module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/fca-io COMPONENT command)
  install(TARGETS fca-pictures-module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/fca-io COMPONENT images)
  include(cli/package/packages.cmake)
endif()
