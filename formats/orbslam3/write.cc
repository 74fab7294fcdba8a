// SPDX-License-Identifier: BSD-3-Clause
#include "orbslam3.h"
#include "settings.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <cmath>

namespace fca::orbslam3 {

namespace {

constexpr double kUpstreamFrameRate = 20.0;

/// The style a new file needs for a model: stock V1.0 where it reads the model, else the fork's.
Style style_for(std::string_view model) {
  for (const Style style : {Style::kV1, Style::kOld, Style::kSlamNoOpt}) {
    if (find_layout(style, model) != nullptr) return style;
  }
  return Style::kV1;
}

/// The sensor mode a base file is written for.
Sensor sensor_of(const text::Document& document, const Rig& rig, Style style) {
  Sensor sensor = *find_sensor("mono");
  const bool two = rig.cameras.size() > 1 && rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  const bool depth = find_key(document, "RGBD.DepthMapFactor") != nullptr || find_key(document, "DepthMapFactor") != nullptr;
  const bool inertial = missing_for(rig, *find_sensor("mono-inertial"), style).empty();
  for (const Sensor& candidate : sensors()) {
    if (candidate.two_cameras == two && candidate.depth == (depth && !two) && candidate.inertial == inertial)
      sensor = candidate;
  }
  return sensor;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

bool only_when_asked(const Sensor& sensor) { return sensor.depth; }

/// The richest mode the rig fully serves; `next`: what is missing for the next richer one, in words.
Sensor richest_sensor(const Rig& rig, Style style, std::string& next) {
  Sensor best = *find_sensor("mono");
  for (const Sensor& sensor : sensors()) {
    if (!only_when_asked(sensor) && missing_for(rig, sensor, style).empty()) best = sensor;
  }
  const std::string_view wished = rig.cameras.size() > 1 ? "stereo-inertial" : "mono-inertial";
  if (best.id != wished && best.id != "stereo-inertial" && style != Style::kSlamNoOpt) {
    next = std::string(wished) + " lacks " + joined(missing_for(rig, *find_sensor(wished), style));
  }
  return best;
}

/// Rates that the style stores as ints.
void list_rounded_rates(const Rig& rig, const Target& target, Written& written) {
  const bool whole_fps = target.style == Style::kV1;
  if (whole_fps && target.frame_rate_known && target.frame_rate_hz != std::round(target.frame_rate_hz)) {
    written.losses.push_back(
        {"frame-rate-rounded", text::format_short(target.frame_rate_hz) + " Hz", "Camera.fps must be an int", ""});
  }
  if (target.style == Style::kOld && target.sensor.inertial &&
      *rig.imus.front().rate_hz != std::round(*rig.imus.front().rate_hz)) {
    written.losses.push_back({"imu-rate-rounded", text::format_short(*rig.imus.front().rate_hz) + " Hz",
                              "IMU.Frequency must be an int in this style", ""});
  }
}

/// What no settings file of that style and mode can hold.
void list_losses(const Rig& rig, const Target& target, Written& written) {
  const std::string program = target.style == Style::kSlamNoOpt ? "slam_no_opt" : "ORB-SLAM3";
  const std::size_t used = target.sensor.two_cameras ? 2 : 1;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    if (i >= used) {
      written.losses.push_back({"camera-dropped", camera.name,
                                std::string(target.sensor.id) + " settings hold " + std::to_string(used) + " camera(s)",
                                "write it to a file of its own with --camera " + camera.name});
      continue;
    }
    if (camera.time_offset_s && *camera.time_offset_s != 0.0) {
      const std::string shift = text::format_short(*camera.time_offset_s, 12);
      written.losses.push_back({"time-offset-dropped", camera.name + " t_imu = t_cam + " + shift + " s",
                                program + " has no key for it",
                                "add " + shift + " s to every image time stamp of " + camera.name});
    }
    if (!camera.topic.empty()) {
      written.losses.push_back(
          {"topic-dropped", camera.name + " " + camera.topic, program + " takes topics on its command line", ""});
    }
  }
  if (!rig.imus.empty() && !target.sensor.inertial) {
    written.losses.push_back({"imu-dropped", rig.imus.front().name + " noise and rate",
                              target.style == Style::kSlamNoOpt ? "slam_no_opt has no keys for them"
                                                                : std::string(target.sensor.id) + " settings hold no IMU",
                              ""});
  }
  if (target.sensor.inertial && !rig.imus.front().topic.empty()) {
    written.losses.push_back({"topic-dropped", rig.imus.front().name + " " + rig.imus.front().topic,
                              program + " takes topics on its command line", ""});
  }
  if (!target.sensor.inertial && target.style != Style::kSlamNoOpt && rig.resolve("imu0", rig.cameras.front().name)) {
    written.losses.push_back({"imu-pose-dropped", "pose of " + rig.cameras.front().name + " to the IMU",
                              std::string(target.sensor.id) + " settings hold no IMU pose", ""});
  }
  if (rig.baseline_m && !target.sensor.two_cameras && !target.sensor.depth) {
    written.losses.push_back({"baseline-dropped", "baseline " + text::format_short(*rig.baseline_m) + " m",
                              "mono settings hold none", "--sensor rgbd writes it"});
  }
  for (const std::string& what : rig.as_read) {
    const bool depth =
        target.sensor.depth && what.find("DepthMapFactor ") != std::string::npos && target.tuning.depth_map_factor;
    const bool threshold = what.find("ThDepth ") != std::string::npos && target.tuning.th_depth &&
                           (target.sensor.depth || target.sensor.two_cameras);
    const bool carried = depth || threshold || (what.starts_with("Camera.RGB ") && target.tuning.colour_order);
    if (!carried) written.losses.push_back({"not-carried", what, "the new settings do not take it over", ""});
  }
  list_rounded_rates(rig, target, written);
}

bool check_cameras(const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  const std::size_t used = target.sensor.two_cameras && rig.cameras.size() > 1 ? 2 : 1;
  for (std::size_t i = 0; i < used; ++i) {
    const Camera& camera = rig.cameras[i];
    const Layout* layout = find_layout(target.style, model_info(camera.model).id);
    if (layout == nullptr) {
      diagnostics.error("model-not-storable",
                        camera.name + ": these settings cannot hold " + std::string(model_info(camera.model).id));
      return false;
    }
    if (!stored_within(kFormat, camera, diagnostics)) return false;
    if (!camera.image_size) {
      diagnostics.error("image-size-missing",
                        camera.name + ": the settings demand Camera.width and Camera.height and the input has none", {},
                        "give it: --size WIDTHxHEIGHT");
      return false;
    }
    if (camera.image_size != rig.cameras[0].image_size) {
      diagnostics.error("image-sizes-differ", "the settings have one image size for both cameras, and theirs differ");
      return false;
    }
    if (model_info(camera.model).id != model_info(rig.cameras[0].model).id) {
      diagnostics.error("models-differ", "the settings have one Camera.type for both cameras, and theirs differ", {},
                        "convert both with --model");
      return false;
    }
  }
  return true;
}

std::string who_reads(const Target& target, std::string_view model) {
  if (target.style == Style::kSlamNoOpt && model == "eucm") {
    return "read by ns15417/slam_no_opt and lsyads/fisheye-ORB-SLAM, NOT by stock ORB-SLAM3 (leave out --model for that)";
  }
  if (target.style == Style::kSlamNoOpt) return "read by ns15417/slam_no_opt, NOT by stock ORB-SLAM3";
  if (model == "ds")
    return "read by urbste/ORB_SLAM3 (branch feature/gopro_slam), NOT by stock ORB-SLAM3 (leave out --model for that)";
  if (target.style == Style::kV1) return "settings for ORB-SLAM3 V1.0";
  return "settings in the style before ORB-SLAM3 V1.0";
}

/// The first line people see: who reads the file, the mode, and what is missing for a richer one.
std::string headline(const Target& target, std::string_view model, const std::string& next) {
  return who_reads(target, model) + ", " + std::string(target.sensor.id) + (next.empty() ? "" : " (" + next + ")");
}

std::vector<std::string> programs_for(Style style, std::string_view model) {
  if (style == Style::kV1) return {"orbslam3"};
  if (style == Style::kSlamNoOpt) return {"slam_no_opt"};
  if (style == Style::kOrbSlam2) return {"orbslam2"};
  if (model == "ds") return {"urbste"};
  return {"orbslam3"};
}

std::optional<Sensor> asked_sensor(const Rig& rig, Style style, const std::string& id, Diagnostics& diagnostics) {
  const Sensor* sensor = find_sensor(id);
  if (sensor == nullptr) {
    diagnostics.error("unknown-sensor", "there is no sensor mode '" + id + "'", {},
                      "one of mono, stereo, rgbd, mono-inertial, stereo-inertial, rgbd-inertial");
    return std::nullopt;
  }
  const std::vector<std::string> missing = missing_for(rig, *sensor, style);
  if (!missing.empty()) {
    diagnostics.error("sensor-not-served", "the input cannot serve " + id + ": it lacks " + joined(missing));
    return std::nullopt;
  }
  return *sensor;
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (rig.cameras.empty()) {
    diagnostics.error("no-camera", "ORB-SLAM3 settings need a camera and the input has none");
    return std::nullopt;
  }
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::string_view model = model_info(rig.cameras.front().model).id;

  Target target;
  std::string next;
  // A base keeps its style where that stores the model; a fork's style only for the fork's own model.
  const bool keeps_style = old && find_layout(style_of(*base), model) != nullptr &&
                           (style_of(*base) != Style::kSlamNoOpt || model == model_info(old->cameras.front().model).id);
  target.style = keeps_style ? style_of(*base) : style_for(model);
  if (!options.sensor.empty()) {
    const std::optional<Sensor> sensor = asked_sensor(rig, target.style, options.sensor, diagnostics);
    if (!sensor) return std::nullopt;
    target.sensor = *sensor;
  } else {
    target.sensor = old ? sensor_of(*base, rig, target.style) : richest_sensor(rig, target.style, next);
  }
  const std::optional<double> stated_rate = options.frame_rate_hz ? options.frame_rate_hz : rig.cameras.front().frame_rate_hz;
  target.frame_rate_known = stated_rate.has_value();
  target.frame_rate_hz = stated_rate.value_or(kUpstreamFrameRate);
  constexpr double kLargestRate = 1e6;
  const bool rate_fits =
      target.frame_rate_hz >= (target.style == Style::kV1 ? 0.5 : 1e-6) && target.frame_rate_hz <= kLargestRate;
  if (!rate_fits) {
    diagnostics.error("rate-not-storable", "a frame rate of " + text::format_short(target.frame_rate_hz) +
                                               " Hz cannot be stored: Camera.fps is a positive int");
    return std::nullopt;
  }
  if (target.sensor.inertial && rig.imus.front().rate_hz &&
      (*rig.imus.front().rate_hz < 0.5 || *rig.imus.front().rate_hz > kLargestRate)) {
    diagnostics.error("rate-not-storable", "an IMU rate of " + text::format_short(*rig.imus.front().rate_hz) +
                                               " Hz cannot be stored in IMU.Frequency");
    return std::nullopt;
  }
  // A base that never stated a size need not begin to.
  const bool unchanged_style = old && target.style == style_of(*base);
  if (!unchanged_style && !check_cameras(rig, target, diagnostics)) return std::nullopt;

  Written written;
  if (old) target.tuning = tuning_of(*base);
  // Another style has other keys and other types for the same ones: such a file is composed anew, and what that drops is
  // listed.
  if (unchanged_style) {
    Target before{style_of(*base), sensor_of(*base, *old, style_of(*base)),
                  old->cameras.front().frame_rate_hz.value_or(kUpstreamFrameRate),
                  old->cameras.front().frame_rate_hz.has_value(), target.tuning};
    text::Document document = *base;
    fields::apply(document, document.root(), text::Dialect::kOpenCv, settings_fields(*old, before),
                  settings_fields(rig, target));
    written.files.push_back({std::move(document), {}});
    list_rounded_rates(rig, target, written);
  } else {
    const std::vector<fields::Field> fields = settings_fields(rig, target);
    std::optional<text::Document> document =
        text::parse_document({"settings.yaml", compose(fields, target, rig, who_reads(target, model))}, diagnostics);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {}});
    written.defaults = defaulted(fields, target, rig);
    list_losses(rig, target, written);
  }
  const std::size_t used = target.sensor.two_cameras ? 2 : 1;
  for (std::size_t i = 0; i < std::min(used, rig.cameras.size()); ++i)
    written.files.front().cameras.push_back(rig.cameras[i].name);
  written.headline = headline(target, model, next);
  written.sensor = target.sensor.id;
  written.programs = programs_for(target.style, model);
  return written;
}

}  // namespace fca::orbslam3
