// SPDX-License-Identifier: BSD-3-Clause
// The error [px] at pixels of a source camera: the distance between the pixel and the target's pixel of the same ray. Many
// pixels are evaluated at a time.
#pragma once

#include "../../models/kernels/batch.h"

#include <fca/convert/angle_limit.h>
#include <fca/convert/evaluate.h>

#include <optional>
#include <span>

namespace fca::internal {

/// Compares a source with a target in a field of view. Batch kernels (models/kernels) evaluate most pixels. Where a kernel is
/// not certain, the models themselves are used.
class Scorer {
 public:
  /// The target is `model` or `program`; the other is null. The target and `field_of_view` must outlive the scorer.
  /// `target_max_angle_rad`: the angle from the axis up to which the target has pixels.
  Scorer(Lens source, const CameraModel* model, const Projection* program, const FieldOfView& field_of_view,
         double target_max_angle_rad);

  /// Computes the ray, the error and the verdict of the first `count` points of the batch. True if the kernel alone found that
  /// all of them are scored. A call with many points is faster per point.
  bool score(Batch& batch, std::size_t count) const;
  /// Computes the error, the cosine and the verdict of the points.
  void score(std::span<Point> points) const;
  /// Computes only the source's rays. Their z is kNoRay if the pixel is certainly outside the field of view, and kAskModel if
  /// the kernel is not certain (models/kernels/rays.h).
  void find_rays(Batch& batch, std::size_t count) const;
  /// The error at one pixel.
  [[nodiscard]] Point at(const Pixel& pixel) const;

  [[nodiscard]] const Lens& source() const { return source_; }
  /// Null if the target is a program.
  [[nodiscard]] const CameraModel* target() const { return model_; }
  [[nodiscard]] const FieldOfView& field_of_view() const { return field_of_view_; }
  [[nodiscard]] double target_max_angle_rad() const { return max_angle_.angle; }

 private:
  /// The verdict of point i of the batch. Computes its ray and error with the models themselves if the kernels did not.
  [[nodiscard]] Verdict verdict_of(Batch& batch, std::size_t i) const;

  Lens source_;
  const CameraModel* model_;
  const Projection* program_;
  const FieldOfView& field_of_view_;
  AngleLimit field_of_view_limit_;  ///< The field of view's largest angle.
  AngleLimit max_angle_;            ///< The target has no pixel for rays beyond this angle.
  AngleLimit surely_reached_;       ///< The target certainly has a pixel for rays within this angle.
  double surely_scored_;  ///< Rays whose angle has a larger cosine are certainly scored, unless the field of view has a circle.
  std::optional<BatchRays> rays_;      ///< The kernel of the source; nullopt if the source is no valid camera model.
  std::optional<BatchErrors> errors_;  ///< The kernel of the target; nullopt if the target is no valid camera model.
};

}  // namespace fca::internal
