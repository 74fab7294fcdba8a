// SPDX-License-Identifier: BSD-3-Clause
// The map of a 1920 x 1080 pinhole view from a fisheye on one core, next to a copy of such a map (what memory allows) and what
// OpenCV takes for the maps it knows.
#include "lib/convert/known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/remap/image_map.h>
#include <fca/remap/view.h>

#include <opencv2/calib3d.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace fca {
namespace {

constexpr ImageSize kSize = {1920, 1080};
constexpr std::size_t kNumbers = 2UL * kSize.width * kSize.height;

Camera target() { return test::make_camera(pinhole_of_view(kSize, 100 * test::kRadians), kSize); }

/// One lens as each model sees it.
Camera source_of(const ModelInfo& info) {
  Diagnostics diagnostics;
  ConvertOptions options;
  options.model = info.id;
  options.bound = false;
  return convert(test::kalibr_ds(), options, diagnostics).value().camera;
}

/// So many maps one after the other that none is still in a cache when it is written again: 270 MB.
constexpr std::size_t kMaps = 16;

std::span<float> map_at(std::vector<float>& maps, std::size_t turn) {
  return std::span(maps).subspan(kNumbers * (turn % kMaps), kNumbers);
}

void map_rows(benchmark::State& state, const Camera& source) {
  Diagnostics diagnostics;
  const std::optional<ImageMapper> mapper = ImageMapper::between(source, target(), turned(0.1, 0.05, 0.02), {}, diagnostics);
  std::vector<float> maps(kNumbers * kMaps);
  const std::size_t stride = 2UL * kSize.width;
  std::size_t turn = 0;
  for (auto _ : state) {
    const std::span<float> uv = map_at(maps, turn++);
    for (int v = 0; v < kSize.height; ++v) mapper->row(v, uv.subspan(static_cast<std::size_t>(v) * stride, stride));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kNumbers / 2));
}

void copy(benchmark::State& state) {
  std::vector<float> from(kNumbers * kMaps, 1.0F);
  std::vector<float> to(kNumbers * kMaps);
  std::size_t turn = 0;
  for (auto _ : state) {
    std::ranges::copy(map_at(from, turn), map_at(to, turn).begin());
    ++turn;
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kNumbers / 2));
}

cv::Matx33d matrix_of(const CameraModel& model) {
  const std::span<const double> p = parameter_values(model);
  return {p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1};
}

/// OpenCV's map of four coefficients: radtan, or kb4.
void opencv(benchmark::State& state, bool fisheye) {
  cv::setNumThreads(1);
  const Camera source = fisheye ? test::kalibr_kb4() : test::kalibr_radtan();
  const std::span<const double> p = parameter_values(source.model);
  const std::vector<double> k(p.begin() + 4, p.begin() + 8);
  const cv::Matx33d turn(0.99, -0.02, 0.1, 0.02, 0.99, -0.05, -0.1, 0.05, 0.99);
  const cv::Matx33d to = matrix_of(target().model);
  const cv::Size size(kSize.width, kSize.height);
  cv::Mat u;
  cv::Mat v;
  for (auto _ : state) {
    if (fisheye) {
      cv::fisheye::initUndistortRectifyMap(matrix_of(source.model), k, turn, to, size, CV_32FC1, u, v);
    } else {
      cv::initUndistortRectifyMap(matrix_of(source.model), k, turn, to, size, CV_32FC1, u, v);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kNumbers / 2));
}

const bool kRegistered = [] {
  benchmark::RegisterBenchmark("remap/copy", copy);
  benchmark::RegisterBenchmark("remap/opencv-radtan", [](benchmark::State& state) { opencv(state, false); });
  benchmark::RegisterBenchmark("remap/opencv-fisheye", [](benchmark::State& state) { opencv(state, true); });
  for (const ModelInfo& info : all_models()) {
    const Camera source = source_of(info);
    benchmark::RegisterBenchmark(("remap/" + std::string(info.id)).c_str(),
                                 [=](benchmark::State& state) { map_rows(state, source); });
  }
  return true;
}();

}  // namespace
}  // namespace fca
