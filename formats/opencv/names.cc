// SPDX-License-Identifier: BSD-3-Clause
#include "names.h"

#include <fca/normalised_id.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace fca::opencv {

namespace {

struct Stem {
  std::string_view word;  ///< Folded.
  Role role;
};

/// "intrisic": SokratG/Surround-View; "cm": stereo tutorials; "intrinsicmatrix", "radialdistortion": MATLAB.
constexpr std::array kStems = {
    Stem{"cameramatrix", Role::kMatrix},
    Stem{"cammatrix", Role::kMatrix},
    Stem{"k", Role::kMatrix},
    Stem{"m", Role::kMatrix},
    Stem{"cm", Role::kMatrix},
    Stem{"mtx", Role::kMatrix},
    Stem{"intrinsic", Role::kMatrix},
    Stem{"intrinsics", Role::kMatrix},
    Stem{"intrisic", Role::kMatrix},
    Stem{"intrinsicmatrix", Role::kMatrix},
    Stem{"cameraintrinsic", Role::kMatrix},
    Stem{"cameraintrinsics", Role::kMatrix},
    Stem{"distortioncoefficients", Role::kDistortion},
    Stem{"distortioncoefficient", Role::kDistortion},
    Stem{"distortioncoeffs", Role::kDistortion},
    Stem{"distortioncoeff", Role::kDistortion},
    Stem{"distortionparameters", Role::kDistortion},
    Stem{"distortionvector", Role::kDistortion},
    Stem{"distortion", Role::kDistortion},
    Stem{"distcoefficients", Role::kDistortion},
    Stem{"distcoeffs", Role::kDistortion},
    Stem{"distcoeff", Role::kDistortion},
    Stem{"distcoefs", Role::kDistortion},
    Stem{"distcoef", Role::kDistortion},
    Stem{"cameradistortion", Role::kDistortion},
    Stem{"dist", Role::kDistortion},
    Stem{"dc", Role::kDistortion},
    Stem{"d", Role::kDistortion},
    Stem{"radialdistortion", Role::kRadial},
    Stem{"tangentialdistortion", Role::kTangential},
    Stem{"xi", Role::kXi},
};

constexpr std::array<std::string_view, 4> kSides = {"left", "right", "l", "r"};

Role role_of(std::string_view word) {
  const auto* const found = std::ranges::find(kStems, word, &Stem::word);
  return found == kStems.end() ? Role::kNone : found->role;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// `word` without `part`, once; nothing if it is not in there.
std::optional<std::string> without(const std::string& word, std::string_view part) {
  const std::size_t place = word.find(part);
  if (place == std::string::npos) return std::nullopt;
  return word.substr(0, place) + word.substr(place + part.size());
}

}  // namespace

Name name_of(std::string_view key) {
  std::string word = normalised_id(key);
  Name name;
  if (std::optional<std::string> rest = without(word, "fisheye")) {
    name.fisheye = true;
    word = *std::move(rest);
  }
  name.role = role_of(word);
  if (name.role != Role::kNone) return name;
  // "cam0_K", "camera1_matrix"
  for (const std::string_view camera : {"camera", "cam"}) {
    if (!word.starts_with(camera)) continue;
    const std::size_t behind = std::min(word.find_first_not_of("0123456789", camera.size()), word.size());
    const std::string_view rest = std::string_view(word).substr(behind);
    if (behind == camera.size()) continue;
    name.role = rest == "matrix" ? Role::kMatrix : role_of(rest);
    name.side = word.substr(camera.size(), behind - camera.size());
    if (name.role != Role::kNone) return name;
  }
  std::size_t digits = word.size();
  while (digits > 0 && is_digit(word[digits - 1])) --digits;
  name.side.clear();
  if (digits < word.size()) {
    name.role = role_of(std::string_view(word).substr(0, digits));
    name.side = word.substr(digits);
  }
  for (const std::string_view side : kSides) {
    if (name.role != Role::kNone) break;
    name.side = side;
    if (word.ends_with(side)) name.role = role_of(std::string_view(word).substr(0, word.size() - side.size()));
    // "left_camera_matrix"; a single letter in front says nothing.
    if (name.role == Role::kNone && side.size() > 1 && word.starts_with(side))
      name.role = role_of(std::string_view(word).substr(side.size()));
  }
  return name.role == Role::kNone ? Name{} : name;
}

std::string distortion_key_for(std::string_view matrix_key) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kPairs = {
      {{"camera_matrix", "distortion_coefficients"},
       {"Camera_Matrix", "Distortion_Coefficients"},
       {"M1", "D1"},
       {"M2", "D2"},
       {"K1", "D1"},
       {"K2", "D2"},
       {"camera_matrix_left", "dist_coeffs_left"},
       {"camera_matrix_right", "dist_coeffs_right"}}};
  const auto* const found = std::ranges::find(kPairs, matrix_key, &std::pair<std::string_view, std::string_view>::first);
  return found == kPairs.end() ? "" : std::string(found->second);
}

}  // namespace fca::opencv
