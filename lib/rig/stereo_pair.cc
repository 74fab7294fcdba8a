// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/stereo_pair.h>

#include "frame_graph.h"

#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fca {

namespace {

constexpr double kLeastInCommon = 0.25;

/// Steps of a lattice over an image along each of its sides.
constexpr int kSteps = 16;
constexpr int kRings = kSteps / 2;

/// Calls `use` with the pixels of one ring of the lattice: ring 0 is the border.
template <class Use>
void for_ring(const ImageSize& size, int ring, const Use& use) {
  const int last = kSteps - 1 - ring;
  for (int i = ring; i <= last; ++i) {
    const bool is_side = i == ring || i == last;
    for (int j = ring; j <= last; j += is_side ? 1 : last - ring)
      use(Pixel{(i + 0.5) / kSteps * size.width - 0.5, (j + 0.5) / kSteps * size.height - 0.5});
  }
}

/// The rays of a lattice over a camera's image. Those of its border, where another camera sees least, come first.
std::vector<Ray> lattice_rays(const Camera& camera) {
  std::vector<Ray> rays;
  for (int ring = 0; ring < kRings; ++ring) {
    for_ring(*camera.image_size, ring, [&](const Pixel& pixel) {
      if (const std::optional<Ray> ray = unproject(camera.model, pixel)) rays.push_back(*ray);
    });
  }
  return rays;
}

/// Does the ray of `from` land in the image of `to`?
bool lands(const Ray& ray, const Camera& to, const Transform& T_to_from) {
  const std::optional<Pixel> there = project(to.model, rotated(T_to_from, ray));
  return there && to.image_size->holds(*there);
}

/// Is the share of `from`'s lattice that lands in the image of `to` kLeastInCommon or more? From the middle on, so that few
/// rays tell of cameras that look the same way.
bool sees_enough(const Camera& from, const Camera& to, const Transform& T_to_from) {
  int asked = 0;
  int seen = 0;
  const auto is_enough = [&seen](int of) { return seen >= kLeastInCommon * of; };
  for (int ring = kRings - 1; ring >= 0; --ring) {
    for_ring(*from.image_size, ring, [&](const Pixel& pixel) {
      const std::optional<Ray> ray = unproject(from.model, pixel);
      if (!ray) return;
      ++asked;
      if (lands(*ray, to, T_to_from)) ++seen;
    });
    if (is_enough(kSteps * kSteps)) return true;
  }
  return asked > 0 && is_enough(asked);
}

/// The share of the rays of another image that land in the image of `to`; `least` or less where that is no more than `least`.
double seen_share(const std::vector<Ray>& rays, const Camera& to, const Transform& T_to_from, double least) {
  const auto asked = static_cast<double>(rays.size());
  if (rays.empty()) return 0.0;
  std::size_t not_seen = 0;
  for (const Ray& ray : rays) {
    if (lands(ray, to, T_to_from)) continue;
    ++not_seen;
    if (const double most = static_cast<double>(rays.size() - not_seen) / asked; most <= least) return most;
  }
  return static_cast<double>(rays.size() - not_seen) / asked;
}

/// A camera, and its rays once they are asked for.
class Viewer {
 public:
  explicit Viewer(const Camera& camera) : camera_(camera) {}
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const std::vector<Ray>& rays() {
    if (!rays_) rays_ = lattice_rays(camera_);
    return *rays_;
  }

 private:
  const Camera& camera_;
  std::optional<std::vector<Ray>> rays_;
};

/// More than 45 degrees between their axes?
bool look_apart(const Transform& T_a_b) { return T_a_b(2, 2) < std::cos(std::numbers::pi / 4.0); }

/// As common_view() has it; `least` or less where that is no more than `least`.
std::optional<double> common_view(Viewer& a, Viewer& b, const std::optional<Transform>& T_a_b,
                                  const std::optional<Transform>& T_b_a, double least) {
  if (!T_a_b || !T_b_a || !a.camera().image_size || !b.camera().image_size) return std::nullopt;
  if (look_apart(*T_a_b)) return 0.0;
  const double of_a = seen_share(a.rays(), b.camera(), *T_b_a, least);
  if (of_a == 1.0) return of_a;
  return std::max(of_a, seen_share(b.rays(), a.camera(), *T_a_b, std::max(of_a, least)));
}

/// Two cameras of one lens, not turned: made to be a pair.
bool are_rectified(const Camera& a, const Camera& b, const std::optional<Transform>& T_a_b) {
  constexpr double kNotTurned = 1.0 - 1e-9;  // cosine
  return T_a_b && a.model == b.model && a.image_size == b.image_size && (*T_a_b)(0, 0) > kNotTurned &&
         (*T_a_b)(1, 1) > kNotTurned;
}

/// The poses of a rig's cameras to each other, searched for once.
class CameraPoses {
 public:
  explicit CameraPoses(const Rig& rig) : graph_(rig.poses) {
    for (const Camera& camera : rig.cameras) {
      numbers_.push_back(graph_.find(camera.name));
      poses_.push_back(numbers_.back() ? graph_.from(*numbers_.back()) : std::vector<std::optional<Transform>>());
    }
  }
  /// T_a_b of two places in Rig::cameras.
  [[nodiscard]] std::optional<Transform> between(std::size_t a, std::size_t b) const {
    return numbers_[a] && numbers_[b] ? poses_[a].at(*numbers_[b]) : std::nullopt;
  }

 private:
  internal::FrameGraph graph_;
  std::vector<std::optional<std::size_t>> numbers_;
  std::vector<std::vector<std::optional<Transform>>> poses_;
};

}  // namespace

std::optional<double> common_view(const Rig& rig, const Camera& a, const Camera& b) {
  constexpr double kAny = -1.0;
  Viewer first(a);
  Viewer second(b);
  return common_view(first, second, rig.resolve(a.name, b.name), rig.resolve(b.name, a.name), kAny);
}

bool may_be_stereo(const Rig& rig, const Camera& a, const Camera& b) {
  const std::optional<Transform> T_a_b = rig.resolve(a.name, b.name);
  const std::optional<Transform> T_b_a = rig.resolve(b.name, a.name);
  if (!T_a_b || !T_b_a || !a.image_size || !b.image_size) return true;
  return !look_apart(*T_a_b) && (sees_enough(a, b, *T_b_a) || sees_enough(b, a, *T_a_b));
}

std::optional<std::pair<std::size_t, std::size_t>> stereo_pair(const Rig& rig) {
  const CameraPoses poses(rig);
  std::vector<Viewer> viewers(rig.cameras.begin(), rig.cameras.end());
  std::optional<std::pair<std::size_t, std::size_t>> best;
  std::pair<bool, double> most = {false, 0.0};
  for (std::size_t i = 0; i < viewers.size(); ++i) {
    for (std::size_t j = i + 1; j < viewers.size(); ++j) {
      const std::optional<Transform> T_i_j = poses.between(i, j);
      const bool is_rectified = are_rectified(rig.cameras[i], rig.cameras[j], T_i_j);
      if (is_rectified < most.first) continue;
      const double to_beat = is_rectified == most.first ? most.second : 0.0;
      constexpr double kAll = 1.0;
      if (to_beat >= kAll) continue;
      const double common = common_view(viewers[i], viewers[j], T_i_j, poses.between(j, i), to_beat).value_or(0.0);
      const std::pair merit = {is_rectified, common};
      if (common < kLeastInCommon || merit <= most) continue;
      most = merit;
      best = {i, j};
    }
  }
  return best;
}

}  // namespace fca
