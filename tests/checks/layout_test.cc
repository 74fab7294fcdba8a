// SPDX-License-Identifier: BSD-3-Clause
// One layout for PyYAML and OpenCV's reader: fixed for the other program a chain loads there, and says what it said.
#include "check_files.h"
#include "id_and_arguments.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

#include <cstdio>

namespace fca::test {
namespace {

std::vector<fs::path> chains() {
  std::vector<fs::path> files = files_in(testdata_dir() / "kalibr" / "good");
  if (!has_corpus()) return files;
  for (const char* folder : {"kalibr", "tumvi"}) {
    const std::vector<fs::path> found = files_in(shared_dir() / "corpus" / folder);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

/// Without blanks, quotes and the first lines: what a fix of the layout may not change.
std::string letters(std::string_view bytes) {
  std::string result;
  for (const char c : bytes) {
    if (std::string_view(" \r\n\"").find(c) == std::string_view::npos) result += c;
  }
  for (const std::string_view header : {"%YAML1.2---", "%YAML1.2", "---"}) {
    if (result.starts_with(header)) return result.substr(header.size());
  }
  return result;
}

bool is_of_opencv(const std::string& bytes) { return bytes.starts_with("%YAML:"); }

// What OpenVINS could use of Kalibr's own files it can read afterwards: two coefficients of its lenses, a pose per camera.
TEST(Layout, KalibrsFilesForOpenVins) {
  const consumers::Consumer* openvins = consumers::find_consumer("openvins");
  int fixed_files = 0;
  for (const fs::path& path : chains()) {
    const text::Source source{path.filename().string(), read_file(path)};
    const std::optional<Rig> before = rig_of(source, find_format("kalibr"));
    if (!before || before->cameras.empty() || is_of_opencv(source.bytes)) continue;
    CheckOptions options;
    options.program = openvins;
    const std::optional<text::Source> after = fixed_source(source, options);
    if (!after) continue;
    EXPECT_EQ(rig_of(*after, find_format("kalibr")), before) << source.name;
    const consumers::ConsumerView view = openvins->load(after->bytes, {});
    for (const consumers::Complaint& refusal : view.refusals) {
      // No fix can give a camera a pose, or four coefficients to a lens without.
      const bool of_the_rig = refusal.facts.code == Code::kOpenVinsSaysPoseMissing ||
                              is_said_of(refusal.facts, Code::kOpenVinsSaysTooFewNumbers, {4});
      EXPECT_TRUE(of_the_rig) << source.name << ": " << sentence_of(refusal);
    }
    fixed_files += view.loads() ? 1 : 0;
  }
  std::printf("%d chains loaded by OpenVINS after the fix\n", fixed_files);
  EXPECT_GE(fixed_files, has_corpus() ? 30 : 1);
}

TEST(Layout, OpenVinsChainsForKalibr) {
  const consumers::Consumer* kalibr = consumers::find_consumer("kalibr");
  int fixed_files = 0;
  for (const fs::path& path : chains()) {
    const text::Source source{path.filename().string(), read_file(path)};
    const std::optional<Rig> before = rig_of(source, find_format("kalibr"));
    if (!before || before->cameras.empty() || !is_of_opencv(source.bytes)) continue;
    CheckOptions options;
    options.from = find_format("kalibr");
    const std::optional<text::Source> after = fixed_source(source, options);
    ASSERT_TRUE(after) << source.name;
    EXPECT_EQ(rig_of(*after, find_format("kalibr")), before) << source.name;
    const consumers::ConsumerView view = kalibr->load(after->bytes, {});
    EXPECT_TRUE(view.loads()) << source.name << ": " << sentence_of(view.refusals.front());
    ++fixed_files;
  }
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  EXPECT_GE(fixed_files, 10);
}

constexpr std::string_view kChain =
    "cam0:\n  T_cam_imu:\n  - [1.0, 0.0, 0.0, 0.0]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, "
    "1.0]\n"
    "  camera_model: pinhole\n  distortion_coeffs: [0.1, 0.0, 0.0, 0.0]\n  distortion_model: equidistant # a fisheye\n"
    "  intrinsics: [200.0, 200.0, 320.0, 240.0]\n  resolution: [640, 480]\n  rostopic: /cam0\n";

// OpenCV's reader takes an unquoted word up to the end of its line: with the comment it is not equidistant.
TEST(Layout, ACommentMakesAFisheyeRadialTangential) {
  CheckOptions options;
  options.program = consumers::find_consumer("openvins");
  for (const std::string& line_break : {std::string("\n"), std::string("\r\n")}) {
    for (const std::string& mark : {std::string(), std::string("\xEF\xBB\xBF")}) {
      std::string bytes = mark;
      for (const char c : kChain) bytes += c == '\n' ? line_break : std::string(1, c);
      const text::Source source{"camchain.yaml", bytes};
      const std::optional<text::Source> after = fixed_source(source, options);
      ASSERT_TRUE(after);
      EXPECT_NE(after->bytes.find("distortion_model: \"equidistant\" # a fisheye"), std::string::npos) << after->bytes;
      EXPECT_EQ(letters(after->bytes), letters(bytes.substr(mark.size())));
      EXPECT_EQ(rig_of(*after, find_format("kalibr")), rig_of(source, find_format("kalibr")));
      const consumers::ConsumerView view = options.program->load(after->bytes, {});
      EXPECT_TRUE(view.loads() && view.warnings.empty());
    }
  }
}

// A fix is one only if the program's complaint is gone, not if it names another line.
TEST(Layout, WhatNoLayoutFixesIsLeftAlone) {
  CheckOptions options;
  options.program = consumers::find_consumer("kalibr");
  // A TAB within a word may be meant.
  EXPECT_FALSE(
      fixed_source({"camchain.yaml", with_replaced(std::string(kChain), "rostopic: /cam0", "rostopic: /cam\t0")}, options));
  // A header in the midst: which half is the file?
  options.program = consumers::find_consumer("openvins");
  EXPECT_FALSE(fixed_source({"camchain.yaml", "more: 1\n%YAML:1.0\n" + std::string(kChain)}, options));
}

// Nothing but comments before: the header goes to the top, and the comments stay.
TEST(Layout, AHeaderBehindCommentsIsMoved) {
  CheckOptions options;
  options.program = consumers::find_consumer("openvins");
  for (const std::string& line_break : {std::string("\n"), std::string("\r\n")}) {
    for (const std::string& mark : {std::string(), std::string("\xEF\xBB\xBF")}) {
      std::string bytes = mark;
      for (const char c : "# mine\n\n%YAML:1.0\n" + std::string(kChain)) bytes += c == '\n' ? line_break : std::string(1, c);
      const text::Source source{"camchain.yaml", bytes};
      const std::optional<text::Source> after = fixed_source(source, options);
      ASSERT_TRUE(after);
      EXPECT_TRUE(after->bytes.starts_with("%YAML:1.0" + line_break + "# mine" + line_break)) << after->bytes;
      EXPECT_EQ(after->bytes.find("%YAML", 1), std::string::npos);
      EXPECT_EQ(rig_of(*after, find_format("kalibr")), rig_of(source, find_format("kalibr")));
      EXPECT_TRUE(options.program->load(after->bytes, {}).loads());
    }
  }
}

TEST(Layout, AByteOrderMarkIsTakenAway) {
  CheckOptions options;
  for (const char* name : {"clean-settings.yaml", "clean.yml", "clean.json"}) {
    const std::string bytes = read_file(fs::path(FCA_TESTDATA_DIR) / "checks" / name);
    const text::Source source{name, "\xEF\xBB\xBF" + bytes};
    const CheckReport report = checked(source);
    ASSERT_TRUE(report.has(Severity::kError)) << name;
    EXPECT_EQ(line_of(report.findings.front(), source), "1:1 error byte-order-mark");
    const std::optional<text::Source> after = fixed_source(source, {});
    ASSERT_TRUE(after) << name;
    EXPECT_EQ(after->bytes, bytes);
  }
}

// OpenVINS never looks at camera_model.
TEST(Layout, AnotherModelIsAnErrorForOpenVins) {
  std::string bytes = "%YAML:1.0\n" + std::string(kChain);
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\n  - [", "\n    - ["},
                                 {"pinhole", "omni"},
                                 {"[200.0,", "[1.5, 200.0,"},
                                 {"equidistant # a fisheye", "radtan"}}) {
    for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size()))
      bytes.replace(at, from.size(), to);
  }
  CheckOptions options;
  options.program = consumers::find_consumer("openvins");
  const text::Source source{"camchain.yaml", bytes};
  const CheckReport report = checked(source, options);
  ASSERT_TRUE(report.has(Severity::kError));
  EXPECT_EQ(line_of(report.findings.front(), source), "8:17 error unknown-model");
}

}  // namespace
}  // namespace fca::test
