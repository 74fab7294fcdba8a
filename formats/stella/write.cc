// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "stella.h"

#include "../fields.h"
#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca::stella {

using fields::Field;

namespace {

/// Of an example's file.
constexpr double kStockRate = 30.0;
constexpr std::string_view kStockColourOrder = "RGB";

/// What is to be written.
struct Target {
  bool pair = false;  ///< Both cameras, and their rectification.
  double frame_rate_hz = kStockRate;
};

double value_of(const CameraModel& model, ParameterId id) { return parameter(model, id).value(); }

bool has_extra(const Rig& rig, std::string_view key) { return rig.find_extra_field("", key) != nullptr; }

/// Of a rig with a baseline alone, only ORB-SLAM's keys and stella_vslam's own word tell a depth sensor from a pair.
std::string_view setup_of(const Rig& rig, const Target& target) {
  if (target.pair) return kStereo;
  if (has_extra(rig, kSetup) || has_extra(rig, "RGBD.DepthMapFactor") || has_extra(rig, "DepthMapFactor")) return kDepth;
  return rig.baseline_m ? kStereo : std::string_view("monocular");
}

std::string name_of(const Rig& rig) {
  const ExtraField* name = rig.find_extra_field("", kName);
  return name != nullptr ? name->value : rig.cameras.front().name;
}

/// As stated, or as ORB-SLAM's Camera.RGB says; empty: nobody says it.
std::string_view colour_order_of(const Rig& rig) {
  if (const ExtraField* own = rig.find_extra_field("", kColourOrder)) return own->value;
  const ExtraField* rgb = rig.find_extra_field("", "Camera.RGB");
  if (rgb == nullptr) return {};
  return rgb->value == "0" ? "BGR" : "RGB";
}

void add_lens(const CameraModel& model, std::vector<Field>& fields) {
  for (const ParameterId id : {ParameterId("fx"), ParameterId("fy"), ParameterId("cx"), ParameterId("cy")})
    fields.push_back(fields::real(std::string(id.name()), value_of(model, id)));
  for (const Coefficient& each : lens_of(model)->coefficients)
    fields.push_back(fields::real(std::string(each.key), parameter(model, each.parameter).value_or(0.0)));
}

/// The camera that both are rectified to, a lens without distortion.
CameraModel rectified_lens(const ros::Projection& P) {
  CameraModel model = *make_model("pinhole");
  static_cast<void>(set_parameter(model, "fx", P[0]));
  static_cast<void>(set_parameter(model, "fy", P[5]));
  static_cast<void>(set_parameter(model, "cx", P[2]));
  static_cast<void>(set_parameter(model, "cy", P[6]));
  return model;
}

/// The block Camera.
std::vector<Field> camera_fields(const Rig& rig, const Target& target) {
  const Camera& camera = rig.cameras.front();
  const ros::Rectification rectification = target.pair ? rectification_of(rig) : ros::Rectification();
  const CameraModel lens = target.pair ? rectified_lens(rectification.cameras.front().P) : camera.model;
  std::vector<Field> fields = {fields::quoted("name", name_of(rig)), fields::quoted("setup", setup_of(rig, target)),
                               fields::quoted("model", lens_of(lens)->name)};
  add_lens(lens, fields);
  fields.push_back(fields::real("fps", target.frame_rate_hz));
  if (camera.image_size) {
    fields.push_back(fields::integer("cols", camera.image_size->width));
    fields.push_back(fields::integer("rows", camera.image_size->height));
  }
  if (target.pair) fields.push_back(fields::real("focal_x_baseline", focal_times_baseline(rectification)));
  if (!target.pair && rig.baseline_m)
    fields.push_back(fields::real("focal_x_baseline", *rig.baseline_m * value_of(camera.model, "fx")));
  if (const ExtraField* threshold = rig.find_extra_field("", kDepthThreshold))
    fields.push_back(fields::scalar("depth_threshold", threshold->value));
  const std::string_view order = colour_order_of(rig);
  fields.push_back(fields::quoted("color_order", order.empty() ? kStockColourOrder : order));
  return fields;
}

/// The block StereoRectifier of a pair.
std::vector<Field> rectifier_fields(const Rig& rig) {
  const std::vector<ros::Rectified> rectified = rectification_of(rig).cameras;
  const bool fisheye = model_info(rig.cameras.front().model).id == "kb4";
  std::vector<Field> fields = {fields::quoted("model", fisheye ? "fisheye" : "perspective")};
  constexpr std::array<std::string_view, 2> kSides = {"left", "right"};
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    const CameraModel& model = rig.cameras[i].model;
    const std::string side(kSides.at(i));
    fields.push_back(fields::list("K_" + side, ros::camera_matrix_of(model)));
    fields.push_back(fields::list("D_" + side, coefficients_of(model)));
    fields.push_back(fields::list("R_" + side, rectified[i].R));
  }
  return fields;
}

std::string block_text(std::string_view name, std::vector<Field> fields, Style style) {
  const bool nested = style == Style::kNested;
  constexpr std::size_t kDeeper = 2;
  std::string text = nested ? std::string(name) + ":\n" : "";
  for (Field& field : fields) {
    if (!nested) field.key = std::string(name) + "." + field.key;
    text += fields::spell(field, nested ? kDeeper : 0) + "\n";
  }
  return text;
}

/// What tunes the program in a file that is rewritten: its blocks as they stand there.
std::string tuning_text(const text::Document& base) {
  std::string text;
  if (style_of(base) == Style::kDotted || base.root().flow) return text;
  for (const text::Entry& entry : base.root().entries) {
    if (entry.key.value == kCamera || entry.key.value == kRectifier) continue;
    const text::Span all = base.extent(entry);
    text += "\n" + base.source().bytes.substr(all.offset, all.length) + "\n";
  }
  std::erase(text, '\r');
  return text;
}

void edit_block(text::Document& document, std::string_view name, std::vector<Field> before, std::vector<Field> after) {
  const text::Node* node = text::find(document.root(), name, kDialect);
  if (style_of(document) == Style::kNested) {
    if (node != nullptr) fields::apply(document, *node, kDialect, before, after);
    return;
  }
  for (std::vector<Field>* fields : {&before, &after}) {
    for (Field& field : *fields) field.key = std::string(name) + "." + field.key;
  }
  fields::apply(document, document.root(), kDialect, before, after);
}

/// A model whose name the file need not specify (perspective in StereoRectifier), or has another word for, is not edited.
void leave_same_lens(const text::Document& base, std::string_view block, std::vector<Field>& before,
                     std::vector<Field>& after) {
  const auto is_model = [](const Field& field) { return field.key == "model"; };
  const auto old = std::ranges::find_if(before, is_model);
  const auto now = std::ranges::find_if(after, is_model);
  if (old == before.end() || now == after.end() || find_key(base, block, "model") != nullptr) return;
  if (*now != *old) {
    before.erase(old);
  } else {
    before.erase(old);
    after.erase(now);
  }
}

/// The rig with what only the base specifies: its words, and a baseline that the rig does not contradict.
Rig with_words_of(const Rig& there, const Rig& rig) {
  Rig result = rig;
  std::erase_if(result.extra_fields, [](const ExtraField& extra) { return extra.owner.empty(); });
  std::ranges::copy_if(there.extra_fields, std::back_inserter(result.extra_fields),
                       [](const ExtraField& extra) { return extra.owner.empty(); });
  if (!result.baseline_m) result.baseline_m = there.baseline_m;
  return result;
}

text::Document edited(const text::Document& base, const Rig& old, const Rig& rig, const Target& before, const Target& after) {
  text::Document document = base;
  edit_block(document, kCamera, camera_fields(old, before), camera_fields(rig, after));
  if (!after.pair) return document;
  std::vector<Field> from = rectifier_fields(old);
  std::vector<Field> to = rectifier_fields(rig);
  leave_same_lens(base, kRectifier, from, to);
  edit_block(document, kRectifier, from, to);
  return document;
}

/// Are all cameras that are written ones that the file can hold? An error for each that is not.
bool are_storable(const Rig& rig, const Target& target, const Rig* old, Diagnostics& diagnostics) {
  bool good = true;
  for (const Camera& camera : std::span(rig.cameras).first(target.pair ? 2 : 1)) {
    const Camera* before = old != nullptr ? old->find_camera(camera.name) : nullptr;
    if (before == nullptr || before->model != camera.model) good = can_store(kFormat, camera, diagnostics) && good;
    if (camera.image_size) continue;
    diagnostics.add(Code::kFormatNeedsSize, {camera.name, Message{Code::kTableDemandsSize}});
    good = false;
  }
  return good;
}

/// Is what the file has, if that is a panorama, what is to be written?
bool keeps_panorama(const Rig& there, const Rig& rig) {
  const Camera& before = there.cameras.front();
  const Camera& now = rig.cameras.front();
  return before.rays == now.rays && (before.rays.empty() || before.image_size == now.image_size);
}

void list_losses(const Rig& rig, const Target& target, std::vector<Loss>& losses) {
  const Message no_place{Code::kFilesHaveNoPlace, {kProgram}};
  const std::size_t used = target.pair ? 2 : 1;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    Camera camera = rig.cameras[i];
    if (i >= used) {
      const Code dropped = used == 1 ? Code::kOrbslam3SecondCameraDropped : Code::kOrbslam3ThirdCameraDropped;
      losses.push_back(lost(dropped, camera.name, "", {setup_of(rig, target)}));
      continue;
    }
    if (i == 0 || camera.frame_rate_hz == target.frame_rate_hz) camera.frame_rate_hz.reset();
    add_stream(camera, no_place, losses);
  }
  for (const Imu& imu : rig.imus) losses.push_back(lost(Code::kImuDropped, imu.name, "", {no_place}));
  if (target.pair && rig.baseline_m)
    losses.push_back(lost(Code::kBaselineDropped, "", "baseline", {no_place, *rig.baseline_m}));
}

/// Those of the rig's extra fields that the file says.
std::vector<ExtraField> said_in(const Rig& rig, const Target& target, const std::vector<ExtraField>& there) {
  std::vector<ExtraField> said = there;
  for (const ExtraField& extra : rig.extra_fields) {
    const bool of_camera = extra.owner.empty() && (extra.key == kName || extra.key == kColourOrder || extra.key == kSetup ||
                                                   extra.key == kDepthThreshold || extra.key == "Camera.RGB");
    if (of_camera) said.push_back(extra);
  }
  if (!target.pair) return said;
  const std::vector<ros::Rectified> rectified = rectification_of(rig).cameras;
  for (std::size_t i = 0; i < 2; ++i) {
    const ExtraField* extra = rig.find_extra_field(rig.cameras[i].name, ros::kProjection);
    if (rectified[i].stated && extra != nullptr) said.push_back(*extra);
  }
  return said;
}

void list_restated(const Rig& rig, Written& written) {
  const ros::Rectification rectification = rectification_of(rig);
  if (!rectification.restated) return;
  const PoseEdge& edge = *rectification.restated;
  written.restated.push_back(edge);
  written.losses.push_back(lost(Code::kPoseRecomputed, edge.b, "R_left", {edge.a}));
}

std::optional<text::Document> composed(const text::Document* base, const Rig& rig, const Target& target, Style style,
                                       bool rate_known, Written& written, Diagnostics& diagnostics) {
  if (!rate_known)
    written.defaults.push_back({"Camera.fps", Message{Code::kTableInitialValue, {kStockRate, kProgram}}, true, false});
  if (colour_order_of(rig).empty()) {
    written.defaults.push_back(
        {std::string(kColourOrder), Message{Code::kTableInitialValue, {kStockColourOrder, kProgram}}, true, false});
  }
  std::string text = block_text(kCamera, camera_fields(rig, target), style);
  if (target.pair) text += "\n" + block_text(kRectifier, rectifier_fields(rig), style);
  if (base != nullptr && style == Style::kNested) text += tuning_text(*base);
  return text::parse_document({"stella_vslam.yaml", std::move(text)}, diagnostics);
}

/// Of a fresh file.
Style style_in(std::string_view layout) { return layout == kOpenVslam ? Style::kDotted : Style::kNested; }

}  // namespace

/// The lenses are still to be chosen.
std::size_t cameras_held(const Rig& rig, std::string_view /*mode*/, std::string_view /*layout*/) {
  std::vector<Message> why_not;
  return stands_as_pair(rig, why_not) ? 2 : std::min<std::size_t>(rig.cameras.size(), 1);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (rig.cameras.empty()) {
    diagnostics.add(Code::kFormatNeedsCamera, {kFormat.title});
    return std::nullopt;
  }
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  std::vector<Message> why_not;
  Target target;
  target.pair = is_pair(rig, why_not);
  const std::optional<double> rate = options.frame_rate_hz ? options.frame_rate_hz : rig.cameras.front().frame_rate_hz;
  target.frame_rate_hz = rate.value_or(kStockRate);
  const bool is_of_layout = options.layout.empty() || (there && style_of(*base) == style_in(options.layout));
  const bool keeps_text =
      there && !options.rewrite && is_of_layout && (there->cameras.size() > 1) == target.pair && keeps_panorama(*there, rig);
  const text::Document* const edits = keeps_text ? base : nullptr;
  if (!are_storable(rig, target, edits != nullptr ? &*there : nullptr, diagnostics)) return std::nullopt;

  Written written;
  const Style style = edits != nullptr ? style_of(*edits) : style_in(options.layout);
  Target before = target;
  if (edits != nullptr) before.frame_rate_hz = there->cameras.front().frame_rate_hz.value_or(kStockRate);
  std::optional<text::Document> document =
      edits != nullptr ? std::optional(edited(*edits, *there, with_words_of(*there, rig), before, target))
                       : composed(base, rig, target, style, rate.has_value(), written, diagnostics);
  if (!document) return std::nullopt;
  if (base != nullptr && edits == nullptr) add_rewritten(*base, *document, Message{}, written.losses);
  const bool dotted = style == Style::kDotted;
  written.files.push_back({*std::move(document), {}, {dotted ? "openvslam" : "stella"}});
  for (const Camera& camera : std::span(rig.cameras).first(target.pair ? 2 : 1))
    written.files.front().cameras.push_back(camera.name);
  if (target.pair) list_restated(rig, written);

  // A file that is composed in the base's place keeps what tunes the program there.
  std::vector<ExtraField> kept = edits != nullptr ? there->extra_fields : std::vector<ExtraField>();
  if (there && edits == nullptr && style == Style::kNested && style_of(*base) == Style::kNested) {
    std::ranges::copy_if(there->extra_fields, std::back_inserter(kept),
                         [](const ExtraField& extra) { return extra.key.starts_with(kTuning); });
  }
  add_extras_lost(rig, edits != nullptr ? kept : said_in(rig, target, kept), edits != nullptr ? std::nullopt : there,
                  Message{Code::kFilesHaveNoPlace, {kProgram}}, written.losses);
  list_losses(rig, target, written.losses);
  written.headline = {
      Code::kOrbslam3Headline,
      {Message{Code::kOrbslam3For,
               {std::vector<std::string>{std::string(dotted ? "OpenVSLAM" : kProgram)}, std::vector<Message>()}},
       setup_of(rig, target), why_not}};
  if (rig.cameras.size() > 1) written.first_is_left = {Code::kSlamFirstIsLeft, {kProgram}};
  return written;
}

}  // namespace fca::stella
