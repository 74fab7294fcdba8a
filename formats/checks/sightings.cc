// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/sightings.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

constexpr std::array kSightings = {
    Sighting{"baseline-contradicts", 0, 0},
};

}  // namespace

std::span<const Sighting> sightings() { return kSightings; }

Sighting sighting_of(std::string_view id) {
  const auto* const found = std::ranges::find(kSightings, id, &Sighting::id);
  return found == kSightings.end() ? Sighting{id} : *found;
}

}  // namespace fca
