// SPDX-License-Identifier: BSD-3-Clause
// How close the fits come to what the target models can reach, by every pixel: ours / floor, in the label. The time is that of
// the whole conversion, with every pixel and without the bound.
#include "lib/convert/floors.h"

#include <fca/convert/convert.h>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>

namespace fca {
namespace {

void reach_floor(benchmark::State& state, const test::Floor& floor) {
  ConvertOptions options;
  options.model = floor.target;
  options.every_pixel = true;
  options.bound = false;
  if (floor.max_angle_deg) options.max_angle_rad = *floor.max_angle_deg * test::kRadians;
  std::optional<Conversion> conversion;
  for (auto _ : state) {
    Diagnostics diagnostics;
    conversion = convert(floor.camera, options, diagnostics);
  }
  if (!conversion) {
    state.SkipWithError("no conversion");
    return;
  }
  char label[64];
  std::snprintf(label, sizeof label, "ours / floor %.4f", conversion->report.statistics.error.rms / floor.rms);
  state.SetLabel(label);
}

const bool kRegistered = [] {
  for (const test::Floor& floor : test::floors()) {
    const std::string name = std::string("floor/") + floor.camera_name + "/" + floor.target;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { reach_floor(state, floor); });
  }
  return true;
}();

}  // namespace
}  // namespace fca
