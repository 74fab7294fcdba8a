// SPDX-License-Identifier: BSD-3-Clause
// The paper's tables, recomputed: every row converted by the library and judged on every pixel.
#pragma once

#include "evaluate_tables.h"

#include <fca/convert/convert.h>
#include <fca/diagnostics.h>

#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

/// What the paper's RE would be: the mean distance over its own samples.
struct SampleError {
  int count = 0;
  double mean_px = 0.0;
};

/// An image shown as the converted camera would have taken it, beside the image itself.
struct RecoveredImage {
  double psnr_db = 0.0;  ///< Infinite: the same.
  double ssim = 0.0;
  double compared = 0.0;  ///< Share of the pixels that both cameras see.
};

struct EvaluatedRow {
  paper::Row published;
  CameraModel source;
  Conversion conversion;
  double time_us = 0.0;  ///< Sampling and fit, the median of some runs.
  SampleError on_samples;
  double parameter_error = 0.0;
  std::optional<RecoveredImage> recovered = {};  ///< With --image.
};

struct EvaluatedTable {
  paper::ConversionTable published;
  std::vector<EvaluatedRow> rows;
};

/// A polynomial for Table 3's camera, published or ours.
struct EvaluatedPolynomial {
  std::string method;
  paper::Polynomial polynomial;
  double rmse = 0.0;  ///< Of a0, a1, a2 against the toolbox's, as the paper has it.
  Intrinsics<Ocamcalib> model;
  std::optional<FitSummary> fit;  ///< Nothing where it is published.
  double time_us = 0.0;
  Judgement judgement;  ///< Against the source.
};

/// a2 of UCM's ray height a(r) on the axis, and what the authors' unprojection makes of it.
struct SignError {
  double right_a2 = 0.0;
  double wrong_a2 = 0.0;
};

struct EvaluatedPolynomials {
  paper::PolynomialTable published;
  std::vector<EvaluatedPolynomial> rows;
  SignError sign;
};

struct Evaluation {
  std::vector<EvaluatedTable> conversions;  ///< Tables 1 and 2.
  EvaluatedPolynomials polynomials;         ///< Table 3.
};

/// Nothing if one of the cameras cannot be converted, which would be a bug.
[[nodiscard]] std::optional<Evaluation> evaluate(Diagnostics& diagnostics);

}  // namespace fca::cli
