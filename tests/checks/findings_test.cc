// SPDX-License-Identifier: BSD-3-Clause
// Every defect is found at its place, and nothing else is: testdata/checks holds a file for each, and next to it what is to be
// said ("line:column severity code").
#include "check_files.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <set>

namespace fca::test {
namespace {

fs::path checks_dir() { return fs::path(FCA_TESTDATA_DIR) / "checks"; }

std::vector<fs::path> check_files() {
  std::vector<fs::path> files = files_in(checks_dir());
  std::erase_if(files, [](const fs::path& path) { return path.extension() == ".expected"; });
  return files;
}

class CheckFile : public testing::TestWithParam<fs::path> {};

TEST_P(CheckFile, SaysWhatIsExpected) {
  const text::Source source = {GetParam().filename().string(), read_file(GetParam())};
  std::string said;
  for (const Finding& finding : checked(source).findings) said += line_of(finding, source) + "\n";
  EXPECT_EQ(said, read_file(GetParam().string() + ".expected"));
}

INSTANTIATE_TEST_SUITE_P(All, CheckFile, testing::ValuesIn(check_files()), [](const auto& file) {
  std::string name = file.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST(CheckCodes, SayWhatHappens) {
  for (const CodeInfo& code : check_codes()) EXPECT_FALSE(code.consequence.empty()) << code.id;
}

TEST(CheckCodes, AreSortedByName) {
  EXPECT_GT(check_codes().size(), 100U);
  EXPECT_TRUE(std::ranges::is_sorted(check_codes(), {}, &CodeInfo::id));
  for (const CodeInfo& code : check_codes()) {
    EXPECT_EQ(find_check_code(code.id), &code) << code.id;
    EXPECT_FALSE(code.text.empty()) << code.id;
  }
  EXPECT_EQ(find_check_code("no-such-code"), nullptr);
}

// A code without a file that shows it would be untested; a code that is said and not in the table could not be explained.
TEST(CheckCodes, AreThoseThatTheFilesShow) {
  std::set<std::string> said;
  std::vector<fs::path> files = check_files();
  const std::vector<fs::path> bad = files_of_all_formats("bad");
  files.insert(files.end(), bad.begin(), bad.end());
  for (const fs::path& path : files) {
    for (const Finding& finding : checked(path).findings) {
      said.insert(id_of(finding));
      EXPECT_NE(find_check_code(id_of(finding)), nullptr) << id_of(finding) << " of " << path;
    }
  }
  for (const CodeInfo& code : check_codes()) {
    const std::string name(code.id);
    const bool larger_than_the_repository = name == "too-large" || name == "too-long";
    EXPECT_NE(said.contains(name), is_of_no_file(name) || larger_than_the_repository) << name;
  }
}

// What is wrong, what happens, how to fix it: a finding is no use without all three.
TEST(CheckFindings, SayWhatHappensAndWhatToDo) {
  std::vector<fs::path> files = check_files();
  const std::vector<fs::path> bad = files_of_all_formats("bad");
  files.insert(files.end(), bad.begin(), bad.end());
  for (const fs::path& path : files) {
    for (const Finding& finding : checked(path).findings) {
      EXPECT_FALSE(message_of(finding).empty()) << id_of(finding);
      EXPECT_FALSE(consequence_of(finding).empty()) << id_of(finding) << " of " << path;
      EXPECT_TRUE(!fix_of(finding).empty() || finding.severity == Severity::kNote) << id_of(finding) << " of " << path;
    }
  }
}

TEST(CheckFindings, ACleanFileSaysWhatWasCheckedAndWhatCouldNotBe) {
  const CheckReport chain = checked(checks_dir() / "clean-pair.yaml");
  EXPECT_TRUE(chain.findings.empty());
  EXPECT_GE(chain.checked.size(), 6U);
  text::Source source = {"no-size.yml", read_file(checks_dir() / "clean.yml")};
  source.bytes = with_replaced(with_replaced(source.bytes, "image_width: 752\n", ""), "image_height: 480\n", "");
  const CheckReport without_size = checked(source);
  ASSERT_EQ(without_size.undecided.size(), 1U);
  EXPECT_EQ(without_size.undecided.front().facts.code, Code::kImageNotEvaluated);
  CheckOptions options;
  options.reading.image_size = ImageSize{752, 480};
  EXPECT_TRUE(checked(source, options).undecided.empty());
}

TEST(CheckFindings, NameTheProgramTheyAreFor) {
  CheckOptions options;
  options.program = consumers::find_consumer("orbslam3");
  ASSERT_NE(options.program, nullptr);
  EXPECT_TRUE(says(checked(checks_dir() / "clean.yaml", options), "program-other-format"));
  // ORB-SLAM2's own file: right by itself, refused where ORB-SLAM3 is to read it.
  const fs::path orbslam2 = checks_dir() / "read-by-another.yaml";
  EXPECT_FALSE(checked(orbslam2).has(Severity::kError));
  EXPECT_TRUE(checked(orbslam2, options).has(Severity::kError));
  options.program = consumers::find_consumer("orbslam2");
  EXPECT_TRUE(checked(orbslam2, options).findings.empty());
}

TEST(CheckFindings, AnAmbiguousVectorShowsBothFieldsOfView) {
  const CheckReport report = checked(checks_dir() / "ambiguous-model.yml");
  ASSERT_EQ(report.findings.size(), 1U);
  // f = 458.6 px of 752: atan(367.2 / f) + atan(383.8 / f) = 78.6 deg without distortion, more with a barrel's.
  const std::vector<Message>& readings = report.findings.front().details;
  ASSERT_EQ(readings.size(), 2U);
  const std::pair<const char*, double> expected[] = {{"pinhole", 92.72}, {"fisheye", 120.2}};
  for (std::size_t i = 0; i < readings.size(); ++i) {
    ASSERT_EQ(readings[i].code, Code::kAsLensView) << message_of(report.findings.front());
    EXPECT_EQ(readings[i].arguments[0], Argument(expected[i].first));
    EXPECT_NEAR(std::get<double>(readings[i].arguments[1].value), expected[i].second, 0.05);
  }
}

// Whichever poses of a loop are in millimetres: each is told once, and the others are right.
TEST(CheckFindings, MillimetresAreToldOncePerPose) {
  const std::string good = read_file(checks_dir() / "clean-pair.yaml");
  // The translations of cam0, of cam1 and of the one to the other, by lines.
  const std::vector<std::vector<int>> poses = {{4, 5, 6}, {18, 19, 20}, {23, 24, 25}};
  for (unsigned wrong = 1; wrong < 8; ++wrong) {
    std::string bytes;
    std::set<int> lines;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if ((wrong >> i & 1U) != 0) lines.insert(poses[i].begin(), poses[i].end());
    }
    int number = 0;
    for (std::string line : split(good, '\n')) {
      const std::size_t comma = line.rfind(", ");
      if (lines.contains(++number)) {
        line = line.substr(0, comma + 2) + text::format_real(1000.0 * std::stod(line.substr(comma + 2))) + "]";
      }
      bytes += line + "\n";
    }
    const CheckReport report = checked({"pair.yaml", bytes});
    EXPECT_EQ(report.findings.size(), lines.size() / 3) << wrong;
    for (const Finding& finding : report.findings) {
      EXPECT_EQ(id_of(finding), "translation-in-mm");
      EXPECT_TRUE(finding.facts.code == Code::kPoseInMillimetres || finding.facts.code == Code::kTranslationInMillimetres)
          << message_of(finding);
    }
  }
}

// Camera.bf is not the metres' contradiction besides.
TEST(CheckFindings, MillimetresOfASecondCameraAreToldOnce) {
  const std::string good = read_file(testdata_dir() / "orbslam3" / "good" / "slam-no-opt-pair.yaml");
  const std::size_t at = good.find("CAMERA.T");
  ASSERT_NE(at, std::string::npos);
  const std::size_t begin = good.find('[', at) + 1;
  const std::size_t end = good.find(']', begin);
  std::string numbers;
  for (const std::string& number : split(good.substr(begin, end - begin), ','))
    numbers += (numbers.empty() ? "" : ", ") + text::format_real(1000.0 * std::stod(number));
  const CheckReport report = checked({"pair.yaml", good.substr(0, begin) + numbers + good.substr(end)});
  EXPECT_TRUE(says(report, "translation-in-mm"));
  EXPECT_FALSE(says(report, "baseline-contradicts"));
}

// 2.3e-3 is a density made larger for SLAM, or one sample's deviation at 200 Hz.
TEST(CheckFindings, NoiseThatMayBeEitherIsNotDecided) {
  const std::string good = read_file(checks_dir() / "clean-imu.yaml");
  EXPECT_TRUE(checked({"imu.yaml", good}).undecided.empty());
  const CheckReport report =
      checked({"imu.yaml", with_replaced(good, "gyroscope_noise_density: 0.00016", "gyroscope_noise_density: 0.0023")});
  EXPECT_TRUE(report.findings.empty());
  ASSERT_EQ(report.undecided.size(), 1U);
  const Message& question = report.undecided.front().facts;
  ASSERT_EQ(question.code, Code::kImuNoiseOfUnknownKind);
  EXPECT_NEAR(std::get<double>(question.arguments.back().value), 0.000163, 5e-7);
}

TEST(CheckFindings, AThresholdBelowZeroIsNotToBeDivided) {
  const std::string good = read_file(checks_dir() / "clean-settings.yaml");
  const CheckReport report = checked({"settings.yaml", with_replaced(good, "ThDepth: 40.0", "ThDepth: -40.0")});
  const auto found =
      std::ranges::find(report.findings, "depth-threshold", [](const Finding& finding) { return id_of(finding); });
  ASSERT_NE(found, report.findings.end());
  EXPECT_EQ(found->facts, (Message{Code::kDepthThresholdNegative, {"Stereo.ThDepth", -40.0, 40.0}})) << fix_of(*found);
}

TEST(CheckFindings, OfAnImuNameNoCamera) {
  for (const char* name : {"not-positive.yaml", "program-refuses.yaml"}) {
    for (const Finding& finding : checked(checks_dir() / name).findings)
      EXPECT_EQ(consequence_of(finding).find("camera"), std::string::npos) << consequence_of(finding);
  }
}

// What lies beyond --max-angle is not lens: a fold there is nobody's affair.
TEST(CheckFindings, FoldsBeyondTheLensAreNotSaid) {
  CheckOptions options;
  options.max_angle_rad = 0.7;  // 40.1 deg; the fold is at 43.1
  EXPECT_FALSE(says(checked(checks_dir() / "folds-inside-image.yaml", options), "folds-inside-image"));
  options.max_angle_rad = 0.8;
  EXPECT_TRUE(says(checked(checks_dir() / "folds-inside-image.yaml", options), "folds-inside-image"));
}

}  // namespace
}  // namespace fca::test
