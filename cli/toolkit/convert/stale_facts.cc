// SPDX-License-Identifier: BSD-3-Clause
#include "stale_facts.h"

#include <fca/code.h>

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

void list_stale(const Rig& rig, std::span<const std::string_view> of, Code found, Code loss, Written& written,
                Diagnostics& diagnostics) {
  std::vector<std::string> stale;
  for (const ExtraField& extra : rig.extra_fields) {
    const bool is_lost = std::ranges::any_of(
        written.losses, [&extra](const Loss& each) { return each.owner == extra.owner && each.key == extra.key; });
    if (is_among(extra, of) && !is_lost) stale.push_back(with_owner(extra));
  }
  if (stale.empty()) return;
  diagnostics.add(found, {stale});
  written.losses.push_back(lost(loss, "", "", {stale}));
}

}  // namespace

void list_facts_of_other_images(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics) {
  list_stale(rig, format.of_the_images, Code::kStaleOfImages, Code::kStaleOfImagesLost, written, diagnostics);
}

void list_facts_of_other_lenses(const Rig& base, const Rig& rig, const Format& format, Written& written,
                                Diagnostics& diagnostics) {
  const bool same = std::ranges::equal(base.cameras, rig.cameras, {}, &Camera::model, &Camera::model) &&
                    base.poses == rig.poses && base.baseline_m == rig.baseline_m;
  if (same || format.of_the_lenses.empty()) return;
  // Only extra fields that the file still has with the same value are stale; others were updated by the writer.
  const std::optional<Rig>& now = written.files.front().says;
  Rig kept = base;
  std::erase_if(kept.extra_fields, [&now](const ExtraField& extra) {
    return now && std::ranges::find(now->extra_fields, extra) == now->extra_fields.end();
  });
  list_stale(kept, format.of_the_lenses, Code::kStaleOfLenses, Code::kStaleOfLensesLost, written, diagnostics);
}

}  // namespace fca
