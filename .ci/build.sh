# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts that build: configures and builds a preset, from the top of the repository.

# build PRESET [TARGET...]
build() {
  local preset=$1 launcher='' quiet=()
  shift
  # A compiler cache makes every build but the first one short.
  if command -v ccache >/dev/null; then launcher=ccache; fi
  # Progress is for people; a log wants only what went wrong.
  [[ -t 1 ]] || quiet=(-- --quiet)
  echo "building with the $preset preset in build/$preset"
  # What CMake finds where is in its cache; its errors come on the other channel.
  cmake --preset "$preset" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >/dev/null
  cmake --build --preset "$preset" --parallel "$(nproc)" ${@:+--target "$@"} "${quiet[@]}"
}
