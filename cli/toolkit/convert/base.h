// SPDX-License-Identifier: BSD-3-Clause
// The base of a conversion: the text that it edits. That is the file named by --into, or the input itself if its layout stays.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

struct Base {
  const text::Document* document = nullptr;
  const Calibration* into = nullptr;  ///< The file of --into, which is the base; null: the input is the base, or there is none.
  bool adopted = false;               ///< The base is the input, in another format with the same layout.
};

/// Reads the file of request.into. nullopt, with an error, if it cannot be a base.
[[nodiscard]] std::optional<Calibration> read_into(const ConvertRequest& request, Files& files, ConvertResult& result);

/// False, with an error, if the base contains only poses and the input has none of them.
[[nodiscard]] bool base_poses_are_known(const Calibration& into, const Rig& rig, const std::string& input,
                                        ConvertResult& result);

/// True if the text of the file of --into must be kept, not replaced by a fresh file.
[[nodiscard]] bool keeps_text(const ConvertRequest& request, const Base& base);

/// The models that fits may choose if the file of --into is kept; empty: no such limit. A file of a fork's model needs that
/// model. A file that keeps one of its cameras needs that camera's model. Others can take the models that their layout holds.
[[nodiscard]] std::vector<std::string> models_for(const ConvertRequest& request, const Base& base, const Rig& input,
                                                  const Format& to);

/// False, with an error, if the base cannot hold the request's model.
[[nodiscard]] bool holds_model(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to,
                               Diagnostics& diagnostics);

/// False, with an error, if the base is for images of another size. Such a base also contains thresholds and columns for its
/// size, so that it is not silently changed. An input that is written into itself may change its size, since the user asked for
/// that.
[[nodiscard]] bool sizes_agree(const Calibration& base, const Calibration& input, const Rig& rig, const ConvertRequest& request,
                               Diagnostics& diagnostics);

/// False, with an error, if the writer replaced the base, whose text must be kept, by a fresh file. A plain-text file (DSO's
/// camera.txt) never becomes a YAML file.
[[nodiscard]] bool is_edit_of_base(const ConvertRequest& request, const Base& base, const Written& written,
                                   Diagnostics& diagnostics);

/// The base of the conversion: the file of --into, the first of joined files of the target's format, or the only input.
/// Base::document is null if there is none.
[[nodiscard]] Base base_of(const ConvertRequest& request, const Calibration& input, const std::optional<Calibration>& into,
                           const Format& to);

}  // namespace fca
