// SPDX-License-Identifier: BSD-3-Clause
// The verdict by what it is decided from: numbers at both sides of each limit, lost facts, made-up values, acceptances.
#include "losses.h"

#include <fca/code.h>
#include <fca/formats/verdict.h>
#include <fca/formats/verdict_limits.h>
#include <fca/formats/wording.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fca {
namespace {

PixelDistance distance(double rms, double p99, double no_rays = 0.0) {
  return {.rms = rms, .p99 = p99, .max = 100.0, .region = 1.0, .no_rays = no_rays};
}

ProofResult proof_of(const PixelDistance& in_circle, const PixelDistance& in_image, bool is_wide) {
  ProofResult proof;
  proof.program = "PROGRAM";
  proof.loads = proof.pixels_agree = proof.poses_agree = true;
  CameraProof camera;
  camera.name = "cam0";
  camera.distance = {in_circle, in_image, is_wide};
  proof.cameras = {camera};
  return proof;
}

VerdictWord word_of(const ProofResult& proof) {
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  facts.proofs = std::span(&proof, 1);
  return decide(facts).word;
}

VerdictWord decided(const PixelDistance& all) { return word_of(proof_of(all, all, false)); }

TEST(Verdict, PixelsDecideByTheirRmsAndTheirNinetyNinthPercentile) {
  const auto [ready, care] = kVerdictRmsPx;
  const auto [p99_ready, p99_care] = kVerdictP99Px;
  constexpr double kMore = 1.001;
  EXPECT_EQ(decided(distance(ready, p99_ready)), VerdictWord::kReady) << "whatever the worst pixel";
  EXPECT_EQ(decided(distance(kMore * ready, 0.5 * p99_ready)), VerdictWord::kUseWithCare);
  EXPECT_EQ(decided(distance(0.5 * ready, kMore * p99_ready)), VerdictWord::kUseWithCare);
  EXPECT_EQ(decided(distance(care, p99_care)), VerdictWord::kUseWithCare);
  EXPECT_EQ(decided(distance(kMore * care, 0.9 * p99_care)), VerdictWord::kDoNotUse);
  EXPECT_EQ(decided(distance(0.5 * care, kMore * p99_care)), VerdictWord::kDoNotUse);
}

TEST(Verdict, WhatHasNoRightRayCountsAsAShare) {
  EXPECT_EQ(decided(distance(0.0, 0.0, kVerdictNoRays.ready)), VerdictWord::kReady);
  EXPECT_EQ(decided(distance(0.0, 0.0, 1.1 * kVerdictNoRays.ready)), VerdictWord::kUseWithCare);
  EXPECT_EQ(decided(distance(0.0, 0.0, 1.02 * kVerdictNoRays.care)), VerdictWord::kDoNotUse);
}

TEST(Verdict, TheCornersOfAWideLensDoNotDecide) {
  EXPECT_EQ(word_of(proof_of(distance(0.0, 0.0), distance(9.0, 40.0, 0.3), true)), VerdictWord::kReady);
  EXPECT_EQ(word_of(proof_of(distance(0.0, 0.0), distance(9.0, 40.0, 0.3), false)), VerdictWord::kDoNotUse);
}

TEST(Verdict, AProgramThatRefusesIsEnough) {
  ProofResult refusing = proof_of(distance(0.0, 0.0), distance(0.0, 0.0), false);
  refusing.loads = false;
  EXPECT_EQ(word_of(refusing), VerdictWord::kDoNotUse);
  refusing.read_by = {"ANOTHER"};
  EXPECT_EQ(word_of(refusing), VerdictWord::kUseWithCare) << "whoever has the other one can use it";
  refusing.read_by.clear();
  refusing.is_first = false;
  EXPECT_EQ(word_of(refusing), VerdictWord::kUseWithCare) << "it is not written for that one";
}

TEST(Verdict, FilesForAnotherProgramNeedThat) {
  const ProofResult proof = proof_of(distance(0.0, 0.0), distance(0.0, 0.0), false);
  VerdictFacts facts;
  facts.to = find_format("orbslam3");
  facts.proofs = std::span(&proof, 1);
  EXPECT_EQ(decide(facts).word, VerdictWord::kReady);
  facts.not_for = "STOCK";
  const Verdict verdict = decide(facts);
  EXPECT_EQ(verdict.word, VerdictWord::kUseWithCare);
  ASSERT_EQ(verdict.reasons.size(), 1U);
  EXPECT_EQ(verdict.reasons.front().facts.code, Code::kVerdictNeedsProgram);
}

// 35 microseconds (OpenVINS' T265 chain) move no image by a pixel.
TEST(Verdict, ClocksOfCamerasMayDifferByATenthOfAMillisecond) {
  const ProofResult proof = proof_of(distance(0.0, 0.0), distance(0.0, 0.0), false);
  for (const auto& [behind_s, word] :
       {std::pair(3.5e-5, VerdictWord::kReady), std::pair(-3.5e-5, VerdictWord::kReady),
        std::pair(2e-3, VerdictWord::kUseWithCare), std::pair(-2e-3, VerdictWord::kUseWithCare)}) {
    Rig rig;
    rig.cameras.resize(1);
    rig.cameras.front().time_offset_s = 0.01 + behind_s;
    std::vector<Loss> losses;
    add_other_time_offsets(rig, 0.01, Message{Code::kOpenvinsChainOneOffset}, losses);
    VerdictFacts facts;
    facts.to = find_format("openvins");
    facts.proofs = std::span(&proof, 1);
    facts.losses = losses;
    EXPECT_EQ(decide(facts).word, word) << behind_s;
  }
}

// As a file that was written is told, so is one that is checked.
TEST(Verdict, AClockThatTheProgramDoesNotReadAsksForCare) {
  for (const auto& [offset_s, word] :
       {std::pair("0.010035", VerdictWord::kReady), std::pair("0.012", VerdictWord::kUseWithCare)}) {
    const std::string camera =
        "  cam_overlaps: []\n  camera_model: pinhole\n  distortion_coeffs: [0.01, 0.0, 0.0, 0.0]\n"
        "  distortion_model: equidistant\n  intrinsics: [200.0, 200.0, 255.5, 255.5]\n  resolution: [512, 512]\n"
        "  rostopic: /cam/image_raw\n  T_cam_imu:\n    - [1.0, 0.0, 0.0, 0.1]\n    - [0.0, 1.0, 0.0, 0.0]\n"
        "    - [0.0, 0.0, 1.0, 0.0]\n    - [0.0, 0.0, 0.0, 1.0]\n";
    const std::string bytes = "%YAML:1.0\n\ncam0:\n" + camera + "  timeshift_cam_imu: 0.01\ncam1:\n" + camera +
                              "  timeshift_cam_imu: " + offset_s + "\n";
    const consumers::ConsumerView view = consumers::find_consumer("openvins")->load(bytes, {});
    EXPECT_TRUE(view.loads());
    ProofResult proof = proof_of(distance(0.0, 0.0), distance(0.0, 0.0), false);
    proof.warnings = view.warnings;
    VerdictFacts facts;
    facts.to = find_format("openvins");
    facts.proofs = std::span(&proof, 1);
    EXPECT_EQ(decide(facts).word, word) << offset_s;
  }
}

// A chain that Kalibr refuses is none the better for the imu.yaml next to it.
TEST(Verdict, AnotherFileThatLoadsDoesNotExcuseARefusal) {
  ProofResult refusing = proof_of(distance(0.0, 0.0), distance(0.0, 0.0), false);
  refusing.loads = false;
  ProofResult imu;
  imu.loads = imu.without_cameras = imu.pixels_agree = imu.poses_agree = true;
  const std::vector<ProofResult> proofs = {refusing, imu};
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  facts.proofs = proofs;
  EXPECT_EQ(decide(facts).word, VerdictWord::kDoNotUse);
}

TEST(Verdict, PixelsThatDifferForNoKnownReasonAreNotUsed) {
  ProofResult proof = proof_of(distance(0.0, 0.0), distance(0.0, 0.0), false);
  CameraProof& camera = proof.cameras.front();
  camera.compared_share = 1.0;
  EXPECT_EQ(word_of(proof), VerdictWord::kReady);
  camera.agrees = false;
  EXPECT_EQ(word_of(proof), VerdictWord::kDoNotUse) << "the writer is at fault";
  camera.misread = true;
  EXPECT_EQ(word_of(proof), VerdictWord::kUseWithCare) << "the program is, and its distance counts";
}

TEST(Verdict, WithoutAProgramItIsNoMoreThanCare) {
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  EXPECT_EQ(decide(facts).word, VerdictWord::kReady);
  facts.is_asked = false;
  EXPECT_EQ(decide(facts).word, VerdictWord::kUseWithCare);
  facts.is_asked = true;
  facts.has_reader = false;
  EXPECT_EQ(decide(facts).word, VerdictWord::kUseWithCare);
}

Finding finding(Severity severity, Code code) {
  Finding result;
  result.severity = severity;
  result.facts = {code, {"cam0"}};
  return result;
}

VerdictWord word_of(const std::vector<Finding>& findings) {
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  facts.findings = findings;
  return decide(facts).word;
}

TEST(Verdict, FindingsAboutMeaningCountAndThoseAboutReadersDoNot) {
  EXPECT_EQ(word_of({finding(Severity::kError, Code::kAnyLeftHanded)}), VerdictWord::kDoNotUse);
  EXPECT_EQ(word_of({finding(Severity::kWarning, Code::kAnyLeftHanded)}), VerdictWord::kUseWithCare);
  EXPECT_EQ(word_of({finding(Severity::kNote, Code::kAnyLeftHanded)}), VerdictWord::kReady);
  EXPECT_EQ(word_of({finding(Severity::kError, Code::kDsoUnknownLens)}), VerdictWord::kReady);
}

VerdictWord word_of(const Loss& loss, const char* format, const char* mode) {
  VerdictFacts facts;
  facts.to = find_format(format);
  facts.mode = mode;
  facts.losses = std::span(&loss, 1);
  return decide(facts).word;
}

TEST(Verdict, ALossMattersToProgramsThatUseTheFact) {
  const Loss offset = lost(Code::kTimeOffsetDropped, "cam0", "timeshift_cam_imu", {0.01, "why"});
  EXPECT_EQ(word_of(offset, "orbslam3", "stereo-inertial"), VerdictWord::kUseWithCare);
  EXPECT_EQ(word_of(offset, "orbslam3", "stereo"), VerdictWord::kReady) << "nothing is compared with an IMU's clock";
  EXPECT_EQ(word_of(offset, "opencv", ""), VerdictWord::kReady);
  EXPECT_EQ(word_of(lost(Code::kTimeOffsetDropped, "cam0", "timeshift_cam_imu", {0.0, "why"}), "orbslam3", "stereo-inertial"),
            VerdictWord::kReady);
}

TEST(Verdict, WhatCorrectsAnImuMattersUnlessItChangesNothing) {
  const auto tw = [](const char* value) {
    return lost(Code::kNotCarriedValue, "imu0", "Tw", {Message{Code::kKeepTheInput}, std::string(value)});
  };
  const char* mode = "mono-inertial";
  EXPECT_EQ(word_of(tw("[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"), "orbslam3", mode), VerdictWord::kReady);
  EXPECT_EQ(word_of(tw("[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]"), "orbslam3", mode), VerdictWord::kReady);
  EXPECT_EQ(word_of(tw("[[1.01, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"), "orbslam3", mode), VerdictWord::kUseWithCare);
}

// Basalt's vectors begin with biases, which every estimator estimates itself.
TEST(Verdict, ABiasIsNoCorrection) {
  const auto lost_accel = [](const char* value) {
    return lost(Code::kNotCarriedValue, "imu0", "calib_accel_bias", {Message{Code::kKeepTheInput}, std::string(value)});
  };
  const char* mode = "mono-inertial";
  EXPECT_EQ(word_of(lost_accel("[-0.003, 0.02, 0.07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]"), "orbslam3", mode), VerdictWord::kReady);
  EXPECT_EQ(word_of(lost_accel("[-0.003, 0.02, 0.07, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0]"), "orbslam3", mode),
            VerdictWord::kUseWithCare);
}

// ORB-SLAM2's rectification of the images as the cameras take them: without it the file is for other images.
TEST(Verdict, ALostRectificationAsksForCare) {
  const Message why{Code::kKeepTheInput};
  EXPECT_EQ(word_of(lost(Code::kNotCarriedValue, "", "LEFT.R", {why, std::string("[1.0, 0.0]")}), "orbslam3", "stereo"),
            VerdictWord::kUseWithCare);
  EXPECT_EQ(word_of(lost(Code::kNotCarriedValue, "", "Viewer.R", {why, std::string("[1.0, 0.0]")}), "orbslam3", "stereo"),
            VerdictWord::kReady);
}

TEST(Verdict, WhatTheModeNeedsIsNotMadeUp) {
  const DefaultedValue pose{"T_imu_cam", "identity", true, true};
  VerdictFacts facts;
  facts.to = find_format("orbslam3");
  facts.defaults = std::span(&pose, 1);
  facts.mode = "mono";
  EXPECT_EQ(decide(facts).word, VerdictWord::kUseWithCare);
  facts.mode = "mono-inertial";
  EXPECT_EQ(decide(facts).word, VerdictWord::kDoNotUse);
}

TEST(Verdict, PosesThatContradictCountByTheirNumbers) {
  Rig rig;
  rig.cameras.resize(2);
  rig.cameras[0].name = "cam0";
  rig.cameras[1].name = "cam1";
  const auto shifted = [](double metres) { return Transform{{1, 0, 0, metres, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}; };
  const auto word = [&](double metres, const char* format) {
    rig.poses = {{"cam1", "cam0", shifted(0.1)}, {"cam1", "cam0", shifted(0.1 + metres)}};
    VerdictFacts facts;
    facts.to = find_format(format);
    facts.rig = &rig;
    return decide(facts).word;
  };
  EXPECT_EQ(word(0.0005, "kalibr"), VerdictWord::kReady);
  EXPECT_EQ(word(0.005, "kalibr"), VerdictWord::kUseWithCare);
  EXPECT_EQ(word(0.05, "kalibr"), VerdictWord::kDoNotUse);
  EXPECT_EQ(word(0.05, "ocamcalib"), VerdictWord::kReady) << "it holds no poses";
}

TEST(Verdict, AnAcceptedReasonAsksForCare) {
  const ProofResult bad = proof_of(distance(9.0, 20.0), distance(9.0, 20.0), false);
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  facts.proofs = std::span(&bad, 1);
  for (const auto& [acceptance, word] : {std::pair{Acceptance{Code::kVerdictPixelsOff, ""}, VerdictWord::kUseWithCare},
                                         {Acceptance{Code::kVerdictPixelsOff, "cam0"}, VerdictWord::kUseWithCare},
                                         {Acceptance{Code::kVerdictPixelsOff, "cam1"}, VerdictWord::kDoNotUse},
                                         {Acceptance{Code::kAnyLeftHanded, ""}, VerdictWord::kDoNotUse}}) {
    facts.accepted = std::span(&acceptance, 1);
    EXPECT_EQ(decide(facts).word, word) << info(acceptance.code).id << ":" << acceptance.camera;
  }
}

// A limit of the user's own is no opinion of the program's.
TEST(Verdict, ALimitIsNotAccepted) {
  const std::vector<Finding> findings = {finding(Severity::kError, Code::kErrorBeyondLimit)};
  const Acceptance acceptance{Code::kErrorBeyondLimit};
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  facts.findings = findings;
  facts.accepted = std::span(&acceptance, 1);
  EXPECT_EQ(decide(facts).word, VerdictWord::kDoNotUse);
}

TEST(Verdict, TheWorstReasonComesFirst) {
  const std::vector<Finding> findings = {finding(Severity::kWarning, Code::kAnyCentreOff),
                                         finding(Severity::kError, Code::kAnyLeftHanded)};
  VerdictFacts facts;
  facts.to = find_format("kalibr");
  facts.findings = findings;
  const Verdict verdict = decide(facts);
  ASSERT_EQ(verdict.reasons.size(), 2U);
  EXPECT_EQ(verdict.reasons.front().facts.code, Code::kAnyLeftHanded);
}

}  // namespace
}  // namespace fca
