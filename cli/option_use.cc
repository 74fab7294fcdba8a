// SPDX-License-Identifier: BSD-3-Clause
#include "option_use.h"

#include "words.h"

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

struct FormatOption {
  std::string_view name;
  bool (*given)(const ConvertArguments&);
  bool (*used)(const Format&);
};

bool has_opencv_layouts(const Format& format) { return format.id == "opencv"; }
bool has_orbslam3_layouts(const Format& format) { return format.id == "orbslam3"; }

constexpr std::array kOptions = {
    FormatOption{"--sensor", [](const ConvertArguments& a) { return !a.sensor.empty(); },
                 [](const Format& format) { return !format.modes.empty(); }},
    FormatOption{"--orbslam3-layout", [](const ConvertArguments& a) { return !a.orbslam3_layout.empty(); },
                 has_orbslam3_layouts},
    FormatOption{"--opencv-layout", [](const ConvertArguments& a) { return !a.opencv_layout.empty(); }, has_opencv_layouts},
    FormatOption{"--fps", [](const ConvertArguments& a) { return a.fps.has_value(); },
                 [](const Format& format) { return format.frame_rate; }},
    FormatOption{"--baseline", [](const ConvertArguments& a) { return a.baseline_m.has_value(); },
                 [](const Format& format) { return format.baseline; }},
};

}  // namespace

std::optional<std::string> option_without_use(const ConvertArguments& arguments, const Format& to) {
  for (const FormatOption& option : kOptions) {
    if (!option.given(arguments) || option.used(to)) continue;
    std::vector<std::string> users;
    for (const Format& format : all_formats()) {
      if (option.used(format)) users.emplace_back(format.id);
    }
    return std::string(option.name) + " is for --to " + enumerated(users, "or") + ", not " + std::string(to.id);
  }
  return std::nullopt;
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
