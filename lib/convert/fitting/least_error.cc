// SPDX-License-Identifier: BSD-3-Clause
// See fca/convert/least_error.h.
#include "fit_model.h"

#include <fca/convert/fit_target.h>
#include <fca/convert/least_error.h>
#include <fca/rig/rotation.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace fca {

namespace {

using Index = Eigen::Index;

/// Samples at a grid of 12 x 12 pixels of the image: those within the lens circle that have a ray within `max_angle_rad` of the
/// axis.
std::vector<Correspondence> grid_of(const Camera& camera, std::optional<double> max_angle_rad) {
  constexpr int kSteps = 12;
  std::vector<Correspondence> samples;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Pixel pixel = {(i + 0.5) / kSteps * camera.image_size->width - 0.5,
                           (j + 0.5) / kSteps * camera.image_size->height - 0.5};
      if (camera.lens_circle && !camera.lens_circle->contains(pixel)) continue;
      const std::optional<Ray> ray = unproject(camera.model, pixel);
      if (ray && !(max_angle_rad && angle_from_axis(*ray) > *max_angle_rad)) samples.push_back({*ray, pixel});
    }
  }
  return samples;
}

/// The smallest |coordinates - columns c|^2 that any coefficients c give.
double least_squares(Eigen::MatrixXd columns, const Eigen::VectorXd& coordinates) {
  // The columns are powers of the angle or radius, whose sizes differ by many orders of magnitude.
  for (Index i = 0; i < columns.cols(); ++i) columns.col(i).normalize();
  return (coordinates - columns * columns.colPivHouseholderQr().solve(coordinates)).squaredNorm();
}

}  // namespace

std::optional<double> least_rms_px(const Camera& camera, std::string_view model_id, std::optional<double> max_angle_rad) {
  const std::optional<CameraModel> model = make_model(model_id);
  if (!model || !camera.image_size || !camera.rays.empty()) return std::nullopt;
  const std::unique_ptr<internal::FitTarget> target = internal::fit_target_of(*model);
  const std::vector<Correspondence> samples = grid_of(camera, max_angle_rad);
  if (target->terms() == 0 || !target->shapes().empty() || samples.empty()) return std::nullopt;
  // The model is u = cx + c . along_u, v = cy + aspect c . along_v. The limit fits u and v separately, each with its own c.
  const auto rows = static_cast<Index>(samples.size());
  const auto terms = static_cast<Index>(target->terms());
  Eigen::MatrixXd of_u = Eigen::MatrixXd::Ones(rows, terms + 1);
  Eigen::MatrixXd of_v = of_u;
  Eigen::VectorXd u(rows);
  Eigen::VectorXd v(rows);
  for (Index row = 0; row < rows; ++row) {
    const Correspondence& sample = samples[static_cast<std::size_t>(row)];
    std::array<double, internal::kMostTerms> along_u{};
    std::array<double, internal::kMostTerms> along_v{};
    constexpr double kNoShape = 0.0;
    if (!target->terms(kNoShape, sample.ray.data(), along_u.data(), along_v.data())) return std::nullopt;
    for (Index i = 0; i < terms; ++i) {
      of_u(row, i + 1) = along_u.at(static_cast<std::size_t>(i));
      of_v(row, i + 1) = along_v.at(static_cast<std::size_t>(i));
    }
    u[row] = sample.pixel[0];
    v[row] = sample.pixel[1];
  }
  return std::sqrt((least_squares(of_u, u) + least_squares(of_v, v)) / static_cast<double>(rows));
}

}  // namespace fca
