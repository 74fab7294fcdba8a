// SPDX-License-Identifier: BSD-3-Clause
#include <fca/remap/lanczos.h>

#include <cmath>
#include <numbers>

namespace fca {

namespace {

/// sin(pi x) / (pi x)
double sinc(double x) {
  constexpr double kTiny = 1e-8;  // where its square no longer counts
  if (std::abs(x) < kTiny) return 1.0;
  return std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

}  // namespace

LanczosWindow::Weights LanczosWindow::weights(double fraction) {
  constexpr double kHalfSide = 0.5 * kSide;
  Weights result{};
  // On a pixel's centre the others do not count at all, to the last bit.
  if (fraction == 0.0) {
    result[kBefore] = 1.0;
    return result;
  }
  double sum = 0.0;
  for (int i = 0; i < kSide; ++i) {
    const double x = fraction + kBefore - i;
    double& weight = result.at(static_cast<std::size_t>(i));
    weight = sinc(x) * sinc(x / kHalfSide);
    sum += weight;
  }
  for (double& weight : result) weight /= sum;
  return result;
}

std::optional<LanczosWindow> LanczosWindow::about(const Pixel& place, const ImageSize& size) {
  const double u = std::floor(place[0]);
  const double v = std::floor(place[1]);
  const auto fits = [](double at, int side) { return at >= kBefore && at + (kSide - kBefore) <= side; };
  if (!fits(u, size.width) || !fits(v, size.height)) return std::nullopt;
  LanczosWindow window;
  window.first_u_ = static_cast<int>(u) - kBefore;
  window.first_v_ = static_cast<int>(v) - kBefore;
  window.along_u_ = weights(place[0] - u);
  window.along_v_ = weights(place[1] - v);
  return window;
}

double LanczosWindow::value(const GreyImage& image) const {
  double sum = 0.0;
  for (std::size_t row = 0; row < kSide; ++row) {
    const std::size_t v = static_cast<std::size_t>(first_v_) + row;
    const float* samples = image.samples.data() + v * static_cast<std::size_t>(image.width) + first_u_;
    double along = 0.0;
    for (std::size_t column = 0; column < kSide; ++column) along += along_u_[column] * static_cast<double>(samples[column]);
    sum += along_v_[row] * along;
  }
  return sum;
}

}  // namespace fca
