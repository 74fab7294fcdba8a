// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "compose.h"
#include "edit.h"
#include "layout.h"
#include "opencv.h"

#include "../losses.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <utility>

namespace fca::opencv {

namespace {

/// What none of OpenCV's samples has a key for.
void list_losses(const Rig& rig, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) add_stream(camera, "OpenCV's files have no key for it", losses);
  for (const Imu& imu : rig.imus) {
    losses.push_back({"imu-dropped", imu.name + " noise and rate", "OpenCV's files have no key for them", ""});
  }
  if (rig.baseline_m) {
    losses.push_back({"baseline-dropped", "baseline " + text::format_short(*rig.baseline_m) + " m",
                      "OpenCV's files state poses of cameras, and the second camera is not in the input", ""});
  }
}

constexpr std::string_view kHolds = "only cameras, image sizes and poses are written into an OpenCV file";

/// What was read elsewhere and stays there. A file that is edited keeps what it says itself.
void list_extras(std::span<const ExtraField> extras, std::span<const ExtraField> there, std::vector<Loss>& losses) {
  std::vector<ExtraField> contradicting;
  std::vector<ExtraField> unknown;
  for (const ExtraField& extra : extras_beyond(extras, there)) {
    const bool known = std::ranges::any_of(
        there, [&extra](const ExtraField& own) { return own.owner == extra.owner && own.key == extra.key; });
    (known ? contradicting : unknown).push_back(extra);
  }
  add_not_carried(contradicting, std::string(kHolds) + "; the one written into keeps its own", losses);
  add_not_carried(unknown, kHolds, losses);
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
std::optional<Edited> try_edit(const text::Document* base, const Rig& rig, const WriteOptions& options, std::string& why) {
  if (base == nullptr || options.anew) return std::nullopt;
  const std::optional<Base> read = read_base(*base, rig);
  if (!read) return std::nullopt;
  if (!options.layout.empty() && options.layout != name_of_layout(read->layout)) {
    why = "another layout was asked for";
    return std::nullopt;
  }
  if (wants_other_syntax(*base, options)) {
    why = "another syntax was asked for";
    return std::nullopt;
  }
  return edit(*read, rig, why);
}

/// What the rig says of its cameras and a file of R and T alone cannot. write_calibration() speaks of the poses of cameras that
/// a file holds, and this one holds none.
void list_losses_beside_pose(const Rig& rig, const PoseEdge& kept, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) {
    losses.push_back({"camera-dropped", camera.name + " (" + std::string(model_info(camera.model).id) + ")",
                      "the file written into holds R and T of a pair and no camera",
                      "--to opencv -o OTHER.yml writes the cameras into a file of their own"});
  }
  Rig stated;
  stated.poses = {kept};
  std::vector<std::string> poses;
  for (const PoseEdge& edge : rig.poses) {
    const bool of_camera = rig.find_camera(edge.a) != nullptr || rig.find_camera(edge.b) != nullptr;
    if (of_camera && !stated.resolve(edge.a, edge.b)) poses.push_back("T_" + edge.a + "_" + edge.b);
  }
  if (!poses.empty())
    losses.push_back({"pose-dropped", text::enumerated(poses), "the file written into holds the pose of one pair", ""});
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
std::string why_first_is_left(const std::string& layout, const Rig& rig) {
  if (rig.cameras.size() != 2 || layout == "cameras") return "";
  return "StereoBM and StereoSGBM take the first camera of a rectified pair for the left one";
}

/// Takes R and T from saying what they say to the pose of the rig's pair; a rig without one leaves them alone.
std::optional<Written> write_pose(const text::Document& base, const Rig& rig, Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Layout> layout = find_layout(base);
  const std::optional<Rig> old = read(std::span(&base, 1), {}, ignored);
  if (!layout || !old) {
    diagnostics.error("no-calibration", "R and T of the file written into cannot be read", base.source().range({0, 1}));
    return std::nullopt;
  }
  const auto [first, second] = pair_in(rig);
  const std::vector<fields::Field> before = stereo_pose_fields(*old, "cam0", "cam1", *layout, &base);
  const std::vector<fields::Field> after = stereo_pose_fields(rig, first, second, *layout, &base);
  text::Document document = base;
  if (!after.empty()) fields::apply(document, document.root(), kDialect, before, after);
  Written written;
  written.files.push_back({std::move(document), {}, {}});
  written.headline = in_words("the pose of a stereo pair");
  written.first_is_left = in_words(why_first_is_left("stereo", rig));
  StaleKeys stale;
  const Transform* was = old->stated("cam1", "cam0");
  const bool moved = !after.empty() && was != nullptr && rig.resolve(second, first) != *was;
  stale.add(base.root(), keys_of(*layout, ""), {false, moved}, "");
  stale.tell(base, written.losses, diagnostics);
  list_losses_beside_pose(rig, {second, first, {}}, written.losses);
  list_extras(rig.extra_fields, old->extra_fields, written.losses);
  list_losses(rig, written.losses);
  return written;
}

/// The layout asked for, the base's if that can hold the rig, else the samples'.
std::optional<std::string> choose_layout(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                         Diagnostics& diagnostics) {
  if (!options.layout.empty()) {
    const std::string problem = problem_with_layout(options.layout, rig);
    if (problem.empty()) return options.layout;
    diagnostics.error("layout-not-served", "the layout " + options.layout + " cannot hold this rig: " + problem, {},
                      "leave out --opencv-layout, or choose " + default_layout(rig));
    return std::nullopt;
  }
  if (base != nullptr) {
    const std::optional<Layout> layout = find_layout(*base);
    if (layout && !layout->cameras.empty()) {
      std::string name = name_of_layout(*layout);
      // A second camera wants another file, or another layout.
      const bool fits = layout->cameras.size() == rig.cameras.size() || layout->in_maps();
      if (fits && problem_with_layout(name, rig).empty()) return name;
    }
  }
  return default_layout(rig);
}

std::string headline(const std::string& layout, const Rig& rig) {
  if (layout == "calibration" && kind_of(rig.cameras.front().model) != Kind::kOmnidir)
    return "the keys of OpenCV's camera_calibration sample";
  if (layout == "stereo" && kind_of(rig.cameras.front().model) != Kind::kOmnidir)
    return "the keys of OpenCV's stereo_calib sample, intrinsics and extrinsics in one file";
  if (layout == "cameras") return "MC-Calib's keys, one camera_<i> per camera";
  if (layout == "left-right") return "camera_matrix_left and camera_matrix_right";
  return "the keys of ccalib's omnidir samples";
}

/// Sizes that the edited file has no keys for: it would have to begin to state one for both cameras.
void list_lost_sizes(const Rig& rig, const Layout& layout, std::vector<Loss>& losses) {
  if (layout.in_maps() || layout.size.stated()) return;
  for (const Camera& camera : rig.cameras) {
    if (!camera.image_size) continue;
    losses.push_back(
        {"image-size-dropped",
         camera.name + " " + std::to_string(camera.image_size->width) + "x" + std::to_string(camera.image_size->height),
         "the keys written into hold one image size for both cameras, and theirs differ",
         "--opencv-layout cameras has a size for each"});
  }
}

/// The file was read as the caller said, and does not say it itself.
void tell_ambiguous(const Rig& rig, Written& written, Diagnostics& diagnostics) {
  const bool fisheye = kind_of(rig.cameras.front().model) == Kind::kFisheye;
  written.opencv_model = fisheye ? "fisheye" : "pinhole";
  diagnostics.note("ambiguous-model",
                   "what is written does not say what its four coefficients are; they are meant as " + written.opencv_model +
                       " (" + (fisheye ? "cv::fisheye" : "cv::projectPoints") + ")",
                   {}, "--opencv-model " + written.opencv_model + " reads it so");
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Written written;
  const bool anew = options.anew || !options.layout.empty() || (base != nullptr && wants_other_syntax(*base, options));
  if (is_pose_alone(base) && (rig.cameras.empty() || !anew)) return write_pose(*base, rig, diagnostics);
  if (rig.cameras.empty()) {
    diagnostics.error("no-camera", "an OpenCV calibration needs a camera and the input has none");
    return std::nullopt;
  }
  if (!options.layout.empty() && std::ranges::find(kLayoutNames, options.layout) == kLayoutNames.end()) {
    diagnostics.error("unknown-layout", "OpenCV files have no layout '" + options.layout + "'");
    return std::nullopt;
  }
  std::string why;
  std::optional<Edited> edited = try_edit(base, rig, options, why);
  if (!can_store(kFormat, rig, edited ? &edited->old : nullptr, diagnostics)) return std::nullopt;
  if (edited) {
    Written::File file{std::move(edited->document), {}, {}};
    for (const Camera& camera : rig.cameras) file.cameras.push_back(camera.name);
    if (samples_read(edited->layout, rig, edited->ambiguous)) file.programs = {"opencv"};
    written.files.push_back(std::move(file));
    written.headline = in_words(headline(name_of_layout(edited->layout), rig));
    written.first_is_left = in_words(why_first_is_left(name_of_layout(edited->layout), rig));
    if (edited->ambiguous) tell_ambiguous(rig, written, diagnostics);
    edited->stale.tell(*base, written.losses, diagnostics);
    list_extras(rig.extra_fields, edited->old.extra_fields, written.losses);
    list_lost_sizes(rig, edited->layout, written.losses);
  } else {
    const std::optional<std::string> layout = choose_layout(base, rig, options, diagnostics);
    if (!layout) return std::nullopt;
    const bool as_base = base != nullptr && !names_syntax(options.extension);
    const text::Syntax syntax = as_base ? base->syntax() : syntax_for(options.extension);
    if (!compose(rig, *layout, syntax, options.extension, written, diagnostics)) return std::nullopt;
    written.headline = in_words(headline(*layout, rig));
    written.first_is_left = in_words(why_first_is_left(*layout, rig));
    list_extras(rig.extra_fields, {}, written.losses);
    if (base != nullptr) {
      add_composed_anew(*base, written.files.front().document, why, written.losses);
      add_not_carried(extras_beyond(extras_of(*base), rig.extra_fields), "the file is composed anew", written.losses);
    }
  }
  list_losses(rig, written.losses);
  return written;
}

}  // namespace fca::opencv
