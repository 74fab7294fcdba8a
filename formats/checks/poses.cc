// SPDX-License-Identifier: BSD-3-Clause
#include "../pose_words.h"
#include "stereo.h"
#include "topics.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>
#include <fca/rig/contradictions.h>
#include <fca/rig/rotation.h>
#include <fca/rig/stereo_order.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::checks {

namespace {

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

/// The row of the translation where a wrong unit shows best.
int longest_row(const Transform& T) {
  int longest = 0;
  for (int row = 1; row < 3; ++row) {
    if (std::abs(T(row, 3)) > std::abs(T(longest, 3))) longest = row;
  }
  return longest;
}

/// For formats that specify metres.
bool too_far(const Subject& subject, double metres, std::string_view from = {}) {
  return !subject.calibration.format->any_length_unit && is_too_long(metres, from, subject.rig());
}

/// With its numbers, or the common mistake that explains them.
void report(const Subject& subject, const Contradiction& contradiction, Findings& findings) {
  const PoseLoop& loop = contradiction.loop;
  const Code mistake = contradiction.mistake;
  const Severity severity = contradiction.severity;
  const PoseEdge& edge = subject.rig().poses[loop.edge];
  constexpr std::array kOfTranslation = {Code::kPoseInMillimetres, Code::kPoseInCentimetres, Code::kPoseInHectometres,
                                         Code::kPoseInKilometres};
  const bool of_translation = std::ranges::find(kOfTranslation, mistake) != kOfTranslation.end();
  const SourceRange where =
      of_translation ? subject.places.pose(loop.edge, longest_row(edge.T_a_b), 3) : subject.places.pose(loop.edge, 0, 0);
  if (mistake != Code::kNone) {
    findings.add(severity, mistake, {name_of(edge)}, where);
    return;
  }
  findings.add(severity, Code::kPosesContradict,
               {name_of(edge), in_degrees(loop.difference.angle_rad), in_metres(loop.difference.distance_m)}, where);
}

/// Which of several poses is wrong, where nothing tells: those that a mistake would explain, else all of the loop.
void ask_which(const Subject& subject, const std::vector<Contradiction>& found, Findings& findings) {
  const auto is_open = [](const Contradiction& each) { return each.blame == Blame::kNone; };
  const auto open = std::ranges::find_if(found, is_open);  // of several they are the same
  if (open == found.end()) return;
  std::vector<std::size_t> edges = open->candidates;
  if (edges.empty()) {
    edges = open->loop.path;
    edges.push_back(open->loop.edge);
    std::ranges::sort(edges);
  }
  std::vector<std::string> names;
  names.reserve(edges.size());
  for (const std::size_t edge : edges) names.push_back(name_of(subject.rig().poses[edge]));
  findings.undecided(Code::kWrongPoseUndecided, {names});
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

/// The first camera is the left one, and the second next to it: ORB-SLAM looks for disparities along rows, to one side only.
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

/// A camera of a pair whose rectified images have matches along their columns.
void check_rectified_order(const Subject& subject, Findings& findings) {
  const Rig& rig = subject.rig();
  if (!subject.is("ros")) return;
  for (std::size_t i = 0; i < rig.poses.size(); ++i) {
    const PoseEdge& edge = rig.poses[i];
    const Camera* camera = rig.find_camera(edge.b);
    if (camera == nullptr || rig.find_camera(edge.a) != nullptr || edge.T_a_b(1, 3) == 0.0) continue;
    constexpr double kCmPerM = 100.0;
    const double below = edge.T_a_b(1, 3);
    findings.add(Code::kRosPairVertical, {camera->name, kCmPerM * std::abs(below), below > 0.0 ? "below" : "above"},
                 subject.places.pose(i, 1, 3));
  }
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
    constexpr double kShortestInMm = 20.0;  // of the distances between cameras; shorter numbers are rather centimetres
    say_distance(metres, metres < kShortestInMm ? Code::kTranslationInCentimetres : Code::kTranslationInMillimetres,
                 {metres, name_of(rig.poses[i])}, subject.places.pose(i, longest_row(T), 3), findings);
  }
  if (rig.baseline_m && too_far(subject, *rig.baseline_m) && !name_bf(subject, findings))
    say_distance(*rig.baseline_m, Code::kBaselineTooLong, {*rig.baseline_m}, subject.places.baseline(), findings);
  check_stereo_order(subject, findings);
  const FindPlace place = [&subject] { return place_of_pair(subject); };
  if (rig.cameras.size() > 1) check_stereo_pair(subject, place, findings);
  check_rectified_order(subject, findings);
  check_vehicle_direction(subject, findings);
  return !rig.poses.empty() || rig.baseline_m;
}

bool check_redundant_poses(const Subject& subject, Findings& findings) {
  const auto& poses = subject.rig().poses;
  const std::vector<Contradiction> found = contradictions(subject.rig());
  if (found.empty() && !std::ranges::all_of(poses, is_rotation)) {
    findings.undecided(Code::kAgreementUndecided);
    return false;
  }
  const bool any_redundant = !pose_loops(subject.rig()).empty();
  // Above a vehicle's ground the height decides.
  const auto is_identity = [](const PoseEdge& edge) { return edge.T_a_b == Transform{}; };
  if (!any_redundant && !std::ranges::all_of(poses, is_identity) && !subject.is("woodscape")) {
    std::vector<Message> others;
    if (poses.size() > 1) others = {{Code::kAndTheOthers}};
    findings.undecided(Code::kDirectionUndecided, {name_of(poses.front()), others});
  }
  for (const Contradiction& contradiction : found) report(subject, contradiction, findings);
  ask_which(subject, found, findings);
  return any_redundant;
}

}  // namespace fca::checks
