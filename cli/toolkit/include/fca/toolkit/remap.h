// SPDX-License-Identifier: BSD-3-Clause
// Images as another camera would have taken them.
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

/// A pinhole camera: straight lines are straight.
struct PinholeView {
  double full_fov_rad = 0.0;           ///< Across the width.
  std::optional<ImageSize> size = {};  ///< Nothing: the input's.
};
/// All directions: columns are longitudes, rows are latitudes (equirectangular_ray()).
struct EquirectangularView {
  std::optional<ImageSize> size = {};  ///< Nothing: 2 : 1, with as many pixels per degree as the middle of the input's image.
};
/// The camera of a calibration file: its only one, or that of the same name.
struct CameraOfFile {
  std::string path;
};
/// The input's camera as another model.
struct AsModel {
  const ModelInfo* model = nullptr;  ///< Null: its own.
};
/// std::monostate: the input's camera itself, to be turned.
using ViewCamera = std::variant<std::monostate, PinholeView, EquirectangularView, CameraOfFile, AsModel>;

/// First yaw (about y: positive to the right), then pitch (about its x: positive up), then roll (about its z: positive
/// clockwise): R = Ry(yaw) Rx(pitch) Rz(roll) takes the new camera's rays to the old one's.
struct Turn {
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

struct RemapRequest {
  Inputs inputs;  ///< One camera, whose images they are.
  ViewCamera view;
  std::optional<Turn> turn;
  std::size_t jobs = 0;  ///< Rows at the same time; 0: as many as there are processors.
};

struct RemapResult {
  Status status = Status::kDone;
  Camera source;
  Camera view;  ///< Of an equirectangular view its size alone.
  bool is_equirectangular = false;
  std::string colmap_camera;  ///< Of an equirectangular view: its line of COLMAP's cameras.txt.
  Transform T_source_view;    ///< A rotation.
  ImageMap map;
  std::vector<std::uint8_t> mask;  ///< Of the view: 255 where the source sees, else 0. Rows from the top.
  double seen_share = 0.0;         ///< Of the view.
  Diagnostics diagnostics;
};

/// The map from the view's pixels to the source's.
[[nodiscard]] RemapResult remap(const RemapRequest& request, Files& files);

/// The image through a map, 0 where the map lies outside of it, as cv::remap does it. Sides are to be shorter than 32,767 px.
/// Nothing where OpenCV cannot do it.
[[nodiscard]] std::optional<Image> remapped(const Image& image, const ImageMap& map, Interpolation interpolation);

}  // namespace fca
