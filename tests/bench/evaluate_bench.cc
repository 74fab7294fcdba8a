// SPDX-License-Identifier: BSD-3-Clause
// Evaluating a conversion: the certificate (lattice, polished maximum, bound) and every pixel, by source and target. The
// targets are fits, as those of a conversion are.
#include "lib/convert/known_cameras.h"

#include <convert/bound/bound.h>
#include <convert/evaluation/stages.h>
#include <fca/convert/convert.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace fca {
namespace {

struct Source {
  const char* name;
  Camera camera;
  std::optional<double> max_angle_deg;
};

/// A conversion to be evaluated.
struct Pair {
  FieldOfView field_of_view;
  CameraModel target;
};

Pair make_pair(const Source& source, const std::string& target) {
  ConvertOptions options;
  options.model = target;
  options.bound = false;
  if (source.max_angle_deg) options.max_angle_rad = *source.max_angle_deg * test::kRadians;
  Diagnostics diagnostics;
  return {field_of_view_of(source.camera, options.max_angle_rad, diagnostics).value(),
          convert(source.camera, options, diagnostics).value().camera.model};
}

void certificate(benchmark::State& state, const Source& source, const std::string& target) {
  const Pair pair = make_pair(source, target);
  ErrorStatistics statistics;
  for (auto _ : state) statistics = evaluate(source.camera.model, pair.target, pair.field_of_view);
  char label[64];
  std::snprintf(label, sizeof label, "bound / max %.4f", statistics.error.bound / statistics.error.max);
  state.SetLabel(label);
}

void every_pixel(benchmark::State& state, const Source& source, const std::string& target) {
  const Pair pair = make_pair(source, target);
  EvaluateOptions options;
  options.every_pixel = true;
  options.bound = false;
  const internal::Scorer scorer(source.camera.model, &pair.target, nullptr, pair.field_of_view, options.target_max_angle_rad);
  for (auto _ : state) benchmark::DoNotOptimize(internal::score_every_pixel(scorer));
  const ImageSize& size = pair.field_of_view.size;
  state.SetItemsProcessed(state.iterations() * size.width * size.height);
}

/// The two halves of a certificate, each alone.
void lattice(benchmark::State& state, const Source& source, const std::string& target) {
  const Pair pair = make_pair(source, target);
  const internal::Scorer scorer(source.camera.model, &pair.target, nullptr, pair.field_of_view, 4.0);
  for (auto _ : state) benchmark::DoNotOptimize(internal::score_on_lattice(scorer));
}

void bound(benchmark::State& state, const Source& source, const std::string& target) {
  const Pair pair = make_pair(source, target);
  const double seen = evaluate(source.camera.model, pair.target, pair.field_of_view).error.max;
  internal::ErrorBound proof;
  for (auto _ : state) proof = internal::bound_error(source.camera.model, pair.target, pair.field_of_view, 4.0, seen);
  state.SetLabel(std::to_string(proof.evaluations) + " evaluations");
}

const bool kRegistered = [] {
  const std::vector<Source> sources = {{"kalibr-ds", test::kalibr_ds(), {}},    {"kalibr-eucm", test::kalibr_eucm(), {}},
                                       {"kalibr-kb4", test::kalibr_kb4(), {}},  {"kalibr-radtan", test::kalibr_radtan(), {}},
                                       {"rational", test::rational_lens(), {}}, {"ocamcalib", test::ocamcalib_sample(), 95.0},
                                       {"tumvi", test::tumvi(), 97.5},          {"woodscape", test::woodscape_front(), 95.0},
                                       {"220-degree", test::lens_220(), 110.0}};
  for (const Source& source : sources) {
    for (const char* target : {"ucm", "eucm", "ds", "kb4", "ocamcalib", "radtan", "rational"}) {
      const bool perspective = std::string(target) == "radtan" || std::string(target) == "rational";
      if (model_info(source.camera.model).id == target || (perspective && source.max_angle_deg)) continue;
      const std::string name = std::string(source.name) + "/" + target;
      const auto add = [&](const char* group, auto measure) {
        benchmark::RegisterBenchmark((std::string(group) + "/" + name).c_str(),
                                     [=](benchmark::State& state) { measure(state, source, target); });
      };
      add("certificate", certificate);
      add("lattice", lattice);
      add("bound", bound);
      add("every-pixel", every_pixel);
    }
  }
  return true;
}();

}  // namespace
}  // namespace fca
