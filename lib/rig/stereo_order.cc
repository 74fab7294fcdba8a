// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/stereo_order.h>

#include <cmath>

namespace fca {

namespace {

/// Where the second camera stands in the first one's image plane: x to the right, y down [m].
struct Place {
  double right = 0.0;
  double below = 0.0;
  [[nodiscard]] bool is_vertical() const {
    constexpr double kMoreAboveThanBeside = 0.98;  // at 45 degrees, both
    return std::abs(right) < kMoreAboveThanBeside * std::abs(below);
  }
};

std::optional<Place> place_of(const Rig& rig, const std::string& first, const std::string& second) {
  const std::optional<Transform> T_c1_c2 = rig.resolve(first, second);
  if (!T_c1_c2) return std::nullopt;
  return Place{(*T_c1_c2)(0, 3), (*T_c1_c2)(1, 3)};
}

std::optional<Place> place_of_second(const Rig& rig) {
  if (rig.cameras.size() < 2) return std::nullopt;
  return place_of(rig, rig.cameras[0].name, rig.cameras[1].name);
}

std::optional<double> below(const std::optional<Place>& place) {
  if (!place || !place->is_vertical()) return std::nullopt;
  return place->below;
}

}  // namespace

std::optional<double> second_left_of_first(const Rig& rig) {
  const std::optional<Place> place = place_of_second(rig);
  if (!place || place->right >= 0.0 || place->is_vertical()) return std::nullopt;
  return -place->right;
}

std::optional<double> second_below_first(const Rig& rig) { return below(place_of_second(rig)); }

std::optional<double> second_below_first(const Rig& rig, const std::string& first, const std::string& second) {
  return below(place_of(rig, first, second));
}

}  // namespace fca
