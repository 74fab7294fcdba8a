// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/console.h"
#include "toolkit/reading.h"

#include <fca/compare/report.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

struct CompareArguments {
  std::string reference;
  std::vector<std::string> files;
  ReadingOptions reading;
  std::vector<std::string> with_of_file;  ///< Further parts of each FILE; those of --with are REF's.
  std::optional<double> max_error_px;
  bool strict = false;  ///< Judge poses and numbers, too.
  bool every_pixel = false;
  std::string page;  ///< --report
  bool force = false;
  bool json = false;
};

/// The reference, as read.
struct ReferenceFile {
  std::string file;
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
};

/// What one file is beside the reference.
struct ComparedFile {
  std::string file;
  std::optional<Calibration> calibration;
  std::optional<RigComparison> comparison;
  std::optional<double> inverse_px;  ///< inverses_apart_px()
  std::string verdict;               ///< One line.
  ExitCode code = ExitCode::kGood;
  Diagnostics diagnostics;
};

void add_compare_command(CLI::App& app, CompareArguments& arguments, std::function<ExitCode(Console&)>& run);

/// How far apart [px] two OCamCalib files image the rays of the reference's image (world2cam: by their inverse polynomials,
/// which are no part of the compared model); nothing for other formats and for images of different sizes.
[[nodiscard]] std::optional<double> inverses_apart_px(const Calibration& reference, const Calibration& other);

/// Is there more between the inverse polynomials than between the directions?
[[nodiscard]] bool inverses_differ(const ComparedFile& compared);

/// "IMU.T_b_c1 is the inverse of what it should be: it holds T_cam0_imu0"
[[nodiscard]] std::string sentence(const Mistake& mistake);
/// "T_cam1_cam0 differs by 0.8 deg and 3 mm"
[[nodiscard]] std::string in_words(const PoseComparison& pose);
/// "imu0 gyroscope noise is 10 times the reference's"
[[nodiscard]] std::string in_words(const FactComparison& fact);
/// What matters most, in one line: slips of the pen, else the largest differences.
[[nodiscard]] std::string verdict_of(const ComparedFile& compared);
/// "0.31 deg: its rays lie 0.3 to the right and 0.08 up": how the rays of a camera lie that is turned by that vector
/// (BestRotation).
[[nodiscard]] std::string rotation_in_words(const BestRotation& rotation);

/// "the same camera up to 83.2 deg from the axis (within 0.25 px)"
[[nodiscard]] std::string same_in_words(const CameraDifference& difference);
/// Does the best rotation bring the two nearer to each other?
[[nodiscard]] bool turning_helps(const CameraComparison& camera);

[[nodiscard]] std::string compare_text(const ReferenceFile& reference, const ComparedFile& compared);
[[nodiscard]] std::string compare_json(const ReferenceFile& reference, const std::vector<ComparedFile>& files,
                                       const Console& console);

}  // namespace fca::cli
