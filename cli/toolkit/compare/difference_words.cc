// SPDX-License-Identifier: BSD-3-Clause
#include "compare/difference_words.h"

#include "words.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

#include <cmath>

namespace fca {

namespace {

/// Rounding is no difference: 1.8e-14 deg reads as 0.
double without_rounding(double value) { return std::abs(value) < 1e-9 ? 0.0 : value; }
double degrees(double radians) { return without_rounding(radians) * kDegreesPerRadian; }
double millimetres(double metres) { return without_rounding(metres) * 1000.0; }

}  // namespace

std::string angle_text(double radians) { return text::format_short(degrees(radians), 3) + " deg"; }
std::string length_text(double metres) { return text::format_short(millimetres(metres), 3) + " mm"; }

Message in_words(const PoseComparison& pose) {
  return {Code::kPoseDiffers, {pose.a, pose.b, degrees(pose.angle_rad), millimetres(pose.distance_m)}};
}

Message in_words(const FactComparison& fact) {
  const double difference = std::abs(fact.other - fact.reference);
  if (fact.unit == "s") return {Code::kTimeDiffers, {fact.owner, fact.name, difference * 1000.0}};
  if (fact.unit == "m") return {Code::kLengthDiffers, {fact.owner, fact.name, millimetres(difference)}};
  return {Code::kRatioDiffers, {fact.owner, fact.name, fact.other / fact.reference}};
}

std::string sentence(const Mistake& mistake) { return text::text_of(mistake.message); }

std::string subject_of(const Mistake& mistake) { return text::filled("{0}", mistake.message.arguments); }

}  // namespace fca
