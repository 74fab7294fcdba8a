// SPDX-License-Identifier: BSD-3-Clause
#include "nerf_file.h"

#include <fca/code.h>
#include <rapidjson/error/en.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <utility>

namespace fca::consumers {

namespace {

using Json = rapidjson::Value;

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr std::array<std::string_view, 6> kNumbers = {"fl_x", "fl_y", "cx", "cy", "w", "h"};
constexpr std::array<std::string_view, 4> kAngles = {"x_fov", "y_fov", "camera_angle_x", "camera_angle_y"};
constexpr std::array<std::string_view, 6> kLens = {"k1", "k2", "k3", "k4", "p1", "p2"};
constexpr std::string_view kList = "distortion_params";

/// A number of a file as text.
std::string digits_of(std::string_view key, double value) {
  std::array<char, 40> digits{};
  static_cast<void>(std::snprintf(digits.data(), digits.size(), "%.17g;", value));
  return std::string(key) + digits.data();
}

/// What the frame says of its camera and the top does not.
std::string own_numbers(const Json& root, const Json& frame) {
  std::string text;
  const auto add = [&](std::string_view key) {
    const Json* value = NerfFile::find(root, key) == nullptr ? NerfFile::find(frame, key) : nullptr;
    if (value != nullptr) text += digits_of(key, value->IsNumber() ? value->GetDouble() : 0.0);
  };
  const auto stands = [&](std::string_view key) {
    return NerfFile::find(root, key) != nullptr || NerfFile::find(frame, key) != nullptr;
  };
  for (const std::string_view key : kNumbers) add(key);
  for (const std::string_view key : kAngles) {
    if (!stands(key.front() == 'x' || key.back() == 'x' ? "fl_x" : "fl_y")) add(key);
  }
  const bool shared = NerfFile::find(root, kList) != nullptr || std::ranges::any_of(kLens, [&root](std::string_view key) {
                        return key != "k4" && NerfFile::find(root, key) != nullptr;
                      });
  if (shared) return text;
  const Json* list = NerfFile::find(frame, kList);
  if (list == nullptr || !list->IsArray()) {
    std::ranges::for_each(kLens, add);
    return text;
  }
  for (rapidjson::SizeType i = 0; i < list->Size() && i < kLens.size(); ++i)
    text += digits_of(kLens.at(i), (*list)[i].IsNumber() ? (*list)[i].GetDouble() : 0.0);
  return text;
}

}  // namespace

NerfFile::NerfFile(std::string_view bytes, bool of_nlohmann, ConsumerView& view) : view_(view) {
  if (bytes.empty() || bytes.size() > kMaxBytes) {
    refuse(bytes.empty() ? Code::kProgramFileEmpty : Code::kProgramFileTooLarge);
    return;
  }
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (!of_nlohmann && bytes.starts_with(kMark)) {
    refuse(Code::kPythonJsonBom);
    return;
  }
  constexpr unsigned kBoth =
      rapidjson::kParseFullPrecisionFlag | rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag;
  if (of_nlohmann) {
    document_.Parse<kBoth | rapidjson::kParseCommentsFlag>(bytes.data(), bytes.size());
  } else {
    document_.Parse<kBoth | rapidjson::kParseNanAndInfFlag>(bytes.data(), bytes.size());
  }
  check_document();
}

void NerfFile::check_document() {
  if (document_.HasParseError()) {
    return refuse(Code::kNerfSaysNotParsed,
                  {document_.GetErrorOffset(), rapidjson::GetParseError_En(document_.GetParseError())});
  }
  if (!document_.IsObject()) return refuse(Code::kNerfSaysNoObject);
  const Json* images = find(document_, "frames");
  if (images == nullptr || !images->IsArray() || images->Empty()) return refuse(Code::kNerfSaysNoFrames, {}, "frames");
  for (rapidjson::SizeType i = 0; i < images->Size(); ++i) {
    if (!(*images)[i].IsObject()) return refuse(Code::kNerfSaysFrameLacks, {"file_path", i}, "frames");
  }
}

void NerfFile::refuse(Code code, std::vector<Argument> arguments, const std::string& key) {
  view_.refusals.emplace_back(code, key, std::move(arguments));
  view_.cameras.clear();
}

void NerfFile::warn(Code code, std::vector<Argument> arguments, const std::string& key) {
  Complaint complaint(code, key, std::move(arguments));
  if (std::ranges::find(view_.warnings, complaint) == view_.warnings.end()) view_.warnings.push_back(std::move(complaint));
}

const Json& NerfFile::frames() const { return *find(document_, "frames"); }

std::vector<NerfCamera> NerfFile::cameras() const {
  std::vector<NerfCamera> cameras;
  std::vector<std::string> labels;
  std::set<std::pair<std::string, std::string>> known;
  const Json& images = frames();
  for (rapidjson::SizeType i = 0; i < images.Size(); ++i) {
    std::pair<std::string, std::string> seen = {own_numbers(document_, images[i]), ""};
    const Json* label = seen.first.empty() ? nullptr : find(images[i], "camera");
    if (label != nullptr && label->IsString()) seen.second = label->GetString();
    if (!known.insert(seen).second) continue;
    cameras.push_back({"cam" + std::to_string(cameras.size()), &images[i], i});
    labels.push_back(seen.second);
  }
  const std::set<std::string> different(labels.begin(), labels.end());
  if (different.size() == cameras.size() && !different.contains("")) {
    for (std::size_t i = 0; i < cameras.size(); ++i) cameras[i].name = labels[i];
  }
  return cameras;
}

const Json* NerfFile::find(const Json& object, std::string_view key) {
  if (!object.IsObject()) return nullptr;
  for (auto member = object.MemberEnd(); member != object.MemberBegin();) {
    --member;
    if (std::string_view(member->name.GetString(), member->name.GetStringLength()) == key) return &member->value;
  }
  return nullptr;
}

std::optional<double> NerfFile::number(const Json& object, std::string_view key) {
  const Json* value = find(object, key);
  if (value == nullptr) return std::nullopt;
  if (value->IsNumber()) return value->GetDouble();
  refuse(Code::kNerfSaysNoNumber, {key}, std::string(key));
  return std::nullopt;
}

std::optional<double> NerfFile::number_or_text(const Json& object, std::string_view key) {
  const Json* value = find(object, key);
  if (value == nullptr || !value->IsString()) return number(object, key);
  // strtod reads all that float() does, and numbers with an x as well.
  const std::string text = value->GetString();
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  const std::string_view rest = end;
  const bool is_float = end != text.c_str() && rest.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos &&
                        text.find_first_of("xX(") == std::string::npos;
  if (is_float) return result;
  refuse(Code::kNerfSaysNoNumber, {key}, std::string(key));
  return std::nullopt;
}

std::optional<std::vector<double>> NerfFile::coefficient_list(const Json& object) {
  const Json* list = find(object, kList);
  if (list == nullptr) return std::nullopt;
  std::vector<double> numbers;
  for (rapidjson::SizeType i = 0; list->IsArray() && i < list->Size(); ++i) {
    if ((*list)[i].IsNumber()) numbers.push_back((*list)[i].GetDouble());
  }
  if (list->IsArray() && numbers.size() == list->Size() && numbers.size() >= kLens.size()) return numbers;
  refuse(Code::kNerfSaysNoList, {}, std::string(kList));
  return std::nullopt;
}

bool NerfFile::warn_of_list(const Json& object) {
  const Json* list = find(object, kList);
  const auto bends = [](const Json& item) { return item.IsNumber() && item.GetDouble() != 0.0; };
  if (list == nullptr || !list->IsArray() || std::none_of(list->Begin(), list->End(), bends) ||
      std::ranges::any_of(kLens, [&object](std::string_view key) { return find(object, key) != nullptr; }))
    return false;
  warn(Code::kNerfSaysListNotRead, {}, std::string(kList));
  return true;
}

bool NerfFile::flag(const Json& object, std::string_view key) {
  const Json* value = find(object, key);
  if (value == nullptr) return false;
  if (!value->IsBool()) refuse(Code::kNerfSaysNoNumber, {key}, std::string(key));
  return value->IsTrue();
}

void NerfFile::check_frames(std::size_t rows) {
  const Json& images = frames();
  for (rapidjson::SizeType i = 0; i < images.Size() && loads(); ++i) {
    for (const std::string_view key : {"file_path", "transform_matrix"}) {
      if (find(images[i], key) == nullptr) return refuse(Code::kNerfSaysFrameLacks, {key, i}, "frames");
    }
    const auto is_row = [](const Json& row) {
      return row.IsArray() && row.Size() == 4 &&
             std::all_of(row.Begin(), row.End(), [](const Json& number) { return number.IsNumber(); });
    };
    const Json& pose = *find(images[i], "transform_matrix");
    if (!pose.IsArray() || pose.Size() < rows || !std::all_of(pose.Begin(), pose.End(), is_row))
      refuse(Code::kNerfSaysNoMatrix, {i}, "frames");
  }
}

namespace {

/// 0, which says nothing, for what no image has.
int side_of(double side) {
  constexpr double kLargest = 1e6;
  return side >= 1.0 && side <= kLargest ? static_cast<int>(side) : 0;
}

}  // namespace

bool NerfFile::is_named_fisheye() const {
  const Json* name = find(root(), "camera_model");
  return name != nullptr && name->IsString() && std::string_view(name->GetString()) == "OPENCV_FISHEYE";
}

ConsumerCamera nerf_camera(const NerfCamera& camera, double width, double height, std::string_view model,
                           NerfProjection project) {
  ConsumerCamera seen;
  seen.name = camera.name;
  seen.width = side_of(width);
  seen.height = side_of(height);
  seen.model = model;
  seen.project = [project = std::move(project)](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
    constexpr double kCentre = 0.5;
    const std::optional<std::array<double, 2>> pixel = project(ray);
    return pixel ? std::optional(std::array{(*pixel)[0] - kCentre, (*pixel)[1] - kCentre}) : std::nullopt;
  };
  return seen;
}

std::optional<std::array<double, 2>> nerf_plane(const std::array<double, 3>& ray) {
  if (!(ray[2] > 0.0)) return std::nullopt;
  return std::array{ray[0] / ray[2], ray[1] / ray[2]};
}

}  // namespace fca::consumers
