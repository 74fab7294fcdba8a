// SPDX-License-Identifier: BSD-3-Clause
#include "syntax.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <vector>

namespace fca::text {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string extension_of(const Source& source) {
  const std::size_t dot = source.name.find_last_of("./");
  if (dot == std::string::npos || source.name[dot] == '/') return "";
  std::string extension = source.name.substr(dot);
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

/// The first `count` lines that are neither blank nor a comment.
std::vector<std::string_view> first_lines(std::string_view text, std::size_t count) {
  std::vector<std::string_view> lines;
  for (std::size_t start = 0; start < text.size() && lines.size() < count;) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = text.substr(start, end - start);
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first != std::string_view::npos && line[first] != '#') lines.push_back(line);
    start = end + 1;
  }
  return lines;
}

bool is_number(std::string_view word) { return parse_real(word).has_value(); }

/// Numbers alone, or after a name: nothing that means something else to YAML ("key:", "-", "!tag", "'quoted'").
bool is_line_of_numbers(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  const auto letters = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const bool named = !is_number(words.front()) && std::ranges::all_of(words.front(), letters);
  const auto numbers = words.begin() + (named ? 1 : 0);
  return numbers != words.end() && std::all_of(numbers, words.end(), is_number);
}

/// Five numbers or more, with commas, semicolons or blanks between them: a row of a table of rays.
bool is_row_of_table(std::string_view line) {
  std::string blank(line);
  std::ranges::replace_if(
      blank, [](char c) { return c == ',' || c == ';'; }, ' ');
  constexpr std::size_t kFewest = 5;
  const std::vector<std::string_view> words = words_of(blank);
  return words.size() >= kFewest && std::ranges::all_of(words, is_number);
}

/// Rows alone, or below a line that names their columns, whatever the file's name.
bool begins_as_table(std::span<const std::string_view> lines) {
  if (lines.empty()) return false;
  const bool may_name_columns = lines[0].find_first_of(":[{(=<-") == std::string_view::npos;
  return is_row_of_table(lines[0]) || (lines.size() > 1 && may_name_columns && is_row_of_table(lines[1]));
}

bool can_begin_yaml(std::string_view line) {
  const std::string_view first = words_of(line).front();
  if (first == "-" || first == "?" || first == "---" || std::string_view("\"'{[!&*|>").find(first[0]) != std::string_view::npos)
    return true;
  const std::size_t last = line.find_last_not_of(kBlanks);
  return line.find(": ") != std::string_view::npos || line.find(":\t") != std::string_view::npos || line[last] == ':';
}

/// "[1", "[ {" and so on, but not "[section]".
bool begins_as_json(std::string_view text) {
  if (text[0] == '{') return true;
  if (text[0] != '[') return false;
  const std::size_t next = text.find_first_not_of(kBlanks, 1);
  return next == std::string_view::npos || std::string_view("[{]\"'-0123456789").find(text[next]) != std::string_view::npos;
}

/// By a name that says nothing of the syntax, a mapping whose first key is in single quotes, after blanks and comments.
bool begins_as_python(const Source& source, std::string_view text) {
  constexpr std::array<std::string_view, 5> kOthers = {".yaml", ".yml", ".json", ".xml", ".txt"};
  if (std::ranges::find(kOthers, extension_of(source)) != kOthers.end()) return false;
  bool is_open = false;
  for (std::size_t at = 0; at < text.size(); at = text.find_first_not_of(kBlanks, at)) {
    const char c = text[at];
    if (c == '#') {
      at = std::min(text.find_first_of("\r\n", at), text.size());
    } else if (c == '{' && !is_open) {
      is_open = true;
      ++at;
    } else {
      return c == '\'' && is_open;
    }
  }
  return false;
}

/// "[image]" alone in its line, and after it neither a key of YAML nor another value: the sections of an .ini, whose lines are
/// words.
bool begins_as_ini(std::span<const std::string_view> lines) {
  if (lines.size() < 2) return false;
  const std::vector<std::string_view> header = words_of(lines[0]);
  const std::string_view first = header.front();
  const std::string_view last = header.back();
  const bool brackets =
      first.starts_with('[') && last.ends_with(']') && lines[0].find_first_of(",:{}\"'") == std::string_view::npos;
  return brackets && std::isalpha(static_cast<unsigned char>(words_of(lines[1]).front()[0])) != 0 && !can_begin_yaml(lines[1]);
}

/// What the tools of RealSense cameras print, whatever stands before it: neither YAML nor lines of another syntax.
bool is_print_of_realsense(std::string_view text) {
  if (text.find("(rs2_intrinsics {") != std::string_view::npos) return true;
  constexpr std::string_view kHead = "Intrinsic of \"";
  for (std::size_t at = text.find(kHead); at != std::string_view::npos; at = text.find(kHead, at + 1)) {
    const std::size_t before = text.substr(0, at).find_last_not_of(" \t");
    if (before == std::string_view::npos || text[before] == '\n') return true;
  }
  return false;
}

std::string_view content_of(const Source& source) {
  std::string_view text = std::string_view(source.bytes).substr(source.byte_order_mark());
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text;
}

}  // namespace

bool named_as_yaml(const Source& source) {
  const std::string extension = extension_of(source);
  return extension == ".yaml" || extension == ".yml";
}

bool named_as_python(const Source& source) { return extension_of(source) == ".cameramodel"; }

bool falls_back_to_yaml(const Source& source) {
  if (named_as_yaml(source)) return true;
  const std::string_view text = content_of(source);
  const std::size_t first = text.find_first_not_of(" \t\r\n[{");
  return extension_of(source) != ".json" && first != std::string_view::npos && text[first] != '"' && text[first] != '}';
}

Syntax choose_syntax(const Source& source) {
  if (named_as_python(source)) return Syntax::kPython;
  if (std::string_view(source.bytes).substr(source.byte_order_mark()).starts_with("%YAML:")) return Syntax::kOpenCvYaml;
  const std::string_view text = content_of(source);
  if (text.empty() || text[0] == '%') return Syntax::kYaml;
  if (text[0] == '<' && !text.starts_with("<<<<<<< ")) return Syntax::kXml;
  if (begins_as_python(source, text)) return Syntax::kPython;
  if (begins_as_json(text)) return Syntax::kJson;

  constexpr std::string_view kReportOfKalibr = "Calibration results";
  if (text.starts_with(kReportOfKalibr) || is_print_of_realsense(text)) return Syntax::kWords;
  const std::vector<std::string_view> lines = first_lines(text, 2);
  if (!lines.empty() && is_line_of_numbers(lines.front())) return Syntax::kWords;
  if (begins_as_table(lines) || begins_as_ini(lines)) return Syntax::kWords;
  if (!lines.empty() && can_begin_yaml(lines.front())) return Syntax::kYaml;
  if (named_as_yaml(source)) return Syntax::kYaml;
  const std::string extension = extension_of(source);
  if (extension == ".txt" || extension == ".csv") return Syntax::kWords;
  if (extension == ".xml" && !lines.empty()) return Syntax::kXml;
  if (extension == ".json" && !lines.empty()) return Syntax::kJson;
  return lines.size() > 1 && is_line_of_numbers(lines[1]) ? Syntax::kWords : Syntax::kYaml;
}

}  // namespace fca::text
