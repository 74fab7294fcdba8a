// SPDX-License-Identifier: BSD-3-Clause
// --into, --in-place and --join: several files and one rig.
#include "cli/run_program.h"

#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>

namespace fca::test {
namespace {

const std::string kTumvi = testdata("formats/kalibr/good/tumvi.yaml");
const std::string kDs = testdata("formats/kalibr/good/ds.yaml");
const std::string kSettings = testdata("formats/orbslam3/good/v1-stereo-inertial.yaml");
const std::string kFork = testdata("formats/orbslam3/good/slam-no-opt-eucm.yaml");

Rig rig_in(const std::string& bytes) {
  Diagnostics diagnostics;
  std::optional<text::Document> document = text::parse_document({"output", bytes}, diagnostics);
  std::optional<Calibration> calibration;
  if (document) calibration = read_calibration({*std::move(document)}, nullptr, {}, diagnostics);
  EXPECT_TRUE(calibration) << bytes;
  return calibration ? calibration->rig : Rig();
}

std::vector<std::string> lines_that_differ(const std::string& a, const std::string& b) {
  std::vector<std::string> different;
  std::istringstream left(a);
  std::istringstream right(b);
  std::string x;
  std::string y;
  while (std::getline(left, x) && std::getline(right, y)) {
    if (x != y) different.push_back(y);
  }
  return different;
}

TEST(Into, OnlyTheCamerasNumbersChange) {
  const RunResult run = run_program({"convert", kDs, "--into", kSettings, "--max-angle", "97.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string before = read_file(kSettings);
  const std::vector<std::string> changed = lines_that_differ(before, run.out);
  EXPECT_EQ(std::count(before.begin(), before.end(), '\n'), std::count(run.out.begin(), run.out.end(), '\n'));
  EXPECT_FALSE(changed.empty());
  for (const std::string& line : changed)
    EXPECT_TRUE(line.starts_with("Camera1.") || line.starts_with("Camera2.") || contains(line, "data") || contains(line, ","))
        << line;
  EXPECT_EQ(rig_in(run.out).imus, rig_in(before).imus) << "the input has no IMU, so the base's stays";
}

// Into a fork's file goes the fork's model.
TEST(Into, AForksFileKeepsItsModel) {
  const RunResult run = run_program({"convert", kTumvi, "--camera", "cam0", "--into", kFork, "--max-angle", "97.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "EUCM")) << run.out;
  EXPECT_EQ(model_info(rig_in(run.out).cameras.at(0).model).id, "eucm");
}

TEST(Into, TheBaseChangesOnlyInPlace) {
  const TemporaryFolder folder;
  const std::string base = folder.write("settings.yaml", read_file(kSettings));
  EXPECT_EQ(run_program({"convert", kDs, "--into", base, "-o", folder / "other.yaml", "--max-angle", "97.5"}).code, 0);
  EXPECT_EQ(read_file(base), read_file(kSettings));
  const RunResult in_place = run_program({"convert", kDs, "--into", base, "--in-place", "--max-angle", "97.5"});
  EXPECT_EQ(in_place.code, 0) << in_place.err;
  EXPECT_EQ(read_file(base), read_file(folder / "other.yaml"));
  // A second time there is nothing to change.
  EXPECT_EQ(run_program({"convert", base, "--into", base, "--in-place"}).code, 0);
  EXPECT_EQ(read_file(base), read_file(folder / "other.yaml"));
}

TEST(Into, ContradictionsAreUsage) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--in-place", "--to", "kalibr"},
                                                {"--into", kSettings, "--in-place", "-o", "x.yaml"},
                                                {"--into", kSettings, "--to", "kalibr"},
                                                {"--into", kSettings, kDs}}) {
    std::vector<std::string> all = {"convert", kTumvi};
    all.insert(all.end(), words.begin(), words.end());
    const RunResult run = run_program(all);
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(run_program({"convert", kTumvi, "--into", "/nowhere.yaml", "--json"}).code, 4);
}

TEST(Join, TwoChainsAreOneRig) {
  const RunResult run =
      run_program({"convert", kTumvi, kDs, "--join", "--to", "kalibr", "--model", "kb4", "--max-angle", "97.5"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Rig joined = rig_in(run.out);
  const Rig first = rig_in(read_file(kTumvi));
  ASSERT_EQ(joined.cameras.size(), 4U);
  EXPECT_EQ(joined.cameras[0].model, first.cameras[0].model);
  // The poses of the second chain are its own cameras'.
  EXPECT_TRUE(joined.resolve("cam3", "cam2"));
  EXPECT_FALSE(joined.resolve("cam2", "cam1"));
}

TEST(Join, ShowNamesTheJoinedCameras) {
  const RunResult run = run_program({"show", kTumvi, kDs, "--join"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "\ncam3:")) << run.out;
}

}  // namespace
}  // namespace fca::test
