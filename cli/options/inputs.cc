// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.h"

#include "shell/words.h"
#include "words.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace fca::cli {

namespace {

/// "64,0,512,512"
std::optional<ImageRegion> parse_region(const std::string& text) {
  std::vector<int> numbers;
  for (const std::string& item : split(text)) {
    const std::optional<int> number = text::parse_int(item);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != 4) return std::nullopt;
  return ImageRegion{numbers[0], numbers[1], {numbers[2], numbers[3]}};
}

std::optional<std::string> take_region(const std::string& word, std::optional<ImageRegion>& target) {
  target = parse_region(word);
  if (target) return std::nullopt;
  return "--crop takes X,Y,WIDTH,HEIGHT in whole pixels, such as 64,0,512,512; got '" + word + "'";
}

/// "1,0" or "cam1"
std::vector<CameraChoice> parse_cameras(const std::string& list) {
  std::vector<CameraChoice> cameras;
  for (const std::string& item : split(list)) {
    const std::optional<int> number = text::parse_int(item);
    cameras.push_back({item, number && *number >= 0 ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt});
  }
  return cameras;
}

std::optional<std::string> take_opencv_model(const std::string& word, std::optional<OpenCvModel>& target) {
  for (const OpenCvModel model : {OpenCvModel::kPinhole, OpenCvModel::kFisheye}) {
    if (word == name_of(model)) target = model;
  }
  return target ? std::nullopt : std::optional("--opencv-model is pinhole or fisheye, not '" + word + "'");
}

std::optional<std::string> take_noise(const std::string& word, std::optional<NoiseKind>& target) {
  for (const NoiseKind kind :
       {NoiseKind::kContinuous, NoiseKind::kDiscrete, NoiseKind::kVariance, NoiseKind::kDiscreteVariance}) {
    if (word == name_of(kind)) target = kind;
  }
  if (target) return std::nullopt;
  return "--imu-noise is continuous, discrete, variance or discrete-variance, not '" + word + "'";
}

/// "IMAGE" or "CAMERA=IMAGE". The name of a file may hold a '=', too.
CameraImage parse_camera_image(const std::string& word) {
  const std::size_t equals = word.find('=');
  std::error_code error;
  if (equals == std::string::npos || std::filesystem::exists(word, error)) return {"", word};
  return {word.substr(0, equals), word.substr(equals + 1)};
}

std::optional<std::string> take_unit(const std::string& word, std::optional<double>& target) {
  constexpr std::array kUnits = {std::pair{"m", 1.0}, std::pair{"cm", 1e-2}, std::pair{"mm", 1e-3}};
  const auto* const unit = std::ranges::find_if(kUnits, [&word](const auto& each) { return word == each.first; });
  if (unit == kUnits.end()) return "--unit is m, cm or mm, not '" + word + "'";
  target = unit->second;
  return std::nullopt;
}

/// An option that makes something else of a file than it is.
struct ChangeOption {
  const char* name;
  bool (*is_given)(const Inputs& inputs);
};
constexpr std::array kChanges = {
    ChangeOption{"--join", [](const Inputs& inputs) { return inputs.join; }},
    ChangeOption{"--camera", [](const Inputs& inputs) { return inputs.cameras.has_value(); }},
    ChangeOption{"--crop", [](const Inputs& inputs) { return inputs.change.crop.has_value(); }},
    ChangeOption{"--binning", [](const Inputs& inputs) { return inputs.change.binning != 1; }},
    ChangeOption{"--resize", [](const Inputs& inputs) { return inputs.change.resize.has_value(); }},
};

}  // namespace

void add_input_options(Options& options, Inputs& inputs) {
  options.group(OptionGroup::kReading);
  options.value("--from", "FORMAT",
                "The input's format, one of fca-io formats, or a program's name (default: found by its content)",
                [&inputs](const std::string& word) { return take_format("--from", word, inputs.format); });
  options.each("--with", "FILE", "Another part of the same calibration, e.g. imu.yaml or results-cam.txt; repeatable",
               inputs.parts);
  options.value(
      "--camera", "LIST", "Only these cameras, in this order: 1,0 or cam1",
      [&inputs](const std::string& word) {
        inputs.cameras = parse_cameras(word);
        return std::nullopt;
      },
      OptionKey::kCameras);
  options.value("--size", "WxH",
                "Image size, for an input that contains none, or has a lens for each of several sizes: 640x480",
                [&inputs](const std::string& word) { return take_size("--size", word, inputs.image_size); });
  options.value("--unit", "m|cm|mm",
                "The unit of translations in files that do not contain it (OpenCV's, COLMAP's; default: metres)",
                [&inputs](const std::string& word) { return take_unit(word, inputs.length_unit_m); });
  options.value("--crop", "X,Y,W,H", "The images are this part of the calibrated images; applies before --binning and --resize",
                [&inputs](const std::string& word) { return take_region(word, inputs.change.crop); });
  options.whole_number("--binning", "N", "N x N pixels of the calibrated images became one pixel; applies before --resize",
                       [&inputs](int number) -> std::optional<std::string> {
                         inputs.change.binning = number;
                         return number < 1 ? std::optional("--binning wants a whole number from 1") : std::nullopt;
                       });
  options.value("--resize", "WxH", "The images are the calibrated images, scaled to this size",
                [&inputs](const std::string& word) { return take_size("--resize", word, inputs.change.resize); });
  options.value("--opencv-model", "pinhole|fisheye", "The lens model, for OpenCV files with four coefficients",
                [&inputs](const std::string& word) { return take_opencv_model(word, inputs.opencv_model); });
  options.group(OptionGroup::kLens);
  options.number("--max-angle", "DEG", "Where the lens ends, in degrees from the axis (default: the whole image counts)",
                 [&inputs](double degrees) -> std::optional<std::string> {
                   if (!(degrees > 0.0 && degrees <= 180.0)) return "--max-angle wants degrees from the axis in (0, 180]";
                   inputs.max_angle_rad = degrees / kDegreesPerRadian;
                   return std::nullopt;
                 });
}

void add_lens_circle_option(Options& options, Inputs& inputs) {
  options.group(OptionGroup::kLens);
  options.each("--lens-circle", "[CAMERA=]IMAGE",
               "Where the lens ends: at the image circle in this image of the camera (with several cameras: cam0=IMAGE); "
               "repeatable, for dark scenes",
               [&inputs](const std::string& word) {
                 inputs.lens_circles.push_back(parse_camera_image(word));
                 return std::nullopt;
               });
  options.afterwards([&inputs]() -> std::optional<std::string> {
    if (inputs.lens_circles.empty() || !inputs.max_angle_rad) return std::nullopt;
    return "--max-angle and --lens-circle both set where the lens ends; give one of them";
  });
}

void add_join_option(Options& options, Inputs& inputs) {
  options.group(OptionGroup::kReading);
  options.flag("--join", "All inputs are the cameras of one rig, in the order given", inputs.join);
}

void add_imu_rate_option(Options& options, Inputs& inputs) {
  options.group(OptionGroup::kReading);
  options.number("--imu-rate", "HZ", "The IMU's rate, for an input that does not contain it (VINS-Fusion's configuration)",
                 [&inputs](double rate_hz) -> std::optional<std::string> {
                   constexpr double kSlowest = 0.1;
                   constexpr double kFastest = 1e6;
                   if (!(rate_hz >= kSlowest && rate_hz <= kFastest))
                     return "--imu-rate wants samples per second from 0.1 to 1e6";
                   inputs.imu_rate_hz = rate_hz;
                   return std::nullopt;
                 });
}

void add_imu_option(Options& options, Inputs& inputs) {
  add_imu_rate_option(options, inputs);
  options.value("--imu-noise", "KIND",
                "The kind of the input's IMU noise: continuous (densities, the default), discrete (standard deviations of "
                "single samples, converted with the rate), variance or discrete-variance (squares of those)",
                [&inputs](const std::string& word) { return take_noise(word, inputs.imu_noise); });
}

std::vector<std::string> given_changes(const Inputs& inputs) {
  std::vector<std::string> names;
  for (const ChangeOption& option : kChanges) {
    if (option.is_given(inputs)) names.emplace_back(option.name);
  }
  return names;
}

std::vector<std::string> all_changes() {
  std::vector<std::string> names;
  names.reserve(kChanges.size());
  for (const ChangeOption& option : kChanges) names.emplace_back(option.name);
  return names;
}

std::ptrdiff_t reads_of_standard_input(const std::vector<std::string>& files) {
  return std::ranges::count_if(files, [](const std::string& file) { return is_standard_input(file); });
}

std::vector<Inputs> grouped(const Inputs& inputs) {
  if (inputs.join) return {inputs};
  std::vector<Inputs> groups;
  for (const std::string& file : inputs.files) {
    groups.push_back(inputs);
    groups.back().files = {file};
  }
  return groups;
}

}  // namespace fca::cli
