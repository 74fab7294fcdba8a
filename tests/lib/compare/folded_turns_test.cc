// SPDX-License-Identifier: BSD-3-Clause
// A turn of a lens and an equal turn of its poses cancel. Evaluated by the rotation between the rays of a grid of pixels
// (Kabsch), which is computed here.
#include "lib/convert/known_cameras.h"

#include <fca/compare/compare.h>
#include <fca/convert/convert.h>
#include <fca/rig/rotation.h>

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace fca::test {
namespace {

Transform pose_of_vector(const Eigen::Vector3d& rotation, const Eigen::Vector3d& translation) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = R(row, column);
    T(row, 3) = translation[row];
  }
  return T;
}

/// The rotation nearest to what takes the reference's ray of each pixel to the other's.
Transform kabsch(const Camera& reference, const Camera& other) {
  Eigen::Matrix3d B = Eigen::Matrix3d::Zero();
  for (double u = 0.0; u < reference.image_size->width; u += 8.0) {
    for (double v = 0.0; v < reference.image_size->height; v += 8.0) {
      const std::optional<Ray> a = unproject(reference.model, {u, v});
      const std::optional<Ray> b = unproject(other.model, {u, v});
      if (a && b) B += Eigen::Map<const Eigen::Vector3d>(b->data()) * Eigen::Map<const Eigen::Vector3d>(a->data()).transpose();
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(B, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = R(row, column);
  }
  return T;
}

/// Lenses with tangential terms, which kb4 and ds cannot hold.
Camera tilted(const std::string& name, double sign) {
  Camera camera = make_camera(Intrinsics<Radtan>{{460, 458, 367, 248, -0.05, 0.01, sign * 0.004, -0.003, 0.0}}, {752, 480});
  camera.name = name;
  return camera;
}

struct Turned {
  Camera camera;
  Transform T_new_old;
  double rms_px = 0.0;
};

Turned turned(const Camera& camera, const char* model) {
  ConvertOptions options;
  options.model = model;
  options.absorb_turn = true;
  options.bound = false;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  EXPECT_TRUE(conversion && conversion->report.turn);
  if (!conversion || !conversion->report.turn) return {camera, {}};
  return {conversion->camera, conversion->report.turn->T_target_source, conversion->report.statistics.error.rms};
}

const Transform kCam0Imu = pose_of_vector({0.3, -1.2, 0.5}, {0.02, 0.3, -0.05});
const Transform kCam1Imu = pose_of_vector({0.3, -1.1, 0.6}, {-0.09, 0.3, -0.05});

Rig rig_of(const std::vector<Camera>& cameras, const std::vector<PoseEdge>& poses) {
  Rig rig;
  rig.cameras = cameras;
  rig.poses = poses;
  return rig;
}

RigComparison compared(const Rig& reference, const Rig& other, const CompareOptions& options = {}) {
  Diagnostics diagnostics;
  RigComparison result = compare(reference, other, options, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return result;
}

TEST(FoldedTurns, OfAnAbsorbedTurnOnlyTheFitsErrorRemains) {
  for (const char* model : {"kb4", "ds", "eucm"}) {
    SCOPED_TRACE(model);
    const Camera camera = tilted("cam0", 1.0);
    const Turned other = turned(camera, model);
    const RigComparison result = compared(rig_of({camera}, {{"cam0", "imu0", kCam0Imu}}),
                                          rig_of({other.camera}, {{"cam0", "imu0", other.T_new_old * kCam0Imu}}));
    ASSERT_EQ(result.cameras.size(), 1U);
    ASSERT_EQ(result.poses.size(), 1U);
    const CameraComparison& lens = result.cameras.front();
    const PoseComparison& pose = result.poses.front();
    ASSERT_TRUE(lens.turn_cancels);
    ASSERT_TRUE(pose.remaining);
    EXPECT_NEAR(lens.decisive().statistics.error.rms, other.rms_px, 0.01 * other.rms_px);
    EXPECT_GT(lens.difference.statistics.error.rms, 2.0 * other.rms_px) << "the test's turn is too small to tell";
    // What the poses say as they are, and what of that is left, by a rotation that was found otherwise.
    const double turn = angle_between(other.T_new_old, Transform());
    EXPECT_NEAR(pose.angle_rad, turn, 1e-9);
    const Transform T_new_old = kabsch(camera, other.camera);
    EXPECT_LT(angle_between(T_new_old * kCam0Imu, other.T_new_old * kCam0Imu), 0.1 * turn) << "Kabsch agrees that it cancels";
    EXPECT_LT(angle_between(T_new_old, lens.rotated->T_other_reference), 0.1 * turn);
    EXPECT_LT(pose.remaining->angle_rad, 0.02 * turn);
    EXPECT_LT(pose.apart(), 0.02 * turn / (0.5 * kRadians) + 1e-3);
    EXPECT_TRUE(result.mistakes.empty());
  }
}

TEST(FoldedTurns, OnlyTheLensOrOnlyThePoseTurnedStaysAsItIs) {
  const Camera camera = tilted("cam0", 1.0);
  const Turned other = turned(camera, "kb4");
  const Rig reference = rig_of({camera}, {{"cam0", "imu0", kCam0Imu}});
  const Transform T_turned = other.T_new_old * kCam0Imu;
  const auto back = inverse(other.T_new_old);
  ASSERT_TRUE(back);
  for (const auto& [what, rig] : {std::pair("lens", rig_of({other.camera}, {{"cam0", "imu0", kCam0Imu}})),
                                  std::pair("pose", rig_of({camera}, {{"cam0", "imu0", T_turned}})),
                                  std::pair("pose the wrong way", rig_of({other.camera}, {{"cam0", "imu0", *back * kCam0Imu}})),
                                  std::pair("no pose", rig_of({other.camera}, {}))}) {
    SCOPED_TRACE(what);
    const RigComparison result = compared(reference, rig);
    ASSERT_EQ(result.cameras.size(), 1U);
    EXPECT_FALSE(result.cameras.front().turn_cancels);
    EXPECT_EQ(&result.cameras.front().decisive(), &result.cameras.front().difference);
    for (const PoseComparison& pose : result.poses) {
      EXPECT_FALSE(pose.remaining);
      EXPECT_EQ(pose.decisive().angle_rad, pose.angle_rad);
      EXPECT_EQ(pose.decisive().distance_m, pose.distance_m);
    }
  }
}

TEST(FoldedTurns, APosesOfTwoCamerasHasTheTurnsOfBoth) {
  const std::vector<Camera> cameras = {tilted("cam0", 1.0), tilted("cam1", -1.0)};
  const std::vector<Turned> others = {turned(cameras[0], "kb4"), turned(cameras[1], "kb4")};
  const Transform back = inverse(others[0].T_new_old).value();
  const Transform T_cam1_cam0 = kCam1Imu * inverse(kCam0Imu).value();
  // With nothing else but the pose between them, and with an IMU.
  for (const bool has_imu : {false, true}) {
    std::vector<PoseEdge> poses = {{"cam1", "cam0", T_cam1_cam0}};
    std::vector<PoseEdge> poses_turned = {{"cam1", "cam0", others[1].T_new_old * T_cam1_cam0 * back}};
    if (has_imu) {
      poses.push_back({"cam0", "imu0", kCam0Imu});
      poses_turned.push_back({"cam0", "imu0", others[0].T_new_old * kCam0Imu});
    }
    const RigComparison result = compared(rig_of(cameras, poses), rig_of({others[0].camera, others[1].camera}, poses_turned));
    for (const CameraComparison& camera : result.cameras) EXPECT_TRUE(camera.turn_cancels) << camera.reference;
    ASSERT_EQ(result.poses.size(), has_imu ? 3U : 1U);
    for (const PoseComparison& pose : result.poses) {
      ASSERT_TRUE(pose.remaining);
      EXPECT_LT(pose.remaining->angle_rad, 0.05 * pose.angle_rad) << pose.a << pose.b;
    }
  }
}

// The turn is one of the whole lens, whatever part of it counts and whatever shift the points' distance would allow.
TEST(FoldedTurns, NeitherFocusNorDistanceHidesIt) {
  for (const char* model : {"kb4", "ds", "eucm"}) {
    const Camera camera = tilted("cam0", 1.0);
    const Turned other = turned(camera, model);
    const Rig reference = rig_of({camera}, {{"cam0", "imu0", kCam0Imu}});
    const Rig rig = rig_of({other.camera}, {{"cam0", "imu0", other.T_new_old * kCam0Imu}});
    const RigComparison plain = compared(reference, rig);
    ASSERT_TRUE(plain.cameras.front().turn_cancels);
    for (const std::optional<double> distance_m : {std::optional<double>(), std::optional(1.0), std::optional(20.0)}) {
      for (const std::optional<double> focus_rad :
           {std::optional<double>(), std::optional(10.0 * kRadians), std::optional(30.0 * kRadians)}) {
        SCOPED_TRACE(std::string(model) + ", distance " + std::to_string(distance_m.value_or(0.0)) + ", focus " +
                     std::to_string(focus_rad.value_or(0.0)));
        CompareOptions options;
        options.distance_m = distance_m;
        options.focus_rad = focus_rad;
        const RigComparison result = compared(reference, rig, options);
        const CameraComparison& lens = result.cameras.front();
        ASSERT_TRUE(lens.turn_cancels);
        EXPECT_EQ(lens.rotated->T_other_reference, plain.cameras.front().rotated->T_other_reference);
        EXPECT_FALSE(lens.rotated->distance_m);
        EXPECT_EQ(result.poses.front().remaining->angle_rad, plain.poses.front().remaining->angle_rad);
        EXPECT_EQ(lens.focus.has_value(), focus_rad.has_value());
        if (lens.focus) {
          EXPECT_EQ(&lens.decisive(), &*lens.focus->rotated);
        }
      }
    }
  }
}

// cam1's poses are turned with its lens, cam0's are not.
TEST(FoldedTurns, EachCameraIsForItself) {
  const std::vector<Camera> cameras = {tilted("cam0", 1.0), tilted("cam1", -1.0)};
  const std::vector<Turned> others = {turned(cameras[0], "kb4"), turned(cameras[1], "kb4")};
  const RigComparison result = compared(rig_of(cameras, {{"cam0", "imu0", kCam0Imu}, {"cam1", "imu0", kCam1Imu}}),
                                        rig_of({others[0].camera, others[1].camera},
                                               {{"cam0", "imu0", kCam0Imu}, {"cam1", "imu0", others[1].T_new_old * kCam1Imu}}));
  ASSERT_EQ(result.cameras.size(), 2U);
  EXPECT_FALSE(result.cameras[0].turn_cancels);
  EXPECT_TRUE(result.cameras[1].turn_cancels);
  for (const PoseComparison& pose : result.poses) {
    EXPECT_EQ(pose.remaining.has_value(), pose.a == "cam1") << pose.a << pose.b;
    EXPECT_LT(pose.decisive().angle_rad, 1e-4) << pose.a << pose.b;
  }
}

}  // namespace
}  // namespace fca::test
