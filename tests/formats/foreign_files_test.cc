// SPDX-License-Identifier: BSD-3-Clause
// Files of other programs that share a key or a word with one of ours are not taken for it.
#include "formats/rigs.h"

#include <fca/code.h>

namespace fca::test {
namespace {

/// What is said of a file whose format nobody knows; nothing if it is taken for one of ours.
std::optional<Message> refusal(const std::string& bytes, const std::string& name) {
  Diagnostics diagnostics;
  if (detect_format(document_of(bytes, name), diagnostics)) return std::nullopt;
  return diagnostics.entries().front().facts;
}

TEST(ForeignFiles, Ov2SlamIsNoVins) {
  const std::string settings =
      "%YAML:1.0\nCamera.model_left: pinhole\nCamera.fxl: 450.5\nCamera.fyl: 451.25\nCamera.k1l: -0.25\n"
      "body_T_cam0: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n"
      "   data: [ 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1. ]\n";
  const std::optional<Message> said = refusal(settings, "stereo.yaml");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->code, Code::kFormatLooksLikeKeysBeside);
  EXPECT_EQ(said->arguments.front(), Argument(Message{Code::kLooksLikeOv2Slam}));
}

TEST(ForeignFiles, AReadmeIsNoCalibResults) {
  std::string readme =
      "Calibration\n\nThe file has the polynomial coefficients of the direct mapping function:\n5 -100 0 0.002 0 0\n";
  for (int i = 0; i < 20; ++i) readme += "Then run the program with the file and look at the affine parameters.\n";
  EXPECT_TRUE(refusal(readme, "README.txt"));
}

TEST(ForeignFiles, SettingsOfAnotherProgramAreNoIniOfRos) {
  EXPECT_TRUE(refusal("[Camera]\nimgRate=30\ndriver=2\n\n[Core]\nversion=1\n", "settings.ini"));
}

}  // namespace
}  // namespace fca::test
