// SPDX-License-Identifier: BSD-3-Clause
#include "outcome.h"

#include "shell/kept_inputs.h"
#include "shell/output_name.h"
#include "shell/words.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

/// The command's words without those that only say where the file goes and how it is shown: the same conversion gives the same
/// file.
std::string made_by(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 10> kOfNoMatter = {"--json", "--force", "--fsync",   "--dry-run", "--provenance",
                                                            "-v",     "-vv",     "--verbose", "-q",        "--quiet"};
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "-o" || word == "--output") {
      ++i;
    } else if (!(word.starts_with("-o") || word.starts_with("--output=")) &&
               std::ranges::find(kOfNoMatter, word) == kOfNoMatter.end()) {
      text += (text.empty() ? "" : " ") + shell_word(word);
    }
  }
  return text;
}

/// What -o has a place for.
OutputRoom room(const ConvertArguments& arguments) {
  const std::string& output = arguments.output;
  const bool folder = names_folder(output);
  OutputRoom result;
  result.named_files = arguments.json || arguments.in_place || !(output.empty() || output == "-");
  result.camera_files = folder || (output.empty() && arguments.json) || output.find("{camera}") != std::string::npos;
  result.further_files = folder;
  return result;
}

/// The command as it was typed, but with these cameras.
std::string command_with_cameras(const std::vector<std::string>& words, const std::vector<CameraChoice>& cameras) {
  std::string list;
  for (const CameraChoice& camera : cameras) list += (list.empty() ? "" : ",") + camera.name;
  std::string command = "fca-io";
  bool skip = false;
  for (const std::string& word : words) {
    if (!skip && word != "--camera" && !word.starts_with("--camera=")) command += " " + shell_word(word);
    skip = word == "--camera";
  }
  return command + " --camera " + shell_word(list);
}

/// How to fix what is wrong, where that is another command.
void add_commands(const std::vector<std::string>& words, ConvertOutcome& outcome) {
  if (outcome.better_order.empty()) return;
  Diagnostics with_commands;
  for (Diagnostic entry : outcome.diagnostics.entries()) {
    if (entry.facts.code == Code::kSecondIsLeft)
      entry.remedy = {Code::kCommandInstead, {command_with_cameras(words, outcome.better_order)}};
    with_commands.add(std::move(entry));
  }
  outcome.diagnostics = std::move(with_commands);
  for (Reason& reason : outcome.verdict.reasons) {
    if (reason.facts.code == Code::kSecondIsLeft)
      reason.remedy = {Code::kCommandInstead, {command_with_cameras(words, outcome.better_order)}};
  }
}

/// The images that show where the lens ends are not written over.
void keep_images(const Inputs& inputs, ConvertOutcome& outcome) {
  const KeptInputs images(inputs);
  for (const ConvertedFile& file : outcome.files) {
    const std::optional<std::string> problem = images.problem_with(file.path);
    if (!problem) continue;
    outcome.diagnostics.add(Code::kOverwritesInput, {*problem});
    outcome.status = Status::kBadRequest;
    return;
  }
}

}  // namespace

ConvertOutcome convert_input(const ConvertArguments& arguments, const std::vector<std::string>& words, Files& files) {
  ConvertRequest request = arguments.request;
  const std::string& input = request.inputs.files.front();
  const std::string& place = arguments.in_place ? request.into : arguments.output;
  request.made_by = made_by(words);
  request.room = room(arguments);
  request.path_of = [&place, &input](const ConvertResult& result, std::size_t file) {
    return output_path(place, input, result, file);
  };
  ConvertOutcome outcome;
  static_cast<ConvertResult&>(outcome) = convert(request, files);
  outcome.input = input;
  keep_images(request.inputs, outcome);
  add_commands(words, outcome);
  outcome.code = exit_code(outcome.status);
  return outcome;
}

}  // namespace fca::cli
