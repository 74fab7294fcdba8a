// SPDX-License-Identifier: BSD-3-Clause
#include "option_use.h"

#include "shell/words.h"

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

struct FormatOption {
  std::string_view name;
  bool (*given)(const WritingOptions&);
  bool (*used)(const Format&);
};

bool any(const Format& /*format*/) { return true; }
bool has_opencv_layouts(const Format& format) { return format.id == "opencv"; }
bool has_orbslam3_layouts(const Format& format) { return format.id == "orbslam3"; }

constexpr std::array kOptions = {
    FormatOption{"--sensor", [](const WritingOptions& a) { return !a.sensor.empty(); },
                 [](const Format& format) { return !format.modes.empty(); }},
    FormatOption{"--orbslam3-layout", [](const WritingOptions& a) { return !a.orbslam3_layout.empty(); }, has_orbslam3_layouts},
    FormatOption{"--opencv-layout", [](const WritingOptions& a) { return !a.opencv_layout.empty(); }, has_opencv_layouts},
    FormatOption{"--fps", [](const WritingOptions& a) { return a.fps.has_value(); },
                 [](const Format& format) { return format.frame_rate; }},
    FormatOption{"--baseline", [](const WritingOptions& a) { return a.baseline_m.has_value(); },
                 [](const Format& format) { return format.baseline; }},
    FormatOption{"--set", [](const WritingOptions& a) { return !a.settings.empty(); }, any},
    FormatOption{"--anew", [](const WritingOptions& a) { return a.anew; }, any},
};

}  // namespace

std::optional<std::string> option_without_use(const WritingOptions& options, const Format& to) {
  for (const FormatOption& option : kOptions) {
    if (!option.given(options) || option.used(to)) continue;
    std::vector<std::string> users;
    for (const Format& format : all_formats()) {
      if (option.used(format)) users.emplace_back(format.id);
    }
    return std::string(option.name) + " is for --to " + enumerated(users, "or") + ", not " + std::string(to.id);
  }
  return std::nullopt;
}

std::optional<std::string> option_without_file(const WritingOptions& options) {
  if (!options.to.empty() || !options.into.empty()) return std::nullopt;
  const auto given = std::ranges::find_if(kOptions, [&](const FormatOption& option) { return option.given(options); });
  if (given == kOptions.end()) return std::nullopt;
  return std::string(given->name) + " says something about a written file; say with --to FORMAT which one";
}

std::optional<std::string> opencv_model_without_use(const ConvertArguments& arguments,
                                                    std::span<const ConvertOutcome> outcomes) {
  if (arguments.reading.opencv_model.empty() || !arguments.reading.with.empty()) return std::nullopt;
  const auto of_opencv = [](const Format* format) { return format == nullptr || format->id == "opencv"; };
  if (std::ranges::any_of(outcomes, [&](const ConvertOutcome& outcome) {
        return of_opencv(outcome.from) || of_opencv(outcome.to) || !outcome.one_format;
      }))
    return std::nullopt;
  return "--opencv-model is for OpenCV files, and " + outcomes.front().input + " is " +
         std::string(outcomes.front().from->title);
}

}  // namespace fca::cli
