// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/field_of_view.h>
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

struct EvaluateOptions {
  bool every_pixel = false;  ///< Score each pixel of the image instead of a lattice, and count them.
  /// Prove ErrorSummary::bound. Both must be models of the list: a proof encloses a model over whole ranges of rays with every
  /// rounding counted, for which the listed ones are written a second time, in ball arithmetic (lib/convert/bound/polar.h). A
  /// function can only be asked at points, and M::formula promises no more than to work on doubles: from either one gets a
  /// largest error that was seen (polished, like that of listed models), or a derivative that was seen, but nothing that holds
  /// between. The bound is then infinite.
  bool bound = true;
  /// The target counts as unable to represent what lies further from the axis: the angle to which a conversion was reduced.
  double target_max_angle_rad = std::numbers::pi;
};

/// Compares `target` with `source` over the field of view, on a lattice of at least 4,000 points (mostly under 6,000) that
/// includes the image's border and has nothing to do with the points of a fit: spokes from the principal point, cut at the
/// borders of the angle bands and at the edges of the lens and of the target's maximum angle. Rms, bands and shares are those
/// of all pixels, each counted once: points are weighted by the pixels they stand for, and the rms is within 0.3 % of that of
/// every pixel; small images are evaluated pixel by pixel, and so are those of up to half a megapixel whose largest error is
/// more than 15 times the rms, of up to two megapixels more than 100 times: what is lost in so few places no lattice tells. The
/// maximum is polished between lattice points and along the edge of the lens to 1e-3 px in position. Its bound is proven by
/// branch and bound on enclosures of both models, for all rays of the field of view (lib/convert/bound.h says how): typically 1
/// % above the maximum.
[[nodiscard]] ErrorStatistics evaluate(const Lens& source, const Projection& target, const FieldOfView& field_of_view,
                                       const EvaluateOptions& options = {});
[[nodiscard]] ErrorStatistics evaluate(const Lens& source, const CameraModel& target, const FieldOfView& field_of_view,
                                       const EvaluateOptions& options = {});

}  // namespace fca
