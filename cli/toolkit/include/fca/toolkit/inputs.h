// SPDX-License-Identifier: BSD-3-Clause
// The inputs of a request: the files of one calibration, and options that say how to read them.
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

/// Chooses a camera of a calibration by name or, if no camera has that name, by its index `place`, which starts at 0.
struct CameraChoice {
  std::string name;
  std::optional<std::size_t> place = {};
};

/// A sample image. `camera`: name of the camera that took it; empty: the calibration's only camera.
struct CameraImage {
  std::string camera;
  std::string path;
};

/// The meaning of the noise values of an IMU in the input files.
enum class NoiseKind : std::uint8_t {
  kContinuous,        ///< Continuous-time noise densities.
  kDiscrete,          ///< Standard deviations of single samples.
  kVariance,          ///< Squares of densities.
  kDiscreteVariance,  ///< Squares of standard deviations of single samples.
};

struct Inputs {
  std::vector<std::string> files;                    ///< Paths. Several files contain the cameras of one rig, in this order.
  std::vector<std::string> parts;                    ///< Paths of additional parts of the calibration (imu.yaml).
  const Format* format = nullptr;                    ///< Format of the files. Null: detected from their content.
  std::optional<std::vector<CameraChoice>> cameras;  ///< Only these cameras are read, in this order. nullopt: all cameras.
  std::optional<ImageSize> image_size;               ///< Image size for files that do not contain one.
  std::optional<OpenCvModel> opencv_model;           ///< Lens model for OpenCV files whose model is ambiguous.
  ImageChange change;                                ///< A change of the images (crop, binning, resize) after calibration.
  std::optional<double> max_angle_rad;    ///< Angle from the axis at which the lens ends. nullopt: it fills the image.
  std::vector<CameraImage> lens_circles;  ///< Sample images whose image circle is the border of the lens.
  std::optional<double> length_unit_m;    ///< Unit of translations in files without a unit. nullopt: 1 m.
  std::optional<double> imu_rate_hz;      ///< IMU rate for files that do not contain it.
  std::optional<NoiseKind> imu_noise;     ///< Meaning of the IMU noise values in the files.
  bool join = false;                      ///< The files contain cameras of one rig; may also be set for one of its files.
};

/// Reads the files and parts of one calibration, keeps the chosen cameras, and applies the change of the images. nullopt, with
/// errors, if that fails.
[[nodiscard]] std::optional<Calibration> read_calibration(const Inputs& inputs, Files& files, Diagnostics& diagnostics);
/// Like read_calibration(), for callers that need camera models: nullopt, with an error, also if a camera is only known by a
/// table of rays.
[[nodiscard]] std::optional<Calibration> read_models(const Inputs& inputs, Files& files, Diagnostics& diagnostics);
/// The first step of read_calibration(): reads the files without applying the choices of the inputs. nullopt with errors.
[[nodiscard]] std::optional<Calibration> read_as_stated(const Inputs& inputs, Files& files, Diagnostics& diagnostics);
/// The second step of read_calibration(): applies the choice of cameras, lens circles, change of images, and IMU options. False
/// with errors.
[[nodiscard]] bool apply_choices(const Inputs& inputs, Files& files, Calibration& calibration, Diagnostics& diagnostics);

/// If exactly one of two to four files contains cameras, moves the other files to the parts ("camchain.yaml imu.yaml").
/// Otherwise returns the inputs unchanged. Reads the files.
[[nodiscard]] Inputs with_parts_recognised(const Inputs& inputs, Files& files);

/// The files of a folder that contains one rig, cameras first. It can be a EuRoC folder (mav0, with cam0/sensor.yaml, ..., or
/// the folder that contains mav0) or a Kimera-VIO folder (LeftCameraParams.yaml, ...). Empty for any other path.
[[nodiscard]] std::vector<std::string> rig_files_in(const std::string& folder);

/// The name by which people know a rig: for a EuRoC folder mav0 the folder that contains it, otherwise the path itself.
[[nodiscard]] std::string rig_name(const std::string& path);

/// The files of a folder that contains a COLMAP model: the file of cameras, then the file of rigs if it exists. Empty for any
/// other path, and for a folder that only contains a file of cameras. For cameras.bin and cameras.txt see cameras_file_in().
[[nodiscard]] std::vector<std::string> model_files_in(const std::string& folder);

/// COLMAP's file of cameras in a folder. If both cameras.bin and cameras.txt exist, it is the one that COLMAP reads. nullopt
/// for any other path.
[[nodiscard]] std::optional<std::string> cameras_file_in(const std::string& folder);

/// The options for the readers of formats.
[[nodiscard]] ReadOptions read_options(const Inputs& inputs);

/// The name in options and messages: "continuous", "discrete", "variance" or "discrete-variance".
[[nodiscard]] std::string_view name_of(NoiseKind kind);

}  // namespace fca
