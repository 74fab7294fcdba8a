// SPDX-License-Identifier: BSD-3-Clause
// The pixels of fisheye624 by Project Aria's own code (projectaria_tools@90f70ff, FisheyeRadTanThinPrism.h, compiled), and
// those of thin-prism-fisheye by the formula in colmap@5d968cf, sensor/models.h, computed by another program.
#include "model_test_support.h"

#include <string_view>

namespace fca::test {
namespace {

struct KnownPixel {
  std::string_view camera;  ///< Of testdata/models.
  Ray ray;
  Pixel pixel;
};

template <CameraModelType M, std::size_t N>
void expect_pixels(const std::array<KnownPixel, N>& known) {
  for (const KnownPixel& each : known) {
    bool found = false;
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      if (camera.name != each.camera) continue;
      found = true;
      Pixel pixel{};
      EXPECT_TRUE(M::project(camera.p(), each.ray.data(), pixel.data()));
      EXPECT_NEAR(pixel[0], each.pixel[0], 1e-9) << each.camera;
      EXPECT_NEAR(pixel[1], each.pixel[1], 1e-9) << each.camera;
    }
    EXPECT_TRUE(found) << each.camera;
  }
}

TEST(AriaAgreement, Fisheye624) {
  expect_pixels<Fisheye624>(std::array<KnownPixel, 18>{{
      {"rgb", {0.1, -0.05, 1}, {777.334799962457, 676.201510914320}},
      {"rgb", {-0.4, 0.3, 1}, {474.165854631745, 888.182573458165}},
      {"rgb", {0.7, 0.2, 0.9}, {1166.096703864624, 835.162779787300}},
      {"rgb", {-0.5, -0.8, 1}, {434.417242227103, 255.897177861223}},
      {"rgb", {0.02, 1.1, 1.2}, {725.514669739714, 1225.419684384058}},
      {"rgb", {1.2, -0.3, 1}, {1347.221512255130, 548.694456942339}},
      {"slam", {0.1, -0.05, 1}, {342.291011378810, 229.482180081858}},
      {"slam", {-0.4, 0.3, 1}, {228.680659616653, 308.723472123650}},
      {"slam", {0.7, 0.2, 0.9}, {476.825452368969, 286.888768513541}},
      {"slam", {-0.5, -0.8, 1}, {220.702868062842, 85.509900058067}},
      {"slam", {0.02, 1.1, 1.2}, {321.545754108802, 422.211898784969}},
      {"slam", {1.2, -0.3, 1}, {529.964348495812, 188.715176479412}},
      {"prism_strong", {0.1, -0.05, 1}, {344.992751930503, 227.269498549054}},
      {"prism_strong", {-0.4, 0.3, 1}, {228.986904725207, 310.176727970875}},
      {"prism_strong", {0.7, 0.2, 0.9}, {487.592712265993, 287.504303181757}},
      {"prism_strong", {-0.5, -0.8, 1}, {224.752841071480, 78.875355927328}},
      {"prism_strong", {0.02, 1.1, 1.2}, {326.253339434876, 428.871035640647}},
      {"prism_strong", {1.2, -0.3, 1}, {541.939148416095, 183.327510838853}},
  }});
}

TEST(ColmapAgreement, ThinPrismFisheye) {
  expect_pixels<ThinPrismFisheye>(std::array<KnownPixel, 18>{{
      {"prism", {0.1, -0.05, 1}, {337.768510573132, 232.991832244966}},
      {"prism", {-0.4, 0.3, 1}, {247.839194812738, 295.699103488241}},
      {"prism", {0.7, 0.2, 0.9}, {443.838793316440, 278.248778529597}},
      {"prism", {-0.5, -0.8, 1}, {242.110297892165, 119.849231234522}},
      {"prism", {0.02, 1.1, 1.2}, {321.363903561836, 384.546813474333}},
      {"prism", {1.2, -0.3, 1}, {484.127668797658, 201.198394087997}},
      {"wide", {0.1, -0.05, 1}, {541.377540279820, 494.210327715127}},
      {"wide", {-0.4, 0.3, 1}, {400.825123805988, 592.781940241810}},
      {"wide", {0.7, 0.2, 0.9}, {706.219922380676, 565.239192418469}},
      {"wide", {-0.5, -0.8, 1}, {392.400907129104, 317.469426123670}},
      {"wide", {0.02, 1.1, 1.2}, {515.451042411088, 730.716470653917}},
      {"wide", {1.2, -0.3, 1}, {767.792924058538, 444.683693707544}},
      {"prism_strong", {0.1, -0.05, 1}, {344.971005247366, 227.288496244913}},
      {"prism_strong", {-0.4, 0.3, 1}, {228.637114456942, 310.646342866010}},
      {"prism_strong", {0.7, 0.2, 0.9}, {487.343996798341, 287.336422989532}},
      {"prism_strong", {-0.5, -0.8, 1}, {225.595029771104, 79.367833546613}},
      {"prism_strong", {0.02, 1.1, 1.2}, {326.846551658593, 430.332624835116}},
      {"prism_strong", {1.2, -0.3, 1}, {540.396262870904, 184.051958734319}},
  }});
}

}  // namespace
}  // namespace fca::test
