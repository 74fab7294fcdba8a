// SPDX-License-Identifier: BSD-3-Clause
// A file of which the end is missing is refused, or it is read as what is whole says: no camera of it is silently another one.
// (Two ends cannot be told: within the last line's number, and before ORB-SLAM's k3, which may be left out.)
#include "formats/test_files.h"
#include "opencv/layout.h"

#include <cstdio>

namespace fca::test {
namespace {

/// Every so many bytes: a prime, so that every kind of place is cut.
constexpr std::size_t kStride = 3;

/// Can the text end within a number or word that counts: "xi: 1.2" of "xi: 1.25", "- 0.1" of "- 0.125"?
bool ends_in_a_value(const std::string& text, bool words) {
  const std::string last = text.substr(text.find_last_of('\n') + 1);
  const std::size_t begin = last.find_first_not_of(" \t\r");
  if (begin == std::string::npos || last.back() == ']') return false;
  const std::size_t colon = last.find(':');
  const bool item = last[begin] == '-';
  return words || item || (colon != std::string::npos && last.find_first_not_of(" \t", colon + 1) != std::string::npos);
}

/// The same camera, or without a k3; of a table the rays that came so far.
bool is_as_meant(const Camera& camera, const Camera& whole) {
  if (!camera.rays.empty()) {
    return camera.rays.size() <= whole.rays.size() &&
           std::ranges::equal(
               camera.rays, std::span(whole.rays).first(camera.rays.size()),
               [](const Correspondence& a, const Correspondence& b) { return a.ray == b.ray && a.pixel == b.pixel; });
  }
  CameraModel without_k3 = whole.model;
  static_cast<void>(set_parameter(without_k3, "k3", 0.0));
  return camera.model == whole.model || (model_info(camera.model).id == "radtan" && camera.model == without_k3);
}

/// Under which keys an OpenCV file's camera matrices stand at its top level.
std::vector<std::string> matrix_keys(const text::Document& document) {
  std::vector<std::string> keys;
  const std::optional<opencv::Layout> layout = opencv::find_layout(document);
  if (!layout || layout->in_maps()) return keys;
  for (const opencv::CameraKeys& camera : layout->cameras) keys.push_back(camera.matrix);
  return keys;
}

std::size_t begun_cameras(const std::string& prefix, const std::vector<std::string>& keys) {
  const auto begun = [&prefix](const std::string& key) { return prefix.find("\n" + key + ":") != std::string::npos; };
  return static_cast<std::size_t>(std::ranges::count_if(keys, begun));
}

class Truncated : public testing::TestWithParam<fs::path> {};

TEST_P(Truncated, IsRefusedOrSaysWhatIsMissing) {
  const std::string bytes = read_file(GetParam());
  const std::string name = GetParam().filename().string();
  const Rig whole = calibration_of(bytes, name).rig;
  const std::vector<std::string> keys = matrix_keys(document_of(bytes, name));
  int read = 0;
  for (std::size_t length = GetParam().string().size() % kStride; length < bytes.size(); length += kStride) {
    const std::string prefix = bytes.substr(0, length);
    SCOPED_TRACE(prefix.substr(prefix.size() - std::min<std::size_t>(prefix.size(), 60)));
    Parsed parsed = parse(prefix, name);
    std::optional<Calibration> calibration;
    if (parsed.document) calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
    ASSERT_EQ(calibration.has_value(), !parsed.diagnostics.has_errors()) << parsed.rendered();
    if (!calibration) continue;
    ++read;
    EXPECT_TRUE(calibration->rig.cameras.size() >= begun_cameras(prefix, keys) || !parsed.diagnostics.entries().empty())
        << "a camera has begun and is gone";
    if (ends_in_a_value(prefix, parsed.document->syntax() == text::Syntax::kWords)) continue;
    for (const Camera& camera : calibration->rig.cameras) {
      // Images of depth have the lens of Infrared 1, which stands further on.
      const Camera* meant = whole.find_camera(camera.name == "Depth" ? "Infrared_1" : camera.name);
      const bool as_meant = meant != nullptr && is_as_meant(camera, *meant);
      EXPECT_TRUE(as_meant || !parsed.diagnostics.entries().empty())
          << camera.name << " is read as " << model_info(camera.model).id << " and nothing is said";
    }
  }
  std::printf("  %d prefixes read\n", read);
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename().string() + "_" + info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, Truncated, testing::ValuesIn(files_of_all_formats("good")), test_name);

}  // namespace
}  // namespace fca::test
