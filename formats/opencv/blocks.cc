// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"

#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>

namespace fca::opencv {

using fields::Field;
using text::Node;

namespace {

bool all_floats(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return static_cast<double>(static_cast<float>(v)) == v; });
}

/// How many numbers a matrix or list in the base holds.
std::size_t count_in(const Node* node) {
  if (node == nullptr) return 0;
  const Node* data = node->is_mapping() ? text::find(*node, "data", kDialect) : node;
  if (data == nullptr) return 0;
  if (data->is_sequence()) return data->items.size();
  return data->is_scalar() ? 1 : 0;
}

std::vector<double> numbers_in(const Node* node) {
  std::vector<double> values;
  const Node* data = node != nullptr && node->is_mapping() ? text::find(*node, "data", kDialect) : node;
  if (data == nullptr) return values;
  for (const Node& item : data->items) values.push_back(text::parse_real(item.value).value_or(0.0));
  return values;
}

std::string_view value_at(const Node* node, std::string_view key) {
  const Node* found = node != nullptr && node->is_mapping() ? text::find(*node, key, kDialect) : nullptr;
  return found == nullptr ? std::string_view() : std::string_view(found->value);
}

/// Numbers that the base says already keep its spelling: "500" in a matrix of doubles, "0.1" in one of floats.
void keep_spellings(std::span<const double> values, bool floats, const Node* node, Field& field) {
  const Node* data = node != nullptr && node->is_mapping() ? text::find(*node, "data", kDialect) : node;
  if (data == nullptr) return;
  for (std::size_t i = 0; i < std::min(values.size(), data->items.size()); ++i) {
    const Node& item = data->items[i];
    const std::optional<double> there = item.is_scalar() ? text::parse_real(item.value) : std::nullopt;
    if (!there) continue;
    const double read = floats ? static_cast<double>(static_cast<float>(*there)) : *there;
    if (read == values[i] && std::signbit(read) == std::signbit(values[i])) field.tokens[i] = item.value;
  }
}

/// A matrix of `columns`; as the base writes it, where there is one of as many numbers. Floats stay floats where they can.
Field matrix_as(const std::string& key, std::span<const double> values, int columns, const Node* node) {
  if (node != nullptr && !node->is_mapping()) {
    Field list = fields::list(key, values);
    keep_spellings(values, false, node, list);
    return list;
  }
  const std::string_view type = value_at(node, "dt");
  const bool floats = type == "f" && all_floats(values);
  Field matrix = fields::matrix(key, values, columns, floats ? "f" : "d");
  // Digits that were a float's are another number as a double's.
  if (floats || type == "d") keep_spellings(values, floats, node, matrix);
  return matrix;
}

/// A vector lies as the base's, else as `row` says.
Field vector_as(const std::string& key, std::span<const double> values, bool row, const Node* node) {
  const std::string_view cols = value_at(node, "cols");
  if (!cols.empty() && value_at(node, "rows") != "0" && cols != "0") row = cols != "1";
  return matrix_as(key, values, row ? static_cast<int>(values.size()) : 1, node);
}

double value_of(const CameraModel& model, ParameterId id) { return parameter(model, id).value(); }

constexpr std::array<ParameterId, 3> kRadial = {"k1", "k2", "k3"};
constexpr std::array<ParameterId, 2> kTangential = {"p1", "p2"};

std::vector<double> values_of(const CameraModel& model, std::span<const ParameterId> ids) {
  std::vector<double> values;
  for (const ParameterId id : ids) values.push_back(value_of(model, id));
  return values;
}

/// The coefficients of a model, as many as the base's (`there`, 0: any) where the reader takes those for the same model.
std::vector<double> coefficients(const CameraModel& model, std::size_t there) {
  const std::string_view id = lens_id(model);
  const std::span<const ParameterId> of_opencv(kOpenCvCoefficients);
  if (id == "kb4") return values_of(model, kFisheyeCoefficients);
  if (id == "mei") return values_of(model, of_opencv.first(4));
  std::vector<double> zeros(std::max(there, kRadtanCount), 0.0);
  if (id == "pinhole") return zeros;
  std::vector<double> values = values_of(model, of_opencv.first(std::max(opencv_count(id), kRadtanCount)));
  if (id == "opencv14") {
    const bool is_level = values[kPrismCount] == 0.0 && values[kPrismCount + 1] == 0.0;
    if (there <= kPrismCount && is_level) values.resize(kPrismCount);
  } else if (id == "rational") {
    const bool is_radtan = values[5] == 0.0 && values[6] == 0.0 && values[7] == 0.0;
    if (there > kRationalCount && !is_radtan) values.resize(there, 0.0);
  } else if (id == "radtan") {
    if (there == 4 && values[4] == 0.0) values.resize(4);
    if (there > kRationalCount) values.resize(there, 0.0);
  }
  return values;
}

Field size_pair(const SizeKeys& keys, const ImageSize& size, const Node* node) {
  Field field{keys.pair, fields::Shape::kList, {}, 0, {}};
  const std::array<int, 2> sides = {keys.rows_first ? size.height : size.width, keys.rows_first ? size.width : size.height};
  const std::string_view type = value_at(node, "dt");
  for (const int side : sides)
    field.tokens.push_back(type == "f" || type == "d" ? text::format_real(side) : std::to_string(side));
  if (type.empty()) return field;
  field.shape = fields::Shape::kMatrix;
  field.columns = value_at(node, "cols") == "1" ? 1 : 2;
  field.element_type = type;
  return field;
}

std::array<double, 9> rotation_of(const Transform& T, bool transposed) {
  std::array<double, 9> R{};
  for (int i = 0; i < 9; ++i) R.at(static_cast<std::size_t>(i)) = transposed ? T(i % 3, i / 3) : T(i / 3, i % 3);
  return R;
}

}  // namespace

const Node* FieldMaker::there(const Node* mapping, const std::string& key) const {
  return mapping == nullptr || key.empty() ? nullptr : text::find(*mapping, key, kDialect);
}

const Node* FieldMaker::mapping_in_base(const CameraKeys& keys) const {
  if (base_ == nullptr) return nullptr;
  return keys.map.empty() ? &base_->root() : text::find(base_->root(), keys.map, kDialect);
}

void FieldMaker::add_size(const SizeKeys& keys, const Camera& camera, const Node* mapping, std::vector<Field>& fields) const {
  if (!keys.stated() || !camera.image_size) return;
  if (!keys.pair.empty()) {
    fields.push_back(size_pair(keys, *camera.image_size, there(mapping, keys.pair)));
    return;
  }
  fields.push_back(fields::integer(keys.width, camera.image_size->width));
  fields.push_back(fields::integer(keys.height, camera.image_size->height));
}

void FieldMaker::add_lens(const Camera& camera, const CameraKeys& keys, bool kept_length, std::vector<Field>& fields) const {
  const Node* mapping = mapping_in_base(keys);
  const Node* K_there = there(mapping, keys.matrix);
  std::vector<double> K = numbers_in(K_there);
  if (K.size() != 9) K = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
  K[0] = value_of(camera.model, "fx");
  K[4] = value_of(camera.model, "fy");
  K[keys.transposed ? 3 : 1] = without_skew(camera.model).skew_px;
  K[keys.transposed ? 6 : 2] = value_of(camera.model, "cx");
  K[keys.transposed ? 7 : 5] = value_of(camera.model, "cy");
  fields.push_back(matrix_as(keys.matrix, K, 3, K_there));
  if (!keys.radial.empty()) {
    const Node* radial = there(mapping, keys.radial);
    const bool straight = lens_id(camera.model) == "pinhole";
    std::vector<double> k = straight ? std::vector<double>(3, 0.0) : values_of(camera.model, kRadial);
    if (k[2] == 0.0 && count_in(radial) == 2) k.resize(2);
    fields.push_back(vector_as(keys.radial, k, true, radial));
    if (!keys.tangential.empty()) {
      const std::vector<double> p = straight ? std::vector<double>(2, 0.0) : values_of(camera.model, kTangential);
      fields.push_back(vector_as(keys.tangential, p, true, there(mapping, keys.tangential)));
    }
    return;
  }
  const Node* D_there = there(mapping, keys.distortion);
  const std::size_t count = count_in(D_there);
  // A base without coefficients says a pinhole so.
  const bool none = base_ != nullptr && kept_length && count == 0 && lens_id(camera.model) == "pinhole";
  if (!keys.distortion.empty() && !none) {
    fields.push_back(
        vector_as(keys.distortion, coefficients(camera.model, kept_length ? count : 0), layout_.row_vectors, D_there));
  }
  if (keys.xi.empty() || kind_of(camera.model) != Kind::kOmnidir) return;
  const double xi = value_of(camera.model, "xi");
  const Node* xi_there = there(mapping, keys.xi);
  if (xi_there != nullptr && xi_there->is_mapping()) {
    fields.push_back(matrix_as(keys.xi, std::array{xi}, 1, xi_there));
  } else {
    fields.push_back(fields::real(keys.xi, xi));
  }
}

std::vector<Field> stereo_pose_fields(const Rig& rig, const std::string& first, const std::string& second, const Layout& layout,
                                      const text::Document* base) {
  if (layout.rotation.empty() || layout.translation.empty() || layout.rotation_vector) return {};
  const Transform* stated = rig.stated(second, first);
  const std::optional<Transform> T = stated != nullptr ? *stated : rig.resolve(second, first);
  if (!T) return {};
  const auto there = [base](const std::string& key) {
    return base != nullptr ? text::find(base->root(), key, kDialect) : nullptr;
  };
  const std::array translation = {(*T)(0, 3), (*T)(1, 3), (*T)(2, 3)};
  return {matrix_as(layout.rotation, rotation_of(*T, layout.rotation_transposed), 3, there(layout.rotation)),
          vector_as(layout.translation, translation, false, there(layout.translation))};
}

std::vector<Field> FieldMaker::root(const std::vector<bool>& kept_length) const {
  std::vector<Field> fields;
  const Node* root = base_ != nullptr ? &base_->root() : nullptr;
  if (!layout_.count.empty()) fields.push_back(fields::integer(layout_.count, static_cast<int>(rig_.cameras.size())));
  add_size(layout_.size, rig_.cameras.front(), root, fields);
  if (!layout_.model.key.empty() && layout_.model.numeric) {
    const bool fisheye = kind_of(rig_.cameras.front().model) == Kind::kFisheye;
    fields.push_back(fields::integer(layout_.model.key, fisheye ? 1 : 0));
  }
  for (std::size_t i = 0; i < rig_.cameras.size() && !layout_.in_maps(); ++i)
    add_lens(rig_.cameras[i], layout_.cameras[i], kept_length[i], fields);
  if (rig_.cameras.size() == 2) {
    const std::vector<Field> pose = stereo_pose_fields(rig_, rig_.cameras[0].name, rig_.cameras[1].name, layout_, base_);
    fields.insert(fields.end(), pose.begin(), pose.end());
  }
  return fields;
}

std::vector<Field> FieldMaker::map(std::size_t camera_index, const CameraKeys& keys, bool kept_length) const {
  std::vector<Field> fields;
  const Camera& camera = rig_.cameras[camera_index];
  const Node* mapping = mapping_in_base(keys);
  add_lens(camera, keys, kept_length, fields);
  if (!keys.model.key.empty() && keys.model.numeric)
    fields.push_back(fields::integer(keys.model.key, kind_of(camera.model) == Kind::kFisheye ? 1 : 0));
  const std::optional<ReferencePose> pose = reference_pose(rig_, camera);
  if (!keys.group.empty() && base_ == nullptr && pose) fields.push_back(fields::integer(keys.group, pose->group));
  add_size(keys.size, camera, mapping, fields);
  if (!keys.pose.empty() && pose) fields.push_back(matrix_as(keys.pose, pose->T.values, 4, there(mapping, keys.pose)));
  return fields;
}

std::optional<ReferencePose> reference_pose(const Rig& rig, const Camera& camera) {
  constexpr std::string_view kFrame = "reference";
  std::string frame;
  for (const PoseEdge& edge : rig.poses) {
    if (!edge.a.starts_with(kFrame)) continue;
    if (edge.b == camera.name) {
      const int group = text::parse_int(edge.a.substr(kFrame.size())).value_or(0);
      return ReferencePose{edge.T_a_b, group};
    }
    if (frame.empty()) frame = edge.a;
  }
  if (!frame.empty()) {
    const std::optional<Transform> T = rig.resolve(frame, camera.name);
    if (T) return ReferencePose{*T, text::parse_int(frame.substr(kFrame.size())).value_or(0)};
    return std::nullopt;
  }
  const std::string& first = rig.cameras.front().name;
  const bool posed = std::ranges::any_of(
      rig.cameras, [&](const Camera& other) { return other.name != first && rig.resolve(first, other.name).has_value(); });
  if (!posed) return std::nullopt;
  if (camera.name == first) return ReferencePose{};
  const Transform* stated = rig.stated(first, camera.name);
  const std::optional<Transform> T = stated != nullptr ? *stated : rig.resolve(first, camera.name);
  if (!T) return std::nullopt;
  return ReferencePose{*T, 0};
}

}  // namespace fca::opencv
