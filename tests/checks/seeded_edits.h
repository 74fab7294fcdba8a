// SPDX-License-Identifier: BSD-3-Clause
// Ways to plant a defect in the text of a file.
#pragma once

#include "seeded_defects.h"

#include <fca/formats/text/document.h>

namespace fca::test {

/// The edit that plants a defect, or nothing where the file has no such place.
using Edit = std::function<std::optional<SpanEdit>(const Good&)>;

/// A defect of the text: the formats whose program stumbles over it (for others it is none; empty: all).
struct TextDefect {
  const char* name;
  std::vector<std::string_view> formats;
  std::vector<std::string> codes;
  Edit edit;
  int at_least = 20;
  bool line_is_known = true;  ///< That it stands in; false: the defect is of the camera, the matrix or the file as a whole.
  const char* program = nullptr;
};

/// Planted in files that were without fault.
SeededDefect seeded(const TextDefect& defect);

/// Where the first camera's parameter stands.
std::optional<text::Span> number_of(const Good& good, ParameterId name);

/// Another spelling of a parameter of the first camera.
Edit spelled(ParameterId name, std::function<std::string(const std::string&)> change);

/// The first line that begins so (after blanks), replaced by a function of it.
Edit line_starting(std::string_view start, std::function<std::optional<std::string>(const std::string&)> change);

/// The first line that begins so, gone.
Edit without_line(std::string_view start);

/// The first match of a pattern (std::regex; ^ and $ at lines), replaced; $1 is its first group.
Edit replaced(const char* pattern, const char* replacement);

/// Text after the end of the file.
Edit appended(std::string_view text);

/// "key: 12.5  # note" with the number replaced; nothing unless a number stands there.
std::optional<std::string> with_number(const std::string& line, const std::function<std::string(double)>& spell);

/// The same edit, in files of that syntax alone.
Edit where(text::Syntax syntax, Edit edit);

/// The same edit, in files with a camera alone.
Edit of_cameras(Edit edit);

/// Does a program of that name load the file?
bool is_read_by(const Good& good, std::string_view program);

}  // namespace fca::test
