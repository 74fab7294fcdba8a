// SPDX-License-Identifier: BSD-3-Clause
#include "start.h"

#include "input_checks.h"
#include "proving.h"

#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace fca {

namespace {

/// What the checks find in the file with the cameras, before anything of it is changed.
std::vector<Finding> findings_of(const Calibration& calibration, const ConvertRequest& request, const Format& to,
                                 const Diagnostics& diagnostics) {
  CheckOptions options;
  options.reading = read_options(request.inputs);
  options.from = calibration.format;
  options.max_angle_rad = request.inputs.max_angle_rad;
  return findings_about_meaning(calibration.documents[calibration.with_cameras], calibration, diagnostics, options, to);
}

/// Of more cameras than the target's program uses it takes the stereo pair. A choice of the user's stays, and a file of the
/// target's own format says itself which cameras come first.
void put_pair_first(const ConvertRequest& request, const Format& to, Calibration& input) {
  constexpr std::size_t kPair = 2;
  std::vector<Camera>& cameras = input.rig.cameras;
  if (to.most_cameras != kPair || cameras.size() <= kPair || request.inputs.cameras || input.format == &to) return;
  const auto pair = stereo_pair(input.rig);
  if (!pair) return;
  std::ranges::rotate(cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(pair->first),
                      cameras.begin() + static_cast<std::ptrdiff_t>(pair->first) + 1);
  std::ranges::rotate(cameras.begin() + 1, cameras.begin() + static_cast<std::ptrdiff_t>(pair->second),
                      cameras.begin() + static_cast<std::ptrdiff_t>(pair->second) + 1);
}

}  // namespace

bool read_start(const ConvertRequest& request, Files& files, Start& start, std::jthread& programs, ConvertResult& result) {
  if (!request.into.empty()) {
    start.into = read_into(request, files, result);
    if (!start.into) return false;
  }
  result.to = start.into ? start.into->format : request.to;
  if (const Message problem = without_use(request, *result.to); problem.is_said()) {
    result.diagnostics.add(problem.code, problem.arguments);
    result.status = Status::kBadRequest;
    return false;
  }
  if (request.verify) programs = prepare_programs(*result.to);
  std::optional<Calibration> input = read_as_stated(request.inputs, files, result.diagnostics);
  if (!input) return false;
  start.findings = findings_of(*input, request, *result.to, result.diagnostics);
  if (!apply_choices(request.inputs, files, *input, result.diagnostics)) return false;
  put_pair_first(request, *result.to, *input);
  start.input = *std::move(input);
  result.from = start.input.format;
  result.one_format = start.input.one_format;
  if (!serves(request, start.input, result)) return false;
  if (start.into && !has_use_for(*start.into, start.input.rig, request.inputs.files.front(), result)) return false;
  start.base = base_of(request, start.input, start.into, *result.to);
  return true;
}

}  // namespace fca
