// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/stereo_pair.h>

#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

constexpr double kLeastInCommon = 0.25;

/// The share of `from`'s image whose rays land in the image of `to`.
double seen_share(const Camera& from, const Camera& to, const Transform& T_to_from) {
  constexpr int kSteps = 16;
  int asked = 0;
  int seen = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Pixel pixel = {(i + 0.5) / kSteps * from.image_size->width - 0.5,
                           (j + 0.5) / kSteps * from.image_size->height - 0.5};
      const std::optional<Ray> ray = unproject(from.model, pixel);
      if (!ray) continue;
      ++asked;
      const std::optional<Pixel> there = project(to.model, rotated(T_to_from, *ray));
      if (there && to.image_size->holds(*there)) ++seen;
    }
  }
  return asked > 0 ? static_cast<double>(seen) / asked : 0.0;
}

/// Two cameras of one lens, not turned: made to be a pair.
bool are_rectified(const Rig& rig, const Camera& a, const Camera& b) {
  const std::optional<Transform> T_a_b = rig.resolve(a.name, b.name);
  constexpr double kNotTurned = 1.0 - 1e-9;  // cosine
  return T_a_b && a.model == b.model && a.image_size == b.image_size && (*T_a_b)(0, 0) > kNotTurned &&
         (*T_a_b)(1, 1) > kNotTurned;
}

}  // namespace

std::optional<double> common_view(const Rig& rig, const Camera& a, const Camera& b) {
  const std::optional<Transform> T_a_b = rig.resolve(a.name, b.name);
  const std::optional<Transform> T_b_a = rig.resolve(b.name, a.name);
  if (!T_a_b || !T_b_a || !a.image_size || !b.image_size) return std::nullopt;
  const double cosine = (*T_a_b)(2, 2);  // between their axes
  if (cosine < std::cos(std::numbers::pi / 4.0)) return 0.0;
  return std::max(seen_share(a, b, *T_b_a), seen_share(b, a, *T_a_b));
}

bool may_be_stereo(const Rig& rig, const Camera& a, const Camera& b) {
  return common_view(rig, a, b).value_or(1.0) >= kLeastInCommon;
}

std::optional<std::pair<std::size_t, std::size_t>> stereo_pair(const Rig& rig) {
  std::optional<std::pair<std::size_t, std::size_t>> best;
  std::pair<bool, double> most = {false, 0.0};
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    for (std::size_t j = i + 1; j < rig.cameras.size(); ++j) {
      const double common = common_view(rig, rig.cameras[i], rig.cameras[j]).value_or(0.0);
      const std::pair merit = {are_rectified(rig, rig.cameras[i], rig.cameras[j]), common};
      if (common < kLeastInCommon || merit <= most) continue;
      most = merit;
      best = {i, j};
    }
  }
  return best;
}

}  // namespace fca
