// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/convert/containment.h>
#include <fca/toolkit/ledger.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

namespace fca {

namespace {

/// A kind of fact that some formats can store.
struct Fact {
  bool Format::*held;  ///< True in formats that store it.
  Code name;
};

constexpr std::array kKindsOfFacts = {
    Fact{&Format::many_cameras, Code::kLedgerSeveralCameras},
    Fact{&Format::extrinsics, Code::kLedgerPoses},
    Fact{&Format::imu, Code::kLedgerImu},
    Fact{&Format::time_offset, Code::kLedgerTimeOffset},
    Fact{&Format::frame_rate, Code::kLedgerFrameRate},
    Fact{&Format::topic, Code::kLedgerTopics},
    Fact{&Format::baseline, Code::kLedgerBaseline},
};

/// True if a conversion fills in a default for a value that the target requires: the source's files can contain the thing to
/// which the value belongs, but not the value itself.
bool needs_default(const Demand& demand, const Format& from, const Format& to) {
  // If the target has only one model, every camera is converted to that model, so that the value is always required.
  const bool is_one_of_several = !demand.of_model.empty() && to.models.size() > 1;
  if (is_one_of_several && find_stored_model(from, demand.of_model, true) == nullptr) return false;
  if (demand.of != nullptr && !(from.*demand.of)) return false;
  if (demand.of_frame && from.frame == to.frame) return false;
  if (demand.of == &Format::pair_poses && from.most_cameras <= 2) return false;
  if (demand.stated != nullptr && from.*demand.stated) return false;
  const bool recomputed = !demand.of_model.empty();
  return recomputed || std::ranges::find(from.demands, demand.name, &Demand::name) == from.demands.end();
}

/// The ranges of a model's parameters that the target requires and the source does not.
std::vector<ParameterRange> limits(const StoredModel& from, const StoredModel& to) {
  std::vector<ParameterRange> result;
  std::ranges::copy_if(to.ranges, std::back_inserter(result), [&from](const ParameterRange& range) {
    return std::ranges::find(from.ranges, range) == from.ranges.end();
  });
  return result;
}

/// True if the target stores every model of the source unchanged, for more than two cameras, too.
bool holds_all_models(const Format& from, const Format& to) {
  return std::ranges::all_of(from.models, [&to](const StoredModel& stored) {
    const StoredModel* in_target = find_stored_model(to, stored.model, true);
    return in_target != nullptr && !in_target->pairs_only;
  });
}

/// True if each range is a single value, which means that the target cannot store these parameters (k3 = 0).
bool are_of_missing_parameters(const std::vector<ParameterRange>& ranges) {
  return std::ranges::all_of(ranges, [](const ParameterRange& range) { return range.lower == range.upper; });
}

/// A model of the target of which the source's model is a special case. Null if there is none.
const StoredModel* container_of(const StoredModel& from, const Format& to) {
  const auto outer = std::ranges::find_if(to.models, [&from](const StoredModel& stored) {
    return stored.stock && stored.model != from.model && contains(stored.model, from.model);
  });
  return outer == to.models.end() ? nullptr : &*outer;
}

/// How a model is converted exactly: unchanged, unchanged within ranges, or as a model that contains it. nullopt if the model
/// is always fitted.
std::optional<LedgerModel> exact_conversion_of(const StoredModel& from, const Format& to) {
  const StoredModel* outer = container_of(from, to);
  const std::string_view as = outer != nullptr ? outer->model : std::string_view();
  if (const StoredModel* in_target = find_stored_model(to, from.model, true)) {
    std::vector<ParameterRange> limited = limits(from, *in_target);
    const bool needs_another = !limited.empty() && are_of_missing_parameters(limited);
    return LedgerModel{from.model, needs_another ? as : std::string_view(), std::move(limited)};
  }
  return outer != nullptr ? std::optional(LedgerModel{from.model, as}) : std::nullopt;
}

/// The ranges outside which a model must be fitted although the target has this model.
std::vector<ParameterRange> limits_of_unchanged(const StoredModel& from, const Format& to) {
  const StoredModel* in_target = find_stored_model(to, from.model, true);
  std::vector<ParameterRange> ranges = in_target != nullptr ? limits(from, *in_target) : std::vector<ParameterRange>();
  const bool held_by_another = are_of_missing_parameters(ranges) && container_of(from, to) != nullptr;
  return held_by_another ? std::vector<ParameterRange>() : ranges;
}

/// Adds the source's models to the row: to `exact`, to `fitted`, or (exact within limits only) to both.
void list_models(const Format& from, const Format& to, LedgerRow& row) {
  for (const StoredModel& stored : from.models) {
    const std::optional<LedgerModel> exact = exact_conversion_of(stored, to);
    std::vector<LedgerModel>& list = exact ? row.exact : row.fitted;
    const LedgerModel model = exact.value_or(LedgerModel{stored.model});
    if (std::ranges::find(list, model) == list.end()) list.push_back(model);
    std::vector<ParameterRange> ranges = limits_of_unchanged(stored, to);
    if (!ranges.empty()) row.fitted.push_back({stored.model, {}, std::move(ranges)});
  }
}

/// Lists the facts that are lost if cameras are converted to a model whose files contain at most two cameras.
void list_lost_to_pairs(const Format& from, const Format& to, std::vector<Message>& dropped) {
  if (!from.many_cameras || from.most_cameras <= 2 || holds_all_models(from, to)) return;
  for (const StoredModel& stored : to.models) {
    if (!stored.pairs_only || find_model(stored.model)->kept_only) continue;
    for (const Code lost : {Code::kLedgerSeveralCameras, Code::kLedgerPoses})
      dropped.push_back({Code::kLedgerButPair, {Message{lost}, stored.model}});
  }
}

/// The facts that the source can contain and the target cannot store.
std::vector<Message> dropped(const Format& from, const Format& to) {
  std::vector<Message> result;
  const bool states_imu = from.imu || from.imu_pose;
  for (const Fact& fact : kKindsOfFacts) {
    // A file with one camera only contains the camera's pose in the frame of the format. If this frame is the IMU, the poses
    // between cameras follow from those of several files.
    const bool is_held = fact.held == &Format::imu ? states_imu : from.*fact.held;
    const bool states_it = is_held && (fact.held != &Format::extrinsics || from.many_cameras || states_imu);
    if (states_it && !(to.*fact.held)) result.push_back({fact.name});
  }
  // Files with one camera each can be joined. So only a target with many cameras per file limits their number.
  if (to.many_cameras && from.most_cameras > to.most_cameras) result.push_back({Code::kLedgerCamerasBeyond, {to.most_cameras}});
  list_lost_to_pairs(from, to, result);
  if (to.pair_poses && to.most_cameras > 2 && from.extrinsics && from.many_cameras && from.most_cameras > 2)
    result.push_back({Code::kLedgerPosesButPair});
  if (!from.frame.empty() && from.frame != to.frame) result.push_back({Code::kLedgerPosesInFrame, {from.frame}});
  for (const OwnFact& fact : from.own_facts) {
    if (std::ranges::find(to.own_facts, fact.name, &OwnFact::name) == to.own_facts.end())
      result.push_back({Code::kLedgerNamed, {fact.name}});
  }
  return result;
}

/// The values that a conversion fills with defaults.
std::vector<Message> defaulted(const Format& from, const Format& to) {
  std::vector<Message> result;
  for (const Demand& demand : to.demands) {
    const bool is_listed = std::ranges::any_of(result, [&demand](const Message& each) {
      return each == Message{Code::kLedgerNamed, {demand.name}};
    });
    if (needs_default(demand, from, to) && !is_listed) result.push_back({Code::kLedgerNamed, {demand.name}});
  }
  if (from.leaves_unit_open() && !to.leaves_unit_open() && to.extrinsics) result.push_back({Code::kLedgerLengthUnit});
  if (to.image_size && !from.image_size) result.push_back({Code::kLedgerSizeAsked});
  return result;
}

LedgerRow row(const Format& from, const Format& to) {
  LedgerRow result{&from, &to, {}, {}, dropped(from, to), defaulted(from, to)};
  list_models(from, to, result);
  return result;
}

}  // namespace

std::vector<LedgerRow> ledger() {
  std::vector<LedgerRow> rows;
  for (const Format& from : all_formats()) {
    if (from.models.empty()) continue;  // a table of rays has no model
    for (const Format& to : written_formats()) {
      if (&from != &to) rows.push_back(row(from, to));
    }
  }
  return rows;
}

}  // namespace fca
