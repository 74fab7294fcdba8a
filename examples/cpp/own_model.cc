// SPDX-License-Identifier: BSD-3-Clause
// A camera model that fca-io does not know, fitted to one that it does, and back again: equisolid angle, r = 2 f sin(angle /
// 2), fx fy cx cy. fca/models/model_traits.h says what a model must have.
#include <fca/convert/evaluate.h>
#include <fca/convert/fit.h>
#include <fca/convert/sample.h>

#include <cmath>
#include <cstdio>
#include <numbers>

struct Equisolid {
  static constexpr std::string_view kId = "equisolid", kTitle = "Equisolid angle";
  static constexpr std::array<std::string_view, 0> kAliases = {};
  static constexpr std::array kParameters = {fca::common_parameter::kFx, fca::common_parameter::kFy, fca::common_parameter::kCx,
                                             fca::common_parameter::kCy};

  template <class T>
  static bool formula(const T* p, const T* ray, T* pixel) {  // (x, y) 2 sin(angle / 2) / sin(angle)
    using std::sqrt;
    const T length = sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
    const T scale = sqrt(T(2.0) / (length * (length + ray[2])));
    for (int i = 0; i < 2; ++i) pixel[i] = p[i] * scale * ray[i] + p[2 + i];
    return length + ray[2] > T(0.0);
  }
  template <class T>
  static bool project(const T* p, const T* ray, T* pixel) {
    return formula(p, ray, pixel);
  }
  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double x = (pixel[0] - p[2]) / p[0], y = (pixel[1] - p[3]) / p[1], r2 = x * x + y * y;
    if (!(r2 < 4.0)) return false;
    const double scale = std::sqrt(1.0 - r2 / 4.0);
    ray[0] = scale * x, ray[1] = scale * y, ray[2] = 1.0 - r2 / 2.0;
    return true;
  }
  static double max_angle(const double* /*p*/) { return std::numbers::pi; }
  static std::array<double, 2> principal_point(const double* p) { return {p[2], p[3]}; }
  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[0], p[1]}; }
  static constexpr int kStarts = 1;
  static void initialise(std::span<const fca::Correspondence>, const fca::LensCentre& centre, int, double* p) {
    for (int i = 0; i < 2; ++i) p[i] = centre.focal[i], p[2 + i] = centre.point[i];
  }
};

int main() {  // TUM VI's left camera (Kannala-Brandt), as far as its lens sees
  const fca::CameraModel tumvi =
      fca::Intrinsics<fca::Kb4>{{190.978, 190.973, 254.932, 256.897, 0.00348, 0.000715, -0.00205, 0.0002}};
  fca::Diagnostics diagnostics;
  const auto field_of_view = fca::field_of_view_of(tumvi, {512, 512}, 1.7017, "tumvi", diagnostics);
  const auto own = fca::fit<Equisolid>(fca::sample(tumvi, *field_of_view), fca::Lens(tumvi).centre());
  const fca::Lens lens(own->model);
  const auto back = fca::fit<fca::Kb4>(fca::sample(lens, *field_of_view), lens.centre());
  const fca::ErrorSummary there = fca::evaluate(tumvi, fca::projection_of(own->model), *field_of_view).error;
  const fca::ErrorSummary again = fca::evaluate(lens, fca::CameraModel(back->model), *field_of_view).error;
  std::printf("kb4 -> equisolid: f %.3f, rms %.3f px, max %.3f px\n", own->model.values[0], there.rms, there.max);
  std::printf("equisolid -> kb4: rms %.2g px, max %.2g px\n", again.rms, again.max);
}
