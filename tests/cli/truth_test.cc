// SPDX-License-Identifier: BSD-3-Clause
// One physical camera that others calibrated twice, in two models (../shared/corpus/truth). Converting one calibration to the
// model of the other must not take it farther from that one than it was.
#include "cli/run_program.h"

#include <rapidjson/document.h>

#include <string>
#include <vector>

namespace fca::test {
namespace {

/// `from` is converted for the program `to` and the model, and compared with the independent calibration.
struct Pair {
  std::string independent;
  std::string from;
  std::string to;
  std::string model;
  std::string max_angle_deg;  ///< Empty: the whole image.
};

std::vector<Pair> pairs() {
  const std::string tumvi = "rpng__open_vins__tum_vi_kb4.yaml";
  const std::string tumvi_ds = "basalt__tumvi_512_ds_calib.json";
  const std::string tumvi_eucm = "basalt__tumvi_512_eucm_calib.json";
  const std::string euroc = "rpng__open_vins__euroc_mav_radtan.yaml";
  const std::string factory = "basalt-xr__odysseyplus_rt8_calib.json";
  const std::string odyssey = "basalt-xr__odysseyplus_kb4_calib.json";
  // Not EuRoC's ds to radtan, which cannot hold the lens' corners: that conversion ends with poor-fit.
  return {{tumvi_ds, tumvi, "basalt", "ds", "97.5"},
          {tumvi_eucm, tumvi, "basalt", "eucm", "97.5"},
          {tumvi, tumvi_ds, "openvins", "kb4", "97.5"},
          {tumvi, tumvi_eucm, "openvins", "kb4", "97.5"},
          {"basalt__euroc_ds_calib.json", euroc, "basalt", "ds", ""},
          {"basalt__euroc_eucm_calib.json", euroc, "basalt", "eucm", ""},
          {odyssey, factory, "basalt", "kb4", ""},
          {factory, odyssey, "basalt", "rational", ""}};
}

class Truth : public ::testing::TestWithParam<Pair> {
 protected:
  [[nodiscard]] std::vector<std::string> with_angle(std::vector<std::string> words) const {
    if (!GetParam().max_angle_deg.empty()) words.insert(words.end(), {"--max-angle", GetParam().max_angle_deg});
    return words;
  }

  /// The rms [px] over the image of the independent calibration's first camera; negative where compare fails.
  [[nodiscard]] double distance_to_independent(const std::string& file) const {
    const std::string independent = (folder_ / GetParam().independent).string();
    const RunResult run = run_program(with_angle({"compare", independent, file, "--camera", "0", "--json"}));
    rapidjson::Document document;
    document.Parse(run.out.c_str(), run.out.size());
    if (run.code != 0 || document.HasParseError()) {
      ADD_FAILURE() << file << ": " << run.out << run.err;
      return -1.0;
    }
    return document["files"][0]["cameras"][0]["error_px"]["rms"].GetDouble();
  }

  fs::path folder_ = fs::path(FCA_SHARED_DIR) / "corpus" / "truth";
};

TEST_P(Truth, AConversionStaysAsCloseToAnIndependentCalibration) {
  if (!fs::exists(folder_)) GTEST_SKIP() << "no files in " << folder_;
  const TemporaryFolder folder;
  const std::string from = (folder_ / GetParam().from).string();
  const std::string converted = folder / (GetParam().to == "basalt" ? "converted.json" : "converted.yaml");
  const RunResult run = run_program(
      with_angle({"convert", from, "--camera", "0", "--to", GetParam().to, "--model", GetParam().model, "-o", converted}));
  ASSERT_EQ(run.code, 0) << run.err;
  const double before = distance_to_independent(from);
  const double after = distance_to_independent(converted);
  EXPECT_GT(before, 0.1);  // two calibrations, not one twice
  EXPECT_GE(after, 0.0);
  EXPECT_LE(after, 1.01 * before);
}

INSTANTIATE_TEST_SUITE_P(Files, Truth, ::testing::ValuesIn(pairs()));

}  // namespace
}  // namespace fca::test
