// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/verdict.h>
#include <fca/formats/verdict_limits.h>

#include "pose_words.h"
#include "verdict_pairs.h"
#include "written_facts.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace fca {

namespace {

VerdictWord word_of(double value, const VerdictLimits& limits) {
  if (value <= limits.ready) return VerdictWord::kReady;
  return value <= limits.care ? VerdictWord::kUseWithCare : VerdictWord::kDoNotUse;
}

VerdictWord word_of(Severity severity) {
  return severity == Severity::kError ? VerdictWord::kDoNotUse : VerdictWord::kUseWithCare;
}

VerdictWord worse(VerdictWord a, VerdictWord b) { return std::max(a, b); }

/// A program whose files those are not in the first place needs to be that one: no more than care.
VerdictWord weighed(VerdictWord word, bool is_first) { return is_first ? word : std::min(word, VerdictWord::kUseWithCare); }

/// What the program does with the numbers of a camera that it misreads.
std::vector<Message> causes_of(const CameraProof& camera, const ProofResult& proof) {
  std::vector<Message> causes;
  for (const consumers::Complaint& warning : proof.warnings) {
    if (camera.misread) causes.push_back({Code::kVerdictCause, {warning.facts}});
  }
  return causes;
}

/// Where the program's rays end.
std::vector<Message> why_no_rays(const ProofResult& proof) {
  if (!proof.wrong_ray_why.is_said()) return {};
  return {Message{Code::kVerdictCause, {proof.wrong_ray_why}}};
}

/// What the calibration does not know itself needs no care: an rms below its own uncertainty, and a 99th percentile below what
/// is that of the distance of such pixels. An error that is too much for any use stays one.
VerdictWord word_of(const PixelDistance& distance, double own_rms_px) {
  constexpr double kP99OfSigmas = 3.035;  // of the distance in two dimensions
  const auto raised = [](const VerdictLimits& limits, double own) {
    return VerdictLimits{std::clamp(own, limits.ready, limits.care), limits.care};
  };
  return worse(word_of(distance.rms, raised(kVerdictRmsPx, own_rms_px)),
               word_of(distance.p99, raised(kVerdictP99Px, kP99OfSigmas * own_rms_px)));
}

void add_cameras(const VerdictFacts& facts, const ProofResult& proof, std::vector<Reason>& reasons) {
  for (const CameraProof& camera : proof.cameras) {
    const PixelDistance& distance = camera.distance.decisive();
    const auto own = std::ranges::find(facts.uncertainties, camera.name, &OwnUncertainty::camera);
    const VerdictWord pixels = word_of(distance, own != facts.uncertainties.end() ? own->rms_px : 0.0);
    const auto add = [&](VerdictWord word, Code code, std::vector<Argument> arguments, const PixelDistance& of) {
      if (word == VerdictWord::kReady) return;
      reasons.push_back({weighed(word, proof.is_first), {code, std::move(arguments)}, camera.name, of});
    };
    add(pixels, Code::kVerdictPixelsOff, {proof.program, distance.rms, distance.p99, distance.max, causes_of(camera, proof)},
        distance);
    constexpr double kSeen = 1.0;  // px
    if (pixels == VerdictWord::kReady && camera.misread && distance.max > kSeen)
      add(VerdictWord::kUseWithCare, Code::kVerdictMisread, {proof.program, distance.max, causes_of(camera, proof)}, distance);
    const PixelDistance& image = camera.distance.in_image;
    std::vector<Message> of_circle;
    if (camera.distance.is_wide) of_circle.push_back({Code::kVerdictOfCircle, {distance.no_rays}});
    add(word_of(distance.no_rays, kVerdictNoRays), Code::kVerdictNoRays,
        {proof.program, image.region * image.no_rays, image.region * (1.0 - image.no_rays), why_no_rays(proof), of_circle},
        image);
  }
}

std::vector<Message> facts_of(std::span<const consumers::Complaint> complaints) {
  std::vector<Message> messages;
  messages.reserve(complaints.size());
  for (const consumers::Complaint& complaint : complaints) messages.push_back(complaint.facts);
  return messages;
}

/// Models that not every version of the program reads.
void add_versions(const Format& to, const ProofResult& proof, std::vector<Reason>& reasons) {
  for (const CameraProof& camera : proof.cameras) {
    const auto row = std::ranges::find(to.models, std::string_view(camera.model), &StoredModel::file_name);
    if (row == to.models.end() || row->since.empty() || !proof.is_first) continue;
    reasons.push_back(
        {VerdictWord::kUseWithCare, {Code::kVerdictNeedsVersion, {proof.program, row->since, row->file_name}}, camera.name});
  }
}

/// What the program holds otherwise than the rig: that would be a fault of the writer.
void add_disagreement(const ProofResult& proof, std::vector<Reason>& reasons) {
  const VerdictWord word = weighed(VerdictWord::kDoNotUse, proof.is_first);
  for (const CameraProof& camera : proof.cameras) {
    if (camera.agrees || camera.misread || camera.compared_share == 0.0) continue;
    reasons.push_back({word,
                       {Code::kVerdictNumbersDiffer, {proof.program, Message{Code::kPixelsDiffer, {camera.max_diff_px}}}},
                       camera.name});
  }
  if (!proof.poses_agree) reasons.push_back({word, {Code::kVerdictPosesDiffer, {proof.program, proof.max_diff_pose}}});
  if (!proof.other_numbers.empty())
    reasons.push_back({word, {Code::kVerdictNumbersDiffer, {proof.program, proof.other_numbers}}});
}

void add_programs(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  const VerdictWord for_others = facts.is_named ? VerdictWord::kDoNotUse : VerdictWord::kUseWithCare;
  if (!facts.is_asked) reasons.push_back({VerdictWord::kUseWithCare, {Code::kVerdictNotAsked}});
  if (!facts.not_for.empty() && !facts.proofs.empty() && facts.proofs.front().loads) {
    const std::vector<std::string> readers = {facts.proofs.front().program};
    reasons.push_back({for_others, {Code::kVerdictNeedsProgram, {readers, std::string(facts.not_for)}}});
  }
  if (!facts.has_reader) reasons.push_back({VerdictWord::kUseWithCare, {Code::kVerdictNoReader, {facts.to->program}}});
  for (const ProofResult& proof : facts.proofs) {
    if (proof.loads) {
      add_cameras(facts, proof, reasons);
      add_versions(*facts.to, proof, reasons);
      const auto names_it = [](const Reason& reason) { return reason.facts.code == Code::kVerdictNeedsName; };
      if (proof.is_first && !proof.wanted_name.empty() && std::ranges::none_of(reasons, names_it))
        reasons.push_back({VerdictWord::kUseWithCare, {Code::kVerdictNeedsName, {proof.program, proof.wanted_name}}});
      add_disagreement(proof, reasons);
      continue;
    }
    if (!proof.read_by.empty()) {
      reasons.push_back({for_others, {Code::kVerdictNeedsProgram, {proof.read_by, proof.program}}});
      continue;
    }
    const VerdictWord word = weighed(VerdictWord::kDoNotUse, proof.is_first);
    constexpr std::size_t kMostSaid = 4;
    const std::size_t said = std::min(kMostSaid, proof.refusals.size());
    std::vector<Message> more;
    if (said < proof.refusals.size()) more.push_back({Code::kAndMore, {proof.refusals.size() - said}});
    reasons.push_back({word, {Code::kVerdictRefused, {proof.program, facts_of(std::span(proof.refusals).first(said)), more}}});
  }
}

/// Is the number, list or matrix one that changes nothing: zeros, or an identity? Basalt's vectors begin with three biases,
/// which every estimator estimates itself.
bool is_neutral(std::string_view key, std::string_view value) {
  std::vector<double> numbers = text::reals_in(value).value_or(std::vector<double>());
  if (numbers.empty()) return false;
  constexpr std::size_t kBiases = 3;
  const bool begins_with_bias = key.ends_with("calib_accel_bias") || key.ends_with("calib_gyro_bias");
  if (begins_with_bias)
    numbers.erase(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(std::min(kBiases, numbers.size())));
  if (std::ranges::all_of(numbers, [](double number) { return number == 0.0; })) return true;
  std::size_t side = 1;
  while (side * side < numbers.size()) ++side;
  if (side < 2 || side * side != numbers.size()) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != (i % (side + 1) == 0 ? 1.0 : 0.0)) return false;
  }
  return true;
}

/// Time offsets that the program takes to be the first camera's. Of a file that was written those are among the losses.
void add_clocks(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  if (std::ranges::find(facts.losses, Code::kOtherTimeOffset, &Loss::kind) != facts.losses.end()) return;
  for (const ProofResult& proof : facts.proofs) {
    for (const consumers::Complaint& warning : proof.warnings) {
      if (warning.facts.code != Code::kOpenVinsSaysTimeshiftNotRead) continue;
      const std::string camera = warning.key.substr(0, warning.key.find('/'));
      reasons.push_back({.facts = {Code::kVerdictLost, {warning.facts}}, .camera = camera});
    }
  }
}

/// The rotations of ORB-SLAM2's rectification: without it the file is not for the images as the cameras take them.
bool rectifies(std::string_view key) { return key == "LEFT.R" || key == "RIGHT.R"; }

/// What corrects an IMU's measurements, as Kalibr, OpenVINS and Basalt name it; and its clock.
bool corrects_an_imu(std::string_view key) {
  constexpr std::array<std::string_view, 15> kKeys = {"M",
                                                      "A",
                                                      "C_gyro_i",
                                                      "Tw",
                                                      "Ta",
                                                      "Tg",
                                                      "R_IMUtoGYRO",
                                                      "R_IMUtoACC",
                                                      "T_i_b",
                                                      "time_offset",
                                                      "r_accel_x_i",
                                                      "r_accel_y_i",
                                                      "r_accel_z_i",
                                                      "calib_accel_bias",
                                                      "calib_gyro_bias"};
  return std::ranges::find(kKeys, key.substr(key.rfind('/') + 1)) != kKeys.end();  // npos + 1 is 0
}

const double* number_in(const Loss& loss, std::size_t index) {
  return index < loss.values.size() ? std::get_if<double>(&loss.values[index].value) : nullptr;
}

const std::string* text_in(const Loss& loss, std::size_t index) {
  return index < loss.values.size() ? std::get_if<std::string>(&loss.values[index].value) : nullptr;
}

/// "rate_hz" of "IMU rate_hz", where a key of the IMU came before.
std::string without_owner(const std::string& key, const std::string& first) {
  const std::string owner = first.substr(0, first.find(' ') + 1);
  return !owner.empty() && key.starts_with(owner) ? key.substr(owner.size()) : key;
}

void add_facts(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  for (const Loss& loss : facts.losses) {
    if (!matters(loss, *facts.to, facts.mode)) continue;
    reasons.push_back({.facts = {Code::kVerdictLost, {Message(facts_of(loss))}}, .camera = loss.owner, .kind = loss.kind});
  }
  const bool needs_imu = facts.mode.ends_with("inertial");
  std::vector<std::string> invented;
  Message remedy;
  for (const DefaultedValue& value : facts.defaults) {
    if (!value.invented) continue;
    invented.push_back(invented.empty() ? value.key : without_owner(value.key, invented.front()));
    const auto* clauses = std::get_if<std::vector<Message>>(&value.value.value);
    if (clauses != nullptr && clauses->front().code == Code::kTakenAsMetres) remedy = {Code::kGiveLengthUnit};
  }
  if (remedy.is_said() && invented.size() > 1) remedy = {Code::kGiveFileAndUnit};
  if (invented.empty()) return;
  reasons.push_back({.word = needs_imu ? VerdictWord::kDoNotUse : VerdictWord::kUseWithCare,
                     .facts = {Code::kVerdictInvented, {invented}},
                     .remedy = remedy});
}

/// Is the same defect of the same camera, which messages name first, among the reasons?
bool is_among(const std::vector<Reason>& reasons, const Finding& finding) {
  return std::ranges::any_of(reasons, [&](const Reason& reason) {
    const bool same_owner = reason.facts.arguments.empty() || finding.facts.arguments.empty() ||
                            reason.facts.arguments.front() == finding.facts.arguments.front();
    return id_of(reason) == id_of(finding) && same_owner;
  });
}

bool is_of_one_camera(const VerdictFacts& facts) { return facts.files.size() == 1 && facts.files.front().size() == 1; }

/// The camera that a finding is about: messages name it first. Empty: none of the rig.
std::string camera_of(const Finding& finding, const Rig* rig) {
  if (rig == nullptr || finding.facts.arguments.empty()) return "";
  const auto* name = std::get_if<std::string>(&finding.facts.arguments.front().value);
  return name != nullptr && rig->find_camera(*name) != nullptr ? *name : "";
}

/// Are the rays of cv::undistortPoints among what the program has no right rays for?
bool is_measured(const VerdictFacts& facts) {
  return std::ranges::any_of(facts.proofs, [](const ProofResult& proof) { return proof.is_first && proof.undistorts_points; });
}

/// Is the finding about the pose that was left out, by its name?
bool is_of_outvoted(const Finding& finding, const VerdictFacts& facts) {
  return facts.outvoted != nullptr && !finding.facts.arguments.empty() &&
         finding.facts.arguments.front() == Argument(name_of(facts.rig->poses[facts.outvoted->loop.edge]));
}

/// On which side the second camera stands follows from its pose: where that is wrong, it is no finding.
void remove_side_of_wrong_pose(std::vector<Reason>& reasons) {
  const auto is_wrong_pose = [](const Reason& reason) {
    return reason.word == VerdictWord::kDoNotUse && info(reason.kind).about == About::kPoses;
  };
  if (std::ranges::none_of(reasons, is_wrong_pose)) return;
  std::erase_if(reasons, [](const Reason& reason) { return same_id(reason.kind, Code::kSecondIsLeft); });
}

void add_findings(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  for (const Finding& finding : facts.findings) {
    const Code kind = code_of(finding);
    if (finding.severity == Severity::kNote) continue;
    // What programs refuse and misread, their proofs say, in numbers.
    const bool is_of_rows = kind == Code::kRosPairVertical && facts.to->id == "ros";
    const bool cannot_be_asked = !facts.is_read || kind == Code::kProgramOtherFormat || is_of_rows;
    const About about = info(kind).about;
    const bool counts = about == About::kMeaning || (about == About::kPoses && states_poses(facts)) ||
                        (cannot_be_asked && finding.severity == Severity::kError);
    if (!counts) continue;
    if (facts.rig != nullptr && reports_contradiction(kind)) continue;  // add_contradictions()
    if (about == About::kPoses && is_of_outvoted(finding, facts)) continue;
    if (is_of_unwritten_pose(finding, facts)) continue;
    if (same_id(kind, Code::kAnyUndistortionInexact) && (is_measured(facts) || !facts.to->undistorts_points)) continue;
    const VerdictWord word = word_of(finding.severity);
    // Lengths that are no metres become wrong ones in a format of metres.
    if (kind == Code::kOpencvUnitsNotGiven && is_of_one_camera(facts)) continue;  // of the second one's distance
    const bool is_of_unit = kind == Code::kOpencvUnitsNotGiven && facts.to->extrinsics && !facts.to->any_length_unit;
    const std::string camera = camera_of(finding, facts.rig);
    if (is_among(reasons, finding) || (!camera.empty() && !is_written(camera, facts))) continue;
    reasons.push_back({.word = is_of_unit ? VerdictWord::kDoNotUse : word,
                       .facts = finding.facts,
                       .camera = camera,
                       .remedy = finding.remedy,
                       .kind = kind});
  }
  remove_side_of_wrong_pose(reasons);
}

Message worded(const Contradiction& contradiction, const Rig& rig, std::vector<Message> decided) {
  const auto& [edge, path, around, difference] = contradiction.loop;
  return {Code::kVerdictPosesContradict,
          {rig.poses[edge].a, rig.poses[edge].b, in_degrees(difference.angle_rad), in_metres(difference.distance_m),
           std::move(decided)}};
}

/// A pose that was left out counts as decided; all others by how grave they are.
void add_contradictions(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  if (facts.rig == nullptr || !states_poses(facts)) return;
  if (facts.outvoted != nullptr) {
    const Code rule = facts.outvoted->blame == Blame::kOrderOfPair ? Code::kOrderOfThePair : Code::kOthersAgree;
    const std::string wrong = name_of(facts.rig->poses[facts.outvoted->loop.edge]);
    reasons.push_back({.facts = worded(*facts.outvoted, *facts.rig, {{rule, {wrong}}})});
    return;  // without it there is none
  }
  for (const Contradiction& each : contradictions(*facts.rig)) {
    const Message mistake = {each.mistake, {name_of(facts.rig->poses[each.loop.edge])}};
    if (each.blame != Blame::kNone && is_of_unwritten_pose({.facts = mistake}, facts)) continue;
    Message addition = written_statement(each, facts);
    // The wrong statement is not the one that the files have.
    const bool is_avoided = each.blame != Blame::kNone && addition.code == Code::kPoseWrittenAsDerived;
    reasons.push_back({.word = is_avoided ? VerdictWord::kUseWithCare : word_of(each.severity),
                       .facts = each.mistake != Code::kNone ? mistake : worded(each, *facts.rig, {}),
                       .kind = each.mistake,
                       .addition = std::move(addition)});
  }
}

}  // namespace

VerdictWord word_of(const PixelDistance& distance) { return word_of(distance, 0.0); }

std::string_view name_of(VerdictWord word) {
  constexpr std::array<std::string_view, 3> kNames = {"ready", "use-with-care", "do-not-use"};
  return kNames.at(static_cast<std::size_t>(word));
}

namespace {

/// Why a limit that the user sets is exceeded.
constexpr std::array kLimits = {Code::kMisreadBeyondLimit, Code::kMissingBeyondLimit, Code::kErrorBeyondLimit,
                                Code::kLossesNotAllowed};

}  // namespace

bool may_be_accepted(const Reason& reason) {
  // No file can state a pose that mirrors.
  return reason.facts.code != Code::kPoseMirrors && std::ranges::find(kLimits, reason.facts.code) == kLimits.end();
}

bool may_be_accepted(Code code) { return !same_id(code, kLimits); }

bool Acceptance::covers(const Reason& reason) const {
  // Of a pose both ends are meant.
  const auto names_it = [this](const Argument& argument) { return argument == Argument(camera); };
  return info(code).id == id_of(reason) && (camera.empty() || camera == reason.camera ||
                                            (reason.camera.empty() && std::ranges::any_of(reason.facts.arguments, names_it)));
}

bool matters(const Loss& loss, const Format& to, std::string_view mode) {
  const bool has_imu = to.imu || to.facts_apart;
  const bool uses_imu = has_imu && mode != kLensAlone && (to.modes.empty() || mode.ends_with("inertial"));
  const bool uses_poses = (to.extrinsics || to.facts_apart) && mode != kLensAlone;
  switch (loss.kind) {
    case Code::kTimeOffsetDropped: {
      const double* seconds = number_in(loss, 0);
      return uses_imu && seconds != nullptr && *seconds != 0.0;
    }
    case Code::kVinsTimeOffsetDropped: {
      const double* seconds = number_in(loss, 0);
      return seconds != nullptr && *seconds != 0.0;
    }
    case Code::kOtherTimeOffset: {
      const double* behind_common = number_in(loss, 3);
      return behind_common != nullptr && std::abs(*behind_common) > kSameClock;
    }
    case Code::kImuFileDropped:
      return to.imu ? uses_imu : uses_poses;  // without an IMU it is a file of poses
    case Code::kImuDropped:
    case Code::kCamchainImuDropped:
    case Code::kCamchainImuIncomplete:
    case Code::kVinsImuDropped:
    case Code::kVinsNoiseOfUnknownRate:
      return uses_imu;
    case Code::kPoseDropped:
      return loss.key == "T_cam_cam" ? uses_poses : uses_imu && loss.key == "T_cam_imu";
    case Code::kBaselineDropped:
    case Code::kCamchainBaselineDropped:
    case Code::kVinsBaselineDropped:
    case Code::kOpenvinsChainBaselineDropped:
      return uses_poses;
    case Code::kStaleOfImagesLost:
    case Code::kStaleOfLensesLost:
    case Code::kOpencvStaleKept:
    case Code::kBasaltStaleRadius:
    case Code::kWoodscapeStaleTranslation:
      return true;
    case Code::kNotCarriedValue: {
      const std::string* value = text_in(loss, 1);
      const bool is_used = uses_imu && corrects_an_imu(loss.key);
      return rectifies(loss.key) || (is_used && value != nullptr && !is_neutral(loss.key, *value));
    }
    default:
      return false;
  }
}

Verdict decide(const VerdictFacts& facts) {
  Verdict verdict;
  add_programs(facts, verdict.reasons);
  constexpr double kNearlyAll = 0.9;
  if (facts.outside_lens > kNearlyAll) verdict.reasons.push_back({.facts = {Code::kVerdictLensGiven, {facts.outside_lens}}});
  add_contradictions(facts, verdict.reasons);
  add_missing_poses(facts, verdict.reasons);
  add_epipolar_error(facts, verdict.reasons);
  add_strange_pair(facts, verdict.reasons);
  add_vertical_pair(facts, verdict.reasons);
  add_findings(facts, verdict.reasons);
  add_facts(facts, verdict.reasons);
  add_clocks(facts, verdict.reasons);
  for (Reason& reason : verdict.reasons) {
    const auto covers = [&reason](const Acceptance& acceptance) { return acceptance.covers(reason); };
    reason.is_accepted =
        reason.word == VerdictWord::kDoNotUse && may_be_accepted(reason) && std::ranges::any_of(facts.accepted, covers);
    if (reason.is_accepted) reason.word = VerdictWord::kUseWithCare;
    verdict.word = worse(verdict.word, reason.word);
  }
  std::ranges::stable_sort(verdict.reasons, std::ranges::greater{}, &Reason::word);
  return verdict;
}

}  // namespace fca
