// SPDX-License-Identifier: BSD-3-Clause
// The FitTarget of a listed model. The derivatives are those of the model (formula_and_derivatives) or, if it has none, those
// of Ceres' automatic differentiation.
#pragma once

#include "jacobian_columns.h"

#include <fca/convert/fit_target.h>

#include <ceres/jet.h>

namespace fca::internal {

/// The FitTarget of the listed model M.
template <CameraModelType M>
class JetTarget : public FitTargetOf<M> {
 public:
  using FitTargetOf<M>::kCount;

  bool compute_jacobian(const double* p, std::span<const Correspondence> samples, const JacobianColumns& out) const override {
    if constexpr (HasDerivatives<M>) {
      return jacobian_columns(std::type_identity<M>(), p, samples, out);
    } else {
      using Jet = ceres::Jet<double, static_cast<int>(kCount)>;
      std::array<Jet, kCount> parameters;
      for (std::size_t i = 0; i < kCount; ++i) parameters[i] = Jet(p[i], static_cast<int>(i));
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const Correspondence& s = samples[k];
        const Jet ray[3] = {Jet(s.ray[0]), Jet(s.ray[1]), Jet(s.ray[2])};
        Jet pixel[2];
        if (!M::formula(parameters.data(), ray, pixel)) return false;
        std::array<std::array<double, kCount>, 2> derivatives;
        for (std::size_t axis = 0; axis < 2; ++axis) {
          for (std::size_t i = 0; i < kCount; ++i) {
            // At the edge of the formula's domain a derivative may be NaN or infinite. It is then taken as 0.
            const double derivative = pixel[axis].v[static_cast<int>(i)];
            derivatives[axis][i] = std::isfinite(derivative) ? derivative : 0.0;
          }
        }
        out.set(k, derivatives[0], derivatives[1], pixel[0].a - s.pixel[0], pixel[1].a - s.pixel[1]);
      }
      return true;
    }
  }
};

}  // namespace fca::internal
