// SPDX-License-Identifier: BSD-3-Clause
// The core of a conversion, sampling and fit together at N = 200: the paper's 12 pairs, and a selection of others. Not in it:
// the field of view, which a conversion asks for once, and the evaluation.
#include "lib/convert/known_cameras.h"

#include <convert/fitting/fit_model.h>
#include <convert/sampling/edge_samples.h>
#include <fca/convert/field_of_view.h>
#include <fca/convert/sample.h>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

namespace fca {
namespace {

constexpr int kSamples = 200;

struct Source {
  const char* name;
  Camera camera;
  double max_angle_deg;
};

void convert_core(benchmark::State& state, const Source& source, const std::string& target) {
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view =
      field_of_view_of(source.camera, source.max_angle_deg * test::kRadians, diagnostics);
  const LensCentre centre{central_focal_lengths(source.camera.model), principal_point(source.camera.model)};
  std::optional<internal::FittedModel> fitted;
  for (auto _ : state) {
    std::vector<Correspondence> samples = sample(source.camera.model, *field_of_view, kSamples);
    if (internal::may_end_early(target)) internal::add_edge(source.camera.model, *field_of_view, samples);
    fitted = internal::fit_model(target, samples, centre, {});
    benchmark::DoNotOptimize(fitted);
  }
  if (!fitted) {
    state.SkipWithError("no fit");
    return;
  }
  char label[64];
  std::snprintf(label, sizeof label, "%d iterations; rms %.3g px", fitted->iterations, fitted->rms_px);
  state.SetLabel(label);
}

void sampling(benchmark::State& state, const Source& source) {
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view =
      field_of_view_of(source.camera, source.max_angle_deg * test::kRadians, diagnostics);
  for (auto _ : state) benchmark::DoNotOptimize(sample(source.camera.model, *field_of_view, kSamples));
}

void add(const std::string& group, const Source& source, const std::vector<std::string>& targets) {
  for (const std::string& target : targets) {
    const std::string name = group + "/" + source.name + "/" + target;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { convert_core(state, source, target); });
  }
}

const bool kRegistered = [] {
  constexpr double kWholeImage = 180.0;
  const Source kb4{"kalibr-kb4", test::kalibr_kb4(), kWholeImage};
  const Source eucm{"kalibr-eucm", test::kalibr_eucm(), kWholeImage};
  const Source ds{"kalibr-ds", test::kalibr_ds(), kWholeImage};
  const Source radtan{"kalibr-radtan", test::kalibr_radtan(), kWholeImage};
  const Source tumvi{"tumvi", test::tumvi(), 97.5};
  const Source lens_220{"220-degree", test::lens_220(), 110.0};
  const Source woodscape{"woodscape", test::woodscape_front(), 95.0};
  for (const Source& source : {kb4, eucm, ds, radtan, tumvi, woodscape}) {
    const std::string name = std::string("sample/") + source.name;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { sampling(state, source); });
  }
  add("paper", kb4, {"eucm", "ds", "radtan"});
  add("paper", eucm, {"kb4", "ds", "radtan"});
  add("paper", ds, {"kb4", "eucm", "radtan"});
  add("paper", radtan, {"kb4", "eucm", "ds"});
  const std::vector<std::string> others = {"ucm", "rational", "ocamcalib", "woodscape", "mei", "fov"};
  for (const Source& source : {kb4, ds, radtan}) add("other", source, others);
  add("other", tumvi, {"ucm", "eucm", "ds", "ocamcalib", "woodscape", "mei"});
  add("other", lens_220, {"eucm", "ds", "ocamcalib"});
  add("other", woodscape, {"kb4", "eucm", "ds", "ocamcalib", "mei"});
  return true;
}();

}  // namespace
}  // namespace fca
