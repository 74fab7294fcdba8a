// SPDX-License-Identifier: BSD-3-Clause
// Converts good cameras and nonsense to the models, from one thread and from four at once. Prints nothing itself, so that
// whatever is printed comes from fca::core or from below. Exit code 1: two threads disagree; 2: the good cameras could not be
// converted.
#include <fca/convert/convert.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

fca::Camera camera(const fca::CameraModel& model, fca::ImageSize size = {640, 480}) {
  return {"cam0", size, model, {}, {}, {}};
}

std::vector<fca::Camera> good_cameras() {
  return {camera(fca::Intrinsics<fca::Kb4>{{190.978, 190.973, 254.932, 256.897, 0.00348, 0.000715, -0.00205, 0.000203}},
                 {512, 512}),
          camera(fca::Intrinsics<fca::Ds>{{156.9, 156.9, 254.0, 256.0, 0.59, -0.18}}, {512, 512}),
          camera(fca::Intrinsics<fca::Pinhole>{{400.0, 401.0, 320.0, 240.0}})};
}

/// Every model with each parameter in turn at a value that is no camera's, or hardly one's.
std::vector<fca::Camera> nonsense() {
  std::vector<fca::Camera> cameras;
  for (const fca::ModelInfo& info : fca::all_models()) {
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      for (const double value : {kNaN, -kInfinity, kInfinity, 1e308, 0.0, -1.0, 50.0}) {
        fca::CameraModel model = *fca::make_model(info.id);
        const std::span<double> values = fca::parameter_values(model);
        values[0] = values[1] = 300.0;
        values[2] = 320.0;
        values[3] = 240.0;
        if (info.parameters.size() == 6) values[4] = values[5] = 0.6;
        values[i] = value;
        cameras.push_back(camera(model));
      }
    }
  }
  const fca::CameraModel good = good_cameras().front().model;
  for (const fca::ImageSize size : {fca::ImageSize{0, 0}, {-640, 480}, {1, 1}, {2, 1}, {1, 100000}, {2147483647, 2147483647}}) {
    cameras.push_back(camera(good, size));
  }
  cameras.push_back({"", std::nullopt, good, {}, {}, {}});
  return cameras;
}

/// Everything a conversion says that is a number, bit by bit, but the time it took.
void append(const std::optional<fca::Conversion>& conversion, std::vector<std::uint64_t>& bits) {
  bits.push_back(conversion ? 1 : 0);
  if (!conversion) return;
  const fca::ErrorSummary& error = conversion->report.statistics.error;
  for (const double value : fca::parameter_values(conversion->camera.model))
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  for (const double value : {error.rms, error.max, error.p50, error.max_at[0], error.max_at[1]}) {
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  }
}

/// Each camera to every `stride`-th model, another first one for each.
std::vector<std::uint64_t> convert_all(const std::vector<fca::Camera>& cameras, std::size_t stride = 1) {
  std::vector<std::uint64_t> bits;
  const std::span<const fca::ModelInfo> targets = fca::all_models();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    for (std::size_t k = i % stride; k < targets.size(); k += stride) {
      fca::Diagnostics diagnostics;
      append(fca::convert(cameras[i], {std::string(targets[k].id), {}, {}}, diagnostics), bits);
      bits.push_back(diagnostics.entries().size());
    }
  }
  return bits;
}

bool all_converted(const std::vector<fca::Camera>& cameras) {
  for (const fca::Camera& source : cameras) {
    fca::Diagnostics diagnostics;
    if (!fca::convert(source, {"kb4", {}, {}}, diagnostics)) return false;
  }
  return true;
}

}  // namespace

int main() {
  std::vector<fca::Camera> cameras = good_cameras();
  if (!all_converted(cameras)) return 2;
  const std::vector<fca::Camera> bad = nonsense();
  // Seven values of each parameter: every model meets some of them.
  constexpr std::size_t kStride = 4;
  convert_all(bad, kStride);

  // A part is enough for the threads.
  for (std::size_t i = 0; i < bad.size(); i += 20) cameras.push_back(bad[i]);
  const std::vector<std::uint64_t> alone = convert_all(cameras);
  std::vector<std::vector<std::uint64_t>> together(3);
  std::vector<std::thread> threads;
  for (std::vector<std::uint64_t>& bits : together) threads.emplace_back([&bits, &cameras] { bits = convert_all(cameras); });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<std::uint64_t>& bits : together) {
    if (bits != alone) return 1;
  }
  return 0;
}
