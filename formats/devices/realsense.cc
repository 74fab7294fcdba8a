// SPDX-License-Identifier: BSD-3-Clause
// The calibration of a RealSense camera as its tools print it (realsense_text.h), which is only read
// (IntelRealSense/librealsense: src/rs.cpp, include/librealsense2/rsutil.h, h/rs_types.h, src/ds/d400/d400-private.cpp).
//
//   Intrinsic of a stream   px, for each size of its images; the centre of the first pixel is (0, 0), as librealsense's ROS
//                           driver has it. Coeffs: k1 k2 p1 p2 k3; of Kannala Brandt4 k1 to k4; of Ftheta the angle of the FOV
//                           model
//   Extrinsic from A to B   p_B = R p_A + t [m]; the gyroscope is the IMU
//   Motion Intrinsic        scale and bias, and variances: kept
//
// Inverse Brown Conrady is computed from ray to pixel as Brown Conrady is (rs2_project_point_to_pixel), up to the place at
// which the tangential terms are taken; D400's colour cameras say it, mostly with zeros. Blocks to Infrared 2 repeat those to
// Infrared 1 in real files, 5 cm off.
#include "realsense.h"

#include "lens.h"
#include "realsense_text.h"

#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/pose_loops.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <utility>

namespace fca::realsense {

using text::Node;

namespace {

enum class Lens { kBrown, kDoubtful, kFisheye, kFov, kNone };

/// librealsense's name for a lens, and its number (rs2_distortion).
struct Distortion {
  std::string_view name;
  std::string_view number;
  Lens lens;
};
constexpr std::array kDistortions = {Distortion{"None", "0", Lens::kNone},
                                     Distortion{"Modified Brown Conrady", "1", Lens::kDoubtful},
                                     Distortion{"Inverse Brown Conrady", "2", Lens::kDoubtful},
                                     Distortion{"Ftheta", "3", Lens::kFov},
                                     Distortion{"F-Theta", "3", Lens::kFov},
                                     Distortion{"Brown Conrady", "4", Lens::kBrown},
                                     Distortion{"Kannala Brandt4", "5", Lens::kFisheye}};

struct Number {
  const char* key;
  ParameterId id;
};
constexpr std::array kParameters = {Number{"Fx", "fx"}, Number{"Fy", "fy"}, Number{"PPX", "cx"}, Number{"PPY", "cy"}};

constexpr std::string_view kDepth = "Depth";
constexpr std::string_view kInfrared1 = "Infrared_1";
constexpr std::string_view kInfrared2 = "Infrared_2";
constexpr std::string_view kGyroscope = "Gyro";
constexpr std::string_view kAccelerometer = "Accel";

std::string camera_name(std::string stream) {
  std::ranges::replace(stream, ' ', '_');
  return text::printable(stream);
}

devices::Nodes pointers(const std::vector<Node>& nodes) {
  devices::Nodes result;
  for (const Node& node : nodes) result.push_back(&node);
  return result;
}

class PrintReader {
 public:
  PrintReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : reader_(document, text::Dialect::kPyYaml, diagnostics), options_(options), blocks_(blocks_of(document)) {}

  bool read_into(Rig& rig) {
    for (const Block& block : blocks_) {
      if (block.twice == nullptr) continue;
      reader_.say(Severity::kError, *block.twice, Code::kKeyTwice, {"of the block of " + block.name});
      return false;
    }
    const std::vector<devices::Sizes> streams = streams_of_blocks();
    if (std::ranges::any_of(streams, [](const devices::Sizes& stream) { return stream.sizes.empty(); })) return false;
    if (streams.empty()) {
      reader_.say(reader_.document().root(), Code::kKeyMissing, {"the file", "Intrinsic of a stream"});
      return false;
    }
    const auto chosen = devices::chosen_sizes(streams, options_.image_size, reader_);
    if (!chosen) return false;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (chosen->at(i) && !read_camera(streams[i].camera, *chosen->at(i), rig)) return false;
    }
    keep_motion(rig);
    if (!read_poses(rig)) return false;
    remove_depth(rig);
    // The stereo pair comes first.
    std::stable_partition(rig.cameras.begin(), rig.cameras.end(),
                          [](const Camera& camera) { return camera.name.starts_with("Infrared"); });
    return true;
  }

 private:
  /// Images of depth are computed from those of Infrared 1.
  void remove_depth(Rig& rig) {
    const Camera* depth = rig.find_camera(kDepth);
    const Camera* infrared = rig.find_camera(kInfrared1);
    if (depth == nullptr || infrared == nullptr) return;
    const bool is_one_lens = depth->model == infrared->model && depth->image_size == infrared->image_size &&
                             rig.resolve(kDepth, kInfrared1) == Transform{};
    if (!is_one_lens) return;
    // Where another camera sits to it counts if nothing says where that sits to Infrared 1.
    const std::vector<PoseEdge> poses = std::exchange(rig.poses, {});
    const auto is_of_depth = [](const PoseEdge& edge) { return edge.a == kDepth || edge.b == kDepth; };
    std::ranges::copy_if(poses, std::back_inserter(rig.poses), std::not_fn(is_of_depth));
    for (PoseEdge edge : poses) {
      if (!is_of_depth(edge)) continue;
      (edge.a == kDepth ? edge.a : edge.b) = kInfrared1;
      if (edge.a != edge.b && !rig.resolve(edge.a, edge.b)) rig.poses.push_back(edge);
    }
    std::erase_if(rig.cameras, [](const Camera& camera) { return camera.name == kDepth; });
    const auto block = std::ranges::find_if(
        blocks_, [](const Block& each) { return each.kind == Block::Kind::kStream && camera_name(each.name) == kDepth; });
    if (block != blocks_.end()) reader_.say(*block->place, Code::kRealsenseDepthIsInfrared, {kDepth, kInfrared1});
  }

  /// Those of which a size cannot be read have none.
  std::vector<devices::Sizes> streams_of_blocks() {
    std::vector<devices::Sizes> streams;
    for (const Block& block : blocks_) {
      if (block.kind != Block::Kind::kStream) continue;
      const std::string name = camera_name(block.name);
      auto stream = std::ranges::find(streams, name, &devices::Sizes::camera);
      if (stream == streams.end()) stream = streams.insert(streams.end(), {name, {}, block.place});
      const std::optional<ImageSize> size = read_size(block);
      if (!size) {
        stream->sizes.clear();
        return streams;
      }
      stream->sizes.push_back(*size);
    }
    return streams;
  }

  std::optional<ImageSize> read_size(const Block& block) {
    const std::vector<Node>* width = require(block, "Width", 1);
    const std::vector<Node>* height = require(block, "Height", 1);
    if (width == nullptr || height == nullptr) return std::nullopt;
    return reader_.image_size(width->front(), height->front(), block.name + " ");
  }

  /// Null with an error where the block does not specify so many.
  const std::vector<Node>* require(const Block& block, const std::string& key, std::size_t count) {
    const std::vector<Node>* values = block.find(key);
    if (values == nullptr) {
      reader_.say(*block.place, Code::kKeyMissing, {"the block of " + block.name, key});
    } else if (values->size() < count || (count > 1 && values->size() > count)) {
      reader_.say(*block.place, Code::kNumbersWanted, {block.name + " " + key, values->size(), count});
      return nullptr;
    }
    return values;
  }

  /// "Inverse Brown Conrady", or 2.
  static std::string distortion_of(const Block& block) {
    std::string words;
    for (const Node& word : *block.find("Distortion")) words += (words.empty() ? "" : " ") + word.value;
    return words;
  }

  std::optional<CameraModel> read_lens(const Block& block, const std::string& camera) {
    constexpr std::size_t kCoefficients = 5;
    const std::vector<Node>* distortion = require(block, "Distortion", 1);
    const std::vector<Node>* coefficients = require(block, "Coeffs", kCoefficients);
    if (distortion == nullptr || coefficients == nullptr) return std::nullopt;
    const std::string words = distortion_of(block);
    const auto* const row = std::ranges::find_if(
        kDistortions, [&words](const Distortion& each) { return each.name == words || each.number == words; });
    if (row == kDistortions.end()) {
      std::vector<std::string> known;
      for (const Distortion& each : kDistortions) {
        if (each.name.find('-') == std::string_view::npos) known.emplace_back(each.name);
      }
      reader_.say(distortion->front(), Code::kTableUnknownWord, {camera + " Distortion", words, known});
      return std::nullopt;
    }
    const std::string what = camera + " Coeffs";
    const devices::Nodes nodes = pointers(*coefficients);
    std::optional<CameraModel> model;
    switch (row->lens) {
      case Lens::kNone:
        return make_model("pinhole");
      case Lens::kFisheye:
        return devices::fisheye_lens(nodes, what, reader_);
      case Lens::kFov:
        model = make_model("fov");
        if (!reader_.parameter(*nodes.front(), what, "w", *model)) return std::nullopt;
        return model;
      case Lens::kBrown:
      case Lens::kDoubtful:
        model = devices::opencv_lens(nodes, what, reader_);
        if (model && row->lens == Lens::kDoubtful && model_info(*model).id != "pinhole")
          reader_.say(*block.place, Code::kRealsenseInverseModel, {camera, row->name});
        return model;
    }
    return std::nullopt;
  }

  bool read_camera(const std::string& name, const ImageSize& size, Rig& rig) {
    std::optional<Camera> camera;
    for (const Block& block : blocks_) {
      if (block.kind != Block::Kind::kStream || camera_name(block.name) != name || read_size(block) != size) continue;
      Camera stated;
      stated.name = name;
      stated.image_size = size;
      std::optional<CameraModel> lens = read_lens(block, name);
      if (!lens) return false;
      for (const auto& [key, id] : kParameters) {
        const std::vector<Node>* number = require(block, key, 1);
        if (number == nullptr || !reader_.parameter(number->front(), name + " " + key, id, *lens)) return false;
      }
      stated.model = *lens;
      if (camera && camera->model != stated.model)
        reader_.say(*block.place, Code::kRealsenseBlocksDiffer, {name, devices::in_words(size)});
      if (!camera) camera = stated;
    }
    rig.cameras.push_back(camera.value());
    return true;
  }

  /// A stream as a frame of the rig; empty where it is neither a camera nor the IMU of it.
  [[nodiscard]] std::string frame_of(const Rig& rig, const std::string& stream) const {
    if (stream == kGyroscope) return std::string(schema::kImu);
    const bool has_gyroscope = std::ranges::any_of(blocks_, [](const Block& block) {
      return block.kind == Block::Kind::kPose && (block.name == kGyroscope || block.to == kGyroscope);
    });
    if (stream == kAccelerometer && !has_gyroscope) return std::string(schema::kImu);
    const std::string name = camera_name(stream);
    return rig.find_camera(name) != nullptr ? name : "";
  }

  std::optional<Transform> read_transform(const Block& block) {
    constexpr std::size_t kRotation = 9;
    const std::vector<Node>* R = require(block, "Rotation Matrix", kRotation);
    const std::vector<Node>* t = require(block, "Translation Vector", 3);
    if (R == nullptr || t == nullptr) return std::nullopt;
    const std::string what = "Extrinsic from " + block.name + " to " + block.to;
    Transform T;
    for (std::size_t i = 0; i < kRotation; ++i) {
      const std::optional<double> element = reader_.real((*R)[i], what);
      if (!element) return std::nullopt;
      T(static_cast<int>(i / 3), static_cast<int>(i % 3)) = *element;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<double> metres = reader_.real((*t)[i], what);
      if (!metres) return std::nullopt;
      T(static_cast<int>(i), 3) = *metres;
    }
    if (!reader_.checked(T, {R->front(), what}, {t->front(), what})) return std::nullopt;
    return T;
  }

  /// A pose that another block specifies already, from there to here, is not kept twice.
  static bool is_known(const Rig& rig, const PoseEdge& edge) {
    return std::ranges::any_of(rig.poses, [&edge](const PoseEdge& each) {
      const std::optional<Transform> there = each.a == edge.b && each.b == edge.a ? inverse(each.T_a_b) : std::nullopt;
      return there && !difference_of(*there, edge.T_a_b).contradicts();
    });
  }

  bool read_poses(Rig& rig) {
    std::vector<std::pair<const Block*, PoseEdge>> doubtful;
    for (const Block& block : blocks_) {
      if (block.kind != Block::Kind::kPose) continue;
      const std::optional<Transform> T = read_transform(block);
      if (!T) return false;
      const std::string from = frame_of(rig, block.name);
      const std::string to = frame_of(rig, block.to);
      if (from.empty() || to.empty() || from == to) continue;
      const PoseEdge edge{to, from, *T};
      if (to == kInfrared2 && from != kInfrared1) {
        doubtful.emplace_back(&block, edge);
      } else if (!is_known(rig, edge)) {
        rig.poses.push_back(edge);
      }
    }
    for (const auto& [block, edge] : doubtful) {
      const std::optional<Transform> others = rig.resolve(edge.a, edge.b);
      if (!others) {
        rig.poses.push_back(edge);
        continue;
      }
      const PoseDifference difference = difference_of(*others, edge.T_a_b);
      if (difference.contradicts())
        reader_.say(*block->place, Code::kRealsenseCopiedBlock, {block->name, block->to, difference.distance_m});
    }
    const auto is_imu = [](const PoseEdge& edge) { return edge.a == schema::kImu || edge.b == schema::kImu; };
    if (std::ranges::any_of(rig.poses, is_imu)) rig.add_frame(schema::kImu, FrameKind::kImu);
    return true;
  }

  /// What says something: neither variances of 0 nor the identity.
  void keep_motion(Rig& rig) const {
    for (const Block& block : blocks_) {
      if (block.kind != Block::Kind::kMotion) continue;
      for (const auto& [key, numbers] : block.values) {
        constexpr std::size_t kColumns = 4;
        bool says_something = false;
        std::string list;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
          const bool one = key == "Sensitivity" && i % kColumns == i / kColumns;
          says_something = says_something || text::parse_real(numbers[i].value) != (one ? 1.0 : 0.0);
          list += (i == 0 ? "[" : ", ") + numbers[i].value;
        }
        if (says_something) rig.extra_fields.push_back({std::string(schema::kImu), block.name + " " + key, list + "]"});
      }
    }
  }

  fields::Reader reader_;
  const ReadOptions& options_;
  std::vector<Block> blocks_;
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  Rig rig;
  if (!PrintReader(documents.front(), options, diagnostics).read_into(rig)) return std::nullopt;
  return rig;
}

ProbeResult probe(const text::Document& document) {
  const std::vector<Block> blocks = blocks_of(document);
  const auto is_stream = [](const Block& block) { return block.kind == Block::Kind::kStream; };
  if (std::ranges::any_of(blocks, is_stream)) return {evidence::kCamera, Message{Code::kRealsenseFound}};
  return blocks.empty() ? ProbeResult() : ProbeResult{evidence::kHint, Message{Code::kRealsenseFound}};
}

constexpr std::string_view kProgram = "RealSense SDK";
constexpr std::array kModels = {
    StoredModel{"radtan", "Brown Conrady", true, kProgram, {}},
    StoredModel{"pinhole", "coefficients of 0", true, kProgram, {}},
    StoredModel{"kb4", "Kannala Brandt4", true, kProgram, {}},
    StoredModel{"fov", "Ftheta", true, kProgram, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"scale, bias and variances of the IMU"}};

}  // namespace

const Format kFormat = {
    .id = "realsense",
    .title = "RealSense factory calibration",
    .group = FormatGroup::kDevices,
    .syntaxes = "text, JSON",
    .extension = ".txt",
    .program = kProgram,
    .main_file = "realsense.txt",
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

}  // namespace fca::realsense
