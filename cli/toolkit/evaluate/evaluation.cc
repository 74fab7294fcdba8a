// SPDX-License-Identifier: BSD-3-Clause
// Recomputes the tables of S. Lee, "Fisheye-Calib-Adapter", 2024 ("the paper").
#include <fca/toolkit/evaluate.h>

#include "degrees.h"
#include "recovered_images.h"
#include "sample_sweep.h"

#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = 1.0 / kDegreesPerRadian;

std::optional<double> radians(std::optional<double> degrees) {
  return degrees ? std::optional(*degrees * kRadiansPerDegree) : std::nullopt;
}

Camera camera_of(std::string name, const ImageSize& size, const CameraModel& model) {
  Camera camera;
  camera.name = std::move(name);
  camera.image_size = size;
  camera.model = model;
  return camera;
}

/// A conversion evaluated on every pixel, and the median time [us] of its sampling and fit.
struct TimedConversion {
  Conversion conversion;
  double time_us = 0.0;
};

/// Converts the camera several times for the timing, and once more for the evaluation. nullopt if that conversion fails.
std::optional<TimedConversion> timed_conversion(const Camera& camera, ConvertOptions options, Diagnostics& diagnostics) {
  // The reported time is the median of the runs: the first ones fill the caches, and other processes may slow some down.
  constexpr std::size_t kRuns = 7;
  std::array<double, kRuns> times{};
  options.bound = false;
  for (double& time : times) {
    Diagnostics discarded;  // the same as those of the conversion below
    const std::optional<Conversion> conversion = convert(camera, options, discarded);
    if (conversion) time = conversion->report.fit.time_us;
  }
  std::ranges::nth_element(times, times.begin() + kRuns / 2);
  options.every_pixel = true;
  std::optional<Conversion> evaluated = convert(camera, options, diagnostics);
  if (!evaluated) return std::nullopt;
  return TimedConversion{std::move(*evaluated), times[kRuns / 2]};
}

/// The mean error on the paper's samples, the centres of about 500 equal cells of the image. Samples outside the field of view
/// and samples that the target cannot project are left out.
SampleError error_on_samples(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view) {
  SampleError result;
  for (const Pixel& pixel : paper::cell_centres(field_of_view.size, paper::kSamples)) {
    const std::optional<Ray> ray = field_of_view.ray(source, pixel);
    const std::optional<Pixel> image = ray ? project(target, *ray) : std::nullopt;
    if (!image) continue;
    ++result.count;
    result.mean_px += std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]);
  }
  if (result.count > 0) result.mean_px /= result.count;
  return result;
}

/// Repeats a conversion of the paper. If the table has no calibration in the row's source model, the source is the table's
/// first calibration converted to that model. nullopt if a conversion fails or the table has no calibration in the target
/// model.
std::optional<EvaluatedRow> evaluate_row(const paper::ConversionTable& table, const paper::Row& row, Diagnostics& diagnostics) {
  ConvertOptions options;
  options.max_angle_rad = radians(table.max_angle_deg);
  const std::string name = std::string(row.from.name) + "-" + std::string(row.to.name);

  const CameraModel* from = paper::calibration_in(table, row.from);
  Camera source = camera_of(name, table.size, from != nullptr ? *from : table.calibrations.front());
  if (from == nullptr) {
    options.model = row.from.id;
    const std::optional<Conversion> derived = convert(source, options, diagnostics);
    if (!derived) return std::nullopt;
    source = derived->camera;
  }

  options.model = row.to.id;
  // The polynomials of the paper have the lowest degree of the model.
  if (const int least = find_model(options.model)->least_degree; least > 0) options.degree = least;
  std::optional<TimedConversion> timed = timed_conversion(source, options, diagnostics);
  const std::optional<FieldOfView> field_of_view = field_of_view_of(source, options.max_angle_rad, diagnostics);
  const CameraModel* truth = paper::calibration_in(table, row.to);
  if (!timed || !field_of_view || truth == nullptr) return std::nullopt;

  EvaluatedRow result{row, source.model, std::move(timed->conversion), timed->time_us, {}, 0.0};
  const CameraModel& target = result.conversion.camera.model;
  result.on_samples = error_on_samples(source.model, target, *field_of_view);
  result.parameter_error = paper::parameter_distance(target, *truth);
  return result;
}

/// The rms of the differences between the three coefficients of two polynomials, the RMSE of the paper's Table 3.
double rmse(const paper::Polynomial& a, const paper::Polynomial& b) {
  return std::sqrt(((a.a0 - b.a0) * (a.a0 - b.a0) + (a.a1 - b.a1) * (a.a1 - b.a1) + (a.a2 - b.a2) * (a.a2 - b.a2)) / 3.0);
}

/// A fit of OCamCalib's model.
struct PolynomialFit {
  std::string_view method;
  std::optional<double> max_angle_deg;  ///< The largest angle from the axis that is fitted; nullopt: the whole image.
  std::vector<ParameterRange> fixed;    ///< Parameters with fixed values.
};

/// The fits that are compared with the polynomials of Table 3, from the most similar to the paper's to the least similar.
std::vector<PolynomialFit> polynomial_fits() {
  const std::vector<ParameterRange> degree_2 = {{"a3", 0.0, 0.0}, {"a4", 0.0, 0.0}};
  std::vector<ParameterRange> fixed_in_paper = degree_2;
  fixed_in_paper.insert(fixed_in_paper.end(), {{"c", 1.0, 1.0}, {"d", 0.0, 0.0}, {"e", 0.0, 0.0}});
  return {{"fca-io, degree 2, c = 1", 90.0, fixed_in_paper},
          {"fca-io, degree 2", 90.0, degree_2},
          {"fca-io, degree 2", std::nullopt, degree_2},
          {"fca-io, degree 4", std::nullopt, {}}};
}

/// The coefficient a2 of OCamCalib's polynomial a(r) for a UCM lens, computed with the correct unprojection and with that of
/// the paper's program. With gamma = f / (1 - alpha), m = r / gamma and k = (xi + sqrt(1 + (1 - xi^2) m^2)) / (1 + m^2), the
/// ray of UCM is (k m, k - xi) and its height over r is a(r) = gamma (1 - xi / k). The coefficient a2 follows from k = (1 + xi)
/// (1 - (1 + xi) m^2 / 2 + ...). The paper's program divides by 1 - m^2 instead of 1 + m^2; then k = (1 + xi) (1 + (3 - xi) m^2
/// / 2 + ...).
SignError sign_error(const Intrinsics<Ucm>& ucm) {
  const double alpha = parameter(ucm, "alpha").value();
  const double focal = 0.5 * (parameter(ucm, "fx").value() + parameter(ucm, "fy").value());
  const double gamma = focal / (1.0 - alpha);
  const double xi = alpha / (1.0 - alpha);
  return {-xi / (2.0 * gamma), xi * (3.0 - xi) / (2.0 * gamma * (1.0 + xi))};
}

/// Evaluates the polynomials of the paper's Table 3 and those that fca-io fits. nullopt if a conversion fails.
std::optional<EvaluatedPolynomials> evaluate_polynomials(Diagnostics& diagnostics) {
  EvaluatedPolynomials result;
  result.published = paper::polynomial_table();
  const paper::PolynomialTable& table = result.published;
  const Camera source = camera_of("UCM-OCC", table.size, table.source);
  result.sign = sign_error(table.source);

  // The paper's samples are in front of the camera: z > 0.
  constexpr double kMaxAngleDeg = 90.0;
  const std::optional<FieldOfView> in_front = field_of_view_of(source, kMaxAngleDeg * kRadiansPerDegree, diagnostics);
  if (!in_front) return std::nullopt;
  for (const paper::PublishedPolynomial& published : table.methods) {
    EvaluatedPolynomial row;
    row.method = published.method;
    row.polynomial = published.polynomial;
    row.model = paper::camera_of(published.polynomial, principal_point(source.model));
    row.statistics = evaluate(source.model, CameraModel(row.model), *in_front, {.every_pixel = true, .bound = false});
    result.rows.push_back(std::move(row));
  }
  for (const PolynomialFit& fit : polynomial_fits()) {
    ConvertOptions options;
    options.model = Ocamcalib::kId;
    options.max_angle_rad = radians(fit.max_angle_deg);
    options.ranges = fit.fixed;
    options.degree = Ocamcalib::kLeastDegree;
    std::optional<TimedConversion> timed = timed_conversion(source, options, diagnostics);
    if (!timed) return std::nullopt;
    EvaluatedPolynomial row;
    row.method = fit.method;
    row.model = std::get<Intrinsics<Ocamcalib>>(timed->conversion.camera.model);
    row.polynomial = paper::polynomial_of(row.model);
    row.fit = timed->conversion.report.fit;
    row.time_us = timed->time_us;
    row.statistics = std::move(timed->conversion.report.statistics);
    result.rows.push_back(std::move(row));
  }
  for (EvaluatedPolynomial& row : result.rows) row.rmse = rmse(row.polynomial, table.toolbox);
  return result;
}

/// Repeats the conversion whose camera the paper uses in a SLAM system (Table 4). nullopt if it fails.
std::optional<ConversionReport> evaluate_slam_camera(Diagnostics& diagnostics) {
  const paper::SlamCamera published = paper::slam_camera();
  ConvertOptions options;
  options.model = published.to.id;
  options.max_angle_rad = radians(published.max_angle_deg);
  options.every_pixel = true;
  const std::optional<Conversion> conversion =
      convert(camera_of("KB-EUCM", published.size, published.model), options, diagnostics);
  return conversion ? std::optional(conversion->report) : std::nullopt;
}

/// Adds the paper's tables to the result. Throws std::logic_error if a camera cannot be converted: the cameras are constants in
/// paper_tables.cc, so a failure is a bug.
void add_tables(EvaluateResult& result) {
  constexpr const char* kBug = "a camera of the paper cannot be converted";
  for (paper::ConversionTable& table : paper::conversion_tables()) {
    EvaluatedTable evaluated;
    for (const paper::Row& row : table.rows) {
      std::optional<EvaluatedRow> evaluated_row = evaluate_row(table, row, result.diagnostics);
      if (!evaluated_row) throw std::logic_error(kBug);
      evaluated.rows.push_back(std::move(*evaluated_row));
    }
    evaluated.published = std::move(table);
    result.conversions.push_back(std::move(evaluated));
  }
  result.sweeps = sample_sweeps(result.conversions.front());
  std::optional<EvaluatedPolynomials> polynomials = evaluate_polynomials(result.diagnostics);
  std::optional<ConversionReport> slam = evaluate_slam_camera(result.diagnostics);
  if (!polynomials || !slam) throw std::logic_error(kBug);
  result.polynomials = std::move(*polynomials);
  result.slam_camera = std::move(*slam);
}

}  // namespace

EvaluateResult evaluate(const EvaluateRequest& request, Files& files) {
  EvaluateResult result;
  add_tables(result);
  if (!request.image_path.empty() && !add_recovered_images(request, files, result))
    result.status = worse(status_of(result.diagnostics), Status::kBadInput);
  return result;
}

}  // namespace fca
