// SPDX-License-Identifier: BSD-3-Clause
// Whatever number of a file is absurd, it is refused where it stands or is no fact of the rig; and whatever a rig built in code
// holds, no writer puts a number into a file that is not finite.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "text/binary.h"
#include "write_guard.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>
#include <fca/rig/limits.h>

#include <cmath>
#include <limits>

namespace fca::test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// `bytes` with the number at `place` replaced.
std::string with_number(const text::Document& document, const text::Node& place, const std::string& number) {
  text::Document edited = document;
  const bool binary = document.syntax() == text::Syntax::kBinary;
  edited.replace(place.span, binary ? text::encoded(place.tag, number) : number);
  return edited.bytes();
}

/// Is any fact of the rig so large that what follows from it may overflow?
bool holds_an_absurd_number(const Rig& rig) {
  constexpr double kLargest = 1e12;  // of a parameter (camera_model.cc); of noise and rates it is less
  if (!validate(rig).empty()) return true;
  for (const Camera& camera : rig.cameras) {
    if (!validate(camera.model).empty() || camera.frame_rate_hz.value_or(0.0) > kLargest) return true;
  }
  for (const Imu& imu : rig.imus) {
    for (const auto& value : {imu.gyroscope_noise_density, imu.gyroscope_random_walk, imu.accelerometer_noise_density,
                              imu.accelerometer_random_walk, imu.rate_hz}) {
      if (value.value_or(0.0) > kLargest) return true;
    }
  }
  return false;
}

class HugeNumbers : public testing::TestWithParam<fs::path> {};

TEST_P(HugeNumbers, AreRefusedAtTheirPlaceOrAreNoFacts) {
  const std::string name = GetParam().filename().string();
  const text::Document document = document_of(read_file(GetParam()), name);
  int refused = 0;
  if (has_numbers_inside_words(document)) GTEST_SKIP() << "no word is a number";
  for (const text::Node* scalar : scalars_of(document)) {
    if (scalar->quoted || !text::parse_real(scalar->value)) continue;
    for (const char* number : {"1e308", "-1e308", "1e30"}) {
      Parsed parsed = parse(with_number(document, *scalar, number), name);
      if (!parsed.document) continue;
      const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
      if (calibration) {
        EXPECT_FALSE(holds_an_absurd_number(calibration->rig)) << number << " for the number at byte " << scalar->span.offset;
        continue;
      }
      ++refused;
      ASSERT_FALSE(parsed.diagnostics.entries().empty());
      EXPECT_FALSE(parsed.diagnostics.entries().back().where.file.empty()) << parsed.rendered();
    }
  }
  EXPECT_GT(refused, 10);
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename().string() + "_" + info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, HugeNumbers, testing::ValuesIn(files_of_all_formats("good")), test_name);

TEST(WriteGuard, NoFormatWritesANumberThatIsNotFinite) {
  const std::vector<std::pair<const char*, void (*)(Rig&)>> faults = {
      {"parameter", [](Rig& rig) { set_parameter(rig.cameras[0].model, "cx", kNan); }},
      {"translation", [](Rig& rig) { rig.poses[0].T_a_b(1, 3) = kInf; }},
      {"rotation", [](Rig& rig) { rig.poses[0].T_a_b(2, 0) = kNan; }},
      {"far", [](Rig& rig) { rig.poses[0].T_a_b(0, 3) = 1e30; }},
      {"noise", [](Rig& rig) { rig.imus[0].gyroscope_noise_density = kInf; }},
      {"rate", [](Rig& rig) { rig.cameras[0].frame_rate_hz = kNan; }},
      {"offset", [](Rig& rig) { rig.cameras[0].time_offset_s = kNan; }},
      {"baseline", [](Rig& rig) { rig.baseline_m = kInf; }},
  };
  for (const Format& format : written_formats()) {
    for (const auto& [what, spoil] : faults) {
      Rig rig = sample_rig("kb4", {true, true});
      spoil(rig);
      Diagnostics diagnostics;
      EXPECT_FALSE(format.write(nullptr, rig, {}, diagnostics)) << format.id << " " << what;
      ASSERT_FALSE(diagnostics.entries().empty()) << format.id << " " << what;
      EXPECT_EQ(id_of(diagnostics.entries().front()), "out-of-range") << message_of(diagnostics.entries().front());
    }
  }
}

/// A settings file that says so of its baseline.
text::Document settings_with(const std::string& baseline) {
  return document_of("%YAML:1.0\nCamera.fx: 435.25\nCamera.bf: " + baseline + "\n");
}

TEST(WriteGuard, NothingIsWrittenThatIsNotANumber) {
  for (const char* word : {".inf", "-.inf", ".nan", ".Inf"}) {
    Written written;
    written.files.push_back({settings_with(word), {}, {}});
    Diagnostics diagnostics;
    EXPECT_FALSE(holds_finite_numbers(written, nullptr, diagnostics)) << word;
    ASSERT_EQ(diagnostics.entries().size(), 1U);
    EXPECT_EQ(diagnostics.entries().front().facts, (Message{Code::kNumberWouldNotBeFinite, {"Camera.bf", "file.yaml"}}));
  }
}

TEST(WriteGuard, EditsAreRead) {
  const text::Document base = settings_with("47.9");
  text::Document edited = base;
  edited.replace(at(base, "Camera.bf").span, ".inf");
  Written written;
  written.files.push_back({edited, {}, {}});
  Diagnostics diagnostics;
  EXPECT_FALSE(holds_finite_numbers(written, &base, diagnostics));
}

// What nobody asked to change is the file's own affair.
TEST(WriteGuard, AWordOfTheBaseStaysWhereItIs) {
  const std::string bytes = with_replaced(read_file(testdata_dir() / "orbslam3/good/v1-pinhole.yaml"), "Viewer.PointSize: 2.0",
                                          "Viewer.PointSize: .inf");
  const Calibration calibration = calibration_of(bytes);
  Diagnostics diagnostics;
  const std::optional<Written> kept =
      calibration.format->write(&calibration.documents.front(), calibration.rig, {}, diagnostics);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->files.front().document.bytes(), bytes);
}

}  // namespace
}  // namespace fca::test
