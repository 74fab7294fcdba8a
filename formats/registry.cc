// SPDX-License-Identifier: BSD-3-Clause
// The table of formats. One row each; the order is that of `fca-io formats` and of detection.
#include "basalt.h"
#include "colmap/colmap.h"
#include "devices/depthai.h"
#include "devices/realsense.h"
#include "devices/zed.h"
#include "dso/dso.h"
#include "fast_livo.h"
#include "kalibr/kalibr.h"
#include "kitti.h"
#include "mast3r.h"
#include "metashape.h"
#include "mrcal/mrcal.h"
#include "ncamera/ncamera.h"
#include "ncore.h"
#include "nerfstudio/nerfstudio.h"
#include "ocamcalib/ocamcalib.h"
#include "okvis/okvis.h"
#include "opencv/opencv.h"
#include "openicc.h"
#include "opensfm.h"
#include "openvins/openvins.h"
#include "orbslam3/orbslam3.h"
#include "rays.h"
#include "ros/ros.h"
#include "sensors/euroc.h"
#include "sensors/kimera.h"
#include "stella/stella.h"
#include "tumvi/tumvi.h"
#include "vins/vins.h"
#include "woodscape/woodscape.h"
#include "write_guard.h"

#include <fca/code.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

const auto& table() {
  static const std::array kTable = {
      guarded<kalibr::kFormat>(),    guarded<opencv::kFormat>(),    guarded<ocamcalib::kFormat>(),
      guarded<tumvi::kFormat>(),     guarded<orbslam3::kFormat>(),  guarded<woodscape::kFormat>(),
      guarded<basalt::kFormat>(),    guarded<openvins::kFormat>(),  guarded<vins::kFormat>(),
      guarded<ros::kFormat>(),       guarded<euroc::kFormat>(),     guarded<kimera::kFormat>(),
      guarded<mrcal::kFormat>(),     guarded<colmap::kFormat>(),    guarded<nerfstudio::kFormat>(),
      guarded<stella::kFormat>(),    guarded<fast_livo::kFormat>(), guarded<dso::kFormat>(),
      guarded<okvis::kFormat>(),     guarded<ncamera::kFormat>(),   guarded<mast3r::kFormat>(),
      guarded<opensfm::kFormat>(),   guarded<metashape::kFormat>(), guarded<kitti::kFormat>(),
      guarded<ncore::kFormat>(),     guarded<openicc::kFormat>(),   guarded<depthai::kFormat>(),
      guarded<realsense::kFormat>(), guarded<zed::kFormat>(),       guarded<rays::kFormat>(),
  };
  return kTable;
}

}  // namespace

std::span<const Format> all_formats() { return table(); }

std::span<const Format> written_formats() {
  static const auto kCount = static_cast<std::size_t>(std::ranges::count_if(table(), &Format::is_written));
  return std::span(table()).first(kCount);
}

const Format* find_format(std::string_view name) {
  const auto& formats = table();
  const auto found = std::ranges::find_if(formats, [&](const Format& f) { return normalised_id(f.id) == normalised_id(name); });
  return found == formats.end() ? nullptr : &*found;
}

bool is_base_of(const Format& from, const text::Document& document, const Format& to) {
  if (from.id == to.id || to.layout_of == from.id) return true;
  return from.layout_of == to.id && to.probe(document).score > 0;
}

const StoredModel* find_stored_model(const Format& format, std::string_view model, bool stock_only) {
  const auto found = std::ranges::find_if(
      format.models, [&](const StoredModel& row) { return row.model == model && (row.stock || !stock_only); });
  return found == format.models.end() ? nullptr : &*found;
}

bool can_store(const Format& format, const Camera& camera, Diagnostics& diagnostics) {
  if (!camera.rays.empty()) {
    diagnostics.add(Code::kOnlyRaysKnown, {camera.name});
    return false;
  }
  const std::string model(model_info(camera.model).id);
  const StoredModel* stored = find_stored_model(format, model, false);
  if (stored == nullptr) {
    diagnostics.add(Code::kFormatHasNoModel, {camera.name, format.title, model});
    return false;
  }
  if (within(camera.model, stored->ranges)) return true;
  for (const ParameterRange& range : stored->ranges) {
    const std::optional<double> value = parameter(camera.model, range.parameter);
    if (!value || (*value >= range.lower && *value <= range.upper)) continue;
    diagnostics.add(Code::kFormatHasNoValue,
                    {camera.name, range.parameter.name(), *value, stored->file_name, format.title, range.lower, range.upper});
  }
  return false;
}

bool can_store(const Format& format, const Rig& rig, const Rig* there, Diagnostics& diagnostics) {
  bool good = true;
  for (const Camera& camera : rig.cameras) {
    const Camera* before = there != nullptr ? there->find_camera(camera.name) : nullptr;
    if (before == nullptr || before->model != camera.model || before->rays != camera.rays)
      good = can_store(format, camera, diagnostics) && good;
  }
  return good;
}

}  // namespace fca
