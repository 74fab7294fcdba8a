// SPDX-License-Identifier: BSD-3-Clause
#include "ledger.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

/// A fact that some formats have a place for.
struct Fact {
  bool Format::*held;
  const char* name;
};

constexpr std::array kFacts = {
    Fact{&Format::many_cameras, "several cameras in one file"},
    Fact{&Format::extrinsics, "poses"},
    Fact{&Format::imu, "IMU"},
    Fact{&Format::time_offset, "time offset"},
    Fact{&Format::frame_rate, "frame rate"},
    Fact{&Format::topic, "topics"},
    Fact{&Format::baseline, "baseline without poses"},
};

/// " (k3 = 0)": what the target demands of a model's parameters and the source does not.
std::string limits_in_words(const StoredModel& from, const StoredModel& to) {
  std::string text;
  for (const ParameterRange& range : to.ranges) {
    if (std::ranges::find(from.ranges, range) != from.ranges.end()) continue;
    const std::string name(range.parameter);
    text += (text.empty() ? "" : ", ") + (range.lower == range.upper ? name + " = " + text::format_short(range.lower)
                                                                     : name + " in [" + text::format_short(range.lower) + ", " +
                                                                           text::format_short(range.upper) + "]");
  }
  return text.empty() ? "" : " (" + text + ")";
}

LedgerRow row(const Format& from, const Format& to) {
  LedgerRow result{&from, &to, {}, {}, {}, {}};
  for (const StoredModel& stored : from.models) {
    const StoredModel* there = find_stored_model(to, stored.model, true);
    std::vector<std::string>& list = there != nullptr ? result.exact : result.fitted;
    const std::string name = std::string(stored.model) + (there != nullptr ? limits_in_words(stored, *there) : "");
    if (std::ranges::find(list, name) == list.end()) list.push_back(name);
  }
  for (const Fact& fact : kFacts) {
    if (from.*fact.held && !(to.*fact.held)) result.dropped.emplace_back(fact.name);
  }
  for (const std::string_view value : to.defaulted) {
    const bool stated = (value == "frame rate" && from.frame_rate) || (value == "IMU topic" && from.topic);
    if (!stated) result.defaulted.emplace_back(value);
  }
  if (to.image_size && !from.image_size) result.defaulted.emplace_back("nothing: the image size is asked for (--size)");
  return result;
}

}  // namespace

std::vector<LedgerRow> ledger() {
  std::vector<LedgerRow> rows;
  for (const Format& from : all_formats()) {
    for (const Format& to : all_formats()) {
      if (&from != &to) rows.push_back(row(from, to));
    }
  }
  return rows;
}

}  // namespace fca::cli
