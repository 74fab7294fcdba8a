// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "opencv.h"

#include "../fields.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>

namespace fca::opencv {

using text::Node;

namespace {

/// Numbers of a matrix or list, with their places.
struct Numbers {
  int rows = 0;
  int cols = 0;
  bool is_float = false;  ///< dt: f; OpenCV holds floats.
  std::vector<double> values;
  std::vector<const Node*> nodes;
  [[nodiscard]] bool is_vector() const { return rows <= 1 || cols <= 1; }
};

std::string size_of(const Numbers& numbers) { return std::to_string(numbers.rows) + " x " + std::to_string(numbers.cols); }

class CalibrationReader {
 public:
  CalibrationReader(const text::Document& document, const Layout& layout, const ReadOptions& options, Diagnostics& diagnostics)
      : document_(document), reader_(document, kDialect, diagnostics), layout_(layout), options_(options) {}

  void read_into(Rig& rig) {
    if (document_.syntax() == text::Syntax::kYaml) {
      reader_.warning(document_.root().entries.front().key, "program-refuses",
                      "the first line is not %YAML:1.0; cv::FileStorage does not open the file", "add that line");
    }
    warn_of_duplicates();
    for (std::size_t i = 0; i < layout_.cameras.size(); ++i) read_camera(layout_.cameras[i], "cam" + std::to_string(i), rig);
    read_count();
    read_stereo_pose(rig);
    keep_unread(rig);
  }

 private:
  static std::string label(const CameraKeys& keys, std::string_view key) {
    return (keys.map.empty() ? "" : keys.map + " ") + std::string(key);
  }

  void warn_of_duplicates() {
    for (const text::Entry& entry : document_.root().entries) {
      if (text::find_entry(document_.root(), entry.key.value, kDialect) != &entry)
        reader_.warning(entry.key, "duplicate-key", "the key " + entry.key.value + " stands twice; this one is not read");
    }
  }

  /// An opencv-matrix or a list. An error where neither stands.
  std::optional<Numbers> numbers(const Node& node, const std::string& what) {
    Numbers result;
    const Node* data = &node;
    if (node.is_mapping()) {
      const Node* type = reader_.require(node, "dt", what);
      if (type == nullptr || !is_float_type(*type, what)) return std::nullopt;
      result.is_float = type->value == "f";
      if (is_empty(node)) return result;
      const std::optional<fields::Reader::Matrix> matrix = reader_.opencv_matrix(node, what);
      if (!matrix) return std::nullopt;
      result.rows = matrix->rows;
      result.cols = matrix->cols;
      result.values = matrix->values;
      data = reader_.find(node, "data");
    } else {
      const std::optional<std::vector<double>> values = reader_.reals(node, 0, what);
      if (!values) return std::nullopt;
      result.rows = static_cast<int>(values->size());
      result.cols = 1;
      result.values = *values;
    }
    if (data->is_sequence()) {
      for (const Node& item : data->items) result.nodes.push_back(&item);
    } else {
      result.nodes.push_back(data);
    }
    if (result.is_float) {
      for (double& value : result.values) value = static_cast<float>(value);
    }
    return result;
  }

  bool is_float_type(const Node& type, const std::string& what) {
    if (type.value == "d" || type.value == "f") return true;
    if (type.value.ends_with('i') || type.value.ends_with('u') || type.value.ends_with('s') || type.value.ends_with('w')) {
      reader_.error(type, "matrix-type",
                    what + " holds dt '" + type.value + "', whole numbers; OpenCV's functions want floating-point numbers",
                    "write dt: d");
    } else {
      reader_.error(type, "matrix-type", what + " holds dt '" + type.value + "'; d (double) or f (float) is wanted");
    }
    return false;
  }

  /// cv::FileStorage's way to write an empty matrix.
  bool is_empty(const Node& matrix) {
    const Node* rows = reader_.find(matrix, "rows");
    const Node* cols = reader_.find(matrix, "cols");
    return (rows != nullptr && rows->value == "0") || (cols != nullptr && cols->value == "0");
  }

  bool set(const Numbers& from, std::size_t place, const std::string& what, std::string_view name, CameraModel& model) {
    if (!reader_.parameter(*from.nodes[place], what, name, model)) return false;
    return !from.is_float || set_parameter(model, name, from.values[place]);
  }

  void read_camera(const CameraKeys& keys, const std::string& name, Rig& rig) {
    const Node& map = mapping_of(document_, keys);
    const Node& K_node = *reader_.find(map, keys.matrix);
    const std::string K_label = label(keys, keys.matrix);
    std::optional<Numbers> K = numbers(K_node, K_label);
    if (K && !check_matrix(*K, K_node, K_label, keys.transposed)) K.reset();
    const std::optional<CameraModel> lens = read_lens(keys, map);
    if (!K || !lens) return;
    Camera camera;
    camera.name = name;
    camera.model = *lens;
    // Row-major, transposed in MATLAB.
    const std::size_t cx = keys.transposed ? 6 : 2;
    const std::size_t cy = keys.transposed ? 7 : 5;
    bool good = set(*K, 0, K_label, "fx", camera.model);
    good = set(*K, 4, K_label, "fy", camera.model) && good;
    good = set(*K, cx, K_label, "cx", camera.model) && good;
    good = set(*K, cy, K_label, "cy", camera.model) && good;
    good = check_skew(*K, keys, K_label, camera.model) && good;
    if (!good) return;
    camera.image_size = read_size(keys, map);
    read_map_pose(keys, map, name, rig);
    rig.cameras.push_back(std::move(camera));
  }

  bool check_matrix(const Numbers& K, const Node& node, const std::string& what, bool transposed) {
    if (K.rows != 3 || K.cols != 3) {
      reader_.error(node, "wrong-length", what + " is " + size_of(K) + "; a camera matrix is 3 x 3");
      return false;
    }
    const auto& k = K.values;
    const bool upper = k[2] != 0.0 || k[5] != 0.0;
    const bool lower = k[6] != 0.0 || k[7] != 0.0;
    if (!transposed && lower && !upper) {
      reader_.error(node, "matrix-transposed",
                    what + " is transposed: its principal point stands in the last row, as MATLAB writes it",
                    "OpenCV wants fx 0 cx, 0 fy cy, 0 0 1 row by row");
      return false;
    }
    if (transposed && upper && !lower) {
      reader_.error(node, "matrix-transposed", what + " stands beside MATLAB's keys and is not transposed as MATLAB's is",
                    "MATLAB writes fx 0 0, s fy 0, cx cy 1 row by row");
      return false;
    }
    const std::vector<std::size_t> zeros = transposed ? std::vector<std::size_t>{1, 2, 5} : std::vector<std::size_t>{3, 6, 7};
    for (const std::size_t place : zeros) {
      if (k[place] == 0.0) continue;
      reader_.error(*K.nodes[place], "not-a-camera-matrix",
                    what + " has " + text::format_short(k[place]) + " where a camera matrix has 0");
      return false;
    }
    if (k[8] != 1.0) {
      reader_.warning(*K.nodes[8], "matrix-corner",
                      what + "(2, 2) is " + text::format_short(k[8]) +
                          ", not 1; OpenCV's projections do not read it, but K * p and inv(K) come out wrong",
                      "write 1.0");
    }
    if (transposed) {
      reader_.warning(node, "matlab-origin",
                      what + " is MATLAB's, which counts pixels from 1; its principal point is read as it stands",
                      "if nothing has subtracted 1 from it yet (stereoParametersToOpenCV does), subtract 1 from both numbers");
    }
    return true;
  }

  /// None of our models has a skew: it must not vanish unsaid.
  bool check_skew(const Numbers& K, const CameraKeys& keys, const std::string& what, const CameraModel& model) {
    const std::size_t place = keys.transposed ? 3 : 1;
    const double skew = K.values[place];
    if (skew == 0.0) return true;
    const bool omnidir = kind_of(model) == Kind::kOmnidir;
    reader_.error(*K.nodes[place], "skew",
                  what + " has a skew of " + text::format_short(skew) + " px at (0, 1), which the model " +
                      std::string(model_info(model).id) + " cannot hold" +
                      (omnidir ? "; cv::omnidir uses it" : "; cv::projectPoints and cv::fisheye ignore it, others do not"),
                  omnidir ? "calibrate with cv::omnidir::CALIB_FIX_SKEW"
                          : "calibrate without skew, or write 0 there if the program that uses the file ignores it");
    return false;
  }

  /// The model with its distortion, the matrix still to be read.
  std::optional<CameraModel> read_lens(const CameraKeys& keys, const Node& map) {
    if (!keys.radial.empty()) return read_matlab_lens(keys, map);
    Numbers D;
    if (!keys.distortion.empty()) {
      const std::string what = label(keys, keys.distortion);
      const Node& node = *reader_.find(map, keys.distortion);
      std::optional<Numbers> read = numbers(node, what);
      if (!read) return std::nullopt;
      if (!read->is_vector()) {
        reader_.error(node, "wrong-length", what + " is " + size_of(*read) + "; a vector is wanted");
        return std::nullopt;
      }
      D = *std::move(read);
      if (!keys.xi.empty()) return read_omnidir(keys, map, node, D);
      return lens_of(keys, node, D);
    }
    if (!keys.xi.empty()) return read_omnidir(keys, map, *reader_.find(map, keys.xi), D);
    reader_.warning(*reader_.find(map, keys.matrix), "distortion-missing",
                    label(keys, keys.matrix) + " has no distortion coefficients beside it: read as a lens without distortion");
    return make_model("pinhole");
  }

  std::optional<CameraModel> with(std::string_view id, std::initializer_list<std::string_view> names, const Numbers& D,
                                  const std::string& what) {
    std::optional<CameraModel> model = make_model(id);
    std::size_t place = 0;
    for (const std::string_view name : names) {
      if (place < D.values.size() && !set(D, place++, what, name, *model)) return std::nullopt;
    }
    return model;
  }

  std::optional<CameraModel> lens_of(const CameraKeys& keys, const Node& node, const Numbers& D) {
    const std::string what = label(keys, keys.distortion);
    const std::size_t count = D.values.size();
    const std::optional<bool> said = fisheye_said(keys);
    if (count == 0) return make_model("pinhole");
    if (count == 4) {
      const std::optional<bool> fisheye = decide(said, node, what, D);
      if (!fisheye) return std::nullopt;
      if (*fisheye) return with("kb4", {"k1", "k2", "k3", "k4"}, D, what);
      return with("radtan", {"k1", "k2", "p1", "p2"}, D, what);
    }
    if (said.value_or(false) && count != 4) {
      reader_.error(node, "wrong-length",
                    what + " has " + std::to_string(count) + " numbers and the file says fisheye; cv::fisheye wants 4");
      return std::nullopt;
    }
    if (count != 5 && count != 8 && count != 12 && count != 14) {
      reader_.error(node, "wrong-length",
                    what + " has " + std::to_string(count) + " numbers; OpenCV knows vectors of 0, 4, 5, 8, 12 and 14");
      return std::nullopt;
    }
    if (!check_no_prism(what, D)) return std::nullopt;
    const auto all_zero = [&D](std::size_t from, std::size_t to) {
      return std::all_of(D.values.begin() + static_cast<std::ptrdiff_t>(from),
                         D.values.begin() + static_cast<std::ptrdiff_t>(to), [](double v) { return v == 0.0; });
    };
    if (all_zero(0, std::min<std::size_t>(count, 8))) return make_model("pinhole");
    if (count == 5 || (count > 8 && all_zero(5, 8))) return with("radtan", {"k1", "k2", "p1", "p2", "k3"}, D, what);
    return with("rational", {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"}, D, what);
  }

  /// s1..s4 and tau_x, tau_y: no model of ours has them.
  bool check_no_prism(const std::string& what, const Numbers& D) {
    constexpr std::array<std::string_view, 6> kTerms = {"s1", "s2", "s3", "s4", "tau_x", "tau_y"};
    std::string found;
    const Node* first = nullptr;
    for (std::size_t i = 8; i < D.values.size(); ++i) {
      if (D.values[i] == 0.0) continue;
      if (first == nullptr) first = D.nodes[i];
      found += (found.empty() ? "" : ", ") + std::string(kTerms.at(i - 8)) + " = " + text::format_short(D.values[i]);
    }
    if (found.empty()) return true;
    const bool tilt = D.values.size() > 12 && (D.values[12] != 0.0 || D.values[13] != 0.0);
    reader_.error(*first, tilt ? "tilted-sensor" : "thin-prism",
                  what + " has " + found + ": " + (tilt ? "a tilted sensor" : "thin-prism distortion") +
                      ", which none of our models can hold",
                  tilt ? "calibrate without CALIB_TILTED_MODEL" : "calibrate without CALIB_THIN_PRISM_MODEL");
    return false;
  }

  /// What the file says of a camera's four numbers.
  [[nodiscard]] std::optional<bool> fisheye_said(const CameraKeys& keys) const {
    if (keys.fisheye) return true;
    return keys.model.fisheye ? keys.model.fisheye : layout_.model.fisheye;
  }

  /// Are four numbers cv::fisheye's? Nothing, with an error, where nobody says.
  std::optional<bool> decide(std::optional<bool> said, const Node& node, const std::string& what, const Numbers& D) {
    if (!options_.opencv_model.empty()) {
      const bool fisheye = options_.opencv_model == "fisheye";
      if (said && *said != fisheye) {
        reader_.warning(node, "model-contradicts",
                        what + " is " + (*said ? "fisheye" : "pinhole") + " by the file and read as " + options_.opencv_model +
                            ", as told");
      }
      return fisheye;
    }
    if (said) return said;
    const auto spelled = [&D](std::initializer_list<const char*> names) {
      std::string text;
      std::size_t place = 0;
      for (const char* name : names) {
        if (place > 0) text += " ";
        text += std::string(name) + "=" + text::format_short(D.values[place]);
        ++place;
      }
      return text;
    };
    reader_.error(node, "ambiguous-model",
                  what + " has four numbers and nothing in the file says of what: pinhole " +
                      spelled({"k1", "k2", "p1", "p2"}) + " (cv::projectPoints), or fisheye " +
                      spelled({"k1", "k2", "k3", "k4"}) + " (cv::fisheye)",
                  "say which: --opencv-model pinhole or --opencv-model fisheye");
    return std::nullopt;
  }

  std::optional<CameraModel> read_omnidir(const CameraKeys& keys, const Node& map, const Node& place, const Numbers& D) {
    if (D.values.size() != 4) {
      reader_.error(place, "wrong-length",
                    label(keys, keys.xi) + " says cv::omnidir, which wants 4 distortion coefficients, not " +
                        std::to_string(D.values.size()));
      return std::nullopt;
    }
    const std::string what = label(keys, keys.xi);
    std::optional<CameraModel> model = with("mei", {"k1", "k2", "p1", "p2"}, D, label(keys, keys.distortion));
    const Node& node = *reader_.find(map, keys.xi);
    if (node.is_scalar()) {
      if (!model || !reader_.parameter(node, what, "xi", *model)) return std::nullopt;
      return model;
    }
    // The 1 x 1 matrix that cv::omnidir::calibrate returns.
    const std::optional<Numbers> xi = numbers(node, what);
    if (!xi || !model) return std::nullopt;
    if (xi->values.size() != 1) {
      reader_.error(node, "wrong-length", what + " has " + std::to_string(xi->values.size()) + " numbers; one is wanted");
      return std::nullopt;
    }
    if (!set(*xi, 0, what, "xi", *model)) return std::nullopt;
    return model;
  }

  std::optional<CameraModel> read_matlab_lens(const CameraKeys& keys, const Node& map) {
    const Node& node = *reader_.find(map, keys.radial);
    const std::optional<Numbers> radial = numbers(node, keys.radial);
    if (!radial) return std::nullopt;
    if (radial->values.size() != 2 && radial->values.size() != 3) {
      reader_.error(node, "wrong-length",
                    keys.radial + " has " + std::to_string(radial->values.size()) + " numbers; 2 or 3 are wanted");
      return std::nullopt;
    }
    std::optional<CameraModel> model = with("radtan", {"k1", "k2", "k3"}, *radial, keys.radial);
    if (!model || keys.tangential.empty()) return model;
    const Node& second = *reader_.find(map, keys.tangential);
    const std::optional<Numbers> tangential = numbers(second, keys.tangential);
    if (!tangential) return std::nullopt;
    if (tangential->values.size() != 2) {
      reader_.error(second, "wrong-length",
                    keys.tangential + " has " + std::to_string(tangential->values.size()) + " numbers; 2 are wanted");
      return std::nullopt;
    }
    if (!set(*tangential, 0, keys.tangential, "p1", *model) || !set(*tangential, 1, keys.tangential, "p2", *model))
      return std::nullopt;
    return model;
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
      reader_.error(node, "wrong-length", size.pair + " must be two numbers");
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
    const std::optional<Numbers> values = numbers(node, what);
    if (!values) return;
    if (values->values.size() != 16 || values->rows != 4) {
      reader_.error(node, "wrong-length", what + " is " + size_of(*values) + "; 4 x 4 is wanted");
      return;
    }
    Transform T;
    std::ranges::copy(values->values, T.values.begin());
    if (!reader_.checked(T, node, what)) return;
    warn_of_units(T, node, what);
    const Node* group = keys.group.empty() ? nullptr : reader_.find(map, keys.group);
    const bool first_group = group == nullptr || group->value == "0";
    rig.poses.push_back({first_group ? "reference" : "reference" + group->value, name, T});
  }

  void warn_of_units(const Transform& T, const Node& node, const std::string& what) {
    const double length = std::hypot(T(0, 3), T(1, 3), T(2, 3));
    constexpr double kLongerThanARig = 10.0;
    if (length <= kLongerThanARig) return;
    reader_.warning(
        node, "units-not-stated",
        what + " is " + text::format_short(length, 4) +
            " long, in the units of the calibration board, which no file states; read as metres, probably millimetres",
        "divide it by 1000 if they are millimetres");
  }

  void read_stereo_pose(Rig& rig) {
    const bool has_rotation = !layout_.rotation.empty();
    const bool has_translation = !layout_.translation.empty();
    if (has_rotation != has_translation) {
      reader_.warning(
          *reader_.find(document_.root(), has_rotation ? layout_.rotation : layout_.translation), "pose-missing",
          "the pose of the second camera needs R and T, and " + std::string(has_rotation ? "T" : "R") + " is missing");
    }
    if (!has_rotation || !has_translation) return;
    const Node& R_node = *reader_.find(document_.root(), layout_.rotation);
    const Node& T_node = *reader_.find(document_.root(), layout_.translation);
    const std::optional<Numbers> R = numbers(R_node, layout_.rotation);
    const std::optional<Numbers> T = numbers(T_node, layout_.translation);
    if (!R || !T) return;
    const std::size_t wanted = layout_.rotation_vector ? 3 : 9;
    if (R->values.size() != wanted || (R_node.is_mapping() && !layout_.rotation_vector && R->rows != 3)) {
      reader_.error(R_node, "wrong-length",
                    layout_.rotation + " is " + size_of(*R) + "; " +
                        (layout_.rotation_vector ? "a rotation vector of 3 numbers" : "a 3 x 3 rotation") + " is wanted");
      return;
    }
    if (T->values.size() != 3) {
      reader_.error(T_node, "wrong-length",
                    layout_.translation + " has " + std::to_string(T->values.size()) + " numbers; 3 are wanted");
      return;
    }
    Transform T_c1_c0;
    if (layout_.rotation_vector) {
      set_rotation(R->values, T_c1_c0);
    } else {
      for (int i = 0; i < 9; ++i) {
        const int row = layout_.rotation_transposed ? i % 3 : i / 3;
        const int column = layout_.rotation_transposed ? i / 3 : i % 3;
        T_c1_c0(row, column) = R->values[static_cast<std::size_t>(i)];
      }
    }
    for (int row = 0; row < 3; ++row) T_c1_c0(row, 3) = T->values[static_cast<std::size_t>(row)];
    if (!reader_.checked(T_c1_c0, R_node, layout_.rotation)) return;
    warn_of_units(T_c1_c0, T_node, layout_.translation);
    rig.poses.push_back({"cam1", "cam0", T_c1_c0});
  }

  /// Rodrigues' formula.
  static void set_rotation(const std::vector<double>& om, Transform& T) {
    const double angle = std::hypot(om[0], om[1], om[2]);
    if (angle == 0.0) return;
    const double axis[3] = {om[0] / angle, om[1] / angle, om[2] / angle};
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      T(i, i) = c + (1.0 - c) * axis[i] * axis[i];
      T(i, j) = (1.0 - c) * axis[i] * axis[j] - s * axis[k];
      T(i, k) = (1.0 - c) * axis[i] * axis[k] + s * axis[j];
    }
  }

  void read_count() {
    if (layout_.count.empty()) return;
    const Node& node = *reader_.find(document_.root(), layout_.count);
    if (node.value == std::to_string(layout_.cameras.size())) return;
    reader_.warning(node, "program-refuses",
                    layout_.count + " is " + node.value + ", but there are " + std::to_string(layout_.cameras.size()) +
                        " cameras; MC-Calib's reader stops");
  }

  /// What the file says and a Rig has no place for.
  void keep_unread(Rig& rig) const {
    const auto keep = [&rig](const Node& mapping, const std::vector<std::string>& known, const std::string& owner) {
      for (const text::Entry& entry : mapping.entries) {
        if (std::ranges::find(known, entry.key.value) == known.end())
          rig.as_read.push_back({owner + entry.key.value, entry.value.value});
      }
    };
    keep(document_.root(), keys_of(layout_, ""), "");
    for (const CameraKeys& keys : layout_.cameras) {
      if (!keys.map.empty()) keep(mapping_of(document_, keys), keys_of(layout_, keys.map), keys.map + " ");
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
      diagnostics.error(
          "no-calibration", "no 3 x 3 camera matrix under a usual key (camera_matrix, M1, K1, camera_0 ...) stands here",
          document.source().range({0, 1}), "OpenCV's calibration samples write camera_matrix and distortion_coefficients");
      return std::nullopt;
    }
    Rig part;
    Diagnostics found;
    CalibrationReader(document, *layout, options, found).read_into(part);
    for (const Camera& camera : part.cameras) {
      if (rig.find_camera(camera.name) != nullptr)
        found.error("stated-twice", "a camera " + camera.name + " stands here and in the file before",
                    document.source().range({0, 1}));
    }
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (found.has_errors()) return std::nullopt;
    rig.cameras.insert(rig.cameras.end(), part.cameras.begin(), part.cameras.end());
    rig.poses.insert(rig.poses.end(), part.poses.begin(), part.poses.end());
    rig.as_read.insert(rig.as_read.end(), part.as_read.begin(), part.as_read.end());
  }
  return rig;
}

}  // namespace fca::opencv
