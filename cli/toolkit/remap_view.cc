// SPDX-License-Identifier: BSD-3-Clause
#include "remap_view.h"

#include "shell/words.h"

#include <fca/convert/convert.h>
#include <fca/formats/text/numbers.h>
#include <fca/remap/view.h>

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

/// "yaw,pitch,roll" in degrees.
std::optional<std::array<double, 3>> parse_turn(const std::string& text) {
  const std::vector<std::string> words = CLI::detail::split(text, ',');
  std::array<double, 3> angles{};
  if (words.size() != angles.size()) return std::nullopt;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::optional<double> angle = text::parse_real(words[i]);
    constexpr double kFullTurn = 360.0;
    if (!angle || !(std::abs(*angle) <= kFullTurn)) return std::nullopt;
    angles.at(i) = *angle;
  }
  return angles;
}

/// The camera of --like: that of the same name, or the only one.
std::optional<Camera> like(const std::string& file, const std::string& name, Console& console, Diagnostics& diagnostics) {
  const std::optional<Calibration> calibration = read_input(file, {}, console, diagnostics);
  if (!calibration) return std::nullopt;
  const std::vector<Camera>& cameras = calibration->rig.cameras;
  const auto same = std::ranges::find(cameras, name, &Camera::name);
  if (cameras.size() == 1) return cameras.front();
  if (same != cameras.end()) return *same;
  std::vector<std::string> names;
  names.reserve(cameras.size());
  for (const Camera& camera : cameras) names.push_back(camera.name);
  diagnostics.error("unknown-camera",
                    "--like wants a file with one camera, or with one named " + name + "; this one has " +
                        (names.empty() ? "none" : enumerated(names)),
                    {file, 0, 0});
  return std::nullopt;
}

std::optional<Camera> as_model(const RemapArguments& arguments, const Camera& source, Diagnostics& diagnostics) {
  ConvertOptions options;
  options.model = arguments.model;
  options.max_angle_rad = max_angle_rad(arguments.reading);
  options.bound = false;
  std::optional<Conversion> conversion = convert(source, options, diagnostics);
  if (!conversion) return std::nullopt;
  return std::move(conversion->camera);
}

}  // namespace

std::optional<std::string> problem_with_view(const RemapArguments& arguments) {
  const int cameras = (arguments.model.empty() ? 0 : 1) + (arguments.like.empty() ? 0 : 1) + (arguments.pinhole_deg ? 1 : 0);
  if (cameras > 1) return "--model, --like and --pinhole each say what the image is to look like; give one of them";
  if (cameras == 0 && arguments.rotate.empty())
    return "say what the image is to look like: --pinhole FULL_FOV_DEG, --model MODEL, --like FILE or --rotate YAW,PITCH,ROLL";
  if (!arguments.model.empty() && find_model(arguments.model) == nullptr) return unknown_model(arguments.model);
  if (arguments.pinhole_deg && !(*arguments.pinhole_deg > 0.0 && *arguments.pinhole_deg < 180.0))
    return "--pinhole wants the full field of view in degrees, more than 0 and less than 180";
  if (!arguments.rotate.empty() && !parse_turn(arguments.rotate))
    return "--rotate wants YAW,PITCH,ROLL in degrees, each from -360 to 360, such as 30,0,0; got '" + arguments.rotate + "'";
  if (!arguments.out_size.empty() && !arguments.pinhole_deg) return "--out-size is for --pinhole";
  if (!arguments.out_size.empty() && !parse_size(arguments.out_size))
    return "--out-size wants WIDTHxHEIGHT in whole pixels, such as 640x480; got '" + arguments.out_size + "'";
  return std::nullopt;
}

std::optional<RemapView> view_of(const RemapArguments& arguments, const Camera& source, Console& console,
                                 Diagnostics& diagnostics) {
  RemapView view{source, {}};
  std::optional<Camera> camera = source;
  if (!arguments.model.empty()) camera = as_model(arguments, source, diagnostics);
  if (!arguments.like.empty()) camera = like(arguments.like, source.name, console, diagnostics);
  if (!camera) return std::nullopt;
  if (arguments.pinhole_deg) {
    if (const std::optional<ImageSize> size = parse_size(arguments.out_size)) camera->image_size = size;
    camera->model = pinhole_of_view(*camera->image_size, *arguments.pinhole_deg / kDegreesPerRadian);
  }
  view.camera = *std::move(camera);
  if (!arguments.rotate.empty()) {
    const auto [yaw, pitch, roll] = parse_turn(arguments.rotate).value_or(std::array<double, 3>{});
    view.T_source_view = turned(yaw / kDegreesPerRadian, pitch / kDegreesPerRadian, roll / kDegreesPerRadian);
  }
  return view;
}

}  // namespace fca::cli
