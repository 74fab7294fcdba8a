// SPDX-License-Identifier: BSD-3-Clause
#include "start.h"

#include "input_checks.h"
#include "proving.h"

#include <fca/code.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

namespace fca {

namespace {

/// The options of the checks of one input file. `from`: the format of the file.
CheckOptions check_options(const ConvertRequest& request, const Format* from) {
  CheckOptions options;
  options.reading = read_options(request.inputs);
  options.reading.join = false;
  options.from = from;
  options.max_angle_rad = request.inputs.max_angle_rad;
  return options;
}

/// Joining files renames cameras with equal names. Returns a map from the names of one file's cameras to their names in the
/// joined rig. `next`: the index of this file's first camera in `joined`. It becomes the index of the next file's first camera.
std::map<std::string, std::string> joined_names(const Rig& one, const std::vector<Camera>& joined, std::size_t& next) {
  std::map<std::string, std::string> names;
  for (const Camera& camera : one.cameras) {
    const auto begin = joined.begin() + static_cast<std::ptrdiff_t>(next);
    const auto found = std::find_if(begin, joined.end(), [&](const Camera& each) { return each.model == camera.model; });
    if (found == joined.end()) continue;
    next = static_cast<std::size_t>(found - joined.begin()) + 1;
    names[camera.name] = found->name;
  }
  return names;
}

/// Replaces the name of a camera at the start of a finding by its name in the joined rig.
void use_joined_name(const std::map<std::string, std::string>& names, Finding& finding) {
  if (finding.facts.arguments.empty()) return;
  auto* owner = std::get_if<std::string>(&finding.facts.arguments.front().value);
  const auto joined = owner != nullptr ? names.find(*owner) : names.end();
  if (joined != names.end()) *owner = joined->second;
}

/// The findings of the checks of each input file as it was read, without the changes that the request asks for. `diagnostics`:
/// what the readers reported about all files.
std::vector<Finding> findings_of(const Calibration& calibration, const ConvertRequest& request, const Format& to,
                                 const Diagnostics& diagnostics) {
  if (calibration.documents.size() == 1) {
    const CheckOptions options = check_options(request, calibration.format);
    return findings_about_meaning(calibration.documents.front(), calibration, diagnostics, options, to);
  }
  std::vector<Finding> findings;
  std::size_t next_camera = 0;
  for (std::size_t i = 0; i < calibration.documents.size(); ++i) {
    CheckOptions options = check_options(request, calibration.formats[i]);
    std::optional<Calibration> one = alone(calibration, i);
    // The image size in the request is only for files without one.
    if (one && !one->rig.cameras.empty() && one->rig.cameras.front().image_size) options.reading.image_size.reset();
    Diagnostics already_reported;
    if (options.reading.image_size)
      one = read_calibration({calibration.documents[i]}, options.from, options.reading, already_reported);
    if (!one) continue;
    // The diagnostics of the readers are passed only once, with the first file.
    std::vector<Finding> found =
        findings_about_meaning(calibration.documents[i], *one, i == 0 ? diagnostics : Diagnostics{}, options, to);
    const std::map<std::string, std::string> names = joined_names(one->rig, calibration.rig.cameras, next_camera);
    for (Finding& finding : found) use_joined_name(names, finding);
    std::ranges::move(found, std::back_inserter(findings));
  }
  return findings;
}

/// Removes findings about cameras that were not chosen. `read`: all cameras of the input; `rig`: the chosen ones. If only one
/// camera and no IMU was chosen, no pose is written, so that findings about poses are removed too.
void remove_findings_of_others(const std::vector<Camera>& read, const Rig& rig, std::vector<Finding>& findings) {
  const bool is_single_camera = rig.cameras.size() == 1 && rig.imus.empty();
  std::erase_if(findings, [&](const Finding& finding) {
    const auto* owner =
        finding.facts.arguments.empty() ? nullptr : std::get_if<std::string>(&finding.facts.arguments.front().value);
    const bool is_of_camera = owner != nullptr && std::ranges::find(read, *owner, &Camera::name) != read.end();
    const bool is_removed = is_of_camera && rig.find_camera(*owner) == nullptr;
    return is_removed || (is_single_camera && info(code_of(finding)).about == About::kPoses);
  });
}

/// Moves the stereo pair to the front if the target's program uses the first two cameras as a pair. Does nothing if the user
/// chose the cameras or if the input has the target's format: their order is kept.
void put_pair_first(const ConvertRequest& request, const Format& to, Calibration& input) {
  constexpr std::size_t kCamerasOfPair = 2;
  std::vector<Camera>& cameras = input.rig.cameras;
  if (!to.begins_with_pair || cameras.size() <= kCamerasOfPair || request.inputs.cameras || input.format == &to) return;
  const auto pair = stereo_pair(input.rig);
  if (!pair) return;
  std::rotate(cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(pair->first),
              cameras.begin() + static_cast<std::ptrdiff_t>(pair->first) + 1);
  std::rotate(cameras.begin() + 1, cameras.begin() + static_cast<std::ptrdiff_t>(pair->second),
              cameras.begin() + static_cast<std::ptrdiff_t>(pair->second) + 1);
}

/// If poses contradict each other and removing a single one resolves that, removes that pose from the input, so that it is not
/// written. Also removes the diagnostics about it: the verdict reports the pose.
void remove_contradicting_pose(Start& start, Diagnostics& diagnostics) {
  start.outvoted = outvoted_pose(start.rig_of_input);
  if (!start.outvoted) return;
  start.input.rig = without_pose(start.outvoted->loop.edge, std::move(start.input.rig));
  Diagnostics others;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (!reports_contradiction(code_of(entry))) others.add(entry);
  }
  diagnostics = std::move(others);
}

}  // namespace

void add_findings(std::span<const Diagnostic> entries, std::vector<Finding>& findings) {
  for (const Diagnostic& entry : entries) {
    if (entry.severity == Severity::kNote || entry.facts.code == Code::kPoorFit) continue;
    findings.push_back({.severity = entry.severity, .facts = entry.facts, .kind = entry.kind, .remedy = entry.remedy});
  }
}

bool read_start(const ConvertRequest& request, Files& files, Start& start, std::jthread& programs, ConvertResult& result) {
  if (!request.into.empty()) {
    start.into = read_into(request, files, result);
    if (!start.into) return false;
  }
  result.to = start.into ? start.into->format : request.to;
  if (result.to == nullptr) {
    result.diagnostics.add(Code::kNoTarget);
    return false;
  }
  if (const Message problem = without_use(request, *result.to); problem.is_said()) {
    result.diagnostics.add(problem.code, problem.arguments);
    result.status = Status::kBadRequest;
    return false;
  }
  if (request.verify) programs = prepare_programs(*result.to);
  Diagnostics found;  // about the input, not about the base
  std::optional<Calibration> input = read_as_stated(request.inputs, files, found);
  for (const Diagnostic& entry : found.entries()) result.diagnostics.add(entry);
  if (!input) return false;
  start.findings = findings_of(*input, request, *result.to, found);
  const std::vector<Camera> all_cameras = input->rig.cameras;
  const std::size_t before_choices = result.diagnostics.entries().size();
  if (!apply_choices(request.inputs, files, *input, result.diagnostics)) return false;
  // The request may say that the noise is of another kind (imu_noise). If the converted noise has a usual size, the findings
  // about its size in the file no longer apply.
  if (request.inputs.imu_noise && std::ranges::all_of(input->rig.imus, has_usual_noise)) {
    std::erase_if(start.findings, [](const Finding& finding) {
      return finding.facts.code == Code::kImuNoiseTooSmall || finding.facts.code == Code::kImuNoiseTooLarge;
    });
  }
  add_findings(std::span(result.diagnostics.entries()).subspan(before_choices), start.findings);
  if (request.inputs.cameras && input->documents.size() == 1)
    remove_findings_of_others(all_cameras, input->rig, start.findings);
  start.rig_of_input = input->rig;
  put_pair_first(request, *result.to, *input);
  start.input = *std::move(input);
  result.from = start.input.format;
  result.one_format = start.input.one_format;
  if (!input_is_convertible(request, start.input, result)) return false;
  if (start.into && !base_poses_are_known(*start.into, start.input.rig, request.inputs.files.front(), result)) return false;
  start.base = base_of(request, start.input, start.into, *result.to);
  if (start.base.document == nullptr || (request.rewrite && !start.into)) remove_contradicting_pose(start, result.diagnostics);
  return true;
}

}  // namespace fca
