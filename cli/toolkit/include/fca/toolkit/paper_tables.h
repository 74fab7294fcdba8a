// SPDX-License-Identifier: BSD-3-Clause
// What the paper prints: S. Lee, "Fisheye-Calib-Adapter: An Easy Tool for Fisheye Camera Model Conversion", 2024, Tables 1-3.
// Only figures and cameras; evaluation.h has what fca-io computes from them.
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

/// Distances between pixels, over an image.
struct ErrorFigures {
  double mean_px = 0.0;
  double rms_px = 0.0;
  double max_px = 0.0;
};

/// A line of Table 1 or 2.
struct Row {
  Model from;
  Model to;
  double time_ms = 0.0;
  double reprojection_error_px = 0.0;  ///< "RE": the mean distance on the samples that the authors' program kept.
  double parameter_error = 0.0;        ///< "PE": L2 norm of the difference to a separate calibration's parameters.
  double psnr_db = 0.0;                ///< Of the paper's image, which is not ours, and of one recovered from it.
  double ssim = 0.0;
  /// What the authors' program computes, evaluated on every 4th pixel of the image instead: our measurement, not the
  /// paper's.
  std::optional<ErrorFigures> authors_over_image;
  std::string_view why;  ///< Where the printed figures differ from the image's, and why.
};

/// Table 1 or 2. A row's source is the published calibration in its model where there is one; else the published calibration
/// converted to that model (the paper: i_in = FCA(i*_OCC)).
struct ConversionTable {
  int number = 0;
  std::string_view title;
  ImageSize size;
  std::optional<double> max_angle_deg;  ///< Where the lens ends; nothing: the whole image is lens.
  std::vector<CameraModel> calibrations;
  std::vector<Row> rows;
  std::string_view remark;
};
[[nodiscard]] std::vector<ConversionTable> conversion_tables();

/// The published calibration in that model; null where there is none.
[[nodiscard]] const CameraModel* calibration_in(const ConversionTable& table, const Model& model);

/// The N of all tables: samples asked for.
inline constexpr int kSamples = 500;

/// Centres of about `count` equal cells, in columns and rows in the image's proportion (752 x 480 and 500: 28 x 18).
[[nodiscard]] std::vector<Pixel> cell_centres(const ImageSize& size, int count);

/// The parameters between which the paper measures PE. OCC's are those of its (u, v) form, with z ahead; else the model's own.
[[nodiscard]] std::vector<double> parameters_as_published(const CameraModel& model);

/// PE: the L2 norm of the difference between the parameters of two cameras of one model.
[[nodiscard]] double parameter_distance(const CameraModel& a, const CameraModel& b);

/// Height of the ray a0 + a1 r + a2 r^2 in pixels, positive ahead of the camera.
struct Polynomial {
  double a0 = 0.0;
  double a1 = 0.0;
  double a2 = 0.0;
};
[[nodiscard]] Polynomial polynomial_of(const Intrinsics<Ocamcalib>& model);

struct PublishedPolynomial {
  std::string_view method;
  Polynomial polynomial;
};

/// Table 3: the polynomial of one omnidirectional camera, from libPeR's UCM of it.
struct PolynomialTable {
  std::string_view title;
  ImageSize size;
  Intrinsics<Ucm> source;  ///< As libPeR has it.
  Polynomial toolbox;      ///< OCamCalib's own calibration, against which the paper measures.
  std::array<PublishedPolynomial, 2> methods;
};
[[nodiscard]] PolynomialTable polynomial_table();

/// The camera of Table 4, with which the paper runs a SLAM system: TUM VI's cam0 as its authors calibrated it (kb4; Schubert et
/// al. 2018).
struct SlamCamera {
  ImageSize size;
  double max_angle_deg = 0.0;  ///< The lens ends there.
  CameraModel model;
  Model to;
};
[[nodiscard]] SlamCamera slam_camera();

/// A polynomial without shear or stretch around a centre.
[[nodiscard]] Intrinsics<Ocamcalib> camera_of(const Polynomial& polynomial, const Pixel& centre);

}  // namespace fca::paper
