# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts that build: configures and builds a preset, from the top of the repository.

# configure PRESET [CMAKE_OPTION...]: an option stays until the folder is gone or another value is given.
configure() {
  local launcher=''
  # A compiler cache makes every build but the first one short.
  if command -v ccache >/dev/null; then launcher=ccache; fi
  # What CMake finds where is in its cache; its errors come on the other channel.
  cmake --preset "$1" --no-warn-unused-cli -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" "${@:2}" >/dev/null
}

# build PRESET [TARGET...]
build() {
  local preset=$1 quiet=()
  shift
  # Progress is for people; a log wants only what went wrong.
  [[ -t 1 ]] || quiet=(-- --quiet)
  echo "building with the $preset preset in build/$preset"
  configure "$preset"
  cmake --build --preset "$preset" --parallel "$(nproc)" ${@:+--target "$@"} "${quiet[@]}"
}
