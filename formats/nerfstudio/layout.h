// SPDX-License-Identifier: BSD-3-Clause
// Which object of a transforms.json specifies which number of which camera.
#pragma once

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::nerfstudio {

/// The last of equal keys counts, in Python's json as in nlohmann's.
inline constexpr text::Dialect kDialect = text::Dialect::kPyYaml;

inline constexpr std::string_view kCameraModel = "camera_model";
inline constexpr std::string_view kIsFisheye = "is_fisheye";
inline constexpr std::string_view kFrames = "frames";
inline constexpr std::string_view kPose = "transform_matrix";
inline constexpr std::string_view kImageFile = "file_path";
/// What fca-io calls a frame's camera: two of them may have the same numbers. No program reads it.
inline constexpr std::string_view kLabel = "camera";

inline constexpr std::array<std::string_view, 4> kFocalAndCentre = {"fl_x", "fl_y", "cx", "cy"};
inline constexpr std::array<std::string_view, 2> kSize = {"w", "h"};
inline constexpr std::array<std::string_view, 6> kCoefficients = {"k1", "k2", "k3", "k4", "p1", "p2"};
/// All of them in that order; nerfstudio takes it before each of them.
inline constexpr std::string_view kCoefficientList = "distortion_params";

/// A key with the angle that the image spans, from border to border.
struct AngleKey {
  std::string_view name;
  bool horizontal = true;
  bool degrees = false;
  bool read = true;  ///< By instant-ngp.
};
inline constexpr std::array kAngles = {AngleKey{"x_fov", true, true},       AngleKey{"y_fov", false, true},
                                       AngleKey{"camera_angle_x", true},    AngleKey{"camera_angle_y", false},
                                       AngleKey{"fovx", true, true, false}, AngleKey{"fovy", false, true, false}};

/// A focal length [px] from such an angle, and back. `side`: of the image [px].
[[nodiscard]] double focal_length_of(const AngleKey& key, double angle, int side);
[[nodiscard]] double angle_of(const AngleKey& key, double focal_length, int side);

/// The key of `fl_x`'s axis (horizontal) or of `fl_y`'s that counts in an object; null if there is none.
[[nodiscard]] const AngleKey* angle_in(const text::Node& object, bool horizontal);

/// The value under a key of an object; null if there is none.
[[nodiscard]] const text::Node* value_in(const text::Node& object, std::string_view key);
[[nodiscard]] bool is_coefficient(std::string_view key);
/// The number of a coefficient in an object: of its list, else under its key; null if there is none.
[[nodiscard]] const text::Node* coefficient_in(const text::Node& object, std::string_view key);
/// Does the object specify coefficients, by keys or as a list?
[[nodiscard]] bool has_coefficients(const text::Node& object);
/// Do the coefficients at the top count, and none of a frame? k4 alone does not do that.
[[nodiscard]] bool coefficients_at_top(const text::Node& root);

/// A camera, and where it is specified.
struct Group {
  std::string name;                       ///< "cam0", or its label.
  std::vector<const text::Node*> frames;  ///< The images of it; none where the file has none.
};

/// The cameras of a file, in the order of their first frames; at least one. Every frame must be an object.
[[nodiscard]] std::vector<Group> groups_of(const text::Node& root);

/// The object that specifies a number of the camera to nerfstudio: the top if the key is there, else its first frame (the top
/// where there is none).
[[nodiscard]] const text::Node& owner_of(const text::Node& root, const Group& group, std::string_view key);

/// nerfstudio's models that are one of ours: true for the fisheye. Nothing of others.
[[nodiscard]] std::optional<bool> is_fisheye_model(std::string_view camera_model);
[[nodiscard]] bool is_fisheye(const Camera& camera);
/// The names of those models.
[[nodiscard]] std::vector<std::string> read_models();
/// The name for a camera of that model, in place of `there` (empty: none), which stays if it does.
[[nodiscard]] std::string_view camera_model_for(std::string_view there, const CameraModel& model);

}  // namespace fca::nerfstudio
