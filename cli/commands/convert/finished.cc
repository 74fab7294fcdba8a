// SPDX-License-Identifier: BSD-3-Clause
#include "finished.h"

#include "conversion_json.h"
#include "shell/packed.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace fca::cli {

namespace {

std::string models(const ConvertOutcome& outcome) {
  std::vector<std::string> said;
  for (const ConvertedCamera& camera : outcome.cameras) {
    const std::string from(camera.source.lens_id());
    const std::string to(camera.target.lens_id());
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
      most = std::max(most, camera.report->statistics.error.*figure);
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

/// Puts them into the bytes, or gets them from there, in one order.
template <class Bytes, class Values>
void pass_fields(Bytes& bytes, Values& finished) {
  std::uint64_t files = finished.files.size();
  bytes.pass(finished.input, finished.code, finished.is_evaluated, finished.word, finished.has_error, finished.errors,
             finished.json, files);
  bytes.pass(finished.row.models, finished.row.rms_px, finished.row.max_px, finished.row.result);
  if constexpr (!std::is_const_v<Values>) finished.files.resize(files);
  for (auto& file : finished.files) bytes.pass(file.path, file.bytes);
}

}  // namespace

Finished finished(const ConvertOutcome& outcome, const ConvertArguments& arguments, std::span<const text::Source> sources,
                  const Console& console) {
  Finished result = {.input = outcome.input,
                     .code = outcome.code,
                     .is_evaluated = outcome.status <= Status::kRejected,
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
  pass_fields(writer, finished);
  return writer.bytes();
}

Finished unpacked(std::string_view bytes) {
  PackedReader reader(bytes);
  Finished finished;
  pass_fields(reader, finished);
  finished.row.input = finished.input;
  return finished;
}

}  // namespace fca::cli
