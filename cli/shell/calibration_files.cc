// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_files.h"

#include <fca/toolkit/inputs.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <unordered_set>
#include <utility>

#include <glob.h>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// What stands there under that very name is no pattern.
bool is_pattern(const std::string& path) {
  std::error_code error;
  return path.find_first_of("*?[") != std::string::npos && !fs::exists(path, error);
}

/// By name; empty if nothing fits.
std::vector<std::string> matches(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return files;
}

bool is_rig(const fs::path& folder) {
  return !rig_files_in(folder.string()).empty() || !model_files_in(folder.string()).empty();
}

/// Is the folder of a dataset, which holds its rig in a folder of its own, not alone with it?
bool holds_others(const fs::path& folder, WantedExtension wanted) {
  if (!is_rig(folder / "mav0")) return false;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored) && wanted(at->path().extension().string())) return true;
  }
  return false;
}

/// Errors of single entries (no permission, gone meanwhile) leave those out.
void walk_folder(const fs::path& folder, WantedExtension wanted, bool whole_rigs, std::vector<std::string>& files) {
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (at->path().filename().string().starts_with('.')) {
      at.disable_recursion_pending();
      continue;
    }
    std::error_code ignored;
    if (whole_rigs && at->is_directory(ignored) && is_rig(at->path()) && !holds_others(at->path(), wanted)) {
      files.push_back(at->path().string());
      at.disable_recursion_pending();
    }
    if (at->is_regular_file(ignored) && wanted(at->path().extension().string())) files.push_back(at->path().string());
  }
}

std::vector<FoundFile> walk(const std::vector<std::string>& paths, WantedExtension wanted, bool whole_rigs) {
  std::vector<FoundFile> resolved;
  for (const std::string& path : paths) {
    if (!is_pattern(path)) {
      resolved.push_back({path, true});
      continue;
    }
    for (std::string& file : matches(path)) resolved.push_back({std::move(file), false});
  }
  std::vector<FoundFile> found;
  std::unordered_set<std::string> met;
  const auto add = [&found, &met](FoundFile file) {
    std::error_code error;  // what has no such path is told by its name
    const std::string where = is_standard_input(file.path) ? file.path : fs::weakly_canonical(file.path, error).string();
    if (met.insert(error ? file.path : where).second) found.push_back(std::move(file));
  };
  for (const FoundFile& each : resolved) {
    std::error_code error;
    if (is_standard_input(each.path) || !fs::is_directory(each.path, error) ||
        (whole_rigs && is_rig(each.path) && !holds_others(each.path, wanted))) {
      add(each);
      continue;
    }
    std::vector<std::string> files;
    walk_folder(each.path, wanted, whole_rigs, files);
    std::ranges::sort(files);
    for (std::string& file : files) add({std::move(file), false});
  }
  return found;
}

}  // namespace

std::optional<std::string> problem_with_patterns(const std::vector<std::string>& paths) {
  const auto found =
      std::ranges::find_if(paths, [](const std::string& path) { return is_pattern(path) && matches(path).empty(); });
  if (found == paths.end()) return std::nullopt;
  return "no file fits the pattern '" + *found + "'";
}

std::vector<FoundFile> walk(const std::vector<std::string>& paths, WantedExtension wanted) {
  return walk(paths, wanted, false);
}

std::vector<FoundFile> walk_rigs(const std::vector<std::string>& paths) { return walk(paths, &is_calibration_extension, true); }

}  // namespace fca::cli
