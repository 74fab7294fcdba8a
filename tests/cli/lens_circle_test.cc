// SPDX-License-Identifier: BSD-3-Clause
// --lens-circle: images made here, of a known circle, as a user gives them.
#include "lit_image.h"
#include "run_program.h"
#include "shell/command_files.h"
#include "told.h"

#include <fca/code.h>
#include <fca/fca.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace fca::test {
namespace {

/// A second camera next to it.
const std::string kPair = kChain + R"(cam1:
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.1]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)" + kLens;

/// About the middle of a square.
std::string image(int side, double radius, double lit = 7.0) {
  return Lit{.width = side, .height = side, .u = (side - 1) / 2.0, .v = (side - 1) / 2.0, .radius = radius, .lit = lit}.file();
}

rapidjson::Document json_of(const std::vector<std::string>& words) {
  const RunResult run = run_program(words);
  rapidjson::Document json;
  json.Parse(run.out.c_str());
  EXPECT_FALSE(json.HasParseError()) << run.out << run.err;
  return json;
}

/// Why the field of view of the chain's only camera ends where it does.
Code why_of_field_of_view(const std::string& chain, const std::string& seen) {
  ConvertRequest request;
  request.inputs.files = {chain};
  request.inputs.lens_circles = {{"", seen}};
  request.to = find_format("kalibr");
  request.model = find_model("eucm");
  std::istringstream in;
  std::string printed;
  MemoryOutput out(printed);
  cli::Streams streams = {in, out, out};
  cli::CommandFiles files(streams);
  const ConvertResult result = convert(request, files);
  const bool fitted = result.cameras.size() == 1 && result.cameras.front().report;
  EXPECT_TRUE(fitted) << (result.diagnostics.entries().empty() ? std::string()
                                                               : message_of(result.diagnostics.entries().front()));
  return fitted ? result.cameras.front().report->statistics.coverage.why.code : Code::kNone;
}

/// The diagnostics of that file in a run with --json.
std::size_t diagnostics_of(const Told& run, const std::string& file) {
  return static_cast<std::size_t>(std::ranges::count_if(run.json()["diagnostics"].GetArray(), [&file](const auto& entry) {
    return entry.HasMember("file") && entry["file"] == file.c_str();
  }));
}

TEST(LensCircleOption, IsTheFieldOfView) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  for (const double radius : {240.0, 290.0}) {
    SCOPED_TRACE(radius);
    const std::string seen = folder.write("seen.pgm", image(512, radius));
    const auto json =
        json_of({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", seen, "--every-pixel", "--json"});
    const auto& camera = json["cameras"][0];
    const auto& field_of_view = camera["domain"];
    EXPECT_NEAR(field_of_view["lens_circle"]["centre"][0].GetDouble(), 255.5, 0.5);
    EXPECT_NEAR(field_of_view["lens_circle"]["centre"][1].GetDouble(), 255.5, 0.5);
    EXPECT_NEAR(field_of_view["lens_circle"]["radius_px"].GetDouble(), radius, 1.0);
    // A pixel of radius is 2 pi r pixels of area.
    EXPECT_NEAR(field_of_view["outside_lens_share"].GetDouble(), Lit{.radius = radius}.share_beyond(),
                6.3 * radius / (512.0 * 512.0));
    EXPECT_NEAR(field_of_view["scored_share"].GetDouble() + field_of_view["outside_lens_share"].GetDouble() +
                    field_of_view["unrepresentable_share"].GetDouble(),
                1.0, 1e-12);
    EXPECT_TRUE(contains(field_of_view["why"].GetString(), "seen.pgm"));
    EXPECT_TRUE(camera["reach"].Empty()) << "the lens's angle is known";
    // The same angle by hand is the same conversion.
    const std::string angle = std::to_string(field_of_view["max_angle_deg"].GetDouble());
    const auto by_hand = json_of({"convert", chain, "--to", "kalibr", "--model", "eucm", "--max-angle", angle, "--json"});
    EXPECT_NEAR(camera["error_px"]["rms"].GetDouble(), by_hand["cameras"][0]["error_px"]["rms"].GetDouble(),
                0.01 * camera["error_px"]["rms"].GetDouble());
  }
}

// A lens that is mounted askew: the circle is where it is, and not a cone about the axis.
TEST(LensCircleOption, MayLieBesideTheAxis) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  for (const Lit& lit : {Lit{.u = 291.0, .v = 233.0, .radius = 210.0}, Lit{.u = 228.0, .v = 270.5, .radius = 262.0}}) {
    SCOPED_TRACE(lit.radius);
    const std::string seen = folder.write("seen.pgm", lit.file());
    const std::vector<std::string> words = {"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", seen};
    std::vector<std::string> as_json = words;
    as_json.insert(as_json.end(), {"--every-pixel", "--json"});
    const auto json = json_of(as_json);
    const auto& field_of_view = json["cameras"][0]["domain"];
    EXPECT_NEAR(field_of_view["lens_circle"]["centre"][0].GetDouble(), lit.u, 0.5);
    EXPECT_NEAR(field_of_view["lens_circle"]["centre"][1].GetDouble(), lit.v, 0.5);
    EXPECT_NEAR(field_of_view["lens_circle"]["radius_px"].GetDouble(), lit.radius, 1.0);
    EXPECT_NEAR(field_of_view["outside_lens_share"].GetDouble(), lit.share_beyond(), 6.3 * lit.radius / (512.0 * 512.0));
    // Its rim is nearer to the axis on one side than on the other: twice the angle is nobody's.
    std::vector<std::string> dry = words;
    dry.insert(dry.end(), {"--every-pixel", "--dry-run"});
    const RunResult run = run_program(dry);
    const double angle = field_of_view["max_angle_deg"].GetDouble();
    EXPECT_TRUE(contains(run.out, text::format_short(angle, 4) + " deg")) << run.out;
    EXPECT_FALSE(contains(run.out, text::format_short(2.0 * angle, 4))) << run.out;
  }
}

TEST(LensCircleOption, IsFoundInImagesOf10And12Bits) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  for (const int grey : {4, 16, 257}) {
    SCOPED_TRACE(grey);
    const std::string seen = folder.write("seen.pgm", Lit{.grey = grey}.file());
    const auto json = json_of({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", seen, "--json"});
    EXPECT_NEAR(json["cameras"][0]["domain"]["lens_circle"]["radius_px"].GetDouble(), 240.0, 1.0);
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
  EXPECT_TRUE(says(whose.err, "lens-circle-of-none", "cam0=IMAGE")) << whose.err;
  const RunResult nobody =
      run_program({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", "cam9=" + small});
  EXPECT_EQ(nobody.code, 2);
  EXPECT_TRUE(says(nobody.err, "lens-circle-of-none", "cam9")) << nobody.err;
}

/// The file, the centre and the radius are said, as in the golden files' sentence.
void expect_said(const std::string& text, const char* radius) {
  for (const char* value : {"seen.pgm", "(255.5, 255.5)", radius}) EXPECT_TRUE(contains(text, value)) << value;
}

TEST(LensCircleOption, IsSaidByCompareAndByReport) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string other = folder.write("other.yaml", with_replaced(kChain, "[0.003,", "[0.004,"));
  const std::string seen = folder.write("seen.pgm", image(512, 240.0));
  const RunResult compared = run_program({"compare", chain, other, "--lens-circle", seen});
  EXPECT_EQ(compared.code, 0) << compared.err;
  expect_said(compared.out, "240.0 px");
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--to", "kalibr", "--model", "eucm"}, {"--to", "kalibr"}, {"--model", "all"}}) {
    std::vector<std::string> words = {"report", chain, "--lens-circle", seen};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult page = run_program(words);
    EXPECT_EQ(page.code, 0) << page.err;
    expect_said(page.out, "240.0 px");
    EXPECT_TRUE(contains(page.out, "class=\"patch rim\"")) << "in the legend";
  }
}

// What the page says of a comparison is what the command says: also what speaks against the circle.
TEST(LensCircleOption, IsDoubtedOnTheComparisonsPage) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string other = folder.write("other.yaml", with_replaced(kChain, "[0.003,", "[0.004,"));
  const std::string path = folder / "page.html";
  for (const auto& [seen, code] :
       {std::pair{Lit{.u = 291.0}, "lens-circle-off-centre"}, std::pair{Lit{.radius = 1000.0}, "no-lens-circle"}}) {
    const RunResult run = run_program(
        {"compare", chain, other, "--lens-circle", folder.write("seen.pgm", seen.file()), "--report", path, "--force"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(says(run.err, code)) << run.err;
    EXPECT_TRUE(contains(read_file(path), code));
  }
}

// --force is for the page of last time, not for what it is made of.
TEST(LensCircleOption, NoOutputReplacesAnInput) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string other = folder.write("other.yaml", with_replaced(kChain, "[0.003,", "[0.004,"));
  const std::string seen = folder.write("seen.pgm", image(512, 240.0));
  fs::create_symlink(seen, folder / "link.pgm");
  const std::vector<std::vector<std::string>> commands = {
      {"report", chain, "--lens-circle", seen, "-o", chain},
      {"report", chain, "--lens-circle", seen, "-o", seen},
      {"report", chain, "--lens-circle", "cam0=" + seen, "-o", folder / "link.pgm"},
      {"compare", chain, other, "--lens-circle", seen, "--report", chain},
      {"compare", chain, other, "--lens-circle", seen, "--report", other},
      {"compare", chain, other, "--lens-circle", seen, "--report", seen},
      {"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", seen, "-o", seen}};
  const std::vector<std::string> files = {chain, other, seen};
  std::vector<std::string> before;
  for (const std::string& file : files) before.push_back(read_file(file));
  for (const std::vector<std::string>& command : commands) {
    std::vector<std::string> words = command;
    words.emplace_back("--force");
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_TRUE(std::ranges::any_of(words, [&run](const std::string& word) { return contains(run.err, word + " "); }))
        << run.err;
  }
  for (std::size_t i = 0; i < files.size(); ++i) EXPECT_EQ(read_file(files[i]), before[i]) << files[i];
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
    const RunResult said = run_program(
        {"convert", chain, "--to", "kalibr", "--model", "eucm", "--resize", "256x256", "--lens-circle", seen, "--dry-run"});
    EXPECT_TRUE(contains(said.out, "(127.")) << "in the pixels of the images that are converted: " << said.out;
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
  EXPECT_TRUE(says(said(far, seen), "no-lens-circle")) << "the axis hits no lens there";
  const std::string moved = with_replaced(kChain, "255.5, 255.5", "285.5, 255.5");
  EXPECT_TRUE(says(said(moved, seen), "lens-circle-off-centre", "30.0 px")) << said(moved, seen);
  const std::string quarter = folder.write("quarter.pgm", image(512, 240.0, 1.6));
  EXPECT_TRUE(says(said(kChain, quarter), "lens-circle-uncertain")) << said(kChain, quarter);
  // Something bright and round in front of the lens.
  const std::string disc = folder.write("disc.pgm", Lit{.radius = 90.0}.file());
  EXPECT_TRUE(says(said(kChain, disc), "lens-circle-small")) << said(kChain, disc);
  for (const double flatness : {0.6, 0.75, 0.9}) {
    const std::string ellipse = folder.write("ellipse.pgm", Lit{.radius = 220.0, .flatness = flatness}.file());
    EXPECT_TRUE(contains(said(kChain, ellipse), "lens-circle-")) << flatness;
  }
}

TEST(LensCircleOption, LeavesOutAnImageOfAnotherCamera) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string half = folder.write("half.pgm", Lit{.lit = 3.0}.file());
  const std::string dim = folder.write("dim.pgm", Lit{.lit = 4.5}.file());
  const std::string other = folder.write("other.pgm", Lit{.u = 240.0, .radius = 215.0}.file());
  for (const std::vector<std::string>& images : {std::vector{half, dim, other}, {other, half, dim}}) {
    std::vector<std::string> words = {"convert", chain, "--to", "kalibr", "--model", "eucm"};
    for (const std::string& path : images) words.insert(words.end(), {"--lens-circle", path});
    const Told run(words);
    EXPECT_NEAR(run.json()["cameras"][0]["domain"]["lens_circle"]["radius_px"].GetDouble(), 240.0, 1.0) << run.text();
    EXPECT_TRUE(run.says("lens-circles-differ", "cam0")) << run.text();
    EXPECT_TRUE(run.says("lens-circles-differ", "(240.")) << run.text();
    EXPECT_EQ(diagnostics_of(run, other), 1U) << run.text();
    EXPECT_EQ(diagnostics_of(run, half), 0U) << run.text();
    EXPECT_EQ(diagnostics_of(run, dim), 0U) << run.text();
  }
}

// A model that folds before the lens ends: what was found is said all the same.
TEST(LensCircleOption, IsSaidWhereTheModelEndsBefore) {
  const TemporaryFolder folder;
  const std::string chain =
      folder.write("chain.yaml", with_replaced(kChain, "[0.003, 0.001, -0.002, 0.0002]", "[-0.15, -0.05, 0.0, 0.0]"));
  const std::string seen = folder.write("seen.pgm", image(512, 250.0));
  const RunResult run =
      run_program({"convert", chain, "--to", "kalibr", "--model", "eucm", "--lens-circle", seen, "--dry-run"});
  expect_said(run.out, "250.0 px");
  EXPECT_EQ(why_of_field_of_view(chain, seen), Code::kFieldOfViewAndInsideCircle);
}

// Of several images those are named that show it, and a doubt is told at one of them.
TEST(LensCircleOption, NamesTheImagesThatShowIt) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", kChain);
  const std::string black = folder.write("black.pgm", Lit{.radius = 0.0}.file());
  const std::string seen = folder.write("seen.pgm", Lit{.u = 291.0}.file());
  const std::vector<std::string> words = {"convert", chain,           "--to", "kalibr",        "--model",
                                          "eucm",    "--lens-circle", black,  "--lens-circle", seen};
  const Told run(words);
  const std::string why = run.json()["cameras"][0]["domain"]["why"].GetString();
  EXPECT_TRUE(contains(why, "seen.pgm") && !contains(why, "black.pgm")) << why;
  EXPECT_TRUE(contains(run_program(words).err, " seen.pgm:"));
  EXPECT_EQ(diagnostics_of(run, seen), 1U) << run.text();
  EXPECT_EQ(diagnostics_of(run, black), 0U) << run.text();
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
    EXPECT_TRUE(says(run.err, "no-lens-circle")) << run.err;
    EXPECT_EQ(why_of_field_of_view(chain, path), Code::kFieldOfViewWholeImage);
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
  EXPECT_TRUE(says(other_size.err, "image-size", "500 x 500")) << other_size.err;
  EXPECT_TRUE(says(other_size.err, "image-size", "512 x 512")) << other_size.err;
  EXPECT_EQ(run_with(folder.write("empty.pgm", "")).code, 2);
  EXPECT_EQ(run_with(folder.write("text.pgm", "no image")).code, 2);
  EXPECT_EQ(run_with(folder.path().string()).code, 2);
  EXPECT_EQ(run_with(folder / "missing.pgm").code, 4);
  const RunResult nothing = run_with("cam0=");
  EXPECT_EQ(nothing.code, 2);
  EXPECT_TRUE(says(nothing.err, "no-image", "cam0=")) << nothing.err;
  const std::string good = folder.write("good.pgm", image(512, 240.0));
  EXPECT_EQ(run_with(good, {"--max-angle", "60"}).code, 3);
  // What is advised is not what was done.
  const RunResult changed = run_with(folder.write("other.pgm", image(500, 240.0)), {"--resize", "256x256"});
  EXPECT_EQ(changed.code, 2);
  for (const char* option : {"--crop", "--binning", "--resize"})
    EXPECT_TRUE(says(changed.err, "image-size", option)) << changed.err;
  EXPECT_FALSE(contains(changed.err, "--resize 500x500")) << changed.err;
}

}  // namespace
}  // namespace fca::test
