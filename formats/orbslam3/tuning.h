// SPDX-License-Identifier: BSD-3-Clause
// Keys that tune ORB-SLAM or describe its images and say nothing of the geometry. What an input specifies is kept through a
// change of style or sensor; for the rest upstream's example values are written, and said.
#pragma once

#include "layout.h"

#include "../fields.h"

#include <fca/formats/format.h>

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace fca::orbslam3 {

/// One such key.
struct TuningKey {
  std::string_view key;        ///< V1.0's name
  std::string_view old_key;    ///< the name before V1.0
  bool whole = false;          ///< An int to the parsers; else a real.
  double upstream = 0.0;       ///< Value in upstream's Examples/*/*.yaml; none for optional keys.
  bool optional = false;       ///< Upstream's value is not written where the input specifies none.
  std::string_view note = {};  ///< What to tell people, in a comment, next to a value that no input specifies.
  bool look_at_it = false;     ///< They must check it; the others are tuning.
  /// What makes sense: the first positive double for sizes, rates and thresholds that are divided by or drawn with.
  double lowest = std::numeric_limits<double>::min();
  double highest = 1e9;
};

namespace tuning_key {
inline constexpr TuningKey kColourOrder{
    "Camera.RGB", "Camera.RGB", true,
    1.0,          false,        "Default. Colour order (0: BGR, 1: RGB; no matter for grey images): not in the input.",
    true,         0.0,          1.0};
inline constexpr TuningKey kThDepth{
    "Stereo.ThDepth", "ThDepth", false, 40.0, false, "Default. Close/far threshold in baselines: tuning, upstream's value."};
inline constexpr TuningKey kDepthMapFactor{"RGBD.DepthMapFactor",
                                           "DepthMapFactor",
                                           false,
                                           1000.0,
                                           false,
                                           "Default. Depth image units per metre: not in the input. Set your sensor's.",
                                           true};
/// Columns of each image that both cameras see.
inline constexpr std::string_view kOverlapNote = "Column range that both cameras see, from their poses and fields of view.";
inline constexpr TuningKey kOverlapBegin1{
    "Camera1.overlappingBegin", "Camera.lappingBegin", true, 0.0, true, kOverlapNote, false, 0.0};
inline constexpr TuningKey kOverlapEnd1{
    "Camera1.overlappingEnd", "Camera.lappingEnd", true, 0.0, true, kOverlapNote, false, 0.0};
inline constexpr TuningKey kOverlapBegin2{
    "Camera2.overlappingBegin", "Camera2.lappingBegin", true, 0.0, true, kOverlapNote, false, 0.0};
inline constexpr TuningKey kOverlapEnd2{
    "Camera2.overlappingEnd", "Camera2.lappingEnd", true, 0.0, true, kOverlapNote, false, 0.0};
/// Of the first camera and of the second.
struct OverlapKeys {
  const TuningKey* begin;
  const TuningKey* end;
};
inline constexpr std::array kOverlap = {OverlapKeys{&kOverlapBegin1, &kOverlapEnd1},
                                        OverlapKeys{&kOverlapBegin2, &kOverlapEnd2}};
inline constexpr TuningKey kInsertKeyFrames{"IMU.InsertKFsWhenLost", "InsertKFsWhenLost", true, 0.0, true, {}, false, 0.0, 1.0};
}  // namespace tuning_key

/// Format::range_of
[[nodiscard]] std::optional<ValueRange> range_of(std::string_view key, const Rig& rig);

/// Format::optional_value
[[nodiscard]] std::optional<ValueType> optional_value(const text::Document& document, std::string_view key);

/// ORBextractor.* and Viewer.*, in upstream's order: every mode exits without them.
[[nodiscard]] std::span<const TuningKey> program_tuning();

/// What one input specifies of them.
class Tuning {
 public:
  Tuning() = default;
  explicit Tuning(const text::Document& document);

  /// Does the input specify it?
  [[nodiscard]] bool states(const TuningKey& key) const { return stated_.contains(key.key); }
  /// What the input specifies of the columns that both cameras see, as those of other cameras: `from` tells for the first and
  /// the second which of the input's it is; nothing where its images are others, and their columns are forgotten.
  void move_overlap(const std::array<std::optional<std::size_t>, 2>& from);
  /// What another program's file specifies in its own words.
  void take(const TuningKey& key, double value) { stated_.emplace(key.key, value); }
  /// The value that the input specifies.
  [[nodiscard]] std::optional<double> stated(const TuningKey& key) const;
  /// The key as that style spells it, with the input's value, else with `otherwise`, else with upstream's.
  [[nodiscard]] fields::Field field(const TuningKey& key, Style style, std::optional<double> otherwise = {}) const;

 private:
  std::map<std::string_view, double> stated_;  ///< By V1.0's name.
};

/// The row of a key in either spelling; null if it is none.
[[nodiscard]] const TuningKey* find_tuning_key(std::string_view key);

}  // namespace fca::orbslam3
