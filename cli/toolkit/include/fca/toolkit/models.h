// SPDX-License-Identifier: BSD-3-Clause
// Fits every camera model to a camera, and lists the error of each model and the formats that store it.
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
  /// The reason for which a conversion to the format must fit the model again. kNone: the format stores the parameters as they
  /// are.
  Code demands = {};
  bool operator==(const StoringFormat&) const = default;
};

/// A fit of a model to a wide lens, only inside the image's inscribed circle.
struct CircleFit {
  double max_angle_deg = 0.0;  ///< Largest angle from the axis that is visible in the circle. The fit ends there.
  PixelDistance distance;      ///< The distance between the camera and the fitted model inside the circle.
};

/// One model, and the camera's conversion to it.
struct Candidate {
  const ModelInfo* model = nullptr;
  std::optional<Conversion> conversion;  ///< The fit to the whole lens. nullopt if it fails; `diagnostics` contain the reason.
  CameraDistance distance = {};          ///< The distance between the camera and the converted camera.
  std::optional<CircleFit> in_circle;    ///< Only for a lens wider than 120 deg, if this fit is better there than `conversion`.

  /// The distance that ranks the models, over the region that decides: the whole image, or, of a lens wider than 120 deg, the
  /// image's inscribed circle, since its corners do not count. Of a wide lens it is that of `in_circle`, if this is set.
  [[nodiscard]] const PixelDistance& decisive() const { return in_circle ? in_circle->distance : distance.decisive(); }
  std::vector<StoringFormat> stored_by;  ///< The formats that store the model.
  Diagnostics diagnostics;
};

/// True if the model covers the whole region that decides the ranking. The candidate must have a conversion.
[[nodiscard]] bool reaches_all(const Candidate& candidate);

/// The candidates that have a conversion: exact ones first, then by increasing rms in the region that decides, and last those
/// that do not cover all of this region.
[[nodiscard]] std::vector<const Candidate*> ranked(const std::vector<Candidate>& candidates);

/// Fits every model to the camera, in the order of all_models(). `max_angle_rad`: the angle from the axis at which the lens
/// ends; nullopt: the whole image.
[[nodiscard]] std::vector<Candidate> candidates(const Camera& camera, std::optional<double> max_angle_rad);

/// The candidate to use: the camera's own model if it is exact. Otherwise, of the candidates whose fit to the whole lens is
/// `ready` by the limits of verdict.h, the one with the smallest rms in the region that decides. If no candidate is ready, the
/// best of all, as ranked() puts it. If `format` is not null, only models that the format's own program reads are considered.
/// Null if there is no such candidate.
[[nodiscard]] const Candidate* recommended(const std::vector<Candidate>& candidates, const Format* format);

/// Like recommended(), for any format, of all candidates except `other`.
[[nodiscard]] const Candidate* recommended_beside(const std::vector<Candidate>& candidates, const Candidate& other);

/// All models of each camera of a calibration.
struct ModelsResult {
  struct OfCamera {
    Camera camera;
    std::vector<Candidate> candidates;
  };
  Status status = Status::kDone;
  std::vector<OfCamera> cameras;
  Diagnostics diagnostics;
};

/// Reads a calibration and fits every model to each of its cameras.
[[nodiscard]] ModelsResult compare_models(const Inputs& inputs, Files& files);

/// Fits every model to each camera. nullopt, with errors, if a camera has no field of view over which models could be
/// compared.
[[nodiscard]] std::optional<std::vector<ModelsResult::OfCamera>> compare_models(const std::vector<Camera>& cameras,
                                                                                std::optional<double> max_angle_rad,
                                                                                Diagnostics& diagnostics);

}  // namespace fca
