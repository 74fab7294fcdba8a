// SPDX-License-Identifier: BSD-3-Clause
// What is ORB-SLAM's own: one baseline in two spellings, a threshold in baselines, matrices that are read as floats.
#include "topics.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/rotation.h>

#include <array>
#include <cmath>

namespace fca::checks {

namespace {

using text::Node;

const Node* find(const Subject& subject, std::string_view key) {
  return text::find(subject.document.root(), key, text::Dialect::kOpenCv);
}

std::optional<double> number_at(const Subject& subject, std::string_view key) {
  const Node* node = find(subject, key);
  return node != nullptr && node->is_scalar() ? text::parse_real(node->value) : std::nullopt;
}

/// ORB-SLAM3 takes these by .at<float>() and looks at no type. Files without Camera.type are other programs'.
void check_matrix_types(const Subject& subject, Findings& findings) {
  if (find(subject, "Camera.type") == nullptr) return;
  for (const std::string_view key : {"Stereo.T_c1_c2", "IMU.T_b_c1", "Tbc", "Tlr"}) {
    const Node* matrix = find(subject, key);
    const Node* type = matrix != nullptr ? text::find(*matrix, "dt", text::Dialect::kOpenCv) : nullptr;
    if (type == nullptr || type->value == "f") continue;
    findings.add(Code::kMatrixNotFloat, {key, type->value}, subject.document.range(*type), SpanEdit{type->span, "f"});
  }
}

/// Element (0, 3) of a 3 x 4 opencv-matrix.
std::optional<double> corner_of(const Subject& subject, std::string_view key) {
  const Node* matrix = find(subject, key);
  const Node* data = matrix != nullptr ? text::find(*matrix, "data", text::Dialect::kOpenCv) : nullptr;
  if (data == nullptr || data->items.size() != 12) return std::nullopt;
  return text::parse_real(data->items[3].value);
}

/// bf = baseline times fx, where the file specifies the baseline another way, too.
void check_baseline(const Subject& subject, Findings& findings) {
  const std::optional<double> bf = number_at(subject, "Camera.bf");
  if (!bf) return;
  const Node& place = *find(subject, "Camera.bf");
  const auto contradicts = [&](double expected, const Message& why) {
    constexpr double kSame = 0.05;
    if (std::abs(expected) < 1e-6 || std::abs(*bf / expected - 1.0) <= kSame) return;
    findings.add(Code::kBaselineContradicts, {*bf, why, expected}, subject.document.range(place));
  };
  const Rig& rig = subject.rig();
  constexpr std::array kOtherUnit = {Code::kAnyTranslationInMm};  // told, and bf is right then
  const double fx = number_at(subject, "Camera.fx").value_or(0.0);
  if (const std::optional<double> corner = corner_of(subject, "RIGHT.P")) {
    contradicts(-*corner, {Code::kBaselineOfP, {*corner}});
  } else if (rig.cameras.size() > 1 && !findings.has_any(kOtherUnit)) {
    if (const std::optional<Transform> T = rig.resolve(rig.cameras[0].name, rig.cameras[1].name)) {
      const double baseline = distance_of(*T);
      contradicts(baseline * fx, {Code::kBaselineOfPose, {baseline}});
    }
  }
  constexpr double kNarrowest = 2e-3;  // m
  if (fx > 0.0 && *bf > 0.0 && *bf / fx < kNarrowest) {
    findings.add(Code::kBfIsABaseline, {*bf, 1000.0 * *bf / fx, *bf * fx}, subject.document.range(place));
  }
}

/// Close points are those within ThDepth baselines: upstream's examples have 35 to 60, and 40 for depth sensors.
void check_depth_threshold(const Subject& subject, Findings& findings) {
  for (const std::string_view key : {"Stereo.ThDepth", "ThDepth"}) {
    const std::optional<double> threshold = number_at(subject, key);
    constexpr double kNearest = 5.0;
    constexpr double kFarthest = 1000.0;
    if (!threshold || (*threshold >= kNearest && *threshold <= kFarthest)) continue;
    const SourceRange where = subject.document.range(*find(subject, key));
    if (*threshold <= 0.0) {
      const Code code = *threshold < 0.0 ? Code::kDepthThresholdNegative : Code::kDepthThresholdZero;
      findings.add(code, {key, *threshold, -*threshold}, where);
      continue;
    }
    findings.add(Code::kDepthThresholdNotInBaselines, {key, *threshold}, where);
  }
}

}  // namespace

bool check_orbslam3(const Subject& subject, Findings& findings) {
  if (!subject.is("orbslam3")) return false;
  check_matrix_types(subject, findings);
  check_baseline(subject, findings);
  check_depth_threshold(subject, findings);
  return true;
}

}  // namespace fca::checks
