// SPDX-License-Identifier: BSD-3-Clause
#include "proving.h"

#include "parallel_for.h"

#include <fca/code.h>
#include <fca/formats/fix.h>
#include <fca/formats/read_back.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/save.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

namespace fca {

namespace {

/// The sentences of the complaints.
std::vector<Message> messages_of(const std::vector<consumers::Complaint>& complaints) {
  std::vector<Message> messages;
  messages.reserve(complaints.size());
  for (const consumers::Complaint& complaint : complaints) messages.push_back(complaint.facts);
  return messages;
}

/// The first way in which the program does not agree with the rig: it refuses the file, or reads other poses, numbers or
/// pixels.
Message disagreement(const ProofResult& proof) {
  if (!proof.loads) return {Code::kWouldRefuse, {messages_of(proof.refusals)}};
  if (!proof.poses_agree) return {Code::kPosesDiffer, {proof.max_diff_pose}};
  if (proof.pixels_agree) return {Code::kNumbersDiffer, {proof.other_numbers}};
  if (proof.compared_share == 0.0) return {Code::kHasNoPixel};
  return {Code::kPixelsDiffer, {proof.max_diff_px}};
}

/// The options with which a program must load the files that contain `rig`. The user's options for the input do not apply.
consumers::LoadOptions load_options(const Written& written, const Rig& rig) {
  ReadOptions reading;
  reading.opencv_model = written.opencv_model;
  if (!rig.cameras.empty()) reading.image_size = rig.cameras.front().image_size;
  consumers::LoadOptions options = load_options(reading);
  options.sensor = written.sensor.empty() ? "mono" : written.sensor;
  return options;
}

/// The file name of the output, for a program that recognises the lens by it, if the request names that program or the name is
/// the one that the program expects. Otherwise empty.
std::string name_for(const consumers::Consumer& program, const ConvertedFile& output, const ConvertRequest& request) {
  const std::string_view right_name = program.writing.equidistant_file_name;
  if (right_name.empty()) return {};
  std::string name = std::filesystem::path(output.path).filename().string();
  return &program == request.program || name == right_name ? name : std::string();
}

/// The first reason why the program does not load the bytes; nullopt if it loads them.
std::optional<consumers::Complaint> first_refusal(const std::string& bytes, const std::string& program,
                                                  const consumers::LoadOptions& options, LoadedViews& views) {
  const consumers::Consumer* consumer = consumers::find_consumer(program);
  if (consumer == nullptr) return std::nullopt;
  const consumers::ConsumerView& view = views.of(*consumer, bytes, options);
  return view.loads() ? std::nullopt : std::optional(view.refusals.front());
}

/// The names of other programs of the same format that load the file and read its cameras correctly.
std::vector<std::string> other_readers(const consumers::Consumer& refusing, const ConvertedFile& file,
                                       const consumers::LoadOptions& options, LoadedViews& views) {
  std::vector<std::string> names;
  for (const consumers::Consumer& each : consumers::all_consumers()) {
    if (each.id == refusing.id || !each.reads(refusing.format) || each.cameras == file.cameras.empty()) continue;
    const consumers::ConsumerView& view = views.of(each, file.bytes, options);
    const bool misreads = std::ranges::any_of(view.cameras, &consumers::ConsumerCamera::misread);
    if (view.loads() && !misreads) names.emplace_back(each.program);
  }
  return names;
}

/// If the program reads a fitted camera as it was written, and the proof covers the same part of the image as the fit, replaces
/// the proof's distances by the error statistics of the fit. These are more exact: the proof's lattice has few points and
/// misses errors at the edge of a lens.
void use_errors_of_fits(const std::vector<ConvertedCamera>& cameras, ProofResult& proof) {
  constexpr double kPixelTolerance = 1e-3;  // px
  constexpr double kShareTolerance = 0.02;  // of the image
  for (CameraProof& camera : proof.cameras) {
    const auto converted =
        std::ranges::find(cameras, camera.name, [](const ConvertedCamera& each) { return each.source.name; });
    if (converted == cameras.end() || !converted->report || converted->report->exact) continue;
    PixelDistance& image = camera.distance.in_image;
    const ErrorStatistics& fit = converted->report->statistics;
    const bool is_as_written = camera.agrees && !camera.misread && camera.max_diff_px <= kPixelTolerance;
    const bool is_same_region = image.no_rays == 0.0 && std::abs(image.region - fit.coverage.scored) <= kShareTolerance;
    if (!is_as_written || !is_same_region) continue;
    image.rms = fit.error.rms;
    image.p99 = fit.error.p99;
    image.max = fit.error.max;
  }
}

}  // namespace

std::jthread prepare_programs(const Format& format) {
  const auto needs_preparation = [&format](const consumers::Consumer& each) {
    return each.prepare != nullptr && each.format == format.id;
  };
  const auto programs = consumers::all_consumers();
  const auto program = std::ranges::find_if(programs, needs_preparation);
  return program == programs.end() ? std::jthread() : in_background(program->prepare);
}

Message newly_refused(const Written& written, const Rig& rig, const text::Document* base, LoadedViews& views) {
  const consumers::LoadOptions options = load_options(written, rig);
  for (const Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const std::optional<consumers::Complaint> refusal = first_refusal(file.document.bytes(), id, options, views);
      if (refusal && (base == nullptr || refusal != first_refusal(base->source().bytes, id, options, views)))
        return refusal->facts;
    }
  }
  return {};
}

bool fix_kept_text(const Format& format, const Rig& rig, Written& written, LoadedViews& views, Diagnostics& diagnostics) {
  constexpr int kMaxFixes = 100;  // of one file: each fix takes several runs of the program's reader
  const consumers::LoadOptions options = load_options(written, rig);
  bool all_load = true;
  for (Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const consumers::Consumer* program = consumers::find_consumer(id);
      if (program == nullptr) continue;
      text::Document document = file.document;
      Diagnostics fixes;
      std::optional<consumers::Complaint> refusal;
      consumers::ConsumerView tried;
      const AskProgram ask = [&](const std::string& bytes) { return tried = program->load(bytes, options); };
      for (int i = 0; i < kMaxFixes; ++i) {
        const consumers::ConsumerView& view = views.of(*program, document.bytes(), options);
        refusal = view.loads() ? std::nullopt : std::optional(view.refusals.front());
        all_load = all_load && !refusal;
        const std::optional<Fix> fix = refusal ? find_fix(document, view, *refusal, ask) : std::nullopt;
        if (!fix) break;
        std::vector<Message> remedy;
        if (!names_fix(refusal->facts, *fix)) remedy.push_back({Code::kFixedHow, {fix->remedy}});
        fixes.add(Code::kFixed, {refusal->facts, remedy}, document.source().range(fix->span));
        document.replace(fix->span, fix->text);
        views.add(*program, document.bytes(), options, std::exchange(tried, {}));
      }
      if (refusal) continue;
      if (fixes.entries().empty()) continue;
      file.document = std::move(document);
      file.says = read_back(format, file, rig, written);
      for (const Diagnostic& each : fixes.entries()) diagnostics.add(each);
    }
  }
  return all_load;
}

void warn_if_refused(const Calibration& calibration, const Inputs& inputs, Diagnostics& diagnostics) {
  const std::size_t main_file = calibration.with_cameras;
  const text::Source& source = calibration.documents[main_file].source();
  // A file of joined ones may contain poses but no cameras: the readers of files without cameras are asked then.
  const std::optional<Rig> own_rig = calibration.documents.size() > 1 ? rig_alone(calibration, main_file) : std::nullopt;
  const bool has_cameras = own_rig ? !own_rig->cameras.empty() : !calibration.rig.cameras.empty();
  const Message refusal = refused_by_all(calibration.format->id, source.bytes, has_cameras, load_options(read_options(inputs)));
  if (refusal.is_said()) diagnostics.add(Code::kInputRefused, {source.name, refusal});
}

void verify(const Rig& rig, const ConvertedFile& output, const ConvertRequest& request, const Written& written,
            const text::Document* base, LoadedViews& views, ConvertResult& result) {
  bool has_program = false;
  std::vector<CalibratedCamera> calibrated;
  calibrated.reserve(result.cameras.size());
  for (const ConvertedCamera& camera : result.cameras) {
    calibrated.emplace_back().camera = camera.source;
    if (camera.report && camera.report->turn) calibrated.back().T_written_camera = camera.report->turn->T_target_source;
    const bool is_partial_fit = camera.report && camera.report->angle_reduced;
    if (is_partial_fit) calibrated.back().fitted_to_rad = camera.report->scored_to_deg * std::numbers::pi / 180.0;
  }
  for (const std::string& id : output.programs) {
    const consumers::Consumer* consumer = consumers::find_consumer(id);
    if (consumer == nullptr) continue;
    has_program = true;
    consumers::LoadOptions options = load_options(written, rig);
    options.file_name = name_for(*consumer, output, request);
    ProofResult proof = prove(
        *consumer, views.of(*consumer, output.bytes, options), rig, output.cameras,
        request.inputs.max_angle_rad.value_or(std::numbers::pi),
        [&request](std::size_t count, const auto& body) { parallel_for(count, request.jobs, body); }, calibrated);
    proof.is_first = id == output.programs.front();
    use_errors_of_fits(result.cameras, proof);
    if (!proof.loads && base != nullptr && consumer != request.program)
      proof.read_by = other_readers(*consumer, output, options, views);
    const std::string program(consumer->program);
    const bool is_unchanged = base != nullptr && output.bytes == base->source().bytes;
    const bool refused_before = base != nullptr && !proof.loads && (is_unchanged || !request.into.empty()) &&
                                first_refusal(base->source().bytes, id, options, views) == proof.refusals.front();
    if (refused_before) result.refused_before.push_back(program);
    if (!proof.agrees() && is_unchanged) {
      result.diagnostics.add(Code::kInputNotUnderstood, {program, disagreement(proof)});
    } else if (refused_before) {
      result.diagnostics.add(Code::kEditNotProven, {program, proof.refusals.front().facts, request.into});
    } else if (!proof.agrees()) {
      const bool is_edit_of_into = !request.into.empty() && !proof.loads;
      const Code reason = proof.loads ? Code::kVerdictNumbersDiffer : Code::kVerdictRefused;
      const bool is_accepted =
          !proof.read_by.empty() ||
          std::ranges::any_of(request.accepted, [reason](const Acceptance& each) { return same_id(each.code, reason); });
      result.diagnostics.add(is_accepted ? Severity::kWarning : Severity::kError,
                             is_edit_of_into ? Code::kProofOfBaseFailed : Code::kProofFailed,
                             {program, disagreement(proof), request.into});
      if (!is_accepted) result.status = worse(result.status, Status::kRejected);
    }
    result.proofs.push_back(std::move(proof));
  }
  if (has_program) return;
  result.unproven.push_back(output.path);
  std::vector<Message> path_clause;
  if (!output.path.empty()) path_clause.push_back({Code::kOfPath, {output.path}});
  result.diagnostics.add(Code::kNotProven, {path_clause, result.to->program});
}

}  // namespace fca
