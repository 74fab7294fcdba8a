// SPDX-License-Identifier: BSD-3-Clause
// Residuals and derivatives of those models of the list that have formula_and_derivatives (model_traits.h). The code uses SIMD
// instructions if compiler and processor support them. Multiplications and additions are not fused, so that every processor
// computes the same numbers to the last bit, and thus the same fit.
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <span>
#include <type_traits>
#include <variant>

namespace fca::internal {

/// A variant with a std::type_identity for each model of a list.
template <class List>
struct VariantOfTypes;
template <class... Ms>
struct VariantOfTypes<TypeList<Ms...>> {
  using Type = std::variant<std::type_identity<Ms>...>;
};

/// Selects a model of the list by its type.
using ListedModel = VariantOfTypes<ModelList>::Type;

/// Implements FitTarget::compute_jacobian() for a listed model. False if a sample has no pixel, or the model has no
/// formula_and_derivatives.
bool jacobian_columns(const ListedModel& model, const double* p, std::span<const Correspondence> samples,
                      const JacobianColumns& out);

}  // namespace fca::internal
