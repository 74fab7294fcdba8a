// SPDX-License-Identifier: BSD-3-Clause
#include "check/preview.h"

#include <fca/code.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/verdict.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/check.h>
#include <fca/toolkit/programs.h>

#include <algorithm>

namespace fca {

namespace {

/// The options of the check. `with_cameras`: which reader of the request's program is asked, the one of files with cameras or
/// the one of files without.
CheckOptions options_for(const CheckRequest& request, bool with_cameras) {
  CheckOptions options;
  options.reading = read_options(request.inputs);
  options.reading.join = false;
  options.from = request.inputs.format;
  options.max_angle_rad = request.inputs.max_angle_rad;
  options.parts = true;
  options.ignored = request.ignored;
  if (request.program != nullptr) options.program = &reader_of(*request.program, with_cameras);
  return options;
}

/// True if the check found that the request's program does not read the format of the file.
bool is_for_another_format(const CheckReport& report) {
  return std::ranges::any_of(report.findings,
                             [](const Finding& finding) { return finding.facts.code == Code::kProgramOtherFormat; });
}

/// The preview of a fresh file of the same format, written for the program that reads the checked file. nullopt unless that
/// program misreads a camera of the checked file noticeably and reads the fresh file better.
std::optional<ConvertResult> preview_of_better_file(const CheckResult& checked, const CheckRequest& request, Files& files) {
  const CheckReport& report = checked.report;
  if (!report.proof || !report.proof->loads || report.format->layouts.empty() || checked.source.name == text::kStandardInput)
    return std::nullopt;
  constexpr double kNoticeablePx = 0.25;  // a smaller largest distance between the pixels of a camera is not reported
  double worst_px = 0.0;
  for (const CameraProof& camera : report.proof->cameras) {
    if (camera.misread) worst_px = std::max(worst_px, camera.distance.decisive().max);
  }
  if (worst_px <= kNoticeablePx) return std::nullopt;
  const auto programs = consumers::all_consumers();
  const auto program = std::ranges::find(programs, report.proof->program, &consumers::Consumer::program);
  if (program == programs.end()) return std::nullopt;
  ConvertResult other = preview_conversion(checked.source.name, request.inputs, *program, files, true);
  if (other.status != Status::kDone) return std::nullopt;
  const bool is_better =
      other.verdict.word < report.verdict.word || (other.verdict.word == report.verdict.word && other.max_px <= kNoticeablePx);
  return is_better ? std::optional(std::move(other)) : std::nullopt;
}

/// True if the file contains no lens: it has no cameras, or the program reports it as a file of poses between cameras.
bool has_no_lens(const CheckReport& report) {
  if (report.holds_no_camera) return true;
  return report.proof && std::ranges::any_of(report.proof->refusals, [](const consumers::Complaint& refusal) {
           return refusal.facts.code == Code::kColmapSaysRigFile;
         });
}

}  // namespace

CheckResult check(const CheckRequest& request, const text::Source& source, Files& files) {
  CheckResult result{source, check_file(source, options_for(request, true))};
  if (result.report.holds_no_camera && request.program != nullptr)
    result.report = check_file(source, options_for(request, false));
  if (request.program != nullptr && source.name != text::kStandardInput && is_for_another_format(result.report))
    result.instead = preview_conversion(source.name, request.inputs, *request.program, files);
  result.is_opened = request.program == nullptr || !request.program->writing.lenses_alone || !has_no_lens(result.report);
  if (request.program == nullptr) result.instead = preview_of_better_file(result, request, files);
  return result;
}

std::optional<text::Source> with_fixes(const CheckRequest& request, const text::Source& source) {
  const bool with_cameras = !check_file(source, options_for(request, true)).holds_no_camera;
  return fixed_source(source, options_for(request, with_cameras));
}

}  // namespace fca
