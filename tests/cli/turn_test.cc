// SPDX-License-Identifier: BSD-3-Clause
// --absorb-rotation: the turn of a camera that its fit takes is in the poses that are written, whatever the format.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/rig/rotation.h>

#include <cmath>

namespace fca::test {
namespace {

/// Two cameras with tangential terms, which kb4 and ds cannot hold.
constexpr const char* kChain =
    "cam0:\n"
    "  camera_model: pinhole\n"
    "  intrinsics: [460.0, 458.0, 367.0, 248.0]\n"
    "  distortion_model: radtan\n"
    "  distortion_coeffs: [-0.05, 0.01, 0.002, -0.001]\n"
    "  resolution: [752, 480]\n"
    "  rostopic: /cam0/image_raw\n"
    "  T_cam_imu:\n"
    "  - [0.0, 1.0, 0.0, 0.02]\n"
    "  - [-1.0, 0.0, 0.0, 0.01]\n"
    "  - [0.0, 0.0, 1.0, -0.03]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n"
    "cam1:\n"
    "  camera_model: pinhole\n"
    "  intrinsics: [462.0, 461.0, 375.0, 240.0]\n"
    "  distortion_model: radtan\n"
    "  distortion_coeffs: [-0.06, 0.01, -0.0015, 0.001]\n"
    "  resolution: [752, 480]\n"
    "  rostopic: /cam1/image_raw\n"
    "  T_cam_imu:\n"
    "  - [0.0, 1.0, 0.0, -0.09]\n"
    "  - [-1.0, 0.0, 0.0, 0.01]\n"
    "  - [0.0, 0.0, 1.0, -0.03]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n"
    "  T_cn_cnm1:\n"
    "  - [1.0, 0.0, 0.0, -0.11]\n"
    "  - [0.0, 1.0, 0.0, 0.0]\n"
    "  - [0.0, 0.0, 1.0, 0.0]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n";

/// How far apart two rigs see directions in a frame that both have, in pixels rms: the cameras in their order.
double rms_in_frame(const Rig& before, const Rig& after, const std::string& frame, const std::string& frame_after) {
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < before.cameras.size(); ++i) {
    const Camera& old_camera = before.cameras[i];
    const Camera& new_camera = after.cameras[i];
    const std::optional<Transform> T_frame_old = before.resolve(frame, old_camera.name);
    const std::optional<Transform> T_new_frame = after.resolve(new_camera.name, frame_after);
    EXPECT_TRUE(T_frame_old && T_new_frame);
    if (!T_frame_old || !T_new_frame) return HUGE_VAL;
    for (double u = 0.0; u < old_camera.image_size->width; u += 10.0) {
      for (double v = 0.0; v < old_camera.image_size->height; v += 10.0) {
        const std::optional<Ray> ray = unproject(old_camera.model, {u, v});
        if (!ray) continue;
        const std::optional<Pixel> pixel = project(new_camera.model, rotated(*T_new_frame, rotated(*T_frame_old, *ray)));
        EXPECT_TRUE(pixel);
        if (!pixel) continue;
        squares += std::pow((*pixel)[0] - u, 2) + std::pow((*pixel)[1] - v, 2);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 1000);
  return std::sqrt(squares / count);
}

TEST(Turn, IsInThePosesOfEveryFormat) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("camchain.yaml", kChain);
  const Rig before = rig_in(kChain);
  for (const char* format : {"kalibr", "basalt", "openvins"}) {
    SCOPED_TRACE(format);
    const Told straight({"convert", chain, "--to", format, "--model", "kb4"});
    const Told turned({"convert", chain, "--to", format, "--model", "kb4", "--absorb-rotation"});
    ASSERT_EQ(straight.code(), 0) << straight.text();
    ASSERT_EQ(turned.code(), 0) << turned.text();
    EXPECT_TRUE(straight.says("turn-would-help")) << straight.text();
    EXPECT_TRUE(turned.says("turned-into-pose")) << turned.text();
    const auto rig_of = [](const Told& told) { return rig_in(told.json()["outputs"][0]["text"].GetString()); };
    const auto frame_of = [](const Rig& rig) {
      for (const PoseEdge& edge : rig.poses) {
        for (const std::string& name : {edge.a, edge.b}) {
          if (rig.kind_of(name) == FrameKind::kImu) return name;
        }
      }
      return std::string();
    };
    const Rig rig_straight = rig_of(straight);
    const Rig rig_turned = rig_of(turned);
    const double rms_straight = rms_in_frame(before, rig_straight, frame_of(before), frame_of(rig_straight));
    const double rms_turned = rms_in_frame(before, rig_turned, frame_of(before), frame_of(rig_turned));
    EXPECT_LT(rms_turned, 0.6 * rms_straight);
    // As the report says of both cameras.
    double squares = 0.0;
    for (const auto& camera : turned.json()["cameras"].GetArray()) {
      squares += std::pow(camera["error_px"]["rms"].GetDouble(), 2);
      EXPECT_LT(camera["in_image_px"]["rms"].GetDouble(), 1.02 * camera["error_px"]["rms"].GetDouble());
      EXPECT_GT(camera["turn"]["rms_before_px"].GetDouble(), camera["error_px"]["rms"].GetDouble());
    }
    EXPECT_NEAR(rms_turned, std::sqrt(squares / 2.0), 0.05 * rms_turned);
  }
}

// compare folds the turn of a lens and that of its poses: what remains is the fit's error, and --strict has nothing to say.
TEST(Turn, IsFoldedByCompare) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("camchain.yaml", kChain);
  const std::string turned = folder / "turned.yaml";
  const Told converting(
      {"convert", chain, "--to", "kalibr", "--model", "kb4", "--absorb-rotation", "-o", turned, "--no-verify"});
  ASSERT_EQ(converting.code(), 0) << converting.text();
  const Told compared({"compare", chain, turned, "--strict", "--max-error", "1"});
  EXPECT_EQ(compared.code(), 0) << compared.text();
  const auto& file = compared.json()["files"][0];
  for (rapidjson::SizeType i = 0; i < 2; ++i) {
    const auto& camera = file["cameras"][i];
    const double fitted = converting.json()["cameras"][i]["error_px"]["rms"].GetDouble();
    EXPECT_TRUE(camera["rotated"]["cancels"].GetBool());
    EXPECT_NEAR(camera["rotated"]["error_px"]["rms"].GetDouble(), fitted, 0.02 * fitted);
    EXPECT_GT(camera["error_px"]["max"].GetDouble(), 1.0);
  }
  ASSERT_GT(file["poses"].Size(), 0U);
  for (const auto& pose : file["poses"].GetArray()) {
    EXPECT_GT(pose["rotation_deg"].GetDouble(), 0.05);
    EXPECT_LT(pose["remaining_rotation_deg"].GetDouble(), 0.1 * pose["rotation_deg"].GetDouble());
  }
  const std::string verdict = file["verdict"].GetString();
  EXPECT_TRUE(contains(verdict, "cam0") && contains(verdict, "cancel")) << verdict;
  // The lens alone, its poses as they were.
  const std::string lens = read_file(turned);
  const std::size_t first = lens.find("  T_cam_imu");
  ASSERT_NE(first, std::string::npos);
  const std::string lens_alone = folder.write("lens.yaml", read_file(chain).substr(0, std::string(kChain).find("cam1:")));
  const std::string turned_alone = folder.write("turned-alone.yaml", lens.substr(0, lens.find("cam1:")));
  EXPECT_EQ(run_program({"compare", lens_alone, turned_alone, "--max-error", "1"}).code, 0);
  const std::size_t line = lens.find('\n', first) + 1;
  const std::string unturned =
      folder.write("unturned.yaml", lens.substr(0, line) + "  - [0.0, 1.0, 0.0, 0.02]\n  - [-1.0, 0.0, 0.0, 0.01]\n" +
                                        "  - [0.0, 0.0, 1.0, -0.03]\n  - [0.0, 0.0, 0.0, 1.0]\n");
  const Told plain({"compare", lens_alone, unturned, "--max-error", "1"});
  EXPECT_EQ(plain.code(), 1) << plain.text();
  EXPECT_FALSE(plain.json()["files"][0]["cameras"][0]["rotated"]["cancels"].GetBool());
}

TEST(Turn, IsToldWhereNoPoseHoldsIt) {
  const TemporaryFolder folder;
  std::string lens = kChain;
  lens = lens.substr(0, lens.find("  T_cam_imu"));
  const std::string chain = folder.write("camchain.yaml", lens);
  const Told straight({"convert", chain, "--to", "kalibr", "--model", "kb4"});
  EXPECT_FALSE(straight.says("turn-would-help")) << straight.text();
  const Told turned({"convert", chain, "--to", "kalibr", "--model", "kb4", "--absorb-rotation"});
  EXPECT_EQ(turned.code(), 0) << turned.text();
  EXPECT_TRUE(turned.says("turned-into-pose")) << turned.text();
}

TEST(Turn, IsRefusedWhereItCannotBe) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("camchain.yaml", kChain);
  const std::string base = folder.write("base.yaml", kChain);
  EXPECT_EQ(run_program({"convert", chain, "--to", "kalibr", "--into", base, "--absorb-rotation"}).code, 3);
  EXPECT_EQ(run_program({"convert", chain, "--to", "kalibr", "--model", "kb4", "--absorb-rotation", "--objective", "max"}).code,
            3);
}

TEST(Fix, HoldsWhatIsAsked) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("camchain.yaml", kChain);
  const RunResult run =
      run_program({"convert", chain, "--to", "kalibr", "--model", "kb4", "--fix", "k4=0,cx", "--fix", "fx=fy"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Rig rig = rig_in(run.out);
  EXPECT_EQ(parameter(rig.cameras[0].model, "cx"), 367.0);
  for (const Camera& camera : rig.cameras) {
    EXPECT_EQ(parameter(camera.model, "k4"), 0.0);
    EXPECT_EQ(parameter(camera.model, "fx"), parameter(camera.model, "fy"));
  }
}

TEST(Fix, IsFittedEvenToTheModelThatIsThere) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("camchain.yaml", kChain);
  const RunResult run =
      run_program({"convert", chain, "--to", "opencv", "--model", "radtan", "--camera", "cam0", "--fix", "p1=0,p2=0"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Rig rig = rig_in(run.out);
  EXPECT_EQ(parameter(rig.cameras[0].model, "p1"), 0.0);
  EXPECT_NE(parameter(rig.cameras[0].model, "k1"), -0.05);
}

TEST(Fix, WantsAParameter) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("camchain.yaml", kChain);
  for (const char* words : {"q9=0", "k3=x", "cx,cx", "fx=fz", "=", ""}) {
    const RunResult run = run_program({"convert", chain, "--to", "kalibr", "--model", "kb4", "--fix", words});
    EXPECT_EQ(run.code, 3) << words << run.err;
  }
  // kb4 has no xi: nothing is written.
  EXPECT_NE(run_program({"convert", chain, "--to", "kalibr", "--model", "kb4", "--fix", "xi=0"}).code, 0);
}

}  // namespace
}  // namespace fca::test
