// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rectify/rectify.h>

#include <fca/rig/rotation.h>

#include <cmath>
#include <utility>

namespace fca {

namespace {

using Vector = std::array<double, 3>;

Transform transposed(const Transform& R) {
  Transform result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) result(row, column) = R(column, row);
  }
  return result;
}

/// Half the inverse rotation.
Transform half_back(const Transform& R) {
  const Quaternion q = quaternion_of(R);
  return pose_of(normalised({-q[0], -q[1], -q[2], q[3] + 1.0}), {});
}

/// The shortest rotation that takes `t` to the axis number `axis`, in the direction in which `t` goes along it.
Transform to_axis(const Vector& t, std::size_t axis) {
  const double length = std::hypot(t[0], t[1], t[2]);
  const double sign = t.at(axis) > 0.0 ? 1.0 : -1.0;
  Vector unit{};
  unit.at(axis) = sign;
  // The rotation between unit vectors a and b is the quaternion (a x b, 1 + a b), scaled to length 1.
  const Vector a = {t[0] / length, t[1] / length, t[2] / length};
  return pose_of(normalised({a[1] * unit[2] - a[2] * unit[1], a[2] * unit[0] - a[0] * unit[2], a[0] * unit[1] - a[1] * unit[0],
                             1.0 + std::abs(a.at(axis))}),
                 {});
}

}  // namespace

std::optional<RectifyingRotations> rectifying_rotations(const Transform& T_second_first) {
  const std::optional<Transform> exact = nearest_rotation(T_second_first);
  if (!exact) return std::nullopt;
  Transform rotation = *exact;
  for (int row = 0; row < 3; ++row) rotation(row, 3) = 0.0;
  const Vector translation = translation_of(T_second_first);
  constexpr double kShortest = 1e-9;  // m
  if (!(std::hypot(translation[0], translation[1], translation[2]) > kShortest)) return std::nullopt;
  const Transform half = half_back(rotation);
  const Vector t = rotated(half, translation);  // in the mean frame
  RectifyingRotations result;
  result.is_vertical = !(std::abs(t[0]) > std::abs(t[1]));
  const std::size_t axis = result.is_vertical ? 1 : 0;
  if (t.at(axis) == 0.0) return std::nullopt;  // one behind the other
  const Transform level = to_axis(t, axis);
  result.T_rectified_camera = {level * transposed(half), level * half};
  result.offset_m = -rotated(level, t).at(axis);  // the first camera's centre is at t in the second's axes
  return result;
}

Transform pose_of(const RectifiedPair& pair) {
  Transform between;
  between(pair.is_vertical ? 1 : 0, 3) = -pair.offset_m;
  return transposed(pair.views[1].T_rectified_camera) * between * pair.views[0].T_rectified_camera;
}

bool states_rectification(const Rig& rig) {
  if (!rig.rectified || !rig.rectified->sources.empty()) return false;
  const auto& [first, second] = rig.rectified->views;
  if (rig.find_camera(first.camera) == nullptr || rig.find_camera(second.camera) == nullptr) return false;
  const std::optional<Transform> T = rig.resolve(second.camera, first.camera);
  constexpr double kPrinted = 1e-5;
  const Transform stated = pose_of(*rig.rectified);
  return T && largest_difference(*T, stated).distance <= kPrinted && distance_between(*T, stated) <= kPrinted;
}

RectifiedPair exchanged(const RectifiedPair& pair) {
  RectifiedPair result = pair;
  std::swap(result.views[0], result.views[1]);
  if (result.sources.size() == 2) std::swap(result.sources[0], result.sources[1]);
  result.offset_m = -pair.offset_m;
  return result;
}

}  // namespace fca
