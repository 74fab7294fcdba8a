// SPDX-License-Identifier: BSD-3-Clause
#include "losses.h"

#include "text/comments.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace fca {

namespace {

/// What tunes a program comes in numbers, and says nothing of the calibration or the images.
constexpr std::array<std::string_view, 3> kTuning = {"Viewer.", "ORBextractor.", "vins."};

/// "Viewer." of "Viewer.PointSize"; nothing of a key that is no tuning.
std::string_view group_of(const ExtraField& extra) {
  if (!extra.owner.empty()) return {};
  const auto* const group =
      std::ranges::find_if(kTuning, [&extra](std::string_view prefix) { return extra.key.starts_with(prefix); });
  return group == kTuning.end() ? std::string_view() : *group;
}

std::string in_words(const ExtraField& extra) {
  return with_owner(extra) + (extra.value.empty() ? "" : " " + text::shortened(extra.value));
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

void add_composed_anew(const text::Document& base, const text::Document& fresh, std::string_view why,
                       std::vector<Loss>& losses) {
  const std::string reason = "the file is composed anew" + (why.empty() ? "" : ": " + std::string(why));
  if (holds_comments(base)) losses.push_back({"comments-dropped", "comments of " + base.source().name, reason, ""});
  const std::string_view header = yaml_header(base);
  if (!header.empty() && yaml_header(fresh).empty()) {
    losses.push_back({"header-dropped", "first line " + std::string(header) + " of " + base.source().name, reason,
                      "cv::FileStorage (OpenVINS) reads no file without it"});
  }
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
  std::vector<std::string> lost;
  for (const text::Span& span : before) {
    const auto there = kept.find(words(edited, span));
    if (there == kept.end()) {
      lost.push_back(text::shortened(words(edited, span)));
    } else {
      kept.erase(there);
    }
  }
  constexpr std::size_t kNamed = 3;  // of more, their number
  if (lost.empty()) return;
  std::vector<std::string> named(lost.begin(), lost.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, lost.size())));
  if (lost.size() > kNamed) named.push_back(std::to_string(lost.size() - kNamed) + " more");
  losses.push_back({"comments-dropped", (lost.size() == 1 ? "comment " : "comments ") + text::enumerated(named),
                    "what stood there is replaced or removed", ""});
}

void add_not_carried(std::span<const ExtraField> extras, std::string_view why, std::vector<Loss>& losses) {
  constexpr int kFewest = 3;  // fewer keys are named one by one
  std::map<std::string_view, int> sizes;
  for (const ExtraField& extra : extras) ++sizes[group_of(extra)];
  std::set<std::string_view> told;
  for (const ExtraField& extra : extras) {
    const std::string_view group = group_of(extra);
    const int members = sizes[group];
    if (group.empty() || members < kFewest) {
      losses.push_back({"not-carried", in_words(extra), std::string(why), ""});
    } else if (told.insert(group).second) {
      losses.push_back({"not-carried", std::string(group) + "* (" + std::to_string(members) + " keys)", std::string(why), ""});
    }
  }
}

void add_time_offset(const Camera& camera, std::string_view why, std::vector<Loss>& losses) {
  if (camera.time_offset_s.value_or(0.0) == 0.0) return;
  const std::string shift = text::format_short(*camera.time_offset_s, 12);
  losses.push_back({"time-offset-dropped", camera.name + " timeshift_cam_imu " + shift + " s", std::string(why),
                    "add " + shift + " s to every image time stamp of " + camera.name});
}

void add_time_offset(const Camera& camera, const Message& why, std::vector<Loss>& losses) {
  if (camera.time_offset_s.value_or(0.0) == 0.0) return;
  losses.push_back(lost(Code::kTimeOffsetDropped, camera.name, "timeshift_cam_imu", {*camera.time_offset_s, why}));
}

void add_other_time_offsets(const Rig& rig, double common, std::string_view who, std::vector<Loss>& losses) {
  for (const Camera& camera : rig.cameras) {
    const double offset = camera.time_offset_s.value_or(common);
    if (offset == common) continue;
    losses.push_back({"time-offset-dropped", camera.name + " time offset " + text::format_short(offset, 9) + " s",
                      std::string(who) + ", " + text::format_short(common, 9) + " s",
                      "add " + text::format_short(offset - common, 9) + " s to every image time stamp of " + camera.name});
  }
}

void add_stream(const Camera& camera, std::string_view why, std::vector<Loss>& losses) {
  add_time_offset(camera, why, losses);
  if (!camera.topic.empty()) losses.push_back({"topic-dropped", camera.name + " " + camera.topic, std::string(why), ""});
  if (camera.frame_rate_hz) {
    losses.push_back(
        {"frame-rate-dropped", camera.name + " " + text::format_short(*camera.frame_rate_hz) + " Hz", std::string(why), ""});
  }
}

void add_beyond_base(std::span<const ExtraField> extras, std::span<const ExtraField> there, std::string_view why,
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
  add_not_carried(all.first(kept), "the file that is written into keeps its own value", losses);
}

std::vector<ExtraField> extras_beyond(std::span<const ExtraField> extras, std::span<const ExtraField> there) {
  const std::set<ExtraField> stated(there.begin(), there.end());
  std::vector<ExtraField> result;
  for (const ExtraField& extra : extras) {
    if (!stated.contains(extra)) result.push_back(extra);
  }
  return result;
}

}  // namespace fca
