// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/least_error.h>

#include <fca/rig/rotation.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace fca {

namespace {

/// A ray's place on the plane z = 1, and its pixel.
struct Place {
  double x = 0.0;
  double y = 0.0;
  Pixel pixel{};
};

/// Pixels of a lattice that are lens; nothing if one's ray has no place.
std::optional<std::vector<Place>> places_of(const Camera& camera, std::optional<double> max_angle_rad) {
  constexpr int kSteps = 12;
  std::vector<Place> places;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Pixel pixel = {(i + 0.5) / kSteps * camera.image_size->width - 0.5,
                           (j + 0.5) / kSteps * camera.image_size->height - 0.5};
      if (camera.lens_circle && !camera.lens_circle->contains(pixel)) continue;
      const std::optional<Ray> ray = unproject(camera.model, pixel);
      if (!ray || (max_angle_rad && angle_from_axis(*ray) > *max_angle_rad)) continue;
      if (!((*ray)[2] > 0.0)) return std::nullopt;
      places.push_back({(*ray)[0] / (*ray)[2], (*ray)[1] / (*ray)[2], pixel});
    }
  }
  return places;
}

/// What a coordinate of a pixel is a sum of, each times a number: 1 and the coordinate on the plane, with radtan also times
/// powers of r^2, and both tangential terms. `along`: the coordinate, `across`: the other one.
void put_terms(double along, double across, std::span<double> terms) {
  const double r2 = along * along + across * across;
  std::size_t at = 0;
  terms[at++] = 1.0;
  double term = along;
  terms[at++] = term;
  constexpr std::size_t kTangential = 2;
  if (terms.size() <= at + kTangential) return;
  while (at + kTangential < terms.size()) terms[at++] = term *= r2;
  terms[at++] = along * across;
  terms[at] = r2 + 2.0 * along * along;
}

/// The sum of squares that the best of all sums leaves.
double least_squares(Eigen::MatrixXd terms, const Eigen::VectorXd& pixels) {
  // Powers of r reach over many orders of magnitude.
  for (Eigen::Index column = 0; column < terms.cols(); ++column) terms.col(column).normalize();
  return (pixels - terms * terms.colPivHouseholderQr().solve(pixels)).squaredNorm();
}

/// How many numbers a coordinate has; 0: the model is none of these.
Eigen::Index terms_of(std::string_view model_id) {
  if (model_id == Pinhole::kId) return 2;
  return model_id == Radtan::kId ? 7 : 0;
}

}  // namespace

std::optional<double> least_rms_px(const Camera& camera, std::string_view model_id, std::optional<double> max_angle_rad) {
  const Eigen::Index count = terms_of(model_id);
  if (count == 0 || !camera.image_size || !camera.rays.empty()) return std::nullopt;
  const std::optional<std::vector<Place>> places = places_of(camera, max_angle_rad);
  if (!places || places->empty()) return std::nullopt;
  double squares = 0.0;
  for (const std::size_t coordinate : {std::size_t{0}, std::size_t{1}}) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Rows terms(static_cast<Eigen::Index>(places->size()), count);
    Eigen::VectorXd pixels(terms.rows());
    for (Eigen::Index row = 0; row < terms.rows(); ++row) {
      const Place& place = (*places)[static_cast<std::size_t>(row)];
      const auto [along, across] = coordinate == 0 ? std::pair(place.x, place.y) : std::pair(place.y, place.x);
      put_terms(along, across, {terms.row(row).data(), static_cast<std::size_t>(count)});
      pixels[row] = place.pixel[coordinate];
    }
    squares += least_squares(terms, pixels);
  }
  return std::sqrt(squares / static_cast<double>(places->size()));
}

}  // namespace fca
