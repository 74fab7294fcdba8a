// SPDX-License-Identifier: BSD-3-Clause
// How good a conversion is, measured where people need it: pixel -> ray by the source -> pixel by the target.
#pragma once

#include <fca/convert/fit_weight.h>
#include <fca/message.h>
#include <fca/models/camera_model.h>
#include <fca/rig/lens_circle.h>
#include <fca/rig/transform.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fca {

/// Errors over a weighted set of points, in pixels.
struct ErrorSummary {
  double rms = 0.0;
  double mean = 0.0;
  double p50 = 0.0;
  double p95 = 0.0;
  double p99 = 0.0;
  double max = 0.0;  ///< Polished from the worst points of the lattice to the maximum between them.
  Pixel max_at{};    ///< The source's pixel where it is.
  /// No error of the field of view is larger, between the pixels, too: proven. Infinite where nothing is (a target that is a
  /// program, or whose error has no limit).
  double bound = std::numeric_limits<double>::infinity();
};

/// Errors between two angles from the axis.
struct ErrorBand {
  double from_deg = 0.0;
  double to_deg = 0.0;
  double share = 0.0;  ///< Of the image's area.
  double rms_px = 0.0;
  double max_px = 0.0;
};

/// Which part of the image was scored, as shares of its area; they sum to 1.
struct Coverage {
  double max_angle_deg = 0.0;
  Message why = {};                  ///< What decided that, a clause.
  std::optional<LensCircle> circle;  ///< Of images, if that decided.
  double scored = 0.0;
  double outside_lens = 0.0;     ///< No ray of the source, or beyond the field of view's angle.
  double unrepresentable = 0.0;  ///< The target cannot reach this ray.

  /// The same as counts of pixels, exact; 0 unless every pixel was scored.
  long long scored_pixels = 0;
  long long outside_lens_pixels = 0;
  long long unrepresentable_pixels = 0;
};

/// The error statistics of a pair of models.
struct ErrorStatistics {
  Coverage coverage;
  ErrorSummary error;
  std::vector<ErrorBand> bands;
};

/// The calibration's own uncertainty over the scored part of the image: one standard deviation of a pixel along the direction
/// in which it is largest.
struct PixelUncertainty {
  bool is_limit = false;      ///< Correlations are not known: no pixel is more uncertain than that, and each may be less.
  bool of_residuals = false;  ///< Computed from the fit's own residuals, of a table of rays.
  std::string source;         ///< The file that specifies the parameters' standard deviations; empty: `of_residuals`.
  double rms_px = 0.0;
  double max_px = 0.0;
  Pixel max_at{};            ///< The source's pixel where it is.
  double most_sigmas = 0.0;  ///< The largest ratio, over the image, of the conversion's error to the uncertainty there.
  std::vector<double> bands_px = {};    ///< Root mean square between the angles of ErrorStatistics::bands, one for one.
  std::vector<double> sigmas = {};      ///< Of the target's parameters; empty where `is_limit`, and of an exact copy.
  std::vector<double> covariance = {};  ///< The same, row by row.
};

/// How the target was found.
struct FitSummary {
  int samples = 0;
  int iterations = 0;
  double time_us = 0.0;
};

/// What a fit makes small.
enum class Objective : std::uint8_t {
  kRms,  ///< The root mean square of the errors over the field of view.
  kMax,  ///< The largest error of the field of view.
};

/// The error that a weighted fit makes small.
struct WeightedRms {
  WeightKind kind = WeightKind::kPixel;
  double rms_px = 0.0;  ///< Root mean square of the errors over the scored part, by those weights.
};

/// The least-squares fit from which the search for a smaller largest error set out: what that cost in rms, and what it gained.
struct RmsFit {
  double rms_px = 0.0;
  double max_px = 0.0;
  bool kept = false;  ///< No camera with a smaller largest error was found near it.
};

/// A turn of the camera that was fitted together with its model: the frame of the written camera is another one.
struct AbsorbedTurn {
  AbsorbedTurn(const Transform& T_target_source, double rms_before_px, double max_before_px);

  Transform T_target_source;   ///< A rotation: takes rays in the calibrated camera's frame to the written one's.
  double angle_deg = 0.0;      ///< The rotation's angle.
  double rms_before_px = 0.0;  ///< Of the best camera without a turn.
  double max_before_px = 0.0;
};

/// What a turn would come to, about.
struct TurnOffer {
  double angle_deg = 0.0;
  double rms_px = 0.0;
};

/// A parameter of the fit outside the range of published cameras (Parameter::usual).
struct UnusualParameter {
  std::string name;
  double value = 0.0;
  std::array<double, 2> usual{};
  double rms_inside_px = 0.0;  ///< Of the best camera with all parameters inside.
};

/// The errors of a conversion if the lens ended at that angle from the axis.
struct MaxAngleRow {
  double max_angle_deg = 0.0;
  double scored_to_deg = 0.0;    ///< As in ConversionReport; less where the target was fitted up to a smaller angle.
  double scored = 0.0;           ///< Share of the image.
  double unrepresentable = 0.0;  ///< Share of the image.
  double rms_px = 0.0;
  double max_px = 0.0;
};

/// The report of one camera's conversion.
struct ConversionReport {
  std::string from_model;
  std::string to_model;
  bool exact = false;  ///< The target contains the source: same pixels by construction, no fit.
  ErrorStatistics statistics;
  /// Nothing further from the axis was scored: the field of view's largest angle, or where the target ends, by itself or
  /// because it was fitted up to that angle only.
  double scored_to_deg = 0.0;
  bool angle_reduced = false;  ///< The target cannot describe all of the field of view and was fitted up to there.
  FitSummary fit;
  int degree = 0;  ///< Of the polynomial that was fitted; 0: the target is none, or nothing was fitted.
  Objective objective = Objective::kRms;
  std::optional<WeightedRms> weighted = {};  ///< Where pixels do not count alike; ErrorStatistics has the errors of all pixels.
  std::optional<RmsFit> rms_fit;             ///< Of a fit for the largest error.
  std::vector<std::string> at_bound;         ///< Parameters that ended at the edge of their range.
  std::vector<UnusualParameter> unusual;
  std::optional<AbsorbedTurn> turn;                  ///< Only if requested, and where it helps.
  std::optional<TurnOffer> turn_offer;               ///< Where nobody asked, and it would take a fifth off a visible error.
  std::optional<PixelUncertainty> uncertainty = {};  ///< Where it is known (uncertainty.h).
  /// Only if requested, and where the lens's angle matters and no file contains it (max_angle_table.h).
  std::vector<MaxAngleRow> max_angles;

  /// The root mean square that the fit made small.
  [[nodiscard]] double fitted_rms_px() const { return weighted ? weighted->rms_px : statistics.error.rms; }
};

}  // namespace fca
