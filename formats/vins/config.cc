// SPDX-License-Identifier: BSD-3-Clause
#include "config.h"

#include "camera_file.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fca::vins {

using text::Node;

namespace {

constexpr std::string_view kImu = "imu0";
constexpr std::string_view kTuning = "vins.";

std::string numbered(std::string_view before, std::size_t index, std::string_view after = "") {
  return std::string(before) + std::to_string(index) + std::string(after);
}

const Node* find(const text::Document& config, std::string_view key) { return text::find(config.root(), key, kDialect); }

class ConfigReader {
 public:
  ConfigReader(const text::Document& config, const ReadOptions& options, Diagnostics& diagnostics)
      : config_(config), reader_(config, kDialect, diagnostics), options_(options) {}

  void read_into(std::span<const text::Document> camera_files, Rig& rig) {
    if (!config_.source().bytes.starts_with("%YAML")) reader_.say(top(), Code::kYamlDirectiveMissing);
    reader_.warn_of_duplicates(config_.root());
    const std::optional<std::size_t> count = read_count();
    const std::optional<ImageSize> size = read_size();
    if (!count) return;
    read_poses(*count, rig);
    read_noise(rig);
    read_cameras(camera_files, size, rig);
    for (const text::Entry& entry : config_.root().entries) {
      if (read_.contains(entry.key.value)) continue;
      ExtraField extra = {"", std::string(kTuning) + entry.key.value, fields::value_text(entry.value)};
      if (std::ranges::find(kNoises, entry.key.value, &Noise::key) != kNoises.end()) extra.kind = Code::kVinsNoiseOfUnknownRate;
      rig.extra_fields.push_back(std::move(extra));
    }
  }

 private:
  /// The top of the file, for what it lacks.
  const Node& top() const { return config_.root().entries.front().key; }

  const Node* take(const std::string& key) {
    read_.insert(key);
    return reader_.find(config_.root(), key);
  }

  std::optional<std::size_t> read_count() {
    const Node* node = take("num_of_cam");
    if (node == nullptr) {
      reader_.say(top(), Code::kVinsCountMissing);
      return std::nullopt;
    }
    const std::optional<int> count = reader_.integer(*node, "num_of_cam");
    if (count && (*count == 1 || *count == 2)) return static_cast<std::size_t>(*count);
    if (count) reader_.say(*node, Code::kVinsCountOutOfRange, {node->value});
    return std::nullopt;
  }

  std::optional<ImageSize> read_size() {
    const Node* width = take("image_width");
    const Node* height = take("image_height");
    if (width == nullptr || height == nullptr) return std::nullopt;
    return reader_.image_size(*width, *height, "image ");
  }

  void read_poses(std::size_t count, Rig& rig) {
    const Node* estimated = find(config_, "estimate_extrinsic");
    for (std::size_t i = 0; i < count; ++i) {
      const std::string key = numbered("body_T_cam", i);
      // 2: VINS-Fusion begins cam0 from the identity whatever stands there.
      if (i == 0 && estimated != nullptr && estimated->value == "2") continue;
      const Node* node = take(key);
      if (node == nullptr) {
        reader_.say(top(), Code::kVinsPoseMissing, {key});
        continue;
      }
      const std::optional<fields::Reader::Matrix> matrix = reader_.opencv_matrix(*node, key);
      if (!matrix) continue;
      if (matrix->rows != 4 || matrix->cols != 4) {
        reader_.say(*node, Code::kVinsPoseOfOtherSize, {key});
        continue;
      }
      Transform T;
      std::ranges::copy(matrix->values, T.values.begin());
      if (const std::optional<Transform> checked = reader_.checked(T, *node, key)) {
        rig.poses.push_back({std::string(kImu), numbered("cam", i), *checked});
        rig.add_frame(kImu, FrameKind::kImu);
      }
    }
  }

  /// Densities from one sample's noise; nothing without the rate.
  void read_noise(Rig& rig) {
    if (!options_.imu_rate_hz) return;
    Imu imu;
    imu.name = kImu;
    imu.rate_hz = options_.imu_rate_hz;
    const Node* first = nullptr;
    for (const Noise& noise : kNoises) {
      const Node* node = find(config_, noise.key);
      if (node == nullptr) continue;
      const std::optional<double> of_sample = reader_.positive(*take(std::string(noise.key)), noise.key);
      if (!of_sample) continue;
      imu.*noise.density = *of_sample / std::sqrt(*imu.rate_hz);
      if (first == nullptr) first = node;
    }
    if (first == nullptr) return;
    reader_.say(*first, Code::kVinsNoiseRead, {imu.name, *imu.rate_hz});
    rig.imus.push_back(std::move(imu));
  }

  void read_cameras(std::span<const text::Document> files, const std::optional<ImageSize>& size, Rig& rig) {
    std::optional<double> offset;
    if (const Node* td = take("td")) offset = reader_.time_offset(*td, "td");
    for (std::size_t i = 0; i < camera_files_of(config_).size(); ++i) take(numbered("cam", i, "_calib"));
    for (std::size_t i = 0; i < files.size(); ++i) {
      Rig one;
      if (is_config(files[i])) {
        reader_.say(*camera_files_of(config_)[i], Code::kVinsNamesConfiguration);
        continue;
      }
      read_camera_file(files[i], options_, one, reader_.diagnostics());
      if (one.cameras.empty()) continue;
      Camera camera = one.cameras.front();
      for (ExtraField extra : one.extra_fields) {
        if (extra.owner == camera.name) extra.owner = numbered("cam", i);
        rig.extra_fields.push_back(std::move(extra));
      }
      camera.name = numbered("cam", i);
      camera.time_offset_s = offset;
      const Node* topic = take(numbered("image", i, "_topic"));
      if (topic != nullptr) camera.topic = reader_.name(*topic, camera.name + " topic");
      warn_of_size(camera, size, files[i]);
      if (size) camera.image_size = size;
      rig.cameras.push_back(std::move(camera));
    }
  }

  void warn_of_size(const Camera& camera, const std::optional<ImageSize>& size, const text::Document& file) {
    if (!size || !camera.image_size || *size == *camera.image_size) return;
    const ImageSize& other = *camera.image_size;
    reader_.say(*find(config_, "image_width"), Code::kVinsSizeContradicts,
                {size->width, size->height, other.width, other.height, file.source().name});
  }

  const text::Document& config_;
  fields::Reader reader_;
  const ReadOptions& options_;
  std::set<std::string, std::less<>> read_;  ///< Keys that were asked for.
};

}  // namespace

bool is_config(const text::Document& document) {
  return find(document, "model_type") == nullptr &&
         (find(document, "cam0_calib") != nullptr || find(document, "body_T_cam0") != nullptr);
}

std::vector<const Node*> camera_files_of(const text::Document& config) {
  std::vector<const Node*> names;
  const Node* count = find(config, "num_of_cam");
  const int used = count != nullptr ? text::parse_int(count->value).value_or(0) : 0;
  for (std::size_t i = 0; i < kMostCameras && static_cast<int>(i) < used; ++i) {
    const Node* name = find(config, numbered("cam", i, "_calib"));
    if (name == nullptr || !name->is_scalar() || name->value.empty()) break;
    names.push_back(name);
  }
  return names;
}

void read_config(const text::Document& config, std::span<const text::Document> camera_files, const ReadOptions& options,
                 Rig& rig, Diagnostics& diagnostics) {
  ConfigReader(config, options, diagnostics).read_into(camera_files, rig);
}

}  // namespace fca::vins
