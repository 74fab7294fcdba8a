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

/// What to do with a model that cannot describe the whole lens: fit it up to a smaller angle, or not at all.
enum class Partial : std::uint8_t { kSmallerAngle, kNothing };

struct ModelChoice {
  const ConvertRequest& request;        ///< Options of the fits; it must outlive the choice.
  std::size_t most_cameras = SIZE_MAX;  ///< Cameras beyond this number are not converted, since no file will contain them.
  std::span<const consumers::UnreadParameter> unread = {};
  std::vector<std::string> among = {};  ///< Ids of the models that may be chosen; empty: those that the stock program reads.
  Partial partial = Partial::kSmallerAngle;
  KnownConversions* known = nullptr;  ///< A cache of conversions of the same request; null: none.
  bool errors_of_kept = true;         ///< As in the request.
  bool same_format = false;           ///< The cameras come from a file of the format they are written to.
};

/// True if a fresh file in that layout of the format can contain the model.
[[nodiscard]] bool layout_stores(const Format& to, std::string_view layout, std::string_view model);

/// Ids of the models that may be chosen for that layout: those that the stock program reads or, if the layout holds none of
/// these, all that it holds.
[[nodiscard]] std::vector<std::string> models_of_layout(const Format& to, std::string_view layout);

/// True if the model may be chosen when the request names none.
[[nodiscard]] bool may_be_chosen(const StoredModel& stored, const ModelChoice& choice);

/// The options of fca::convert() for a fit to what `stored` can hold.
[[nodiscard]] ConvertOptions options_for(const StoredModel& stored, const ModelChoice& choice);

/// Like fca::convert(), but uses the cache of the choice.
[[nodiscard]] std::optional<Conversion> converted(const Camera& camera, const ConvertOptions& options,
                                                  const ModelChoice& choice, Diagnostics& diagnostics);

/// The cameras as `format` will store them; nullopt, with errors, if a fit fails. Unless the request names a model, cameras
/// keep their model if the stock program reads it exactly (all of them, if the format has one model for all). The others take
/// the stock model that covers most of the images and, among equals, has the smallest error by the objective.
[[nodiscard]] std::optional<std::vector<ConvertedCamera>> convert_cameras(const std::vector<Camera>& cameras,
                                                                          const Format& format, const ModelChoice& choice,
                                                                          Diagnostics& diagnostics);

}  // namespace fca
