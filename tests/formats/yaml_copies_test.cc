// SPDX-License-Identifier: BSD-3-Clause
// YAML files that hold more than their keys say. Anchors, aliases and merge keys, which PyYAML reads: a file with them means
// what the same file written out means; it comes back byte for byte, and is not edited. And parameter files of ROS 2.
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/check.h>
#include <fca/formats/proof.h>
#include <fca/formats/set_value.h>

namespace fca::test {
namespace {

constexpr const char* kAnchored = R"(common: &common
  camera_model: pinhole
  distortion_model: equidistant
  resolution: [752, 480]
cam0: &left
  <<: *common
  intrinsics: [461.5, 460.25, 366.25, 249.0]
  distortion_coeffs: &coeffs [-0.0125, 0.0575, -0.085, 0.0435]
  rostopic: /cam0/image_raw
cam1:
  <<: [*left, *common]
  distortion_coeffs: *coeffs
  rostopic: /cam1/image_raw
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)";

constexpr const char* kWrittenOut = R"(cam0:
  camera_model: pinhole
  distortion_model: equidistant
  resolution: [752, 480]
  intrinsics: [461.5, 460.25, 366.25, 249.0]
  distortion_coeffs: [-0.0125, 0.0575, -0.085, 0.0435]
  rostopic: /cam0/image_raw
cam1:
  camera_model: pinhole
  distortion_model: equidistant
  resolution: [752, 480]
  intrinsics: [461.5, 460.25, 366.25, 249.0]
  distortion_coeffs: [-0.0125, 0.0575, -0.085, 0.0435]
  rostopic: /cam1/image_raw
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)";

bool has(const Diagnostics& diagnostics, Code code) {
  return std::ranges::any_of(diagnostics.entries(), [code](const Diagnostic& each) { return each.facts.code == code; });
}

TEST(YamlAnchors, MeanWhatTheyStandFor) {
  const Rig rig = calibration_of(kAnchored).rig;
  const Rig written_out = calibration_of(kWrittenOut).rig;
  EXPECT_EQ(rig.cameras, written_out.cameras);
  EXPECT_EQ(rig.poses, written_out.poses);
}

TEST(YamlAnchors, AreReported) {
  const Parsed parsed = parse(kAnchored);
  EXPECT_TRUE(parsed.document);
  EXPECT_TRUE(has(parsed.diagnostics, Code::kYamlCopies));
  EXPECT_FALSE(parsed.diagnostics.has_errors());
}

TEST(YamlAnchors, AFileIsKeptButNotEdited) {
  const text::Document base = document_of(kAnchored);
  const Format& kalibr = *find_format("kalibr");
  Rig rig = calibration_of(kAnchored).rig;
  Diagnostics diagnostics;
  const std::optional<Written> kept = write_calibration(kalibr, &base, rig, {}, diagnostics);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->files.front().document.bytes(), kAnchored);
  ASSERT_TRUE(set_parameter(rig.cameras[1].model, "fx", 462.0));
  EXPECT_FALSE(write_calibration(kalibr, &base, rig, {}, diagnostics));
  EXPECT_TRUE(has(diagnostics, Code::kYamlCopiesNotEdited));
}

TEST(YamlAnchors, CopiesOfCopiesEnd) {
  std::string bytes = "a0: &a0 [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bytes += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int k = 1; k < 10; ++k) bytes += ", " + before;
    bytes += "]\n";
  }
  const Parsed parsed = parse(bytes);
  EXPECT_FALSE(parsed.document);
  EXPECT_TRUE(has(parsed.diagnostics, Code::kListTooLong));
}

// As PyYAML has it: of two merge keys the last one counts, of the mappings in a list the first.
TEST(YamlAnchors, MergesInPythonsOrder) {
  const text::Document document =
      document_of("a: &a {x: 400, y: 1}\nb: &b {x: 500}\nc:\n  <<: *a\n  <<: *b\nd:\n  <<: [*a, *b]\ne:\n  x: 1\n  <<: *a\n");
  EXPECT_EQ(at(document, "c/x").value, "500");
  EXPECT_EQ(at(document, "c/y").value, "1");
  EXPECT_EQ(at(document, "d/x").value, "400");
  EXPECT_EQ(at(document, "e/x").value, "1");
}

// An anchor that nothing names is no reason not to edit, and not a part of the value.
TEST(YamlAnchors, AValueBeginsBehindItsAnchorAndTag) {
  const std::string bytes = "a: &a 1.5\nb: &b \"two\"\nc: !!str \"three\"\nd: &d [4, 5]\ne: &e !!str six\n";
  const text::Document document = document_of(bytes);
  const auto spelled = [&](const char* key) { return std::string(document.source().text(at(document, key).span)); };
  EXPECT_EQ(spelled("a"), "1.5");
  EXPECT_EQ(spelled("b"), "\"two\"");
  EXPECT_EQ(spelled("c"), "\"three\"");
  EXPECT_EQ(spelled("d"), "[4, 5]");
  EXPECT_EQ(spelled("e"), "six");
}

TEST(YamlAnchors, AValueIsNotSetWhereOthersShareIt) {
  const Format& kalibr = *find_format("kalibr");
  Diagnostics diagnostics;
  const std::optional<StatedRig> stated = as_stated(kalibr, document_of(kAnchored), {}, diagnostics);
  ASSERT_TRUE(stated);
  EXPECT_FALSE(set_value(kalibr, *stated, {"cam1/rostopic", "/other"}, {}, diagnostics));
  EXPECT_TRUE(has(diagnostics, Code::kYamlCopiesNotEdited));
}

TEST(YamlAnchors, NothingIsFixedWhereValuesAreShared) {
  // An int where Kalibr wants a real number: fixed in a file without aliases.
  const std::string bytes = with_replaced(kAnchored, "461.5", "461");
  EXPECT_TRUE(
      fixed_source({"file.yaml", with_replaced(kWrittenOut,
                                               "intrinsics: [461.5, 460.25, 366.25, 249.0]\n  distortion_coeffs: "
                                               "[-0.0125, 0.0575, -0.085, 0.0435]\n  rostopic: /cam0",
                                               "intrinsics: [461, 460.25, 366.25, 249.0]\n  distortion_coeffs: [-0.0125, "
                                               "0.0575, -0.085, 0.0435]\n  rostopic: /cam0")},
                   {}));
  EXPECT_FALSE(fixed_source({"file.yaml", bytes}, {}));
}

TEST(YamlAnchors, CopiesOfALongTextEnd) {
  std::string bytes = "a: &a " + std::string(500'000, 'x') + "\nb:\n";
  for (int i = 0; i < 1000; ++i) bytes += "- *a\n";
  EXPECT_TRUE(has(parse(bytes).diagnostics, Code::kListTooLong));
}

// Parameters of a ROS 2 node are the calibration that stands in them; an edit keeps what is around them.
TEST(RosParameters, AreUnwrapped) {
  std::string wrapped = "/**:\n  ros__parameters:\n";
  for (const std::string& line : split(kWrittenOut, '\n')) wrapped += "    " + line + "\n";
  const Calibration calibration = calibration_of(wrapped);
  Rig rig = calibration.rig;
  EXPECT_EQ(rig.cameras, calibration_of(kWrittenOut).rig.cameras);
  EXPECT_TRUE(has(parse(wrapped).diagnostics, Code::kYamlRosParameters));
  const text::Document base = document_of(wrapped);
  Diagnostics diagnostics;
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "fx", 462.0));
  const std::optional<Written> written = write_calibration(*find_format("kalibr"), &base, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  const std::string edited = written->files.front().document.bytes();
  const std::size_t at = wrapped.find("461.5");
  EXPECT_EQ(edited, wrapped.substr(0, at) + "462.0" + wrapped.substr(at + 5));
}

}  // namespace
}  // namespace fca::test
