// SPDX-License-Identifier: BSD-3-Clause
// For many pixels of a source camera at a time: how far from each [px] the target images the pixel's ray.
#pragma once

#include "../../models/kernels/batch.h"

#include <fca/convert/angle_limit.h>
#include <fca/convert/evaluate.h>

#include <optional>
#include <span>

namespace fca::internal {

/// Compares a source with a target in a field of view of pixels and angles. A batch kernel answers most pixels; the models
/// themselves answer those about which it is not sure.
class Scorer {
 public:
  /// The target is `model` or `program`; the other is null. The target and `field_of_view` must outlive the scorer.
  /// `target_max_angle_rad`: the angle from the axis up to which the target has pixels.
  Scorer(Lens source, const CameraModel* model, const Projection* program, const FieldOfView& field_of_view,
         double target_max_angle_rad);

  /// Fills in error, cosine and verdict of the first `count` points. Each call chooses the models' code once, so give it many
  /// points. True if the kernel alone found that all are scored.
  bool score(Batch& batch, std::size_t count) const;
  void score(std::span<Point> points) const;
  /// Only the source's rays. Their z is kNoRay where the pixel is certainly outside the field of view, kAskModel where the
  /// kernel is not sure (models/kernels/rays.h).
  void find_rays(Batch& batch, std::size_t count) const;
  [[nodiscard]] Point at(const Pixel& pixel) const;

  [[nodiscard]] const Lens& source() const { return source_; }
  /// Null if the target is a program.
  [[nodiscard]] const CameraModel* target() const { return model_; }
  [[nodiscard]] const FieldOfView& field_of_view() const { return field_of_view_; }
  [[nodiscard]] double target_max_angle_rad() const { return max_angle_.angle; }

 private:
  /// The verdict of one point, with the models' answers where the kernel had none.
  [[nodiscard]] Verdict look_closer(Batch& batch, std::size_t i) const;
  [[nodiscard]] std::optional<Pixel> image_of(const Ray& ray) const;

  Lens source_;
  const CameraModel* model_;
  const Projection* program_;
  const FieldOfView& field_of_view_;
  AngleLimit lens_;
  AngleLimit max_angle_;
  AngleLimit surely_reached_;      ///< Rays within it are certainly in the target's domain.
  double surely_scored_;           ///< If the cosine of a ray's angle is larger, the ray is within lens_ and surely_reached_.
  std::optional<BatchRays> rays_;  ///< Nothing if the source is no valid camera model.
  std::optional<BatchErrors> errors_;  ///< Nothing if the target is no valid camera model.
};

}  // namespace fca::internal
