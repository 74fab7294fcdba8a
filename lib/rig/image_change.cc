// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/rig/image_change.h>

#include <algorithm>
#include <cmath>
#include <concepts>

namespace fca {

namespace {

template <class M>
void map_pixels(double* p, const PixelMap& map) {
  if constexpr (std::derived_from<M, internal::FocalLengthsFirst>) {  // (fx m_x + cx, fy m_y + cy), whatever m is
    for (std::size_t axis = 0; axis < 2; ++axis) {
      p[axis] *= map.scale[axis];
      p[2 + axis] = map.scale[axis] * p[2 + axis] + map.shift[axis];
    }
  } else if constexpr (kIsSkewed<M>) {
    map_pixels<typename M::Straight>(p, map);
    p[M::kSkew] *= map.scale[0];
  } else {
    M::map_pixels(p, map);
  }
}

/// Whole images scaled from one size to another: edges stay edges.
void scale_to(const std::array<double, 2>& scale, PixelMap& map) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    map.scale[axis] *= scale[axis];
    map.shift[axis] = (map.shift[axis] + 0.5) * scale[axis] - 0.5;
  }
}

/// Compared so that x + width cannot overflow.
bool holds(const ImageSize& image, const ImageRegion& region) {
  return region.x >= 0 && region.y >= 0 && region.size.width > 0 && region.size.height > 0 &&
         region.size.width <= image.width - region.x && region.size.height <= image.height - region.y;
}

}  // namespace

CameraModel with_pixels(const CameraModel& model, const PixelMap& map) {
  return std::visit(
      [&map]<class M>(Intrinsics<M> intrinsics) -> CameraModel {
        map_pixels<M>(intrinsics.values.data(), map);
        return intrinsics;
      },
      model);
}

std::optional<LensCircle> with_pixels(const LensCircle& circle, const PixelMap& map) {
  constexpr double kRounding = 0.02;
  const auto [scale_u, scale_v] = map.scale;
  if (std::abs(scale_u - scale_v) > kRounding * std::max(scale_u, scale_v)) return std::nullopt;
  LensCircle result = circle;
  const double scale = std::sqrt(scale_u * scale_v);
  result.centre = map(circle.centre);
  result.radius_px *= scale;
  result.rms_px *= scale;
  return result;
}

std::optional<ChangedImage> changed_image(const ImageSize& size, const ImageChange& change, Diagnostics& diagnostics) {
  ChangedImage result{{}, size};
  if (change.crop) {
    if (!holds(size, *change.crop)) {
      const ImageRegion& crop = *change.crop;
      diagnostics.add(Code::kCropOutside, {size.width, size.height, crop.size.width, crop.size.height, crop.x, crop.y});
      return std::nullopt;
    }
    result.map.shift = {-static_cast<double>(change.crop->x), -static_cast<double>(change.crop->y)};
    result.size = change.crop->size;
  }
  if (change.binning != 1) {
    if (change.binning < 1 || change.binning > result.size.width || change.binning > result.size.height) {
      diagnostics.add(Code::kBinningImpossible, {result.size.width, result.size.height, change.binning});
      return std::nullopt;
    }
    result.size = {result.size.width / change.binning, result.size.height / change.binning};
    scale_to({1.0 / change.binning, 1.0 / change.binning}, result.map);
  }
  if (change.resize) {
    if (change.resize->width < 1 || change.resize->height < 1) {
      diagnostics.add(Code::kResizeImpossible, {change.resize->width, change.resize->height});
      return std::nullopt;
    }
    scale_to({static_cast<double>(change.resize->width) / result.size.width,
              static_cast<double>(change.resize->height) / result.size.height},
             result.map);
    result.size = *change.resize;
  }
  return result;
}

std::optional<Camera> with_changed_images(const Camera& camera, const ImageChange& change, Diagnostics& diagnostics) {
  if (change.changes_nothing()) return camera;
  if (!camera.image_size) {
    diagnostics.add(Code::kImageSizeNotGiven, {camera.name});
    return std::nullopt;
  }
  const std::optional<ChangedImage> changed = changed_image(*camera.image_size, change, diagnostics);
  if (!changed) return std::nullopt;
  Camera result = camera;
  result.model = with_pixels(camera.model, changed->map);
  for (Correspondence& entry : result.rays) entry.pixel = changed->map(entry.pixel);
  result.image_size = changed->size;
  if (camera.lens_circle) result.lens_circle = with_pixels(*camera.lens_circle, changed->map);
  const auto [along_u, along_v] = changed->map.scale;
  constexpr double kSameShape = 0.02;
  if (std::abs(along_u - along_v) > kSameShape * along_v) {
    diagnostics.add(Code::kImagesStretched, {camera.name, camera.image_size->width, camera.image_size->height,
                                             changed->size.width, changed->size.height, along_u / along_v});
  }
  if (camera.lens_circle && !result.lens_circle) {
    diagnostics.add(Code::kLensCircleStretched, {camera.name});
  }
  return result;
}

}  // namespace fca
