# SPDX-License-Identifier: BSD-3-Clause
# What is installed with the command (manual pages, completions), and `cmake --build ... --target package`: Debian packages; `tarball`:
# the command with its libraries, for other systems.
set(FCA_MANUALS ${PROJECT_BINARY_DIR}/cli/man1)
add_custom_command(OUTPUT ${FCA_MANUALS}/fca-io.1.gz
  COMMAND ${CMAKE_COMMAND} -DFCA_IO=$<TARGET_FILE:fca-io> -DFOLDER=${FCA_MANUALS} -P ${CMAKE_CURRENT_LIST_DIR}/manuals.cmake
  DEPENDS fca-io ${CMAKE_CURRENT_LIST_DIR}/manuals.cmake)
add_custom_target(fca-manuals ALL DEPENDS ${FCA_MANUALS}/fca-io.1.gz)
install(DIRECTORY ${FCA_MANUALS}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)

set(completions ${PROJECT_SOURCE_DIR}/cli/completions)
install(FILES ${completions}/fca-io.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME fca-io
  COMPONENT command)
install(FILES ${completions}/_fca-io DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT command)
install(FILES ${completions}/fca-io.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT command)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/cli/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/fca-io COMPONENT command)

add_custom_target(tarball DEPENDS fca-io fca-storage-module fca-manuals VERBATIM USES_TERMINAL
  COMMAND ${CMAKE_COMMAND} -E env CMAKE=${CMAKE_COMMAND} ${CMAKE_CURRENT_LIST_DIR}/tarball ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR})

# fca_package(COMPONENT NAME SECTION SUMMARY TEXT [DEPENDS ...]): one Debian package of that component, with its licence and
# changelog.
set(FCA_COMPONENTS "")
function(fca_package component name section summary text)
  cmake_parse_arguments(arg "" "DEPENDS;RECOMMENDS" "" ${ARGN})
  string(TOUPPER ${component} upper)
  set(doc ${CMAKE_INSTALL_DATAROOTDIR}/doc/${name})
  install(FILES ${PROJECT_SOURCE_DIR}/cli/package/copyright DESTINATION ${doc} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/cli/changelog.gz DESTINATION ${doc} COMPONENT ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_FILE_NAME DEB-DEFAULT PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${arg_DEPENDS}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS "${arg_RECOMMENDS}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
  list(APPEND FCA_COMPONENTS ${component})
  set(FCA_COMPONENTS ${FCA_COMPONENTS} PARENT_SCOPE)
endfunction()

set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${PROJECT_BINARY_DIR}/cli/changelog.gz
  COMMAND_ERROR_IS_FATAL ANY)

set(own "fca-io (= ${PROJECT_VERSION})")
fca_package(command fca-io science "converter and checker of camera calibration files"
  "fca-io reads camera calibrations of Kalibr, OpenCV, OCamCalib, ROS, COLMAP and\nothers, says what they mean, writes them for another program with another\ncamera model if need be, and proves that the program understands the result."
  RECOMMENDS "fca-io-images (= ${PROJECT_VERSION})")
fca_package(images fca-io-images science "images for fca-io"
  "What fca-io needs to read and to write images: undistorted pictures, and lens\ncircles found in images."
  DEPENDS "${own}")
fca_package(dev libfca-dev libdevel "camera calibration library (development files)"
  "Static libraries, headers and the CMake package of fca-io: camera models, fits\nwith proven bounds, the formats, and all that the command does as functions.\nThere is no promise about the binary interface before 1.0."
  DEPENDS "libceres-dev, libeigen3-dev, libfmt-dev, libmd-dev, libopencv-dev, libtinyxml2-dev, libyaml-cpp-dev, rapidjson-dev")
if(TARGET fca-python)
  fca_package(python python3-fca-io python "camera calibration files in Python"
    "The package fca_io: reads, checks, fits and converts camera calibrations;\nprojects arrays of points by any of the models."
    DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fca-io)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CONTACT "The fca-io authors <fca-io@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ${FCA_COMPONENTS})
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
foreach(component IN LISTS FCA_COMPONENTS)
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENT_${upper}_GROUP ${component})
endforeach()
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
