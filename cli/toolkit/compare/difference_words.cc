// SPDX-License-Identifier: BSD-3-Clause
#include "compare/difference_words.h"

#include "words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

#include <cmath>

namespace fca {

namespace {

/// Rounding is no difference: 1.8e-14 deg reads as 0.
double without_rounding(double value) { return std::abs(value) < 1e-9 ? 0.0 : value; }
}  // namespace

std::string angle_text(double radians) { return text::format_short(without_rounding(radians) * kDegreesPerRadian, 3) + " deg"; }
std::string length_text(double metres) { return text::format_short(without_rounding(metres) * 1000.0, 3) + " mm"; }

std::string in_words(const PoseComparison& pose) {
  return "T_" + pose.a + "_" + pose.b + " differs by " + angle_text(pose.angle_rad) + " and " + length_text(pose.distance_m);
}

std::string in_words(const FactComparison& fact) {
  const std::string what = (fact.owner.empty() ? "" : fact.owner + " ") + fact.name + " ";
  if (fact.unit == "s")
    return what + "differs by " + text::format_short(std::abs(fact.other - fact.reference) * 1000.0, 3) + " ms";
  if (fact.unit == "m") return what + "differs by " + length_text(std::abs(fact.other - fact.reference));
  return what + "is " + text::format_short(fact.other / fact.reference, 3) + " times the reference's";
}

std::string sentence(const Mistake& mistake) { return text::text_of(mistake.message); }

std::string subject_of(const Mistake& mistake) { return text::filled("{0}", mistake.message.arguments); }

}  // namespace fca
