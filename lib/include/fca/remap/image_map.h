// SPDX-License-Identifier: BSD-3-Clause
// Where the pixels of one camera's image lie in another's: target pixel -> ray -> turned -> source pixel.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>
#include <fca/rig/transform.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace fca {

/// For each pixel of a target image the place in the source image that it shows.
struct ImageMap {
  ImageSize size;  ///< Of the target image.
  /// Rows from the top, u and v of each pixel, in pixels of the source image (which they may lie outside of); not a number
  /// where the source's model has no pixel. As cv::remap takes it (CV_32FC2).
  std::vector<float> uv;
};

/// Makes the rows of such a map. Computed in double; agrees with project(source, R unproject(target, pixel)) to 1e-9 px before
/// it is rounded to float.
class ImageMapper {
 public:
  /// `T_source_target`: only its rotation counts, which takes rays of the target to rays of the source. `limit_rad`: the source
  /// sees nothing further from its axis, and nothing outside its lens circle. Errors: a camera without a usable size or
  /// parameters, or no ray at all in the target's image.
  [[nodiscard]] static std::optional<ImageMapper> between(const Camera& source, const Camera& target,
                                                          const Transform& T_source_target, std::optional<double> limit_rad,
                                                          Diagnostics& diagnostics);
  /// To an equirectangular image of that size (equirectangular_ray()).
  [[nodiscard]] static std::optional<ImageMapper> to_equirectangular(const Camera& source, const ImageSize& size,
                                                                     const Transform& T_source_target,
                                                                     std::optional<double> limit_rad, Diagnostics& diagnostics);
  ImageMapper(ImageMapper&&) noexcept;
  ImageMapper& operator=(ImageMapper&&) noexcept;
  ~ImageMapper();

  [[nodiscard]] ImageSize size() const;  ///< Of the target image.
  /// Row `v` of the map: u and v of each of its pixels. May be called from several threads.
  void row(int v, std::span<float> uv) const;

 private:
  struct Pair;
  explicit ImageMapper(std::unique_ptr<const Pair> pair);
  std::unique_ptr<const Pair> pair_;
};

/// All rows.
[[nodiscard]] ImageMap image_map(const ImageMapper& mapper);

/// 255 for each pixel whose place lies in the source's image (between the centres of its outermost pixels, to 1/64 px: half of
/// what cv::remap tells apart), 0 for the others. Rows from the top.
[[nodiscard]] std::vector<std::uint8_t> seen(const ImageMap& map, const ImageSize& source);

}  // namespace fca
