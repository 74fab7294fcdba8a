// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "known_conversions.h"

#include <fca/convert/convert.h>
#include <fca/formats/format.h>
#include <fca/toolkit/convert.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// What to do with a model that cannot describe the whole lens: fit it up to a smaller angle, or fail with an error.
enum class Partial : std::uint8_t { kSmallerAngle, kNothing };

/// Which models the cameras may get, and how they are fitted.
struct ModelChoice {
  const ConvertRequest& request;        ///< The options of the fits. The request must outlive this object.
  std::size_t most_cameras = SIZE_MAX;  ///< Further cameras are not converted, since no file will contain them.
  /// Parameters that the program does not read, and the values that it uses instead.
  std::span<const consumers::UnreadParameter> unread = {};
  std::vector<std::string> among =
      {};  ///< Ids of the models that may be chosen; empty: those that the format's own program reads.
  Partial partial = Partial::kSmallerAngle;
  KnownConversions* known = nullptr;  ///< A cache of conversions of the same request; null: none.
  bool errors_of_kept = true;  ///< Evaluate the errors of cameras that keep their model (ConvertOptions::errors_of_kept).
  bool same_format = false;    ///< The cameras come from a file of the target's format.
};

/// True if a fresh file in that layout of the format can contain the model.
[[nodiscard]] bool layout_stores(const Format& to, std::string_view layout, std::string_view model);

/// Ids of the models that may be chosen for that layout: the models that the layout can hold and the format's own program
/// reads. If there is none, all models that the layout can hold.
[[nodiscard]] std::vector<std::string> models_of_layout(const Format& to, std::string_view layout);

/// True if the model may be chosen for a camera that does not have it, when the request names no model.
[[nodiscard]] bool may_be_chosen(const StoredModel& stored, const ModelChoice& choice);

/// The options of fca::convert() for a fit of the model `stored`, within the parameter ranges that the format can hold.
[[nodiscard]] ConvertOptions options_for(const StoredModel& stored, const ModelChoice& choice);

/// Like fca::convert(), but uses the cache of the choice.
[[nodiscard]] std::optional<Conversion> converted(const Camera& camera, const ConvertOptions& options,
                                                  const ModelChoice& choice, Diagnostics& diagnostics);

/// Converts the cameras to models that `format` can store. Returns one element per camera, or nullopt, with errors, if a fit
/// fails. If the request names a model, all cameras get it. Otherwise a camera keeps its model if the format's own program
/// reads it with the camera's parameters. If the format has one model for all cameras of a file, either all of them keep it or
/// none. The cameras that do not keep their model get one common model: the one that covers the largest part of the images or,
/// among models with the same coverage, has the smallest error by the request's objective.
[[nodiscard]] std::optional<std::vector<ConvertedCamera>> convert_cameras(const std::vector<Camera>& cameras,
                                                                          const Format& format, const ModelChoice& choice,
                                                                          Diagnostics& diagnostics);

}  // namespace fca
