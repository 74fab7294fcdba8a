// SPDX-License-Identifier: BSD-3-Clause
// The source may be any function pixel -> ray: a program's own camera class, a lens design, an interpolated map. Here a
// stereographic lens, r = 2 f tan(angle / 2), which Double Sphere can be (xi = 0, alpha = 1/2) and Kannala-Brandt only nearly.
#include <fca/convert/evaluate.h>
#include <fca/convert/fit.h>
#include <fca/convert/sample.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr double kFocal = 220.0, kCentre[] = {511.5, 383.5};  // px

std::optional<fca::Ray> stereographic(const fca::Pixel& pixel) {
  const double x = (pixel[0] - kCentre[0]) / (2.0 * kFocal), y = (pixel[1] - kCentre[1]) / (2.0 * kFocal);
  const double r2 = x * x + y * y, scale = 1.0 / (1.0 + r2);  // tan^2(angle / 2)
  return fca::Ray{2.0 * scale * x, 2.0 * scale * y, scale * (1.0 - r2)};
}

}  // namespace

int main() {
  // What a function cannot say: the pixel of its axis and the pixels per radian there. An angle where the lens ends may follow.
  const fca::Lens lens(stereographic, fca::LensCentre{{kFocal, kFocal}, {kCentre[0], kCentre[1]}});
  fca::Diagnostics diagnostics;
  const auto field_of_view = fca::field_of_view_of(lens, {1024, 768}, std::nullopt, "stereographic", diagnostics);
  if (!field_of_view) return 1;
  const auto samples = fca::sample(lens, *field_of_view);
  const auto ds = fca::fit<fca::Ds>(samples, lens.centre());
  const auto kb4 = fca::fit<fca::Kb4>(samples, lens.centre());
  if (!ds || !kb4) return 1;
  const fca::ErrorSummary as_ds = fca::evaluate(lens, fca::CameraModel(ds->model), *field_of_view).error;
  const fca::ErrorSummary as_kb4 = fca::evaluate(lens, fca::CameraModel(kb4->model), *field_of_view).error;
  std::printf("stereographic, up to %.1f deg from the axis\n", field_of_view->max_angle_rad * 57.29577951308232);
  std::printf("  as ds:  rms %.1e px, max %.1e px\n", as_ds.rms, as_ds.max);
  std::printf("  as kb4: rms %.4f px, max %.4f px\n", as_kb4.rms, as_kb4.max);
  return as_ds.max < 1e-6 && as_kb4.max < 1.0 ? 0 : 1;
}
