// SPDX-License-Identifier: BSD-3-Clause
// Where rays come from: a camera model of the list, a model of one's own, or any function pixel -> ray.
#pragma once

#include <fca/models/camera_model.h>

#include <functional>
#include <numbers>
#include <optional>
#include <type_traits>

namespace fca {

/// Pixel -> unit ray; nothing where the lens does not see.
using Unprojection = std::function<std::optional<Ray>(const Pixel&)>;

class Lens {
 public:
  /// A camera model; must outlive the lens.
  Lens(const CameraModel& model) : model_(&model) {}  // NOLINT(google-explicit-constructor): a model is a lens

  /// Any function, with the pixel of the axis, the pixels per radian there, and the angle from the axis where the lens ends.
  Lens(Unprojection ray, const LensCentre& centre, double max_angle_rad = std::numbers::pi)
      : ray_(std::move(ray)), centre_(centre), max_angle_rad_(max_angle_rad) {}

  /// A model of one's own, copied.
  template <CameraModelType M>
  requires(!std::is_constructible_v<CameraModel, Intrinsics<M>>) explicit Lens(const Intrinsics<M>& model)
      : Lens(
            [model](const Pixel& pixel) {
              Ray ray;
              return M::unproject(model.values.data(), pixel.data(), ray.data()) ? std::optional<Ray>(ray) : std::nullopt;
            },
            {M::central_focal_lengths(model.values.data()), M::principal_point(model.values.data())},
            M::max_angle(model.values.data())) {}

  [[nodiscard]] std::optional<Ray> ray(const Pixel& pixel) const {
    return model_ != nullptr ? unproject(*model_, pixel) : ray_(pixel);
  }
  [[nodiscard]] LensCentre centre() const {
    return model_ != nullptr ? LensCentre{central_focal_lengths(*model_), principal_point(*model_)} : centre_;
  }
  /// From the axis.
  [[nodiscard]] double max_angle_rad() const { return model_ != nullptr ? max_angle(*model_) : max_angle_rad_; }
  /// Null unless it is a model of the list.
  [[nodiscard]] const CameraModel* model() const { return model_; }

 private:
  const CameraModel* model_ = nullptr;
  Unprojection ray_;
  LensCentre centre_;
  double max_angle_rad_ = 0.0;
};

}  // namespace fca
