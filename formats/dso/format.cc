// SPDX-License-Identifier: BSD-3-Clause
#include "camera_txt.h"
#include "dso.h"

#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca::dso {

namespace {

constexpr std::string_view kProgram = "DSO";
constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};
constexpr std::array kModels = {
    StoredModel{"kb4", "EquiDistant", true, "DSO (rays inside 90 deg)", {}},
    StoredModel{"radtan", "RadTan", true, kProgram, kNoK3, Code::kCameraTxtNoK3},
    StoredModel{"fov", "FOV", true, kProgram, {}},
    StoredModel{"pinhole", "Pinhole", true, kProgram, {}},
};
constexpr std::array<std::string_view, 1> kRectified = {"DSO's rectified image"};
constexpr std::array kDemands = {Demand{"DSO's rectified image (lines 3 and 4)", "(line "}};
constexpr std::array kOwnFacts = {OwnFact{kRectified.front(), kRectified}};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  if (documents.size() != 1 || !is_camera_txt(documents.front())) {
    diagnostics.add(Code::kCameraTxtNoLens, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return read_camera_txt(documents.front(), diagnostics);
}

/// The camera's file: the base, where it is the base's own camera, else a fresh one. Nothing, and `why` says why, if it cannot
/// be said.
std::optional<text::Document> file_of(const text::Document* base, const Rig& rig, const Camera& camera, Message& why,
                                      Diagnostics& diagnostics) {
  Rig alone;
  alone.cameras = {camera};
  why = problem_with_camera_txt(alone);
  if (base != nullptr) {
    // In shares of the image's size, the base can say another centre than in pixels.
    std::optional<text::Document> document = edited_camera_txt(*base, camera);
    if (!document && !why.is_said()) why = {Code::kCameraTxtCentreNoShare};
    return document;
  }
  if (why.is_said()) return std::nullopt;
  const std::string name = rig.cameras.size() == 1 ? "camera.txt" : as_file_name(camera.name) + ".txt";
  return text::parse_document({name, fresh_camera_txt(camera)}, diagnostics);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (!writable_alone(kFormat, rig, Message{Code::kCameraTxtSizeMissing}, diagnostics)) return std::nullopt;
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  Message why;
  std::optional<Written> result = written(base, options.rewrite ? std::nullopt : there, rig, why, diagnostics);
  if (!result) {
    diagnostics.add(Code::kCameraTxtNotWritten, {why});
    return std::nullopt;
  }
  if (there && options.rewrite)
    add_not_carried(extras_beyond(there->extra_fields, rig.extra_fields), Message{Code::kFileRewritten}, result->losses);
  return result;
}

ProbeResult probe(const text::Document& document) { return probe_camera_txt(document); }

bool layout_holds(const text::Document& /*document*/, std::string_view model) { return camera_txt_holds(model); }

}  // namespace

bool is_camera_txt(const text::Document& document) { return document.syntax() == text::Syntax::kWords; }

std::optional<Written> written(const text::Document* base, const std::optional<Rig>& old, const Rig& rig, Message& why,
                               Diagnostics& diagnostics) {
  Written written;
  bool edits = false;
  for (const Camera& camera : rig.cameras) {
    const bool of_base = base != nullptr && is_camera_txt(*base) && is_camera_of(old, rig, camera);
    std::optional<text::Document> document = file_of(of_base ? base : nullptr, rig, camera, why, diagnostics);
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {"dso"}});
    edits = edits || of_base;
  }
  if (!edits) {
    written.defaults.push_back({"rectification (line 3)", "crop", false});
    written.defaults.push_back({"size of DSO's images (line 4)", Message{Code::kCameraTxtSizeOfCamera}, false});
  }
  written.sensor = kLensAlone;
  list_camera_losses(rig, kProgram, written.losses);
  const std::vector<ExtraField> there = edits ? old->extra_fields : std::vector<ExtraField>();
  add_beyond_base(rig.extra_fields, there, Message{Code::kCameraTxtNoPlace}, written.losses);
  written.headline = {written.files.size() == 1 ? Code::kCameraTxtHeadline : Code::kCameraTxtHeadlineEach};
  return written;
}

const Format kFormat = {
    .id = "dso",
    .title = "DSO camera.txt",
    .syntaxes = "text",
    .extension = ".txt",
    .program = kProgram,
    .main_file = "camera.txt",
    .many_cameras = false,
    .extrinsics = false,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .probe = probe,
    .layout_holds = layout_holds,
    .read = read,
    .write = write,
};

}  // namespace fca::dso
