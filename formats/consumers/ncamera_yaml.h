// SPDX-License-Identifier: BSD-3-Clause
// Private: what SVO and maplab share, aslam's yaml-serialization over yaml-cpp: values by their keys, matrices of cols, rows
// and data, of which data is a list or a list of rows.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "fca/code.h"
#include "fca/formats/consumers/consumer.h"

namespace fca::consumers::ncamera {

/// The file and what a program says of it. Values that a program does without have no refusal here.
class File {
 public:
  File(std::string_view program, ConsumerView& view) : program_(program), view_(view) {}

  [[nodiscard]] std::string_view program() const { return program_; }
  [[nodiscard]] ConsumerView& view() { return view_; }

  /// With the program behind the arguments.
  void refuse(Code code, const std::string& path, std::vector<Argument> arguments = {});
  void complain(Code code, const std::string& path, std::vector<Argument> arguments);

  /// The value under a key; an empty node and a refusal where there is none.
  YAML::Node require(const YAML::Node& node, const char* key, const std::string& path);
  std::optional<std::string> word(const YAML::Node& node, const char* key, const std::string& path);
  std::optional<double> number(const YAML::Node& node, const char* key, const std::string& path);
  /// `rows` and `cols` of which 0 is any.
  std::optional<std::vector<double>> matrix(const YAML::Node& node, const std::string& path, int rows, int cols);

 private:
  std::string_view program_;
  ConsumerView& view_;
};

/// yaml-cpp's as<double>.
[[nodiscard]] std::optional<double> real(const YAML::Node& node);
/// "the string 'x'" and the like, for sentences.
[[nodiscard]] Argument description_of(const YAML::Node& node);

/// Runs `body` on the tree; what keeps yaml-cpp from making one is a refusal.
[[nodiscard]] ConsumerView read(std::string_view bytes, std::string_view program,
                                const std::function<void(const YAML::Node& root, File& file)>& body);

/// 16 numbers, row by row.
[[nodiscard]] ConsumerPose pose_in_imu(const std::string& camera, const std::vector<double>& T_body_camera);

/// How much an FOV lens of that parameter (> 0) widens the plane at its centre, times the parameter.
[[nodiscard]] inline double fov_tangent(double w) { return 2.0 * std::tan(0.5 * w); }

}  // namespace fca::consumers::ncamera
