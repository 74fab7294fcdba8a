// SPDX-License-Identifier: BSD-3-Clause
#include "check/preview.h"

#include <fca/code.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/check.h>
#include <fca/toolkit/programs.h>

#include <algorithm>

namespace fca {

namespace {

/// How a file with cameras, or one without, is checked.
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

/// Is it for a program that reads another format?
bool is_for_another_format(const CheckReport& report) {
  return std::ranges::any_of(report.findings,
                             [](const Finding& finding) { return finding.facts.code == Code::kProgramOtherFormat; });
}

}  // namespace

CheckResult check(const CheckRequest& request, const text::Source& source, Files& files) {
  CheckResult result{source, check_file(source, options_for(request, true)), std::nullopt};
  if (result.report.holds_no_camera && request.program != nullptr)
    result.report = check_file(source, options_for(request, false));
  if (request.program != nullptr && source.name != text::kStandardInput && is_for_another_format(result.report))
    result.instead = preview_conversion(source.name, request.inputs, *request.program, files);
  return result;
}

std::optional<text::Source> with_fixes(const CheckRequest& request, const text::Source& source) {
  const bool with_cameras = !check_file(source, options_for(request, true)).holds_no_camera;
  return mended(source, options_for(request, with_cameras));
}

}  // namespace fca
