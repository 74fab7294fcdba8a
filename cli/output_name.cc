// SPDX-License-Identifier: BSD-3-Clause
#include "output_name.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, std::string_view placeholder, std::string_view value) {
  for (std::size_t at = text.find(placeholder); at != std::string::npos; at = text.find(placeholder, at + value.size())) {
    text.replace(at, placeholder.size(), value);
  }
  return text;
}

}  // namespace

std::optional<std::string> unknown_placeholder(std::string_view pattern) {
  constexpr std::array<std::string_view, 3> kKnown = {"{stem}", "{camera}", "{format}"};
  for (std::size_t at = pattern.find('{'); at != std::string_view::npos; at = pattern.find('{', at + 1)) {
    const std::size_t end = pattern.find('}', at);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view placeholder = pattern.substr(at, end - at + 1);
    if (std::ranges::find(kKnown, placeholder) == kKnown.end()) return std::string(placeholder);
  }
  return std::nullopt;
}

bool names_folder(const std::string& output) { return !output.empty() && (fs::is_directory(output) || output.ends_with('/')); }

std::string output_path(const std::string& output, const std::string& input, const Format& format, const Written& written,
                        std::size_t index) {
  if (output.empty() || output == "-") return "";
  const std::string stem = input == "-" ? "stdin" : fs::path(input).stem().string();
  if (output.find('{') != std::string::npos) {
    std::string camera;
    for (const std::string& name : written.files[index].cameras) camera += (camera.empty() ? "" : "-") + name;
    return replaced(replaced(replaced(output, "{stem}", stem), "{format}", format.id), "{camera}", camera);
  }
  if (!names_folder(output)) return output;
  const std::string name =
      index == 0 ? stem + "." + std::string(format.id) + ".yaml" : written.files[index].document.source().name;
  return (fs::path(output) / name).string();
}

}  // namespace fca::cli
