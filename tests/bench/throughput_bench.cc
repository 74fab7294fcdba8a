// SPDX-License-Identifier: BSD-3-Clause
// Points per second of project and unproject, per model: a camera that model can well be, over 4,096 points of its image.
#include "lib/convert/known_cameras.h"

#include <fca/convert/field_of_view.h>
#include <fca/convert/sample.h>

#include <convert/fitting/fit_model.h>
#include <models/kernels/batch.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

namespace fca {
namespace {

constexpr int kPoints = 4096;

/// EuRoC's lens as each model sees it.
CameraModel model_of(const ModelInfo& info) {
  const Camera source = test::euroc();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(source, {}, diagnostics);
  const LensCentre centre{central_focal_lengths(source.model), principal_point(source.model)};
  const std::vector<Correspondence> samples = sample(source.model, *field_of_view);
  return internal::fit_model(info.id, samples, centre, {}).value().model;
}

std::vector<Correspondence> points_of(const CameraModel& model) {
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(test::make_camera(model, {752, 480}), {}, diagnostics);
  return sample(model, *field_of_view, kPoints);
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

/// The same as evaluate() does it.
void batches(benchmark::State& state, const CameraModel& model, bool rays) {
  const std::vector<Correspondence> points = points_of(model);
  internal::Batch batch;
  double max_angle_rad = 0.0;
  for (std::size_t i = 0; i < internal::Batch::kSize; ++i) {
    const Correspondence& point = points[i * points.size() / internal::Batch::kSize];
    batch.u[i] = point.pixel[0];
    batch.v[i] = point.pixel[1];
    batch.x[i] = point.ray[0];
    batch.y[i] = point.ray[1];
    batch.z[i] = point.ray[2];
    max_angle_rad = std::max(max_angle_rad, angle_from_axis(point.ray));
  }
  const internal::BatchRays to_rays(model, max_angle_rad);
  const internal::BatchErrors to_errors(model, max_angle_rad);
  for (auto _ : state) {
    if (rays) {
      to_rays(batch, internal::Batch::kSize);
    } else {
      to_errors(batch, internal::Batch::kSize);
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(internal::Batch::kSize));
}

const bool kRegistered = [] {
  for (const ModelInfo& info : all_models()) {
    const CameraModel model = model_of(info);
    const std::string id(info.id);
    benchmark::RegisterBenchmark(("project/" + id).c_str(), [=](benchmark::State& state) { projection(state, model); });
    benchmark::RegisterBenchmark(("batch-project/" + id).c_str(),
                                 [=](benchmark::State& state) { batches(state, model, false); });
    benchmark::RegisterBenchmark(("batch-unproject/" + id).c_str(),
                                 [=](benchmark::State& state) { batches(state, model, true); });
    benchmark::RegisterBenchmark(("unproject/" + id).c_str(), [=](benchmark::State& state) { unprojection(state, model); });
  }
  return true;
}();

}  // namespace
}  // namespace fca
