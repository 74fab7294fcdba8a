// SPDX-License-Identifier: BSD-3-Clause
// Numbers of one lens model under the name of another. Four coefficients look alike in every file; what they may be differs.
#include "topics.h"

#include <fca/code.h>
#include <fca/convert/field_of_view.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/fields_of_view.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::checks {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

double value(const Camera& camera, ParameterId id) { return parameter(camera.model, id).value(); }

/// Lenses are centred to a small fraction of a degree: tangential terms above this are another model's third and fourth number,
/// where the first two may be, too, and there is no fifth; else they come from too few views.
void check_tangential(const Subject& subject, const Camera& camera, Findings& findings) {
  constexpr double kLargest = 0.02;
  constexpr double kLargestOfFisheye = 0.3;  // k1 and k2
  const std::optional<double> k3 = parameter(camera.model, "k3");
  const bool may_be_fisheye = std::abs(value(camera, "k1")) <= kLargestOfFisheye &&
                              std::abs(value(camera, "k2")) <= kLargestOfFisheye && (!k3 || *k3 == 0.0);
  const Code code = may_be_fisheye ? Code::kTangentialTooLarge : Code::kTangentialOfNoLens;
  for (const ParameterId id : ParameterIds{"p1", "p2"}) {
    if (std::abs(value(camera, id)) <= kLargest) continue;
    findings.add(code, {camera.name, id.name(), value(camera, id)}, subject.places.parameter(camera, id));
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

/// Under radtan, k1 and k2 of a unified model leave out the xi that makes the pincushion of k2 a fisheye's barrel. No plain
/// lens's second term outweighs the first and pulls the corner outwards so far. Next to an xi of 3 they are large and positive:
/// the focal length, which has that factor too, then makes the corner's radius small.
void check_unified(const Subject& subject, const Camera& camera, Findings& findings) {
  if (!camera.image_size) return;
  const double k1 = value(camera, "k1");
  const double k2 = value(camera, "k2");
  const Pixel centre = principal_point(camera.model);
  const double across = std::max(centre[0], camera.image_size->width - centre[0]) / value(camera, "fx");
  const double down = std::max(centre[1], camera.image_size->height - centre[1]) / value(camera, "fy");
  const double r2 = across * across + down * down;  // of the farthest corner, without distortion
  constexpr double kOutweighs = 4.0;
  constexpr double kShape = 0.4;  // EUCM's alpha, which ORB-SLAM's check names
  constexpr double kPincushion = 0.2;
  const double outwards = k1 * r2 + k2 * r2 * r2;
  const bool four_numbers = value(camera, "k3") == 0.0;
  const bool pulls_far = std::abs(k1) <= kShape && k2 * r2 >= kOutweighs * std::abs(k1) && outwards >= kPincushion;
  constexpr double kFirstOfLargeXi = 0.4;  // of eleven real cameras with an xi above 3: 0.67 and more
  constexpr double kSecondOfLargeXi = 5.0;
  const bool of_large_xi = k1 > kFirstOfLargeXi && k2 > kSecondOfLargeXi;
  if (!four_numbers || !(pulls_far || of_large_xi)) return;
  // Not with a focal length or a size that nobody believes.
  if (findings.has(Code::kAnyFocalLengthNotInPixels, subject.places.parameter(camera, "fx")) ||
      findings.has(Code::kAnySizeUnlikeCentre, subject.places.image_width(camera)))
    return;
  constexpr double kNoLensAtAll = 10.0;  // the corner at eleven times its radius
  findings.add(outwards > kNoLensAtAll ? Severity::kError : Severity::kWarning, Code::kMeiUnderRadtan,
               {camera.name, k1, k2, 100.0 * outwards}, subject.places.parameter(camera, "k2"));
}

/// Of the shortest spelling that reads as the number: 2 of 0.00120 and of 1.2e-5.
int significant_digits(double number) {
  std::string digits = text::format_real(std::abs(number));
  digits.resize(std::min(digits.size(), digits.find('e')));
  std::erase(digits, '.');
  digits.erase(0, digits.find_first_not_of('0'));
  digits.resize(digits.find_last_not_of('0') + 1);  // npos + 1 is 0
  return static_cast<int>(digits.size());
}

/// Estimated coefficients never agree to the last of many digits.
void check_repeated(const Subject& subject, const Camera& camera, Findings& findings) {
  const ParameterIds kCoefficients = {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"};
  std::vector<std::pair<ParameterId, double>> seen;
  for (const ParameterId id : kCoefficients) {
    const std::optional<double> number = parameter(camera.model, id);
    constexpr int kFew = 5;  // 0.0123 may come twice
    if (!number || significant_digits(*number) < kFew) continue;
    const auto same = std::ranges::find(seen, *number, &std::pair<ParameterId, double>::second);
    if (same != seen.end()) {
      findings.add(Code::kCoefficientRepeated, {camera.name, same->first.name(), id.name(), *number},
                   subject.places.parameter(camera, id));
      return;
    }
    seen.emplace_back(id, *number);
  }
}

}  // namespace

bool check_family(const Subject& subject, Findings& findings) {
  bool any = false;
  for (const Camera& camera : subject.rig().cameras) {
    const std::string_view model = model_info(camera.model).id;
    const bool has_tangential = opencv_count(model) > 0 || model == "mei";
    if (has_tangential) check_tangential(subject, camera, findings);
    if (model == "radtan") check_rectilinear(subject, camera, findings);
    if (model == "radtan") check_unified(subject, camera, findings);
    check_repeated(subject, camera, findings);
    if (model == "kb4") check_equidistant(subject, camera, findings);
    any = any || has_tangential || model == "kb4";
  }
  return any;
}

}  // namespace fca::checks
