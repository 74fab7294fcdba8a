// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras.txt: what the numbers of each model mean, by formulas written down here once more, what is written comes
// back, edits keep every other byte, and the corpus' files are read with the values that a person reads in them.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>

#include <array>
#include <cmath>
#include <functional>
#include <iostream>

namespace fca::test {
namespace {

constexpr const char* kName = "cameras.txt";

const Format& colmap() { return *find_format("colmap"); }
Rig rig_of(const std::string& bytes) { return calibration_of(bytes, kName).rig; }

std::string written_bytes(const Rig& rig, const text::Document* base = nullptr) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(colmap(), base, rig, {}, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? written->files.front().document.bytes() : "";
}

/// The lines that are no comments.
std::string without_comments(const std::string& bytes) {
  std::string text;
  for (const std::string& line : split(bytes, '\n')) text += line.starts_with('#') ? "" : line + "\n";
  return text;
}

// ---------------------------------------------------------------- the models

constexpr double kX = 0.3;
constexpr double kY = -0.2;
constexpr double kR2 = kX * kX + kY * kY;
const double kRadius = std::sqrt(kR2);
const double kTheta = std::atan(kRadius);

/// The point (0.3, -0.2, 1) of a line `1 MODEL 640 480 ...` in COLMAP's pixels, less the half.
struct ByFormula {
  const char* line;
  const char* model;
  double u;
  double v;
};

double fisheye_factor(double k1, double k2, double k3, double k4) {
  return kTheta / kRadius *
         (1.0 + k1 * std::pow(kTheta, 2) + k2 * std::pow(kTheta, 4) + k3 * std::pow(kTheta, 6) + k4 * std::pow(kTheta, 8));
}

ByFormula straight(const char* line, const char* model, double fx, double fy, double factor) {
  return {line, model, fx * kX * factor + 321.0 - 0.5, fy * kY * factor + 239.0 - 0.5};
}

ByFormula brown(const char* line, const char* model, double factor, double p1, double p2) {
  const double x = kX * factor + 2.0 * p1 * kX * kY + p2 * (kR2 + 2.0 * kX * kX);
  const double y = kY * factor + p1 * (kR2 + 2.0 * kY * kY) + 2.0 * p2 * kX * kY;
  return {line, model, 500.0 * x + 320.5, 510.0 * y + 238.5};
}

TEST(Colmap, ParametersMeanWhatColmapsFormulasSay) {
  const double radial = 1.0 - 0.1 * kR2 + 0.02 * kR2 * kR2;
  const double rational =
      (radial + 0.003 * std::pow(kR2, 3)) / (1.0 + 0.04 * kR2 - 0.005 * kR2 * kR2 + 0.0006 * std::pow(kR2, 3));
  const double fov = std::atan(2.0 * kRadius * std::tan(0.45)) / (0.9 * kRadius);
  const double eucm = 1.0 / (0.6 * std::sqrt(1.1 * kR2 + 1.0) + 0.4);
  // Of radius = r / (1 + k r^2), which COLMAP computes from a pixel, the root r.
  const double division = (1.0 - std::sqrt(1.0 + 0.4 * kR2)) / (-0.2 * kR2);
  const double pincushion = (1.0 - std::sqrt(1.0 - 0.4 * kR2)) / (0.2 * kR2);
  const double x = kTheta * kX / kRadius;
  const double y = kTheta * kY / kRadius;
  const double q = kTheta * kTheta;
  const double bent = 1.0 + 0.01 * q - 0.02 * q * q + 0.003 * q * q * q - 0.0004 * q * q * q * q;
  const ByFormula thin_prism = {"THIN_PRISM_FISHEYE 640 480 500 510 321 239 0.01 -0.02 0.001 -0.002 0.003 -0.0004 0.005 -0.006",
                                "thin-prism-fisheye",
                                500.0 * (x * bent + 0.002 * x * y - 0.002 * (q + 2.0 * x * x) + 0.005 * q) + 320.5,
                                510.0 * (y * bent + 0.001 * (q + 2.0 * y * y) - 0.004 * x * y - 0.006 * q) + 238.5};
  const double further = bent + 0.00005 * std::pow(q, 5) - 0.00006 * std::pow(q, 6);
  const double xr = x * further;
  const double yr = y * further;
  const double qr = xr * xr + yr * yr;
  const ByFormula rad_tan_thin_prism = {
      "RAD_TAN_THIN_PRISM_FISHEYE 640 480 500 510 321 239 0.01 -0.02 0.003 -0.0004 0.00005 -0.00006 0.001 -0.002 0.003 -0.004 "
      "0.005 -0.006",
      "fisheye624", 500.0 * (xr + 0.001 * (2.0 * xr * xr + qr) - 0.004 * xr * yr + 0.003 * qr - 0.004 * qr * qr) + 320.5,
      510.0 * (yr - 0.002 * (2.0 * yr * yr + qr) + 0.002 * xr * yr + 0.005 * qr - 0.006 * qr * qr) + 238.5};
  const std::array rows = {
      straight("SIMPLE_PINHOLE 640 480 500 321 239", "pinhole", 500, 500, 1.0),
      straight("PINHOLE 640 480 500 510 321 239", "pinhole", 500, 510, 1.0),
      straight("SIMPLE_RADIAL 640 480 500 321 239 -0.1", "radtan", 500, 500, 1.0 - 0.1 * kR2),
      straight("RADIAL 640 480 500 321 239 -0.1 0.02", "radtan", 500, 500, radial),
      brown("OPENCV 640 480 500 510 321 239 -0.1 0.02 0.001 -0.002", "radtan", radial, 0.001, -0.002),
      brown("FULL_OPENCV 640 480 500 510 321 239 -0.1 0.02 0.001 -0.002 0.003 0.04 -0.005 0.0006", "rational", rational, 0.001,
            -0.002),
      straight("OPENCV_FISHEYE 640 480 500 510 321 239 0.01 -0.02 0.003 -0.0004", "kb4", 500, 510,
               fisheye_factor(0.01, -0.02, 0.003, -0.0004)),
      straight("SIMPLE_RADIAL_FISHEYE 640 480 500 321 239 0.01", "kb4", 500, 500, fisheye_factor(0.01, 0, 0, 0)),
      straight("RADIAL_FISHEYE 640 480 500 321 239 0.01 -0.02", "kb4", 500, 500, fisheye_factor(0.01, -0.02, 0, 0)),
      straight("SIMPLE_FISHEYE 640 480 500 321 239", "kb4", 500, 500, fisheye_factor(0, 0, 0, 0)),
      straight("FISHEYE 640 480 500 510 321 239", "kb4", 500, 510, fisheye_factor(0, 0, 0, 0)),
      straight("FOV 640 480 500 510 321 239 0.9", "fov", 500, 510, fov),
      straight("FOV 640 480 500 510 321 239 0", "pinhole", 500, 510, 1.0),
      straight("EUCM 640 480 500 510 321 239 0.6 1.1", "eucm", 500, 510, eucm),
      straight("SIMPLE_DIVISION 640 480 500 321 239 -0.1", "division", 500, 500, division),
      straight("DIVISION 640 480 500 510 321 239 -0.1", "division", 500, 510, division),
      straight("DIVISION 640 480 500 510 321 239 0.1", "division", 500, 510, pincushion),
      straight("DIVISION 640 480 500 510 321 239 0", "division", 500, 510, 1.0),
      thin_prism,
      rad_tan_thin_prism,
  };
  for (const ByFormula& row : rows) {
    const std::string bytes = "1 " + std::string(row.line) + "\n";
    const Rig rig = rig_of(bytes);
    ASSERT_EQ(rig.cameras.size(), 1U) << row.line;
    const Camera& camera = rig.cameras.front();
    EXPECT_EQ(model_info(camera.model).id, row.model) << row.line;
    EXPECT_EQ(camera.image_size, (ImageSize{640, 480}));
    const std::optional<Pixel> pixel = project(camera.model, {kX, kY, 1.0});
    ASSERT_TRUE(pixel) << row.line;
    EXPECT_NEAR((*pixel)[0], row.u, 1e-11) << row.line;
    EXPECT_NEAR((*pixel)[1], row.v, 1e-11) << row.line;
    const consumers::ConsumerView view = consumers::find_consumer("colmap")->load(bytes, {});
    ASSERT_EQ(view.cameras.size(), 1U) << row.line;
    const auto seen = view.cameras.front().project({2.0 * kX, 2.0 * kY, 2.0});
    ASSERT_TRUE(seen) << row.line;
    EXPECT_NEAR((*seen)[0], row.u, 1e-11) << row.line;
    EXPECT_NEAR((*seen)[1], row.v, 1e-11) << row.line;
    EXPECT_FALSE(view.cameras.front().project({kX, kY, 0.0})) << "COLMAP sees nothing at 90 degrees";
  }
}

// Near the axis COLMAP takes a series for the formula; the consumer says what that costs.
TEST(Colmap, TheSeriesOfFovIsNoOtherLens) {
  for (const char* omega : {"0.005", "0.5", "0.93", "2.5"}) {
    const std::string bytes = "1 FOV 640 480 500 510 321 239 " + std::string(omega) + "\n";
    const consumers::ConsumerCamera seen = consumers::find_consumer("colmap")->load(bytes, {}).cameras.at(0);
    const CameraModel model = rig_of(bytes).cameras.front().model;
    for (double x = 0.0005; x < 2.0; x *= 1.05) {
      const Pixel ours = *project(model, {x, 0.0, 1.0});
      EXPECT_NEAR((*seen.project({x, 0.0, 1.0}))[0], ours[0], seen.approximation_px + 1e-9) << omega << " " << x;
    }
  }
}

// ---------------------------------------------------------------- written

TEST(Colmap, AFreshFileIsReadAsTheSameRig) {
  for (const char* model : {"pinhole", "radtan", "kb4", "eucm", "fov", "division", "thin-prism-fisheye", "fisheye624"}) {
    const Rig rig = sample_rig(model, {true, false});
    const std::string bytes = written_bytes(rig);
    const Rig again = rig_of(bytes);
    ASSERT_EQ(again.cameras.size(), rig.cameras.size());
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      const std::span<const double> wanted = parameter_values(rig.cameras[i].model);
      const std::span<const double> there = parameter_values(again.cameras[i].model);
      EXPECT_EQ(again.cameras[i].image_size, rig.cameras[i].image_size);
      // A centre below a power of two may lose its last bit to the half that COLMAP adds.
      for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(there[k], wanted[k], 1e-13) << model << " " << k;
    }
    EXPECT_EQ(bytes.find("  ", bytes.rfind('#') + 30), std::string::npos) << "COLMAP 3.8 refuses two blanks\n" << bytes;
    EXPECT_EQ(bytes.find('\t'), std::string::npos);
  }
}

TEST(Colmap, TheHalfPixelIsExact) {
  Rig rig = rig_of("1 PINHOLE 640 480 500 510 321.25 239.75\n");
  EXPECT_EQ(parameter(rig.cameras.front().model, "cx"), 320.75);
  EXPECT_EQ(parameter(rig.cameras.front().model, "cy"), 239.25);
  EXPECT_EQ(without_comments(written_bytes(rig)), "1 PINHOLE 640 480 500.0 510.0 321.25 239.75\n");
}

TEST(Colmap, IdsAreKept) {
  const std::string lines = "7 PINHOLE 640 480 500.0 510.0 321.25 239.75\n2 PINHOLE 640 480 500.0 510.0 321.25 239.75\n";
  Rig rig = rig_of(lines);
  EXPECT_EQ(rig.cameras.at(1).name, "cam1");
  ASSERT_NE(rig.find_extra_field("cam0", "CAMERA_ID"), nullptr);
  EXPECT_EQ(rig.find_extra_field("cam1", "CAMERA_ID"), nullptr) << "2 is what a second camera is called anyhow";
  EXPECT_EQ(without_comments(written_bytes(rig)), lines);
  rig.extra_fields.front().value = "2";
  EXPECT_TRUE(without_comments(written_bytes(rig)).starts_with("2 PINHOLE 640 480 500.0 510.0 321.25 239.75\n3 PINHOLE"));
}

// 32 bits without a sign.
TEST(Colmap, LargeIdsAreKept) {
  const std::string lines =
      "3000000000 PINHOLE 640 480 500.0 510.0 321.25 239.75\n2 PINHOLE 640 480 500.0 510.0 321.25 239.75\n";
  const Rig rig = rig_of(lines);
  ASSERT_NE(rig.find_extra_field("cam0", "CAMERA_ID"), nullptr);
  EXPECT_EQ(without_comments(written_bytes(rig)), lines);
  // As in the binary file, and in a file of rigs.
  const std::string rigs = "1 2 CAMERA 3000000000 CAMERA 2 1 1 0 0 0 0.1 0 0\n";
  Diagnostics diagnostics;
  const std::optional<Calibration> both =
      read_calibration({document_of(lines, kName), document_of(rigs, "rigs.txt")}, nullptr, {}, diagnostics);
  ASSERT_TRUE(both);
  EXPECT_NE(both->rig.stated("cam1", "cam0"), nullptr);
}

// gsplat reads OPENCV_FISHEYE and no simpler fisheye.
TEST(Colmap, ALineGetsAModelThatTheProgramTakes) {
  const std::string line =
      "1 SIMPLE_RADIAL_FISHEYE 640 480 300.0 320.5 240.5 0.0\n2 SIMPLE_RADIAL 640 480 300.0 320.5 240.5 0.1\n";
  const text::Document base = document_of(line, kName);
  WriteOptions options;
  options.models_taken = consumers::find_consumer("gsplat")->writing.models_taken;
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(colmap(), &base, rig_of(line), options, diagnostics);
  ASSERT_TRUE(written);
  const std::string bytes = written->files.front().document.bytes();
  EXPECT_EQ(bytes,
            "1 OPENCV_FISHEYE 640 480 300.0 300.0 320.5 240.5 0.0 0.0 0.0 0.0\n"
            "2 SIMPLE_RADIAL 640 480 300.0 320.5 240.5 0.1\n");
  EXPECT_TRUE(consumers::find_consumer("gsplat")->load(bytes, {}).loads());
}

// The verdict is of the file; what is printed says the same by the same name.
TEST(Colmap, ArgumentsNameTheModelOfTheFile) {
  for (const auto& [line, words] : {std::pair("1 SIMPLE_RADIAL 640 480 500.0 320.5 240.5 -0.1\n", "SIMPLE_RADIAL"),
                                    {"1 SIMPLE_DIVISION 640 480 500.0 320.5 240.5 -0.1\n", "SIMPLE_DIVISION"}}) {
    const std::string expected =
        std::string("--ImageReader.camera_model ") + words + " --ImageReader.camera_params 500.0,320.5,240.5,-0.1";
    EXPECT_EQ(colmap().arguments(rig_of(line).cameras[0], document_of(line, kName), 0), expected);
  }
}

TEST(Colmap, WhatHasNoPlaceIsLost) {
  Rig rig = sample_rig("radtan", {true, true});
  rig.cameras.front().topic = "/cam0/image_raw";
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(colmap(), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_TRUE(loses(*written, Code::kTopicDropped));
  EXPECT_TRUE(loses(*written, Code::kImuDropped));
  EXPECT_TRUE(std::ranges::any_of(written->losses, [](const Loss& loss) { return info(loss.kind).id == "pose-dropped"; }));
}

TEST(Colmap, WhatColmapCannotHoldIsRefused) {
  Rig rig = sample_rig("radtan", {false, false});
  EXPECT_TRUE(set_parameter(rig.cameras.front().model, "k3", 0.01));
  Diagnostics diagnostics;
  EXPECT_FALSE(write_calibration(colmap(), nullptr, rig, {}, diagnostics)) << "OPENCV has no k3; FULL_OPENCV is of rational";
  Rig unsized = sample_rig("kb4", {false, false});
  unsized.cameras.front().image_size.reset();
  EXPECT_FALSE(write_calibration(colmap(), nullptr, unsized, {}, diagnostics));
}

// ---------------------------------------------------------------- edited

constexpr const char* kThree =
    "# mine\n3 SIMPLE_RADIAL 640 480 500 320 240 -0.10\n\n# yours\n1 SIMPLE_PINHOLE 640 480 5e2 320 240.0\n2 OPENCV 640 480 "
    "500 510 "
    "320 240 -0.1 0.02 0 0\n";

std::string edited(const std::function<void(Rig&)>& edit) {
  Rig rig = rig_of(kThree);
  edit(rig);
  const text::Document base = document_of(kThree, kName);
  return written_bytes(rig, &base);
}

std::string with(const std::string& from, const std::string& to) { return with_replaced(kThree, from, to); }

TEST(Colmap, AnEditChangesNumbersAlone) {
  const auto set = [](std::size_t camera, const std::vector<ParameterValue>& values) {
    return [=](Rig& rig) {
      for (const auto& [id, value] : values) EXPECT_TRUE(set_parameter(rig.cameras[camera].model, id, value));
    };
  };
  EXPECT_EQ(edited([](Rig&) {}), kThree);
  EXPECT_EQ(edited(set(0, {{"cx", 321.0}})), with("500 320 240 -0.10", "500 321.5 240 -0.10"));
  EXPECT_EQ(edited(set(1, {{"fx", 250.0}, {"fy", 250.0}})), with("5e2", "250.0"));
  EXPECT_EQ(edited(set(2, {{"p2", 0.001}})), with("-0.1 0.02 0 0", "-0.1 0.02 0 0.001"));
  EXPECT_EQ(edited([](Rig& rig) {
              rig.cameras[1].image_size = ImageSize{640, 360};
            }),
            with("1 SIMPLE_PINHOLE 640 480", "1 SIMPLE_PINHOLE 640 360"));
}

// f of SIMPLE_DIVISION is one number.
TEST(Colmap, ADivisionModelKeepsItsLine) {
  const std::string line = "1 SIMPLE_DIVISION 640 480 500 321 239 -0.1\n";
  const text::Document base = document_of(line, kName);
  const auto written = [&](std::initializer_list<ParameterValue> values) {
    Rig rig = rig_of(line);
    for (const auto& [id, value] : values) EXPECT_TRUE(set_parameter(rig.cameras[0].model, id, value));
    return written_bytes(rig, &base);
  };
  EXPECT_EQ(written({{"fx", 505.0}, {"fy", 505.0}}), with_replaced(line, "500", "505.0"));
  EXPECT_EQ(written({{"k", 0.25}}), with_replaced(line, "-0.1", "0.25"));
  EXPECT_EQ(written({{"fy", 510.0}}), "1 DIVISION 640 480 500.0 510.0 321.0 239.0 -0.1\n");
}

// f of SIMPLE_RADIAL is one number, and k2 has none.
TEST(Colmap, ALineWhoseModelIsTooSmallGetsAnother) {
  EXPECT_EQ(edited([](Rig& rig) { set_parameter(rig.cameras[0].model, "fy", 505.0); }),
            with("SIMPLE_RADIAL 640 480 500 320 240 -0.10", "OPENCV 640 480 500.0 505.0 320.0 240.0 -0.1 0.0 0.0 0.0"));
  EXPECT_EQ(edited([](Rig& rig) { rig.cameras[1].model = sample_model("eucm"); }).find("SIMPLE_PINHOLE"), std::string::npos);
}

// ---------------------------------------------------------------- the corpus

struct Expected {
  const char* file;
  std::size_t cameras;
  const char* model;  ///< Of the last camera, as what follows.
  double fx;          ///< As the file has it.
  double cx;          ///< As the file has it: half a pixel more than ours.
  ImageSize size;
};

constexpr std::array kExpected = {
    Expected{"5697526__NeRF-TensoRF__sparse__0__cameras.txt", 80, "pinhole", 1831.9143095815152, 540, {1080, 1920}},
    Expected{"AiEson__ObjectFolderConvertor__cameras.txt", 1, "pinhole", 886.81, 512, {1024, 1024}},
    Expected{"AspasZhang__NeRF__sparse_text__cameras.txt", 1, "radtan", 2049.47, 360, {720, 1280}},
    Expected{"HexGP__nerf-prep__colmap_text__cameras.txt", 1, "radtan", 1027.7879529283434, 481.14437353992906, {1080, 1920}},
    Expected{"Wujiazhang__Nerfhomework__cameras.txt", 1, "pinhole", 1497.4865033457656, 540, {1080, 1920}},
    Expected{"hku-mars__FAST-LIVO2__Log__Colmap__sparse__0__cameras.txt", 1, "pinhole", 588.143715, 296.059369, {640, 512}},
    Expected{"sangminkim-99__COLMAP_multicam__colmap_text__cameras.txt",
             2,
             "radtan",
             608.56203083016101,
             321.32542926972661,
             {640, 480}},
};

TEST(Colmap, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "colmap";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const std::string bytes = read_file(corpus / expected.file);
    const Rig rig = calibration_of(bytes, expected.file).rig;
    ASSERT_EQ(rig.cameras.size(), expected.cameras);
    const Camera& camera = rig.cameras.back();
    EXPECT_EQ(model_info(camera.model).id, expected.model);
    EXPECT_EQ(parameter(camera.model, "fx"), expected.fx);
    EXPECT_EQ(parameter(camera.model, "cx"), expected.cx - 0.5);
    EXPECT_EQ(camera.image_size, expected.size);
    EXPECT_TRUE(rig.extra_fields.empty()) << "ids in turn";
    const text::Document base = document_of(bytes, expected.file);
    EXPECT_EQ(written_bytes(rig, &base), bytes);
    EXPECT_TRUE(consumers::find_consumer("colmap")->load(bytes, {}).loads());
  }
  const auto texts = std::ranges::count_if(
      files_in(corpus), [](const fs::path& path) { return path.filename().string().ends_with("cameras.txt"); });
  EXPECT_EQ(static_cast<std::size_t>(texts), kExpected.size());
}

}  // namespace
}  // namespace fca::test
