// SPDX-License-Identifier: BSD-3-Clause
// stella_vslam's block Camera, which of a pair says what both are rectified to.
#include "../stella/layout.h"
#include "topics.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::checks {

namespace {

struct Number {
  const text::Node* node = nullptr;
  double value = 0.0;
};

Number number_of(const Subject& subject, std::string_view key) {
  const text::Node* node = stella::find_key(subject.document, stella::kCamera, key);
  return {node, node != nullptr ? text::parse_real(node->value).value_or(0.0) : 0.0};
}

/// Two numbers of a calibration are not equal by chance.
void check_copied(const Subject& subject, const Number& fx, Findings& findings) {
  const Number cx = number_of(subject, "cx");
  if (cx.node == nullptr || cx.value != fx.value || fx.value == std::floor(fx.value)) return;
  findings.add(Code::kCoefficientRepeated, {std::string(stella::kCamera), "fx", "cx", fx.value},
               subject.document.range(*cx.node));
}

/// Millimetres between the two cameras of devices that are sold (RealSense D435, D415, D455, ZED Mini, OAK-D, ZED and others).
constexpr std::array kBaselinesSold = {50.0, 55.0, 60.0, 63.0, 75.0, 95.0, 110.0, 120.0};

/// Whole millimetres of a baseline that no focal length has multiplied: a product is rarely a whole number, and more rarely
/// that of a device, or of a baseline that few rigs have.
void check_product(const Subject& subject, const Number& fx, Findings& findings) {
  const Number product = number_of(subject, "focal_x_baseline");
  if (product.node == nullptr || product.value != std::floor(product.value)) return;
  constexpr double kShortest = 50.0;
  constexpr double kLongest = 250.0;
  constexpr double kSame = 0.05;
  const double metres = product.value / 1000.0;
  const double baseline = product.value / fx.value;
  if (product.value < kShortest || product.value > kLongest || std::abs(baseline / metres - 1.0) < kSame) return;
  const bool is_sold = std::ranges::find(kBaselinesSold, product.value) != kBaselinesSold.end();
  if (!is_sold && 1000.0 * baseline <= kLongest) return;
  findings.add(Code::kBaselineInProduct, {product.value, baseline, metres * fx.value}, subject.document.range(*product.node));
}

}  // namespace

bool check_stella(const Subject& subject, Findings& findings) {
  if (!subject.is("stella")) return false;
  const Number fx = number_of(subject, "fx");
  if (!(fx.value > 0.0)) return false;
  check_copied(subject, fx, findings);
  const text::Node* setup = stella::find_key(subject.document, stella::kCamera, "setup");
  if (setup != nullptr && setup->value == stella::kStereo) check_product(subject, fx, findings);
  return true;
}

}  // namespace fca::checks
