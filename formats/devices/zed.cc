// SPDX-License-Identifier: BSD-3-Clause
// SN<serial>.conf, the factory calibration of a ZED camera, which is only read (stereolabs/zed-opencv-native and
// zed-open-capture, calibration.hpp; the writer of Stereolabs' tool for pairs of ZED X One).
//
//   [LEFT_CAM_HD] [RIGHT_CAM_HD]   and so on, for each size of images, which only the section's name specifies (kModes)
//     fx fy cx cy                  px; the centre of the first pixel is (0, 0)
//     k1 k2 k3 p1 p2               as OpenCV names them; k1 to k4 without p1 and p2 are cv::fisheye's
//   [LEFT_DISTO] [RIGHT_DISTO]     k1 k2 p1 p2 k3 k4 k5 k6 for all sizes, before those of a section
//   [STEREO]
//     Baseline TY TZ               mm: of the right camera's pose T_right_left they are -x, y, z
//     RX_HD CV_HD RZ_HD            its rotation vector (Rodrigues) [rad], for each size
//   [MISC]                         kept
//
// Names are case-insensitive (SimpleIni), and of equal keys the last counts.
#include "zed.h"

#include "lens.h"

#include "../ini_sections.h"
#include "../rotation_vector.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace fca::zed {

using text::Node;

namespace {

/// The images of a section's name.
struct Mode {
  std::string_view suffix;
  ImageSize size;
};
constexpr std::array kModes = {Mode{"4K", {3840, 2160}},      Mode{"QHDPLUS", {3200, 1800}}, Mode{"2K", {2208, 1242}},
                               Mode{"FHD1200", {1920, 1200}}, Mode{"FHD", {1920, 1080}},     Mode{"HD", {1280, 720}},
                               Mode{"SVGA", {960, 600}},      Mode{"VGA", {672, 376}}};

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

struct Value {
  std::string key;  ///< In upper case.
  Node number;      ///< What stands after "=".
};

struct Section {
  std::string name;  ///< In upper case.
  const Node* header = nullptr;
  std::vector<Value> values = {};

  [[nodiscard]] const Node* find(std::string_view key) const {
    const auto found = std::find_if(values.rbegin(), values.rend(), [key](const Value& value) { return value.key == key; });
    return found == values.rend() ? nullptr : &found->number;
  }
};

/// "fx = 700.5"; nothing where there is no "=".
std::optional<Value> value_in(const IniLine& line) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t equals = line.text.find('=');
  if (equals == std::string::npos) return std::nullopt;
  Value result;
  result.key = line.text.substr(0, equals);
  result.key.erase(result.key.find_last_not_of(kBlanks) + 1);
  result.key = upper(result.key);
  const std::size_t begin = std::min(line.text.find_first_not_of(kBlanks, equals + 1), line.text.size());
  result.number.kind = text::NodeKind::kScalar;
  result.number.value = line.text.substr(begin);
  result.number.span = {line.node->span.offset + begin, result.number.value.size()};
  if (result.number.value.empty()) result.number.span = line.node->span;
  return result;
}

std::vector<Section> sections_of(const text::Document& document) {
  std::vector<Section> sections;
  for (const IniSection& each : ini_sections_of(document)) {
    const std::size_t open = each.header.text.find('[') + 1;
    const std::size_t close = std::max(open, each.header.text.find(']'));
    Section section{upper(each.header.text.substr(open, close - open)), each.header.node};
    for (const IniLine& line : each.lines) {
      if (std::optional<Value> value = value_in(line)) section.values.push_back(*std::move(value));
    }
    sections.push_back(std::move(section));
  }
  return sections;
}

/// One of the two cameras.
struct Side {
  std::string_view name;    ///< Ours.
  std::string_view prefix;  ///< "LEFT_CAM_"
  std::string_view disto;   ///< The section with coefficients for all sizes.
};
constexpr std::array kSides = {Side{"left", "LEFT_CAM_", "LEFT_DISTO"}, Side{"right", "RIGHT_CAM_", "RIGHT_DISTO"}};

/// Null where the section is of no camera, or of a mode that nobody knows.
const Mode* mode_of(const Section& section, const Side& side) {
  if (!section.name.starts_with(side.prefix)) return nullptr;
  const std::string suffix = section.name.substr(side.prefix.size());
  const auto* const found = std::ranges::find(kModes, suffix, &Mode::suffix);
  return found == kModes.end() ? nullptr : found;
}

constexpr std::array<std::string_view, 8> kCoefficients = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
constexpr std::size_t kBrown = 5;  ///< So many of them where there is no K4.

class ConfReader {
 public:
  ConfReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : reader_(document, text::Dialect::kPyYaml, diagnostics), options_(options), sections_(sections_of(document)) {}

  bool read_into(Rig& rig) {
    std::vector<devices::Sizes> sizes;
    for (const Side& side : kSides) {
      devices::Sizes of_side{std::string(side.name), {}};
      for (const Section& section : sections_) {
        const Mode* mode = mode_of(section, side);
        if (mode == nullptr) continue;
        of_side.sizes.push_back(mode->size);
        if (of_side.place == nullptr) of_side.place = section.header;
      }
      if (!of_side.sizes.empty()) sizes.push_back(std::move(of_side));
    }
    if (sizes.empty()) {
      reader_.say(reader_.document().root(), Code::kKeyMissing, {"the file", "[LEFT_CAM_HD]"});
      return false;
    }
    warn_of_duplicates();
    if (sizes.size() < kSides.size() && find_section("STEREO") != nullptr) warn_of_missing("a second camera for [STEREO]");
    const auto chosen = devices::chosen_sizes(sizes, options_.image_size, reader_);
    if (!chosen) return false;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (chosen->at(i) && !read_camera(sizes[i].camera, *chosen->at(i), rig)) return false;
    }
    keep_misc(rig);
    return read_pose(rig);
  }

 private:
  /// The last of equal keys counts.
  void warn_of_duplicates() {
    for (const Section& section : sections_) {
      for (const Value& value : section.values) {
        const Node* counts = section.find(value.key);
        if (counts == &value.number) continue;
        const bool alike = counts->value == value.number.value;
        reader_.say(value.number, alike ? Code::kKeyTwiceAlike : Code::kKeyTwiceUnlike,
                    {value.key, counts->value, value.number.value});
      }
    }
  }

  [[nodiscard]] const Section* find_section(std::string_view name) const {
    const auto found = std::ranges::find(sections_, name, &Section::name);
    return found == sections_.end() ? nullptr : &*found;
  }

  bool read_camera(const std::string& name, const ImageSize& size, Rig& rig) {
    const Side& side = *std::ranges::find(kSides, name, &Side::name);
    const auto section = std::ranges::find_if(sections_, [&](const Section& each) {
      const Mode* mode = mode_of(each, side);
      return mode != nullptr && mode->size == size;
    });
    const Section* disto = find_section(side.disto);
    std::optional<CameraModel> lens = read_lens(disto != nullptr ? *disto : *section);
    if (!lens) return false;
    constexpr std::array<ParameterId, 4> kParameters = {"fx", "fy", "cx", "cy"};
    for (const ParameterId id : kParameters) {
      const Node* number = require(*section, id.name());
      if (number == nullptr || !reader_.parameter(*number, section->name + " " + std::string(id.name()), id, *lens))
        return false;
    }
    Camera camera;
    camera.name = name;
    camera.image_size = size;
    camera.model = *lens;
    rig.cameras.push_back(std::move(camera));
    modes_.push_back(mode_of(*section, side));
    return true;
  }

  void warn_of_missing(std::string_view what) {
    reader_.say(Severity::kWarning, reader_.document().root(), Code::kKeyMissing, {"the file", what});
  }

  const Node* require(const Section& section, std::string_view key) {
    const Node* node = section.find(upper(std::string(key)));
    if (node == nullptr) reader_.say(*section.header, Code::kKeyMissing, {"[" + section.name + "]", key});
    return node;
  }

  std::optional<CameraModel> read_lens(const Section& section) {
    const auto has = [&section](std::string_view key) { return section.find(key) != nullptr; };
    const std::string what = section.name + " distortion";
    if (!has("K1")) {
      reader_.say(Severity::kWarning, *section.header, Code::kKeyMissing, {"[" + section.name + "]", "k1"});
      return make_model("pinhole");
    }
    const auto is_zero = [&section](std::string_view key) {
      const Node* node = section.find(key);
      return node == nullptr || text::parse_real(node->value) == 0.0;
    };
    const bool zeros = std::ranges::all_of(std::array<std::string_view, 4>{"P1", "P2", "K5", "K6"}, is_zero);
    const bool no_tangential = !has("P1") && !has("P2");
    if (has("K4") && (no_tangential || (zeros && !is_zero("K4")))) {
      if (!no_tangential) reader_.say(*section.header, Code::kZedFisheyeByZeros, {"[" + section.name + "]"});
      devices::Nodes coefficients;
      for (const std::string_view key : {"k1", "k2", "k3", "k4"}) {
        const Node* node = require(section, key);
        if (node == nullptr) return std::nullopt;
        coefficients.push_back(node);
      }
      return devices::fisheye_lens(coefficients, what, reader_);
    }
    devices::Nodes coefficients;
    const bool is_rational = !is_zero("K4") || !is_zero("K5") || !is_zero("K6");
    const std::size_t count = is_rational ? kCoefficients.size() : kBrown;
    for (const std::string_view key : std::span(kCoefficients).first(count)) {
      const Node* node = section.find(upper(std::string(key)));
      coefficients.push_back(node != nullptr ? node : &zero_);
      if (node == nullptr) reader_.say(Severity::kWarning, *section.header, Code::kKeyMissing, {"[" + section.name + "]", key});
    }
    return devices::opencv_lens(coefficients, what, reader_);
  }

  /// Nothing, with a warning or an error, where the file does not say it.
  std::optional<double> number(const Section& section, const std::string& key, Severity missing) {
    const Node* node = section.find(upper(key));
    if (node != nullptr) return reader_.real(*node, section.name + " " + key);
    reader_.say(missing, *section.header, Code::kKeyMissing, {"[" + section.name + "]", key});
    return std::nullopt;
  }

  bool read_pose(Rig& rig) {
    const Section* stereo = find_section("STEREO");
    const bool is_pair = modes_.size() == kSides.size() && modes_[0] == modes_[1];
    if (is_pair && stereo == nullptr) warn_of_missing("[STEREO]");
    if (stereo == nullptr || !is_pair) return true;
    const std::string mode(modes_.front()->suffix);
    std::array<double, 3> rotation{};
    std::array<double, 3> mm{};
    constexpr std::array<std::string_view, 3> kRotation = {"RX_", "CV_", "RZ_"};
    for (std::size_t i = 0; i < rotation.size(); ++i) {
      const std::string key = std::string(kRotation.at(i)) + mode;
      const bool is_there = stereo->find(key) != nullptr;
      const std::optional<double> value = number(*stereo, key, Severity::kWarning);
      if (!value) return !is_there;
      rotation.at(i) = *value;
    }
    constexpr std::array<std::string_view, 3> kTranslation = {"Baseline", "TY", "TZ"};
    for (std::size_t i = 0; i < mm.size(); ++i) {
      if (i > 0 && stereo->find(kTranslation.at(i)) == nullptr) continue;
      const std::optional<double> value = number(*stereo, std::string(kTranslation.at(i)), Severity::kError);
      if (!value) return false;
      mm.at(i) = *value;
    }
    Transform T;
    set_rotation(rotation, T);
    constexpr double kMillimetre = 1e-3;
    T(0, 3) = -mm[0] * kMillimetre;
    T(1, 3) = mm[1] * kMillimetre;
    T(2, 3) = mm[2] * kMillimetre;
    const Node& place = *stereo->find(upper(std::string(kTranslation.front())));
    if (!reader_.checked(T, {place, "STEREO rotation"}, {place, "STEREO Baseline"})) return false;
    if (mm[1] != 0.0 || mm[2] != 0.0) reader_.say(place, Code::kZedHeightOfSign, {mm[1], mm[2]});
    rig.poses.push_back({std::string(kSides[1].name), std::string(kSides[0].name), T});
    return true;
  }

  void keep_misc(Rig& rig) const {
    const Section* misc = find_section("MISC");
    for (const Value& value : misc != nullptr ? misc->values : std::vector<Value>())
      rig.extra_fields.push_back({"", "MISC " + value.key, value.number.value});
  }

  fields::Reader reader_;
  const ReadOptions& options_;
  std::vector<Section> sections_;
  std::vector<const Mode*> modes_ = {};  ///< Of the rig's cameras.
  Node zero_ = [] {
    Node zero;
    zero.kind = text::NodeKind::kScalar;
    zero.value = "0";
    return zero;
  }();
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  Rig rig;
  if (!ConfReader(documents.front(), options, diagnostics).read_into(rig)) return std::nullopt;
  return rig;
}

ProbeResult probe(const text::Document& document) {
  if (document.syntax() != text::Syntax::kWords) return {};
  for (const Section& section : sections_of(document)) {
    const bool is_camera = std::ranges::any_of(kSides, [&](const Side& side) { return mode_of(section, side) != nullptr; });
    if (is_camera) return {evidence::kCamera, Message{Code::kFoundKey, {"[" + section.name + "]"}}};
  }
  return {};
}

constexpr std::string_view kProgram = "ZED SDK";
constexpr std::array kModels = {
    StoredModel{"radtan", "k1 k2 k3 p1 p2", true, kProgram, {}},
    StoredModel{"kb4", "k1 k2 k3 k4", true, kProgram, {}},
    StoredModel{"rational", "LEFT_DISTO with k1 to k6", true, kProgram, {}},
    StoredModel{"pinhole", "coefficients of 0", true, kProgram, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"number of the sensor"}};

}  // namespace

const Format kFormat = {
    .id = "zed",
    .title = "ZED factory calibration",
    .group = FormatGroup::kDevices,
    .syntaxes = "INI",
    .extension = ".conf",
    .program = kProgram,
    .main_file = "SN12345.conf",
    .many_cameras = true,
    .most_cameras = kSides.size(),
    .extrinsics = true,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::zed
