// SPDX-License-Identifier: BSD-3-Clause
// Images through one map, many at a time.
#pragma once

#include "remap_command.h"
#include "shell/calibration_files.h"
#include "shell/console.h"

#include <fca/remap/image_map.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca::cli {

/// What became of an image.
struct RemappedImage {
  std::string input;
  std::string output;  ///< Its path.
  Diagnostics diagnostics;
  ExitCode code = ExitCode::kGood;
  bool left = false;  ///< Not begun: Ctrl-C came before.
};

/// Why these images cannot all be written to what -o names, in a sentence.
[[nodiscard]] std::optional<std::string> problem_with_output(const RemapArguments& arguments, std::span<const FoundFile> images,
                                                             const std::string& camera);

/// Reads, maps and writes them; a file that fails leaves the others their results.
[[nodiscard]] std::vector<RemappedImage> remap_images(const RemapArguments& arguments, std::span<const FoundFile> images,
                                                      const Camera& source, const ImageMap& map, const Console& console);

}  // namespace fca::cli
