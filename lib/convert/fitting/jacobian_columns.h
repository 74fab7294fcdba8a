// SPDX-License-Identifier: BSD-3-Clause
// Residuals and derivatives of the listed models that have formula_and_derivatives, as SIMD where compiler and processor
// support it. Multiplications and additions are not fused, so that every processor computes the same numbers to the last bit,
// and the same fit.
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

/// Selects a model of the list by its type.
using ListedModel = IdOf<ModelList>::Any;

/// FitTarget::compute_jacobian() for a listed model that has formula_and_derivatives. False if a sample has no pixel, or the
/// model has none.
bool jacobian_columns(const ListedModel& model, const double* p, std::span<const Correspondence> samples,
                      const JacobianColumns& out);

}  // namespace fca::internal
