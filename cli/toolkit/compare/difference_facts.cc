// SPDX-License-Identifier: BSD-3-Clause
#include "compare/difference_facts.h"

#include "degrees.h"

#include <fca/code.h>

#include <cmath>

namespace fca {

namespace {

/// Returns 0 for values that are so small that they can only come from rounding.
double without_rounding(double value) { return std::abs(value) < 1e-9 ? 0.0 : value; }

}  // namespace

double degrees_apart(double radians) { return without_rounding(radians) * kDegreesPerRadian; }
double millimetres_apart(double metres) { return without_rounding(metres) * 1000.0; }

Message facts_of(const PoseComparison& pose) {
  const PoseDistance distance = pose.decisive();
  return {Code::kPoseDiffers, {pose.a, pose.b, degrees_apart(distance.angle_rad), millimetres_apart(distance.distance_m)}};
}

Message facts_of(const FactComparison& fact) {
  const double difference = std::abs(fact.other - fact.reference);
  if (fact.unit == "s") return {Code::kTimeDiffers, {fact.owner, fact.name, difference * 1000.0}};
  if (fact.unit == "m") return {Code::kLengthDiffers, {fact.owner, fact.name, millimetres_apart(difference)}};
  return {Code::kRatioDiffers, {fact.owner, fact.name, fact.other / fact.reference}};
}

}  // namespace fca
