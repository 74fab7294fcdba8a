// SPDX-License-Identifier: BSD-3-Clause
// The reading options that every subcommand shares, and reading a calibration with them.
#pragma once

#include "shell/console.h"

#include <fca/formats/calibration.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

namespace fca::cli {

struct ReadingOptions {
  std::string from;
  std::vector<std::string> with;
  bool join = false;
  std::optional<std::string> cameras;  ///< "1,0" or "cam1"
  std::string size;                    ///< "640x480"
  std::string opencv_model;            ///< "pinhole" or "fisheye"
  std::string crop;                    ///< "64,0,512,512"
  int binning = 1;
  std::string resize;  ///< "640x480"
  std::optional<double> max_angle_deg;
  std::vector<std::string> lens_circles;  ///< "IMAGE" or "CAMERA=IMAGE"
  std::string imu_noise;                  ///< A NoiseKind by its name; empty: densities.
};

/// --from, --with, --camera, --size, --crop, --binning, --resize, --opencv-model, --max-angle
void add_reading_options(CLI::App& command, ReadingOptions& options);

/// --lens-circle, for commands that measure over the lens.
void add_lens_circle_option(CLI::App& command, ReadingOptions& options);

/// --join, for commands that take several files.
void add_join_option(CLI::App& command, ReadingOptions& options);

/// --imu-noise, for commands that say or write what an IMU is like.
void add_imu_option(CLI::App& command, ReadingOptions& options);

/// The inputs as calibrations are read from them: each by itself, or all together under --join.
[[nodiscard]] std::vector<std::vector<std::string>> grouped(const std::vector<std::string>& inputs,
                                                            const ReadingOptions& options);

/// The calibration of one group of inputs with its further parts, reduced to the chosen cameras, for the images that were asked
/// for. Diagnostics are added, not shown.
[[nodiscard]] std::optional<Calibration> read_input(std::span<const std::string> paths, const ReadingOptions& options,
                                                    Console& console, Diagnostics& diagnostics);
[[nodiscard]] std::optional<Calibration> read_input(const std::string& path, const ReadingOptions& options, Console& console,
                                                    Diagnostics& diagnostics);

/// A usage error among the options that can be told without reading (unknown format, malformed size), in words.
[[nodiscard]] std::optional<std::string> check(const ReadingOptions& options);

/// For options that may come several times: one value each time, so that what follows is no further one.
void take_one_each_time(CLI::Option& option);

/// For options: a plain decimal number ("0x61" and "" are none).
[[nodiscard]] CLI::Validator decimal_number();

/// Are the images others than those that were calibrated (--crop, --binning, --resize)?
[[nodiscard]] bool changes_images(const ReadingOptions& options);

[[nodiscard]] std::optional<double> max_angle_rad(const ReadingOptions& options);

/// "kalibr, opencv and ..."
[[nodiscard]] std::string format_names();
/// "unknown format 'orb'; did you mean orbslam3?" with the list when nothing is near.
[[nodiscard]] std::string unknown_format(std::string_view typed);
[[nodiscard]] std::string unknown_model(std::string_view typed);

}  // namespace fca::cli
