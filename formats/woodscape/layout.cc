// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <fca/formats/text/numbers.h>

#include <cmath>
#include <limits>
#include <optional>

namespace fca::woodscape {

double centre_of(double offset, int size) { return (0.5 * size - 0.5) + offset; }

double offset_of(double centre, int size) {
  const double middle = 0.5 * size - 0.5;
  const double offset = centre - middle;
  // Of all that do, the one with the fewest digits: 0.329055 rather than 0.3290550000000394.
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    const std::optional<double> candidate = text::parse_real(text::format_short(offset, digits));
    if (candidate && middle + *candidate == centre) return *candidate;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double candidate : {offset, std::nextafter(offset, -kInfinity), std::nextafter(offset, kInfinity)}) {
    if (middle + candidate == centre) return candidate;
  }
  return offset;
}

}  // namespace fca::woodscape
