// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/containment.h>
#include <fca/formats/text/numbers.h>
#include <fca/toolkit/ledger.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

namespace fca {

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

/// A value that the target's program demands: made up only for what the source holds, and where the source does not state it.
bool is_made_up(const Demand& demand, const Format& from, const Format& to) {
  // Where there is no other model, everything becomes that one.
  const bool beside_others = !demand.of_model.empty() && to.models.size() > 1;
  if (beside_others && find_stored_model(from, demand.of_model, true) == nullptr) return false;
  if (demand.of != nullptr && !(from.*demand.of)) return false;
  if (demand.stated != nullptr && from.*demand.stated) return false;
  const bool computed_anew = !demand.of_model.empty();
  return computed_anew || std::ranges::find(from.demands, demand.name, &Demand::name) == from.demands.end();
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
  const std::string name(range.parameter.name());
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

/// Is every model of the source stored as it is, and as many of its cameras as there are?
bool holds_all_models(const Format& from, const Format& to) {
  return std::ranges::all_of(from.models, [&to](const StoredModel& stored) {
    const StoredModel* there = find_stored_model(to, stored.model, true);
    return there != nullptr && !there->pairs_only;
  });
}

/// Are the limits of parameters that the target's model does not have: k3 = 0?
bool are_of_missing_parameters(const std::vector<ParameterRange>& ranges) {
  return std::ranges::all_of(ranges, [](const ParameterRange& range) { return range.lower == range.upper; });
}

/// A model of the target that contains the source's; null if there is none.
const StoredModel* container_of(const StoredModel& from, const Format& to) {
  const auto outer = std::ranges::find_if(to.models, [&from](const StoredModel& stored) {
    return stored.stock && stored.model != from.model && contains(stored.model, from.model);
  });
  return outer == to.models.end() ? nullptr : &*outer;
}

/// How a model stays exact: as it is (""), within limits, as a model that contains it; nothing where it is fitted.
std::optional<std::string> how_exact(const StoredModel& from, const Format& to) {
  const StoredModel* outer = container_of(from, to);
  const std::string as = outer != nullptr ? "as " + std::string(outer->model) : "";
  if (const StoredModel* there = find_stored_model(to, from.model, true)) {
    const std::vector<ParameterRange> limited = limits(from, *there);
    if (outer == nullptr || limited.empty() || !are_of_missing_parameters(limited))
      return in_brackets(limited, within_in_words, ", ");
    return " (" + as + " where" + in_brackets(limited, beyond_in_words, " or ").replace(1, 1, "");
  }
  return outer != nullptr ? std::optional(" (" + as + ")") : std::nullopt;
}

LedgerRow row(const Format& from, const Format& to) {
  LedgerRow result{&from, &to, {}, {}, {}, {}};
  for (const StoredModel& stored : from.models) {
    const std::optional<std::string> how = how_exact(stored, to);
    std::vector<std::string>& list = how ? result.exact : result.fitted;
    const std::string name = std::string(stored.model) + how.value_or("");
    if (std::ranges::find(list, name) == list.end()) list.push_back(name);
    const StoredModel* there = find_stored_model(to, stored.model, true);
    const std::vector<ParameterRange> ranges = there != nullptr ? limits(stored, *there) : std::vector<ParameterRange>();
    const bool held_by_another = are_of_missing_parameters(ranges) && container_of(stored, to) != nullptr;
    if (!ranges.empty() && !held_by_another)
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
    if (!stored.pairs_only || !from.many_cameras || from.most_cameras <= 2 || holds_all_models(from, to)) continue;
    for (const char* lost : {"several cameras in one file", "poses"})
      result.dropped.push_back(std::string(lost) + " (" + std::string(stored.model) + ", but for a pair)");
  }
  if (to.pair_poses && from.extrinsics && from.many_cameras && from.most_cameras > 2)
    result.dropped.emplace_back("poses, but for a stereo pair");
  if (!from.frame.empty() && from.frame != to.frame) result.dropped.push_back("poses in the frame " + std::string(from.frame));
  for (const OwnFact& fact : from.own_facts) {
    if (std::ranges::find(to.own_facts, fact.name, &OwnFact::name) == to.own_facts.end())
      result.dropped.emplace_back(fact.name);
  }
  for (const Demand& demand : to.demands) {
    if (is_made_up(demand, from, to)) result.defaulted.emplace_back(demand.name);
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

}  // namespace fca
