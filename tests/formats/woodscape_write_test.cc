// SPDX-License-Identifier: BSD-3-Clause
// WoodScape's JSON written from rigs: our reader gives back the same doubles, projection.py's consumer the same pixels and
// pose, and an edit changes its own bytes only.
#include "formats/oracle_table.h"
#include "formats/rigs.h"
#include "woodscape/layout.h"

#include <fca/formats/proof.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>
#include <fca/rig/rotation.h>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

const Format& woodscape_format() { return *find_format("woodscape"); }
const consumers::Consumer& projection_py() { return *consumers::find_consumer("woodscape"); }

double random_in(double low, double high) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  return low + (high - low) * (static_cast<double>(bits >> 11U) * 0x1p-53);
}

Quaternion random_quaternion() {
  const Quaternion q = {random_in(-1.0, 1.0), random_in(-1.0, 1.0), random_in(-1.0, 1.0), random_in(-1.0, 1.0)};
  RC_PRE(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0.01);
  return q;
}

Camera random_camera() {
  const ImageSize size = {*rc::gen::inRange(64, 4000), *rc::gen::inRange(64, 3000)};
  const double k1 = random_in(60.0, 900.0);
  return {"FV",
          size,
          model_of("woodscape", {k1, random_in(-0.1, 0.1) * k1, random_in(0.0, 0.1) * k1, random_in(-0.02, 0.0) * k1,
                                 random_in(0.95, 1.05), random_in(0.3, 0.7) * size.width, random_in(0.3, 0.7) * size.height}),
          std::nullopt,
          std::nullopt,
          ""};
}

Rig random_rig() {
  Rig rig;
  rig.cameras.push_back(random_camera());
  rig.poses.push_back(
      {"vehicle", "FV",
       pose_of(normalised(random_quaternion()), {random_in(-5.0, 5.0), random_in(-5.0, 5.0), random_in(-5.0, 5.0)})});
  return rig;
}

std::string bytes_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

RC_GTEST_PROP(WoodScapeWrite, ReadsBackBitEqualAndProjectionPyAgrees, ()) {
  const Rig rig = random_rig();
  const Written written = written_by(woodscape_format(), nullptr, rig);
  const std::string bytes = bytes_of(written);
  RC_ASSERT(written.losses.empty());
  RC_ASSERT(written.defaults.empty());
  const Calibration back = calibration_of(bytes, "FV.json");
  RC_ASSERT(back.format->id == "woodscape");
  RC_ASSERT(back.rig.cameras == rig.cameras);
  // A quaternion is not a matrix: the pose survives to rounding, its translation to the bit.
  const Transform* pose = back.rig.stated("vehicle", "FV");
  RC_ASSERT(pose != nullptr);
  RC_ASSERT(test::element_difference(*pose, rig.poses.front().T_a_b) <= 2e-15);
  RC_ASSERT(translation_of(*pose) == translation_of(rig.poses.front().T_a_b));
  const ProofResult proof = prove(projection_py(), bytes, {}, rig);
  RC_ASSERT(proof.agrees());
  RC_ASSERT(proof.max_diff_pose <= 1e-14);
  RC_ASSERT(proof.warnings.empty());
}

// cx = width / 2 - 0.5 + cx_offset: the offset is chosen so that the sum is the same double. From a quarter of the image on
// there is one; nearer to its left edge cx has finer digits than any offset, and 1e-13 px are lost.
RC_GTEST_PROP(WoodScapeWrite, TheOffsetGivesBackTheCentre, ()) {
  const int size = *rc::gen::inRange(1, 20000);
  const double centre = random_in(0.25, 3.0) * size;
  RC_ASSERT(woodscape::centre_of(woodscape::offset_of(centre, size), size) == centre);
  const double left = random_in(-0.5, 0.25) * size;
  RC_ASSERT(std::abs(woodscape::centre_of(woodscape::offset_of(left, size), size) - left) <= 1e-15 * size);
}

RC_GTEST_PROP(WoodScapeWrite, QuaternionsAreOfUnitLengthWithPositiveW, ()) {
  const Transform T = pose_of(normalised(random_quaternion()), {0.0, 0.0, 0.0});
  const Quaternion q = quaternion_of(T);
  RC_ASSERT(q[3] >= 0.0);
  RC_ASSERT(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0) <= 1e-15);
  RC_ASSERT(test::element_difference(pose_of(q, {0.0, 0.0, 0.0}), T) <= 2e-15);
}

// Rotations by 180 degrees, where w is 0 and each of the others is the largest once.
TEST(WoodScapeWrite, HalfTurns) {
  for (const Quaternion& q : {Quaternion{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}})
    EXPECT_EQ(quaternion_of(pose_of(q, {1.0, 2.0, 3.0})), q);
}

// omnidet takes list(intrinsic.values()): the order is part of the format.
TEST(WoodScapeWrite, TheDatasetsLayout) {
  Rig rig;
  rig.cameras.push_back({"FV", ImageSize{1280, 966},
                         model_of("woodscape", {338.5, -30.25, 46.75, -6.875, 1.0025, 643.4375, 479.75}), std::nullopt,
                         std::nullopt, ""});
  rig.poses.push_back({"vehicle", "FV", pose_of({0.5, -0.5, 0.5, -0.5}, {3.7125, 0.015, 0.655})});
  EXPECT_EQ(bytes_of(written_by(woodscape_format(), nullptr, rig)), R"({
  "extrinsic": {
    "quaternion": [
      -0.5,
      0.5,
      -0.5,
      0.5
    ],
    "translation": [
      3.7125,
      0.015,
      0.655
    ]
  },
  "intrinsic": {
    "aspect_ratio": 1.0025,
    "cx_offset": 3.9375,
    "cy_offset": -2.75,
    "height": 966.0,
    "k1": 338.5,
    "k2": -30.25,
    "k3": 46.75,
    "k4": -6.875,
    "model": "radial_poly",
    "poly_order": 4,
    "width": 1280.0
  },
  "name": "FV"
}
)");
}

TEST(WoodScapeWrite, WithoutAPoseItIsIdentityAndSaid) {
  Rig rig;
  rig.cameras.push_back({"cam\"0", ImageSize{1280, 966},
                         model_of("woodscape", {338.5, -30.25, 46.75, -6.875, 1.0, 643.5, 479.75}), 0.0021, 30.0, "/cam0"});
  rig.imus.push_back(tumvi_imu());
  rig.poses.push_back({"cam\"0", "imu0", T_cam0_imu()});
  const Written written = written_by(woodscape_format(), nullptr, rig);
  ASSERT_EQ(written.defaults.size(), 1U);
  EXPECT_TRUE(written.defaults.front().look_at_it);
  std::vector<std::string> codes;
  for (const Loss& loss : written.losses) codes.push_back(id_of(loss));
  EXPECT_EQ(codes, (std::vector<std::string>{"time-offset-dropped", "topic-dropped", "frame-rate-dropped", "imu-dropped"}));
  EXPECT_EQ(calibration_of(bytes_of(written), "cam.json").rig.cameras[0].name, "cam\"0");
  EXPECT_TRUE(projection_py().load(bytes_of(written), {}).loads());
}

// The vehicle is found through the IMU, too.
TEST(WoodScapeWrite, ThePoseIsResolved) {
  Rig rig;
  rig.cameras.push_back({"FV", ImageSize{1280, 966}, model_of("woodscape", {338.5, -30.25, 46.75, -6.875, 1.0, 643.5, 479.75}),
                         std::nullopt, std::nullopt, ""});
  const Transform T_vehicle_imu = pose_of(normalised({0.1, 0.2, 0.3, 0.9}), {1.0, 0.5, 0.25});
  rig.poses.push_back({"FV", "imu0", T_cam0_imu()});
  rig.poses.push_back({"vehicle", "imu0", T_vehicle_imu});
  const Calibration back = calibration_of(bytes_of(written_by(woodscape_format(), nullptr, rig)), "FV.json");
  EXPECT_LE(test::element_difference(*back.rig.stated("vehicle", "FV"), T_vehicle_imu * inverse(T_cam0_imu()).value()), 1e-12);
}

struct Case {
  ParameterId parameter;
  const char* spelling;
};

TEST(WoodScapeEdit, OneNumberChangesItsOwnBytesOnly) {
  for (const char* file : {"front.json", "crlf-tabs.json", "one-line.json", "ints-and-more.json"}) {
    const std::string bytes = read_file(testdata_dir() / "woodscape" / "good" / file);
    const Calibration calibration = calibration_of(bytes, file);
    for (const Case& row : {Case{"k1", "338.5"},
                            {"k2", "-30.25"},
                            {"k3", "46.75"},
                            {"k4", "-6.875"},
                            {"aspect_ratio", "1.0025"},
                            {"cx", "3.9375"},
                            {"cy", "-2.75"}}) {
      SCOPED_TRACE(std::string(file) + " " + std::string(row.parameter.name()));
      Rig rig = calibration.rig;
      ASSERT_TRUE(
          set_parameter(rig.cameras[0].model, row.parameter, parameter(rig.cameras[0].model, row.parameter).value() + 0.125));
      const std::string wanted = text::format_real(text::parse_real(row.spelling).value() + 0.125);
      EXPECT_EQ(bytes_of(written_by(woodscape_format(), &calibration.documents.front(), rig)),
                with_replaced(bytes, row.spelling, wanted));
    }
    Rig rig = calibration.rig;
    rig.poses.front().T_a_b(2, 3) = 0.75;
    EXPECT_EQ(bytes_of(written_by(woodscape_format(), &calibration.documents.front(), rig)),
              with_replaced(bytes, "0.655", "0.75"))
        << "the rotation is the same, and so is the quaternion";
  }
}

TEST(WoodScapeEdit, ATurnedCameraGetsANewQuaternion) {
  const std::string bytes = read_file(testdata_dir() / "woodscape/good/front.json");
  const Calibration calibration = calibration_of(bytes, "front.json");
  Rig rig = calibration.rig;
  rig.poses.front().T_a_b = pose_of({0.5, -0.5, 0.5, -0.5}, {3.7125, 0.015, 0.655});
  const std::string edited = bytes_of(written_by(woodscape_format(), &calibration.documents.front(), rig));
  const Calibration back = calibration_of(edited, "front.json");
  EXPECT_EQ(back.rig.poses, rig.poses) << edited;
  EXPECT_TRUE(edited.ends_with(bytes.substr(bytes.find("\"translation\""))));
}

RC_GTEST_PROP(WoodScapeEdit, AnyOtherRigReadsBack, ()) {
  const std::string file =
      *rc::gen::element<std::string>("front.json", "crlf-tabs.json", "one-line.json", "ints-and-more.json");
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "woodscape" / "good" / file), file);
  const Rig rig = random_rig();
  const std::string edited = bytes_of(written_by(woodscape_format(), &calibration.documents.front(), rig));
  const Calibration back = calibration_of(edited, file);
  RC_ASSERT(back.rig.cameras[0].model == rig.cameras[0].model);
  RC_ASSERT(back.rig.cameras[0].image_size == rig.cameras[0].image_size);
  RC_ASSERT(prove(projection_py(), edited, {}, rig).agrees());
}

// A file without a pose, or with CARLA's, gets one where the rig has it.
TEST(WoodScapeEdit, AMissingPoseIsAdded) {
  for (const char* file : {"no-extrinsic.json", "carla.json", "no-quaternion.json"}) {
    SCOPED_TRACE(file);
    const Calibration calibration = calibration_of(read_file(testdata_dir() / "woodscape" / "bad" / file), file);
    EXPECT_TRUE(calibration.rig.poses.empty());
    Rig rig = calibration.rig;
    rig.poses.push_back({"vehicle", "FV", pose_of({0.5, -0.5, 0.5, -0.5}, {3.7125, 0.015, 0.655})});
    const std::string edited = bytes_of(written_by(woodscape_format(), &calibration.documents.front(), rig));
    EXPECT_EQ(calibration_of(edited, file).rig.poses, rig.poses) << edited;
    EXPECT_TRUE(prove(projection_py(), edited, {}, rig).agrees()) << edited;
  }
}

}  // namespace
}  // namespace fca::test
