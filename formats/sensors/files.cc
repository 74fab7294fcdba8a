// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"

#include "../losses.h"
#include "../one_camera_files.h"
#include "keys.h"

#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <filesystem>

namespace fca::sensors {

using schema::Subject;
using text::Node;

namespace {

/// A document of one camera or one IMU.
bool read_document(const Files& files, const text::Document& document, const ReadOptions& options, Rig& rig,
                   Diagnostics& diagnostics) {
  const Node& root = document.root();
  if (!root.is_mapping()) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {document.source().name, 0, 0});
    return false;
  }
  const bool of_imu = is_imu(root);
  const schema::Schema& table = of_imu ? files.imu : files.camera;
  fields::Reader reader(document, table.dialect, diagnostics);
  Camera camera;
  Imu imu;
  std::string& name = of_imu ? imu.name : camera.name;
  name = of_imu ? files.imu_name(document) : files.camera_name(document);
  camera.image_size = options.image_size;
  schema::Reading reading{table, reader, options, rig, name};
  reading.camera = of_imu ? nullptr : &camera;
  reading.imu = of_imu ? &imu : nullptr;
  if (!schema::read_mapping(reading, table.root, root)) return false;
  reader.warn_of_misspelt();
  schema::keep_unread(reading, table.root, root, name);
  if (of_imu) {
    rig.imus.push_back(std::move(imu));
  } else {
    rig.cameras.push_back(std::move(camera));
  }
  return true;
}

/// The base with what the rig says of its camera. Nothing where it then says another lens: names of a lens may stand there that
/// only a fresh file has not.
std::optional<text::Document> edited_camera(const Files& files, const text::Document& base, const Rig& old, const Rig& rig,
                                            std::size_t camera, Written& written) {
  text::Document document = schema::edited(base, {files.camera, old}, {files.camera, rig, camera}, written);
  const CameraModel& model = rig.cameras[camera].model;
  if (old.cameras.front().model.index() == model.index()) return document;
  Diagnostics ignored;
  const std::optional<text::Document> result = text::as_edited(document);
  const std::optional<Rig> back = result ? files.format.read(std::span(&*result, 1), {}, ignored) : std::nullopt;
  return back && back->cameras.front().model == model ? std::optional(std::move(document)) : std::nullopt;
}

/// A name without folders: "cam0.yaml" of "mav0/cam0/sensor.yaml".
std::string name_at(std::string_view place) {
  const std::filesystem::path path = place;
  if (!path.has_parent_path()) return path.string();
  return path.parent_path().filename().string() + path.extension().string();
}

/// Numbers that the IMU lacks.
std::vector<std::string> missing_in(const Files& files, const Imu& imu) {
  std::vector<std::string> missing;
  for (const schema::Key& key : files.imu.root.keys) {
    if (key.with.imu != nullptr && !(imu.*key.with.imu)) missing.emplace_back(key.name);
  }
  return missing;
}

/// Does the rig specify what stands in the IMU's file and is no IMU's: a time offset, tuning?
bool states_for_imu_file(const Files& files, const Rig& rig) {
  const auto is_kept = [&rig](const schema::Key& key) {
    return !key.with.token.empty() && !key.with.other.empty() &&
           rig.find_extra_field("", std::string(key.with.other) + key.text()) != nullptr;
  };
  return std::ranges::any_of(rig.cameras, [](const Camera& camera) { return camera.time_offset_s.value_or(0.0) != 0.0; }) ||
         std::ranges::any_of(files.imu.root.keys, is_kept);
}

/// A fresh file of the first IMU, or of none.
void add_imu_file(const Files& files, const Rig& rig, Written& written, Diagnostics& diagnostics) {
  if (!rig.imus.empty() && !files.demands_imu) {
    if (const std::vector<std::string> missing = missing_in(files, rig.imus.front()); !missing.empty()) {
      written.losses.push_back(lost(Code::kImuDropped, rig.imus.front().name, "", {Message{files.imu_demands, {missing}}}));
      return;
    }
  }
  Written made_up;
  const Subject subject{.schema = files.imu, .rig = rig, .fresh = &made_up};
  std::optional<text::Document> document =
      schema::composed_yaml(subject, std::string(kHeader), name_at(files.imu_place), diagnostics);
  if (!document) return;
  // What tunes the program is one default.
  std::vector<std::string> tuning;
  for (DefaultedValue& value : made_up.defaults) {
    if (!value.invented) tuning.push_back(value.key);
    value.key = "IMU " + value.key;
    value.file = document->source().name;
    if (value.invented) written.defaults.push_back(std::move(value));
  }
  if (!tuning.empty()) {
    written.defaults.push_back({"tuning (" + text::enumerated(tuning) + ")", Message{Code::kKimeraStockTuning}, false, false,
                                document->source().name});
  }
  written.files.push_back({*std::move(document), {}, {std::string(files.imu_program)}});
  written.files.back().place = files.imu_place;
  written.files.back().of_defaults = rig.imus.empty() && !states_for_imu_file(files, rig);
}

/// The rig's extra fields that the files contain.
std::vector<ExtraField> contained_in(const Files& files, const std::optional<Rig>& old, const Rig& rig, bool imu_file) {
  std::vector<ExtraField> said = old ? old->extra_fields : std::vector<ExtraField>();
  for (const schema::Key& key : files.imu.root.keys) {
    const ExtraField* kept = key.with.token.empty() || key.with.other.empty() ? nullptr : schema::kept_tuning(rig, key);
    if (imu_file && kept != nullptr) said.push_back(*kept);
  }
  return said;
}

}  // namespace

bool is_imu(const Node& root) {
  constexpr std::array<schema::Key, 4> kNoise = noise_keys({});
  const auto has = [&root](std::string_view key) { return text::find(root, key, text::Dialect::kOpenCv) != nullptr; };
  return !has("intrinsics") && !has("camera_model") &&
         std::ranges::any_of(kNoise, [&has](const schema::Key& key) { return has(key.name); });
}

std::optional<Rig> read(const Files& files, std::span<const text::Document> documents, const ReadOptions& options,
                        Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    Diagnostics found;
    const bool good = read_document(files, document, options, rig, found);
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (!good || found.has_errors()) return std::nullopt;
  }
  return rig;
}

std::optional<Written> write(const Files& files, const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? files.format.read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::optional<Rig> old = options.rewrite ? std::nullopt : there;
  const bool of_imu = old && old->cameras.empty();
  const bool only_imu = rig.cameras.empty() && !rig.imus.empty();
  if (!only_imu && !writable_alone(files.format, rig, Message{Code::kTableDemandsSize}, diagnostics)) return std::nullopt;

  Written written;
  bool edits = false;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    std::optional<text::Document> document;
    const text::Document* own = old && !of_imu && is_camera_of(old, rig, camera) ? base : nullptr;
    if (own != nullptr) document = edited_camera(files, *base, *old, rig, i, written);
    edits = edits || document;
    const std::string place = files.camera_place(rig, i, own);
    if (!document) {
      const Subject subject{.schema = files.camera, .rig = rig, .camera = i, .fresh = &written};
      document = schema::composed_yaml(subject, std::string(kHeader), name_at(place), diagnostics);
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {std::string(files.camera_program)}});
    written.files.back().place = place;
  }
  if (of_imu && !rig.imus.empty()) {
    written.files.push_back(
        {schema::edited(*base, {files.imu, *old}, {files.imu, rig}, written), {}, {std::string(files.imu_program)}});
    written.files.back().place = files.imu_place;
    edits = true;
  } else if (!rig.imus.empty() || (files.demands_imu && !edits)) {
    add_imu_file(files, rig, written, diagnostics);
  }
  if (written.files.empty()) {
    diagnostics.add(Code::kFormatNeedsCamera, {files.format.title});
    return std::nullopt;
  }

  const Message no_place{Code::kFilesHaveNoPlace, {files.file_of}};
  const bool imu_file = written.files.back().cameras.empty();
  const std::vector<ExtraField> said = contained_in(files, edits ? old : std::nullopt, rig, imu_file && !of_imu);
  add_extras_lost(rig, said, edits ? std::nullopt : there, no_place, written.losses);
  schema::list_losses(files.whole, rig, no_place, written.losses);
  written.headline = {rig.cameras.empty() ? files.wrote_imu : files.wrote};
  return written;
}

}  // namespace fca::sensors
