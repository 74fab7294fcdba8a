// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/formats/text/numbers.h>
#include <fca/toolkit/files.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace fca::cli {

std::string fixed(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), result.ptr};
}

std::string angle_in_words(double degrees) {
  return text::format_short(degrees, 4) + " deg from the axis (" + text::format_short(2.0 * degrees, 4) + " deg in full)";
}

std::string percent(double share) { return fixed(100.0 * share, 1) + " %"; }

namespace {

constexpr std::size_t kColumns = 80;

/// Parts in lines of at most 80 columns, each line after `indent`.
std::string in_lines(std::span<const std::string> parts, std::string_view indent, std::string_view separator) {
  std::string text;
  std::string line(indent);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string item = parts[i] + (i + 1 < parts.size() ? std::string(separator) : "");
    if (line.size() > indent.size() && line.size() + item.find_last_not_of(' ') + 1 > kColumns) {
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
      line = indent;
    }
    line += item;
  }
  return text + line + "\n";
}

}  // namespace

std::string wrapped(std::span<const std::string> parts, std::string_view indent) { return in_lines(parts, indent, ", "); }

std::string paragraph(std::string_view text, std::string_view indent) {
  // Words between blanks; a command is one, however long, since it is there to be copied.
  std::vector<std::string> words;
  bool in_command = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (in_command && !word.starts_with('(')) {
      words.back() += " " + word;
    } else {
      words.push_back(word);
      in_command = word == "fca-io" || word == "(fca-io";
    }
    if (word.ends_with(',') || word.ends_with(';') || word.ends_with(')')) in_command = false;
  }
  return in_lines(words, indent, " ");
}

std::string parameters_in_words(const CameraModel& model, std::string_view indent) {
  std::vector<std::string> parts;
  const std::span<const Parameter> parameters = model_info(model).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parts.push_back(std::string(parameters[i].name) + " " + text::format_short(parameter_values(model)[i], 9));
  return in_lines(parts, indent, "  ");
}

std::string in_columns(std::string_view text, std::size_t used, std::size_t indent) {
  std::istringstream words{std::string(text)};
  std::string result;
  std::size_t column = used;
  bool begins_line = true;
  for (std::string word; words >> word; column += word.size()) {
    if (!begins_line && column + 1 + word.size() > kColumns) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!begins_line) {
      result += ' ';
      ++column;
    }
    result += word;
    begins_line = false;
  }
  return result;
}

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  if (result.size() < width) result.append(width - result.size(), ' ');
  return result;
}

std::string pixels(double value, const std::optional<ImageSize>& image) {
  const double diagonal = image ? std::ceil(std::hypot(image->width, image->height)) : value;
  return value > diagonal ? "over " + text::format_short(diagonal) : pixels(value);
}

std::string file_in_words(const std::string& path) {
  return is_standard_input(path) ? "standard input" : std::filesystem::path(path).filename().string();
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::optional<double> in_degrees(const std::optional<double>& radians) {
  return radians ? std::optional(*radians * kDegreesPerRadian) : std::nullopt;
}

std::string place_in_words(const LensCircle& circle) {
  return "centre (" + fixed(circle.centre[0], 1) + ", " + fixed(circle.centre[1], 1) + "), radius " +
         fixed(circle.radius_px, 1) + " px";
}

}  // namespace fca::cli
