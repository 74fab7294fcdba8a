// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rectify/vertical_disparity.h>

#include <fca/rig/rotation.h>

#include <array>
#include <cmath>

namespace fca {

namespace {

/// One rectified image and the camera behind it.
class View {
 public:
  View(const MeantCamera& camera, const RectifiedPair& pair, std::size_t view)
      : camera_(camera),
        model_(rectified_camera(pair, view, {}).model),
        T_rectified_camera_(pair.views.at(view).T_rectified_camera),
        T_camera_rectified_(inverse(T_rectified_camera_).value_or(Transform())) {}

  /// The source camera's ray of what the rectified image shows there.
  [[nodiscard]] std::optional<Ray> source_ray(const Pixel& rectified) const {
    const std::optional<Ray> ray = unproject(model_, rectified);
    const std::optional<Pixel> pixel = ray ? project(camera_.meant, rotated(T_camera_rectified_, *ray)) : std::nullopt;
    if (!pixel || !camera_.source.image_size->holds(*pixel)) return std::nullopt;
    return unproject(camera_.source.model, *pixel);
  }
  /// Where the rectified image shows what the source camera sees in a direction.
  [[nodiscard]] std::optional<Pixel> rectified(const Ray& source_ray) const {
    const std::optional<Pixel> pixel = project(camera_.source.model, source_ray);
    if (!pixel || !camera_.source.image_size->holds(*pixel)) return std::nullopt;
    const std::optional<Ray> ray = unproject(camera_.meant, *pixel);
    return ray ? project(model_, rotated(T_rectified_camera_, *ray)) : std::nullopt;
  }

 private:
  const MeantCamera& camera_;
  CameraModel model_;
  Transform T_rectified_camera_;
  Transform T_camera_rectified_;
};

/// Sums of squares over the lattice.
class Sums {
 public:
  void add(const Pixel& at, double difference) {
    ++seen_;
    squares_ += difference * difference;
    if (std::abs(difference) <= result_.max_px && seen_ > 1) return;
    result_.max_px = std::abs(difference);
    result_.max_at = at;
  }
  [[nodiscard]] std::optional<RowDifference> result(int points) const {
    if (seen_ == 0) return std::nullopt;
    RowDifference result = result_;
    result.rms_px = std::sqrt(squares_ / seen_);
    result.share = static_cast<double>(seen_) / points;
    return result;
  }

 private:
  RowDifference result_;
  double squares_ = 0.0;
  int seen_ = 0;
};

/// Over so many columns and rows.
std::optional<VerticalDisparity> measured(int steps, const MeantCamera& first, const MeantCamera& second,
                                          const Transform& T_second_first, const RectifiedPair& pair, const ImageSize& size) {
  const View here(first, pair, 0);
  const View there(second, pair, 1);
  const double distance_m = kNearPoints * distance_of(T_second_first);
  const std::array<double, 3> t = translation_of(T_second_first);
  const std::size_t across = pair.is_vertical ? 0 : 1;
  std::array<Sums, 2> sums;  // at infinity, at ten baselines
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Pixel pixel = {(size.width - 1.0) * i / (steps - 1), (size.height - 1.0) * j / (steps - 1)};
      const std::optional<Ray> ray = here.source_ray(pixel);
      if (!ray) continue;
      const Ray turned = rotated(T_second_first, *ray);
      const Ray near = {distance_m * turned[0] + t[0], distance_m * turned[1] + t[1], distance_m * turned[2] + t[2]};
      for (std::size_t k = 0; k < 2; ++k) {
        const std::optional<Pixel> match = there.rectified(k == 0 ? turned : near);
        if (match && size.holds(*match)) sums.at(k).add(pixel, match->at(across) - pixel.at(across));
      }
    }
  }
  const std::optional<RowDifference> far_away = sums[0].result(steps * steps);
  const std::optional<RowDifference> near = sums[1].result(steps * steps);
  if (!far_away || !near) return std::nullopt;
  return VerticalDisparity{*far_away, *near};
}

}  // namespace

std::optional<VerticalDisparity> vertical_disparity(const MeantCamera& first, const MeantCamera& second,
                                                    const Transform& T_second_first, const RectifiedPair& pair,
                                                    const ImageSize& size) {
  constexpr int kSteps = 64;
  return measured(kSteps, first, second, T_second_first, pair, size);
}

std::optional<PairError> pair_error(const MeantCamera& first, const MeantCamera& second, const Transform& T_second_first,
                                    const Transform& T_meant) {
  const bool is_kept = first.meant == first.source.model && second.meant == second.source.model && T_meant == T_second_first;
  if (is_kept) return PairError{first.source.name, second.source.name, {}};
  const auto meant = [](const MeantCamera& camera) {
    Camera result = camera.source;
    result.model = camera.meant;
    return result;
  };
  Diagnostics discarded;  // who asks has not asked for a rectification
  RectifyOptions options;
  options.valid_regions = false;
  const std::optional<RectifiedPair> pair = rectify(meant(first), meant(second), T_meant, options, discarded);
  if (!pair) return std::nullopt;
  constexpr int kSteps = 32;
  const std::optional<VerticalDisparity> disparity = measured(kSteps, first, second, T_second_first, *pair, *pair->size);
  return disparity ? std::optional(PairError{first.source.name, second.source.name, *disparity}) : std::nullopt;
}

}  // namespace fca
