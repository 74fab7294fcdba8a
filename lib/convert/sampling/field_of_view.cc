// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/field_of_view.h>

#include "../../models/kernels/batch.h"

#include <fca/code.h>
#include <fca/rig/covered_image.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fca {

namespace {

/// A rectangle of the image, from the pixel `first` to the pixel `last`, both included.
struct Window {
  Pixel first = {};
  Pixel last = {};
};

/// A rectangle with the pixels whose rays are roughly within `angle_rad` of the axis.
Window around_axis(const Lens& lens, const ImageSize& size, double angle_rad) {
  const LensCentre centre = lens.centre();
  const std::array<double, 2> end = {size.width - 1.0, size.height - 1.0};
  Window window;
  for (const std::size_t i : {0U, 1U}) {
    const double radius = centre.focal.at(i) * angle_rad;
    window.first.at(i) = std::clamp(centre.point.at(i) - radius, 0.0, end.at(i));
    window.last.at(i) = std::clamp(centre.point.at(i) + radius, 0.0, end.at(i));
  }
  return window;
}

/// The rays of a coarse lattice of pixels in a window, including the window's border. The border alone would not be enough for
/// a lens that ends inside the image.
class RayLattice {
 public:
  RayLattice(const Lens& lens, const Window& window) : lens_(lens) {
    std::optional<internal::BatchRays> rays;
    if (lens.model() != nullptr && validate(*lens.model()).empty()) rays.emplace(*lens.model(), std::numbers::pi);
    rays_.reserve(static_cast<std::size_t>((kSteps + 1) * (kSteps + 1)));
    internal::Batch batch;
    std::size_t count = 0;
    const auto find_rays = [&] {
      std::fill_n(batch.z.begin(), count, internal::kAskModel);
      if (rays) (*rays)(batch, count);
      for (std::size_t i = 0; i < count; ++i) keep(batch, i);
      count = 0;
    };
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        batch.u[count] = window.first[0] + (window.last[0] - window.first[0]) * i / kSteps;
        batch.v[count] = window.first[1] + (window.last[1] - window.first[1]) * j / kSteps;
        if (++count == internal::Batch::kSize) find_rays();
      }
    }
    find_rays();
  }

  /// The largest angle [rad] of these rays that does not exceed `limit` [rad]; -1 if there is none.
  [[nodiscard]] double largest_angle(double limit) const {
    constexpr double kUncertain = 1e-9;  // cosines that are nearer to each other do not decide; angles do
    const double limit_cosine = std::cos(limit);
    const PixelWithRay* furthest = nullptr;
    for (const PixelWithRay& seen : rays_) {
      if (furthest != nullptr && seen.ray[2] >= furthest->ray[2]) continue;
      const double difference = seen.ray[2] - limit_cosine;
      if (std::abs(difference) > kUncertain ? difference > 0.0 : angle_from_axis(seen.ray) <= limit) furthest = &seen;
    }
    if (furthest == nullptr) return -1.0;
    return angle_from_axis(lens_.ray(furthest->pixel).value_or(furthest->ray));  // exactly as Lens computes it
  }

 private:
  static constexpr int kSteps = 24;

  struct PixelWithRay {
    Pixel pixel;
    Ray ray;
  };

  /// Adds the ray of point i of a batch, if it has one.
  void keep(const internal::Batch& batch, std::size_t i) {
    const Pixel pixel = {batch.u[i], batch.v[i]};
    if (std::isfinite(batch.z[i])) {
      rays_.push_back({pixel, {batch.x[i], batch.y[i], batch.z[i]}});
    } else if (batch.z[i] != internal::kNoRay) {
      if (const std::optional<Ray> ray = lens_.ray(pixel)) rays_.push_back({pixel, *ray});
    }
  }

  const Lens& lens_;
  std::vector<PixelWithRay> rays_;
};

/// True if all of many pixels along the image's border have rays. Otherwise the lens ends inside the image.
bool border_is_covered(const Lens& lens, const ImageSize& size) {
  constexpr int kSteps = 64;
  if (lens.model() != nullptr && is_surely_covered(*lens.model(), size)) return true;
  const double width = size.width - 1.0;
  const double height = size.height - 1.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = width * i / kSteps;
    const double y = height * i / kSteps;
    for (const Pixel& pixel : {Pixel{x, 0.0}, Pixel{x, height}, Pixel{0.0, y}, Pixel{width, y}}) {
      if (!lens.ray(pixel)) return false;
    }
  }
  return true;
}

/// A limit of the field of view's largest angle, and the codes of clauses that explain that angle.
struct Limit {
  double rad = std::numbers::pi;
  Code limited{};    ///< The clause if the limit is below the image's largest angle.
  Code unlimited{};  ///< The clause if the limit does not exclude any part of the image.
};

/// The limit that the caller has given.
Limit as_given(double rad) { return {rad, Code::kFieldOfViewGiven, Code::kFieldOfViewInsideGiven}; }

/// The centres of the pixels in the image's corners.
std::array<Pixel, 4> corners_of(const ImageSize& size) {
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  return {{{0.0, 0.0}, {right, 0.0}, {0.0, bottom}, {right, bottom}}};
}

/// The largest angle [rad] in the part of the image inside the circle. Angles grow outwards, so that this angle is on the rim
/// or in a corner of the image. If a pixel there has no ray, returns the model's largest angle. nullopt if no pixel of the rim
/// has a ray.
std::optional<double> largest_angle_in(const LensCircle& circle, const Lens& lens, const ImageSize& size) {
  double largest = 0.0;
  bool model_ends = false;
  // True if the pixel's ray is further from the axis than all before.
  const auto look = [&](const Pixel& pixel) {
    const std::optional<Ray> ray = lens.ray(pixel);
    model_ends = model_ends || !ray;
    const double angle = ray ? angle_from_axis(*ray) : 0.0;
    const bool larger = angle > largest;
    largest = std::max(largest, angle);
    return larger;
  };
  const auto look_at_rim = [&](double azimuth) {
    const Pixel pixel = circle.rim(azimuth);
    return size.holds(pixel) && look(pixel);
  };
  constexpr int kAzimuths = 720;
  constexpr double kSpacing = 2.0 * std::numbers::pi / kAzimuths;
  constexpr double kFinest = 1e-7;
  double furthest = 0.0;
  for (int i = 0; i < kAzimuths; ++i) {
    if (look_at_rim(kSpacing * i)) furthest = kSpacing * i;
  }
  for (double step = 0.5 * kSpacing; step > kFinest; step *= 0.5) {
    for (const double azimuth : {furthest - step, furthest + step}) {
      if (look_at_rim(azimuth)) furthest = azimuth;
    }
  }
  if (!(largest > 0.0)) return std::nullopt;
  for (const Pixel& corner : corners_of(size)) {
    if (circle.contains(corner)) look(corner);
  }
  return model_ends ? lens.max_angle_rad() : largest;
}

/// True if the image size and the limit are valid; otherwise false, with an error.
bool are_valid(const ImageSize& size, std::optional<double> limit_rad, const std::string& name, Diagnostics& diagnostics) {
  if (const Message problem = problem_with_image_size(size); problem.is_said()) {
    diagnostics.add(Code::kImageSizeInvalid, {name, problem});
    return false;
  }
  if (limit_rad && !(*limit_rad > 0.0 && *limit_rad <= std::numbers::pi)) {
    diagnostics.add(Code::kMaxAngleInvalid);
    return false;
  }
  return true;
}

/// The field of view without regard to a circle. `given`: the limit of its angle, if there is one. nullopt, with an error, if
/// no pixel has a ray within the limit.
std::optional<FieldOfView> field_of_view_within(const Lens& lens, const ImageSize& size, const std::optional<Limit>& given,
                                                const std::string& name, Diagnostics& diagnostics) {
  const double limit = given ? given->rad : std::numbers::pi;
  const RayLattice rays(lens, {{0.0, 0.0}, {size.width - 1.0, size.height - 1.0}});
  double largest = rays.largest_angle(limit);
  // A field of view of a few degrees may lie between the points of the coarse lattice.
  if (largest < 0.0 && given) largest = RayLattice(lens, around_axis(lens, size, limit)).largest_angle(limit);
  if (largest < 0.0 && given && rays.largest_angle(std::numbers::pi) >= 0.0) {
    diagnostics.add(Code::kNoPixelInTheLens, {name});
    return std::nullopt;
  }
  if (largest < 0.0) {
    diagnostics.add(Code::kNoPixelHasARay, {name, size.width, size.height});
    return std::nullopt;
  }
  FieldOfView field_of_view;
  field_of_view.size = size;
  const double model_limit = lens.max_angle_rad();
  if (given && rays.largest_angle(std::numbers::pi) > limit) {
    field_of_view.max_angle_rad = limit;
    field_of_view.why = {given->limited};
  } else if (!border_is_covered(lens, size)) {
    field_of_view.max_angle_rad = std::min(model_limit, limit);
    field_of_view.why = {given && limit < model_limit ? given->limited : Code::kFieldOfViewModelEnds};
  } else {
    // The corners are lattice points, so that this is the image's largest angle. With the slack, rounding does not exclude
    // them.
    field_of_view.max_angle_rad = std::min(largest * (1.0 + 1e-12), std::numbers::pi);
    field_of_view.why = {given ? given->unlimited : Code::kFieldOfViewWholeImage};
  }
  return field_of_view;
}

/// Restricts the field of view to the camera's circle. `limit`: the limit of its angle, or null.
void cut_by_circle(const LensCircle& circle, const Camera& camera, const Limit* limit, FieldOfView& field_of_view) {
  const auto is_lit = [&circle](const Pixel& pixel) { return circle.contains(pixel); };
  if (std::ranges::all_of(corners_of(field_of_view.size), is_lit)) {
    field_of_view.why = {Code::kFieldOfViewInsideCircle, {circle.why}};
    return;
  }
  const std::optional<double> largest = largest_angle_in(circle, camera.model, field_of_view.size);
  field_of_view.circle = circle;
  if (!largest) {
    field_of_view.why = {Code::kFieldOfViewAndInsideCircle, {field_of_view.why, circle.why}};
    return;
  }
  constexpr double kSlack = 1.0 + 1e-9;  // rounding must not exclude the rim
  const bool limited = limit != nullptr && field_of_view.max_angle_rad == limit->rad;
  field_of_view.max_angle_rad = std::min(field_of_view.max_angle_rad, *largest * kSlack);
  field_of_view.why = limited ? Message{Code::kFieldOfViewAndCircle, {Message{limit->limited}, circle.why}} : circle.why;
}

}  // namespace

std::optional<Ray> FieldOfView::ray(const Lens& source, const Pixel& pixel) const {
  if (!is_lit(pixel)) return std::nullopt;
  const std::optional<Ray> ray = source.ray(pixel);
  if (!ray || angle_from_axis(*ray) > max_angle_rad) return std::nullopt;
  return ray;
}

std::optional<FieldOfView> field_of_view_of(const Camera& camera, std::optional<double> limit_rad, Diagnostics& diagnostics) {
  bool usable = true;
  for (const Message& problem : validate(camera.model)) {
    diagnostics.add(Code::kNotACamera, {camera.name, problem});
    usable = false;
  }
  if (!camera.image_size) {
    diagnostics.add(Code::kImageSizeNotKnown, {camera.name});
    return std::nullopt;
  }
  if (!usable) return std::nullopt;
  if (!are_valid(*camera.image_size, limit_rad, camera.name, diagnostics)) return std::nullopt;
  std::optional<Limit> limit;
  if (limit_rad) limit = as_given(*limit_rad);
  std::optional<FieldOfView> field_of_view =
      field_of_view_within(camera.model, *camera.image_size, limit, camera.name, diagnostics);
  if (field_of_view && camera.lens_circle)
    cut_by_circle(*camera.lens_circle, camera, limit ? &*limit : nullptr, *field_of_view);
  return field_of_view;
}

std::optional<FieldOfView> field_of_view_of(const Lens& lens, const ImageSize& size, std::optional<double> limit_rad,
                                            const std::string& name, Diagnostics& diagnostics) {
  if (!are_valid(size, limit_rad, name, diagnostics)) return std::nullopt;
  return field_of_view_within(lens, size, limit_rad ? std::optional(as_given(*limit_rad)) : std::nullopt, name, diagnostics);
}

}  // namespace fca
