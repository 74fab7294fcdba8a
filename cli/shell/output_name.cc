// SPDX-License-Identifier: BSD-3-Clause
#include "output_name.h"

#include "shell/words.h"

#include <fca/formats/file_name.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, std::string_view pattern_word, std::string_view value) {
  for (std::size_t at = text.find(pattern_word); at != std::string::npos; at = text.find(pattern_word, at + value.size())) {
    text.replace(at, pattern_word.size(), value);
  }
  return text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "-") + name;
  return text;
}

/// Of a folder its name, however it was written ("sparse/", ".").
std::string stem_of(const std::string& input) {
  if (is_standard_input(input)) return "stdin";
  const fs::path path = input;
  if (path.has_filename() && path.filename() != "." && path.filename() != "..") return path.stem().string();
  std::error_code error;  // a folder that is gone has no name
  const fs::path folder = fs::weakly_canonical(path, error);
  return folder.filename().stem().string();
}

/// The name of the folder that an input lies in.
std::string folder_of(const std::string& input) {
  std::error_code error;  // a folder that is gone has no name
  return is_standard_input(input) ? "stdin" : fs::absolute(input, error).lexically_normal().parent_path().filename().string();
}

/// A file of a program's own folder, in that one ("mav0") or in what is to hold it.
std::string in_folder(const fs::path& folder, const fs::path& file) {
  const fs::path last = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
  const bool is_own = std::distance(file.begin(), file.end()) > 1 && *file.begin() == last;
  return (folder / (is_own ? file.lexically_relative(last) : file)).string();
}

}  // namespace

std::string with_names_of(const std::string& input, const std::string& camera, const std::string& pattern) {
  const std::string stem = stem_of(input);
  const std::string extension = fs::path(input).extension().string();
  std::string path = replaced(replaced(pattern, "{stem}", stem), "{folder}", folder_of(input));
  path = replaced(path, "{extension}", extension.empty() ? extension : extension.substr(1));
  return replaced(path, "{camera}", as_file_name(camera));
}

bool names_binary_folder(const OutputPlace& place, const Format* to) {
  const fs::path path = place.path;
  return place.kind == OutputPlace::Kind::kFile && to != nullptr && !to->binary_file.empty() && path.has_parent_path() &&
         path.filename() == to->binary_file;
}

void make_folder_of(const std::string& path, const OutputPlace& place) {
  if (!place.holds_many()) return;
  std::error_code error;  // what is wrong with the folder, writing into it will tell
  fs::create_directories(fs::path(path).parent_path(), error);
}

std::optional<std::string> problem_with_pattern(const OutputPlace& place, std::span<const std::string_view> known) {
  const std::string_view pattern = place.path;
  for (std::size_t at = pattern.find('{'); at != std::string_view::npos; at = pattern.find('{', at + 1)) {
    const std::size_t end = pattern.find('}', at);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view name = pattern.substr(at, end - at + 1);
    if (std::ranges::find(known, name) != known.end()) continue;
    return "-o: " + std::string(name) + " is unknown; there are " +
           enumerated(std::vector<std::string>(known.begin(), known.end()), "and");
  }
  return std::nullopt;
}

std::string output_path(const OutputPlace& place, const std::string& input, const ConvertResult& result, std::size_t index) {
  if (place.is_standard_output()) return "";
  const std::string stem = stem_of(input);
  const ConvertedFile& file = result.files[index];
  if (file.named && index > 0) {
    const fs::path main_file = output_path(place, input, result, 0);
    return (main_file.parent_path() / fs::path(file.name).filename()).string();
  }
  if (place.is_folder_pattern()) {
    const std::string folder = replaced(with_names_of(input, joined(file.cameras), place.path), "{format}", result.to->id);
    return output_path({OutputPlace::Kind::kFolder, folder}, input, result, index);
  }
  if (place.kind == OutputPlace::Kind::kPattern)
    return replaced(with_names_of(input, joined(file.cameras), place.path), "{format}", result.to->id);
  if (place.kind == OutputPlace::Kind::kFile)
    return index == 0 || file.place.empty() ? place.path : (fs::path(place.path).parent_path() / file.place).string();
  const fs::path folder = place.path;
  const fs::path proposal = file.name;
  if (!file.place.empty()) return in_folder(folder, file.place);
  if (file.cameras.empty() || file.named) return (folder / as_file_name(proposal.filename().string())).string();
  // Files that belong together have the names under which their program looks for them.
  const bool has_further = std::ranges::any_of(result.files, [](const ConvertedFile& each) { return each.cameras.empty(); });
  const fs::path main_file = folder / result.to->main_file;
  std::error_code error;  // what cannot be asked is not there
  const bool is_input = fs::equivalent(main_file, input, error);
  if (has_further && camera_files(result.files) == 1 && !is_input) return main_file.string();
  const std::string camera = camera_files(result.files) > 1 ? "." + as_file_name(joined(file.cameras)) : "";
  return (folder / (stem + camera + "." + std::string(result.to->id) + extension_of(file, *result.to))).string();
}

}  // namespace fca::cli
