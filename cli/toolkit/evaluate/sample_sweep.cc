// SPDX-License-Identifier: BSD-3-Clause
#include "sample_sweep.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fca {

namespace {

/// The requested numbers of samples.
constexpr std::array kSampleCounts = {10, 30, 100, 300, 1000, 3000, 10'000};

/// Each conversion is run several times, and the shortest time is reported: the first run fills the caches, and other processes
/// may slow some runs down.
constexpr std::size_t kRuns = 3;

/// Converts the source with that many samples. nullopt if the conversion fails.
std::optional<SweepPoint> point_of(const Camera& source, const EvaluatedRow& row, const CameraModel& truth, int samples) {
  ConvertOptions options;
  options.model = row.published.to.id;
  options.samples = samples;
  options.bound = false;
  std::array<double, kRuns> times{};
  std::optional<Conversion> conversion;
  for (double& time : times) {
    Diagnostics discarded;  // those of the table's conversion suffice
    conversion = convert(source, options, discarded);
    if (!conversion) return std::nullopt;
    time = conversion->report.fit.time_us;
  }
  return SweepPoint{samples, conversion->report.fit.samples, paper::parameter_distance(conversion->camera.model, truth),
                    conversion->report.statistics.error.rms, *std::ranges::min_element(times)};
}

}  // namespace

std::vector<SampleSweep> sample_sweeps(const EvaluatedTable& table) {
  std::vector<SampleSweep> sweeps;
  for (const EvaluatedRow& row : table.rows) {
    const CameraModel* truth = paper::calibration_in(table.published, row.published.to);
    if (truth == nullptr) continue;
    Camera source;
    source.image_size = table.published.size;
    source.model = row.source;
    SampleSweep sweep{row.published.from, row.published.to, {}};
    for (const int samples : kSampleCounts) {
      if (const std::optional<SweepPoint> point = point_of(source, row, *truth, samples)) sweep.points.push_back(*point);
    }
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

}  // namespace fca
