// SPDX-License-Identifier: BSD-3-Clause
// The memory of an OAK camera as depthai-core's CalibrationHandler reads it (MORE-FORMATS-2.md section 20.1): OpenCV's 14
// coefficients, or its fisheye's four; extrinsics take points of a socket's camera to that of toCameraSocket, in centimetres.
#include "pixels_depthai.h"

#include "opencv_lens.h"

#include <rapidjson/document.h>

#include <map>

namespace fca::matrix::depthai {

namespace {

using Json = rapidjson::Value;

rapidjson::Document parsed(const std::string& bytes) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  return document;
}

/// By their sockets.
std::map<int, const Json*> cameras_of(const rapidjson::Document& document) {
  std::map<int, const Json*> cameras;
  if (document.HasParseError() || !document.IsObject() || !document.HasMember("cameraData")) return cameras;
  for (const Json& pair : document["cameraData"].GetArray()) cameras[pair[0].GetInt()] = &pair[1];
  return cameras;
}

/// To the camera that heads the chain.
Pose in_head(const std::map<int, const Json*>& cameras, int socket) {
  const Json& extrinsics = (*cameras.at(socket))["extrinsics"];
  const int to = extrinsics["toCameraSocket"].GetInt();
  if (to < 0) return identity_pose();
  const double unit = !extrinsics.HasMember("lengthUnit") || extrinsics["lengthUnit"].GetInt() == 1 ? 0.01
                      : extrinsics["lengthUnit"].GetInt() == 2                                      ? 0.001
                                                                                                    : 1.0;
  Pose pose{};
  for (std::size_t row = 0; row < 3; ++row) {
    const Json& numbers = extrinsics["rotationMatrix"][static_cast<rapidjson::SizeType>(row)];
    for (std::size_t column = 0; column < 3; ++column)
      pose[row][column] = numbers[static_cast<rapidjson::SizeType>(column)].GetDouble();
  }
  pose[0][3] = extrinsics["translation"]["x"].GetDouble() * unit;
  pose[1][3] = extrinsics["translation"]["y"].GetDouble() * unit;
  pose[2][3] = extrinsics["translation"]["z"].GetDouble() * unit;
  return in_head(cameras, to) * pose;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const rapidjson::Document document = parsed(bytes);
  const std::map<int, const Json*> cameras = cameras_of(document);
  if (index >= cameras.size()) return std::nullopt;
  const Json& stated = *std::next(cameras.begin(), static_cast<std::ptrdiff_t>(index))->second;
  std::vector<double> D;
  for (const Json& coefficient : stated["distortionCoeff"].GetArray()) D.push_back(coefficient.GetDouble());
  const Json& K = stated["intrinsicMatrix"];
  const bool is_fisheye = stated.HasMember("cameraType") && stated["cameraType"].GetInt() == 1;
  PixelFormula formula;
  formula.pixel = in_image(is_fisheye ? fisheye(D) : pinhole(D), K[0][0].GetDouble(), K[1][1].GetDouble(), K[0][2].GetDouble(),
                           K[1][2].GetDouble());
  if (stated["width"].GetInt() > 0) formula.size = Size{stated["width"].GetInt(), stated["height"].GetInt()};
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  const rapidjson::Document document = parsed(files.front());
  const std::map<int, const Json*> cameras = cameras_of(document);
  if (cameras.size() < 2) return {};
  const int first = cameras.begin()->first;
  const int second = std::next(cameras.begin())->first;
  return {inverse(in_head(cameras, second)) * in_head(cameras, first)};
}

}  // namespace fca::matrix::depthai
