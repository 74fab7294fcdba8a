// SPDX-License-Identifier: BSD-3-Clause
#include "joined_files.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace fca {

namespace {

/// An input of the format to be written, with what it holds.
struct Part {
  const text::Document* document = nullptr;
  Rig rig;
};

/// The inputs of that format with one camera each. Of one whose files hold several, those of bare words (DSO's camera.txt).
std::vector<Part> parts_of(const Calibration& source, const Format& format) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < source.documents.size(); ++i) {
    const text::Document& document = source.documents[i];
    if (source.formats[i] != &format) continue;
    if (format.many_cameras && document.syntax() != text::Syntax::kWords) continue;
    const std::optional<Rig> rig = rig_alone(source, i);
    if (rig && rig->cameras.size() == 1) parts.push_back({&document, *rig});
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

/// What is read beside the camera, under its name in the joined rig.
std::vector<ExtraField> extras_of(const Part& part, const Camera& camera) {
  std::vector<ExtraField> extras = part.rig.extra_fields;
  const std::string& own = part.rig.cameras.front().name;
  for (ExtraField& extra : extras) {
    if (extra.owner == own) extra.owner = camera.name;
  }
  return extras;
}

/// Takes a camera that its own file says, and what else that says, out of the rig.
void take_out(const Part& part, const Camera& camera, Rig& rig) {
  for (const ExtraField& extra : extras_of(part, camera)) {
    const auto found = std::ranges::find(rig.extra_fields, extra);
    if (found != rig.extra_fields.end()) rig.extra_fields.erase(found);
  }
  std::erase_if(rig.poses, [&camera](const PoseEdge& edge) { return edge.a == camera.name || edge.b == camera.name; });
  std::erase_if(rig.cameras, [&camera](const Camera& other) { return other.name == camera.name; });
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
  for (const Frame& frame : rig.frames) result.add_frame(frame.name, frame.kind);
  return result;
}

void append(Written part, Written& all) {
  for (Written::File& file : part.files) all.files.push_back(std::move(file));
  if (!all.headline.is_said()) all.headline = std::move(part.headline);
  all.losses.insert(all.losses.end(), part.losses.begin(), part.losses.end());
  all.defaults.insert(all.defaults.end(), part.defaults.begin(), part.defaults.end());
  for (PoseEdge& edge : part.restated) all.restated.push_back(std::move(edge));
}

/// The inputs of that format with an IMU and no camera, where it has such files.
std::vector<Part> imu_parts_of(const Calibration& source, const Format& format) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < source.documents.size() && format.imu_file; ++i) {
    if (source.formats[i] != &format) continue;
    const std::optional<Rig> rig = rig_alone(source, i);
    if (rig && rig->cameras.empty() && !rig->imus.empty()) parts.push_back({&source.documents[i], *rig});
  }
  return parts;
}

/// Takes what an IMU's own file says out of the rig, also of its cameras' clocks.
void take_out(const Part& part, const Format& format, std::vector<std::pair<Camera, Part>>& cameras, Rig& rig) {
  for (const ExtraField& extra : part.rig.extra_fields) {
    const auto found = std::ranges::find(rig.extra_fields, extra);
    if (found != rig.extra_fields.end()) rig.extra_fields.erase(found);
  }
  std::erase_if(rig.imus, [&part](const Imu& imu) { return std::ranges::count(part.rig.imus, imu.name, &Imu::name) > 0; });
  for (auto& [camera, own] : cameras) {
    Rig with_camera = part.rig;
    with_camera.cameras = own.rig.cameras;
    if (format.complete != nullptr) format.complete(with_camera);
    if (camera.time_offset_s == with_camera.cameras.front().time_offset_s) camera.time_offset_s.reset();
  }
}

/// What the rig says of the IMUs of a file.
Rig of_imus(const Part& part, const Rig& rig) {
  Rig result = part.rig;
  for (Imu& imu : result.imus) {
    const auto now = std::ranges::find(rig.imus, imu.name, &Imu::name);
    if (now != rig.imus.end()) imu = *now;
  }
  for (PoseEdge& edge : result.poses) {
    if (const Transform* now = rig.stated(edge.a, edge.b)) edge.T_a_b = *now;
  }
  return result;
}

/// Files of which two would have one place have none.
void forget_shared_places(std::vector<Written::File>& files) {
  std::vector<std::string> places;
  places.reserve(files.size());
  for (const Written::File& file : files) places.push_back(file.place);
  for (Written::File& file : files) {
    if (std::ranges::count(places, file.place) > 1) file.place.clear();
  }
}

/// Files in the order of the rig's cameras.
void sort_files(const Rig& rig, std::vector<Written::File>& files) {
  std::ranges::stable_sort(files, {}, [&rig](const Written::File& file) {
    return file.cameras.empty() ? rig.cameras.end() : std::ranges::find(rig.cameras, file.cameras.front(), &Camera::name);
  });
}

}  // namespace

std::optional<Written> write_each_into_its_own(const Calibration& source, const Rig& rig, const Format& format,
                                               const WriteOptions& options, Diagnostics& diagnostics) {
  if (format.many_cameras && options.extension != ".txt") return std::nullopt;
  std::vector<Part> parts = parts_of(source, format);
  std::vector<std::pair<Camera, Part>> own;
  Rig rest = rig;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const auto part = part_with(parts, source.rig.cameras[i]);
    if (part == parts.end() && source.one_format) return std::nullopt;
    if (part == parts.end()) continue;
    take_out(*part, rig.cameras[i], rest);
    own.emplace_back(rig.cameras[i], std::move(*part));
    parts.erase(part);
  }
  if (own.empty()) return std::nullopt;
  const std::vector<Part> imus = imu_parts_of(source, format);
  for (const Part& part : imus) take_out(part, format, own, rest);
  Written all;
  for (const auto& [camera, part] : own) {
    Rig said = alone(rig, camera, part);
    // What belongs to no camera (an IMU of a further file) is listed once.
    if (rest.cameras.empty()) {
      said.imus = std::exchange(rest.imus, {});
      said.extra_fields.insert(said.extra_fields.end(), rest.extra_fields.begin(), rest.extra_fields.end());
      rest.extra_fields.clear();
    }
    std::optional<Written> written = write_calibration(format, part.document, said, options, diagnostics);
    if (!written) return std::nullopt;
    for (Written::File& file : written->files) {
      if (!file.cameras.empty()) file.cameras = {camera.name};
    }
    append(*std::move(written), all);
  }
  if (!rest.cameras.empty()) {
    std::optional<Written> written = write_calibration(format, nullptr, rest, options, diagnostics);
    if (!written) return std::nullopt;
    append(*std::move(written), all);
  }
  for (const Part& part : imus) {
    std::optional<Written> written = write_calibration(format, part.document, of_imus(part, rig), options, diagnostics);
    if (!written) return std::nullopt;
    append(*std::move(written), all);
  }
  sort_files(rig, all.files);
  forget_shared_places(all.files);
  return all;
}

}  // namespace fca
