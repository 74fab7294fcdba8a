// SPDX-License-Identifier: BSD-3-Clause
#include "judge_scorer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fca::internal {

namespace {

/// Past a model's last angle project() would say no, too, but only after looking for it: slow for polynomials. What is closer
/// than this, rounding included, is left to project().
double just_beyond(double angle) {
  constexpr double kSlack = 1e-7;
  return angle + kSlack;
}

}  // namespace

Scorer::Limit::Limit(double angle_rad) : angle(angle_rad), cosine(angle_rad < std::numbers::pi ? std::cos(angle_rad) : -2.0) {}

bool Scorer::Limit::admits(const Ray& unit_ray) const {
  constexpr double kClose = 1e-9;
  const double difference = unit_ray[2] - cosine;
  return std::abs(difference) > kClose ? difference > 0.0 : angle_from_axis(unit_ray) <= angle;
}

Scorer::Scorer(Lens source, const CameraModel* model, const Projection* program, const Domain& domain, double target_reach_rad)
    : source_(std::move(source)),
      model_(model),
      program_(program),
      domain_(domain),
      lens_(domain.max_angle_rad),
      reach_(model != nullptr ? std::min(target_reach_rad, just_beyond(max_angle(*model))) : target_reach_rad) {}

void Scorer::score(std::span<Point> points) const {
  constexpr std::size_t kBatch = 256;
  std::array<Ray, kBatch> rays;
  for (; !points.empty(); points = points.subspan(std::min(kBatch, points.size()))) {
    const std::span<Point> batch = points.first(std::min(kBatch, points.size()));
    const auto see = [&](const auto& ray_of) {
      for (std::size_t i = 0; i < batch.size(); ++i) {
        Point& point = batch[i];
        const bool seen = ray_of(point.pixel, rays[i]) && lens_.admits(rays[i]);
        point.verdict = seen ? Verdict::kUnrepresentable : Verdict::kOutsideLens;
        point.cosine = rays[i][2];
      }
    };
    if (source_.model() != nullptr) {
      std::visit(
          [&]<class M>(const Intrinsics<M>& source) {
            see([&](const Pixel& pixel, Ray& ray) { return M::unproject(source.values.data(), pixel.data(), ray.data()); });
          },
          *source_.model());
    } else {
      see([&](const Pixel& pixel, Ray& ray) {
        const std::optional<Ray> seen = source_.ray(pixel);
        if (seen) ray = *seen;
        return seen.has_value();
      });
    }
    const auto compare = [&](const auto& project_ray) {
      for (std::size_t i = 0; i < batch.size(); ++i) {
        Point& point = batch[i];
        Pixel image{};
        if (point.verdict == Verdict::kOutsideLens || !reach_.admits(rays[i]) || !project_ray(rays[i], image)) continue;
        const double du = image[0] - point.pixel[0];
        const double dv = image[1] - point.pixel[1];
        const double square = du * du + dv * dv;
        if (!std::isfinite(square)) continue;
        point.error = std::sqrt(square);
        point.verdict = Verdict::kScored;
      }
    };
    if (model_ != nullptr) {
      std::visit(
          [&]<class M>(const Intrinsics<M>& target) {
            compare([&](const Ray& ray, Pixel& image) { return M::project(target.values.data(), ray.data(), image.data()); });
          },
          *model_);
    } else {
      compare([&](const Ray& ray, Pixel& image) {
        const std::optional<Pixel> pixel = (*program_)(ray);
        if (pixel) image = *pixel;
        return pixel.has_value();
      });
    }
  }
}

Point Scorer::at(const Pixel& pixel) const {
  Point point;
  point.pixel = pixel;
  score({&point, 1});
  return point;
}

}  // namespace fca::internal
