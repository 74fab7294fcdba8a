// SPDX-License-Identifier: BSD-3-Clause
// One camera as another model would describe it. Steps, each in its own file: field of view -> sample -> fit -> evaluate.
#pragma once

#include <fca/convert/fit_weight.h>
#include <fca/convert/parameter_range.h>
#include <fca/convert/report.h>
#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {

struct ConvertOptions {
  std::string model;                    ///< Id or alias of the target model.
  std::optional<double> max_angle_rad;  ///< What counts as lens, from the axis; default: the whole image.
  std::vector<ParameterRange> ranges;   ///< Of the target's parameters.
  std::optional<int> degree = {};  ///< Of a target that is a polynomial (ModelInfo::least_degree); default: the lowest that is
                                   ///< nearly as good as any.
  FixedParameters fixed = {};
  bool absorb_turn = false;  ///< A turn of the camera is fitted, too (ConversionReport::turn); for Objective::kRms.
  Objective objective = Objective::kRms;
  FitWeight weight = {};  ///< Of Objective::kRms: what counts how much in the sum of squares.
  /// What cannot describe the whole field of view is fitted up to a smaller angle; false: not at all, an error.
  bool reduce_angle = true;
  bool every_pixel = false;  ///< The report counts each pixel instead of a lattice.
  bool bound = true;         ///< The report proves ErrorSummary::bound.
  /// False: the report of a camera that keeps its model may hold the coverage alone, without errors, which are 0 but for
  /// rounding.
  bool errors_of_kept = true;
  bool max_angle_table = false;  ///< The report holds the table of max_angle_table.h, at the price of one more fit per row.
  int samples = 200;             ///< To begin with; more where the target turns out to be worse between them.
  bool operator==(const ConvertOptions&) const = default;
};

/// A converted camera (everything but the model is the source's) and how good it is.
struct Conversion {
  Camera camera;
  ConversionReport report;
};

/// Converts `camera` to another model at the least-squares optimum in pixels over its field of view, weighted by
/// options.weight, or, with Objective::kMax, at the camera near it whose largest error is smallest; that one reaches every ray
/// which the least-squares fit reaches. The same model, and a model that contains the source (ucm -> eucm, pinhole -> radtan,
/// ...), are exact.
///
/// Where the target cannot describe the whole field of view, it is fitted up to the largest angle from the axis that it can
/// describe, with a warning. To describe means to have a pixel for every ray, but for the very edge (a thousandth of the
/// image), without a fold; of a perspective model (is_perspective: radtan, rational, pinhole), also to stay under 1 px rms.
/// Other models are fitted to all that they reach, at whatever error (ucm from a lens of 360 degrees: 3.7 px rms inside 136
/// degrees from the axis): a wider field of view never scores less of the image, and options.max_angle_rad buys a better fit
/// nearer the axis.
///
/// Errors: unknown model, no image size, parameters that are no camera, a field of view without pixels, an image of weights of
/// another size or that counts none of them.
[[nodiscard]] std::optional<Conversion> convert(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics);

/// Whether the model's parameters lie within the ranges.
[[nodiscard]] bool within(const CameraModel& model, std::span<const ParameterRange> ranges);

/// Has the model what is to be fixed at a number, and one focal length if that is asked for? What is to be kept as the source
/// has it is not looked at.
[[nodiscard]] bool is_as_fixed(const CameraModel& model, const FixedParameters& fixed);

}  // namespace fca
