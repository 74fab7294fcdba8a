// SPDX-License-Identifier: BSD-3-Clause
#include "pose_words.h"

#include "shell/words.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fca::cli {

namespace {

/// A direction, and what joins it to the thing from which it is seen: "behind cam0", but "ahead of cam0".
struct Direction {
  std::string_view name;
  std::string_view joint = " of ";
};

/// What the ends of an axis are called.
struct AxisNames {
  Direction negative;
  Direction positive;
};

constexpr std::string_view kNoJoint = " ";
constexpr std::array kOfAnyFrame = {AxisNames{{"towards -x"}, {"towards +x"}}, AxisNames{{"towards -y"}, {"towards +y"}},
                                    AxisNames{{"towards -z"}, {"towards +z"}}};
/// x right, y down, z forward.
constexpr std::array kOfACamera = {AxisNames{{"to the left"}, {"to the right"}},
                                   AxisNames{{"above", kNoJoint}, {"below", kNoJoint}},
                                   AxisNames{{"behind", kNoJoint}, {"ahead"}}};
constexpr std::array kViewInAnyFrame = {AxisNames{{"looks along -x"}, {"looks along +x"}},
                                        AxisNames{{"looks along -y"}, {"looks along +y"}},
                                        AxisNames{{"looks along -z"}, {"looks along +z"}}};
constexpr std::array kViewInACamera = {AxisNames{{"looks to its left"}, {"looks to its right"}},
                                       AxisNames{{"looks up"}, {"looks down"}},
                                       AxisNames{{"looks backwards"}, {"looks the same way"}}};

/// Half of the last digit that is printed.
constexpr double kNoticeableCm = 0.005;
constexpr double kNoticeableDeg = 0.005;

std::string position_in_words(const Placement& placement) {
  const auto& names = placement.frame_is_camera ? kOfACamera : kOfAnyFrame;
  std::vector<std::string> parts;
  Direction last;
  for (int axis = 0; axis < 3; ++axis) {
    const double centimetres = 100.0 * placement.T_frame_thing(axis, 3);
    if (std::abs(centimetres) < kNoticeableCm) continue;
    const AxisNames& name = names.at(static_cast<std::size_t>(axis));
    last = centimetres < 0.0 ? name.negative : name.positive;
    parts.push_back(fixed(std::abs(centimetres), 2) + " cm " + std::string(last.name));
  }
  if (parts.empty()) return "sits where " + placement.frame + " is";
  return "sits " + enumerated(parts, "and") + std::string(last.joint) + placement.frame;
}

/// By how much a camera is turned about its axis against the frame's, whose y is down as its own is: positive as a clock's
/// hand, seen from behind. Nothing for one that looks up or down.
std::optional<double> roll_deg(const Transform& T_frame_camera) {
  constexpr double kHorizontal = 0.5;  // of the frame's y, in the camera's image plane
  const double right = T_frame_camera(1, 0);
  const double down = T_frame_camera(1, 1);
  if (std::hypot(right, down) < kHorizontal) return std::nullopt;
  return std::atan2(right, down) * kDegreesPerRadian;
}

/// What the direction of view does not tell: ", turned 90 deg clockwise about its axis". Empty where the camera is as level as
/// pairs are, or as level as it is straight.
std::string roll_in_words(const Transform& T_frame_camera, double off_deg) {
  constexpr double kOrdinaryDeg = 5.0;
  constexpr double kHalfTurnDeg = 180.0;
  const double roll = roll_deg(T_frame_camera).value_or(0.0);
  const double size = std::abs(roll);
  if (size <= std::max(kOrdinaryDeg, off_deg)) return "";
  const std::string way = kHalfTurnDeg - size < kOrdinaryDeg ? "" : roll > 0.0 ? " clockwise" : " counterclockwise";
  return ", turned " + text::format_short(size, 4) + " deg" + way + " about its axis";
}

/// The optical axis is the thing's z.
std::string view_in_words(const Placement& placement) {
  std::array<double, 3> view{};
  for (int row = 0; row < 3; ++row) view.at(static_cast<std::size_t>(row)) = placement.T_frame_thing(row, 2);
  const auto along = static_cast<std::size_t>(
      std::ranges::max_element(view, {}, [](double component) { return std::abs(component); }) - view.begin());
  const AxisNames& name = (placement.frame_is_camera ? kViewInACamera : kViewInAnyFrame).at(along);
  const double main = std::abs(view.at(along));
  const double across = std::sqrt(std::max(0.0, std::inner_product(view.begin(), view.end(), view.begin(), 0.0) - main * main));
  const double off = std::atan2(across, main) * kDegreesPerRadian;
  const std::string words((view.at(along) < 0.0 ? name.negative : name.positive).name);
  const std::string view_words = off < kNoticeableDeg ? words : words + " (" + fixed(off, 2) + " deg off)";
  return placement.frame_is_camera ? view_words + roll_in_words(placement.T_frame_thing, off) : view_words;
}

}  // namespace

std::string placement_in_words(const Placement& placement) {
  const std::string text = placement.thing + " " + position_in_words(placement);
  return placement.thing_is_camera ? text + "; it " + view_in_words(placement) : text;
}

std::string pose_in_words(const PoseEdge& edge, const Rig& rig, bool in_metres) {
  const bool a_sees = rig.find_camera(edge.a) != nullptr;
  const bool b_sees = rig.find_camera(edge.b) != nullptr;
  const std::string_view unit = in_metres ? "" : ", if the unit of its position is the metre (the file contains none)";
  if (b_sees && !a_sees) return placement_in_words({edge.b, edge.a, true, false, edge.T_a_b}).append(unit);
  const std::optional<Transform> T_b_a = inverse(edge.T_a_b);
  return T_b_a ? placement_in_words({edge.a, edge.b, a_sees, b_sees, *T_b_a}).append(unit) : "";
}

}  // namespace fca::cli
