// SPDX-License-Identifier: BSD-3-Clause
#include "losses.h"

#include "text/comments.h"

#include <fca/code.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace fca {

namespace {

/// What tunes a program comes in numbers, and says nothing of the calibration or the images.
constexpr std::array<std::string_view, 7> kTuning = {"Viewer.", "ORBextractor.", "vins.",  "kimera.",
                                                     "okvis.",  "svo.",          "stella."};

/// "Viewer." of "Viewer.PointSize"; nothing of a key that is no tuning.
std::string_view group_of(const ExtraField& extra) {
  if (!extra.owner.empty()) return {};
  const auto* const group =
      std::ranges::find_if(kTuning, [&extra](std::string_view prefix) { return extra.key.starts_with(prefix); });
  return group == kTuning.end() ? std::string_view() : *group;
}

bool holds_comments(const text::Document& document) {
  const std::string& bytes = document.source().bytes;
  // In documents of words they are part of the layout, and yet somebody's.
  if (document.syntax() == text::Syntax::kWords) return bytes.find('#') != std::string::npos;
  return !text::comments_of(document).empty();
}

/// The line that cv::FileStorage asks for; "" if there is none.
std::string_view yaml_header(const text::Document& document) {
  const std::string_view bytes = document.source().bytes;
  constexpr std::string_view kHeader = "%YAML";
  if (!bytes.starts_with(kHeader)) return {};
  return bytes.substr(0, bytes.find_first_of("\r\n"));
}

}  // namespace

void add_rewritten(const text::Document& base, const text::Document& fresh, const Message& why, std::vector<Loss>& losses) {
  const Message reason = why.is_said() ? Message{Code::kFileRewrittenBecause, {why}} : Message{Code::kFileRewritten};
  const std::string& name = base.source().name;
  if (holds_comments(base)) losses.push_back(lost(Code::kCommentsOfFileDropped, name, "", {reason}));
  const std::string_view header = yaml_header(base);
  if (!header.empty() && yaml_header(fresh).empty()) losses.push_back(lost(Code::kHeaderDropped, name, "", {reason, header}));
}

void add_extras_lost(const Rig& rig, std::span<const ExtraField> there, const std::optional<Rig>& replaced, const Message& why,
                     std::vector<Loss>& losses) {
  add_beyond_base(rig.extra_fields, there, why, losses);
  if (!replaced) return;
  const std::vector<ExtraField> of_base = extras_beyond(replaced->extra_fields, rig.extra_fields);
  add_not_carried(extras_beyond(of_base, there), Message{Code::kFileRewritten}, losses);
}

void add_lost_comments(const text::Document& edited, std::vector<Loss>& losses) {
  const std::vector<text::Span> before = text::comments_of(edited);
  if (before.empty()) return;
  const std::optional<text::Document> result = text::as_edited(edited);
  if (!result) return;
  const auto words = [](const text::Document& document, const text::Span& span) {
    return document.source().bytes.substr(span.offset, span.length);
  };
  std::multiset<std::string> kept;
  for (const text::Span& span : text::comments_of(*result)) kept.insert(words(*result, span));
  std::vector<std::string> gone;
  for (const text::Span& span : before) {
    const auto there = kept.find(words(edited, span));
    if (there == kept.end()) {
      gone.push_back(text::shortened(words(edited, span)));
    } else {
      kept.erase(there);
    }
  }
  constexpr std::size_t kNamed = 3;  // of more, their number
  if (gone.empty()) return;
  const std::size_t unnamed = gone.size() - std::min(kNamed, gone.size());
  gone.resize(gone.size() - unnamed);
  const Message why{Code::kReplacedOrRemoved};
  if (unnamed == 0) {
    losses.push_back(lost(Code::kCommentsReplaced, "", "", {why, gone}));
  } else {
    losses.push_back(lost(Code::kManyCommentsReplaced, "", "", {why, gone, unnamed}));
  }
}

void add_not_carried(std::span<const ExtraField> extras, const Message& why, std::vector<Loss>& losses) {
  constexpr int kFewest = 3;  // fewer keys are named one by one
  std::map<std::string_view, int> sizes;
  std::map<Code, std::vector<std::string>> facts;
  for (const ExtraField& extra : extras) {
    if (extra.kind == Code::kNone) {
      ++sizes[group_of(extra)];
    } else {
      facts[extra.kind].push_back(extra.key.substr(group_of(extra).size()));
    }
  }
  for (const auto& [kind, keys] : facts) losses.push_back(lost(kind, "", "", {keys}));
  std::set<std::string_view> told;
  for (const ExtraField& extra : extras) {
    if (extra.kind != Code::kNone) continue;
    const std::string_view group = group_of(extra);
    const int members = sizes[group];
    if (!group.empty() && members >= kFewest) {
      if (told.insert(group).second) losses.push_back(lost(Code::kNotCarriedGroup, "", std::string(group), {why, members}));
    } else if (extra.value.empty()) {
      losses.push_back(lost(Code::kNotCarried, extra.owner, extra.key, {why}));
    } else {
      const Argument value = extra.said.is_said() ? Argument(extra.said) : Argument(extra.value);
      losses.push_back(lost(Code::kNotCarriedValue, extra.owner, extra.key, {why, value}));
    }
  }
}

void add_time_offset(const Camera& camera, const Message& why, std::vector<Loss>& losses) {
  if (camera.time_offset_s.value_or(0.0) == 0.0) return;
  losses.push_back(lost(Code::kTimeOffsetDropped, camera.name, "timeshift_cam_imu", {*camera.time_offset_s, why}));
}

void add_other_time_offsets(const Rig& rig, double common, const Message& who, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) {
    const double offset = camera.time_offset_s.value_or(common);
    if (offset == common) continue;
    losses.push_back(lost(Code::kOtherTimeOffset, camera.name, "", {who, offset, common, offset - common}));
  }
}

void add_stream(const Camera& camera, const Message& why, std::vector<Loss>& losses) {
  add_time_offset(camera, why, losses);
  if (!camera.topic.empty()) losses.push_back(lost(Code::kTopicDropped, camera.name, "topic", {why, camera.topic}));
  if (camera.frame_rate_hz)
    losses.push_back(lost(Code::kFrameRateDropped, camera.name, "frame rate", {why, *camera.frame_rate_hz}));
}

void add_beyond_base(std::span<const ExtraField> extras, std::span<const ExtraField> there, const Message& why,
                     std::vector<Loss>& losses) {
  std::set<std::pair<std::string_view, std::string_view>> keys;
  for (const ExtraField& extra : there) keys.emplace(extra.owner, extra.key);
  std::vector<ExtraField> other_values = extras_beyond(extras, there);
  const auto without_place = std::stable_partition(other_values.begin(), other_values.end(), [&keys](const ExtraField& extra) {
    return keys.contains({extra.owner, extra.key});
  });
  const std::span<const ExtraField> all = other_values;
  const auto kept = static_cast<std::size_t>(without_place - other_values.begin());
  add_not_carried(all.subspan(kept), why, losses);
  add_not_carried(all.first(kept), Message{Code::kKeepsItsOwnValue}, losses);
}

std::vector<ExtraField> extras_beyond(std::span<const ExtraField> extras, std::span<const ExtraField> there) {
  const auto as_spelled = [](const ExtraField& extra) {
    return std::tuple<std::string_view, std::string_view, std::string_view>(extra.owner, extra.key, extra.value);
  };
  std::multimap<decltype(as_spelled(there[0])), const ExtraField*> stated;
  for (const ExtraField& extra : there) stated.emplace(as_spelled(extra), &extra);
  std::vector<ExtraField> result;
  for (const ExtraField& extra : extras) {
    const auto [first, last] = stated.equal_range(as_spelled(extra));
    if (std::none_of(first, last, [&extra](const auto& row) { return *row.second == extra; })) result.push_back(extra);
  }
  return result;
}

}  // namespace fca
