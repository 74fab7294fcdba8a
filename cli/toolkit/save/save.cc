// SPDX-License-Identifier: BSD-3-Clause
#include "save/output_file.h"

#include <fca/code.h>
#include <fca/toolkit/save.h>

#include <filesystem>
#include <vector>

namespace fca {

std::string name_in_folder(const ConvertedFile& file) {
  return file.place.empty() ? std::filesystem::path(file.name).filename().string() : file.place;
}

bool save(const ConvertResult& result, const std::string& folder, Diagnostics& diagnostics, bool replaces) {
  if (result.status != Status::kDone) {
    diagnostics.add(Code::kNothingToSave);
    return false;
  }
  namespace fs = std::filesystem;
  std::error_code ignored;  // write_files() reports a folder that could not be created
  std::vector<OutputFile> files;
  for (const ConvertedFile& file : result.files) {
    const fs::path path = fs::path(folder) / name_in_folder(file);
    fs::create_directories(path.parent_path(), ignored);
    files.push_back({path.string(), file.bytes});
  }
  const std::optional<Message> problem = write_files(files, replaces, false);
  if (problem) diagnostics.add(problem->code, problem->arguments);
  return !problem;
}

}  // namespace fca
