// SPDX-License-Identifier: BSD-3-Clause
#include "written_outputs.h"

#include "output_name.h"
#include "toolkit/save/output_file.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace fca::cli {

namespace {

/// The files of what was converted well; what goes to standard output goes there.
std::vector<OutputFile> files_of(const ConvertArguments& arguments, const Finished& converted, const Console& console) {
  std::vector<OutputFile> files;
  if (converted.code != ExitCode::kGood) return files;
  for (const OutputFile& file : converted.files) {
    if (file.path.empty()) {
      console.out(file.bytes);
    } else {
      files.push_back(file);
    }
  }
  for (const OutputFile& file : files) make_folder_of(file.path, arguments.output);
  return files;
}

}  // namespace

void OutputWriter::remove_leftovers_beside(const Finished& converted) {
  for (const OutputFile& file : converted.files) {
    if (file.path.empty()) continue;
    const std::string folder = std::filesystem::path(file.path).parent_path().string();
    if (clean_.insert(std::hash<std::string>{}(folder)).second) remove_leftovers(folder);
  }
}

void OutputWriter::write(std::span<Finished> converted) {
  std::vector<std::vector<OutputFile>> sets;
  for (const Finished& each : converted) {
    remove_leftovers_beside(each);
    sets.push_back(files_of(arguments_, each, console_));
  }
  const std::vector<std::optional<Message>> problems =
      write_sets(std::vector<std::span<const OutputFile>>(sets.begin(), sets.end()), arguments_.force || arguments_.in_place,
                 arguments_.fsync, arguments_.request.jobs);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (!problems[i] && !sets[i].empty()) console_.note_written();
    if (problems[i]) converted[i].fail(*problems[i], console_);
  }
}

}  // namespace fca::cli
