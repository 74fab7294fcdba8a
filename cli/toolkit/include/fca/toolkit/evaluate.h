// SPDX-License-Identifier: BSD-3-Clause
// Recomputes the tables and figures of S. Lee, "Fisheye-Calib-Adapter: An Easy Tool for Fisheye Camera Model Conversion", 2024
// ("the paper"): the library repeats each conversion and evaluates it on every pixel.
#pragma once

#include <fca/toolkit/paper_tables.h>

#include <fca/convert/convert.h>
#include <fca/diagnostics.h>
#include <fca/toolkit/files.h>
#include <fca/toolkit/image.h>
#include <fca/toolkit/status.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

/// Corresponds to the paper's RE: the mean distance over the paper's samples, including those that the paper's program drops.
struct SampleError {
  int count = 0;  ///< Number of samples that both cameras see.
  double mean_px = 0.0;
};

/// Compares an image with the image that the converted camera would have taken.
struct RecoveredImage {
  double psnr_db = 0.0;   ///< Infinite if the images are equal.
  double ssim = 0.0;      ///< Mean of the colours.
  double compared = 0.0;  ///< The share of pixels that are compared.
};

/// PSNR and SSIM of an image as the paper's program computes them. The program paints a disc of 5 pixels at the position to
/// which the converted model projects a pixel, truncated to whole pixels. It takes the disc's colour from that position and not
/// from the original pixel. So a displacement is invisible, except where 1e-9 px more or less changes the truncated position.
struct PaintedImage {
  double psnr_db = 0.0;  ///< PSNR of the first colour (blue). 0 if the images are equal.
  double ssim = 0.0;     ///< Mean SSIM of the first colour.
};

/// Two 8-bit pictures: the image that the converted camera would have taken, and its difference from the original. Pixels that
/// cannot be computed are black.
struct RecoveredPictures {
  Image image;
  Image difference;  ///< 16 times the absolute difference of the levels.
};

/// A row of Table 1 or 2, and the same conversion by fca-io.
struct EvaluatedRow {
  paper::Row published;
  CameraModel source;
  Conversion conversion;
  double time_us = 0.0;  ///< Duration of sampling and fit: the median of several runs.
  SampleError on_samples;
  double parameter_error = 0.0;                    ///< PE (paper::parameter_distance) of the converted camera.
  std::optional<RecoveredImage> recovered = {};    ///< Set if the request has an image of the table's size.
  std::optional<PaintedImage> painted = {};        ///< Set if `recovered` is set.
  std::optional<RecoveredPictures> pictures = {};  ///< Set for the rows of Figure 3 if the request asks for pictures.
};

/// Table 1 or 2, and its conversions by fca-io.
struct EvaluatedTable {
  paper::ConversionTable published;
  std::vector<EvaluatedRow> rows;
  /// The statistics if nothing is converted, but noise of up to 1e-9 px moves each pixel. Set if the rows have `painted`.
  std::optional<PaintedImage> painted_noise = {};
};

/// A conversion that is fitted to a given number of samples.
struct SweepPoint {
  int asked = 0;  ///< The requested number of samples.
  int taken = 0;  ///< The number of samples of the fit: larger than `asked` if the fit was worse between the samples.
  double parameter_error = 0.0;  ///< PE (paper::parameter_distance).
  double rms_px = 0.0;           ///< Rms error over the image.
  double time_us = 0.0;          ///< Duration of sampling and fit: the shortest of several runs.
};

/// One curve of Figure 2: a conversion with increasing numbers of samples.
struct SampleSweep {
  paper::Model from;
  paper::Model to;
  std::vector<SweepPoint> points;
};

/// A polynomial for the camera of Table 3, published or fitted by fca-io.
struct EvaluatedPolynomial {
  std::string method;
  paper::Polynomial polynomial;
  double rmse = 0.0;  ///< The paper's RMSE: the rms difference of a0, a1, a2 from the OCamCalib toolbox's.
  Intrinsics<Ocamcalib> model;
  std::optional<FitSummary> fit;  ///< nullopt if the polynomial is published.
  double time_us = 0.0;           ///< Duration of sampling and fit. 0 if the polynomial is published.
  ErrorStatistics statistics;     ///< The errors of `model` against the source camera.
};

/// The coefficient a2 of OCamCalib's polynomial for a UCM lens. The unprojection of the paper's program has a wrong sign.
struct SignError {
  double right_a2 = 0.0;
  double wrong_a2 = 0.0;  ///< With the unprojection of the paper's program.
};

/// Table 3, and its polynomials evaluated.
struct EvaluatedPolynomials {
  paper::PolynomialTable published;
  std::vector<EvaluatedPolynomial> rows;  ///< The published polynomials, then those of fca-io.
  SignError sign;
};

struct EvaluateRequest {
  /// Path of an image that has the image size of one of the tables. Each row of such a table then compares the image with the
  /// one that the row's converted camera would have taken. A pixel of the latter has the value of the original at the position
  /// where the source camera sees the same ray: a Lanczos interpolation that is not rounded to grey levels. Pixels whose
  /// interpolation window extends beyond the image are not compared. If the models agree, the images are equal. Empty: no
  /// image.
  std::string image_path;
  bool pictures = false;  ///< Compute EvaluatedRow::pictures for the rows of Figure 3, whose source is KB.
};

struct EvaluateResult {
  Status status = Status::kDone;            ///< Not kDone if the image cannot be read or no table has its size.
  std::vector<EvaluatedTable> conversions;  ///< Tables 1 and 2.
  std::vector<SampleSweep> sweeps;          ///< Figure 2, from the conversions of Table 1.
  EvaluatedPolynomials polynomials;         ///< Table 3.
  ConversionReport slam_camera;             ///< The conversion behind Table 4, with a proven bound of its error.
  Diagnostics diagnostics;
};

/// Recomputes all tables. Throws std::logic_error if a camera of the paper cannot be converted, which is a bug.
[[nodiscard]] EvaluateResult evaluate(const EvaluateRequest& request, Files& files);

}  // namespace fca
