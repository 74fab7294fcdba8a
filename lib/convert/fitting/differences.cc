// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/fit_target.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace fca::internal {

bool jacobian_by_differences(const FitTarget& target, const double* p, std::span<const Correspondence> samples,
                             const JacobianColumns& out) {
  // Central differences, with the step of Ceres' numeric differentiation: 1e-6 of the parameter, but at least the root of the
  // rounding error of 1, below which rounding outweighs the difference. We do not call Ceres' functions for it: they need
  // libglog, which loads three more libraries each time the command starts.
  constexpr double kRelativeStep = 1e-6;
  const double smallest = std::sqrt(std::numeric_limits<double>::epsilon());

  const std::size_t count = target.parameters().size();
  std::vector<double> jacobian(2 * count * samples.size());  // row-major; u and v of a sample follow each other
  std::vector<double> shifted(p, p + count);
  std::vector<std::array<double, 2>> upper(samples.size());
  std::vector<std::array<double, 2>> lower(samples.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double step = std::max(smallest, kRelativeStep * std::abs(p[i]));
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
  std::vector<std::array<double, 2>>& projected = upper;
  if (!target.pixels(p, samples, projected.data())) return false;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::span<const double> du(&jacobian[2 * k * count], count);
    const std::span<const double> dv(&jacobian[(2 * k + 1) * count], count);
    out.set(k, du, dv, projected[k][0] - samples[k].pixel[0], projected[k][1] - samples[k].pixel[1]);
  }
  return true;
}

}  // namespace fca::internal
