// SPDX-License-Identifier: BSD-3-Clause
// calib_results.txt as Scaramuzza's C program reads it and computes with it. Source: FORMATS.md section 5 and ERRATA.md,
// "OCamCalib conventions" (ocam_functions.c: get_ocam_model, cam2world, world2cam, as vendored in ctu-mrs/uvdar_core@5a375cb):
// x is the row's direction, y the column's, z points backwards; the centre is (row, column). The camera is what the direct
// polynomial says (cam2world); what world2cam computes from the file's inverse polynomial is an approximation that the file
// stores next to it.
#include "pixels_ocamcalib.h"

#include <sstream>

namespace fca::matrix::ocamcalib {

namespace {

struct Model {
  std::vector<double> direct;   ///< a0 < 0, ascending
  std::vector<double> inverse;  ///< ascending, of atan(z / |xy|)
  double row = 0.0;
  double column = 0.0;
  double c = 1.0;
  double d = 0.0;
  double e = 0.0;
  int height = 0;
  int width = 0;
};

void skip_line(std::istream& stream) {
  stream >> std::ws;
  std::string ignored;
  std::getline(stream, ignored);
}

bool read_polynomial(std::istream& stream, std::vector<double>& coefficients) {
  int n = 0;
  skip_line(stream);
  if (!(stream >> n) || n < 1 || n > 64) return false;
  coefficients.resize(static_cast<std::size_t>(n));
  for (double& coefficient : coefficients) stream >> coefficient;
  return !stream.fail();
}

std::optional<Model> model_of(const std::string& bytes) {
  std::istringstream stream(bytes);
  Model model;
  if (!read_polynomial(stream, model.direct) || !read_polynomial(stream, model.inverse)) return std::nullopt;
  skip_line(stream);
  stream >> model.row >> model.column;
  skip_line(stream);
  stream >> model.c >> model.d >> model.e;
  skip_line(stream);
  stream >> model.height >> model.width;
  if (stream.fail()) return std::nullopt;
  return model;
}

double at(const std::vector<double>& coefficients, double x) {
  double result = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) result = result * x + coefficients[i];
  return result;
}

/// From the sensor's (x down, y right) to (column, row).
Pixel pixel_at(const Model& model, double x, double y) {
  return {model.e * x + y + model.column, model.c * x + model.d * y + model.row};
}

/// Angle from the axis of the ray at that distance from the centre: the ray is (rho, f(rho)) and the lens looks along -z.
double angle_at(const Model& model, double rho) { return std::atan2(rho, -at(model.direct, rho)); }

/// The distance at which the direct polynomial has that angle: the first, walking outwards, as long as the angle grows.
std::optional<double> radius_of(const Model& model, double angle) {
  const double limit = 1.5 * std::hypot(model.height, model.width);
  const double step = limit / 512.0;
  for (double rho = 0.0; rho < limit; rho += step) {
    const double ahead = angle_at(model, rho + step);
    if (ahead < angle_at(model, rho)) return std::nullopt;
    if (ahead < angle) continue;
    double low = rho;
    double high = rho + step;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (angle_at(model, middle) < angle ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  return std::nullopt;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const std::optional<Model> read = model_of(bytes);
  if (!read || index > 0) return std::nullopt;
  const Model& model = *read;
  PixelFormula formula;
  if (model.width > 0 && model.height > 0) formula.size = Size{model.width, model.height};
  formula.pixel = [model](const Ray& p) -> std::optional<Pixel> {
    const double x = p[1];
    const double y = p[0];
    const double r = std::hypot(x, y);
    if (r == 0.0) return p[2] > 0.0 ? std::optional(pixel_at(model, 0.0, 0.0)) : std::nullopt;
    const std::optional<double> rho = radius_of(model, std::atan2(r, p[2]));
    if (!rho) return std::nullopt;
    return pixel_at(model, *rho * x / r, *rho * y / r);
  };
  formula.stored_approximation = [model](const Ray& p) -> std::optional<Pixel> {
    const double x = p[1];
    const double y = p[0];
    const double r = std::sqrt(x * x + y * y);
    if (r == 0.0) return pixel_at(model, 0.0, 0.0);
    const double rho = at(model.inverse, std::atan(-p[2] / r));
    return pixel_at(model, rho * x / r, rho * y / r);
  };
  formula.ray = [model](const Pixel& pixel) -> std::optional<Ray> {
    // A^-1 of [c d; e 1]
    const double determinant = model.c - model.d * model.e;
    const double down = pixel[1] - model.row;
    const double right = pixel[0] - model.column;
    const double x = (down - model.d * right) / determinant;
    const double y = (model.c * right - model.e * down) / determinant;
    const double rho = std::hypot(x, y);
    // Beyond the place where the angle stops growing there is no lens.
    double angle = 0.0;
    for (int i = 1; i <= 256; ++i) {
      const double next = angle_at(model, rho * i / 256.0);
      if (next < angle) return std::nullopt;
      angle = next;
    }
    return Ray{y, x, -at(model.direct, rho)};
  };
  return formula;
}

/// The format has no place for poses.
std::vector<Pose> relative_poses(const std::vector<std::string>&) { return {}; }

}  // namespace fca::matrix::ocamcalib
