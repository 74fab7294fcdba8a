// SPDX-License-Identifier: BSD-3-Clause
// camodocal's camera files: what their numbers mean, what is written comes back, and what the program itself computed.
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/formats/proof.h>

namespace fca::test {
namespace {

const Format& vins() { return *find_format("vins"); }
const consumers::Consumer& program() { return *consumers::find_consumer("vins"); }
std::string good(const std::string& format, const std::string& name) {
  return read_file(testdata_dir() / format / "good" / name);
}
Camera camera_in(const std::string& bytes) { return calibration_of(bytes, "camera.yaml").rig.cameras.at(0); }
const std::string& bytes_of(const Written& written, std::string& bytes) {
  return bytes = written.files.front().document.bytes();
}

/// A rig of that model, as OCamCalib's and the rational one, too, have.
Rig rig_of(std::string_view model, bool two) {
  if (model == "ocamcalib") return calibration_of(good("ocamcalib", "toolbox.txt"), "a.txt").rig;
  Rig rig = sample_rig(model == "rational" ? "radtan" : std::string(model), {.two = two});
  if (model != "rational") return rig;
  for (Camera& camera : rig.cameras)
    camera.model = model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
  return rig;
}

// EquidistantCamera.h: "k1 = 1" is the first of its polynomial's coefficients.
TEST(Vins, KannalaBrandtsK2IsOurK1) {
  const Camera camera = camera_in(good("vins", "kannala-brandt.yaml"));
  EXPECT_EQ(camera.model, sample_model("kb4"));
  EXPECT_EQ(camera.image_size, (ImageSize{512, 512}));
}

// KITTI-360 names its cameras; camodocal calls every one "camera".
TEST(Vins, NamesAreTakenWhereTheyNameSomething) {
  EXPECT_EQ(camera_in(good("vins", "mei-crlf.yaml")).name, "image_02");
  EXPECT_EQ(camera_in(good("vins", "pinhole.yaml")).name, "cam0");
}

TEST(Vins, EveryModelComesBackAndTheProgramComputesTheSame) {
  for (const StoredModel& stored : vins().models) {
    SCOPED_TRACE(stored.model);
    const Rig rig = rig_of(stored.model, true);
    const Written written = written_by(vins(), nullptr, rig);
    ASSERT_EQ(written.files.size(), rig.cameras.size());
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      const std::string bytes = written.files[i].document.bytes();
      const Camera back = camera_in(bytes);
      EXPECT_EQ(back.name, rig.cameras[i].name);
      EXPECT_EQ(back.image_size, rig.cameras[i].image_size);
      const std::span<const double> ours = parameter_values(rig.cameras[i].model);
      const std::span<const double> theirs = parameter_values(back.model);
      ASSERT_EQ(model_info(back.model).id, stored.model);
      // scaramuzza's numbers are computed.
      const double rounding = stored.model == "ocamcalib" ? 1e-14 : 0.0;
      for (std::size_t k = 0; k < ours.size(); ++k) EXPECT_NEAR(theirs[k], ours[k], rounding * std::abs(ours[k])) << k;
      Rig one = rig;
      one.cameras = {rig.cameras[i]};
      const ProofResult proof = prove(program(), bytes, {}, one);
      EXPECT_TRUE(proof.agrees()) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
      EXPECT_LE(proof.max_diff_px, stored.model == "ocamcalib" ? 1e-5 : 1e-9);
      EXPECT_GT(proof.compared_share, 0.9);
    }
  }
}

// Measured in MORE-FORMATS.md: the conversion is exact, and copying c d e is off by pixels.
TEST(Vins, ScaramuzzasAffinePartIsTheOtherWayRound) {
  const Rig rig = rig_of("ocamcalib", false);
  const Written written = written_by(vins(), nullptr, rig);
  std::string bytes;
  bytes_of(written, bytes);
  const Camera back = camera_in(bytes);
  for (const Pixel& pixel : {Pixel{10.0, 20.0}, Pixel{300.0, 400.0}, Pixel{600.0, 100.0}}) {
    const std::optional<Ray> ray = unproject(rig.cameras[0].model, pixel);
    if (!ray) continue;
    const std::optional<Pixel> there = project(back.model, *ray);
    ASSERT_TRUE(there);
    EXPECT_LE(distance(*there, pixel), 1e-10);
  }
}

// What camodocal loads as zeros without a word, its consumer refuses.
TEST(Vins, TheProgramsSilenceIsARefusal) {
  const std::string bytes = good("vins", "mei-crlf.yaml");
  EXPECT_TRUE(program().load(bytes, {}).loads());
  for (const auto& [from, to] : {std::pair("MEI", "Mei"), std::pair("gamma1", "fx"), std::pair("mirror_parameters", "mirror"),
                                 std::pair("model_type", "model")})
    EXPECT_FALSE(program().load(with_replaced(bytes, from, to), {}).loads()) << to;
  // scaramuzza is compared in any case.
  std::string ocam;
  bytes_of(written_by(vins(), nullptr, rig_of("ocamcalib", false)), ocam);
  EXPECT_TRUE(program().load(with_replaced(ocam, "scaramuzza", "SCARAMUZZA"), {}).loads());
}

// camodocal's liftProjective gives the pixel instead of the straightened point, and nothing on the axis.
TEST(Vins, ScaramuzzasOwnInverseIsReproduced) {
  std::string bytes;
  bytes_of(written_by(vins(), nullptr, rig_of("ocamcalib", false)), bytes);
  const consumers::ConsumerView view = program().load(bytes, {});
  ASSERT_EQ(view.cameras.size(), 1U);
  EXPECT_FALSE(view.cameras[0].project({0.0, 0.0, 1.0}));
  ASSERT_TRUE(view.cameras[0].unproject);
  EXPECT_FALSE(view.warnings.empty());
  const Pixel pixel = {120.0, 90.0};
  const std::optional<Ray> exact = unproject(camera_in(bytes).model, pixel);
  const std::optional<Ray> theirs = view.cameras[0].unproject(pixel);
  ASSERT_TRUE(exact && theirs);
  const double length = std::hypot((*theirs)[0], (*theirs)[1], (*theirs)[2]);
  const double cosine = ((*exact)[0] * (*theirs)[0] + (*exact)[1] * (*theirs)[1] + (*exact)[2] * (*theirs)[2]) / length;
  const double angle = std::acos(std::min(1.0, cosine));
  EXPECT_GT(angle, 1e-6);
  EXPECT_LT(angle, 1e-2);
}

// Edits touch their own numbers; name and spelling of the others stay.
TEST(Vins, AnEditChangesItsOwnNumbers) {
  const std::string bytes = good("vins", "mei-crlf.yaml");
  const Calibration calibration = calibration_of(bytes, "image_02.yaml");
  Rig rig = calibration.rig;
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "cx", 700.5));
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "xi", 2.5));
  rig.cameras[0].image_size = ImageSize{1400, 1408};
  std::string expected = with_replaced(with_replaced(bytes, "7.1694e+02", "700.5"), "2.2137", "2.5");
  expected = with_replaced(expected, "image_height: 1400", "image_height: 1408");
  std::string edited;
  EXPECT_EQ(bytes_of(written_by(vins(), &calibration.documents.front(), rig), edited), expected);
}

// Another model's sections take the old ones' place, from every model to every other.
TEST(Vins, AnotherModelTakesTheOldOnesPlace) {
  for (const StoredModel& from : vins().models) {
    for (const StoredModel& to : vins().models) {
      SCOPED_TRACE(std::string(from.model) + " -> " + std::string(to.model));
      Rig old = rig_of(from.model, false);
      std::string base;
      bytes_of(written_by(vins(), nullptr, old), base);
      base = with_replaced(base, "---\n", "---\n# kept\n") + "mask: none\n";
      const Calibration calibration = calibration_of(base, "camera.yaml");
      Rig rig = calibration.rig;
      rig.cameras[0].model = rig_of(to.model, false).cameras[0].model;
      std::string bytes;
      bytes_of(written_by(vins(), &calibration.documents.front(), rig), bytes);
      EXPECT_NE(bytes.find("# kept"), std::string::npos);
      EXPECT_NE(bytes.find("mask: none"), std::string::npos);
      EXPECT_TRUE(program().load(bytes, {}).loads()) << bytes;
      Rig fresh = rig;
      std::string rewritten;
      bytes_of(written_by(vins(), nullptr, fresh), rewritten);
      EXPECT_EQ(with_replaced(with_replaced(bytes, "# kept\n", ""), "mask: none\n", ""), rewritten);
    }
  }
}

// k3 has no place in PINHOLE, nor a fifth power in scaramuzza.
TEST(Vins, WhatHasNoPlaceIsRefused) {
  Rig rig = rig_of("radtan", false);
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "k3", 0.01));
  Diagnostics diagnostics;
  EXPECT_FALSE(vins().write(nullptr, rig, {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

// What camodocal printed of real files, against the model that our reader gives.
TEST(Vins, OurModelIsThePrograms) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int compared = 0;
  for (const OracleTable& table : oracle_tables("camodocal", "camodocal")) {
    const ReadCorpusFile file = read_corpus_file(table.file);
    ASSERT_TRUE(file.calibration) << table.file;
    EXPECT_EQ(file.calibration->format, &vins());
    for (const OracleRow& row : table.rows) {
      const std::optional<Pixel> ours = project(file.calibration->rig.cameras.at(0).model, row.ray);
      if (!ours) continue;  // the program knows no end of a lens
      EXPECT_LE(distance(*ours, row.pixel), 1e-9 * std::max(1.0, std::abs(row.pixel[0]) / 1000.0)) << table.file;
      ++compared;
    }
  }
  EXPECT_GE(compared, 500);
}

}  // namespace
}  // namespace fca::test
