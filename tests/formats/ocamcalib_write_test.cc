// SPDX-License-Identifier: BSD-3-Clause
// calib_results.txt written from rigs: our reader gives back the same doubles, OCamCalib's C functions load it and understand
// the same, and an edit changes its own bytes only.
#include "formats/oracle_table.h"
#include "formats/rigs.h"
#include "ocamcalib/blocks.h"
#include "ocamcalib/inverse.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

const Format& ocamcalib_format() { return *find_format("ocamcalib"); }
const consumers::Consumer& world2cam() { return *consumers::find_consumer("ocamcalib"); }

/// cx cy c d e a0 .. a8
Camera camera_with(std::initializer_list<double> values, ImageSize size) {
  return {"cam0", size, model_of("ocamcalib", values), std::nullopt, std::nullopt, ""};
}

/// A number in [low, high] with all the digits of a double.
double random_in(double low, double high) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  return low + (high - low) * (static_cast<double>(bits >> 11U) * 0x1p-53);
}

/// A fisheye of the kind the toolbox is for: radii in units of |a0|, up to 1.6 of them in the image, and an angle that grows
/// far beyond. (One that folds nearby has an inverse with a branch point, and no polynomial comes near it: its own test is
/// below.)
Camera random_camera() {
  const double f = random_in(90.0, 900.0);
  const ImageSize size = {static_cast<int>(random_in(0.7, 2.2) * f), static_cast<int>(random_in(0.7, 2.2) * f)};
  Camera camera =
      camera_with({(0.5 + random_in(-0.02, 0.02)) * size.width, (0.5 + random_in(-0.02, 0.02)) * size.height,
                   random_in(0.98, 1.02), random_in(-0.01, 0.01), random_in(-0.01, 0.01), -f, 0.0, random_in(0.25, 0.5) / f,
                   random_in(-0.01, 0.05) / (f * f), random_in(0.01, 0.08) / (f * f * f), 0.0, 0.0, 0.0, 0.0},
                  size);
  if (*rc::gen::inRange(0, 3) == 0) set_parameter(camera.model, "a6", random_in(0.0, 1e-3) * std::pow(f, -5.0));
  return camera;
}

Rig rig_of(const Camera& camera) {
  Rig rig;
  rig.cameras.push_back(camera);
  return rig;
}

std::string bytes_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

std::vector<double> inverse_in(const std::string& bytes) {
  Diagnostics ignored;
  const text::Document document = document_of(bytes, "calib_results.txt");
  const std::optional<ocamcalib::Blocks> blocks = ocamcalib::find_blocks(document, ignored);
  EXPECT_TRUE(blocks);
  std::vector<double> values;
  if (blocks) {
    for (const text::Node* node : blocks->inverse.coefficients) values.push_back(text::parse_real(node->value).value());
  }
  return values;
}

RC_GTEST_PROP(OCamCalibWrite, ReadsBackBitEqualAndWorld2camAgrees, ()) {
  const Rig rig = rig_of(random_camera());
  const Written written = written_by(ocamcalib_format(), nullptr, rig);
  const std::string bytes = bytes_of(written);
  Parsed parsed = parse(bytes, "calib_results.txt");
  RC_ASSERT(parsed.document.has_value());
  const std::optional<Calibration> back = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  RC_ASSERT(back.has_value());
  RC_ASSERT(parsed.codes().empty());
  RC_ASSERT(back->format->id == "ocamcalib");
  RC_ASSERT(back->rig.cameras == rig.cameras);

  const std::vector<double> inverse = inverse_in(bytes);
  RC_ASSERT(inverse.size() <= ocamcalib::kMostCoefficients);
  const double error = ocamcalib::inverse_error(rig.cameras.front(), inverse);
  RC_ASSERT(error <= 1e-6);
  const ProofResult proof = prove(world2cam(), bytes, {}, rig);
  RC_ASSERT(proof.loads);
  RC_ASSERT(proof.max_diff_px <= 1e-6);
  RC_ASSERT(proof.agrees());
}

// exportData2TXT.m's layout: each of the five blocks after one line that begins with '#'.
TEST(OCamCalibWrite, OneCommentLineBeforeEachBlock) {
  const Camera camera =
      camera_with({480.5, 300.25, 1.0, 0.0, 0.0, -310.25, 0.0, 1.2e-3, -1.5e-6, 2.1e-9, 0.0, 0.0, 0.0, 0.0}, {960, 600});
  std::vector<std::string> lines;
  for (const std::string& line : split(bytes_of(written_by(ocamcalib_format(), nullptr, rig_of(camera))), '\n')) {
    if (!line.empty()) lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 10U);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].starts_with('#'), i % 2 == 0) << lines[i];
  EXPECT_EQ(lines[1], "5 -310.25 0.0 0.0012 -1.5e-06 2.1e-09") << "five coefficients, as programs with fixed places have";
  EXPECT_EQ(lines[5], "300.25 480.5") << "row, column";
  EXPECT_EQ(lines[7], "1.0 0.0 0.0");
  EXPECT_EQ(lines[9], "600 960") << "height, width";
}

// The fit over all kinds of lenses, testdata/models' among them.
TEST(OCamCalibWrite, TheInverseIsFittedToAMillionthOfAPixel) {
  const std::vector<std::pair<const char*, Camera>> cameras = {
      {"sheared", camera_with({322.4, 238.7, 1.02, 0.01, -0.008, -180, 0, 1.9e-3, -1.1e-6, 6e-9, 0, 0, 0, 0}, {640, 480})},
      {"degree 8",
       camera_with({512.5, 380.25, 0.9995, -0.0002, 0.0003, -320, 0, 9e-4, -4e-7, 1.2e-9, 1e-12, -2e-15, 3e-18, 1e-20},
                   {1024, 768})},
      {"a1 not 0", camera_with({320, 240, 1, 0, 0, -200, 0.05, 1.2e-3, 0, 4e-9, 0, 0, 0, 0}, {640, 480})},
      {"stereographic", camera_with({320, 240, 1, 0, 0, -200, 0, 1.25e-3, 0, 0, 0, 0, 0, 0}, {640, 480})},
      {"pinhole", camera_with({320, 240, 1.025, 0, 0, -400, 0, 0, 0, 0, 0, 0, 0, 0}, {640, 480})},
      {"one pixel", camera_with({0, 0, 1, 0, 0, -200, 0, 1.25e-3, 0, 0, 0, 0, 0, 0}, {1, 1})},
  };
  for (const auto& [name, camera] : cameras) {
    const ocamcalib::InversePolynomial inverse = ocamcalib::fit_inverse(camera);
    std::printf("%-14s %2zu coefficients, %.2g px\n", name, inverse.coefficients.size(), inverse.error_px);
    EXPECT_LE(inverse.error_px, 1e-6) << name;
    EXPECT_EQ(inverse.error_px, ocamcalib::inverse_error(camera, inverse.coefficients)) << name;
    if (inverse.coefficients.size() > 3) {
      const std::span<const double> fewer(inverse.coefficients.data(), inverse.coefficients.size() - 1);
      EXPECT_GT(ocamcalib::inverse_error(camera, fewer), 1e-6) << name << ": as few as reach it";
    }
  }
}

// An image that reaches beyond the angle at which the direct polynomial folds: there is no inverse out there, and the curve
// ends with an infinite derivative. The best polynomial is written, and how good it is said.
TEST(OCamCalibWrite, ALensThatFoldsInsideTheImageIsSaid) {
  const Camera camera = camera_with({320, 240, 1, 0, 0, -200, 0, -1.25e-3, 0, 0, 0, 0, 0, 0}, {640, 480});
  Diagnostics diagnostics;
  const std::optional<Written> written = ocamcalib_format().write(nullptr, rig_of(camera), {}, diagnostics);
  ASSERT_TRUE(written);
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(id_of(diagnostics.entries().front()), "inverse-inexact");
  EXPECT_LE(inverse_in(bytes_of(*written)).size(), ocamcalib::kMostCoefficients);
}

struct Case {
  const char* file;
  const char* spelling;
  ParameterId parameter;
};

// The centre and the affine part are no part of rho(theta): the file's own inverse stays.
TEST(OCamCalibEdit, OneNumberChangesItsOwnBytesOnly) {
  for (const Case& row : {Case{"toolbox.txt", "483.25", "cx"},
                          {"toolbox.txt", "297.625", "cy"},
                          {"toolbox.txt", "1.0004", "c"},
                          {"toolbox.txt", "-0.00021", "d"},
                          {"toolbox.txt", "0.00034", "e"},
                          {"crlf.txt", "483.25", "cx"},
                          {"free-layout.txt", "297.625", "cy"},
                          {"free-layout.txt", " .00034", "e"}}) {
    SCOPED_TRACE(std::string(row.file) + " " + std::string(row.parameter.name()));
    const std::string bytes = read_file(testdata_dir() / "ocamcalib" / "good" / row.file);
    const Calibration calibration = calibration_of(bytes, row.file);
    Rig rig = calibration.rig;
    const double changed = parameter(rig.cameras[0].model, row.parameter).value() + 0.0009765625;
    ASSERT_TRUE(set_parameter(rig.cameras[0].model, row.parameter, changed));
    const Written written = written_by(ocamcalib_format(), &calibration.documents.front(), rig);
    const std::string blank = row.spelling[0] == ' ' ? " " : "";
    EXPECT_EQ(bytes_of(written), with_replaced(bytes, row.spelling, blank + text::format_real(changed)));
    EXPECT_TRUE(written.defaults.empty());
  }
}

TEST(OCamCalibEdit, AnotherDirectPolynomialGetsItsInverse) {
  for (const char* file : {"toolbox.txt", "crlf.txt", "free-layout.txt", "degree-eight.txt"}) {
    SCOPED_TRACE(file);
    const std::string bytes = read_file(testdata_dir() / "ocamcalib" / "good" / file);
    const Calibration calibration = calibration_of(bytes, file);
    for (const ParameterId name : ParameterIds{"a0", "a2", "a4", "a6"}) {
      SCOPED_TRACE(name.name());
      Rig rig = calibration.rig;
      const double scale = std::pow(310.0, 1.0 - (name.name()[1] - '0'));
      ASSERT_TRUE(set_parameter(rig.cameras[0].model, name, parameter(rig.cameras[0].model, name).value() + 0.001 * scale));
      const Written written = written_by(ocamcalib_format(), &calibration.documents.front(), rig);
      ASSERT_EQ(written.defaults.size(), 1U);
      EXPECT_EQ(written.defaults.front().key, "cam0 inverse polynomial");
      const Calibration back = calibration_of(bytes_of(written), file);
      EXPECT_TRUE(back.rig.cameras == rig.cameras) << bytes_of(written);
      EXPECT_LE(ocamcalib::inverse_error(rig.cameras[0], inverse_in(bytes_of(written))), 1e-6);
      EXPECT_TRUE(prove(world2cam(), bytes_of(written), {}, rig).agrees()) << bytes_of(written);
      // What stands after the two polynomials is the same, and so are its bytes.
      const std::size_t tail = bytes.find("297.625");
      EXPECT_TRUE(bytes_of(written).ends_with(bytes.substr(tail)));
    }
  }
}

RC_GTEST_PROP(OCamCalibEdit, AnyOtherCameraReadsBack, ()) {
  const std::string file = *rc::gen::element<std::string>("toolbox.txt", "crlf.txt", "free-layout.txt", "degree-eight.txt");
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "ocamcalib" / "good" / file), file);
  const Rig rig = rig_of(random_camera());
  const Written written = written_by(ocamcalib_format(), &calibration.documents.front(), rig);
  RC_ASSERT(calibration_of(bytes_of(written), file).rig.cameras == rig.cameras);
  RC_ASSERT(prove(world2cam(), bytes_of(written), {}, rig).agrees());
}

// The two defects that the writer fixes, told by the reader (testdata/formats/ocamcalib/bad).
TEST(OCamCalibEdit, AMissingOrStaleInverseIsRebuilt) {
  const std::string good = read_file(testdata_dir() / "ocamcalib/good/toolbox.txt");
  for (const char* file : {"stale-inverse.txt", "no-inverse.txt", "inverse-empty.txt"}) {
    SCOPED_TRACE(file);
    const Calibration calibration = calibration_of(read_file(testdata_dir() / "ocamcalib" / "bad" / file), file);
    const Written written = written_by(ocamcalib_format(), &calibration.documents.front(), calibration.rig);
    ASSERT_EQ(written.defaults.size(), 1U);
    const auto& said = std::get<std::vector<Message>>(written.defaults.front().value.value);
    EXPECT_EQ(said.front().code, Code::kCalibResultsInverseFitted);
    // All but the inverse's line is the good file's, from which they were made.
    std::vector<std::string> lines = split(bytes_of(written), '\n');
    std::vector<std::string> wanted = split(good, '\n');
    ASSERT_EQ(lines.size(), wanted.size());
    lines[6].clear();
    wanted[6].clear();
    EXPECT_EQ(lines, wanted);
    EXPECT_LE(ocamcalib::inverse_error(calibration.rig.cameras[0], inverse_in(bytes_of(written))), 1e-6);
  }
}

TEST(OCamCalibWrite, OneFilePerCamera) {
  Rig rig = rig_of(
      camera_with({480.5, 300.25, 1.0, 0.0, 0.0, -310.25, 0.0, 1.2e-3, -1.5e-6, 2.1e-9, 0.0, 0.0, 0.0, 0.0}, {960, 600}));
  rig.cameras.push_back(rig.cameras.front());
  rig.cameras[1].name = "cam1";
  set_parameter(rig.cameras[1].model, "cx", 470.0);
  rig.poses.push_back({"cam1", "cam0", T_cam1_cam0()});
  rig.cameras[0].time_offset_s = 0.0021;
  const Written written = written_by(ocamcalib_format(), nullptr, rig);
  ASSERT_EQ(written.files.size(), 2U);
  EXPECT_EQ(written.files[1].document.source().name, "cam1.txt");
  EXPECT_EQ(written.files[1].cameras, std::vector<std::string>{"cam1"});
  EXPECT_EQ(calibration_of(written.files[1].document.bytes(), "cam1.txt").rig.cameras[0].model, rig.cameras[1].model);
  std::vector<std::string> codes;
  for (const Loss& loss : written.losses) codes.push_back(id_of(loss));
  EXPECT_EQ(codes, std::vector<std::string>{"time-offset-dropped"});
}

TEST(OCamCalibWrite, WhatItCannotHoldIsAnError) {
  Rig rig = sample_rig("kb4", {false, false});
  Diagnostics diagnostics;
  EXPECT_FALSE(ocamcalib_format().write(nullptr, rig, {}, diagnostics));
  EXPECT_EQ(id_of(diagnostics.entries().at(0)), "model-not-storable");
  rig = rig_of(camera_with({480.5, 300.25, 1.0, 0.0, 0.0, -310.25, 0.0, 1.2e-3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, {960, 600}));
  rig.cameras[0].image_size.reset();
  Diagnostics without_size;
  EXPECT_FALSE(ocamcalib_format().write(nullptr, rig, {}, without_size));
  EXPECT_EQ(id_of(without_size.entries().at(0)), "image-size-missing");
  Diagnostics empty;
  EXPECT_FALSE(ocamcalib_format().write(nullptr, Rig(), {}, empty));
  EXPECT_EQ(id_of(empty.entries().at(0)), "no-camera");
}

}  // namespace
}  // namespace fca::test
