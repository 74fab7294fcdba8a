// SPDX-License-Identifier: BSD-3-Clause
// FAST-LIVO's camera: what its numbers mean, what its program reads from them, and that edits keep every other byte.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>

namespace fca::test {
namespace {

const Format& fast_livo() { return *find_format("fast-livo"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "fast-livo" / name); }
Rig rig_of(const std::string& bytes) { return calibration_of(bytes, "camera.yaml").rig; }

consumers::ConsumerView view_of(const std::string& bytes) { return consumers::find_consumer("fast-livo")->load(bytes, {}); }

std::string written_bytes(const text::Document* base, const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(fast_livo(), base, rig, {}, diagnostics);
  EXPECT_TRUE(written);
  if (!written) return "";
  const Written::File& file = written->files.front();
  const std::string bytes = file.document.bytes();
  const ProofResult proof = prove(*consumers::find_consumer("fast-livo"), bytes, {}, rig, file.cameras, 0.9);
  EXPECT_TRUE(proof.agrees()) << (proof.loads ? "other numbers" : "refused") << "\n" << bytes;
  return bytes;
}

std::string with_change(const std::string& bytes, const std::function<void(Rig&)>& change) {
  Rig rig = rig_of(bytes);
  change(rig);
  const text::Document base = document_of(bytes, "camera.yaml");
  return written_bytes(&base, rig);
}

// scale says what the program does with the images; the numbers are those of the images as they come.
TEST(FastLivo, TheNumbersAreThoseOfTheImagesAsTheyCome) {
  const Rig rig = rig_of(good("good/pinhole.yaml"));
  const Camera& camera = rig.cameras.front();
  EXPECT_EQ(camera.image_size, (ImageSize{1280, 1024}));
  EXPECT_EQ(parameter(camera.model, "fx"), 1293.5);
  EXPECT_EQ(parameter(camera.model, "p2"), 0.00025);
  EXPECT_EQ(rig.find_extra_field("cam0", "scale")->value, "0.5");
  const consumers::ConsumerView view = view_of(good("good/pinhole.yaml"));
  ASSERT_EQ(view.cameras.size(), 1U);
  EXPECT_EQ(view.cameras.front().width, 640);
  const std::optional<Pixel> pixel = project(camera.model, {0.2, -0.1, 1.0});
  const std::optional<std::array<double, 2>> shrunk = view.cameras.front().project({0.2, -0.1, 1.0});
  ASSERT_TRUE(pixel && shrunk);
  EXPECT_NEAR((*shrunk)[0], 0.5 * (*pixel)[0], 1e-9);
}

// Of ATAN lengths are shares of the image's sides, whose centre counts from the border: 0.50625 * 752 - 0.5.
TEST(FastLivo, LengthsOfAtanAreShares) {
  const Camera camera = rig_of(good("good/atan.yaml")).cameras.front();
  ASSERT_EQ(model_info(camera.model).id, "fov");
  EXPECT_NEAR(parameter(camera.model, "fx").value(), 385.4, 1e-12);
  EXPECT_NEAR(parameter(camera.model, "fy").value(), 384.6, 1e-12);
  EXPECT_NEAR(parameter(camera.model, "cx").value(), 380.2, 1e-12);
  EXPECT_NEAR(parameter(camera.model, "cy").value(), 230.5, 1e-12);
  EXPECT_EQ(parameter(camera.model, "w"), 0.9125);
}

TEST(FastLivo, AFileOfRos2IsReadAndEditedWhereItStands) {
  const std::string bytes = good("dialect/ros2.yaml");
  EXPECT_EQ(parameter(rig_of(bytes).cameras.front().model, "fy"), 536.625);
  EXPECT_EQ(with_change(bytes, [](Rig&) {}), bytes);
  EXPECT_EQ(with_change(bytes, [](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras.front().model, "k1", -0.25)); }),
            with_replaced(bytes, "-0.35625", "-0.25"));
}

TEST(FastLivo, AnEditKeepsEveryOtherByte) {
  const std::string bytes = good("good/pinhole.yaml");
  EXPECT_EQ(with_change(bytes, [](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras.front().model, "cx", 630.25)); }),
            with_replaced(bytes, "cam_cx: 626.875", "cam_cx: 630.25"));
  const std::string atan = good("good/atan.yaml");
  EXPECT_EQ(with_change(atan, [](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras.front().model, "fx", 376.0)); }),
            with_replaced(atan, "cam_fx: 0.5125", "cam_fx: 0.5"));
}

// The program goes by the first coefficient alone.
TEST(FastLivo, AFirstCoefficientOfZeroDropsAll) {
  const std::string bytes = read_file(testdata_dir() / "fast-livo" / "bad" / "k1-nearly-zero.yaml");
  const consumers::ConsumerView view = view_of(bytes);
  ASSERT_TRUE(view.loads());
  EXPECT_TRUE(view.cameras.front().misread);
  ASSERT_EQ(view.warnings.size(), 1U);
  EXPECT_EQ(view.warnings.front().facts.code, Code::kFastLivoSaysNoDistortion);
  const std::optional<std::array<double, 2>> pixel = view.cameras.front().project({0.4, 0.0, 1.0});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR((*pixel)[0], 0.5 * (1293.5 * 0.4 + 626.875), 1e-9);
  EXPECT_TRUE(view_of(good("good/no-distortion.yaml")).warnings.empty());
  const std::string fisheye = read_file(testdata_dir() / "fast-livo" / "bad" / "equidistant-without-k1.yaml");
  EXPECT_TRUE(view_of(fisheye).cameras.front().misread);
}

TEST(FastLivo, WhatIsWrittenIsReadBack) {
  for (const std::string id : {"radtan", "kb4", "fov", "pinhole"}) {
    SCOPED_TRACE(id);
    Rig rig = sample_rig(id, {});
    rig.cameras.resize(1);
    const std::string bytes = written_bytes(nullptr, rig);
    EXPECT_EQ(bytes.find("scale") != std::string::npos, id != "fov") << bytes;
    const Camera back = rig_of(bytes).cameras.front();
    EXPECT_EQ(back.image_size, rig.cameras.front().image_size);
    for (const char* name : {"fx", "fy", "cx", "cy"}) {
      const ParameterId each = ParameterId::find(name).value();
      EXPECT_NEAR(parameter(back.model, each).value(), parameter(rig.cameras.front().model, each).value(), 1e-12) << name;
    }
    if (id != "pinhole") {
      EXPECT_EQ(model_info(back.model).id, id);
    }
  }
}

TEST(FastLivo, FilesOfItsOtherPartsAreToldByName) {
  Parsed parsed = parse("extrin_calib:\n  Rcl: [1.0, 0.0]\n  Pcl: [0.1, 0.2, 0.3]\n", "avia.yaml");
  ASSERT_TRUE(parsed.document);
  EXPECT_FALSE(read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
  EXPECT_EQ(parsed.diagnostics.entries().front().facts.code, Code::kLooksLikeFastLivoPoses);
}

}  // namespace
}  // namespace fca::test
