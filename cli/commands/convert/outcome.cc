// SPDX-License-Identifier: BSD-3-Clause
#include "outcome.h"

#include "options/command_line.h"
#include "shell/kept_inputs.h"
#include "shell/words.h"
#include "shell/written_names.h"

#include <fca/code.h>

namespace fca::cli {

namespace {

/// The command without what only says where the file goes and how it is shown: the same conversion gives the same file.
std::string made_by(const TypedOptions& typed) {
  return command_line(typed, "convert", [](const TypedOption& option) { return !option.about_output; });
}

/// What -o has a place for.
OutputRoom room(const ConvertArguments& arguments) {
  const OutputPlace& output = arguments.output;
  OutputRoom result;
  result.named_files = arguments.json || arguments.in_place || !output.is_standard_output();
  result.further_files = output.kind == OutputPlace::Kind::kFolder || output.is_folder_pattern() ||
                         names_binary_folder(output, arguments.request.to);
  result.fillers = result.further_files && (arguments.one_input || output.is_folder_pattern());
  result.given_parts = !arguments.in_place && (!output.is_said() || output.is_standard_output());
  result.camera_files = result.further_files || (!output.is_said() && arguments.json) || output.names_camera();
  return result;
}

/// The command as it was typed, but with these cameras.
std::string command_with_cameras(const ConvertArguments& arguments, const TypedOptions& typed,
                                 const std::vector<CameraChoice>& cameras) {
  std::string list;
  for (const CameraChoice& camera : cameras) list += (list.empty() ? "" : ",") + camera.name;
  const std::string others =
      command_line(typed, "convert", [](const TypedOption& option) { return option.key != OptionKey::kCameras; });
  // What was written stands in the way of the second try.
  const bool needs_force = !arguments.output.is_standard_output() && !arguments.force && !arguments.dry_run;
  return "fca-io " + others + " --camera " + shell_word(list) + (needs_force ? " --force" : "");
}

/// How to fix what is wrong, where that is another command.
void add_commands(const ConvertArguments& arguments, const TypedOptions& typed, ConvertOutcome& outcome) {
  if (outcome.better_order.empty()) return;
  const Message remedy = {Code::kCommandInstead, {command_with_cameras(arguments, typed, outcome.better_order)}};
  Diagnostics with_commands;
  for (Diagnostic entry : outcome.diagnostics.entries()) {
    if (entry.facts.code == Code::kSecondIsLeft) entry.remedy = remedy;
    with_commands.add(std::move(entry));
  }
  outcome.diagnostics = std::move(with_commands);
  for (Reason& reason : outcome.verdict.reasons) {
    if (reason.facts.code == Code::kSecondIsLeft) reason.remedy = remedy;
  }
}

/// The images that show where the lens ends, or what counts, are not written over.
void keep_images(const ConvertRequest& request, ConvertOutcome& outcome) {
  KeptInputs images(request.inputs);
  images.add(std::span(&request.weight_image, 1));
  for (const ConvertedFile& file : outcome.files) {
    if (!images.hold(file.path)) continue;
    outcome.diagnostics.add(Code::kOverwritesInput, {file.path});
    outcome.status = Status::kBadRequest;
    return;
  }
}

}  // namespace

ConvertOutcome convert_input(const std::string& input, const ConvertArguments& arguments, const TypedOptions& typed,
                             Files& files) {
  ConvertRequest request = arguments.request;
  const OutputPlace place = arguments.in_place ? OutputPlace{OutputPlace::Kind::kFile, request.into} : arguments.output;
  request.made_by = made_by(typed);
  request.room = room(arguments);
  request.path_of = [&place, &input](const ConvertResult& result, std::size_t file) {
    return output_path(place, input, result, file);
  };
  ConvertOutcome outcome;
  static_cast<ConvertResult&>(outcome) = convert(request, files);
  name_as_written(outcome);
  outcome.input = input;
  keep_images(request, outcome);
  add_commands(arguments, typed, outcome);
  outcome.code = exit_code(outcome.status);
  return outcome;
}

}  // namespace fca::cli
