// SPDX-License-Identifier: BSD-3-Clause
// What an image shows between its pixels, at exactly the place asked for: cv::remap rounds places to 1/32 px.
#pragma once

#include <fca/models/camera_model.h>
#include <fca/rig/grey_image.h>
#include <fca/rig/rig.h>

#include <array>
#include <cstddef>
#include <optional>

namespace fca {

/// The 8 x 8 pixels about a place and how much each of them counts: products of sinc(x) sinc(x / 4), x the distance in px along
/// rows and columns, scaled to sum 1 (the kernel of cv::INTER_LANCZOS4). One window serves all colours of an image.
class LanczosWindow {
 public:
  static constexpr int kBefore = 3;  ///< Pixels before the one that holds the place.
  static constexpr int kSide = 8;

  /// Nothing where the window reaches beyond the image: nothing is made up there.
  [[nodiscard]] static std::optional<LanczosWindow> about(const Pixel& place, const ImageSize& size);

  /// `image`: of the size given to about(). In the unit of its samples, not rounded, and not clamped to black and white.
  [[nodiscard]] double value(const GreyImage& image) const;

 private:
  using Weights = std::array<double, kSide>;
  static Weights weights(double fraction);

  int first_u_ = 0;
  int first_v_ = 0;
  Weights along_u_{};
  Weights along_v_{};
};

}  // namespace fca
