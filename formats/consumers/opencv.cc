// SPDX-License-Identifier: BSD-3-Clause
// Programs around OpenCV's calibration functions. There is no schema; these are the keys that OpenCV's samples
// (calibration.cpp and camera_calibration.cpp of 2.x to 4.x, stereo_calib.cpp, ccalib's omni_calibration.cpp and
// omni_stereo_calibration.cpp) and MC-Calib write and their counterparts read, through cv::FileStorage itself, then handed to
// cv::projectPoints, cv::fisheye::projectPoints or cv::omnidir::projectPoints (opencv_formulas.h) with what those assert.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "storage.h"

namespace fca::consumers {
namespace opencv {
namespace {

using storage::is_number;

using Names = std::array<const char*, 3>;

/// The keys of one camera; null ends a list of spellings.
struct CameraKeys {
  const char* matrix;
  Names distortion;
  const char* xi = nullptr;
};

/// The keys of one or two cameras in a file. The first family whose matrix is there is read.
struct Family {
  CameraKeys first;
  std::optional<CameraKeys> second;
};

const std::array<Family, 6>& families() {
  static const std::array<Family, 6> kFamilies = {{
      {{"camera_matrix", {"distortion_coefficients", "dist_coeffs", "distortion_coeffs"}, "xi"}, std::nullopt},
      {{"Camera_Matrix", {"Distortion_Coefficients"}}, std::nullopt},
      {{"M1", {"D1"}}, CameraKeys{"M2", {"D2"}}},
      {{"K1", {"D1"}}, CameraKeys{"K2", {"D2"}}},
      {{"camera_matrix_1", {"distortion_coefficients_1"}, "xi_1"},
       CameraKeys{"camera_matrix_2", {"distortion_coefficients_2"}, "xi_2"}},
      {{"camera_matrix_left", {"dist_coeffs_left", "distortion_coeffs_left", "distortion_coefficients_left"}},
       CameraKeys{"camera_matrix_right", {"dist_coeffs_right", "distortion_coeffs_right", "distortion_coefficients_right"}}},
  }};
  return kFamilies;
}

constexpr std::array<std::pair<const char*, const char*>, 3> kSizeKeys = {
    {{"image_width", "image_height"}, {"image_Width", "image_Height"}, {"img_width", "img_height"}}};
constexpr std::array<const char*, 3> kSizePairKeys = {"imageSize", "image_size", "resolution"};

enum class Function { kPinhole, kFisheye, kOmnidir };

std::string_view name_of(Function function) {
  switch (function) {
    case Function::kFisheye:
      return "cv::fisheye";
    case Function::kOmnidir:
      return "cv::omnidir";
    case Function::kPinhole:
      break;
  }
  return "cv::projectPoints";
}

std::optional<Pixel> finite_pixel(const Pixel& pixel) {
  if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
  return pixel;
}

bool is_real(const cv::Mat& matrix) { return matrix.depth() == CV_64F || matrix.depth() == CV_32F; }

/// The elements in file order, as doubles; a float stays the float that OpenCV reads.
std::vector<double> values_of(const cv::Mat& matrix) {
  cv::Mat converted;
  matrix.reshape(1, 1).convertTo(converted, CV_64F);
  return {converted.begin<double>(), converted.end<double>()};
}

class Reader {
 public:
  Reader(const cv::FileStorage& storage, const LoadOptions& options, ConsumerView& view)
      : storage_(storage), options_(options), view_(view) {}

  void run() {
    if (!node("camera_0").empty()) {
      read_mc_calib();
      return;
    }
    const Family* found = nullptr;
    for (const Family& family : families()) {
      if (node(family.first.matrix).empty()) continue;
      if (found == nullptr) {
        found = &family;
      } else {
        warn(Code::kCvOtherMatrixFirst, family.first.matrix, {found->first.matrix});
      }
    }
    if (found == nullptr) {
      view_.finds_no_camera = true;
      view_.refusals.emplace_back(Code::kCvNoCameraMatrix, "");
      return;
    }
    read_family(*found);
  }

 private:
  /// Of what stands under `name`, "camera_0.camera_matrix": argument 0, `more` follow.
  static Complaint complaint(Code code, std::string name, std::vector<Argument> more) {
    more.insert(more.begin(), name);
    std::replace(name.begin(), name.end(), '.', '/');
    return {code, std::move(name), std::move(more)};
  }
  void refuse(Code code, const std::string& name, std::vector<Argument> more = {}) {
    view_.refusals.push_back(complaint(code, name, std::move(more)));
  }
  void warn(Code code, const std::string& name, std::vector<Argument> more = {}) {
    view_.warnings.push_back(complaint(code, name, std::move(more)));
  }
  [[nodiscard]] cv::FileNode node(const std::string& key) const { return storage_[key]; }

  /// fs[key] >> Mat.
  std::optional<cv::Mat> matrix(const cv::FileNode& found, const std::string& name) {
    if (!found.isMap()) {
      refuse(Code::kCvNoMatrix, name);
      return std::nullopt;
    }
    try {
      return storage::read_matrix(found);
    } catch (const cv::Exception& error) {
      refuse(Code::kCvUnreadableMatrix, name, {storage::fault_of(error)});
    }
    return std::nullopt;
  }

  std::optional<CameraMatrix> camera_matrix(const cv::FileNode& found, const std::string& name) {
    const std::optional<cv::Mat> K = matrix(found, name);
    if (!K) return std::nullopt;
    if (K->rows != 3 || K->cols != 3 || K->channels() != 1 || !is_real(*K)) {
      std::vector<Message> not_real;
      if (!is_real(*K)) not_real = {{Code::kCvNotReal}};
      refuse(Code::kCvCameraMatrixSize, name, {K->rows, K->cols, not_real});
      return std::nullopt;
    }
    const std::vector<double> k = values_of(*K);
    if (k[1] == 0.0 && (k[3] != 0.0 || k[6] != 0.0)) warn(Code::kCvMatrixTransposed, name);
    return CameraMatrix{k[0], k[4], k[2], k[5], k[1]};
  }

  /// A vector of 4, 5, 8, 12 or 14 numbers, or none.
  std::optional<std::vector<double>> distortion(const cv::FileNode& found, const std::string& name) {
    const std::optional<cv::Mat> D = matrix(found, name);
    if (!D) return std::nullopt;
    if (D->empty()) return std::vector<double>();
    constexpr std::array<std::size_t, 5> kLengths = {4, 5, 8, 12, 14};
    const std::size_t length = D->total() * static_cast<std::size_t>(D->channels());
    const bool is_vector = D->rows == 1 || D->cols == 1;
    if (!is_vector || !is_real(*D) || std::find(kLengths.begin(), kLengths.end(), length) == kLengths.end()) {
      refuse(Code::kCvDistortionSize, name, {D->rows, D->cols});
      return std::nullopt;
    }
    return values_of(*D);
  }

  /// The first of the camera's keys of coefficients that stands there; else the usual one.
  const char* distortion_key(const CameraKeys& keys) {
    for (const char* name : keys.distortion) {
      if (name != nullptr && !node(name).empty()) return name;
    }
    return keys.distortion.front();
  }

  std::optional<std::vector<double>> distortion_of(const CameraKeys& keys) {
    const char* name = distortion_key(keys);
    if (!node(name).empty()) return distortion(node(name), name);
    warn(Code::kCvDistortionMissing, name);
    return std::vector<double>();
  }

  /// Nothing: the file does not say. Settings of a surround view say it by their other keys: its program calls cv::fisheye.
  std::optional<bool> says_fisheye() {
    const cv::FileNode flag = node("fisheye_model");
    if (is_number(flag)) return static_cast<int>(flag) != 0;
    if (!node("project_matrix").empty() && (!node("scale_xy").empty() || !node("shift_xy").empty())) return true;
    return std::nullopt;
  }

  /// cv::FileNode's conversion of "width" and "height", or a pair; 0 where the file does not say.
  std::array<int, 2> image_size(const cv::FileNode& map) {
    const auto at = [&](const char* key) { return map.isMap() ? map[key] : node(key); };
    for (const auto& [width, height] : kSizeKeys) {
      if (at(width).isNone() || at(height).isNone()) continue;
      if (is_number(at(width)) && is_number(at(height))) return {static_cast<int>(at(width)), static_cast<int>(at(height))};
    }
    for (const char* key : kSizePairKeys) {
      const cv::FileNode pair = at(key);
      if (pair.isSeq() && pair.size() == 2 && is_number(pair[0]) && is_number(pair[1]))
        return {static_cast<int>(pair[0]), static_cast<int>(pair[1])};
    }
    return {0, 0};
  }

  /// Which function a program calls: the caller's word, then the file's, then the length of the vector, then pinhole. Of
  /// vectors that are not of four numbers the caller has nothing to say.
  Function choose(std::size_t length, std::optional<bool> file_says_fisheye, const std::string& name) {
    constexpr std::size_t kAmbiguous = 4;
    const bool told = options_.opencv_model && length == kAmbiguous;
    if (told) {
      const bool fisheye = options_.opencv_model == OpenCvModel::kFisheye;
      if (file_says_fisheye && *file_says_fisheye != fisheye)
        warn(Code::kCvGivenOtherwise, name, {*file_says_fisheye ? "fisheye" : "pinhole", name_of(*options_.opencv_model)});
      return fisheye ? Function::kFisheye : Function::kPinhole;
    }
    if (file_says_fisheye) return *file_says_fisheye ? Function::kFisheye : Function::kPinhole;
    if (length == kAmbiguous) warn(Code::kCvFourNumbers, name);
    return Function::kPinhole;
  }

  void add_camera(const CameraMatrix& K, const std::vector<double>& D, Function function, double xi, std::array<int, 2> size,
                  const std::string& name) {
    if (function != Function::kPinhole && D.size() != 4) {
      refuse(Code::kCvCoefficientsNotFour, name, {D.size(), name_of(function)});
      return;
    }
    ConsumerCamera camera;
    camera.name = "cam" + std::to_string(view_.cameras.size());
    camera.width = size[0];
    camera.height = size[1];
    camera.model = name_of(function);
    if (function == Function::kPinhole) {
      PinholeCoefficients k{};
      std::copy(D.begin(), D.end(), k.begin());
      camera.project = [K, k](const Ray& ray) { return finite_pixel(project_points(K, k, ray)); };
    } else {
      std::array<double, 4> k{};
      std::copy(D.begin(), D.end(), k.begin());
      if (function == Function::kFisheye) {
        camera.project = [K, k](const Ray& ray) { return finite_pixel(fisheye_project_points(K, k, ray)); };
        camera.unproject = [K, k](const Pixel& pixel) { return std::optional(fisheye_undistort_points(K, k, pixel)); };
        camera.unproject_fault = {Code::kRaysUpToNinety};
      } else {
        camera.project = [K, xi, k](const Ray& ray) { return finite_pixel(omnidir_project_points(K, xi, k, ray)); };
      }
    }
    if (function != Function::kOmnidir && K.skew != 0.0) {
      // At the upper or lower edge of the image; distortion aside.
      const double edge = std::max(std::abs(K.cy), std::abs(size[1] - 1 - K.cy)) / std::abs(K.fy);
      warn(Code::kCvSkewUnused, name,
           {K.skew, function == Function::kPinhole ? "cv::projectPoints" : "cv::fisheye::projectPoints",
            std::round(100.0 * edge * std::abs(K.skew)) / 100.0});
      camera.misread = true;
    }
    view_.cameras.push_back(std::move(camera));
  }

  void read_camera(const CameraKeys& keys) {
    if (node(keys.matrix).empty()) {
      refuse(Code::kCvPairIncomplete, keys.matrix);
      return;
    }
    const std::optional<CameraMatrix> K = camera_matrix(node(keys.matrix), keys.matrix);
    const std::optional<std::vector<double>> D = distortion_of(keys);
    if (!K || !D) return;
    const std::array<int, 2> size = image_size(cv::FileNode());
    const cv::FileNode xi = keys.xi == nullptr ? cv::FileNode() : node(keys.xi);
    if (!xi.empty()) {
      if (const std::optional<double> value = mei_parameter(xi, keys.xi))
        add_camera(*K, *D, Function::kOmnidir, *value, size, keys.matrix);
      return;
    }
    add_camera(*K, *D, choose(D->size(), says_fisheye(), distortion_key(keys)), 0.0, size, keys.matrix);
  }

  /// A number; some write the 1 x 1 matrix that cv::omnidir::calibrate returned.
  std::optional<double> mei_parameter(const cv::FileNode& xi, const std::string& name) {
    if (options_.opencv_model) warn(Code::kCvOmnidirMeant, name, {name_of(*options_.opencv_model)});
    if (is_number(xi)) return static_cast<double>(xi);
    if (xi.isMap()) {
      const std::optional<cv::Mat> value = matrix(xi, name);
      if (value && value->total() == 1 && is_real(*value)) return values_of(*value).front();
    }
    refuse(Code::kCvXiNoNumber, name);
    return std::nullopt;
  }

  void read_family(const Family& family) {
    read_camera(family.first);
    if (!family.second) return;
    read_camera(*family.second);
    read_stereo();
  }

  /// Three numbers: a matrix or a plain list (cv::Vec3d reads that).
  std::optional<std::array<double, 3>> vector3(const std::string& name) {
    const cv::FileNode found = node(name);
    std::vector<double> values;
    if (found.isSeq()) {
      for (const cv::FileNode& item : found) values.push_back(is_number(item) ? static_cast<double>(item) : std::nan(""));
    } else if (const std::optional<cv::Mat> read = matrix(found, name)) {
      if (is_real(*read)) values = values_of(*read);
    } else {
      return std::nullopt;
    }
    if (values.size() == 3) return std::array<double, 3>{values[0], values[1], values[2]};
    refuse(Code::kCvNoVector, name);
    return std::nullopt;
  }

  /// stereoCalibrate: p_2 = R p_1 + T. omni_stereo_calibration writes a rotation vector, om.
  void read_stereo() {
    const bool has_rotation = !node("R").empty() || !node("om").empty();
    const bool has_translation = !node("T").empty();
    if (!has_rotation && !has_translation) return;
    if (!has_rotation || !has_translation) {
      refuse(Code::kCvHalfAPose, has_rotation ? "T" : "R", {has_rotation ? "R" : "T"});
      return;
    }
    std::optional<Matrix3> R;
    if (!node("R").empty()) {
      const std::optional<cv::Mat> read = matrix(node("R"), "R");
      if (read && read->rows == 3 && read->cols == 3 && read->channels() == 1 && is_real(*read)) {
        R.emplace();
        const std::vector<double> values = values_of(*read);
        std::copy(values.begin(), values.end(), R->begin());
      } else if (read && read->rows == 3 && read->cols == 1 && read->channels() == 1 && is_real(*read)) {
        const std::vector<double> vector = values_of(*read);  // cv::stereoRectify takes a rotation vector, too
        R = rotation_of({vector[0], vector[1], vector[2]});
      } else if (read) {
        refuse(Code::kCvRotationSize, "R", {read->rows, read->cols});
      }
    } else if (const auto om = vector3("om")) {
      R = rotation_of(*om);
    }
    const auto T = vector3("T");
    if (!R || !T) return;
    ConsumerPose pose{"cam1", "cam0", {}};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t col = 0; col < 3; ++col) pose.T_a_b.at(4 * row + col) = R->at(3 * row + col);
      pose.T_a_b.at(4 * row + 3) = T->at(row);
    }
    pose.T_a_b.back() = 1.0;
    view_.poses.push_back(pose);
  }

  /// MC-Calib: one map per camera; camera_pose_matrix takes points of the camera to those of the reference camera.
  void read_mc_calib() {
    std::vector<std::optional<std::array<double, 16>>> poses;
    int count = 0;
    for (; !node("camera_" + std::to_string(count)).empty() && view_.loads(); ++count) {
      const std::string name = "camera_" + std::to_string(count);
      poses.push_back(read_mc_calib_camera(node(name), name));
    }
    const cv::FileNode declared = node("nb_camera");
    // A number in quotes is none to cv::FileStorage, and read as INT_MAX.
    const bool number = declared.isInt() || declared.isReal();
    const int announced = number ? static_cast<int>(declared) : std::numeric_limits<int>::max();
    if (!declared.empty() && announced != count && view_.loads()) {
      refuse(Code::kCvCameraCount, "nb_camera", {announced, count});
    }
    for (std::size_t i = 1; i < poses.size(); ++i) {
      if (poses[0] && poses[i]) view_.poses.push_back({"cam0", "cam" + std::to_string(i), relative(*poses[0], *poses[i])});
    }
  }

  /// inverse(T_r_0) T_r_i of rigid transforms.
  static std::array<double, 16> relative(const std::array<double, 16>& T_r_0, const std::array<double, 16>& T_r_i) {
    std::array<double, 16> result{};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t col = 0; col < 4; ++col) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
          sum += T_r_0.at(4 * i + row) * (T_r_i.at(4 * i + col) - (col == 3 ? T_r_0.at(4 * i + 3) : 0.0));
        result.at(4 * row + col) = sum;
      }
    }
    result.back() = 1.0;
    return result;
  }

  std::optional<std::array<double, 16>> read_mc_calib_camera(const cv::FileNode& map, const std::string& name) {
    if (!map.isMap()) {
      refuse(Code::kCvNoMap, name);
      return std::nullopt;
    }
    for (const char* key : {"camera_matrix", "distortion_vector"}) {
      if (!map[key].empty()) continue;
      refuse(Code::kCvKeyMissing, name + "." + key);
      return std::nullopt;
    }
    const std::optional<CameraMatrix> K = camera_matrix(map["camera_matrix"], name + ".camera_matrix");
    const std::optional<std::vector<double>> D = distortion(map["distortion_vector"], name + ".distortion_vector");
    if (!K || !D) return std::nullopt;
    const cv::FileNode type = map["distortion_type"];
    std::optional<bool> fisheye;
    if (is_number(type)) fisheye = static_cast<int>(type) == 1;
    add_camera(*K, *D, choose(D->size(), fisheye, name + ".distortion_vector"), 0.0, image_size(map), name);
    const cv::FileNode pose = map["camera_pose_matrix"];
    if (pose.empty()) return std::nullopt;
    const std::optional<cv::Mat> T = matrix(pose, name + ".camera_pose_matrix");
    if (!T) return std::nullopt;
    if (T->rows != 4 || T->cols != 4 || T->channels() != 1 || !is_real(*T)) {
      refuse(Code::kCvPoseSize, name + ".camera_pose_matrix", {T->rows, T->cols});
      return std::nullopt;
    }
    const std::vector<double> values = values_of(*T);
    std::array<double, 16> result{};
    std::copy(values.begin(), values.end(), result.begin());
    return result;
  }

  const cv::FileStorage& storage_;
  const LoadOptions& options_;
  ConsumerView& view_;
};

}  // namespace
}  // namespace opencv

ConsumerView load_opencv(std::string_view bytes, const LoadOptions& options) {
  return storage::read(bytes, "OpenCV", "cv::FileStorage", [&options](const cv::FileStorage& file, ConsumerView& view) {
    opencv::Reader(file, options, view).run();
  });
}

}  // namespace fca::consumers
