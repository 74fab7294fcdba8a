// SPDX-License-Identifier: BSD-3-Clause
#include <fca/compare/compare.h>

#include "best_rotation.h"
#include "camera_difference.h"
#include "fact_comparison.h"
#include "folded_turns.h"
#include "matching.h"
#include "mistaken_camera.h"
#include "pose_comparison.h"

#include <fca/code.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <string_view>

namespace fca {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// The two cameras for images of one size: the reference's.
struct CameraPair {
  Camera reference;
  Camera other;
  std::optional<ImageSize> scaled_from;
  double scale = 1.0;  ///< Reference's pixels per pixel of the other.
  bool size_assumed = false;
};

/// The image whose middle is that principal point: what is likely where nothing specifies a size.
ImageSize image_about(const Pixel& centre) {
  constexpr double kLargest = 20'000.0;  // of any sensor; also where the principal point is nonsense
  const auto side = [kLargest](double middle) {
    return static_cast<int>(std::clamp(std::round(2.0 * middle + 1.0), 1.0, kLargest));
  };
  return ImageSize{side(centre[0]), side(centre[1])};
}

std::optional<CameraPair> at_one_size(const Camera& reference, const Camera& other, Diagnostics& diagnostics) {
  CameraPair pair{reference, other, {}};
  if (!pair.reference.image_size) pair.reference.image_size = other.image_size;
  if (!pair.reference.image_size) {
    pair.reference.image_size = image_about(principal_point(reference.model));
    pair.size_assumed = true;
  }
  if (!pair.other.image_size) pair.other.image_size = pair.reference.image_size;
  if (pair.reference.image_size == pair.other.image_size) return pair;
  const ImageSize& right = *pair.reference.image_size;
  const ImageSize& left = *pair.other.image_size;
  if (static_cast<long long>(right.width) * left.height != static_cast<long long>(left.width) * right.height) {
    const bool exchanged = right.width == left.height && right.height == left.width;
    diagnostics.add(Code::kResolutionDiffers, {reference.name, right.width, right.height, left.width, left.height,
                                               Message{exchanged ? Code::kSidesExchanged : Code::kNotScaled}});
    return std::nullopt;
  }
  const std::optional<Camera> scaled = with_changed_images(pair.other, {.resize = right}, diagnostics);
  if (!scaled) return std::nullopt;
  pair.scaled_from = left;
  pair.scale = static_cast<double>(right.width) / left.width;
  pair.other = *scaled;
  return pair;
}

/// Everything a comparison of two cameras needs to go on.
struct PreparedPair {
  CameraPair cameras;
  FieldOfView field_of_view;
  std::optional<FieldOfView> focus = {};  ///< The part of it that counts, if the options name one.
};

/// The field of view up to the angle in focus; nothing with an error where it holds no pixel.
std::optional<FieldOfView> in_focus(const Camera& reference, const CompareOptions& options, Diagnostics& diagnostics) {
  return field_of_view_of(reference, std::min(*options.focus_rad, options.max_angle_rad.value_or(*options.focus_rad)),
                          diagnostics);
}

std::optional<PreparedPair> prepared(const Camera& reference, const Camera& other, const CompareOptions& options,
                                     Diagnostics& diagnostics) {
  std::optional<CameraPair> pair = at_one_size(reference, other, diagnostics);
  if (!pair) return std::nullopt;
  const std::vector<Message> problems = validate(pair->other.model);
  for (const Message& problem : problems) diagnostics.add(Code::kNotACamera, {other.name, problem});
  if (!problems.empty()) return std::nullopt;
  Diagnostics of_field_of_view;
  std::optional<FieldOfView> field_of_view = field_of_view_of(pair->reference, options.max_angle_rad, of_field_of_view);
  const bool same_lens = pair->reference.model == pair->other.model && !pair->scaled_from;
  for (Diagnostic entry : of_field_of_view.entries()) {
    // Of a lens that sees nothing of its image nothing can be measured, but it is the same as itself.
    if (same_lens && entry.facts.code == Code::kNoPixelHasARay) {
      entry.severity = Severity::kWarning;
      field_of_view =
          FieldOfView{*pair->reference.image_size, max_angle(pair->reference.model), Message{Code::kFieldOfViewWithoutRay}};
    }
    diagnostics.add(std::move(entry));
  }
  if (!field_of_view) return std::nullopt;
  PreparedPair result{*std::move(pair), *std::move(field_of_view)};
  if (!options.focus_rad) return result;
  result.focus = in_focus(result.cameras.reference, options, diagnostics);
  return result.focus ? std::optional(std::move(result)) : std::nullopt;
}

std::vector<ParameterComparison> parameters_of(const CameraModel& reference, const CameraModel& other) {
  std::vector<ParameterComparison> rows;
  const bool same_model = model_info(reference).id == model_info(other).id;
  const auto add = [&](const CameraModel& model, bool only_new) {
    for (const Parameter& parameter_of_model : model_info(model).parameters) {
      const ParameterId id(parameter_of_model);
      // Coefficients of the same name are other numbers in another model.
      const bool is_common = same_model || parameter_of_model.group == ParameterGroup::kFocalLength ||
                             parameter_of_model.group == ParameterGroup::kPrincipalPoint;
      if (only_new && is_common && parameter(reference, id)) continue;
      rows.push_back({std::string(parameter_of_model.name), only_new ? std::nullopt : parameter(reference, id),
                      only_new || is_common ? parameter(other, id) : std::nullopt});
    }
  };
  add(reference, false);
  add(other, true);
  return rows;
}

/// The rotation (at a distance, the motion) with which the two come nearest within `region`, and the differences that it
/// leaves.
std::optional<internal::LensTurn> turn_of(const PreparedPair& pair, const FieldOfView& region, std::optional<double> distance_m,
                                          const CompareOptions& options) {
  const CameraModel& reference = pair.cameras.reference.model;
  const CameraModel& other = pair.cameras.other.model;
  const std::optional<Transform> found = internal::best_rotation(reference, other, region, distance_m);
  const std::optional<Transform> T_reference_other = found ? inverse(*found) : std::nullopt;
  if (!T_reference_other) return std::nullopt;
  internal::LensTurn turn;
  BestRotation& best = turn.rotation;
  best.T_other_reference = *found;
  best.vector_rad = rotation_vector(*found);
  best.angle_rad = std::hypot(best.vector_rad[0], best.vector_rad[1], best.vector_rad[2]);
  best.distance_m = distance_m;
  best.centre_m = translation_of(*T_reference_other);
  const internal::ModelPair as_moved = {reference, other, &best.T_other_reference, distance_m};
  const EvaluateOptions unproven = {.every_pixel = options.every_pixel, .bound = false};
  best.difference = internal::difference_of(as_moved, pair.field_of_view, unproven);
  if (pair.focus) turn.in_focus = internal::difference_of(as_moved, *pair.focus, unproven);
  return turn;
}

CameraComparison comparison_of(const PreparedPair& pair, const CompareOptions& options) {
  const Camera& reference = pair.cameras.reference;
  const Camera& other = pair.cameras.other;
  CameraComparison result;
  result.reference = reference.name;
  result.other = other.name;
  result.reference_model = model_info(reference.model).id;
  result.other_model = model_info(other.model).id;
  result.size = pair.field_of_view.size;
  result.size_assumed = pair.cameras.size_assumed;
  result.other_size = pair.cameras.scaled_from;
  result.parameters = parameters_of(reference.model, other.model);
  result.identical = reference.model == other.model && !result.other_size;
  result.scored_to_deg = std::min(pair.field_of_view.max_angle_rad, max_angle(other.model)) * kDegreesPerRadian;
  const EvaluateOptions evaluated = {.every_pixel = options.every_pixel, .bound = options.bound};
  const internal::ModelPair as_they_are = {reference.model, other.model};
  result.difference = internal::difference_of(as_they_are, pair.field_of_view, evaluated);
  if (pair.focus) {
    result.focus = FocusComparison{pair.focus->max_angle_rad * kDegreesPerRadian,
                                   internal::difference_of(as_they_are, *pair.focus, evaluated), std::nullopt};
  }
  if (reference.model == other.model) return result;
  const std::optional<internal::LensTurn> turn =
      turn_of(pair, pair.focus ? *pair.focus : pair.field_of_view, options.distance_m, options);
  if (turn) internal::set_turn(*turn, result);
  return result;
}

/// The turn of the whole lens, whatever part of it and whatever distance the options ask for: a turn that went into a pose is
/// one of all rays.
std::optional<internal::LensTurn> whole_turn_of(const PreparedPair& pair, const CameraComparison& comparison,
                                                const CompareOptions& options) {
  if (!comparison.rotated) return std::nullopt;
  if (!pair.focus && !options.distance_m) return internal::LensTurn{*comparison.rotated, std::nullopt};
  return turn_of(pair, pair.field_of_view, std::nullopt, options);
}

/// The cameras of a rig, matched and, where they can be, prepared.
struct RigPair {
  const Rig& reference;
  const Rig& other;
  internal::Matching matching;
  std::vector<std::optional<PreparedPair>> cameras;  ///< As matching.cameras.
};

/// Two cameras each of whom is what the other should be.
struct Exchange {
  std::size_t first = 0;
  std::size_t second = 0;
  bool lenses = false;
  bool poses = false;
};

bool lenses_exchanged(const RigPair& rigs, std::size_t first, std::size_t second) {
  for (const auto& [here, there] : {std::pair(first, second), std::pair(second, first)}) {
    if (!rigs.cameras[here] || !rigs.cameras[there]) return false;
    const PreparedPair& right = *rigs.cameras[here];
    const PreparedPair& left = *rigs.cameras[there];
    if (right.field_of_view.size != left.field_of_view.size) return false;
    const CameraModel& reference = right.cameras.reference.model;
    const double as_stated = internal::misfit_px(reference, right.cameras.other.model, right.field_of_view);
    const double exchanged = internal::misfit_px(reference, left.cameras.other.model, right.field_of_view);
    if (as_stated <= kSamePx || exchanged > internal::kExplained * as_stated) return false;
  }
  return true;
}

std::optional<Exchange> find_exchange(const RigPair& rigs, const internal::PoseTask& poses) {
  // Rigs have a handful of cameras; a file of hundreds would take minutes.
  constexpr std::size_t kMostCameras = 16;
  const std::size_t count = std::min(kMostCameras, rigs.cameras.size());
  for (std::size_t first = 0; first < count; ++first) {
    for (std::size_t second = first + 1; second < count; ++second) {
      Exchange exchange{first, second, lenses_exchanged(rigs, first, second), false};
      exchange.poses = internal::exchange_explains_poses(poses, first, second);
      // One statement between two cameras says the same exchanged as inverted: then it is called inverted.
      if (exchange.lenses || (exchange.poses && internal::comparable_poses(poses) > 1)) return exchange;
    }
  }
  return std::nullopt;
}

Mistake mistake_of(const Exchange& exchange, const RigPair& rigs) {
  const std::string first = rigs.other.cameras[rigs.matching.cameras[exchange.first].other].name;
  const std::string second = rigs.other.cameras[rigs.matching.cameras[exchange.second].other].name;
  const std::vector<std::string> both = {first, second};
  if (exchange.lenses && exchange.poses) return {{Code::kCamerasExchanged, {both}}};
  return {{exchange.lenses ? Code::kIntrinsicsExchanged : Code::kPosesExchanged, {both}}};
}

void find_mistakes(const RigPair& rigs, const internal::PoseTask& poses, RigComparison& result) {
  const std::optional<Exchange> exchange = find_exchange(rigs, poses);
  if (exchange) result.mistakes.push_back(mistake_of(*exchange, rigs));
  for (std::size_t i = 0; i < rigs.cameras.size(); ++i) {
    if (!rigs.cameras[i] || (exchange && exchange->lenses && (i == exchange->first || i == exchange->second))) continue;
    const PreparedPair& pair = *rigs.cameras[i];
    const auto compared = std::ranges::find(result.cameras, pair.cameras.reference.name, &CameraComparison::reference);
    if (compared->turn_cancels) continue;
    std::optional<Mistake> mistake = internal::mistake_in(pair.cameras.reference, pair.cameras.other, pair.cameras.scale,
                                                          compared->difference, pair.field_of_view);
    if (mistake) result.mistakes.push_back(*std::move(mistake));
  }
  if (exchange && exchange->poses) return;
  for (Mistake& mistake : internal::mistaken_poses(poses)) result.mistakes.push_back(std::move(mistake));
}

/// "2 cameras and 1 IMU"
Message contents_of(const Rig& rig) {
  const auto counted = [](std::size_t count, std::string_view what) {
    return count == 0 ? Message{Code::kNoSuch, {what}} : Message{Code::kSoMany, {count, what}};
  };
  return {Code::kCamerasAndImus, {counted(rig.cameras.size(), "camera"), counted(rig.imus.size(), "IMU")}};
}

template <class Thing>
void list_unmatched(const std::vector<Thing>& things, const std::set<std::size_t>& matched, std::vector<Message>& list) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (!matched.contains(i)) list.push_back({Code::kOnlyThing, {things[i].name}});
  }
}

void list_unmatched(const RigPair& rigs, RigComparison& result) {
  const auto list = [&](const auto& reference, const auto& other, const std::vector<internal::Match>& matches) {
    std::set<std::size_t> right;
    std::set<std::size_t> left;
    for (const internal::Match& match : matches) {
      right.insert(match.reference);
      left.insert(match.other);
    }
    list_unmatched(reference, right, result.only_in_reference);
    list_unmatched(other, left, result.only_in_other);
  };
  list(rigs.reference.cameras, rigs.other.cameras, rigs.matching.cameras);
  list(rigs.reference.imus, rigs.other.imus, rigs.matching.imus);
}

}  // namespace

bool Mistake::is_like(const Mistake& mistake) const {
  const auto rest = [](const Mistake& each) { return std::span(each.message.arguments).subspan(1); };
  return message.code == mistake.message.code && std::ranges::equal(rest(*this), rest(mistake));
}

const CameraDifference* CameraComparison::counted_rotated() const {
  if (focus) return focus->rotated ? &*focus->rotated : nullptr;
  return rotated ? &rotated->difference : nullptr;
}

bool ParameterComparison::same_but_for_rounding() const {
  constexpr double kRounding = 1e-12;
  return reference && other && std::abs(*other - *reference) <= kRounding * std::abs(*reference);
}

bool PoseComparison::same_but_for_rounding() const {
  constexpr double kRounding = 1e-9;
  return angle_rad <= kRounding && distance_m <= kRounding;
}

bool FactComparison::same_but_for_rounding() const {
  constexpr double kRounding = 1e-9;
  return std::abs(other - reference) <= kRounding * std::abs(reference);
}

double FactComparison::apart() const {
  constexpr double kSameTime = 1e-3;  // s
  constexpr double kSameShare = 0.05;
  // Of nothing every other number is infinitely many times as much.
  return other == reference ? 0.0 : std::abs(other - reference) / (unit == "s" ? kSameTime : kSameShare * std::abs(reference));
}

bool RigComparison::identical() const {
  return std::ranges::all_of(cameras, &CameraComparison::identical) &&
         std::ranges::all_of(poses, &PoseComparison::same_but_for_rounding) &&
         std::ranges::all_of(facts, [](const FactComparison& fact) { return fact.reference == fact.other; });
}

std::optional<CameraComparison> compare(const Camera& reference, const Camera& other, const CompareOptions& options,
                                        Diagnostics& diagnostics) {
  const std::optional<PreparedPair> pair = prepared(reference, other, options, diagnostics);
  if (!pair) return std::nullopt;
  return comparison_of(*pair, options);
}

RigComparison compare(const Rig& reference, const Rig& other, const CompareOptions& options, Diagnostics& diagnostics) {
  RigComparison result;
  RigPair rigs{reference, other, internal::match(reference, other, options.by_order), {}};
  std::vector<std::optional<internal::LensTurn>> turns;  // as result.cameras
  for (const internal::Match& match : rigs.matching.cameras) {
    rigs.cameras.push_back(prepared(reference.cameras[match.reference], other.cameras[match.other], options, diagnostics));
    if (!rigs.cameras.back()) continue;
    const PreparedPair& pair = *rigs.cameras.back();
    result.cameras.push_back(comparison_of(pair, options));
    turns.push_back(whole_turn_of(pair, result.cameras.back(), options));
  }
  const internal::PoseTask poses(reference, other, rigs.matching);
  internal::compare_poses(poses, result);
  internal::compare_facts(reference, other, rigs.matching, result);
  const std::optional<Rig> turned = internal::fold_turns(poses, turns, result);
  find_mistakes(rigs, turned ? internal::PoseTask(*turned, other, rigs.matching) : poses, result);
  list_unmatched(rigs, result);
  if (result.cameras.empty() && result.poses.empty() && result.facts.empty() && !diagnostics.has_errors()) {
    diagnostics.add(Code::kNothingInCommon, {contents_of(reference), contents_of(other)});
  }
  return result;
}

}  // namespace fca
