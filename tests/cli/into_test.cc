// SPDX-License-Identifier: BSD-3-Clause
// --into, --in-place and --join: several files and one rig.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"
#include "transforms.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fca::test {
namespace {

const std::string kSettings = testdata("formats/orbslam3/good/v1-stereo-inertial.yaml");
const std::string kOpenVins = testdata("formats/openvins/good/mono.yaml");
const std::string kFork = testdata("formats/orbslam3/good/slam-no-opt-eucm.yaml");

/// The lines of `after` that differ from the same line of `before`, each after the last key before it.
std::vector<std::string> lines_that_differ(const std::string& before, const std::string& after) {
  const std::vector<std::string> was = lines_of(before);
  const std::vector<std::string> is = lines_of(after);
  EXPECT_EQ(was.size(), is.size()) << after;
  std::vector<std::string> different;
  std::string key;
  for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) {
    if (is[i].find(':') != std::string::npos) key = is[i].substr(0, is[i].find(':'));
    if (was[i] != is[i]) different.push_back(key + " | " + is[i]);
  }
  return different;
}

/// The text of a camera of a chain.
std::string block_of(const std::string& chain, const std::string& camera) {
  const std::size_t begin = chain.find(camera + ":");
  EXPECT_NE(begin, std::string::npos);
  return chain.substr(begin, chain.find("\ncam", begin) - begin);
}

/// tumvi.yaml's first camera as a Double Sphere, without a pose.
const std::string kBareDs =
    "cam0:\n"
    "  camera_model: ds\n"
    "  distortion_coeffs: []\n"
    "  distortion_model: none\n"
    "  intrinsics: [-0.17213086034353243, 0.5931177593944744, 158.28600034966977, 158.2743455478755, 254.9611657819, 256.88]\n"
    "  resolution: [512, 512]\n";

// Thresholds are tuned for images of one size.
TEST(Into, ABaseForOtherImagesIsRefused) {
  const TemporaryFolder folder;
  const std::string base = testdata("formats/orbslam3/good/v1-pinhole.yaml");
  const ImageSize size = rig_in(read_file(base)).cameras.at(0).image_size.value();
  const std::string resize = std::to_string(size.width) + "x" + std::to_string(size.height);
  const std::vector<std::string> words = {"convert", folder.write("ds.yaml", kBareDs), "--into", base, "--max-angle", "60"};
  const RunResult other = run_program(words);
  EXPECT_EQ(other.code, 2) << other.err;
  EXPECT_EQ(other.out, "");
  EXPECT_TRUE(says(other.err, "size-contradicts", "--resize " + resize)) << other.err;
  std::vector<std::string> proposed = words;
  proposed.insert(proposed.end(), {"--resize", resize});
  const RunResult resized = run_program(proposed);
  EXPECT_EQ(resized.code, 0) << resized.err;
  EXPECT_FALSE(says(resized.err, "size-contradicts")) << resized.err;
  EXPECT_EQ(rig_in(resized.out).cameras.at(0).image_size, size);
}

// A rig's poses are of several cameras in a frame, and of none of the input's.
TEST(Into, ARigOfPosesNamesAllOfItsFrames) {
  const TemporaryFolder folder;
  const std::string pairs = testdata("formats/euroc/cuvslam-rig/pairs.yaml");
  const RunResult into = run_program({"convert", folder.write("ds.yaml", kBareDs), "--into", pairs});
  EXPECT_EQ(into.code, 2) << into.err;
  for (const char* frame : {"cam0", "cam3", "rig"}) EXPECT_TRUE(says(into.err, "pose-missing", frame)) << into.err;
  const RunResult alone = run_program({"convert", pairs, "--to", "kalibr"});
  EXPECT_TRUE(says(alone.err, "no-camera", "4")) << alone.err;
}

// Who names the input's own size wants the base to be for that; who changes the images of a file changes its size.
TEST(Into, ABaseTakesAnotherSizeWhenToldTo) {
  const TemporaryFolder folder;
  const std::string base = testdata("formats/orbslam3/good/v1-pinhole.yaml");
  const std::string ds = folder.write("ds.yaml", kBareDs);
  const ImageSize size = rig_in(kBareDs).cameras.at(0).image_size.value();
  const std::string own = std::to_string(size.width) + "x" + std::to_string(size.height);
  const RunResult told = run_program({"convert", ds, "--into", base, "--max-angle", "60", "--resize", own});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(rig_in(told.out).cameras.at(0).image_size, size);
  const RunResult itself = run_program({"convert", base, "--into", base, "--binning", "2"});
  EXPECT_EQ(itself.code, 0) << itself.err;
  const ImageSize before = rig_in(read_file(base)).cameras.at(0).image_size.value();
  EXPECT_EQ(rig_in(itself.out).cameras.at(0).image_size, (ImageSize{before.width / 2, before.height / 2}));
}

// A pose of the base is one of its own camera: next to another camera it is said, where it stays.
TEST(Into, PosesThatStayAreSaid) {
  const TemporaryFolder folder;
  const std::string ds = folder.write("ds.yaml", kBareDs);
  const RunResult run = run_program({"convert", ds, "--into", kSettings, "--max-angle", "97.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "pose-kept")) << run.err;
  EXPECT_TRUE(says(run.err, "camera-kept", "cam1")) << run.err;
  // The same camera, and a base without poses.
  EXPECT_FALSE(says(run_program({"convert", kTumvi, "--into", kTumvi}).err, "pose-kept"));
  EXPECT_FALSE(says(run_program({"convert", ds, "--into", folder.write("other.yaml", kBareDs)}).err, "pose-kept"));
  // What a mode leaves out does not stay.
  const RunResult mono = run_program({"convert", ds, "--into", kSettings, "--max-angle", "97.5", "--sensor", "mono"});
  EXPECT_EQ(mono.code, 0) << mono.err;
  EXPECT_FALSE(contains(mono.out, "Camera2")) << mono.out;
  EXPECT_FALSE(says(mono.err, "camera-kept")) << mono.err;
  EXPECT_FALSE(says(mono.err, "pose-kept")) << mono.err;
}

TEST(Into, OnlyTheCamerasNumbersChange) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", folder.write("ds.yaml", kBareDs), "--into", kSettings, "--max-angle", "97.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::vector<std::string> changed = lines_that_differ(read_file(kSettings), run.out);
  EXPECT_FALSE(changed.empty());
  for (const std::string& line : changed) EXPECT_TRUE(line.starts_with("Camera1.")) << line;
}

// Neither derived again nor made to agree: what the input does not state is the base's.
TEST(Into, PosesThatTheInputDoesNotStateKeepTheirBytes) {
  const TemporaryFolder folder;
  const std::string input = folder.write("ds.yaml", kBareDs);
  const std::string tumvi = read_file(kTumvi);
  const std::size_t chain = tumvi.find("-0.10106110275180535");
  ASSERT_NE(chain, std::string::npos);
  const std::string contradicting = std::string(tumvi).replace(chain, std::string("-0.10106110275180535").size(), "-0.2");
  for (const std::string& base : {tumvi, contradicting}) {
    const RunResult run =
        run_program({"convert", input, "--into", folder.write("base.yaml", base), "--model", "ds", "--no-verify"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(block_of(run.out, "cam1"), block_of(base, "cam1"));
    const std::string rows = base.substr(0, base.find("  cam_overlaps"));
    EXPECT_EQ(run.out.substr(0, rows.size()), rows);
    EXPECT_FALSE(says(run.err, "pose-follows")) << run.err;
  }
}

// The base says the second camera's pose twice. One that contradicts what the input says follows from it, and that is reported.
TEST(Into, ARedundantPoseFollowsTheOneThatMoved) {
  const TemporaryFolder folder;
  const std::string tumvi = read_file(kTumvi);
  std::string moved = tumvi.substr(0, tumvi.find("cam1:"));
  const std::string number = "0.04727988224914392";
  moved.replace(moved.find(number), number.size(), "0.5");
  const RunResult run = run_program({"convert", folder.write("moved.yaml", moved), "--into", kTumvi});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "pose-follows")) << run.err;
  const Rig before = rig_in(tumvi);
  const Rig after = rig_in(run.out);
  EXPECT_EQ(after.stated("cam0", "imu0")->operator()(0, 3), 0.5);
  EXPECT_EQ(*after.stated("cam1", "cam0"), *before.stated("cam1", "cam0"));
  EXPECT_LE(element_difference(*after.stated("cam1", "imu0"), *before.stated("cam1", "cam0") * *after.stated("cam0", "imu0")),
            1e-12);
  for (const std::string& line : lines_that_differ(tumvi, run.out)) EXPECT_TRUE(line.starts_with("  T_cam_imu |")) << line;
}

// A camera that was not chosen does not come by its poses.
TEST(Into, ACameraLeftOutOfTheInputLeavesTheBasesAlone) {
  const TemporaryFolder folder;
  const std::string tumvi = read_file(kTumvi);
  const std::string number = "-0.10106110275180535";
  const std::string base = std::string(tumvi).replace(tumvi.find(number), number.size(), "-0.2");
  const RunResult run =
      run_program({"convert", kTumvi, "--camera", "cam0", "--into", folder.write("b.yaml", base), "--no-verify"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, base);
}

// Of the base's cameras it is the second: its verdict is no distance to the first.
TEST(Into, TheVerdictIsOfTheCameraThatWasPutIn) {
  const TemporaryFolder folder;
  const std::string base = folder.write("base.yaml", read_file(kTumvi));
  const Told told({"convert", kTumvi, "--camera", "cam1", "--into", base});
  EXPECT_EQ(told.code(), 0) << told.text();
  ASSERT_EQ(told.json()["cameras"].Size(), 1U) << told.text();
  EXPECT_STREQ(told.json()["cameras"][0]["name"].GetString(), "cam1") << told.text();
}

// OpenVINS' header, comments and direction of the pose are its owner's.
TEST(Into, AFileOfAnotherProgramKeepsItsLayout) {
  const TemporaryFolder folder;
  const std::string bytes = read_file(kOpenVins);
  const std::string base = folder.write("base.yaml", bytes);
  const RunResult run =
      run_program({"convert", kTumvi, "--camera", "cam0", "--into", base, "--model", "kb4", "--resize", "512x512"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(says(run.err, "layout-not-kept")) << run.err;
  EXPECT_FALSE(says(run.err, "program-refuses")) << run.err;
  EXPECT_TRUE(run.out.starts_with(bytes.substr(0, bytes.find("cam0:")))) << run.out;
  EXPECT_FALSE(contains(run.out, "T_cam_imu")) << run.out;
  const Rig input = rig_in(read_file(kTumvi));
  const Rig after = rig_in(run.out);
  EXPECT_EQ(after.cameras.at(0).model, input.cameras.at(0).model);
  EXPECT_LE(element_difference(after.resolve("cam0", "imu0").value(), input.resolve("cam0", "imu0").value()), 1e-12);
}

TEST(Into, WhatIsRewrittenListsWhatGoes) {
  const TemporaryFolder folder;
  const std::string base = folder.write("base.yaml", read_file(testdata("formats/kalibr/good/opencv-header.yaml")) +
                                                         "\n  cam_overlaps: []\n  line_delay: 0.001\n");
  const std::vector<std::string> words = {"convert", kTumvi,      "--camera", "cam0",   "--into",
                                          base,      "--rewrite", "--resize", "512x512"};
  const Told run(words);
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.lost("comments-dropped", base)) << run.text();
  EXPECT_TRUE(run.lost("header-dropped", "%YAML:1.0")) << run.text();
  EXPECT_TRUE(run.lost("not-carried", "line_delay")) << run.text();
}

// Into a fork's file goes the fork's model.
// An IMU's file is not turned into a camchain.
TEST(Into, AFileWithoutCamerasIsRefused) {
  const TemporaryFolder folder;
  const std::string imu = read_file(testdata("formats/kalibr/good/imu.yaml"));
  const std::string path = folder.write("imu.yaml", imu);
  const RunResult run = run_program({"convert", kTumvi, "--into", path, "--in-place"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_TRUE(says(run.err, "into-without-camera")) << run.err;
  EXPECT_EQ(read_file(path), imu);
}

// What stands next to the cameras is the base's; where the input says otherwise, that is a loss.
TEST(Into, OtherValuesOfTheInputAreSaidWhereTheBaseKeepsItsOwn) {
  const TemporaryFolder folder;
  const std::string results = testdata("formats/ocamcalib/good/toolbox.txt");
  const std::string overlap = testdata("formats/kalibr/good/tumvi.yaml");
  struct Case {
    std::string base, from, to, lost;
  };
  for (const Case& c : {Case{results, "76.44743355669645", "76.5", "inverse polynomial"},
                        Case{overlap, "cam_overlaps: [1]", "cam_overlaps: [1, 2]", "cam0 cam_overlaps [1, 2]"}}) {
    const std::string bytes = read_file(c.base);
    if (!contains(bytes, c.from)) {
      ADD_FAILURE() << c.base << " has no " << c.from;
      continue;
    }
    const std::string extension = c.base.substr(c.base.rfind('.'));
    const std::string input = folder.write("input" + extension, with_replaced(bytes, c.from, c.to));
    const Told run({"convert", input, "--into", c.base});
    EXPECT_EQ(run.code(), 0) << run.text();
    EXPECT_EQ(run.bytes(), bytes);
    EXPECT_TRUE(run.lost("not-carried", c.lost)) << run.text();
  }
}

// A baseline is as true next to a lens with distortion as it was without; before V1.0 it is stored times the focal length.
TEST(Into, TheBasesBaselineStays) {
  const TemporaryFolder folder;
  const std::string rectified = read_file(testdata("formats/orbslam3/good/v1-rectified.yaml"));
  const std::string old_style =
      "%YAML:1.0\nCamera.type: \"PinHole\"\nCamera.fx: 700.0\nCamera.fy: 700.0\nCamera.cx: 600.0\nCamera.cy: 180.0\n"
      "Camera.k1: 0.0\nCamera.k2: 0.0\nCamera.p1: 0.0\nCamera.p2: 0.0\nCamera.width: 1241\nCamera.height: 376\n"
      "Camera.fps: 10.0\nCamera.bf: 350.0\nCamera.RGB: 1\nThDepth: 40\n";
  const std::string input = folder.write("lens.yaml",
                                         "cam0:\n  camera_model: pinhole\n  intrinsics: [800.0, 800.0, 600.0, 180.0]\n"
                                         "  distortion_model: radtan\n  distortion_coeffs: [-0.1, 0.01, 0.0, 0.0]\n"
                                         "  resolution: [1241, 376]\n  rostopic: /cam0\n");
  const RunResult old_run = run_program({"convert", input, "--into", folder.write("old.yaml", old_style), "--no-verify"});
  EXPECT_EQ(old_run.code, 0) << old_run.err;
  EXPECT_TRUE(contains(old_run.out, "Camera.bf: 400.0")) << old_run.out;
  EXPECT_TRUE(contains(old_run.out, "ThDepth: 40\n")) << old_run.out;
  EXPECT_TRUE(says(old_run.err, "baseline-kept", "50.00 cm")) << old_run.err;
  EXPECT_TRUE(says(old_run.err, "not-rectified")) << old_run.err;
  const RunResult run =
      run_program({"convert", input, "--into", folder.write("v1.yaml", rectified), "--no-verify", "--resize", "1241x376"});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const std::string kept : {"Stereo.b: 0.11007784219\n", "Stereo.ThDepth: 40.0\n"}) {
    EXPECT_TRUE(contains(rectified, kept));
    EXPECT_TRUE(contains(run.out, kept)) << run.out;
  }
  // V1.0's Rectified has no lens: the keys stay, and the pair is none.
  EXPECT_TRUE(says(run.err, "poorer-mode", "mono")) << run.err;
  const RunResult without = run_program({"convert", kDs, "--into", kSettings, "--max-angle", "60", "--resize", "512x512"});
  EXPECT_FALSE(says(without.err, "poorer-mode")) << without.err;
  EXPECT_FALSE(says(without.err, "baseline-kept")) << without.err;
}

TEST(Into, AForksFileKeepsItsModel) {
  const RunResult run = run_program(
      {"convert", kTumvi, "--camera", "cam0", "--into", kFork, "--max-angle", "97.5", "--accept", "program-refuses"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "EUCM")) << run.out;
  EXPECT_EQ(model_info(rig_in(run.out).cameras.at(0).model).id, "eucm");
}

// stereo_calib's extrinsics.yml, with what cv::stereoRectify puts after R and T.
TEST(Into, AFileOfThePoseAloneIsEditedInPlace) {
  const TemporaryFolder folder;
  const std::string bytes = read_file(testdata("formats/opencv/good/extrinsics.yml")) +
                            "Q: !!opencv-matrix\n   rows: 1\n   cols: 1\n   dt: d\n   data: [ 1. ]\n";
  const std::string base = folder.write("extrinsics.yml", bytes);
  const Told run({"convert", kTumvi, "--into", base, "--in-place"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.lost("camera-dropped", "cam1 (kb4)")) << run.text();
  const std::string after = read_file(base);
  EXPECT_TRUE(after.ends_with(bytes.substr(bytes.find("Q:")))) << after;
  EXPECT_FALSE(contains(after, "M1")) << after;
  EXPECT_LE(element_difference(rig_in(after).resolve("cam1", "cam0").value(),
                               rig_in(read_file(kTumvi)).resolve("cam1", "cam0").value()),
            1e-12);
}

// It counts the cameras of its pair: the input's, whatever those are called.
TEST(Into, APoseAloneIsThatOfTheFirstTwoCameras) {
  const TemporaryFolder folder;
  const std::string front = read_file(testdata("formats/woodscape/good/front.json"));
  for (const char* name : {"\"MVL\"", "\"FV\""}) {
    SCOPED_TRACE(name);  // of the same name it becomes cam1
    std::string behind = front;
    behind.replace(behind.find("3.7125"), 6, "2.7125");  // m
    behind.replace(behind.rfind("\"FV\""), 4, name);
    const RunResult run = run_program({"convert", folder.write("front.json", front), folder.write("behind.json", behind),
                                       "--join", "--into", testdata("formats/opencv/good/extrinsics.yml")});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(contains(run.err, "T_cam0")) << run.err;  // no pose of the pair is lost
    const Transform T = rig_in(run.out).resolve("cam1", "cam0").value();
    EXPECT_NEAR(std::hypot(T(0, 3), T(1, 3), T(2, 3)), 1.0, 1e-3) << run.out;
    EXPECT_NEAR(T(0, 0), 1.0, 1e-3) << run.out;
  }
}

// As the first file of an input it is a part: the file that holds the cameras is the one whose keys stay.
TEST(Into, AnInputIsEditedWhereItsCamerasStand) {
  const TemporaryFolder folder;
  const std::string intrinsics = folder.write("intrinsics.yml", read_file(testdata("formats/opencv/good/stereo-14.yml")));
  const RunResult run =
      run_program({"convert", testdata("formats/opencv/good/extrinsics.yml"), "--with", intrinsics, "--to", "opencv"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, read_file(intrinsics));
}

TEST(Into, TheBaseChangesOnlyInPlace) {
  const TemporaryFolder folder;
  const std::string base = folder.write("settings.yaml", read_file(kSettings));
  EXPECT_EQ(run_program({"convert", kDs, "--into", base, "-o", folder / "other.yaml", "--max-angle", "97.5"}).code, 0);
  EXPECT_EQ(read_file(base), read_file(kSettings));
  const RunResult in_place = run_program({"convert", kDs, "--into", base, "--in-place", "--max-angle", "97.5"});
  EXPECT_EQ(in_place.code, 0) << in_place.err;
  EXPECT_EQ(read_file(base), read_file(folder / "other.yaml"));
  // A second time there is nothing to change.
  EXPECT_EQ(run_program({"convert", base, "--into", base, "--in-place"}).code, 0);
  EXPECT_EQ(read_file(base), read_file(folder / "other.yaml"));
}

TEST(Into, ContradictionsAreUsage) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--in-place", "--to", "kalibr"},
                                                {"--into", kSettings, "--in-place", "-o", "x.yaml"},
                                                {"--into", kSettings, "--to", "kalibr"},
                                                {"--into", kSettings, kDs}}) {
    std::vector<std::string> all = {"convert", kTumvi};
    all.insert(all.end(), words.begin(), words.end());
    const RunResult run = run_program(all);
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(run_program({"convert", kTumvi, "--into", "/nowhere.yaml", "--json"}).code, 4);
}

TEST(Join, TwoChainsAreOneRig) {
  const RunResult run =
      run_program({"convert", kTumvi, kDs, "--join", "--to", "kalibr", "--model", "kb4", "--max-angle", "97.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Rig joined = rig_in(run.out);
  const Rig first = rig_in(read_file(kTumvi));
  ASSERT_EQ(joined.cameras.size(), 4U);
  EXPECT_EQ(joined.cameras[0].model, first.cameras[0].model);
  // The poses of the second chain are its own cameras'.
  EXPECT_TRUE(joined.resolve("cam3", "cam2"));
  EXPECT_FALSE(joined.resolve("cam2", "cam1"));
}

// A name that says nothing of the syntax is no wish for another one.
TEST(Into, AnUnknownExtensionKeepsTheSyntax) {
  const std::string input = testdata("formats/opencv/good/calibration-old.xml");
  const TemporaryFolder folder;
  for (const char* name : {"out.calib", "out.xml.new", "out"}) {
    const RunResult run = run_program({"convert", input, "--to", "opencv", "-o", folder / name});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(read_file(folder / name), read_file(input)) << name;
  }
}

// Formats of one camera per file: every file is its own base, whatever the others are.
TEST(Join, FilesOfOneCameraComeBackByteForByte) {
  const std::pair<const char*, std::vector<const char*>> formats[] = {
      {"woodscape", {"front.json", "crlf-tabs.json", "ints-and-more.json", "one-line.json"}},
      {"ocamcalib", {"toolbox.txt", "degree-eight.txt", "free-layout.txt"}}};
  for (const auto& [format, names] : formats) {
    SCOPED_TRACE(format);
    const TemporaryFolder folder;
    std::vector<std::string> arguments = {"convert", "--join", "--to", format, "-o", folder / "{camera}", "--strict", "--json"};
    std::vector<std::string> inputs;
    for (const char* name : names) {
      inputs.push_back(read_file(testdata("formats/" + std::string(format) + "/good/" + name)));
      arguments.push_back(testdata("formats/" + std::string(format) + "/good/" + name));
    }
    const RunResult run = run_program(arguments);
    ASSERT_EQ(run.code, 0) << run.err << run.out;
    std::vector<std::string> outputs;
    for (const auto& entry : fs::directory_iterator(folder.path())) outputs.push_back(read_file(entry.path().string()));
    std::ranges::sort(inputs);
    std::ranges::sort(outputs);
    EXPECT_EQ(outputs, inputs);
  }
}

// Cameras in another order than the base's: the first takes the place of the base's only one, whose name the second had.
TEST(Into, AnAddedCameraTakesNoNameThatIsTaken) {
  const TemporaryFolder folder;
  const std::string chain = read_file(kTumvi);
  const std::string base = folder.write("one.yaml", chain.substr(0, chain.find("cam1:")));
  const Told run({"convert", kTumvi, "--camera", "1,0", "--into", base});
  EXPECT_EQ(run.code(), 0) << run.text();
  ASSERT_FALSE(run.bytes().empty()) << run.text();
  const Told written({"show", folder.write("two.yaml", run.bytes())});
  const Told input({"show", kTumvi});
  const auto model = [](const Told& shown, int camera) -> const rapidjson::Value& {
    return shown.json()["files"][0]["cameras"][camera]["parameters"];
  };
  for (const int i : {0, 1}) EXPECT_EQ(model(written, i), model(input, 1 - i)) << written.text();
}

// Where one file holds them all the first is edited; of the others only the cameras come.
TEST(Join, TheFirstFileIsEditedAndTheOthersCommentsAreListed) {
  const std::vector<std::string> command = {"convert", kTumvi, kDs, "--join", "--to", "kalibr", "--max-angle", "97.5"};
  const Told run(command);
  EXPECT_EQ(run.code(), 0) << run.text();
  const std::string first = read_file(kTumvi);
  EXPECT_TRUE(run.bytes().starts_with(first.substr(0, first.find("cam1:")))) << run.bytes();
  EXPECT_TRUE(run.lost("comments-dropped", kDs)) << run.text();
}

// Settings that nobody can compute stay the first file's.
TEST(Join, SettingsOfTheFirstFileStay) {
  const TemporaryFolder folder;
  const std::string mine =
      folder.write("mine.yaml", with_replaced(read_file(testdata("formats/orbslam3/good/v1-pinhole.yaml")),
                                              "ORBextractor.nFeatures: 1500", "ORBextractor.nFeatures: 1777  # tuned"));
  const RunResult run = run_program(
      {"convert", "--join", mine, testdata("formats/orbslam3/good/v1-pinhole.yaml"), "--camera", "0", "--to", "orbslam3"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "ORBextractor.nFeatures: 1777  # tuned")) << run.out;
}

TEST(Join, ShowNamesTheJoinedCameras) {
  const RunResult run = run_program({"show", kTumvi, kDs, "--join"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "\ncam3:")) << run.out;
}

// Settings have one Camera.type for both cameras: where one stays, the other comes as that.
TEST(Into, ACameraBesideOneThatStaysTakesItsModel) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("radtan.yaml",
                                         "cam0:\n"
                                         "  camera_model: pinhole\n"
                                         "  distortion_coeffs: [-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05]\n"
                                         "  distortion_model: radtan\n"
                                         "  intrinsics: [258.654, 257.296, 257.215, 248.375]\n"
                                         "  resolution: [512, 512]\n");
  const Rig before = rig_in(read_file(kSettings));
  const RunResult run = run_program({"convert", chain, "--into", kSettings, "--accept", "pixels-off"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Rig after = rig_in(run.out);
  ASSERT_EQ(after.cameras.size(), 2U) << run.out;
  EXPECT_EQ(model_info(after.cameras[0].model).id, model_info(before.cameras[1].model).id);
  EXPECT_NE(after.cameras[0].model, before.cameras[0].model);
  EXPECT_EQ(after.cameras[1].model, before.cameras[1].model);
  const RunResult other = run_program({"convert", chain, "--into", kSettings, "--model", "radtan"});
  EXPECT_EQ(other.code, 2) << other.out;
  EXPECT_TRUE(says(other.err, "models-differ", "--model kb4")) << other.err;
  const RunResult alone = run_program({"convert", chain, "--into", kSettings, "--model", "radtan", "--sensor", "mono"});
  EXPECT_EQ(alone.code, 0) << alone.err;
}

// A base that its own program would refuse for the spelling of a number is of no use with other cameras in it, either.
TEST(Into, WhatTheProgramRefusesOfTheKeptTextIsFixedAndReported) {
  const TemporaryFolder folder;
  std::string settings = read_file(kSettings);
  settings = with_replaced(settings, "Camera.fps: 20", "Camera.fps: 20.0");
  settings = with_replaced(settings, "IMU.Frequency: 200.0", "IMU.Frequency: 200");
  const std::string base = folder.write("mine.yaml", settings);
  const RunResult run = run_program({"convert", kTumvi, "--into", base});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* key : {"Camera.fps", "IMU.Frequency"}) EXPECT_TRUE(says(run.err, "mended", key)) << run.err;
  EXPECT_EQ(run.out, run_program({"convert", kTumvi, "--into", kSettings}).out) << "and nothing else";
  EXPECT_EQ(read_file(base), settings);
  // Where the program would refuse the file all the same, it stays as it is.
  const std::string incomplete =
      folder.write("worse.yaml", with_replaced(settings, "ORBextractor.nLevels", "# ORBextractor.nLevels"));
  const RunResult refused = run_program({"convert", kTumvi, "--into", incomplete});
  EXPECT_TRUE(says(refused.err, "program-refuses", "ORBextractor.nLevels")) << refused.err;
  EXPECT_FALSE(says(refused.err, "mended")) << refused.err;
}

// ORB-SLAM2 knows one lens: into its settings a fisheye goes as that, or not at all.
TEST(Into, ABaseOfAProgramWithoutTheLensKeepsItsText) {
  const TemporaryFolder folder;
  const std::string settings = read_file(testdata("formats/orbslam3/good/orbslam2-tight.yaml"));
  const std::string base = folder.write("mine.yaml", settings);
  const std::string chain = testdata("formats/kalibr/good/tumvi.yaml");
  const std::string size = "--resize=640x480";  // the base's
  const RunResult run = run_program(
      {"convert", chain, "--camera", "0", size, "--max-angle", "50", "--into", base, "--accept", "program-refuses"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(model_info(rig_in(run.out).cameras.at(0).model).id, "radtan");
  EXPECT_FALSE(contains(run.out, "File.version")) << run.out;
  // Nor does it know an IMU.
  const Told inertial({"convert", chain, "--camera", "0", size, "--max-angle", "50", "--into", base, "--with",
                       testdata("formats/kalibr/good/imu.yaml"), "--accept", "program-refuses"});
  EXPECT_EQ(inertial.code(), 0) << inertial.text();
  EXPECT_FALSE(contains(inertial.bytes(), "IMU.")) << inertial.bytes();
  EXPECT_TRUE(inertial.headline().ends_with(" mono")) << inertial.headline();
  const RunResult asked =
      run_program({"convert", chain, "--camera", "0", size, "--model", "kb4", "--into", base, "--in-place"});
  EXPECT_EQ(asked.code, 2) << asked.err;
  EXPECT_TRUE(says(asked.err, "into-another-layout")) << asked.err;
  EXPECT_EQ(read_file(base), settings);
}

// A pair put into a depth camera's settings: what tells its depth images is not the pair's to take away.
TEST(Into, AModeThatThePairDoesNotUseKeepsItsKeys) {
  const TemporaryFolder folder;
  const std::string depth = "RGBD.DepthMapFactor: 5000.0\nStereo.ThDepth: 35.0\nStereo.b: 0.07\n";
  const std::string settings = read_file(testdata("formats/orbslam3/good/v1-pinhole.yaml"));
  const std::string base = folder.write("depth.yaml", settings + (settings.ends_with("\n") ? "" : "\n") + depth);
  const ImageSize size = rig_in(settings).cameras.at(0).image_size.value();
  const RunResult run = run_program(
      {"convert", kTumvi, "--resize", std::to_string(size.width) + "x" + std::to_string(size.height), "--into", base});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "RGBD.DepthMapFactor: 5000.0")) << run.out;
  EXPECT_TRUE(contains(run.out, "Stereo.ThDepth: 35.0")) << run.out;
  EXPECT_TRUE(contains(run.out, "Stereo.T_c1_c2")) << run.out;
}

// The columns that both cameras see are set for images of the cameras that were there.
TEST(Into, ColumnsDoNotStayWithTheWrongCamera) {
  const TemporaryFolder folder;
  const std::string settings = with_replaced(with_replaced(read_file(testdata("formats/orbslam3/good/v1-stereo-inertial.yaml")),
                                                           "Camera1.overlappingEnd: ", "Camera1.overlappingEnd: 400 #"),
                                             "Camera2.overlappingBegin: ", "Camera2.overlappingBegin: 44 #");
  const std::string base = folder.write("base.yaml", settings);
  EXPECT_TRUE(contains(run_program({"convert", base, "--into", base}).out, "Camera1.overlappingEnd: 400"));
  const std::string swapped = run_program({"convert", base, "--camera", "1,0", "--into", base}).out;
  EXPECT_FALSE(contains(swapped, "Camera1.overlappingEnd: 400")) << swapped;
  EXPECT_FALSE(contains(swapped, "Camera2.overlappingBegin: 44")) << swapped;
}

// ORB-SLAM3 exits without them, and they follow from the pair that is put in.
TEST(Into, ColumnsThatTheBaseLacksComeWithThePair) {
  const TemporaryFolder folder;
  std::string settings = read_file(kSettings);
  for (const char* key : {"Camera1.overlappingBegin", "Camera1.overlappingEnd"})
    settings = with_replaced(settings, key, "Camera" + std::string(key).substr(7));
  const std::string base = folder.write("base.yaml", settings);
  const Told run({"convert", kTumvi, "--max-angle", "80", "--into", base});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(contains(run.bytes(), "\nCamera1.overlappingBegin: ")) << run.bytes();
  EXPECT_TRUE(contains(run.bytes(), "\nCamera1.overlappingEnd: ")) << run.bytes();
  EXPECT_TRUE(run.loads()) << run.text();
  // A base that is only written into itself stays as it is.
  EXPECT_EQ(run_program({"convert", base, "--into", base, "--no-verify"}).out, settings);
}

// stereo_euroc rectifies by LEFT.* and RIGHT.*, which nobody but who rectified can compute again.
TEST(Into, WhatWasComputedFromTheBasesCamerasIsListed) {
  const TemporaryFolder folder;
  const std::string settings = read_file(testdata("formats/orbslam3/good/orbslam2-tight.yaml"));
  const std::string matrix =
      ": !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n  data: [400., 0., 320., 0., 400., 240., 0., 0., 1.]\n";
  const std::string base = folder.write("base.yaml", settings + "\nLEFT.K" + matrix + "RIGHT.R" + matrix);
  const RunResult run = run_program({"convert", kTumvi, "--camera", "0", "--resize", "640x480", "--max-angle", "50", "--into",
                                     base, "--accept", "program-refuses"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "stale-derived", "LEFT.K") && says(run.err, "stale-derived", "RIGHT.R")) << run.err;
  EXPECT_FALSE(says(run_program({"convert", base, "--into", base, "--accept", "program-refuses"}).err, "stale-derived"));
}

}  // namespace
}  // namespace fca::test
