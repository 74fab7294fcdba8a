// SPDX-License-Identifier: BSD-3-Clause
// What is ORB-SLAM's own: one baseline in two spellings, a threshold in baselines, matrices that are read as floats.
#include "topics.h"

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
    findings.add({Severity::kError,
                  "matrix-not-float",
                  std::string(key) + " has dt: " + type->value + "; ORB-SLAM3 reads its bytes as floats",
                  {},
                  "write dt: f",
                  subject.document.range(*type),
                  SpanEdit{type->span, "f"}});
  }
}

/// Element (0, 3) of a 3 x 4 opencv-matrix.
std::optional<double> corner_of(const Subject& subject, std::string_view key) {
  const Node* matrix = find(subject, key);
  const Node* data = matrix != nullptr ? text::find(*matrix, "data", text::Dialect::kOpenCv) : nullptr;
  if (data == nullptr || data->items.size() != 12) return std::nullopt;
  return text::parse_real(data->items[3].value);
}

/// bf = baseline times fx, where the file states the baseline another way, too.
void check_baseline(const Subject& subject, Findings& findings) {
  const std::optional<double> bf = number_at(subject, "Camera.bf");
  if (!bf) return;
  const Node& place = *find(subject, "Camera.bf");
  const auto contradicts = [&](double expected, const std::string& why) {
    constexpr double kSame = 0.05;
    if (std::abs(expected) < 1e-6 || std::abs(*bf / expected - 1.0) <= kSame) return;
    findings.add(
        {Severity::kWarning,
         "baseline-contradicts",
         "Camera.bf is " + text::format_short(*bf, 5) + ", and " + why + " makes it " + text::format_short(expected, 5),
         {},
         "Camera.bf is the baseline in metres times Camera.fx",
         subject.document.range(place)});
  };
  const Rig& rig = subject.rig();
  constexpr std::array<std::string_view, 1> kOtherUnit = {"translation-in-mm"};  // told, and bf is right then
  const double fx = number_at(subject, "Camera.fx").value_or(0.0);
  if (const std::optional<double> corner = corner_of(subject, "RIGHT.P")) {
    contradicts(-*corner, "RIGHT.P(0, 3) = " + text::format_short(*corner, 5));
  } else if (rig.cameras.size() > 1 && !findings.has_any(kOtherUnit)) {
    if (const std::optional<Transform> T = rig.resolve(rig.cameras[0].name, rig.cameras[1].name)) {
      const double baseline = distance_of(*T);
      contradicts(baseline * fx, "the second camera's distance of " + text::format_short(baseline, 4) + " m");
    }
  }
  constexpr double kNarrowest = 2e-3;  // m
  if (fx > 0.0 && *bf > 0.0 && *bf / fx < kNarrowest) {
    findings.add({Severity::kWarning,
                  "bf-is-a-baseline",
                  "Camera.bf = " + text::format_short(*bf, 4) + " makes a baseline of " +
                      text::format_short(1000.0 * *bf / fx, 3) + " mm: that is probably the baseline itself, in metres",
                  {},
                  "if so, write " + text::format_short(*bf * fx, 6) + " (baseline times Camera.fx)",
                  subject.document.range(place)});
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
      findings.add({Severity::kWarning,
                    "depth-threshold",
                    std::string(key) + " = " + text::format_short(*threshold, 4) +
                        ": no point is nearer than that, so none counts as close",
                    {},
                    *threshold < 0.0
                        ? "write " + text::format_real(-*threshold) + " if only the sign is wrong; upstream's are 35 to 60"
                        : "write 40.0; upstream's are 35 to 60",
                    where});
      continue;
    }
    findings.add({Severity::kWarning,
                  "depth-threshold",
                  std::string(key) + " = " + text::format_short(*threshold, 4) +
                      " is counted in baselines, not in metres; upstream's are 35 to 60",
                  {},
                  "divide the distance in metres by the baseline",
                  where});
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
