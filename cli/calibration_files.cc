// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_files.h"

#include "output_name.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include <glob.h>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// The files of a pattern by name; the path itself where it is none, or fits nothing: reading it will tell.
std::vector<std::string> matches(const std::string& path) {
  std::error_code error;
  if (path.find_first_of("*?[") == std::string::npos || fs::exists(path, error)) return {path};
  glob_t found{};
  std::vector<std::string> files;
  if (glob(path.c_str(), 0, nullptr, &found) == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return files.empty() ? std::vector<std::string>{path} : files;
}

/// Errors of single entries (no permission, gone meanwhile) leave those out.
void walk_folder(const fs::path& folder, std::vector<std::string>& files) {
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (at->path().filename().string().starts_with('.')) {
      at.disable_recursion_pending();
      continue;
    }
    std::error_code ignored;
    if (at->is_regular_file(ignored) && is_calibration_extension(at->path().extension().string()))
      files.push_back(at->path().string());
  }
}

}  // namespace

std::vector<FoundFile> walk(const std::vector<std::string>& paths) {
  std::vector<FoundFile> found;
  std::vector<std::string> resolved;
  for (const std::string& path : paths) std::ranges::move(matches(path), std::back_inserter(resolved));
  for (const std::string& path : resolved) {
    std::error_code error;
    if (path == "-" || !fs::is_directory(path, error)) {
      found.push_back({path, true});
      continue;
    }
    std::vector<std::string> files;
    walk_folder(path, files);
    std::ranges::sort(files);
    for (std::string& file : files) found.push_back({std::move(file), false});
  }
  return found;
}

}  // namespace fca::cli
