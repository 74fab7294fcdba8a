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
#include <iterator>

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

/// The base's edit, if there is a base that can be edited; else `why` says what stands against it.
std::optional<Edited> try_edit(const text::Document* base, const Rig& rig, const WriteOptions& options, std::string& why) {
  if (base == nullptr || options.anew) return std::nullopt;
  const std::optional<Base> read = read_base(*base, rig);
  if (!read) return std::nullopt;
  if (!options.layout.empty() && options.layout != name_of_layout(read->layout)) {
    why = "another layout was asked for";
    return std::nullopt;
  }
  if (!options.extension.empty() && !same_syntax(base->syntax(), syntax_for(options.extension))) {
    why = "another syntax was asked for";
    return std::nullopt;
  }
  return edit(*read, rig, why);
}

/// stereo_calib's extrinsics.yml: R and T alone.
text::Document edited_pose(const text::Document& base, const Rig& rig) {
  text::Document document = base;
  Diagnostics ignored;
  const std::optional<Layout> layout = find_layout(base);
  const std::optional<Rig> old = read(std::span(&base, 1), {}, ignored);
  if (!layout || !old) return document;
  const auto fields_of = [&](const Rig& says) { return stereo_pose_fields(says, "cam0", "cam1", *layout, &base); };
  fields::apply(document, document.root(), kDialect, fields_of(*old), fields_of(rig));
  return document;
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

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Written written;
  const bool base_is_pose = [&] {
    const std::optional<Layout> layout = base != nullptr ? find_layout(*base) : std::nullopt;
    return layout && layout->cameras.empty();
  }();
  if (rig.cameras.empty()) {
    if (!base_is_pose) {
      diagnostics.error("no-camera", "an OpenCV calibration needs a camera and the input has none");
      return std::nullopt;
    }
    written.files.push_back({edited_pose(*base, rig), {}, {}});
    written.headline = "the pose of a stereo pair";
    return written;
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
    if (samples_read(edited->layout, rig)) file.programs = {"opencv"};
    written.files.push_back(std::move(file));
    written.headline = headline(name_of_layout(edited->layout), rig);
    // What the file itself says beside its cameras is still there.
    std::vector<AsRead> elsewhere;
    std::ranges::copy_if(rig.as_read, std::back_inserter(elsewhere), [&edited](const AsRead& extra) {
      return std::ranges::find(edited->old.as_read, extra) == edited->old.as_read.end();
    });
    add_not_carried(elsewhere, "OpenCV's files have no key for it", written.losses);
  } else {
    const std::optional<std::string> layout = choose_layout(base, rig, options, diagnostics);
    if (!layout) return std::nullopt;
    const text::Syntax syntax = options.extension.empty() && base != nullptr ? base->syntax() : syntax_for(options.extension);
    if (!compose(rig, *layout, syntax, options.extension, written, diagnostics)) return std::nullopt;
    written.headline = headline(*layout, rig);
    add_not_carried(rig.as_read, "a new file has no place for it", written.losses);
    if (base != nullptr) add_composed_anew(*base, written.files.front().document, why, written.losses);
    if (const std::optional<Base> old = base != nullptr ? read_base(*base, rig) : std::nullopt)
      add_not_carried(extras_beyond(old->rig.as_read, rig.as_read), "a new file has no place for it", written.losses);
  }
  list_losses(rig, written.losses);
  return written;
}

}  // namespace fca::opencv
