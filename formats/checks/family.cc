// SPDX-License-Identifier: BSD-3-Clause
// Numbers of one lens model under the name of another. Four coefficients look alike in every file; what they may be differs.
#include "topics.h"

#include <fca/code.h>
#include <fca/convert/domain.h>
#include <fca/rig/fields_of_view.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::checks {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

double value(const Camera& camera, ParameterId id) { return parameter(camera.model, id).value(); }

/// Lenses are centred to a small fraction of a degree: tangential terms above this are another model's third and fourth number.
void check_tangential(const Subject& subject, const Camera& camera, Findings& findings) {
  constexpr double kLargest = 0.02;
  for (const ParameterId id : ParameterIds{"p1", "p2"}) {
    if (std::abs(value(camera, id)) <= kLargest) continue;
    findings.add(Code::kTangentialTooLarge, {camera.name, id.name(), value(camera, id)}, subject.places.parameter(camera, id));
    return;
  }
}

/// A distortion-free lens that sees more than 100 deg does not exist outside of simulators; a fisheye's small k1 under radtan
/// claims one.
void check_rectilinear(const Subject& subject, const Camera& camera, Findings& findings) {
  const std::optional<double> view = horizontal_field_of_view(camera);
  constexpr double kWidest = 100.0 / kDegreesPerRadian;
  constexpr double kStraight = 0.03;
  const double k1 = value(camera, "k1");
  if (!view || *view < kWidest || k1 == 0.0 || std::abs(k1) > kStraight) return;
  findings.add(Code::kRectilinearTooWide, {camera.name, k1, *view * kDegreesPerRadian}, subject.places.parameter(camera, "k1"));
}

/// radtan's signature: a strong negative k1, a positive k2 and two tangential terms that are next to nothing. An equidistant
/// polynomial with so strong a k1 has higher terms of its size.
void check_equidistant(const Subject& subject, const Camera& camera, Findings& findings) {
  const double k1 = value(camera, "k1");
  const double k2 = value(camera, "k2");
  constexpr double kStrong = 0.15;
  constexpr double kTangential = 5e-3;
  const bool tiny = std::abs(value(camera, "k3")) < kTangential && std::abs(value(camera, "k4")) < kTangential;
  if (std::abs(k1) < kStrong || k1 * k2 >= 0.0 || !tiny) return;
  findings.add(Code::kRadtanUnderEquidistant, {camera.name, k1, k2}, subject.places.parameter(camera, "k1"));
}

}  // namespace

bool check_family(const Subject& subject, Findings& findings) {
  bool any = false;
  for (const Camera& camera : subject.rig().cameras) {
    const std::string_view model = model_info(camera.model).id;
    if (model == "radtan" || model == "rational" || model == "mei") check_tangential(subject, camera, findings);
    if (model == "radtan") check_rectilinear(subject, camera, findings);
    if (model == "kb4") check_equidistant(subject, camera, findings);
    any = any || model == "radtan" || model == "rational" || model == "mei" || model == "kb4";
  }
  return any;
}

}  // namespace fca::checks
