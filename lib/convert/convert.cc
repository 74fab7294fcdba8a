// SPDX-License-Identifier: BSD-3-Clause
// convert(): checks the options, converts a camera exactly or by a fit, evaluates the result and fills in the report.
#include <fca/convert/convert.h>

#include "absorbed_turn.h"
#include "evaluation/stages.h"
#include "exact.h"
#include "fitting/degree.h"
#include "fitting/fit_field_of_view.h"
#include "fitting/fixed_parameters.h"
#include "fitting/minimax.h"
#include "sampling/weights.h"
#include "table_conversion.h"

#include <fca/code.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>
#include <fca/convert/max_angle_table.h>
#include <fca/rig/covered_image.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

using internal::FitTask;

/// Warns that the target describes the camera only up to this angle from the axis [rad].
void warn_of_reduced_angle(const FitTask& task, double max_angle_rad, Diagnostics& diagnostics) {
  diagnostics.add(Code::kTargetCannotReach, {task.camera.name, task.target.id, max_angle_rad / kRadiansPerDegree});
}

/// Reports a perspective model that has no ray for a part of the image although such models should have rays up to 90 degrees
/// from the axis. Its image radius stops growing there: the distortion folds.
void warn_of_fold(const Camera& camera, const Coverage& coverage, Diagnostics& diagnostics) {
  constexpr double kSmallestShare = 1e-3;       // of the image; a smaller part without rays is not reported
  constexpr double kLargestShareOfNote = 0.01;  // of the image; a larger part is a warning instead of a note
  if (!is_perspective(model_info(camera.model).id) || coverage.outside_lens < kSmallestShare) return;
  diagnostics.add(coverage.outside_lens > kLargestShareOfNote ? Severity::kWarning : Severity::kNote, Code::kFoldsInsideImage,
                  {camera.name, max_angle(camera.model) / kRadiansPerDegree, coverage.outside_lens});
}

/// Warns of focal lengths and principal points that no real camera has, but that can be converted. The command `check` applies
/// stricter limits.
void warn_of_odd_camera(const Camera& camera, const ImageSize& size, Diagnostics& diagnostics) {
  constexpr double kLargestRatio = 2.0;  // of the focal lengths; larger than that of any real sensor
  const auto [f_u, f_v] = central_focal_lengths(camera.model);
  if (std::max(f_u, f_v) > kLargestRatio * std::min(f_u, f_v)) {
    diagnostics.add(Code::kFocalLengthsDiffer, {camera.name, f_u, f_v});
  }
  const auto [u, v] = principal_point(camera.model);
  if (!(u >= -0.5 && u <= size.width - 0.5 && v >= -0.5 && v <= size.height - 0.5)) {
    diagnostics.add(Code::kCentreOutside, {camera.name, std::lround(u), std::lround(v), size.width, size.height});
  }
}

/// The largest number of pixels per radian at the axis divided by the smallest, over all directions from it. 1 if rays near the
/// axis have no pixels; infinite if the smallest number is 0.
double stretch_on_axis(const CameraModel& model) {
  constexpr double kStep = 1e-5;
  const auto pixels = [&model](double x, double y) -> std::optional<Pixel> {
    const std::optional<Pixel> plus = project(model, {x, y, 1.0});
    const std::optional<Pixel> minus = project(model, {-x, -y, 1.0});
    if (!plus || !minus) return std::nullopt;
    return Pixel{(*plus)[0] - (*minus)[0], (*plus)[1] - (*minus)[1]};
  };
  const std::optional<Pixel> x = pixels(kStep, 0.0);
  const std::optional<Pixel> y = pixels(0.0, kStep);
  if (!x || !y) return 1.0;
  // The ratio of the singular values of the 2 x 2 matrix with the columns x and y.
  const double squares = (*x)[0] * (*x)[0] + (*x)[1] * (*x)[1] + (*y)[0] * (*y)[0] + (*y)[1] * (*y)[1];
  const double determinant = std::abs((*x)[0] * (*y)[1] - (*x)[1] * (*y)[0]);
  if (!(determinant > 0.0)) return std::numeric_limits<double>::infinity();
  return (squares + std::sqrt(std::max(0.0, squares * squares - 4.0 * determinant * determinant))) / (2.0 * determinant);
}

/// The options, reduced to a single fit if the stretch is larger than that of any real sensor: without a search for a smaller
/// angle or a higher degree, which would take long. `stretch`: see stretch_on_axis().
ConvertOptions without_search_if_stretched(ConvertOptions options, double stretch, const ModelInfo& target) {
  constexpr double kLargestStretch = 3.0;
  if (stretch <= kLargestStretch) return options;
  options.reduce_angle = false;
  if (target.least_degree > 0) options.degree = options.degree.value_or(target.least_degree);
  return options;
}

/// False, with an error, if the stretch at the axis is larger than that of any lens. A fit would then take a hundred times as
/// long and be wrong by many pixels.
bool is_worth_a_fit(const Camera& camera, double stretch, Diagnostics& diagnostics) {
  constexpr double kLargestStretch = 300.0;
  if (stretch <= kLargestStretch) return true;
  diagnostics.add(Code::kStretchOfNoLens, {camera.name, stretch});
  return false;
}

/// The full evaluation of a model. `lattice`: its errors on the lattice.
ErrorStatistics final_statistics(const FitTask& task, const internal::Scorer& scorer, internal::Score lattice) {
  return internal::evaluate_all(scorer, std::move(lattice), {task.options.every_pixel, task.options.bound});
}

/// The angle [deg] from the axis up to which `model` is scored. `max_angle_rad`: the angle up to which its fit is valid.
double scored_to_deg(const FitTask& task, const CameraModel& model, double max_angle_rad) {
  return std::min({task.field_of_view.max_angle_rad, max_angle_rad, max_angle(model)}) / kRadiansPerDegree;
}

/// Compares `model` with the camera, up to `max_angle_rad` from the axis.
internal::Scorer scorer_of(const FitTask& task, const CameraModel& model, double max_angle_rad) {
  return {task.camera.model, &model, nullptr, task.field_of_view, max_angle_rad};
}

/// True if it is certain that every pixel of the image has a ray in the field of view. A conversion to the same camera is then
/// scored at every pixel.
bool is_surely_whole(const FitTask& task) {
  return !task.field_of_view.circle && task.field_of_view.why.code == Code::kFieldOfViewWholeImage &&
         is_surely_covered(task.camera.model, task.field_of_view.size);
}

/// The statistics of a conversion to the same camera: the whole image is scored, and all errors are 0.
ErrorStatistics statistics_of_same_camera(const FieldOfView& field_of_view) {
  ErrorStatistics result;
  result.coverage.max_angle_deg = field_of_view.max_angle_rad / kRadiansPerDegree;
  result.coverage.why = field_of_view.why;
  result.coverage.scored = 1.0;
  return result;
}

/// The conversion without a fit; nullopt if the target cannot represent the source exactly (up to rounding), or not within the
/// ranges and fixed values of the options.
std::optional<Conversion> exact_conversion(const FitTask& task) {
  const std::optional<CameraModel> model = internal::convert_exactly(task.camera.model, task.target.id);
  if (!model || !within(*model, task.options.ranges) || !is_as_fixed(*model, task.options.fixed) || !validate(*model).empty())
    return std::nullopt;
  Conversion conversion{task.camera, {}};
  conversion.camera.model = *model;
  conversion.report.exact = true;
  conversion.report.scored_to_deg = scored_to_deg(task, *model, std::numbers::pi);
  if (!task.options.errors_of_kept && *model == task.camera.model && is_surely_whole(task)) {
    conversion.report.statistics = statistics_of_same_camera(task.field_of_view);
    return conversion;
  }
  const internal::Scorer scorer = scorer_of(task, *model, std::numbers::pi);
  conversion.report.statistics = final_statistics(task, scorer, internal::score_on_lattice(scorer));
  return conversion;
}

/// Searches near a least-squares fit for the camera with the smallest maximum error. Replaces the fit if that camera's maximum
/// is smaller and if it covers as much of the image.
void minimise_largest_error(const FitTask& task, double max_angle_rad, std::span<const ParameterRange> ranges,
                            Conversion& conversion) {
  using Clock = std::chrono::steady_clock;
  ConversionReport& report = conversion.report;
  CameraModel& model = conversion.camera.model;
  const ErrorStatistics& before = report.statistics;
  report.objective = Objective::kMax;
  report.rms_fit = {before.error.rms, before.error.max, true};
  const Clock::time_point start = Clock::now();
  internal::MinimaxFit fit = internal::fit_largest_error(task.camera.model, model, task.field_of_view, max_angle_rad, ranges);
  report.fit.time_us += std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  report.fit.iterations += fit.iterations;
  if (!validate(fit.model).empty()) return;
  const internal::Scorer scorer = scorer_of(task, fit.model, max_angle_rad);
  ErrorStatistics after = final_statistics(task, scorer, internal::score_on_lattice(scorer));
  if (!(after.error.max < before.error.max && after.coverage.scored >= before.coverage.scored)) return;
  report.rms_fit->kept = false;
  report.statistics = std::move(after);
  report.at_bound = std::move(fit.at_bound);
  model = fit.model;
}

/// The first fit for which an error bound can be proven. The first fit of all if there is no such fit, or if no bound is
/// requested. `statistics` receives the evaluation of the chosen fit.
internal::DegreeFit& choose_proven(const FitTask& task, std::vector<internal::DegreeFit>& fits, ErrorStatistics& statistics) {
  const auto evaluated = [&task](internal::DegreeFit& each) {
    const internal::Scorer scorer = scorer_of(task, each.fit.fitted.model->model, each.fit.fitted.max_angle_rad);
    return final_statistics(task, scorer, std::move(each.fit.score));
  };
  statistics = evaluated(fits.front());
  if (!task.options.bound || std::isfinite(statistics.error.bound)) return fits.front();
  for (internal::DegreeFit& each : std::span(fits).subspan(1)) {
    ErrorStatistics other = evaluated(each);
    if (!std::isfinite(other.error.bound)) continue;
    statistics = std::move(other);
    return each;
  }
  return fits.front();
}

/// The conversion by the best fit; nullopt, with an error, if the fit fails.
std::optional<Conversion> fitted_conversion(const FitTask& task, Diagnostics& diagnostics) {
  std::vector<internal::DegreeFit> fits = internal::fit_degrees(task);
  const internal::SampledFit& first = fits.front().fit.fitted;
  if (internal::too_few(first.samples, task.target)) {
    diagnostics.add(Code::kTooFewRaysToFit, {task.camera.name, task.target.id});
    return std::nullopt;
  }
  const ImageSize& size = task.field_of_view.size;
  const double pixels = fits.front().fit.score.statistics.coverage.scored * size.width * size.height;
  if (first.model && 2.0 * pixels < static_cast<double>(task.target.parameters.size())) {
    diagnostics.add(Code::kTooFewPixelsToFit, {task.camera.name, task.target.id});
    return std::nullopt;
  }
  if (!first.model) {
    diagnostics.add(Code::kFitFailed, {task.camera.name, task.target.id});
    return std::nullopt;
  }
  Conversion conversion{task.camera, {}};
  const internal::DegreeFit& chosen = choose_proven(task, fits, conversion.report.statistics);
  const internal::SampledFit& fitted = chosen.fit.fitted;
  conversion.report.angle_reduced = fitted.max_angle_rad < std::numbers::pi;
  if (conversion.report.angle_reduced) warn_of_reduced_angle(task, fitted.max_angle_rad, diagnostics);
  conversion.camera.model = fitted.model->model;
  conversion.report.fit = {static_cast<int>(fitted.samples), fitted.model->iterations, chosen.fit.time.count()};
  conversion.report.at_bound = fitted.model->at_bound;
  conversion.report.degree = chosen.degree;
  conversion.report.unusual = chosen.unusual;
  for (const UnusualParameter& each : chosen.unusual) {
    diagnostics.add(Code::kParameterUnusual, {task.camera.name, task.target.id, each.name, each.value, each.usual[0],
                                              each.usual[1], each.rms_inside_px, chosen.fit.rms_px});
  }
  if (task.options.absorb_turn) {
    internal::absorb_turn(task, chosen, conversion, diagnostics);
  } else if (internal::has_equal_weights(task.options.weight)) {
    conversion.report.turn_offer = internal::offered_turn(task, chosen, conversion.report.statistics.error.rms);
  }
  if (task.options.objective == Objective::kMax) minimise_largest_error(task, fitted.max_angle_rad, chosen.ranges, conversion);
  conversion.report.scored_to_deg = scored_to_deg(task, conversion.camera.model, fitted.max_angle_rad);
  return conversion;
}

/// False, with an error, if the weights are an image of another size than the camera's, or an image that is black at every
/// pixel of the field of view.
bool is_usable(const FitWeight& weight, const Camera& camera, const FieldOfView& field_of_view, Diagnostics& diagnostics) {
  if (weight.kind != WeightKind::kImage) return true;
  const ImageSize size = weight.density != nullptr ? ImageSize{weight.density->width, weight.density->height} : ImageSize{0, 0};
  if (size != field_of_view.size) {
    diagnostics.add(Code::kImageOfOtherSize, {size.width, size.height, camera.name, field_of_view.size.width,
                                              field_of_view.size.height, Message{Code::kGiveCalibratedSize}});
    return false;
  }
  if (internal::has_weight(*weight.density, camera.model, field_of_view)) return true;
  diagnostics.add(Code::kWeightsBlack, {camera.name});
  return false;
}

/// The weighted rms of the conversion; nullopt if the caller chose equal weights for all pixels.
std::optional<WeightedRms> weighted_error(const Camera& camera, const FitWeight& weight, const Conversion& conversion,
                                          const FieldOfView& field_of_view) {
  if (weight.kind == WeightKind::kPixel) return std::nullopt;
  const ConversionReport& report = conversion.report;
  if (internal::has_equal_weights(weight)) return WeightedRms{weight.kind, report.statistics.error.rms};
  // The rms is over the scored rays. Without the slack, rounding could exclude the rays at the edge.
  constexpr double kSlack = 1.0 + 1e-9;
  const double max_angle_rad = kSlack * report.scored_to_deg * kRadiansPerDegree;
  const Transform* turn = report.turn ? &report.turn->T_target_source : nullptr;
  return WeightedRms{weight.kind,
                     internal::weighted_rms(weight, camera.model, conversion.camera.model, field_of_view, max_angle_rad, turn)};
}

/// True if the options are valid for a conversion to `target`; otherwise false, with an error.
bool are_valid(const ConvertOptions& options, const ModelInfo& target, Diagnostics& diagnostics) {
  constexpr int kMostSamples = 100'000;
  if (options.samples < 1 || options.samples > kMostSamples) {
    diagnostics.add(Code::kSamplesInvalid, {kMostSamples});
    return false;
  }
  if (options.degree &&
      (target.least_degree == 0 || *options.degree < target.least_degree || *options.degree > target.most_degree)) {
    diagnostics.add(target.least_degree == 0 ? Code::kModelHasNoDegree : Code::kDegreeOutside,
                    {target.id, target.least_degree, target.most_degree});
    return false;
  }
  if (options.absorb_turn && options.objective != Objective::kRms) {
    diagnostics.add(Code::kTurnedForRms);
    return false;
  }
  if (options.weight.kind != WeightKind::kPixel && options.objective != Objective::kRms) {
    diagnostics.add(Code::kWeightedForRms);
    return false;
  }
  std::vector<ParameterRange> ranges = options.ranges;
  ranges.insert(ranges.end(), options.fixed.at.begin(), options.fixed.at.end());
  for (const ParameterRange& range : ranges) {
    if (std::ranges::find(target.parameters, range.parameter.name(), &Parameter::name) == target.parameters.end()) {
      diagnostics.add(Code::kModelHasNoParameter, {target.id, range.parameter.name()});
      return false;
    }
    if (!(range.lower <= range.upper)) {
      diagnostics.add(Code::kRangeEmpty, {range.parameter.name()});
      return false;
    }
  }
  return true;
}

}  // namespace

bool within(const CameraModel& model, std::span<const ParameterRange> ranges) {
  return std::ranges::all_of(ranges, [&model](const ParameterRange& range) {
    const std::optional<double> value = parameter(model, range.parameter);
    return !value || (*value >= range.lower && *value <= range.upper);
  });
}

bool is_as_fixed(const CameraModel& model, const FixedParameters& fixed) {
  return within(model, fixed.at) && (!fixed.one_focal_length || parameter(model, "fx") == parameter(model, "fy"));
}

std::optional<Conversion> convert(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  const ModelInfo* target = find_model(options.model);
  if (target == nullptr) {
    diagnostics.add(Code::kUnknownModel, {options.model});
    return std::nullopt;
  }
  if (!are_valid(options, *target, diagnostics)) return std::nullopt;
  const std::optional<ConvertOptions> fixed = internal::with_fixed(camera, *target, options, diagnostics);
  if (!fixed) return std::nullopt;
  if (!camera.rays.empty()) return internal::convert_table(camera, *target, *fixed, diagnostics);
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, options.max_angle_rad, diagnostics);
  if (!field_of_view) return std::nullopt;
  warn_of_odd_camera(camera, field_of_view->size, diagnostics);
  const LensCentre centre{central_focal_lengths(camera.model), principal_point(camera.model)};
  const double stretch = stretch_on_axis(camera.model);
  ConvertOptions fit_options = without_search_if_stretched(*fixed, stretch, *target);
  if (!is_usable(options.weight, camera, *field_of_view, diagnostics)) return std::nullopt;
  if (internal::has_equal_weights(options.weight)) fit_options.weight = {};
  const FitTask task{camera, *target, fit_options, *field_of_view, centre};

  std::optional<Conversion> conversion = exact_conversion(task);
  if (!conversion && internal::id_without_skew(target->id) != target->id) {
    // No fit has a skew as unknown. Fits the model without skew, and adds the skew 0.
    ConvertOptions straight = options;
    straight.model = internal::id_without_skew(target->id);
    conversion = convert(camera, straight, diagnostics);
    if (!conversion) return std::nullopt;
    conversion->camera.model = with_skew(conversion->camera.model, 0.0).value();
    conversion->report.to_model = target->id;
    return conversion;
  }
  if (!conversion && is_worth_a_fit(camera, stretch, diagnostics)) conversion = fitted_conversion(task, diagnostics);
  if (!conversion) return std::nullopt;
  if (!options.max_angle_rad && !camera.lens_circle) warn_of_fold(camera, conversion->report.statistics.coverage, diagnostics);
  conversion->report.from_model = model_info(camera.model).id;
  conversion->report.to_model = target->id;
  conversion->report.weighted = weighted_error(camera, options.weight, *conversion, *field_of_view);
  if (options.max_angle_table)
    conversion->report.max_angles = max_angle_table(camera, options, conversion->report, diagnostics);
  if (!(conversion->report.statistics.coverage.scored > 0.0)) {
    diagnostics.add(Code::kNoPartCompared, {camera.name, target->id});
    return std::nullopt;
  }
  return conversion;
}

}  // namespace fca
