// SPDX-License-Identifier: BSD-3-Clause
// Residuals and derivatives of the models of the list that have slopes, as SIMD where the compiler and the processor have it.
// Nothing is fused: the numbers are the same to the last bit on every processor, and so is every fit.
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <span>
#include <type_traits>
#include <variant>

namespace fca::internal {

template <class List>
struct IdOf;
template <class... Ms>
struct IdOf<TypeList<Ms...>> {
  using Any = std::variant<std::type_identity<Ms>...>;
};

/// Which model of the list.
using ListedModel = IdOf<ModelList>::Any;

/// FitTarget::linearise() of a model with slopes; false for one without.
bool slope_columns(const ListedModel& model, const double* p, std::span<const Correspondence> samples,
                   const LinearisedColumns& out);

}  // namespace fca::internal
