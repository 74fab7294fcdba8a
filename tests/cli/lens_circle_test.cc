// SPDX-License-Identifier: BSD-3-Clause
// --lens-circle: images made here, of a known circle, as a user gives them.
#include "run_program.h"

#include <rapidjson/document.h>

#include <cmath>
#include <string>
#include <vector>

namespace fca::test {
namespace {

/// A wide lens whose axis hits the middle of its image, and a second camera beside it.
const std::string kLens = R"(  camera_model: pinhole
  intrinsics: [190.0, 190.0, 255.5, 255.5]
  distortion_model: equidistant
  distortion_coeffs: [0.003, 0.001, -0.002, 0.0002]
  resolution: [512, 512]
)";
const std::string kChain = "cam0:\n" + kLens;
const std::string kPair = kChain + R"(cam1:
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.1]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)" + kLens;

/// A grey image (PGM) whose light lies in a circle about the middle; of it only the sector up to `lit` [rad] is bright.
std::string image(int side, double radius, double lit = 7.0) {
  std::string bytes = "P5\n" + std::to_string(side) + " " + std::to_string(side) + "\n255\n";
  const double middle = (side - 1) / 2.0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) {
      const bool inside = std::hypot(u - middle, v - middle) <= radius;
      const bool bright = std::atan2(v - middle, u - middle) + 3.2 <= lit;
      bytes += static_cast<char>(inside ? (bright ? 120 + (u / 9 + v / 5) % 40 : 6) : 5 + (u * v) % 2);
    }
  }
  return bytes;
}

rapidjson::Document json_of(const std::vector<std::string>& words) {
  const RunResult run = run_program(words);
  rapidjson::Document json;
  json.Parse(run.out.c_str());
  EXPECT_FALSE(json.HasParseError()) << run.out << run.err;
  return json;
}

double share_beyond(int side, double radius) {
  const double middle = (side - 1) / 2.0;
  int beyond = 0;
  for (int v = 0; v < side; ++v) {
    for (int u = 0; u < side; ++u) beyond += std::hypot(u - middle, v - middle) > radius ? 1 : 0;
  }
  return static_cast<double>(beyond) / (side * side);
}

TEST(LensCircleOption, IsTheDomain) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  for (const double radius : {240.0, 290.0}) {
    SCOPED_TRACE(radius);
    const std::string seen = folder.write("seen.pgm", image(512, radius));
    const auto json =
        json_of({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", seen, "--every-pixel", "--json"});
    const auto& camera = json["cameras"][0];
    const auto& domain = camera["domain"];
    EXPECT_NEAR(domain["lens_circle"]["centre"][0].GetDouble(), 255.5, 0.5);
    EXPECT_NEAR(domain["lens_circle"]["centre"][1].GetDouble(), 255.5, 0.5);
    EXPECT_NEAR(domain["lens_circle"]["radius_px"].GetDouble(), radius, 1.0);
    // A pixel of radius is 2 pi r pixels of area.
    EXPECT_NEAR(domain["outside_lens_share"].GetDouble(), share_beyond(512, radius), 6.3 * radius / (512.0 * 512.0));
    EXPECT_NEAR(domain["scored_share"].GetDouble() + domain["outside_lens_share"].GetDouble() +
                    domain["unrepresentable_share"].GetDouble(),
                1.0, 1e-12);
    EXPECT_TRUE(contains(domain["why"].GetString(), "seen.pgm"));
    EXPECT_TRUE(camera["reach"].Empty()) << "the lens's angle is known";
    // The same angle by hand is the same conversion.
    const std::string angle = std::to_string(domain["max_angle_deg"].GetDouble());
    const auto by_hand = json_of({"convert", chain, "--to", "kalibr", "--model", "eucm", "--max-angle", angle, "--json"});
    EXPECT_NEAR(camera["error_px"]["rms"].GetDouble(), by_hand["cameras"][0]["error_px"]["rms"].GetDouble(),
                0.01 * camera["error_px"]["rms"].GetDouble());
  }
}

TEST(LensCircleOption, ImagesOfOneCameraAreTakenTogether) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string left = folder.write("left.pgm", image(512, 250.0, 2.0));
  const std::string all = folder.write("all.pgm", image(512, 250.0));
  const auto rim_of = [&](const std::vector<std::string>& images) {
    std::vector<std::string> words = {"convert", chain, "--to", "kalibr", "--model", "eucm", "--json"};
    for (const std::string& path : images) words.insert(words.end(), {"--lens-circle", path});
    return json_of(words)["cameras"][0]["domain"]["lens_circle"]["rim_share"].GetDouble();
  };
  EXPECT_LT(rim_of({left}), 0.6);
  EXPECT_GT(rim_of({left, all}), 0.9);
}

TEST(LensCircleOption, EachCameraOfARigHasItsOwn) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kPair);
  const std::string small = folder.write("small.pgm", image(512, 200.0));
  const auto json =
      json_of({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", "cam1=" + small, "--json"});
  EXPECT_FALSE(json["cameras"][0]["domain"].HasMember("lens_circle"));
  EXPECT_NEAR(json["cameras"][1]["domain"]["lens_circle"]["radius_px"].GetDouble(), 200.0, 1.0);

  const RunResult whose = run_program({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", small});
  EXPECT_EQ(whose.code, 2);
  EXPECT_TRUE(contains(whose.err, "cam0=IMAGE")) << whose.err;
  const RunResult nobody =
      run_program({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", "cam9=" + small});
  EXPECT_EQ(nobody.code, 2);
  EXPECT_TRUE(contains(nobody.err, "there is no camera 'cam9'")) << nobody.err;
}

TEST(LensCircleOption, IsSaidByCompareAndDrawnByReport) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string other = folder.write("other.yaml", with_replaced(kChain, "[0.003,", "[0.004,"));
  const std::string seen = folder.write("seen.pgm", image(512, 240.0));
  const RunResult compared = run_program({"compare", chain, other, "--lens-circle", seen});
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_TRUE(contains(compared.out, "the lit circle of seen.pgm: centre (255.5, 255.5)")) << compared.out;
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--to", "kalibr", "--model", "eucm"}}) {
    std::vector<std::string> words = {"report", chain, "--lens-circle", seen};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult page = run_program(words);
    EXPECT_EQ(page.code, 0) << page.err;
    EXPECT_TRUE(contains(page.out, "class=\"rim\"")) << page.err;
    EXPECT_TRUE(contains(page.out, "lit circle of the images"));
  }
}

// The images given may be those that were calibrated, or show what was done to them since.
TEST(LensCircleOption, IsOfTheImagesBeforeOrAfterTheirChange) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  for (const auto& [side, radius] : {std::pair{512, 240.0}, std::pair{256, 120.0}}) {
    const std::string seen = folder.write("seen.pgm", image(side, radius));
    const auto json = json_of(
        {"convert", chain, "--to", "kalibr", "--model", "eucm", "--resize", "256x256", "--lens-circle", seen, "--json"});
    const auto& circle = json["cameras"][0]["domain"]["lens_circle"];
    EXPECT_NEAR(circle["centre"][0].GetDouble(), 127.5, 0.5);
    EXPECT_NEAR(circle["radius_px"].GetDouble(), 120.0, 1.0);
  }
}

// A lamp in a dark room, the images of another camera.
TEST(LensCircleOption, SaysWhatSpeaksAgainstACircle) {
  const TemporaryFolder folder;
  const std::string seen = folder.write("seen.pgm", image(512, 200.0));
  const auto said = [&](const std::string& chain, const std::string& path) {
    return run_program({"convert", folder.write("chain.yaml", chain), "--to", "kalibr", "--model", "eucm", "--lens-circle",
                        path, "--dry-run"})
        .err;
  };
  EXPECT_FALSE(contains(said(kChain, seen), "lens-circle"));
  const std::string far = with_replaced(kChain, "255.5, 255.5", "425.5, 255.5");
  EXPECT_TRUE(contains(said(far, seen), "no-lens-circle")) << "the axis hits no lens there";
  const std::string moved = with_replaced(kChain, "255.5, 255.5", "285.5, 255.5");
  EXPECT_TRUE(contains(said(moved, seen), "30.0 px from the principal point")) << said(moved, seen);
  const std::string quarter = folder.write("quarter.pgm", image(512, 240.0, 1.6));
  EXPECT_TRUE(contains(said(kChain, quarter), "lens-circle-uncertain")) << said(kChain, quarter);
}

TEST(LensCircleOption, WithoutADarkBorderTheWholeImageIsLens) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string lit = folder.write("lit.pgm", image(512, 1000.0));
  const std::string dark = folder.write("dark.pgm", image(512, 0.0));
  for (const std::string& path : {lit, dark}) {
    const RunResult run =
        run_program({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", path, "--dry-run"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(contains(run.err, "no-lens-circle")) << run.err;
    EXPECT_TRUE(contains(run.out, "the whole image")) << run.out;
  }
}

TEST(LensCircleOption, RefusesWhatIsNoImageOfTheCamera) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const auto run_with = [&](const std::string& path, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", path};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  };
  const RunResult other_size = run_with(folder.write("other.pgm", image(500, 240.0)));
  EXPECT_EQ(other_size.code, 2);
  EXPECT_TRUE(contains(other_size.err, "500 x 500")) << other_size.err;
  EXPECT_TRUE(contains(other_size.err, "512 x 512")) << other_size.err;
  EXPECT_EQ(run_with(folder.write("empty.pgm", "")).code, 2);
  EXPECT_EQ(run_with(folder.write("text.pgm", "no image")).code, 2);
  EXPECT_EQ(run_with(folder.path().string()).code, 2);
  EXPECT_EQ(run_with(folder / "missing.pgm").code, 4);
  EXPECT_EQ(run_with(folder.write("good.pgm", image(512, 240.0)), {"--max-angle", "60"}).code, 3);
}

}  // namespace
}  // namespace fca::test
