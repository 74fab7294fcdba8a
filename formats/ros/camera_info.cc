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

/// Under which keys the numbers stand.
struct Keys {
  std::string_view width;
  std::string_view height;
  std::string_view K;
  std::string_view D;
  std::string_view R;
  std::string_view P;
  bool is_message = false;  ///< Matrices are plain lists; the camera's name is the frame of the header.
};

constexpr Keys kFile = {"image_width", "image_height", kMatrix, kCoefficients, kRectification, kProjection};
/// A sensor_msgs/CameraInfo as `rostopic echo` and `ros2 topic echo` print it.
constexpr Keys kMessageOfRos1 = {"width", "height", "K", "D", "R", "P", true};
constexpr Keys kMessageOfRos2 = {"width", "height", "k", "d", "r", "p", true};

bool has_lists(const text::Document& document, const Keys& keys) {
  const Node& root = document.root();
  const auto has = [&root](std::string_view key) { return text::find(root, key, kDialect) != nullptr; };
  const auto is_list = [&root](std::string_view key) {
    const Node* node = text::find(root, key, kDialect);
    return node != nullptr && node->is_sequence() && std::ranges::all_of(node->items, &Node::is_scalar);
  };
  return root.is_mapping() && !has(kMatrix) && has(keys.width) && has(keys.height) && is_list(keys.K) && is_list(keys.D) &&
         is_list(keys.P);
}

const Keys& keys_of(const text::Document& document) {
  if (has_lists(document, kMessageOfRos1)) return kMessageOfRos1;
  return has_lists(document, kMessageOfRos2) ? kMessageOfRos2 : kFile;
}

/// The camera is that of the images that ROS publishes: whoever reads that binning is lost is not to apply it again.
std::string applied(std::string_view key) {
  const bool reduces = std::ranges::find(kReductionKeys, key) != kReductionKeys.end();
  return reduces ? " (applied)" : "";
}

class YamlFinder {
 public:
  explicit YamlFinder(fields::Reader& reader)
      : reader_(reader), root_(reader.document().root()), keys_(keys_of(reader.document())) {}

  std::optional<CameraInfo> run() {
    reader_.warn_of_duplicates(root_);
    CameraInfo info;
    info.width = reader_.find(root_, keys_.width);
    info.height = reader_.find(root_, keys_.height);
    read_name(info);
    info.model = reader_.find(root_, kModel);
    bool good = read_matrix(keys_.K, 3, 3, info.K);
    good = read_coefficients(info.D) && good;
    warn_of_missing(info);
    good = read_matrix(keys_.R, 3, 3, info.R) && good;
    good = read_matrix(keys_.P, 3, 4, info.P) && good;
    good = read_binning("binning_x", info.reduction.binning_x) && good;
    good = read_binning("binning_y", info.reduction.binning_y) && good;
    good = read_roi(info) && good;
    keep_unread(info);
    reader_.warn_of_misspelt();
    return good ? std::optional(info) : std::nullopt;
  }

 private:
  void read_name(CameraInfo& info) {
    const Node* header = keys_.is_message ? reader_.find(root_, "header") : &root_;
    const std::string_view key = keys_.is_message ? "frame_id" : "camera_name";
    const Node* name = header != nullptr && header->is_mapping() ? reader_.find(*header, key) : nullptr;
    if (name != nullptr) info.name = reader_.name(*name, key);
  }

  /// Without them a camera is known all the same: ROVIO, for one, reads such files.
  void warn_of_missing(const CameraInfo& info) {
    SourceRange where = reader_.document().range(root_);
    where.length = 1;
    Diagnostics& diagnostics = reader_.diagnostics();
    if (info.width == nullptr) diagnostics.add(Code::kRosKeyMissing, {keys_.width}, where);
    if (info.height == nullptr) diagnostics.add(Code::kRosKeyMissing, {keys_.height}, where);
    if (reader_.find(root_, keys_.R) == nullptr) diagnostics.add(Code::kRosRectificationMissing, {}, where);
    if (reader_.find(root_, keys_.P) == nullptr) diagnostics.add(Code::kRosProjectionMissing, {}, where);
  }

  /// The numbers of a list.
  std::optional<Numbers> listed(const Node& node, std::string_view key) {
    Numbers result{&node, {}, {}};
    for (const Node& item : node.items) {
      const std::optional<double> value = reader_.real(item, key);
      if (!value) return std::nullopt;
      result.nodes.push_back(&item);
      result.values.push_back(*value);
    }
    return result;
  }

  /// `rows` and `columns`: what is wanted, and then what is there.
  std::optional<Numbers> numbers(const Node& node, std::string_view key, int& rows, int& columns) {
    if (keys_.is_message && node.is_sequence()) {
      std::optional<Numbers> result = listed(node, key);
      const int count = static_cast<int>(node.items.size());
      if (count != rows * columns) rows = 1, columns = count;
      return result;
    }
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
    const bool needed = key == keys_.K;
    const Node* node = needed ? reader_.require(root_, key, "the file") : reader_.find(root_, key);
    if (node == nullptr) return !needed;
    int rows = wanted_rows;
    int columns = wanted_columns;
    into = numbers(*node, key, rows, columns);
    if (!into) return false;
    if (rows == wanted_rows && columns == wanted_columns) return true;
    const Node& place = keys_.is_message ? *node : *reader_.find(*node, rows != wanted_rows ? "rows" : "cols");
    reader_.say(place, Code::kRosMatrixSize, {key, rows, columns, wanted_rows, wanted_columns});
    return false;
  }

  bool read_coefficients(std::optional<Numbers>& into) {
    const Node* node = reader_.require(root_, keys_.D, "the file");
    if (node == nullptr) return false;
    const Node* data = node->is_mapping() ? reader_.find(*node, "data") : nullptr;
    const Node* cols = node->is_mapping() ? reader_.find(*node, "cols") : nullptr;
    if (data != nullptr && data->is_sequence() && data->items.empty() && cols != nullptr && cols->value == "0") {
      into = Numbers{node, {}, {}};  // ROS writes it of a camera that is not calibrated, or that has no distortion
      return true;
    }
    int rows = 0;
    int columns = 0;
    into = numbers(*node, keys_.D, rows, columns);
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

  /// Has a Rig members for it? Binning and roi are in its numbers, and as read next to them.
  [[nodiscard]] bool is_read(std::string_view key) const {
    const std::array<std::string_view, 8> known = {
        keys_.width, keys_.height, keys_.K, keys_.D, keys_.R, keys_.P, kModel, keys_.is_message ? "header" : "camera_name"};
    return std::ranges::find(known, key) != known.end();
  }

  void keep_unread(CameraInfo& info) {
    for (const text::Entry& entry : root_.entries) {
      if (!is_read(entry.key.value))
        info.extras.push_back({"", entry.key.value, fields::value_text(entry.value) + applied(entry.key.value)});
    }
  }

  fields::Reader& reader_;
  const Node& root_;
  const Keys& keys_;
};

}  // namespace

bool is_message(const text::Document& document) { return keys_of(document).is_message; }

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
