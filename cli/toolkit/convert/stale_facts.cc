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

/// Adds the warning and the loss with those extra fields of `rig` that have one of the keys and were not lost.
void list_stale(const Rig& rig, std::span<const std::string_view> keys, Code warning, Code loss, Written& written,
                Diagnostics& diagnostics) {
  std::vector<std::string> stale;
  for (const ExtraField& extra : rig.extra_fields) {
    const bool is_lost = std::ranges::any_of(
        written.losses, [&extra](const Loss& each) { return each.owner == extra.owner && each.key == extra.key; });
    if (is_among(extra, keys) && !is_lost) stale.push_back(with_owner(extra));
  }
  if (stale.empty()) return;
  diagnostics.add(warning, {stale});
  written.losses.push_back(lost(loss, "", "", {stale}));
}

}  // namespace

void list_facts_of_other_images(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics) {
  list_stale(rig, format.of_the_images, Code::kStaleOfImages, Code::kStaleOfImagesLost, written, diagnostics);
}

void list_facts_of_other_lenses(const Rig& base, const Rig& rig, const Format& format, Written& written,
                                Diagnostics& diagnostics) {
  const bool is_same = std::ranges::equal(base.cameras, rig.cameras, {}, &Camera::model, &Camera::model) &&
                       base.poses == rig.poses && base.baseline_m == rig.baseline_m;
  if (is_same || format.of_the_lenses.empty()) return;
  // Extra fields with another value than before were updated by the writer and are not stale.
  const std::optional<Rig>& in_file = written.files.front().says;
  Rig kept = base;
  std::erase_if(kept.extra_fields, [&in_file](const ExtraField& extra) {
    return in_file && std::ranges::find(in_file->extra_fields, extra) == in_file->extra_fields.end();
  });
  list_stale(kept, format.of_the_lenses, Code::kStaleOfLenses, Code::kStaleOfLensesLost, written, diagnostics);
}

}  // namespace fca
