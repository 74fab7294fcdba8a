// SPDX-License-Identifier: BSD-3-Clause
#include "rigs.h"

#include "lines.h"
#include "rig_config.h"

#include "../fields.h"
#include "../text/binary.h"
#include "../text/words.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace fca::colmap {

using text::Node;

namespace {

constexpr std::string_view kCamera = "CAMERA";
constexpr std::string_view kImu = "IMU";
constexpr std::size_t kOfPose = 7;

bool is_type(std::string_view word) { return word == kCamera || word == kImu; }

bool is_header(const Node& line) {
  return line.tag == text::kCommentTag && has_words(line, {"RIG_ID", "NUM_SENSORS", "SENSOR"});
}

/// Four or three words of a line as a list.
Node as_list(std::span<const Node> words) {
  Node list;
  list.kind = text::NodeKind::kSequence;
  list.span = {words.front().span.offset, words.back().span.end() - words.front().span.offset};
  list.items.assign(words.begin(), words.end());
  return list;
}

class RigsReader {
 public:
  RigsReader(const text::Document& document, Diagnostics& diagnostics)
      : reader_(document, text::Dialect::kPyYaml, diagnostics) {}

  std::optional<Rig> run() {
    const std::vector<const Node*> lines = camera_lines(reader_.document());
    if (lines.empty()) {
      reader_.diagnostics().add(Code::kColmapNoRigLine, {}, {reader_.document().source().name, 0, 0});
      return std::nullopt;
    }
    bool good = true;
    for (const Node* line : lines) good = read_rig(*line) && good;
    return good ? std::optional(std::move(rig_)) : std::nullopt;
  }

 private:
  /// The next word of the line; null, with an error at the last one, where there is none.
  const Node* next(std::string_view what) {
    if (at_ < words_.size()) return &words_[at_++];
    reader_.say(words_.back(), Code::kColmapRigShort, {what});
    return nullptr;
  }

  std::optional<int> next_integer(std::string_view what) {
    const Node* word = next(what);
    return word != nullptr ? reader_.integer(*word, what) : std::nullopt;
  }

  std::optional<Id> next_id(std::string_view what) {
    const Node* word = next(what);
    return word != nullptr ? read_id(*word, what, reader_) : std::nullopt;
  }

  bool read_rig(const Node& line) {
    words_ = line.items;
    at_ = 0;
    const std::optional<Id> id = next_id("RIG_ID");
    if (!id) return false;
    if (!ids_.insert(*id).second) {
      reader_.say(words_[0], Code::kColmapRigIdTwice, {*id});
      return false;
    }
    const std::optional<int> sensors = next_integer("NUM_SENSORS");
    if (!sensors) return false;
    if (*sensors > 0) {
      const std::optional<std::string> reference = read_sensor();
      if (!reference) return false;
      for (int i = 1; i < *sensors; ++i) {
        if (!read_further_sensor(*reference)) return false;
      }
    }
    if (at_ < words_.size()) reader_.say(words_[at_], Code::kColmapRigAfterLast, {words_.size() - at_, *sensors});
    return true;
  }

  std::optional<std::string> read_sensor() {
    const Node* type = next("a type of sensor");
    if (type == nullptr) return std::nullopt;
    if (!is_type(type->value)) {
      reader_.say(*type, Code::kColmapSensorType, {type->value.substr(0, 40)});
      return std::nullopt;
    }
    const std::optional<Id> id = next_id("the id of a sensor");
    if (!id) return std::nullopt;
    const std::string name = type->value + " " + std::to_string(*id);
    if (sensors_.insert(name).second) return name;
    reader_.say(*type, Code::kColmapSensorTwice, {type->value, *id});
    return std::nullopt;
  }

  bool read_further_sensor(const std::string& reference) {
    const std::optional<std::string> sensor = read_sensor();
    const Node* flag = sensor ? next("HAS_POSE") : nullptr;
    if (flag == nullptr) return false;
    if (flag->value != "0" && flag->value != "1") {
      reader_.say(*flag, Code::kColmapPoseFlag, {flag->value.substr(0, 40)});
      return false;
    }
    return flag->value == "0" || read_pose_of(*sensor, reference);
  }

  bool read_pose_of(const std::string& sensor, const std::string& reference) {
    constexpr std::array<std::string_view, 7> kNumbers = {"QW", "QX", "QY", "QZ", "TX", "TY", "TZ"};
    constexpr std::size_t kOfRotation = 4;
    const std::size_t first = at_;
    std::vector<double> numbers;
    for (const std::string_view name : kNumbers) {
      const Node* word = next(name);
      const std::optional<double> number =
          word != nullptr ? reader_.real(*word, sensor + " " + std::string(name)) : std::nullopt;
      if (!number) return false;
      numbers.push_back(*number);
    }
    const std::span<const Node> words = words_.subspan(first, kNumbers.size());
    const Node rotation = as_list(words.first(kOfRotation));
    const Node translation = as_list(words.subspan(kOfRotation));
    const std::optional<Transform> T =
        read_pose({numbers.begin(), numbers.begin() + kOfRotation}, {numbers.begin() + kOfRotation, numbers.end()},
                  {rotation, sensor + " QW QX QY QZ"}, {translation, sensor}, reader_);
    if (T) rig_.poses.push_back({sensor, reference, *T});
    return T.has_value();
  }

  fields::Reader reader_;
  Rig rig_;
  std::span<const Node> words_;  ///< Of the line that is read.
  std::size_t at_ = 0;           ///< The next of them.
  std::set<Id> ids_;
  std::set<std::string> sensors_;
};

/// 2 of "CAMERA 2".
std::optional<Id> id_of(std::string_view frame, std::string_view type) {
  if (!frame.starts_with(type) || frame.substr(type.size(), 1) != " ") return std::nullopt;
  return parse_id(frame.substr(type.size() + 1));
}

/// "cam0" of 1, from which COLMAP counts.
std::string counted_from_0(std::string_view prefix, Id id) { return std::string(prefix) + std::to_string(id - 1); }

/// The seven numbers of each pose of a line that can be read.
std::vector<std::span<const Node>> poses_in(std::span<const Node> words) {
  constexpr std::size_t kFirst = 4;     // after the rig's id, its number of sensors and the first of them
  constexpr std::size_t kOfSensor = 3;  // type, id and flag
  std::vector<std::span<const Node>> poses;
  const int sensors = text::parse_int(words[1].value).value_or(0);
  std::size_t at = kFirst;
  for (int i = 1; i < sensors; ++i) {
    const bool has_pose = words[at + kOfSensor - 1].value == "1";
    at += kOfSensor;
    if (!has_pose) continue;
    poses.push_back(words.subspan(at, kOfPose));
    at += kOfPose;
  }
  return poses;
}

/// The numbers of a pose.
std::vector<double> stated(const Transform& T, const Quaternion& alike = {0.0, 0.0, 0.0, 1.0}) {
  std::vector<double> numbers;
  for (const double number : stated_quaternion(T, alike)) numbers.push_back(number);
  for (const double number : translation_of(T)) numbers.push_back(number);
  return numbers;
}

double value_of(const Node& word) { return text::parse_real(word.value).value_or(0.0); }

}  // namespace

bool is_rigs(const text::Document& document) {
  if (document.syntax() == text::Syntax::kBinary) return document.root().tag == text::kRigsTag;
  if (document.syntax() != text::Syntax::kWords) return false;
  const std::vector<const Node*> lines = camera_lines(document);
  if (lines.empty()) return std::ranges::any_of(document.root().items, is_header);
  constexpr std::size_t kType = 2;
  const std::vector<Node>& words = lines.front()->items;
  const bool sensor = words.size() > kType && is_type(words[kType].value);
  return sensor || (find_model(words[std::min<std::size_t>(1, words.size() - 1)].value) == nullptr &&
                    std::ranges::any_of(document.root().items, is_header));
}

ProbeResult probe_rigs(const text::Document& document) {
  return is_rigs(document) ? ProbeResult{evidence::kCamera, Message{Code::kColmapRigLines}} : ProbeResult{};
}

std::optional<Rig> read_rigs(const text::Document& document, Diagnostics& diagnostics) {
  return RigsReader(document, diagnostics).run();
}

void name_sensors(Rig& rig) {
  std::map<Id, std::string> names;
  const std::vector<Id> ids = camera_ids(rig);
  for (std::size_t i = 0; i < ids.size(); ++i) names.emplace(ids[i], rig.cameras[i].name);
  const auto rename = [&](std::string& frame) {
    if (const std::optional<Id> id = id_of(frame, kCamera)) {
      if (names.contains(*id)) {
        frame = names.at(*id);
      } else if (rig.cameras.empty() && *id > 0) {
        frame = counted_from_0("cam", *id);
      }
    } else if (const std::optional<Id> imu = id_of(frame, kImu); imu && *imu > 0) {
      frame = counted_from_0("imu", *imu);
      rig.add_frame(frame, FrameKind::kImu);
    }
  };
  for (PoseEdge& edge : rig.poses) {
    rename(edge.a);
    rename(edge.b);
  }
}

text::Document edited_rigs(const text::Document& base, const Rig& rig) {
  text::Document document = base;
  Diagnostics ignored;
  std::optional<Rig> before = read_rigs(base, ignored);
  if (!before) return document;
  before->cameras = rig.cameras;
  before->extra_fields = rig.extra_fields;
  name_sensors(*before);
  auto edge = before->poses.begin();  // one for each of the poses, in their order
  for (const Node* line : camera_lines(base)) {
    for (const std::span<const Node> words : poses_in(line->items)) {
      const PoseEdge& was = *edge++;
      const std::optional<Transform> now = rig.resolve(was.a, was.b);
      if (!now) continue;
      const Quaternion alike = {value_of(words[1]), value_of(words[2]), value_of(words[3]), value_of(words[0])};
      const std::vector<double> old = stated(was.T_a_b, alike);
      const std::vector<double> numbers = stated(*now, alike);
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (old[i] != numbers[i]) fields::set_scalar(document, words[i], text::format_real(numbers[i]));
      }
    }
  }
  return document;
}

std::vector<std::vector<std::string>> rig_lines(const Rig& rig, std::span<const Id> ids) {
  std::vector<std::vector<std::string>> lines;
  std::vector<bool> placed(rig.cameras.size());
  bool poses = false;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    if (placed[i]) continue;
    std::vector<std::string> words = {std::to_string(lines.size() + 1), "1", std::string(kCamera), std::to_string(ids[i])};
    int sensors = 1;
    for (std::size_t j = i + 1; j < rig.cameras.size(); ++j) {
      const std::optional<Transform> T = placed[j] ? std::nullopt : rig.resolve(rig.cameras[j].name, rig.cameras[i].name);
      if (!T) continue;
      placed[j] = poses = true;
      words[1] = std::to_string(++sensors);
      words.insert(words.end(), {std::string(kCamera), std::to_string(ids[j]), "1"});
      for (const double number : stated(*T)) words.push_back(text::format_real(number));
    }
    lines.push_back(std::move(words));
  }
  return poses ? lines : std::vector<std::vector<std::string>>();
}

}  // namespace fca::colmap
