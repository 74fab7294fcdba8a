// SPDX-License-Identifier: BSD-3-Clause
#include "jacobian_columns.h"

#include "../../models/kernels/multiversioned.h"
#include "../../models/kernels/with_kernel.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace fca::internal {

namespace {

/// The number of samples that are computed together. It is constant, so that the compiler vectorises the loops, and small
/// enough for the stack.
constexpr std::size_t kBlock = 16;
using Lane = std::array<double, kBlock>;

/// kBlock samples, with one array per component.
struct Block {
  Lane x, y, z;  ///< The rays.
  Lane u, v;     ///< The pixels.
  Lane root;     ///< The square roots of the weights.

  /// Copies the samples from index `begin` on. Repeats the last sample if fewer than kBlock remain.
  Block(std::span<const Correspondence> samples, std::span<const double> roots, std::size_t begin) {
    for (std::size_t k = 0; k < kBlock; ++k) {
      const std::size_t at = std::min(begin + k, samples.size() - 1);
      const Correspondence& s = samples[at];
      x[k] = s.ray[0];
      y[k] = s.ray[1];
      z[k] = s.ray[2];
      u[k] = s.pixel[0];
      v[k] = s.pixel[1];
      root[k] = roots[at];
    }
  }
};

/// Copies the first `count` numbers of a lane. For a full lane the length is constant, so that the copy takes only a few
/// instructions.
void copy(const Lane& lane, std::size_t count, double* to) {
  if (count == kBlock) {
    std::memcpy(to, lane.data(), sizeof lane);
  } else {
    std::copy_n(lane.begin(), count, to);
  }
}

/// Implements jacobian_columns() for the model M.
template <class M>
bool columns_of(const double* p, std::span<const Correspondence> samples, const JacobianColumns& out) {
  constexpr std::size_t kCount = kParameterCount<M>;
  std::array<double, kCount> parameters;
  std::copy_n(p, kCount, parameters.begin());
  for (std::size_t begin = 0; begin < samples.size(); begin += kBlock) {
    const Block block(samples, out.roots, begin);
    std::array<Lane, kCount + 1> along_u;
    std::array<Lane, kCount + 1> along_v;
    double missing = 0.0;
    for (std::size_t k = 0; k < kBlock; ++k) {
      const double ray[3] = {block.x[k], block.y[k], block.z[k]};
      double pixel[2] = {block.u[k], block.v[k]};  // the first guess of models whose formula iterates
      double du[kCount] = {};
      double dv[kCount] = {};
      missing += M::formula_and_derivatives(parameters.data(), ray, pixel, du, dv) ? 0.0 : 1.0;
      for (std::size_t i = 0; i < kCount; ++i) {
        along_u[i][k] = block.root[k] * du[i];
        along_v[i][k] = block.root[k] * dv[i];
      }
      along_u[kCount][k] = block.root[k] * (pixel[0] - block.u[k]);
      along_v[kCount][k] = block.root[k] * (pixel[1] - block.v[k]);
    }
    if (missing > 0.0) return false;
    const std::size_t count = std::min(kBlock, samples.size() - begin);
    for (std::size_t i = 0; i <= kCount; ++i) {
      copy(along_u[i], count, out.column(i) + begin);
      copy(along_v[i], count, out.column(i) + samples.size() + begin);
    }
  }
  return true;
}

}  // namespace

FCA_MULTIVERSIONED bool jacobian_columns(const ListedModel& model, const double* p, std::span<const Correspondence> samples,
                                         const JacobianColumns& out) {
  bool valid = false;
  with_kernel(model, [&]<class M>(std::type_identity<M> /*model*/) {
    if constexpr (HasDerivatives<M>) valid = columns_of<M>(p, samples, out);
  });
  return valid;
}

}  // namespace fca::internal
