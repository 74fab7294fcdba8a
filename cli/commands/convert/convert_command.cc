// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"

#include "batch.h"
#include "batch_report.h"
#include "options/target.h"
#include "shell/calibration_files.h"
#include "shell/words.h"
#include "shell/written_outputs.h"

#include <fca/toolkit/read.h>

#include <algorithm>
#include <filesystem>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// Are they more than one conversion?
bool are_many(const ConvertArguments& arguments, const std::vector<FoundFile>& files) {
  return !arguments.request.inputs.join && (files.size() > 1 || (files.size() == 1 && !files.front().named));
}

/// Reading anything but files, and folders of them, may wait for ever.
bool is_at_hand(const FoundFile& file) {
  std::error_code ignored;
  return fs::is_regular_file(file.path, ignored) || fs::is_directory(file.path, ignored);
}

/// `convert camchain.yaml imu.yaml`: of a few inputs the one with cameras is the calibration, the others are parts of it. To
/// know, they are read.
ConvertArguments with_parts(const ConvertArguments& arguments, const std::vector<FoundFile>& files, Files& read_apart) {
  if (!std::ranges::all_of(files, [](const FoundFile& file) { return file.named && is_at_hand(file); })) return arguments;
  Inputs inputs = arguments.request.inputs;
  inputs.files.clear();
  for (const FoundFile& file : files) inputs.files.push_back(file.path);
  const Inputs recognised = with_parts_recognised(inputs, read_apart);
  if (recognised.files.size() == files.size()) return arguments;
  ConvertArguments result = arguments;
  result.inputs = recognised.files;
  result.request.inputs.parts = recognised.parts;
  return result;
}

/// Of a model's folder that is to be written into the file of its cameras is changed.
ConvertArguments into_cameras(ConvertArguments arguments) {
  const std::vector<std::string> model = model_files_in(arguments.request.into);
  if (!model.empty()) arguments.request.into = model.front();
  return arguments;
}

/// Need no file be put into its place, and no input be compared with the others? Then each result is reported immediately.
bool is_reported_immediately(const ConvertArguments& arguments) {
  return arguments.json_lines && !arguments.output.is_said() && !arguments.in_place && !arguments.request.inputs.opencv_model;
}

/// Puts what was converted into its places, and reports it, until the interrupt.
void write_and_report(Batch& batch, const ConvertArguments& arguments, const HeldInterrupt& interrupt, BatchReport& report,
                      const Console& console) {
  OutputWriter writer(arguments, console);
  bool is_reached = true;
  for (;;) {
    is_reached = is_reached && (batch.converted() == 1 || !interrupt.asked());
    std::vector<Finished> next = batch.take(kFilesAtOnce);
    if (next.empty()) return;
    if (is_reached && !arguments.dry_run) writer.write(next);
    for (const Finished& finished : next) report.add(finished, is_reached);
  }
}

ExitCode run_convert(const ConvertArguments& given, const TypedOptions& typed, Console& console) {
  if (const std::optional<std::string> problem = problem_with_patterns(given.inputs))
    return console.refuse(ExitCode::kIo, *problem);
  std::vector<FoundFile> files = walk_rigs(given.inputs);
  CommandFiles read_apart(console.streams());
  const ConvertArguments arguments = into_cameras(with_parts(given, files, read_apart));
  if (arguments.inputs != given.inputs) files = walk_rigs(arguments.inputs);
  if (const std::optional<std::string> error = problem_with(arguments, are_many(arguments, files)))
    return console.refuse(ExitCode::kUsage, *error);
  const HeldInterrupt interrupt(files.size() > 1 && std::ranges::all_of(files, is_at_hand), console);
  Batch batch(files, arguments, typed, read_apart, console);
  BatchReport report(batch, arguments, console);
  const bool is_immediate = is_reported_immediately(arguments);
  batch.convert(interrupt,
                is_immediate ? [&report](const Finished& finished) { report.add(finished, true); } : Batch::OnFinished());
  if (batch.converted() == 0 && batch.left() == 0) {
    return console.refuse(ExitCode::kBadInput, "no calibration with a camera in " + enumerated(arguments.inputs) + " (" +
                                                   counted(batch.skipped(), "file") + " looked at)");
  }
  if (const std::optional<std::string> error = batch.opencv_model_problem()) return console.refuse(ExitCode::kUsage, *error);
  if (batch.collide()) return ExitCode::kUsage;
  write_and_report(batch, arguments, interrupt, report, console);
  report.end();
  return report.code();
}

}  // namespace

void add_convert_command(Application& application) {
  application.add<ConvertArguments>("convert",
                                    "Convert a calibration to another format, and to another camera model if need be",
                                    &add_convert_options, &run_convert);
}

}  // namespace fca::cli
