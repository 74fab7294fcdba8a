// SPDX-License-Identifier: BSD-3-Clause
#include "proving.h"

#include "parallel_for.h"
#include "words.h"

#include <fca/formats/mend.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <numbers>

namespace fca {

namespace {

std::string disagreement(const ProofResult& proof) {
  if (!proof.loads) return "it would refuse the file: " + text::printable(enumerated(sentences_of(proof.refusals)));
  if (!proof.poses_agree) return "an element of its poses differs by " + text::format_short(proof.max_diff_pose, 3);
  if (proof.pixels_agree) return enumerated(text::texts_of(proof.other_numbers), "and");
  if (proof.compared_share == 0.0) return "it has no pixel where we have one";
  return "its pixels differ by up to " + pixels(proof.max_diff_px) + " px";
}

/// As the files were written to be read. --opencv-model is about the input.
consumers::LoadOptions load_options(const Written& written) {
  consumers::LoadOptions options;
  if (!written.sensor.empty()) options.sensor = written.sensor;
  options.opencv_model = written.opencv_model;
  return options;
}

/// The program's first reason not to load the bytes; nothing if it loads them.
std::optional<std::string> first_refusal(const std::string& bytes, const std::string& program,
                                         const consumers::LoadOptions& options) {
  const consumers::Consumer* consumer = consumers::find_consumer(program);
  if (consumer == nullptr) return std::nullopt;
  const consumers::ConsumerView view = consumer->load(bytes, options);
  if (view.loads()) return std::nullopt;
  return sentence_of(view.refusals.front());
}

}  // namespace

std::jthread prepare_programs(const Format& format) {
  const auto needed = [&format](const consumers::Consumer& each) {
    return each.prepare != nullptr && each.format == format.id;
  };
  const auto all = consumers::all_consumers();
  const auto program = std::ranges::find_if(all, needed);
  return program == all.end() ? std::jthread() : in_background(program->prepare);
}

std::optional<std::string> newly_refused(const Written& written, const text::Document* base) {
  const consumers::LoadOptions options = load_options(written);
  for (const Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const std::optional<std::string> now = first_refusal(file.document.bytes(), id, options);
      if (now && (base == nullptr || now != first_refusal(base->source().bytes, id, options))) return now;
    }
  }
  return std::nullopt;
}

bool mend_kept_text(Written& written, Diagnostics& diagnostics) {
  constexpr int kMostMends = 100;  // each is some runs of the program's reader
  const consumers::LoadOptions options = load_options(written);
  bool all_load = true;
  for (Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const consumers::Consumer* program = consumers::find_consumer(id);
      if (program == nullptr) continue;
      text::Document document = file.document;
      Diagnostics mends;
      std::optional<std::string> refusal;
      for (int i = 0; i < kMostMends; ++i) {
        refusal = first_refusal(document.bytes(), id, options);
        all_load = all_load && !refusal;
        const std::optional<Mend> mend = refusal ? find_mend(document, *program, options, *refusal) : std::nullopt;
        if (!mend) break;
        const std::string fix = text::text_of(mend->fix);
        const bool says_how = refusal->ends_with(fix);
        mends.note("mended", *refusal + (says_how ? "" : "; " + fix) + ": done", document.source().range(mend->span));
        document.replace(mend->span, mend->text);
      }
      if (refusal) continue;
      file.document = std::move(document);
      for (const Diagnostic& each : mends.entries()) diagnostics.add(each);
    }
  }
  return all_load;
}

void warn_if_refused(const Calibration& calibration, const Inputs& inputs, Diagnostics& diagnostics) {
  const text::Source& source = calibration.documents[calibration.with_cameras].source();
  const Message refusal = refused_by_all(calibration.format->id, source.bytes, !calibration.rig.cameras.empty(),
                                         {"", std::string(name_of(inputs.opencv_model))});
  if (!refusal.is_said()) return;
  diagnostics.warning("program-refuses",
                      source.name + " is read, but its own program would refuse it, " + text::text_of(refusal), {},
                      "fca-io check " + shell_word(source.name) + " says where, and how to mend it");
}

void verify(const Rig& rig, const ConvertedFile& output, const ConvertRequest& request, const Written& written,
            const text::Document* base, ConvertResult& result) {
  bool judged = false;
  for (const std::string& id : output.programs) {
    const consumers::Consumer* consumer = consumers::find_consumer(id);
    if (consumer == nullptr) continue;
    judged = true;
    const consumers::LoadOptions options = load_options(written);
    ProofResult proof =
        prove(*consumer, output.bytes, options, rig, output.cameras, request.inputs.max_angle_rad.value_or(std::numbers::pi),
              [&request](std::size_t count, const auto& body) { parallel_for(count, request.jobs, body); });
    const std::string program(consumer->program);
    const bool unchanged = base != nullptr && output.bytes == base->source().bytes;
    const bool refused_before =
        base != nullptr && !proof.loads && (unchanged || !request.into.empty()) &&
        first_refusal(base->source().bytes, id, options) == std::optional(sentence_of(proof.refusals.front()));
    if (refused_before) result.refused_before.push_back(program);
    if (!proof.agrees() && unchanged) {
      result.diagnostics.warning(
          "program-refuses",
          "nothing was changed, and " + program + " does not understand the input itself: " + disagreement(proof), {},
          "--anew writes it as " + program + " reads it");
    } else if (refused_before) {
      result.diagnostics.warning("program-refuses",
                                 request.into + " is edited and not proven: before and after, " + program +
                                     " refuses it: " + text::printable(sentence_of(proof.refusals.front())),
                                 {}, "--anew writes it as " + program + " reads it");
    } else if (!proof.agrees()) {
      result.diagnostics.error("proof-failed", program + " would not understand what was to be written: " + disagreement(proof),
                               {},
                               request.into.empty() || proof.loads
                                   ? ""
                                   : "fca-io check " + shell_word(request.into) +
                                         " tells whether the base itself is at fault; if not, --sensor takes a poorer mode");
      result.status = worse(result.status, Status::kRejected);
    }
    result.proofs.push_back(std::move(proof));
  }
  if (judged) return;
  result.unproven.push_back(output.path);
  result.diagnostics.note(
      "not-proven",
      (output.path.empty() ? "" : output.path + ": ") + "no program that fca-io knows reads such keys, so none has proven it",
      {}, "--anew writes the keys that " + std::string(result.to->program) + " reads");
}

}  // namespace fca
