// SPDX-License-Identifier: BSD-3-Clause
// show, convert and check name the same contradicting poses of a rig, all of them and each once, and weigh them alike.
#include "cli/message_facts.h"
#include "cli/run_program.h"

#include <fca/code.h>
#include <fca/fca.h>
#include <fca/rig/contradictions.h>

#include <string>
#include <vector>

namespace fca::test {
namespace {

using Names = std::vector<std::string>;

/// A file and the poses that are wrong, or without blame the last of each loop.
struct Case {
  std::string file;
  Names wrong;
  Severity severity = Severity::kError;
  bool is_decided = false;  ///< A rule tells which pose is wrong, and a fresh file does without it.
};

const std::vector<Case> kCases = {
    {"poses-contradict-thrice.yaml", {"T_cam1_imu0", "T_cam2_imu0", "T_cam3_imu0"}},
    {"poses-contradict-no-rotation.yaml", {"T_cam1_imu0"}},
    {"poses-contradict-slightly.yaml", {"T_cam1_imu0"}, Severity::kWarning},
    {"pose-inverted-of-pair.yaml", {"T_cam1_cam0"}, Severity::kError, true},
    {"pose-inverted-to-imu.yaml", {"T_cam1_imu0"}},
    {"pose-inverted-somewhere.yaml", {"T_cam1_imu0"}},
};

/// The pose that a message about a contradiction names.
std::string pose_in(const Message& message) {
  const bool has_frames = message.code == Code::kPoseContradictsOthers || message.code == Code::kVerdictPosesContradict;
  const std::string first = argument<std::string>(message, 0);
  return has_frames ? "T_" + first + "_" + argument<std::string>(message, 1) : first;
}

VerdictWord word_for(Severity severity) {
  return severity == Severity::kError ? VerdictWord::kDoNotUse : VerdictWord::kUseWithCare;
}

/// The poses that diagnostics or findings name.
template <class Entries>
Names named_in(const Entries& entries) {
  Names names;
  for (const auto& entry : entries) {
    if (reports_contradiction(code_of(entry))) names.push_back(pose_in(entry.facts));
  }
  return names;
}

/// The poses that a verdict names, each with that word.
Names named_in(const Verdict& verdict, VerdictWord word) {
  Names names;
  for (const Reason& reason : verdict.reasons) {
    if (!reports_contradiction(reason.facts.code)) continue;
    names.push_back(pose_in(reason.facts));
    EXPECT_EQ(reason.word, word) << names.back();
  }
  return names;
}

Inputs inputs_of(const Case& each) {
  Inputs inputs;
  inputs.files = {testdata("checks/" + each.file)};
  return inputs;
}

ConvertResult converted(const Case& each, const char* format) {
  ConvertRequest request;
  request.inputs = inputs_of(each);
  request.to = find_format(format);
  Files files;
  return convert(request, files);
}

TEST(Contradictions, ShowNamesThem) {
  for (const Case& each : kCases) {
    SCOPED_TRACE(each.file);
    Files files;
    const Reading reading = read({inputs_of(each), consumers::find_consumer("kalibr")}, files);
    EXPECT_EQ(named_in(reading.diagnostics.entries()), each.wrong);
    ASSERT_TRUE(reading.asked);
    EXPECT_EQ(named_in(reading.asked->modes.front().verdict, word_for(each.severity)), each.wrong);
  }
}

TEST(Contradictions, CheckNamesThem) {
  for (const Case& each : kCases) {
    SCOPED_TRACE(each.file);
    const std::string path = testdata("checks/" + each.file);
    Files files;
    const CheckResult result = check({inputs_of(each), nullptr, {}}, text::Source{path, read_file(path)}, files);
    EXPECT_EQ(named_in(result.report.findings), each.wrong);
    for (const Finding& finding : result.report.findings) {
      if (reports_contradiction(code_of(finding))) {
        EXPECT_EQ(finding.severity, each.severity);
      }
    }
    EXPECT_EQ(named_in(result.report.verdict, word_for(each.severity)), each.wrong);
  }
}

// An edited file specifies all that it did.
TEST(Contradictions, AConversionWithinTheFormatNamesThem) {
  for (const Case& each : kCases) {
    SCOPED_TRACE(each.file);
    const ConvertResult result = converted(each, "kalibr");
    EXPECT_EQ(named_in(result.diagnostics.entries()), each.wrong);
    EXPECT_EQ(named_in(result.verdict, word_for(each.severity)), each.wrong);
  }
}

// A fresh file does without a pose of which a rule tells that it is wrong: the verdict says so in place of the reader.
TEST(Contradictions, AConversionToAnotherFormatNamesThem) {
  for (const Case& each : kCases) {
    for (const char* format : {"openvins", "basalt"}) {
      SCOPED_TRACE(each.file + " " + format);
      const ConvertResult result = converted(each, format);
      EXPECT_EQ(named_in(result.diagnostics.entries()), each.is_decided ? Names() : each.wrong);
      const VerdictWord word = each.is_decided ? VerdictWord::kUseWithCare : word_for(each.severity);
      EXPECT_EQ(named_in(result.verdict, word), each.wrong);
    }
  }
}

// Two statements of one pose: which one is in the files decides whether these are wrong.
TEST(Contradictions, AConversionSaysWhichStatementTheFilesHave) {
  struct Expected {
    const char* file;
    const char* format;
    Code addition;
    VerdictWord word;
  };
  for (const Expected& each : {
           Expected{"poses-contradict.yaml", "openvins", Code::kPoseWrittenAsGiven, VerdictWord::kDoNotUse},
           Expected{"poses-contradict.yaml", "kalibr", Code::kPosesWrittenBoth, VerdictWord::kDoNotUse},
           Expected{"poses-contradict.yaml", "orbslam3", Code::kPoseWrittenAsGiven, VerdictWord::kDoNotUse},
           Expected{"pose-inverted-of-three.yaml", "openvins", Code::kPoseWrittenAsDerived, VerdictWord::kUseWithCare},
           Expected{"pose-inverted-of-three.yaml", "kalibr", Code::kPosesWrittenBoth, VerdictWord::kDoNotUse},
       }) {
    SCOPED_TRACE(std::string(each.file) + " " + each.format);
    const ConvertResult result = converted({each.file, {}}, each.format);
    const auto reason =
        std::ranges::find_if(result.verdict.reasons, [](const Reason& one) { return one.addition.code != Code::kNone; });
    ASSERT_NE(reason, result.verdict.reasons.end());
    EXPECT_EQ(reason->addition.code, each.addition);
    EXPECT_EQ(reason->word, each.word);
  }
}

// ROS' stereo matching looks along rows; other programs take such a pair as it is.
TEST(Verdict, OneCameraAboveTheOtherConcernsRosAlone) {
  const Case lower = {"ros-one-above-the-other.yaml", {}};
  const auto is_of_rows = [](const Reason& reason) { return same_id(reason.facts.code, Code::kAnyStereoVertical); };
  EXPECT_TRUE(std::ranges::none_of(converted(lower, "kalibr").verdict.reasons, is_of_rows));
  EXPECT_TRUE(std::ranges::any_of(converted(lower, "ros").verdict.reasons, is_of_rows));
}

}  // namespace
}  // namespace fca::test
