// SPDX-License-Identifier: BSD-3-Clause
#include "../pose_words.h"
#include "topics.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>
#include <fca/rig/contradictions.h>
#include <fca/rig/pose_slip.h>
#include <fca/rig/rotation.h>
#include <fca/rig/stereo_order.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace fca::checks {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

// Printed with three digits an element is off by 5e-4, and R^T R by 1e-3; with two by 2e-2.
constexpr double kPrintedWithThreeDigits = 2e-3;
constexpr double kPrintedWithTwoDigits = 2e-2;

bool is_rotation(const PoseEdge& edge) {
  return rotation_determinant(edge.T_a_b) > 0.0 && rotation_defect(edge.T_a_b) <= kPrintedWithThreeDigits;
}

void check_rotation(const Subject& subject, std::size_t index, Findings& findings) {
  const PoseEdge& edge = subject.rig().poses[index];
  if (rotation_determinant(edge.T_a_b) < 0.0) {
    findings.add(Code::kPoseLeftHanded, {name_of(edge)}, subject.places.pose(index, 0, 0));
    return;
  }
  if (is_rotation(edge)) return;
  const double defect = rotation_defect(edge.T_a_b);
  const std::optional<Transform> nearest = nearest_rotation(edge.T_a_b);
  if (!nearest) return;
  const ElementDifference worst = largest_difference(edge.T_a_b, *nearest);
  std::vector<Argument> facts = {name_of(edge), defect, worst.distance};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) facts.emplace_back((*nearest)(row, column));
  }
  findings.add(defect > kPrintedWithTwoDigits ? Severity::kError : Severity::kWarning, Code::kPoseNotARotation,
               std::move(facts), subject.places.pose(index, worst.row, worst.column));
}

bool close(const Transform& a, const Transform& b) {
  constexpr double kAngle = 0.5 / kDegreesPerRadian;
  constexpr double kDistance = 5e-3;
  return angle_between(a, b) < kAngle && distance_between(a, b) < std::max(kDistance, 0.05 * distance_of(b));
}

/// But for the digits that were not printed.
bool same(const Transform& a, const Transform& b) {
  constexpr double kPrinted = 1e-6;  // rad, m
  return angle_between(a, b) < kPrinted && distance_between(a, b) < kPrinted;
}

/// A pose of a contradicting loop, and what follows for it from the others.
struct Suspect {
  std::size_t index = 0;
  Transform around;
};

/// Every pose of the loops that the others contradict, in the order in which they were read.
std::vector<Suspect> suspects_in(const Rig& rig, const std::vector<PoseLoop>& loops) {
  std::vector<Suspect> suspects;
  for (const std::size_t i : edges_of(loops)) {
    Rig others;
    others.poses = rig.poses;
    others.poses.erase(others.poses.begin() + static_cast<std::ptrdiff_t>(i));
    const std::optional<Transform> around = others.resolve(rig.poses[i].a, rig.poses[i].b);
    if (around && difference_of(rig.poses[i].T_a_b, *around).contradicts()) suspects.push_back({i, *around});
  }
  return suspects;
}

/// The row of the translation where a wrong unit shows best.
int longest_row(const Transform& T) {
  int longest = 0;
  for (int row = 1; row < 3; ++row) {
    if (std::abs(T(row, 3)) > std::abs(T(longest, 3))) longest = row;
  }
  return longest;
}

/// For formats that state metres: cars are longer than 5 m, but their cameras and IMUs sit closer together; a vehicle's frame
/// may be at its other end.
bool too_far(const Subject& subject, double metres, std::string_view from = {}) {
  constexpr double kLargeRig = 5.0;
  constexpr double kLongVehicle = 20.0;
  const bool vehicle = subject.rig().kind_of(from) == FrameKind::kVehicle;
  return metres > (vehicle ? kLongVehicle : kLargeRig) && !subject.calibration.format->any_length_unit;
}

/// Translations that are too long for metres, and with which alone in millimetres all poses agree: are named.
bool name_millimetres(const Subject& subject, Findings& findings) {
  Rig metric = subject.rig();
  std::vector<std::size_t> in_mm;
  for (std::size_t i = 0; i < metric.poses.size(); ++i) {
    Transform& T = metric.poses[i].T_a_b;
    if (!too_far(subject, distance_of(T), metric.poses[i].a)) continue;
    for (int row = 0; row < 3; ++row) T(row, 3) *= 1e-3;
    in_mm.push_back(i);
  }
  if (in_mm.empty() || in_mm.size() == metric.poses.size()) return false;
  if (pose_loops(metric).empty() || !contradictions(metric).empty() || contradictions(subject.rig()).empty()) return false;
  for (const std::size_t i : in_mm) {
    const PoseEdge& edge = subject.rig().poses[i];
    findings.add(Code::kPoseInMillimetres, {name_of(edge)}, subject.places.pose(i, longest_row(edge.T_a_b), 3));
  }
  return true;
}

/// A slip that explains the contradictions of a pose with the others.
struct Explanation {
  Suspect suspect;
  Code slip = {};
};

std::optional<Explanation> explained(const PoseEdge& edge, const Suspect& suspect) {
  for (const PoseSlip& slip : pose_slips()) {
    const std::optional<Transform> undone = slip.undo(edge.T_a_b);
    if (!undone) continue;
    // A small rotation and its transpose are as near as honest statements are, but then none of them is exact.
    const bool explains = !close(edge.T_a_b, suspect.around) && close(*undone, suspect.around);
    if (explains || same(*undone, suspect.around)) return Explanation{suspect, slip.code};
  }
  return std::nullopt;
}

Rig without_slip(const Rig& rig, const Explanation& explanation) {
  Rig meant = rig;
  meant.poses[explanation.suspect.index].T_a_b = explanation.suspect.around;
  return meant;
}

/// Those of the explanations that are `likely`; all where that is none of them.
template <class Likely>
std::vector<Explanation> preferred(const std::vector<Explanation>& explanations, const Likely& likely) {
  std::vector<Explanation> left;
  std::ranges::copy_if(explanations, std::back_inserter(left), likely);
  return left.empty() ? explanations : left;
}

/// Does it leave cameras as far from each other as those of a rig are?
bool leaves_a_rig(const Explanation& each) {
  constexpr double kNarrowest = 1e-3;  // m
  constexpr double kWidest = 5.0;
  const double metres = distance_of(each.suspect.around);
  return metres > kNarrowest && metres < kWidest;
}

void report_slip(const Subject& subject, const Explanation& explanation, Findings& findings) {
  const std::size_t index = explanation.suspect.index;
  const PoseEdge& edge = subject.rig().poses[index];
  const bool of_translation = explanation.slip == Code::kPoseInMillimetres || explanation.slip == Code::kPoseInKilometres;
  findings.add(explanation.slip, {name_of(edge)},
               of_translation ? subject.places.pose(index, longest_row(edge.T_a_b), 3) : subject.places.pose(index, 0, 0));
}

/// Reports the slip of one pose that explains contradictions; `meant` gets the pose that follows from the others.
/// Where slips of several would, and the order of a stereo pair does not decide, that is an open question.
bool explain_one(const Subject& subject, const std::vector<PoseLoop>& loops, Rig& meant, Findings& findings) {
  const std::vector<PoseEdge>& stated = subject.rig().poses;
  std::vector<Explanation> explanations;
  for (const Suspect& suspect : suspects_in(meant, loops)) {
    if (meant.poses[suspect.index] != stated[suspect.index]) continue;  // reported before
    if (const auto explanation = explained(stated[suspect.index], suspect)) explanations.push_back(*explanation);
  }
  explanations = preferred(explanations, leaves_a_rig);
  explanations = preferred(
      explanations, [&meant](const Explanation& each) { return !second_left_of_first(without_slip(meant, each)).has_value(); });
  if (explanations.size() > 1) {
    std::vector<std::string> names;
    names.reserve(explanations.size());
    for (const Explanation& each : explanations) names.push_back(name_of(stated[each.suspect.index]));
    findings.undecided(Code::kWrongPoseUndecided, {names});
  }
  if (explanations.size() != 1) return false;
  report_slip(subject, explanations.front(), findings);
  meant = without_slip(meant, explanations.front());
  return true;
}

/// The slip of all poses to an IMU: who writes one the wrong way round writes each of them so. Where undoing them all closes
/// every loop, each is reported.
bool explain_all_of_imu(const Subject& subject, const std::vector<PoseLoop>& loops, Findings& findings) {
  const Rig& rig = subject.rig();
  const auto is_explained = [&rig](const Suspect& each) { return explained(rig.poses[each.index], each).has_value(); };
  if (std::ranges::any_of(suspects_in(rig, loops), is_explained)) return false;  // one alone is the simpler reason
  std::vector<std::size_t> of_imu;
  for (std::size_t i = 0; i < rig.poses.size(); ++i) {
    const auto is_imu = [&rig](const std::string& frame) { return rig.kind_of(frame) == FrameKind::kImu; };
    if (is_imu(rig.poses[i].a) || is_imu(rig.poses[i].b)) of_imu.push_back(i);
  }
  if (of_imu.size() < 2) return false;
  for (const PoseSlip& slip : pose_slips()) {
    Rig meant = rig;
    const bool undone = std::ranges::all_of(of_imu, [&](std::size_t i) {
      const std::optional<Transform> T = slip.undo(rig.poses[i].T_a_b);
      if (T) meant.poses[i].T_a_b = *T;
      return T.has_value();
    });
    const auto is_closed = [](const PoseLoop& loop) {
      constexpr double kPrinted = 1e-5;  // rad, m
      return loop.difference.angle_rad < kPrinted && loop.difference.distance_m < kPrinted;
    };
    if (!undone || !std::ranges::all_of(pose_loops(meant), is_closed)) continue;
    for (const std::size_t i : of_imu) report_slip(subject, {{i, meant.poses[i].T_a_b}, slip.code}, findings);
    return true;
  }
  return false;
}

/// Millimetres that were read as metres and scaled once more, or an identity that nobody has filled in. Two cameras behind one
/// lens are at 0, but for rounding, and turned.
void check_too_close(const Subject& subject, std::size_t index, Findings& findings) {
  constexpr double kRounding = 1e-6;   // m
  constexpr double kNarrowest = 1e-3;  // m; telephones' lenses are 8 mm apart
  const PoseEdge& edge = subject.rig().poses[index];
  const double metres = distance_of(edge.T_a_b);
  const auto is_camera = [&](const std::string& frame) { return subject.rig().find_camera(frame) != nullptr; };
  const bool is_behind_one_lens = metres <= kRounding && edge.T_a_b != Transform();
  if (is_behind_one_lens || metres >= kNarrowest || !is_camera(edge.a) || !is_camera(edge.b)) return;
  findings.add(Code::kCamerasTooClose, {name_of(edge), 1000.0 * metres},
               subject.places.pose(index, longest_row(edge.T_a_b), 3));
}

constexpr double kLargestRig = 50.0;  // m

/// `facts`: the metres first.
void say_distance(double metres, Code code, std::vector<Argument> facts, const SourceRange& where, Findings& findings) {
  if (findings.has(Code::kAnyTranslationInMm, where)) return;
  findings.add(metres > kLargestRig ? Severity::kError : Severity::kWarning, code, std::move(facts), where);
}

/// Stereo.b is the baseline, and people know the number as Camera.bf of the older style: baseline times fx.
bool name_bf(const Subject& subject, Findings& findings) {
  const Rig& rig = subject.rig();
  const text::Node* place = text::find(subject.document.root(), "Stereo.b", text::Dialect::kOpenCv);
  if (!subject.is("orbslam3") || place == nullptr || rig.cameras.empty()) return false;
  const auto plausible = [](double metres) { return metres > 0.02 && metres < 2.0; };
  const double as_bf = *rig.baseline_m / central_focal_lengths(rig.cameras.front().model)[0];
  const double as_mm = *rig.baseline_m / 1000.0;
  if (!plausible(as_bf)) return false;
  findings.add(*rig.baseline_m > kLargestRig ? Severity::kError : Severity::kWarning,
               plausible(as_mm) ? Code::kBaselineIsBfOrMillimetres : Code::kBaselineIsBf, {*rig.baseline_m, as_bf, as_mm},
               subject.document.range(*place));
  return true;
}

/// Where the pose of a stereo pair stands; the file without a place where it is not stated.
SourceRange place_of_pair(const Subject& subject) {
  const Rig& rig = subject.rig();
  const auto stated = std::ranges::find_if(rig.poses, [&rig](const PoseEdge& edge) {
    const bool of_imu = rig.kind_of(edge.a) == FrameKind::kImu || rig.kind_of(edge.b) == FrameKind::kImu;
    return !of_imu && (edge.a == rig.cameras[1].name || edge.b == rig.cameras[1].name);
  });
  if (stated == rig.poses.end()) return {subject.document.source().name, 0, 0};
  return subject.places.pose(static_cast<std::size_t>(stated - rig.poses.begin()), 0, 3);
}

/// The first camera is the left one, and the second beside it: ORB-SLAM looks for disparities along rows, to one side only.
/// Fisheyes (kb4) are matched in the images as they are, by descriptors.
void check_stereo_order(const Subject& subject, Findings& findings) {
  const Rig& rig = subject.rig();
  if (!subject.is("orbslam3")) return;
  if (const std::optional<double> left = second_left_of_first(rig)) {
    findings.add(Code::kSecondCameraIsLeft, {in_metres(*left)}, place_of_pair(subject));
  }
  const std::optional<double> below = second_below_first(rig);
  if (!below || model_info(rig.cameras.front().model).id == std::string_view("kb4")) return;
  constexpr double kCmPerM = 100.0;
  findings.add(Code::kOrbslam3PairVertical,
               {rig.cameras[1].name, kCmPerM * std::abs(*below), *below > 0.0 ? "below" : "above", rig.cameras[0].name},
               place_of_pair(subject));
}

/// "0.65 m above the ground", "3.2 m below the ground"
Message above_ground(double height) {
  return {height < 0.0 ? Code::kBelowGround : Code::kAboveGround, {in_metres(std::abs(height))}};
}

/// A camera in a vehicle's frame stands above the ground and not farther from it than a truck is high.
void check_vehicle_direction(const Subject& subject, Findings& findings) {
  const auto plausible = [](double height) { return height > 0.1 && height < 4.5; };
  if (!subject.is("woodscape")) return;  // elsewhere the frame is a board or another camera
  for (std::size_t i = 0; i < subject.rig().poses.size(); ++i) {
    const PoseEdge& edge = subject.rig().poses[i];
    if (subject.rig().kind_of(edge.a) != FrameKind::kVehicle) continue;
    const std::optional<Transform> other = inverse(edge.T_a_b);
    if (!other || plausible(edge.T_a_b(2, 3))) continue;
    const bool inverted = plausible((*other)(2, 3));
    findings.add(inverted ? Code::kCameraUnderGround : Code::kCameraNotOfACar,
                 {edge.b, above_ground(edge.T_a_b(2, 3)), above_ground((*other)(2, 3))}, subject.places.pose(i, 2, 3));
  }
}

}  // namespace

bool check_rotations(const Subject& subject, Findings& findings) {
  for (std::size_t i = 0; i < subject.rig().poses.size(); ++i) check_rotation(subject, i, findings);
  return !subject.rig().poses.empty();
}

bool check_distances(const Subject& subject, Findings& findings) {
  const Rig& rig = subject.rig();
  for (std::size_t i = 0; i < rig.poses.size(); ++i) check_too_close(subject, i, findings);
  for (std::size_t i = 0; i < rig.poses.size(); ++i) {
    const Transform& T = rig.poses[i].T_a_b;
    if (!too_far(subject, distance_of(T), rig.poses[i].a)) continue;
    const double metres = distance_of(T);
    say_distance(metres, Code::kTranslationInMillimetres, {metres, name_of(rig.poses[i])},
                 subject.places.pose(i, longest_row(T), 3), findings);
  }
  if (rig.baseline_m && too_far(subject, *rig.baseline_m) && !name_bf(subject, findings))
    say_distance(*rig.baseline_m, Code::kBaselineTooLong, {*rig.baseline_m}, subject.places.baseline(), findings);
  check_stereo_order(subject, findings);
  check_vehicle_direction(subject, findings);
  return !rig.poses.empty() || rig.baseline_m;
}

bool check_redundant_poses(const Subject& subject, Findings& findings) {
  const auto& poses = subject.rig().poses;
  if (!std::ranges::all_of(poses, is_rotation)) {
    findings.undecided(Code::kAgreementUndecided);
    return false;
  }
  const bool any_redundant = !pose_loops(subject.rig()).empty();
  std::vector<PoseLoop> loops = contradictions(subject.rig());
  // Above a vehicle's ground the height decides.
  const auto is_identity = [](const PoseEdge& edge) { return edge.T_a_b == Transform{}; };
  if (!any_redundant && !std::ranges::all_of(poses, is_identity) && !subject.is("woodscape")) {
    std::vector<Message> others;
    if (poses.size() > 1) others = {{Code::kAndTheOthers}};
    findings.undecided(Code::kDirectionUndecided, {name_of(poses.front()), others});
  }
  if (!loops.empty() && name_millimetres(subject, findings)) return true;
  if (!loops.empty() && explain_all_of_imu(subject, loops, findings)) return true;
  // What one slip explains is no contradiction besides.
  Rig meant = subject.rig();
  for (std::size_t slips = 0; slips < poses.size() && !loops.empty() && explain_one(subject, loops, meant, findings); ++slips)
    loops = contradictions(meant);
  constexpr double kSmallAngle = 0.5 / kDegreesPerRadian;
  constexpr double kSmallDistance = 0.01;
  for (const PoseLoop& loop : loops) {
    const double angle = loop.difference.angle_rad;
    const double distance = loop.difference.distance_m;
    findings.add(angle > kSmallAngle || distance > kSmallDistance ? Severity::kError : Severity::kWarning,
                 Code::kPosesContradict, {name_of(poses[loop.edge]), in_degrees(angle), in_metres(distance)},
                 subject.places.pose(loop.edge, 0, 0));
  }
  return any_redundant;
}

}  // namespace fca::checks
