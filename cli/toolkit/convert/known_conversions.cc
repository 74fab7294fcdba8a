// SPDX-License-Identifier: BSD-3-Clause
#include "known_conversions.h"

#include <algorithm>
#include <utility>

namespace fca {

const KnownConversions::Known* KnownConversions::find(const Camera& camera, const ConvertOptions& options) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::ranges::find_if(known_, [&](const Known& each) { return each.camera == camera && each.options == options; });
  return found == known_.end() ? nullptr : &*found;
}

std::optional<Conversion> KnownConversions::convert(const Camera& camera, const ConvertOptions& options,
                                                    Diagnostics& diagnostics) {
  const Known* known = find(camera, options);
  if (known == nullptr) {
    Known made{camera, options, std::nullopt, {}};
    made.conversion = fca::convert(camera, options, made.found);
    const std::lock_guard lock(mutex_);
    known = &known_.emplace_back(std::move(made));
  }
  for (const Diagnostic& entry : known->found.entries()) diagnostics.add(entry);
  return known->conversion;
}

}  // namespace fca
