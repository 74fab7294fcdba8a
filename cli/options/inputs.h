// SPDX-License-Identifier: BSD-3-Clause
// The options that say what is read, the same for every subcommand that reads a calibration.
#pragma once

#include "options.h"

#include <fca/toolkit/inputs.h>

#include <cstddef>
#include <string>
#include <vector>

namespace fca::cli {

/// --from, --with, --camera, --size, --crop, --binning, --resize, --opencv-model, --max-angle
void add_input_options(Options& options, Inputs& inputs);

/// --lens-circle, for commands that measure over the lens, in place of --max-angle.
void add_lens_circle_option(Options& options, Inputs& inputs);

/// --join, for commands that take several files.
void add_join_option(Options& options, Inputs& inputs);

/// --imu-noise, for commands that say or write what an IMU is like.
void add_imu_option(Options& options, Inputs& inputs);
/// --imu-rate alone.
void add_imu_rate_option(Options& options, Inputs& inputs);

/// Those of these options that were given and make something else of a file than it is: "--camera", "--crop".
[[nodiscard]] std::vector<std::string> given_changes(const Inputs& inputs);
/// All that there are, for commands that look at a file as it stands.
[[nodiscard]] std::vector<std::string> all_changes();

/// How often standard input is among the files.
[[nodiscard]] std::ptrdiff_t reads_of_standard_input(const std::vector<std::string>& files);

/// The files as calibrations are read from them: each by itself, or all together under --join. The other members are those of
/// `inputs`.
[[nodiscard]] std::vector<Inputs> grouped(const Inputs& inputs);

}  // namespace fca::cli
