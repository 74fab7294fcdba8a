// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/convert/domain.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fca::cli {

std::string fixed(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), result.ptr};
}

std::string angle_in_words(double degrees) {
  return text::format_short(degrees, 4) + " deg from the axis (" + text::format_short(2.0 * degrees, 4) + " deg in full)";
}

std::string pixels(double value) {
  if (value == 0.0) return "0";
  if (value < 1e-4) return text::format_short(value, 2);
  return text::format_short(value, 3);
}

std::string percent(double share) { return fixed(100.0 * share, 1) + " %"; }

namespace {

/// Parts in lines of at most 100 characters, each line behind `indent`.
std::string in_lines(std::span<const std::string> parts, std::string_view indent, std::string_view separator) {
  constexpr std::size_t kLineLength = 100;
  std::string text;
  std::string line(indent);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string item = parts[i] + (i + 1 < parts.size() ? std::string(separator) : "");
    if (line.size() > indent.size() && line.size() + item.find_last_not_of(' ') + 1 > kLineLength) {
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

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  if (result.size() < width) result.append(width - result.size(), ' ');
  return result;
}

std::string size_in_words(const ImageSize& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

std::optional<ImageSize> parse_size(std::string_view text) {
  const std::size_t x = text.find_first_of("xX");
  if (x == std::string_view::npos) return std::nullopt;
  const std::optional<int> width = text::parse_int(text.substr(0, x));
  const std::optional<int> height = text::parse_int(text.substr(x + 1));
  if (!width || !height || *width < 1 || *height < 1) return std::nullopt;
  return ImageSize{*width, *height};
}

FieldsOfView fields_of_view(const Camera& camera, double limit_deg) {
  FieldsOfView result;
  if (!camera.image_size) return result;
  const std::optional<Pixel> centre = project(camera.model, {0.0, 0.0, 1.0});
  if (!centre) return result;
  const Pixel last = {camera.image_size->width - 1.0, camera.image_size->height - 1.0};
  const auto angle = [&camera, limit_deg](const Pixel& pixel) -> std::optional<double> {
    const std::optional<Ray> ray = unproject(camera.model, pixel);
    if (!ray) return std::nullopt;
    const double degrees = angle_from_axis(*ray) * kDegreesPerRadian;
    return degrees <= limit_deg ? std::optional(degrees) : std::nullopt;
  };
  const auto across = [&angle, &centre](const Pixel& a, const Pixel& b) -> std::optional<double> {
    const std::optional<double> first = angle(a);
    const std::optional<double> second = angle(b);
    if (!first || !second) return std::nullopt;
    // The axis may lie beside the image, as in a crop.
    const double between = (a[0] - (*centre)[0]) * (b[0] - (*centre)[0]) + (a[1] - (*centre)[1]) * (b[1] - (*centre)[1]);
    return between > 0.0 ? std::abs(*first - *second) : *first + *second;
  };
  result.horizontal = across({0.0, (*centre)[1]}, {last[0], (*centre)[1]});
  result.vertical = across({(*centre)[0], 0.0}, {(*centre)[0], last[1]});
  result.diagonal = across({0.0, 0.0}, last);
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const std::optional<double> here = angle({last[0] * i / kSteps, last[1] * j / kSteps});
      if (here && (!result.largest_from_axis || *here > *result.largest_from_axis)) result.largest_from_axis = here;
    }
  }
  return result;
}

std::string unknown_word(std::string_view kind, std::string_view typed, std::span<const std::string> names,
                         std::string_view otherwise) {
  const std::string text = "unknown " + std::string(kind) + " '" + std::string(typed) + "'; ";
  const std::vector<std::string> near = nearest(typed, names);
  if (!near.empty()) return text + "did you mean " + enumerated(near, "or") + "?";
  return text + (otherwise.empty() ? "there are " + enumerated(names) : std::string(otherwise));
}

}  // namespace fca::cli
