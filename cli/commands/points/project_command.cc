// SPDX-License-Identifier: BSD-3-Clause
#include "project_command.h"

#include "options/points.h"
#include "shell/json.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/toolkit/read.h>

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <istream>
#include <limits>
#include <numbers>

namespace fca::cli {

namespace {

/// 17 significant digits, as scripts compare them.
std::string digits17(double value) {
  std::array<char, 40> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 17);
  return {buffer.data(), result.ptr};
}

/// Exactly N numbers, separated by blanks, TABs or commas.
template <std::size_t N>
std::optional<std::array<double, N>> parse_numbers(std::string_view line) {
  std::array<double, N> numbers{};
  std::size_t count = 0;
  for (std::size_t at = line.find_first_not_of(" \t\r,"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t\r,", at), line.size());
    const std::string_view word = line.substr(at, end - at);
    // What `project` itself prints where there is no answer may come back.
    const std::optional<double> number =
        word == "nan" || word == "-nan" ? std::numeric_limits<double>::quiet_NaN() : text::parse_real(word);
    if (!number || count == N) return std::nullopt;
    numbers[count++] = *number;
    at = line.find_first_not_of(" \t\r,", end);
  }
  return count == N ? std::optional(numbers) : std::nullopt;
}

/// Where one line goes: ray -> pixel or pixel -> ray; nothing where the model has no answer.
template <std::size_t In, std::size_t Out>
using Mapping = std::function<std::optional<std::array<double, Out>>(const std::array<double, In>&)>;

template <std::size_t In, std::size_t Out>
ExitCode map_lines(const Mapping<In, Out>& mapping, bool as_json, Console& console) {
  Json json;
  std::vector<std::optional<std::array<double, Out>>> results;
  std::string line;
  for (int number = 1; std::getline(console.in(), line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
    const std::optional<std::array<double, In>> numbers = parse_numbers<In>(line);
    if (!numbers) {
      constexpr std::size_t kLongestQuote = 60;
      return console.refuse(ExitCode::kBadInput, "standard input, line " + std::to_string(number) + " must have " +
                                                     std::to_string(In) + " numbers, but is '" + line.substr(0, kLongestQuote) +
                                                     "'");
    }
    bool finite = true;
    for (const double v : *numbers) finite = finite && std::isfinite(v);
    const std::optional<std::array<double, Out>> result = finite ? mapping(*numbers) : std::nullopt;
    if (as_json) {
      results.push_back(result);
      continue;
    }
    std::string text;
    for (std::size_t i = 0; i < Out; ++i) text += (i > 0 ? " " : "") + (result ? digits17((*result)[i]) : std::string("nan"));
    console.out(text + "\n");
    if (console.failed()) break;
  }
  if (as_json) {
    json.object([&] {
      json.put("fca_io", FCA_VERSION);
      json.array(Out == 2 ? "pixels" : "rays", results, [&](const auto& result) {
        json.object([&] {
          constexpr std::array<const char*, 3> kNames = Out == 2 ? std::array{"u", "v", ""} : std::array{"x", "y", "z"};
          for (std::size_t i = 0; i < Out; ++i) result ? json.put(kNames[i], (*result)[i]) : json.null(kNames[i]);
        });
      });
    });
    console.out(json.document());
  }
  return ExitCode::kGood;
}

ExitCode run_mapping(const ProjectArguments& arguments, bool forwards, Console& console) {
  const CameraReading reading = read_camera(arguments.inputs, console.files());
  if (!reading.camera) return console.refuse(exit_code(reading.status), reading.diagnostics);
  console.show(reading.diagnostics);
  const CameraModel& model = reading.camera->model;
  const double limit_rad = arguments.inputs.max_angle_rad.value_or(std::numbers::pi);
  if (forwards) {
    const Mapping<3, 2> to_pixel = [&](const Ray& ray) {
      return angle_from_axis(ray) <= limit_rad ? project(model, ray) : std::nullopt;
    };
    return map_lines(to_pixel, arguments.json, console);
  }
  const Mapping<2, 3> to_ray = [&](const Pixel& pixel) {
    const std::optional<Ray> ray = unproject(model, pixel);
    return ray && angle_from_axis(*ray) <= limit_rad ? ray : std::nullopt;
  };
  return map_lines(to_ray, arguments.json, console);
}

/// One of the two: they differ in the way they go.
struct Direction {
  const char* name;
  const char* what;
  const char* footer;
  bool forwards;
};

constexpr std::array kDirections = {
    Direction{"project", "Rays 'x y z' per line on standard input -> pixels 'u v'; 'nan nan' where the model has no answer",
              "Example:\n  echo '0.1 0.2 1' | fca-io project camchain.yaml --camera cam0\n", true},
    Direction{"unproject",
              "Pixels 'u v' per line on standard input -> unit rays 'x y z'; 'nan nan nan' where the model has no answer",
              "Example:\n  echo '320 240' | fca-io unproject camchain.yaml --camera cam0\n", false}};

}  // namespace

void add_project_commands(Application& application) {
  for (const Direction& direction : kDirections) {
    application.add<ProjectArguments>(
        direction.name, direction.what,
        [&direction](Options& options, ProjectArguments& arguments) {
          add_project_options(options, direction.footer, arguments);
        },
        [&direction](const ProjectArguments& arguments, Console& console) {
          return run_mapping(arguments, direction.forwards, console);
        });
  }
}

}  // namespace fca::cli
