// SPDX-License-Identifier: BSD-3-Clause
// What the proof tells of several cameras at once, besides that they agree.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

#include <cmath>

namespace fca::test {
namespace {

/// Two kb4 cameras of one image size; `focal_length` [px] is the second one's.
Rig pair_of(double focal_length) {
  Rig rig = sample_rig("kb4", {true, false});
  for (const ParameterId name : ParameterIds{"fx", "fy"}) EXPECT_TRUE(set_parameter(rig.cameras[1].model, name, focal_length));
  return rig;
}

std::string bytes_for(const char* format, const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written = find_format(format)->write(nullptr, rig, {}, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? written->files.front().document.bytes() : "";
}

// Kalibr projects nothing from behind: it misses the corners of the first camera's image, and nothing of the second one's.
TEST(Proof, SharesCountEveryCameraAsOneImage) {
  const Rig rig = pair_of(400.0);
  const ProofResult proof = prove(*consumers::find_consumer("kalibr"), bytes_for("kalibr", rig), {}, rig);
  ASSERT_EQ(proof.cameras.size(), 2U);
  EXPECT_LT(proof.cameras[0].compared_share, 0.95);
  EXPECT_EQ(proof.cameras[1].compared_share, 1.0);
  EXPECT_NEAR(proof.compared_share, 0.5 * (proof.cameras[0].compared_share + 1.0), 1e-12);
}

// V1.0 reads the second camera's coefficients from the first.
TEST(Proof, WhatIsMisreadIsToldByItsWorstPixel) {
  const consumers::Consumer& orbslam3 = *consumers::find_consumer("orbslam3");
  for (const double focal_length : {250.0, 320.0, 700.0}) {
    SCOPED_TRACE(focal_length);
    Rig rig = pair_of(focal_length);
    ASSERT_TRUE(set_parameter(rig.cameras[1].model, "k1", 0.02));
    const std::string bytes = bytes_for("orbslam3", rig);
    const ProofResult proof = prove(orbslam3, bytes, {"stereo"}, rig);
    const consumers::ConsumerView view = orbslam3.load(bytes, {"stereo"});
    ASSERT_EQ(view.cameras.size(), 2U);
    ASSERT_TRUE(view.cameras[1].misread);
    double worst = 0.0;
    for (double u = 0.0; u < rig.cameras[1].image_size->width; u += 1.0) {
      for (double v = 0.0; v < rig.cameras[1].image_size->height; v += 1.0) {
        const std::optional<Ray> ray = unproject(rig.cameras[1].model, {u, v});
        ASSERT_TRUE(ray);
        const std::optional<Pixel> pixel = view.cameras[1].project(*ray);
        ASSERT_TRUE(pixel);
        worst = std::max(worst, std::hypot((*pixel)[0] - u, (*pixel)[1] - v));
      }
    }
    EXPECT_NEAR(proof.misread_px, worst, 0.001 * worst);
  }
}

}  // namespace
}  // namespace fca::test
