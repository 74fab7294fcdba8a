// SPDX-License-Identifier: BSD-3-Clause
// Another camera into every settings file that people have published: what they tuned and wrote beside it stays byte by byte,
// and the program that read the file before reads the new camera.
#include "formats/test_files.h"

#include <fca/formats/proof.h>

namespace fca::test {
namespace {

/// Every number of the cameras another one, of the same lens.
Rig with_other_cameras(Rig rig) {
  for (Camera& camera : rig.cameras) {
    for (const std::string_view focal : {"fx", "fy"})
      EXPECT_TRUE(set_parameter(camera.model, focal, 1.03125 * *parameter(camera.model, focal)));
    for (const std::string_view centre : {"cx", "cy"})
      EXPECT_TRUE(set_parameter(camera.model, centre, *parameter(camera.model, centre) + 1.5));
    if (const std::optional<double> k1 = parameter(camera.model, "k1")) set_parameter(camera.model, "k1", 0.9375 * *k1);
  }
  return rig;
}

/// Whole lines of tuning and of comments, and the comments behind values.
std::vector<std::string> kept_by_the_owner(const std::string& bytes) {
  std::vector<std::string> lines;
  for (const std::string& line : split(bytes, '\n')) {
    const std::size_t comment = line.find('#');
    if (line.starts_with("ORBextractor.") || line.starts_with("Viewer.")) {
      lines.push_back(line);
    } else if (comment != std::string::npos) {
      lines.push_back(line.substr(comment));
    }
  }
  return lines;
}

/// The first reason of any of the programs not to load the bytes in the mode; "" if all do.
std::string refusal(const std::string& bytes, const Written& written) {
  consumers::LoadOptions options;
  if (!written.sensor.empty()) options.sensor = written.sensor;
  for (const std::string& program : written.files.front().programs) {
    const consumers::ConsumerView view = consumers::find_consumer(program)->load(bytes, options);
    if (!view.loads()) return view.refusals.front();
  }
  return "";
}

TEST(IntoCorpus, AnotherCameraLeavesTheTuningAlone) {
  const fs::path folder = shared_dir() / "corpus" / "orbslam3";
  if (!fs::exists(folder)) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const Format& format = *find_format("orbslam3");
  int tried = 0;
  int proven = 0;
  for (const fs::path& path : files_in(folder)) {
    SCOPED_TRACE(path.filename().string());
    Diagnostics diagnostics;
    const std::string bytes = read_file(path);
    const std::optional<text::Document> base = text::parse_document({path.filename().string(), bytes}, diagnostics);
    const std::optional<Rig> rig = base ? format.read(std::span(&*base, 1), {}, diagnostics) : std::nullopt;
    if (!rig || rig->cameras.empty()) continue;
    const Rig other = with_other_cameras(*rig);
    const std::optional<Written> written = write_calibration(format, &*base, other, {}, diagnostics);
    if (!written) continue;
    ++tried;
    const text::Document& document = written->files.front().document;
    EXPECT_EQ(document.source().bytes, bytes) << "composed anew";
    EXPECT_EQ(kept_by_the_owner(document.bytes()), kept_by_the_owner(bytes));
    // A file's own defects are its owner's.
    if (!refusal(bytes, *written).empty()) continue;
    ++proven;
    consumers::LoadOptions options;
    if (!written->sensor.empty()) options.sensor = written->sensor;
    for (const std::string& program : written->files.front().programs) {
      const ProofResult proof =
          prove(*consumers::find_consumer(program), document.bytes(), options, other, written->files.front().cameras);
      EXPECT_TRUE(proof.agrees()) << program << " " << proof.max_diff_px << " px "
                                  << (proof.refusals.empty() ? "" : proof.refusals.front());
    }
  }
  EXPECT_GT(tried, 90);
  EXPECT_GT(proven, 50);
}

}  // namespace
}  // namespace fca::test
