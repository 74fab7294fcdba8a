// SPDX-License-Identifier: BSD-3-Clause
// Which pose is wrong where poses contradict each other, why, and how gravely.
#include <fca/code.h>
#include <fca/rig/contradictions.h>
#include <fca/rig/pose_mistake.h>
#include <fca/rig/rotation.h>

#include <array>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

Transform shifted(double x, double y = 0.0, double z = 0.0) { return {{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1}}; }

/// Cameras in a row, 0.1 m apart, each with its pose in the one before it and in the IMU.
Rig row_of(std::size_t cameras) {
  Rig rig;
  for (std::size_t i = 0; i < cameras; ++i) {
    Camera camera;
    camera.name = "cam" + std::to_string(i);
    rig.cameras.push_back(camera);
    if (i > 0) rig.poses.push_back({camera.name, "cam" + std::to_string(i - 1), shifted(-0.1)});
    rig.poses.push_back({camera.name, "imu0", shifted(-0.1 * static_cast<double>(i))});
  }
  return rig;
}

std::size_t place_of(const Rig& rig, const std::string& name) {
  std::size_t place = 0;
  while (name_of(rig.poses.at(place)) != name) ++place;
  return place;
}

TEST(OutvotedPose, NoneWhereAllAgree) { EXPECT_FALSE(outvoted_pose(row_of(4))); }

TEST(OutvotedPose, TwoPathsOutvoteOnePose) {
  for (const char* wrong : {"T_cam1_imu0", "T_cam2_imu0", "T_cam2_cam1"}) {
    Rig rig = row_of(4);
    const std::size_t place = place_of(rig, wrong);
    const Transform right = rig.poses[place].T_a_b;
    rig.poses[place].T_a_b = shifted(0.0, 0.02) * right;
    const auto found = outvoted_pose(rig);
    ASSERT_TRUE(found) << wrong;
    EXPECT_EQ(found->loop.edge, place) << wrong;
    EXPECT_EQ(found->blame, Blame::kOthersAgree);
    EXPECT_NEAR(difference_of(found->loop.around, right).distance_m, 0.0, 1e-12);
    EXPECT_TRUE(contradictions(without_pose(found->loop.edge, rig)).empty());
  }
}

// Three statements of one pose.
TEST(OutvotedPose, TwoStatementsOutvoteAThird) {
  Rig rig;
  rig.poses = {{"cam1", "cam0", shifted(-0.2)}, {"cam1", "cam0", shifted(-0.1)}, {"cam0", "cam1", shifted(0.1)}};
  const auto found = outvoted_pose(rig);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->loop.edge, 0U);
}

// Of the last camera either statement may be wrong; of a triangle any.
TEST(OutvotedPose, NobodyKnowsWhichOfTwo) {
  Rig end = row_of(3);
  end.poses[place_of(end, "T_cam2_cam1")].T_a_b = shifted(-0.1, 0.02);
  EXPECT_FALSE(outvoted_pose(end));
  Rig triangle = row_of(2);
  triangle.poses[place_of(triangle, "T_cam1_cam0")].T_a_b = shifted(-0.1, 0.02);
  EXPECT_FALSE(outvoted_pose(triangle));
}

// A stereo pair has its second camera on the right: the statement that says otherwise is the wrong one.
TEST(OutvotedPose, TheOrderOfThePairDecides) {
  Rig rig = row_of(2);
  const std::size_t place = place_of(rig, "T_cam1_cam0");
  rig.poses[place].T_a_b = shifted(0.1);
  const auto found = outvoted_pose(rig);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->loop.edge, place);
  EXPECT_EQ(found->blame, Blame::kOrderOfPair);
}

// Cameras that look away from each other are no pair, and stand on either side.
TEST(OutvotedPose, TheOrderOfNoPairDecidesNothing) {
  Rig rig = row_of(2);
  for (Camera& camera : rig.cameras) {
    camera.image_size = ImageSize{640, 480};
    camera.model = Intrinsics<Pinhole>{{400.0, 400.0, 319.5, 239.5}};
  }
  const Transform backwards = {{-1, 0, 0, -0.1, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}};
  rig.poses[place_of(rig, "T_cam1_imu0")].T_a_b = backwards;
  rig.poses[place_of(rig, "T_cam1_cam0")].T_a_b = shifted(2.0) * backwards;
  EXPECT_FALSE(outvoted_pose(rig));
}

// Nor has a pair of which one stands above the other a usual order.
TEST(OutvotedPose, TheOrderOfAVerticalPairDecidesNothing) {
  for (const double wrong : {-0.1, 0.2}) {
    Rig rig;
    rig.cameras = row_of(2).cameras;
    rig.poses = {{"cam0", "imu0", shifted(0.0)}, {"cam1", "imu0", shifted(0.0, 0.1)}, {"cam1", "cam0", shifted(0.0, wrong)}};
    EXPECT_FALSE(outvoted_pose(rig));
  }
}

TEST(OutvotedPose, TwoWrongPosesAreNotDecided) {
  Rig rig = row_of(5);
  for (const char* wrong : {"T_cam1_imu0", "T_cam3_imu0"}) {
    Transform& T = rig.poses[place_of(rig, wrong)].T_a_b;
    T = shifted(0.0, 0.02) * T;
  }
  EXPECT_FALSE(outvoted_pose(rig));
}

// A mirror is no statement of a pose, and has findings of its own.
TEST(OutvotedPose, NoneAmongMatricesThatAreNoRotations) {
  Rig rig = row_of(4);
  rig.poses[place_of(rig, "T_cam2_imu0")].T_a_b(0, 0) = -1.0;
  EXPECT_FALSE(outvoted_pose(rig));
}

// Whichever of the poses in the middle of a row is wrong, and by however much.
RC_GTEST_PROP(OutvotedPose, IsTheOneThatWasMoved, ()) {
  Rig rig = row_of(*rc::gen::inRange<std::size_t>(4, 8));
  const std::size_t place = *rc::gen::suchThat(rc::gen::inRange<std::size_t>(0, rig.poses.size()), [&rig](std::size_t i) {
    const std::string last = rig.cameras.back().name;
    const PoseEdge& edge = rig.poses[i];
    return edge.a != last && edge.a != "cam0" && edge.b != "cam0";
  });
  const double metres = 0.001 * *rc::gen::inRange(2, 5000);
  rig.poses[place].T_a_b = shifted(0.0, metres) * rig.poses[place].T_a_b;
  const auto found = outvoted_pose(rig);
  RC_ASSERT(found.has_value());
  RC_ASSERT(found->loop.edge == place);
}

/// Cameras in a row as above, and an IMU that is turned and away from all of them: no pose is its own inverse.
Rig turned_row_of(std::size_t cameras) {
  Rig rig = row_of(cameras);
  const Transform T_c0_imu = {{0, -1, 0, 0.05, 0, 0, -1, 0.03, 1, 0, 0, 0.02, 0, 0, 0, 1}};
  for (PoseEdge& edge : rig.poses) {
    if (edge.b == "imu0") edge.T_a_b = edge.T_a_b * T_c0_imu;
  }
  return rig;
}

/// The only contradiction; throws where there is not exactly one.
Contradiction contradiction_of(const Rig& rig) {
  const std::vector<Contradiction> found = contradictions(rig);
  if (found.size() != 1) throw std::runtime_error(std::to_string(found.size()) + " contradictions");
  return found.front();
}

TEST(Contradictions, AnInvertedPoseIsBlamedForIt) {
  for (const char* wrong : {"T_cam1_cam0", "T_cam1_imu0", "T_cam0_imu0"}) {
    Rig rig = turned_row_of(2);
    Transform& T = rig.poses[place_of(rig, wrong)].T_a_b;
    const Transform right = T;
    T = inverse(T).value();
    const Contradiction found = contradiction_of(rig);
    EXPECT_EQ(name_of(rig.poses[found.loop.edge]), wrong);
    EXPECT_EQ(found.mistake, Code::kPoseHoldsInverse) << wrong;
    EXPECT_NE(found.blame, Blame::kNone) << wrong;
    EXPECT_EQ(found.severity, Severity::kError) << wrong;
    EXPECT_NEAR(distance_between(found.loop.around, right), 0.0, 1e-12) << wrong;
  }
}

// Whoever writes the pose of one camera in the IMU the wrong way round writes all of them so.
TEST(Contradictions, AllPosesToAnImuMayBeInverted) {
  Rig rig = turned_row_of(3);
  rig.add_frame("imu0", FrameKind::kImu);
  for (PoseEdge& edge : rig.poses) {
    if (edge.b == "imu0") edge.T_a_b = inverse(edge.T_a_b).value();
  }
  const std::vector<Contradiction> found = contradictions(rig);
  EXPECT_EQ(found.size(), 3U);
  for (const Contradiction& each : found) {
    EXPECT_EQ(rig.poses[each.loop.edge].b, "imu0");
    EXPECT_EQ(each.mistake, Code::kPoseHoldsInverse);
  }
  EXPECT_FALSE(outvoted_pose(rig)) << "no single one is";
}

/// The transform of a camera at the right whose axes are nearly the first one's.
Transform turned_beside() {
  return {{0.99995, 0.0, 0.01, -0.11, 0.0, 1.0, 0.0, 0.001, -0.01, 0.0, 0.99995, 0.0005, 0.0, 0.0, 0.0, 1.0}};
}

// Inverting the pose between the cameras would close the loop, too, and put the right camera on the left.
TEST(Contradictions, AllPosesToAnImuAreWrongRatherThanTheOrderOfThePair) {
  Rig rig = row_of(2);
  rig.add_frame("imu0", FrameKind::kImu);
  const Transform T_cam0_imu0 = shifted(0.02);
  rig.poses[place_of(rig, "T_cam1_cam0")].T_a_b = turned_beside();
  rig.poses[place_of(rig, "T_cam0_imu0")].T_a_b = *inverse(T_cam0_imu0);
  rig.poses[place_of(rig, "T_cam1_imu0")].T_a_b = *inverse(turned_beside() * T_cam0_imu0);
  const std::vector<Contradiction> found = contradictions(rig);
  ASSERT_EQ(found.size(), 2U);
  for (const Contradiction& each : found) {
    EXPECT_EQ(each.mistake, Code::kPoseHoldsInverse);
    EXPECT_EQ(rig.poses[each.loop.edge].b, "imu0");
  }
}

// The poses to the IMU say left, the pose between the cameras says right: a mistake and the order disagree.
TEST(Contradictions, AMistakeAgainstTheOrderOfThePairBlamesNone) {
  Rig rig = row_of(2);
  rig.poses[place_of(rig, "T_cam1_cam0")].T_a_b = turned_beside();
  rig.poses[place_of(rig, "T_cam0_imu0")].T_a_b = shifted(0.02, 0.3);
  rig.poses[place_of(rig, "T_cam1_imu0")].T_a_b = *inverse(turned_beside()) * shifted(0.02, 0.3);
  const std::vector<Contradiction> found = contradictions(rig);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().blame, Blame::kNone);
}

// Nobody knows in which of several a mistake was made, where each alone would explain as much.
TEST(Contradictions, TheCandidatesAreNamedWhereMistakesOfSeveralWouldDo) {
  Rig rig = turned_row_of(6);
  const std::vector<std::size_t> wrong = {place_of(rig, "T_cam1_imu0"), place_of(rig, "T_cam4_imu0")};
  for (const std::size_t edge : wrong) rig.poses[edge].T_a_b = inverse(rig.poses[edge].T_a_b).value();
  const std::vector<Contradiction> found = contradictions(rig);
  EXPECT_EQ(found.size(), contradicting_loops(rig).size());
  for (const Contradiction& each : found) {
    EXPECT_EQ(each.blame, Blame::kNone);
    EXPECT_EQ(each.candidates, wrong);
  }
}

TEST(Contradictions, SomeTranslationsInMillimetresAreNamed) {
  Rig rig = turned_row_of(4);
  for (const char* wrong : {"T_cam1_cam0", "T_cam2_cam1", "T_cam3_cam2"}) {
    Transform& T = rig.poses[place_of(rig, wrong)].T_a_b;
    for (int row = 0; row < 3; ++row) T(row, 3) *= 1000.0;
  }
  const std::vector<Contradiction> found = contradictions(rig);
  EXPECT_EQ(found.size(), 3U);
  for (const Contradiction& each : found) {
    EXPECT_EQ(each.mistake, Code::kPoseInMillimetres);
    EXPECT_NE(rig.poses[each.loop.edge].b, "imu0");
  }
}

// Where nothing tells which is wrong, the last that was read is named, and none is blamed.
TEST(Contradictions, WithoutBlameEachLoopIsOne) {
  Rig rig = row_of(4);
  const std::array<double, 3> off = {0.005, 0.02, 0.03};
  for (std::size_t i = 1; i < 4; ++i) {
    Transform& T = rig.poses[place_of(rig, "T_cam" + std::to_string(i) + "_cam" + std::to_string(i - 1))].T_a_b;
    T = shifted(0.0, off.at(i - 1)) * T;
  }
  const std::vector<Contradiction> found = contradictions(rig);
  ASSERT_EQ(found.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Contradiction& each = found[i];
    EXPECT_EQ(name_of(rig.poses[each.loop.edge]), "T_cam" + std::to_string(i + 1) + "_imu0");
    EXPECT_EQ(each.blame, Blame::kNone);
    EXPECT_EQ(each.mistake, Code::kNone);
    EXPECT_EQ(each.severity, off.at(i) > 0.01 ? Severity::kError : Severity::kWarning);
  }
}

// What is no rotation is not inverted, and its loops are reported all the same.
TEST(Contradictions, AMatrixThatIsNoRotationIsReportedAndBlamesNone) {
  Rig rig = turned_row_of(3);
  rig.poses[place_of(rig, "T_cam0_imu0")].T_a_b(1, 2) = -1.1;
  Transform& T = rig.poses[place_of(rig, "T_cam2_cam1")].T_a_b;
  T = inverse(T).value();
  const std::vector<Contradiction> found = contradictions(rig);
  EXPECT_EQ(found.size(), contradicting_loops(rig).size());
  EXPECT_EQ(found.size(), 2U);
  for (const Contradiction& each : found) EXPECT_EQ(each.blame, Blame::kNone);
}

// Undoing one mistake never hides what else is wrong.
RC_GTEST_PROP(Contradictions, NameEachPoseOnceAndNoneWhereAllAgree, ()) {
  Rig rig = turned_row_of(*rc::gen::inRange<std::size_t>(2, 7));
  RC_ASSERT(contradictions(rig).empty());
  const int wrong = *rc::gen::inRange(1, 4);
  for (int i = 0; i < wrong; ++i) {
    PoseEdge& edge = rig.poses[*rc::gen::inRange<std::size_t>(0, rig.poses.size())];
    edge.T_a_b = *rc::gen::arbitrary<bool>() ? inverse(edge.T_a_b).value() : shifted(0.0, 0.02) * edge.T_a_b;
  }
  const std::vector<Contradiction> found = contradictions(rig);
  RC_ASSERT(found.empty() == contradicting_loops(rig).empty());
  std::set<std::size_t> edges;
  for (const Contradiction& each : found) {
    RC_ASSERT(edges.insert(each.loop.edge).second);
    RC_ASSERT((each.mistake == Code::kNone) || (each.blame != Blame::kNone));
    RC_ASSERT(each.candidates.empty() || each.blame == Blame::kNone);
  }
}

}  // namespace
}  // namespace fca::test
