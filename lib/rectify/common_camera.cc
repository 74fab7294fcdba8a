// SPDX-License-Identifier: BSD-3-Clause
// The camera that both become. cv::stereoRectify's way (calib3d/src/calibration.cpp, OpenCV 4.6): the focal length is the mean
// of both cameras' across the rows that are matched; the mean of both images' corners lies in the middle; alpha then scales the
// view between the largest rectangle inside both images and the smallest about both.
#include <fca/code.h>
#include <fca/rectify/rectify.h>
#include <fca/remap/view.h>
#include <fca/rig/fields_of_view.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace fca {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNarrowLens = kWidestRectifiedView;

using Point = std::array<double, 2>;

/// Where a pixel of the camera's image is in the rectified one's plane z = 1; nothing where it is behind that.
std::optional<Point> in_plane(const Camera& camera, const Transform& T_rectified_camera, const Pixel& pixel) {
  const std::optional<Ray> ray = unproject(camera.model, pixel);
  if (!ray) return std::nullopt;
  const Ray turned = rotated(T_rectified_camera, *ray);
  constexpr double kAlmostBehind = 1e-6;
  if (!(turned[2] > kAlmostBehind)) return std::nullopt;
  return Point{turned[0] / turned[2], turned[1] / turned[2]};
}

/// Of an image's border in that plane: left, top, right, bottom.
struct Borders {
  std::array<double, 4> inner = {-kInfinity, -kInfinity, kInfinity, kInfinity};  ///< The largest rectangle inside it.
  std::array<double, 4> outer = {kInfinity, kInfinity, -kInfinity, -kInfinity};  ///< The smallest about it.
};

Borders borders_of(const Camera& camera, const Transform& T_rectified_camera) {
  constexpr int kSteps = 64;
  const double width = camera.image_size->width - 1.0;
  const double height = camera.image_size->height - 1.0;
  Borders result;
  auto& [inner, outer] = result;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = width * i / kSteps;
    const double v = height * i / kSteps;
    const std::array<Pixel, 4> pixels = {Pixel{0.0, v}, Pixel{u, 0.0}, Pixel{width, v}, Pixel{u, height}};
    for (std::size_t side = 0; side < 4; ++side) {
      const std::size_t axis = side % 2;
      const std::optional<Point> point = in_plane(camera, T_rectified_camera, pixels.at(side));
      if (!point) {
        outer = {-kInfinity, -kInfinity, kInfinity, kInfinity};
        continue;
      }
      const auto widest = [side](double a, double b, bool inside) {
        return (side < 2) == inside ? std::max(a, b) : std::min(a, b);
      };
      inner.at(side) = widest(inner.at(side), (*point)[axis], true);
      outer[0] = std::min(outer[0], (*point)[0]);
      outer[1] = std::min(outer[1], (*point)[1]);
      outer[2] = std::max(outer[2], (*point)[0]);
      outer[3] = std::max(outer[3], (*point)[1]);
    }
  }
  return result;
}

/// The mean of an image's corners in the plane; of one whose corners are behind it the point of the image's middle.
std::optional<Point> middle_of(const Camera& camera, const Transform& T_rectified_camera) {
  const double width = camera.image_size->width - 1.0;
  const double height = camera.image_size->height - 1.0;
  Point mean{};
  for (const Pixel& corner : {Pixel{0.0, 0.0}, Pixel{width, 0.0}, Pixel{0.0, height}, Pixel{width, height}}) {
    const std::optional<Point> point = in_plane(camera, T_rectified_camera, corner);
    if (!point) return in_plane(camera, T_rectified_camera, {0.5 * width, 0.5 * height});
    mean[0] += 0.25 * (*point)[0];
    mean[1] += 0.25 * (*point)[1];
  }
  return mean;
}

/// A view as it is being made: focal length and centre of an image of `size`.
struct View {
  double focal_length = 0.0;
  Pixel centre{};
};

/// How much a view must be magnified so that the borders in the plane are at those of the image, at least or at most.
double scale_to(const std::array<double, 4>& borders, const View& view, const Pixel& new_centre, const ImageSize& size,
                bool inside) {
  double scale = inside ? 0.0 : kInfinity;
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t axis = side % 2;
    const double last = (axis == 0 ? size.width : size.height) - 1.0;
    const double wanted = side < 2 ? new_centre.at(axis) : last - new_centre.at(axis);
    const double there = view.focal_length * (side < 2 ? -borders.at(side) : borders.at(side));
    const double ratio = there > 0.0 ? wanted / there : inside ? kInfinity : 0.0;
    scale = inside ? std::max(scale, ratio) : std::min(scale, ratio);
  }
  return scale;
}

using Cameras = std::array<const Camera*, 2>;

std::optional<View> view_by_alpha(const Cameras& cameras, const RectifyingRotations& rotations, const ImageSize& size,
                                  double alpha) {
  const ImageSize& old_size = *cameras[0]->image_size;
  const std::array<double, 2> ratio = {static_cast<double>(size.width) / old_size.width,
                                       static_cast<double>(size.height) / old_size.height};
  const std::size_t across = rotations.is_vertical ? 0 : 1;
  View view;
  for (const Camera* camera : cameras)
    view.focal_length += 0.5 * central_focal_lengths(camera->model).at(across) * ratio.at(across);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<Point> middle = middle_of(*cameras.at(i), rotations.T_rectified_camera.at(i));
    if (!middle) return std::nullopt;
    view.centre[0] += 0.5 * (0.5 * (old_size.width - 1.0) - view.focal_length * (*middle)[0]);
    view.centre[1] += 0.5 * (0.5 * (old_size.height - 1.0) - view.focal_length * (*middle)[1]);
  }
  const Pixel new_centre = {view.centre[0] * ratio[0], view.centre[1] * ratio[1]};
  double least = 0.0;
  double most = kInfinity;
  for (std::size_t i = 0; i < 2; ++i) {
    const Borders borders = borders_of(*cameras.at(i), rotations.T_rectified_camera.at(i));
    least = std::max(least, scale_to(borders.inner, view, new_centre, size, true));
    most = std::min(most, scale_to(borders.outer, view, new_centre, size, false));
  }
  const double scale = least * (1.0 - alpha) + most * alpha;
  if (!(std::isfinite(scale) && scale > 0.0)) return std::nullopt;
  return View{view.focal_length * scale, new_centre};
}

View view_by_field(const ImageSize& size, double full_fov_rad) {
  return {0.5 * size.width / std::tan(0.5 * full_fov_rad), {0.5 * (size.width - 1.0), 0.5 * (size.height - 1.0)}};
}

/// As fine as the middle of the finer image.
View finest_view(const Cameras& cameras, const ImageSize& size) {
  double focal_length = 0.0;
  for (const Camera* camera : cameras)
    focal_length = std::max(focal_length, std::ranges::max(central_focal_lengths(camera->model)));
  focal_length *= static_cast<double>(size.width) / cameras[0]->image_size->width;
  const double full_fov = 2.0 * std::atan(0.5 * size.width / focal_length);
  return view_by_field(size, std::min(full_fov, kWidestRectifiedView));
}

bool is_wide(const Camera& camera) {
  const std::optional<double> across = horizontal_field_of_view(camera);
  return !across || *across >= kNarrowLens;
}

/// From the left border to the right one, or from the upper to the lower one, of the pixels' outer edges.
double widest_field(const View& view, const ImageSize& size) {
  const auto field = [&](double centre, int pixels) {
    return std::atan((centre + 0.5) / view.focal_length) + std::atan((pixels - 0.5 - centre) / view.focal_length);
  };
  return std::max(field(view.centre[0], size.width), field(view.centre[1], size.height));
}

/// The share of the image that is more than 60 deg from its axis.
double stretched_share(const View& view, const ImageSize& size) {
  constexpr int kSteps = 200;
  const double radius = view.focal_length * std::tan(0.5 * kWidestRectifiedView);
  int beyond = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double u = (i + 0.5) / kSteps * size.width - 0.5 - view.centre[0];
      const double v = (j + 0.5) / kSteps * size.height - 0.5 - view.centre[1];
      beyond += std::hypot(u, v) > radius ? 1 : 0;
    }
  }
  return static_cast<double>(beyond) / (kSteps * kSteps);
}

std::optional<View> chosen_view(const Cameras& cameras, const RectifyingRotations& rotations, const ImageSize& size,
                                const RectifiedViewChoice& choice) {
  if (const auto* field = std::get_if<RectifiedByField>(&choice)) return view_by_field(size, field->full_fov_rad);
  if (const auto* by_alpha = std::get_if<RectifiedByAlpha>(&choice))
    return view_by_alpha(cameras, rotations, size, by_alpha->alpha);
  if (is_wide(*cameras[0]) || is_wide(*cameras[1])) return finest_view(cameras, size);
  return view_by_alpha(cameras, rotations, size, 0.0);
}

constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

std::optional<RectifiedPair> rectify(const Camera& first, const Camera& second, const Transform& T_second_first,
                                     const RectifyOptions& options, Diagnostics& diagnostics) {
  for (const Camera* camera : {&first, &second}) {
    if (camera->image_size) continue;
    diagnostics.add(Code::kCameraWithoutSize, {camera->name});
    return std::nullopt;
  }
  if (first.image_size != second.image_size) {
    diagnostics.add(Code::kRectifySizesDiffer, {first.name, first.image_size->width, first.image_size->height, second.name,
                                                second.image_size->width, second.image_size->height});
    return std::nullopt;
  }
  const std::optional<RectifyingRotations> rotations = rectifying_rotations(T_second_first);
  if (!rotations) {
    diagnostics.add(Code::kRectifyNoBaseline, {first.name, second.name});
    return std::nullopt;
  }
  const ImageSize size = options.size.value_or(*first.image_size);
  const std::optional<View> view = chosen_view({&first, &second}, *rotations, size, options.view);
  if (!view) {
    diagnostics.add(Code::kRectifyNoValidPart, {first.name});
    return std::nullopt;
  }
  constexpr double kRounding = 1e-9;
  if (const double field = widest_field(*view, size); field > kWidestRectifiedView + kRounding) {
    diagnostics.add(Code::kRectifyViewTooWide, {field * kDegrees, stretched_share(*view, size)});
    return std::nullopt;
  }
  RectifiedPair pair;
  pair.views = {RectifiedPair::View{first.name, rotations->T_rectified_camera[0], view->centre},
                RectifiedPair::View{second.name, rotations->T_rectified_camera[1], view->centre}};
  pair.focal_lengths = {view->focal_length, view->focal_length};
  pair.size = size;
  pair.is_vertical = rotations->is_vertical;
  pair.offset_m = rotations->offset_m;
  const Cameras cameras = {&first, &second};
  for (std::size_t i = 0; i < 2 && options.valid_regions; ++i) {
    pair.views.at(i).valid = valid_region(*cameras.at(i), pair, i, size);
    if (pair.views.at(i).valid) continue;
    diagnostics.add(Code::kRectifyNoValidPart, {cameras.at(i)->name});
    return std::nullopt;
  }
  return pair;
}

Camera rectified_camera(const RectifiedPair& pair, std::size_t view, const ImageSize& size) {
  Camera camera;
  camera.name = pair.views.at(view).camera;
  camera.image_size = size;
  const auto& [fx, fy] = pair.focal_lengths;
  const auto& [cx, cy] = pair.views.at(view).centre;
  camera.model = Intrinsics<Pinhole>{{fx, fy, cx, cy}};
  return camera;
}

}  // namespace fca
