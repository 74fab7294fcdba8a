// SPDX-License-Identifier: BSD-3-Clause
// --weight: what a fit makes small is told next to the error of all pixels, and images that are none are refused.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <string>
#include <vector>

namespace fca::test {
namespace {

/// A grey image: a byte for each pixel, rows from the top.
template <class Grey>
std::string pgm(int width, int height, const Grey& grey) {
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) bytes += static_cast<char>(grey(u, v));
  }
  return bytes;
}

std::string of_one_grey(int width, int height, int grey) {
  return pgm(width, height, [grey](int, int) { return grey; });
}

/// TUM VI's first camera as eucm.
std::vector<std::string> conversion(const std::vector<std::string>& more) {
  std::vector<std::string> words = {"convert", kTumvi, "--camera",    "0",    "--to",           "kalibr",
                                    "--model", "eucm", "--max-angle", "97.5", "--no-provenance"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(WeightOption, IsToldBesideTheErrorOfAllPixels) {
  const Told plain(conversion({}));
  const Told pixel(conversion({"--weight", "pixel"}));
  const Told angle(conversion({"--weight", "angle"}));
  const auto camera = [](const Told& told) -> const rapidjson::Value& { return told.json()["cameras"][0]; };
  for (const Told* told : {&plain, &pixel, &angle}) ASSERT_EQ(told->code(), 0) << told->text();
  EXPECT_FALSE(camera(plain).HasMember("weighted"));
  EXPECT_FALSE(camera(pixel).HasMember("weighted"));
  EXPECT_STREQ(pixel.json()["outputs"][0]["text"].GetString(), plain.json()["outputs"][0]["text"].GetString());
  EXPECT_STRNE(angle.json()["outputs"][0]["text"].GetString(), plain.json()["outputs"][0]["text"].GetString());
  EXPECT_STREQ(camera(angle)["weighted"]["weight"].GetString(), "angle");
  EXPECT_GT(camera(angle)["weighted"]["rms_px"].GetDouble(), 0.0);
  // The error of all pixels is the least where they count alike.
  EXPECT_GT(camera(angle)["error_px"]["rms"].GetDouble(), camera(plain)["error_px"]["rms"].GetDouble());
}

TEST(WeightOption, AnImageOfOneGreyChangesNothing) {
  const TemporaryFolder folder;
  const std::string grey = folder.write("grey.pgm", of_one_grey(512, 512, 100));
  const RunResult plain = run_program(conversion({}));
  const RunResult weighted = run_program(conversion({"--weight", grey}));
  ASSERT_EQ(weighted.code, 0) << weighted.err;
  EXPECT_EQ(weighted.out, plain.out);
}

TEST(WeightOption, WhatIsWhiteGetsBetter) {
  const TemporaryFolder folder;
  const std::string white = folder.write("white.pgm", pgm(512, 512, [](int u, int v) {
                                           return (u - 255) * (u - 255) + (v - 257) * (v - 257) < 120 * 120 ? 255 : 0;
                                         }));
  const Told plain(conversion({}));
  const Told weighted(conversion({"--weight", white}));
  ASSERT_EQ(weighted.code(), 0) << weighted.text();
  const auto first_band = [](const Told& told) { return told.json()["cameras"][0]["bands"][0]["rms_px"].GetDouble(); };
  EXPECT_LT(first_band(weighted), 0.5 * first_band(plain));
  EXPECT_STREQ(weighted.json()["cameras"][0]["weighted"]["weight"].GetString(), "image");
}

TEST(WeightOption, WhatIsNoWeightIsRefused) {
  const TemporaryFolder folder;
  const auto code = [&](const std::string& image) { return Told(conversion({"--weight", image})); };
  const Told black = code(folder.write("black.pgm", of_one_grey(512, 512, 0)));
  EXPECT_EQ(black.code(), 2);
  EXPECT_TRUE(black.says("weights-black")) << black.text();
  // White only in a corner that is no lens.
  const Told corner = code(folder.write("corner.pgm", pgm(512, 512, [](int u, int v) { return u + v < 20 ? 255 : 0; })));
  EXPECT_EQ(corner.code(), 2);
  EXPECT_TRUE(corner.says("weights-black")) << corner.text();
  const Told small = code(folder.write("small.pgm", of_one_grey(256, 256, 9)));
  EXPECT_EQ(small.code(), 2);
  EXPECT_TRUE(small.says("image-size")) << small.text();
  EXPECT_EQ(code(folder.write("text.pgm", "no image")).code(), 2);
  EXPECT_NE(code(folder / "missing.pgm").code(), 0);
  EXPECT_EQ(run_program(conversion({"--weight", "angle", "--objective", "max"})).code, 3);
  EXPECT_EQ(run_program(conversion({"--weight", ""})).code, 3);
}

TEST(WeightOption, TheImageIsNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string grey = folder.write("grey.yaml", of_one_grey(512, 512, 100));
  EXPECT_EQ(run_program(conversion({"--weight", grey, "-o", grey, "--force"})).code, 3);
  EXPECT_EQ(read_file(grey), of_one_grey(512, 512, 100));
}

}  // namespace
}  // namespace fca::test
