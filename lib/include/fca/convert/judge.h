// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/lens.h>
#include <fca/convert/report.h>

#include <functional>
#include <numbers>
#include <optional>

namespace fca {

/// Any function ray -> pixel: a model, or what a program does.
using Projection = std::function<std::optional<Pixel>(const Ray&)>;

/// The projection of a model, one's own for instance, copied.
template <CameraModelType M>
[[nodiscard]] Projection projection_of(const Intrinsics<M>& model) {
  return [model](const Ray& ray) {
    Pixel pixel;
    return M::project(model.values.data(), ray.data(), pixel.data()) ? std::optional<Pixel>(pixel) : std::nullopt;
  };
}

struct JudgeOptions {
  bool every_pixel = false;  ///< Score each pixel of the image instead of a lattice, and count them.
  bool bound = true;         ///< Prove ErrorSummary::bound (both must be models of the list).
  /// The target counts as unable to represent what lies further from the axis: the cone to which a conversion was restricted.
  double target_reach_rad = std::numbers::pi;
};

/// Compares `target` with `source` over the domain, on a lattice of 3,000 to 6,000 points that includes the image's border and
/// has nothing to do with the points of a fit: spokes from the principal point, cut at the borders of the angle bands and at
/// the edges of the lens and of the target's reach. Points are weighted by area, so that rms, bands and shares are the image's;
/// small images are judged pixel by pixel. The maximum is polished between lattice points and along the edge of the lens to
/// 1e-3 px in position. Its bound is proven by branch and bound on enclosures of both models, for all rays of the domain
/// (lib/convert/bound.h says how): typically 1 % above the maximum.
[[nodiscard]] Judgement judge(const Lens& source, const Projection& target, const Domain& domain,
                              const JudgeOptions& options = {});
[[nodiscard]] Judgement judge(const Lens& source, const CameraModel& target, const Domain& domain,
                              const JudgeOptions& options = {});

}  // namespace fca
