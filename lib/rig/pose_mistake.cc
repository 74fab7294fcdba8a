// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/pose_mistake.h>

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <numbers>

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

constexpr std::array kMistakes = {
    PoseMistake{Code::kPoseHoldsInverse, [](const Transform& T) { return inverse(T); }},
    PoseMistake{Code::kPoseTransposed, &transposed},
    PoseMistake{Code::kPoseInMillimetres, [](const Transform& T) { return scaled(T, 1e-3); }},
    PoseMistake{Code::kPoseInCentimetres, [](const Transform& T) { return scaled(T, 1e-2); }},
    PoseMistake{Code::kPoseInHectometres, [](const Transform& T) { return scaled(T, 1e2); }},
    PoseMistake{Code::kPoseInKilometres, [](const Transform& T) { return scaled(T, 1e3); }},
};

bool is_close(const Transform& a, const Transform& b) {
  constexpr double kAngle = 0.5 * std::numbers::pi / 180.0;
  constexpr double kDistance = 5e-3;
  return angle_between(a, b) < kAngle && distance_between(a, b) < std::max(kDistance, 0.05 * distance_of(b));
}

/// But for the digits that were not printed.
bool is_same(const Transform& a, const Transform& b) {
  constexpr double kPrinted = 1e-6;  // rad, m
  return angle_between(a, b) < kPrinted && distance_between(a, b) < kPrinted;
}

}  // namespace

std::span<const PoseMistake> pose_mistakes() { return kMistakes; }

Code mistake_in(const Transform& stated, const Transform& meant) {
  for (const PoseMistake& mistake : kMistakes) {
    const std::optional<Transform> undone = mistake.undo(stated);
    if (!undone) continue;
    // A small rotation and its transpose are as near as honest statements are, but then none of them is exact.
    const bool explains = !is_close(stated, meant) && is_close(*undone, meant);
    if (explains || is_same(*undone, meant)) return mistake.code;
  }
  return Code::kNone;
}

}  // namespace fca
