// SPDX-License-Identifier: BSD-3-Clause
// A fit of any camera model, listed or one's own, to rays and pixels: the step of convert() between sample() and evaluate().
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {

template <CameraModelType M>
struct Fitted {
  Intrinsics<M> model;
  double rms_px = 0.0;  ///< Over the samples, by their weights.
  int iterations = 0;
  bool reaches_all = true;            ///< Every sample's ray lies in the model's domain, but for a thousandth of the weights.
  std::vector<std::string> at_bound;  ///< Parameters that ended at the edge of their range.
};

/// The least-squares optimum in pixels from the model's own starts (M::initialise), given the centre of the lens; nothing if no
/// start leads to a camera. Derivatives are M::formula_and_derivatives where the model has it, else central differences of
/// M::formula: exact enough for the optimum, and some ten times slower.
template <CameraModelType M>
[[nodiscard]] std::optional<Fitted<M>> fit(std::span<const Correspondence> samples, const LensCentre& centre,
                                           std::span<const ParameterRange> ranges = {}) {
  const std::optional<internal::FoundFit> found = internal::fit_target(internal::FitTargetOf<M>(), samples, centre, ranges);
  if (!found) return std::nullopt;
  Fitted<M> result{{}, found->rms_px, found->iterations, found->reaches_all, found->at_bound};
  std::copy_n(found->parameters.begin(), result.model.values.size(), result.model.values.begin());
  return result;
}

}  // namespace fca
