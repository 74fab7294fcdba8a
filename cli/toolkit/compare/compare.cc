// SPDX-License-Identifier: BSD-3-Clause
#include "compare/difference_facts.h"
#include "compare/inverses.h"

#include <fca/code.h>
#include <fca/compare/compare.h>
#include <fca/formats/stated_as.h>
#include <fca/rig/stereo_pair.h>
#include <fca/toolkit/compare.h>

#include <algorithm>
#include <array>
#include <utility>

namespace fca {

namespace {

/// The inputs for reading another file: those of the reference, without its change of images and its lens circles.
Inputs inputs_of(const CompareRequest& request, const std::string& file) {
  Inputs inputs = request.reference;
  inputs.files = {file};
  inputs.parts = request.parts;
  inputs.change = {};
  inputs.lens_circles.clear();
  return inputs;
}

bool says_unit_is_unused(const Diagnostic& entry) { return entry.facts.code == Code::kUnitWithoutUse; }

/// Reads a file with the length unit of `inputs`. If the file contains its own unit, reads it without the unit of `inputs`.
std::optional<Calibration> read_in_unit(Inputs inputs, Files& files, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<Calibration> calibration = read_models(inputs, files, found);
  if (std::ranges::any_of(found.entries(), says_unit_is_unused)) {
    found = {};
    inputs.length_unit_m.reset();
    calibration = read_models(inputs, files, found);
  }
  for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
  return calibration;
}

/// True if the request gives a length unit although both files contain their own.
bool unit_is_without_use(const CompareRequest& request, const Calibration& reference, const Calibration& other) {
  const auto has_unit = [](const Calibration& calibration) {
    return std::ranges::none_of(calibration.formats, [](const Format* format) { return format->any_length_unit; });
  };
  return request.reference.length_unit_m && has_unit(reference) && has_unit(other);
}

/// True if the file has one camera. The choice of cameras in the request then applies only to the reference.
bool has_one_camera(Inputs inputs, Files& files) {
  Diagnostics discarded;
  inputs.cameras.reset();
  const std::optional<Calibration> calibration = read_in_unit(inputs, files, discarded);
  return calibration && calibration->rig.cameras.size() == 1;
}

/// Reads a file to compare with the reference. nullopt with errors.
std::optional<Calibration> read_file(const CompareRequest& request, const std::string& file, Files& files,
                                     Diagnostics& diagnostics) {
  Inputs inputs = inputs_of(request, file);
  const bool one_chosen = inputs.cameras && inputs.cameras->size() == 1;
  if (one_chosen && !is_standard_input(file) && has_one_camera(inputs, files)) inputs.cameras.reset();
  return read_in_unit(inputs, files, diagnostics);
}

/// Replaces the names of poses in messages by the keys that these poses have in the file.
void name_poses_by_keys(const Calibration& calibration, std::vector<Mistake>& mistakes) {
  for (Mistake& mistake : mistakes) {
    if (!mistake.pose) continue;
    const std::string key = key_of_pose(calibration, *mistake.pose);
    if (!key.empty()) mistake.message.arguments.front() = key;
  }
}

/// Adds an error and rejects the file.
void reject(ComparedFile& compared, Code code, std::vector<Argument> arguments = {}) {
  compared.diagnostics.add(code, std::move(arguments));
  compared.status = worse(compared.status, Status::kRejected);
}

/// Rejects the file if cameras differ by more than the limit, or if more than a small share of pixels has no counterpart.
void evaluate_pixels(const CompareRequest& request, const ReferenceFile& reference, ComparedFile& compared) {
  const double limit_px = request.max_error_px.value_or(kSamePx);
  for (const CameraComparison& camera : compared.comparison->cameras) {
    if (camera.identical) continue;
    const ErrorStatistics& statistics = camera.decisive().statistics;
    constexpr double kNoticeableShare = 1e-3;  // share of the image
    const double missing_share = statistics.coverage.unrepresentable;
    if (!(statistics.coverage.scored > 0.0)) {
      reject(compared, Code::kNothingCompared, {camera.other});
      continue;
    }
    if (statistics.error.max > limit_px)
      reject(compared, Code::kDifferenceBeyondLimit, {camera.other, statistics.error.max, limit_px});
    if (missing_share > kNoticeableShare) {
      std::vector<Message> hint;
      if (!request.reference.lens_circles.empty()) hint.push_back({Code::kInPlaceOfCircle});
      reject(compared, Code::kPixelsMissing, {camera.other, missing_share, hint});
    }
  }
  if (reference.calibration->rig.cameras.size() > compared.comparison->cameras.size()) reject(compared, Code::kCamerasMissing);
  if (inverses_differ(compared) && *compared.inverse_px > limit_px)
    reject(compared, Code::kInversesBeyondLimit, {*compared.inverse_px, limit_px});
}

/// Rejects the file if poses, time offsets or IMU values differ, or if it lacks facts of the reference.
void check_other_facts(ComparedFile& compared) {
  const RigComparison& comparison = *compared.comparison;
  for (const PoseComparison& pose : comparison.poses) {
    if (!pose.alike()) reject(compared, Code::kPoseBeyondLimit, {facts_of(pose)});
  }
  for (const FactComparison& fact : comparison.facts) {
    if (!fact.alike()) reject(compared, Code::kFactBeyondLimit, {facts_of(fact)});
  }
  if (!comparison.only_in_reference.empty()) reject(compared, Code::kReferenceSaysMore, {comparison.only_in_reference});
}

/// The errors in the images of the reference's stereo pair if they are rectified with the other calibration. nullopt if the
/// reference has no stereo pair, or if the other calibration does not contain the same pair with the same image sizes.
std::optional<PairError> pair_error_of(const Rig& reference, const Rig& other, const RigComparison& comparison) {
  const auto indices = stereo_pair(reference);
  if (!indices) return std::nullopt;
  const std::array<const Camera*, 2> cameras = {&reference.cameras[indices->first], &reference.cameras[indices->second]};
  std::array<const Camera*, 2> others{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto match = std::ranges::find(comparison.cameras, cameras.at(i)->name, &CameraComparison::reference);
    if (match == comparison.cameras.end()) return std::nullopt;
    others.at(i) = other.find_camera(match->other);
    if (others.at(i) == nullptr || (others.at(i)->image_size && others.at(i)->image_size != cameras.at(i)->image_size))
      return std::nullopt;
  }
  const std::optional<Transform> T = reference.resolve(cameras[1]->name, cameras[0]->name);
  const std::optional<Transform> T_other = other.resolve(others[1]->name, others[0]->name);
  if (!T || !T_other) return std::nullopt;
  return pair_error({*cameras[0], others[0]->model}, {*cameras[1], others[1]->model}, *T, *T_other);
}

/// Rejects the file by the limits of the request.
void apply_limits(const CompareRequest& request, const ReferenceFile& reference, ComparedFile& compared) {
  if (!request.max_error_px && !request.strict) return;
  for (const Mistake& mistake : compared.comparison->mistakes) reject(compared, Code::kMistakeFound, {mistake.message});
  evaluate_pixels(request, reference, compared);
  if (request.strict) check_other_facts(compared);
}

}  // namespace

ReferenceFile read_reference(const CompareRequest& request, Files& files) {
  ReferenceFile reference;
  if (!request.reference.files.empty()) reference.file = request.reference.files.front();
  reference.calibration = read_in_unit(request.reference, files, reference.diagnostics);
  return reference;
}

ComparedFile compare(const CompareRequest& request, const ReferenceFile& reference, const std::string& file, Files& files) {
  ComparedFile compared;
  compared.file = file;
  compared.calibration = read_file(request, file, files, compared.diagnostics);
  if (compared.calibration && unit_is_without_use(request, *reference.calibration, *compared.calibration)) {
    compared.diagnostics.add(Code::kUnitWithoutUse, {compared.calibration->format->title}, {file, 0, 0});
    compared.calibration.reset();
  }
  if (compared.calibration) {
    const CompareOptions options = {.max_angle_rad = request.reference.max_angle_rad,
                                    .every_pixel = request.every_pixel,
                                    .by_order = request.reference.cameras.has_value(),
                                    .focus_rad = request.focus_rad,
                                    .distance_m = request.distance_m};
    compared.comparison = compare(reference.calibration->rig, compared.calibration->rig, options, compared.diagnostics);
    name_poses_by_keys(*compared.calibration, compared.comparison->mistakes);
    compared.pair = pair_error_of(reference.calibration->rig, compared.calibration->rig, *compared.comparison);
    if (request.reference.change.changes_nothing())
      compared.inverse_px = inverse_distance_px(*reference.calibration, *compared.calibration);
  }
  compared.status = status_of(compared.diagnostics);
  if (compared.status == Status::kDone) apply_limits(request, reference, compared);
  return compared;
}

CompareResult compare(const CompareRequest& request, Files& files) {
  CompareResult result;
  result.reference = read_reference(request, files);
  result.status = status_of(result.reference.diagnostics);
  if (!result.reference.calibration) {
    result.status = worse(result.status, Status::kBadInput);
    return result;
  }
  if (request.files.empty()) {
    result.reference.diagnostics.add(Code::kNoInput);
    result.status = Status::kBadRequest;
  }
  for (const std::string& file : request.files) {
    result.files.push_back(compare(request, result.reference, file, files));
    result.status = worse(result.status, result.files.back().status);
  }
  return result;
}

bool inverses_differ(const ComparedFile& compared) {
  if (!compared.inverse_px || !compared.comparison) return false;
  double of_models_px = 0.0;
  for (const CameraComparison& camera : compared.comparison->cameras)
    of_models_px = std::max(of_models_px, camera.identical ? 0.0 : camera.difference.statistics.error.max + kSamePx);
  return *compared.inverse_px > of_models_px;
}

}  // namespace fca
