// SPDX-License-Identifier: BSD-3-Clause
// A test image of nobody's: a calibration board in a room, seen through a known fisheye. Usage: render-image OUT.pgm
#include <fca/models/camera_model.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

constexpr int kWidth = 752;
constexpr int kHeight = 480;

/// Kalibr's sample camera as Kannala-Brandt (Lee 2024, Table 1).
const fca::Intrinsics<fca::Kb4> kLens{{461.58688085556616, 460.2811732644195, 366.28603126815506, 249.08026891791644,
                                       -0.012523386218579752, 0.057836801948828065, -0.08495347810986263, 0.04362766880887814}};

/// Brightness of a checkered board one metre ahead, a little turned: 8 x 6 squares of 12 cm; negative next to it.
double board(const fca::Ray& ray) {
  if (ray[2] < 0.3 * std::hypot(ray[0], ray[1])) return -1.0;
  const double depth = 1.0 / (1.0 - 0.25 * ray[0] / ray[2]);  // the plane z = 1 + x / 4
  const double x = depth * ray[0] / ray[2] / 0.12 + 4.0;
  const double y = depth * ray[1] / ray[2] / 0.12 + 3.0;
  if (x < -0.5 || y < -0.5 || x > 8.5 || y > 6.5) return -1.0;
  if (x < 0.0 || y < 0.0 || x > 8.0 || y > 6.0) return 235.0;  // its white border
  return (static_cast<int>(x) + static_cast<int>(y)) % 2 == 0 ? 25.0 : 235.0;
}

/// A room behind it: plaster, planks and a lamp, by direction.
double room(const fca::Ray& ray) {
  const double angle = std::atan2(ray[1], ray[0]);
  const double away = std::acos(ray[2]);
  const double plaster = 14.0 * std::sin(41.0 * ray[0] + 3.0 * std::sin(23.0 * ray[1])) * std::cos(37.0 * ray[1]);
  const double planks = std::sin(18.0 * angle) * std::sin(9.0 * away) > 0.0 ? 30.0 : -20.0;
  const double lamp = 90.0 * std::exp(-std::pow((away - 0.7) / 0.08, 2) - std::pow((angle + 2.3) / 0.15, 2));
  return 110.0 + plaster + planks + lamp;
}

double brightness(const fca::Ray& ray) {
  const double of_board = board(ray);
  return of_board < 0.0 ? room(ray) : of_board;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fputs("usage: render-image OUT.pgm\n", stderr), 2;
  std::vector<std::uint8_t> samples;
  constexpr int kRays = 4;  // along each side of a pixel
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      double sum = 0.0;
      for (int i = 0; i < kRays * kRays; ++i) {
        const double du = (i % kRays + 0.5) / kRays - 0.5;
        const double dv = (i / kRays + 0.5) / kRays - 0.5;
        if (const auto ray = fca::unproject(kLens, {u + du, v + dv})) sum += brightness(*ray);
      }
      samples.push_back(static_cast<std::uint8_t>(std::lround(std::fmin(255.0, sum / (kRays * kRays)))));
    }
  }
  std::FILE* file = std::fopen(arguments[1], "wb");
  if (file == nullptr) return std::perror(arguments[1]), 1;
  std::fprintf(file, "P5\n%d %d\n255\n", kWidth, kHeight);
  const bool written = std::fwrite(samples.data(), 1, samples.size(), file) == samples.size();
  return std::fclose(file) == 0 && written ? 0 : 1;
}
