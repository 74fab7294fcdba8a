// SPDX-License-Identifier: BSD-3-Clause
#include "derived.h"

#include "names.h"

#include <fca/code.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace fca::opencv {

struct Origin {
  Code why;  ///< Why such values are stale.
  Code remedy;
};

namespace {

constexpr Origin kRectification = {Code::kOpencvOfRectification, Code::kOpencvRectifyAgain};
constexpr Origin kCalibration = {Code::kOpencvOfCalibration, Code::kOpencvCalibrateAgain};
constexpr Origin kSecondStatement = {Code::kOpencvOfSecondStatement, Code::kOpencvRemoveKeys};

/// What a value was computed from or with.
struct Derived {
  std::string_view word;  ///< Folded.
  bool whole;             ///< The key is that word; else it holds it.
  bool from_lens;
  bool from_pose;
  const Origin* origin;
};

/// cv::stereoRectify, cv::stereoCalibrate; the samples camera_calibration.cpp, stereo_calib.cpp and omni_calibration.cpp.
constexpr std::array kDerived = {
    Derived{"r1", true, true, true, &kRectification},
    Derived{"r2", true, true, true, &kRectification},
    Derived{"p", true, true, true, &kRectification},
    Derived{"p1", true, true, true, &kRectification},
    Derived{"p2", true, true, true, &kRectification},
    Derived{"q", true, true, true, &kRectification},
    Derived{"rectif", false, true, true, &kRectification},
    Derived{"projectionmatrix", false, true, true, &kRectification},
    Derived{"disparitytodepth", false, true, true, &kRectification},
    Derived{"validroi", false, true, true, &kRectification},
    Derived{"validpixroi", false, true, true, &kRectification},
    Derived{"newcameramatrix", false, true, false, &kRectification},
    Derived{"e", true, false, true, &kRectification},
    Derived{"essential", false, false, true, &kRectification},
    Derived{"f", true, true, true, &kRectification},
    Derived{"fundamental", false, true, true, &kRectification},
    Derived{"baseline", false, false, true, &kRectification},
    Derived{"reproj", false, true, true, &kCalibration},
    Derived{"rms", true, true, true, &kCalibration},
    Derived{"rmserror", true, true, true, &kCalibration},
    Derived{"imagepoints", false, true, false, &kCalibration},
    Derived{"extrinsicparameters", false, true, false, &kCalibration},
    Derived{"flags", true, true, false, &kCalibration},
    Derived{"flagvalue", true, true, false, &kCalibration},
    Derived{"aspectratio", false, true, false, &kCalibration},
    Derived{"focallength", false, true, false, &kSecondStatement},
};

/// Where the key's value comes from, if it does not outlive the changes; else null.
const Origin* stale_origin(const std::string& key, const Changes& changes) {
  const std::string word = normalised_id(key);
  for (const Derived& row : kDerived) {
    const bool is_row = row.whole ? word == row.word : word.find(row.word) != std::string::npos;
    if (is_row && ((row.from_lens && changes.lens) || (row.from_pose && changes.pose))) return row.origin;
  }
  // The same cameras once more, under names that are not read: "camera_matrix_left" next to "M1".
  if (changes.lens && name_of(key).role != Role::kNone) return &kSecondStatement;
  return nullptr;
}

}  // namespace

bool same_lens(const CameraModel& a, const CameraModel& b) {
  if (kind_of(a) != kind_of(b)) return false;
  const auto covers = [](const CameraModel& from, const CameraModel& to) {
    return std::ranges::all_of(model_info(from).parameters, [&](const Parameter& row) {
      const double value = parameter(from, ParameterId(row)).value();
      const std::optional<double> there = parameter(to, ParameterId(row));
      return there ? value == *there : value == 0.0;
    });
  };
  return covers(a, b) && covers(b, a);
}

void StaleKeys::add(const text::Node& mapping, std::span<const std::string> edited, const Changes& changes,
                    const std::string& owner) {
  for (const text::Entry& entry : mapping.entries) {
    if (std::ranges::find(edited, entry.key.value) != edited.end()) continue;
    if (const Origin* origin = stale_origin(entry.key.value, changes))
      keys_.push_back({owner + entry.key.value, &entry.key, origin});
  }
}

void StaleKeys::tell(const text::Document& base, std::vector<Loss>& losses, Diagnostics& diagnostics) const {
  for (const Origin* origin : {&kRectification, &kCalibration, &kSecondStatement}) {
    std::vector<std::string> names;
    const text::Node* first = nullptr;
    for (const Key& key : keys_) {
      if (key.origin != origin) continue;
      if (first == nullptr) first = key.node;
      names.push_back(key.name);
    }
    if (first == nullptr) continue;
    const std::vector<Argument> facts = {names, Message{origin->why}, Message{origin->remedy}};
    diagnostics.add(Code::kOpencvStale, facts, base.range(*first));
    losses.push_back(lost(Code::kOpencvStaleKept, "", "", facts));
  }
}

}  // namespace fca::opencv
