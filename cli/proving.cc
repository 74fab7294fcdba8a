// SPDX-License-Identifier: BSD-3-Clause
#include "proving.h"

#include "words.h"

#include <fca/formats/text/numbers.h>

namespace fca::cli {

namespace {

std::string disagreement(const ProofResult& proof) {
  if (!proof.loads) return "it would refuse the file: " + enumerated(proof.refusals);
  if (!proof.poses_agree) return "an element of its poses differs by " + text::format_short(proof.max_diff_pose, 3);
  if (proof.compared_share == 0.0) return "it has no pixel where we have one";
  return "its pixels differ by up to " + pixels(proof.max_diff_px) + " px";
}

consumers::LoadOptions load_options(const Written& written, const ConvertArguments& arguments) {
  consumers::LoadOptions options;
  if (!written.sensor.empty()) options.sensor = written.sensor;
  options.opencv_model = arguments.reading.opencv_model;
  return options;
}

}  // namespace

std::optional<std::string> refused(const Written& written, const ConvertArguments& arguments) {
  for (const Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const consumers::Consumer* consumer = consumers::find_consumer(id);
      if (consumer == nullptr) continue;
      const consumers::ConsumerView view = consumer->load(file.document.bytes(), load_options(written, arguments));
      if (!view.loads()) return view.refusals.front();
    }
  }
  return std::nullopt;
}

void drop_byte_order_mark(Written& written, const ConvertArguments& arguments, Diagnostics& diagnostics) {
  const text::Source& source = written.files.front().document.source();
  if (source.byte_order_mark() == 0 || !refused(written, arguments)) return;
  Written without = written;
  without.files.front().document.replace({0, source.byte_order_mark()}, "");
  if (refused(without, arguments)) return;
  diagnostics.note("byte-order-mark-dropped",
                   "the base's byte order mark is left out: the program that reads the file refuses it with one");
  written = std::move(without);
}

void verify(const Rig& rig, const ConvertOutcome::Output& output, const ConvertArguments& arguments, ConvertOutcome& outcome) {
  bool judged = false;
  for (const std::string& id : output.programs) {
    const consumers::Consumer* consumer = consumers::find_consumer(id);
    if (consumer == nullptr) continue;
    judged = true;
    ProofResult proof = prove(*consumer, output.bytes, load_options(outcome.written, arguments), rig, output.cameras);
    const std::string program(consumer->program);
    if (!proof.agrees() && outcome.unchanged) {
      outcome.diagnostics.warning(
          "program-refuses",
          "nothing was changed, and " + program + " does not understand the input itself: " + disagreement(proof), {},
          "--anew writes it as " + program + " reads it");
    } else if (!proof.agrees()) {
      outcome.diagnostics.error("proof-failed",
                                program + " would not understand what was to be written: " + disagreement(proof));
      outcome.code = worse(outcome.code, ExitCode::kJudgedBad);
    }
    outcome.proofs.push_back(std::move(proof));
  }
  if (judged) return;
  outcome.unproven.push_back(output.path);
  outcome.diagnostics.note(
      "not-proven",
      (output.path.empty() ? "" : output.path + ": ") + "no program that fca-io knows reads such keys, so none has proven it",
      {}, "--anew writes the keys that " + std::string(outcome.to->program) + " reads");
}

}  // namespace fca::cli
