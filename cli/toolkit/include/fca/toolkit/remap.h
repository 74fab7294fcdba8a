// SPDX-License-Identifier: BSD-3-Clause
// Computes the images that another camera would have taken.
#pragma once

#include <fca/remap/image_map.h>
#include <fca/toolkit/image.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/status.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fca {

/// A pinhole camera, which shows straight lines as straight lines.
struct PinholeView {
  double full_fov_rad = 0.0;           ///< Horizontal field of view.
  std::optional<ImageSize> size = {};  ///< nullopt: the size of the input's images.
};
/// An image of all directions: columns are longitudes, rows are latitudes (equirectangular_ray()).
struct EquirectangularView {
  /// nullopt: twice as wide as high, with as many pixels per degree as the middle of the input's image.
  std::optional<ImageSize> size = {};
};
/// A camera of a calibration file: its only camera, or the one that has the name of the input's camera.
struct CameraOfFile {
  std::string path;
};
/// The input's camera converted to another model.
struct AsModel {
  const ModelInfo* model = nullptr;  ///< Null: the camera's own model.
};
/// The camera of the new images. std::monostate: the input's camera itself, for views that are only rotated.
using ViewCamera = std::variant<std::monostate, PinholeView, EquirectangularView, CameraOfFile, AsModel>;

/// A rotation of the camera: first yaw (about y; positive: to the right), then pitch (about the new x; positive: up), then roll
/// (about the new z; positive: clockwise). R = Ry(yaw) Rx(pitch) Rz(roll) maps rays of the new camera to rays of the old
/// camera.
struct Turn {
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

struct RemapRequest {
  Inputs inputs;  ///< A calibration with one camera: that of the images to remap.
  ViewCamera view;
  std::optional<Turn> turn;  ///< A rotation of the new camera.
  std::size_t jobs = 0;      ///< Number of rows that are computed at the same time. 0: number of processors.
};

struct RemapResult {
  Status status = Status::kDone;
  Camera source;
  Camera view;  ///< The camera of the new images. If they are equirectangular, only its image size is valid.
  bool is_equirectangular = false;
  std::string colmap_camera;  ///< For an equirectangular view: its line in COLMAP's cameras.txt. Empty for other views.
  Transform T_source_view;    ///< A rotation: maps rays of the view to rays of the source.
  ImageMap map;
  std::vector<std::uint8_t> mask;  ///< For each pixel of the view, rows from the top: 255 if the source sees it, else 0.
  double seen_share = 0.0;         ///< The share of the view's pixels that the source sees.
  Diagnostics diagnostics;
};

/// Computes the map from the pixels of the view to the pixels of the source.
[[nodiscard]] RemapResult remap(const RemapRequest& request, Files& files);

/// Remaps an image with cv::remap. Pixels that the map takes from outside of the image are 0. The sides of both images must be
/// shorter than 32,767 px. nullopt if OpenCV fails.
[[nodiscard]] std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation);

}  // namespace fca
