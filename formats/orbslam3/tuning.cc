// SPDX-License-Identifier: BSD-3-Clause
#include "tuning.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace fca::orbslam3 {

namespace {

constexpr TuningKey same_name(std::string_view key, bool whole, double upstream, bool optional = false) {
  return {key, key, whole, upstream, optional};
}

constexpr TuningKey within(TuningKey key, double lowest, double highest) {
  key.lowest = lowest;
  key.highest = highest;
  return key;
}

constexpr double kBrightest = 255.0;
constexpr double kFar = 1e6;  // of the viewer's camera, metres

constexpr std::array kProgramTuning = {
    within(same_name("ORBextractor.nFeatures", true, 1000.0), 1.0, 1e6),
    within(same_name("ORBextractor.scaleFactor", false, 1.2), 1.001, 10.0),
    within(same_name("ORBextractor.nLevels", true, 8.0), 1.0, 64.0),
    within(same_name("ORBextractor.iniThFAST", true, 20.0), 1.0, kBrightest),
    within(same_name("ORBextractor.minThFAST", true, 7.0), 1.0, kBrightest),
    same_name("Viewer.KeyFrameSize", false, 0.05),
    same_name("Viewer.KeyFrameLineWidth", false, 1.0),
    same_name("Viewer.GraphLineWidth", false, 0.9),
    same_name("Viewer.PointSize", false, 2.0),
    same_name("Viewer.CameraSize", false, 0.08),
    same_name("Viewer.CameraLineWidth", false, 3.0),
    within(same_name("Viewer.ViewpointX", false, 0.0), -kFar, kFar),
    within(same_name("Viewer.ViewpointY", false, -0.7), -kFar, kFar),
    within(same_name("Viewer.ViewpointZ", false, -3.5), -kFar, kFar),
    same_name("Viewer.ViewpointF", false, 500.0),
    same_name("Viewer.imageViewScale", false, 0.0, true),
    TuningKey{"System.thFarPoints", "thFarPoints", false, 0.0, true},
};

constexpr std::array kOthers = {tuning_key::kColourOrder,   tuning_key::kThDepth,        tuning_key::kDepthMapFactor,
                                tuning_key::kOverlapBegin1, tuning_key::kOverlapEnd1,    tuning_key::kOverlapBegin2,
                                tuning_key::kOverlapEnd2,   tuning_key::kInsertKeyFrames};

/// The number under a key, if a key of that type can hold it.
std::optional<double> number_at(const text::Document& document, std::string_view key, bool whole) {
  const text::Node* node = find_key(document, key);
  const std::optional<double> value =
      node != nullptr && node->is_scalar() && !node->quoted ? text::parse_real(node->value) : std::nullopt;
  constexpr double kLargestInt = 2147483647.0;
  if (!value || !std::isfinite(*value) || (whole && std::abs(*value) > kLargestInt)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<ValueRange> range_of(std::string_view key, const Rig& rig) {
  constexpr ValueRange kFrameRate = {1.0, 1e6};
  if (key == "Camera.fps") return kFrameRate;
  const TuningKey* row = find_tuning_key(key);
  if (row == nullptr) return std::nullopt;
  ValueRange range = {row->lowest, row->highest};
  const bool is_column = row->note == tuning_key::kOverlapNote;
  if (is_column && !rig.cameras.empty() && rig.cameras.front().image_size)
    range.highest = rig.cameras.front().image_size->width - 1.0;
  return range;
}

std::optional<ValueType> optional_value(const text::Document& document, std::string_view key) {
  // Settings.cc of V1.0, readLoadAndSave.
  constexpr std::array<std::string_view, 2> kFilesOfTheMap = {"System.LoadAtlasFromFile", "System.SaveAtlasToFile"};
  const bool v1 = style_of(document) == Style::kV1;
  if (v1 && std::ranges::find(kFilesOfTheMap, key) != kFilesOfTheMap.end()) return ValueType::kText;
  const TuningKey* row = find_tuning_key(key);
  // The columns that both cameras see are a stereo pair's, whose settings specify them.
  if (row == nullptr || !row->optional || row->note == tuning_key::kOverlapNote || key != (v1 ? row->key : row->old_key))
    return std::nullopt;
  return row->whole ? ValueType::kInteger : ValueType::kReal;
}

std::span<const TuningKey> program_tuning() { return kProgramTuning; }

const TuningKey* find_tuning_key(std::string_view key) {
  const auto named = [key](const TuningKey& row) { return row.key == key || row.old_key == key; };
  for (const std::span<const TuningKey> rows : {std::span<const TuningKey>(kOthers), program_tuning()}) {
    const auto found = std::ranges::find_if(rows, named);
    if (found != rows.end()) return &*found;
  }
  return nullptr;
}

Tuning::Tuning(const text::Document& document) {
  for (const text::Entry& entry : document.root().entries) {
    const TuningKey* row = find_tuning_key(entry.key.value);
    if (row == nullptr) continue;
    if (const std::optional<double> value = number_at(document, entry.key.value, row->whole)) stated_.emplace(row->key, *value);
  }
}

void Tuning::move_overlap(const std::array<std::optional<std::size_t>, 2>& from) {
  const std::map<std::string_view, double> before = stated_;
  const auto move = [&](const TuningKey& to, const TuningKey* source) {
    stated_.erase(to.key);
    const auto found = source != nullptr ? before.find(source->key) : before.end();
    if (found != before.end()) stated_.emplace(to.key, found->second);
  };
  for (std::size_t i = 0; i < from.size(); ++i) {
    const tuning_key::OverlapKeys* source = from.at(i) ? &tuning_key::kOverlap.at(*from.at(i)) : nullptr;
    move(*tuning_key::kOverlap.at(i).begin, source != nullptr ? source->begin : nullptr);
    move(*tuning_key::kOverlap.at(i).end, source != nullptr ? source->end : nullptr);
  }
}

std::optional<double> Tuning::stated(const TuningKey& key) const {
  const auto found = stated_.find(key.key);
  return found == stated_.end() ? std::nullopt : std::optional(found->second);
}

fields::Field Tuning::field(const TuningKey& key, Style style, std::optional<double> otherwise) const {
  const auto found = stated_.find(key.key);
  const double value = found != stated_.end() ? found->second : otherwise.value_or(key.upstream);
  std::string name(style == Style::kV1 ? key.key : key.old_key);
  return key.whole ? fields::integer(std::move(name), static_cast<int>(std::lround(value)))
                   : fields::real(std::move(name), value);
}

}  // namespace fca::orbslam3
