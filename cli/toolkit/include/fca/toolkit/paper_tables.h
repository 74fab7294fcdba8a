// SPDX-License-Identifier: BSD-3-Clause
// The figures and cameras that a paper prints: S. Lee, "Fisheye-Calib-Adapter: An Easy Tool for Fisheye Camera Model
// Conversion", 2024, Tables 1-4 ("the paper"). evaluate.h declares what fca-io computes from them.
#pragma once

#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace fca::paper {

/// A camera model under the paper's name ("KB") and ours ("kb4").
struct Model {
  std::string_view name;
  std::string_view id;
};

/// Statistics of the distances between corresponding pixels over an image.
struct ErrorFigures {
  double mean_px = 0.0;
  double rms_px = 0.0;
  double max_px = 0.0;
};

/// A printed row of Table 1 or 2.
struct Row {
  Model from;
  Model to;
  double time_ms = 0.0;
  double reprojection_error_px = 0.0;  ///< "RE": the mean distance on the samples that the paper's program kept.
  double parameter_error = 0.0;        ///< "PE": L2 norm of the difference from the parameters of a separate calibration.
  /// Compares the paper's image with the image that the converted camera would have taken. We do not have the paper's image.
  double psnr_db = 0.0;
  double ssim = 0.0;  ///< Of the same two images as `psnr_db`.
  /// The errors of the camera that the paper's program computes, measured by us on every 4th pixel of the image.
  std::optional<ErrorFigures> authors_over_image;
  std::string_view why;  ///< Why the printed figures differ from the errors over the image.
};

/// Table 1 or 2. The source of a row is the published calibration in the row's source model. If there is none, it is the
/// published calibration converted to that model (in the paper: i_in = FCA(i*_OCC)).
struct ConversionTable {
  int number = 0;
  std::string_view title;
  ImageSize size;
  std::optional<double> max_angle_deg;  ///< Angle from the axis at which the lens ends. nullopt: it fills the image.
  std::vector<CameraModel> calibrations;
  std::vector<Row> rows;
  std::string_view remark;  ///< A remark on the whole table.
};
/// Tables 1 and 2.
[[nodiscard]] std::vector<ConversionTable> conversion_tables();

/// The published calibration of the table in that model. Null if there is none.
[[nodiscard]] const CameraModel* calibration_in(const ConversionTable& table, const Model& model);

/// The number of samples N that the paper requests for all tables.
inline constexpr int kSamples = 500;

/// The centres [px] of about `count` equal cells of the image. The numbers of columns and rows have about the ratio of width
/// and height (752 x 480 px and 500: 28 x 18 cells).
[[nodiscard]] std::vector<Pixel> cell_centres(const ImageSize& size, int count);

/// The parameters from which the paper computes PE. For OCC (OCamCalib's model) these are c, d, e, cx, cy, a0 ... a4 of the
/// paper's form, in which z is positive in front of the camera; for other models the model's own parameters.
[[nodiscard]] std::vector<double> parameters_as_published(const CameraModel& model);

/// PE: the L2 norm of the difference between the published parameters of two cameras, which must have the same model.
[[nodiscard]] double parameter_distance(const CameraModel& a, const CameraModel& b);

/// The polynomial a0 + a1 r + a2 r^2: the z coordinate [px] of the ray at radius r [px], positive in front of the camera.
struct Polynomial {
  double a0 = 0.0;
  double a1 = 0.0;
  double a2 = 0.0;
};
/// The first three coefficients of a camera's polynomial.
[[nodiscard]] Polynomial polynomial_of(const Intrinsics<Ocamcalib>& model);

struct PublishedPolynomial {
  std::string_view method;
  Polynomial polynomial;
};

/// Table 3: polynomials of one omnidirectional camera, computed from libPeR's UCM calibration of this camera.
struct PolynomialTable {
  std::string_view title;
  ImageSize size;
  Intrinsics<Ucm> source;  ///< libPeR's calibration.
  Polynomial toolbox;      ///< OCamCalib's own calibration, with which the paper compares.
  std::array<PublishedPolynomial, 2> methods;
};
/// Table 3.
[[nodiscard]] PolynomialTable polynomial_table();

/// The camera of Table 4, which the paper uses in a SLAM system: cam0 of the TUM VI data set with its published kb4 calibration
/// (Schubert et al. 2018).
struct SlamCamera {
  ImageSize size;
  double max_angle_deg = 0.0;  ///< Angle from the axis at which the lens ends.
  CameraModel model;
  Model to;  ///< The model to which the paper converts the camera.
};
[[nodiscard]] SlamCamera slam_camera();

/// The camera with that polynomial and centre, c = 1 and d = e = 0 (square pixels).
[[nodiscard]] Intrinsics<Ocamcalib> camera_of(const Polynomial& polynomial, const Pixel& centre);

}  // namespace fca::paper
