// SPDX-License-Identifier: BSD-3-Clause
// The base of a conversion: the file whose text is edited to make the output. It is the file of --into, or the input if the
// output has the layout of the input.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

struct Base {
  const text::Document* document = nullptr;  ///< The file to edit; null: there is none, and a fresh file is written.
  const Calibration* into = nullptr;         ///< The calibration in the file of --into; null without --into.
  bool adopted = false;                      ///< The base is the input, and the target is another format with the same layout.
};

/// Reads the file request.into. Returns nullopt, with an error, if it cannot be a base.
[[nodiscard]] std::optional<Calibration> read_into(const ConvertRequest& request, Files& files, ConvertResult& result);

/// Returns false, with an error, if the base `into` contains poses but no cameras, and the poses of `rig` determine none of
/// these. `input`: the path of the input, for the message.
[[nodiscard]] bool base_poses_are_known(const Calibration& into, const Rig& rig, const std::string& input,
                                        ConvertResult& result);

/// True if the base is the file of --into and its text must be kept, not replaced by a fresh file.
[[nodiscard]] bool keeps_text(const ConvertRequest& request, const Base& base);

/// Ids of the models that the input's cameras may get if the text of the file of --into is kept; empty: all models. If the
/// file's model is one that only forks of the program read, or if all cameras must have one model and a camera of the file
/// stays, this is the file's model only. Otherwise these are the models that the layout of the file can hold and the format's
/// program reads.
[[nodiscard]] std::vector<std::string> models_for(const ConvertRequest& request, const Base& base, const Rig& input,
                                                  const Format& to);

/// Returns false, with an error, if the request names a model and the base cannot hold it.
[[nodiscard]] bool holds_model(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to,
                               Diagnostics& diagnostics);

/// Returns false, with an error, if a camera of the base has another image size than the camera of `rig` that replaces it, or
/// if the base has image sizes and a camera of `input` has none. Such a base also contains thresholds and image columns for its
/// size, so that its size is not changed silently. The sizes may differ if the request resizes the images, or changes the
/// images of an input that is also the base.
[[nodiscard]] bool sizes_agree(const Calibration& base, const Calibration& input, const Rig& rig, const ConvertRequest& request,
                               Diagnostics& diagnostics);

/// Returns false, with an error, if the text of the file of --into must be kept but the writer composed a fresh file. A
/// plain-text file (DSO's camera.txt) must always stay plain text.
[[nodiscard]] bool is_edit_of_base(const ConvertRequest& request, const Base& base, const Written& written,
                                   Diagnostics& diagnostics);

/// Returns the base of the conversion: the file of --into, the first of several joined files in the target's format, or the
/// only input file. Base::document is null if none of them can be edited.
[[nodiscard]] Base base_of(const ConvertRequest& request, const Calibration& input, const std::optional<Calibration>& into,
                           const Format& to);

}  // namespace fca
