// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <algorithm>
#include <cmath>

namespace fca::basalt {

namespace {

struct Names {
  std::string_view camera_type;
  std::string_view model;
};
/// Parameters have the same names in both.
constexpr std::array kNames = {Names{"ds", "ds"},
                               Names{"kb4", "kb4"},
                               Names{"eucm", "eucm"},
                               Names{"ucm", "ucm"},
                               Names{"fov", "fov"},
                               Names{"pinhole", "pinhole"},
                               Names{"pinhole-radtan8", "rational"}};

constexpr double kNanoseconds = 1e9;

}  // namespace

std::string_view model_of(std::string_view camera_type) {
  const auto* const found = std::ranges::find(kNames, camera_type, &Names::camera_type);
  return found == kNames.end() ? std::string_view() : found->model;
}

std::string_view type_of(std::string_view model) {
  const auto* const found = std::ranges::find(kNames, model, &Names::model);
  return found == kNames.end() ? std::string_view() : found->camera_type;
}

std::int64_t nanoseconds(double seconds) { return std::llround(seconds * kNanoseconds); }

double seconds(double nanoseconds) { return nanoseconds / kNanoseconds; }

std::string camera_name(std::size_t index) { return "cam" + std::to_string(index); }

}  // namespace fca::basalt
