// SPDX-License-Identifier: BSD-3-Clause
#include "ledger.h"

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
};

bool holds(const Format& format, std::string_view model) { return find_stored_model(format, model, true) != nullptr; }

LedgerRow row(const Format& from, const Format& to) {
  LedgerRow result{&from, &to, {}, {}, {}, {}};
  for (const StoredModel& stored : from.models) {
    std::vector<std::string>& list = holds(to, stored.model) ? result.exact : result.fitted;
    if (std::ranges::find(list, stored.model) == list.end()) list.emplace_back(stored.model);
  }
  for (const Fact& fact : kFacts) {
    if (from.*fact.held && !(to.*fact.held)) result.dropped.emplace_back(fact.name);
  }
  for (const std::string_view value : to.defaulted) {
    if (!(value == "frame rate" && from.frame_rate)) result.defaulted.emplace_back(value);
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
