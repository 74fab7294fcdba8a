// SPDX-License-Identifier: BSD-3-Clause
#include "compose.h"
#include "config.h"
#include "vins.h"

#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca::vins {

using fields::Field;
using text::Node;

namespace {

constexpr std::string_view kImu = "imu0";

/// Alike but for what dividing by a root and multiplying with it rounds.
bool agrees(double a, double b) {
  constexpr double kRounding = 1e-14;
  return std::abs(a - b) <= kRounding * std::abs(b);
}

std::string numbered(std::string_view before, std::size_t index, std::string_view after) {
  return std::string(before) + std::to_string(index) + std::string(after);
}

/// A name that leads nowhere but next to the configuration.
bool is_plain_file(std::string_view name) {
  return !name.empty() && name.find_first_of("/\\") == std::string_view::npos && !name.starts_with('.');
}

class Editor {
 public:
  Editor(text::Document base, const Rig& old, const Rig& rig)
      : document_(std::move(base)),
        root_(document_.root()),
        old_(old),
        rig_(rig),
        used_(std::min(rig.cameras.size(), kMostCameras)) {}

  /// The camera files' names; what the configuration does not name, or leads elsewhere, is named again.
  std::vector<std::string> file_names() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < used_; ++i) {
      const Node* stated = text::find(root_, numbered("cam", i, "_calib"), kDialect);
      std::string name = stated != nullptr && is_plain_file(stated->value) ? stated->value : numbered("cam", i, ".yaml");
      // One file for both cameras (KITTI's) serves only where they are one.
      if (i == 1 && name == names.front() && rig_.cameras[0].model != rig_.cameras[1].model) name = "cam1.yaml";
      names.push_back(std::move(name));
    }
    return names;
  }

  text::Document run(const std::vector<std::string>& names, Written& written, Diagnostics& diagnostics) {
    std::vector<Field> after;
    const Node* count = text::find(root_, "num_of_cam", kDialect);
    const int before = count != nullptr ? text::parse_int(count->value).value_or(0) : 0;
    if (static_cast<int>(used_) > before) after.push_back(fields::integer("num_of_cam", static_cast<int>(used_)));
    for (std::size_t i = 0; i < used_; ++i) {
      if (!rig_.cameras[i].topic.empty()) after.push_back(text_field(numbered("image", i, "_topic"), rig_.cameras[i].topic));
    }
    for (std::size_t i = 0; i < used_; ++i) after.push_back(text_field(numbered("cam", i, "_calib"), names[i]));
    if (used_ > 0) {
      const ImageSize size = rig_.cameras.front().image_size.value_or(ImageSize{});
      after.push_back(fields::integer("image_width", size.width));
      after.push_back(fields::integer("image_height", size.height));
    }
    add_poses(after, diagnostics);
    add_noise(after, written, diagnostics);
    const std::optional<double> offset = used_ > 0 ? rig_.cameras.front().time_offset_s : std::nullopt;
    if (offset) after.push_back(fields::real("td", *offset));
    fields::apply(document_, root_, kDialect, stated(after), after);
    return std::move(document_);
  }

 private:
  /// A text as the key has it, with quotes or without.
  Field text_field(const std::string& key, const std::string& value) const {
    const Node* stated = text::find(root_, key, kDialect);
    return stated != nullptr && !stated->quoted && stated->value == value ? fields::scalar(key, value)
                                                                          : fields::quoted(key, value);
  }

  void add_poses(std::vector<Field>& after, Diagnostics& diagnostics) const {
    for (std::size_t i = 0; i < (used_ > 0 ? used_ : kMostCameras); ++i) {
      const std::string camera = used_ > 0 ? rig_.cameras[i].name : numbered("cam", i, "");
      const Transform* stated = rig_.stated(kImu, camera);
      const std::optional<Transform> T = stated != nullptr ? *stated : rig_.resolve(kImu, camera);
      const std::string key = numbered("body_T_cam", i, "");
      if (T) {
        after.push_back(fields::matrix(key, T->values, 4, "d"));
      } else if (used_ > 0 && text::find(root_, key, kDialect) != nullptr) {
        diagnostics.add(Code::kVinsPoseKept, {key, camera});
      }
    }
  }

  /// Samples' noise from densities; without a rate nobody can tell.
  void add_noise(std::vector<Field>& after, Written& written, Diagnostics& diagnostics) const {
    if (rig_.imus.empty()) return;
    const Imu& imu = rig_.imus.front();
    const bool complete = std::ranges::all_of(kNoises, [&imu](const Noise& noise) { return (imu.*noise.density).has_value(); });
    if (!complete || !imu.rate_hz) {
      written.losses.push_back(lost(Code::kVinsNoiseDropped, imu.name, ""));
      return;
    }
    const double root = std::sqrt(*imu.rate_hz);
    for (const Noise& noise : kNoises) after.push_back(fields::real(std::string(noise.key), *(imu.*noise.density) * root));
    diagnostics.add(Code::kVinsNoiseConverted, {imu.name, *imu.rate_hz});
  }

  /// What the configuration says under the keys of `after`, whatever its spelling.
  std::vector<Field> stated(const std::vector<Field>& after) const {
    std::vector<Field> result;
    for (const Field& field : after) {
      const Node* node = text::find(root_, field.key, kDialect);
      if (node == nullptr) continue;
      if (field.shape != fields::Shape::kMatrix) {
        const std::optional<double> number = text::parse_real(node->value);
        const std::optional<double> wanted = text::parse_real(field.tokens.front());
        const bool same = number && wanted && agrees(*number, *wanted);
        result.push_back(same ? field : fields::scalar(field.key, node->value));
        continue;
      }
      const auto pose =
          std::ranges::find_if(old_.poses, [&field](const PoseEdge& edge) { return field.key == "body_T_" + edge.b; });
      if (pose != old_.poses.end()) result.push_back(fields::matrix(field.key, pose->T_a_b.values, 4, "d"));
    }
    return result;
  }

  text::Document document_;
  const Node& root_;
  const Rig& old_;
  const Rig& rig_;
  std::size_t used_;
};

/// td [s]: what the configuration says in the end.
void list_losses(const Rig& rig, double td, std::vector<Loss>& losses) {
  const Message no_place{Code::kVinsConfigurationHasNoPlace};
  Rig used = rig;
  used.cameras.resize(std::min(rig.cameras.size(), kMostCameras));
  add_other_time_offsets(used, td, Message{Code::kVinsHasOneTd}, losses);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    Camera camera = rig.cameras[i];
    if (i >= kMostCameras) {
      losses.push_back(lost(Code::kVinsCameraDropped, camera.name, ""));
      continue;
    }
    camera.topic.clear();
    camera.time_offset_s.reset();
    add_stream(camera, no_place, losses);
  }
  for (std::size_t i = 0; i < rig.imus.size(); ++i) {
    const Imu& imu = rig.imus[i];
    if (i > 0) losses.push_back(lost(Code::kVinsSecondImuDropped, imu.name, ""));
    if (i == 0 && !imu.topic.empty())
      losses.push_back(lost(Code::kTopicDropped, imu.name, "topic", {Message{Code::kVinsImuTopicNotTouched}, imu.topic}));
  }
  if (rig.baseline_m) losses.push_back(lost(Code::kVinsBaselineDropped, "", "baseline", {*rig.baseline_m, no_place}));
}

/// td [s] as it will be; a note where the base's stays.
double td_of(const text::Document& base, const Rig& rig, Diagnostics& diagnostics) {
  if (!rig.cameras.empty() && rig.cameras.front().time_offset_s) return *rig.cameras.front().time_offset_s;
  const Node* node = text::find(base.root(), "td", kDialect);
  const double td = node != nullptr ? text::parse_real(node->value).value_or(0.0) : 0.0;
  if (td != 0.0 && !rig.cameras.empty()) diagnostics.add(Code::kVinsTimeOffsetKept, {node->value, rig.cameras.front().name});
  return td;
}

/// A camera of the base that no camera file was found for has no place next to others.
void warn_of_missing_cameras(const text::Document& base, std::size_t used, Diagnostics& diagnostics) {
  const Node* count = text::find(base.root(), "num_of_cam", kDialect);
  const int before = count != nullptr ? text::parse_int(count->value).value_or(0) : 0;
  if (used == 0 || before <= static_cast<int>(used)) return;
  diagnostics.add(Code::kVinsCameraKept, {count->value, numbered("cam", used, ""), used}, base.range(*count));
}

/// The second camera alone would be written as the first, next to the base's own second.
bool keeps_its_place(const text::Document& base, const Rig& rig, Diagnostics& diagnostics) {
  const Node* count = text::find(base.root(), "num_of_cam", kDialect);
  const bool pair = count != nullptr && text::parse_int(count->value) == static_cast<int>(kMostCameras);
  if (!pair || rig.cameras.size() != 1 || rig.cameras.front().name != "cam1") return true;
  diagnostics.add(Code::kVinsCameraMisplaced, {}, base.range(*count));
  return false;
}

/// A warning where the configuration was for images of another size; cameras of its own were compared when they were read.
void warn_of_other_images(const text::Document& base, const Rig& old, const Rig& rig, Diagnostics& diagnostics) {
  const Node* width = text::find(base.root(), "image_width", kDialect);
  const Node* height = text::find(base.root(), "image_height", kDialect);
  if (!old.cameras.empty() || rig.cameras.empty() || width == nullptr || height == nullptr) return;
  const ImageSize size = rig.cameras.front().image_size.value_or(ImageSize{});
  if (width->value == std::to_string(size.width) && height->value == std::to_string(size.height)) return;
  const double columns = text::parse_real(width->value).value_or(0.0);
  const double rows = text::parse_real(height->value).value_or(0.0);
  constexpr double kSameShape = 0.02;
  const bool may_be_scaled = std::abs(columns * size.height - rows * size.width) <= kSameShape * columns * size.height;
  std::vector<Message> scaled;
  if (may_be_scaled) scaled.push_back({Code::kVinsIfScaled, {width->value, height->value}});
  diagnostics.add(Code::kVinsOtherImages, {width->value, height->value, size.width, size.height, scaled}, base.range(*width));
}

bool same_size(const Rig& rig, Diagnostics& diagnostics) {
  if (rig.cameras.size() < 2 || rig.cameras[0].image_size == rig.cameras[1].image_size) return true;
  diagnostics.add(Code::kVinsSizesDiffer);
  return false;
}

}  // namespace

std::optional<Written> write_config(const text::Document& base, const Rig& rig, Diagnostics& diagnostics) {
  // Poses alone go there, too.
  const bool writable = rig.cameras.empty() || writable_alone(kFormat, rig, Message{Code::kVinsWantsSize}, diagnostics);
  if (!writable || !same_size(rig, diagnostics) || !keeps_its_place(base, rig, diagnostics)) return std::nullopt;
  Diagnostics ignored;
  const std::optional<Rig> old = read(std::span(&base, 1), {}, ignored);
  if (!old) {
    diagnostics.add(Code::kVinsConfigurationUnreadable, {}, base.source().range({0, 1}));
    return std::nullopt;
  }
  warn_of_other_images(base, *old, rig, diagnostics);
  warn_of_missing_cameras(base, std::min(rig.cameras.size(), kMostCameras), diagnostics);
  Written written;
  Editor editor(base, *old, rig);
  const std::vector<std::string> names = editor.file_names();
  written.files.push_back({editor.run(names, written, diagnostics), {}, {"vins-config"}});
  written.files.back().named = true;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    if (i > 0 && names[i] == names.front()) {
      written.files.back().cameras.push_back(camera.name);
      continue;
    }
    std::optional<text::Document> document = fresh_camera_file(camera, kNameless, names[i], written, diagnostics);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {"vins"}, true});
  }
  list_losses(rig, td_of(base, rig, diagnostics), written.losses);
  add_beyond_base(rig.extra_fields, old->extra_fields, Message{Code::kVinsConfigurationHasNoPlace}, written.losses);
  written.headline = {Code::kVinsConfiguration};
  return written;
}

}  // namespace fca::vins
