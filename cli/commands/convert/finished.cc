// SPDX-License-Identifier: BSD-3-Clause
#include "finished.h"

#include "conversion_json.h"
#include "shell/packed.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <cstdint>

namespace fca::cli {

namespace {

std::string models(const ConvertOutcome& outcome) {
  std::vector<std::string> said;
  for (const ConvertedCamera& camera : outcome.cameras) {
    const std::string from(model_info(camera.source.model).id);
    const std::string to(model_info(camera.target.model).id);
    const std::string one = from == to ? to : from + " -> " + to;
    if (std::ranges::find(said, one) == said.end()) said.push_back(one);
  }
  return enumerated(said);
}

/// The largest of a figure over the cameras, as the program sees them, else of the fit.
std::string largest(const ConvertOutcome& outcome, double ErrorSummary::*figure, double as_program_sees) {
  if (outcome.cameras.empty()) return "";
  double most = as_program_sees;
  for (const ConvertedCamera& camera : outcome.cameras) {
    if (as_program_sees == 0.0 && camera.report && !camera.report->exact)
      most = std::max(most, camera.report->judgement.error.*figure);
  }
  constexpr double kNothingPx = 1e-4;
  return most < kNothingPx ? "0" : pixels(most);
}

std::string error_in_words(const std::string& id) { return "error: " + id; }

std::string result(const ConvertOutcome& outcome) {
  for (const Diagnostic& entry : outcome.diagnostics.entries()) {
    if (entry.severity != Severity::kError) continue;
    const bool is_rejected = outcome.status == Status::kRejected;
    return is_rejected ? std::string(in_words(VerdictWord::kDoNotUse)) + ": " + id_of(entry) : error_in_words(id_of(entry));
  }
  return std::string(in_words(outcome.verdict.word));
}

}  // namespace

Finished finished(const ConvertOutcome& outcome, const ConvertArguments& arguments, std::span<const text::Source> sources,
                  const Console& console) {
  Finished result = {.input = outcome.input,
                     .code = outcome.code,
                     .is_judged = outcome.status <= Status::kRejected,
                     .word = outcome.verdict.word,
                     .has_error = outcome.diagnostics.has_errors(),
                     .files = {},
                     .row = {outcome.input, models(outcome), largest(outcome, &ErrorSummary::rms, outcome.rms_px),
                             largest(outcome, &ErrorSummary::max, outcome.max_px), cli::result(outcome)},
                     .errors = {},
                     .json = {},
                     .whole = {}};
  const bool is_written = outcome.code == ExitCode::kGood && !arguments.dry_run;
  for (const ConvertedFile& file : outcome.files) {
    const bool is_in_json = arguments.json && file.path.empty();
    result.files.push_back({file.path, is_written && !is_in_json ? file.bytes : ""});
  }
  if (arguments.json) {
    result.json = conversion_json(outcome, sources);
  } else {
    result.errors = console.errors_in_words(outcome.diagnostics, sources);
  }
  return result;
}

void Finished::fail(const Message& problem, const Console& console) {
  Diagnostics said;
  said.add(problem);
  code = ExitCode::kIo;
  if (!has_error) row.result = error_in_words(id_of(problem));
  has_error = true;
  if (whole) {
    whole->diagnostics.add(problem);
    whole->code = code;
  }
  if (!json.empty()) {
    json = unwritten_json(json, code, said);
  } else {
    errors += console.errors_in_words(said, {});
  }
}

std::string packed(const Finished& finished) {
  PackedWriter writer;
  writer.put(finished.input);
  writer.put(finished.code);
  writer.put(finished.is_judged);
  writer.put(finished.word);
  writer.put(finished.has_error);
  writer.put(static_cast<std::uint64_t>(finished.files.size()));
  for (const OutputFile& file : finished.files) {
    writer.put(file.path);
    writer.put(file.bytes);
  }
  for (const std::string* text : {&finished.row.models, &finished.row.rms_px, &finished.row.max_px, &finished.row.result,
                                  &finished.errors, &finished.json})
    writer.put(*text);
  return writer.bytes();
}

Finished unpacked(std::string_view bytes) {
  PackedReader reader(bytes);
  Finished finished;
  reader.get(finished.input);
  reader.get(finished.code);
  reader.get(finished.is_judged);
  reader.get(finished.word);
  reader.get(finished.has_error);
  std::uint64_t count = 0;
  reader.get(count);
  finished.files.resize(count);
  for (OutputFile& file : finished.files) {
    reader.get(file.path);
    reader.get(file.bytes);
  }
  finished.row.input = finished.input;
  for (std::string* text : {&finished.row.models, &finished.row.rms_px, &finished.row.max_px, &finished.row.result,
                            &finished.errors, &finished.json})
    reader.get(*text);
  return finished;
}

}  // namespace fca::cli
