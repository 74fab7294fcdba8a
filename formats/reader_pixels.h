// SPDX-License-Identifier: BSD-3-Clause
// Private: pixels of a file next to those of a program that reads it and may scale its images.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/pixel_distance.h>
#include <fca/models/camera_model.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace fca {

/// Between pixels. (std::hypot, which also knows distances that doubles hold and their squares do not, takes ten times as
/// long.)
[[nodiscard]] inline double distance(const Pixel& a, const Pixel& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

[[nodiscard]] inline Pixel in_file_pixels(const Pixel& pixel, const consumers::ConsumerCamera& theirs) {
  return {pixel[0] / theirs.scale[0], pixel[1] / theirs.scale[1]};
}

[[nodiscard]] inline Pixel in_their_pixels(const Pixel& pixel, const consumers::ConsumerCamera& theirs) {
  return {pixel[0] * theirs.scale[0], pixel[1] * theirs.scale[1]};
}

/// How far the program's ray of the pixel lies from it, by the program's own formula; 0 where it has none. Both are the
/// program's, so that nothing else is counted: its inverse goes wrong beyond 90 degrees.
[[nodiscard]] inline double wrong_ray_px(const Pixel& pixel, const consumers::ConsumerCamera& theirs) {
  if (!theirs.unproject) return 0.0;
  const std::optional<Ray> ray = theirs.unproject(in_their_pixels(pixel, theirs));
  const std::optional<Pixel> back = ray ? theirs.project(*ray) : std::nullopt;
  return back ? distance(in_file_pixels(*back, theirs), pixel) : 0.0;
}

/// A point of an image, and what is found of it once it is asked for: programs' formulas take their time.
class ReaderPoint {
 public:
  /// The camera's ray.
  const std::optional<Ray>& ray(const CameraModel& model, const Pixel& pixel) {
    if (!ray_) ray_ = unproject(model, pixel);
    return *ray_;
  }
  /// The program's pixel of the camera's ray.
  const std::optional<Pixel>& image(const consumers::ConsumerCamera& theirs, const Ray& ray) {
    if (!image_) image_ = theirs.project(ray);
    return *image_;
  }
  /// wrong_ray_px()
  double wrong_px(const consumers::ConsumerCamera& theirs, const Pixel& pixel) {
    if (!wrong_px_) wrong_px_ = wrong_ray_px(pixel, theirs);
    return *wrong_px_;
  }

 private:
  std::optional<std::optional<Ray>> ray_;
  std::optional<std::optional<Pixel>> image_;
  std::optional<double> wrong_px_;
};

/// The points of a lattice over an image, column by column, of a camera and a program that do not change.
class ReaderPoints {
 public:
  /// So many steps along each side: where shares of the image are to be told.
  static constexpr int kSteps = 40;

  ReaderPoint& at(int i, int j) {
    points_.resize((kSteps + 1) * (kSteps + 1));
    return points_[static_cast<std::size_t>(i) * (kSteps + 1) + static_cast<std::size_t>(j)];
  }

 private:
  std::vector<ReaderPoint> points_;  ///< Made when the first is asked for.
};

/// distance_of() of pixel_distance.h. `known`: what was found before of that reader and a camera whose model is `written`.
[[nodiscard]] CameraDistance distance_of(const Camera& camera, const CameraModel& written,
                                         const consumers::ConsumerCamera& reader, const AngleLimits& limits, bool has_gaps,
                                         const std::optional<Transform>& T_written_camera, ReaderPoints& known);

}  // namespace fca
