// SPDX-License-Identifier: BSD-3-Clause
// Dot products of columns, from which the normal equations of a least-squares problem consist. The Jacobian is stored column by
// column.
#pragma once

#include <fca/convert/fit_target.h>

#include <span>

namespace fca::internal {

/// Writes columns[i] . columns[j] for i <= j into a row-major square matrix. Leaves the elements below the diagonal unchanged.
void dot_products(std::span<const Column> columns, double* matrix);

/// Writes columns[i] . other for each i into `vector`.
void dot_products(std::span<const Column> columns, const Column& other, double* vector);

}  // namespace fca::internal
