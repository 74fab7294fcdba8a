// SPDX-License-Identifier: BSD-3-Clause
#include <fca/toolkit/inputs.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace fca {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// The number after the prefix: 1 for "cam1". nullopt if the name is not the prefix and a number.
std::optional<int> number_in(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, failure] = std::from_chars(name.data() + prefix.size(), end, number);
  return failure == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// The file of a sensor. If its folder contains a recalibrated file, it is that one, as in cuVSLAM's example. nullopt if there
/// is none.
std::optional<fs::path> sensor_file_in(const fs::path& folder) {
  for (const std::string_view name : {"sensor_recalibrated.yaml", "sensor.yaml"}) {
    if (is_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

/// Adds the files of the sensors in a folder, in the order of their numbers: cam0/sensor.yaml, cam1/sensor.yaml, ...
void add_sensors(const fs::path& folder, std::string_view prefix, std::vector<std::string>& files) {
  std::vector<std::pair<int, std::string>> found;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    const std::optional<int> number = number_in(at->path().filename().string(), prefix);
    const std::optional<fs::path> file = number ? sensor_file_in(at->path()) : std::nullopt;
    if (file) found.emplace_back(*number, file->string());
  }
  std::ranges::sort(found);
  for (auto& [number, file] : found) files.push_back(std::move(file));
}

/// True if the folder contains a file of a COLMAP model, e.g. `name` "cameras" with the extension ".bin".
bool has_model_file(const fs::path& folder, std::string_view name, const std::string& extension) {
  return is_file(folder / (std::string(name) + extension));
}

/// True if the folder contains all files of a COLMAP model with that extension.
bool is_whole_model(const fs::path& folder, const std::string& extension) {
  constexpr std::array<std::string_view, 3> kModelFiles = {"cameras", "images", "points3D"};
  return std::ranges::all_of(kModelFiles, [&](std::string_view name) { return has_model_file(folder, name, extension); });
}

}  // namespace

std::vector<std::string> rig_files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code ignored;
  if (folder.empty() || !fs::is_directory(folder, ignored)) return files;
  for (const fs::path& place : {fs::path(folder) / "mav0", fs::path(folder)}) {
    add_sensors(place, "cam", files);
    if (files.empty()) continue;
    add_sensors(place, "imu", files);
    return files;
  }
  constexpr std::array<std::string_view, 3> kKimeraFiles = {"LeftCameraParams.yaml", "RightCameraParams.yaml",
                                                            "ImuParams.yaml"};
  for (const std::string_view name : kKimeraFiles) {
    if (const fs::path file = fs::path(folder) / name; is_file(file)) files.push_back(file.string());
  }
  // A folder with a file of an IMU, but without cameras, is not a rig.
  const bool has_camera = !files.empty() && !files.front().ends_with(kKimeraFiles.back());
  return has_camera ? files : std::vector<std::string>();
}

/// Every EuRoC data set keeps its files in a folder "mav0", so that only the folder above it has a distinctive name.
std::string rig_name(const std::string& path) {
  if (rig_files_in(path).empty()) return path;
  const fs::path folder = fs::path(path + "/").lexically_normal().parent_path();  // without a slash at the end
  const bool has_parent = folder.filename() == "mav0" && folder.has_parent_path();
  return (has_parent ? folder.parent_path() : folder).string();
}

std::optional<std::string> cameras_file_in(const std::string& folder) {
  std::error_code ignored;
  if (folder.empty() || !fs::is_directory(folder, ignored)) return std::nullopt;
  // COLMAP only opens folders with all files of a model. If both the binary and the text files are complete, it reads the
  // binary ones (colmap@5d968cf, scene/reconstruction.cc, Read).
  const bool is_text = !is_whole_model(folder, ".bin") && is_whole_model(folder, ".txt");
  std::string kind = is_text ? ".txt" : ".bin";
  if (!has_model_file(folder, "cameras", kind)) kind = ".txt";
  return has_model_file(folder, "cameras", kind) ? std::optional((fs::path(folder) / ("cameras" + kind)).string())
                                                 : std::nullopt;
}

std::vector<std::string> model_files_in(const std::string& folder) {
  const std::optional<std::string> cameras = cameras_file_in(folder);
  if (!cameras) return {};
  const std::string kind = fs::path(*cameras).extension().string();
  const auto has = [&](std::string_view name) { return has_model_file(folder, name, kind); };
  if (!has("images") && !has("points3D") && !has("rigs")) return {};
  std::vector<std::string> files = {*cameras};
  if (has("rigs")) files.push_back((fs::path(folder) / ("rigs" + kind)).string());
  return files;
}

}  // namespace fca
