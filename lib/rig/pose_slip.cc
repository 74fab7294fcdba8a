// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/pose_slip.h>

#include <fca/code.h>

#include <array>

namespace fca {

namespace {

std::optional<Transform> transposed(const Transform& T) {
  Transform result = T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) result(row, column) = T(column, row);
  }
  return result;
}

std::optional<Transform> scaled(const Transform& T, double factor) {
  Transform result = T;
  for (int row = 0; row < 3; ++row) result(row, 3) *= factor;
  return result;
}

constexpr std::array kSlips = {
    PoseSlip{Code::kPoseHoldsInverse, [](const Transform& T) { return inverse(T); }},
    PoseSlip{Code::kPoseTransposed, &transposed},
    PoseSlip{Code::kPoseInMillimetres, [](const Transform& T) { return scaled(T, 1e-3); }},
    PoseSlip{Code::kPoseInKilometres, [](const Transform& T) { return scaled(T, 1e3); }},
};

}  // namespace

std::span<const PoseSlip> pose_slips() { return kSlips; }

}  // namespace fca
