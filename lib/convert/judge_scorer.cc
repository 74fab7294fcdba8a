// SPDX-License-Identifier: BSD-3-Clause
#include "judge_scorer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace fca::internal {

namespace {

/// How well a model's last angle is known. Past it project() would say no, too, but only after looking for it: slow for
/// polynomials. What is closer, rounding included, is left to project().
constexpr double kLastAngleSlack = 1e-7;

}  // namespace

Scorer::Limit::Limit(double angle_rad) : angle(angle_rad), cosine(angle_rad < std::numbers::pi ? std::cos(angle_rad) : -2.0) {}

bool Scorer::Limit::admits(const Ray& unit_ray) const {
  const double difference = unit_ray[2] - cosine;
  return std::abs(difference) > kClose ? difference > 0.0 : angle_from_axis(unit_ray) <= angle;
}

Scorer::Scorer(Lens source, const CameraModel* model, const Projection* program, const Domain& domain, double target_reach_rad)
    : source_(std::move(source)),
      model_(model),
      program_(program),
      domain_(domain),
      lens_(domain.max_angle_rad),
      reach_(target_reach_rad),
      surely_reached_(0.0) {
  if (source_.model() != nullptr && validate(*source_.model()).empty()) rays_.emplace(*source_.model(), lens_.angle);
  if (model_ == nullptr) return;
  const double last = max_angle(*model_);
  reach_ = Limit(std::min(target_reach_rad, last + kLastAngleSlack));
  surely_reached_ = Limit(std::min(target_reach_rad, last - kLastAngleSlack));
  if (validate(*model_).empty()) errors_.emplace(*model_, std::min(lens_.angle, surely_reached_.angle));
}

void Scorer::score(std::span<Point> points) const {
  Batch batch;
  for (; !points.empty(); points = points.subspan(std::min(Batch::kSize, points.size()))) {
    const std::span<Point> some = points.first(std::min(Batch::kSize, points.size()));
    see(batch, some);
    compare(batch, some);
  }
}

void Scorer::see(Batch& batch, std::span<Point> points) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    batch.u[i] = points[i].pixel[0];
    batch.v[i] = points[i].pixel[1];
    batch.x[i] = batch.y[i] = 0.0;
    batch.z[i] = kAskModel;
  }
  if (rays_) (*rays_)(batch, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& point = points[i];
    point.verdict = Verdict::kOutsideLens;
    if (batch.z[i] == kNoRay) continue;
    if (!std::isfinite(batch.z[i])) {
      const std::optional<Ray> ray = source_.ray(point.pixel);
      if (!ray) continue;
      batch.x[i] = (*ray)[0];
      batch.y[i] = (*ray)[1];
      batch.z[i] = (*ray)[2];
    }
    point.cosine = batch.z[i];
    if (lens_.admits({batch.x[i], batch.y[i], batch.z[i]})) point.verdict = Verdict::kUnrepresentable;
  }
}

std::optional<Pixel> Scorer::image_of(const Ray& ray) const {
  return model_ != nullptr ? project(*model_, ray) : (*program_)(ray);
}

void Scorer::compare(Batch& batch, std::span<Point> points) const {
  if (errors_) (*errors_)(batch, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& point = points[i];
    if (point.verdict == Verdict::kOutsideLens) continue;
    if (errors_ && surely_reached_.surely_admits(batch.z[i]) && std::isfinite(batch.error[i])) {
      point.error = batch.error[i];
      point.verdict = Verdict::kScored;
      continue;
    }
    const Ray ray = {batch.x[i], batch.y[i], batch.z[i]};
    if (!reach_.admits(ray)) continue;
    const std::optional<Pixel> image = image_of(ray);
    if (!image) continue;
    const double du = (*image)[0] - point.pixel[0];
    const double dv = (*image)[1] - point.pixel[1];
    const double square = du * du + dv * dv;
    if (!std::isfinite(square)) continue;
    point.error = std::sqrt(square);
    point.verdict = Verdict::kScored;
  }
}

Point Scorer::at(const Pixel& pixel) const {
  Point point;
  point.pixel = pixel;
  score({&point, 1});
  return point;
}

}  // namespace fca::internal
