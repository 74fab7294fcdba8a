// SPDX-License-Identifier: BSD-3-Clause
// Options that only some formats have a use for: none is ignored silently.
#pragma once

#include "toolkit/conversion.h"

#include <optional>
#include <span>
#include <string>

namespace fca::cli {

/// "--fps is for --to orbslam3, not kalibr"; nothing if every option given says something about a file of format `to`.
[[nodiscard]] std::optional<std::string> option_without_use(const WritingOptions& options, const Format& to);

/// "--fps says something about a written file; ..." where none is written at all, neither by --to nor by --into.
[[nodiscard]] std::optional<std::string> option_without_file(const WritingOptions& options);

/// The same of --opencv-model, which says how inputs are read: nothing if one of them, or a target, is OpenCV's or could not be
/// read.
[[nodiscard]] std::optional<std::string> opencv_model_without_use(const ConvertArguments& arguments,
                                                                  std::span<const ConvertOutcome> outcomes);

}  // namespace fca::cli
