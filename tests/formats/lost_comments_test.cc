// SPDX-License-Identifier: BSD-3-Clause
// A comment is somebody's words: an edit keeps it, or says that it went.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/formats/wording.h>

namespace fca::test {
namespace {

/// What the base becomes as a camera of `model`.
Written as_model(const std::string& bytes, const std::string& name, const CameraModel& model) {
  const Calibration base = calibration_of(bytes, name);
  Rig rig = base.rig;
  rig.cameras.front().model = model;
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(*base.format, &base.documents.front(), rig, {}, diagnostics);
  EXPECT_TRUE(written) << bytes;
  return written.value_or(Written());
}

std::vector<std::string> lost_comments(const Written& written) {
  std::vector<std::string> what;
  for (const Loss& loss : written.losses) {
    if (id_of(loss) == "comments-dropped") what.push_back(what_of(loss));
  }
  return what;
}

constexpr const char* kFlowList =
    "cam0:   # left\n"
    "  camera_model: pinhole\n"
    "  distortion_coeffs: [0.01,  # k1\n"
    "    0.02, 0.03, 0.04]  # four\n"
    "  distortion_model: equidistant  # of 3\n"
    "  intrinsics: [190.5, 190.25,\n"
    "    # the centre\n"
    "    254.0, 256.0]\n"
    "  resolution: [512, 512]\n"
    "  rostopic: \"/cam#0\"\n";

TEST(LostComments, ThoseInAReplacedListAreListedAndNoOther) {
  // eucm has six intrinsics in one list and no coefficients.
  const Written eucm = as_model(kFlowList, "chain.yaml", sample_model("eucm"));
  EXPECT_EQ(lost_comments(eucm), std::vector<std::string>{"comments # k1 and # the centre"});
  const std::string bytes = eucm.files.front().document.bytes();
  for (const char* kept : {"# left", "# four", "# of 3", "\"/cam#0\""}) EXPECT_NE(bytes.find(kept), std::string::npos) << bytes;
  // As many numbers as before change one by one.
  const Written kb4 = as_model(kFlowList, "chain.yaml", sample_model("kb4"));
  EXPECT_TRUE(lost_comments(kb4).empty());
  EXPECT_NE(kb4.files.front().document.bytes().find("# the centre"), std::string::npos);
}

TEST(LostComments, OfManyTheNumberIsSaid) {
  const std::string bytes = with_replaced(kFlowList, "    # the centre\n    254.0, 256.0]",
                                          "    # a\n    254.0,  # b\n    # c\n    256.0 # d\n    ]");
  EXPECT_EQ(lost_comments(as_model(bytes, "chain.yaml", sample_model("eucm"))),
            std::vector<std::string>{"comments # k1, # a, # b and 2 more"});
}

TEST(LostComments, ThoseInAnOpenCvMatrixAre) {
  std::string yaml = read_file(testdata_dir() / "opencv/good/calibration.yml");
  const std::size_t data = yaml.find("data: [", yaml.find("distortion_coefficients"));
  yaml.insert(yaml.find(',', data) + 1, " # k1\n");
  EXPECT_EQ(lost_comments(as_model(yaml, "x.yml", sample_model("kb4"))), std::vector<std::string>{"comment # k1"});
  EXPECT_TRUE(lost_comments(as_model(yaml, "x.yml", calibration_of(yaml, "x.yml").rig.cameras.front().model)).empty());
}

}  // namespace
}  // namespace fca::test
