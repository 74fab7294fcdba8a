// SPDX-License-Identifier: BSD-3-Clause
// KITTI's and KITTI-360's lines of "key: numbers". Read only: nobody reads another camera from them.
//
//   calib_cam_to_cam.txt (KITTI raw), perspective.txt (KITTI-360): of each camera nn
//     S_nn: w h   K_nn: 9   D_nn: k1 k2 p1 p2 k3   R_nn: 9   T_nn: 3     as recorded; p_nn = R p_00 + T [m]
//     S_rect_nn, R_rect_nn, P_rect_nn     of the rectified images: kept; read where K_nn is missing
//   calib.txt (KITTI odometry)
//     P0: 12 ... P3: 12     P = K [1 | t], p_n = p_0 + t [m]: rectified cameras, whose size is in no file
//     Tr: 12                T_cam0_lidar: kept
//   calib_cam_to_pose.txt (KITTI-360)
//     image_nn: 12          T_imu_camera [m], of the cameras above
//
// KITTI-360's fisheyes (image_02.yaml, image_03.yaml) are files of VINS.
#include "kitti.h"

#include "fields.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace fca::kitti {

using text::Node;

namespace {

using Numbers = std::vector<double>;

/// A line of a file.
struct Line {
  const Node* value = nullptr;
  std::vector<Node> words;
};

/// The lines of a file by their keys; the first of equal ones counts.
class Lines {
 public:
  Lines(const text::Document& document, Diagnostics& diagnostics) : reader_(document, text::Dialect::kPyYaml, diagnostics) {
    for (const text::Entry& entry : document.root().entries) {
      const auto [line, is_first] = lines_.emplace(entry.key.value, Line{&entry.value, fields::words_in(entry.value, " \t")});
      if (is_first) continue;
      const bool alike = line->second.value->value == entry.value.value;
      reader_.say(entry.key, alike ? Code::kKeyTwiceAlike : Code::kKeyTwice, {entry.key.value});
    }
  }

  [[nodiscard]] const std::map<std::string, Line>& all() const { return lines_; }
  [[nodiscard]] bool has(const std::string& key) const { return lines_.contains(key); }
  [[nodiscard]] bool has_read(const std::string& key) const { return read_.contains(key); }
  void mark_read(const std::string& key) { read_.insert(key); }
  [[nodiscard]] fields::Reader& reader() { return reader_; }
  /// A number's word.
  [[nodiscard]] const Node& word(const std::string& key, std::size_t i) const { return lines_.at(key).words[i]; }

  /// `count` numbers; nothing with an error where there are others.
  [[nodiscard]] std::optional<Numbers> numbers(const std::string& key, std::size_t count) {
    const auto found = lines_.find(key);
    if (found == lines_.end()) {
      reader_.diagnostics().add(Code::kKeyMissing, {reader_.document().source().name, key},
                                {reader_.document().source().name, 0, 0});
      return std::nullopt;
    }
    read_.insert(key);
    const auto& [value, words] = found->second;
    if (words.size() != count) {
      reader_.say(*value, Code::kNumbersWanted, {key, words.size(), count});
      return std::nullopt;
    }
    Numbers numbers;
    for (const Node& word : words) {
      const std::optional<double> number = reader_.real(word, key);
      if (!number) return std::nullopt;
      numbers.push_back(*number);
    }
    return numbers;
  }

 private:
  fields::Reader reader_;
  std::map<std::string, Line> lines_;
  std::set<std::string> read_;
};

/// T from rows of a rotation and a translation.
Transform transform_of(std::span<const double> rotation, std::span<const double> translation) {
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = rotation[static_cast<std::size_t>(3 * row + column)];
    T(row, 3) = translation[static_cast<std::size_t>(row)];
  }
  return T;
}

/// fx fy cx cy of a 3 x 3 or 3 x 4 camera matrix. False with an error where they are none.
bool set_pinhole(Lines& lines, const std::string& key, std::size_t columns, const Numbers& K, CameraModel& model) {
  struct Element {
    ParameterId id;
    std::size_t row;
    std::size_t column;
  };
  constexpr std::array kElements = {Element{"fx", 0, 0}, Element{"fy", 1, 1}, Element{"cx", 0, 2}, Element{"cy", 1, 2}};
  for (const auto& [id, row, column] : kElements) {
    const std::size_t at = row * columns + column;
    if (!lines.reader().parameter(lines.word(key, at), key, id, K[at], model)) return false;
  }
  return true;
}

void keep(Lines& lines, const std::string& key, const std::string& owner, Rig& rig) {
  lines.mark_read(key);
  const auto& [node, words] = lines.all().at(key);
  std::string value;
  for (const Node& word : words) value += (value.empty() ? "[" : ", ") + word.value;
  rig.extra_fields.push_back({owner, key, words.empty() ? fields::value_text(*node) : value + "]"});
}

/// It is spelled as a real number: 1.392000e+03. False with errors.
bool read_size(Lines& lines, const std::string& key, const ReadOptions& options, Camera& camera) {
  camera.image_size = options.image_size;
  if (!lines.has(key)) return true;
  const std::optional<Numbers> size = lines.numbers(key, 2);
  if (!size) return false;
  constexpr double kMost = 1e6;
  const bool fits = std::ranges::all_of(*size, [](double side) { return side >= 1.0 && side <= kMost; });
  camera.image_size = fits ? ImageSize{static_cast<int>((*size)[0]), static_cast<int>((*size)[1])} : ImageSize{};
  const Message problem = problem_with_image_size(*camera.image_size);
  if (problem.is_said()) lines.reader().say(lines.word(key, 0), Code::kNotACamera, {key, problem});
  return !problem.is_said();
}

/// A camera as recorded. False with errors.
bool read_recorded(Lines& lines, const std::string& number, const ReadOptions& options, Rig& rig) {
  Camera camera;
  camera.name = "image_" + number;
  camera.model = make_model("radtan").value();
  const std::optional<Numbers> K = lines.numbers("K_" + number, 9);
  const std::optional<Numbers> D = lines.numbers("D_" + number, kRadtanCount);
  if (!K || !D || !set_pinhole(lines, "K_" + number, 3, *K, camera.model)) return false;
  for (std::size_t i = 0; i < kRadtanCount; ++i) {
    if (!lines.reader().parameter(lines.word("D_" + number, i), "D_" + number, kOpenCvCoefficients.at(i), (*D)[i],
                                  camera.model))
      return false;
  }
  if (!read_size(lines, "S_" + number, options, camera)) return false;
  if (lines.has("R_" + number) && number != "00") {
    const std::optional<Numbers> R = lines.numbers("R_" + number, 9);
    const std::optional<Numbers> t = lines.numbers("T_" + number, 3);
    if (!R || !t) return false;
    const std::optional<Transform> T =
        lines.reader().checked(transform_of(*R, *t), *lines.all().at("R_" + number).value, "R_" + number);
    if (!T) return false;
    rig.poses.push_back({camera.name, "image_00", *T});
  }
  for (const char* rectified : {"S_rect_", "R_rect_", "P_rect_"}) {
    if (lines.has(rectified + number)) keep(lines, rectified + number, camera.name, rig);
  }
  rig.cameras.push_back(std::move(camera));
  return true;
}

/// A rectified camera: its projection matrix, and the key of its size. False with errors.
bool read_rectified(Lines& lines, const std::string& key, const Camera& named, const std::string& first, Rig& rig) {
  const std::optional<Numbers> P = lines.numbers(key, 12);
  Camera camera = named;
  camera.model = make_model("pinhole").value();
  if (!P || !set_pinhole(lines, key, 4, *P, camera.model)) return false;
  if (camera.name != first) {
    const double z = (*P)[11];
    const Numbers t = {((*P)[3] - (*P)[2] * z) / (*P)[0], ((*P)[7] - (*P)[6] * z) / (*P)[5], z};
    constexpr std::array kIdentity = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    const std::optional<Transform> T = lines.reader().checked(transform_of(kIdentity, t), *lines.all().at(key).value, key);
    if (!T) return false;
    rig.poses.push_back({camera.name, first, *T});
  }
  rig.cameras.push_back(std::move(camera));
  return true;
}

constexpr std::string_view kImu = "imu0";

/// The pose of a camera of another file. False with errors.
bool read_pose(Lines& lines, const std::string& key, Rig& rig) {
  const std::optional<Numbers> rows = lines.numbers(key, 12);
  if (!rows) return false;
  Transform T;
  for (int i = 0; i < 12; ++i) T(i / 4, i % 4) = (*rows)[static_cast<std::size_t>(i)];
  const std::optional<Transform> checked = lines.reader().checked(T, *lines.all().at(key).value, key);
  if (!checked) return false;
  rig.add_frame(kImu, FrameKind::kImu);
  rig.poses.push_back({std::string(kImu), key, *checked});
  return true;
}

bool is_recorded(const std::string& key) {
  return key.size() == 4 && key.starts_with("K_") && key.find_first_not_of("0123456789", 2) == std::string::npos;
}
bool is_rectified(const std::string& key) { return key.size() == 2 && key[0] == 'P' && key[1] >= '0' && key[1] <= '9'; }
bool is_rectified_alone(const Lines& lines, const std::string& key) {
  return key.size() == 9 && key.starts_with("P_rect_") && !lines.has("K_" + key.substr(7));
}
bool is_pose(const std::string& key) {
  constexpr std::string_view kStart = "image_";
  return key.size() == kStart.size() + 2 && key.starts_with(kStart) &&
         key.find_first_not_of("0123456789", kStart.size()) == std::string::npos;
}

bool read_lines(Lines& lines, const ReadOptions& options, Rig& rig) {
  for (const auto& [key, line] : lines.all()) {
    if (is_recorded(key) && !read_recorded(lines, key.substr(2), options, rig)) return false;
    Camera camera;
    camera.name = key;
    camera.image_size = options.image_size;
    if (is_rectified(key) && !read_rectified(lines, key, camera, "P0", rig)) return false;
    if (is_rectified_alone(lines, key)) {
      camera.name = "image_" + key.substr(7);
      if (!read_size(lines, "S_rect_" + key.substr(7), options, camera)) return false;
      if (!read_rectified(lines, key, camera, "image_00", rig)) return false;
    }
    if (is_pose(key) && !read_pose(lines, key, rig)) return false;
  }
  for (const auto& [key, line] : lines.all()) {
    if (!lines.has_read(key)) keep(lines, key, "", rig);
  }
  return true;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    Lines lines(document, diagnostics);
    if (!read_lines(lines, options, rig)) return std::nullopt;
    if (rig.cameras.empty() && rig.poses.empty()) {
      diagnostics.add(Code::kTableWrongSyntax, {}, {document.source().name, 0, 0});
      return std::nullopt;
    }
  }
  return rig;
}

ProbeResult probe(const text::Document& document) {
  if (!document.root().is_mapping() || document.syntax() != text::Syntax::kYaml) return {};
  Diagnostics ignored;
  const Lines lines(document, ignored);
  const auto found = [](const std::string& key) { return Message{Code::kFoundKeys, {std::vector<std::string>{key}}}; };
  for (const auto& [key, line] : lines.all()) {
    const bool is_matrix = is_rectified(key) || is_rectified_alone(lines, key);
    if (is_recorded(key) || (is_matrix && line.words.size() == 12)) return {evidence::kCamera, found(key)};
    if (is_pose(key) && line.words.size() == 12) return {evidence::kPart, found(key)};
  }
  return {};
}

constexpr std::array kModels = {
    StoredModel{"radtan", "K_nn, D_nn", true, "KITTI", {}},
    StoredModel{"pinhole", "P_rect_nn, P0", true, "KITTI", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"rectified images, time of the calibration, pose of the LiDAR"}};

}  // namespace

const Format kFormat = {
    .id = "kitti",
    .title = "KITTI and KITTI-360 calibration",
    .group = FormatGroup::kDatasets,
    .syntaxes = "text",
    .extension = ".txt",
    .program = "KITTI",
    .main_file = "perspective.txt",
    .imu = false,
    .imu_pose = true,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::kitti
