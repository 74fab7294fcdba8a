// SPDX-License-Identifier: BSD-3-Clause
#include "ini.h"

#include "camera_info.h"

#include "../ini_sections.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>

namespace fca::ros {

using text::Node;

namespace {

class IniFinder {
 public:
  explicit IniFinder(fields::Reader& reader) : reader_(reader) {}

  std::optional<std::vector<CameraInfo>> run() {
    std::vector<CameraInfo> infos;
    CameraInfo image;
    for (const IniSection& section : ini_sections_of(reader_.document())) {
      if (section.header.text == "[image]") {
        image = {};
        if (!read_image(section, image)) return std::nullopt;
      } else if (section.header.text != "[externals]") {
        if (image.width == nullptr) reader_.say(*section.header.node, Code::kRosIniNoImage);
        CameraInfo info = image;
        if (!read_camera(section, info)) return std::nullopt;
        infos.push_back(std::move(info));
      }
    }
    if (infos.empty()) {
      reader_.say(reader_.document().root(), Code::kRosIniNoCamera);
      return std::nullopt;
    }
    if (infos.size() > 1) reader_.say(*infos.back().K->place, Code::kRosIniManyCameras, {infos.size()});
    return infos;
  }

 private:
  /// The line after a key; nothing, with an error, where there is none.
  std::optional<std::size_t> value_of(const IniSection& section, std::string_view key) {
    const auto found = std::ranges::find(section.lines, key, &IniLine::text);
    if (found == section.lines.end() || found + 1 == section.lines.end()) {
      reader_.say(*section.header.node, Code::kRosIniKeyMissing, {section.header.text, key});
      return std::nullopt;
    }
    return static_cast<std::size_t>(found + 1 - section.lines.begin());
  }

  bool read_image(const IniSection& section, CameraInfo& info) {
    const std::optional<std::size_t> width = value_of(section, "width");
    const std::optional<std::size_t> height = value_of(section, "height");
    if (!width || !height) return false;
    info.width = &section.lines[*width].node->items.front();
    info.height = &section.lines[*height].node->items.front();
    return true;
  }

  bool read_camera(const IniSection& section, CameraInfo& info) {
    const std::string& header = section.header.text;
    info.name = text::printable(std::string_view(header).substr(1, header.size() - 2));
    info.counted = true;
    info.D.emplace();
    return read_matrix(section, "camera matrix", 3, 3, info.K) && read_coefficients(section, *info.D) &&
           read_matrix(section, "rectification", 3, 3, info.R) && read_matrix(section, "projection", 3, 4, info.P);
  }

  bool read_row(const IniLine& line, const std::string& what, Numbers& numbers) {
    for (const Node& word : line.node->items) {
      const std::optional<double> value = reader_.real(word, what);
      if (!value) return false;
      numbers.nodes.push_back(&word);
      numbers.values.push_back(*value);
    }
    return true;
  }

  bool read_matrix(const IniSection& section, const std::string& key, std::size_t rows, std::size_t columns,
                   std::optional<Numbers>& into) {
    const std::optional<std::size_t> first = value_of(section, key);
    if (!first) return false;
    Numbers numbers{section.lines[*first].node, {}, {}};
    for (std::size_t row = 0; row < rows; ++row) {
      const bool there = *first + row < section.lines.size();
      const IniLine& line = section.lines[there ? *first + row : section.lines.size() - 1];
      const std::size_t count = there ? line.node->items.size() : 0;
      if (there && !read_row(line, key, numbers)) return false;
      if (count == columns) continue;
      reader_.say(*line.node, Code::kRosIniRowLength, {key, row + 1, count, columns, rows});
      return false;
    }
    into = std::move(numbers);
    return true;
  }

  /// parse_ini.cpp: 8 numbers where there are more than 5, else 5; what is missing becomes nan.
  bool read_coefficients(const IniSection& section, Numbers& numbers) {
    const std::optional<std::size_t> first = value_of(section, "distortion");
    if (!first) return false;
    const IniLine& line = section.lines[*first];
    numbers.place = line.node;
    if (!read_row(line, "distortion", numbers)) return false;
    constexpr std::size_t kPlumbBob = 5;
    constexpr std::size_t kRational = 8;
    if (numbers.values.size() == kPlumbBob || numbers.values.size() == kRational) return true;
    reader_.say(*line.node, Code::kRosIniCoefficientCount, {numbers.values.size()});
    return false;
  }

  fields::Reader& reader_;
};

std::string block(std::string_view key, std::span<const double> values, std::size_t columns) {
  std::string text = "\n" + std::string(key) + "\n";
  for (std::size_t i = 0; i < values.size(); ++i) text += text::format_real(values[i]) + ((i + 1) % columns == 0 ? "\n" : " ");
  return text;
}

}  // namespace

std::optional<std::vector<CameraInfo>> find_in_ini(fields::Reader& reader) { return IniFinder(reader).run(); }

bool looks_like_ini(const text::Document& document) {
  if (document.syntax() != text::Syntax::kWords) return false;
  const std::vector<IniLine> lines = ini_lines_of(document);
  // Other programs' .ini files have key = value.
  constexpr std::array<std::string_view, 4> kOwnLines = {"width", "height", "camera matrix", "distortion"};
  const auto is_own = [&kOwnLines](const IniLine& line) { return std::ranges::find(kOwnLines, line.text) != kOwnLines.end(); };
  return !lines.empty() && is_ini_header(lines.front()) && std::ranges::any_of(lines, is_own);
}

bool ini_holds(std::string_view model) { return model == "radtan" || model == "rational" || model == "pinhole"; }

std::string section_of(std::string name) {
  std::ranges::replace(name, '[', '(');
  std::ranges::replace(name, ']', ')');
  return name == "image" || name == "externals" ? name + "_camera" : name;
}

std::string compose_ini(const Camera& camera, const Rectified& rectified) {
  const std::vector<double> D = coefficients_of(camera.model);
  return "# Camera intrinsics\n\n[image]\n\nwidth\n" + std::to_string(camera.image_size->width) + "\n\nheight\n" +
         std::to_string(camera.image_size->height) + "\n\n[" + section_of(camera.name) + "]\n" +
         block("camera matrix", camera_matrix_of(camera.model), 3) + block("distortion", D, D.size()) +
         block("rectification", rectified.R, 3) + block("projection", rectified.P, 4);
}

}  // namespace fca::ros
