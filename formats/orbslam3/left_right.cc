// SPDX-License-Identifier: BSD-3-Clause
#include "left_right.h"

#include "layout.h"

#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fca::orbslam3 {

namespace {

constexpr std::array<std::string_view, 2> kSides = {"LEFT", "RIGHT"};
constexpr std::array<std::string_view, 2> kNames = {"left", "right"};

using Values = std::vector<double>;

constexpr double kLargest = 1e9;  // of P, far beyond any image's

/// One of the two cameras.
struct Side {
  Camera camera;
  Values R;
  Values P;
};

class SideReader {
 public:
  SideReader(const text::Document& document, std::string_view side)
      : reader_(document, text::Dialect::kOpenCv, discarded_), side_(side) {}

  std::optional<Side> read(std::string_view name) {
    const std::optional<Values> K = matrix(".K", 9);
    const std::optional<Values> D = matrix(".D", 0);
    const std::optional<Values> R = matrix(".R", 9);
    const std::optional<Values> P = matrix(".P", 12);
    const text::Node* width = node(".width");
    const text::Node* height = node(".height");
    if (!K || !D || !R || !P || width == nullptr || height == nullptr) return std::nullopt;
    Side side;
    side.R = *R;
    side.P = *P;
    side.camera.name = name;
    side.camera.image_size = reader_.image_size(*width, *height, std::string(side_) + ".");
    const bool is_straight = std::ranges::all_of(*D, [](double value) { return value == 0.0; });
    if (!side.camera.image_size || D->size() > kOpenCvCoefficients.size()) return std::nullopt;
    side.camera.model = *make_model(opencv_model_of(is_straight ? 0 : D->size()));
    CameraModel& model = side.camera.model;
    set_parameter(model, "fx", (*K)[0]);
    set_parameter(model, "fy", (*K)[4]);
    set_parameter(model, "cx", (*K)[2]);
    set_parameter(model, "cy", (*K)[5]);
    for (std::size_t i = 0; i < D->size() && !is_straight; ++i) set_parameter(model, kOpenCvCoefficients.at(i), (*D)[i]);
    return validate(model).empty() ? std::optional(side) : std::nullopt;
  }

 private:
  const text::Node* node(std::string_view key) {
    return text::find(reader_.document().root(), std::string(side_) + std::string(key), text::Dialect::kOpenCv);
  }
  std::optional<Values> matrix(std::string_view key, std::size_t count) {
    const text::Node* there = node(key);
    if (there == nullptr) return std::nullopt;
    const std::optional<fields::Reader::Matrix> read = reader_.opencv_matrix(*there, std::string(side_) + std::string(key));
    if (!read || (count != 0 && read->values.size() != count)) return std::nullopt;
    return Values(read->values.begin(), read->values.end());
  }

  Diagnostics discarded_;  // the keys are not of every program that reads the file
  fields::Reader reader_;
  std::string_view side_;
};

bool is_rotation(const Transform& R) {
  constexpr double kPrintedWithThreeDigits = 2e-3;
  return rotation_determinant(R) > 0.0 && rotation_defect(R) <= kPrintedWithThreeDigits;
}

}  // namespace

std::optional<RectifiedPair> read_left_right(const text::Document& document) {
  RectifiedPair pair;
  std::array<Values, 2> P;
  for (std::size_t i = 0; i < 2; ++i) {
    std::optional<Side> side = SideReader(document, kSides.at(i)).read(kNames.at(i));
    if (!side) return std::nullopt;
    Transform R;
    for (int k = 0; k < 9; ++k) R(k / 3, k % 3) = side->R[static_cast<std::size_t>(k)];
    if (!is_rotation(R)) return std::nullopt;
    P.at(i) = side->P;
    pair.views.at(i) = {std::string(kNames.at(i)), R, {P.at(i)[2], P.at(i)[6]}};
    pair.sources.push_back(std::move(side->camera));
  }
  constexpr double kPrinted = 1e-6;
  const auto alike = [&P](std::size_t place) {
    return std::abs(P[0][place] - P[1][place]) <= kPrinted * std::abs(P[0][place]);
  };
  if (!(P[0][0] > 0.0 && P[0][5] > 0.0) || !alike(0) || !alike(5) || P[1][3] == 0.0) return std::nullopt;
  pair.focal_lengths = {P[0][0], P[0][5]};
  pair.offset_m = (P[0][3] - P[1][3]) / P[0][0];
  const auto has_limits = [](double value) { return std::abs(value) <= kLargest; };
  const bool is_in_limits = !problem_with_baseline(std::abs(pair.offset_m)).is_said() &&
                            std::ranges::all_of(P[0], has_limits) && std::ranges::all_of(P[1], has_limits);
  return is_in_limits ? std::optional(pair) : std::nullopt;
}

std::optional<std::vector<double>> coefficients_of(const CameraModel& model) {
  const std::string_view id = model_info(model).id;
  if (id == "pinhole") return std::vector<double>(kRadtanCount, 0.0);
  std::vector<double> values;
  for (std::size_t i = 0; i < opencv_count(id); ++i) values.push_back(parameter(model, kOpenCvCoefficients.at(i)).value());
  return values.empty() ? std::nullopt : std::optional(values);
}

std::vector<fields::Field> left_right_fields(const RectifiedPair& pair) {
  std::vector<fields::Field> fields;
  const auto& [fx, fy] = pair.focal_lengths;
  for (std::size_t i = 0; i < 2; ++i) {
    const Camera& camera = pair.sources.at(i);
    const std::string side(kSides.at(i));
    const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
    const ImageSize size = pair.size.value_or(camera.image_size.value_or(ImageSize()));  // of the image that is made
    fields.push_back(fields::integer(side + ".height", size.height));
    fields.push_back(fields::integer(side + ".width", size.width));
    const std::vector<double> D = coefficients_of(camera.model).value();
    fields.push_back(fields::matrix(side + ".D", D, static_cast<int>(D.size()), "d"));
    const std::array K = {value("fx"), 0.0, value("cx"), 0.0, value("fy"), value("cy"), 0.0, 0.0, 1.0};
    fields.push_back(fields::matrix(side + ".K", K, 3, "d"));
    const Transform& T = pair.views.at(i).T_rectified_camera;
    const std::array R = {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
    fields.push_back(fields::matrix(side + ".R", R, 3, "d"));
    const auto& [cx, cy] = pair.views.at(i).centre;
    const double shift = i == 0 ? 0.0 : -fx * pair.offset_m;
    const std::array P = {fx, 0.0, cx, shift, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0};
    fields.push_back(fields::matrix(side + ".P", P, 4, "d"));
  }
  return fields;
}

}  // namespace fca::orbslam3
