// SPDX-License-Identifier: BSD-3-Clause
// Numbers and things in words, for people.
#pragma once

#include "toolkit/degrees.h"
#include "toolkit/words.h"

#include <fca/formats/text/prose.h>
#include <fca/models/camera_model.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fca::cli {

/// "97.5 deg from the axis (195 deg in full)"
[[nodiscard]] std::string angle_in_words(double degrees);
/// Fixed decimals: "0.113".
[[nodiscard]] std::string fixed(double value, int decimals);
[[nodiscard]] std::string percent(double share);
/// "fx 190.978  fy 190.973 ..." over lines of at most 80 columns, each after `indent`.
[[nodiscard]] std::string parameters_in_words(const CameraModel& model, std::string_view indent);
/// "a, b, c" over lines of at most 80 columns, each after `indent`.
[[nodiscard]] std::string wrapped(std::span<const std::string> parts, std::string_view indent);
/// A text in lines of at most 80 columns, each after `indent`; a command ("fca-io ..." to the next comma, semicolon or
/// parenthesis) stays in one line.
[[nodiscard]] std::string paragraph(std::string_view text, std::string_view indent);
/// Words in lines of 80 columns, without a line break at the end. The first line goes on with one of `used` characters; the
/// others begin with `indent` blanks.
[[nodiscard]] std::string in_columns(std::string_view text, std::size_t used, std::size_t indent);
/// Padded with blanks to `width` on the right.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);
using fca::pixels;
using text::enumerated;
using text::nearest;
using text::shell_word;
/// An error between pixels of an image: "over 905" where none are so far apart.
[[nodiscard]] std::string pixels(double value, const std::optional<ImageSize>& image);
/// A file without its folder, or "standard input".
[[nodiscard]] std::string file_in_words(const std::string& path);
/// "1 file", "2 files"
[[nodiscard]] std::string counted(std::size_t count, const std::string& what);
/// "centre (255.5, 250.1), radius 240.1 px"
[[nodiscard]] std::string place_in_words(const LensCircle& circle);
[[nodiscard]] std::optional<double> in_degrees(const std::optional<double>& radians);

}  // namespace fca::cli
