# SPDX-License-Identifier: BSD-3-Clause
# cmake -DSOURCE=... -DRESULT=FILE.cc -P origin.cmake: writes the file that tells `fca-io version` from what it was built, and leaves it
# alone where it says that already. From git, where SOURCE is the top of a repository; else the date is SOURCE_DATE_EPOCH's, else
# the one behind the newest version in CHANGELOG.md.
set(commit "")
set(date "")
set(changed false)
set(ENV{TZ} UTC)
find_program(GIT git)

# ask(RESULT WORD...): what git prints; empty where it fails.
function(ask result)
  execute_process(COMMAND ${GIT} -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE said ERROR_QUIET RESULT_VARIABLE code
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT code EQUAL 0)
    set(said "")
  endif()
  set(${result} "${said}" PARENT_SCOPE)
endfunction()

if(GIT)
  # A repository around it, into which somebody copied fca-io, is another one.
  ask(top rev-parse --show-toplevel)
  file(REAL_PATH ${SOURCE} source)
  if(top AND top STREQUAL source)
    ask(commit rev-parse HEAD)
    ask(date log -1 --date=format-local:%Y-%m-%d --format=%cd)
    ask(changes --no-optional-locks status --porcelain --untracked-files=no)
    if(changes)
      set(changed true)
    endif()
  endif()
endif()
if(NOT date AND DEFINED ENV{SOURCE_DATE_EPOCH})
  string(TIMESTAMP date "%Y-%m-%d" UTC)  # CMake takes it from there
endif()
if(NOT date)
  file(STRINGS ${SOURCE}/CHANGELOG.md versions REGEX "^## ")
  list(POP_FRONT versions newest)
  string(REGEX MATCH "[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]" date "${newest}")
endif()

file(CONFIGURE OUTPUT ${RESULT} @ONLY CONTENT [[
// Written by cli/package/origin.cmake.
#include "shell/origin.h"

namespace fca::cli {

Origin origin_of_build() { return {"@commit@", "@date@", @changed@}; }

}  // namespace fca::cli
]])
