// SPDX-License-Identifier: BSD-3-Clause
// Typed words that name things or hold numbers, and what is wrong with those that do not.
#pragma once

#include <fca/toolkit/convert.h>

#include <fca/formats/format.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

[[nodiscard]] std::vector<std::string> format_ids();
/// Those that are written.
[[nodiscard]] std::vector<std::string> target_ids();
[[nodiscard]] std::vector<std::string> model_ids();
/// Of all codes that are printed in brackets, by name.
[[nodiscard]] std::vector<std::string> code_ids();

/// "unknown model 'kb5'; did you mean kb4?", or, where nothing is near, "...; there are kb4 and ds"; `otherwise` in place of
/// the list, where that is long.
[[nodiscard]] std::string unknown_word(std::string_view kind, std::string_view typed, std::span<const std::string> names,
                                       std::string_view otherwise = {});
/// "kalibr, opencv and ..."
[[nodiscard]] std::string format_names();
/// The same, and that programs' names are taken, too.
[[nodiscard]] std::string target_names();
/// Those that fits have for a target.
[[nodiscard]] std::string model_names();
/// "unknown format 'orb'; did you mean orbslam3?", with the list when nothing is near.
[[nodiscard]] std::string unknown_format(std::string_view typed);
[[nodiscard]] std::string unknown_model(std::string_view typed);
/// `otherwise`: who knows the codes, where none is near.
[[nodiscard]] std::string unknown_code(std::string_view typed, std::string_view otherwise);

/// "a,b" in its parts.
[[nodiscard]] std::vector<std::string> split(std::string_view list);

/// Of a name that is no target: what its program reads and what is nearest, or that nobody knows it.
[[nodiscard]] std::string unknown_target(const std::string& option, const std::string& word);

/// Of a name that --for does not know.
[[nodiscard]] std::string unknown_program(const std::string& word);

/// Takes a format, or a camera model, of that name. Returns why it cannot, in a sentence.
[[nodiscard]] std::optional<std::string> take_format(const std::string& option, const std::string& word, const Format*& target);
/// --to: also a program's name, which may stand for a layout or a syntax, too.
[[nodiscard]] std::optional<std::string> take_target(const std::string& word, ConvertRequest& request);
[[nodiscard]] std::optional<std::string> take_model(const std::string& word, const ModelInfo*& target);
/// Takes "640x480". `option` is named where it cannot.
[[nodiscard]] std::optional<std::string> take_size(const std::string& option, const std::string& word,
                                                   std::optional<ImageSize>& target);

}  // namespace fca::cli
