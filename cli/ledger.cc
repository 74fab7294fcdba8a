// SPDX-License-Identifier: BSD-3-Clause
#include "ledger.h"

#include <fca/convert/containment.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

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

/// A value that a target defaults: only for what the source holds, and not where the source states it.
struct Default {
  std::string_view value;
  bool Format::*of = nullptr;
  bool Format::*stated = nullptr;
};

constexpr std::array kDefaults = {
    Default{"frame rate", nullptr, &Format::frame_rate},
    Default{"IMU topic", &Format::imu, &Format::topic},
    Default{"depth threshold", &Format::extrinsics, nullptr},
    Default{"overlapping columns", &Format::extrinsics, nullptr},
};

bool is_defaulted(std::string_view value, const Format& from) {
  const auto* const row = std::ranges::find(kDefaults, value, &Default::value);
  if (row == kDefaults.end()) return true;
  return (row->of == nullptr || from.*row->of) && (row->stated == nullptr || !(from.*row->stated));
}

/// What the target demands of a model's parameters and the source does not.
std::vector<ParameterRange> limits(const StoredModel& from, const StoredModel& to) {
  std::vector<ParameterRange> result;
  std::ranges::copy_if(to.ranges, std::back_inserter(result), [&from](const ParameterRange& range) {
    return std::ranges::find(from.ranges, range) == from.ranges.end();
  });
  return result;
}

/// "k3 = 0", "alpha in [0, 1)"
std::string within_in_words(const ParameterRange& range) {
  const std::string name(range.parameter);
  if (range.lower == range.upper) return name + " = " + text::format_short(range.lower);
  const std::string upper = text::format_short(range.upper);
  const bool up_to = text::parse_real(upper) == range.upper;  // else the last number below it
  return name + " in [" + text::format_short(range.lower) + ", " + upper + (up_to ? "]" : ")");
}

/// "k3 != 0", "alpha not in [0, 1)"
std::string beyond_in_words(const ParameterRange& range) {
  std::string words = within_in_words(range);
  const bool one_value = range.lower == range.upper;
  words.insert(words.find(one_value ? " = " : " in ") + 1, one_value ? "!" : "not ");
  return words;
}

/// " (k3 = 0)"; nothing of no limit.
std::string in_brackets(const std::vector<ParameterRange>& ranges, std::string (*words)(const ParameterRange&),
                        std::string_view separator) {
  std::string text;
  for (const ParameterRange& range : ranges) text += (text.empty() ? "" : std::string(separator)) + words(range);
  return text.empty() ? "" : " (" + text + ")";
}

/// How a model stays exact: as it is (""), within limits, as a model that contains it; nothing where it is fitted.
std::optional<std::string> how_exact(const StoredModel& from, const Format& to) {
  if (const StoredModel* there = find_stored_model(to, from.model, true))
    return in_brackets(limits(from, *there), within_in_words, ", ");
  const auto outer = std::ranges::find_if(
      to.models, [&from](const StoredModel& stored) { return stored.stock && contains(stored.model, from.model); });
  if (outer == to.models.end()) return std::nullopt;
  return " (as " + std::string(outer->model) + ")";
}

LedgerRow row(const Format& from, const Format& to) {
  LedgerRow result{&from, &to, {}, {}, {}, {}};
  for (const StoredModel& stored : from.models) {
    const std::optional<std::string> how = how_exact(stored, to);
    std::vector<std::string>& list = how ? result.exact : result.fitted;
    const std::string name = std::string(stored.model) + how.value_or("");
    if (std::ranges::find(list, name) == list.end()) list.push_back(name);
    const StoredModel* there = find_stored_model(to, stored.model, true);
    if (const auto ranges = there != nullptr ? limits(stored, *there) : std::vector<ParameterRange>(); !ranges.empty())
      result.fitted.push_back(std::string(stored.model) + in_brackets(ranges, beyond_in_words, " or "));
  }
  for (const Fact& fact : kFacts) {
    // A file of one camera states no pose but that in its frame.
    const bool states_it = from.*fact.held && (fact.held != &Format::extrinsics || from.many_cameras);
    if (states_it && !(to.*fact.held)) result.dropped.emplace_back(fact.name);
  }
  // Files of one camera each are as many as one likes (--join).
  if (to.many_cameras && from.most_cameras > to.most_cameras)
    result.dropped.push_back("cameras beyond " + std::to_string(to.most_cameras));
  for (const StoredModel& stored : to.models) {
    if (!stored.pairs_only || !from.many_cameras || from.most_cameras <= 2) continue;
    for (const char* lost : {"several cameras in one file", "poses"})
      result.dropped.push_back(std::string(lost) + " (" + std::string(stored.model) + ", but for a pair)");
  }
  if (!from.frame.empty() && from.frame != to.frame) result.dropped.push_back("poses in the frame " + std::string(from.frame));
  for (const std::string_view fact : from.own_facts) {
    if (std::ranges::find(to.own_facts, fact) == to.own_facts.end()) result.dropped.emplace_back(fact);
  }
  for (const std::string_view value : to.defaulted) {
    if (is_defaulted(value, from)) result.defaulted.emplace_back(value);
  }
  if (from.any_length_unit && to.extrinsics) result.defaulted.emplace_back("translation unit");
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
