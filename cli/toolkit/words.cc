// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/formats/text/numbers.h>

namespace fca {

std::string pixels(double value) {
  if (value == 0.0) return "0";
  if (value < 1e-4) return text::format_short(value, 2);
  return text::format_short(value, 3);
}

std::string size_in_words(const ImageSize& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

}  // namespace fca
