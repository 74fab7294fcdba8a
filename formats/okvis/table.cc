// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fca::okvis {

using schema::FactKind;
using schema::Key;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

/// OKVIS reads rates as ints.
bool read_camera_rate(schema::Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> rate = reading.reader.positive(node, reading.label(key));
  for (Camera& camera : reading.rig.cameras) camera.frame_rate_hz = rate;
  return rate.has_value();
}

int whole(double rate) { return static_cast<int>(std::lrint(std::clamp(rate, 1.0, 1e6))); }

// As the first program's config/config_fpga_p2_euroc.yaml has them [Hz].
constexpr int kStockCameraRate = 20;
constexpr int kStockImuRate = 200;

/// Of a fresh file, where nobody specifies it.
std::vector<Statement> stock_rate(const Subject& subject, const Key& key, int rate) {
  if (subject.fresh == nullptr) return {};
  subject.fresh->defaults.push_back({key.text(), std::to_string(rate), true, false});
  return schema::states(fields::integer(key.text(), rate));
}

std::vector<Statement> write_camera_rate(const Subject& subject, const Key& key) {
  const auto& cameras = subject.rig.cameras;
  const auto stated = std::ranges::find_if(cameras, [](const Camera& camera) { return camera.frame_rate_hz.has_value(); });
  if (stated != cameras.end())
    return schema::states(fields::integer(key.text(), whole(stated->frame_rate_hz.value())), {FactKind::kFrameRate});
  return stock_rate(subject, key, kStockCameraRate);
}

std::vector<Statement> write_imu_rate(const Subject& subject, const Key& key) {
  if (subject.rig.imus.empty() || !subject.rig.imus.front().rate_hz) return stock_rate(subject, key, kStockImuRate);
  return schema::states(fields::integer(key.text(), whole(*subject.rig.imus.front().rate_hz)),
                        {.kind = FactKind::kImu, .imu = &Imu::rate_hz});
}

/// The IMU's pose in the body whose motion is put out. All other poses are in the IMU.
bool read_body(schema::Reading& reading, const Key& key, const Node& node) {
  const std::optional<Transform> T = reading.reader.transform(node, reading.label(key));
  if (T && *T != Transform{})
    reading.rig.extra_fields.push_back({std::string(schema::kImu), key.text(), fields::value_text(node)});
  return T.has_value();
}

std::vector<Statement> write_body(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  const ExtraField* kept = subject.rig.find_extra_field(schema::kImu, key.text());
  const std::vector<double> numbers =
      kept != nullptr ? text::reals_in(kept->value).value_or(std::vector<double>()) : std::vector<double>();
  const Transform identity;
  return schema::states(numbers.size() == identity.values.size() ? fields::list(key.text(), numbers)
                                                                 : fields::list(key.text(), identity.values));
}

/// By their numbers.
std::vector<Statement> write_synchronised(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  if (const ExtraField* kept = schema::kept_tuning(subject.rig, key)) {
    const std::optional<std::vector<double>> numbers = text::reals_in(kept->value);
    const double last = static_cast<double>(subject.rig.cameras.size()) - 1.0;
    if (numbers && std::ranges::all_of(*numbers, [last](double number) { return number >= 0.0 && number <= last; }))
      return schema::states(fields::scalar(key.text(), kept->value));
  }
  fields::Field field;
  field.key = key.name;
  field.shape = fields::Shape::kList;
  std::string all;
  for (std::size_t i = 0; i < subject.rig.cameras.size(); ++i) {
    field.tokens.push_back(std::to_string(i));
    all += (i > 0 ? ", " : "") + field.tokens.back();
  }
  subject.fresh->defaults.push_back({key.text(), "[" + all + "]", true, false});
  return schema::states(std::move(field));
}

/// What a fresh file takes over from the rig for a key of tuning; null: it has the stock value.
const ExtraField* taken_over(const Rig& rig, const Key& key) {
  if (const ExtraField* numbers = schema::kept_tuning(rig, key)) return numbers;
  const ExtraField* kept = rig.find_extra_field("", std::string(key.with.other) + key.text());
  return kept != nullptr && (kept->value == "true" || kept->value == "false") ? kept : nullptr;
}

std::vector<Statement> write_tuning(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  const ExtraField* kept = taken_over(subject.rig, key);
  if (kept == nullptr) subject.fresh->defaults.push_back({key.text(), std::string(key.with.token), false, false});
  return schema::states(fields::scalar(key.text(), kept != nullptr ? kept->value : std::string(key.with.token)));
}

/// `section`: "okvis.imu_parameters."
constexpr Key tuning(std::string_view name, std::string_view section, std::string_view token) {
  return {name, FactKind::kOther, schema::read_tuning, write_tuning, {.other = section, .token = token}};
}

constexpr Key cameras() {
  return schema::required(schema::per_camera(schema::Spread::kCounted,
                                             Key{"cameras", FactKind::kOther, read_camera, nullptr, {.mapping = &kCamera}}));
}

/// A number of the IMU under the same name in both generations; what a fresh file has where none is specified.
constexpr std::array<Key, 4> noise(double gyroscope, double accelerometer, double gyroscope_walk, double accelerometer_walk) {
  return {schema::imu_number("sigma_g_c", &Imu::gyroscope_noise_density, gyroscope),
          schema::imu_number("sigma_a_c", &Imu::accelerometer_noise_density, accelerometer),
          schema::imu_number("sigma_gw_c", &Imu::gyroscope_random_walk, gyroscope_walk),
          schema::imu_number("sigma_aw_c", &Imu::accelerometer_random_walk, accelerometer_walk)};
}

// Noise and tuning begin as the program's config/euroc.yaml has them; what only OKVIS2-X reads as its file of that name, but
// for the maps of volumes, for which no camera is marked.
constexpr auto kNoise = noise(20.0e-4, 20.0e-3, 20.0e-5, 20.0e-3);
constexpr auto kNoise1 = noise(12.0e-4, 8.0e-3, 4.0e-6, 4.0e-5);

constexpr std::string_view kOnline = "okvis.online_calibration.";
constexpr std::array kOnlineKeys = {
    tuning("do_extrinsics", kOnline, "false"),   tuning("do_extrinsics_final_ba", kOnline, "true"),
    tuning("sigma_r", kOnline, "0.01"),          tuning("sigma_alpha", kOnline, "0.1"),
    tuning("sigma_r_final_ba", kOnline, "0.03"), tuning("sigma_alpha_final_ba", kOnline, "0.3")};
constexpr schema::Mapping kOnlineMapping = {.keys = kOnlineKeys, .unread = kOnline};

constexpr std::string_view kCameras = "okvis.camera_parameters.";
constexpr std::array kCameraKeys = {
    tuning("timestamp_tolerance", kCameras, "0.005"),
    Key{"sync_cameras", FactKind::kOther, schema::read_tuning, write_synchronised, {.other = kCameras}},
    schema::common_delay("image_delay"), schema::object("online_calibration", kOnlineMapping)};
constexpr schema::Mapping kCameraMapping = {.keys = kCameraKeys, .unread = kCameras};

constexpr std::string_view kImu = "okvis.imu_parameters.";
constexpr std::array kImuKeys = {
    tuning("use", kImu, "true"),
    tuning("a_max", kImu, "176.0"),
    tuning("g_max", kImu, "7.8"),
    kNoise[0],
    kNoise[1],
    tuning("sigma_bg", kImu, "0.01"),
    tuning("sigma_ba", kImu, "0.1"),
    kNoise[2],
    kNoise[3],
    tuning("g", kImu, "9.81007"),
    tuning("g0", kImu, "[0.0, 0.0, 0.0]"),
    tuning("a0", kImu, "[0.0, 0.0, 0.0]"),  // the file has those of its own device
    tuning("s_a", kImu, "[1.0, 1.0, 1.0]"),
    Key{"T_BS", FactKind::kOther, read_body, write_body},
};
constexpr schema::Mapping kImuMapping = {.keys = kImuKeys, .unread = kImu};

constexpr std::string_view kFrontend = "okvis.frontend_parameters.";
constexpr std::array kFrontendKeys = {tuning("detection_threshold", kFrontend, "38.0"),
                                      tuning("absolute_threshold", kFrontend, "150.0"),
                                      tuning("matching_threshold", kFrontend, "60.0"),
                                      tuning("octaves", kFrontend, "0"),
                                      tuning("max_num_keypoints", kFrontend, "700"),
                                      tuning("keyframe_overlap", kFrontend, "0.6"),
                                      tuning("use_cnn", kFrontend, "false"),
                                      tuning("parallelise_detection", kFrontend, "true"),
                                      tuning("num_matching_threads", kFrontend, "4")};
constexpr schema::Mapping kFrontendMapping = {.keys = kFrontendKeys, .unread = kFrontend};

constexpr std::string_view kEstimator = "okvis.estimator_parameters.";
constexpr std::array kEstimatorKeys = {
    tuning("num_keyframes", kEstimator, "5"),
    tuning("num_loop_closure_frames", kEstimator, "3"),
    tuning("num_imu_frames", kEstimator, "3"),
    tuning("do_loop_closures", kEstimator, "true"),
    tuning("do_final_ba", kEstimator, "false"),
    tuning("enforce_realtime", kEstimator, "false"),
    tuning("realtime_min_iterations", kEstimator, "3"),
    tuning("realtime_max_iterations", kEstimator, "10"),
    tuning("realtime_time_limit", kEstimator, "0.035"),
    tuning("realtime_num_threads", kEstimator, "3"),
    tuning("full_graph_iterations", kEstimator, "15"),
    tuning("full_graph_num_threads", kEstimator, "3"),
    tuning("p_dbow", kEstimator, "0.4"),
    tuning("drift_percentage_heuristic", kEstimator, "1.35"),
};
constexpr schema::Mapping kEstimatorMapping = {.keys = kEstimatorKeys, .unread = kEstimator};

constexpr std::string_view kOutput = "okvis.output_parameters.";
constexpr std::array kOutputKeys = {tuning("display_topview", kOutput, "true"), tuning("display_matches", kOutput, "false"),
                                    tuning("display_overhead", kOutput, "false"),
                                    tuning("enable_submapping", kOutput, "false")};
constexpr schema::Mapping kOutputMapping = {.keys = kOutputKeys, .unread = kOutput};

// The first generation's. Tuning begins as the program's config/config_fpga_p2_euroc.yaml has it.
constexpr std::string_view kDetection = "okvis.detection_options.";
constexpr std::array kDetectionKeys = {tuning("threshold", kDetection, "40.0"), tuning("octaves", kDetection, "0"),
                                       tuning("maxNoKeypoints", kDetection, "400")};
constexpr schema::Mapping kDetectionMapping = {.keys = kDetectionKeys, .unread = kDetection};
constexpr std::string_view kImu1 = "okvis.imu_params.";
constexpr std::array kCameraKeys1 = {Key{"camera_rate", FactKind::kFrameRate, read_camera_rate, write_camera_rate}};
constexpr schema::Mapping kCameraMapping1 = {.keys = kCameraKeys1, .unread = "okvis.camera_params."};
constexpr std::array kImuKeys1 = {
    tuning("a_max", kImu1, "176.0"),
    tuning("g_max", kImu1, "7.8"),
    kNoise1[0],
    kNoise1[1],
    tuning("sigma_bg", kImu1, "0.03"),
    tuning("sigma_ba", kImu1, "0.1"),
    kNoise1[2],
    kNoise1[3],
    tuning("tau", kImu1, "3600.0"),
    tuning("g", kImu1, "9.81007"),
    tuning("a0", kImu1, "[0.0, 0.0, 0.0]"),
    Key{"imu_rate", FactKind::kImu, schema::read_imu_number, write_imu_rate, {.imu = &Imu::rate_hz}},
    Key{"T_BS", FactKind::kOther, read_body, write_body}};
constexpr schema::Mapping kImuMapping1 = {.keys = kImuKeys1, .unread = kImu1};
constexpr std::string_view kCameraSection1 = "camera_params";
constexpr std::string_view kImuSection1 = "imu_params";

constexpr std::array kKeys2 = {
    cameras(),
    schema::object("camera_parameters", kCameraMapping),
    schema::object("imu_parameters", kImuMapping),
    schema::object("frontend_parameters", kFrontendMapping),
    schema::object("estimator_parameters", kEstimatorMapping),
    schema::object("output_parameters", kOutputMapping),
};
constexpr std::array kKeys1 = {
    cameras(),
    schema::object(kCameraSection1, kCameraMapping1),
    schema::object(kImuSection1, kImuMapping1),
    schema::object("detection_options", kDetectionMapping),
    schema::common_delay("imageDelay"),
    tuning("displayImages", kTuningPrefix, "true"),
    tuning("useDriver", kTuningPrefix, "false"),
};
/// Sensors of OKVIS2-X that are neither cameras nor the IMU.
constexpr std::array kFurther = {schema::kept("lidar"), schema::kept("gps_parameters")};

constexpr auto kAllKeys = [] {
  std::array<Key, kKeys2.size() + kKeys1.size() - 1 + kFurther.size()> keys{};
  auto* at = std::ranges::copy(kKeys2, keys.data()).out;
  at = std::ranges::copy(std::span(kKeys1).subspan(1), at).out;
  std::ranges::copy(kFurther, at);
  return keys;
}();

constexpr schema::Schema schema_of(const schema::Mapping& root, std::string_view program) {
  return {.what = "a configuration of OKVIS",
          .dialect = text::Dialect::kOpenCv,
          .root = root,
          .codes = {.wrong_syntax = Code::kTableWrongSyntax,
                    .no_object = Code::kTableNoObject,
                    .no_camera_list = Code::kTableNoCameraList,
                    .initial_value = Code::kTableInitialValue,
                    .one_offset = Code::kTableOneOffset,
                    .further_imu = Code::kTableFurtherImu},
          .program = program};
}

constexpr std::size_t kDeeper = 4;

/// An entry of the list as the program's own files have it: between braces, a row of the pose in a line.
std::string entry_of(const Subject& subject) {
  std::string text = "    - {";
  std::string separator;
  for (const Key* key : schema::in_written_order(kCamera)) {
    for (const fields::Field& field : schema::fields_of(key->write(subject, *key))) {
      std::string value = fields::spell(field);
      if (key->fact == FactKind::kPose) {
        value = field.key + ":\n         [";
        for (std::size_t i = 0; i < field.tokens.size(); ++i)
          value += (i == 0 ? "" : i % 4 == 0 ? ",\n          " : ", ") + field.tokens[i];
        value += "]";
      }
      text += separator + value;
      separator = ",\n       ";
    }
  }
  return text + "}\n";
}

/// Calls `take` with each key of tuning of a fresh file.
template <typename Take>
void for_each_tuning(const schema::Mapping& mapping, const Take& take) {
  for (const Key& key : mapping.keys) {
    if (key.with.mapping != nullptr) {
      for_each_tuning(*key.with.mapping, take);
    } else if (key.write == write_tuning) {
      take(key);
    }
  }
}

}  // namespace

constinit const schema::Schema kTable =
    schema_of({.keys = kAllKeys, .unread = kTuningPrefix, .warns_of_duplicates = true}, "OKVIS2");
constinit const schema::Schema kOkvis2 = schema_of({.keys = kKeys2}, "OKVIS2");
constinit const schema::Schema kOkvis1 = schema_of({.keys = kKeys1}, "OKVIS");

bool is_first_generation(const text::Document& document) {
  const auto has = [&document](std::string_view key) { return text::find(document.root(), key, kTable.dialect) != nullptr; };
  return (has(kCameraSection1) || has(kImuSection1)) && !has("camera_parameters");
}

std::string composed(const schema::Schema& table, const Rig& rig, Written& written) {
  Subject subject{.schema = table, .rig = rig, .fresh = &written};
  std::string text = "%YAML:1.0\ncameras:\n";
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    subject.camera = i;
    text += entry_of(subject);
  }
  // What tunes the program is one default: its sections are named.
  std::vector<std::string> sections;
  for (const Key& key : table.root.keys.subspan(1)) {
    Written made_up;
    subject.fresh = &made_up;
    if (key.with.mapping != nullptr) {
      text += "\n" + key.text() + ":\n" + schema::yaml_lines(subject, *key.with.mapping, kDeeper, kDeeper);
    } else {
      for (const fields::Field& field : schema::fields_of(key.write(subject, key))) text += "\n" + fields::spell(field) + "\n";
    }
    for (DefaultedValue& value : made_up.defaults) {
      if (value.invented) value.key = "IMU " + value.key;
      if (value.invented || value.look_at_it) {
        written.defaults.push_back(std::move(value));
      } else if (sections.empty() || sections.back() != key.text()) {
        sections.push_back(key.text());
      }
    }
  }
  std::string names;
  for (const std::string& section : sections) names += (names.empty() ? "" : ", ") + section;
  if (!names.empty())
    written.defaults.push_back({"tuning (" + names + ")", Message{Code::kTableStockValue, {table.program}}, false, false});
  return text;
}

std::vector<ExtraField> carried_over(const schema::Schema& table, const Rig& rig) {
  std::vector<ExtraField> result = schema::carried(table, rig);
  for_each_tuning(table.root, [&](const Key& key) {
    if (const ExtraField* kept = taken_over(rig, key)) result.push_back(*kept);
  });
  // The words of cameras: what write_word takes over is what it spells so.
  for (const ExtraField& extra : rig.extra_fields) {
    const auto is_word = [&extra](const Key& key) { return key.name == extra.key && !key.with.token.empty(); };
    if (rig.find_camera(extra.owner) != nullptr && std::ranges::any_of(kCamera.keys, is_word)) result.push_back(extra);
  }
  return result;
}

}  // namespace fca::okvis
