// SPDX-License-Identifier: BSD-3-Clause
// Short cuts of searches over a rig, against the search that looks at everything.
#include "../convert/random_model.h"

#include <fca/rig/stereo_pair.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

constexpr ImageSize kSize = {640, 480};

/// Cameras in a chain, each turned and moved a little from the last; few have one lens and no turn.
Rig random_rig(unsigned seed, int cameras) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-0.4, 0.4);
  std::uniform_int_distribution<int> one_in_three(0, 2);
  Rig rig;
  for (int i = 0; i < cameras; ++i) {
    const double focal = one_in_three(random) == 0 ? 300.0 : 300.0 + 100.0 * turn(random);
    rig.cameras.push_back(
        {"cam" + std::to_string(i), kSize, Intrinsics<Kb4>{{focal, focal, 319.5, 239.5, 0, 0, 0, 0}}, {}, {}, {}});
    if (i == 0) continue;
    const double angle = one_in_three(random) == 0 ? 0.0 : turn(random);
    PoseEdge edge{"cam" + std::to_string(i), "cam" + std::to_string(i - 1), {}};
    edge.T_a_b(0, 0) = edge.T_a_b(2, 2) = std::cos(angle);
    edge.T_a_b(0, 2) = -std::sin(angle);
    edge.T_a_b(2, 0) = std::sin(angle);
    edge.T_a_b(0, 3) = -0.1;
    rig.poses.push_back(edge);
  }
  return rig;
}

bool is_rectified(const Rig& rig, const Camera& a, const Camera& b) {
  const std::optional<Transform> T = rig.resolve(a.name, b.name);
  return T && a.model == b.model && (*T)(0, 0) > 1.0 - 1e-9 && (*T)(1, 1) > 1.0 - 1e-9;
}

TEST(StereoPair, IsTheOneOfAllThatHasMostInCommon) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Rig rig = random_rig(seed, 6);
    std::optional<std::pair<std::size_t, std::size_t>> best;
    std::pair<bool, double> most = {false, 0.0};
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      for (std::size_t j = i + 1; j < rig.cameras.size(); ++j) {
        const double common = common_view(rig, rig.cameras[i], rig.cameras[j]).value_or(0.0);
        const std::pair merit = {is_rectified(rig, rig.cameras[i], rig.cameras[j]), common};
        if (common < 0.25 || merit <= most) continue;
        most = merit;
        best = {i, j};
      }
    }
    EXPECT_EQ(stereo_pair(rig), best) << seed;
  }
}

TEST(StereoPair, MayBeOneWhereAQuarterIsInCommon) {
  int apart = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Rig rig = random_rig(seed, 6);
    for (const Camera& a : rig.cameras) {
      for (const Camera& b : rig.cameras) {
        const bool expected = common_view(rig, a, b).value_or(1.0) >= 0.25;
        apart += expected ? 0 : 1;
        EXPECT_EQ(may_be_stereo(rig, a, b), expected) << seed << " " << a.name << " " << b.name;
      }
    }
  }
  EXPECT_GT(apart, 0);
}

TEST(StereoPair, IsNotKnownOfCamerasWithoutPoses) {
  Rig rig = random_rig(1, 2);
  rig.poses.clear();
  EXPECT_EQ(common_view(rig, rig.cameras[0], rig.cameras[1]), std::nullopt);
  EXPECT_TRUE(may_be_stereo(rig, rig.cameras[0], rig.cameras[1]));
  EXPECT_EQ(stereo_pair(rig), std::nullopt);
}

}  // namespace
}  // namespace fca::test
