// SPDX-License-Identifier: BSD-3-Clause
// Where the files of a conversion go.
#pragma once

#include <fca/toolkit/convert.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fca::cli {

/// Where outputs go, as -o says it.
struct OutputPlace {
  enum class Kind : std::uint8_t { kNotSaid, kStandardOutput, kFile, kFolder, kPattern };
  Kind kind = Kind::kNotSaid;
  std::string path;  ///< Of a file, of a folder that may be yet to be made, or the pattern: "out/{stem}.yaml".

  [[nodiscard]] bool is_said() const { return kind != Kind::kNotSaid; }
  /// The default, too.
  [[nodiscard]] bool is_standard_output() const { return kind <= Kind::kStandardOutput; }
  [[nodiscard]] bool holds_many() const { return kind >= Kind::kFolder; }
  /// A folder for each input: "out/{stem}/".
  [[nodiscard]] bool is_folder_pattern() const { return kind == Kind::kPattern && path.ends_with('/'); }
  /// A file for each camera: "out/{camera}.yaml".
  [[nodiscard]] bool names_camera() const { return kind == Kind::kPattern && path.find("{camera}") != std::string::npos; }
};

/// What output_path() fills in.
inline constexpr std::array<std::string_view, 5> kPlaceholders = {"{stem}", "{extension}", "{folder}", "{camera}", "{format}"};

/// Why it is no pattern: the first "{...}" in it that is none of the known ones.
[[nodiscard]] std::optional<std::string> problem_with_pattern(const OutputPlace& place,
                                                              std::span<const std::string_view> known = kPlaceholders);

/// The pattern with {stem}, {extension} (without its point) and {folder} (the name of the one it lies in) of an input, and
/// {camera}: a name that may hold anything.
[[nodiscard]] std::string with_names_of(const std::string& input, const std::string& camera, const std::string& pattern);

/// Is it the file that a folder of the format's binary files has its cameras in, "sparse/0/cameras.bin"? It stands for that
/// folder. `to`: null, of a base's own format.
[[nodiscard]] bool names_binary_folder(const OutputPlace& place, const Format* to);

/// Makes the folder of `path`, which need not be there yet where `place` holds many.
void make_folder_of(const std::string& path, const OutputPlace& place);

/// The path of file number `index` of a conversion of `input`; empty: standard output.
[[nodiscard]] std::string output_path(const OutputPlace& place, const std::string& input, const ConvertResult& result,
                                      std::size_t index);

}  // namespace fca::cli
