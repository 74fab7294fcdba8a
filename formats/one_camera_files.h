// SPDX-License-Identifier: BSD-3-Clause
// What writers of formats share that hold one camera per file and little else (OCamCalib, WoodScape).
#pragma once

#include <fca/formats/format.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// Can every camera be written? An error for each that cannot: no size (`size_use`: what such a file wants it for, a clause:
/// "Basalt demands a resolution"), a model or parameters that the format does not hold; and one if there is no camera at all.
[[nodiscard]] bool writable_alone(const Format& format, const Rig& rig, const Message& size_use, Diagnostics& diagnostics);

/// A fresh file, parsed. Nothing where the format itself would not read it, with its errors: what nobody reads is not written.
[[nodiscard]] std::optional<text::Document> fresh_file(const Format& format, const Camera& camera, text::Source source,
                                                       Diagnostics& diagnostics);

/// Is it the camera of `there`, the file to be edited? A rig of one camera goes there whatever its name.
[[nodiscard]] bool is_camera_of(const std::optional<Rig>& there, const Rig& rig, const Camera& camera);

/// What of `rig` such a file has no place for: time offsets, topics, frame rates, IMUs, the baseline. `program`: who reads the
/// file, for people.
void list_camera_losses(const Rig& rig, std::string_view program, std::vector<Loss>& losses);

}  // namespace fca
