// SPDX-License-Identifier: BSD-3-Clause
// Writing into a base whose cameras, parts or style change: what nobody asked to change stays.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>

#include <algorithm>

namespace fca::test {
namespace {

std::string good(const char* name) { return read_file(testdata_dir() / name); }

Written written_into(const Calibration& base, const Rig& rig, const WriteOptions& options = {}) {
  Diagnostics diagnostics;
  std::optional<Written> written = base.format->write(&base.documents.front(), rig, options, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? *std::move(written) : Written();
}

WriteOptions in_layout(const std::string& layout) {
  WriteOptions options;
  options.layout = layout;
  return options;
}

std::string bytes_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

std::string value_of(const std::string& bytes, const std::string& key) {
  const text::Document document = document_of(bytes);
  const text::Node* node = text::find(document.root(), key, text::Dialect::kOpenCv);
  return node == nullptr ? "absent" : node->value;
}

/// Keys a user tunes, with values that are nobody's default.
std::string tuned(std::string settings) {
  settings = std::string(settings);
  for (const auto& [key, value] : {std::pair{"Camera.RGB", "0"},
                                   {"Stereo.ThDepth", "35.0"},
                                   {"ORBextractor.nFeatures", "1250"},
                                   {"Viewer.ViewpointF", "1800.0"}}) {
    const std::size_t at = settings.find(std::string("\n") + key + ":");
    EXPECT_NE(at, std::string::npos) << key;
    const std::size_t end = settings.find('\n', at + 1);
    settings.replace(at, end - at, std::string("\n") + key + ": " + value);
  }
  return settings;
}

std::string settings_with_two_cameras_and_imu() {
  Diagnostics diagnostics;
  const std::optional<Written> written =
      find_format("orbslam3")->write(nullptr, sample_rig("kb4", {true, true}), {}, diagnostics);
  EXPECT_TRUE(written);
  return tuned(bytes_of(*written));
}

TEST(Base, OneCameraOfTwoKeepsTheTuning) {
  const Calibration base = calibration_of(settings_with_two_cameras_and_imu());
  Rig second = base.rig;
  second.cameras.erase(second.cameras.begin());
  const Written written = written_into(base, second);
  EXPECT_EQ(written.sensor, "mono-inertial");
  EXPECT_TRUE(written.losses.empty()) << what_of(written.losses.front());
  EXPECT_TRUE(written.defaults.empty()) << written.defaults.front().key;
  const std::string bytes = bytes_of(written);
  EXPECT_EQ(value_of(bytes, "Camera.RGB"), "0");
  EXPECT_EQ(value_of(bytes, "ORBextractor.nFeatures"), "1250");
  EXPECT_EQ(value_of(bytes, "Camera2.fx"), "absent");
  const Rig back = calibration_of(bytes).rig;
  ASSERT_EQ(back.cameras.size(), 1U);
  EXPECT_EQ(back.cameras[0].model, base.rig.cameras[1].model);
  EXPECT_LE(element_difference(back.resolve("cam0", "imu0").value(), base.rig.resolve("cam1", "imu0").value()), 1e-12);
  EXPECT_TRUE(consumers::find_consumer("orbslam3")->load(bytes, {"mono-inertial"}).loads());
}

// What is listed as lost is not there; what no mode asks for and the base specifies is edited.
TEST(Base, AModeWithoutImuDropsItsPoseAndKeepsTheBases) {
  const Calibration inertial = calibration_of(settings_with_two_cameras_and_imu());
  Diagnostics diagnostics;
  WriteOptions mono;
  mono.sensor = "mono";
  const Written dropped = written_into(inertial, inertial.rig, mono);
  EXPECT_EQ(value_of(bytes_of(dropped), "IMU.T_b_c1"), "absent");
  // That the pose goes is told by write_calibration(), which asks the written file.
  const std::optional<Written> told =
      write_calibration(*inertial.format, &inertial.documents.front(), inertial.rig, mono, diagnostics);
  ASSERT_TRUE(told);
  EXPECT_TRUE(loses(*told, Code::kPoseDropped, {"T_imu0_cam0"}));

  const Calibration list = calibration_of(good("orbslam3/good/orbslam2-tbc-list.yaml"));
  Rig moved = list.rig;
  moved.poses.front().T_a_b(0, 3) = 0.5;
  const Written kept = written_into(list, moved);
  EXPECT_TRUE(kept.losses.empty());
  EXPECT_EQ(bytes_of(kept), with_replaced(good("orbslam3/good/orbslam2-tbc-list.yaml"), "0.0625", "0.5"));
}

TEST(Base, AnImuThatJoinsIsInserted) {
  Diagnostics diagnostics;
  const std::string mono =
      bytes_of(*find_format("orbslam3")->write(nullptr, sample_rig("kb4", {false, false}), {}, diagnostics));
  const std::string bytes_before = with_replaced(mono, "Camera.RGB: 1", "Camera.RGB: 0   # mine");
  const Calibration base = calibration_of(bytes_before);
  Rig rig = base.rig;
  const Rig inertial = sample_rig("kb4", {false, true});
  rig.imus = inertial.imus;
  rig.poses = inertial.poses;
  const std::string bytes = bytes_of(written_into(base, rig));
  EXPECT_NE(bytes.find("Camera.RGB: 0   # mine"), std::string::npos) << bytes;
  EXPECT_TRUE(consumers::find_consumer("orbslam3")->load(bytes, {"mono-inertial"}).loads()) << bytes;
}

// A Double Sphere file of a fork becomes stock settings: another parser, the same robot.
TEST(Base, AnotherStyleCarriesWhatTheInputTunes) {
  const Calibration base = calibration_of(good("orbslam3/good/old-doublesphere.yaml") +
                                          "ORBextractor.nFeatures: 1250\nViewer.PointSize: 3\nViewer.ViewpointF: 1800\n");
  Rig rig = base.rig;
  for (Camera& camera : rig.cameras) camera.model = sample_model("kb4");
  const Written written = written_into(base, rig, in_layout("v1"));
  const std::string bytes = bytes_of(written);
  EXPECT_EQ(value_of(bytes, "File.version"), "1.0");
  EXPECT_EQ(value_of(bytes, "Viewer.PointSize"), "3.0") << "V1.0 demands a real";
  for (const text::Entry& entry : base.documents.front().root().entries) {
    const std::string& key = entry.key.value;
    if (!key.starts_with("ORBextractor.") && !key.starts_with("Viewer.") && key != "Camera.RGB") continue;
    const std::optional<double> was = text::parse_real(entry.value.value);
    EXPECT_EQ(text::parse_real(value_of(bytes, key)), was) << key;
  }
  EXPECT_TRUE(consumers::find_consumer("orbslam3")->load(bytes, {written.sensor}).loads()) << bytes;
}

TEST(Base, ALayoutCanBeAskedFor) {
  const Calibration base = calibration_of(good("orbslam3/good/orbslam2-tight.yaml"));
  const Written written = written_into(base, base.rig, in_layout("v1"));
  EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"orbslam3"});
  EXPECT_EQ(calibration_of(bytes_of(written)).rig.cameras.at(0).model, base.rig.cameras.at(0).model);
  EXPECT_TRUE(consumers::find_consumer("orbslam3")->load(bytes_of(written), {written.sensor}).loads());
}

// V1.0 does not read Camera2.* of Rectified settings: Stereo.b is the pair.
TEST(Base, RectifiedSettingsAreAPairByTheirBaseline) {
  const std::string bytes = good("orbslam3/good/v1-rectified.yaml") + "\nCamera2.fx: 435.2\nCamera2.fy: 435.2\n";
  const Calibration base = calibration_of(bytes);
  EXPECT_EQ(base.rig.cameras.size(), 1U);
  EXPECT_TRUE(base.rig.baseline_m);
  const Written written = written_into(base, base.rig);
  EXPECT_TRUE(written.sensor.starts_with("stereo")) << written.sensor;
  EXPECT_EQ(bytes_of(written), bytes);
}

// Whatever stands in a settings file and has no place in a camchain is said, key by key or group by group.
TEST(Base, NoKeyOfSettingsGoesSilently) {
  for (const fs::path& path : files_in(testdata_dir() / "orbslam3" / "good", ".yaml")) {
    const Calibration settings = calibration_of(read_file(path) + "\nMy.own.key: 5\nTheir.height: 480\n");
    Rig rig = settings.rig;
    for (Camera& camera : rig.cameras) camera.model = sample_model("kb4");
    Diagnostics diagnostics;
    const std::optional<Written> written = find_format("kalibr")->write(nullptr, rig, {}, diagnostics);
    ASSERT_TRUE(written) << path;
    EXPECT_TRUE(loses(*written, Code::kNotCarriedValue, {"My.own.key", "5"})) << path;
    EXPECT_TRUE(loses(*written, Code::kNotCarriedValue, {"Their.height", "480"})) << path;
    if (value_of(read_file(path), "ORBextractor.nLevels") != "absent") {
      EXPECT_TRUE(loses(*written, Code::kNotCarriedGroup, {"ORBextractor."})) << path;
    }
  }
}

/// The file with two keys that no program knows, one of them a list.
std::string with_own_keys(const text::Document& document) {
  const text::Syntax syntax = document.syntax();
  std::string text = document.source().bytes;
  if (syntax != text::Syntax::kJson && document.root().flow) return text;
  if (syntax == text::Syntax::kXml)
    return text.insert(text.rfind("</opencv_storage>"), "<my_own_key>5</my_own_key>\n<my_list>6 7</my_list>\n");
  if (syntax == text::Syntax::kJson) return text.insert(text.find('{') + 1, "\"my_own_key\": 5, \"my_list\": [6, 7],");
  if (syntax == text::Syntax::kWords || syntax == text::Syntax::kBinary) return text;
  return text + (text.ends_with('\n') ? "" : "\n") + "my_own_key: 5\nmy_list: [6, 7]\n";
}

/// Is the key said somewhere in the files, with that value? Settings say some under a group's name: "Stereo.ThDepth".
bool still_says(std::span<const ExtraField> files, const ExtraField& extra) {
  const std::string last = extra.key.substr(extra.key.find('.') + 1);  // all of it, where there is no point
  return std::ranges::any_of(files, [&](const ExtraField& now) {
    const bool same_key = (now.owner == extra.owner && now.key == extra.key) || now.key.ends_with("." + last);
    const std::optional<double> was = text::parse_real(extra.value);
    return same_key && (now.value == extra.value || (was && text::parse_real(now.value) == was));
  });
}

/// Is the key, or its group, among the losses, or among what is computed (OCamCalib's inverse polynomial)?
bool is_listed(const Written& written, const std::string& key) {
  if (std::ranges::find(written.defaults, key, &DefaultedValue::key) != written.defaults.end()) return true;
  return std::ranges::any_of(written.losses, [&key](const Loss& loss) {
    const std::string named = loss.owner.empty() ? loss.key : loss.owner + " " + loss.key;
    return loss.kind == Code::kNotCarriedGroup ? key.starts_with(named) : key == named;
  });
}

// Whatever the format: where a base gives way to a file that is rewritten, each of its keys is carried or listed.
TEST(Base, ARewrittenBaseGoesWithNoKeyUnreported) {
  int bases = 0;
  for (const Format& format : written_formats()) {
    if (!format.layout_of.empty()) continue;  // its files are another's
    for (const fs::path& path : files_in(testdata_dir() / std::string(format.id) / "good")) {
      SCOPED_TRACE(path.string());
      Diagnostics diagnostics;
      const std::optional<text::Document> plain =
          text::parse_document({path.filename().string(), read_file(path)}, diagnostics);
      ASSERT_TRUE(plain);
      const std::string bytes = with_own_keys(*plain);
      const std::optional<text::Document> document = text::parse_document({path.filename().string(), bytes}, diagnostics);
      ASSERT_TRUE(document) << bytes;
      const std::optional<Rig> base = format.read(std::span(&*document, 1), {}, diagnostics);
      ASSERT_TRUE(base) << bytes;
      // A rig from elsewhere, that knows nothing of the base's own keys.
      Rig rig = sample_rig("kb4", {false, false});
      if (!base->cameras.empty()) rig.cameras.front().model = base->cameras.front().model;
      WriteOptions rewrite;
      rewrite.rewrite = true;
      const std::optional<Written> written = write_calibration(format, &*document, rig, rewrite, diagnostics);
      ASSERT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().back()));
      ++bases;
      std::vector<ExtraField> said;
      for (const Written::File& file : written->files) {
        if (file.of_defaults && file.programs.empty()) continue;  // COLMAP's images.txt, without an image
        const std::optional<text::Document> now =
            text::parse_document({file.document.source().name, file.document.bytes()}, diagnostics);
        ASSERT_TRUE(now);
        const std::optional<Rig> back = format.read(std::span(&*now, 1), {}, diagnostics);
        ASSERT_TRUE(back);
        said.insert(said.end(), back->extra_fields.begin(), back->extra_fields.end());
      }
      for (const ExtraField& extra : base->extra_fields) {
        // What is said of a camera goes with the camera.
        const bool of_gone = base->find_camera(extra.owner) != nullptr && rig.find_camera(extra.owner) == nullptr;
        EXPECT_TRUE(of_gone || still_says(said, extra) || is_listed(*written, with_owner(extra)))
            << with_owner(extra) << " " << extra.value;
      }
    }
  }
  EXPECT_GE(bases, 30);
}

/// A chain with comments, an odd spelling and a key of Kalibr's that Rig has no member for.
constexpr const char* kChain =
    "# my rig\n"
    "cam0:\n"
    "  camera_model: pinhole   # left\n"
    "  cam_overlaps: [1]\n"
    "  intrinsics: [190.50, 190.25, 254.0, 256.0]\n"
    "  distortion_model: equidistant\n"
    "  distortion_coeffs: [0.01, 0.02, 0.03, 0.04]\n"
    "  resolution: [512, 512]\n"
    "  line_delay: 0.00002\n"
    "cam1:\n"
    "  camera_model: pinhole   # right\n"
    "  cam_overlaps: [0]\n"
    "  T_cn_cnm1:\n"
    "  - [1.0, 0.0, 0.0, -0.1]\n"
    "  - [0.0, 1.0, 0.0, 0.0]\n"
    "  - [0.0, 0.0, 1.0, 0.0]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n"
    "  intrinsics: [191.50, 191.25, 255.0, 257.0]\n"
    "  distortion_model: equidistant\n"
    "  distortion_coeffs: [0.01, 0.02, 0.03, 0.05]\n"
    "  resolution: [512, 512]\n"
    "  line_delay: 0.00003\n";

TEST(Base, AChainLosesACameraInPlace) {
  const Calibration base = calibration_of(kChain);
  Rig rig = base.rig;
  rig.cameras.erase(rig.cameras.begin());
  const Written written = written_into(base, rig);
  EXPECT_EQ(bytes_of(written),
            "# my rig\n"
            "cam0:\n"
            "  camera_model: pinhole   # right\n"
            "  cam_overlaps: []\n"
            "  intrinsics: [191.50, 191.25, 255.0, 257.0]\n"
            "  distortion_model: equidistant\n"
            "  distortion_coeffs: [0.01, 0.02, 0.03, 0.05]\n"
            "  resolution: [512, 512]\n"
            "  line_delay: 0.00003\n");
  EXPECT_FALSE(loses_anything_of(written, "cam_overlaps"));
  EXPECT_EQ(written.files.front().cameras, std::vector<std::string>{"cam1"});
}

TEST(Base, AChainInAnotherOrderMeansTheSame) {
  const Calibration base = calibration_of(kChain);
  Rig rig = base.rig;
  std::swap(rig.cameras[0], rig.cameras[1]);
  const std::string bytes = bytes_of(written_into(base, rig));
  const Rig back = calibration_of(bytes).rig;
  ASSERT_EQ(back.cameras.size(), 2U);
  EXPECT_EQ(back.cameras[0].model, base.rig.cameras[1].model);
  EXPECT_EQ(back.cameras[1].model, base.rig.cameras[0].model);
  EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), base.rig.resolve("cam0", "cam1").value()), 1e-15);
  EXPECT_NE(bytes.find("# right"), std::string::npos);
  EXPECT_TRUE(consumers::find_consumer("kalibr")->load(bytes, {}).loads()) << bytes;
}

TEST(Base, AChainGainsACameraBehindItsOwn) {
  const Calibration base = calibration_of(kChain);
  Rig rig = base.rig;
  Camera third = rig.cameras[0];
  third.name = "third";
  third.model = sample_model("eucm");
  rig.cameras.push_back(third);
  rig.poses.push_back({"third", "cam1", T_cam1_cam0()});
  const std::string bytes = bytes_of(written_into(base, rig));
  EXPECT_NE(bytes.find("# left"), std::string::npos);
  const Rig back = calibration_of(bytes).rig;
  ASSERT_EQ(back.cameras.size(), 3U);
  EXPECT_EQ(back.cameras[2].model, third.model);
  EXPECT_EQ(back.resolve("cam2", "cam1"), T_cam1_cam0());
  EXPECT_TRUE(consumers::find_consumer("kalibr")->load(bytes, {}).loads()) << bytes;
}

// Kalibr counts cam0, cam1, ... and refuses both of these; read and written back unchanged they are what they were.
TEST(Base, AChainThatCountsOtherwiseStaysAsItIs) {
  const std::string kGap =
      "# cam0 and cam2: cam1 was taken out by hand.\n"
      "cam0:\n"
      "  camera_model: pinhole\n"
      "  intrinsics: [460.25, 459.5, 365.5, 249.0]\n"
      "  distortion_model: radtan\n"
      "  distortion_coeffs: [-0.28, 0.074, 0.0002, 1.76e-05]\n"
      "  resolution: [752, 480]\n"
      "cam2:\n"
      "  camera_model: pinhole\n"
      "  intrinsics: [457.5, 456.25, 379.75, 255.25]\n"
      "  distortion_model: radtan\n"
      "  distortion_coeffs: [-0.283, 0.0745, -0.0001, -3.5e-05]\n"
      "  resolution: [752, 480]\n";
  const std::string kOnlySecond =
      "# The right camera of a pair, in a file of its own.\n"
      "cam1:\n"
      "  cam_overlaps: []\n"
      "  camera_model: pinhole\n"
      "  intrinsics: [457.5, 456.25, 379.75, 255.25]\n"
      "  distortion_model: radtan\n"
      "  distortion_coeffs: [-0.283, 0.0745, -0.0001, -3.5e-05]\n"
      "  resolution: [752, 480]\n";
  for (const std::string& bytes : {kGap, kOnlySecond}) {
    const Calibration base = calibration_of(bytes);
    EXPECT_EQ(bytes_of(written_into(base, base.rig)), bytes);
  }
}

// A camera left out must not lend its name's poses to the one that takes the name.
TEST(Base, ACameraLeftOutLeavesNoPoses) {
  Rig rig = sample_rig("kb4", {true, true});
  const Transform T_cam1_imu = rig.resolve("cam1", "imu0").value();
  rig.cameras.erase(rig.cameras.begin());
  Diagnostics diagnostics;
  const std::optional<Written> written = find_format("kalibr")->write(nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  const Rig back = calibration_of(bytes_of(*written)).rig;
  EXPECT_LE(element_difference(back.resolve("cam0", "imu0").value(), T_cam1_imu), 1e-12);
}

TEST(Base, AnImuWithoutATopicGetsOneToLookAt) {
  Rig rig = sample_rig("kb4", {false, true});
  rig.imus.front().topic.clear();
  Diagnostics diagnostics;
  const std::optional<Written> written = find_format("kalibr")->write(nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  ASSERT_EQ(written->files.size(), 2U);
  EXPECT_TRUE(consumers::find_consumer("kalibr-imu")->load(written->files[1].document.bytes(), {}).loads());
  EXPECT_TRUE(std::ranges::any_of(written->defaults, &DefaultedValue::look_at_it));
  rig.imus.front().rate_hz.reset();  // a fact: never made up
  const std::optional<Written> without = find_format("kalibr")->write(nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(without);
  EXPECT_EQ(without->files.size(), 1U);
  EXPECT_TRUE(loses(*without, Code::kCamchainImuIncomplete, {"imu0", "update_rate"}));
}

}  // namespace
}  // namespace fca::test
