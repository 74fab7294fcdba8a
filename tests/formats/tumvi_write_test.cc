// SPDX-License-Identifier: BSD-3-Clause
// TUM-VI: chains as Kalibr reads them, with the dataset's habits; and DSO's camera.txt, edited in place.
#include "formats/lost_facts.h"
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

const Format& tumvi_format() { return *find_format("tumvi"); }
std::string bytes_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

double random_in(double low, double high) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  return low + (high - low) * (static_cast<double>(bits >> 11U) * 0x1p-53);
}

std::vector<std::string> codes_of(const Written& written) {
  std::vector<std::string> codes;
  for (const Loss& loss : written.losses) codes.push_back(id_of(loss));
  return codes;
}

/// A chain read as TUM-VI's: --from tumvi.
Rig read_as_tumvi(const std::string& bytes) {
  Diagnostics diagnostics;
  const text::Document document = document_of(bytes);
  const std::optional<Rig> rig = tumvi_format().read(std::span(&document, 1), {}, diagnostics);
  EXPECT_TRUE(rig) << bytes;
  return rig.value_or(Rig());
}

TEST(TumViChain, AChainIsDetectedAsKalibrs) {
  const text::Document chain = document_of(read_file(testdata_dir() / "kalibr/good/tumvi.yaml"));
  EXPECT_EQ(tumvi_format().probe(chain).score, 0);
  Diagnostics diagnostics;
  EXPECT_EQ(detect_format(chain, diagnostics)->format->id, "kalibr");
}

TEST(TumViChain, ReadByNameAndWrittenBackByteForByte) {
  for (const char* file : {"tumvi.yaml", "crlf.yaml", "omni.yaml", "ds.yaml"}) {
    const std::string bytes = read_file(testdata_dir() / "kalibr/good" / file);
    const text::Document document = document_of(bytes);
    EXPECT_EQ(bytes_of(written_by(tumvi_format(), &document, read_as_tumvi(bytes))), bytes) << file;
  }
}

TEST(TumViChain, ReadsBackBitEqualAndKalibrAgrees) {
  for (const StoredModel& row : tumvi_format().models) {
    SCOPED_TRACE(row.model);
    const Rig rig = sample_rig(std::string(row.model), {true, true});
    const Written written = written_by(tumvi_format(), nullptr, rig);
    EXPECT_EQ(bytes_of(written).find("timeshift_cam_imu"), std::string::npos);
    const Rig back = read_as_tumvi(bytes_of(written));
    if (row.model != "pinhole" && row.model != "ucm") {  // Kalibr has them as radtan with zeros and as eucm with beta = 1
      EXPECT_TRUE(back.cameras == rig.cameras);
    }
    EXPECT_EQ(back.resolve("cam1", "cam0"), rig.resolve("cam1", "cam0"));
    EXPECT_EQ(back.resolve("cam0", "imu0"), rig.resolve("cam0", "imu0"));
    ASSERT_NE(back.stated("cam1", "imu0"), nullptr) << "of both cameras";
    EXPECT_LE(element_difference(*back.stated("cam1", "imu0"), T_cam1_cam0() * T_cam0_imu()), 1e-15);
    const ProofResult proof = prove(*consumers::find_consumer("kalibr"), bytes_of(written), {}, rig);
    EXPECT_TRUE(proof.agrees()) << proof.max_diff_px;
    ASSERT_EQ(written.files.size(), 2U);
    EXPECT_TRUE(consumers::find_consumer("kalibr-imu")->load(written.files[1].document.bytes(), {}).loads());
  }
}

// FORMATS.md 7: as Kalibr. Where either would do, the dataset's own come first.
TEST(TumViChain, HoldsWhatKalibrHolds) {
  for (const StoredModel& stored : find_format("kalibr")->models) {
    const StoredModel* here = find_stored_model(tumvi_format(), stored.model, true);
    ASSERT_NE(here, nullptr) << stored.model;
    EXPECT_EQ(here->file_name, stored.file_name);
  }
  EXPECT_EQ(tumvi_format().models[0].model, "kb4");
  EXPECT_EQ(tumvi_format().models[1].model, "mei");
}

TEST(TumViChain, ATimeOffsetIsDroppedAndSaid) {
  Rig rig = sample_rig("kb4", {true, true});
  rig.cameras[0].time_offset_s = -0.0021;
  rig.cameras[1].time_offset_s = 0.0;
  const Written written = written_by(tumvi_format(), nullptr, rig);
  EXPECT_EQ(codes_of(written), std::vector<std::string>{"time-offset-dropped"});
  EXPECT_TRUE(loses(written, Code::kTimeOffsetDropped, {"cam0", -0.0021}));
  EXPECT_EQ(bytes_of(written).find("timeshift_cam_imu"), std::string::npos);
}

TEST(TumViChain, ContradictingPosesAreMadeOne) {
  Rig rig = sample_rig("kb4", {true, true});
  Transform off = T_cam1_cam0() * T_cam0_imu();
  off(0, 3) += 0.01;
  rig.poses.push_back({"cam1", "imu0", off});
  const Written written = written_by(tumvi_format(), nullptr, rig);
  EXPECT_EQ(codes_of(written), std::vector<std::string>{"pose-recomputed"});
  const Rig back = read_as_tumvi(bytes_of(written));
  EXPECT_LE(element_difference(*back.stated("cam1", "imu0"), *back.stated("cam1", "cam0") * *back.stated("cam0", "imu0")),
            1e-15);
}

// Half the size: the pixel-centre rule is lib's affair; the format keeps what it is told.
TEST(TumViChain, BothSizesOfTheDataset) {
  for (const int side : {512, 1024}) {
    Rig rig = sample_rig("kb4", {true, false});
    for (Camera& camera : rig.cameras) camera.image_size = ImageSize{side, side};
    EXPECT_EQ(read_as_tumvi(bytes_of(written_by(tumvi_format(), nullptr, rig))).cameras[1].image_size, (ImageSize{side, side}));
  }
}

struct Meaning {
  const char* file;
  const char* model;
  std::vector<double> parameters;
  ImageSize size;
};

TEST(CameraTxt, WhatTheFilesMean) {
  const std::vector<Meaning> meanings = {
      {"equidistant.txt",
       "kb4",
       {190.75, 190.625, 254.875, 256.9375, 0.0034375, 0.00071875, -0.002046875, 0.000203125},
       {512, 512}},
      {"radtan-bare.txt",
       "radtan",
       {458.75, 457.25, 367.125, 248.375, -0.2834375, 0.07390625, 0.00019375, 1.75e-05, 0.0},
       {752, 480}},
      {"fov-bare.txt", "fov", {445.5, 558.75, 631.0, 511.0, 0.9375}, {1280, 1024}},
      {"fov-relative.txt",
       "fov",
       {0.349153 * 1280, 0.436593 * 1024, 0.49314 * 1280 - 0.5, 0.499021 * 1024 - 0.5, 0.933271},
       {1280, 1024}},
      {"pinhole.txt", "pinhole", {501.5, 501.5, 421.75, 167.625}, {800, 304}},
      {"pinhole-relative.txt", "pinhole", {500.0, 500.0, 421.5, 167.5}, {800, 400}},
  };
  for (const Meaning& meaning : meanings) {
    SCOPED_TRACE(meaning.file);
    const std::string bytes = read_file(testdata_dir() / "dso/good" / meaning.file);
    const Calibration calibration = calibration_of(bytes, meaning.file);
    const Camera& camera = calibration.rig.cameras.at(0);
    EXPECT_EQ(model_info(camera.model).id, meaning.model);
    const std::span<const double> values = parameter_values(camera.model);
    EXPECT_EQ(std::vector<double>(values.begin(), values.end()), meaning.parameters);
    EXPECT_EQ(camera.image_size, meaning.size);
    const ProofResult proof = prove(*consumers::find_consumer("dso"), bytes, {}, calibration.rig);
    EXPECT_TRUE(proof.agrees()) << proof.max_diff_px;
    ASSERT_EQ(calibration.rig.extra_fields.size(), 1U) << "what DSO makes of the images is no part of the camera";
  }
}

// Every number, one at a time; in the relative form a centre and a focal length are written as shares.
TEST(CameraTxt, OneNumberChangesItsOwnBytesOnly) {
  for (const fs::path& path : files_in(testdata_dir() / "dso/good", ".txt")) {
    const std::string bytes = read_file(path);
    const Calibration calibration = calibration_of(bytes, path.filename().string());
    const auto& parameters = model_info(calibration.rig.cameras[0].model).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name == "k3" && parameters.size() == 9) continue;  // radtan's, of which DSO has none
      SCOPED_TRACE(path.filename().string() + " " + std::string(parameters[i].name));
      Rig rig = calibration.rig;
      parameter_values(rig.cameras[0].model)[i] += 0.0009765625;
      const Written written = written_by(tumvi_format(), &calibration.documents.front(), rig);
      EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"dso"});
      const std::string edited = bytes_of(written);
      EXPECT_TRUE(calibration_of(edited, "camera.txt").rig.cameras == rig.cameras) << edited;
      std::vector<std::string> before = split(bytes, '\n');
      std::vector<std::string> after = split(edited, '\n');
      ASSERT_EQ(before.size(), after.size());
      EXPECT_TRUE(std::equal(before.begin() + 1, before.end(), after.begin() + 1)) << "only line 1";
      const text::Document old_words = document_of(before[0] + "\n1 1\n", "camera.txt");
      const text::Document new_words = document_of(after[0] + "\n1 1\n", "camera.txt");
      int different = 0;
      for (std::size_t k = 0; k < old_words.root().items[0].items.size(); ++k)
        different += old_words.root().items[0].items[k].value != new_words.root().items[0].items.at(k).value ? 1 : 0;
      EXPECT_EQ(different, 1) << after[0];
    }
  }
}

RC_GTEST_PROP(CameraTxt, AnyOtherCameraOfTheModelReadsBack, ()) {
  const std::string file = *rc::gen::element<std::string>("equidistant.txt", "radtan-bare.txt", "fov-bare.txt", "pinhole.txt");
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "dso/good" / file), file);
  Rig rig = calibration.rig;
  Camera& camera = rig.cameras.front();
  camera.image_size = ImageSize{*rc::gen::inRange(64, 3000), *rc::gen::inRange(64, 3000)};
  const double focal = random_in(100.0, 900.0);
  for (const ParameterId name : ParameterIds{"fx", "fy"}) set_parameter(camera.model, name, focal * random_in(0.98, 1.02));
  set_parameter(camera.model, "cx", random_in(0.4, 0.6) * camera.image_size->width);
  set_parameter(camera.model, "cy", random_in(0.4, 0.6) * camera.image_size->height);
  for (const ParameterId name : ParameterIds{"k1", "k2", "p1", "p2"}) set_parameter(camera.model, name, random_in(-0.01, 0.01));
  const std::string edited = bytes_of(written_by(tumvi_format(), &calibration.documents.front(), rig));
  RC_ASSERT(calibration_of(edited, file).rig.cameras == rig.cameras);
  RC_ASSERT(consumers::find_consumer("dso")->load(edited, {}).cameras.size() == 1U);
}

// Shares cannot say every double of a pixel: the nearest is written, and less than a billionth of a pixel lost.
RC_GTEST_PROP(CameraTxt, RelativeNumbersReadBackToRounding, ()) {
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "dso/good/fov-relative.txt"), "camera.txt");
  Rig rig = calibration.rig;
  Camera& camera = rig.cameras.front();
  for (const ParameterId name : ParameterIds{"fx", "fy", "cx", "cy"})
    set_parameter(camera.model, name, random_in(300.0, 700.0));
  const Calibration back =
      calibration_of(bytes_of(written_by(tumvi_format(), &calibration.documents.front(), rig)), "camera.txt");
  for (std::size_t i = 0; i < 5; ++i)
    RC_ASSERT(std::abs(parameter_values(back.rig.cameras[0].model)[i] - parameter_values(camera.model)[i]) <= 2.5e-13);
}

// Another lens of DSO's is another name in line 1; the rest stays.
TEST(CameraTxt, AnotherLensIsAnotherFirstLine) {
  for (const char* file : {"radtan-bare.txt", "equidistant.txt", "fov-bare.txt", "pinhole.txt", "fov-relative.txt"}) {
    const std::string bytes = read_file(testdata_dir() / "dso/good" / file);
    const Calibration calibration = calibration_of(bytes, "camera.txt");
    const std::string_view own = model_info(calibration.rig.cameras[0].model).id;
    for (const char* model : {"kb4", "radtan", "fov", "pinhole"}) {
      if (own == model) continue;
      Rig rig = calibration.rig;
      rig.cameras[0].model = sample_model(model);
      if (std::string_view(model) == "radtan") set_parameter(rig.cameras[0].model, "k3", 0.0);
      for (const ParameterId name : ParameterIds{"fx", "fy", "cx", "cy"})
        set_parameter(rig.cameras[0].model, name, *parameter(calibration.rig.cameras[0].model, name));
      const Written written = written_by(tumvi_format(), &calibration.documents.front(), rig);
      EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"dso"}) << file << " " << model;
      const std::string after = bytes_of(written);
      EXPECT_EQ(after.substr(after.find('\n')), bytes.substr(bytes.find('\n'))) << "only line 1 changes";
      const std::vector<double> was(parameter_values(rig.cameras[0].model).begin(),
                                    parameter_values(rig.cameras[0].model).end());
      const Calibration back = calibration_of(after, "camera.txt");
      ASSERT_EQ(back.rig.cameras[0].model.index(), rig.cameras[0].model.index()) << after;
      for (std::size_t i = 0; i < was.size(); ++i)
        EXPECT_NEAR(parameter_values(back.rig.cameras[0].model)[i], was[i], 1e-9) << after;
    }
  }
}

// DSO has no such lens, or would take the centre for a relative one: the camera goes into a chain, and that is reported.
TEST(CameraTxt, WhatItCannotSayBecomesAChain) {
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "dso/good/radtan-bare.txt"), "camera.txt");
  const auto becomes_a_chain = [&calibration](const Rig& rig) {
    Diagnostics diagnostics;
    const std::optional<Written> written = tumvi_format().write(&calibration.documents.front(), rig, {}, diagnostics);
    return written && written->files.front().programs == std::vector<std::string>{"kalibr"} &&
           id_of(diagnostics.entries().front()) == "not-a-camera-txt" &&
           read_as_tumvi(bytes_of(*written)).cameras.at(0).model == rig.cameras.at(0).model;
  };
  Rig other_model = calibration.rig;
  other_model.cameras[0].model = sample_model("mei");
  EXPECT_TRUE(becomes_a_chain(other_model));
  Rig near_the_corner = calibration.rig;
  set_parameter(near_the_corner.cameras[0].model, "cx", 0.5);
  set_parameter(near_the_corner.cameras[0].model, "cy", 0.25);
  EXPECT_TRUE(becomes_a_chain(near_the_corner));
  Rig pair = calibration.rig;
  pair.cameras.push_back(pair.cameras[0]);
  pair.cameras[1].name = "cam1";
  EXPECT_TRUE(becomes_a_chain(pair));
}

// A name that ends in .txt asks for DSO's text.
TEST(CameraTxt, AFreshOneByItsName) {
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "dso/good/equidistant.txt"), "camera.txt");
  for (const char* extension : {".txt", ".yaml"}) {
    WriteOptions options;
    options.extension = extension;
    Diagnostics diagnostics;
    const std::optional<Written> written = tumvi_format().write(nullptr, calibration.rig, options, diagnostics);
    ASSERT_TRUE(written);
    const bool text = options.extension == ".txt";
    EXPECT_EQ(written->files.front().programs.front(), text ? "dso" : "kalibr");
    EXPECT_EQ(written->defaults.empty(), !text);
    EXPECT_TRUE(diagnostics.entries().empty());
    const std::string bytes = bytes_of(*written);
    EXPECT_EQ(bytes.starts_with("EquiDistant "), text) << bytes;
    const Rig back = text ? calibration_of(bytes, "camera.txt").rig : read_as_tumvi(bytes);
    EXPECT_EQ(back.cameras.at(0).model, calibration.rig.cameras[0].model);
  }
}

}  // namespace
}  // namespace fca::test
