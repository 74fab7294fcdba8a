// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace fca {

/// Puts the best of the items first, then the best of the others, and so on; of equally good ones the earlier comes first. For
/// a comparison with a tolerance, which may prefer a to b, b to c and c to a, so that no sort of the standard library may use
/// it.
template <class T, class IsBetter>
void put_best_first(std::vector<T>& items, IsBetter&& is_better) {
  for (auto place = items.begin(); place != items.end(); ++place) {
    auto best = place;
    for (auto each = std::next(place); each != items.end(); ++each) {
      if (is_better(*each, *best)) best = each;
    }
    std::rotate(place, best, std::next(best));
  }
}

}  // namespace fca
