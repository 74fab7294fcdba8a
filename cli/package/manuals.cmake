# SPDX-License-Identifier: BSD-3-Clause
# cmake -DFCA_IO=... -DFOLDER=... -P manuals.cmake: the manual pages of the command and each of its subcommands, as the command
# prints them, compressed.
execute_process(COMMAND ${FCA_IO} complete "" OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[a-z]+" commands "${commands}")
list(REMOVE_ITEM commands files)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
foreach(command IN LISTS commands ITEMS "")
  string(REGEX REPLACE "(.+)" "-\\1" suffix "${command}")
  set(page ${FOLDER}/fca-io${suffix}.1)
  execute_process(COMMAND ${FCA_IO} manual ${command} OUTPUT_FILE ${page} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
