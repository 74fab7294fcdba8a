// SPDX-License-Identifier: BSD-3-Clause
#include "base.h"
#include "base_shape.h"
#include "columns.h"
#include "orbslam3.h"
#include "pair.h"
#include "settings.h"

#include "../losses.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::orbslam3 {

namespace {

/// The style a new file needs for a model: stock V1.0 where it reads the model, else the fork's.
Style style_for(std::string_view model) {
  for (const Style style : {Style::kV1, Style::kOld, Style::kSlamNoOpt}) {
    if (find_layout(style, model) != nullptr) return style;
  }
  return Style::kV1;
}

bool only_when_asked(const Sensor& sensor) { return sensor.depth; }

/// The richest mode the rig fully serves; `next`: what is missing for the next richer one, in words.
Sensor richest_sensor(const Rig& rig, Style style, std::string& next) {
  Sensor best = *find_sensor("mono");
  for (const Sensor& sensor : kSensors) {
    if (!only_when_asked(sensor) && missing_for(rig, sensor, style).empty()) best = sensor;
  }
  const std::string_view wished = rig.cameras.size() > 1 ? "stereo-inertial" : "mono-inertial";
  if (best.id != wished && best.id != "stereo-inertial" && style != Style::kSlamNoOpt) {
    next = std::string(wished) + " lacks " + text::enumerated(missing_for(rig, *find_sensor(wished), style));
  }
  return best;
}

/// Rates that the style stores as ints.
void list_rounded_rates(const Rig& rig, const Target& target, Written& written) {
  const bool whole_fps = target.style == Style::kV1;
  const auto writes = [](double rate) { return ": " + std::to_string(std::lround(rate)) + " is written"; };
  if (whole_fps && target.frame_rate_known && target.frame_rate_hz != std::round(target.frame_rate_hz)) {
    written.losses.push_back({"frame-rate-rounded", text::format_short(target.frame_rate_hz) + " Hz",
                              "Camera.fps must be an int" + writes(target.frame_rate_hz), ""});
  }
  if (target.style == Style::kOld && target.sensor.inertial &&
      *rig.imus.front().rate_hz != std::round(*rig.imus.front().rate_hz)) {
    written.losses.push_back({"imu-rate-rounded", text::format_short(*rig.imus.front().rate_hz) + " Hz",
                              "IMU.Frequency must be an int in this style" + writes(*rig.imus.front().rate_hz), ""});
  }
}

void list_camera_losses(const Rig& rig, const Target& target, const std::string& program, std::vector<Loss>& losses) {
  const std::size_t used = target.sensor.two_cameras ? 2 : 1;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    if (i >= used) {
      losses.push_back({"camera-dropped", camera.name,
                        std::string(target.sensor.id) + " settings hold " + (used == 1 ? "one camera" : "two cameras"),
                        "write it to a file of its own with --camera " + camera.name});
      continue;
    }
    const bool fork = target.style == Style::kSlamNoOpt;
    const std::string why =
        fork ? "the settings do not state it (" + std::string(kDelayKey) + ")" : program + " has no key for it";
    if (i > 0 || !target.states_delay) add_time_offset(camera, why, losses);
    if (!camera.topic.empty()) {
      losses.push_back(
          {"topic-dropped", camera.name + " " + camera.topic,
           fork ? "the keys of the calibration do not hold it" : program + " takes topics on its command line",
           fork ? "the files that come with slam_no_opt name it in a line of its own: imagetopic: \"" + camera.topic + "\""
                : ""});
    }
  }
}

/// What an edited base already says outside the fields of its own mode is still there.
void list_mode_losses(const Rig& rig, const Target& target, const Base* edited, const std::string& program,
                      std::vector<Loss>& losses) {
  const std::string mode(target.sensor.id);
  const bool slam_no_opt = target.style == Style::kSlamNoOpt;
  const bool untouched_imu = edited != nullptr && !edited->target.sensor.inertial;
  if (!rig.imus.empty() && !target.sensor.inertial && !(untouched_imu && edited->rig.imus == rig.imus)) {
    losses.push_back({"imu-dropped", rig.imus.front().name + " noise and rate",
                      slam_no_opt ? "slam_no_opt has no keys for them" : mode + " settings hold no IMU", ""});
  }
  if (target.sensor.inertial && !rig.imus.front().topic.empty()) {
    losses.push_back({"topic-dropped", rig.imus.front().name + " " + rig.imus.front().topic,
                      program + " takes topics on its command line", ""});
  }
  for (std::size_t i = 1; i < rig.imus.size(); ++i)
    losses.push_back({"imu-dropped", rig.imus[i].name + " noise and rate", "the settings hold one IMU", ""});
  const bool said_by_mode = edited != nullptr && (edited->target.sensor.two_cameras || edited->target.sensor.depth);
  const bool untouched_baseline =
      edited != nullptr && edited->rig.baseline_m == rig.baseline_m && (target.style == Style::kV1 || !said_by_mode);
  if (rig.baseline_m && !target.sensor.two_cameras && !target.sensor.depth && !untouched_baseline) {
    losses.push_back({"baseline-dropped", "baseline " + text::format_short(*rig.baseline_m) + " m",
                      mode + " settings hold none", "--sensor rgbd writes it"});
  }
}

/// What was read and the fields of a fresh file do not say.
void list_extras(std::span<const ExtraField> extras, const std::vector<fields::Field>& fields, std::vector<Loss>& losses) {
  std::vector<ExtraField> lost;
  std::ranges::copy_if(extras, std::back_inserter(lost), [&fields](const ExtraField& extra) {
    const TuningKey* key = extra.owner.empty() ? find_tuning_key(extra.key) : nullptr;
    return key == nullptr || std::ranges::none_of(fields, [key](const fields::Field& field) {
             return field.key == key->key || field.key == key->old_key;
           });
  });
  add_not_carried(lost, "the new settings have no place for it", losses);
}

bool check_cameras(const Rig& rig, const Target& target, const Base* edited, Diagnostics& diagnostics) {
  const std::size_t used = target.sensor.two_cameras && rig.cameras.size() > 1 ? 2 : 1;
  for (std::size_t i = 0; i < used; ++i) {
    const Camera& camera = rig.cameras[i];
    const Layout* layout = find_layout(target.style, model_info(camera.model).id);
    if (layout == nullptr) {
      diagnostics.error("model-not-storable",
                        camera.name + ": these settings cannot hold " + std::string(model_info(camera.model).id));
      return false;
    }
    const Camera* before = edited != nullptr ? edited->rig.find_camera(camera.name) : nullptr;
    if ((before == nullptr || before->model != camera.model) && !can_store(kFormat, camera, diagnostics)) return false;
    // A base that never stated a size need not begin to.
    if (!camera.image_size && before == nullptr) {
      diagnostics.error("image-size-missing",
                        camera.name + ": the settings demand Camera.width and Camera.height and the input has none", {},
                        "give it: --size WIDTHxHEIGHT");
      return false;
    }
    if (camera.image_size != rig.cameras[0].image_size) {
      diagnostics.error("image-sizes-differ", "the settings have one image size for both cameras, and theirs differ");
      return false;
    }
    // PinHole with and without a lens have one name.
    const Layout* first = find_layout(target.style, model_info(rig.cameras[0].model).id);
    if (first != nullptr && layout->type != first->type) {
      diagnostics.error("models-differ", "the settings have one Camera.type for both cameras, and theirs differ", {},
                        "convert both with --model");
      return false;
    }
  }
  return true;
}

/// Who reads settings of a style that hold a model, in a mode.
struct Audience {
  Style style;
  std::string_view model;     ///< "" for any other
  std::string_view sensor;    ///< "" for any other
  std::string_view headline;  ///< Who reads it, for people.
  std::string_view program;   ///< Its name in messages.
  std::string_view consumer;  ///< The one that proves it.
};

constexpr std::array kAudiences = {
    // fisheye-ORB-SLAM reads no second camera, and its IMU-less base no Camera.Tbc (src/Tracking.cc).
    Audience{Style::kSlamNoOpt, "eucm", "mono",
             "read by ns15417/slam_no_opt and lsyads/fisheye-ORB-SLAM, NOT by stock ORB-SLAM3 (leave out --model for that)",
             "slam_no_opt", "slam_no_opt"},
    Audience{Style::kSlamNoOpt, "eucm", "", "read by ns15417/slam_no_opt, NOT by stock ORB-SLAM3 (leave out --model for that)",
             "slam_no_opt", "slam_no_opt"},
    Audience{Style::kSlamNoOpt, "", "", "read by ns15417/slam_no_opt, NOT by stock ORB-SLAM3 (--orbslam3-layout v1 for that)",
             "slam_no_opt", "slam_no_opt"},
    Audience{Style::kOld, "ds", "",
             "read by urbste/ORB_SLAM3 (branch feature/gopro_slam), NOT by stock ORB-SLAM3 (leave out --model for that)",
             "urbste/ORB_SLAM3", "urbste"},
    Audience{Style::kV1, "", "", "settings for ORB-SLAM3 V1.0", "ORB-SLAM3", "orbslam3"},
    Audience{Style::kOld, "", "", "settings in the style before ORB-SLAM3 V1.0", "ORB-SLAM3", "orbslam3"},
    Audience{Style::kOrbSlam2, "", "", "settings for ORB-SLAM2, NOT for stock ORB-SLAM3 (--orbslam3-layout v1 for that)",
             "ORB-SLAM2", "orbslam2"},
};

const Audience& audience_of(const Target& target, std::string_view model) {
  const auto* const found = std::ranges::find_if(kAudiences, [&](const Audience& row) {
    return row.style == target.style && (row.model.empty() || row.model == model) &&
           (row.sensor.empty() || row.sensor == target.sensor.id);
  });
  return found == kAudiences.end() ? kAudiences.back() : *found;
}

std::optional<Sensor> asked_sensor(const Rig& rig, Style style, const std::string& id, Diagnostics& diagnostics) {
  const Sensor* sensor = find_sensor(id);
  if (sensor == nullptr) {
    diagnostics.error("unknown-sensor", "there is no sensor mode '" + id + "'");
    return std::nullopt;
  }
  const std::vector<std::string> missing = missing_for(rig, *sensor, style);
  if (!missing.empty()) {
    diagnostics.error("sensor-not-served", "the sensor mode " + id + " lacks " + text::enumerated(missing));
    return std::nullopt;
  }
  return *sensor;
}

/// The style asked for, else the base's where that stores the model (a fork's only for the fork's own model), else a new
/// file's.
std::optional<Style> choose_style(const Rig& rig, const Base* base, const WriteOptions& options, Diagnostics& diagnostics) {
  const std::string_view model = model_info(rig.cameras.front().model).id;
  const std::string& asked = options.layout;
  if (!asked.empty()) {
    const auto* const named = std::ranges::find(kStyleNames, asked, &StyleName::name);
    if (named != kStyleNames.end()) return named->style;
    diagnostics.error("unknown-layout", "ORB-SLAM3 settings have no layout '" + asked + "'");
    return std::nullopt;
  }
  if (base == nullptr || options.anew || find_layout(base->target.style, model) == nullptr) return style_for(model);
  const bool fork = base->target.style == Style::kSlamNoOpt && !options.keeps_layout;
  return fork && model != model_info(base->rig.cameras.front().model).id ? style_for(model) : base->target.style;
}

bool check_rates(const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  constexpr double kLargestRate = 1e6;
  constexpr double kRoundsToOne = 0.5;
  const double lowest = target.style == Style::kV1 ? kRoundsToOne : 1e-6;
  if (!(target.frame_rate_hz >= lowest && target.frame_rate_hz <= kLargestRate)) {
    diagnostics.error("rate-not-storable", "a frame rate of " + text::format_short(target.frame_rate_hz) +
                                               " Hz cannot be stored: Camera.fps is a positive int");
    return false;
  }
  if (!target.sensor.inertial) return true;
  const double imu_rate = rig.imus.front().rate_hz.value_or(kRoundsToOne);
  if (imu_rate >= kRoundsToOne && imu_rate <= kLargestRate) return true;
  diagnostics.error("rate-not-storable",
                    "an IMU rate of " + text::format_short(imu_rate) + " Hz cannot be stored in IMU.Frequency");
  return false;
}

/// What is to be written; `next`: what a richer mode lacks, in words.
std::optional<Target> choose_target(const Rig& rig, const Base* base, const WriteOptions& options, std::string& next,
                                    Diagnostics& diagnostics) {
  Target target;
  const std::optional<Style> style = choose_style(rig, base, options, diagnostics);
  if (!style) return std::nullopt;
  target.style = *style;
  if (!options.sensor.empty()) {
    const std::optional<Sensor> sensor = asked_sensor(rig, target.style, options.sensor, diagnostics);
    if (!sensor) return std::nullopt;
    target.sensor = *sensor;
  } else {
    target.sensor = base != nullptr ? sensor_of(base->document, rig, target.style) : richest_sensor(rig, target.style, next);
  }
  const std::optional<double> rate = options.frame_rate_hz ? options.frame_rate_hz : rig.cameras.front().frame_rate_hz;
  target.frame_rate_known = rate.has_value();
  target.frame_rate_hz = rate.value_or(kUpstreamFrameRate);
  target.max_angle_rad = options.max_angle_rad;
  if (base != nullptr) target.tuning = base->target.tuning;
  if (base != nullptr) target.tuning.move_overlap(same_images(base->rig, rig, options.replaced));
  if (base != nullptr && !options.anew && base->target.style == target.style) {
    // A mode without IMU keeps a pose that the base states beside its mode, not one of the mode it leaves.
    const bool leaves_inertial = base->target.sensor.inertial && !target.sensor.inertial;
    target.states_delay = base->target.states_delay;
    if (!leaves_inertial && (options.sensor.empty() || target.sensor.inertial)) target.imu_pose_key = base->target.imu_pose_key;
  }
  if (!check_rates(rig, target, diagnostics)) return std::nullopt;
  return target;
}

/// What to do about a camera that V1.0 misreads. With depth it undistorts nothing. Of a pair it is the second: Settings.cc,
/// readCamera2, takes Camera2's k1..k4 of KannalaBrandt8 from Camera1; Settings.h, camera2DistortionCoef, gives
/// cv::stereoRectify the first PinHole's coefficients twice. The parser before it reads both KannalaBrandt8 cameras rightly,
/// and knows no second PinHole.
std::string remedy_for_misreading(const Rig& rig, const Sensor& sensor) {
  if (sensor.depth) {
    return "undistort the images first, those of depth too (cv::initUndistortRectifyMap), and convert the camera that they "
           "then have";
  }
  if (!sensor.two_cameras || rig.cameras.size() < 2) return "";
  if (model_info(rig.cameras[1].model).id == "kb4")
    return "--orbslam3-layout old: V1.0 also reads the older style, and there both cameras rightly";
  return "rectify the images first (cv::stereoRectify) and convert one camera of the rectified pair with --baseline METRES "
         "--sensor stereo; or --model kb4 --orbslam3-layout old, where V1.0 reads both cameras rightly";
}

}  // namespace

std::optional<Written> write(const text::Document* base_document, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (rig.cameras.empty()) {
    diagnostics.error("no-camera", "ORB-SLAM3 settings need a camera and the input has none");
    return std::nullopt;
  }
  const std::optional<Base> base = read_base(base_document);
  std::string next;
  const std::optional<Target> target = choose_target(rig, base ? &*base : nullptr, options, next, diagnostics);
  if (!target) return std::nullopt;
  // Another style has other keys and other types for the same ones: such a file is composed anew, and what that drops is
  // listed.
  const Base* edited = base && !options.anew && base->target.style == target->style ? &*base : nullptr;
  if (!check_cameras(rig, *target, edited, diagnostics) || !check_pair(rig, *target, diagnostics)) return std::nullopt;

  warn_of_pair(rig, *target, diagnostics);
  if (edited != nullptr && options.sensor.empty()) warn_of_poorer_mode(*edited, rig, *target, diagnostics);
  const Audience& audience = audience_of(*target, model_info(rig.cameras.front().model).id);
  const std::vector<fields::Field> fields = settings_fields(rig, *target);
  Written written;
  if (edited != nullptr) {
    text::Document document = edited->document;
    fields::apply(document, document.root(), text::Dialect::kOpenCv,
                  shaped_as(fields_of(*edited, rig, fields, options), edited->document), shaped_as(fields, edited->document));
    written.files.push_back({std::move(document), {}, {}});
    written.defaults = defaulted(new_fields(fields, *edited), *target, rig);
    add_beyond_base(rig.extra_fields, edited->rig.extra_fields, "the settings have no place for it", written.losses);
    if (!options.sensor.empty()) list_left_keys(*edited, fields, *target, written.losses);
    warn_of_other_baseline(*edited, fields, diagnostics);
  } else {
    std::optional<text::Document> document = compose(fields, *target, rig, audience.headline, diagnostics);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {}, {}});
    written.defaults = defaulted(fields, *target, rig);
    list_extras(rig.extra_fields, fields, written.losses);
    if (base) {
      add_composed_anew(base->document, written.files.front().document, "", written.losses);
      list_extras(extras_beyond(base->rig.extra_fields, rig.extra_fields), fields, written.losses);
    }
  }
  const std::string program(audience.program);
  list_camera_losses(rig, *target, program, written.losses);
  list_mode_losses(rig, *target, options.sensor.empty() ? edited : nullptr, program, written.losses);
  if (base) tell_of_columns(base->rig, base->target, rig, *target, options.replaced, diagnostics);
  list_rounded_rates(rig, *target, written);
  Written::File& file = written.files.front();
  const std::size_t used = std::min<std::size_t>(target->sensor.two_cameras ? 2 : 1, rig.cameras.size());
  for (std::size_t i = 0; i < used; ++i) file.cameras.push_back(rig.cameras[i].name);
  file.programs = {std::string(audience.consumer)};
  // The first line people see: who reads the file, the mode, and what is missing for a richer one.
  written.headline =
      in_words(std::string(audience.headline) + ", " + std::string(target->sensor.id) + (next.empty() ? "" : "; " + next));
  written.sensor = target->sensor.id;
  if (target->sensor.two_cameras)
    written.first_is_left = in_words("ORB-SLAM3 takes the first camera of a stereo pair for the left one");
  if (target->style == Style::kV1) written.misread_remedy = in_words(remedy_for_misreading(rig, target->sensor));
  return written;
}

}  // namespace fca::orbslam3
