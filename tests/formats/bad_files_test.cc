// SPDX-License-Identifier: BSD-3-Clause
// testdata/formats/<format>/bad: every file stands beside what people are told about it, word for word. Adding a file adds a test:
// put NAME.yaml there and run with FCA_WRITE_EXPECTED=1 to have NAME.yaml.expected written, then read it.
//
// A file can be bad in three ways, and NAME.yaml.expected holds them in this order: the reader refuses or warns; the numbers are no
// camera (validate); it is a camera, but the format's own programs would not load it (ask_readers).
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/models/camera_model.h>

#include <cstdlib>

namespace fca::test {
namespace {

std::string judged(const fs::path& path) {
  Parsed parsed = parse(read_file(path), path.filename().string());
  std::optional<Calibration> calibration;
  if (parsed.document) calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  std::string text = parsed.rendered();
  if (!calibration) return text;
  for (const Camera& camera : calibration->rig.cameras) {
    for (const std::string& problem : validate(camera.model)) text += "no camera: " + camera.name + ": " + problem + "\n";
  }
  for (const Readers::Program& program : ask_readers(calibration->format->id, parsed.source.bytes).programs) {
    for (const std::string& refusal : program.refusals) text += program.program + ": " + refusal + "\n";
  }
  return text;
}

class BadFiles : public testing::TestWithParam<fs::path> {};

TEST_P(BadFiles, AreExplainedWordForWord) {
  const fs::path expected = GetParam().string() + ".expected";
  const std::string text = judged(GetParam());
  if (std::getenv("FCA_WRITE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << text;
  ASSERT_TRUE(fs::exists(expected)) << "run with FCA_WRITE_EXPECTED=1 and read what it wrote:\n" << text;
  EXPECT_EQ(text, read_file(expected));
  EXPECT_FALSE(text.empty()) << "nothing is said about a bad file";
}

std::vector<fs::path> bad_files() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& format : fs::directory_iterator(testdata_dir())) {
    if (!fs::exists(format.path() / "bad")) continue;
    const std::vector<fs::path> found = files_in(format.path() / "bad", ".yaml");
    files.insert(files.end(), found.begin(), found.end());
  }
  std::ranges::sort(files);
  return files;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename().string() + "_" + info.param.stem().string();
  std::ranges::replace_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, BadFiles, testing::ValuesIn(bad_files()), test_name);

TEST(BadFileFolder, HoldsEnough) {
  for (const char* format : {"kalibr", "orbslam3"}) EXPECT_GE(files_in(testdata_dir() / format / "bad", ".yaml").size(), 12U) << format;
  for (const char* format : {"kalibr", "orbslam3"}) {
    for (const fs::path& path : files_in(testdata_dir() / format / "bad", ".expected")) {
      EXPECT_TRUE(fs::exists(path.parent_path() / path.stem())) << path << " explains a file that is not there";
    }
  }
}

class GoodFiles : public testing::TestWithParam<fs::path> {};

TEST_P(GoodFiles, AreReadWithoutAWord) {
  Parsed parsed = parse(read_file(GetParam()));
  ASSERT_TRUE(parsed.document) << parsed.rendered();
  const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  ASSERT_TRUE(calibration) << parsed.rendered();
  EXPECT_EQ(parsed.rendered(), "");
  EXPECT_EQ(calibration->format->id, GetParam().parent_path().parent_path().filename().string());
  for (const Camera& camera : calibration->rig.cameras) EXPECT_TRUE(validate(camera.model).empty());
}

TEST_P(GoodFiles, AreWrittenBackByteForByte) {
  const std::string bytes = read_file(GetParam());
  const Calibration calibration = calibration_of(bytes);
  Diagnostics diagnostics;
  const std::optional<Written> written = calibration.format->write(&calibration.documents.front(), calibration.rig, {}, diagnostics);
  ASSERT_TRUE(written);
  ASSERT_EQ(written->files.size(), 1U);
  EXPECT_EQ(written->files.front().document.bytes(), bytes);
}

std::vector<fs::path> good_files() {
  std::vector<fs::path> files;
  for (const char* format : {"kalibr", "orbslam3"}) {
    const std::vector<fs::path> found = files_in(testdata_dir() / format / "good", ".yaml");
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

INSTANTIATE_TEST_SUITE_P(Formats, GoodFiles, testing::ValuesIn(good_files()), test_name);

}  // namespace
}  // namespace fca::test
