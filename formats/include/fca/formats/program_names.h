// SPDX-License-Identifier: BSD-3-Clause
// The names that people type for formats: those of programs, datasets and devices.
#pragma once

#include <span>
#include <string_view>

namespace fca {

/// A program, dataset or device, and the format that serves it or is nearest to what it reads.
struct ProgramName {
  std::span<const std::string_view> names;  ///< As typed, in any case and with any separators.
  std::string_view title = {};              ///< "COLMAP"
  std::string_view format;                  ///< Id of a format.
  std::string_view layout = {};             ///< One of its layouts; empty: the usual.
  std::string_view extension = {};          ///< Of the file, where that chooses the syntax: ".txt".
  /// What it reads, where that is not the format: "cameras.txt of a model folder". Empty: the format serves it.
  std::string_view reads = {};
  /// Id of the consumer that it is, where it is not the first that reads the format; empty: it is.
  std::string_view consumer = {};
  /// Of several programs under one name, that one or that part which the format serves: "Isaac ROS, which reads camera_info".
  std::string_view served_part = {};

  [[nodiscard]] constexpr bool is_served() const { return reads.empty(); }
};

/// Null for a name that nobody is known by. Ids of formats are not among them.
[[nodiscard]] const ProgramName* find_program_name(std::string_view typed);

[[nodiscard]] std::span<const ProgramName> all_program_names();

}  // namespace fca
