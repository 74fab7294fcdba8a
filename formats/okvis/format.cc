// SPDX-License-Identifier: BSD-3-Clause
// Configurations of OKVIS2 (ethz-mrl/okvis2@a2ea006 of 2025-08, okvis_common/src/ViParametersReader.cpp), of OKVIS2-X
// (the same file of luohongk/OKVIS2-X@3104473), and of OKVIS (ethz-asl/okvis@16181c8, VioParametersReader.cpp).
//
//   cameras                             a list (camera.cc)
//   camera_parameters/image_delay [s]   t_imu = t_cam - delay, for all cameras; OKVIS: imageDelay
//   camera_parameters/sync_cameras      the numbers of those whose images belong together
//   imu_parameters                      sigma_g_c, sigma_a_c, sigma_gw_c, sigma_aw_c: densities in continuous time; sigma_bg,
//                                       sigma_ba: priors; T_BS: the IMU in the body that the motion is put out of. OKVIS:
//                                       imu_params, with imu_rate
//   camera_params/camera_rate           OKVIS: the rate of all cameras, an int
//   frontend_parameters, ...            tune the program
//
// The programs read them with cv::FileStorage. OKVIS2 stops where one of these keys is missing, where a real has no point, and
// where one camera's entry is incomplete.
#include "okvis.h"

#include "../losses.h"
#include "../one_camera_files.h"
#include "table.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca::okvis {

using text::Node;

namespace {

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  return schema::read(kTable, documents, options, diagnostics);
}

constexpr std::string_view kFirstLayout = "okvis1";
constexpr std::array<std::string_view, 2> kLayouts = {"okvis2", kFirstLayout};

std::string_view layout_of(const text::Document& document) {
  return is_first_generation(document) ? kFirstLayout : kLayouts.front();
}

bool says_camera_models(const text::Document& document) {
  const Node* cameras = text::find(document.root(), "cameras", kTable.dialect);
  return cameras != nullptr && std::ranges::all_of(cameras->items, [](const Node& camera) {
           return text::find(camera, kCameraModel, kTable.dialect) != nullptr;
         });
}

/// OKVIS has no EUCM.
bool layout_stores(std::string_view layout, std::string_view model) { return model != kEucm || layout != kFirstLayout; }

bool layout_holds(const text::Document& document, std::string_view model) { return layout_stores(layout_of(document), model); }

bool all_held(const text::Document& document, const Rig& rig) {
  return std::ranges::all_of(rig.cameras,
                             [&document](const Camera& camera) { return layout_holds(document, model_info(camera.model).id); });
}

/// Are there the sections that hold what the rig specifies besides the cameras?
bool has_sections(const text::Document& document, const Rig& rig) {
  const bool first = is_first_generation(document);
  const auto has = [&document](std::string_view key) { return text::find(document.root(), key, kTable.dialect) != nullptr; };
  const bool of_time =
      std::ranges::any_of(rig.cameras, [](const Camera& camera) { return camera.time_offset_s.value_or(0.0) != 0.0; });
  return (rig.imus.empty() || has(first ? "imu_params" : "imu_parameters")) &&
         (!of_time || has(first ? "imageDelay" : "camera_parameters"));
}

std::vector<std::string> programs_of(const text::Document& document, const Rig& rig, bool fresh) {
  const bool eucm = std::ranges::any_of(rig.cameras, [](const Camera& camera) { return model_info(camera.model).id == kEucm; });
  if (is_first_generation(document)) return {"okvis"};
  if (eucm) return {"okvis2-x"};
  if (fresh) return {"okvis2", "okvis2-x"};
  if (says_camera_models(document)) return {"okvis2", "okvis2-x"};
  return {"okvis2"};
}

/// What stands next to the rig's noise in other files.
void list_imu_rate(const Rig& rig, const Message& why, std::vector<Loss>& losses) {
  if (rig.imus.empty() || !rig.imus.front().rate_hz) return;
  losses.push_back(
      lost(Code::kNotCarriedValue, rig.imus.front().name, "rate", {why, text::format_short(*rig.imus.front().rate_hz)}));
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool is_of_layout = options.layout.empty() || (there && options.layout == layout_of(*base));
  const bool edits = there && !options.rewrite && is_of_layout && schema::same_cameras(*there, rig) && all_held(*base, rig) &&
                     has_sections(*base, rig);
  if (edits ? !can_store(kFormat, rig, &*there, diagnostics)
            : !writable_alone(kFormat, rig, Message{Code::kTableDemandsSize}, diagnostics))
    return std::nullopt;

  const bool first = edits ? is_first_generation(*base) : options.layout == kFirstLayout;
  const schema::Schema& table = first ? kOkvis1 : kOkvis2;
  Written written;
  std::optional<text::Document> document =
      edits ? schema::edited(*base, {table, *there}, {table, rig}, written)
            : text::parse_document({std::string(first ? "okvis.yaml" : kFormat.main_file), composed(table, rig, written)},
                                   diagnostics);
  if (!document) return std::nullopt;
  std::vector<std::string> programs = programs_of(*document, rig, !edits);
  const std::string_view program = programs.front() == "okvis2-x" ? "OKVIS2-X" : table.program;
  written.files.push_back({*std::move(document), {}, std::move(programs)});
  for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  const Message no_place{Code::kFilesHaveNoPlace, {table.program}};
  add_extras_lost(rig, edits ? there->extra_fields : carried_over(table, rig), edits ? std::nullopt : there, no_place,
                  written.losses);
  schema::list_losses(table, rig, no_place, written.losses);
  if (&table == &kOkvis2) list_imu_rate(rig, no_place, written.losses);
  written.headline = {Code::kTableWrote, {kFormat.title, program}};
  return written;
}

ProbeResult probe(const text::Document& document) {
  const auto found = [](std::string_view a, std::string_view b) {
    return Message{Code::kFoundKeys, {std::vector<std::string>{std::string(a), std::string(b)}}};
  };
  const auto has = [](const Node& node, std::string_view key) { return text::find(node, key, kTable.dialect) != nullptr; };
  const Node* cameras = text::find(document.root(), "cameras", kTable.dialect);
  if (cameras != nullptr && cameras->is_sequence()) {
    for (const Node& camera : cameras->items) {
      for (const std::string_view key : {"image_dimension", "focal_length", "principal_point"}) {
        if (has(camera, "T_SC") && has(camera, key)) return {evidence::kCamera, found("T_SC", key)};
        if (has(camera, "distortion_type") && has(camera, key)) return {evidence::kCamera, found("distortion_type", key)};
      }
    }
  }
  for (const auto& [a, b] : std::array<std::array<std::string_view, 2>, 2>{
           {{"camera_parameters", "imu_parameters"}, {"camera_params", "imu_params"}}}) {
    if (has(document.root(), a) && has(document.root(), b)) return {evidence::kTuning, found(a, b)};
  }
  return {};
}

constexpr std::string_view kReader = "OKVIS, OKVIS2, OKVIS2-X";
constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};
constexpr std::array kModels = {
    StoredModel{"radtan", "radialtangential", true, kReader, kNoK3},
    StoredModel{"kb4", "equidistant", true, kReader, {}},
    StoredModel{"rational", "radialtangential8", true, kReader, {}},
    StoredModel{"eucm", "eucm", false, "OKVIS2-X", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"tuning, LiDAR and GNSS"}};
constexpr std::array kDemands = {
    Demand{"pose in the IMU", "T_SC"},
    Demand{"IMU noise", "sigma_g_c", nullptr, &Format::needs_imu},
    Demand{"IMU noise", "sigma_a_c", nullptr, &Format::needs_imu},
    Demand{"IMU random walks", "sigma_gw_c", nullptr, &Format::needs_imu},
    Demand{"IMU random walks", "sigma_aw_c", nullptr, &Format::needs_imu},
    Demand{"synchronised cameras", "sync_cameras"},
    Demand{"colour", "camera_type"},
    Demand{"use in SLAM", "slam_use"},
    Demand{"OKVIS2's tuning", "tuning ("},
};

}  // namespace

const Format kFormat = {
    .id = "okvis",
    .title = "OKVIS configuration",
    .group = FormatGroup::kSlam,
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "OKVIS2",
    .main_file = "okvis2.yaml",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .needs_imu = true,
    .image_size = true,
    .time_offset = true,
    .own_facts = kOwnFacts,
    .layouts = kLayouts,
    .about_layouts = Code::kOkvisLayouts,
    .demands = kDemands,
    .models = kModels,
    .table = &kTable,
    .probe = probe,
    .layout_holds = layout_holds,
    .layout_stores = layout_stores,
    .read = read,
    .write = write,
};

}  // namespace fca::okvis
