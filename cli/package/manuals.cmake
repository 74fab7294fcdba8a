# SPDX-License-Identifier: BSD-3-Clause
# cmake -DFCA_IO=... -DFOLDER=... -P manuals.cmake: the manual pages of the command and each of its subcommands, as the command
# prints them, compressed.
execute_process(COMMAND ${FCA_IO} complete help "" OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[a-z]+" commands "${commands}")
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
list(APPEND commands "fca-io")
foreach(command IN LISTS commands)
  set(page ${FOLDER}/fca-io-${command}.1)
  set(which ${command})
  if(command STREQUAL "fca-io")
    set(page ${FOLDER}/fca-io.1)
    set(which)
  endif()
  execute_process(COMMAND ${FCA_IO} manual ${which} OUTPUT_FILE ${page} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
