// SPDX-License-Identifier: BSD-3-Clause
// Another camera into every settings file that people have published: what they tuned and wrote next to it stays byte by byte,
// and the program that read the file before reads the new camera.
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

namespace fca::test {
namespace {

/// Every number of the cameras another one, of the same lens.
Rig with_other_cameras(Rig rig) {
  for (Camera& camera : rig.cameras) {
    for (const ParameterId focal : ParameterIds{"fx", "fy"})
      EXPECT_TRUE(set_parameter(camera.model, focal, 1.03125 * *parameter(camera.model, focal)));
    for (const ParameterId centre : ParameterIds{"cx", "cy"})
      EXPECT_TRUE(set_parameter(camera.model, centre, *parameter(camera.model, centre) + 1.5));
    if (const std::optional<double> k1 = parameter(camera.model, "k1")) set_parameter(camera.model, "k1", 0.9375 * *k1);
  }
  return rig;
}

/// The same rig seen through another lens: cameras with distortion become such without, and those without get some.
Rig with_another_lens(Rig rig) {
  for (Camera& camera : rig.cameras) {
    const double f = *parameter(camera.model, "fx");
    const double cx = *parameter(camera.model, "cx");
    const double cy = *parameter(camera.model, "cy");
    const std::string_view model = model_info(camera.model).id;
    if (model == "radtan") {
      camera.model = Intrinsics<Kb4>{{f, f, cx, cy, -0.01, 0.002, -0.001, 0.0005}};
    } else {
      camera.model = Intrinsics<Radtan>{{f, f, cx, cy, -0.1, 0.01, 0.001, -0.001, 0.0}};
    }
  }
  return rig;
}

/// Whole lines of tuning and, `with_comments`, of comments and those after values.
std::vector<std::string> kept_by_the_owner(const std::string& bytes, bool with_comments) {
  std::vector<std::string> lines;
  for (const std::string& line : split(bytes, '\n')) {
    const std::size_t comment = line.find('#');
    if (line.starts_with("ORBextractor.") || line.starts_with("Viewer.")) {
      lines.push_back(line);
    } else if (with_comments && comment != std::string::npos) {
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
    if (!view.loads()) return sentence_of(view.refusals.front());
  }
  return "";
}

/// `change` of the cameras of every base of the corpus: tuning and comments stay, and the programs that read the base before
/// read the new cameras.
void expect_bases_take(Rig (*change)(Rig), int fewest_tried, int fewest_proven) {
  const fs::path folder = shared_dir() / "corpus" / "orbslam3";
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
    const Rig other = change(*rig);
    WriteOptions options;
    options.keeps_layout = true;
    const std::optional<Written> written = write_calibration(format, &*base, other, options, diagnostics);
    if (!written) continue;
    ++tried;
    const text::Document& document = written->files.front().document;
    // Only a base whose layout has no such lens is rewritten; --into asks before.
    if (document.source().bytes != bytes) {
      EXPECT_FALSE(format.layout_holds(*base, model_info(other.cameras.front().model).id)) << "composed anew";
      continue;
    }
    // A comment after a coefficient that the new lens has not goes with it, and is listed.
    const bool listed =
        std::ranges::any_of(written->losses, [](const Loss& loss) { return id_of(loss) == "comments-dropped"; });
    EXPECT_EQ(kept_by_the_owner(document.bytes(), !listed), kept_by_the_owner(bytes, !listed));
    // A file's own defects are its owner's.
    if (!refusal(bytes, *written).empty()) continue;
    ++proven;
    consumers::LoadOptions as_written;
    if (!written->sensor.empty()) as_written.sensor = written->sensor;
    // Tracking.cc: with depth and an IMU, V1.0 exits where a KannalaBrandt8 has no Camera2. The user is told so by the proof.
    if (written->sensor == "rgbd-inertial" && model_info(other.cameras.front().model).id == "kb4") continue;
    for (const std::string& program : written->files.front().programs) {
      const ProofResult proof =
          prove(*consumers::find_consumer(program), document.bytes(), as_written, other, written->files.front().cameras);
      EXPECT_TRUE(proof.agrees()) << program << " " << proof.max_diff_px << " px "
                                  << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
    }
  }
  EXPECT_GT(tried, fewest_tried);
  EXPECT_GT(proven, fewest_proven);
}

class IntoCorpus : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(shared_dir() / "corpus" / "orbslam3")) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  }
};

TEST_F(IntoCorpus, AnotherCameraLeavesTheTuningAlone) { expect_bases_take(with_other_cameras, 90, 50); }

TEST_F(IntoCorpus, ACameraOfAnotherLensLeavesTheTuningAlone) { expect_bases_take(with_another_lens, 90, 50); }

}  // namespace
}  // namespace fca::test
