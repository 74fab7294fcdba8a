// SPDX-License-Identifier: BSD-3-Clause
#include "matches.h"

#include <fca/rig/rotation.h>

#include <cmath>

namespace fca::internal {

namespace {

constexpr double kFar = 10.0;  // baselines

/// One rectified image.
class View {
 public:
  View(const Camera& camera, const RectifiedPair& pair, std::size_t view)
      : camera_(camera),
        size_(*pair.size),
        model_(rectified_camera(pair, view, size_).model),
        T_rectified_camera_(pair.views.at(view).T_rectified_camera),
        across_(pair.is_vertical ? 0 : 1) {}

  [[nodiscard]] bool shows(const Ray& ray) const {
    const std::optional<Pixel> pixel = project(model_, rotated(T_rectified_camera_, ray));
    return pixel && size_.holds(*pixel);
  }
  /// By central differences; nothing where a neighbour has no ray.
  [[nodiscard]] std::optional<Eigen::RowVector2d> row_slope(const Pixel& pixel) const {
    constexpr double kStep = 0.25;  // px
    Eigen::RowVector2d slope;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Pixel before = pixel;
      Pixel after = pixel;
      before.at(axis) -= kStep;
      after.at(axis) += kStep;
      const std::optional<double> row_before = row_of(before);
      const std::optional<double> row_after = row_of(after);
      if (!row_before || !row_after) return std::nullopt;
      slope[static_cast<Eigen::Index>(axis)] = (*row_after - *row_before) / (2.0 * kStep);
    }
    return slope;
  }

 private:
  [[nodiscard]] std::optional<double> row_of(const Pixel& pixel) const {
    const std::optional<Ray> ray = unproject(camera_.model, pixel);
    const std::optional<Pixel> rectified = ray ? project(model_, rotated(T_rectified_camera_, *ray)) : std::nullopt;
    return rectified ? std::optional(rectified->at(across_)) : std::nullopt;
  }

  const Camera& camera_;
  ImageSize size_;
  CameraModel model_;
  Transform T_rectified_camera_;
  std::size_t across_;
};

Ray unit(const std::array<double, 3>& direction) {
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  return {direction[0] / length, direction[1] / length, direction[2] / length};
}

/// Where the camera shows a ray, if it counts there.
std::optional<Pixel> counted_pixel(const CameraOfPair& of_pair, const Ray& ray) {
  if (std::atan2(std::hypot(ray[0], ray[1]), ray[2]) > of_pair.domain.max_angle_rad) return std::nullopt;
  if (!project(*of_pair.start, ray)) return std::nullopt;
  const std::optional<Pixel> pixel = project(of_pair.camera->model, ray);
  return pixel && of_pair.domain.size.holds(*pixel) && of_pair.domain.is_lit(*pixel) ? pixel : std::nullopt;
}

void add_match(const std::array<View, 2>& views, const Correspondence& first, const Correspondence& second, Matches& matches) {
  if (!views[0].shows(first.ray) || !views[1].shows(second.ray)) return;
  const std::optional<Eigen::RowVector2d> first_slope = views[0].row_slope(first.pixel);
  const std::optional<Eigen::RowVector2d> second_slope = views[1].row_slope(second.pixel);
  if (!first_slope || !second_slope) return;
  matches.seen[0].push_back(first);
  matches.seen[1].push_back(second);
  matches.row_slopes[0].push_back(*first_slope);
  matches.row_slopes[1].push_back(*second_slope);
}

}  // namespace

Matches matches_of(const std::array<CameraOfPair, 2>& cameras, const Transform& T_second_first, const RectifiedPair& pair) {
  const std::array<View, 2> views = {View(*cameras[0].camera, pair, 0), View(*cameras[1].camera, pair, 1)};
  const double distance_m = kFar * distance_of(T_second_first);
  const std::array<double, 3> t = translation_of(T_second_first);
  Matches matches;
  for (const Correspondence& first : cameras[0].samples) {
    const Ray turned = rotated(T_second_first, first.ray);
    const Ray near = unit({distance_m * turned[0] + t[0], distance_m * turned[1] + t[1], distance_m * turned[2] + t[2]});
    for (const Ray& ray : {turned, near}) {
      const std::optional<Pixel> pixel = counted_pixel(cameras[1], ray);
      if (pixel) add_match(views, first, {ray, *pixel, first.weight}, matches);
    }
  }
  double sum = 0.0;
  for (const Correspondence& each : matches.seen[0]) sum += each.weight;
  for (std::vector<Correspondence>& seen : matches.seen) {
    for (Correspondence& each : seen) each.weight /= sum;
  }
  return matches;
}

}  // namespace fca::internal
