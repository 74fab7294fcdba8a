// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "stella.h"

#include "../fields.h"
#include "../panorama.h"
#include "../ros/layout.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <set>

namespace fca::stella {

namespace {

using text::Node;

constexpr std::size_t kShown = 40;  ///< Of a word of the file, in a message.

/// The keys of one block, in the file's style.
class Block {
 public:
  Block(fields::Reader& reader, Style style, std::string_view name)
      : reader_(reader), root_(reader.document().root()), name_(name) {
    if (style == Style::kNested) node_ = reader.find(root_, name);
  }

  [[nodiscard]] bool is_there() const {
    const std::string prefix = name_ + ".";
    return node_ != nullptr || std::ranges::any_of(root_.entries, [&prefix](const text::Entry& entry) {
             return entry.key.value.starts_with(prefix);
           });
  }

  [[nodiscard]] const Node* find(std::string_view key) {
    asked_.emplace(key);
    return node_ != nullptr ? reader_.find(*node_, key) : reader_.find(root_, label(key));
  }

  /// With an error where it is missing.
  [[nodiscard]] const Node* require(std::string_view key) {
    const Node* found = find(key);
    if (found != nullptr) return found;
    const Node& mapping = node_ != nullptr ? *node_ : root_;
    SourceRange where = reader_.document().range(mapping);
    where.length = 1;
    if (node_ != nullptr) {
      reader_.diagnostics().add(Code::kKeyMissing, {name_, key}, where);
    } else {
      reader_.diagnostics().add(Code::kKeyMissing, {"the file", label(key)}, where);
    }
    return nullptr;
  }

  [[nodiscard]] std::string label(std::string_view key) const { return name_ + "." + std::string(key); }

  /// What nobody has asked for.
  void keep_unread(Rig& rig) const {
    if (node_ == nullptr) return;
    for (const text::Entry& entry : node_->entries) {
      if (!asked_.contains(entry.key.value))
        rig.extra_fields.push_back({"", label(entry.key.value), fields::value_text(entry.value)});
    }
  }
  /// Is it a key of the block that somebody has asked for?
  [[nodiscard]] bool has_read(std::string_view dotted) const {
    const std::string prefix = name_ + ".";
    return dotted.starts_with(prefix) && asked_.contains(std::string(dotted.substr(prefix.size())));
  }

 private:
  fields::Reader& reader_;
  const Node& root_;
  std::string name_;
  const Node* node_ = nullptr;
  std::set<std::string, std::less<>> asked_;
};

/// Of one camera of a pair that is not rectified.
struct Side {
  std::string_view K;
  std::string_view D;
  std::string_view R;
};
constexpr std::array kSides = {Side{"K_left", "D_left", "R_left"}, Side{"K_right", "D_right", "R_right"}};

class ConfigReader {
 public:
  ConfigReader(const text::Document& document, Diagnostics& diagnostics)
      : document_(document),
        reader_(document, kDialect, diagnostics),
        style_(style_of(document)),
        camera_(reader_, style_, kCamera),
        rectifier_(reader_, style_, kRectifier) {}

  std::optional<Rig> run() {
    Rig rig;
    reader_.warn_of_duplicates(document_.root());
    if (style_ == Style::kNested) reader_.warn_of_duplicates(*text::find(document_.root(), kCamera, kDialect));
    Camera camera;
    camera.name = "cam0";
    const Node* model = camera_.find("model");
    const bool is_panorama = model != nullptr && model->value == kPanorama;
    bool good = is_panorama || read_lens(camera.model);
    good = read_image(camera) && good;
    read_words(rig);
    if (!good) return std::nullopt;
    if (is_panorama) {
      rig.cameras.push_back(panorama(std::move(camera)));
    } else if (rectifier_.is_there()) {
      good = read_pair(camera, rig);
    } else {
      good = read_baseline(camera, rig);
      rig.cameras.push_back(std::move(camera));
    }
    if (!good) return std::nullopt;
    keep_unread(rig);
    reader_.warn_of_misspelt();
    return rig;
  }

 private:
  bool read_lens(CameraModel& model) {
    const Node* name = camera_.require("model");
    if (name == nullptr) return false;
    const Lens* lens = find_lens(name->value);
    if (lens == nullptr) {
      reader_.say(*name, Code::kTableUnknownWord, {camera_.label("model"), name->value.substr(0, kShown), lens_names()});
      return false;
    }
    model = *make_model(lens->model);
    bool good = true;
    const auto take = [&](std::string_view key, ParameterId id) {
      const Node* node = camera_.require(key);
      good = node != nullptr && reader_.parameter(*node, camera_.label(key), id, model) && good;
    };
    take("fx", "fx");
    take("fy", "fy");
    take("cx", "cx");
    take("cy", "cy");
    for (const Coefficient& each : lens->coefficients) take(each.key, each.parameter);
    return good;
  }

  bool read_image(Camera& camera) {
    const Node* cols = camera_.require("cols");
    const Node* rows = camera_.require("rows");
    const Node* fps = camera_.find("fps");
    if (cols != nullptr && rows != nullptr) camera.image_size = reader_.image_size(*cols, *rows, "Camera ");
    if (fps != nullptr) camera.frame_rate_hz = reader_.positive(*fps, camera_.label("fps"));
    return camera.image_size && (fps == nullptr || camera.frame_rate_hz);
  }

  /// What a rig has no member for. What the program says of other words is its affair.
  void read_words(Rig& rig) {
    const Node* setup = camera_.find("setup");
    if (setup != nullptr && setup->value == kDepth) rig.extra_fields.push_back({"", std::string(kSetup), setup->value});
    for (const std::string_view key : {"name", "color_order", "depth_threshold"}) {
      const Node* node = camera_.find(key);
      if (node != nullptr) rig.extra_fields.push_back({"", "Camera." + std::string(key), fields::value_text(*node)});
    }
  }

  /// That of a rectified pair or a depth sensor. 0, the program's default, says nothing.
  bool read_baseline(const Camera& camera, Rig& rig) {
    const Node* node = camera_.find("focal_x_baseline");
    if (node == nullptr || text::parse_real(node->value) == 0.0) return true;
    rig.baseline_m = reader_.baseline(*node, camera_.label("focal_x_baseline"), parameter(camera.model, "fx"));
    return rig.baseline_m.has_value();
  }

  /// Both cameras as StereoRectifier has them. `rectified`: what they become.
  bool read_pair(const Camera& rectified, Rig& rig) {
    const Node* name = rectifier_.find("model");
    const Lens* lens = find_lens(name != nullptr ? name->value : "perspective");
    if (lens == nullptr || !may_be_rectified(*lens)) {
      const std::vector<std::string> known = {"perspective", "fisheye"};
      reader_.say(*name, Code::kTableUnknownWord, {rectifier_.label("model"), name->value.substr(0, kShown), known});
      return false;
    }
    const Node* product = camera_.require("focal_x_baseline");
    if (product == nullptr) return false;
    const double fx = parameter(rectified.model, "fx").value();
    const std::optional<double> baseline = reader_.baseline(*product, camera_.label("focal_x_baseline"), fx);
    if (!baseline) return false;
    ros::Matrix3 K = ros::kIdentity;
    K[0] = fx;
    K[2] = parameter(rectified.model, "cx").value();
    K[4] = parameter(rectified.model, "fy").value();
    K[5] = parameter(rectified.model, "cy").value();
    ros::Projection P = ros::projection_of(K);
    for (std::size_t i = 0; i < kSides.size(); ++i) {
      Camera camera = rectified;
      camera.name = "cam" + std::to_string(i);
      if (i > 0) P[3] = -text::parse_real(product->value).value_or(*baseline * fx);
      if (!read_side(kSides.at(i), *lens, P, *product, camera, rig)) return false;
      rig.cameras.push_back(std::move(camera));
    }
    return true;
  }

  bool read_side(const Side& side, const Lens& lens, const ros::Projection& P, const Node& product, Camera& camera, Rig& rig) {
    constexpr std::size_t kOfMatrix = 9;
    const Node* K = rectifier_.require(side.K);
    const Node* D = rectifier_.require(side.D);
    const Node* R = rectifier_.require(side.R);
    if (K == nullptr || D == nullptr || R == nullptr) return false;
    const std::optional<std::vector<double>> k = reader_.reals(*K, kOfMatrix, rectifier_.label(side.K));
    const std::optional<std::vector<double>> r = reader_.reals(*R, kOfMatrix, rectifier_.label(side.R));
    if (!k || !r || !read_coefficients(*D, side.D, lens, camera.model)) return false;
    bool good = check_zeros(*K, *k);
    const auto take = [&](std::size_t place, ParameterId id) {
      good = reader_.parameter(K->items[place], rectifier_.label(side.K), id, (*k)[place], camera.model) && good;
    };
    take(0, "fx");
    take(4, "fy");
    take(2, "cx");
    take(5, "cy");
    ros::Matrix3 rotation{};
    std::ranges::copy(*r, rotation.begin());
    const std::string label = rectifier_.label(side.R);
    const std::optional<Transform> T = reader_.checked(ros::pose_of(rotation, P), {*R, label}, {product, "focal_x_baseline"});
    if (!good || !T) return false;
    rig.poses.push_back({ros::frame_of(P), camera.name, *T});
    rig.extra_fields.push_back({camera.name, std::string(ros::kProjection), printed(P)});
    return true;
  }

  /// OpenCV takes fx, fy, cx and cy out of K, and looks at nothing else of it.
  bool check_zeros(const Node& K, const std::vector<double>& k) {
    for (const std::size_t place : {1U, 3U, 6U, 7U}) {
      if (k[place] == 0.0) continue;
      reader_.say(K.items[place], Code::kRosNotACameraMatrix, {k[place]});
      return false;
    }
    return true;
  }

  bool read_coefficients(const Node& D, std::string_view key, const Lens& lens, CameraModel& model) {
    const std::string label = rectifier_.label(key);
    const std::optional<std::vector<double>> d = reader_.reals(D, 0, label);
    if (!d) return false;
    const bool fisheye = lens.model == "kb4";
    const std::span<const ParameterId> names =
        fisheye ? std::span<const ParameterId>(kFisheyeCoefficients) : std::span<const ParameterId>(kOpenCvCoefficients);
    const std::span<const std::size_t> counts = std::span(kOpenCvCounts).first(fisheye ? 1 : kOpenCvCounts.size());
    if (std::ranges::find(counts, d->size()) == counts.end()) {
      std::vector<std::string> wanted;
      for (const std::size_t count : counts) wanted.push_back(std::to_string(count));
      reader_.say(D, Code::kTableCoefficientCount, {label, d->size(), wanted, lens.name});
      return false;
    }
    model = *make_model(fisheye ? "kb4" : opencv_model_of(d->size()));
    for (std::size_t i = 0; i < d->size(); ++i) {
      if (!reader_.parameter(D.items[i], label, names[i], (*d)[i], model)) return false;
    }
    return true;
  }

  static std::string printed(const ros::Projection& P) {
    std::string text;
    for (const double value : P) text += (text.empty() ? "[" : ", ") + text::format_real(value);
    return text + "]";
  }

  /// Keys of the two blocks that nobody reads, and all other blocks.
  void keep_unread(Rig& rig) const {
    camera_.keep_unread(rig);
    rectifier_.keep_unread(rig);
    for (const text::Entry& entry : document_.root().entries) {
      const std::string& key = entry.key.value;
      if (style_ == Style::kNested ? key == kCamera || key == kRectifier : camera_.has_read(key) || rectifier_.has_read(key))
        continue;
      rig.extra_fields.push_back({"", std::string(kTuning) + key, fields::value_text(entry.value)});
    }
  }

  const text::Document& document_;
  fields::Reader reader_;
  Style style_;
  Block camera_;
  Block rectifier_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  if (documents.size() != 1 || !documents.front().root().is_mapping()) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return ConfigReader(documents.front(), diagnostics).run();
}

}  // namespace fca::stella
