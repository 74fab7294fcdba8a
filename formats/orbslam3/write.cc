// SPDX-License-Identifier: BSD-3-Clause
#include "base.h"
#include "base_shape.h"
#include "columns.h"
#include "orbslam3.h"
#include "pair.h"
#include "settings.h"

#include "../losses.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/rig/rotation.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

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

/// The richest mode the rig fully serves; `next`: a clause on what is missing for the next richer one.
Sensor richest_sensor(const Rig& rig, Style style, std::vector<Message>& next) {
  Sensor best = *find_sensor("mono");
  const bool is_pair = rig.cameras.size() < 2 || may_be_stereo(rig, rig.cameras[0], rig.cameras[1]);
  const bool is_held = holds_pair(rig, style);
  const bool is_matched = !matches_along_rows(model_info(rig.cameras.front().model).id) || !second_below_first(rig);
  for (const Sensor& sensor : kSensors) {
    if (sensor.two_cameras && !(is_pair && is_held && is_matched)) continue;
    if (!only_when_asked(sensor) && missing_for(rig, sensor, style).empty()) best = sensor;
  }
  if (!is_pair) {
    next = {Message{Code::kOrbslam3NoPair, {rig.cameras[0].name, rig.cameras[1].name}}};
    return best;
  }
  if (!is_matched) {
    next = {Message{Code::kOrbslam3NoRows, {rig.cameras[0].name, rig.cameras[1].name}}};
    return best;
  }
  if (!is_held) {
    next = {Message{Code::kOrbslam3ModeLacks, {"stereo", Message{Code::kOrbslam3LacksRectifiedPair}}}};
    return best;
  }
  const std::string_view wished = rig.cameras.size() > 1 ? "stereo-inertial" : "mono-inertial";
  if (best.id != wished && best.id != "stereo-inertial" && style != Style::kSlamNoOpt) {
    next = {Message{Code::kOrbslam3ModeLacks, {wished, enumerated(missing_for(rig, *find_sensor(wished), style))}}};
  }
  return best;
}

/// Rates that the style stores as ints.
void list_rounded_rates(const Rig& rig, const Target& target, Written& written) {
  const auto add = [&written](Code code, const std::string& owner, std::string_view key, double rate) {
    if (rate != std::round(rate)) written.losses.push_back(lost(code, owner, std::string(key), {rate, std::lround(rate)}));
  };
  if (target.style == Style::kV1 && target.frame_rate_known)
    add(Code::kOrbslam3FrameRateRounded, rig.cameras.front().name, "Camera.fps", target.frame_rate_hz);
  if (target.style == Style::kOld && target.sensor.inertial)
    add(Code::kOrbslam3ImuRateRounded, rig.imus.front().name, "IMU.Frequency", *rig.imus.front().rate_hz);
}

Loss topic_dropped(const std::string& owner, const std::string& topic, std::string_view program) {
  return lost(Code::kTopicDropped, owner, "topic", {Message{Code::kOrbslam3TopicsOnCommandLine, {program}}, topic});
}

void list_camera_losses(const Rig& rig, const Target& target, std::string_view program, std::vector<Loss>& losses) {
  const std::size_t used = target.sensor.two_cameras ? 2 : 1;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    if (i >= used) {
      const Code dropped = used == 1 ? Code::kOrbslam3SecondCameraDropped : Code::kOrbslam3ThirdCameraDropped;
      losses.push_back(lost(dropped, camera.name, "", {target.sensor.id}));
      continue;
    }
    const bool fork = target.style == Style::kSlamNoOpt;
    const Message why =
        fork ? Message{Code::kOrbslam3DelayNotGiven, {kDelayKey}} : Message{Code::kOrbslam3NoKeyForIt, {program}};
    if (i > 0 || !target.states_delay) add_time_offset(camera, why, losses);
    if (camera.topic.empty()) continue;
    losses.push_back(fork ? lost(Code::kOrbslam3ImageTopicDropped, camera.name, "topic", {camera.topic})
                          : topic_dropped(camera.name, camera.topic, program));
  }
}

/// What an edited base already says outside the fields of its own mode is still there.
void list_mode_losses(const Rig& rig, const Target& target, const Base* edited, std::string_view program,
                      std::vector<Loss>& losses) {
  const auto drop_imu = [&losses](const Imu& imu, Message why) {
    losses.push_back(lost(Code::kOrbslam3ImuDropped, imu.name, "", {std::move(why)}));
  };
  const bool untouched_imu = edited != nullptr && !edited->target.sensor.inertial;
  if (!rig.imus.empty() && !target.sensor.inertial && !(untouched_imu && edited->rig.imus == rig.imus)) {
    drop_imu(rig.imus.front(), target.style == Style::kSlamNoOpt ? Message{Code::kOrbslam3NoKeysForImu}
                                                                 : Message{Code::kOrbslam3NoImu, {target.sensor.id}});
  }
  if (target.sensor.inertial && !rig.imus.front().topic.empty())
    losses.push_back(topic_dropped(rig.imus.front().name, rig.imus.front().topic, program));
  for (std::size_t i = 1; i < rig.imus.size(); ++i) drop_imu(rig.imus[i], {Code::kOrbslam3OneImu});
  const bool said_by_mode = edited != nullptr && (edited->target.sensor.two_cameras || edited->target.sensor.depth);
  const bool untouched_baseline =
      edited != nullptr && edited->rig.baseline_m == rig.baseline_m && (target.style == Style::kV1 || !said_by_mode);
  if (rig.baseline_m && !target.sensor.two_cameras && !target.sensor.depth && !untouched_baseline)
    losses.push_back(lost(Code::kOrbslam3BaselineDropped, "", "baseline", {*rig.baseline_m, target.sensor.id}));
}

/// What was read and the fields of a fresh file do not say.
void list_extras(std::span<const ExtraField> extras, const std::vector<fields::Field>& fields, std::vector<Loss>& losses) {
  std::vector<ExtraField> lost;
  std::ranges::copy_if(extras, std::back_inserter(lost), [&fields](const ExtraField& extra) {
    if (extra.owner.empty() && std::ranges::find(fields, extra.key, &fields::Field::key) != fields.end()) return false;
    const TuningKey* key = extra.owner.empty() ? find_tuning_key(extra.key) : nullptr;
    return key == nullptr || std::ranges::none_of(fields, [key](const fields::Field& field) {
             return field.key == key->key || field.key == key->old_key;
           });
  });
  add_not_carried(lost, Message{Code::kOrbslam3NoPlaceInNew}, losses);
}

bool check_cameras(const Rig& rig, const Target& target, const Base* edited, Diagnostics& diagnostics) {
  const std::size_t used = target.sensor.two_cameras && rig.cameras.size() > 1 ? 2 : 1;
  for (std::size_t i = 0; i < used; ++i) {
    const Camera& camera = rig.cameras[i];
    const Layout* layout = find_layout(target.style, model_info(camera.model).id);
    if (layout == nullptr) {
      diagnostics.add(Code::kOrbslam3ModelNotStorable, {camera.name, model_info(camera.model).id});
      return false;
    }
    const Camera* before = edited != nullptr ? edited->rig.find_camera(camera.name) : nullptr;
    if ((before == nullptr || before->model != camera.model) && !can_store(kFormat, camera, diagnostics)) return false;
    // A base that never stated a size need not begin to.
    if (!camera.image_size && before == nullptr) {
      diagnostics.add(Code::kOrbslam3SizeMissing, {camera.name});
      return false;
    }
    if (camera.image_size != rig.cameras[0].image_size) {
      diagnostics.add(Code::kOrbslam3SizesDiffer);
      return false;
    }
    // PinHole with and without a lens have one name.
    const Layout* first = find_layout(target.style, model_info(rig.cameras[0].model).id);
    if (first != nullptr && layout->type != first->type) {
      diagnostics.add(Code::kOrbslam3TypesDiffer);
      return false;
    }
  }
  return true;
}

/// Who reads settings of a style that hold a model, in a mode.
struct Audience {
  Style style;
  std::string_view model;                   ///< "" for any other
  std::string_view sensor;                  ///< "" for any other
  Code headline;                            ///< What the file is to whom.
  std::array<std::string_view, 2> readers;  ///< Who reads it, for people; "": none.
  Code stock;                               ///< How the stock program's are to be had instead; kNone: it reads these.
  std::string_view program;                 ///< Its name in messages.
  std::string_view consumer;                ///< The one that proves it.
};

constexpr std::string_view kNoOpt = "ns15417/slam_no_opt";
constexpr std::string_view kV1Program = "ORB-SLAM3 V1.0";
constexpr std::array kAudiences = {
    // fisheye-ORB-SLAM reads no second camera, and its IMU-less base no Camera.Tbc (src/Tracking.cc).
    Audience{Style::kSlamNoOpt,
             "eucm",
             "mono",
             Code::kOrbslam3ReadBy,
             {kNoOpt, "lsyads/fisheye-ORB-SLAM"},
             Code::kOrbslam3StockByModel,
             "slam_no_opt",
             "slam_no_opt"},
    Audience{Style::kSlamNoOpt,
             "eucm",
             "",
             Code::kOrbslam3ReadBy,
             {kNoOpt},
             Code::kOrbslam3StockByModel,
             "slam_no_opt",
             "slam_no_opt"},
    Audience{
        Style::kSlamNoOpt, "", "", Code::kOrbslam3ReadBy, {kNoOpt}, Code::kOrbslam3StockByLayout, "slam_no_opt", "slam_no_opt"},
    Audience{Style::kOld,
             "ds",
             "",
             Code::kOrbslam3ReadBy,
             {"urbste/ORB_SLAM3 (branch feature/gopro_slam)"},
             Code::kOrbslam3StockByModel,
             "urbste/ORB_SLAM3",
             "urbste"},
    Audience{Style::kV1, "", "", Code::kOrbslam3For, {kV1Program}, Code::kNone, "ORB-SLAM3", "orbslam3"},
    Audience{Style::kOld, "", "", Code::kOrbslam3StyleBefore, {kV1Program}, Code::kNone, "ORB-SLAM3", "orbslam3"},
    Audience{Style::kOrbSlam2,
             "",
             "",
             Code::kOrbslam3ForNotStock,
             {"ORB-SLAM2"},
             Code::kOrbslam3StockByLayout,
             "ORB-SLAM2",
             "orbslam2"},
};

/// Who reads it, as a clause; `stock`: how the stock program's settings are to be had, as a clause, or none.
Message headline_of(const Audience& audience, std::vector<Message> stock) {
  std::vector<std::string> readers;
  for (const std::string_view reader : audience.readers) {
    if (!reader.empty()) readers.emplace_back(reader);
  }
  return {audience.headline, {std::move(readers), std::move(stock)}};
}

Message headline_of(const Audience& audience) {
  return headline_of(audience, audience.stock != Code::kNone ? std::vector{Message{audience.stock}} : std::vector<Message>());
}

/// The same as the comment that stands in files.
std::string comment_of(const Audience& audience) { return text::text_of(headline_of(audience, {})); }

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
    diagnostics.add(Code::kOrbslam3UnknownMode, {id});
    return std::nullopt;
  }
  const std::vector<Message> missing = missing_for(rig, *sensor, style);
  if (!missing.empty()) {
    diagnostics.add(Code::kOrbslam3ModeNotServed, {id, enumerated(missing)});
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
    if (const std::optional<Style> named = style_named(asked)) return *named;
    diagnostics.add(Code::kOrbslam3UnknownLayout, {asked});
    return std::nullopt;
  }
  if (base == nullptr || options.rewrite || find_layout(base->target.style, model) == nullptr) return style_for(model);
  const bool fork = base->target.style == Style::kSlamNoOpt && !options.keeps_layout;
  return fork && model != model_info(base->rig.cameras.front().model).id ? style_for(model) : base->target.style;
}

bool check_rates(const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  constexpr double kLargestRate = 1e6;
  constexpr double kRoundsToOne = 0.5;
  const double lowest = target.style == Style::kV1 ? kRoundsToOne : 1e-6;
  if (!(target.frame_rate_hz >= lowest && target.frame_rate_hz <= kLargestRate)) {
    diagnostics.add(Code::kOrbslam3FrameRateNotStorable, {target.frame_rate_hz});
    return false;
  }
  if (!target.sensor.inertial) return true;
  const double imu_rate = rig.imus.front().rate_hz.value_or(kRoundsToOne);
  if (imu_rate >= kRoundsToOne && imu_rate <= kLargestRate) return true;
  diagnostics.add(Code::kOrbslam3ImuRateNotStorable, {imu_rate});
  return false;
}

/// As stella_vslam says it; of gray images it says nothing that matters.
std::optional<double> colour_order_of(const Rig& rig) {
  const ExtraField* order = rig.find_extra_field("", "Camera.color_order");
  if (order == nullptr) return std::nullopt;
  return order->value.find("BGR") == std::string::npos ? 1.0 : 0.0;
}

/// What is to be written; `next`: a clause on what a richer mode lacks.
std::optional<Target> choose_target(const Rig& rig, const Base* base, const WriteOptions& options, std::vector<Message>& next,
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
  if (base != nullptr && !options.rewrite && base->target.style == target.style) {
    // A mode without IMU keeps a pose that the base specifies besides its mode, not one of the mode it leaves.
    const bool leaves_inertial = base->target.sensor.inertial && !target.sensor.inertial;
    target.states_delay = base->target.states_delay;
    if (!leaves_inertial && (options.sensor.empty() || target.sensor.inertial)) target.imu_pose_key = base->target.imu_pose_key;
  }
  const bool is_fresh = base == nullptr || options.rewrite || base->target.style != target.style;
  target.states_rectification = is_fresh && target.style == Style::kOrbSlam2;
  if (!check_rates(rig, target, diagnostics)) return std::nullopt;
  if (const std::optional<double> order = colour_order_of(rig)) target.tuning.take(tuning_key::kColourOrder, *order);
  return target;
}

/// Before V1.0 the IMU's pose goes through Sophus, which aborts unless its matrix is a rotation to 1e-5: one of few digits
/// becomes the nearest.
Rig with_imu_rotation(const Rig& rig, const Target& target, Written& written) {
  constexpr double kRounding = 1e-6;
  Rig result = rig;
  if (target.style != Style::kOld || !target.sensor.inertial) return result;
  const std::string& camera = rig.cameras.front().name;
  const std::optional<Transform> T_imu_cam = rig.resolve("imu0", camera);
  const std::optional<Transform> nearest = T_imu_cam ? nearest_rotation(*T_imu_cam) : std::nullopt;
  if (!nearest || largest_difference(*nearest, *T_imu_cam).distance <= kRounding) return result;
  std::erase_if(result.poses, [&camera](const PoseEdge& edge) {
    return (edge.a == "imu0" && edge.b == camera) || (edge.a == camera && edge.b == "imu0");
  });
  result.poses.push_back({"imu0", camera, *nearest});
  written.restated.push_back(result.poses.back());
  written.losses.push_back(lost(Code::kPoseRecomputed, camera, std::string(pose_keys(target.style).T_imu_c1), {"imu0"}));
  return result;
}

}  // namespace

std::size_t cameras_held(const Rig& rig, std::string_view mode, std::string_view layout) {
  if (rig.cameras.empty()) return 0;
  std::vector<Message> next;
  const Sensor* asked = find_sensor(mode);
  // Whether other layouts hold a pair depends on the model that is still to be chosen.
  const Style style = style_named(layout) == Style::kOrbSlam2 ? Style::kOrbSlam2 : Style::kV1;
  const Sensor sensor = asked != nullptr ? *asked : richest_sensor(rig, style, next);
  return sensor.two_cameras ? 2 : 1;
}

std::optional<Written> write(const text::Document* base_document, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (rig.cameras.empty()) {
    diagnostics.add(Code::kOrbslam3NoCamera);
    return std::nullopt;
  }
  const std::optional<Base> base = read_base(base_document);
  std::vector<Message> next;
  const std::optional<Target> target = choose_target(rig, base ? &*base : nullptr, options, next, diagnostics);
  if (!target) return std::nullopt;
  // Another style has other keys and other types for the same ones: such a file is rewritten, and what that drops is
  // listed.
  const Base* edited = base && !options.rewrite && base->target.style == target->style ? &*base : nullptr;
  if (!check_cameras(rig, *target, edited, diagnostics) || !check_pair(rig, *target, diagnostics)) return std::nullopt;

  warn_of_pair(rig, *target, diagnostics);
  if (edited != nullptr && options.sensor.empty()) warn_of_poorer_mode(*edited, rig, *target, diagnostics);
  const Audience& audience = audience_of(*target, model_info(rig.cameras.front().model).id);
  Written written;
  const std::vector<fields::Field> fields =
      settings_fields(edited == nullptr ? with_imu_rotation(rig, *target, written) : rig, *target);
  if (edited != nullptr) {
    text::Document document = edited->document;
    fields::apply(document, document.root(), text::Dialect::kOpenCv,
                  shaped_as(fields_of(*edited, rig, fields, options), edited->document), shaped_as(fields, edited->document));
    written.files.push_back({std::move(document), {}, {}});
    written.defaults = defaulted(new_fields(fields, *edited), *target, rig);
    add_beyond_base(rig.extra_fields, edited->rig.extra_fields, Message{Code::kOrbslam3NoPlace}, written.losses);
    if (!options.sensor.empty()) list_left_keys(*edited, fields, *target, written.losses);
    warn_of_other_baseline(*edited, fields, diagnostics);
  } else {
    std::optional<text::Document> document = compose(fields, *target, rig, comment_of(audience), diagnostics);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {}, {}});
    written.defaults = defaulted(fields, *target, rig);
    list_extras(rig.extra_fields, fields, written.losses);
    if (base) {
      add_rewritten(base->document, written.files.front().document, Message{}, written.losses);
      list_extras(extras_beyond(base->rig.extra_fields, rig.extra_fields), fields, written.losses);
    }
  }
  list_camera_losses(rig, *target, audience.program, written.losses);
  list_mode_losses(rig, *target, options.sensor.empty() ? edited : nullptr, audience.program, written.losses);
  if (base) report_columns(base->rig, base->target, rig, *target, options.replaced, diagnostics);
  list_rounded_rates(rig, *target, written);
  Written::File& file = written.files.front();
  const std::size_t used = std::min<std::size_t>(target->sensor.two_cameras ? 2 : 1, rig.cameras.size());
  for (std::size_t i = 0; i < used; ++i) file.cameras.push_back(rig.cameras[i].name);
  file.programs = {std::string(audience.consumer)};
  // The first line people see: who reads the file, the mode, and what is missing for a richer one.
  // How the stock program's settings are to be had instead, a layout says of fresh files; of an edit, its verdict.
  const Message readers = edited != nullptr ? headline_of(audience, {}) : headline_of(audience);
  written.headline = {Code::kOrbslam3Headline, {readers, target->sensor.id, next}};
  written.sensor = target->sensor.id;
  if (target->sensor.two_cameras) written.first_is_left = {Code::kOrbslam3FirstIsLeft};
  return written;
}

}  // namespace fca::orbslam3
