// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "left_right.h"
#include "orbslam3.h"

#include "../fields.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace fca::orbslam3 {

namespace {

using text::Node;

class SettingsReader {
 public:
  SettingsReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : document_(document),
        reader_(document, text::Dialect::kOpenCv, diagnostics),
        options_(options),
        style_(style_of(document)) {}

  void read_into(Rig& rig) {
    warn_of_version();
    reader_.warn_of_duplicates(document_.root());
    const Layout* layout = read_layout();
    if (layout == nullptr) return;
    if (!read_camera(*layout, camera_prefix(style_, 0), "cam0", rig)) return;
    read_delay(rig.cameras.front());
    warn_of_missing_keys(*layout);
    warn_if_eucm_without_type(rig.cameras.front());
    read_second_camera(*layout, rig);
    read_baseline(rig);
    if (style_ == Style::kOrbSlam2 || style_ == Style::kOld) rig.rectified = read_left_right(document_);
    read_imu(rig);
    keep_unread(rig);
    reader_.warn_of_misspelt();
  }

 private:
  /// The first key, for what the file lacks.
  const Node& top() const { return document_.root().entries.front().key; }

  const Node* find(std::string_view key) {
    read_.emplace(key);
    return reader_.find(document_.root(), key);
  }
  static std::string joined(std::string_view prefix, std::string_view key) { return std::string(prefix) + std::string(key); }

  void warn_of_version() {
    const Node* version = find("File.version");
    if (version == nullptr) {
      if (style_ == Style::kV1) reader_.say(top(), Code::kOrbslam3VersionMissing);
    } else if (!version->quoted || version->value != "1.0") {
      reader_.say(*version, Code::kOrbslam3VersionNotString);
    }
  }

  /// What the file says and a Rig has no place for.
  void keep_unread(Rig& rig) const {
    for (const text::Entry& entry : document_.root().entries) {
      if (!read_.contains(entry.key.value)) rig.extra_fields.push_back({"", entry.key.value, fields::value_text(entry.value)});
    }
  }

  /// stella_vslam's settings have the keys of ORB-SLAM2's, and say which of its models the numbers are of. Only its pinhole is
  /// ORB-SLAM2's.
  bool check_stella_model() {
    const Node* model = find_key(document_, "Camera.model");
    if (model == nullptr || find_key(document_, "Camera.type") != nullptr || model->value == "perspective") return true;
    reader_.say(*model, Code::kOrbslam3ModelOfStella, {model->value});
    return false;
  }

  /// Without a type the programs read k1 k2 p1 p2 k3 of a pinhole.
  bool check_coefficients() {
    const Node* k4 = find_key(document_, "Camera.k4");
    const bool fisheye =
        k4 != nullptr && find_key(document_, "Camera.p1") == nullptr && find_key(document_, "Camera.p2") == nullptr;
    if (!fisheye || text::parse_real(k4->value) == 0.0) return true;
    reader_.say(*k4, Code::kOrbslam3FisheyeWithoutType);
    return false;
  }

  void say_unknown_type(const Node& type) {
    std::vector<std::string_view> known;
    for (const Layout& row : layouts()) {
      if (row.style == style_ && std::ranges::find(known, row.type) == known.end()) known.push_back(row.type);
    }
    std::vector<Message> further;
    for (const std::string_view name : std::span(known).subspan(1)) further.push_back({Code::kOrbslam3Further, {name}});
    const bool of_forks = std::ranges::find(layouts(), type.value, &Layout::type) != layouts().end();
    reader_.say(type, of_forks ? Code::kOrbslam3TypeOfForks : Code::kOrbslam3TypeUnknown, {type.value, known.front(), further});
  }

  const Layout* read_layout() {
    if (!check_stella_model()) return nullptr;
    const Node* type = find("Camera.type");
    const std::string name = type != nullptr ? type->value : "";
    if (type == nullptr && style_ == Style::kV1) {
      reader_.say(top(), Code::kOrbslam3TypeMissing);
      return nullptr;
    }
    if (type == nullptr && !check_coefficients()) return nullptr;
    const auto& rows = layouts();
    const bool distorted = find(joined(camera_prefix(style_, 0), "k1")) != nullptr;
    const auto found = std::ranges::find_if(rows, [&](const Layout& l) {
      return l.style == style_ && l.type == name && (distorted || style_ != Style::kV1 || l.model != "radtan");
    });
    if (found == rows.end()) {
      say_unknown_type(*type);
      return nullptr;
    }
    return &*found;
  }

  bool read_camera(const Layout& layout, std::string_view prefix, const std::string& name, Rig& rig) {
    Camera camera;
    camera.name = name;
    camera.model = *make_model(layout.model);
    bool good = true;
    for (const Slot& slot : layout.slots) {
      const std::string key = joined(prefix, slot.key);
      const Node* node = find(key);
      if (node == nullptr && slot.required) {
        reader_.say(top(), Code::kOrbslam3KeyMissing, {key});
        good = false;
      }
      if (node != nullptr && !slot.parameter && text::parse_real(node->value) != 0.0)
        rig.extra_fields.push_back({"", key, fields::value_text(*node)});
      if (node == nullptr || !slot.parameter) continue;
      good = reader_.parameter(*node, key, *slot.parameter, camera.model) && good;
    }
    camera.image_size = read_size();
    if (const Node* fps = find("Camera.fps")) {
      camera.frame_rate_hz = reader_.positive(*fps, "Camera.fps");
      good = good && camera.frame_rate_hz;
    }
    rig.cameras.push_back(std::move(camera));
    return good;
  }

  void read_delay(Camera& camera) {
    const Node* node = find(kDelayKey);
    if (node == nullptr) return;
    if (const std::optional<double> delay = reader_.time_offset(*node, std::string(kDelayKey))) camera.time_offset_s = -*delay;
  }

  std::optional<ImageSize> read_size() {
    const Node* width = find("Camera.width");
    const Node* height = find("Camera.height");
    if (width == nullptr || height == nullptr) return options_.image_size;
    return reader_.image_size(*width, *height, "Camera.");
  }

  /// What a file whose end is missing lacks, and its program demands or reads as 0: without it the camera may be another one.
  void warn_of_missing_keys(const Layout& layout) {
    std::vector<std::string> missing;
    const auto want = [&](std::string key) {
      if (find_key(document_, key) == nullptr) missing.push_back(std::move(key));
    };
    if (style_ == Style::kV1) {
      want("Camera.width");
      want("Camera.height");
    } else if (layout.model == "radtan") {
      for (const std::string_view key : {"k1", "k2", "p1", "p2"}) want(joined(camera_prefix(style_, 0), key));
    }
    if (missing.empty()) return;
    reader_.say(top(), style_ == Style::kV1 ? Code::kOrbslam3StopsWithoutKeys : Code::kOrbslam3KeysReadAsZero, {missing});
  }

  /// ORB-SLAM2's layout says nothing of the model; fisheye-ORB-SLAM reads the same keys as EUCM.
  void warn_if_eucm_without_type(const Camera& camera) {
    if (style_ != Style::kOrbSlam2 || model_info(camera.model).id != "radtan") return;
    const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
    const bool plausible_alpha_beta = value("k1") > 0.3 && value("k1") <= 1.0 && value("k2") > 0.5 && value("k2") < 3.0;
    if (!plausible_alpha_beta || value("p1") != 0.0 || value("p2") != 0.0 || value("k3") != 0.0) return;
    reader_.say(*find("Camera.k1"), Code::kOrbslam3EucmWithoutType);
  }

  void read_second_camera(const Layout& first, Rig& rig) {
    if (style_ == Style::kSlamNoOpt) {
      read_right_camera(first, rig);
      return;
    }
    // For PinHole the parser before V1.0 knows only rectified pairs: Camera.bf, and one set of intrinsics for both.
    const bool old_pair = style_ != Style::kV1 && !is_fisheye(first);
    // Rectified images have one set of intrinsics: V1.0 does not read Camera2.* there.
    if (old_pair || first.type == "Rectified" || !states_lens("Camera2.")) return;
    const Layout* layout = &first;
    if (first.model == "pinhole" && find("Camera2.k1") != nullptr) layout = find_layout(style_, "radtan");
    if (first.model == "radtan" && style_ == Style::kV1 && find("Camera2.k1") == nullptr)
      layout = find_layout(style_, "pinhole");
    if (!read_camera(*layout, "Camera2.", "cam1", rig)) return;
    const std::string key(pose_keys(style_).T_c1_c2);
    if (const Node* node = find(key)) {
      if (const std::optional<Transform> T = read_affine(*node, key)) rig.poses.push_back({"cam0", "cam1", *T});
    } else {
      warn_of_missing_pose(key);
    }
  }

  /// Is any number of a camera there? One key that is missing must not make the whole camera vanish.
  bool states_lens(std::string_view prefix) const {
    const auto& rows = layouts();
    return std::ranges::any_of(rows, [&](const Layout& layout) {
      return std::ranges::any_of(layout.slots,
                                 [&](const Slot& slot) { return find_key(document_, joined(prefix, slot.key)) != nullptr; });
    });
  }

  /// A warning at the top: there are two cameras, and not how they sit to each other.
  void warn_of_missing_pose(const std::string& key) { reader_.say(top(), Code::kOrbslam3PoseMissing, {key}); }

  /// 3 x 4 or 4 x 4.
  std::optional<Transform> read_affine(const Node& node, const std::string& key) {
    if (node.is_sequence()) return reader_.transform(node, key);
    const std::optional<fields::Reader::Matrix> matrix = reader_.opencv_matrix(node, key);
    if (!matrix) return std::nullopt;
    if (matrix->cols != 4 || (matrix->rows != 3 && matrix->rows != 4)) {
      reader_.say(node, Code::kOrbslam3PoseOfOtherSize, {key});
      return std::nullopt;
    }
    Transform T;
    std::copy_n(matrix->values.begin(), matrix->values.size(), T.values.begin());
    return reader_.checked(T, node, key);
  }

  /// slam_no_opt's second camera: RIGHT.K, RIGHT.D in the order of Camera.k1 k2 p1 p2, and p_right = CAMERA.R p_left +
  /// CAMERA.T.
  void read_right_camera(const Layout& layout, Rig& rig) {
    const Node* K = find("RIGHT.K");
    const Node* D = find("RIGHT.D");
    const auto is_of_right_camera = [](const text::Entry& entry) { return entry.key.value.starts_with("RIGHT."); };
    const auto first_of_right = std::ranges::find_if(document_.root().entries, is_of_right_camera);
    if (first_of_right == document_.root().entries.end()) return;
    for (const auto& [node, key] : {std::pair{K, "RIGHT.K"}, std::pair{D, "RIGHT.D"}}) {
      if (node == nullptr) reader_.say(first_of_right->key, Code::kOrbslam3KeyMissing, {key});
    }
    if (K == nullptr || D == nullptr) return;
    const std::optional<fields::Reader::Matrix> k = reader_.opencv_matrix(*K, "RIGHT.K");
    const std::optional<fields::Reader::Matrix> d = reader_.opencv_matrix(*D, "RIGHT.D");
    if (!k || !d) return;
    if (k->values.size() != 9 || d->values.size() < 4) {
      reader_.say(*K, Code::kOrbslam3RightLensOfOtherSize);
      return;
    }
    Camera camera = rig.cameras.front();
    camera.name = "cam1";
    // K and D row by row, as nodes, so that a bad number is told at its place.
    const Node& k_data = *reader_.find(*K, "data");
    const Node& d_data = *reader_.find(*D, "data");
    const std::array focal_and_centre = {&k_data.items[0], &k_data.items[4], &k_data.items[2], &k_data.items[5]};
    bool good = true;
    for (std::size_t i = 0; i < layout.slots.size(); ++i) {
      const Node& node = i < focal_and_centre.size() ? *focal_and_centre[i] : d_data.items[i - focal_and_centre.size()];
      const std::optional<ParameterId> id = layout.slots[i].parameter;
      if (id) good = reader_.parameter(node, i < 4 ? "RIGHT.K" : "RIGHT.D", *id, camera.model) && good;
    }
    if (!good) return;
    rig.cameras.push_back(std::move(camera));
    read_right_pose(rig);
  }

  void read_right_pose(Rig& rig) {
    const Node* R = find("CAMERA.R");
    const Node* T = find("CAMERA.T");
    if (R == nullptr || T == nullptr) {
      warn_of_missing_pose(R == nullptr ? "CAMERA.R" : "CAMERA.T");
      return;
    }
    const std::optional<fields::Reader::Matrix> rotation = reader_.opencv_matrix(*R, "CAMERA.R");
    const std::optional<fields::Reader::Matrix> translation = reader_.opencv_matrix(*T, "CAMERA.T");
    if (!rotation || !translation) return;
    if (rotation->values.size() != 9 || translation->values.size() != 3) {
      reader_.say(*R, Code::kOrbslam3RightPoseOfOtherSize);
      return;
    }
    Transform T_right_left;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        T_right_left(row, column) = rotation->values[static_cast<std::size_t>(3 * row + column)];
      }
      T_right_left(row, 3) = translation->values[static_cast<std::size_t>(row)];
    }
    if (reader_.checked(T_right_left, {*R, "CAMERA.R"}, {*T, "CAMERA.T"})) rig.poses.push_back({"cam1", "cam0", T_right_left});
  }

  /// Of a rectified pair or a depth sensor: Stereo.b, or bf / fx. With a posed second camera the poses say it.
  void read_baseline(Rig& rig) {
    if (rig.cameras.size() > 1) return;
    if (const Node* b = find("Stereo.b")) {
      rig.baseline_m = reader_.baseline(*b, "Stereo.b");
    } else if (const Node* bf = find("Camera.bf")) {
      if (const std::optional<double> fx = parameter(rig.cameras.front().model, "fx"))
        rig.baseline_m = reader_.baseline(*bf, "Camera.bf", *fx);
    }
  }

  void read_imu(Rig& rig) {
    Imu imu;
    bool any = false;
    const auto read_number = [&](const std::string& key, std::optional<double>& target) {
      if (const Node* node = find(key)) {
        target = reader_.positive(*node, key);
        any = true;
      }
    };
    read_number("IMU.NoiseGyro", imu.gyroscope_noise_density);
    read_number("IMU.NoiseAcc", imu.accelerometer_noise_density);
    read_number("IMU.GyroWalk", imu.gyroscope_random_walk);
    read_number("IMU.AccWalk", imu.accelerometer_random_walk);
    read_number("IMU.Frequency", imu.rate_hz);
    const std::string key(imu_pose_key(document_));
    // Where it has none it is asked for all the same, for warn_of_misspelt().
    if (key.empty()) static_cast<void>(find(pose_keys(style_ == Style::kOrbSlam2 ? Style::kSlamNoOpt : style_).T_imu_c1));
    if (const Node* pose = find(key)) {
      if (const std::optional<Transform> T = read_affine(*pose, key)) {
        rig.poses.push_back({"imu0", "cam0", *T});
        rig.add_frame("imu0", FrameKind::kImu);
      }
    }
    if (any) rig.imus.push_back(std::move(imu));
  }

  const text::Document& document_;
  fields::Reader reader_;
  const ReadOptions& options_;
  Style style_;
  std::set<std::string, std::less<>> read_;  ///< Keys that were asked for.
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    if (!document.root().is_mapping() || document.root().entries.empty()) {
      diagnostics.add(Code::kOrbslam3NoKeys, {}, document.source().range({0, 1}));
      return std::nullopt;
    }
    Diagnostics found;
    SettingsReader(document, options, found).read_into(rig);
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (found.has_errors()) return std::nullopt;
  }
  return rig;
}

}  // namespace fca::orbslam3
