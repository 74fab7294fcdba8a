// SPDX-License-Identifier: BSD-3-Clause
// The steps of a map between the two models' kernels, as loops of which a compiler makes SIMD.
#pragma once

#include "../models/kernels/batch.h"
#include "matrix3.h"

#include <cstddef>

namespace fca::internal {

/// Turns the first `count` rays of a batch.
void turn_rays(const Matrix3& rotation, Batch& batch, std::size_t count);

/// How many of the first `count` rays are not finite.
[[nodiscard]] std::size_t count_unknown_rays(const Batch& batch, std::size_t count);

/// Writes the first `count` pixels of a batch; returns how many of them are not sure: their ray's cosine is not above
/// `surely_seen`, or they are no numbers that a float holds.
[[nodiscard]] std::size_t write_pixels(const Batch& batch, std::size_t count, double surely_seen, float* uv);

}  // namespace fca::internal
