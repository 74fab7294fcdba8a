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

/// What a model gets that cannot describe the whole lens.
enum class Partial : std::uint8_t { kCone, kNothing };

struct ModelChoice {
  const ConvertRequest& request;        ///< What is asked of a fit; it outlives the choice.
  std::size_t most_cameras = SIZE_MAX;  ///< Further ones are not converted: no file will hold them.
  std::span<const consumers::UnreadParameter> unread = {};
  std::vector<std::string> among = {};  ///< What may be chosen; empty: what the stock program reads.
  Partial partial = Partial::kCone;
  KnownConversions* known = nullptr;  ///< Where conversions of the same request are remembered; null: nowhere.
  bool errors_of_kept = true;         ///< As in the request.
  bool same_format = false;           ///< The cameras come from a file of the format they are written to.
};

/// Does a fresh file in that layout, one of the format's, hold the model?
[[nodiscard]] bool layout_stores(const Format& to, std::string_view layout, std::string_view model);

/// What may be chosen for such a file: the stock program's of the models that the layout holds, else all of those.
[[nodiscard]] std::vector<std::string> models_of_layout(const Format& to, std::string_view layout);

/// Is the model one that the choice takes where none is asked for?
[[nodiscard]] bool may_be_chosen(const StoredModel& stored, const ModelChoice& choice);

/// What lib/convert is to be asked for, to fit a camera to what `stored` can hold.
[[nodiscard]] ConvertOptions options_for(const StoredModel& stored, const ModelChoice& choice);

/// As fca::convert(), or remembered.
[[nodiscard]] std::optional<Conversion> converted(const Camera& camera, const ConvertOptions& options,
                                                  const ModelChoice& choice, Diagnostics& diagnostics);

/// The cameras as `format` will store them. Without a model asked for: each keeps its model if the stock program reads it
/// exactly and all agree, else all take the stock model that covers most of the images and, among equals, fits best by
/// the objective.
[[nodiscard]] std::optional<std::vector<ConvertedCamera>> convert_cameras(const std::vector<Camera>& cameras,
                                                                          const Format& format, const ModelChoice& choice,
                                                                          Diagnostics& diagnostics);

}  // namespace fca
