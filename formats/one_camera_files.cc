// SPDX-License-Identifier: BSD-3-Clause
#include "one_camera_files.h"

#include "losses.h"

#include <fca/code.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <iterator>

namespace fca {

bool writable_alone(const Format& format, const Rig& rig, const Message& size_use, Diagnostics& diagnostics) {
  if (rig.cameras.empty()) {
    diagnostics.add(Code::kFormatNeedsCamera, {format.title});
    return false;
  }
  bool good = can_store(format, rig, nullptr, diagnostics);
  for (const Camera& camera : rig.cameras) {
    const auto problems = validate(camera.model);
    for (const auto& problem : problems) diagnostics.add(Code::kNotACamera, {camera.name, problem});
    if (!camera.image_size) diagnostics.add(Code::kFormatNeedsSize, {camera.name, size_use});
    good = good && problems.empty() && camera.image_size;
  }
  return good;
}

std::optional<text::Document> fresh_file(const Format& format, const Camera& camera, text::Source source,
                                         Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<text::Document> document = text::parse_document(std::move(source), found);
  if (document && format.read(std::span(&*document, 1), {}, found)) return document;
  for (const Diagnostic& entry : found.entries()) {
    if (entry.severity != Severity::kError) continue;
    diagnostics.add({.severity = Severity::kError,
                     .facts = {Code::kNotWrittenBecause, {camera.name, entry.facts}},
                     .remedy = entry.facts,
                     .kind = entry.facts.code});
  }
  return std::nullopt;
}

bool is_camera_of(const std::optional<Rig>& there, const Rig& rig, const Camera& camera) {
  return there && (rig.cameras.size() == 1 || camera.name == there->cameras.front().name);
}

void list_camera_losses(const Rig& rig, std::string_view program, std::vector<Loss>& losses) {
  const Message no_place{Code::kFilesHaveNoPlace, {program}};
  for (const Camera& camera : rig.cameras) add_stream(camera, no_place, losses);
  for (const Imu& imu : rig.imus) losses.push_back(lost(Code::kImuDropped, imu.name, "", {no_place}));
  if (rig.baseline_m) losses.push_back(lost(Code::kBaselineDropped, "", "baseline", {no_place, *rig.baseline_m}));
}

}  // namespace fca
