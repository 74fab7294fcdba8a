// SPDX-License-Identifier: BSD-3-Clause
#include "ncamera_yaml.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

#include "../yaml_directive.h"
#include "about_key.h"

namespace fca::consumers::ncamera {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;

void collect(const YAML::Node& data, std::vector<double>& numbers) {
  for (const YAML::Node& item : data) {
    if (item.IsSequence()) {
      for (const YAML::Node& inner : item) numbers.push_back(real(inner).value_or(std::numeric_limits<double>::quiet_NaN()));
    } else {
      numbers.push_back(real(item).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  }
}

}  // namespace

void File::refuse(Code code, const std::string& path, std::vector<Argument> arguments) {
  arguments.emplace_back(program_);
  view_.refusals.push_back(about_key(code, path, std::move(arguments)));
}

void File::complain(Code code, const std::string& path, std::vector<Argument> arguments) {
  view_.refusals.push_back(about_key(code, path, std::move(arguments)));
}

YAML::Node File::require(const YAML::Node& node, const char* key, const std::string& path) {
  if (node.IsMap() && node[key]) return node[key];
  refuse(Code::kProgramSaysMissing, path);
  return YAML::Node(YAML::NodeType::Undefined);
}

std::optional<std::string> File::word(const YAML::Node& node, const char* key, const std::string& path) {
  const YAML::Node value = require(node, key, path);
  if (!value.IsDefined()) return std::nullopt;
  if (value.IsScalar()) return value.Scalar();
  refuse(Code::kProgramSaysNoText, path);
  return std::nullopt;
}

std::optional<double> File::number(const YAML::Node& node, const char* key, const std::string& path) {
  const YAML::Node value = require(node, key, path);
  if (!value.IsDefined()) return std::nullopt;
  const std::optional<double> number = real(value);
  if (!number) refuse(Code::kProgramSaysNoNumber, path, {description_of(value)});
  return number;
}

std::optional<std::vector<double>> File::matrix(const YAML::Node& node, const std::string& path, int rows, int cols) {
  const std::optional<double> stated_rows = number(node, "rows", path + "/rows");
  const std::optional<double> stated_cols = number(node, "cols", path + "/cols");
  const YAML::Node data = require(node, "data", path + "/data");
  if (!stated_rows || !stated_cols || !data.IsDefined()) return std::nullopt;
  const auto count = static_cast<std::size_t>(std::clamp(*stated_rows * *stated_cols, 0.0, 1e9));
  std::vector<double> numbers;
  if (data.IsSequence()) collect(data, numbers);
  const bool good = data.IsSequence() && numbers.size() == count &&
                    std::none_of(numbers.begin(), numbers.end(), [](double number) { return number != number; });
  if (!good) {
    refuse(Code::kProgramSaysNumberCount, path + "/data", {count});
    return std::nullopt;
  }
  if ((rows != 0 && *stated_rows != rows) || (cols != 0 && *stated_cols != cols)) {
    refuse(Code::kProgramSaysNumberCount, path + "/data", {rows * cols});
    return std::nullopt;
  }
  return numbers;
}

std::optional<double> real(const YAML::Node& node) {
  if (!node.IsDefined() || !node.IsScalar()) return std::nullopt;
  std::stringstream stream(node.Scalar());
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (YAML::conversion::ConvertStreamTo(stream, value)) return value;
  return std::nullopt;
}

Argument description_of(const YAML::Node& node) {
  constexpr std::size_t kLongest = 40;
  if (node.IsScalar()) return Message{Code::kValueString, {node.Scalar().substr(0, kLongest)}};
  if (node.IsSequence()) return Message{Code::kValueList};
  return Message{node.IsMap() ? Code::kValueMap : Code::kValueNothing};
}

ConsumerView read(std::string_view bytes, std::string_view program,
                  const std::function<void(const YAML::Node& root, File& file)>& body) {
  ConsumerView view;
  if (bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(Code::kProgramFileTooLarge, "");
    return view;
  }
  try {
    const YAML::Node root = YAML::Load(without_version(std::string(bytes)));
    File file(program, view);
    if (root.IsMap()) {
      body(root, file);
    } else {
      view.refusals.emplace_back(Code::kProgramSaysNoKeys, "");
    }
  } catch (const YAML::Exception& error) {
    view.refusals.emplace_back(Code::kProgramSaysNotParsed, "", std::vector<Argument>{"yaml-cpp", error.what()});
  }
  if (!view.loads()) {
    view.cameras.clear();
    view.poses.clear();
  }
  return view;
}

ConsumerPose pose_in_imu(const std::string& camera, const std::vector<double>& T_body_camera) {
  ConsumerPose pose = {"imu0", camera, {}};
  std::copy_n(T_body_camera.begin(), pose.T_a_b.size(), pose.T_a_b.begin());
  // Neither program reads the last row.
  std::fill_n(pose.T_a_b.begin() + 12, 3, 0.0);
  pose.T_a_b.back() = 1.0;
  return pose;
}

}  // namespace fca::consumers::ncamera
