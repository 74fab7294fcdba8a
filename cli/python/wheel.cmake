# SPDX-License-Identifier: BSD-3-Clause
# cmake -DVERSION=... -DPYTHON=... -DPYTHON_VERSION=3.11 -DPLATFORM=linux_x86_64 -DSTRIP=... -DOBJDUMP=... -DPACKAGE=FOLDER
# -DMODULE=FILE -DLICENCE=FILE -DSTAGE=FOLDER -DTO=FOLDER -P wheel.cmake: makes fca_io-VERSION-cp311-cp311-linux_x86_64.whl of the
# package in the build tree. SOURCE_DATE_EPOCH makes it the same to the last byte.
cmake_minimum_required(VERSION 3.25)
set(info ${STAGE}/fca_io-${VERSION}.dist-info)
file(REMOVE_RECURSE ${STAGE})
file(COPY ${PACKAGE}/__init__.py ${PACKAGE}/__init__.pyi ${PACKAGE}/py.typed ${MODULE} DESTINATION ${STAGE}/fca_io)
get_filename_component(module ${MODULE} NAME)
execute_process(COMMAND ${STRIP} --strip-unneeded ${STAGE}/fca_io/${module} COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${LICENCE} DESTINATION ${info})

# The libraries that it does not bring along, by their names in the file itself.
execute_process(COMMAND ${OBJDUMP} --private-headers ${STAGE}/fca_io/${module} OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "NEEDED +[^ \n]+" needed "${headers}")
list(TRANSFORM needed REPLACE "NEEDED +" "Requires-External: ")
list(JOIN needed "\n" needed)
string(REPLACE "." "" short ${PYTHON_VERSION})
set(tag cp${short}-cp${short}-${PLATFORM})
configure_file(${CMAKE_CURRENT_LIST_DIR}/wheel/METADATA.in ${info}/METADATA @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/wheel/WHEEL.in ${info}/WHEEL @ONLY)
execute_process(COMMAND ${PYTHON} -m wheel pack --dest-dir ${TO} ${STAGE} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
