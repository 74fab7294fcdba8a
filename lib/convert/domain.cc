// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/domain.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

// Larger than any sensor; keeps w * h and the lattices far from overflow.
constexpr int kLargestImageSide = 100'000;

/// The largest angle among the rays of the image's border and of a coarse lattice: the border alone would miss a lens that ends
/// inside the image.
double largest_angle(const Lens& lens, const ImageSize& size, double limit) {
  constexpr int kSteps = 48;
  double largest = -1.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(size.width - 1.0) * i / kSteps, (size.height - 1.0) * j / kSteps};
      const std::optional<Ray> ray = lens.ray(pixel);
      if (!ray) continue;
      const double angle = angle_from_axis(*ray);
      if (angle <= limit) largest = std::max(largest, angle);
    }
  }
  return largest;
}

/// Does every pixel of the border have a ray? If not, the lens ends inside the image.
bool border_is_covered(const Lens& lens, const ImageSize& size) {
  constexpr int kSteps = 64;
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

}  // namespace

double angle_from_axis(const Ray& ray) { return std::atan2(std::hypot(ray[0], ray[1]), ray[2]); }

std::optional<Ray> Domain::ray(const Lens& source, const Pixel& pixel) const {
  const std::optional<Ray> ray = source.ray(pixel);
  if (!ray || angle_from_axis(*ray) > max_angle_rad) return std::nullopt;
  return ray;
}

std::optional<Domain> domain_of(const Camera& camera, std::optional<double> limit_rad, Diagnostics& diagnostics) {
  bool usable = true;
  for (const std::string& problem : validate(camera.model)) {
    diagnostics.error("not-a-camera", camera.name + ": " + problem);
    usable = false;
  }
  if (!camera.image_size) {
    diagnostics.error("image-size-missing", camera.name + ": the image size is not known", {}, "give it: --size WIDTHxHEIGHT");
    return std::nullopt;
  }
  if (!usable) return std::nullopt;
  return domain_of(camera.model, *camera.image_size, limit_rad, camera.name, diagnostics);
}

std::optional<Domain> domain_of(const Lens& lens, const ImageSize& size, std::optional<double> limit_rad,
                                const std::string& name, Diagnostics& diagnostics) {
  if (size.width < 1 || size.height < 1 || size.width > kLargestImageSide || size.height > kLargestImageSide) {
    diagnostics.error("image-size-invalid", name + ": an image of " + std::to_string(size.width) + " x " +
                                                std::to_string(size.height) + " pixels cannot be");
    return std::nullopt;
  }
  if (limit_rad && !(*limit_rad > 0.0 && *limit_rad <= std::numbers::pi)) {
    diagnostics.error("max-angle-invalid", "the largest angle from the axis must lie in (0, 180] degrees");
    return std::nullopt;
  }

  const double limit = limit_rad.value_or(std::numbers::pi);
  const double largest = largest_angle(lens, size, limit);
  if (largest < 0.0 && limit_rad && largest_angle(lens, size, std::numbers::pi) >= 0.0) {
    diagnostics.error("no-pixel-in-the-lens", name + ": no pixel of the image lies within that angle of the axis", {},
                      "a larger --max-angle");
    return std::nullopt;
  }
  if (largest < 0.0) {
    diagnostics.error("no-pixel-has-a-ray", name + ": the model gives no ray for any pixel of the " +
                                                std::to_string(size.width) + " x " + std::to_string(size.height) +
                                                " image; are focal length and principal point in pixels of this image?");
    return std::nullopt;
  }
  Domain domain;
  domain.size = size;
  const double model_limit = lens.max_angle_rad();
  if (limit_rad && largest_angle(lens, size, std::numbers::pi) > limit) {
    domain.max_angle_rad = limit;
    domain.why = "given (--max-angle)";
  } else if (!border_is_covered(lens, size)) {
    domain.max_angle_rad = std::min(model_limit, limit);
    domain.why = "the source model ends there, inside the image";
  } else {
    // Corners are lattice points, so this is the image's own largest angle; the slack keeps rounding from dropping them.
    domain.max_angle_rad = std::min(largest * (1.0 + 1e-12), std::numbers::pi);
    domain.why = "the whole image (nothing states the lens's angle)";
  }
  return domain;
}

}  // namespace fca
