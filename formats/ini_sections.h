// SPDX-License-Identifier: BSD-3-Clause
// The lines of an .ini below their "[section]", of a document of words.
#pragma once

#include <fca/formats/text/document.h>

#include <string>
#include <vector>

namespace fca {

/// A line that is neither blank nor a comment (# or ;).
struct IniLine {
  const text::Node* node = nullptr;  ///< Its words.
  std::string text;                  ///< Without blanks around it.
};

[[nodiscard]] std::vector<IniLine> ini_lines_of(const text::Document& document);

/// Does it head a section? Brackets, wherever they stand: as ROS' parse_ini.cpp has it.
[[nodiscard]] bool is_ini_header(const IniLine& line);

struct IniSection {
  IniLine header;
  std::vector<IniLine> lines;
};

/// In the file's order; lines before the first header are of none.
[[nodiscard]] std::vector<IniSection> ini_sections_of(const text::Document& document);

}  // namespace fca
