// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/pose_slip.h>

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
    PoseSlip{"pose-inverted", "holds the other direction (its inverse agrees with the other poses)",
             "invert it: R^T and -R^T t", [](const Transform& T) { return inverse(T); }},
    PoseSlip{"pose-transposed", "holds the transposed rotation", "write the rotation's columns as rows", &transposed},
    PoseSlip{"translation-in-mm", "has its translation in millimetres", "divide the translation by 1000",
             [](const Transform& T) { return scaled(T, 1e-3); }},
    PoseSlip{"translation-in-mm", "has its translation 1000 times too small", "multiply the translation by 1000",
             [](const Transform& T) { return scaled(T, 1e3); }},
};

}  // namespace

std::span<const PoseSlip> pose_slips() { return kSlips; }

}  // namespace fca
