// SPDX-License-Identifier: BSD-3-Clause
// Stereo rectification of a calibration: the geometry, the maps, and settings files of programs that need rectified images. In
// rectified images, matching points lie in the same row (in the same column if one camera is above the other).
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

/// The ids of the formats that can store a rectified pair.
[[nodiscard]] std::vector<std::string> rectified_formats();

struct OpenCvPair;  // toolkit/rectify/stereo_rectify.h
struct OpenCvRectification;
/// A function that calls OpenCV's stereoRectify or fisheye::stereoRectify, and returns nullopt if that fails.
using OpenCvRectifier = std::function<std::optional<OpenCvRectification>(const OpenCvPair& pair)>;

struct RectifyRequest {
  Inputs inputs;  ///< The calibration. If it has more than two cameras, those whose views overlap most are rectified.
  /// The view of the rectified cameras. If this is std::monostate and neither `size` nor `like_opencv` is set, the
  /// rectification in the files is used; it is computed only if they contain none.
  RectifiedViewChoice view;
  std::optional<ImageSize> size;            ///< Size of the rectified images. Not set: that of the cameras' images.
  OpenCvRectifier like_opencv;              ///< Computes the rectification with OpenCV. Empty: fca-io computes it.
  const Format* to = nullptr;               ///< Format of the settings file. Null: no settings file is made.
  std::optional<FormatLayout> layout = {};  ///< Layout of the settings file. Not set: the usual one.
  std::string extension = {};               ///< Extension of the settings file, as in ConvertRequest.
  std::string made_by = {};                 ///< The command or program that a comment in the files names as their maker.
  bool maps = false;                        ///< Compute the maps for cv::remap.
  std::size_t jobs = 0;                     ///< Number of rows that are computed at the same time. 0: number of processors.
};

/// The rectified pair. The left camera comes first (the upper one, if one camera is above the other).
struct RectifyResult {
  Status status = Status::kDone;
  std::array<Camera, 2> cameras;
  Transform T_second_first;           ///< From the poses in the files: maps points of the first camera to the second.
  RectifiedPair pair;                 ///< The rectification. Its first view is that of the left (upper) camera.
  ImageSize size;                     ///< Size of the rectified images.
  bool is_stated = false;             ///< `pair` comes from the files.
  bool is_rectified = false;          ///< The files only contain the camera of images that are already rectified.
  bool is_exchanged = false;          ///< The first camera in the files is the right (lower) one.
  double full_fov_rad = 0.0;          ///< Horizontal field of view of the rectified images.
  std::optional<RectifiedPair> ours;  ///< If OpenCV computed `pair`: the rectification that fca-io computes.
  std::optional<VerticalDisparity> disparity;
  std::array<double, 2> seen_shares{};   ///< If maps were requested: the share of each rectified image that its camera sees.
  std::vector<ImageMap> maps;            ///< One for each camera if requested, otherwise empty.
  std::vector<ConvertedFile> files;      ///< The settings files, in memory: nothing is written to the disk.
  std::string mode;                      ///< The program's mode for which the settings are.
  std::vector<Loss> losses;              ///< Facts of the inputs that the settings do not contain.
  std::vector<DefaultedValue> defaults;  ///< Values in the settings that the inputs do not contain.
  std::vector<ProofResult> proofs;       ///< What the programs read from the settings.
  Diagnostics diagnostics;

  /// Distance between the two cameras along the rectified rows (columns, if one camera is above the other).
  [[nodiscard]] double baseline_m() const { return pair.offset_m; }
  /// Baseline times fx [m px]: the value of Camera.bf in ORB-SLAM's settings.
  [[nodiscard]] double bf() const { return pair.offset_m * pair.focal_lengths[0]; }
};

/// Reads a calibration and rectifies its stereo pair. Errors are in the result's diagnostics.
[[nodiscard]] RectifyResult rectify(const RectifyRequest& request, Files& files);

}  // namespace fca
