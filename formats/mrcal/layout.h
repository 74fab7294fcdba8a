// SPDX-License-Identifier: BSD-3-Clause
// A .cameramodel: a dict of Python (dkogan/mrcal@c47576e of 2026-06, mrcal/cameramodel.py; Debian's 2.2).
//
//   lensmodel      'LENSMODEL_OPENCV8'; in files of before 2.0 lens_model, or distortion_model 'DISTORTION_OPENCV8'
//   intrinsics     fx fy cx cy and cv::projectPoints' coefficients [px, from the centre of the first pixel]
//   rt_cam_ref     r (axis times angle) and t: p_camera = R(r) p_reference + t; since 2.5
//   extrinsics     the same, which versions before 2.5 demand; since 2.5 both must agree
//   imagersize     width, height
//   valid_intrinsics_region   a polygon of pixels
//   optimization_inputs, icam_intrinsics, icam_extrinsics   all observations of the calibration, in bytes, and whose they are
//
// mrcal specifies no unit of translations; its own examples are in metres. All files of a rig have the same reference.
#pragma once

#include "../schema/schema.h"

#include <fca/formats/opencv_coefficients.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace fca::mrcal {

/// Of equal keys of a dict the last counts.
inline constexpr text::Dialect kDialect = text::Dialect::kPyYaml;

inline constexpr std::string_view kReference = "ref";  ///< The frame, in a rig, as mrcal calls it.
inline constexpr std::string_view kIntrinsics = "intrinsics";
inline constexpr std::string_view kImageSize = "imagersize";
inline constexpr std::string_view kRegion = "valid_intrinsics_region";
inline constexpr std::string_view kInputs = "optimization_inputs";
/// In the order in which mrcal looks for them.
inline constexpr std::array<std::string_view, 3> kLensKeys = {"lensmodel", "distortion_model", "lens_model"};
/// A fresh file has both.
inline constexpr std::array<std::string_view, 2> kPoseKeys = {"rt_cam_ref", "extrinsics"};

/// A lens: of kOpenCvCoefficients it has so many.
struct LensModel {
  std::string_view name;
  std::string_view model;  ///< Ours.
  std::size_t coefficients = 0;
};
inline constexpr std::array kLenses = {LensModel{"LENSMODEL_PINHOLE", "pinhole", 0},
                                       LensModel{"LENSMODEL_OPENCV4", "radtan", 4}, LensModel{"LENSMODEL_OPENCV5", "radtan", 5},
                                       LensModel{"LENSMODEL_OPENCV8", "rational", 8},
                                       LensModel{"LENSMODEL_OPENCV12", "opencv14", 12}};

/// The name of a lens as mrcal renames an old one.
[[nodiscard]] std::string todays_name(std::string_view name);

/// By the name that a file has for it, also an old one; null if there is none.
[[nodiscard]] const LensModel* find_lens(std::string_view name);
/// The one that a file has for the model: `there` (may be null) where that does. Of one of `Format::models`.
[[nodiscard]] const LensModel& lens_for(const CameraModel& model, const LensModel* there);
/// fx fy cx cy and the lens's coefficients.
[[nodiscard]] std::vector<ParameterId> parameters_of(const LensModel& lens);
[[nodiscard]] fields::Field intrinsics_field(const CameraModel& model, const LensModel& lens);

/// T_camera_reference of the six numbers that a file specifies, and those numbers.
[[nodiscard]] Transform pose_of(const std::array<double, 6>& rt);
[[nodiscard]] std::array<double, 6> rt_of(const Transform& T_camera_reference);

/// That the cameras of a rig have in common, in its words: kReference, or the first camera where none has a pose in that.
[[nodiscard]] std::string reference_of(const Rig& rig);
/// T_camera_frame; nothing where it is not known.
[[nodiscard]] std::optional<Transform> pose_in(const std::string& frame, const Rig& rig, const Camera& camera);

extern const schema::Schema kSchema;
extern const schema::PoseLayout kPose;

/// The base, which specifies `old`, with another camera and, where the rig specifies one, its pose. Losses are listed.
[[nodiscard]] text::Document edited(const text::Document& base, const Rig& old, const Rig& rig, const Camera& camera,
                                    Written& written);
/// A fresh file of a camera.
[[nodiscard]] std::string composed(const Rig& rig, const Camera& camera, Written& written);

}  // namespace fca::mrcal
