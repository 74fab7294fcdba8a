// SPDX-License-Identifier: BSD-3-Clause
// The camera of images that were cropped, binned or resized after the calibration.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <array>
#include <optional>

namespace fca {

/// Where a pixel of the calibrated image is in the changed one: u' = scale[0] u + shift[0], v' = scale[1] v + shift[1].
struct PixelMap {
  std::array<double, 2> scale = {1.0, 1.0};
  std::array<double, 2> shift = {0.0, 0.0};

  [[nodiscard]] Pixel operator()(const Pixel& pixel) const {
    return {scale[0] * pixel[0] + shift[0], scale[1] * pixel[1] + shift[1]};
  }
  /// From the changed image back.
  [[nodiscard]] PixelMap inverse() const {
    return {{1.0 / scale[0], 1.0 / scale[1]}, {-shift[0] / scale[0], -shift[1] / scale[1]}};
  }
  bool operator==(const PixelMap&) const = default;
};

/// The model whose pixels are the map's of `model`: project(result, ray) = map(project(model, ray)). Exact (to rounding) for
/// every model, also where the scales differ, which must be positive; the rays that have a pixel stay the same.
[[nodiscard]] CameraModel with_pixels(const CameraModel& model, const PixelMap& map);

/// The circle in the changed image; nothing where the scales differ by more than a size's rounding to whole pixels: stretched
/// along one side it is none.
[[nodiscard]] std::optional<LensCircle> with_pixels(const LensCircle& circle, const PixelMap& map);

/// What was done to the images, in this order, as sensors do it.
struct ImageChange {
  std::optional<ImageRegion> crop = {};  ///< In pixels of the calibrated image.
  int binning = 1;                       ///< N x N pixels become one; columns and rows beyond a multiple of N are left out.
  std::optional<ImageSize> resize = {};

  [[nodiscard]] bool changes_nothing() const { return !crop && binning == 1 && !resize; }
};

/// The map of that change and the size of its images; nothing with an error where an image of that size does not hold the
/// region or not one bin. A pixel is an area, its centre in the middle: scaling by s takes c to (c + 0.5) s - 0.5, as
/// cv::resize and binning sensors do (TUM VI's calibrations for 1024 and 512 pixels agree with it to 1e-3 px).
struct ChangedImage {
  PixelMap map;
  ImageSize size;
};
[[nodiscard]] std::optional<ChangedImage> changed_image(const ImageSize& size, const ImageChange& change,
                                                        Diagnostics& diagnostics);

/// The camera of the changed images; nothing with an error, also where its image size is not known. A lens circle that is none
/// any more is left out with a warning.
[[nodiscard]] std::optional<Camera> with_changed_images(const Camera& camera, const ImageChange& change,
                                                        Diagnostics& diagnostics);

}  // namespace fca
