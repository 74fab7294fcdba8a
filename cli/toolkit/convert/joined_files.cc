// SPDX-License-Identifier: BSD-3-Clause
#include "joined_files.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace fca {

namespace {

/// An input file of the format to be written, and the rig that it holds by itself.
struct Part {
  const text::Document* document = nullptr;
  Rig rig;
};

/// The input files of the format that contain exactly one camera. If files of the format may hold several cameras, only its
/// plain-text files are returned (TUM-VI's camera.txt), which always hold one.
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

/// Returns the file that the camera comes from, or parts.end() if there is none. Joining files may have renamed the camera, so
/// that its model and image size are compared, not its name. If several files have an equal camera, returns the first file.
std::vector<Part>::iterator file_of(std::vector<Part>& parts, const Camera& camera) {
  return std::ranges::find_if(parts, [&camera](const Part& part) {
    const Camera& in_file = part.rig.cameras.front();
    return in_file.model == camera.model && in_file.image_size == camera.image_size;
  });
}

/// The extra fields of the file. The owner of those that belong to its camera is the camera's name in the joined rig.
std::vector<ExtraField> extras_of(const Part& part, const Camera& camera) {
  std::vector<ExtraField> extras = part.rig.extra_fields;
  const std::string& name_in_file = part.rig.cameras.front().name;
  for (ExtraField& extra : extras) {
    if (extra.owner == name_in_file) extra.owner = camera.name;
  }
  return extras;
}

/// Removes the camera, its poses and the extra fields of its file from the rig.
void remove_camera(const Part& part, const Camera& camera, Rig& rig) {
  for (const ExtraField& extra : extras_of(part, camera)) {
    const auto found = std::ranges::find(rig.extra_fields, extra);
    if (found != rig.extra_fields.end()) rig.extra_fields.erase(found);
  }
  std::erase_if(rig.poses, [&camera](const PoseEdge& edge) { return edge.a == camera.name || edge.b == camera.name; });
  std::erase_if(rig.cameras, [&camera](const Camera& other) { return other.name == camera.name; });
}

/// The rig to write into the camera's file: this camera alone, under its name in that file, with its poses from `rig`.
Rig rig_of_camera(const Rig& rig, const Camera& camera, const Part& part) {
  const std::string& name = part.rig.cameras.front().name;
  Rig result = part.rig;
  result.cameras = {camera};
  result.cameras.front().name = name;
  result.poses.clear();
  for (PoseEdge edge : rig.poses) {
    if (edge.a != camera.name && edge.b != camera.name) continue;
    std::string& end = edge.a == camera.name ? edge.a : edge.b;
    end = name;
    result.poses.push_back(std::move(edge));
  }
  for (const Frame& frame : rig.frames) result.add_frame(frame.name, frame.kind);
  return result;
}

/// Adds the files, losses, defaults and restated poses of one file to those of all.
void append(Written part, Written& all) {
  for (Written::File& file : part.files) all.files.push_back(std::move(file));
  if (!all.headline.is_said()) all.headline = std::move(part.headline);
  all.losses.insert(all.losses.end(), part.losses.begin(), part.losses.end());
  all.defaults.insert(all.defaults.end(), part.defaults.begin(), part.defaults.end());
  for (PoseEdge& edge : part.restated) all.restated.push_back(std::move(edge));
}

/// The input files of the format that contain an IMU and no camera. Empty if the format has no such files.
std::vector<Part> imu_parts_of(const Calibration& source, const Format& format) {
  std::vector<Part> parts;
  if (!format.imu_file) return parts;
  for (std::size_t i = 0; i < source.documents.size(); ++i) {
    if (source.formats[i] != &format) continue;
    const std::optional<Rig> rig = rig_alone(source, i);
    if (rig && rig->cameras.empty() && !rig->imus.empty()) parts.push_back({&source.documents[i], *rig});
  }
  return parts;
}

/// Removes the IMUs of a file and its extra fields from the rig. If a camera's time offset comes from the IMU file (through
/// format.complete), removes it from the camera, since it stays in the IMU file.
void remove_imus(const Part& part, const Format& format, std::vector<std::pair<Camera, Part>>& cameras, Rig& rig) {
  for (const ExtraField& extra : part.rig.extra_fields) {
    const auto found = std::ranges::find(rig.extra_fields, extra);
    if (found != rig.extra_fields.end()) rig.extra_fields.erase(found);
  }
  std::erase_if(rig.imus, [&part](const Imu& imu) { return std::ranges::count(part.rig.imus, imu.name, &Imu::name) > 0; });
  for (auto& [camera, camera_file] : cameras) {
    Rig with_camera = part.rig;
    with_camera.cameras = camera_file.rig.cameras;
    if (format.complete != nullptr) format.complete(with_camera);
    if (camera.time_offset_s == with_camera.cameras.front().time_offset_s) camera.time_offset_s.reset();
  }
}

/// The rig to write into an IMU file: the rig that it contains, with the values that its IMUs and poses have in `rig`.
Rig rig_of_imus(const Part& part, const Rig& rig) {
  Rig result = part.rig;
  for (Imu& imu : result.imus) {
    const auto found = std::ranges::find(rig.imus, imu.name, &Imu::name);
    if (found != rig.imus.end()) imu = *found;
  }
  for (PoseEdge& edge : result.poses) {
    if (const Transform* T_a_b = rig.stated(edge.a, edge.b)) edge.T_a_b = *T_a_b;
  }
  return result;
}

/// Clears the place of files that have the same place in their program's folder.
void clear_shared_places(std::vector<Written::File>& files) {
  std::vector<std::string> places;
  places.reserve(files.size());
  for (const Written::File& file : files) places.push_back(file.place);
  for (Written::File& file : files) {
    if (std::ranges::count(places, file.place) > 1) file.place.clear();
  }
}

/// Sorts the files by their first camera's position in the rig; files without cameras come last.
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
  std::vector<std::pair<Camera, Part>> cameras;  // each camera with the file that it comes from
  Rig rest = rig;                                // what no input file of the format contains
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const auto part = file_of(parts, source.rig.cameras[i]);
    if (part == parts.end() && source.one_format) return std::nullopt;
    if (part == parts.end()) continue;
    remove_camera(*part, rig.cameras[i], rest);
    cameras.emplace_back(rig.cameras[i], std::move(*part));
    parts.erase(part);
  }
  if (cameras.empty()) return std::nullopt;
  const std::vector<Part> imus = imu_parts_of(source, format);
  for (const Part& part : imus) remove_imus(part, format, cameras, rest);
  Written all;
  for (const auto& [camera, part] : cameras) {
    Rig camera_rig = rig_of_camera(rig, camera, part);
    // If every camera has a file, the first file gets what belongs to no camera, for example an IMU from a file of another
    // format.
    if (rest.cameras.empty()) {
      camera_rig.imus = std::exchange(rest.imus, {});
      camera_rig.extra_fields.insert(camera_rig.extra_fields.end(), rest.extra_fields.begin(), rest.extra_fields.end());
      rest.extra_fields.clear();
    }
    std::optional<Written> written = write_calibration(format, part.document, camera_rig, options, diagnostics);
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
    std::optional<Written> written = write_calibration(format, part.document, rig_of_imus(part, rig), options, diagnostics);
    if (!written) return std::nullopt;
    append(*std::move(written), all);
  }
  sort_files(rig, all.files);
  clear_shared_places(all.files);
  return all;
}

}  // namespace fca
