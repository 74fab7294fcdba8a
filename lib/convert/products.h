// SPDX-License-Identifier: BSD-3-Clause
// Sums of products of columns: the normal equations of a least-squares problem whose Jacobian is stored column by column.
#pragma once

#include <cstddef>
#include <span>

namespace fca::internal {

/// Numbers that are 0 outside [begin, end).
struct Column {
  const double* data = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// columns[i] . columns[j] for i <= j, into a row-major square matrix; nothing below the diagonal.
void products(std::span<const Column> columns, double* matrix);

/// columns[i] . other, one number per column.
void products(std::span<const Column> columns, const Column& other, double* vector);

}  // namespace fca::internal
