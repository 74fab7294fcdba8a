// SPDX-License-Identifier: BSD-3-Clause
#include "stale_facts.h"

#include "words.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fca::cli {

namespace {

bool of_the_images(const AsRead& extra, const Format& format) {
  return std::ranges::any_of(format.of_the_images, [&extra](std::string_view key) {
    return extra.key == key || extra.key.ends_with(" " + std::string(key));
  });
}

}  // namespace

void list_stale_facts(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics) {
  std::vector<std::string> stale;
  for (const AsRead& extra : rig.as_read) {
    const bool lost =
        std::ranges::any_of(written.losses, [&extra](const Loss& loss) { return loss.what.starts_with(extra.key); });
    if (of_the_images(extra, format) && !lost) stale.push_back(extra.key);
  }
  if (stale.empty()) return;
  const std::string keys = enumerated(stale, "and");
  const std::string why = "of the images as they were calibrated, and kept unchanged";
  const std::string remedy = "compute it for the new images, or --anew leaves it out";
  diagnostics.warning("stale-derived", keys + ": " + why, {}, remedy);
  written.losses.push_back({"stale-derived", keys, why, remedy});
}

}  // namespace fca::cli
