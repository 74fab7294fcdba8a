// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the models share: the cameras of testdata/models, rays on a cone, and a model's derivative dr/dangle.
#pragma once

#include <fca/models/camera_model.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <ceres/jet.h>
#include <gtest/gtest.h>

namespace fca::test {

template <CameraModelType M>
struct TestCamera {
  std::string name;
  int width = 0;
  int height = 0;
  Intrinsics<M> intrinsics;
  [[nodiscard]] const double* p() const { return intrinsics.values.data(); }
};

/// Fields of a line of a table, which are separated by tabs.
inline std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
  return fields;
}

/// The number a field holds; NaN, which no test survives, if it holds none.
inline double number_in(const std::string& field) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  return result.ptr == field.data() + field.size() ? value : std::numeric_limits<double>::quiet_NaN();
}

/// The cameras in testdata/models/<id>.tsv. A model without that file, or with other columns, fails its tests.
template <CameraModelType M>
std::vector<TestCamera<M>> cameras_of() {
  std::vector<TestCamera<M>> cameras;
  const std::string path = std::string(FCA_TESTDATA_DIR) + "/models/" + std::string(M::kId) + ".tsv";
  std::ifstream file(path);
  std::vector<std::string> expected = {"name", "width", "height"};
  for (const Parameter& parameter : M::kParameters) expected.emplace_back(parameter.name);
  expected.emplace_back("source");
  bool header_seen = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> fields = fields_of(line);
    if (!header_seen) {
      EXPECT_EQ(fields, expected) << path;
      header_seen = true;
      continue;
    }
    if (fields.size() != expected.size()) {
      ADD_FAILURE() << path << ": " << line << ": " << fields.size() << " columns for " << expected.size();
      continue;
    }
    TestCamera<M> camera{fields[0], static_cast<int>(number_in(fields[1])), static_cast<int>(number_in(fields[2])), {}};
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) camera.intrinsics.values[i] = number_in(fields[3 + i]);
    cameras.push_back(camera);
  }
  EXPECT_FALSE(cameras.empty()) << path << " holds no camera";
  return cameras;
}

/// The cameras of cameras_of() and, for each, some neighbours: every lens parameter changed by up to 10 % of itself, plus 0.01
/// unless it is in pixels, inside its bounds. Seeded: the same in every run.
template <CameraModelType M>
std::vector<TestCamera<M>> cameras_and_neighbours_of(int neighbours) {
  std::vector<TestCamera<M>> result;
  std::mt19937_64 generator(20240607);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const TestCamera<M>& camera : cameras_of<M>()) {
    result.push_back(camera);
    for (int n = 0; n < neighbours; ++n) {
      TestCamera<M> neighbour = camera;
      neighbour.name += " neighbour " + std::to_string(n);
      for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
        if (M::kParameters[i].group != ParameterGroup::kLens) continue;
        const bool in_pixels = M::kParameters[i].unit.find("px") != std::string_view::npos;
        const double value = camera.intrinsics.values[i];
        const double changed = value + (0.1 * std::abs(value) + (in_pixels ? 0.0 : 0.01)) * uniform(generator);
        const bool allowed = changed > M::kParameters[i].lower && changed < M::kParameters[i].upper;
        neighbour.intrinsics.values[i] = allowed ? changed : value;
      }
      result.push_back(neighbour);
    }
  }
  return result;
}

/// The ray at `angle` from the axis, `azimuth` from x towards y.
template <class T>
std::array<T, 3> ray_at(const T& angle, double azimuth, double length = 1.0) {
  using std::cos;
  using std::sin;
  return {length * std::cos(azimuth) * sin(angle), length * std::sin(azimuth) * sin(angle), length * cos(angle)};
}

/// Angle between two rays [rad], exact for small angles.
inline double angle_between(const Ray& a, const Ray& b) {
  const Ray cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// Image radius on the normalised plane (distance from the principal point over the central focal lengths), and its derivative
/// by the angle [1 / rad].
struct RadiusAndDerivative {
  double radius;
  double derivative;
};

template <CameraModelType M>
std::optional<RadiusAndDerivative> radius_and_derivative(const double* p, double angle, double azimuth) {
  using Jet = ceres::Jet<double, 1>;
  std::array<Jet, kParameterCount<M>> parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i] = Jet(p[i]);
  const std::array<Jet, 3> ray = ray_at(Jet(angle, 0), azimuth);
  Jet pixel[2];
  if (!M::project(parameters.data(), ray.data(), pixel)) return std::nullopt;
  const std::array<double, 2> centre = M::principal_point(p);
  const std::array<double, 2> focal = M::central_focal_lengths(p);
  const Jet mx = (pixel[0] - centre[0]) / focal[0];
  const Jet my = (pixel[1] - centre[1]) / focal[1];
  const Jet radius = ceres::sqrt(mx * mx + my * my);
  return RadiusAndDerivative{radius.a, radius.v[0]};
}

inline const std::vector<double>& some_azimuths() {
  static const std::vector<double> azimuths = {0.0, 0.3, 0.25 * std::numbers::pi, 0.5 * std::numbers::pi, 2.0, 3.0, -2.5, -0.7};
  return azimuths;
}

/// Angles from 0 to `last`, with more of them close to both ends and at 90 degrees.
inline std::vector<double> angles_up_to(double last) {
  std::vector<double> angles;
  constexpr int kCount = 100;
  for (int i = 0; i <= kCount; ++i) angles.push_back(last * i / kCount);
  for (double distance = 1e-9; distance < 0.1; distance *= 10.0) {
    for (const double angle :
         {distance, last - distance, 0.5 * std::numbers::pi - distance, 0.5 * std::numbers::pi + distance}) {
      if (angle > 0.0 && angle <= last) angles.push_back(angle);
    }
  }
  if (last >= 0.5 * std::numbers::pi) angles.push_back(0.5 * std::numbers::pi);
  std::ranges::sort(angles);
  return angles;
}

/// Calls f.template operator()<M>() for every model of the list, with a trace that names the model.
template <class F>
void for_each_model(F&& f) {
  ModelList::for_each([&]<CameraModelType M>() {
    SCOPED_TRACE(std::string(M::kId));
    f.template operator()<M>();
  });
}

}  // namespace fca::test
