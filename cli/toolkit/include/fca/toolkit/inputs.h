// SPDX-License-Identifier: BSD-3-Clause
// What a request reads: the files of one calibration, and how they are to be understood.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/rig/image_change.h>
#include <fca/toolkit/files.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// A camera of a calibration: the one of that name or, if there is none, the one at that place, counted from 0.
struct CameraChoice {
  std::string name;
  std::optional<std::size_t> place = {};
};

/// An image that a camera took. No camera: the calibration's only one.
struct CameraImage {
  std::string camera;
  std::string path;
};

/// What the numbers of an IMU's noise are, where they are no continuous-time densities.
enum class NoiseKind : std::uint8_t {
  kContinuous,
  kDiscrete,          ///< Standard deviations of single samples.
  kVariance,          ///< Squares of densities.
  kDiscreteVariance,  ///< Squares of standard deviations of single samples.
};

struct Inputs {
  std::vector<std::string> files;                    ///< Paths; several are the cameras of one rig, in this order.
  std::vector<std::string> parts;                    ///< Paths of further parts of the calibration (imu.yaml).
  const Format* format = nullptr;                    ///< Of the files; null: found by their content.
  std::optional<std::vector<CameraChoice>> cameras;  ///< These alone, in this order; nothing: all.
  std::optional<ImageSize> image_size;               ///< For files that do not specify one.
  std::optional<OpenCvModel> opencv_model;           ///< For files that could be either.
  ImageChange change;                                ///< From the calibrated images to those that the cameras are for.
  std::optional<double> max_angle_rad;               ///< What counts as lens, from the axis; nothing: the whole image.
  std::vector<CameraImage> lens_circles;             ///< What counts as lens: the image circle that these images show.
  std::optional<double> length_unit_m;               ///< Of translations in files that do not specify their unit; none: metres.
  std::optional<double> imu_rate_hz;                 ///< For files that do not specify it.
  std::optional<NoiseKind> imu_noise;                ///< Of the input.
  bool join = false;                                 ///< Several files, or one that is written as one of several.
};

/// Reads one calibration: its files and their parts, reduced to the chosen cameras, for the changed images. Nothing with
/// errors.
[[nodiscard]] std::optional<Calibration> read_calibration(const Inputs& inputs, Files& files, Diagnostics& diagnostics);
/// The same for who asks its cameras for pixels and rays: nothing, with an error, where one is known by rays alone.
[[nodiscard]] std::optional<Calibration> read_models(const Inputs& inputs, Files& files, Diagnostics& diagnostics);
/// The first in two steps: as the files specify it, and with what the inputs ask for besides the files. False with errors.
[[nodiscard]] std::optional<Calibration> read_as_stated(const Inputs& inputs, Files& files, Diagnostics& diagnostics);
[[nodiscard]] bool apply_choices(const Inputs& inputs, Files& files, Calibration& calibration, Diagnostics& diagnostics);

/// Of a few files of which one alone holds cameras, that one, the others as its parts ("camchain.yaml imu.yaml"); of any other
/// files the inputs as they are. The files are read.
[[nodiscard]] Inputs with_parts_recognised(const Inputs& inputs, Files& files);

/// The files of a folder that is one rig: EuRoC's (mav0 with cam0/sensor.yaml, ..., or the folder that holds it), Kimera-VIO's
/// (LeftCameraParams.yaml, ...). Cameras first; empty of any other path.
[[nodiscard]] std::vector<std::string> rig_files_in(const std::string& folder);

/// What people call the path: of a folder that is one rig the folder that they know it by (mav0's own), else the path.
[[nodiscard]] std::string rig_name(const std::string& path);

/// The files of a folder that is a COLMAP model, with more than its cameras: that with the cameras, then that with the rigs, if
/// it is there. Of cameras.bin and cameras.txt it is the one that COLMAP reads. Empty of any other path.
[[nodiscard]] std::vector<std::string> model_files_in(const std::string& folder);

/// The file of cameras in a folder, alone or not: of COLMAP's cameras.bin and cameras.txt the one that COLMAP reads. Nothing of
/// any other path.
[[nodiscard]] std::optional<std::string> cameras_file_in(const std::string& folder);

/// As the readers of formats take them.
[[nodiscard]] ReadOptions read_options(const Inputs& inputs);

/// "continuous", "discrete", "variance", "discrete-variance".
[[nodiscard]] std::string_view name_of(NoiseKind kind);

}  // namespace fca
