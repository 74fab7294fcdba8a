// SPDX-License-Identifier: BSD-3-Clause
#include "read.h"

#include "../colmap/lines.h"
#include "../fields.h"
#include "layout.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

namespace fca::nerfstudio {

using text::Node;

namespace {

constexpr std::size_t kLongestWord = 40;

/// Of nerfstudio's other models.
struct OtherModel {
  std::string_view name;
  Code why_not;
};
constexpr std::array kOtherModels = {OtherModel{"FISHEYE624", Code::kNerfFisheye624},
                                     OtherModel{"EQUIRECTANGULAR", Code::kColmapEquirectangular},
                                     OtherModel{"OMNIDIRECTIONALSTEREO_L", Code::kNerfStereo},
                                     OtherModel{"OMNIDIRECTIONALSTEREO_R", Code::kNerfStereo},
                                     OtherModel{"VR180_L", Code::kNerfStereo},
                                     OtherModel{"VR180_R", Code::kNerfStereo},
                                     OtherModel{"ORTHOPHOTO", Code::kNerfOrthographic}};
/// Keys by which instant-ngp takes another lens, whatever their value.
constexpr std::array kOtherLenses = {
    OtherModel{"ftheta_p0", Code::kNerfFtheta}, OtherModel{"latlong", Code::kColmapEquirectangular},
    OtherModel{"equirectangular", Code::kColmapEquirectangular}, OtherModel{"orthographic", Code::kNerfOrthographic}};

/// SeppeJ's files, for one, have them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWithDigitOne = {
    {{"f1_x", "fl_x"}, {"f1_y", "fl_y"}, {"c1_x", "cx"}, {"c1_y", "cy"}}};

/// A number of a camera that all programs read from the key.
bool is_number(std::string_view key) {
  const auto is_among = [key](const auto& keys) { return std::ranges::find(keys, key) != keys.end(); };
  return is_among(kFocalAndCentre) || is_among(kSize) || is_coefficient(key);
}

/// Once for all frames.
void warn_of_digit_one(fields::Reader& reader, const Node& object) {
  for (const auto& [written, meant] : kWithDigitOne) {
    const text::Entry* entry = text::find_entry(object, written, kDialect);
    if (entry != nullptr && value_in(object, meant) == nullptr) reader.say(entry->key, Code::kNerfDigitOne, {written, meant});
  }
}

/// From the top and a camera's first frame.
class CameraReader {
 public:
  CameraReader(fields::Reader& reader, const ReadOptions& options, const Group& group)
      : reader_(reader), options_(options), root_(reader.document().root()), group_(group) {}

  std::optional<Camera> run() {
    camera_.name = group_.name;
    warn_of_two_values();
    const std::optional<bool> fisheye = read_kind();
    if (!fisheye || !read_size() || !check_list()) return std::nullopt;
    const bool bends = std::ranges::any_of(kCoefficients, [this](std::string_view key) { return find(key) != nullptr; });
    camera_.model = make_model(*fisheye ? "kb4" : bends ? "radtan" : "pinhole").value();
    const bool focal = read_focal_lengths();
    const bool centre = read_centre("cx", true) && read_centre("cy", false);
    return focal && centre && read_coefficients() ? std::optional(std::move(camera_)) : std::nullopt;
  }

 private:
  [[nodiscard]] const Node* find(std::string_view key) const {
    const Node& owner = owner_of(root_, group_, key);
    return is_coefficient(key) ? coefficient_in(owner, key) : value_in(owner, key);
  }
  [[nodiscard]] const Node& frame() const { return group_.frames.empty() ? root_ : *group_.frames.front(); }
  /// Where messages about what is not there point.
  [[nodiscard]] SourceRange beginning() const {
    SourceRange where = reader_.document().range(frame());
    where.length = 1;
    return where;
  }

  /// What frames say otherwise than the top, each key once: nerfstudio goes by the top.
  void warn_of_two_values() {
    std::set<std::string> told;
    for (const Node* of_image : group_.frames) {
      for (const text::Entry& entry : of_image->entries) {
        const std::string& key = entry.key.value;
        if (is_number(key)) {
          warn_of_other_value(key, entry.key, entry.value, told);
        } else if (key == kCoefficientList) {
          for (std::size_t i = 0; i < std::min(entry.value.items.size(), kCoefficients.size()); ++i)
            warn_of_other_value(kCoefficients.at(i), entry.key, entry.value.items[i], told);
        }
      }
    }
  }

  void warn_of_other_value(std::string_view key, const Node& where, const Node& value, std::set<std::string>& told) {
    const std::string top = value_at_top(key);
    if (top.empty() || top == value.value || text::parse_real(top) == text::parse_real(value.value)) return;
    if (told.insert(where.value).second) reader_.say(where, Code::kNerfTwoValues, {key, value.value, top});
  }

  /// What counts to nerfstudio before a frame's number; empty where the frame's does. Of coefficients the others are 0.
  [[nodiscard]] std::string value_at_top(std::string_view key) const {
    if (is_coefficient(key) && !coefficients_at_top(root_)) return {};
    const Node* top = is_coefficient(key) ? coefficient_in(root_, key) : value_in(root_, key);
    if (top != nullptr) return top->value;
    return is_coefficient(key) ? "0" : "";
  }

  /// Is it a fisheye? By nerfstudio's word, else by instant-ngp's.
  std::optional<bool> read_kind() {
    for (const OtherModel& lens : kOtherLenses) {
      const text::Entry* entry = text::find_entry(root_, lens.name, kDialect);
      if (entry == nullptr) entry = text::find_entry(frame(), lens.name, kDialect);
      if (entry == nullptr) continue;
      reader_.say(entry->key, Code::kNerfLensNotRead, {lens.name, Message{lens.why_not}});
      return std::nullopt;
    }
    const Node* flag = value_in(frame(), kIsFisheye);
    if (flag == nullptr) flag = value_in(root_, kIsFisheye);
    if (flag != nullptr && flag->value != "true" && flag->value != "false") {
      reader_.say(*flag, Code::kNerfNoBool, {flag->value.substr(0, kLongestWord)});
      return std::nullopt;
    }
    const Node* name = value_in(root_, kCameraModel);
    if (name == nullptr) return flag != nullptr && flag->value == "true";
    const std::optional<bool> fisheye = is_fisheye_model(name->value);
    if (!fisheye) say_unknown_model(*name);
    if (fisheye && flag != nullptr && *fisheye != (flag->value == "true"))
      reader_.say(*flag, Code::kNerfTwoLenses, {name->value, flag->value});
    return fisheye;
  }

  void say_unknown_model(const Node& name) {
    const auto* const other = std::ranges::find(kOtherModels, name.value, &OtherModel::name);
    if (other != kOtherModels.end()) return reader_.say(name, Code::kNerfModelNotRead, {other->name, Message{other->why_not}});
    const std::vector<std::string> all = read_models();
    const std::vector<std::string> alike = text::nearest(name.value, all);
    reader_.say(name, Code::kNerfUnknownModel, {name.value.substr(0, kLongestWord), alike.empty() ? all : alike});
  }

  bool read_size() {
    const Node* width = find("w");
    const Node* height = find("h");
    camera_.image_size = options_.image_size;
    if (width == nullptr || height == nullptr) return true;
    camera_.image_size = reader_.image_size(*width, *height, camera_.name + " ");
    return camera_.image_size.has_value();
  }

  /// Is distortion_params, where it counts, a list of all coefficients? Warns of keys next to it that say otherwise.
  bool check_list() {
    const Node& owner = owner_of(root_, group_, kCoefficients.front());
    const Node* list = value_in(owner, kCoefficientList);
    if (list == nullptr) return true;
    const std::optional<std::vector<double>> numbers = reader_.reals(*list, kCoefficients.size(), kCoefficientList);
    for (std::size_t i = 0; numbers && i < numbers->size(); ++i) {
      const text::Entry* beside = text::find_entry(owner, kCoefficients.at(i), kDialect);
      if (beside == nullptr || text::parse_real(beside->value.value) == (*numbers)[i]) continue;
      reader_.say(beside->key, Code::kNerfListContradicts, {beside->key.value, beside->value.value, list->items[i].value});
    }
    return numbers.has_value();
  }

  bool needs_size(std::string_view what) {
    if (camera_.image_size) return true;
    reader_.diagnostics().add(Code::kNerfNeedsSize, {what}, beginning());
    return false;
  }

  [[nodiscard]] int side(bool horizontal) const { return horizontal ? camera_.image_size->width : camera_.image_size->height; }

  bool set(const Node& node, ParameterId id, double value) {
    return reader_.parameter(node, camera_.name, id, value, camera_.model);
  }

  /// fl_x, else what instant-ngp takes in its place. One alone is both. False with an error.
  bool read_focal_lengths() {
    const std::optional<Stated> x = focal_length("fl_x", true);
    const std::optional<Stated> y = x ? focal_length("fl_y", false) : std::nullopt;
    if (!x || !y) return false;
    const Stated& first = x->node != nullptr ? *x : *y;
    const Stated& second = y->node != nullptr ? *y : *x;
    if (first.node == nullptr) {
      reader_.diagnostics().add(Code::kNerfNoFocalLength, {camera_.name}, beginning());
      return false;
    }
    return set(*first.node, "fx", first.value) && set(*second.node, "fy", second.value);
  }

  struct Stated {
    const Node* node = nullptr;  ///< Null: nothing specifies it.
    double value = 0.0;
  };

  /// Nothing, with an error, where what stands there specifies none.
  std::optional<Stated> focal_length(std::string_view key, bool horizontal) {
    if (const Node* node = find(key)) {
      const std::optional<double> value = reader_.real(*node, key);
      return value ? std::optional(Stated{node, *value}) : std::nullopt;
    }
    const Node& object = angle_in(frame(), horizontal) != nullptr ? frame() : root_;
    const AngleKey* angle = angle_in(object, horizontal);
    if (angle == nullptr) return Stated{};
    const Node& node = *value_in(object, angle->name);
    const std::optional<double> value = reader_.real(node, angle->name);
    if (!value || !needs_size(angle->name)) return std::nullopt;
    const double half_turn = angle->degrees ? 180.0 : std::numbers::pi;
    if (*value > 0.0 && *value < half_turn) return Stated{&node, focal_length_of(*angle, *value, side(horizontal))};
    reader_.say(node, Code::kNerfAngle, {angle->name, *value, half_turn});
    return std::nullopt;
  }

  /// Where it is not stated it is the middle of the image.
  bool read_centre(std::string_view key, bool horizontal) {
    const ParameterId id = horizontal ? ParameterId("cx") : ParameterId("cy");
    if (const Node* node = find(key)) {
      const std::optional<double> value = reader_.real(*node, key);
      return value && set(*node, id, colmap::from_file(*value));
    }
    return needs_size(key) && set_parameter(camera_.model, id, colmap::from_file(0.5 * side(horizontal)));
  }

  bool read_coefficients() {
    bool good = true;
    for (const std::string_view key : kCoefficients) {
      const Node* node = find(key);
      if (node != nullptr) good = read_coefficient(key, *node) && good;
    }
    return good;
  }

  bool read_coefficient(std::string_view key, const Node& node) {
    const std::optional<double> value = reader_.real(node, key);
    if (!value) return false;
    const auto& parameters = model_info(camera_.model).parameters;
    const auto row = std::ranges::find(parameters, key, &Parameter::name);
    if (row != parameters.end()) return set(node, ParameterId(*row), *value);
    if (*value == 0.0) return true;
    if (key == "k4") {
      reader_.say(node, Code::kNerfQuartic, {*value});
    } else {
      reader_.say(node, Code::kNerfTangential, {key, *value});
    }
    return false;
  }

  fields::Reader& reader_;
  const ReadOptions& options_;
  const Node& root_;
  const Group& group_;
  Camera camera_;
};

/// False with an error where a frame or its pose cannot be read by anyone.
bool check_frames(fields::Reader& reader, const Node& frames) {
  if (!frames.is_sequence()) {
    reader.say(frames, Code::kNerfFramesNoList);
    return false;
  }
  for (std::size_t i = 0; i < frames.items.size(); ++i) {
    const Node& frame = frames.items[i];
    if (!frame.is_mapping()) {
      reader.say(frame, Code::kNerfFrameNoObject, {i});
      return false;
    }
    reader.warn_of_duplicates(frame);
    const Node* pose = value_in(frame, kPose);
    if (pose == nullptr) continue;
    // nerfstudio and instant-ngp look at three rows.
    constexpr std::size_t kRows = 4;
    if (!pose->is_sequence() || (pose->items.size() != kRows && pose->items.size() != kRows - 1)) {
      reader.say(*pose, Code::kRowsWanted, {kPose, pose->items.size(), kRows});
      return false;
    }
    for (const Node& row : pose->items) {
      if (!reader.reals(row, 4, kPose)) return false;
    }
  }
  return true;
}

/// Is it a key of an image or of all, that says something of cameras or poses?
bool is_known(std::string_view key) {
  constexpr std::array kOthers = {kCameraModel, kIsFisheye, kFrames, kPose, kLabel, kImageFile, kCoefficientList};
  return is_number(key) || std::ranges::find(kOthers, key) != kOthers.end() ||
         std::ranges::find(kAngles, key, &AngleKey::name) != kAngles.end();
}

/// The key that is probably meant and does not stand in the object; empty: none.
std::string_view meant_by(std::string_view key, const Node& object) {
  // Shorter ones (k1, cx) have too many neighbours.
  constexpr std::array<std::string_view, 15> kLong = {kCameraModel, kIsFisheye,       kFrames,          kPose,  kLabel,
                                                      kImageFile,   kCoefficientList, "fl_x",           "fl_y", "x_fov",
                                                      "y_fov",      "camera_angle_x", "camera_angle_y", "fovx", "fovy"};
  if (is_known(key)) return {};
  const auto* const meant = std::ranges::find_if(
      kLong, [&](std::string_view known) { return text::is_misspelling(key, known) && value_in(object, known) == nullptr; });
  return meant == kLong.end() ? std::string_view() : *meant;
}

/// Each key once, however many images have it.
void warn_of_misspelt(fields::Reader& reader, const Node& object, std::set<std::string>& told) {
  for (const text::Entry& entry : object.entries) {
    const std::string& key = entry.key.value;
    const std::string_view meant = meant_by(key, object);
    if (!meant.empty() && told.insert(key).second) reader.say(entry.key, Code::kKeyMisspelt, {key, meant});
  }
}

/// What stands next to cameras: at the top with its value, of the images how many there are and how many have a key.
std::vector<ExtraField> others(const Node& root) {
  std::vector<ExtraField> extras;
  std::map<std::string, std::size_t> in_frames;
  for (const text::Entry& entry : root.entries) {
    const std::string& key = entry.key.value;
    const bool frames = key == kFrames;
    if ((is_known(key) && !frames) || value_in(root, key) != &entry.value) continue;
    extras.push_back({"", key, frames ? std::to_string(entry.value.items.size()) : fields::value_text(entry.value)});
    if (!frames) continue;
    for (const Node& frame : entry.value.items) {
      for (const text::Entry& own : frame.entries) in_frames[own.key.value] += is_known(own.key.value) ? 0 : 1;
    }
  }
  for (const auto& [key, count] : in_frames) {
    if (count > 0) extras.push_back({"", std::string(kFrames) + "/" + key, std::to_string(count)});
  }
  return extras;
}

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  const bool is_object =
      documents.size() == 1 && documents.front().syntax() == text::Syntax::kJson && documents.front().root().is_mapping();
  if (!is_object) {
    diagnostics.add(Code::kNerfWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  const Node& root = documents.front().root();
  fields::Reader reader(documents.front(), kDialect, diagnostics);
  reader.warn_of_duplicates(root);
  const Node* frames = value_in(root, kFrames);
  if (frames != nullptr && !check_frames(reader, *frames)) return std::nullopt;
  Rig rig;
  const bool has_frame = frames != nullptr && !frames->items.empty();
  warn_of_digit_one(reader, root);
  if (has_frame) warn_of_digit_one(reader, frames->items.front());
  for (const Group& group : groups_of(root)) {
    std::optional<Camera> camera = CameraReader(reader, options, group).run();
    if (!camera) return std::nullopt;
    rig.cameras.push_back(*std::move(camera));
  }
  rig.extra_fields = others(root);
  std::set<std::string> told;
  warn_of_misspelt(reader, root, told);
  for (std::size_t i = 0; has_frame && i < frames->items.size(); ++i) warn_of_misspelt(reader, frames->items[i], told);
  return rig;
}

std::vector<fields::Field> numbers_of(const Camera& camera) {
  const CameraModel& model = camera.model;
  std::vector<fields::Field> numbers;
  const auto add = [&](std::string_view key, double value) { numbers.push_back(fields::real(std::string(key), value)); };
  add("fl_x", parameter(model, "fx").value());
  add("fl_y", parameter(model, "fy").value());
  add("cx", colmap::to_file(parameter(model, "cx").value()));
  add("cy", colmap::to_file(parameter(model, "cy").value()));
  if (camera.image_size) {
    numbers.push_back(fields::integer("w", camera.image_size->width));
    numbers.push_back(fields::integer("h", camera.image_size->height));
  }
  const auto& parameters = model_info(model).parameters;
  for (const std::string_view key : kCoefficients) {
    const auto row = std::ranges::find(parameters, key, &Parameter::name);
    if (row != parameters.end()) add(key, parameter(model, ParameterId(*row)).value());
  }
  return numbers;
}

}  // namespace fca::nerfstudio
