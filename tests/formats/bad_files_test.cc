// SPDX-License-Identifier: BSD-3-Clause
// testdata/formats/<format>/bad: every file stands next to what is said of it, as codes and values; their words stand elsewhere
// (lib/diagnostics). Adding a file adds a test: put NAME there and run with FCA_WRITE_EXPECTED=1 to have NAME.expected
// written, then read it.
//
// A file can be bad in three ways, and NAME.expected holds them in this order:
//   3:11-15 error ID ARGUMENTS     the reader refuses or warns, of these columns (or: byte 24-31); what it proposes stands
//                                  after "->"
//   no camera: CAMERA: ID ARGUMENTS     the numbers are no camera (validate)
//   PROGRAM refuses: ID KEY ARGUMENTS     the format's own program would not load it (ask_readers; its first reason)
// How arguments are written: id_and_arguments.h.
#include "formats/test_files.h"
#include "id_and_arguments.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/wording.h>
#include <fca/models/camera_model.h>

#include <cstdlib>

namespace fca::test {
namespace {

/// Of two programs whose files have keys of their own, is it that of this file?
bool is_of_layout(const std::string& program, const text::Document& document) {
  const auto has = [&document](std::string_view key) {
    return std::ranges::any_of(document.root().entries, [key](const text::Entry& entry) { return entry.key.value == key; });
  };
  if (program == "OKVIS" || program == "OKVIS2") return (program == "OKVIS") == has("camera_params");
  return program == "maplab" || (program == "SVO" && !has("sensors"));
}

/// Is that the program which files of the format are written for?
bool is_stock(const std::string& program, const Calibration& calibration) {
  const std::string_view format = calibration.format->id;
  if (format == "dso") return program.starts_with("DSO");
  if (format == "okvis" || format == "ncamera") return is_of_layout(program, calibration.documents.front());
  if (format == "openvins" && program.starts_with("OpenVINS")) return true;
  constexpr std::array<std::string_view, 5> kWithParts = {"Kalibr", "OCamCalib", "Kimera-VIO", "cuVSLAM", "mrcal"};
  constexpr std::array<std::string_view, 9> kStock = {
      "ORB-SLAM3 V1.0", "WoodScape's projection.py", "Basalt", "VINS-Fusion", "ROS", "COLMAP", "nerfstudio", "stella_vslam",
      "FAST-LIVO2"};
  return std::ranges::find(kStock, program) != kStock.end() ||
         std::ranges::any_of(kWithParts, [&program](std::string_view begin) { return program.starts_with(begin); });
}

/// "3:11-15": where it begins and ends; "3:11" of one character, "-" of the whole file.
std::string range_of(const SourceRange& where, const text::Source& source) {
  const std::string place = place_of(where, source);
  if (where.length < 2) return place;
  if (source.is_binary()) return place + "-" + std::to_string(where.offset + where.length - 1);
  const text::Position end = source.position(where.offset + where.length - 1);
  const bool one_line = end.line == source.position(where.offset).line;
  return place + "-" + (one_line ? "" : std::to_string(end.line) + ":") + std::to_string(end.column);
}

std::string line_of(const Diagnostic& diagnostic, const text::Source& source) {
  std::string line = range_of(diagnostic.where, source) + " " + severity_word(diagnostic.severity) + " ";
  if (id_of(diagnostic) != id_of(diagnostic.facts)) line += id_of(diagnostic) + ": ";
  line += id_and_arguments(diagnostic.facts);
  return diagnostic.remedy.is_said() ? line + " -> " + id_and_arguments(diagnostic.remedy) : line;
}

std::string evaluated(const fs::path& path) {
  Parsed parsed = parse(read_file(path), path.filename().string());
  std::optional<Calibration> calibration;
  if (parsed.document) calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  std::string text;
  for (const Diagnostic& diagnostic : parsed.diagnostics.entries()) text += line_of(diagnostic, parsed.source) + "\n";
  if (!calibration) return text;
  for (const Camera& camera : calibration->rig.cameras) {
    for (const Message& problem : validate(camera.model))
      text += "no camera: " + camera.name + ": " + id_and_arguments(problem) + "\n";
  }
  const bool cameras = !calibration->rig.cameras.empty();
  const Readers readers = ask_readers(calibration->format->id, parsed.source.bytes, cameras);
  for (const Readers::Program& program : readers.programs) {
    if (!is_stock(program.program, *calibration) || program.refusals.empty()) continue;
    const consumers::Complaint& refusal = program.refusals.front();
    text += program.program + " refuses: " + id_of(refusal.facts) + " " + in_quotes_if_needed(refusal.key);
    text += id_and_arguments(refusal.facts).substr(id_of(refusal.facts).size()) + "\n";
  }
  return text;
}

class BadFiles : public testing::TestWithParam<fs::path> {};

TEST_P(BadFiles, AreEvaluatedAsExpected) {
  const fs::path expected = GetParam().string() + ".expected";
  const std::string text = evaluated(GetParam());
  if (std::getenv("FCA_WRITE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << text;
  ASSERT_TRUE(fs::exists(expected)) << "run with FCA_WRITE_EXPECTED=1 and read what it wrote:\n" << text;
  EXPECT_EQ(text, read_file(expected));
  EXPECT_FALSE(text.empty()) << "nothing is said about a bad file";
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename().string() + "_" + info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, BadFiles, testing::ValuesIn(files_of_all_formats("bad")), test_name);

TEST(BadFileFolder, HoldsEnough) {
  for (const Format& format : all_formats()) {
    if (!format.layout_of.empty()) continue;  // its files are another's
    const std::vector<fs::path> expected = files_in(testdata_dir() / format.id / "bad", ".expected");
    EXPECT_GE(expected.size(), 12U) << format.id;
    for (const fs::path& path : expected) {
      EXPECT_TRUE(fs::exists(path.parent_path() / path.stem())) << path << " explains a file that is not there";
    }
  }
}

/// Codes of what is said of bytes, warnings included.
std::string codes_of(const std::string& bytes) {
  Parsed parsed = parse(bytes);
  if (parsed.document) static_cast<void>(read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
  return parsed.codes();
}

// diagnostics.h names the code. A matrix whose 3 x 3 part scales or mirrors moves every point wrongly; the reader sees it
// first.
TEST(BadPoses, APoseThatIsNoRotationIsSaid) {
  const std::string chain = read_file(testdata_dir() / "kalibr/good/flat-transforms.yaml");
  EXPECT_EQ(codes_of(with_replaced(chain, "T_cam_imu: [0.0, 1.0", "T_cam_imu: [0.0, 3.0")), "not-a-rotation") << "scaled";
  EXPECT_EQ(codes_of(with_replaced(chain, "T_cam_imu: [0.0, 1.0", "T_cam_imu: [0.0, -1.0")), "not-a-rotation") << "mirrored";
  const std::string settings = read_file(testdata_dir() / "orbslam3/good/v1-stereo-inertial.yaml");
  EXPECT_EQ(codes_of(with_replaced(settings, "0.998899461915674", "2.998899461915674")), "not-a-rotation");
}

TEST(BadPoses, TheLastRowIsCheckedInEveryFormat) {
  const std::string settings = read_file(testdata_dir() / "orbslam3/good/v1-stereo-inertial.yaml");
  EXPECT_EQ(codes_of(with_replaced(settings, "0.0, 0.0, 0.0, 1.0 ]", "0.0, 0.0, 0.0, 2.0 ]")), "not-a-transform")
      << "Stereo.T_c1_c2";
  EXPECT_EQ(codes_of(with_replaced(settings, "0.0, 0.0, 0.0, 1.0]", "0.0, 0.0, 0.5, 1.0]")), "not-a-transform") << "IMU.T_b_c1";
}

// "Camera.type 'EUCM' is none of ..., EUCM, ..." helps nobody.
TEST(BadModels, AKnownTypeInTheWrongStyleIsNotCalledUnknown) {
  for (const char* type : {"EUCM", "DoubleSphere", "KB"}) {
    Parsed parsed = parse(with_replaced(read_file(testdata_dir() / "orbslam3/good/v1-pinhole.yaml"), "\"PinHole\"",
                                        std::string("\"") + type + "\""));
    ASSERT_TRUE(parsed.document);
    EXPECT_FALSE(read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics)) << type;
    const Message& said = parsed.diagnostics.entries().at(0).facts;
    EXPECT_EQ(said.code, Code::kOrbslam3TypeOfForks) << id_and_arguments(said);
    ASSERT_EQ(said.arguments.size(), 3U);
    EXPECT_EQ(said.arguments[0], Argument(type));
    EXPECT_FALSE(speaks_of({said.code, {said.arguments[1], said.arguments[2]}}, type)) << id_and_arguments(said);
  }
}

// The caret stands under the side that is wrong.
TEST(BadSizes, TheCaretIsUnderTheBadSide) {
  Parsed parsed = parse(
      with_replaced(read_file(testdata_dir() / "orbslam3/good/v1-pinhole.yaml"), "Camera.height: 480", "Camera.height: -480"));
  ASSERT_TRUE(parsed.document);
  EXPECT_FALSE(read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
  EXPECT_EQ(parsed.source.text({parsed.diagnostics.entries().at(0).where.offset, 4}), "-480");
}

class GoodFiles : public testing::TestWithParam<fs::path> {};

TEST_P(GoodFiles, AreReadWithoutAWord) {
  Parsed parsed = parse(read_file(GetParam()), GetParam().filename().string());
  ASSERT_TRUE(parsed.document) << parsed.rendered();
  const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  ASSERT_TRUE(calibration) << parsed.rendered();
  // What it is about is in the real texts, always.
  const bool is_of_depth = parsed.diagnostics.entries().size() == 1 &&
                           parsed.diagnostics.entries().front().facts.code == Code::kRealsenseDepthIsInfrared;
  EXPECT_TRUE(is_of_depth || parsed.diagnostics.entries().empty()) << parsed.rendered();
  EXPECT_EQ(calibration->format->id, GetParam().parent_path().parent_path().filename().string());
  for (const Camera& camera : calibration->rig.cameras) EXPECT_TRUE(validate(camera.model).empty());
}

TEST_P(GoodFiles, AreWrittenBackByteForByte) {
  const std::string bytes = read_file(GetParam());
  const Calibration calibration = calibration_of(bytes, GetParam().filename().string());
  if (!calibration.format->is_written()) GTEST_SKIP() << "only read";
  Diagnostics diagnostics;
  const std::optional<Written> written =
      calibration.format->write(&calibration.documents.front(), calibration.rig, {}, diagnostics);
  ASSERT_TRUE(written);
  ASSERT_EQ(written->files.size(), 1U);
  EXPECT_EQ(written->files.front().document.bytes(), bytes);
}

INSTANTIATE_TEST_SUITE_P(Formats, GoodFiles, testing::ValuesIn(files_of_all_formats("good")), test_name);

}  // namespace
}  // namespace fca::test
