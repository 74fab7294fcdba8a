// SPDX-License-Identifier: BSD-3-Clause
// What a comparison comes to, in one line.
#include "compare_command.h"
#include "shell/difference_words.h"
#include "shell/option_hints.h"
#include "shell/words.h"
#include "toolkit/compare/difference_facts.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace fca::cli {

namespace {

std::string in_tenths(double degrees) { return fixed(degrees, 1) + " deg"; }

bool same(const CameraComparison& camera) {
  const CameraDifference& difference = camera.decisive();
  return camera.identical || difference.same_to_deg >= difference.statistics.coverage.max_angle_deg;
}

/// "the cameras are the same (within 0.12 px)"
std::string same_cameras(const std::vector<CameraComparison>& cameras) {
  double worst = 0.0;
  for (const CameraComparison& camera : cameras) worst = std::max(worst, camera.decisive().statistics.error.max);
  const std::string what = cameras.size() == 1 ? "the same camera" : "the same cameras";
  return worst == 0.0 ? what : what + ", within " + pixels(worst) + " px";
}

/// ", and has no pixel for 3 % of the image"; empty where nobody notices.
std::string lost_in_words(const ErrorStatistics& statistics) {
  constexpr double kNoticeable = 5e-4;
  const double lost = statistics.coverage.unrepresentable;
  return lost > kNoticeable ? ", and has no pixel for " + percent(lost) + " of the image" : "";
}

/// "cam0 is up to 4.2 px off"
std::string different_camera(const CameraComparison& camera) {
  const CameraDifference& difference = camera.counted();
  if (!(difference.statistics.coverage.scored > 0.0)) return camera.other + " shares no ray with the reference's";
  constexpr double kNoticeable = 1.0;
  std::string text = camera.other + " ";
  if (difference.same_to_deg >= kNoticeable) {
    text += "is the same camera up to " + in_tenths(difference.same_to_deg) + " from the axis, beyond ";
  } else {
    text += "is ";
  }
  const std::string most = pixels(difference.statistics.error.max, camera.size);
  const bool is_held = difference.statistics.error.max <= std::hypot(camera.size.width, camera.size.height);
  text += (is_held ? "up to " : "") + most + " px off";
  text += lost_in_words(difference.statistics);
  const CameraDifference* rotated = camera.counted_rotated();
  if (rotated == nullptr) return text;
  // The best rotation makes the rms smallest; the largest error may grow by it.
  const double before = difference.statistics.error.rms;
  const double after = rotated->statistics.error.rms;
  constexpr double kExplains = 0.5;
  if (after < kExplains * before) {
    text += ", rms " + pixels(before, camera.size) + " (" + pixels(after, camera.size) + " with a turn of " +
            angle_text(camera.rotated->angle_rad) + " undone)";
  }
  return text;
}

/// "for images of 256 x 256 px, the reference's have 512 x 512"; empty where the sizes are the same.
std::string resolutions(const std::vector<CameraComparison>& cameras) {
  const auto scaled =
      std::ranges::find_if(cameras, [](const CameraComparison& camera) { return camera.other_size.has_value(); });
  if (scaled == cameras.end()) return "";
  return "for images of " + size_in_words(*scaled->other_size) + " px, the reference's have " + size_in_words(scaled->size);
}

/// Below that part of what counts as alike a difference is mere rounding.
constexpr double kRounding = 1e-6;

bool is_real(const PoseComparison& pose) { return pose.apart() >= kRounding; }
bool is_real(const FactComparison& fact) { return fact.apart() >= kRounding; }

/// Does anything differ by more than rounding?
bool any_is_real(const ComparedFile& compared) {
  const auto is_real_camera = [](const CameraComparison& camera) {
    return !same(camera) || camera.decisive().statistics.error.max >= kRounding * kSamePx;
  };
  const RigComparison& comparison = *compared.comparison;
  return inverses_differ(compared) || std::ranges::any_of(comparison.cameras, is_real_camera) ||
         std::ranges::any_of(comparison.poses, [](const PoseComparison& pose) { return is_real(pose); }) ||
         std::ranges::any_of(comparison.facts, [](const FactComparison& fact) { return is_real(fact); });
}

/// The poses furthest apart.
std::string different_poses(const std::vector<PoseComparison>& poses) {
  const auto angle_of = [](const PoseComparison& pose) { return pose.decisive().angle_rad; };
  const auto distance_of = [](const PoseComparison& pose) { return pose.decisive().distance_m; };
  const auto angle = std::ranges::max_element(poses, {}, angle_of);
  const auto distance = std::ranges::max_element(poses, {}, distance_of);
  const auto name = [](const PoseComparison& pose) { return "T_" + pose.a + "_" + pose.b; };
  constexpr double kNothing = 1e-9;  // rad, m
  const bool is_turned = angle_of(*angle) > kNothing;
  const bool is_moved = distance_of(*distance) > kNothing;
  if (angle == distance || !is_turned || !is_moved) {
    return text::text_of(facts_of(is_moved ? *distance : *angle), with_options);
  }
  return name(*angle) + " differs by " + angle_text(angle_of(*angle)) + ", " + name(*distance) + " by " +
         length_text(distance_of(*distance));
}

/// One for each kind: "cam0 has ... (cam1 as well)".
std::vector<std::string> sentences(const std::vector<Mistake>& mistakes) {
  std::vector<std::string> result;
  for (auto first = mistakes.begin(); first != mistakes.end(); ++first) {
    const auto like_first = [&first](const Mistake& mistake) { return mistake.is_like(*first); };
    if (std::find_if(mistakes.begin(), first, like_first) != first) continue;
    std::vector<std::string> others;
    for (auto other = std::next(first); other != mistakes.end(); ++other) {
      if (like_first(*other)) others.push_back(subject_of(*other));
    }
    result.push_back(sentence(*first) + (others.empty() ? "" : " (" + enumerated(others, "and") + " as well)"));
  }
  return result;
}

double distance_from_zero(const std::array<double, 3>& metres) { return std::hypot(metres[0], metres[1], metres[2]); }

/// " (of pixels up to 30.0 deg from the axis)"; empty where all rays count.
std::string focus_in_words(const std::vector<CameraComparison>& cameras) {
  double furthest = 0.0;
  for (const CameraComparison& camera : cameras) {
    if (camera.focus && !camera.identical) furthest = std::max(furthest, camera.focus->max_angle_deg);
  }
  return furthest > 0.0 ? " (of pixels up to " + in_tenths(furthest) + " from the axis)" : "";
}

/// One clause of the verdict.
struct Part {
  std::string text;
  double apart = std::numeric_limits<double>::infinity();  ///< In units of what counts as alike; 0 of what is the same.
};

/// What the cameras, poses and numbers come to.
std::vector<Part> parts_of(const ComparedFile& compared, const std::string& of_inverse) {
  const RigComparison& comparison = *compared.comparison;
  const bool without_rounding = any_is_real(compared);
  std::vector<Part> parts;
  if (const std::string sizes = resolutions(comparison.cameras); !sizes.empty()) parts.push_back({sizes});
  const bool all_same = std::ranges::all_of(comparison.cameras, same);
  if (all_same && !comparison.cameras.empty()) parts.push_back({same_cameras(comparison.cameras), 0.0});
  for (const CameraComparison& camera : comparison.cameras) {
    if (camera.turn_cancels) parts.push_back({cancelled_turn_in_words(camera)});
    if (!same(camera) && !camera.turn_cancels) parts.push_back({different_camera(camera)});
  }
  if (!of_inverse.empty()) parts.push_back({of_inverse});
  const auto same_pose = [without_rounding](const PoseComparison& pose) {
    if (pose.remaining) return !is_real(pose);
    return pose.same_but_for_rounding() || (without_rounding && !is_real(pose));
  };
  if (std::ranges::all_of(comparison.poses, same_pose)) {
    if (!comparison.poses.empty()) parts.push_back({"the same poses", 0.0});
  } else {
    const double apart = std::ranges::max(comparison.poses, {}, &PoseComparison::apart).apart();
    parts.push_back({different_poses(comparison.poses), apart});
  }
  for (const FactComparison& fact : comparison.facts) {
    if (fact.same_but_for_rounding() || (without_rounding && !is_real(fact))) continue;
    parts.push_back({text::text_of(facts_of(fact), with_options), fact.apart()});
  }
  return parts;
}

/// The three that differ most, in their order.
std::string in_one_line(const std::vector<Part>& parts) {
  constexpr std::size_t kMost = 3;
  std::vector<std::size_t> shown(parts.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  std::ranges::stable_sort(shown, std::greater(), [&parts](std::size_t i) { return parts[i].apart; });
  shown.resize(std::min(kMost, shown.size()));
  std::ranges::sort(shown);
  std::string text;
  for (const std::size_t i : shown) text += (text.empty() ? "" : "; ") + parts[i].text;
  return parts.size() > kMost ? text + "; and " + std::to_string(parts.size() - kMost) + " more" : text;
}

}  // namespace

std::string verdict_of(const ComparedFile& compared) {
  if (compared.status > Status::kRejected) {
    const auto& entries = compared.diagnostics.entries();
    return "not compared: " + message_of(*std::ranges::find(entries, Severity::kError, &Diagnostic::severity), with_options);
  }
  const RigComparison& comparison = *compared.comparison;
  const bool inverse = inverses_differ(compared);
  const std::string of_inverse =
      inverse ? "the inverse polynomials (world2cam) differ by up to " + pixels(*compared.inverse_px) + " px" : "";
  std::vector<Part> parts;
  if (!comparison.mistakes.empty()) {
    for (std::string& mistake : sentences(comparison.mistakes)) parts.push_back({std::move(mistake)});
    if (inverse) parts.push_back({of_inverse});
  } else if (comparison.identical()) {
    if (inverse) return "the same directions, but " + of_inverse;
    const bool all = comparison.only_in_reference.empty() && comparison.only_in_other.empty();
    return all ? "the same" : "the same in all that both contain";
  } else {
    parts = parts_of(compared, of_inverse);
  }
  const std::string text = in_one_line(parts);
  const bool assumed = std::ranges::any_of(
      comparison.cameras, [](const CameraComparison& camera) { return camera.size_assumed && !camera.identical; });
  return text + focus_in_words(comparison.cameras) + (assumed ? " (for an assumed image size)" : "");
}

std::string cancelled_turn_in_words(const CameraComparison& camera) {
  const ErrorStatistics& statistics = camera.decisive().statistics;
  const ErrorSummary& remains = statistics.error;
  return camera.other + ": turned by " + angle_text(camera.rotated->angle_rad) +
         (camera.rotated->distance_m ? " and moved by " + length_text(distance_from_zero(camera.rotated->centre_m)) : "") +
         ", and its poses turn back: they cancel; " + pixels(remains.rms, camera.size) + " px rms remain" +
         (remains.max > kSamePx ? " (at most " + pixels(remains.max, camera.size) + " px)" : "") + lost_in_words(statistics);
}

std::string rotation_in_words(const BestRotation& rotation) {
  struct Axis {
    double radians;
    const char* positive;
    const char* negative;
  };
  // Ahead is z: about x (right) it goes up, about y (down) to the right; about z, right goes down.
  const std::array axes = {Axis{rotation.vector_rad[1], "to the right", "to the left"},
                           Axis{rotation.vector_rad[0], "up", "down"},
                           Axis{rotation.vector_rad[2], "clockwise", "counter-clockwise"}};
  std::vector<std::string> parts;
  for (const Axis& axis : axes) {
    // A hundredth of the whole says nothing.
    if (std::abs(axis.radians) < 0.01 * rotation.angle_rad || axis.radians == 0.0) continue;
    parts.push_back(text::format_short(std::abs(axis.radians) * kDegreesPerRadian, 3) + " deg " +
                    (axis.radians > 0.0 ? axis.positive : axis.negative));
  }
  const std::string turn = angle_text(rotation.angle_rad) + (parts.empty() ? "" : ": its rays lie " + enumerated(parts, "and"));
  if (!rotation.distance_m) return turn;
  const auto millimetres = [&rotation](std::size_t i) { return text::format_short(1000.0 * rotation.centre_m.at(i), 3); };
  return turn + "; its projection centre is x " + millimetres(0) + ", y " + millimetres(1) + ", z " + millimetres(2) +
         " mm from REF's, for points " + text::format_short(*rotation.distance_m, 4) + " m away";
}

}  // namespace fca::cli
