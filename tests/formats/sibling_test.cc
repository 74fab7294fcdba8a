// SPDX-License-Identifier: BSD-3-Clause
// A camera that is added to a file looks as the cameras that stand there: indentation, kind of lists, order of keys.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <regex>

namespace fca::test {
namespace {

std::string written_over(const std::string& bytes, const std::string& name, const Rig& rig) {
  const Calibration base = calibration_of(bytes, name);
  Diagnostics diagnostics;
  const std::optional<Written> written = base.format->write(&base.documents.front(), rig, {}, diagnostics);
  EXPECT_TRUE(written && written->losses.empty());
  return written ? written->files.front().document.bytes() : "";
}

/// A text without comments and with N for every number. One blank for any before a number or comma: numbers differ in length.
std::string shape(const std::string& text) {
  std::string result = std::regex_replace(text, std::regex(" *#[^\n]*"), "");
  result = std::regex_replace(result, std::regex("[-+]?[0-9][0-9.eE+-]*"), "N");
  return std::regex_replace(result, std::regex(" +N"), " N");
}

/// From `begin` to `end`, or to the end of the text.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  EXPECT_NE(from, std::string::npos) << begin << "\n" << text;
  return from == std::string::npos ? "" : text.substr(from, text.find(end, from + 1) - from);
}

Rig with_a_camera(Rig rig, const std::string& like, const std::string& name) {
  Camera camera = *rig.find_camera(like);
  camera.name = name;
  for (double& value : parameter_values(camera.model)) value *= 1.0009765625;
  rig.cameras.push_back(camera);
  rig.extra_fields.clear();  // of another camera, or another file
  return rig;
}

TEST(Sibling, AKalibrCameraTakesTheStyleOfTheOneBeforeIt) {
  for (const fs::path& path : files_in(testdata_dir() / "kalibr" / "good", ".yaml")) {
    const std::string bytes = read_file(path);
    const Calibration base = calibration_of(bytes);
    // Next to other keys cameras neither come nor go.
    const bool cameras_alone = std::ranges::all_of(base.documents.front().root().entries,
                                                   [](const text::Entry& entry) { return entry.key.value.starts_with("cam"); });
    if (base.rig.cameras.empty() || !cameras_alone) continue;
    SCOPED_TRACE(path.filename());
    const std::string last = base.rig.cameras.back().name;
    const std::string added = "cam" + std::to_string(std::stoi(last.substr(3)) + 1);
    Rig rig = with_a_camera(base.rig, last, added);
    if (const std::optional<Transform> T = rig.resolve(last, "imu0")) rig.poses.push_back({added, "imu0", *T});
    Diagnostics diagnostics;
    const std::optional<Written> written = base.format->write(&base.documents.front(), rig, {}, diagnostics);
    ASSERT_TRUE(written);
    const std::string result = written->files.front().document.bytes();
    const Rig back = calibration_of(result).rig;
    EXPECT_TRUE(std::ranges::equal(back.cameras, rig.cameras, {}, &Camera::model, &Camera::model)) << result;
    const std::string whole = "\n" + result;
    const std::string sibling = between(whole, "\n" + last + ":", "\n" + added + ":");
    std::string block = whole.substr(whole.find("\n" + added + ":"));
    // A comment between two cameras belongs to neither.
    while (block.ends_with('\n') || block.ends_with('\r')) block.pop_back();
    const auto lines = [](const std::string& text) {
      std::vector<std::string> kept;
      bool in_chain = false;
      for (std::string line : split(shape(text), '\n')) {
        while (line.ends_with('\r') || line.ends_with(' ')) line.pop_back();
        const bool key = std::regex_match(line, std::regex(" +[A-Za-z].*"));
        if (key) in_chain = line.find("T_cn_cnm") != std::string::npos || line.find("cam_overlaps") != std::string::npos;
        if (!in_chain && !line.empty()) kept.push_back(line);
      }
      return kept;
    };
    EXPECT_EQ(lines(block), lines(sibling)) << result;
  }
}

TEST(Sibling, ANewTransformIsLaidOutAsTheOthers) {
  const std::string bytes = read_file(testdata_dir() / "kalibr/good/block-style.yaml");
  Rig rig = with_a_camera(calibration_of(bytes).rig, "cam0", "cam1");
  rig.poses.push_back({"cam1", "imu0", *rig.resolve("cam0", "imu0")});
  const std::string result = written_over(bytes, "x.yaml", rig);
  const std::string added = result.substr(result.find("\ncam1:"));
  const std::string chain = shape(between(added, "T_cn_cnm1:", "    resolution"));
  EXPECT_EQ(chain.substr(chain.find('\n')), shape(between(bytes, "T_cam_imu:", "    resolution")).substr(10)) << result;
}

TEST(Sibling, AnOpenCvCameraTakesTheStyleOfOneOfItsKind) {
  const std::string yaml = read_file(testdata_dir() / "opencv/good/cameras.yml");
  const Calibration cameras = calibration_of(yaml, "cameras.yml");
  for (const char* extension : {".yml", ".xml", ".json"}) {
    SCOPED_TRACE(extension);
    std::string bytes = yaml;
    const std::string name = std::string("x") + extension;
    if (std::string(extension) != ".yml") {
      WriteOptions options;
      options.extension = extension;
      Diagnostics diagnostics;
      bytes = find_format("opencv")->write(nullptr, cameras.rig, options, diagnostics)->files.front().document.bytes();
    }
    Rig rig = with_a_camera(cameras.rig, "cam1", "cam3");
    rig.poses.push_back({"reference", "cam3", *cameras.rig.resolve("reference", "cam1")});
    const std::string result = written_over(bytes, name, rig);
    const Rig back = calibration_of(result, name).rig;
    EXPECT_TRUE(back.cameras == rig.cameras) << result;
    EXPECT_TRUE(back.poses == rig.poses) << result;
    const bool xml = std::string(extension) == ".xml";
    std::string sibling = xml ? between(result, "<camera_1>", "</camera_1>") : between(result, "camera_1", "camera_2");
    std::string added = xml ? between(result, "<camera_3>", "</camera_3>") : between(result, "camera_3", "</none>");
    // The fisheye's matrices alone: what stands after them is the neighbours' affair.
    sibling = sibling.substr(0, sibling.find("distortion_type"));
    added = added.substr(0, added.find("distortion_type"));
    EXPECT_EQ(shape(added), shape(sibling)) << result;
  }
}

}  // namespace
}  // namespace fca::test
