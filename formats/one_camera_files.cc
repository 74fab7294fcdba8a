// SPDX-License-Identifier: BSD-3-Clause
#include "one_camera_files.h"

#include "losses.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <iterator>

namespace fca {

bool writable_alone(const Format& format, const Rig& rig, std::string_view size_use, Diagnostics& diagnostics) {
  if (rig.cameras.empty()) {
    diagnostics.error("no-camera", "a " + std::string(format.title) + " needs a camera and the input has none");
    return false;
  }
  bool good = can_store(format, rig, nullptr, diagnostics);
  for (const Camera& camera : rig.cameras) {
    const std::vector<Message> problems = validate(camera.model);
    for (const Message& problem : problems) diagnostics.add(Code::kNotACamera, {camera.name, problem});
    if (!camera.image_size) {
      diagnostics.error("image-size-missing", camera.name + ": " + std::string(size_use) + " and the input has no size", {},
                        "give it: --size WIDTHxHEIGHT");
    }
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
    if (entry.severity == Severity::kError)
      diagnostics.error(id_of(entry), camera.name + " cannot be written: " + message_of(entry), {}, fix_of(entry));
  }
  return std::nullopt;
}

bool is_camera_of(const std::optional<Rig>& there, const Rig& rig, const Camera& camera) {
  return there && (rig.cameras.size() == 1 || camera.name == there->cameras.front().name);
}

void list_camera_losses(const Rig& rig, std::string_view program, std::vector<Loss>& losses) {
  const std::string no_place = "files of " + std::string(program) + " have no place for it";
  for (const Camera& camera : rig.cameras) add_stream(camera, no_place, losses);
  for (const Imu& imu : rig.imus) losses.push_back({"imu-dropped", imu.name + " noise and rate", no_place, ""});
  if (rig.baseline_m) {
    losses.push_back({"baseline-dropped", "baseline " + text::format_short(*rig.baseline_m) + " m", no_place, ""});
  }
}

}  // namespace fca
