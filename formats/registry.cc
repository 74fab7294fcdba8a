// SPDX-License-Identifier: BSD-3-Clause
// The table of formats. One row each; the order is that of `fca-io formats` and of detection.
#include "kalibr/kalibr.h"
#include "ocamcalib/ocamcalib.h"
#include "opencv/opencv.h"
#include "orbslam3/orbslam3.h"
#include "tumvi/tumvi.h"
#include "woodscape/woodscape.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

const auto& table() {
  static const std::array kTable = {kalibr::kFormat, opencv::kFormat,   ocamcalib::kFormat,
                                    tumvi::kFormat,  orbslam3::kFormat, woodscape::kFormat};
  return kTable;
}

/// Lower case without '-' and '_': "ORB_SLAM3", "orb-slam3" and "orbslam3" are one name.
std::string folded(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == '-' || c == '_') continue;
    result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

}  // namespace

std::span<const Format> all_formats() { return table(); }

const Format* find_format(std::string_view name) {
  const auto& formats = table();
  const auto found = std::ranges::find_if(formats, [&](const Format& f) { return folded(f.id) == folded(name); });
  return found == formats.end() ? nullptr : &*found;
}

const StoredModel* find_stored_model(const Format& format, std::string_view model, bool stock_only) {
  const auto found = std::ranges::find_if(
      format.models, [&](const StoredModel& row) { return row.model == model && (row.stock || !stock_only); });
  return found == format.models.end() ? nullptr : &*found;
}

bool stored_within(const Format& format, const Camera& camera, Diagnostics& diagnostics) {
  const StoredModel* stored = find_stored_model(format, model_info(camera.model).id, false);
  if (stored == nullptr || within(camera.model, stored->ranges)) return true;
  for (const ParameterRange& range : stored->ranges) {
    const double value = parameter(camera.model, range.parameter).value_or(range.lower);
    if (value >= range.lower && value <= range.upper) continue;
    diagnostics.error("parameter-not-storable",
                      camera.name + ": " + std::string(range.parameter) + " = " + text::format_short(value) +
                          " cannot be stored as " + std::string(stored->file_name) + " (" + std::string(format.title) +
                          "); it must lie in [" + text::format_short(range.lower) + ", " + text::format_short(range.upper) +
                          "]",
                      {}, "convert the camera to this format's ranges first");
  }
  return false;
}

}  // namespace fca
