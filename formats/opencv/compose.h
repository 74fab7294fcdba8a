// SPDX-License-Identifier: BSD-3-Clause
// New files: which layout holds a rig, and its text.
#pragma once

#include "layout.h"

#include <fca/formats/format.h>

#include <string>
#include <string_view>

namespace fca::opencv {

/// Is it the extension of one of cv::FileStorage's syntaxes? ".calib" says nothing.
[[nodiscard]] bool names_syntax(std::string_view extension);
/// cv::FileStorage's YAML unless the extension is .xml or .json.
[[nodiscard]] text::Syntax syntax_for(std::string_view extension);
/// Plain YAML (without its first line) and cv::FileStorage's count as one.
[[nodiscard]] bool same_syntax(text::Syntax a, text::Syntax b);

/// Why a layout (of kLayoutNames) cannot hold the rig; Message{} if it can.
[[nodiscard]] Message problem_with_layout(std::string_view layout, const Rig& rig);
/// What the stock programs read, for a rig of that many cameras of those models.
[[nodiscard]] std::string default_layout(const Rig& rig);

/// Adds the files, and what of the poses among cameras they do not hold. One file per camera where the layout has one camera.
[[nodiscard]] bool compose(const Rig& rig, const std::string& layout, text::Syntax syntax, std::string extension,
                           Written& written, Diagnostics& diagnostics);

}  // namespace fca::opencv
