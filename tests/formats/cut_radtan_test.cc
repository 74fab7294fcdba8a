// SPDX-License-Identifier: BSD-3-Clause
// radtan of the corpus's lenses that it can describe only a cone of: the best that does not fold (best_radtan.h)? Without the
// corpus, skipped.
#include "best_radtan.h"
#include "formats/test_files.h"

#include <fca/convert/convert.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>

namespace fca::test {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// Every camera with a model that a file of the corpus holds, once; a few of them but in a long run.
std::vector<Camera> corpus_cameras() {
  std::map<std::vector<double>, Camera> cameras;
  for (const Format& format : all_formats()) {
    for (const fs::path& path : corpus_files_of(format.id)) {
      Diagnostics diagnostics;
      std::optional<text::Document> document = text::read_document(path.string(), diagnostics);
      if (!document) continue;
      const std::optional<Calibration> calibration = read_calibration({*std::move(document)}, nullptr, {}, diagnostics);
      if (!calibration) continue;
      for (Camera camera : calibration->rig.cameras) {
        if (!camera.image_size || !camera.rays.empty() || !validate(camera.model).empty()) continue;
        camera.name = path.filename().string() + " " + camera.name;
        const std::span<const double> values = parameter_values(camera.model);
        cameras.emplace(std::vector<double>(values.begin(), values.end()), std::move(camera));
      }
    }
  }
  constexpr std::size_t kEvery = 48;
  const bool all = std::getenv("FCA_ALL_RANDOM_CAMERAS") != nullptr;
  std::vector<Camera> chosen;
  std::size_t i = 0;
  for (auto& [values, camera] : cameras) {
    if (all || i++ % kEvery == 0) chosen.push_back(std::move(camera));
  }
  return chosen;
}

TEST(CutRadtan, OfTheCorpusIsTheBestThatDoesNotFold) {
  if (!fs::exists(shared_dir() / "corpus" / "kalibr")) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::mt19937 starts(28);
  double largest = 0.0;
  int compared = 0;
  for (const Camera& camera : corpus_cameras()) {
    for (const int coefficients : {4, 5}) {
      ConvertOptions options;
      options.model = "radtan";
      options.bound = false;
      if (coefficients == 4) options.ranges = {{"k3", 0.0, 0.0}};
      Diagnostics diagnostics;
      const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
      if (!conversion || !conversion->report.angle_reduced) continue;
      const Cone cone(camera, conversion->report.scored_to_deg * kRadiansPerDegree);
      const double rms = cone.rms_of(conversion->camera.model);
      const double ratio = rms / best_radtan_rms(camera, cone, coefficients, starts);
      EXPECT_LE(ratio, 1.005) << camera.name << ", " << coefficients << " coefficients: " << rms << " px";
      EXPECT_GE(ratio, 0.9998) << camera.name << ": the reference is none";
      largest = std::max(largest, ratio);
      ++compared;
      if (ratio > 1.001) std::printf("  %s, %d coefficients: %.4f\n", camera.name.c_str(), coefficients, ratio);
    }
  }
  std::printf("  %d fits compared, largest ratio %.4f\n", compared, largest);
}

}  // namespace
}  // namespace fca::test
