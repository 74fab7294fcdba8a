// SPDX-License-Identifier: BSD-3-Clause
// Closed forms from one model to another. A model's folder has those between it and the models before it in ModelList;
// convert_exactly() (lib/convert/exact.h) chains them.
#pragma once

#include <fca/models/camera_model.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace fca::internal {

struct ExactStep {
  std::string_view from;
  std::string_view to;
  /// The same camera; nothing where the parameters do not allow it.
  std::optional<CameraModel> (*convert)(const CameraModel& model);
};

template <auto kFormula, CameraModelType From, CameraModelType To>
constexpr ExactStep step_of(std::optional<Intrinsics<To>> (*)(const Intrinsics<From>&)) {
  return {From::kId, To::kId, [](const CameraModel& model) -> std::optional<CameraModel> {
            if (const std::optional<Intrinsics<To>> result = kFormula(std::get<Intrinsics<From>>(model))) return *result;
            return std::nullopt;
          }};
}
/// Of a function from the parameters of one model to those of another.
template <auto kFormula>
constexpr ExactStep exact_step() {
  return step_of<kFormula>(kFormula);
}

inline bool all_zero(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return v == 0.0; });
}

/// A model that has the parameters of `Inner` first: the outer one with further parameters 0, and back where they are 0.
template <CameraModelType Inner, CameraModelType Outer>
std::optional<Intrinsics<Outer>> widened(const Intrinsics<Inner>& inner) {
  Intrinsics<Outer> outer;
  std::ranges::copy(inner.values, outer.values.begin());
  return outer;
}
template <CameraModelType Outer, CameraModelType Inner>
std::optional<Intrinsics<Inner>> narrowed(const Intrinsics<Outer>& outer) {
  Intrinsics<Inner> inner;
  std::copy_n(outer.values.begin(), inner.values.size(), inner.values.begin());
  if (!all_zero(std::span(outer.values).subspan(inner.values.size()))) return std::nullopt;
  return inner;
}

}  // namespace fca::internal
