// SPDX-License-Identifier: BSD-3-Clause
// bench-points MODEL RAYS PIXELS NAME=VALUE...: ns per point of project_all and unproject_all over files of doubles, each the
// shortest of ten. tests/bench/python calls it.
#include <fca/models/camera_model.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {
namespace {

std::vector<double> numbers_of(const std::string& path) {
  std::vector<double> numbers(std::filesystem::file_size(path) / sizeof(double));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return numbers;
}

CameraModel model_of(const std::string& id, int count, char** words) {
  CameraModel model = make_model(id).value();
  for (int i = 0; i < count; ++i) {
    const std::string word = words[i];
    const std::size_t equals = word.find('=');
    const std::optional<ParameterId> parameter = ParameterId::find(word.substr(0, equals));
    if (!parameter || !set_parameter(model, *parameter, std::stod(word.substr(equals + 1)))) std::exit(2);
  }
  return model;
}

/// ns per point. As Python's functions do, each time makes its own array.
template <class ForAll>
double least_ns(const CameraModel& model, const std::vector<double>& asked, std::size_t points, std::size_t columns,
                ForAll for_all) {
  constexpr int kRepetitions = 10;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRepetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const std::unique_ptr<double[]> answers(new double[points * columns]);
    for_all(model, asked, std::span(answers.get(), points * columns));
    best = std::min(best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return best / static_cast<double>(points);
}

}  // namespace
}  // namespace fca

int main(int count, char** words) {
  if (count < 4) return 2;
  const fca::CameraModel model = fca::model_of(words[1], count - 4, words + 4);
  const std::vector<double> rays = fca::numbers_of(words[2]);
  const std::vector<double> pixels = fca::numbers_of(words[3]);
  const std::size_t points = rays.size() / 3;
  std::printf("%.2f %.2f\n", fca::least_ns(model, rays, points, 2, &fca::project_all),
              fca::least_ns(model, pixels, points, 3, &fca::unproject_all));
  return 0;
}
