// SPDX-License-Identifier: BSD-3-Clause
// How far apart a camera and the program that reads its file see the same ray: one number for the fit's error and the program's
// misreading together.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/rig/rig.h>

#include <optional>
#include <vector>

namespace fca {

/// Distances between the camera's pixel of a ray and the program's, over a region of the image. Pixels of the camera's image.
struct PixelDistance {
  double rms = 0.0;
  double p99 = 0.0;     ///< 99th percentile.
  double max = 0.0;     ///< Of the points of a lattice.
  double region = 0.0;  ///< The region's share of the image, 0 to 1: only pixels that have a ray.
  double no_rays =
      0.0;  ///< Share of the region for which the program has no right pixel or no right ray; not in the distances.
  bool operator==(const PixelDistance&) const = default;
};

/// A pixel of the camera's image, and the program's for the same ray.
struct SeenPixel {
  Pixel camera{};
  std::optional<Pixel> program = {};  ///< Nothing: it has none, one on the other side of the image, or another ray for it.
};

struct CameraDistance {
  PixelDistance in_circle;  ///< Inside the largest circle about the middle of the image.
  PixelDistance in_image;
  bool is_wide = false;  ///< The lens sees more than 120 deg: its corners are beyond what programs use.
  int grid_steps = 0;    ///< The image's pixels in so many steps along each side,
  std::vector<std::optional<SeenPixel>> grid = {};  ///< column by column; nothing where the camera has no ray.

  /// That by which the file is evaluated.
  [[nodiscard]] const PixelDistance& decisive() const { return is_wide ? in_circle : in_image; }
};

/// How far from the axis a comparison goes, in radians.
struct AngleLimits {
  double asked = std::numbers::pi;   ///< Rays beyond are not asked for.
  double fitted = std::numbers::pi;  ///< Rays beyond have no right pixel in the model of the file.
};

/// `camera`: as it was calibrated; of a known image size. `written`: the same camera in the model of the file. `reader`: what
/// the program holds of it. Rays outside the camera's image circle are not asked for. `has_gaps`: it is known that the program
/// has no right ray for a part of the image. `T_written_camera`: the rotation of the written camera's frame, if it has another.
[[nodiscard]] CameraDistance distance_of(const Camera& camera, const CameraModel& written,
                                         const consumers::ConsumerCamera& reader, const AngleLimits& limits,
                                         bool has_gaps = false, const std::optional<Transform>& T_written_camera = {});

/// How far from the axis, in whole degrees, the camera sees in the largest circle about the middle of its image: the smallest
/// angle that holds all of it. Nothing where the image size is unknown, or the model ends inside the circle.
[[nodiscard]] std::optional<double> degrees_in_circle(const Camera& camera);

}  // namespace fca
