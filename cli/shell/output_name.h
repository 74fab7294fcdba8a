// SPDX-License-Identifier: BSD-3-Clause
// Where the files of a conversion go.
#pragma once

#include <fca/toolkit/convert.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fca::cli {

/// What output_path() fills in.
inline constexpr std::array<std::string_view, 5> kPlaceholders = {"{stem}", "{extension}", "{folder}", "{camera}", "{format}"};

/// Why -o is no pattern: the first "{...}" in it that is none of the known ones.
[[nodiscard]] std::optional<std::string> problem_with_pattern(std::string_view pattern,
                                                              std::span<const std::string_view> known = kPlaceholders);

/// The pattern with {stem}, {extension} (without its point) and {folder} (the name of the one it lies in) of an input, and
/// {camera}: a name that may hold anything.
[[nodiscard]] std::string with_names_of(const std::string& input, const std::string& camera, const std::string& pattern);

/// Does -o (a folder with its slash, a pattern) name places that need not be there yet? Then makes the folder of `path`.
void make_folder_of(const std::string& path, const std::string& output);

/// Is `output` (-o) a folder, which has room for several files?
[[nodiscard]] bool names_folder(const std::string& output);

/// The path of file number `index` of a conversion of `input`, from -o: a path, a folder or a pattern; empty: standard output.
[[nodiscard]] std::string output_path(const std::string& output, const std::string& input, const ConvertResult& result,
                                      std::size_t index);

}  // namespace fca::cli
