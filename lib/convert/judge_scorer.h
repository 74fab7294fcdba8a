// SPDX-License-Identifier: BSD-3-Clause
// The error of a pair of models at given pixels, many at a time.
#pragma once

#include "batch.h"

#include <fca/convert/judge.h>

#include <cstdint>
#include <optional>
#include <span>

namespace fca::internal {

/// What the pair of models makes of a pixel.
enum class Verdict : std::uint8_t { kOutsideLens, kUnrepresentable, kScored };

struct Point {
  Pixel pixel{};
  double weight = 0.0;  ///< pixels
  double error = 0.0;   ///< px
  double cosine = 0.0;  ///< of the ray's angle from the axis, if scored
  Verdict verdict = Verdict::kOutsideLens;
};

/// Source, target and domain of a judgement.
class Scorer {
 public:
  /// One of `model` and `program` is the target, the other null; both are kept by reference.
  Scorer(Lens source, const CameraModel* model, const Projection* program, const Domain& domain, double target_reach_rad);

  /// Fills in error, cosine and verdict. Models are chosen once per call: give many points at a time.
  void score(std::span<Point> points) const;
  [[nodiscard]] Point at(const Pixel& pixel) const;

  [[nodiscard]] const Lens& source() const { return source_; }
  /// Null if the target is a program.
  [[nodiscard]] const CameraModel* target() const { return model_; }
  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] double target_reach_rad() const { return reach_.angle; }

 private:
  /// "Not further from the axis than", decided by the cosine of a unit ray, and by the angle itself where that is close.
  struct Limit {
    double angle;
    double cosine;
    explicit Limit(double angle_rad);
    [[nodiscard]] bool admits(const Ray& unit_ray) const;
    /// By the cosine alone: true only where that is not close.
    [[nodiscard]] bool surely_admits(double ray_cosine) const { return ray_cosine - cosine > kClose; }
    static constexpr double kClose = 1e-9;
  };

  /// Rays and cosines of a batch, and which of the pixels the lens sees.
  void see(Batch& batch, std::span<Point> points) const;
  /// Errors of those seen.
  void compare(Batch& batch, std::span<Point> points) const;
  [[nodiscard]] std::optional<Pixel> image_of(const Ray& ray) const;

  Lens source_;
  const CameraModel* model_;
  const Projection* program_;
  const Domain& domain_;
  Limit lens_;
  Limit reach_;
  Limit surely_reached_;               ///< Within it, a batch needs not ask the model for its domain.
  std::optional<BatchRays> rays_;      ///< Of a source of the list.
  std::optional<BatchErrors> errors_;  ///< Of a target of the list.
};

}  // namespace fca::internal
