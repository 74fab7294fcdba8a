// SPDX-License-Identifier: BSD-3-Clause
#include "rectification.h"

#include <fca/formats/rectified_image.h>
#include <fca/formats/text/numbers.h>
#include <fca/rectify/rectify.h>
#include <fca/rig/rotation.h>
#include <fca/rig/stereo_order.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::ros {

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a + s b
Vector sum(const Vector& a, double s, const Vector& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }

Vector scaled(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }

/// Nothing of a vector without a direction.
std::optional<Vector> unit(const Vector& a) {
  constexpr double kShortest = 1e-9;
  const double length = std::sqrt(dot(a, a));
  return length > kShortest ? std::optional(scaled(1.0 / length, a)) : std::nullopt;
}

/// The part of a that is at right angles to the unit vector n, of length 1.
std::optional<Vector> across(const Vector& a, const Vector& n) { return unit(sum(a, -dot(a, n), n)); }

Vector row_of(const Transform& T, int row) { return {T(row, 0), T(row, 1), T(row, 2)}; }

/// The rectified axes in the first camera, and where the second one is in them.
struct Axes {
  std::array<Vector, 3> axes;
  Vector second{};
};

/// T: the second camera's pose T_second_first, a rotation exactly.
std::optional<Axes> rectified_axes(const Transform& T) {
  // The second camera's axes in the first are the rows of its rotation.
  const std::optional<Vector> right = unit(sum(row_of(T, 0), 1.0, {1.0, 0.0, 0.0}));
  const std::optional<Vector> down = unit(sum(row_of(T, 1), 1.0, {0.0, 1.0, 0.0}));
  const std::optional<Vector> ahead = unit(sum(row_of(T, 2), 1.0, {0.0, 0.0, 1.0}));
  if (!right || !down || !ahead) return std::nullopt;
  Vector centre{};
  for (int i = 0; i < 3; ++i) centre = sum(centre, -T(i, 3), row_of(T, i));
  const std::optional<Vector> baseline = unit(centre);
  Vector x = *right;
  Vector y = *down;
  Vector z = *ahead;
  const bool above = baseline && std::abs(dot(*baseline, y)) > std::abs(dot(*baseline, x));
  if (baseline && above) {
    y = scaled(dot(*baseline, y) < 0.0 ? -1.0 : 1.0, *baseline);
  } else if (baseline) {
    x = scaled(dot(*baseline, x) < 0.0 ? -1.0 : 1.0, *baseline);
  }
  const std::optional<Vector> forward = across(z, above ? y : x);
  if (!forward) return std::nullopt;
  z = *forward;
  if (above) {
    x = cross(y, z);
  } else {
    const std::optional<Vector> level = across(x, z);  // without a baseline the mean axes are not quite at right angles
    if (!level) return std::nullopt;
    x = *level;
    y = cross(z, x);
  }
  const double least = std::numbers::sqrt2 / 2.0;  // 45 deg
  if (dot(z, {0.0, 0.0, 1.0}) < least || dot(z, row_of(T, 2)) < least) return std::nullopt;
  return Axes{{x, y, z}, {dot(x, centre), dot(y, centre), dot(z, centre)}};
}

Matrix3 rotation_of(const std::array<Vector, 3>& rows) {
  Matrix3 R{};
  for (std::size_t i = 0; i < R.size(); ++i) R.at(i) = rows.at(i / 3).at(i % 3);
  return R;
}

Matrix3 matrix_of(const Transform& T) {
  return {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
}

/// What a camera's file specifies of it.
struct Stated {
  std::optional<PoseEdge> place;         ///< T_frame_camera in a rectified frame.
  std::optional<Projection> projection;  ///< Where P is not [K | ..].
  bool is_reduced = false;               ///< P is of the whole sensor, and the camera of a part of it.
};

std::optional<Projection> parsed(const std::string& list) {
  Projection P{};
  std::size_t count = 0;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t start = list.find_first_not_of("[], ", at);
    if (start == std::string::npos) break;
    const std::size_t end = std::min(list.find_first_of("[], ", start), list.size());
    const std::optional<double> value = text::parse_real(list.substr(start, end - start));
    if (!value || !std::isfinite(*value) || count == P.size()) return std::nullopt;
    P.at(count++) = *value;
    at = end;
  }
  if (count != P.size() || P[0] == 0.0 || P[5] == 0.0) return std::nullopt;
  return P;
}

Stated stated_of(const Rig& rig, const Camera& camera) {
  Stated stated;
  for (const PoseEdge& edge : rig.poses) {
    if (edge.b == camera.name && is_rectified_frame(edge.a)) stated.place = edge;
    if (edge.a != camera.name || !is_rectified_frame(edge.b)) continue;
    if (const std::optional<Transform> T = inverse(edge.T_a_b)) stated.place = PoseEdge{edge.b, edge.a, *T};
  }
  const auto find = [&](std::string_view key) { return rig.find_extra_field(camera.name, key); };
  stated.is_reduced = std::ranges::any_of(kReductionKeys, [&](std::string_view key) { return find(key) != nullptr; });
  const ExtraField* extra = find(kProjection);
  if (extra != nullptr && !stated.is_reduced) stated.projection = parsed(extra->value);
  return stated;
}

/// The rectified image of a camera whose P specifies the same K, or what its file specifies.
Rectified as_stated(const Camera& camera, const Stated& stated) {
  Rectified result;
  result.P = stated.projection.value_or(projection_of(camera_matrix_of(camera.model)));
  result.P[3] = result.P[7] = 0.0;
  result.stated = stated.projection.has_value();
  if (!stated.place) return result;
  const Transform& T = stated.place->T_a_b;
  result.R = matrix_of(T);
  if (T(0, 3) != 0.0) result.P[3] = -result.P[0] * T(0, 3);
  if (T(1, 3) != 0.0) result.P[7] = -result.P[5] * T(1, 3);
  return result;
}

/// Do the files of two cameras specify a pair, in which they are as the rig says?
bool states_pair(const Rig& rig, const Stated& first, const Stated& second, const Transform& T_second_first) {
  if (!first.place || !second.place || first.place->a != second.place->a) return false;
  Rig files;
  files.poses = {*first.place, *second.place};
  const std::optional<Transform> T = files.resolve(rig.cameras[1].name, rig.cameras[0].name);
  constexpr double kSame = 1e-9;
  return T && std::ranges::equal(T->values, T_second_first.values, [](double a, double b) { return std::abs(a - b) <= kSame; });
}

/// A rectified image for both: no magnification where either lens has least, and the middle of both images near its middle.
void choose_images(const Rig& rig, const std::array<double, 2>& place, std::span<Rectified> pair) {
  double focal_length = 0.0;
  std::array<double, 2> centre{};
  for (std::size_t i = 0; i < pair.size(); ++i) {
    for (const double length : central_focal_lengths(rig.cameras[i].model))
      focal_length = focal_length == 0.0 ? length : std::min(focal_length, length);
  }
  for (std::size_t i = 0; i < pair.size(); ++i) {
    const Matrix3& R = pair[i].R;  // the optical axis is its last column
    const Pixel principal_point = fca::principal_point(rig.cameras[i].model);
    centre[0] += 0.5 * (principal_point[0] - focal_length * R[2] / R[8]);
    centre[1] += 0.5 * (principal_point[1] - focal_length * R[5] / R[8]);
  }
  const Matrix3 K = {focal_length, 0.0, centre[0], 0.0, focal_length, centre[1], 0.0, 0.0, 1.0};
  for (Rectified& camera : pair) {
    camera.P = projection_of(K);
    camera.stated = false;
  }
  // The left or upper camera is the origin.
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (place.at(axis) != 0.0) pair[place.at(axis) > 0.0 ? 1 : 0].P.at(4 * axis + 3) = -focal_length * std::abs(place.at(axis));
  }
}

/// Both cameras of a pair by its pose; false if no rectified image holds what both see.
bool choose(const Rig& rig, const Transform& T_second_first, Rectification& result) {
  const Transform exact = nearest_rotation(T_second_first).value_or(T_second_first);
  const std::optional<Axes> axes = rectified_axes(exact);
  if (!axes) return false;
  result.cameras[0].R = rotation_of(axes->axes);
  std::array<Vector, 3> second{};
  for (std::size_t i = 0; i < 3; ++i) second.at(i) = rotated(exact, axes->axes.at(i));
  result.cameras[1].R = rotation_of(second);
  std::array<double, 2> place = {axes->second[0], axes->second[1]};
  place[std::abs(place[0]) < std::abs(place[1]) ? 0 : 1] = 0.0;  // what rounding leaves of it
  choose_images(rig, place, std::span(result.cameras).first(2));
  constexpr double kRounding = 1e-9;
  if (largest_difference(exact, T_second_first).distance > kRounding)
    result.restated = PoseEdge{rig.cameras[1].name, rig.cameras[0].name, exact};
  return true;
}

/// The cameras of the pair that the rig specifies.
void take_stated_pair(const Rig& rig, Rectification& result) {
  const RectifiedPair& pair = *rig.rectified;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto camera = std::ranges::find(rig.cameras, pair.views.at(i).camera, &Camera::name);
    Rectified& rectified = result.cameras[static_cast<std::size_t>(camera - rig.cameras.begin())];
    const auto& [fx, fy] = pair.focal_lengths;
    const auto& [cx, cy] = pair.views.at(i).centre;
    rectified.R = matrix_of(pair.views.at(i).T_rectified_camera);
    rectified.P = projection_of({fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0});
    rectified.stated = true;
    if (i == 0) continue;
    const std::size_t axis = pair.is_vertical ? 1 : 0;
    rectified.P.at(4 * axis + 3) = -(axis == 0 ? fx : fy) * pair.offset_m;
  }
  result.stated = true;
  const auto& [first, second] = pair.views;
  const Transform T = pose_of(pair);
  const Transform in_rig = *rig.resolve(second.camera, first.camera);
  constexpr double kRounding = 1e-9;
  if (largest_difference(T, in_rig).distance > kRounding || distance_between(T, in_rig) > kRounding)
    result.restated = PoseEdge{second.camera, first.camera, T};
}

}  // namespace

void find_rectified_pair(Rig& rig) {
  struct Place {
    const Camera* camera;
    Stated stated;
  };
  std::vector<Place> places;
  for (const Camera& camera : rig.cameras) {
    Stated stated = stated_of(rig, camera);
    if (stated.place && !stated.is_reduced) places.push_back({&camera, std::move(stated)});
  }
  const auto is_origin = [](const Transform& T) { return T(0, 3) == 0.0 && T(1, 3) == 0.0; };
  for (const Place& first : places) {
    if (!is_origin(first.stated.place->T_a_b)) continue;
    for (const Place& second : places) {
      const Transform& T = second.stated.place->T_a_b;
      if (second.stated.place->a != first.stated.place->a || (T(0, 3) != 0.0) == (T(1, 3) != 0.0)) continue;
      const std::array images = {as_stated(*first.camera, first.stated).P, as_stated(*second.camera, second.stated).P};
      if (images[0][0] != images[1][0] || images[0][5] != images[1][5]) continue;
      RectifiedPair pair;
      pair.focal_lengths = {images[0][0], images[0][5]};
      pair.is_vertical = T(1, 3) != 0.0;
      pair.offset_m = pair.is_vertical ? T(1, 3) : T(0, 3);
      for (std::size_t i = 0; i < 2; ++i) {
        const Place& place = i == 0 ? first : second;
        Transform R = place.stated.place->T_a_b;
        R(0, 3) = R(1, 3) = 0.0;
        pair.views.at(i) = {place.camera->name, R, {images.at(i)[2], images.at(i)[6]}};
      }
      rig.rectified = pair;
      // P is all there now.
      std::erase_if(rig.extra_fields, [&](const ExtraField& extra) {
        return extra.key == kProjection && (extra.owner == first.camera->name || extra.owner == second.camera->name);
      });
      return;
    }
  }
}

Rectification rectification_of(const Rig& rig) {
  Rectification result;
  std::vector<Stated> stated;
  for (const Camera& camera : rig.cameras) {
    stated.push_back(stated_of(rig, camera));
    result.cameras.push_back(as_stated(camera, stated.back()));
  }
  if (states_rectification(rig)) {
    take_stated_pair(rig, result);
    return result;
  }
  if (rig.cameras.size() < 2) return result;
  const std::optional<Transform> T = rig.resolve(rig.cameras[1].name, rig.cameras[0].name);
  if (!T) return result;
  const auto alike = [&](std::size_t place) { return result.cameras[0].P.at(place) == result.cameras[1].P.at(place); };
  if (states_pair(rig, stated[0], stated[1], *T) && alike(0) && alike(5) && alike(6)) return result;
  result.is_vertical = second_below_first(rig).has_value();
  result.chosen = !result.is_vertical && choose(rig, *T, result);
  if (result.chosen) return result;
  for (std::size_t i = 0; i < 2; ++i) result.cameras[i] = as_stated(rig.cameras[i], {{}, stated[i].projection});
  return result;
}

}  // namespace fca::ros

namespace fca {

std::optional<RectifiedImage> rectified_image(const Rig& rig, const Camera& camera) {
  const ros::Stated stated = ros::stated_of(rig, camera);
  const ros::Rectified image = ros::as_stated(camera, stated);
  const bool is_turned = stated.place && image.R != ros::kIdentity;
  if (stated.is_reduced || !(is_turned || stated.projection)) return std::nullopt;
  RectifiedImage result;
  result.camera = camera;
  result.camera.model = Intrinsics<Pinhole>{{image.P[0], image.P[5], image.P[2], image.P[6]}};
  for (int i = 0; i < 9; ++i) result.T_rectified_camera(i / 3, i % 3) = image.R.at(static_cast<std::size_t>(i));
  return result;
}

}  // namespace fca
