// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "lens.h"
#include "numbers.h"
#include "opencv.h"
#include "rectification.h"
#include "sigmas.h"

#include "../fields.h"
#include "../rotation_vector.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>

namespace fca::opencv {

using text::Node;

namespace {

class CalibrationReader {
 public:
  CalibrationReader(const text::Document& document, const Layout& layout, const ReadOptions& options, Diagnostics& diagnostics)
      : document_(document), reader_(document, kDialect, diagnostics), layout_(layout), options_(options) {}

  void read_into(Rig& rig) {
    const bool yaml = document_.syntax() == text::Syntax::kYaml || document_.syntax() == text::Syntax::kOpenCvYaml;
    if (yaml && !document_.source().bytes.starts_with("%YAML")) {
      reader_.say(document_.root().entries.front().key, Code::kYamlDirectiveMissing);
    }
    reader_.warn_of_duplicates(document_.root());
    for (std::size_t i = 0; i < layout_.cameras.size(); ++i) read_camera(layout_.cameras[i], "cam" + std::to_string(i), rig);
    read_count();
    read_stereo_pose(rig);
    rig.rectified = read_rectification(document_);
    keep_unread(rig);
    reader_.warn_of_misspelt();
  }

 private:
  void read_camera(const CameraKeys& keys, const std::string& name, Rig& rig) {
    const Node& map = mapping_of(document_, keys);
    const Node& K_node = *reader_.find(map, keys.matrix);
    const std::string K_label = label(keys, keys.matrix);
    std::optional<Numbers> K = read_numbers(K_node, K_label, reader_);
    if (K && !check_matrix(*K, K_node, K_label, keys.transposed)) K.reset();
    const std::optional<CameraModel> lens = read_lens(layout_, keys, map, options_, reader_);
    if (!K || !lens) return;
    Camera camera;
    camera.name = name;
    camera.model = *lens;
    // Row-major, transposed in MATLAB.
    const std::size_t cx = keys.transposed ? 6 : 2;
    const std::size_t cy = keys.transposed ? 7 : 5;
    bool good = set(*K, 0, K_label, "fx", camera.model, reader_);
    good = set(*K, 4, K_label, "fy", camera.model, reader_) && good;
    good = set(*K, cx, K_label, "cx", camera.model, reader_) && good;
    good = set(*K, cy, K_label, "cy", camera.model, reader_) && good;
    good = take_skew(*K, keys, K_label, camera.model) && good;
    if (!good) return;
    camera.image_size = read_size(keys, map);
    read_map_pose(keys, map, name, rig);
    if (!keys.map.empty() || layout_.cameras.size() == 1) read_sigmas(map, camera, reader_, rig);
    rig.cameras.push_back(std::move(camera));
  }

  bool check_matrix(const Numbers& K, const Node& node, const std::string& what, bool transposed) {
    if (K.rows != 3 || K.cols != 3) {
      reader_.say(node, Code::kOpencvNotCameraMatrixSize, {what, K.rows, K.cols});
      return false;
    }
    const auto& k = K.values;
    const bool upper = k[2] != 0.0 || k[5] != 0.0;
    const bool lower = k[6] != 0.0 || k[7] != 0.0;
    if (!transposed && lower && !upper) {
      reader_.say(node, Code::kOpencvMatrixTransposed, {what});
      return false;
    }
    if (transposed && upper && !lower) {
      reader_.say(node, Code::kOpencvMatrixNotTransposed, {what});
      return false;
    }
    const std::vector<std::size_t> zeros = transposed ? std::vector<std::size_t>{1, 2, 5} : std::vector<std::size_t>{3, 6, 7};
    for (const std::size_t place : zeros) {
      if (k[place] == 0.0) continue;
      reader_.say(*K.nodes[place], Code::kOpencvMatrixNonZero, {what, k[place]});
      return false;
    }
    if (k[8] != 1.0) reader_.say(*K.nodes[8], Code::kOpencvMatrixCorner, {what, k[8]});
    if (transposed) reader_.say(node, Code::kOpencvMatlabOrigin, {what});
    return true;
  }

  bool take_skew(const Numbers& K, const CameraKeys& keys, const std::string& what, CameraModel& model) {
    const std::size_t place = keys.transposed ? 3 : 1;
    const double skew_px = K.values[place];
    if (skew_px == 0.0) return true;
    model = with_skew(model, 0.0).value();  // of each model that OpenCV has
    if (!set(K, place, what, "skew", model, reader_)) return false;
    if (kind_of(model) != Kind::kOmnidir) reader_.say(*K.nodes[place], Code::kOpencvSkewKept, {what, skew_px});
    return true;
  }

  std::optional<ImageSize> read_size(const CameraKeys& keys, const Node& map) {
    const bool own = keys.size.stated();
    const SizeKeys& size = own ? keys.size : layout_.size;
    const Node& mapping = own ? map : document_.root();
    if (!size.width.empty()) {
      return reader_.image_size(*reader_.find(mapping, size.width), *reader_.find(mapping, size.height),
                                keys.map.empty() ? "image " : keys.map + " ");
    }
    if (size.pair.empty()) return options_.image_size;
    const Node& node = *reader_.find(mapping, size.pair);
    const Node* data = node.is_mapping() ? reader_.find(node, "data") : &node;
    if (data == nullptr || !data->is_sequence() || data->items.size() != 2) {
      reader_.say(node, Code::kOpencvSizeNotTwoNumbers, {size.pair});
      return std::nullopt;
    }
    const std::size_t width = size.rows_first ? 1 : 0;
    return reader_.image_size(data->items[width], data->items[1 - width], size.pair + " ");
  }

  /// MC-Calib: camera -> reference of its group.
  void read_map_pose(const CameraKeys& keys, const Node& map, const std::string& name, Rig& rig) {
    if (keys.pose.empty()) return;
    const Node& node = *reader_.find(map, keys.pose);
    const std::string what = label(keys, keys.pose);
    const std::optional<Numbers> values = read_numbers(node, what, reader_);
    if (!values) return;
    if (values->values.size() != 16 || values->rows != 4) {
      reader_.say(node, Code::kOpencvPoseNotFourByFour, {what, values->rows, values->cols});
      return;
    }
    Transform T;
    std::ranges::copy(values->values, T.values.begin());
    if (!reader_.checked(T, node, what)) return;
    warn_of_units(T, node, what);
    const Node* group = keys.group.empty() ? nullptr : reader_.find(map, keys.group);
    const std::optional<int> number = group == nullptr ? 0 : reader_.integer(*group, label(keys, keys.group));
    if (!number) return;
    rig.poses.push_back({*number == 0 ? "reference" : "reference" + std::to_string(*number), name, T});
  }

  void warn_of_units(const Transform& T, const Node& node, const std::string& what) {
    const double length = std::hypot(T(0, 3), T(1, 3), T(2, 3));
    constexpr double kLongerThanARig = 10.0;
    if (length > kLongerThanARig && !options_.length_unit_m) reader_.say(node, Code::kOpencvUnitsNotGiven, {what, length});
  }

  void read_stereo_pose(Rig& rig) {
    const bool has_rotation = !layout_.rotation.empty();
    const bool has_translation = !layout_.translation.empty();
    if (has_rotation != has_translation) {
      reader_.say(*reader_.find(document_.root(), has_rotation ? layout_.rotation : layout_.translation),
                  Code::kOpencvPoseMissing, {has_rotation ? "T" : "R"});
    }
    if (!has_rotation || !has_translation) return;
    const Node& R_node = *reader_.find(document_.root(), layout_.rotation);
    const Node& T_node = *reader_.find(document_.root(), layout_.translation);
    const std::optional<Numbers> R = read_numbers(R_node, layout_.rotation, reader_);
    const std::optional<Numbers> T = read_numbers(T_node, layout_.translation, reader_);
    if (!R || !T) return;
    const std::size_t wanted = layout_.rotation_vector ? 3 : 9;
    if (R->values.size() != wanted || (R_node.is_mapping() && !layout_.rotation_vector && R->rows != 3)) {
      reader_.say(R_node, layout_.rotation_vector ? Code::kOpencvNotRotationVector : Code::kOpencvNotRotationMatrix,
                  {layout_.rotation, R->rows, R->cols});
      return;
    }
    if (T->values.size() != 3) {
      reader_.say(T_node, Code::kNumbersWanted, {layout_.translation, T->values.size(), 3});
      return;
    }
    Transform T_c1_c0;
    if (layout_.rotation_vector) {
      if (!check_rotation_vector(*R, R_node)) return;
      set_rotation({R->values[0], R->values[1], R->values[2]}, T_c1_c0);
    } else {
      for (int i = 0; i < 9; ++i) {
        const int row = layout_.rotation_transposed ? i % 3 : i / 3;
        const int column = layout_.rotation_transposed ? i / 3 : i % 3;
        T_c1_c0(row, column) = R->values[static_cast<std::size_t>(i)];
      }
    }
    for (int row = 0; row < 3; ++row) T_c1_c0(row, 3) = T->values[static_cast<std::size_t>(row)];
    if (!reader_.checked(T_c1_c0, {R_node, layout_.rotation}, {T_node, layout_.translation})) return;
    warn_of_units(T_c1_c0, T_node, layout_.translation);
    rig.poses.push_back({"cam1", "cam0", T_c1_c0});
  }

  /// OpenCV's are at most half a turn; any angle is a rotation, but a far larger one is no radians.
  bool check_rotation_vector(const Numbers& om, const Node& node) {
    constexpr double kLargestAngle = 100.0;  // rad
    const double angle = std::hypot(om.values[0], om.values[1], om.values[2]);
    if (angle <= kLargestAngle) return true;
    reader_.say(node, Code::kOpencvAngleTooLarge, {layout_.rotation, angle});
    return false;
  }

  void read_count() {
    if (layout_.count.empty()) return;
    const Node& node = *reader_.find(document_.root(), layout_.count);
    if (node.value == std::to_string(layout_.cameras.size())) return;
    reader_.say(node, Code::kOpencvCameraCount, {layout_.count, node.value, layout_.cameras.size()});
  }

  /// A matrix says the same in every syntax.
  [[nodiscard]] std::string value_text(const Node& value) const {
    const Node* data = is_matrix(value) ? reader_.find(value, "data") : nullptr;
    const Node* rows = reader_.find(value, "rows");
    const Node* cols = reader_.find(value, "cols");
    if (data == nullptr || rows == nullptr || cols == nullptr) return fields::value_text(value);
    return rows->value + " x " + cols->value + " " + fields::value_text(*data);
  }

  /// What the file says and a Rig has no place for.
  void keep_unread(Rig& rig) const {
    const auto keep = [this, &rig](const Node& mapping, const std::vector<std::string>& known, const std::string& owner) {
      for (const text::Entry& entry : mapping.entries) {
        if (std::ranges::find(known, entry.key.value) == known.end())
          rig.extra_fields.push_back({owner, entry.key.value, value_text(entry.value)});
      }
    };
    std::vector<std::string> read = keys_of(layout_, "");
    if (rig.rectified) read.insert(read.end(), kRectificationKeys.begin(), kRectificationKeys.end());
    keep(document_.root(), read, "");
    for (const CameraKeys& keys : layout_.cameras) {
      if (!keys.map.empty()) keep(mapping_of(document_, keys), keys_of(layout_, keys.map), keys.map);
    }
  }

  const text::Document& document_;
  fields::Reader reader_;
  const Layout& layout_;
  const ReadOptions& options_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    const std::optional<Layout> layout = find_layout(document);
    if (!layout) {
      diagnostics.add(Code::kOpencvNoCalibration, {}, document.source().range({0, 1}));
      return std::nullopt;
    }
    Rig part;
    Diagnostics found;
    CalibrationReader(document, *layout, options, found).read_into(part);
    for (const Camera& camera : part.cameras) {
      if (rig.find_camera(camera.name) != nullptr)
        found.add(Code::kOpencvCameraTwice, {camera.name}, document.source().range({0, 1}));
    }
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (found.has_errors()) return std::nullopt;
    rig.cameras.insert(rig.cameras.end(), part.cameras.begin(), part.cameras.end());
    rig.poses.insert(rig.poses.end(), part.poses.begin(), part.poses.end());
    if (!rig.rectified) rig.rectified = part.rectified;
    rig.extra_fields.insert(rig.extra_fields.end(), part.extra_fields.begin(), part.extra_fields.end());
    rig.uncertainties.insert(rig.uncertainties.end(), part.uncertainties.begin(), part.uncertainties.end());
  }
  return rig;
}

}  // namespace fca::opencv
