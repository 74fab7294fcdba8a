// SPDX-License-Identifier: BSD-3-Clause
// The memory (EEPROM) of Luxonis' OAK cameras as JSON, which is only read (luxonis/depthai-core@ca7d6dea of 2026-03:
// CalibrationHandler.cpp, common/EepromData.hpp, CameraInfo.hpp, Extrinsics.hpp, CameraBoardSocket.hpp; versions 5 to 7).
//
//   cameraData                [[socket, camera], ...] in any order; socket 0 is CAM_A (colour), 1 CAM_B (left), 2 CAM_C (right)
//     cameraType              0 perspective, 1 fisheye
//     width, height           of the calibrated images; 0: not stated
//     intrinsicMatrix         3 x 3, pixels; the centre of the first pixel is (0, 0)
//     distortionCoeff         14, in OpenCV's order; of a fisheye the first four count, as cv::fisheye has them
//     extrinsics              rotationMatrix, translation, toCameraSocket (-1: none): p_to = R p_this + t
//       lengthUnit            of translations: 0 m, 1 cm (and where it is not stated), 2 mm, 3 inch, 4 foot
//       specTranslation       of the design
//   imuExtrinsics             the same of the IMU: T_cam_imu
//   stereoRectificationData, housingExtrinsics, imuCalibrationParams, boardName, ...   kept
//
// A chain of two is T_dst_to T_to_src; older versions of CalibrationHandler multiply it the other way round. Numbers are
// floats, printed as doubles. Parts that were not calibrated are all zeros, or [].
#include "depthai.h"

#include "lens.h"

#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <set>

namespace fca::depthai {

using text::Node;

namespace {

/// nlohmann's parser: of equal keys the last counts.
constexpr text::Dialect kDialect = text::Dialect::kPyYaml;
constexpr std::string_view kCameras = "cameraData";
constexpr std::string_view kImuPose = "imuExtrinsics";
constexpr int kPerspective = 0;
constexpr int kFisheye = 1;
constexpr int kMostSockets = 10;  ///< CAM_A to CAM_J
constexpr int kNoSocket = -1;

std::string name_of(int socket) { return std::string("CAM_") + static_cast<char>('A' + socket); }

/// Metres of the units by their numbers; the sixth is the user's own.
constexpr std::array kUnits = {1.0, 0.01, 0.001, 0.0254, 0.3048};
constexpr double kCentimetre = 0.01;

void collect_numbers(const Node& node, devices::Nodes& numbers) {
  if (node.is_scalar()) numbers.push_back(&node);
  for (const Node& item : node.items) collect_numbers(item, numbers);
  for (const text::Entry& entry : node.entries) collect_numbers(entry.value, numbers);
}

bool is_zero(const Node* number) { return text::parse_real(number->value) == 0.0; }

/// Is there no number but 0 in the tree?
bool is_blank(const Node& node) {
  devices::Nodes numbers;
  collect_numbers(node, numbers);
  return std::ranges::all_of(numbers, is_zero);
}

class EepromReader {
 public:
  EepromReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : document_(document), reader_(document, kDialect, diagnostics), options_(options) {}

  bool read_into(Rig& rig) {
    const Node& root = document_.root();
    reader_.warn_of_duplicates(root);
    const Node* cameras = reader_.require(root, kCameras, "the memory of a DepthAI device");
    if (cameras == nullptr) return false;
    if (!cameras->is_sequence() || cameras->items.empty()) {
      reader_.say(*cameras, Code::kTableNoCameraList, {kCameras});
      return false;
    }
    bool good = true;
    for (const Node& pair : cameras->items) good = read_pair(pair, rig) && good;
    const Node* imu = reader_.find(root, kImuPose);
    if (imu != nullptr) good = read_imu_pose(*imu, rig) && good;
    if (!good) return false;
    // The order of a hash map says nothing.
    std::ranges::sort(rig.cameras, {}, &Camera::name);
    keep_entries(root, {kCameras, kImuPose}, "", rig);
    reader_.warn_of_misspelt();
    return true;
  }

 private:
  void keep_entries(const Node& mapping, const std::set<std::string_view>& read, const std::string& owner, Rig& rig) const {
    for (const text::Entry& entry : mapping.entries) {
      const bool says_nothing = entry.value.is_scalar() ? entry.value.value.empty() : is_blank(entry.value);
      if (!says_nothing && !read.contains(entry.key.value))
        rig.extra_fields.push_back({owner, entry.key.value, fields::value_text(entry.value)});
    }
  }

  /// The number of a socket, from `lowest`; nothing with an error.
  std::optional<int> read_socket(const Node& node, const std::string& what, int lowest) {
    const std::optional<int> socket = reader_.integer(node, what);
    if (!socket || (*socket >= lowest && *socket < kMostSockets)) return socket;
    const std::vector<std::string> known = {std::to_string(lowest) + " to " + std::to_string(kMostSockets - 1)};
    reader_.say(node, Code::kTableUnknownWord, {what, node.value, known});
    return std::nullopt;
  }

  bool read_pair(const Node& pair, Rig& rig) {
    if (!pair.is_sequence() || pair.items.size() != 2 || !pair.items[1].is_mapping()) {
      reader_.say(pair, Code::kDepthaiNoPair, {std::string(kCameras)});
      return false;
    }
    const std::optional<int> socket = read_socket(pair.items[0], "the socket of a camera", 0);
    if (!socket) return false;
    const Node& map = pair.items[1];
    reader_.warn_of_duplicates(map);
    Camera camera;
    camera.name = name_of(*socket);
    if (!sockets_.insert(*socket).second) {
      reader_.say(pair.items[0], Code::kDepthaiSocketTwice, {camera.name});
      return false;
    }
    const Node* matrix = reader_.require(map, "intrinsicMatrix", camera.name);
    if (matrix == nullptr) return false;
    if (is_blank(*matrix)) {
      reader_.say(*matrix, Code::kTableNotCalibrated, {camera.name + " intrinsicMatrix"});
    } else {
      const std::optional<CameraModel> lens = read_lens(map, camera.name);
      if (!lens) return false;
      camera.model = *lens;
      if (!read_matrix(*matrix, camera) || !read_size(map, camera)) return false;
      rig.cameras.push_back(camera);
    }
    const Node* extrinsics = reader_.find(map, "extrinsics");
    if (extrinsics != nullptr && !read_camera_pose(*extrinsics, camera.name, rig)) return false;
    keep_entries(map, {"cameraType", "intrinsicMatrix", "distortionCoeff", "extrinsics", "width", "height"}, camera.name, rig);
    return true;
  }

  std::optional<CameraModel> read_lens(const Node& map, const std::string& camera) {
    const Node* type = reader_.find(map, "cameraType");  // not in version 5
    const std::optional<int> number = type != nullptr ? reader_.integer(*type, camera + " cameraType") : kPerspective;
    if (!number) return std::nullopt;
    if (*number != kPerspective && *number != kFisheye) {
      const std::vector<std::string> known = {"0 (perspective)", "1 (fisheye)"};
      reader_.say(*type, Code::kTableUnknownWord, {camera + " cameraType", type->value, known});
      return std::nullopt;
    }
    const Node* list = reader_.require(map, "distortionCoeff", camera);
    const std::string what = camera + " distortionCoeff";
    if (list == nullptr || !reader_.reals(*list, 0, what)) return std::nullopt;
    devices::Nodes coefficients;
    collect_numbers(*list, coefficients);
    const bool fisheye = *number == kFisheye;
    const bool counts = fisheye ? coefficients.size() >= kFisheyeCoefficients.size()
                                : std::ranges::find(kOpenCvCounts, coefficients.size()) != kOpenCvCounts.end();
    if (!counts) {
      std::vector<std::string> known;
      known.reserve(kOpenCvCounts.size());
      for (const std::size_t count : kOpenCvCounts) known.push_back(std::to_string(count));
      if (fisheye) known = {"4 or more"};
      reader_.say(*list, Code::kTableCoefficientCount,
                  {what, coefficients.size(), known, fisheye ? "a fisheye" : "a perspective camera"});
      return std::nullopt;
    }
    if (fisheye) return devices::fisheye_lens(coefficients, what, reader_);
    return devices::opencv_lens(coefficients, what, reader_);
  }

  bool read_matrix(const Node& node, Camera& camera) {
    const std::string what = camera.name + " intrinsicMatrix";
    if (!has_three_rows(node, what)) return false;
    constexpr std::array<ParameterId, 4> kParameters = {"fx", "cx", "fy", "cy"};
    devices::Nodes numbers;
    collect_numbers(node, numbers);
    for (const std::size_t place : {1U, 3U, 6U, 7U}) {
      if (is_zero(numbers[place])) continue;
      reader_.say(*numbers[place], Code::kOpencvMatrixNonZero, {what, text::parse_real(numbers[place]->value).value_or(0.0)});
      return false;
    }
    return devices::set_parameters(kParameters, {numbers[0], numbers[2], numbers[4], numbers[5]}, what, camera.model, reader_);
  }

  /// Three rows of three finite numbers; an error if not.
  bool has_three_rows(const Node& node, const std::string& what) {
    constexpr std::size_t kRows = 3;
    if (!node.is_sequence() || node.items.size() != kRows) {
      reader_.say(node, Code::kRowsWanted, {what, node.items.size(), kRows});
      return false;
    }
    return std::ranges::all_of(node.items, [&](const Node& row) { return reader_.reals(row, kRows, what).has_value(); });
  }

  bool read_size(const Node& map, Camera& camera) {
    const Node* width = reader_.find(map, "width");
    const Node* height = reader_.find(map, "height");
    camera.image_size = options_.image_size;
    if (width == nullptr || height == nullptr || (is_zero(width) && is_zero(height))) return true;
    camera.image_size = reader_.image_size(*width, *height, camera.name + " ");
    return camera.image_size.has_value();
  }

  std::optional<double> read_unit(const Node& map, const std::string& what) {
    const Node* node = reader_.find(map, "lengthUnit");
    if (node == nullptr) return kCentimetre;
    const std::optional<int> unit = reader_.integer(*node, what + " lengthUnit");
    if (!unit) return std::nullopt;
    if (*unit >= 0 && static_cast<std::size_t>(*unit) < kUnits.size()) return kUnits.at(static_cast<std::size_t>(*unit));
    const std::vector<std::string> known = {"0 (m)", "1 (cm)", "2 (mm)", "3 (inch)", "4 (foot)"};
    reader_.say(*node, Code::kTableUnknownWord, {what + " lengthUnit", node->value, known});
    return std::nullopt;
  }

  /// x, y, z [m]; nothing with an error.
  std::optional<std::array<double, 3>> read_translation(const Node& node, const std::string& what, double unit_m) {
    std::array<double, 3> metres{};
    constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const Node* axis = reader_.require(node, kAxes.at(i), what);
      const std::optional<double> value =
          axis != nullptr ? reader_.real(*axis, what + " " + std::string(kAxes.at(i))) : std::nullopt;
      if (!value) return std::nullopt;
      metres.at(i) = *value * unit_m;
    }
    return metres;
  }

  struct Pose {
    int socket = kNoSocket;  ///< To whose camera it takes points; kNoSocket: there is none.
    Transform T_to_this;
  };

  /// Nothing with an error.
  std::optional<Pose> read_pose(const Node& map, const std::string& what) {
    const Node* to = reader_.require(map, "toCameraSocket", what);
    const Node* rotation = reader_.require(map, "rotationMatrix", what);
    const Node* translation = reader_.require(map, "translation", what);
    if (to == nullptr || rotation == nullptr || translation == nullptr) return std::nullopt;
    const std::optional<int> socket = read_socket(*to, what + " toCameraSocket", kNoSocket);
    if (!socket) return std::nullopt;
    if (*socket == kNoSocket) return Pose{};
    if (is_blank(*rotation)) {
      reader_.say(*rotation, Code::kTableNotCalibrated, {what + " rotationMatrix"});
      return Pose{};
    }
    const std::optional<double> unit_m = read_unit(map, what);
    if (!unit_m || !has_three_rows(*rotation, what + " rotationMatrix")) return std::nullopt;
    const auto metres = read_translation(*translation, what + " translation", *unit_m);
    if (!metres) return std::nullopt;
    Pose pose{*socket, {}};
    for (int row = 0; row < 3; ++row) {
      const Node& numbers = rotation->items[static_cast<std::size_t>(row)];
      for (int column = 0; column < 3; ++column)
        pose.T_to_this(row, column) = text::parse_real(numbers.items[static_cast<std::size_t>(column)].value).value_or(0.0);
      pose.T_to_this(row, 3) = metres->at(static_cast<std::size_t>(row));
    }
    if (!reader_.checked(pose.T_to_this, {*rotation, what}, {*translation, what})) return std::nullopt;
    return pose;
  }

  void keep_design(const Node& map, const std::string& owner, const std::string& prefix, Rig& rig) const {
    const Node* design = text::find(map, "specTranslation", kDialect);
    if (design != nullptr && !is_blank(*design))
      rig.extra_fields.push_back({owner, prefix + "specTranslation", fields::value_text(*design)});
  }

  bool read_camera_pose(const Node& map, const std::string& camera, Rig& rig) {
    const std::optional<Pose> pose = read_pose(map, camera + " extrinsics");
    if (!pose) return false;
    keep_design(map, camera, "extrinsics ", rig);
    if (pose->socket != kNoSocket) rig.poses.push_back({name_of(pose->socket), camera, pose->T_to_this});
    return true;
  }

  bool read_imu_pose(const Node& map, Rig& rig) {
    const std::optional<Pose> pose = read_pose(map, std::string(kImuPose));
    if (!pose) return false;
    keep_design(map, "", std::string(kImuPose) + " ", rig);
    if (pose->socket == kNoSocket) return true;
    const Transform& T = pose->T_to_this;
    reader_.say(map, Code::kDepthaiImuDirection, {name_of(pose->socket), T(0, 3), T(1, 3), T(2, 3)});
    rig.poses.push_back({name_of(pose->socket), std::string(schema::kImu), T});
    rig.add_frame(schema::kImu, FrameKind::kImu);
    return true;
  }

  const text::Document& document_;
  fields::Reader reader_;
  const ReadOptions& options_;
  std::set<int> sockets_ = {};
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1 || !documents.front().root().is_mapping()) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  Rig rig;
  if (!EepromReader(documents.front(), options, diagnostics).read_into(rig)) return std::nullopt;
  return rig;
}

ProbeResult probe(const text::Document& document) {
  const Node* cameras = text::find(document.root(), kCameras, kDialect);
  if (cameras == nullptr || !cameras->is_sequence()) return {};
  return {evidence::kCamera, Message{Code::kFoundKey, {std::string(kCameras)}}};
}

constexpr std::string_view kProgram = "DepthAI";
constexpr std::array kModels = {
    StoredModel{"opencv14", "Perspective", true, kProgram, {}}, StoredModel{"rational", "Perspective", true, kProgram, {}},
    StoredModel{"radtan", "Perspective", true, kProgram, {}},   StoredModel{"pinhole", "Perspective", true, kProgram, {}},
    StoredModel{"kb4", "Fisheye", true, kProgram, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"design, rectification and housing, names of the board"}};

}  // namespace

const Format kFormat = {
    .id = "depthai",
    .title = "DepthAI device memory",
    .group = FormatGroup::kDevices,
    .syntaxes = "JSON",
    .extension = ".json",
    .program = kProgram,
    .main_file = "calib.json",
    .many_cameras = true,
    .extrinsics = true,
    .imu = false,
    .imu_pose = true,
    .image_size = true,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::depthai
