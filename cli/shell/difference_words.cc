// SPDX-License-Identifier: BSD-3-Clause
#include "difference_words.h"

#include "toolkit/compare/difference_facts.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

namespace fca::cli {

std::string angle_text(double radians) { return text::format_short(degrees_apart(radians), 3) + " deg"; }
std::string length_text(double metres) {
  constexpr double kLong = 10.0;
  if (metres >= kLong) return text::format_short(metres, 3) + " m";
  return text::format_short(millimetres_apart(metres), 3) + " mm";
}

std::string sentence(const Mistake& mistake) { return text::text_of(mistake.message); }

std::string subject_of(const Mistake& mistake) { return text::filled("{0}", mistake.message.arguments); }

}  // namespace fca::cli
