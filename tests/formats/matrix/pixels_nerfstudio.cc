// SPDX-License-Identifier: BSD-3-Clause
// nerfstudio's transforms.json after MORE-FORMATS-2.md section 18: a number at the top is that of every frame, else the frame's
// own; the first pixel's centre is (0.5, 0.5). Frames with the same numbers are one camera; two cameras with the same numbers
// are told apart by the frames' "camera".
#include "pixels_nerfstudio.h"

#include "sensor_lens.h"

#include <rapidjson/document.h>

#include <algorithm>
#include <map>

namespace fca::matrix::nerfstudio {

namespace {

struct Seen {
  std::map<std::string, double> numbers;
  std::string label;
  bool operator==(const Seen&) const = default;
};

void add_numbers(const rapidjson::Value& object, std::map<std::string, double>& numbers) {
  if (object.HasMember("distortion_params") && object["distortion_params"].IsArray()) {
    const auto& list = object["distortion_params"];
    const std::vector<std::string> keys = {"k1", "k2", "k3", "k4", "p1", "p2"};
    for (rapidjson::SizeType i = 0; i < list.Size() && i < keys.size(); ++i) {
      if (list[i].IsNumber()) numbers.emplace(keys[i], list[i].GetDouble());
    }
  }
  for (const auto& member : object.GetObject()) {
    const std::string key = member.name.GetString();
    const bool counts =
        key.size() <= 4 && (key[0] == 'k' || key[0] == 'p' || key[0] == 'c' || key[0] == 'f' || key.size() == 1);
    if (counts && member.value.IsNumber()) numbers.emplace(key, member.value.GetDouble());
  }
}

std::vector<Seen> cameras(const rapidjson::Value& root) {
  Seen top;
  add_numbers(root, top.numbers);
  std::vector<Seen> seen;
  if (root.HasMember("frames") && root["frames"].IsArray()) {
    for (const rapidjson::Value& frame : root["frames"].GetArray()) {
      Seen camera = top;
      add_numbers(frame, camera.numbers);
      if (camera != top && frame.HasMember("camera") && frame["camera"].IsString()) camera.label = frame["camera"].GetString();
      if (std::ranges::find(seen, camera) == seen.end()) seen.push_back(camera);
    }
  }
  return seen.empty() ? std::vector{top} : seen;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  if (document.HasParseError() || !document.IsObject()) return std::nullopt;
  const std::vector<Seen> all = cameras(document);
  if (index >= all.size()) return std::nullopt;
  std::map<std::string, double> n = all[index].numbers;
  for (const char* key : {"fl_x", "fl_y", "cx", "cy", "w", "h"}) {
    if (!n.contains(key)) return std::nullopt;
  }
  const bool fisheye = document.HasMember("camera_model") && document["camera_model"] == "OPENCV_FISHEYE";
  const std::vector<double> k = {n["fl_x"], n["fl_y"], n["cx"] - 0.5, n["cy"] - 0.5};
  const std::vector<double> d =
      fisheye ? std::vector{n["k1"], n["k2"], n["k3"], n["k4"]} : std::vector{n["k1"], n["k2"], n["p1"], n["p2"], n["k3"]};
  PixelFormula formula;
  formula.size = {static_cast<int>(n["w"]), static_cast<int>(n["h"])};
  formula.pixel = sensor_lens(k, d, fisheye);
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& /*files*/) { return {}; }

}  // namespace fca::matrix::nerfstudio
