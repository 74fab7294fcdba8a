// SPDX-License-Identifier: BSD-3-Clause
// Every model that a camera could be written as, what that costs, and who reads it.
#pragma once

#include <fca/convert/convert.h>
#include <fca/formats/format.h>
#include <fca/formats/pixel_distance.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/status.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

/// A format that stores a model.
struct StoringFormat {
  std::string name;
  Code demands =
      {};  ///< Why the camera's numbers are fitted again for the format, a clause; kNone: it stores these very numbers.
  bool operator==(const StoringFormat&) const = default;
};

/// A model fitted to the inscribed circle of a wide lens alone.
struct CircleFit {
  double max_angle_deg = 0.0;  ///< Of the fit: all that the circle shows.
  PixelDistance distance;      ///< In the circle.
};

/// One model as a camera's target. No conversion: it cannot describe the camera, `diagnostics` say why.
struct Candidate {
  const ModelInfo* model = nullptr;
  std::optional<Conversion> conversion;  ///< To the whole lens.
  CameraDistance distance = {};          ///< From the camera to the model of that conversion.
  std::optional<CircleFit> in_circle;    ///< Where it is better there: beyond the circle it is worse.

  /// By which models are ranked: of a lens wider than 120 deg the circle about the middle of the image decides, not its
  /// corners.
  [[nodiscard]] const PixelDistance& decisive() const { return in_circle ? in_circle->distance : distance.decisive(); }
  std::vector<StoringFormat> stored_by;
  Diagnostics diagnostics;
};

/// Does the model, which could be fitted, reach all of the region that decides?
[[nodiscard]] bool reaches_all(const Candidate& candidate);

/// The candidates that could be fitted, by their error in the region that decides; those that do not reach all of it last.
[[nodiscard]] std::vector<const Candidate*> ranked(const std::vector<Candidate>& candidates);

/// All models, in the order of the list.
[[nodiscard]] std::vector<Candidate> candidates(const Camera& camera, std::optional<double> max_angle_rad);

/// The candidate to take: the camera's own model if it is exact, else the best of those that nobody would notice as a fit to
/// the whole lens, else the first that is ranked. Of those that the stock program of `format` reads, if one is given. Null
/// where there is none.
[[nodiscard]] const Candidate* recommended(const std::vector<Candidate>& candidates, const Format* format);

/// The same among all but `other`.
[[nodiscard]] const Candidate* recommended_beside(const std::vector<Candidate>& candidates, const Candidate& other);

/// Every model next to the others, for each camera of a calibration.
struct ModelsResult {
  struct OfCamera {
    Camera camera;
    std::vector<Candidate> candidates;
  };
  Status status = Status::kDone;
  std::vector<OfCamera> cameras;
  Diagnostics diagnostics;
};

/// What each camera of a calibration would be as every model.
[[nodiscard]] ModelsResult compare_models(const Inputs& inputs, Files& files);

/// The same of cameras that were read. Nothing with errors where one has no part of its image to compare over.
[[nodiscard]] std::optional<std::vector<ModelsResult::OfCamera>> compare_models(const std::vector<Camera>& cameras,
                                                                                std::optional<double> max_angle_rad,
                                                                                Diagnostics& diagnostics);

}  // namespace fca
