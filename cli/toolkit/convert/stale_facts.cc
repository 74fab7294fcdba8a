// SPDX-License-Identifier: BSD-3-Clause
#include "stale_facts.h"

#include "words.h"

#include <fca/formats/read_back.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {

namespace {

bool is_among(const ExtraField& extra, std::span<const std::string_view> keys) {
  return std::ranges::find(keys, extra.key) != keys.end();
}

void list_stale(const Rig& rig, std::span<const std::string_view> of, const std::string& why, const std::string& remedy,
                Written& written, Diagnostics& diagnostics) {
  std::vector<std::string> stale;
  for (const ExtraField& extra : rig.extra_fields) {
    const bool lost = std::ranges::any_of(written.losses,
                                          [&extra](const Loss& loss) { return what_of(loss).starts_with(with_owner(extra)); });
    if (is_among(extra, of) && !lost) stale.push_back(with_owner(extra));
  }
  if (stale.empty()) return;
  const std::string keys = enumerated(stale, "and");
  diagnostics.warning("stale-derived", keys + ": " + why, {}, remedy);
  written.losses.push_back({"stale-derived", keys, why, remedy});
}

}  // namespace

void list_facts_of_other_images(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics) {
  list_stale(rig, format.of_the_images, "of the images as they were calibrated, and kept unchanged",
             "compute it for the new images, or --anew leaves it out", written, diagnostics);
}

void list_facts_of_other_lenses(const Rig& base, const Rig& rig, const Format& format, Written& written,
                                Diagnostics& diagnostics) {
  const bool same = std::ranges::equal(base.cameras, rig.cameras, {}, &Camera::model, &Camera::model) &&
                    base.poses == rig.poses && base.baseline_m == rig.baseline_m;
  if (same || format.of_the_lenses.empty()) return;
  // What the writer knew to follow is no longer as the base had it.
  const std::optional<Rig> now = read_back(format, written.files.front());
  Rig kept = base;
  std::erase_if(kept.extra_fields, [&now](const ExtraField& extra) {
    return now && std::ranges::find(now->extra_fields, extra) == now->extra_fields.end();
  });
  list_stale(kept, format.of_the_lenses, "of the base's cameras, and kept unchanged",
             "compute it for the new cameras (cv::stereoRectify), or --anew leaves it out", written, diagnostics);
}

}  // namespace fca
