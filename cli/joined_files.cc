// SPDX-License-Identifier: BSD-3-Clause
#include "joined_files.h"

#include <algorithm>
#include <vector>

namespace fca::cli {

namespace {

/// An input with what it holds.
struct Part {
  const text::Document* document = nullptr;
  Rig rig;
};

/// The inputs with one camera each, or nothing if that is not what they are.
std::vector<Part> parts_of(const Calibration& source) {
  std::vector<Part> parts;
  for (const text::Document& document : source.documents) {
    Diagnostics said_before;
    const std::optional<Rig> rig = source.format->read(std::span(&document, 1), {}, said_before);
    if (!rig || rig->cameras.size() != 1) return {};
    parts.push_back({&document, *rig});
  }
  return parts;
}

/// The part that states the camera. Joined rigs rename cameras of one name, so the numbers tell.
std::vector<Part>::iterator part_with(std::vector<Part>& parts, const Camera& camera) {
  return std::ranges::find_if(parts, [&camera](const Part& part) {
    const Camera& own = part.rig.cameras.front();
    return own.model == camera.model && own.image_size == camera.image_size;
  });
}

/// What the rig says of one camera, under the name that its file gives it.
Rig alone(const Rig& rig, const Camera& camera, const Part& part) {
  const std::string& name = part.rig.cameras.front().name;
  Rig result = part.rig;
  result.cameras = {camera};
  result.cameras.front().name = name;
  result.poses.clear();
  for (PoseEdge edge : rig.poses) {
    if (edge.a != camera.name && edge.b != camera.name) continue;
    (edge.a == camera.name ? edge.a : edge.b) = name;
    result.poses.push_back(std::move(edge));
  }
  return result;
}

void append(Written part, const std::string& camera, Written& all) {
  for (Written::File& file : part.files) {
    if (!file.cameras.empty()) file.cameras = {camera};
    all.files.push_back(std::move(file));
  }
  if (all.headline.empty()) all.headline = std::move(part.headline);
  all.losses.insert(all.losses.end(), part.losses.begin(), part.losses.end());
  all.defaults.insert(all.defaults.end(), part.defaults.begin(), part.defaults.end());
  for (PoseEdge& edge : part.restated) all.restated.push_back(std::move(edge));
}

}  // namespace

std::optional<Written> write_each_into_its_own(const Calibration& source, const Rig& rig, const Format& format,
                                               const WriteOptions& options, Diagnostics& diagnostics) {
  if (format.many_cameras || source.format != &format || !source.one_format) return std::nullopt;
  std::vector<Part> parts = parts_of(source);
  Written all;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const auto part = part_with(parts, source.rig.cameras[i]);
    if (part == parts.end()) return std::nullopt;
    std::optional<Written> written =
        write_calibration(format, part->document, alone(rig, rig.cameras[i], *part), options, diagnostics);
    if (!written) return std::nullopt;
    append(*std::move(written), rig.cameras[i].name, all);
    parts.erase(part);
  }
  return all;
}

}  // namespace fca::cli
