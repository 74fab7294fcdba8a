// SPDX-License-Identifier: BSD-3-Clause
#include "writing_options.h"

#include "option_use.h"
#include "shell/words.h"
#include "toolkit/reading.h"

#include <fca/rig/limits.h>

#include <algorithm>
#include <set>
#include <span>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

/// An option that is one format's own, as an error if that one does not know the value.
std::optional<std::string> not_among(const std::string& value, std::string_view kind, std::string_view owner,
                                     std::span<const std::string_view> Format::*values) {
  if (value.empty()) return std::nullopt;
  const Format* format = find_format(owner);
  const std::span<const std::string_view> known = format != nullptr ? format->*values : std::span<const std::string_view>();
  if (std::ranges::find(known, value) != known.end()) return std::nullopt;
  const std::vector<std::string> names(known.begin(), known.end());
  return unknown_word(kind, value, names);
}

/// The key of two settings.
std::optional<std::string> key_set_twice(const std::vector<std::string>& settings) {
  std::set<std::string> keys;
  for (const std::string& setting : settings) {
    const std::string key = setting.substr(0, setting.find('='));
    if (!keys.insert(key).second) return key;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> problem_with(const WritingOptions& options) {
  if (!options.to.empty() && find_format(options.to) == nullptr) return unknown_format(options.to);
  if (!options.model.empty() && find_model(options.model) == nullptr) return unknown_model(options.model);
  if (options.objective != "rms" && options.objective != "max")
    return "unknown objective '" + options.objective + "'; there are rms and max";
  if (options.fps && !(*options.fps > 0.0 && *options.fps < 1e6)) return "--fps wants a rate in Hz, more than 0 and below 1e6";
  if (options.baseline_m && problem_with_baseline(*options.baseline_m)) return "--baseline wants a positive number of metres";
  for (const std::string& setting : options.settings) {
    if (setting.find('=') == std::string::npos || setting.starts_with('='))
      return "--set wants KEY=VALUE, such as Viewer.PointSize=3.0; got '" + setting + "'";
  }
  if (const std::optional<std::string> twice = key_set_twice(options.settings))
    return "--set " + *twice + " comes twice; one value can stand there";
  if (const Format* to = find_format(options.to)) {
    if (const auto error = option_without_use(options, *to)) return error;
  }
  if (const auto error = not_among(options.sensor, "sensor mode", "orbslam3", &Format::modes)) return error;
  if (const auto error = not_among(options.orbslam3_layout, "layout", "orbslam3", &Format::layouts)) return error;
  return not_among(options.opencv_layout, "layout", "opencv", &Format::layouts);
}

void add_writing_options(CLI::App& command, WritingOptions& options) {
  command
      .add_option(
          "--sensor", options.sensor,
          "orbslam3: mono, stereo, rgbd, mono-inertial, stereo-inertial or rgbd-inertial (default: the richest the input "
          "serves)")
      ->type_name("MODE");
  command
      .add_option("--orbslam3-layout", options.orbslam3_layout,
                  "v1 (stock V1.0), old (before V1.0), orbslam2 or slam_no_opt (default: the input's, else v1)")
      ->type_name("LAYOUT");
  command
      .add_option("--opencv-layout", options.opencv_layout,
                  "calibration, stereo, omnidir, cameras or left-right (default: what the cameras need)")
      ->type_name("LAYOUT");
  command.add_option("--into", options.into, "Write what the input says into this file's text; its format is --to")
      ->type_name("BASE");
  command
      .add_option("--objective", options.objective,
                  "What a fit makes small: rms, or max, the error of the worst pixel (the report says what that costs in rms)")
      ->type_name("rms|max");
  command.add_flag("--every-pixel", options.every_pixel, "Judge by every pixel, not by a lattice of about 5,000 points");
  command.add_flag("--anew", options.anew, "Write a fresh file even where the input's own text could be edited; comments go");
  command.add_option("--fps", options.fps, "Frame rate, for formats that state it")->type_name("HZ")->check(decimal_number());
  command.add_option("--baseline", options.baseline_m, "Baseline of a rectified pair or depth sensor")
      ->type_name("METRES")
      ->check(decimal_number());
  take_one_each_time(
      *command
           .add_option("--set", options.settings,
                       "A value of the written file that no calibration states; KEY may be nested (cam0/rostopic); repeatable")
           ->type_name("KEY=VALUE"));
}

}  // namespace fca::cli
