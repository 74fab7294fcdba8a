// SPDX-License-Identifier: BSD-3-Clause
// The paper's tables and figures, recomputed: every row converted by the library and evaluated on every pixel.
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

/// What the paper's RE would be: the mean distance over its own samples.
struct SampleError {
  int count = 0;
  double mean_px = 0.0;
};

/// An image shown as the converted camera would have taken it, next to the image itself.
struct RecoveredImage {
  double psnr_db = 0.0;  ///< Infinite: the same.
  double ssim = 0.0;
  double compared = 0.0;  ///< Share of the pixels that both cameras see.
};

/// PSNR and SSIM as the authors' program has them of an image. It paints each pixel's colour as a disc of 5 pixels where the
/// converted model has the pixel, cut to whole pixels, and takes the colour from there too, not from where the pixel was: no
/// displacement can be seen, but where 1e-9 px more or less cut a place to the next pixel.
struct PaintedImage {
  double psnr_db = 0.0;  ///< Of the first colour (blue); 0: the same.
  double ssim = 0.0;     ///< Of the first colour.
};

/// The image as the converted camera would have taken it, of 8 bits, black where it is not known; and what of it differs.
struct RecoveredPictures {
  Image image;
  Image difference;  ///< 16 times as much as the levels differ.
};

struct EvaluatedRow {
  paper::Row published;
  CameraModel source;
  Conversion conversion;
  double time_us = 0.0;  ///< Sampling and fit, the median of some runs.
  SampleError on_samples;
  double parameter_error = 0.0;
  std::optional<RecoveredImage> recovered = {};  ///< With an image; and the two below.
  std::optional<PaintedImage> painted = {};
  std::optional<RecoveredPictures> pictures = {};  ///< Of Figure 3.
};

struct EvaluatedTable {
  paper::ConversionTable published;
  std::vector<EvaluatedRow> rows;
  std::optional<PaintedImage> painted_noise = {};  ///< With an image: no conversion, but noise of up to 1e-9 px.
};

/// A conversion from a number of samples.
struct SweepPoint {
  int asked = 0;
  int taken = 0;  ///< More than asked where the fit turned out to be worse between them.
  double parameter_error = 0.0;
  double rms_px = 0.0;   ///< Over the image.
  double time_us = 0.0;  ///< Sampling and fit, the shortest of some runs.
};

/// A curve of Figure 2.
struct SampleSweep {
  paper::Model from;
  paper::Model to;
  std::vector<SweepPoint> points;
};

/// A polynomial for Table 3's camera, published or ours.
struct EvaluatedPolynomial {
  std::string method;
  paper::Polynomial polynomial;
  double rmse = 0.0;  ///< Of a0, a1, a2 against the toolbox's, as the paper has it.
  Intrinsics<Ocamcalib> model;
  std::optional<FitSummary> fit;  ///< Nothing where it is published.
  double time_us = 0.0;
  ErrorStatistics statistics;  ///< Against the source.
};

/// a2 of UCM's ray height a(r) on the axis, and what the authors' unprojection computes from it.
struct SignError {
  double right_a2 = 0.0;
  double wrong_a2 = 0.0;
};

struct EvaluatedPolynomials {
  paper::PolynomialTable published;
  std::vector<EvaluatedPolynomial> rows;
  SignError sign;
};

struct EvaluateRequest {
  /// Of an image as large as those of one of the tables: each row of it tells how alike the image and the one recovered from
  /// it by that row's conversion are. Each pixel of the recovered one is the original's where the source camera sees the
  /// converted one's ray (Lanczos, at exactly that place, not rounded to grey levels). Places near the border, whose window
  /// reaches beyond the image, are left out. With models that agree the two are the same. Empty: no image.
  std::string image_path;
  bool pictures = false;  ///< EvaluatedRow::pictures of the rows of Figure 3, whose source is KB.
};

struct EvaluateResult {
  Status status = Status::kDone;            ///< Else only the diagnostics are set.
  std::vector<EvaluatedTable> conversions;  ///< Tables 1 and 2.
  std::vector<SampleSweep> sweeps;          ///< Figure 2, of Table 1's conversions.
  EvaluatedPolynomials polynomials;         ///< Table 3.
  ConversionReport slam_camera;             ///< In place of Table 4: its conversion, the largest error proven.
  Diagnostics diagnostics;
};

[[nodiscard]] EvaluateResult evaluate(const EvaluateRequest& request, Files& files);

}  // namespace fca
