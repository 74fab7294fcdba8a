// SPDX-License-Identifier: BSD-3-Clause
// Under which keys a document says what: found in a file, or chosen for a new one. Reading, writing and editing share it.
#pragma once

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/document.h>
#include <fca/message.h>
#include <fca/models/camera_model.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::opencv {

/// Which of OpenCV's three functions project the points of a camera.
enum class Kind { kPinhole, kFisheye, kOmnidir };

[[nodiscard]] Kind kind_of(const CameraModel& model);
/// The id of the model that the coefficients are of, whatever the camera matrix says.
[[nodiscard]] std::string_view lens_id(const CameraModel& model);

/// Two keys, or one with both numbers. All empty: the file does not say.
struct SizeKeys {
  std::string width;
  std::string height;
  std::string pair;
  bool rows_first = false;  ///< MATLAB's order.
  [[nodiscard]] bool stated() const { return !width.empty() || !pair.empty(); }
};

/// A key that says which function four coefficients are for.
struct ModelKey {
  std::string key;  ///< Empty: there is none.
  bool numeric = true;
  std::optional<bool> fisheye;  ///< What it says.
  bool foreign = false;         ///< It says a model that none of OpenCV's functions has.
};

struct CameraKeys {
  std::string map;  ///< Key of the camera's own mapping; empty: its keys stand at the top level.
  std::string matrix;
  std::string distortion;  ///< Empty: there is none.
  std::string radial;      ///< MATLAB: k1 k2 [k3], next to `tangential`.
  std::string tangential;
  std::string xi;
  bool transposed = false;  ///< MATLAB
  bool fisheye = false;     ///< The keys themselves say fisheye.
  std::string pose;         ///< In maps: 4 x 4, camera -> reference.
  std::string group;        ///< In maps: which reference.
  SizeKeys size;            ///< Of the camera's own mapping.
  ModelKey model;           ///< Of the camera's own mapping.
};

struct Layout {
  std::vector<CameraKeys> cameras;
  SizeKeys size;            ///< Top level.
  ModelKey model;           ///< Top level.
  std::string rotation;     ///< R of the second camera, or om.
  std::string translation;  ///< T
  bool rotation_vector = false;
  bool rotation_transposed = false;
  std::string count;         ///< "nb_camera" or empty.
  bool row_vectors = false;  ///< Of a fresh file: distortion coefficients in one row.
  Message why;               ///< By which keys it was found.

  [[nodiscard]] bool in_maps() const { return !cameras.empty() && !cameras.front().map.empty(); }
};

inline constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

/// What an opencv-matrix looks like, whatever is wrong inside.
[[nodiscard]] bool is_matrix(const text::Node& node);

/// The keys of a document; nothing if it is no calibration. No cameras: it holds R and T alone.
[[nodiscard]] std::optional<Layout> find_layout(const text::Document& document);

/// Every key of `layout` in the mapping `map` ("" for the top level).
[[nodiscard]] std::vector<std::string> keys_of(const Layout& layout, const std::string& map);

/// The camera's mapping.
[[nodiscard]] const text::Node& mapping_of(const text::Document& document, const CameraKeys& keys);

/// How new files are laid out; WriteOptions::layout.
inline constexpr std::array<std::string_view, 5> kLayoutNames = {"calibration", "stereo", "omnidir", "cameras", "left-right"};

/// The keys of a new file for that many cameras.
[[nodiscard]] Layout new_layout(std::string_view name, std::size_t cameras, bool omnidir);

}  // namespace fca::opencv
