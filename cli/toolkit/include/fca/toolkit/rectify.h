// SPDX-License-Identifier: BSD-3-Clause
// A stereo pair whose matches lie in rows: the geometry, maps, and settings of programs that want rectified images.
#pragma once

#include <fca/formats/proof.h>
#include <fca/rectify/rectify.h>
#include <fca/rectify/vertical_disparity.h>
#include <fca/remap/image_map.h>
#include <fca/toolkit/convert.h>
#include <fca/toolkit/files.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/status.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fca {

/// The formats that hold a rectified pair.
[[nodiscard]] std::vector<std::string> rectified_formats();

struct OpenCvPair;  // toolkit/rectify/stereo_rectify.h
struct OpenCvRectification;
/// Calls OpenCV's stereoRectify or fisheye::stereoRectify. Nothing where that fails.
using OpenCvRectifier = std::function<std::optional<OpenCvRectification>(const OpenCvPair& pair)>;

struct RectifyRequest {
  Inputs inputs;  ///< Two cameras; of more those that have most in common.
  /// std::monostate and no size: what the files specify, else computed.
  RectifiedViewChoice view;
  std::optional<ImageSize> size;  ///< Of the rectified images; nothing: as the cameras'.
  OpenCvRectifier like_opencv;    ///< Empty: our own.
  const Format* to = nullptr;     ///< Of the settings; null: none.
  std::optional<FormatLayout> layout = {};
  std::string extension = {};  ///< As ConvertRequest's.
  std::string made_by = {};    ///< For the comment in the files: the command or program that asks.
  bool maps = false;           ///< The maps are wanted.
  std::size_t jobs = 0;        ///< Rows at the same time; 0: as many as there are processors.
};

/// The two cameras in the order of their images: left and right; upper and lower where one stands above the other.
struct RectifyResult {
  Status status = Status::kDone;
  std::array<Camera, 2> cameras;
  Transform T_second_first;           ///< As the poses of the files have it.
  RectifiedPair pair;                 ///< Its first view is the left (upper) camera's.
  ImageSize size;                     ///< Of the rectified images.
  bool is_stated = false;             ///< The files specify it.
  bool is_rectified = false;          ///< The images are rectified as they are: the files hold nothing but their camera.
  bool is_exchanged = false;          ///< The files' first camera is the right (lower) one.
  double full_fov_rad = 0.0;          ///< Across the width.
  std::optional<RectifiedPair> ours;  ///< Where it is OpenCV's: what we would have computed.
  std::optional<VerticalDisparity> disparity;
  std::array<double, 2> seen_shares{};  ///< Of each rectified image, where maps are wanted: what the camera sees.
  std::vector<ImageMap> maps;           ///< Two, where wanted.
  std::vector<ConvertedFile> files;     ///< Settings. Nothing is on the disk yet.
  std::string mode;                     ///< That they are for.
  std::vector<Loss> losses;
  std::vector<DefaultedValue> defaults;
  std::vector<ProofResult> proofs;
  Diagnostics diagnostics;

  [[nodiscard]] double baseline_m() const { return pair.offset_m; }
  /// Baseline times fx [m px], as ORB-SLAM's Camera.bf.
  [[nodiscard]] double bf() const { return pair.offset_m * pair.focal_lengths[0]; }
};

[[nodiscard]] RectifyResult rectify(const RectifyRequest& request, Files& files);

}  // namespace fca
