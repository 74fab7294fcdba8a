// SPDX-License-Identifier: BSD-3-Clause
// Points per second of project and unproject, per model: a camera that model can well be, over 4,096 points of its image.
#include "lib/convert/known_cameras.h"

#include <fca/convert/domain.h>
#include <fca/convert/sample.h>

#include <convert/fit_model.h>

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace fca {
namespace {

constexpr int kPoints = 4096;

/// EuRoC's lens as each model sees it.
CameraModel model_of(const ModelInfo& info) {
  const Camera source = test::euroc();
  Diagnostics diagnostics;
  const std::optional<Domain> domain = domain_of(source, {}, diagnostics);
  const LensCentre centre{central_focal_lengths(source.model), principal_point(source.model)};
  const std::vector<Correspondence> samples = sample(source.model, *domain);
  return internal::fit_model(info.id, samples, centre, {}).value().model;
}

std::vector<Correspondence> points_of(const CameraModel& model) {
  Diagnostics diagnostics;
  const std::optional<Domain> domain = domain_of(test::make_camera(model, {752, 480}), {}, diagnostics);
  return sample(model, *domain, kPoints);
}

void projection(benchmark::State& state, const CameraModel& model) {
  const std::vector<Correspondence> points = points_of(model);
  for (auto _ : state) {
    for (const Correspondence& point : points) benchmark::DoNotOptimize(project(model, point.ray));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

void unprojection(benchmark::State& state, const CameraModel& model) {
  const std::vector<Correspondence> points = points_of(model);
  for (auto _ : state) {
    for (const Correspondence& point : points) benchmark::DoNotOptimize(unproject(model, point.pixel));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

const bool kRegistered = [] {
  for (const ModelInfo& info : all_models()) {
    const CameraModel model = model_of(info);
    const std::string id(info.id);
    benchmark::RegisterBenchmark(("project/" + id).c_str(), [=](benchmark::State& state) { projection(state, model); });
    benchmark::RegisterBenchmark(("unproject/" + id).c_str(), [=](benchmark::State& state) { unprojection(state, model); });
  }
  return true;
}();

}  // namespace
}  // namespace fca
