// SPDX-License-Identifier: BSD-3-Clause
// One layout of YAML is read by PyYAML, yaml-cpp and cv::FileStorage alike.
#pragma once

#include <fca/formats/fix.h>

namespace fca::checks {

/// YAML's own first lines in the place of OpenCV's %YAML:1.0, which PyYAML refuses, before comments; nothing where that does
/// not stand.
[[nodiscard]] std::optional<Fix> header_fix(const text::Document& document);

/// What cv::FileStorage (OpenCV 4.6) wants of a YAML file besides its values: a first line %YAML with neither a byte order mark
/// nor comments before it, and lists indented deeper than their key. Blanks and that first line are all it adds. Nothing where
/// the layout already is so.
[[nodiscard]] std::optional<Fix> layout_fix(const text::Document& document);

}  // namespace fca::checks
