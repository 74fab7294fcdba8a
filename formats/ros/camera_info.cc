// SPDX-License-Identifier: BSD-3-Clause
#include "camera_info.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::ros {

using text::Node;

bool Numbers::all_zero() const {
  return std::ranges::all_of(values, [](double value) { return value == 0.0; });
}

namespace {

/// What a Rig has members for; binning and roi are in its numbers, and as read beside them.
constexpr std::array<std::string_view, 8> kKeys = {"image_width", "image_height", "camera_name",  kMatrix,
                                                   kModel,        kCoefficients,  kRectification, kProjection};

/// The camera is that of the images that ROS publishes: whoever reads that binning is lost is not to apply it again.
std::string applied(std::string_view key) {
  const bool reduces = std::ranges::find(kReductionKeys, key) != kReductionKeys.end();
  return reduces ? " (applied)" : "";
}

class YamlFinder {
 public:
  explicit YamlFinder(fields::Reader& reader) : reader_(reader), root_(reader.document().root()) {}

  std::optional<CameraInfo> run() {
    reader_.warn_of_duplicates(root_);
    CameraInfo info;
    info.width = reader_.find(root_, "image_width");
    info.height = reader_.find(root_, "image_height");
    const Node* name = reader_.find(root_, "camera_name");
    if (name != nullptr) info.name = reader_.name(*name, "camera_name");
    info.model = reader_.find(root_, kModel);
    bool good = read_matrix(kMatrix, 3, 3, info.K);
    good = read_coefficients(info.D) && good;
    warn_of_missing(info);
    good = read_matrix(kRectification, 3, 3, info.R) && good;
    good = read_matrix(kProjection, 3, 4, info.P) && good;
    good = read_binning("binning_x", info.reduction.binning_x) && good;
    good = read_binning("binning_y", info.reduction.binning_y) && good;
    good = read_roi(info) && good;
    keep_unread(info);
    reader_.warn_of_misspelt();
    return good ? std::optional(info) : std::nullopt;
  }

 private:
  /// Without them a camera is known all the same: ROVIO, for one, reads such files.
  void warn_of_missing(const CameraInfo& info) {
    SourceRange where = reader_.document().range(root_);
    where.length = 1;
    Diagnostics& diagnostics = reader_.diagnostics();
    if (info.width == nullptr) diagnostics.add(Code::kRosKeyMissing, {"image_width"}, where);
    if (info.height == nullptr) diagnostics.add(Code::kRosKeyMissing, {"image_height"}, where);
    if (reader_.find(root_, kRectification) == nullptr) diagnostics.add(Code::kRosRectificationMissing, {}, where);
    if (reader_.find(root_, kProjection) == nullptr) diagnostics.add(Code::kRosProjectionMissing, {}, where);
  }

  std::optional<Numbers> numbers(const Node& node, std::string_view key, int& rows, int& columns) {
    if (!node.is_mapping()) {
      reader_.say(node, Code::kRosNotAMatrix, {key});
      return std::nullopt;
    }
    const std::optional<fields::Reader::Matrix> matrix = reader_.opencv_matrix(node, key);
    if (!matrix) return std::nullopt;
    rows = matrix->rows;
    columns = matrix->cols;
    Numbers result{&node, {}, matrix->values};
    for (const Node& item : reader_.find(node, "data")->items) result.nodes.push_back(&item);
    return result;
  }

  /// False with an error where something else stands under the key. A missing camera matrix is one, too.
  bool read_matrix(std::string_view key, int wanted_rows, int wanted_columns, std::optional<Numbers>& into) {
    const Node* node = key == kMatrix ? reader_.require(root_, key, "the file") : reader_.find(root_, key);
    if (node == nullptr) return key != kMatrix;
    int rows = 0;
    int columns = 0;
    into = numbers(*node, key, rows, columns);
    if (!into) return false;
    if (rows == wanted_rows && columns == wanted_columns) return true;
    reader_.say(*reader_.find(*node, rows != wanted_rows ? "rows" : "cols"), Code::kRosMatrixSize,
                {key, rows, columns, wanted_rows, wanted_columns});
    return false;
  }

  bool read_coefficients(std::optional<Numbers>& into) {
    const Node* node = reader_.require(root_, kCoefficients, "the file");
    if (node == nullptr) return false;
    const Node* data = node->is_mapping() ? reader_.find(*node, "data") : nullptr;
    const Node* cols = node->is_mapping() ? reader_.find(*node, "cols") : nullptr;
    if (data != nullptr && data->is_sequence() && data->items.empty() && cols != nullptr && cols->value == "0") {
      into = Numbers{node, {}, {}};  // ROS writes it of a camera that is not calibrated, or that has no distortion
      return true;
    }
    int rows = 0;
    int columns = 0;
    into = numbers(*node, kCoefficients, rows, columns);
    return into.has_value();
  }

  bool read_binning(std::string_view key, int& binning) {
    const Node* node = reader_.find(root_, key);
    if (node == nullptr) return true;
    const std::optional<int> value = reader_.integer(*node, key);
    if (!value) return false;
    constexpr int kLargest = 64;
    if (*value < 0 || *value > kLargest) {
      reader_.say(*node, Code::kRosBinningImpossible, {key, *value});
      return false;
    }
    binning = std::max(*value, 1);  // 0 is the same as 1
    return true;
  }

  bool read_roi(CameraInfo& info) {
    info.roi = reader_.find(root_, "roi");
    if (info.roi == nullptr) return true;
    if (!info.roi->is_mapping()) {
      reader_.say(*info.roi, Code::kRosRoiNoMapping);
      return false;
    }
    std::array<int, 4> values{};
    constexpr std::array<std::string_view, 4> kParts = {"x_offset", "y_offset", "width", "height"};
    for (std::size_t i = 0; i < kParts.size(); ++i) {
      const Node* node = reader_.require(*info.roi, kParts.at(i), "roi");
      const std::optional<int> value =
          node != nullptr ? reader_.integer(*node, "roi " + std::string(kParts.at(i))) : std::nullopt;
      if (!value) return false;
      if (*value < 0) {
        reader_.say(*node, Code::kRosRoiNegative, {kParts.at(i), *value});
        return false;
      }
      values.at(i) = *value;
    }
    if (values == std::array<int, 4>{}) return true;  // the whole image
    info.reduction.x = values[0];
    info.reduction.y = values[1];
    info.part = ImageSize{values[2], values[3]};
    return true;
  }

  void keep_unread(CameraInfo& info) {
    for (const text::Entry& entry : root_.entries) {
      if (std::ranges::find(kKeys, entry.key.value) == kKeys.end())
        info.extras.push_back({"", entry.key.value, fields::value_text(entry.value) + applied(entry.key.value)});
    }
  }

  fields::Reader& reader_;
  const Node& root_;
};

}  // namespace

std::optional<CameraInfo> find_in_yaml(fields::Reader& reader) { return YamlFinder(reader).run(); }

std::optional<std::vector<CameraInfo>> find_camera_infos(fields::Reader& reader) {
  if (reader.document().syntax() == text::Syntax::kWords) return find_in_ini(reader);
  if (!reader.document().root().is_mapping()) {
    reader.say(reader.document().root(), Code::kRosNoMapping);
    return std::nullopt;
  }
  std::optional<CameraInfo> info = find_in_yaml(reader);
  if (!info) return std::nullopt;
  return std::vector{*std::move(info)};
}

}  // namespace fca::ros
