// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras.bin, rigs.bin and rigs.txt: their bytes by a layout written down here once more, the same rig as the text
// file, edits that keep every other byte, and the corpus' files as a person reads them.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "text/binary.h"
#include "transforms.h"

#include <fca/code.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/proof.h>
#include <fca/rig/rotation.h>

#include <array>
#include <bit>
#include <cstdint>
#include <functional>

namespace fca::test {
namespace {

const Format& colmap() { return *find_format("colmap"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "colmap" / "good" / name); }

std::string bytes_of(std::uint64_t number, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>((number >> (8 * i)) & 0xFF);
  return bytes;
}
std::string bytes_of(double number) { return bytes_of(std::bit_cast<std::uint64_t>(number), 8); }

/// A file of one camera.
std::string camera_file(std::uint32_t id, std::uint32_t model, std::array<std::uint64_t, 2> size,
                        const std::vector<double>& parameters) {
  std::string bytes = bytes_of(1, 8) + bytes_of(id, 4) + bytes_of(model, 4) + bytes_of(size[0], 8) + bytes_of(size[1], 8);
  for (const double parameter : parameters) bytes += bytes_of(parameter);
  return bytes;
}

std::optional<Written> written(const Rig& rig, const text::Document* base, const std::string& extension) {
  Diagnostics diagnostics;
  WriteOptions options;
  options.extension = extension;
  std::optional<Written> result = write_calibration(colmap(), base, rig, options, diagnostics);
  EXPECT_TRUE(result) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return result;
}

std::string written_bytes(const Rig& rig, const text::Document* base, const std::string& extension) {
  const std::optional<Written> result = written(rig, base, extension);
  return result ? result->files.front().document.bytes() : "";
}

/// The bytes as a file of the other kind.
std::string as(const std::string& bytes, const std::string& name, const std::string& extension) {
  const text::Document base = document_of(bytes, name);
  return written_bytes(calibration_of(bytes, name).rig, &base, extension);
}

// ---------------------------------------------------------------- the bytes

// Each of COLMAP's models by its number, with as many parameters as its line has: what the file says is what the line says.
TEST(ColmapBinary, SaysWhatTheLineSays) {
  constexpr std::array kLines = {"1 SIMPLE_PINHOLE 640 480 1.5 2.5 3.5",
                                 "1 PINHOLE 640 480 1.5 2.5 3.5 4.5",
                                 "1 SIMPLE_RADIAL 640 480 1.5 2.5 3.5 4.5",
                                 "1 RADIAL 640 480 1.5 2.5 3.5 4.5 5.5",
                                 "1 OPENCV 640 480 1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5",
                                 "1 OPENCV_FISHEYE 640 480 1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5",
                                 "1 FULL_OPENCV 640 480 1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5 9.5 10.5 11.5 12.5",
                                 "1 FOV 640 480 1.5 2.5 3.5 4.5 5.5",
                                 "1 SIMPLE_RADIAL_FISHEYE 640 480 1.5 2.5 3.5 4.5",
                                 "1 RADIAL_FISHEYE 640 480 1.5 2.5 3.5 4.5 5.5",
                                 "1 THIN_PRISM_FISHEYE 640 480 1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5 9.5 10.5 11.5 12.5",
                                 "1 RAD_TAN_THIN_PRISM_FISHEYE 640 480 1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5 9.5 10.5 11.5 12.5 13.5 "
                                 "14.5 15.5 16.5",
                                 "1 SIMPLE_DIVISION 640 480 1.5 2.5 3.5 4.5",
                                 "1 DIVISION 640 480 1.5 2.5 3.5 4.5 5.5",
                                 "1 SIMPLE_FISHEYE 640 480 1.5 2.5 3.5",
                                 "1 FISHEYE 640 480 1.5 2.5 3.5 4.5",
                                 "1 EUCM 640 480 1.5 2.5 3.5 4.5 5.5 6.5",
                                 "1 EQUIRECTANGULAR 640 480 1.5 2.5"};
  for (std::size_t i = 0; i < kLines.size(); ++i) {
    SCOPED_TRACE(kLines.at(i));
    const std::vector<std::string> words = split(kLines.at(i), ' ');
    std::vector<double> parameters;
    for (std::size_t k = 4; k < words.size(); ++k) parameters.push_back(std::stod(words[k]));
    const std::string bytes = camera_file(1, static_cast<std::uint32_t>(i), {640, 480}, parameters);
    const text::Document document = document_of(bytes, "cameras.bin");
    EXPECT_EQ(document.syntax(), text::Syntax::kBinary);
    EXPECT_EQ(document.root().tag, text::kCamerasTag);
    ASSERT_EQ(document.root().items.size(), 1U);
    const text::Node& line = document.root().items.front();
    ASSERT_EQ(line.items.size(), words.size());
    std::size_t at = 8;
    for (std::size_t k = 0; k < words.size(); ++k) {
      EXPECT_EQ(line.items[k].value, words[k]);
      EXPECT_EQ(line.items[k].span.offset, at);
      at = line.items[k].span.end();
    }
    EXPECT_EQ(at, bytes.size());
    EXPECT_EQ(text::binary_file(text::kCamerasTag, std::array{words}), bytes);
    // Other programs' readers take it apart in the same way.
    const consumers::ConsumerView view = consumers::find_consumer("colmap")->load(bytes, {});
    ASSERT_TRUE(view.loads());
    EXPECT_EQ(view.cameras.front().model, words[1]);
    EXPECT_EQ(view.cameras.front().width, 640);
  }
}

TEST(ColmapBinary, IsKnownByItsContent) {
  EXPECT_EQ(calibration_of(good("lenses.bin"), "<stdin>").rig, calibration_of(good("lenses.bin"), "cameras.bin").rig);
  EXPECT_EQ(document_of(good("pair-rigs.bin"), "a").root().tag, text::kRigsTag);
  EXPECT_EQ(document_of("a: 1\nb: 2\n", "cameras.bin").syntax(), text::Syntax::kYaml) << "a text by that name";
  EXPECT_EQ(parse(std::string("a: 1\nb: \0 2\n", 12), "a.yaml").codes(), "binary-file");
}

TEST(ColmapBinary, EveryPrefixIsRefusedAtItsEnd) {
  for (const char* name : {"lenses.bin", "pair-rigs.bin"}) {
    const std::string bytes = good(name);
    for (std::size_t length = 1; length < bytes.size(); ++length) {
      const Parsed parsed = parse(bytes.substr(0, length), name);
      ASSERT_FALSE(parsed.document) << length;
      ASSERT_EQ(parsed.codes(), "wrong-count") << length;
    }
  }
}

// A count is believed only as far as there are bytes for it.
TEST(ColmapBinary, AnAbsurdCountTakesNoMemory) {
  std::string bytes = good("pinhole.bin");
  for (std::size_t byte = 1; byte < 8; ++byte) {
    std::string large = bytes;
    large[byte] = '\x7f';
    const Parsed parsed = parse(large, "cameras.bin");
    EXPECT_FALSE(parsed.document);
    EXPECT_EQ(parsed.diagnostics.entries().front().facts.code, Code::kBinaryCount);
  }
}

// ---------------------------------------------------------------- text and binary

TEST(ColmapBinary, TextAndBinaryBecomeEachOther) {
  const std::string bytes = good("lenses.bin");
  const std::string text = as(bytes, "cameras.bin", ".txt");
  EXPECT_NE(text.find("\n3 SIMPLE_RADIAL 1920 1080 1500.75 960.5 540.5 -0.02\n"), std::string::npos) << text;
  EXPECT_EQ(calibration_of(text, "cameras.txt").rig, calibration_of(bytes, "cameras.bin").rig);
  EXPECT_EQ(as(text, "cameras.txt", ".bin"), bytes);
  for (const fs::path& path : files_in(testdata_dir() / "colmap" / "good", ".txt")) {
    if (path.stem().string().ends_with("rigs")) continue;
    const std::string binary = as(read_file(path), "cameras.txt", ".bin");
    EXPECT_EQ(calibration_of(binary, "cameras.bin").rig, calibration_of(read_file(path), "cameras.txt").rig) << path;
    EXPECT_EQ(as(as(binary, "cameras.bin", ".txt"), "cameras.txt", ".bin"), binary) << path;
  }
}

// Numbers of a text file may be spelled in several ways.
TEST(ColmapBinary, WholeNumbersAreWhatTheTextMeans) {
  const std::string text = "+5 PINHOLE +640 4.8e2 +500 500 320 240\n";
  EXPECT_EQ(as(text, "cameras.txt", ".bin"), camera_file(5, 1, {640, 480}, {500.0, 500.0, 320.0, 240.0}));
}

TEST(ColmapBinary, AFreshFileIsReadAsTheSameRig) {
  for (const char* model : {"pinhole", "radtan", "kb4", "eucm", "fov", "division", "thin-prism-fisheye", "fisheye624"}) {
    const Rig rig = sample_rig(model, {false, false});
    const std::string text = written_bytes(rig, nullptr, "");
    const std::string binary = written_bytes(rig, nullptr, ".bin");
    EXPECT_EQ(calibration_of(binary, "<stdin>").rig, calibration_of(text, "cameras.txt").rig) << model;
    const ProofResult proof = prove(*consumers::find_consumer("colmap"), binary, {}, rig);
    EXPECT_TRUE(proof.agrees()) << model;
  }
}

// ---------------------------------------------------------------- edited

std::string edited(const std::function<void(Rig&)>& edit) {
  const std::string bytes = good("lenses.bin");
  Rig rig = calibration_of(bytes, "cameras.bin").rig;
  edit(rig);
  const text::Document base = document_of(bytes, "cameras.bin");
  return written_bytes(rig, &base, "");
}

/// The file with other bytes at a word of a camera.
std::string with(std::size_t camera, std::size_t word, const std::string& now) {
  const std::string bytes = good("lenses.bin");
  const text::Document document = document_of(bytes, "cameras.bin");
  std::string result = bytes;
  return result.replace(document.root().items.at(camera).items.at(word).span.offset, now.size(), now);
}

TEST(ColmapBinary, AnEditChangesItsBytesAlone) {
  EXPECT_EQ(edited([](Rig&) {}), good("lenses.bin"));
  EXPECT_EQ(edited([](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras[1].model, "cx", 321.0)); }),
            with(1, 6, bytes_of(321.5)));
  EXPECT_EQ(edited([](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras[4].model, "p2", -0.25)); }),
            with(4, 11, bytes_of(-0.25)));
  EXPECT_EQ(edited([](Rig& rig) { rig.cameras[4].image_size = ImageSize{752, 240}; }), with(4, 3, bytes_of(240, 8)));
}

// f of SIMPLE_RADIAL is one number.
TEST(ColmapBinary, ACameraWhoseModelIsTooSmallGetsAnother) {
  const std::string bytes = edited([](Rig& rig) { set_parameter(rig.cameras[2].model, "fy", 1505.0); });
  EXPECT_EQ(bytes.size(), good("lenses.bin").size() + 4 * 8);
  const text::Document document = document_of(bytes, "cameras.bin");
  EXPECT_EQ(document.root().items[2].items[1].value, "OPENCV");
  EXPECT_EQ(parameter(calibration_of(bytes, "cameras.bin").rig.cameras[2].model, "fy"), 1505.0);
}

// ---------------------------------------------------------------- rigs

const Transform& pose(const Rig& rig, const std::string& a, const std::string& b) {
  static const Transform kNone = {};
  const Transform* found = rig.stated(a, b);
  EXPECT_NE(found, nullptr) << "no T_" << a << "_" << b;
  return found != nullptr ? *found : kNone;
}

// A quarter turn about z takes x to y. A pose takes points of the rig, which is its first sensor, to the sensor.
TEST(ColmapRigs, PosesTakeThePointsOfTheFirstSensor) {
  const Transform expected = {{0.0, -1.0, 0.0, -0.11, 1.0, 0.0, 0.0, 0.002, 0.0, 0.0, 1.0, 0.003, 0.0, 0.0, 0.0, 1.0}};
  for (const char* name : {"pair-rigs.txt", "pair-rigs.bin"}) {
    SCOPED_TRACE(name);
    const Rig rig = calibration_of(good(name), name).rig;
    EXPECT_EQ(rig.poses.size(), 2U);
    EXPECT_LT(element_difference(pose(rig, "cam1", "cam0"), expected), 1e-15);
    EXPECT_EQ(translation_of(pose(rig, "imu0", "cam0")), (std::array{0.01, 0.02, -0.03}));
    EXPECT_EQ(rig.kind_of("imu0"), FrameKind::kImu);
    const consumers::ConsumerView view = consumers::find_consumer("colmap-rig")->load(good(name), {});
    ASSERT_EQ(view.poses.size(), 2U);
    EXPECT_EQ(view.poses.front().a, "CAMERA 2");
    EXPECT_LT(element_difference(Transform{view.poses.front().T_a_b}, expected), 1e-15);
  }
  EXPECT_EQ(calibration_of(good("pair-rigs.txt"), "a.txt").rig, calibration_of(good("pair-rigs.bin"), "a.bin").rig);
}

/// Cameras and rigs of one folder.
Calibration both(const std::string& cameras, const std::string& rigs) {
  Diagnostics diagnostics;
  std::vector<text::Document> documents = {document_of(cameras, "cameras.txt"), document_of(rigs, "rigs.txt")};
  std::optional<Calibration> result = read_calibration(std::move(documents), nullptr, {}, diagnostics);
  EXPECT_TRUE(result);
  return result ? *std::move(result) : Calibration();
}

TEST(ColmapRigs, SensorsAreCamerasByTheirIds) {
  const Rig rig = both("5 PINHOLE 640 480 500 500 320 240\n2 PINHOLE 640 480 500 500 320 240\n",
                       "1 3 CAMERA 2 CAMERA 5 1 1 0 0 0 0.5 0 0 CAMERA 9 1 1 0 0 0 0.7 0 0\n")
                      .rig;
  EXPECT_EQ(translation_of(pose(rig, "cam0", "cam1")), (std::array{0.5, 0.0, 0.0}));
  EXPECT_EQ(rig.kind_of(rig.poses.back().a), FrameKind::kOther) << "no camera has the id 9";
}

TEST(ColmapRigs, AFreshOneComesBack) {
  Rig rig = sample_rig("kb4", {true, false});
  for (Camera& camera : rig.cameras) camera.topic.clear();
  rig.extra_fields.push_back({rig.cameras[0].name, "CAMERA_ID", "7"});
  for (const std::string& extension : {std::string(), std::string(".bin")}) {
    const std::optional<Written> files = written(rig, nullptr, extension);
    ASSERT_TRUE(files);
    ASSERT_EQ(files->files.size(), 5U);
    EXPECT_FALSE(loses(*files, Code::kPoseDropped));
    const text::Document& rigs = files->files[2].document;
    EXPECT_TRUE(rigs.source().name.starts_with("rigs."));
    const Rig back = both(files->files[0].document.bytes(), rigs.bytes()).rig;
    const std::string& first = back.cameras.front().name;
    for (std::size_t i = 1; i < rig.cameras.size(); ++i) {
      EXPECT_LT(element_difference(pose(back, back.cameras[i].name, first),
                                   *rig.resolve(rig.cameras[i].name, rig.cameras.front().name)),
                1e-12);
    }
    EXPECT_TRUE(consumers::find_consumer("colmap-rig")->load(rigs.bytes(), {}).loads());
  }
}

// COLMAP asks that each camera with images is in a rig.
TEST(ColmapRigs, CamerasWithoutPosesAreRigsOfTheirOwn) {
  Rig rig = sample_rig("kb4", {true, false});
  Camera alone = rig.cameras.front();
  alone.name = "alone";
  rig.cameras.insert(rig.cameras.begin(), alone);
  const std::optional<Written> files = written(rig, nullptr, "");
  ASSERT_TRUE(files);
  const std::string& name = files->files[1].document.source().name;
  EXPECT_EQ(name, "rigs.txt") << "a rig_config.json has one reference for all";
  const std::string rigs = files->files[1].document.bytes();
  EXPECT_NE(rigs.find("\n1 1 CAMERA 1\n2 "), std::string::npos) << rigs;
}

// ---------------------------------------------------------------- the corpus

struct Expected {
  const char* file;
  std::size_t cameras;
  const char* model;  ///< COLMAP's, of the last camera, as what follows.
  double fx;          ///< As the file has it.
  double cx;          ///< Half a pixel more than ours.
  ImageSize size;
};

// Values as Python's struct.unpack shows them.
constexpr std::array kExpected = {
    Expected{"5697526__NeRF-TensoRF__sparse__0__cameras.bin", 80, "SIMPLE_PINHOLE", 1831.9143095815152, 540, {1080, 1920}},
    Expected{"AspasZhang__NeRF__sparse__0__cameras.bin", 1, "SIMPLE_RADIAL", 2049.4731417087132, 360, {720, 1280}},
    Expected{"HexGP__nerf-prep__colmap_sparse__0__cameras.bin",
             1,
             "SIMPLE_RADIAL",
             1027.7879529283434,
             481.14437353992906,
             {1080, 1920}},
    Expected{"sangminkim-99__COLMAP_multicam__colmap_sparse__0__cameras.bin",
             2,
             "OPENCV",
             608.562030830161,
             321.3254292697266,
             {640, 480}},
    Expected{
        "vork__duck_queen-photogrammetry__sparse__0__cameras.bin", 1, "SIMPLE_RADIAL", 3689.688157122283, 2592, {5184, 3888}},
};

TEST(ColmapBinary, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "colmap";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const std::string bytes = read_file(corpus / expected.file);
    const Calibration calibration = calibration_of(bytes, expected.file);
    ASSERT_EQ(calibration.rig.cameras.size(), expected.cameras);
    const Camera& camera = calibration.rig.cameras.back();
    EXPECT_EQ(calibration.documents.front().root().items.back().items[1].value, expected.model);
    EXPECT_EQ(parameter(camera.model, "fx"), expected.fx);
    EXPECT_EQ(parameter(camera.model, "cx"), expected.cx - 0.5);
    EXPECT_EQ(camera.image_size, expected.size);
    EXPECT_EQ(written_bytes(calibration.rig, &calibration.documents.front(), ""), bytes);
    EXPECT_TRUE(consumers::find_consumer("colmap")->load(bytes, {}).loads());
  }
  const auto binary = std::ranges::count_if(
      files_in(corpus), [](const fs::path& path) { return path.filename().string().ends_with("cameras.bin"); });
  EXPECT_EQ(static_cast<std::size_t>(binary), kExpected.size());
  for (const char* rigs : {"HexGP__nerf-prep__colmap_sparse__0__rigs.bin", "HexGP__nerf-prep__colmap_text__rigs.txt"}) {
    const Calibration calibration = calibration_of(read_file(corpus / rigs), rigs);
    EXPECT_EQ(calibration.format, &colmap());
    EXPECT_TRUE(calibration.rig.poses.empty()) << "one rig of one camera";
  }
}

}  // namespace
}  // namespace fca::test
