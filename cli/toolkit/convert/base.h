// SPDX-License-Identifier: BSD-3-Clause
// The text that a conversion is written into: the request's base, or the input itself where the layout stays.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

struct Base {
  const text::Document* document = nullptr;
  const Calibration* into = nullptr;  ///< The request's; null: the input is the base, or there is none.
  bool adopted = false;               ///< The input, of another format with the same layout.
};

/// The request's base. Nothing with an error where it cannot be one.
[[nodiscard]] std::optional<Calibration> read_into(const ConvertRequest& request, Files& files, ConvertResult& result);

/// False with an error where the base holds only a pose that the input does not state.
[[nodiscard]] bool has_use_for(const Calibration& into, const Rig& rig, const std::string& input, ConvertResult& result);

/// Does the text of the request's base have to stay?
[[nodiscard]] bool keeps_text(const ConvertRequest& request, const Base& base);

/// The models to choose from for the request's base: a fork's file is of the fork's own, one that keeps a camera of that
/// camera's, another of those that its layout holds; empty: no such limit.
[[nodiscard]] std::vector<std::string> models_for(const ConvertRequest& request, const Base& base, const Rig& input,
                                                  const Format& to);

/// False with an error where the request's model is one for which the base has no place.
[[nodiscard]] bool holds_model(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to,
                               Diagnostics& diagnostics);

/// False with an error where the base is for images of another size. A base is not silently made one for other images, whose
/// thresholds and columns differ; an input that is written into itself is the owner's to change.
[[nodiscard]] bool sizes_agree(const Calibration& base, const Calibration& input, const Rig& rig, const ConvertRequest& request,
                               Diagnostics& diagnostics);

/// False with an error where the base, whose text is to stay, would become a fresh file. Lines of words (DSO's camera.txt) are
/// never made a YAML file.
[[nodiscard]] bool is_edit_of_base(const ConvertRequest& request, const Base& base, const Written& written,
                                   Diagnostics& diagnostics);

/// The base of the request: its own, or of joined files of the target's format the first, or the only input.
[[nodiscard]] Base base_of(const ConvertRequest& request, const Calibration& input, const std::optional<Calibration>& into,
                           const Format& to);

}  // namespace fca
