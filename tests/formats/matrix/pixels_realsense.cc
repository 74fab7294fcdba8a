// SPDX-License-Identifier: BSD-3-Clause
// What rs-enumerate-devices -c prints of streams with one size each, and realsense-rust's structures, by
// rs2_project_point_to_pixel (MORE-FORMATS-2.md section 20.2): Brown Conrady is OpenCV's, Kannala Brandt4 its fisheye's, Ftheta
// the FOV model; an extrinsic takes points of the first stream to the second, in metres.
#include "pixels_realsense.h"

#include "opencv_lens.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace fca::matrix::realsense {

namespace {

struct Stream {
  std::string name;
  std::map<std::string, std::string> values;
};

struct Extrinsic {
  std::string from;
  std::string to;
  Pose pose;
};

struct Device {
  std::vector<Stream> streams;
  std::vector<Extrinsic> extrinsics;
};

std::vector<double> numbers_in(std::string text) {
  for (char& c : text) {
    if (c == ',' || c == '[' || c == ']') c = ' ';
  }
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) numbers.push_back(number);
  return numbers;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return "";
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

Device rust(const std::string& bytes) {
  Device device;
  std::istringstream stream(bytes);
  for (std::string line; std::getline(stream, line);) {
    if (line.find("rs2_intrinsics") != std::string::npos) {
      Stream& found = device.streams.emplace_back();
      found.name = line.substr(0, line.find(' '));
      for (const auto& [key, rust_key] : {std::pair{"Width", "width"},
                                          {"Height", "height"},
                                          {"PPX", "ppx"},
                                          {"PPY", "ppy"},
                                          {"Fx", "fx"},
                                          {"Fy", "fy"},
                                          {"Distortion", "model"}})
        found.values[key] = between(line, std::string(" ") + rust_key + ": ", ",");
      found.values["Coeffs"] = between(line, "coeffs: [", "]");
    } else if (line.find("rs2_extrinsics") != std::string::npos) {
      const std::vector<double> R = numbers_in(between(line, "rotation: [", "]"));
      const std::vector<double> t = numbers_in(between(line, "translation: [", "]"));
      Extrinsic& found = device.extrinsics.emplace_back();
      found.from = line.substr(0, line.find(" to "));
      found.to = between(line, " to ", ":");
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) found.pose[row][column] = R[3 * column + row];
        found.pose[row][3] = t[row];
      }
    }
  }
  return device;
}

Device printed(const std::string& bytes) {
  Device device;
  std::istringstream stream(bytes);
  bool in_stream = false;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    line = line.substr(first);
    if (line.starts_with("Intrinsic of")) {
      device.streams.push_back({between(line, "\"", "\""), {}});
      in_stream = true;
    } else if (line.starts_with("Motion Intrinsic") || line.starts_with("Extrinsic Parameters")) {
      in_stream = false;
    } else if (line.starts_with("Extrinsic from")) {
      in_stream = false;
      const std::string rest = line.substr(line.find("To"));
      device.extrinsics.push_back({between(line, "\"", "\""), between(rest, "\"", "\""), {}});
      std::getline(stream, line);  // Rotation Matrix:
      for (std::size_t row = 0; row < 3; ++row) {
        std::getline(stream, line);
        const std::vector<double> numbers = numbers_in(line);
        for (std::size_t column = 0; column < 3; ++column) device.extrinsics.back().pose[row][column] = numbers[column];
      }
    } else if (line.starts_with("Translation Vector:")) {
      const std::vector<double> t = numbers_in(line.substr(line.find(':') + 1));
      for (std::size_t row = 0; row < 3; ++row) device.extrinsics.back().pose[row][3] = t[row];
    } else if (in_stream && line.find(':') != std::string::npos) {
      const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
      device.streams.back().values[line.substr(0, line.find(':'))] =
          line.substr(value, line.find_last_not_of(" \t\r") + 1 - value);
    }
  }
  return device;
}

Device device_of(const std::string& bytes) {
  Device device = bytes.find("rs2_intrinsics") != std::string::npos ? rust(bytes) : printed(bytes);
  // Images of depth are computed from those of Infrared 1, and are no camera of their own.
  const auto infrared = std::ranges::find_if(device.streams, [](const Stream& stream) { return stream.name == "Infrared 1"; });
  if (infrared != device.streams.end()) {
    const Stream lens = *infrared;
    std::erase_if(device.streams,
                  [&lens](const Stream& stream) { return stream.name == "Depth" && stream.values == lens.values; });
  }
  std::ranges::stable_partition(device.streams, [](const Stream& stream) { return stream.name.starts_with("Infrared"); });
  return device;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  Device device = device_of(bytes);
  if (index >= device.streams.size()) return std::nullopt;
  auto& values = device.streams[index].values;
  const std::vector<double> D = numbers_in(values["Coeffs"]);
  RayToPixel lens = pinhole(D);
  if (values["Distortion"] == "Kannala Brandt4") lens = fisheye(D);
  if (values["Distortion"] == "Ftheta") {
    lens = [w = D[0]](const Ray& p) -> std::optional<Pixel> {
      const double r = std::hypot(p[0], p[1]);
      if (r == 0.0) return p[2] > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
      const double bent = std::atan2(2.0 * r * std::tan(w / 2.0), p[2]) / w;
      return Pixel{bent * p[0] / r, bent * p[1] / r};
    };
  }
  PixelFormula formula;
  formula.pixel =
      in_image(lens, std::stod(values["Fx"]), std::stod(values["Fy"]), std::stod(values["PPX"]), std::stod(values["PPY"]));
  formula.size = Size{std::stoi(values["Width"]), std::stoi(values["Height"])};
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  const Device device = device_of(files.front());
  std::vector<Pose> poses;
  for (const Extrinsic& each : device.extrinsics) {
    if (device.streams.size() > 1 && each.from == device.streams[0].name && each.to == device.streams[1].name)
      poses.push_back(each.pose);
  }
  return poses;
}

}  // namespace fca::matrix::realsense
