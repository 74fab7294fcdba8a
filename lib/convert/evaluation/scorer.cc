// SPDX-License-Identifier: BSD-3-Clause
#include "scorer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace fca::internal {

namespace {

/// The assumed error [rad] of max_angle(). Rays beyond a model's largest angle have no pixel, but project() of a polynomial
/// model takes long to find this. So project() decides only for rays that are within this distance of the largest angle.
constexpr double kLastAngleSlack = 1e-7;

/// A value of surely_scored_ with which no ray is certainly scored: it is larger than every cosine.
constexpr double kAboveEveryCosine = 2.0;

}  // namespace

Scorer::Scorer(Lens source, const CameraModel* model, const Projection* program, const FieldOfView& field_of_view,
               double target_max_angle_rad)
    : source_(std::move(source)),
      model_(model),
      program_(program),
      field_of_view_(field_of_view),
      field_of_view_limit_(field_of_view.max_angle_rad),
      max_angle_(target_max_angle_rad),
      surely_reached_(0.0),
      surely_scored_(kAboveEveryCosine) {
  if (source_.model() != nullptr && validate(*source_.model()).empty())
    rays_.emplace(*source_.model(), field_of_view_limit_.angle);
  if (model_ == nullptr) return;
  const double last = max_angle(*model_);
  max_angle_ = AngleLimit(std::min(target_max_angle_rad, last + kLastAngleSlack));
  surely_reached_ = AngleLimit(std::min(target_max_angle_rad, last - kLastAngleSlack));
  if (validate(*model_).empty()) errors_.emplace(*model_, std::min(field_of_view_limit_.angle, surely_reached_.angle));
  surely_scored_ = std::max(field_of_view_limit_.cosine, surely_reached_.cosine) + AngleLimit::kClose;
}

void Scorer::find_rays(Batch& batch, std::size_t count) const {
  if (rays_) {
    (*rays_)(batch, count);
  } else {
    std::fill_n(batch.x.begin(), count, 0.0);
    std::fill_n(batch.y.begin(), count, 0.0);
    std::fill_n(batch.z.begin(), count, kAskModel);
  }
}

bool Scorer::score(Batch& batch, std::size_t count) const {
  find_rays(batch, count);
  if (errors_) {
    (*errors_)(batch, count);
  } else {
    std::fill_n(batch.error.begin(), count, kAskModel);
  }
  if (!field_of_view_.circle && all_within(batch, count, surely_scored_)) {
    std::fill_n(batch.verdict.begin(), count, Verdict::kScored);
    return true;
  }
  for (std::size_t i = 0; i < count; ++i) batch.verdict[i] = verdict_of(batch, i);
  return false;
}

Verdict Scorer::verdict_of(Batch& batch, std::size_t i) const {
  const Pixel pixel = {batch.u[i], batch.v[i]};
  if (batch.z[i] == kNoRay || !field_of_view_.is_lit(pixel)) return Verdict::kOutsideLens;
  const bool computed = std::isfinite(batch.z[i]);
  if (!computed) {
    const std::optional<Ray> ray = source_.ray(pixel);
    if (!ray) return Verdict::kOutsideLens;
    batch.x[i] = (*ray)[0];
    batch.y[i] = (*ray)[1];
    batch.z[i] = (*ray)[2];
  }
  const Ray ray = {batch.x[i], batch.y[i], batch.z[i]};
  if (!field_of_view_limit_.admits(ray)) return Verdict::kOutsideLens;
  if (computed && surely_reached_.surely_admits(ray[2]) && std::isfinite(batch.error[i])) return Verdict::kScored;
  if (!max_angle_.admits(ray)) return Verdict::kUnrepresentable;
  const std::optional<Pixel> image = model_ != nullptr ? project(*model_, ray) : (*program_)(ray);
  if (!image) return Verdict::kUnrepresentable;
  const double du = (*image)[0] - pixel[0];
  const double dv = (*image)[1] - pixel[1];
  batch.error[i] = std::sqrt(du * du + dv * dv);
  return std::isfinite(batch.error[i]) ? Verdict::kScored : Verdict::kUnrepresentable;
}

void Scorer::score(std::span<Point> points) const {
  Batch batch;
  for (; !points.empty(); points = points.subspan(std::min(Batch::kSize, points.size()))) {
    const std::span<Point> some = points.first(std::min(Batch::kSize, points.size()));
    for (std::size_t i = 0; i < some.size(); ++i) {
      batch.u[i] = some[i].pixel[0];
      batch.v[i] = some[i].pixel[1];
    }
    score(batch, some.size());
    for (std::size_t i = 0; i < some.size(); ++i) {
      some[i].error = batch.error[i];
      some[i].cosine = batch.z[i];
      some[i].verdict = batch.verdict[i];
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
