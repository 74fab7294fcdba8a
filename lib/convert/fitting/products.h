// SPDX-License-Identifier: BSD-3-Clause
// Sums of products of columns: the normal equations of a least-squares problem whose Jacobian is stored column by column.
#pragma once

#include <fca/convert/fit_target.h>

#include <span>

namespace fca::internal {

/// columns[i] . columns[j] for i <= j, into a row-major square matrix; nothing below the diagonal.
void products(std::span<const Column> columns, double* matrix);

/// columns[i] . other, one number per column.
void products(std::span<const Column> columns, const Column& other, double* vector);

}  // namespace fca::internal
