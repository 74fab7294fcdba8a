// SPDX-License-Identifier: BSD-3-Clause
#include "convert/limits.h"
#include "convert/other_writings.h"
#include "convert/pair_errors.h"
#include "convert/start.h"
#include "convert/stray_ray.h"
#include "convert/weight_image.h"
#include "convert/writing.h"
#include "models/model_advice.h"

#include <fca/code.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/verdict.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/convert.h>

#include <algorithm>
#include <span>

namespace fca {

namespace {

/// The advice to use a model that every version of the program reads, with the error of its fit. An empty message if there is
/// no such model.
Message remedy_of_version(const ConvertRequest& request, const Start& start, const ConvertResult& result) {
  std::vector<Camera> sources;
  for (const ConvertedCamera& camera : result.cameras) sources.push_back(camera.source);
  const ModelChoice choice = {.request = request, .known = start.known.get()};
  return best_model_readable_by_all_versions(sources, *result.to, choice).value_or(Message());
}

/// Adds a remedy to each diagnostic about a lens that its model does not cover: the models that would be better. lib/, which
/// adds these diagnostics, does not know which models the program reads.
void name_better_models(const ConvertRequest& request, const Start& start, ConvertResult& result) {
  ConvertRequest chosen = request;
  if (!result.layout.empty()) chosen.layout = FormatLayout::find(*result.to, result.layout);
  const ModelChoice choice = choice_of(chosen, start, *result.to);
  const auto first = std::ranges::find(result.proofs, true, &ProofResult::is_first);
  const std::string_view program = first != result.proofs.end() ? std::string_view(first->program) : result.to->program;
  Diagnostics named;
  for (Diagnostic entry : result.diagnostics.entries()) {
    for (const ConvertedCamera& camera : result.cameras) {
      const bool is_of_camera =
          std::ranges::find(camera.found.entries(), entry.facts, &Diagnostic::facts) != camera.found.entries().end();
      if (entry.facts.code == Code::kTargetCannotReach && camera.report && is_of_camera)
        entry.remedy = {Code::kBetterModelsExist, {better_models(camera.source, *camera.report, *result.to, program, choice)}};
    }
    named.add(std::move(entry));
  }
  result.diagnostics = std::move(named);
}

/// The result of the same conversion if it writes a fresh file instead of editing a text. nullopt if it fails or if a program
/// does not load the file. `before`: the result before anything was written.
std::optional<ConvertResult> rewritten(const ConvertRequest& request, const Start& start, const ConvertResult& before) {
  ConvertRequest rewriting = request;
  rewriting.rewrite = true;
  ConvertResult other = before;
  if (!write_as_asked(rewriting, start, other) || !std::ranges::all_of(other.proofs, &ProofResult::loads)) return std::nullopt;
  try_other_layouts(rewriting, start, before, other);
  other.rms_px = worst_rms_px(other);
  other.max_px = worst_max_px(other);
  return other;
}

/// The verdict for an input whose only errors are poses that are mirror images instead of rotations. No file can contain such a
/// pose. The input is readable, so that the verdict is "do not use" and the status is not kBadInput. nullopt if there are other
/// errors, or none.
std::optional<Verdict> verdict_on_mirrors(const ConvertResult& result) {
  Verdict verdict;
  verdict.word = VerdictWord::kDoNotUse;
  for (const Diagnostic& entry : result.diagnostics.entries()) {
    if (entry.severity != Severity::kError) continue;
    if (entry.facts.code != Code::kPoseMirrors) return std::nullopt;
    verdict.reasons.push_back({.word = VerdictWord::kDoNotUse, .facts = entry.facts, .kind = entry.facts.code});
  }
  return verdict.reasons.empty() ? std::nullopt : std::optional(std::move(verdict));
}

/// The name of the format's own program if the files are for another program although the request names no program, layout or
/// base. Otherwise empty. It is also empty if the format's id is the id of the program that the files are for (OKVIS): the
/// request then named that program.
std::string_view own_program_not_served(const ConvertRequest& request, const ConvertResult& result) {
  const bool is_explicit = request.program != nullptr || request.layout || !request.into.empty();
  const consumers::Consumer* own = consumers::own_program(result.to->id, true);
  if (is_explicit || own == nullptr || result.files.empty() || result.files.front().programs.empty()) return {};
  const consumers::Consumer* first = consumers::find_consumer(result.files.front().programs.front());
  const bool is_for_another =
      first != nullptr && first->cameras && first->format == own->format && first != own && first->id != result.to->id;
  return is_for_another ? own->program : std::string_view();
}

/// True if the image size of a camera is unknown.
bool lacks_size(const Start& start) {
  return std::ranges::any_of(start.input.rig.cameras, [](const Camera& camera) { return !camera.image_size; });
}

/// True if the rate of an IMU is unknown.
bool lacks_rate(const Start& start) {
  return std::ranges::any_of(start.input.rig.imus, [](const Imu& imu) { return !imu.rate_hz; });
}

/// Adds the remedy "write a fresh file" to reasons of the verdict that a fresh file would resolve: the program refuses the
/// edited text or reads it with large errors, or the text is for another program.
void offer_fresh_file(const ConvertRequest& request, const Start& start, const ConvertResult& before,
                      const ConvertResult& result, Verdict& verdict) {
  // The diagnostic which reports that the program already refused the file before the edit. Its facts become the remedy.
  const std::vector<Diagnostic>& entries = result.diagnostics.entries();
  const auto refused = std::ranges::find_if(entries, [](const Diagnostic& entry) {
    return entry.facts.code == Code::kInputNotUnderstood || entry.facts.code == Code::kEditNotProven;
  });
  const auto needs_program = [](const Reason& reason) { return reason.facts.code == Code::kVerdictNeedsProgram; };
  const bool is_edited = start.base.document != nullptr && !request.rewrite && !request.layout && request.verify;
  const bool is_in_place = is_edited && request.into.empty();
  const bool is_file_of_other_program = is_in_place && std::ranges::any_of(verdict.reasons, needs_program);
  const bool is_unusable = is_edited && verdict.word == VerdictWord::kDoNotUse;
  if (refused == entries.end() && !is_unusable && !is_file_of_other_program) return;
  const std::optional<ConvertResult> fresh = rewritten(request, start, before);
  if (!fresh && !lacks_size(start) && !lacks_rate(start)) return;
  const Message demands{lacks_size(start) ? Code::kRewriteDemandsSize : Code::kRewriteDemandsRate};
  for (Reason& reason : verdict.reasons) {
    if (refused != entries.end() && reason.facts.code == Code::kVerdictRefused)
      reason.remedy = fresh ? refused->facts : demands;
    if (is_in_place && needs_program(reason)) {
      if (!fresh) reason.remedy = demands;
      if (fresh && own_program_not_served(request, *fresh).empty())
        reason.remedy = {Code::kRewrittenFor, {reason.facts.arguments.back(), fresh->rms_px, fresh->max_px}};
    }
    const bool is_far_off = reason.distance && word_of(*reason.distance) == VerdictWord::kDoNotUse;
    if (fresh && is_far_off && request.into.empty() && fresh->rms_px < result.rms_px)
      reason.remedy = {Code::kRewrittenIs, {fresh->rms_px, fresh->max_px}};
  }
}

/// Adds the remedies that need more than the reason itself, for example another conversion.
void add_remedies(const ConvertRequest& request, const Start& start, const ConvertResult& before, const ConvertResult& result,
                  Verdict& verdict) {
  offer_fresh_file(request, start, before, result, verdict);
  const auto needs_version = [](const Reason& reason) { return reason.facts.code == Code::kVerdictNeedsVersion; };
  const bool is_too_new = std::ranges::any_of(verdict.reasons, needs_version);
  const Message other_model = is_too_new ? remedy_of_version(request, start, result) : Message();
  const auto& entries = result.diagnostics.entries();
  for (Reason& reason : verdict.reasons) {
    const auto uncovered = std::ranges::find_if(entries, [&reason](const Diagnostic& entry) {
      return entry.facts.code == Code::kTargetCannotReach && entry.facts.arguments.front() == Argument(reason.camera);
    });
    if (reason.facts.code == Code::kVerdictNoRays && uncovered != entries.end()) reason.remedy = uncovered->remedy;
    if (needs_version(reason)) reason.remedy = other_model;
    const std::string_view right_name =
        request.program != nullptr ? request.program->writing.equidistant_file_name : std::string_view();
    if (reason.facts.code == Code::kVerdictPixelsOff && !right_name.empty()) reason.remedy = {Code::kNameTheFile, {right_name}};
    if (result.nearer && reason.facts.code == Code::kVerdictPixelsOff) {
      const double rms_px = reason.distance ? reason.distance->rms : result.rms_px;
      reason.remedy = {Code::kFitInsideAngle, {result.nearer->max_angle_deg, result.nearer->rms_px, rms_px}};
    }
  }
}

/// All findings: those about the input, the diagnostics that the conversion added to `before`, and those about the fitted
/// cameras.
std::vector<Finding> findings_of(const Start& start, const ConvertResult& before, const ConvertResult& result) {
  std::vector<Finding> findings = start.findings;
  add_findings(std::span(result.diagnostics.entries()).subspan(before.diagnostics.entries().size()), findings);
  for (const ConvertedCamera& camera : result.cameras) {
    if (const std::optional<Message> stray = stray_ray(camera))
      findings.push_back({.severity = info(stray->code).severity, .facts = *stray});
    if (!camera.report || camera.report->exact) continue;  // otherwise the checks of the input report it
    if (const std::optional<Message> problem = undistortion_problem(camera.target))
      findings.push_back({.severity = info(problem->code).severity, .facts = *problem});
  }
  return findings;
}

/// The verdict on the written files, with its remedies. The findings of `result` must be complete.
Verdict verdict_of(const ConvertRequest& request, const Start& start, const ConvertResult& before,
                   const ConvertResult& result) {
  VerdictFacts facts;
  facts.to = result.to;
  facts.mode = result.mode;
  facts.proofs = result.proofs;
  facts.is_asked = request.verify;
  facts.has_reader = result.unproven.empty();
  facts.not_for = own_program_not_served(request, result);
  // A request that names a model which only forks of the program read is a request for these forks.
  facts.is_named = request.into.empty() && request.model == nullptr;
  facts.losses = result.losses;
  facts.defaults = result.defaults;
  facts.findings = result.findings;
  facts.rig = &start.rig_of_input;
  facts.written_poses = result.poses;
  facts.outvoted = start.outvoted ? &*start.outvoted : nullptr;
  std::vector<std::vector<std::string>> files;
  for (const ConvertedFile& file : result.files) files.push_back(file.cameras);
  facts.files = files;
  for (const ConvertedCamera& camera : result.cameras) {
    if (result.lens_given && camera.report)
      facts.outside_lens = std::max(facts.outside_lens, camera.report->statistics.coverage.outside_lens);
  }
  facts.pair = result.pair ? &*result.pair : nullptr;
  std::vector<OwnUncertainty> uncertainties;
  for (const ConvertedCamera& camera : result.cameras) {
    const bool is_known = camera.report && camera.report->uncertainty && !camera.report->uncertainty->is_limit;
    if (is_known) uncertainties.push_back({camera.source.name, camera.report->uncertainty->rms_px});
  }
  facts.uncertainties = uncertainties;
  facts.accepted = request.accepted;
  Verdict verdict = decide(facts);
  add_remedies(request, start, before, result, verdict);
  return verdict;
}

/// If the usual layout lacks the key of a setting: writes the files in the layout that would be chosen without the settings,
/// with the settings in it. Returns false, and leaves `result` unchanged, if no key was missing or that layout lacks the key
/// too.
bool write_layout_with_set_keys(const ConvertRequest& request, const Start& start, const ConvertResult& before,
                                ConvertResult& result) {
  const bool lacks_key = std::ranges::any_of(result.diagnostics.entries(),
                                             [](const Diagnostic& entry) { return entry.facts.code == Code::kSetUnknownKey; });
  if (!lacks_key || request.layout || !request.into.empty() || !request.verify) return false;
  ConvertRequest without = request;
  without.settings.clear();
  ConvertResult chosen = before;
  if (!write_as_asked(without, start, chosen)) return false;
  try_other_layouts(without, start, before, chosen);
  if (chosen.layout.empty() || chosen.cameras.empty()) return false;
  ConvertRequest with_layout = request;
  with_layout.layout = FormatLayout::find(*result.to, chosen.layout);
  if (with_layout.model == nullptr) with_layout.model = &model_info(chosen.cameras.front().target.model);
  ConvertResult other = before;
  if (!write_as_asked(with_layout, start, other)) return false;
  result = std::move(other);
  result.layout = chosen.layout;
  result.others = std::move(chosen.others);
  return true;
}

/// Makes the whole conversion. Returns false after an error that leaves no files.
bool run(const ConvertRequest& asked, Files& files, ConvertResult& result) {
  Start start;
  std::jthread programs;
  ConvertRequest request = asked;
  if (!read_start(request, files, start, programs, result)) return false;
  if (!read_weight_image(start.input.rig, files, request, result.diagnostics)) return false;
  if (!has_needed_covariances(request, start.input.rig, result)) return false;
  const ConvertResult before = result;
  const bool is_written = write_as_asked(request, start, result);
  if (!is_written && !write_layout_with_set_keys(request, start, before, result)) return false;
  if (request.verify) {
    if (is_written) try_other_layouts(request, start, before, result);
    try_other_models(request, start, before, result);
    try_fit_in_circle(request, start, before, result);
  }
  name_better_models(request, start, result);
  // With --into the cameras may have other names than in the input, by which the pair is found.
  if (request.into.empty()) result.pair = pair_error_of(start.input.rig, result);
  result.rms_px = worst_rms_px(result);
  result.max_px = worst_max_px(result);
  for (Loss& loss : result.losses) loss.matters = matters(loss, *result.to, result.mode);
  warn_of_poor_fits(request, result);
  apply_limits(request, result);
  result.findings = findings_of(start, before, result);
  result.verdict = verdict_of(request, start, before, result);
  if (result.verdict.word == VerdictWord::kDoNotUse) result.status = worse(result.status, Status::kRejected);
  return true;
}

/// Replaces the files of the result by one text: each camera as arguments of the program's command line.
void write_arguments(ConvertResult& result) {
  const ConvertedFile& written = result.files.front();
  Diagnostics ignored;
  const text::Document file = text::parse_document({written.name, written.bytes}, ignored).value();
  ConvertedFile printed;
  for (const ConvertedCamera& camera : result.cameras) {
    if (result.cameras.size() > 1) printed.bytes += "# " + camera.name() + "\n";
    const auto place = std::ranges::find(written.cameras, camera.source.name) - written.cameras.begin();
    printed.bytes += result.to->arguments(camera.target, file, static_cast<std::size_t>(place)) + "\n";
    printed.cameras.push_back(camera.source.name);
  }
  result.files = {std::move(printed)};
  result.headline = {Code::kArgumentsHeadline, {result.to->program}};
}

}  // namespace

ConvertResult convert(const ConvertRequest& request, Files& files) {
  ConvertResult result;
  result.to = request.to;
  result.lens_given = request.inputs.max_angle_rad.has_value() || !request.inputs.lens_circles.empty();
  if (run(request, files, result)) {
    const bool has_arguments = result.to->arguments != nullptr && !result.files.empty();
    if (request.as_arguments && has_arguments) write_arguments(result);
    return result;
  }
  if (std::optional<Verdict> verdict = verdict_on_mirrors(result)) {
    result.verdict = *std::move(verdict);
    result.status = Status::kRejected;
    return result;
  }
  const Status status = status_of(result.diagnostics);
  result.status = worse(result.status, status == Status::kDone ? Status::kBadInput : status);
  return result;
}

}  // namespace fca
