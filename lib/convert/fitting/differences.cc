// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of a model without derivatives of its own, by central differences.
#include <fca/convert/fit_target.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace fca::internal {

bool jacobian_by_differences(const FitTarget& target, const double* p, std::span<const Correspondence> samples,
                             const JacobianColumns& out) {
  // The step is that of Ceres' numeric differentiation: 1e-6 of the parameter, but at least the root of the rounding error
  // of 1. With a smaller step the rounding errors would exceed the difference. Ceres' own functions for this need libglog,
  // which would load three more libraries each time the command starts.
  constexpr double kRelativeStep = 1e-6;
  const double smallest_step = std::sqrt(std::numeric_limits<double>::epsilon());

  const std::size_t count = target.parameters().size();
  std::vector<double> jacobian(2 * count * samples.size());  // row-major; u and v of a sample follow each other
  std::vector<double> shifted(p, p + count);
  std::vector<std::array<double, 2>> upper(samples.size());
  std::vector<std::array<double, 2>> lower(samples.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double step = std::max(smallest_step, kRelativeStep * std::abs(p[i]));
    shifted[i] = p[i] + step;
    if (!target.pixels(shifted.data(), samples, upper.data())) return false;
    shifted[i] = p[i] - step;
    if (!target.pixels(shifted.data(), samples, lower.data())) return false;
    shifted[i] = p[i];
    for (std::size_t k = 0; k < samples.size(); ++k) {
      for (std::size_t axis = 0; axis < 2; ++axis)
        jacobian[(2 * k + axis) * count + i] = (upper[k][axis] - lower[k][axis]) / (2.0 * step);
    }
  }
  std::vector<std::array<double, 2>>& pixels = upper;  // reuses the memory
  if (!target.pixels(p, samples, pixels.data())) return false;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::span<const double> du(&jacobian[2 * k * count], count);
    const std::span<const double> dv(&jacobian[(2 * k + 1) * count], count);
    out.set(k, du, dv, pixels[k][0] - samples[k].pixel[0], pixels[k][1] - samples[k].pixel[1]);
  }
  return true;
}

}  // namespace fca::internal
