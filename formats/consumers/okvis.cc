// SPDX-License-Identifier: BSD-3-Clause
// OKVIS2 (ethz-mrl/okvis2@a2ea006 of 2025-08, ViParametersReader.cpp), OKVIS2-X (luohongk/OKVIS2-X@d14f9fc of 2026-04) and
// OKVIS (ethz-asl/okvis@16181c8, VioParametersReader.cpp) as consumers of their configurations, through cv::FileStorage.
//
// One incomplete entry among the cameras, and none is used: the program stops. A camera whose distortion it does not know is
// left out. Of the coefficients those of the distortion are read, whatever follows. Numbers that tune it must have a point
// where it wants reals, and none where it wants ints. Rays from behind a pinhole give a pixel, and the status that it is none;
// those of OKVIS2-X's EUCM are not asked where they come from.
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include <opencv2/core.hpp>

#include "about_key.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "storage.h"

namespace fca::consumers {
namespace {

using Projection = std::function<std::optional<std::array<double, 2>>(const std::array<double, 3>&)>;

enum class Type { kReal, kInt, kBoolean, kList };

/// A key without which the program stops.
struct Wanted {
  const char* path;
  Type type;
  std::size_t count = 0;  ///< kList: of its numbers; 0: any.
};

constexpr Wanted kOkvis2[] = {
    {"camera_parameters/timestamp_tolerance", Type::kReal},
    {"camera_parameters/sync_cameras", Type::kList},
    {"camera_parameters/image_delay", Type::kReal},
    {"camera_parameters/online_calibration/do_extrinsics", Type::kBoolean},
    {"camera_parameters/online_calibration/do_extrinsics_final_ba", Type::kBoolean},
    {"camera_parameters/online_calibration/sigma_r", Type::kReal},
    {"camera_parameters/online_calibration/sigma_alpha", Type::kReal},
    {"camera_parameters/online_calibration/sigma_r_final_ba", Type::kReal},
    {"camera_parameters/online_calibration/sigma_alpha_final_ba", Type::kReal},
    {"imu_parameters/use", Type::kBoolean},
    {"imu_parameters/T_BS", Type::kList, 16},
    {"imu_parameters/a_max", Type::kReal},
    {"imu_parameters/g_max", Type::kReal},
    {"imu_parameters/sigma_g_c", Type::kReal},
    {"imu_parameters/sigma_bg", Type::kReal},
    {"imu_parameters/sigma_a_c", Type::kReal},
    {"imu_parameters/sigma_ba", Type::kReal},
    {"imu_parameters/sigma_gw_c", Type::kReal},
    {"imu_parameters/sigma_aw_c", Type::kReal},
    {"imu_parameters/a0", Type::kList, 3},
    {"imu_parameters/g0", Type::kList, 3},
    {"imu_parameters/g", Type::kReal},
    {"frontend_parameters/detection_threshold", Type::kReal},
    {"frontend_parameters/absolute_threshold", Type::kReal},
    {"frontend_parameters/matching_threshold", Type::kReal},
    {"frontend_parameters/octaves", Type::kInt},
    {"frontend_parameters/max_num_keypoints", Type::kInt},
    {"frontend_parameters/keyframe_overlap", Type::kReal},
    {"frontend_parameters/use_cnn", Type::kBoolean},
    {"frontend_parameters/parallelise_detection", Type::kBoolean},
    {"frontend_parameters/num_matching_threads", Type::kInt},
    {"estimator_parameters/num_keyframes", Type::kInt},
    {"estimator_parameters/num_loop_closure_frames", Type::kInt},
    {"estimator_parameters/num_imu_frames", Type::kInt},
    {"estimator_parameters/do_loop_closures", Type::kBoolean},
    {"estimator_parameters/do_final_ba", Type::kBoolean},
    {"estimator_parameters/enforce_realtime", Type::kBoolean},
    {"estimator_parameters/realtime_min_iterations", Type::kInt},
    {"estimator_parameters/realtime_max_iterations", Type::kInt},
    {"estimator_parameters/realtime_time_limit", Type::kReal},
    {"estimator_parameters/realtime_num_threads", Type::kInt},
    {"estimator_parameters/full_graph_iterations", Type::kInt},
    {"estimator_parameters/full_graph_num_threads", Type::kInt},
    {"estimator_parameters/p_dbow", Type::kReal},
    {"estimator_parameters/drift_percentage_heuristic", Type::kReal},
    {"output_parameters/display_matches", Type::kBoolean},
    {"output_parameters/display_overhead", Type::kBoolean},
};
/// OKVIS2-X wants these, too.
constexpr Wanted kOkvis2X[] = {{"imu_parameters/s_a", Type::kList, 3},
                               {"output_parameters/display_topview", Type::kBoolean},
                               {"output_parameters/enable_submapping", Type::kBoolean}};
constexpr Wanted kOkvis1[] = {
    {"useDriver", Type::kBoolean},
    {"displayImages", Type::kBoolean},
    {"detection_options/threshold", Type::kReal},
    {"detection_options/octaves", Type::kInt},
    {"detection_options/maxNoKeypoints", Type::kInt},
    {"imageDelay", Type::kReal},
    {"camera_params/camera_rate", Type::kInt},
    {"imu_params/T_BS", Type::kList, 16},
    {"imu_params/a_max", Type::kReal},
    {"imu_params/g_max", Type::kReal},
    {"imu_params/sigma_g_c", Type::kReal},
    {"imu_params/sigma_a_c", Type::kReal},
    {"imu_params/sigma_bg", Type::kReal},
    {"imu_params/sigma_ba", Type::kReal},
    {"imu_params/sigma_gw_c", Type::kReal},
    {"imu_params/tau", Type::kReal},
    {"imu_params/g", Type::kReal},
    {"imu_params/a0", Type::kList, 3},
    {"imu_params/imu_rate", Type::kInt},
};

/// What differs between the three programs.
struct Generation {
  const char* program;
  std::span<const Wanted> wanted;
  std::span<const Wanted> wanted_further = {};
  bool camera_models = false;  ///< Each entry says pinhole or eucm.
  std::string imu;             ///< The section of the IMU.
  std::string delay;           ///< [s]: t_imu = t_cam - delay.
};

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '/') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

bool is_boolean(const cv::FileNode& node) {
  if (node.isInt()) return true;
  if (!node.isString()) return false;
  std::string word = node.string();
  word.resize(std::min(word.find(' '), word.size()));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<std::string_view, 8> kWords = {"false", "no", "n", "off", "true", "yes", "y", "on"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

class Configuration {
 public:
  Configuration(const cv::FileStorage& storage, const Generation& generation, ConsumerView& view)
      : storage_(storage), generation_(generation), view_(view) {}

  [[nodiscard]] const Generation& generation() const { return generation_; }

  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    arguments.emplace_back(generation_.program);
    view_.refusals.push_back(about_key(code, key, std::move(arguments)));
  }
  void complain(std::vector<Complaint>& complaints, Code code, const std::string& key, std::vector<Argument> arguments) {
    complaints.push_back(about_key(code, key, std::move(arguments)));
  }

  [[nodiscard]] cv::FileNode find(const std::string& path) const {
    cv::FileNode node = storage_.root();
    for (const std::string& part : parts_of(path)) {
      if (!node.isMap()) return {};
      node = node[part];
    }
    return node;
  }

  std::optional<double> number(const std::string& path) const {
    const cv::FileNode node = find(path);
    return storage::is_number(node) ? std::optional(static_cast<double>(node)) : std::nullopt;
  }

  /// A list of at least that many numbers, or (exact) of as many.
  std::optional<std::vector<double>> numbers(const cv::FileNode& node, const std::string& path, std::size_t count, bool exact) {
    if (node.empty()) {
      refuse(Code::kProgramSaysMissing, path);
      return std::nullopt;
    }
    std::vector<double> values;
    for (int i = 0; node.isSeq() && i < static_cast<int>(node.size()); ++i) {
      if (storage::is_number(node[i])) values.push_back(static_cast<double>(node[i]));
    }
    const bool fits = node.isSeq() && values.size() == node.size() && (exact ? values.size() == count : values.size() >= count);
    if (fits) return values;
    refuse(Code::kProgramSaysNumberCount, path, {count});
    return std::nullopt;
  }

  void want(const Wanted& wanted) {
    const std::string path = wanted.path;
    const cv::FileNode node = find(path);
    if (node.empty()) return refuse(Code::kProgramSaysMissing, path);
    switch (wanted.type) {
      case Type::kReal:
        if (node.isInt()) {
          refuse(Code::kProgramSaysNoReal, path, {storage::description_of(node)});
        } else if (!node.isReal()) {
          refuse(Code::kProgramSaysNoNumber, path, {storage::description_of(node)});
        }
        return;
      case Type::kInt:
        if (!node.isInt()) {
          complain(view_.refusals, Code::kOrbslamNotInt, path,
                   {storage::description_of(node), generation_.program, std::vector<Message>()});
        }
        return;
      case Type::kBoolean:
        if (!is_boolean(node)) {
          complain(view_.refusals, Code::kProgramSaysUnknownWord, path,
                   {storage::description_of(node), generation_.program, std::vector<std::string>{"true", "false"}});
        }
        return;
      case Type::kList:
        static_cast<void>(numbers(node, path, wanted.count, false));
        return;
    }
  }

 private:
  const cv::FileStorage& storage_;
  const Generation& generation_;
  ConsumerView& view_;
};

/// How many coefficients a distortion has; 0: it is unknown.
std::size_t coefficient_count(const std::string& distortion) {
  if (distortion == "radialtangential8" || distortion == "plumb_bob8") return 8;
  return distortion == "equidistant" || distortion == "radialtangential" || distortion == "plumb_bob" ? 4 : 0;
}

constexpr double kNearPlane = 1e-12;

Projection pinhole(const opencv::CameraMatrix& K, const std::string& distortion, const std::vector<double>& coefficients) {
  if (distortion == "equidistant") {
    const std::array<double, 4> k = {coefficients[0], coefficients[1], coefficients[2], coefficients[3]};
    return [K, k](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
      if (!(ray[2] >= kNearPlane)) return std::nullopt;
      return opencv::fisheye_project_points(K, k, ray);
    };
  }
  const std::size_t count = coefficient_count(distortion);
  opencv::PinholeCoefficients k{};
  std::copy_n(coefficients.begin(), count, k.begin());
  // "to avoid confusion of this model"
  const double farthest = count == 8 ? 9.0 : HUGE_VAL;
  return [K, k, farthest](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
    if (!(ray[2] >= kNearPlane)) return std::nullopt;
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    if (x * x + y * y > farthest) return std::nullopt;
    return opencv::project_points(K, k, ray);
  };
}

Projection eucm(const opencv::CameraMatrix& K, double alpha, double beta) {
  return [K, alpha, beta](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
    const double rho = std::sqrt(beta * (ray[0] * ray[0] + ray[1] * ray[1]) + ray[2] * ray[2]);
    const double rz = 1.0 / (alpha * rho + (1.0 - alpha) * ray[2]);
    return std::array{K.fx * ray[0] * rz + K.cx, K.fy * ray[1] * rz + K.cy};
  };
}

/// An entry as the program demands it of all, before it reads the first.
struct Entry {
  std::vector<double> pose, size, coefficients, focal, centre;
  std::string distortion;
};

std::optional<Entry> complete_entry(Configuration& file, const cv::FileNode& node, const std::string& path) {
  const auto list = [&](const char* key, std::size_t count, bool exact) {
    return file.numbers(node.isMap() ? node[key] : cv::FileNode(), path + "/" + key, count, exact);
  };
  const auto pose = list("T_SC", 16, false);
  const auto size = list("image_dimension", 2, true);
  const auto coefficients = list("distortion_coefficients", 4, false);
  const auto focal = list("focal_length", 2, true);
  const auto centre = list("principal_point", 2, true);
  const cv::FileNode distortion = node.isMap() ? node["distortion_type"] : cv::FileNode();
  if (!distortion.isString()) {
    const std::string key = path + "/distortion_type";
    file.refuse(distortion.empty() ? Code::kProgramSaysMissing : Code::kProgramSaysNoText, key);
    return std::nullopt;
  }
  if (!pose || !size || !coefficients || !focal || !centre) return std::nullopt;
  return Entry{*pose, *size, *coefficients, *focal, *centre, distortion.string()};
}

std::optional<ConsumerCamera> camera_of(Configuration& file, const Entry& entry, const cv::FileNode& node,
                                        const std::string& path, ConsumerView& view) {
  const Generation& generation = file.generation();
  const opencv::CameraMatrix K = {.fx = entry.focal[0], .fy = entry.focal[1], .cx = entry.centre[0], .cy = entry.centre[1]};
  ConsumerCamera camera;
  camera.width = cv::saturate_cast<int>(entry.size[0]);
  camera.height = cv::saturate_cast<int>(entry.size[1]);
  camera.model = "pinhole, " + entry.distortion;
  const cv::FileNode model = node["cam_model"];
  const std::string name = model.isString() ? model.string() : "";
  if (generation.camera_models && model.empty()) {
    file.refuse(Code::kProgramSaysMissing, path + "/cam_model");
    return std::nullopt;
  }
  if (generation.camera_models && name != "pinhole" && name != "eucm") {
    file.complain(view.refusals, Code::kProgramSaysLeavesCameraOut, path + "/cam_model",
                  {storage::description_of(model), generation.program, std::vector<std::string>{"pinhole", "eucm"}});
    return std::nullopt;
  }
  if (generation.camera_models && name == "eucm") {
    const auto parameters = file.numbers(node["eucm_parameters"], path + "/eucm_parameters", 2, false);
    if (!parameters) return std::nullopt;
    camera.model = name;
    camera.project = eucm(K, (*parameters)[0], (*parameters)[1]);
    return camera;
  }
  const std::size_t count = coefficient_count(entry.distortion);
  const std::string coefficients = path + "/distortion_coefficients";
  if (count == 0) {
    file.complain(
        view.refusals, Code::kProgramSaysLeavesCameraOut, path + "/distortion_type",
        {entry.distortion, generation.program,
         std::vector<std::string>{"radialtangential", "plumb_bob", "radialtangential8", "plumb_bob8", "equidistant"}});
    return std::nullopt;
  }
  if (entry.coefficients.size() < count) {
    file.refuse(Code::kProgramSaysNumberCount, coefficients, {count});
    return std::nullopt;
  }
  for (std::size_t i = count; i < entry.coefficients.size(); ++i)
    file.complain(view.warnings, Code::kProgramSaysUnread, coefficients + "/" + std::to_string(i), {generation.program});
  camera.project = pinhole(K, entry.distortion, entry.coefficients);
  return camera;
}

void read_cameras(Configuration& file, ConsumerView& view) {
  const cv::FileNode list = file.find("cameras");
  if (!list.isSeq() || list.empty()) return file.refuse(Code::kProgramSaysMissing, "cameras");
  std::vector<Entry> entries;
  for (int i = 0; i < static_cast<int>(list.size()); ++i) {
    if (std::optional<Entry> entry = complete_entry(file, list[i], "cameras/" + std::to_string(i))) entries.push_back(*entry);
  }
  if (entries.size() != list.size()) return;
  const std::optional<double> delay = file.number(file.generation().delay);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string path = "cameras/" + std::to_string(i);
    std::optional<ConsumerCamera> camera = camera_of(file, entries[i], list[static_cast<int>(i)], path, view);
    if (!camera) continue;
    camera->name = "cam" + std::to_string(i);
    // One for all: others are told where the file is written.
    if (delay && i == 0) camera->time_offset_s = *delay == 0.0 ? 0.0 : -*delay;
    ConsumerPose pose = {"imu0", camera->name, {}};
    std::copy_n(entries[i].pose.begin(), pose.T_a_b.size(), pose.T_a_b.begin());
    view.poses.push_back(std::move(pose));
    view.cameras.push_back(*std::move(camera));
  }
}

void read_configuration(const cv::FileStorage& storage, const Generation& generation, ConsumerView& view) {
  Configuration file(storage, generation, view);
  read_cameras(file, view);
  for (const Wanted& wanted : generation.wanted) file.want(wanted);
  for (const Wanted& wanted : generation.wanted_further) file.want(wanted);
  const auto of_imu = [&](const char* key) { return file.number(generation.imu + "/" + key); };
  ConsumerImu& imu = view.imu.emplace();
  imu.gyroscope_noise_density = of_imu("sigma_g_c");
  imu.accelerometer_noise_density = of_imu("sigma_a_c");
  imu.gyroscope_random_walk = of_imu("sigma_gw_c");
  imu.accelerometer_random_walk = of_imu("sigma_aw_c");
  imu.rate_hz = of_imu("imu_rate");
}

ConsumerView load(std::string_view bytes, const Generation& generation) {
  return storage::read(
      bytes, generation.program, storage::reader_of(generation.program),
      [&generation](const cv::FileStorage& storage, ConsumerView& view) { read_configuration(storage, generation, view); });
}

}  // namespace

ConsumerView load_okvis2(std::string_view bytes, const LoadOptions& /*options*/) {
  return load(bytes,
              {.program = "OKVIS2", .wanted = kOkvis2, .imu = "imu_parameters", .delay = "camera_parameters/image_delay"});
}

ConsumerView load_okvis2_x(std::string_view bytes, const LoadOptions& /*options*/) {
  return load(bytes, {.program = "OKVIS2-X",
                      .wanted = kOkvis2,
                      .wanted_further = kOkvis2X,
                      .camera_models = true,
                      .imu = "imu_parameters",
                      .delay = "camera_parameters/image_delay"});
}

ConsumerView load_okvis(std::string_view bytes, const LoadOptions& /*options*/) {
  return load(bytes, {.program = "OKVIS", .wanted = kOkvis1, .imu = "imu_params", .delay = "imageDelay"});
}

}  // namespace fca::consumers
