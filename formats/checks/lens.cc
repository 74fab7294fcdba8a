// SPDX-License-Identifier: BSD-3-Clause
#include "topics.h"

#include <fca/code.h>
#include <fca/convert/field_of_view.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/covered_image.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::checks {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// The part of an image, inside the circle that its lens lights where that is known, that has no ray.
struct Uncovered {
  double share = 0.0;
  double nearest_px = 0.0;  ///< Its distance from the principal point.
  Pixel nearest = {};
};

Uncovered uncovered_part(const Camera& camera) {
  const CameraModel& model = camera.model;
  const ImageSize& size = *camera.image_size;
  constexpr int kSteps = 64;
  const Pixel centre = principal_point(model);
  // Trapezoids: a point of the border stands for half a cell.
  const auto width_of = [](int step) { return step == 0 || step == kSteps ? 0.5 : 1.0; };
  Uncovered result;
  bool any = false;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(size.width - 1.0) * i / kSteps, (size.height - 1.0) * j / kSteps};
      if (unproject(model, pixel) || (camera.lens_circle && !camera.lens_circle->contains(pixel))) continue;
      const double distance = std::hypot(pixel[0] - centre[0], pixel[1] - centre[1]);
      if (!any || distance < result.nearest_px) {
        result.nearest_px = distance;
        result.nearest = pixel;
      }
      any = true;
      result.share += width_of(i) * width_of(j) / (kSteps * kSteps);
    }
  }
  return result;
}

/// The parameter that bends the lens first: where to look.
SourceRange place_of_lens(const Subject& subject, const Camera& camera) {
  for (const ParameterId id : ParameterIds{"k1", "alpha", "xi", "w", "a2"}) {
    if (parameter(camera.model, id)) return subject.places.parameter(camera, id);
  }
  return subject.places.parameter(camera, "fx");
}

void check_coverage(const Subject& subject, const Camera& camera, Findings& findings) {
  const ImageSize size = *camera.image_size;
  const double ends = max_angle(camera.model);
  if (ends >= subject.options.max_angle_rad.value_or(std::numbers::pi)) return;
  if (is_surely_covered(camera.model, size)) return;
  const Uncovered uncovered = uncovered_part(camera);
  if (uncovered.share == 0.0) return;
  const Pixel centre = principal_point(camera.model);
  const double nearest_border = std::min({centre[0], size.width - 1.0 - centre[0], centre[1], size.height - 1.0 - centre[1]});
  constexpr double kFisheye = 85.0 / kDegreesPerRadian;
  // A fisheye's image circle ends inside the image; a lens that sees less fills it.
  const bool circle = ends > kFisheye;
  // Polynomials of the tangent fold where they were not fitted: no such lens ends inside the largest circle about its centre.
  const std::string_view model = model_info(camera.model).id;
  const bool of_tangent = opencv_count(model) > 0;
  const bool broken = uncovered.nearest_px < (of_tangent || !circle ? 1.0 : 0.5) * nearest_border;
  constexpr double kNothingToSpeakOf = 0.01;
  const bool is_less = circle || uncovered.share <= kNothingToSpeakOf;
  const Severity severity = broken ? Severity::kError : is_less ? Severity::kNote : Severity::kWarning;
  findings.add(severity, circle && !broken ? Code::kFoldsAtCircle : Code::kFoldsInImage,
               {camera.name, ends * kDegreesPerRadian, uncovered.nearest_px, 100.0 * uncovered.share},
               place_of_lens(subject, camera));
}

/// Double Sphere is one-to-one beyond, too, but no lens has been found there.
void check_second_sphere(const Subject& subject, const Camera& camera, Findings& findings) {
  const std::optional<double> xi = parameter(camera.model, "xi");
  if (model_info(camera.model).id != std::string_view("ds") || !xi || std::abs(*xi) <= 1.0) return;
  findings.add(Code::kSecondSphere, {camera.name, *xi}, subject.places.parameter(camera, "xi"));
}

}  // namespace

bool check_lens(const Subject& subject, Findings& findings) {
  bool any = false;
  for (const Camera& camera : subject.rig().cameras) {
    check_second_sphere(subject, camera, findings);
    if (!camera.image_size) continue;
    any = true;
    // In an image of the other orientation it would end inside for no reason of its own.
    if (findings.has(Code::kSizeSwapped, [&] { return subject.places.image_width(camera); })) continue;
    check_coverage(subject, camera, findings);
  }
  return any;
}

}  // namespace fca::checks
