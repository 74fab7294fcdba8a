// SPDX-License-Identifier: BSD-3-Clause
// The main job, as people and scripts see it: what is written, what is said of it, and the JSON of CLI.md.
#include "cli/message_facts.h"
#include "cli/read_rig.h"
#include "cli/spawn_program.h"
#include "cli/told.h"
#include "shell/option_hints.h"

#include <fca/code.h>
#include <fca/fca.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

const std::string kNoOpt = "ns15417/slam_no_opt";
const std::string kFisheyeOrbSlam = "lsyads/fisheye-ORB-SLAM";

/// An EUCM lens that ends 106 degrees from its axis, inside the image.
const std::string kWide =
    "cam0:\n  camera_model: eucm\n  intrinsics: [0.8, 1.3, 300.0, 300.0, 640.0, 400.0]\n"
    "  distortion_model: none\n  distortion_coeffs: []\n  resolution: [1280, 800]\n";

using Json = rapidjson::Document;
using Value = rapidjson::Value;

Json json_of(const RunResult& run) {
  Json document;
  document.Parse<rapidjson::kParseValidateEncodingFlag | rapidjson::kParseFullPrecisionFlag>(run.out.c_str(), run.out.size());
  EXPECT_FALSE(document.HasParseError()) << run.out << run.err;
  return document;
}

bool loads(const char* consumer, const std::string& bytes, const char* sensor) {
  return consumers::find_consumer(consumer)->load(bytes, {sensor}).loads();
}

/// A request as the command makes one, for results whose facts are not in the JSON.
ConvertRequest request_for(const std::string& file, const char* format, const char* model = nullptr) {
  ConvertRequest request;
  request.inputs.files = {file};
  request.to = find_format(format);
  if (model != nullptr) request.model = find_model(model);
  return request;
}

// 3dgrut gives up the border of a wide lens without a fisheye's angle: the model is the one of which it reaches the most.
TEST(Convert, AModelOfWhichTheProgramReachesMoreIsChosen) {
  const TemporaryFolder folder;
  const std::string wide = folder.write("cameras.txt",
                                        "1 THIN_PRISM_FISHEYE 640 480 310 309 318.5 241 0.012 0.0 0.0001 0.0001 0.0 0.0 "
                                        "0.0001 0.0\n");
  const Told run({"convert", wide, "--to", "3dgrut"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(contains(run.bytes(), "OPENCV_FISHEYE 640")) << run.text();
  const Told asked({"convert", wide, "--to", "3dgrut", "--model", "rational"});
  EXPECT_TRUE(contains(asked.bytes(), "FULL_OPENCV 640")) << asked.text();
}

// The program asked is that of the file's own content: poses alone, whatever the other file adds.
TEST(Convert, AFileOfPosesIsNotRefusedForTheCamerasOfAnother) {
  const TemporaryFolder folder;
  const std::string pairs = testdata("formats/euroc/cuvslam-rig/pairs.yaml");
  const Told run({"convert", pairs, "--with", kTumvi, "--to", "basalt", "-v"});
  EXPECT_FALSE(contains(run.text(), std::string(info(Code::kInputRefused).id))) << run.text();
}

TEST(Convert, TumViBecomesAStereoInertialV1File) {
  const Told run({"convert", kTumvi, "--with", kImu, "--to", "orbslam3"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(contains(run.headline(), "stereo-inertial")) << run.text();
  EXPECT_TRUE(loads("orbslam3", run.bytes(), "stereo-inertial")) << run.bytes();
  const Rig rig = rig_in(run.bytes());
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(rig.cameras[0].model, rig_in(read_file(kTumvi)).cameras[0].model) << "kb4 is kept to the last bit";
}

TEST(Convert, TheFirstLineSaysWhatIsMissingForMore) {
  const Told run({"convert", kTumvi, "--to", "orbslam3"});
  EXPECT_EQ(run.code(), 0);
  EXPECT_TRUE(contains(run.headline(), "--with imu.yaml")) << run.headline();
  // It is the first thing that people read, after the summary.
  EXPECT_TRUE(contains(run_program({"convert", kTumvi, "--to", "orbslam3"}).err, "\n" + run.headline() + "\n"));
  Files files;
  const ConvertResult result = convert(request_for(kTumvi, "orbslam3"), files);
  EXPECT_EQ(result.mode, "stereo");
  ASSERT_EQ(result.headline.code, Code::kOrbslam3Headline);
  EXPECT_EQ(argument<std::string>(result.headline, 1), "stereo");
  const std::vector<Message>& next = clauses(result.headline, 2);
  ASSERT_EQ(next.size(), 1U);
  EXPECT_EQ(next.front().code, Code::kOrbslam3ModeLacks);
  EXPECT_EQ(argument<std::string>(next.front(), 0), "stereo-inertial");
}

TEST(Convert, TheEucmDialectSaysWhoReadsIt) {
  const std::vector<std::string> words = {"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--model", "eucm"};
  const RunResult run = run_program(words);
  EXPECT_EQ(run.code, 0) << run.err;
  Files files;
  ConvertRequest request = request_for(kTumvi, "orbslam3", "eucm");
  for (const auto& [camera, readers] : {std::pair{"", std::vector{kNoOpt}}, {"cam0", {kNoOpt, kFisheyeOrbSlam}}}) {
    if (*camera != '\0') request.inputs.cameras = {{CameraChoice{camera}}};
    const Message headline = convert(request, files).headline;
    ASSERT_EQ(headline.code, Code::kOrbslam3Headline);
    const Message& audience = clauses(headline, 0).at(0);
    EXPECT_EQ(audience.code, Code::kOrbslam3ReadBy) << "and not by the stock program";
    EXPECT_EQ(argument<std::vector<std::string>>(audience, 0), readers);
    EXPECT_EQ(clauses(audience, 1).at(0).code, Code::kOrbslam3StockByModel);
  }
  // In a line of its own, with the option that gives the stock program's.
  const std::string headline = Told(words).headline();
  EXPECT_TRUE(contains(run.err, "\n" + headline + "\n")) << run.err;
  for (const std::string& value : {kNoOpt, std::string("--model")}) EXPECT_TRUE(contains(headline, value)) << headline;
  EXPECT_FALSE(contains(headline, kFisheyeOrbSlam)) << headline;
  EXPECT_FALSE(contains(run.out, "File.version"));
  EXPECT_TRUE(contains(run.out, "Camera.type: \"EUCM\"")) << run.out;
  EXPECT_TRUE(loads("slam_no_opt", run.out, "mono"));
  EXPECT_TRUE(loads("slam_no_opt", run.out, "stereo"));
  EXPECT_FALSE(loads("orbslam3", run.out, "mono"));
  const Rig rig = rig_in(run.out);
  ASSERT_EQ(rig.cameras.size(), 2U);
  for (const Camera& camera : rig.cameras) EXPECT_GT(parameter(camera.model, "alpha").value_or(0.0), 0.5);
}

TEST(Convert, TheObjectiveMaxCutsTheWorstPixelAndSaysWhatItCosts) {
  const std::vector<std::string> command = {"convert", kTumvi, "--camera",    "cam0", "--to",  "orbslam3",
                                            "--model", "eucm", "--max-angle", "97.5", "--json"};
  const auto with = [&](const char* objective) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"--objective", objective});
    return json_of(run_program(words));
  };
  const Json rms = with("rms");
  const Json max = with("max");
  EXPECT_EQ(json_of(run_program(command))["cameras"][0]["parameters"], rms["cameras"][0]["parameters"]) << "rms is the default";
  const Value& before = rms["cameras"][0];
  const Value& after = max["cameras"][0];
  EXPECT_STREQ(before["objective"].GetString(), "rms");
  EXPECT_TRUE(before["rms_fit"].IsNull());
  EXPECT_STREQ(after["objective"].GetString(), "max");
  EXPECT_FALSE(after["rms_fit"]["kept"].GetBool());
  EXPECT_EQ(after["rms_fit"]["rms_px"], before["error_px"]["rms"]);
  EXPECT_EQ(after["rms_fit"]["max_px"], before["error_px"]["max"]);
  EXPECT_LT(after["error_px"]["max"].GetDouble(), before["error_px"]["max"].GetDouble());
  EXPECT_GT(after["error_px"]["rms"].GetDouble(), before["error_px"]["rms"].GetDouble());
  EXPECT_GT(after["parameters"]["alpha"].GetDouble(), 0.5) << "what the program demands holds all the same";
}

// FORMATS.md 3.4: at alpha <= 0.5 both forks reject every point. A source that has it is fitted again with alpha above.
TEST(Convert, AnEucmWithSmallAlphaIsNotPassedThrough) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "small.yaml", with_replaced(with_replaced(read_file(kEucm), "0.6291060881178562", "0.45"), "1.0418067381860868", "1.6"));
  const RunResult run = run_program({"convert", path, "--to", "orbslam3", "--model", "eucm", "--max-angle", "60"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_GT(parameter(rig_in(run.out).cameras.at(0).model, "alpha").value(), 0.5);
}

TEST(Convert, ADoubleSphereChainBecomesKannalaBrandt8) {
  const RunResult run = run_program({"convert", kDs, "--to", "orbslam3"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "Camera.type: \"KannalaBrandt8\"")) << run.out;
  EXPECT_TRUE(contains(run.err, "ds -> kb4")) << run.err;
  EXPECT_TRUE(loads("orbslam3", run.out, "stereo"));
}

// Whatever the JSON has of these stands in the report for people, too.
TEST(Convert, TheReportNamesWhatCliMdAsksFor) {
  const std::vector<std::string> words = {"convert", kDs, "--to", "orbslam3"};
  const RunResult run = run_program(words);
  const Told told(words);
  const auto expect_said = [&run](const std::string& value) {
    EXPECT_TRUE(contains(run.err, value)) << value << " is not in\n" << run.err;
  };
  ASSERT_EQ(told.json()["cameras"].Size(), 2U);
  for (const Value& camera : told.json()["cameras"].GetArray()) {
    expect_said(camera["name"].GetString());
    ASSERT_EQ(camera["parameters"].MemberCount(), 8U);
    for (const auto& parameter : camera["parameters"].GetObject())
      expect_said(parameter.name.GetString() + (" " + text::format_short(parameter.value.GetDouble(), 9)));
    for (const char* figure : {"rms", "max"})
      expect_said(text::format_short(camera["error_px"][figure].GetDouble(), 3) + " px");
  }
  EXPECT_TRUE(told.lost("time-offset-dropped", "cam0 timeshift_cam_imu 0.0021 s")) << told.text();
  for (const Value& loss : told.json()["losses"].GetArray()) expect_said(loss["what"].GetString());
  for (const char* key : {"Camera.fps", "Camera.RGB", "ORBextractor.*", "Viewer.*"}) EXPECT_TRUE(told.made_up(key)) << key;
  for (const Value& value : told.json()["defaults"].GetArray()) expect_said(value["key"].GetString());
  ASSERT_FALSE(told.json()["proof"].Empty());
  for (const Value& proof : told.json()["proof"].GetArray()) expect_said(proof["program"].GetString());
}

TEST(Convert, TimeOffsetsAreLostWithTheirSignAndARemedy) {
  const Json json = json_of(run_program({"convert", kDs, "--to", "orbslam3", "--json"}));
  std::vector<const Value*> offsets;
  for (const Value& loss : json["losses"].GetArray()) {
    for (const char* key : {"code", "what", "why", "do"}) EXPECT_TRUE(loss[key].IsString()) << key;
    if (loss["code"] == "time-offset-dropped") offsets.push_back(&loss);
  }
  ASSERT_EQ(offsets.size(), 2U);
  for (const auto& [i, camera, offset] : {std::tuple{0U, "cam0", " 0.0021 s"}, {1U, "cam1", " -0.0035 s"}}) {
    const Value& loss = *offsets[i];
    EXPECT_TRUE(contains(loss["what"].GetString(), std::string(camera) + " timeshift_cam_imu" + offset));
    for (const char* value : {camera, offset}) EXPECT_TRUE(contains(loss["do"].GetString(), value)) << loss["do"].GetString();
  }
}

// A file that says where its camera sits in the vehicle, and a target that has no place for a vehicle.
TEST(Convert, APoseThatIsDroppedIsALoss) {
  const std::string front = testdata("formats/woodscape/good/front.json");
  const std::string rear = testdata("formats/woodscape/good/crlf-tabs.json");
  const Told one({"convert", front, "--to", "kalibr"});
  EXPECT_TRUE(one.lost("pose-dropped", "T_vehicle_FV")) << one.text();
  // Kalibr knows no vehicle: what it uses is all there.
  const Told joined({"convert", front, rear, "--join", "--to", "kalibr", "--strict"});
  EXPECT_EQ(joined.code(), 0) << joined.text();
  for (const char* pose : {"T_vehicle_FV", "T_vehicle_RV"}) EXPECT_TRUE(joined.lost("pose-dropped", pose)) << joined.text();
  EXPECT_EQ(run_program({"convert", front, "--to", "woodscape", "--strict"}).code, 0);
}

// Nobody asked for the other camera: neither it nor its pose is lost, and what was known by way of it stays known.
TEST(Convert, ACameraLeftOutIsNoLoss) {
  const Told run({"convert", kTumvi, "--with", kImu, "--camera", "1", "--to", "orbslam3"});
  EXPECT_FALSE(run.lost("pose-dropped")) << run.text();
  EXPECT_TRUE(contains(run.bytes(), "IMU.T_b_c1"));
}

TEST(Convert, ThereAndBackThroughTheCommand) {
  const TemporaryFolder folder;
  const std::string settings = folder / "settings.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "-o", settings}).code, 0);
  const RunResult run = run_program({"convert", settings, "--to", "kalibr", "-o", folder / "back/"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Rig start = rig_in(read_file(kTumvi));
  const Rig back = rig_in(read_file(folder / "back/camchain.yaml"));
  ASSERT_EQ(back.cameras.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(back.cameras[i].model, start.cameras[i].model);
  for (const auto& [a, b] : {std::pair{"cam1", "cam0"}, std::pair{"cam0", "imu0"}}) {
    for (std::size_t i = 0; i < 16; ++i)
      EXPECT_NEAR(back.resolve(a, b).value().values[i], start.resolve(a, b).value().values[i], 1e-12);
  }
  EXPECT_TRUE(fs::exists(folder / "back/imu.yaml"));
}

TEST(Convert, TheSameFormatWithoutAChangeIsTheSameBytes) {
  const std::vector<std::pair<std::string, std::string>> kFiles = {
      {"kalibr", "formats/kalibr/good/tumvi.yaml"},
      {"kalibr", "formats/kalibr/good/crlf.yaml"},
      {"kalibr", "formats/kalibr/good/block-style.yaml"},
      {"orbslam3", "formats/orbslam3/good/v1-stereo-inertial.yaml"},
      {"orbslam3", "formats/orbslam3/good/v1-pinhole.yaml"}};
  for (const auto& [format, file] : kFiles) {
    const RunResult run = run_program({"convert", testdata(file), "--to", format});
    EXPECT_EQ(run.code, 0) << file << run.err;
    EXPECT_EQ(run.out, read_file(testdata(file))) << file;
  }
}

TEST(Convert, ChosenCamerasComeInTheirOrderWithTheirPoses) {
  const RunResult swapped = run_program({"convert", kTumvi, "--camera", "1,0", "--to", "kalibr"});
  ASSERT_EQ(swapped.code, 0) << swapped.err;
  const Rig start = rig_in(read_file(kTumvi));
  const Rig rig = rig_in(swapped.out);
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(rig.cameras[0].name, "cam0");
  EXPECT_EQ(rig.cameras[0].model, start.cameras[1].model);
  EXPECT_EQ(rig.cameras[1].model, start.cameras[0].model);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(rig.resolve("cam1", "cam0").value().values[i], start.resolve("cam0", "cam1").value().values[i], 1e-12);
    EXPECT_NEAR(rig.resolve("cam0", "imu0").value().values[i], start.resolve("cam1", "imu0").value().values[i], 1e-12);
  }
  // Kalibr takes baselines from T_cn_cnm1 alone, though T_cam_imu implies them.
  EXPECT_NE(rig.stated("cam1", "cam0"), nullptr) << swapped.out;
  EXPECT_FALSE(contains(swapped.err, "cam1/T_cn_cnm1")) << swapped.err;
  const RunResult one = run_program({"convert", kTumvi, "--camera", "cam1", "--to", "orbslam3", "--with", kImu});
  ASSERT_EQ(one.code, 0) << one.err;
  const Rig mono = rig_in(one.out);
  ASSERT_EQ(mono.cameras.size(), 1U);
  EXPECT_EQ(mono.cameras[0].model, start.cameras[1].model);
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_NEAR(mono.resolve("cam0", "imu0").value().values[i], start.resolve("cam1", "imu0").value().values[i], 1e-12);
}

TEST(Convert, SensorsAreServedOrRefused) {
  for (const char* sensor : {"mono", "stereo", "mono-inertial", "stereo-inertial"}) {
    const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--sensor", sensor});
    EXPECT_EQ(run.code, 0) << sensor << run.err;
    EXPECT_TRUE(loads("orbslam3", run.out, sensor)) << sensor;
  }
  const RunResult refused = run_program({"convert", kTumvi, "--to", "orbslam3", "--sensor", "mono-inertial"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_TRUE(says(refused.err, "sensor-not-served", "imu.yaml")) << refused.err;
  const RunResult depth =
      run_program({"convert", kEucm, "--to", "orbslam3", "--sensor", "rgbd", "--baseline", "0.05", "--max-angle", "60"});
  EXPECT_EQ(depth.code, 0) << depth.err;
  EXPECT_TRUE(loads("orbslam3", depth.out, "rgbd"));
  EXPECT_NEAR(rig_in(depth.out).baseline_m.value(), 0.05, 1e-12);
}

// One camera is exact as PinHole; with the other it would have to become a Kannala-Brandt.
TEST(Convert, ModelsAreChosenForTheCamerasOfTheMode) {
  const std::string first =
      "cam0:\n  camera_model: pinhole\n  intrinsics: [411.5, 412.25, 321.5, 238.5]\n  distortion_model: radtan\n"
      "  distortion_coeffs: [-0.28, 0.0725, 0.0003, -0.0002]\n  resolution: [640, 480]\n";
  const std::string second =
      "cam1:\n  camera_model: pinhole\n  intrinsics: [191.5, 191.25, 321.0, 239.0]\n  distortion_model: equidistant\n"
      "  distortion_coeffs: [0.0035, 0.0007, -0.002, 0.0002]\n  resolution: [640, 480]\n  T_cn_cnm1:\n";
  const std::string beside = "  - [1.0, 0.0, 0.0, -0.11]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n";
  const std::string away = "  - [0.0, 0.0, 1.0, -0.11]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [-1.0, 0.0, 0.0, 0.0]\n";
  const std::string last = "  - [0.0, 0.0, 0.0, 1.0]\n";
  const TemporaryFolder folder;
  const std::string pair = folder.write("pair.yaml", first + second + beside + last);
  const std::string apart = folder.write("apart.yaml", first + second + away + last);
  for (const Told& run :
       {Told({"convert", pair, "--to", "orbslam3", "--sensor", "mono"}), Told({"convert", apart, "--to", "orbslam3"})}) {
    ASSERT_EQ(run.json()["cameras"].Size(), 1U) << run.text();
    EXPECT_TRUE(run.json()["cameras"][0]["exact"].GetBool()) << run.text();
    EXPECT_EQ(std::string(run.json()["cameras"][0]["to_model"].GetString()), "radtan") << run.text();
  }
  const Told both({"convert", pair, "--to", "orbslam3", "--accept", "pixels-off"});
  EXPECT_EQ(both.json()["cameras"].Size(), 2U) << both.text();
}

TEST(Convert, AStatedFrameRateIsNoDefault) {
  const RunResult run = run_program({"convert", kTumvi, "--to", "orbslam3", "--fps", "30", "--orbslam3-layout", "v1"});
  EXPECT_TRUE(contains(run.out, "Camera.fps: 30\n")) << run.out;
  EXPECT_FALSE(contains(run.err, "Camera.fps")) << run.err;
}

TEST(ConvertImu, AloneIsAFileOfKalibrsAndKeepsItsBytes) {
  const std::string imu = testdata("formats/kalibr/good/imu.yaml");
  const RunResult kept = run_program({"convert", imu, "--to", "kalibr"});
  EXPECT_EQ(kept.code, 0) << kept.err;
  EXPECT_EQ(kept.out, read_file(imu));
}

TEST(ConvertImu, OfSingleSamplesBecomesDensitiesInPlace) {
  const TemporaryFolder folder;
  const std::string imu =
      folder.write("imu.yaml",
                   "update_rate: 400.0  # Hz\naccelerometer_noise_density: 0.04\naccelerometer_random_walk: 0.0002\n"
                   "gyroscope_noise_density: 0.04  # of single samples\ngyroscope_random_walk: 0.0001\nrostopic: /imu0\n");
  const RunResult run = run_program({"convert", imu, "--to", "kalibr", "--imu-noise", "discrete"});
  EXPECT_EQ(run.code, 0) << run.err;
  // Noise of a sample is density * sqrt(rate), a step of the walk is walk / sqrt(rate) (Kalibr wiki, "IMU noise model").
  EXPECT_EQ(run.out,
            "update_rate: 400.0  # Hz\naccelerometer_noise_density: 0.002\naccelerometer_random_walk: 0.004\n"
            "gyroscope_noise_density: 0.002  # of single samples\ngyroscope_random_walk: 0.002\nrostopic: /imu0\n");
}

TEST(Convert, AnImuAloneIsAnsweredWithTheCommandThatWasMeant) {
  const RunResult run = run_program({"convert", kImu, "--to", "orbslam3"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(says(run.err, "no-camera", "fca-io convert camchain.yaml --with " + kImu)) << run.err;
  // Of which of two it is a part nobody says.
  const RunResult three = run_program({"convert", kTumvi, kDs, kImu, "--to", "orbslam3", "-o", "written/", "--dry-run"});
  EXPECT_EQ(three.code, 2);
  EXPECT_TRUE(says(three.err, "no-camera", "--with " + kImu)) << three.err;
}

TEST(Convert, APoseAloneIsAnsweredWithOpenCvsNames) {
  const RunResult run = run_program({"convert", testdata("formats/opencv/good/extrinsics.yml"), "--to", "kalibr"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(says(run.err, "no-camera", "fca-io convert intrinsics.yml --with ")) << run.err;
}

// No file of OpenCV's specifies the unit of T.
TEST(Convert, TheUnitOfOpenCvsPoseIsAnAssumption) {
  const std::string pair = testdata("formats/opencv/good/k1d1.yml");
  for (const char* to : {"kalibr", "opencv"}) {
    const Json json = json_of(run_program({"convert", pair, "--size", "640x400", "--to", to, "--max-angle", "40", "--json"}));
    const bool listed = std::ranges::any_of(json["defaults"].GetArray(), [](const Value& value) {
      return std::string_view(value["key"].GetString()) == "translation unit" && value["look_at_it"].GetBool();
    });
    EXPECT_EQ(listed, std::string_view(to) == "kalibr");
  }
}

TEST(Convert, MaxAngleIsTheFieldOfView) {
  const Json whole =
      json_of(run_program({"convert", kTumvi, "--camera", "0", "--to", "orbslam3", "--model", "eucm", "--json"}));
  const Json lens = json_of(run_program(
      {"convert", kTumvi, "--camera", "0", "--to", "orbslam3", "--model", "eucm", "--max-angle", "97.5", "--json"}));
  const Value& all = whole["cameras"][0];
  const Value& cut = lens["cameras"][0];
  EXPECT_NEAR(cut["domain"]["max_angle_deg"].GetDouble(), 97.5, 1e-6);
  EXPECT_GT(all["domain"]["max_angle_deg"].GetDouble(), 97.5);
  EXPECT_GT(cut["domain"]["outside_lens_share"].GetDouble(), 0.01);
  EXPECT_LT(cut["error_px"]["rms"].GetDouble(), all["error_px"]["rms"].GetDouble());
  EXPECT_EQ(cut["domain"]["why"].GetString(), text::text_of({Code::kFieldOfViewGiven}, cli::with_options));
}

TEST(Convert, TheAngleOfATargetThatReachesLessIsReported) {
  const std::vector<std::string> command = {"convert", kTumvi, "--camera", "0", "--to", "opencv", "--model", "radtan"};
  std::vector<std::string> with_json = command;
  with_json.emplace_back("--json");
  const Json json = json_of(run_program(with_json));
  const Value& camera = json["cameras"][0];
  const double end = camera["domain"]["scored_to_deg"].GetDouble();
  EXPECT_LT(end, 70.0);
  EXPECT_GT(camera["domain"]["max_angle_deg"].GetDouble(), 100.0);
  for (const Value& band : camera["bands"].GetArray())
    EXPECT_EQ(band["share"].GetDouble() > 0.0, band["from_deg"].GetDouble() < end);
  // Whether the lens ends at 90 degrees or further out is the same to it.
  ASSERT_GE(camera["reach"].Size(), 3U);
  for (const Value& row : camera["reach"].GetArray()) {
    EXPECT_EQ(row["rms_px"].GetDouble(), camera["error_px"]["rms"].GetDouble());
    EXPECT_EQ(row["scored_share"].GetDouble(), camera["domain"]["scored_share"].GetDouble());
  }
  std::vector<std::string> as_text = command;
  as_text.insert(as_text.end(), {"--dry-run"});
  const std::string degrees = std::to_string(static_cast<int>(std::lround(end)));
  const RunResult text = run_program(as_text);
  EXPECT_TRUE(contains(text.out, " " + degrees + " deg")) << text.out;
}

void expect_numbers(const Value& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    ASSERT_TRUE(object.HasMember(key)) << key;
    EXPECT_TRUE(object[key].IsNumber()) << key;
  }
}

// CLI.md's example, key by key ("bound" comes later).
TEST(Convert, JsonHasTheContractsKeysAndTypes) {
  const TemporaryFolder folder;
  const std::string output = folder / "out.yaml";
  const RunResult run =
      run_program({"convert", kDs, "--to", "orbslam3", "--model", "eucm", "--max-angle", "95", "-o", output, "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "") << "one document on stdout, nothing else";
  const Json json = json_of(run);
  for (const char* key : {"fca_io", "input", "from", "to"}) EXPECT_TRUE(json[key].IsString()) << key;
  EXPECT_STREQ(json["from"].GetString(), "kalibr");
  EXPECT_STREQ(json["to"].GetString(), "orbslam3");
  EXPECT_EQ(json["exit_code"].GetInt(), 0);
  ASSERT_EQ(json["outputs"].Size(), 1U);
  EXPECT_EQ(std::string(json["outputs"][0]["path"].GetString()), output);
  EXPECT_TRUE(fs::exists(output));
  EXPECT_STREQ(json["outputs"][0]["cameras"][0].GetString(), "cam0");
  ASSERT_EQ(json["cameras"].Size(), 2U);
  for (const Value& camera : json["cameras"].GetArray()) {
    for (const char* key : {"name", "from_model", "to_model"}) EXPECT_TRUE(camera[key].IsString()) << key;
    EXPECT_TRUE(camera["exact"].IsBool());
    expect_numbers(camera["parameters"], {"fx", "fy", "cx", "cy", "alpha", "beta"});
    EXPECT_TRUE(camera["at_bound"].IsArray());
    const Value& field_of_view = camera["domain"];
    expect_numbers(field_of_view,
                   {"max_angle_deg", "scored_to_deg", "scored_share", "outside_lens_share", "unrepresentable_share"});
    EXPECT_TRUE(field_of_view["why"].IsString());
    EXPECT_NEAR(field_of_view["scored_share"].GetDouble() + field_of_view["outside_lens_share"].GetDouble() +
                    field_of_view["unrepresentable_share"].GetDouble(),
                1.0, 1e-9);
    const Value& error = camera["error_px"];
    expect_numbers(error, {"rms", "mean", "p50", "p95", "p99", "max"});
    ASSERT_EQ(error["max_at"].Size(), 2U);
    EXPECT_LE(error["mean"].GetDouble(), error["rms"].GetDouble());
    EXPECT_LE(error["p50"].GetDouble(), error["p95"].GetDouble());
    EXPECT_LE(error["p95"].GetDouble(), error["p99"].GetDouble());
    EXPECT_LE(error["p99"].GetDouble(), error["max"].GetDouble());
    EXPECT_LE(error["rms"].GetDouble(), error["max"].GetDouble());
    double share = 0.0;
    double square_sum = 0.0;
    double last = 0.0;
    for (const Value& band : camera["bands"].GetArray()) {
      expect_numbers(band, {"from_deg", "to_deg", "share", "rms_px", "max_px"});
      EXPECT_EQ(band["from_deg"].GetDouble(), last);
      last = band["to_deg"].GetDouble();
      share += band["share"].GetDouble();
      square_sum += band["share"].GetDouble() * std::pow(band["rms_px"].GetDouble(), 2);
      EXPECT_LE(band["max_px"].GetDouble(), error["max"].GetDouble() * (1.0 + 1e-9));
    }
    EXPECT_NEAR(share, field_of_view["scored_share"].GetDouble(), 1e-9) << "the bands are the scored part";
    EXPECT_NEAR(std::sqrt(square_sum / share), error["rms"].GetDouble(), 1e-9 + 1e-6 * error["rms"].GetDouble());
    expect_numbers(camera["fit"], {"samples", "iterations", "time_us"});
  }
  for (const Value& proof : json["proof"].GetArray()) {
    EXPECT_TRUE(proof["program"].IsString());
    EXPECT_TRUE(proof["loads"].IsBool());
    EXPECT_TRUE(proof["max_diff_px"].IsNumber());
    EXPECT_TRUE(proof["warnings"].IsArray());
  }
  EXPECT_GE(json["proof"].Size(), 1U);
  EXPECT_TRUE(json["losses"].IsArray());
  EXPECT_TRUE(json["diagnostics"].IsArray());
}

// CLI.md: {"key": "Camera.fps", "value": 20, "look_at_it": true} - a number is a number.
TEST(Convert, JsonDefaultsHaveTheTypeOfTheirValue) {
  const Json json = json_of(run_program({"convert", kTumvi, "--to", "orbslam3", "--json"}));
  bool seen = false;
  for (const Value& value : json["defaults"].GetArray()) {
    EXPECT_TRUE(value["key"].IsString());
    EXPECT_TRUE(value["look_at_it"].IsBool());
    if (std::string(value["key"].GetString()) != "Camera.fps") continue;
    seen = true;
    EXPECT_TRUE(value["look_at_it"].GetBool());
    EXPECT_TRUE(value["value"].IsNumber());
    if (value["value"].IsNumber()) {
      EXPECT_EQ(value["value"].GetDouble(), 20.0);
    }
  }
  EXPECT_TRUE(seen);
}

TEST(Convert, JsonWithoutAnOutputHoldsTheFile) {
  const RunResult run = run_program({"convert", kTumvi, "--to", "orbslam3", "--json"});
  EXPECT_EQ(run.err, "");
  const Json json = json_of(run);
  ASSERT_EQ(json["outputs"].Size(), 1U);
  EXPECT_EQ(std::string(json["outputs"][0]["text"].GetString()), run_program({"convert", kTumvi, "--to", "orbslam3"}).out);
}

TEST(Convert, JsonOfFailuresSaysSo) {
  const TemporaryFolder folder;
  const RunResult evaluated = run_program({"convert", kTumvi, "--with", kImu, "--to", "kalibr", "--strict", "--json"});
  EXPECT_EQ(evaluated.code, 1);
  const Json strict = json_of(evaluated);
  EXPECT_EQ(strict["exit_code"].GetInt(), 1);
  EXPECT_EQ(strict["outputs"].Size(), 0U);
  EXPECT_EQ(strict["refused_outputs"].Size(), 1U);
  const RunResult missing = run_program({"convert", folder / "missing.yaml", "--to", "orbslam3", "--json"});
  EXPECT_EQ(missing.code, 4);
  EXPECT_EQ(json_of(missing)["exit_code"].GetInt(), 4);
  const RunResult bad = run_program({"convert", folder.write("bad.yaml", "a: 1\n"), "--to", "orbslam3", "--json"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_STREQ(json_of(bad)["diagnostics"][0]["code"].GetString(), "unknown-format");
  const RunResult two = run_program({"convert", kTumvi, kDs, "--to", "orbslam3", "--json"});
  EXPECT_EQ(two.code, 0);
  EXPECT_EQ(json_of(two)["conversions"].Size(), 2U);
}

// The limit of mei is a file that the programs understand.
TEST(Convert, MeiOfAParabolaMirrorIsProven) {
  const TemporaryFolder folder;
  const std::string input = folder.write("mirror.yaml",
                                         "cam0:\n  camera_model: eucm\n  intrinsics: [1.0, 1.0, 460.9, 459.6, 365.8, 248.9]\n"
                                         "  distortion_model: none\n  distortion_coeffs: []\n  resolution: [752, 480]\n");
  for (const char* format : {"kalibr", "opencv"}) {
    const RunResult run = run_program({"convert", input, "--to", format, "--model", "mei", "--max-error", "1e-5"});
    EXPECT_EQ(run.code, 0) << run.err;
  }
}

TEST(Convert, MaxErrorLimitsTheLargestErrorOfTheReport) {
  const Json json = json_of(run_program({"convert", kDs, "--to", "orbslam3", "--sensor", "mono", "--json"}));
  double worst = 0.0;
  for (const Value& camera : json["cameras"].GetArray()) worst = std::max(worst, camera["error_px"]["max"].GetDouble());
  ASSERT_GT(worst, 0.0);
  const RunResult above =
      run_program({"convert", kDs, "--to", "orbslam3", "--sensor", "mono", "--max-error", std::to_string(worst * 1.01)});
  EXPECT_EQ(above.code, 0) << above.err;
  const RunResult below =
      run_program({"convert", kDs, "--to", "orbslam3", "--sensor", "mono", "--max-error", std::to_string(worst * 0.99)});
  EXPECT_EQ(below.code, 1) << below.err;
  EXPECT_EQ(below.out, "");
}

// A pixel that is not there is off by more than any limit.
TEST(Convert, MaxErrorWantsEveryPixelOfTheLens) {
  const std::vector<std::string> command = {"convert", kTumvi,   "--camera", "0",           "--to", "opencv",
                                            "--model", "radtan", "--json",   "--max-error", "1000"};
  const auto with_angle = [&command](const char* angle_deg) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"--max-angle", angle_deg});
    return run_program(words);
  };
  const Json whole = json_of(run_program(command));
  EXPECT_EQ(whole["exit_code"].GetInt(), 1);
  EXPECT_EQ(whole["outputs"].Size(), 0U);
  EXPECT_TRUE(
      std::ranges::any_of(whole["diagnostics"].GetArray(), [](const Value& each) { return each["code"] == "error-limit"; }));
  EXPECT_EQ(with_angle("97.5").code, 1);
  EXPECT_EQ(with_angle("60").code, 0);
}

// However little of the lens a fit gave up; and what is the same camera is within any limit.
TEST(Convert, MaxErrorKnowsNoSmallPartAndNoRounding) {
  const TemporaryFolder folder;
  const std::string wide = folder.write("wide.yaml", kWide);
  const RunResult ds = run_program({"convert", wide, "--to", "kalibr", "--model", "ds", "--max-error", "1000", "--json"});
  const Json json = json_of(ds);
  const Value& field_of_view = json["cameras"][0]["domain"];
  ASSERT_GT(field_of_view["unrepresentable_share"].GetDouble(), 0.0) << "another lens is wanted";
  EXPECT_LT(field_of_view["unrepresentable_share"].GetDouble(), 1e-3) << "another lens is wanted";
  EXPECT_EQ(ds.code, 1) << ds.err;
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "kalibr", "--max-error", "0"}).code, 0);
}

// The lens ends beyond the angle that was given, besides what a coarse look at the image sees.
TEST(Convert, TheFieldOfViewEndsForTheReasonGiven) {
  const TemporaryFolder folder;
  const std::string wide = folder.write("wide.yaml", kWide);
  for (const char* angle : {"100", "105"}) {
    const Json json =
        json_of(run_program({"convert", wide, "--to", "kalibr", "--model", "kb4", "--max-angle", angle, "--json"}));
    EXPECT_EQ(json["cameras"][0]["domain"]["why"].GetString(), text::text_of({Code::kFieldOfViewGiven}, cli::with_options))
        << angle;
  }
}

/// What the diagnostic of a model that cannot reach advises: its clause on the models that the program reads.
Message advice_in(const ConvertResult& result) {
  for (const Diagnostic& entry : result.diagnostics.entries()) {
    if (id_of(entry) == "target-cannot-reach" && entry.remedy.code == Code::kBetterModelsExist)
      return clauses(entry.remedy, 0).at(0);
  }
  return {};
}

/// The models of that clause, each with what is said of it.
std::map<std::string, Message> models_in(const Message& advice) {
  std::map<std::string, Message> models;
  for (const Message& model : clauses(advice, 1)) models[argument<std::string>(model, 0)] = model;
  return models;
}

// What the advice says of a model is what a conversion to it reports.
TEST(Convert, TheAdviceForALensOutOfReachNamesWhatTheProgramReads) {
  Files files;
  const auto converted = [&files](const char* to, const char* model) {
    ConvertRequest request = request_for(kTumvi, to, model);
    request.inputs.cameras = {{CameraChoice{"cam0"}}};
    request.inputs.max_angle_rad = 97.5 / 180.0 * std::numbers::pi;
    return convert(request, files);
  };
  const Message advice = advice_in(converted("opencv", "radtan"));
  ASSERT_EQ(advice.code, Code::kBetterModels);
  std::map<std::string, Message> models = models_in(advice);
  EXPECT_EQ(models["kb4"].code, Code::kModelExact);
  for (const auto& [model, code] : {std::pair{"mei", Code::kModelRms}, {"rational", Code::kModelRmsUpTo}}) {
    ASSERT_EQ(models[model].code, code) << model;
    const double rms = converted("opencv", model).cameras.at(0).report->statistics.error.rms;
    EXPECT_NEAR(argument<double>(models[model], 1), rms, 0.01 * rms) << model;
  }
  // ORB-SLAM3 reads neither.
  const Message narrower = advice_in(converted("orbslam3", "pinhole"));
  ASSERT_EQ(narrower.code, Code::kBetterModels);
  std::map<std::string, Message> fewer = models_in(narrower);
  EXPECT_EQ(fewer["kb4"].code, Code::kModelExact);
  EXPECT_TRUE(fewer.contains("radtan"));
  EXPECT_FALSE(fewer.contains("mei"));
  EXPECT_TRUE(clauses(narrower, 2).empty()) << "kb4 is exact: none is better still";
  // The command says so.
  const Told run({"convert", kTumvi, "--camera", "0", "--to", "opencv", "--model", "radtan", "--max-angle", "97.5"});
  for (const char* model : {"kb4", "mei", "rational"}) EXPECT_TRUE(run.says("target-cannot-reach", model)) << run.text();
}

TEST(Convert, StrictPassesWhereNothingIsLost) {
  const RunResult run = run_program({"convert", kTumvi, "--to", "kalibr", "--model", "kb4", "--strict"});
  EXPECT_EQ(run.code, 0) << run.err;
}

// ORB-SLAM2's monocular examples state no image size. Nothing can be compared then, which is no disagreement.
TEST(Convert, ASettingsFileWithoutASizeIsNotCalledWrong) {
  const TemporaryFolder folder;
  std::string bytes = read_file(testdata("formats/orbslam3/good/orbslam2-tight.yaml"));
  bytes = with_replaced(with_replaced(bytes, "Camera.width: 640\n", ""), "Camera.height:480\n", "");
  bytes = with_replaced(bytes, "ORBextractor.nFeatures: 1000\n",
                        "ORBextractor.nFeatures: 1000\nORBextractor.nLevels: 8\nORBextractor.scaleFactor: 1.2\n");
  const RunResult run = run_program({"convert", folder.write("orbslam2.yaml", bytes), "--to", "orbslam2"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, bytes);
}

// No motion mirrors: what such a pose means nobody knows, and no program is given its inverse.
TEST(Convert, AMirroredPoseIsRefused) {
  const RunResult run = run_program({"convert", testdata("checks/left-handed.yaml"), "--to", "orbslam3"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(contains(run.err, "[left-handed]")) << run.err;
  // Within its format it stays as it is, if the owner says so.
  const std::vector<std::string> within = {"convert", testdata("checks/left-handed.yaml"), "--to", "kalibr"};
  EXPECT_EQ(run_program(within).code, 1);
  std::vector<std::string> accepted = within;
  accepted.insert(accepted.end(), {"--accept", "left-handed", "--accept", "poses-contradict"});
  EXPECT_EQ(run_program(accepted).code, 0);
}

// Exactness through any language: the numbers do not depend on the locale's decimal sign.
TEST(Convert, LocalesDoNotMatter) {
  ::setenv("LC_ALL", "de_DE.UTF-8", 1);
  const RunResult german = spawn_program({"convert", kTumvi, "--to", "orbslam3"});
  ::unsetenv("LC_ALL");
  EXPECT_EQ(german.out, spawn_program({"convert", kTumvi, "--to", "orbslam3"}).out);
}

// VINS-Fusion's four are one sample's noise, whether or not the user says so; the rate makes densities of them, once.
TEST(Convert, TheRateOfAnImuMakesDensities) {
  const TemporaryFolder folder;
  const std::string config = folder.write("config.yaml", read_file(testdata("formats/vins/good/config.yaml")));
  for (const char* name : {"cam0.yaml", "cam1.yaml"})
    static_cast<void>(folder.write(name, read_file(testdata("formats/vins/good/kannala-brandt.yaml"))));
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--imu-noise", "discrete"}}) {
    std::vector<std::string> words = {"convert", config, "--imu-rate",    "200",    "--to",
                                      "kalibr",  "-o",   folder / "out/", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult run = run_program(words);
    ASSERT_EQ(run.code, 0) << run.err;
    const Rig rig = rig_in(read_file(folder / "out/imu.yaml"));
    ASSERT_EQ(rig.imus.size(), 1U);
    EXPECT_NEAR(rig.imus[0].accelerometer_noise_density.value(), 0.1 / std::sqrt(200.0), 1e-12);
    EXPECT_EQ(rig.imus[0].rate_hz, 200.0);
  }
  EXPECT_EQ(run_program({"convert", kTumvi, "--imu-rate", "200", "--to", "opencv"}).code, 2) << "it has no IMU";
  EXPECT_EQ(run_program({"convert", kTumvi, "--imu-rate", "0", "--to", "opencv"}).code, 3);
}

// What feature_extractor takes in place of a file: the numbers of the line that cameras.txt has.
TEST(Convert, PrintsWhatColmapTakesOnItsCommandLine) {
  const RunResult one = run_program({"convert", kTumvi, "--to", "colmap", "--camera", "cam0", "--print"});
  EXPECT_EQ(one.code, 0) << one.err;
  const RunResult file = run_program({"convert", kTumvi, "--to", "colmap", "--camera", "cam0"});
  const std::string model = "OPENCV_FISHEYE 512 512 ";
  std::string numbers = file.out.substr(file.out.find(model) + model.size());
  numbers.pop_back();
  std::ranges::replace(numbers, ' ', ',');
  EXPECT_EQ(one.out, "--ImageReader.camera_model OPENCV_FISHEYE --ImageReader.camera_params " + numbers + "\n");
  const RunResult both = run_program({"convert", kTumvi, "--to", "colmap", "--print"});
  EXPECT_TRUE(both.out.starts_with("# cam0\n" + one.out + "# cam1\n")) << both.out;
  EXPECT_EQ(run_program({"convert", kTumvi, "--print", "--to", "kalibr"}).code, 3);
  EXPECT_EQ(run_program({"convert", kTumvi, "--print", "--to", "colmap", "-o", "out/"}).code, 3);
  EXPECT_EQ(run_program({"convert", kDs, "--to", "colmap", "--model", "ds", "--print"}).out, "");
}

/// The factory calibration of an OAK-D-Pro's left camera: 14 coefficients, a tilt of 0.2 degrees.
const std::string kOak =
    "%YAML:1.0\nimage_width: 1280\nimage_height: 800\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
    "   data: [ 799.3952026367188, 0., 642.171875, 0., 799.3013916015625, 384.5967102050781, 0., 0., 1. ]\n"
    "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 14\n   dt: d\n"
    "   data: [ 27.344240188598633, -47.42519760131836, 0.000490090693347156, 0.00024394151114393026, 24.723031997680664,\n"
    "       26.633960723876953, -45.357730865478516, 23.19692611694336, 0., 0., 0., 0., -0.0032038954086601734,\n"
    "       0.0018769855378195643 ]\n";

// Factory calibrations have a tilted sensor: it is fitted away at a proven price, and stays where the format has it.
TEST(Convert, FourteenCoefficientsAreACamera) {
  const TemporaryFolder folder;
  const std::string oak = folder.write("oak.yml", kOak);
  const Told kalibr({"convert", oak, "--to", "kalibr"});
  ASSERT_EQ(kalibr.code(), 0) << kalibr.text();
  const auto& camera = kalibr.json()["cameras"][0];
  EXPECT_STREQ(camera["from_model"].GetString(), "opencv14");
  EXPECT_LT(camera["error_px"]["rms"].GetDouble(), 1.0);
  ASSERT_TRUE(camera["error_px"]["bound"].IsNumber()) << kalibr.text();
  EXPECT_LT(camera["error_px"]["bound"].GetDouble(), 1.1 * camera["error_px"]["max"].GetDouble());
  const Told ros({"convert", oak, "--to", "ros", "-o", folder / "ros.yaml"});
  EXPECT_TRUE(ros.json()["cameras"][0]["exact"].GetBool()) << ros.text();
  EXPECT_STREQ(ros.json()["verdict"]["word"].GetString(), "ready") << ros.text();
  const Told back({"convert", folder / "ros.yaml", "--to", "opencv"});
  EXPECT_TRUE(back.json()["cameras"][0]["exact"].GetBool()) << back.text();
  EXPECT_STREQ(back.json()["cameras"][0]["to_model"].GetString(), "opencv14");
}

// What cv::omnidir calibrates by default.
TEST(Convert, SkewIsKeptWhereTheFormatHasIt) {
  const TemporaryFolder folder;
  const std::string omnidir = testdata("formats/opencv/good/skew-omnidir.yaml");
  const std::string half = folder / "half.yml";
  const Told opencv({"convert", omnidir, "--to", "opencv", "--resize", "320x240", "-o", half});
  EXPECT_TRUE(opencv.json()["cameras"][0]["exact"].GetBool()) << opencv.text();
  EXPECT_STREQ(opencv.json()["verdict"]["word"].GetString(), "ready") << opencv.text();
  const Told smaller({"show", half});
  EXPECT_EQ(smaller.json()["files"][0]["cameras"][0]["parameters"]["skew"].GetDouble(), 0.375) << smaller.text();
  // Kalibr has no place for it: what leaving it out costs is a distance in pixels.
  const Told kalibr({"convert", omnidir, "--to", "kalibr", "--model", "mei"});
  ASSERT_EQ(kalibr.code(), 0) << kalibr.text();
  const auto& camera = kalibr.json()["cameras"][0];
  EXPECT_STREQ(camera["from_model"].GetString(), "mei-skew");
  EXPECT_STREQ(camera["to_model"].GetString(), "mei");
  EXPECT_GT(camera["error_px"]["max"].GetDouble(), 0.05);
  EXPECT_LT(camera["error_px"]["bound"].GetDouble(), 1.0);
}

// cv::projectPoints does not read it: a file that keeps it is misread by that much.
TEST(Convert, SkewThatTheProgramIgnoresIsFittedAway) {
  const std::string pinhole = testdata("formats/opencv/bad/skew-kept.yaml");
  const Told ros({"convert", pinhole, "--to", "ros"});
  EXPECT_STREQ(ros.json()["cameras"][0]["to_model"].GetString(), "radtan") << ros.text();
  const Told check({"check", pinhole});
  EXPECT_EQ(check.code(), 0) << check.text();
  EXPECT_TRUE(contains(check.text(), "skew"));
}

// Nobody looks for the best model among those that only keep a camera.
TEST(Convert, NothingIsFittedToFourteenCoefficients) {
  const Told run({"convert", kTumvi, "--camera", "cam0", "--to", "opencv"});
  EXPECT_STREQ(run.json()["cameras"][0]["to_model"].GetString(), "kb4");
  const Told models({"models", kTumvi, "--camera", "0"});
  for (const auto& target : models.json()["cameras"][0]["targets"].GetArray())
    EXPECT_STRNE(target["model"].GetString(), "opencv14");
}

}  // namespace
}  // namespace fca::test
