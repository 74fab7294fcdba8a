// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/fit_target.h>

#include <vector>

#include <ceres/dynamic_numeric_diff_cost_function.h>

namespace fca::internal {

namespace {

/// The residuals in pixels, as a functor for Ceres' numeric derivatives: u and v of a sample follow each other.
struct Residuals {
  const FitTarget& target;
  std::span<const Correspondence> samples;
  mutable std::vector<std::array<double, 2>> pixels;

  bool operator()(double const* const* parameters, double* residuals) const {
    if (!target.pixels(parameters[0], samples, pixels.data())) return false;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      for (std::size_t axis = 0; axis < 2; ++axis) residuals[2 * k + axis] = pixels[k][axis] - samples[k].pixel[axis];
    }
    return true;
  }
};

}  // namespace

bool linearise_by_differences(const FitTarget& target, const double* p, std::span<const Correspondence> samples,
                              const LinearisedColumns& out) {
  const std::size_t count = target.parameters().size();
  Residuals functor{target, samples, std::vector<std::array<double, 2>>(samples.size())};
  ceres::DynamicNumericDiffCostFunction<Residuals, ceres::CENTRAL> cost(&functor, ceres::DO_NOT_TAKE_OWNERSHIP);
  cost.AddParameterBlock(static_cast<int>(count));
  cost.SetNumResiduals(static_cast<int>(2 * samples.size()));
  std::vector<double> residuals(2 * samples.size());
  std::vector<double> jacobian(count * residuals.size());  // row-major
  double* blocks[] = {jacobian.data()};
  if (!cost.Evaluate(&p, residuals.data(), blocks)) return false;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::span<const double> du(&jacobian[2 * k * count], count);
    const std::span<const double> dv(&jacobian[(2 * k + 1) * count], count);
    out.set(k, du, dv, residuals[2 * k], residuals[2 * k + 1]);
  }
  return true;
}

}  // namespace fca::internal
