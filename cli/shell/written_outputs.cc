// SPDX-License-Identifier: BSD-3-Clause
#include "written_outputs.h"

#include "output_name.h"
#include "toolkit/save/output_file.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// How outputs that have one path are told apart: by what their inputs' names have of their own.
std::string apart(const std::vector<ConvertOutcome>& outcomes) {
  const bool several =
      std::ranges::any_of(outcomes, [](const ConvertOutcome& outcome) { return camera_files(outcome.files) > 1; });
  const ConvertOutcome& first = outcomes.front();
  const std::string extension =
      first.files.empty() ? std::string(first.to->extension) : extension_of(first.files.front(), *first.to);
  for (const std::string_view names : {"{stem}", "{stem}.{extension}", "{folder}.{stem}", "{folder}.{stem}.{extension}"}) {
    std::set<std::string> paths;
    for (const ConvertOutcome& outcome : outcomes) paths.insert(with_names_of(outcome.input, "", std::string(names)));
    if (paths.size() == outcomes.size())
      return "use a pattern such as -o 'out/" + std::string(names) + (several ? ".{camera}" : "") + extension + "'";
  }
  return "convert them one by one, each with an -o of its own";
}

/// The files of what was converted well; what goes to standard output goes there.
std::vector<OutputFile> files_of(const ConvertArguments& arguments, const ConvertOutcome& outcome, const Console& console) {
  std::vector<OutputFile> files;
  if (outcome.code != ExitCode::kGood) return files;
  for (const ConvertedFile& output : outcome.files) {
    if (!output.path.empty()) {
      files.push_back({output.path, output.bytes});
    } else if (!arguments.json) {
      console.out(output.bytes);
    }
  }
  for (const OutputFile& file : files) make_folder_of(file.path, arguments.output);
  return files;
}

}  // namespace

bool collide(const std::vector<ConvertOutcome>& outcomes, const Console& console) {
  std::map<std::string, std::string> inputs;  // by the path of their output
  for (const ConvertOutcome& outcome : outcomes) {
    for (const ConvertedFile& output : outcome.files) {
      if (output.path.empty()) continue;
      const auto [first, is_new] = inputs.insert({output.path, outcome.input});
      if (is_new) continue;
      const std::string of = first->second == outcome.input ? "two outputs of " + outcome.input
                                                            : "the outputs of " + first->second + " and " + outcome.input;
      static_cast<void>(console.refuse(ExitCode::kUsage, of + " would be written to " + output.path, apart(outcomes)));
      return true;
    }
  }
  return false;
}

void remove_leftovers_beside(const std::vector<ConvertOutcome>& outcomes) {
  std::set<std::string> folders;
  for (const ConvertOutcome& outcome : outcomes) {
    for (const ConvertedFile& output : outcome.files) {
      if (!output.path.empty()) folders.insert(fs::path(output.path).parent_path().string());
    }
  }
  for (const std::string& folder : folders) remove_leftovers(folder);
}

std::size_t write_outputs(const ConvertArguments& arguments, std::span<ConvertOutcome> outcomes, const Console& console) {
  // Few enough to be open at the same time.
  constexpr std::size_t kMostFiles = 256;
  std::vector<std::vector<OutputFile>> sets;
  std::size_t files = 0;
  do {
    sets.push_back(files_of(arguments, outcomes[sets.size()], console));
    files += sets.back().size();
  } while (sets.size() < outcomes.size() && files < kMostFiles);
  const std::vector<std::optional<Message>> problems =
      write_sets(std::vector<std::span<const OutputFile>>(sets.begin(), sets.end()), arguments.force || arguments.in_place,
                 arguments.fsync, arguments.request.jobs);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (!problems[i] && !sets[i].empty()) console.note_written();
    if (!problems[i]) continue;
    outcomes[i].diagnostics.add(problems[i]->code, problems[i]->arguments);
    outcomes[i].code = ExitCode::kIo;
  }
  return sets.size();
}

}  // namespace fca::cli
