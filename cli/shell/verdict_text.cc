// SPDX-License-Identifier: BSD-3-Clause
#include "verdict_text.h"

#include "option_hints.h"
#include "shell/words.h"

#include <fca/code.h>
#include <fca/formats/text/source.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace fca::cli {

namespace {

constexpr std::size_t kIndent = 2;
constexpr std::size_t kAbout = 11;    // the column of what a line is about
constexpr double kNoticeable = 0.01;  // of the image

/// What kind of thing the reason is about.
std::string_view label_of(const Reason& reason) {
  switch (reason.facts.code) {
    case Code::kVerdictNoRays:
      return "limit";
    case Code::kVerdictMisread:
      return "misread";
    case Code::kVerdictRefused:
      return "refused";
    case Code::kVerdictNeedsProgram:
    case Code::kVerdictNeedsVersion:
    case Code::kVerdictNeedsName:
      return "needs";
    case Code::kVerdictNotAsked:
    case Code::kVerdictNoReader:
      return "not proven";
    case Code::kVerdictLost:
      return "lost";
    case Code::kVerdictInvented:
      return "made up";
    default:
      return reason.word == VerdictWord::kDoNotUse ? "wrong" : "look at";
  }
}

/// What the program does with a camera that it sees elsewhere.
std::vector<Message> causes_of(const Reason& reason) {
  std::vector<Message> causes;
  for (const Message& cause : std::get<std::vector<Message>>(reason.facts.arguments.back().value))
    causes.push_back(std::get<std::vector<Message>>(cause.arguments.front().value).front());
  return causes;
}

/// Whose loss or defect it is: messages name it first.
std::string owner_of(const Reason& reason) {
  if (reason.facts.arguments.empty()) return "";
  const Argument& first = reason.facts.arguments.front();
  if (const auto* name = std::get_if<std::string>(&first.value)) return *name;
  const auto* losses = std::get_if<std::vector<Message>>(&first.value);
  return losses != nullptr && !losses->empty() ? owner_of({.facts = losses->front()}) : "";
}

/// What is lost, where the reason is a loss; else the reason's own facts.
const Message& innermost(const Message& facts) {
  const auto* losses = facts.arguments.empty() ? nullptr : std::get_if<std::vector<Message>>(&facts.arguments.front().value);
  return losses != nullptr && !losses->empty() ? innermost(losses->front()) : facts;
}

/// Are the facts those of another owner, whom they name first?
bool is_alike(const Message& a, const Message& b) {
  if (a.arguments.size() != b.arguments.size()) return false;
  return a.arguments.empty() || std::equal(a.arguments.begin() + 1, a.arguments.end(), b.arguments.begin() + 1);
}

/// The same loss or defect of another camera.
bool is_likewise(const Reason& a, const Reason& b) {
  const bool has_owner = a.facts.code == Code::kVerdictLost || a.kind == a.facts.code;
  return has_owner && a.facts.code == b.facts.code && a.kind == b.kind && a.word == b.word && owner_of(a) != owner_of(b);
}

/// `told`: the remedies of earlier lines, and their codes. A remedy is shown once, unless the same code repeats it: such lines
/// may become one.
std::string sentence_of(const Reason& reason, std::map<std::string, Code>& told) {
  std::string text = message_of(reason, with_options);
  const std::string remedy = remedy_of(reason);
  if (reason.facts.code == Code::kVerdictLost && !remedy.empty()) {
    text += ": " + remedy;
  } else if (!remedy.empty() && told.try_emplace(remedy, reason.facts.code).first->second == reason.facts.code) {
    text += "; fix: " + remedy;
  }
  if (reason.is_accepted) text += " (accepted)";
  return text;
}

}  // namespace

std::string remedy_of(const Reason& reason) {
  if (reason.facts.code != Code::kVerdictLost) return fix_of(reason, with_options);
  const auto* clauses = std::get_if<std::vector<Message>>(&reason.facts.arguments.front().value);
  return clauses != nullptr ? text::fix_of(clauses->front(), with_options) : "";
}

std::string_view in_words(VerdictWord word) {
  switch (word) {
    case VerdictWord::kReady:
      return "ready";
    case VerdictWord::kUseWithCare:
      return "use with care";
    case VerdictWord::kDoNotUse:
      return "do not use";
  }
  return "";
}

std::string region_in_words(const CameraDistance& distance) {
  if (!distance.is_wide) return "over the whole image";
  return "inside the circle that fits into the image; " + pixels(distance.in_image.rms) + " px rms over all of it";
}

std::string_view image_in_words(const CameraDistance& distance) {
  return distance.in_image.no_rays * distance.in_image.region > kNoticeable ? "where it has rays" : "in the whole image";
}

double share_without_rays(const CameraDistance& distance) {
  if (!distance.is_wide || distance.in_circle.no_rays > kNoticeable) return 0.0;
  return distance.in_image.no_rays * distance.in_image.region;
}

std::string no_rays_outside_in_words(double share) {
  return "wrong rays outside the inscribed circle: " + percent(share) + " of the image";
}

std::string VerdictCounts::in_words() const {
  std::string text;
  for (const VerdictWord word : {VerdictWord::kReady, VerdictWord::kUseWithCare, VerdictWord::kDoNotUse}) {
    text += (text.empty() ? "" : ", ") + std::to_string(counts_.at(static_cast<std::size_t>(word))) + " " +
            std::string(cli::in_words(word));
  }
  return text;
}

std::string with_colour(std::string text, VerdictWord word) {
  constexpr std::array<std::string_view, 3> kColours = {"\033[1;32m", "\033[1;33m", "\033[1;31m"};
  const std::string said = ": " + std::string(in_words(word));
  const std::size_t at = text.find(said);
  if (at == std::string::npos) return text;
  text.insert(at + said.size(), "\033[0m");
  text.insert(at + 2, kColours.at(static_cast<std::size_t>(word)));
  return text;
}

std::string summary_text(const std::vector<SummaryLine>& lines) {
  std::vector<SummaryLine> merged;
  for (const SummaryLine& line : lines) {
    const auto same = std::ranges::find(merged, line.text, &SummaryLine::text);
    if (same == merged.end()) {
      merged.push_back(line);
    } else if (same->about != line.about) {
      same->about += ", " + line.about;
    }
  }
  std::string text;
  constexpr std::size_t kText = kIndent + kAbout + 2;
  for (const SummaryLine& line : merged) {
    const std::string head = std::string(kIndent, ' ') + padded(text::printable(line.about), kAbout) + "  ";
    text += head + in_columns(text::printable(line.text), head.size(), kText) + "\n";
  }
  return text;
}

std::string wrapped_line(const std::string& sentence) { return in_columns(text::printable(sentence), 0, kIndent) + "\n"; }

std::vector<SummaryLine> lines_of(const Verdict& verdict, bool with_distances) {
  std::vector<SummaryLine> lines;
  std::vector<std::string> codes;
  std::map<std::string, Code> told;
  std::map<std::string, std::size_t> lost;  // the line of each remedy
  for (auto at = verdict.reasons.begin(); at != verdict.reasons.end(); ++at) {
    const Reason& reason = *at;
    if (!with_distances && !may_be_accepted(reason)) continue;  // an error of its own
    if (reason.word == VerdictWord::kDoNotUse && may_be_accepted(reason) &&
        std::ranges::find(codes, id_of(reason)) == codes.end())
      codes.push_back(id_of(reason));
    const bool is_distance = reason.facts.code == Code::kVerdictPixelsOff;
    // The camera's own line says how far.
    const bool is_misread = reason.facts.code == Code::kVerdictMisread && !causes_of(reason).empty();
    if ((is_distance || is_misread) && !with_distances) {
      const std::string fix = reason.remedy.code == Code::kNameTheFile ? "; fix: " + remedy_of(reason) : "";
      for (const Message& cause : causes_of(reason)) lines.push_back({"misread", text::text_of(cause, with_options) + fix});
      continue;
    }
    const bool may_merge = !with_distances || reason.facts.code == Code::kVerdictLost;
    const auto is_like = [&](const Reason& other) { return may_merge && is_likewise(reason, other); };
    // Two programs of one file may end at the same angle.
    const auto is_no_more = [&](const Reason& other) {
      return reason.facts.code == Code::kVerdictNoRays && other.facts.code == reason.facts.code &&
             other.camera == reason.camera && is_alike(other.facts, reason.facts);
    };
    if (std::any_of(verdict.reasons.begin(), at, is_like) || std::any_of(verdict.reasons.begin(), at, is_no_more)) continue;
    std::vector<std::string> likewise;
    bool has_others = false;  // numbers
    for (auto other = at + 1; other != verdict.reasons.end(); ++other) {
      if (!is_like(*other)) continue;
      likewise.push_back(owner_of(*other));
      has_others = has_others || !is_alike(innermost(reason.facts), innermost(other->facts));
    }
    if (reason.facts.code == Code::kVerdictLost && likewise.empty()) {
      const std::string remedy = remedy_of(reason);
      const auto [same, is_first] = lost.try_emplace(remedy, lines.size());
      if (!remedy.empty() && !is_first) {
        // What is lost likewise, before what to do about it.
        std::string& text = lines[same->second].text;
        text.insert(text.size() - remedy.size() - 2, "; " + message_of(reason, with_options));
        continue;
      }
    }
    const bool is_of_camera =
        is_distance || reason.facts.code == Code::kVerdictNoRays || reason.facts.code == Code::kVerdictNumbersDiffer;
    const bool names_camera = is_of_camera && !reason.camera.empty();
    lines.push_back({names_camera ? reason.camera : std::string(label_of(reason)),
                     sentence_of(reason, told) + (likewise.empty() ? ""
                                                                   : "; " + enumerated(likewise) + " likewise" +
                                                                         (has_others && !with_distances ? " (see -v)" : ""))});
  }
  for (const Reason& reason : verdict.reasons) {
    const bool has_line = with_distances || reason.facts.code != Code::kVerdictPixelsOff;
    if (reason.is_accepted && !has_line) lines.push_back({"accepted", id_of(reason) + " of " + reason.camera});
  }
  std::string accept;
  for (const std::string& code : codes) accept += " --accept " + code;
  if (!accept.empty()) lines.push_back({std::string(kAnyway), accept.substr(1)});
  return lines;
}

std::string distance_in_words(const PixelDistance& distance) {
  constexpr double kNothing = 0.001;  // px
  if (distance.max <= kNothing) return "understood within 0.001 px";
  return pixels(distance.rms) + " px rms (p99 " + pixels(distance.p99) + ", max " + pixels(distance.max) + ")";
}

}  // namespace fca::cli
