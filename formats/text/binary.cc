// SPDX-License-Identifier: BSD-3-Clause
#include "binary.h"

#include "refusal.h"

#include <fca/code.h>
#include <fca/formats/text/limits.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <utility>

namespace fca::text {

namespace {

constexpr std::string_view kUint32 = "uint32";
constexpr std::string_view kUint64 = "uint64";
constexpr std::string_view kCount = "sensors";  // uint32: of a rig
constexpr std::string_view kModel = "model";    // int32
constexpr std::string_view kSensor = "sensor";  // int32
constexpr std::string_view kFlag = "has_pose";  // uint8

constexpr std::size_t kOfPose = 7;

struct Model {
  std::string_view name;
  std::size_t parameters = 0;
};

/// By their numbers (colmap@5d968cf, sensor/models.h).
constexpr std::array kModels = {Model{"SIMPLE_PINHOLE", 3},
                                Model{"PINHOLE", 4},
                                Model{"SIMPLE_RADIAL", 4},
                                Model{"RADIAL", 5},
                                Model{"OPENCV", 8},
                                Model{"OPENCV_FISHEYE", 8},
                                Model{"FULL_OPENCV", 12},
                                Model{"FOV", 5},
                                Model{"SIMPLE_RADIAL_FISHEYE", 4},
                                Model{"RADIAL_FISHEYE", 5},
                                Model{"THIN_PRISM_FISHEYE", 12},
                                Model{"RAD_TAN_THIN_PRISM_FISHEYE", 16},
                                Model{"SIMPLE_DIVISION", 4},
                                Model{"DIVISION", 5},
                                Model{"SIMPLE_FISHEYE", 3},
                                Model{"FISHEYE", 4},
                                Model{"EUCM", 6},
                                Model{"EQUIRECTANGULAR", 2}};

constexpr std::array<std::string_view, 2> kSensors = {"CAMERA", "IMU"};

std::size_t size_of(std::string_view tag) {
  if (tag == kFlag) return 1;
  return tag == kUint64 || tag == kRealTag ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
}

/// Which words a camera or rig has: one tells of the next ones.
class Line {
 public:
  explicit Line(bool of_camera) {
    if (of_camera) {
      ahead_ = {kUint32, kModel, kUint64, kUint64};
    } else {
      ahead_ = {kUint32, kCount};
    }
  }

  /// The tag of the next word; empty: there is none.
  [[nodiscard]] std::string_view next() const { return at_ < ahead_.size() ? ahead_[at_] : std::string_view(); }

  /// `word` stands there.
  void take(std::string_view word) {
    const std::string_view tag = ahead_[at_++];
    if (tag == kModel) {
      ahead_.insert(ahead_.end(), std::ranges::find(kModels, word, &Model::name)->parameters, kRealTag);
    } else if (tag == kFlag && word == "1") {
      ahead_.insert(ahead_.end(), kOfPose, kRealTag);
    } else if (tag == kCount) {
      std::from_chars(word.data(), word.data() + word.size(), sensors_);
      if (sensors_ > 0) ahead_.insert(ahead_.end(), {kSensor, kUint32});
      sensors_ -= sensors_ > 0 ? 1 : 0;
    }
    if (at_ < ahead_.size() || sensors_ == 0) return;
    --sensors_;
    ahead_ = {kSensor, kUint32, kFlag};
    at_ = 0;
  }

 private:
  std::vector<std::string_view> ahead_;
  std::size_t at_ = 0;
  std::uint32_t sensors_ = 0;  ///< That are still to come.
};

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) number = (number << 8U) | static_cast<unsigned char>(bytes[i]);
  return number;
}

std::string little_endian(std::uint64_t number, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>((number >> (8U * i)) & 0xFFU);
  return bytes;
}

/// What the bytes of a word say, as the text file has it. Throws a Refusal of what COLMAP does not know.
std::string decoded(std::string_view tag, std::string_view bytes, std::size_t offset) {
  const std::uint64_t number = little_endian(bytes);
  if (tag == kRealTag) return format_real(std::bit_cast<double>(number));
  const auto as_int = static_cast<std::int32_t>(static_cast<std::uint32_t>(number));
  if (tag == kModel) {
    if (number >= kModels.size()) throw Refusal{{Code::kBinaryModel, {as_int}}, offset};
    return std::string(kModels.at(number).name);
  }
  if (tag == kSensor) {
    if (number >= kSensors.size()) throw Refusal{{Code::kBinarySensor, {as_int}}, offset};
    return std::string(kSensors.at(number));
  }
  if (tag == kFlag && number > 1) throw Refusal{{Code::kBinaryPoseFlag, {number}}, offset};
  return std::to_string(number);
}

/// The file as one of cameras, or of rigs.
class BinaryReader {
 public:
  BinaryReader(const Source& source, std::string_view what) : source_(source), what_(what) {}

  /// Throws a Refusal.
  Node run() {
    if (bytes().size() < kOfCount) throw Refusal{{Code::kBinaryEndsInCount}, bytes().size()};
    const std::uint64_t count = little_endian(bytes().substr(0, kOfCount));
    // The smallest: of a panorama, which has two parameters; of a rig without sensors.
    const std::size_t smallest = is_of_cameras() ? 40 : 8;
    const std::size_t most = (bytes().size() - kOfCount) / smallest;
    if (count > most && most > 0) throw Refusal{{Code::kBinaryCount, {std::to_string(count), bytes().size(), most}}, 0};
    Node root;
    root.kind = NodeKind::kSequence;
    root.tag = what_;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (root.items.size() == kLongestList) throw too_long(at_);
      root.items.push_back(read_line(i + 1, count));
    }
    root.span = {0, at_};
    return root;
  }

  /// How many bytes stand after it.
  [[nodiscard]] std::size_t behind() const { return bytes().size() - at_; }

 private:
  static constexpr std::size_t kOfCount = 8;

  [[nodiscard]] std::string_view bytes() const { return source_.bytes; }
  [[nodiscard]] bool is_of_cameras() const { return what_ == kCamerasTag; }

  Node read_line(std::uint64_t number, std::uint64_t count) {
    Node node;
    node.kind = NodeKind::kSequence;
    node.span.offset = at_;
    Line line(is_of_cameras());
    for (std::string_view tag = line.next(); !tag.empty(); tag = line.next()) {
      const std::size_t size = size_of(tag);
      if (behind() < size)
        throw Refusal{{is_of_cameras() ? Code::kBinaryEndsInCamera : Code::kBinaryEndsInRig, {number, count}}, bytes().size()};
      if (node.items.size() == kLongestList) throw too_long(at_);
      Node word;
      word.kind = NodeKind::kScalar;
      word.span = {at_, size};
      word.value = decoded(tag, bytes().substr(at_, size), at_);
      word.tag = tag;
      line.take(word.value);
      node.items.push_back(std::move(word));
      at_ += size;
    }
    node.span.length = at_ - node.span.offset;
    return node;
  }

  const Source& source_;
  std::string_view what_;
  std::size_t at_ = kOfCount;
};

/// The last part of a path, after what a corpus' names have before it.
bool is_named(const Source& source, std::string_view name) { return source.name.ends_with(name); }

}  // namespace

std::optional<Node> parse_binary(const Source& source, Diagnostics& diagnostics) {
  for (const std::string_view other : {"images.bin", "points3D.bin", "frames.bin"}) {
    if (!is_named(source, other)) continue;
    diagnostics.add(Code::kBinaryOther, {other}, source.range({0, std::min<std::size_t>(8, source.bytes.size())}));
    return std::nullopt;
  }
  std::array<std::string_view, 2> kinds = {kCamerasTag, kRigsTag};
  if (is_named(source, "rigs.bin")) std::swap(kinds[0], kinds[1]);
  std::optional<Node> with_rest;
  std::optional<Refusal> why;
  std::size_t rest = 0;
  for (const std::string_view kind : kinds) {
    BinaryReader reader(source, kind);
    try {
      Node root = reader.run();
      if (reader.behind() == 0) return root;
      if (with_rest || why) continue;
      with_rest = std::move(root);
      rest = reader.behind();
    } catch (const Refusal& refusal) {
      if (!with_rest && !why) why = refusal;
    }
  }
  if (why) {
    report(*why, source, diagnostics);
    return std::nullopt;
  }
  diagnostics.add(Code::kBinaryAfterEnd, {rest}, source.range({source.bytes.size() - rest, rest}));
  return with_rest;
}

std::string encoded(std::string_view tag, std::string_view text) {
  std::uint64_t number = 0;
  if (tag == kRealTag) {
    number = std::bit_cast<std::uint64_t>(parse_real(text).value_or(0.0));
  } else if (tag == kModel) {
    number = static_cast<std::uint64_t>(std::ranges::find(kModels, text, &Model::name) - kModels.begin());
  } else if (tag == kSensor) {
    number = static_cast<std::uint64_t>(std::ranges::find(kSensors, text) - kSensors.begin());
  } else {
    // Text files may say +640 or 6.4e2.
    constexpr double kMostExact = 9007199254740992.0;  // 2^53
    const double value = parse_real(text).value_or(0.0);
    if (value >= 0.0 && value <= kMostExact) number = static_cast<std::uint64_t>(value);
  }
  return little_endian(number, size_of(tag));
}

std::string binary_file(std::string_view what, std::span<const std::vector<std::string>> lines) {
  std::string bytes = little_endian(lines.size(), sizeof(std::uint64_t));
  for (const std::vector<std::string>& words : lines) {
    Line line(what == kCamerasTag);
    for (const std::string& word : words) {
      bytes += encoded(line.next(), word);
      line.take(word);
    }
  }
  return bytes;
}

}  // namespace fca::text
