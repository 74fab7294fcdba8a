// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include "names.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/numbers.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <utility>

namespace fca::opencv {

using text::Entry;
using text::Node;

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kSizeKeys = {{{"imagewidth", "imageheight"},
                                                                                     {"imgwidth", "imgheight"},
                                                                                     {"framewidth", "frameheight"},
                                                                                     {"camerawidth", "cameraheight"},
                                                                                     {"width", "height"}}};
constexpr std::array<std::string_view, 6> kSizePairs = {"imagesize",  "imgsize",         "framesize",
                                                        "resolution", "imageresolution", "calibrationsize"};
constexpr std::array<std::string_view, 4> kRotations = {"r", "rotationmatrix", "rotation", "rotationofcamera2"};
constexpr std::array<std::string_view, 4> kTranslations = {"t", "translationvector", "translation", "translationofcamera2"};

bool counts(const Node& mapping, const Entry& entry) { return text::find_entry(mapping, entry.key.value, kDialect) == &entry; }

/// The key of `mapping` that folds to `word`; "" if there is none.
std::string key_folding_to(const Node& mapping, std::string_view word) {
  const auto found =
      std::ranges::find_if(mapping.entries, [word](const Entry& entry) { return normalised_id(entry.key.value) == word; });
  return found == mapping.entries.end() ? "" : found->key.value;
}

template <std::size_t N>
std::string key_among(const Node& mapping, const std::array<std::string_view, N>& words) {
  for (const std::string_view word : words) {
    if (std::string key = key_folding_to(mapping, word); !key.empty()) return key;
  }
  return "";
}

SizeKeys find_size(const Node& mapping) {
  SizeKeys keys;
  for (const auto& [width, height] : kSizeKeys) {
    keys.width = key_folding_to(mapping, width);
    keys.height = key_folding_to(mapping, height);
    if (!keys.width.empty() && !keys.height.empty()) return keys;
  }
  keys = {};
  keys.pair = key_among(mapping, kSizePairs);
  const Node* pair = keys.pair.empty() ? nullptr : text::find(mapping, keys.pair, kDialect);
  if (pair != nullptr && !pair->is_sequence() && !is_matrix(*pair)) keys.pair.clear();
  return keys;
}

/// A name of a model that one of OpenCV's functions projects: is it cv::fisheye's?
std::optional<bool> is_fisheye(const std::string& name) {
  const std::string word = normalised_id(name);
  for (const std::string_view part : {"fisheye", "equidistant", "kannala"}) {
    if (word.find(part) != std::string::npos) return true;
  }
  const ModelInfo* model = find_model(name);
  if (model == nullptr) return std::nullopt;
  if (model->id == "kb4") return true;
  if (opencv_count(model->id) > 0 || model->id == "pinhole") return false;
  return std::nullopt;
}

/// Does a key that is to name a model, or part of one, say one that OpenCV has no function for? Words under camera_model that
/// are no model's may be the name of a device.
bool says_foreign_model(const std::string& normalised_key, const std::string& value) {
  if (value.empty() || value == "0" || normalised_id(value) == "none") return false;
  const bool of_distortion = normalised_key == "distortionmodel" || normalised_key == "distortiontype";
  return of_distortion || find_model(value) != nullptr;
}

/// A flag, 0 or 1, or a name of a model.
ModelKey find_model_key(const Node& mapping) {
  constexpr std::array<std::string_view, 4> kFlags = {"fisheyemodel", "distortiontype", "isfisheye", "fisheye"};
  for (const std::string_view flag : kFlags) {
    const std::string key = key_folding_to(mapping, flag);
    const Node* node = key.empty() ? nullptr : text::find(mapping, key, kDialect);
    if (node == nullptr || !node->is_scalar()) continue;
    if (const std::optional<double> value = text::parse_real(node->value)) {
      const bool is_flag = *value == 0.0 || *value == 1.0;
      return {key, true, is_flag ? std::optional(*value != 0.0) : std::nullopt, !is_flag};
    }
    if (node->value == "true" || node->value == "false") return {key, false, node->value == "true", false};
  }
  ModelKey foreign;
  for (const Entry& entry : mapping.entries) {
    const std::string key = normalised_id(entry.key.value);
    const bool speaks = key.find("model") != std::string::npos || key.ends_with("type");
    if (!speaks || !entry.value.is_scalar()) continue;
    if (const std::optional<bool> fisheye = is_fisheye(entry.value.value)) return {entry.key.value, false, fisheye, false};
    if (foreign.key.empty() && says_foreign_model(key, entry.value.value)) foreign = {entry.key.value, false, {}, true};
  }
  return foreign;
}

/// Settings of a surround view, next to camera_matrix and dist_coeffs: its program calls cv::fisheye.
bool is_of_surround_view(const Node& mapping) {
  const auto has = [&mapping](std::string_view key) { return text::find(mapping, key, kDialect) != nullptr; };
  return has("project_matrix") && (has("scale_xy") || has("shift_xy"));
}

bool has_four_numbers(const Node& mapping, std::string_view key) {
  const Node* matrix = text::find(mapping, key, kDialect);
  const Node* data = matrix != nullptr && matrix->is_mapping() ? text::find(*matrix, "data", kDialect) : matrix;
  constexpr std::size_t kFour = 4;
  return data != nullptr && data->is_sequence() && data->items.size() == kFour;
}

/// Is that what the end of a file leaves of a matrix: nothing, or "rows", after its tag? Next to another camera's the tag may
/// be missing, too.
bool is_cut_off(const Node& value, bool beside_another) {
  const bool nothing = value.kind == text::NodeKind::kNull || (value.is_scalar() && value.value.empty());
  return (value.is_scalar() && !value.tag.empty()) || (nothing && beside_another);
}

/// The cameras whose keys stand in one mapping, with the sides their keys name.
std::vector<std::pair<std::string, CameraKeys>> find_cameras(const Node& mapping) {
  std::vector<std::pair<std::string, CameraKeys>> cameras;
  for (const Entry& entry : mapping.entries) {
    const Name name = name_of(entry.key.value);
    if (name.role != Role::kMatrix || !(is_matrix(entry.value) || is_cut_off(entry.value, !cameras.empty()))) continue;
    const bool known = std::ranges::any_of(cameras, [&name](const auto& camera) { return camera.first == name.side; });
    if (known) continue;
    CameraKeys keys;
    keys.matrix = entry.key.value;
    keys.fisheye = name.fisheye;
    cameras.emplace_back(name.side, std::move(keys));
  }
  for (auto& [side, keys] : cameras) {
    for (const Entry& entry : mapping.entries) {
      const Name name = name_of(entry.key.value);
      if (name.side != side || !counts(mapping, entry)) continue;
      const auto take = [&entry](std::string& key) {
        if (key.empty()) key = entry.key.value;
      };
      // One that is cut off is there, and no reason to read a lens without distortion.
      const bool word = entry.value.is_scalar() && !is_cut_off(entry.value, true);
      if (name.role == Role::kDistortion && !word) {
        keys.fisheye = keys.fisheye || (keys.distortion.empty() && name.fisheye);
        take(keys.distortion);
      }
      if (name.role == Role::kRadial) take(keys.radial);
      if (name.role == Role::kTangential) take(keys.tangential);
      if (name.role == Role::kXi) take(keys.xi);
    }
    keys.fisheye = keys.fisheye || (is_of_surround_view(mapping) && has_four_numbers(mapping, keys.distortion));
    keys.transposed = keys.distortion.empty() && !keys.radial.empty();
    if (!keys.transposed) keys.radial = keys.tangential = "";
  }
  return cameras;
}

/// "camera_12" -> 12, "left" -> 0: cameras in the order in which they are counted, not in which they stand.
double order_of(const std::string& side) {
  const std::size_t digits = side.find_first_of("0123456789");
  if (digits != std::string::npos) return text::parse_real(side.substr(digits)).value_or(0.0);
  return side.find("right") != std::string::npos || side == "r" ? 1.0 : 0.0;
}

/// Top level: one camera under plain names, else those with sides, left before right and 1 before 2.
void take_top_level(const Node& root, Layout& layout) {
  std::vector<std::pair<std::string, CameraKeys>> found = find_cameras(root);
  const auto plain = std::ranges::find(found, "", &std::pair<std::string, CameraKeys>::first);
  if (plain != found.end()) {
    layout.cameras.push_back(plain->second);
    return;
  }
  std::ranges::stable_sort(found, {}, [](const auto& camera) { return order_of(camera.first); });
  // "M1" and "camera_matrix_left" in one file name the same cameras twice: what stands first counts.
  std::vector<double> taken;
  for (auto& [side, keys] : found) {
    const bool digits = side.find_first_of("0123456789") != std::string::npos;
    const bool first_digits = found.front().first.find_first_of("0123456789") != std::string::npos;
    if (digits != first_digits) continue;
    const double order = order_of(side);
    if (std::ranges::find(taken, order) != taken.end()) continue;
    taken.push_back(order);
    layout.cameras.push_back(std::move(keys));
  }
}

void take_maps(const Node& root, Layout& layout) {
  std::vector<std::pair<double, CameraKeys>> found;
  for (const Entry& entry : root.entries) {
    if (!entry.value.is_mapping() || is_matrix(entry.value) || !counts(root, entry)) continue;
    std::vector<std::pair<std::string, CameraKeys>> inside = find_cameras(entry.value);
    if (inside.size() != 1) continue;
    CameraKeys keys = std::move(inside.front().second);
    keys.map = entry.key.value;
    keys.size = find_size(entry.value);
    keys.model = find_model_key(entry.value);
    keys.pose = key_folding_to(entry.value, "cameraposematrix");
    keys.group = key_folding_to(entry.value, "cameragroup");
    found.emplace_back(order_of(normalised_id(keys.map)), std::move(keys));
  }
  std::ranges::stable_sort(found, {}, &std::pair<double, CameraKeys>::first);
  for (auto& [order, keys] : found) layout.cameras.push_back(std::move(keys));
  layout.count = key_folding_to(root, "nbcamera");
}

void take_pose(const Node& root, Layout& layout) {
  layout.rotation = key_among(root, kRotations);
  layout.translation = key_among(root, kTranslations);
  layout.rotation_transposed = normalised_id(layout.rotation) == "rotationofcamera2";
  if (layout.rotation.empty() && !layout.translation.empty()) {
    layout.rotation = key_folding_to(root, "om");
    layout.rotation_vector = !layout.rotation.empty();
  }
}

/// fx s cx, 0 fy cy, 0 0 1
bool looks_like_a_camera(const Node& matrix) {
  const Node* data = text::find(matrix, "data", kDialect);
  if (data == nullptr || data->items.size() != 9) return false;
  const auto at = [data](std::size_t i) { return text::parse_real(data->items[i].value).value_or(1.0); };
  return at(3) == 0.0 && at(6) == 0.0 && at(7) == 0.0 && at(0) > 0.0 && at(4) > 0.0 && at(8) == 1.0;
}

/// A lone "M" or "K" can be any matrix: a homography, a covariance.
bool is_some_matrix(const Node& root, const Layout& layout) {
  constexpr std::size_t kLongestLetters = 3;
  const CameraKeys& keys = layout.cameras.front();
  return keys.map.empty() && keys.distortion.empty() && keys.radial.empty() && keys.xi.empty() &&
         keys.matrix.size() <= kLongestLetters && !looks_like_a_camera(*text::find(root, keys.matrix, kDialect));
}

Message said_by(const CameraKeys& keys) {
  std::vector<Message> further;
  for (const std::string& key : {keys.distortion, keys.radial, keys.xi}) {
    if (!key.empty()) further.push_back({Code::kOpencvFoundFurtherKey, {key}});
  }
  if (keys.map.empty()) return {Code::kOpencvFoundCamera, {keys.matrix, further}};
  return {Code::kOpencvFoundMap, {keys.map, keys.matrix, further}};
}

}  // namespace

Kind kind_of(const CameraModel& model) {
  const std::string_view id = straight_id(model);
  if (id == "kb4") return Kind::kFisheye;
  return id == "mei" ? Kind::kOmnidir : Kind::kPinhole;
}

std::string_view lens_id(const CameraModel& model) {
  const SkewedModel parts = without_skew(model);
  // A pinhole with skew is radtan's.
  const bool has_lens = std::ranges::any_of(kOpenCvCoefficients, [&parts](ParameterId id) {
    const std::optional<double> coefficient = parameter(parts.straight, id);
    return coefficient && *coefficient != 0.0;
  });
  const std::string_view id = model_info(parts.straight).id;
  return parts.skew_px != 0.0 && id == "radtan" && !has_lens ? "pinhole" : id;
}

bool is_matrix(const Node& node) {
  if (!node.is_mapping()) return false;
  if (node.tag.ends_with("opencv-matrix")) return true;
  return text::find(node, "dt", kDialect) != nullptr && text::find(node, "data", kDialect) != nullptr;
}

std::optional<Layout> find_layout(const text::Document& document) {
  const Node& root = document.root();
  if (!root.is_mapping()) return std::nullopt;
  Layout layout;
  take_top_level(root, layout);
  if (!layout.cameras.empty() && is_some_matrix(root, layout)) return std::nullopt;
  if (layout.cameras.empty()) take_maps(root, layout);
  if (layout.cameras.empty()) {
    // stereo_calib's extrinsics.yml
    const Node* R = text::find(root, "R", kDialect);
    const Node* T = text::find(root, "T", kDialect);
    if (R == nullptr || T == nullptr || !is_matrix(*R) || (!is_matrix(*T) && !T->is_sequence())) return std::nullopt;
    layout.rotation = "R";
    layout.translation = "T";
    layout.why = {Code::kOpencvFoundPose};
    return layout;
  }
  layout.size = find_size(root);
  layout.model = find_model_key(root);
  if (layout.cameras.size() == 2 && layout.cameras.front().pose.empty()) take_pose(root, layout);
  layout.size.rows_first = layout.cameras.front().transposed;
  layout.why = said_by(layout.cameras.front());
  return layout;
}

std::vector<std::string> keys_of(const Layout& layout, const std::string& map) {
  std::vector<std::string> keys;
  const auto add_size = [&keys](const SizeKeys& size) { keys.insert(keys.end(), {size.width, size.height, size.pair}); };
  for (const CameraKeys& camera : layout.cameras) {
    if (camera.map != map) {
      if (map.empty()) keys.push_back(camera.map);
      continue;
    }
    keys.insert(keys.end(),
                {camera.matrix, camera.distortion, camera.radial, camera.tangential, camera.xi, camera.pose, camera.model.key});
    // The frame of the pose is named after it: it is the pose's part, or a fact of its own.
    if (!camera.pose.empty()) keys.push_back(camera.group);
    add_size(camera.size);
  }
  if (map.empty()) {
    keys.insert(keys.end(), {layout.model.key, layout.rotation, layout.translation, layout.count});
    add_size(layout.size);
  }
  std::erase(keys, "");
  return keys;
}

const Node& mapping_of(const text::Document& document, const CameraKeys& keys) {
  const Node* map = keys.map.empty() ? nullptr : text::find(document.root(), keys.map, kDialect);
  return map != nullptr ? *map : document.root();
}

Layout new_layout(std::string_view name, std::size_t cameras, bool omnidir) {
  Layout layout;
  layout.size = {"image_width", "image_height", "", false};
  if (!omnidir) layout.model.key = "fisheye_model";
  layout.row_vectors = omnidir || name == "stereo" || name == "cameras";
  const auto add = [&](std::string matrix, std::string distortion, std::string xi = "") {
    CameraKeys keys;
    keys.matrix = std::move(matrix);
    keys.distortion = std::move(distortion);
    if (omnidir) keys.xi = std::move(xi);
    layout.cameras.push_back(std::move(keys));
  };
  if (name == "cameras") {
    layout.size = {};
    layout.model = {};
    layout.count = "nb_camera";
    for (std::size_t i = 0; i < cameras; ++i) {
      add("camera_matrix", "distortion_vector");
      CameraKeys& keys = layout.cameras.back();
      keys.map = "camera_" + std::to_string(i);
      keys.size = {"img_width", "img_height", "", false};
      keys.model.key = "distortion_type";
      keys.pose = "camera_pose_matrix";
    }
    return layout;
  }
  if (cameras < 2) {
    add("camera_matrix", "distortion_coefficients", "xi");
    return layout;
  }
  if (omnidir) {
    add("camera_matrix_1", "distortion_coefficients_1", "xi_1");
    add("camera_matrix_2", "distortion_coefficients_2", "xi_2");
  } else if (name == "left-right") {
    add("camera_matrix_left", "dist_coeffs_left");
    add("camera_matrix_right", "dist_coeffs_right");
  } else {
    add("M1", "D1");
    add("M2", "D2");
  }
  layout.rotation = "R";
  layout.translation = "T";
  return layout;
}

}  // namespace fca::opencv
