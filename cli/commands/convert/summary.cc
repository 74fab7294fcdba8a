// SPDX-License-Identifier: BSD-3-Clause
// The report that is printed without -v: the verdict, and what a user must act on.
#include "convert_command.h"
#include "shell/option_hints.h"
#include "shell/statistics_text.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/code.h>
#include <fca/compare/report.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

namespace {

constexpr double kNothingToSpeakOf = 0.01;  // of the image

std::string name_of_outputs(const ConvertOutcome& outcome) {
  std::vector<std::string> paths;
  for (const ConvertedFile& file : outcome.files) {
    if (!file.path.empty()) paths.push_back(file.path);
  }
  if (paths.empty()) return outcome.one_of_many ? outcome.input : std::string(outcome.to->title);
  constexpr std::size_t kMost = 2;
  if (paths.size() <= kMost) return enumerated(paths);
  return paths.front() + " and " + counted(paths.size() - 1, "other file");
}

std::string first_line(const ConvertOutcome& outcome, bool written) {
  std::string text = name_of_outputs(outcome) + ": " + std::string(in_words(outcome.verdict.word));
  if (outcome.code != ExitCode::kGood && written) text += ", nothing written";
  if (!outcome.headline.is_said()) return text::printable(text) + "\n";
  // However long the paths are, no line breaks before the word has ended.
  constexpr std::size_t kIndent = 2;
  const std::size_t last = text.rfind(' ') + 1;
  const std::string rest = text.substr(last) + "; " + text::text_of(outcome.headline, with_options);
  return text::printable(text.substr(0, last)) + in_columns(text::printable(rest), last, kIndent) + "\n";
}

/// What decides and, of a wide lens, the whole image.
std::string in_both_regions(const CameraDistance& distance) {
  constexpr double kNothingPx = 0.1;
  const std::string decisive = distance_in_words(distance.decisive());
  if (!distance.is_wide || distance.in_image.max <= kNothingPx) return decisive;
  constexpr double kSame = 0.05;
  const auto is_same = [](double image, double circle) { return std::abs(image - circle) <= kSame * image; };
  if (is_same(distance.in_image.rms, distance.in_circle.rms) && is_same(distance.in_image.max, distance.in_circle.max))
    return decisive;
  return decisive + " in the inscribed circle; " + pixels(distance.in_image.rms) + " (max " + pixels(distance.in_image.max) +
         ") " + std::string(image_in_words(distance));
}

SummaryLine line_of(const ConvertResult& outcome, const ConvertedCamera& camera) {
  const CameraDistance* distance = distance_of(outcome, camera);
  const std::string_view way = way_in_words(camera);
  std::string text = models_in_words(camera);
  if (way != "fitted" || distance == nullptr) text += ", " + std::string(way);
  if (distance != nullptr) text += "; " + in_both_regions(*distance);
  if (distance != nullptr && !camera.source.rays.empty()) text += " at the rays";
  return {name_in_words(camera), text};
}

/// What stereo feels of the fits; not of lenses that are kept.
void add_pair(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  constexpr double kNothingPx = 0.01;
  if (!outcome.pair || outcome.pair->max_px() < kNothingPx) return;
  // Why a file is not to be used, and what a lens cannot be, take lines enough.
  if (outcome.verdict.word == VerdictWord::kDoNotUse) return;
  const auto says_more = [](const Reason& reason) {
    return reason.facts.code == Code::kVerdictEpipolarError || reason.facts.code == Code::kTargetCannotReach;
  };
  if (std::ranges::any_of(outcome.verdict.reasons, says_more)) return;
  lines.push_back(
      {"pair", "epipolar error rms " + pixels(outcome.pair->rms_px()) + " px, max " + pixels(outcome.pair->max_px()) + " px"});
}

/// Parts of the image beyond the region that decides, of the camera that has most of them.
void add_limits(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  double most = 0.0;
  for (const ProofResult& proof : outcome.proofs) {
    for (const CameraProof& camera : proof.cameras) {
      if (proof.is_first) most = std::max(most, share_without_rays(camera.distance));
    }
  }
  if (most > kNothingToSpeakOf) lines.push_back({"limit", no_rays_outside_in_words(most)});
}

/// What of the image the user's own limit leaves out, of the camera that loses most.
void add_given_lens(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  double most = 0.0;
  for (const ConvertedCamera& camera : outcome.cameras) {
    if (camera.report) most = std::max(most, camera.report->statistics.coverage.outside_lens);
  }
  if (outcome.lens_given && most > kNothingToSpeakOf)
    lines.push_back({"limit", percent(most) + " of the image lies outside the lens as it was given: not fitted, not compared"});
}

/// What the request does not allow (--strict, --max-error), and else speaks against writing.
void add_refusals(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  for (const Diagnostic& entry : outcome.diagnostics.entries()) {
    if (entry.severity != Severity::kError) continue;
    const auto says_it = [&entry](const Reason& reason) { return may_be_accepted(reason) && id_of(reason) == id_of(entry); };
    if (std::ranges::any_of(outcome.verdict.reasons, says_it)) continue;
    const std::string fix = fix_of(entry, with_options);
    lines.push_back(
        {"refused", message_of(entry, with_options) + (fix.empty() ? "" : "; fix: " + fix) + " [" + id_of(entry) + "]"});
  }
}

/// What is said of several cameras alike is said once.
void add_settings(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  struct Setting {
    std::string text;
    std::vector<std::string> cameras;
  };
  std::vector<Setting> settings;
  for (const DefaultedValue& value : outcome.defaults) {
    if (!value.look_at_it || value.invented) continue;
    std::string text = text_of(value, with_options);
    const auto owner = std::ranges::find_if(
        outcome.cameras, [&text](const ConvertedCamera& camera) { return text.starts_with(camera.name() + " "); });
    std::vector<std::string> cameras;
    if (owner != outcome.cameras.end()) {
      cameras.push_back(owner->name());
      text.erase(0, owner->name().size() + 1);
    }
    const auto same = std::ranges::find(settings, text, &Setting::text);
    if (same == settings.end()) {
      settings.push_back({std::move(text), std::move(cameras)});
    } else {
      same->cameras.insert(same->cameras.end(), cameras.begin(), cameras.end());
    }
  }
  std::vector<std::string> said;
  said.reserve(settings.size());
  for (const Setting& setting : settings)
    said.push_back((setting.cameras.empty() ? "" : enumerated(setting.cameras) + " ") + setting.text);
  if (!said.empty()) lines.push_back({"set", enumerated(said) + ": no input contains it"});
}

void add_removed(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  std::vector<std::string> cameras;
  for (const Loss& loss : outcome.losses) {
    if (same_id(loss.kind, Code::kOrbslam3ThirdCameraDropped)) cameras.push_back(loss.owner);
  }
  if (!cameras.empty()) lines.push_back({"left out", enumerated(cameras) + " of the input"});
}

/// The turns that were fitted, as asked.
void add_turns(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  std::vector<std::string> turns;
  for (const ConvertedCamera& camera : outcome.cameras) {
    if (camera.report && camera.report->turn)
      turns.push_back(name_in_words(camera) + " by " + text::format_short(camera.report->turn->angle_deg, 3) + " deg");
  }
  if (!turns.empty()) lines.push_back({"turned", enumerated(turns)});
}

/// A turn in the poses that makes the worst fit much better, where its error matters.
std::optional<std::string> offered_turn(const ConvertResult& outcome) {
  double worst_px = kSamePx;
  std::optional<std::string> text;
  for (const ConvertedCamera& camera : outcome.cameras) {
    if (!camera.report || !camera.report->turn_offer) continue;
    const double rms_px = camera.report->statistics.error.rms;
    if (rms_px <= worst_px) continue;
    worst_px = rms_px;
    text = "--absorb-rotation: " + pixels(camera.report->turn_offer->rms_px) + " px rms, not " + pixels(rms_px) +
           " (a turn of " + text::format_short(camera.report->turn_offer->angle_deg, 2) + " deg)";
  }
  return text;
}

/// Pixels that nothing could compare.
void add_not_compared(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  const auto is_blind = [](const ProofResult& proof) {
    return proof.is_first && proof.loads && proof.agrees() && !proof.without_cameras && proof.compared_share == 0.0;
  };
  if (std::ranges::any_of(outcome.proofs, is_blind))
    lines.push_back({"pixels", "not compared: no input contains the image's size (--size WxH)"});
}

/// What would be better for the pixels.
void add_better_ways(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  if (const std::optional<std::string> turn = offered_turn(outcome)) return lines.push_back({"better", *turn});
  for (const Reason& reason : outcome.verdict.reasons) {
    if (reason.remedy.code != Code::kFitInsideAngle && reason.remedy.code != Code::kRewrittenIs) continue;
    lines.push_back({"better", text::text_of(reason.remedy, with_options)});
    return;
  }
}

/// The options that write it so.
std::string options_of(const OtherWriting& writing, const ConvertResult& outcome) {
  const std::string options = "--" + std::string(outcome.to->id) + "-layout " + writing.layout;
  const bool same_model = std::ranges::all_of(
      outcome.cameras, [&writing](const ConvertedCamera& camera) { return camera.target.lens_id() == writing.model; });
  return same_model ? options : options + " --model " + writing.model;
}

void add_other_writings(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  if (outcome.others.empty()) return;
  const auto distance = [](double rms_px, double max_px) {
    constexpr double kNothingPx = 0.001;
    return max_px < kNothingPx ? "exact" : pixels(rms_px) + " px rms, worst " + pixels(max_px);
  };
  std::string text = "this one " + distance(outcome.rms_px, outcome.max_px);
  for (const OtherWriting& other : outcome.others)
    text += "; " + options_of(other, outcome) + ": " + distance(other.rms_px, other.max_px);
  lines.push_back({"layouts", text});
}

/// Of a file that is not to be used, what would only ask for care is a detail, but for what may be the cause.
Verdict decisive(const Verdict& verdict) {
  Verdict result = verdict;
  if (verdict.word == VerdictWord::kDoNotUse) {
    std::erase_if(result.reasons, [](const Reason& reason) {
      const bool may_be_cause = reason.facts.code == Code::kRayApart || reason.facts.code == Code::kRayOutside;
      return reason.word != VerdictWord::kDoNotUse && !reason.is_accepted && !may_be_cause;
    });
  }
  return result;
}

/// What is left for -v.
std::size_t details(const ConvertResult& outcome) {
  const auto not_to_set = std::ranges::count(outcome.defaults, false, &DefaultedValue::look_at_it);
  const auto& entries = outcome.diagnostics.entries();
  const auto not_errors =
      std::ranges::count_if(entries, [](const Diagnostic& entry) { return entry.severity != Severity::kError; });
  return static_cast<std::size_t>(std::ranges::count(outcome.losses, false, &Loss::matters) + not_to_set + not_errors);
}

/// Two bands as one.
std::vector<ErrorBand> in_pairs(const std::vector<ErrorBand>& bands) {
  std::vector<ErrorBand> pairs;
  for (std::size_t i = 0; i < bands.size(); i += 2) {
    ErrorBand pair = bands[i];
    if (i + 1 < bands.size()) {
      const ErrorBand& second = bands[i + 1];
      const double squares = pair.share * pair.rms_px * pair.rms_px + second.share * second.rms_px * second.rms_px;
      pair.share += second.share;
      pair.rms_px = pair.share > 0.0 ? std::sqrt(squares / pair.share) : 0.0;
      pair.to_deg = second.to_deg;
    }
    pairs.push_back(pair);
  }
  return pairs;
}

/// The errors over the angle of the worst fit, where that is far off somewhere.
void add_bands(const ConvertResult& outcome, std::vector<SummaryLine>& lines) {
  double worst_px = 1.0;
  const ConvertedCamera* worst = nullptr;
  for (const ConvertedCamera& camera : outcome.cameras) {
    if (!camera.report || camera.report->exact || camera.report->statistics.error.p99 <= worst_px) continue;
    worst_px = camera.report->statistics.error.p99;
    worst = &camera;
  }
  if (worst == nullptr || worst->report->statistics.bands.empty()) return;
  std::vector<ErrorBand> bands = worst->report->statistics.bands;
  constexpr std::size_t kMost = 6;  // of a line
  while (bands.size() > kMost) bands = in_pairs(bands);
  constexpr int kDigits = 2;
  std::string text =
      name_in_words(*worst) + ", rms px per " + fixed(bands.front().to_deg - bands.front().from_deg, 0) + " deg:";
  const auto in_short = [](double px) { return px < 100.0 ? text::format_short(px, kDigits) : fixed(px, 0); };
  for (const ErrorBand& band : bands) text += " " + (band.share > 0.0 ? in_short(band.rms_px) : "-");
  lines.push_back({"by angle", text});
}

}  // namespace

const CameraDistance* distance_of(const ConvertResult& outcome, const ConvertedCamera& camera) {
  for (const ProofResult& proof : outcome.proofs) {
    if (!proof.is_first) continue;
    const auto seen = std::ranges::find(proof.cameras, camera.source.name, &CameraProof::name);
    if (seen != proof.cameras.end() && seen->distance.decisive().region > 0.0) return &seen->distance;
  }
  return nullptr;
}

std::string convert_summary(const ConvertOutcome& outcome, bool written, bool is_short) {
  return first_line(outcome, written) + summary_lines(outcome, is_short);
}

std::string summary_lines(const ConvertResult& outcome, bool is_short) {
  std::vector<SummaryLine> lines;
  for (const ConvertedCamera& camera : outcome.cameras) lines.push_back(line_of(outcome, camera));
  const Verdict verdict = is_short ? decisive(outcome.verdict) : outcome.verdict;
  for (SummaryLine& line : lines_of(verdict, false)) lines.push_back(std::move(line));
  add_refusals(outcome, lines);
  add_pair(outcome, lines);
  add_not_compared(outcome, lines);
  add_limits(outcome, lines);
  add_given_lens(outcome, lines);
  add_turns(outcome, lines);
  add_other_writings(outcome, lines);
  add_better_ways(outcome, lines);
  add_removed(outcome, lines);
  add_settings(outcome, lines);
  if (is_short) add_bands(outcome, lines);
  std::string text = summary_text(lines);
  const std::size_t count = details(outcome) + (outcome.verdict.reasons.size() - verdict.reasons.size());
  if (count > 0 && is_short) text += "  " + counted(count, "detail") + ": -v\n";
  return text;
}

}  // namespace fca::cli
