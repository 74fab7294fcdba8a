// SPDX-License-Identifier: BSD-3-Clause
// Dot products of columns: the normal equations of a least-squares problem whose Jacobian is stored column by column.
#pragma once

#include <fca/convert/fit_target.h>

#include <span>

namespace fca::internal {

/// Writes columns[i] . columns[j] for i <= j into a row-major square matrix; leaves elements below the diagonal unchanged.
void dot_products(std::span<const Column> columns, double* matrix);

/// Writes columns[i] . other, one number per column.
void dot_products(std::span<const Column> columns, const Column& other, double* vector);

}  // namespace fca::internal
