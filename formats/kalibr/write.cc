// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "edit.h"
#include "kalibr.h"
#include "layout.h"
#include "overlaps.h"

#include "../composed.h"
#include "../losses.h"

#include <fca/code.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace fca::kalibr {

namespace {

/// A fresh camchain in Kalibr's own layout, but with the rows of transforms indented deeper than their key: OpenVINS then needs
/// only its first line added. `overlaps`: cam_overlaps of every camera that has it.
std::optional<text::Document> compose(const Rig& rig, std::span<const std::optional<fields::Field>> overlaps,
                                      Diagnostics& diagnostics) {
  ComposedYaml chain("");
  for (std::size_t i = 0; i < rig.cameras.size(); ++i)
    chain.add_mapping(indexed("cam", i), camera_fields(rig, i, overlaps[i]), 2);
  return std::move(chain).document("camchain.yaml", diagnostics);
}

/// Does an input that is no edit of the base count the rig's cameras? One that is written into another file counts its own.
bool counts_as_rig(const text::Document* base, const WriteOptions& options) {
  return base == nullptr || !options.joined.empty();
}

/// What every camera's cam_overlaps is to say: what the base says of its own, and of others what their files say.
std::vector<std::optional<fields::Field>> overlaps_of(const text::Document* base, const std::optional<Rig>& old, const Rig& rig,
                                                      const WriteOptions& options) {
  std::vector<std::optional<fields::Field>> result;
  for (const Camera& camera : rig.cameras) {
    if (old && old->find_camera(camera.name) != nullptr) {
      result.push_back(overlaps_among(*base, camera.name, rig));
    } else {
      result.push_back(counts_as_rig(base, options) ? overlaps_read(rig, camera.name, rig) : std::nullopt);
    }
  }
  return result;
}

/// What the chain says of cam_overlaps of cameras that the base does not have, as it was read.
void add_joined(const Rig& rig, const std::optional<Rig>& old, std::span<const std::optional<fields::Field>> overlaps,
                std::vector<ExtraField>& said) {
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const std::string& name = rig.cameras[i].name;
    if (old && old->find_camera(name) != nullptr) continue;
    const ExtraField* extra = rig.find_extra_field(name, kOverlaps);
    if (extra != nullptr && is_whole(overlaps[i], *extra)) said.push_back(*extra);
  }
}

/// Chains are named cam0, cam1, ... in order: renames the rig's cameras so, and makes room for those names in the poses.
Rig renamed(const Rig& rig) {
  Rig result = rig;
  const auto new_name = [&rig](const std::string& name) {
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      if (rig.cameras[i].name == name) return indexed("cam", i);
    }
    return index_in(name, "cam") ? "left out: " + name : name;
  };
  for (Camera& camera : result.cameras) camera.name = new_name(camera.name);
  for (PoseEdge& edge : result.poses) {
    edge.a = new_name(edge.a);
    edge.b = new_name(edge.b);
  }
  return result;
}

/// A base that never stated a size need not begin to.
bool check_sizes(const Rig& rig, const Rig* old, Diagnostics& diagnostics) {
  bool good = true;
  for (const Camera& camera : rig.cameras) {
    if (camera.image_size || (old != nullptr && old->find_camera(camera.name) != nullptr)) continue;
    diagnostics.add(Code::kCamchainSizeMissing, {camera.name});
    good = false;
  }
  return good;
}

constexpr std::string_view kImuFile = "Kalibr's imu.yaml";

/// Kalibr's imu.yaml as a file of its own, if the IMU is complete.
void add_imu_file(Imu imu, Written& written, Diagnostics& diagnostics) {
  const std::vector<std::string> missing = missing_in(imu, true);
  if (!missing.empty()) {
    const Message why{Code::kCamchainImuDemands, {kImuFile, missing}};
    written.losses.push_back(lost(Code::kCamchainImuIncomplete, imu.name, "", {why}));
    return;
  }
  const std::string file_name = imu.name == "imu0" ? "imu.yaml" : imu.name + ".yaml";
  if (imu.topic.empty()) {
    imu.topic = "/" + imu.name;
    written.defaults.push_back({"rostopic (imu.yaml)", imu.topic, true, false, file_name});
  }
  ComposedYaml file("");
  for (const fields::Field& field : imu_fields(imu)) file.add(field);
  if (std::optional<text::Document> document = std::move(file).document(file_name, diagnostics))
    written.files.push_back({*std::move(document), {}, {"kalibr-imu"}});
}

/// What a chain that was composed in the base's place says of it unchanged but for the order of its cameras: cam_overlaps.
std::vector<ExtraField> taken_over(const text::Document& base, const Rig& old, const Rig& rig_as_named) {
  std::vector<ExtraField> result;
  for (const ExtraField& extra : old.extra_fields) {
    const std::string& name = extra.owner;
    if (!is_overlaps(extra) || rig_as_named.find_camera(name) == nullptr) continue;
    const std::optional<fields::Field> before = overlaps_among(base, name, old);
    const std::optional<fields::Field> now = overlaps_among(base, name, rig_as_named);
    if (before && now && before->tokens.size() == now->tokens.size()) result.push_back(extra);
  }
  return result;
}

/// What the input says besides its rig, and the chain, which says `there`, does not. `of_rig`: are the numbers of this
/// cam_overlaps those of the rig's cameras?
void list_extras(std::span<const ExtraField> extras, std::span<const ExtraField> there,
                 const std::function<bool(const ExtraField&)>& of_rig, std::vector<Loss>& losses) {
  const auto list = [&](Code why, const std::function<bool(const ExtraField&)>& those) {
    std::vector<ExtraField> some;
    std::ranges::copy_if(extras, std::back_inserter(some), those);
    add_beyond_base(some, there, Message{why}, losses);
  };
  list(Code::kCamchainNoPlace, std::not_fn(is_overlaps));
  list(Code::kCamchainOverlapsOfAbsent, [&of_rig](const ExtraField& extra) { return is_overlaps(extra) && of_rig(extra); });
  list(Code::kCamchainOverlapsOfItsFile, [&of_rig](const ExtraField& extra) { return is_overlaps(extra) && !of_rig(extra); });
}

/// What a camchain has no key for.
void list_losses(const Rig& rig, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) {
    if (camera.frame_rate_hz) {
      losses.push_back(
          lost(Code::kFrameRateDropped, camera.name, "frame rate", {Message{Code::kCamchainNoKey}, *camera.frame_rate_hz}));
    }
  }
  if (rig.baseline_m) {
    losses.push_back(lost(Code::kCamchainBaselineDropped, "", "baseline", {*rig.baseline_m}));
  }
}

/// An imu.yaml that says what `rig` does in the base's place: of the same IMUs, only numbers that differ are touched.
std::optional<text::Document> edited_imu_file(const text::Document& base, const Rig& old, const Rig& rig) {
  if (!old.cameras.empty() || !std::ranges::equal(old.imus, rig.imus, {}, &Imu::name, &Imu::name)) return std::nullopt;
  const text::Dialect dialect = dialect_of(base);
  text::Document document = base;
  for (std::size_t i = 0; i < rig.imus.size(); ++i) {
    if (old.imus[i] == rig.imus[i]) continue;
    const text::Node* named = text::find(base.root(), rig.imus[i].name, dialect);
    const text::Node& mapping = named != nullptr ? *named : base.root();
    if (!holds_noise(mapping)) return std::nullopt;
    fields::apply(document, mapping, dialect, imu_fields(old.imus[i]), imu_fields(rig.imus[i]));
  }
  return document;
}

/// A rig of IMUs alone.
std::optional<Written> write_imu_files(const text::Document* base, const Rig* old, const Rig& rig, const WriteOptions& options,
                                       Diagnostics& diagnostics) {
  Written written;
  written.headline = {Code::kCamchainImuHeadline};
  if (old != nullptr && !options.rewrite) {
    if (std::optional<text::Document> document = edited_imu_file(*base, *old, rig)) {
      written.files.push_back({*std::move(document), {}, {"kalibr-imu"}});
      return written;
    }
  }
  for (const Imu& imu : rig.imus) add_imu_file(imu, written, diagnostics);
  if (written.files.empty()) {
    if (rig.imus.empty()) {
      diagnostics.add(Code::kCamchainNoCamera, {"a camchain"});
    } else {
      diagnostics.add(Code::kCamchainImuNotGiven, {kImuFile, missing_in(rig.imus.front(), true)});
    }
    return std::nullopt;
  }
  if (base != nullptr) add_rewritten(*base, written.files.front().document, Message{}, written.losses);
  list_extras(
      rig.extra_fields, {}, [](const ExtraField&) { return false; }, written.losses);
  return written;
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig_as_named, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  // A chain that counts its cameras in its own way (cam0, cam2) keeps doing so.
  const bool same_cameras = old && std::ranges::equal(old->cameras, rig_as_named.cameras, {}, &Camera::name, &Camera::name);
  const Rig rig = same_cameras && !options.rewrite ? rig_as_named : renamed(rig_as_named);
  Written written;
  if (rig.cameras.empty()) return write_imu_files(base, old ? &*old : nullptr, rig, options, diagnostics);
  std::optional<Editor> editor;
  if (old) editor.emplace(*base, *old, rig_as_named, rig);
  if (editor && (options.rewrite || !editor->possible())) editor.reset();
  const Rig* edited = editor ? &*old : nullptr;
  if (!can_store(kFormat, rig_as_named, edited, diagnostics) || !check_sizes(rig_as_named, edited, diagnostics))
    return std::nullopt;

  const std::vector<std::optional<fields::Field>> overlaps = overlaps_of(base, old, rig_as_named, options);
  std::optional<text::Document> document =
      editor ? editor->edited(overlaps, written.losses) : compose(rig, overlaps, diagnostics);
  if (!document) return std::nullopt;
  written.files.push_back({*std::move(document), {}, {"kalibr"}});
  for (const Camera& camera : rig_as_named.cameras) written.files.front().cameras.push_back(camera.name);
  for (const Imu& imu : rig.imus) {
    const bool there = edited != nullptr && std::ranges::find(edited->imus, imu) != edited->imus.end();
    if (!there) add_imu_file(imu, written, diagnostics);
  }
  std::vector<ExtraField> kept;
  if (old) kept = editor ? old->extra_fields : taken_over(*base, *old, rig_as_named);
  add_joined(rig_as_named, old, overlaps, kept);
  const auto of_rig = [&](const ExtraField& extra) {
    return counts_as_rig(base, options) || (old && old->find_camera(extra.owner) != nullptr);
  };
  // A key of Kalibr's own, which the file to be edited had room for.
  std::vector<ExtraField> extras(rig.extra_fields.begin(), rig.extra_fields.end());
  if (old && !editor) {
    const auto of_base = std::stable_partition(extras.begin(), extras.end(), [&](const ExtraField& extra) {
      return is_overlaps(extra) || std::ranges::find(old->extra_fields, extra) == old->extra_fields.end();
    });
    add_not_carried({of_base, extras.end()}, Message{Code::kCamchainRewritten}, written.losses);
    extras.erase(of_base, extras.end());
  }
  list_extras(extras, kept, of_rig, written.losses);
  if (old && !editor) {
    add_rewritten(*base, written.files.front().document, Message{}, written.losses);
    std::vector<ExtraField> gone = extras_beyond(extras_beyond(old->extra_fields, rig.extra_fields), kept);
    // Of a camera that nobody asked for nothing is missed.
    std::erase_if(gone, [&old, &rig_as_named](const ExtraField& extra) {
      return old->find_camera(extra.owner) != nullptr && rig_as_named.find_camera(extra.owner) == nullptr;
    });
    const auto overlaps_gone = std::stable_partition(gone.begin(), gone.end(), std::not_fn(is_overlaps));
    list_extras({overlaps_gone, gone.end()}, {}, of_rig, written.losses);
    gone.erase(overlaps_gone, gone.end());
    add_not_carried(gone, Message{Code::kCamchainRewritten}, written.losses);
  }
  list_losses(rig_as_named, written.losses);
  written.headline = {Code::kCamchainHeadline};
  return written;
}

}  // namespace fca::kalibr
