// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "compose.h"
#include "edit.h"
#include "layout.h"
#include "opencv.h"

#include "../losses.h"

#include <fca/code.h>

#include <algorithm>
#include <utility>

namespace fca::opencv {

namespace {

/// What none of OpenCV's samples has a key for.
void list_losses(const Rig& rig, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) add_stream(camera, Message{Code::kOpencvHasNoKey}, losses);
  for (const Imu& imu : rig.imus) losses.push_back(lost(Code::kOpencvImuDropped, imu.name, ""));
  if (rig.baseline_m) losses.push_back(lost(Code::kOpencvBaselineDropped, "", "baseline", {*rig.baseline_m}));
}

/// What was read elsewhere and stays there. A file that is edited keeps what it says itself.
void list_extras(std::span<const ExtraField> extras, std::span<const ExtraField> there, std::vector<Loss>& losses) {
  std::vector<ExtraField> contradicting;
  std::vector<ExtraField> unknown;
  for (const ExtraField& extra : extras_beyond(extras, there)) {
    const bool known = std::ranges::any_of(
        there, [&extra](const ExtraField& own) { return own.owner == extra.owner && own.key == extra.key; });
    (known ? contradicting : unknown).push_back(extra);
  }
  const Message holds = {Code::kOpencvHolds};
  add_not_carried(contradicting, Message{Code::kOpencvKeepsItsOwn, {holds}}, losses);
  add_not_carried(unknown, holds, losses);
}

/// stereo_calib's extrinsics.yml: R and T without a camera.
bool is_pose_alone(const text::Document* base) {
  const std::optional<Layout> layout = base != nullptr ? find_layout(*base) : std::nullopt;
  return layout && layout->cameras.empty();
}

/// Does another syntax than the base's follow from the name of the file to be written?
bool wants_other_syntax(const text::Document& base, const WriteOptions& options) {
  return names_syntax(options.extension) && !same_syntax(base.syntax(), syntax_for(options.extension));
}

/// The base's edit, if there is a base that can be edited; else `why` says what stands against it.
std::optional<Edited> try_edit(const text::Document* base, const Rig& rig, const WriteOptions& options, Message& why) {
  if (base == nullptr || options.rewrite) return std::nullopt;
  const std::optional<Base> read = read_base(*base, rig);
  if (!read) return std::nullopt;
  if (!options.layout.empty() && options.layout != name_of_layout(read->layout)) {
    why = {Code::kOpencvOtherLayout};
    return std::nullopt;
  }
  if (wants_other_syntax(*base, options)) {
    why = {Code::kOpencvOtherSyntax};
    return std::nullopt;
  }
  return edit(*read, rig, why);
}

/// What the rig says of its cameras and a file of R and T alone cannot. write_calibration() speaks of the poses of cameras that
/// a file holds, and this one holds none.
void list_losses_beside_pose(const Rig& rig, const PoseEdge& kept, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras)
    losses.push_back(lost(Code::kOpencvCameraDropped, camera.name, "", {model_info(camera.model).id}));
  Rig stated;
  stated.poses = {kept};
  std::vector<std::string> poses;
  for (const PoseEdge& edge : rig.poses) {
    const bool of_camera = rig.find_camera(edge.a) != nullptr || rig.find_camera(edge.b) != nullptr;
    if (of_camera && !stated.resolve(edge.a, edge.b)) poses.push_back(name_of(edge));
  }
  if (!poses.empty()) losses.push_back(lost(Code::kOpencvPosesDropped, "", "", {poses}));
}

/// Which frames of the rig R and T of a file without cameras are about: those that reading it names, else the first two
/// cameras.
std::pair<std::string, std::string> pair_in(const Rig& rig) {
  const std::pair<std::string, std::string> named = {"cam0", "cam1"};
  const bool known = rig.find_camera(named.first) != nullptr && rig.find_camera(named.second) != nullptr;
  if (known || rig.cameras.size() < 2) return named;
  return {rig.cameras[0].name, rig.cameras[1].name};
}

/// Files of one pair are for rectification and matching; MC-Calib's are for rigs of any shape.
Message why_first_is_left(const std::string& layout, const Rig& rig) {
  if (rig.cameras.size() != 2 || layout == "cameras") return {};
  return {Code::kOpencvFirstIsLeft};
}

/// Takes R and T from saying what they say to the pose of the rig's pair; a rig without one leaves them alone.
std::optional<Written> write_pose(const text::Document& base, const Rig& rig, Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Layout> layout = find_layout(base);
  const std::optional<Rig> old = read(std::span(&base, 1), {}, ignored);
  if (!layout || !old) {
    diagnostics.add(Code::kOpencvPoseNotRead, {}, base.source().range({0, 1}));
    return std::nullopt;
  }
  const auto [first, second] = pair_in(rig);
  const std::vector<fields::Field> before = stereo_pose_fields(*old, "cam0", "cam1", *layout, &base);
  const std::vector<fields::Field> after = stereo_pose_fields(rig, first, second, *layout, &base);
  text::Document document = base;
  if (!after.empty()) fields::apply(document, document.root(), kDialect, before, after);
  Written written;
  written.files.push_back({std::move(document), {}, {}});
  written.headline = {Code::kOpencvWrotePose};
  written.first_is_left = why_first_is_left("stereo", rig);
  StaleKeys stale;
  const Transform* was = old->stated("cam1", "cam0");
  const bool moved = !after.empty() && was != nullptr && rig.resolve(second, first) != *was;
  stale.add(base.root(), keys_of(*layout, ""), {false, moved}, "");
  stale.tell(base, written.losses, diagnostics);
  list_losses_beside_pose(rig, {second, first, {}}, written.losses);
  list_extras(rig.extra_fields, old->extra_fields, written.losses);
  list_losses(rig, written.losses);
  written.states_rectification = old->rectified == rig.rectified;
  return written;
}

/// The layout asked for, the base's if that can hold the rig, else the samples'.
std::optional<std::string> choose_layout(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                         Diagnostics& diagnostics) {
  if (!options.layout.empty()) {
    const Message problem = problem_with_layout(options.layout, rig);
    if (!problem.is_said()) return options.layout;
    diagnostics.add(Code::kOpencvLayoutNotServed, {options.layout, problem, default_layout(rig)});
    return std::nullopt;
  }
  if (base != nullptr) {
    const std::optional<Layout> layout = find_layout(*base);
    if (layout && !layout->cameras.empty()) {
      std::string name = name_of_layout(*layout);
      // A second camera wants another file, or another layout.
      const bool fits = layout->cameras.size() == rig.cameras.size() || layout->in_maps();
      if (fits && !problem_with_layout(name, rig).is_said()) return name;
    }
  }
  return default_layout(rig);
}

Message headline(const std::string& layout, const Rig& rig) {
  const bool omnidir = kind_of(rig.cameras.front().model) == Kind::kOmnidir;
  if (layout == "calibration" && !omnidir) return {Code::kOpencvWroteCalibration};
  if (layout == "stereo" && !omnidir) return {Code::kOpencvWroteStereo};
  if (layout == "cameras") return {Code::kOpencvWroteMaps};
  return {layout == "left-right" ? Code::kOpencvWroteLeftRight : Code::kOpencvWroteOmnidir};
}

/// Sizes that the edited file has no keys for: it would have to begin to specify one for both cameras.
void list_lost_sizes(const Rig& rig, const Layout& layout, std::vector<Loss>& losses) {
  if (layout.in_maps() || layout.size.stated()) return;
  for (const Camera& camera : rig.cameras) {
    if (!camera.image_size) continue;
    const ImageSize size = *camera.image_size;
    losses.push_back(lost(Code::kOpencvSizeDropped, camera.name, "image size", {size.width, size.height}));
  }
}

/// The file was read as the caller said, and does not say it itself.
void tell_ambiguous(const Rig& rig, Written& written, Diagnostics& diagnostics) {
  const bool fisheye = kind_of(rig.cameras.front().model) == Kind::kFisheye;
  written.opencv_model = fisheye ? OpenCvModel::kFisheye : OpenCvModel::kPinhole;
  diagnostics.add(Code::kOpencvWrittenAmbiguous,
                  {name_of(*written.opencv_model), fisheye ? "cv::fisheye" : "cv::projectPoints"});
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Written written;
  const bool rewrite = options.rewrite || !options.layout.empty() || (base != nullptr && wants_other_syntax(*base, options));
  if (is_pose_alone(base) && (rig.cameras.empty() || !rewrite)) return write_pose(*base, rig, diagnostics);
  if (rig.cameras.empty()) {
    diagnostics.add(Code::kOpencvNoCamera);
    return std::nullopt;
  }
  if (!options.layout.empty() && std::ranges::find(kLayoutNames, options.layout) == kLayoutNames.end()) {
    diagnostics.add(Code::kOpencvUnknownLayout, {options.layout});
    return std::nullopt;
  }
  Message why;
  std::optional<Edited> edited = try_edit(base, rig, options, why);
  if (!can_store(kFormat, rig, edited ? &edited->old : nullptr, diagnostics)) return std::nullopt;
  if (edited) {
    Written::File file{std::move(edited->document), {}, {}};
    for (const Camera& camera : rig.cameras) file.cameras.push_back(camera.name);
    if (samples_read(edited->layout, rig, edited->ambiguous)) file.programs = {"opencv"};
    written.files.push_back(std::move(file));
    written.headline = headline(name_of_layout(edited->layout), rig);
    written.first_is_left = why_first_is_left(name_of_layout(edited->layout), rig);
    if (edited->ambiguous) tell_ambiguous(rig, written, diagnostics);
    edited->stale.tell(*base, written.losses, diagnostics);
    list_extras(rig.extra_fields, edited->old.extra_fields, written.losses);
    list_lost_sizes(rig, edited->layout, written.losses);
    written.states_rectification = edited->old.rectified == rig.rectified;
  } else {
    const std::optional<std::string> layout = choose_layout(base, rig, options, diagnostics);
    if (!layout) return std::nullopt;
    const bool as_base = base != nullptr && !names_syntax(options.extension);
    const text::Syntax syntax = as_base ? base->syntax() : syntax_for(options.extension);
    if (!compose(rig, *layout, syntax, options.extension, written, diagnostics)) return std::nullopt;
    written.headline = headline(*layout, rig);
    written.first_is_left = why_first_is_left(*layout, rig);
    list_extras(rig.extra_fields, {}, written.losses);
    if (base != nullptr) {
      add_rewritten(*base, written.files.front().document, why, written.losses);
      add_not_carried(extras_beyond(extras_of(*base), rig.extra_fields), Message{Code::kFileRewritten}, written.losses);
    }
  }
  list_losses(rig, written.losses);
  return written;
}

}  // namespace fca::opencv
