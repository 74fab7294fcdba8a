// SPDX-License-Identifier: BSD-3-Clause
#include "exact.h"

#include "../models/exact_steps.h"

#include <fca/convert/containment.h>

#include <algorithm>
#include <span>
#include <vector>

namespace fca::internal {

namespace {

/// The exact steps from every model, as lib/models/exact_steps.h defines them.
std::vector<ExactStep> all_steps() {
  std::vector<ExactStep> steps;
  ModelList::for_each([&steps]<class M>() {
    if constexpr (requires { M::exact_steps(); }) {
      const std::span<const ExactStep> of_model = M::exact_steps();
      steps.insert(steps.end(), of_model.begin(), of_model.end());
    }
  });
  return steps;
}

/// True if one of the models has this id.
template <CameraModelType... Ms>
constexpr bool is_listed(std::string_view id, TypeList<Ms...> /*models*/) {
  return ((Ms::kId == id) || ...);
}

/// Converts a model without skew by the shortest chain of exact steps; nullopt if there is none.
std::optional<CameraModel> convert_by_steps(const CameraModel& source, std::string_view target_id) {
  static const std::vector<ExactStep> steps = all_steps();
  std::vector<CameraModel> reached = {source};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::string_view id = model_info(reached[i]).id;
    if (id == target_id) return reached[i];
    for (const ExactStep& step : steps) {
      const auto has_target = [&step](const CameraModel& model) { return model_info(model).id == step.to; };
      if (step.from != id || std::ranges::any_of(reached, has_target)) continue;
      if (const std::optional<CameraModel> next = step.convert(reached[i])) reached.push_back(*next);
    }
  }
  return std::nullopt;
}

}  // namespace

std::string_view id_without_skew(std::string_view id) {
  ModelList::for_each([&id]<class M>() {
    if constexpr (kIsSkewed<M>) {
      if (M::kId == id) id = M::Straight::kId;
    }
  });
  return id;
}

std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id) {
  if (model_info(source).id == target_id) return source;
  const auto [straight, skew_px] = without_skew(source);
  if (const std::string_view straight_id = id_without_skew(target_id); straight_id != target_id) {
    const std::optional<CameraModel> converted = convert_exactly(straight, straight_id);
    return converted ? with_skew(*converted, skew_px) : std::nullopt;
  }
  if (skew_px != 0.0) return std::nullopt;
  if (straight != source) return convert_exactly(straight, target_id);
  return convert_by_steps(source, target_id);
}

std::optional<CameraModel> convert_nearly(const CameraModel& inner, std::string_view outer_id) {
  const std::optional<CameraModel> ucm = outer_id == Mei::kId ? convert_exactly(inner, Ucm::kId) : std::nullopt;
  if (!ucm) return convert_exactly(inner, outer_id);
  const auto& [fx, fy, cx, cy, alpha] = std::get<Intrinsics<Ucm>>(*ucm).values;
  const double xi = alpha < 1.0 ? std::min(alpha / (1.0 - alpha), Mei::kFurthestXi) : Mei::kFurthestXi;
  return Intrinsics<Mei>{{fx * (1.0 + xi), fy * (1.0 + xi), cx, cy, xi, 0.0, 0.0, 0.0, 0.0}};
}

std::string_view contained_model(std::string_view id) {
  std::string_view contained;
  ModelList::for_each([&]<class M>() {
    if constexpr (requires { M::kContains; }) {
      static_assert(is_listed(M::kContains, ModelList{}));
      if (M::kId == id) contained = M::kContains;
    }
  });
  return contained;
}

}  // namespace fca::internal

namespace fca {

bool contains(std::string_view outer, std::string_view inner) {
  for (; !outer.empty(); outer = internal::contained_model(outer)) {
    if (outer == inner) return true;
  }
  return false;
}

}  // namespace fca
