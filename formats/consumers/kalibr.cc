// SPDX-License-Identifier: BSD-3-Clause
// Kalibr (ethz-asl/kalibr@1f60227) as a consumer: kalibr_common/ConfigReader.py for the file, aslam_cameras (kalibr_formulas.h)
// for what it computes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "about_key.h"
#include "fca/code.h"
#include "kalibr_formulas.h"
#include "programs.h"
#include "pyyaml.h"

namespace fca::consumers {
namespace {

using kalibr::KalibrCamera;
using kalibr::make_projection;
using pyyaml::Kind;
using pyyaml::Value;

struct ModelRule {
  std::string_view name;
  std::size_t first_focal;  ///< How many numbers stand before fu.
  std::string_view layout;
};
constexpr std::array kModels{ModelRule{"pinhole", 0, "[fu, fv, pu, pv]"}, ModelRule{"omni", 1, "[xi, fu, fv, pu, pv]"},
                             ModelRule{"eucm", 2, "[alpha, beta, fu, fv, pu, pv]"},
                             ModelRule{"ds", 2, "[xi, alpha, fu, fv, pu, pv]"}};

struct DistortionRule {
  std::string_view name;
  std::size_t count;
};
constexpr std::array kDistortions{DistortionRule{"radtan", 4}, DistortionRule{"equidistant", 4}, DistortionRule{"fov", 1},
                                  DistortionRule{"none", 0}};

template <typename Rules>
auto find_rule(const Rules& rules, const Value* name) -> decltype(&rules[0]) {
  if (name == nullptr || name->kind != Kind::kString) return nullptr;
  for (const auto& rule : rules) {
    if (rule.name == name->text) return &rule;
  }
  return nullptr;
}

/// Reads one camera block; everything it finds goes to the view.
class CameraReader {
 public:
  CameraReader(const Value& block, std::size_t index, std::size_t camera_count, ConsumerView& view)
      : block_(block), index_(index), count_(camera_count), name_("cam" + std::to_string(index)), view_(view) {}

  void read() {
    const std::size_t refusals_before = view_.refusals.size();
    if (block_.kind != Kind::kMap) {
      refuse(Code::kKalibrSaysCameraNoMap, name_, {pyyaml::describe(block_)});
      return;
    }
    read_models();
    read_resolution();
    read_rostopic();
    read_overlaps();
    read_timeshift();
    read_pose("T_cam_imu", "imu0");
    read_baseline();
    if (view_.refusals.size() != refusals_before) return;
    view_.cameras.push_back({name_, camera_.width, camera_.height, make_projection(camera_)});
    view_.cameras.back().model = camera_.camera_model + "-" + camera_.distortion_model;
    view_.cameras.back().time_offset_s = camera_.time_offset_s;
    view_.cameras.back().approximation_px = kalibr::approximation_px(camera_);
  }

 private:
  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.refusals.push_back(about_key(code, key, std::move(arguments)));
  }
  void warn(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.warnings.push_back(about_key(code, key, std::move(arguments)));
  }

  const Value* require(std::string_view key) {
    const Value* value = block_.find(key);
    if (value == nullptr) refuse(Code::kKalibrSaysKeyMissing, at(key));
    return value;
  }

  [[nodiscard]] std::string at(std::string_view key) const { return name_ + "/" + std::string(key); }

  void read_models() {
    const Value* model = require("camera_model");
    const Value* distortion = require("distortion_model");
    const ModelRule* model_rule = find_rule(kModels, model);
    const DistortionRule* distortion_rule = find_rule(kDistortions, distortion);
    if (model != nullptr && model_rule == nullptr) {
      refuse(Code::kKalibrSaysUnknownModel, at("camera_model"), {pyyaml::describe(*model)});
    }
    if (distortion != nullptr && distortion_rule == nullptr) {
      refuse(Code::kKalibrSaysUnknownDistortion, at("distortion_model"), {pyyaml::describe(*distortion)});
    }
    const Value* intrinsics = require("intrinsics");
    const Value* coeffs = require("distortion_coeffs");
    if (intrinsics != nullptr && model_rule != nullptr) read_intrinsics(*intrinsics, *model_rule);
    if (coeffs != nullptr && distortion_rule != nullptr) read_coeffs(*coeffs, *distortion_rule);
    if (model_rule != nullptr && distortion_rule != nullptr) check_combination(model_rule->name, distortion_rule->name);
  }

  void read_intrinsics(const Value& list, const ModelRule& rule) {
    camera_.camera_model = std::string(rule.name);
    if (list.kind != Kind::kList || list.items.size() != rule.first_focal + 4) {
      refuse(Code::kKalibrSaysIntrinsicsCount, at("intrinsics"), {pyyaml::describe(list), rule.layout, rule.name});
      return;
    }
    for (std::size_t i = 0; i < rule.first_focal; ++i) {
      if (!list.items[i]->is_number()) {
        refuse(Code::kKalibrSaysIntrinsicsType, at("intrinsics"), {pyyaml::describe(*list.items[i]), rule.layout});
        return;
      }
      camera_.model.at(i) = list.items[i]->number;
    }
    camera_.intrinsics.fu = read_pinhole_number(*list.items[rule.first_focal], "fu");
    camera_.intrinsics.fv = read_pinhole_number(*list.items[rule.first_focal + 1], "fv");
    camera_.intrinsics.pu = read_pinhole_number(*list.items[rule.first_focal + 2], "pu");
    camera_.intrinsics.pv = read_pinhole_number(*list.items[rule.first_focal + 3], "pv");
    check_model_ranges();
  }

  double read_pinhole_number(const Value& value, const std::string& what) {
    if (value.kind != Kind::kFloat) {
      std::vector<Message> fix;
      if (value.kind == Kind::kInt) fix = {{Code::kProgramWriteReal, {value.text}}};
      if (value.kind == Kind::kString) fix = {{Code::kKalibrSaysFormOfFloats}};
      refuse(Code::kKalibrSaysNoFloat, at("intrinsics"), {what, pyyaml::describe(value), fix});
    } else if (value.number < 0.0) {
      refuse(Code::kKalibrSaysNegative, at("intrinsics"), {what, value.text});
    }
    return value.number;
  }

  void check_model_ranges() {
    if (camera_.camera_model == "omni" && camera_.model[0] < 0.0) {
      refuse(Code::kKalibrSaysXiNegative, at("intrinsics"), {camera_.model[0]});
    }
    const bool eucm = camera_.camera_model == "eucm";
    if (!eucm && camera_.camera_model != "ds") return;
    const double alpha = eucm ? camera_.model[0] : camera_.model[1];
    if (alpha < 0.0 || alpha >= 1.0) {
      refuse(Code::kKalibrSaysAlphaOutside, at("intrinsics"), {alpha, camera_.camera_model});
    }
    if (eucm && camera_.model[1] < 0.0) {
      refuse(Code::kKalibrSaysBetaNegative, at("intrinsics"), {camera_.model[1]});
    }
  }

  void read_coeffs(const Value& list, const DistortionRule& rule) {
    camera_.distortion_model = std::string(rule.name);
    if (list.kind != Kind::kList || list.items.size() != rule.count) {
      refuse(Code::kKalibrSaysCoefficientCount, at("distortion_coeffs"), {pyyaml::describe(list), rule.count, rule.name});
      return;
    }
    for (std::size_t i = 0; i < rule.count; ++i) {
      if (!list.items[i]->is_number()) {
        refuse(Code::kKalibrSaysCoefficientType, at("distortion_coeffs"), {pyyaml::describe(*list.items[i])});
        return;
      }
      camera_.coeffs.at(i) = list.items[i]->number;
    }
    if (rule.name == "fov" && camera_.coeffs[0] != 0.0 && (camera_.coeffs[0] < 0.5 || camera_.coeffs[0] > 1.5)) {
      warn(Code::kKalibrSaysFovOutside, at("distortion_coeffs"));
    }
  }

  void check_combination(std::string_view model, std::string_view distortion) {
    const bool allowed = model == "pinhole" || distortion == "none" || (model == "omni" && distortion == "radtan");
    if (!allowed) {
      refuse(Code::kKalibrSaysNoSuchCamera, name_, {model, distortion});
    } else if (model == "pinhole" && distortion == "none") {
      warn(Code::kKalibrSaysPinholeWithNone, name_);
    }
  }

  void read_resolution() {
    const Value* list = require("resolution");
    if (list == nullptr) return;
    if (list->kind != Kind::kList || list->items.size() != 2 || !list->items[0]->is_int() || !list->items[1]->is_int()) {
      refuse(Code::kKalibrSaysResolutionNoInts, at("resolution"));
      return;
    }
    constexpr double kMax = std::numeric_limits<int>::max();
    if (std::abs(list->items[0]->number) > kMax || std::abs(list->items[1]->number) > kMax) {
      refuse(Code::kKalibrSaysResolutionTooLarge, at("resolution"));
      return;
    }
    camera_.width = static_cast<int>(list->items[0]->number);
    camera_.height = static_cast<int>(list->items[1]->number);
  }

  void read_rostopic() {
    const Value* topic = block_.find("rostopic");
    if (topic == nullptr) {
      warn(Code::kKalibrSaysTopicMissing, at("rostopic"));
    } else if (topic->kind != Kind::kString) {
      refuse(Code::kKalibrSaysTopicNoString, at("rostopic"), {pyyaml::describe(*topic)});
    }
  }

  void read_overlaps() {
    const Value* list = block_.find("cam_overlaps");
    if (list == nullptr) return;
    if (list->kind != Kind::kList) {
      refuse(Code::kKalibrSaysOverlapsNoList, at("cam_overlaps"), {pyyaml::describe(*list)});
      return;
    }
    for (const pyyaml::ValuePtr& item : list->items) {
      if (!item->is_number() || item->number >= static_cast<double>(count_)) {
        refuse(Code::kKalibrSaysOverlapsBeyond, at("cam_overlaps"), {pyyaml::describe(*item), count_});
        return;
      }
    }
  }

  void read_timeshift() {
    const Value* shift = block_.find("timeshift_cam_imu");
    if (shift == nullptr) return;
    if (shift->kind == Kind::kFloat) {
      camera_.time_offset_s = shift->number;
      return;
    }
    refuse(Code::kKalibrSaysTimeshiftNoFloat, at("timeshift_cam_imu"), {pyyaml::describe(*shift)});
  }

  void read_baseline() {
    if (index_ == 0) return;
    const std::string previous = "cam" + std::to_string(index_ - 1);
    if (block_.find("T_cn_cnm1") == nullptr) {
      warn(Code::kKalibrSaysBaselineMissing, at("T_cn_cnm1"), {previous, name_});
      return;
    }
    read_pose("T_cn_cnm1", previous);
  }

  void read_pose(std::string_view key, std::string from) {
    const Value* rows = block_.find(key);
    if (rows == nullptr) return;
    ConsumerPose pose{name_, std::move(from), {}};
    bool valid = rows->kind == Kind::kList && rows->items.size() == 4;
    for (std::size_t r = 0; valid && r < 4; ++r) {
      const Value& row = *rows->items[r];
      valid = row.kind == Kind::kList && row.items.size() == 4;
      for (std::size_t c = 0; valid && c < 4; ++c) {
        valid = row.items[c]->is_number();
        pose.T_a_b.at(r * 4 + c) = row.items[c]->number;
      }
    }
    if (valid) {
      view_.poses.push_back(std::move(pose));
    } else {
      refuse_pose(*rows, at(key));
    }
  }

  void refuse_pose(const Value& rows, const std::string& place) {
    const auto is_scalar = [](const pyyaml::ValuePtr& each) { return each->is_number() || each->kind == Kind::kString; };
    const auto is_list = [](const pyyaml::ValuePtr& each) { return each->kind == Kind::kList; };
    const auto has_string = [](const pyyaml::ValuePtr& row) {
      return std::ranges::any_of(row->items, [](const pyyaml::ValuePtr& each) { return each->kind == Kind::kString; });
    };
    constexpr std::size_t kNumbers = 16;
    if (rows.items.size() == kNumbers && std::ranges::all_of(rows.items, is_scalar)) {
      refuse(Code::kKalibrSaysPoseFlat, place);
      return;
    }
    std::vector<Message> form;
    if (std::ranges::all_of(rows.items, is_list) && std::ranges::any_of(rows.items, has_string))
      form = {{Code::kKalibrSaysFormOfReals}};
    refuse(Code::kKalibrSaysPoseNoRows, place, {form});
  }

  const Value& block_;
  std::size_t index_;
  std::size_t count_;
  std::string name_;
  ConsumerView& view_;
  KalibrCamera camera_;
};

/// The root map, or null with a refusal.
pyyaml::ValuePtr load_map(std::string_view bytes, ConsumerView& view) {
  pyyaml::Loaded loaded = pyyaml::safe_load(bytes);
  if (loaded.error.is_said()) {
    view.refusals.emplace_back(Code::kKalibrSaysNotParsed, "", std::vector<Argument>{loaded.error});
    return nullptr;
  }
  if (loaded.root->kind != Kind::kMap) {
    view.refusals.emplace_back(Code::kKalibrSaysFileNoMap, "", std::vector<Argument>{pyyaml::describe(*loaded.root)});
    return nullptr;
  }
  return loaded.root;
}

/// Number n of a key camn, if the name is one Kalibr could ask for.
bool is_camera_key(const Value& key, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (key.kind == Kind::kString && key.text == "cam" + std::to_string(i)) return true;
  }
  return false;
}

// ConfigReader.py, CameraChainParameters.numCameras: len(self.data), so a foreign key counts as a camera.
void check_chain_keys(const Value& root, ConsumerView& view) {
  const std::size_t count = root.entries.size();
  std::vector<Message> foreign;
  std::string first;
  for (const auto& [key, value] : root.entries) {
    if (is_camera_key(*key, count) || (foreign.empty() && key->text.empty())) continue;
    if (foreign.empty()) first = key->text;
    const Code code = foreign.empty() ? Code::kKalibrSaysFirstKey : Code::kKalibrSaysNextKey;
    foreign.push_back({code, {key->text.substr(0, 80)}});
  }
  if (foreign.empty()) return;
  std::string missing;
  for (std::size_t i = 0; i < count && missing.empty(); ++i) {
    const std::string name = "cam" + std::to_string(i);
    if (root.find(name) == nullptr) missing = name;
  }
  view.refusals.emplace_back(Code::kKalibrSaysForeignKeys, first + "/", std::vector<Argument>{count, foreign, missing});
}

struct ImuKey {
  std::string_view key;
  std::string_view unit;
  std::optional<double> ConsumerImu::*held_as;
};
constexpr std::array kImuKeys{
    ImuKey{"accelerometer_noise_density", "m/s^2/sqrt(Hz)", &ConsumerImu::accelerometer_noise_density},
    ImuKey{"accelerometer_random_walk", "m/s^3/sqrt(Hz)", &ConsumerImu::accelerometer_random_walk},
    ImuKey{"gyroscope_noise_density", "rad/s/sqrt(Hz)", &ConsumerImu::gyroscope_noise_density},
    ImuKey{"gyroscope_random_walk", "rad/s^2/sqrt(Hz)", &ConsumerImu::gyroscope_random_walk},
    ImuKey{"update_rate", "Hz", &ConsumerImu::rate_hz}};

void read_imu_number(const Value& root, const ImuKey& rule, ConsumerView& view) {
  const std::string key(rule.key);
  const Value* value = root.find(key);
  const auto refuse = [&](Code code, std::vector<Argument> arguments) {
    view.refusals.emplace_back(code, key, std::move(arguments));
  };
  if (value == nullptr) {
    refuse(Code::kKalibrSaysKeyMissing, {key});
  } else if (!value->is_number()) {
    refuse(Code::kKalibrSaysImuNoNumber, {key, pyyaml::describe(*value)});
  } else if (value->number <= 0.0) {
    refuse(Code::kKalibrSaysImuNotPositive, {key, value->text, rule.unit});
  } else {
    (*view.imu).*rule.held_as = value->number;
  }
}

}  // namespace

ConsumerView load_kalibr(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  const pyyaml::ValuePtr root = load_map(bytes, view);
  if (!root) return view;
  check_chain_keys(*root, view);
  if (root->entries.empty()) view.refusals.emplace_back(Code::kKalibrSaysNoCamera, "");
  for (std::size_t i = 0; i < root->entries.size(); ++i) {
    const Value* block = root->find("cam" + std::to_string(i));
    if (block != nullptr) CameraReader(*block, i, root->entries.size(), view).read();
  }
  if (!view.loads()) {
    view.cameras.clear();
    view.poses.clear();
  }
  return view;
}

// ConfigReader.py, ImuParameters.
ConsumerView load_kalibr_imu(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  const pyyaml::ValuePtr root = load_map(bytes, view);
  if (!root) return view;
  if (root->find("imu0") != nullptr && root->find("update_rate") == nullptr) {
    view.refusals.emplace_back(Code::kKalibrSaysImuNested, "imu0/");
    return view;
  }
  view.imu.emplace();
  for (const ImuKey& rule : kImuKeys) read_imu_number(*root, rule, view);
  const Value* topic = root->find("rostopic");
  if (topic == nullptr || topic->kind != Kind::kString)
    view.refusals.emplace_back(Code::kKalibrSaysImuTopic, "rostopic", std::vector<Argument>{"rostopic"});
  return view;
}

}  // namespace fca::consumers
