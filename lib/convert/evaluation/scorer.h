// SPDX-License-Identifier: BSD-3-Clause
// The error of a pair of models at given pixels, many at a time.
#pragma once

#include "../../models/kernels/batch.h"

#include <fca/convert/angle_limit.h>
#include <fca/convert/judge.h>

#include <optional>
#include <span>

namespace fca::internal {

/// Source, target and domain of a judgement.
class Scorer {
 public:
  /// One of `model` and `program` is the target, the other null; both are kept by reference.
  Scorer(Lens source, const CameraModel* model, const Projection* program, const Domain& domain, double target_reach_rad);

  /// Fills in error, cosine and verdict. Models are chosen once per call: give many points at a time. True if all are surely
  /// scored.
  bool score(Batch& batch, std::size_t count) const;
  void score(std::span<Point> points) const;
  /// The source's rays alone; z may be kNoRay, surely beyond the domain, or kAskModel.
  void find_rays(Batch& batch, std::size_t count) const;
  [[nodiscard]] Point at(const Pixel& pixel) const;

  [[nodiscard]] const Lens& source() const { return source_; }
  /// Null if the target is a program.
  [[nodiscard]] const CameraModel* target() const { return model_; }
  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] double target_reach_rad() const { return reach_.angle; }

 private:
  /// Asks the models for what the batch has not found, and decides.
  [[nodiscard]] Verdict look_closer(Batch& batch, std::size_t i) const;
  [[nodiscard]] std::optional<Pixel> image_of(const Ray& ray) const;

  Lens source_;
  const CameraModel* model_;
  const Projection* program_;
  const Domain& domain_;
  AngleLimit lens_;
  AngleLimit reach_;
  AngleLimit surely_reached_;          ///< Within it, a batch needs not ask the model for its domain.
  double surely_scored_;               ///< The cosine above which both limits hold.
  std::optional<BatchRays> rays_;      ///< Of a source of the list.
  std::optional<BatchErrors> errors_;  ///< Of a target of the list.
};

}  // namespace fca::internal
