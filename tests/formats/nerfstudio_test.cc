// SPDX-License-Identifier: BSD-3-Clause
// transforms.json of nerfstudio and instant-ngp: what its numbers mean, by formulas written down here once more; which object
// specifies them; what an edit touches; what each loader reads from a file; and the corpus' files, read as a person reads them.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace fca::test {
namespace {

constexpr const char* kName = "transforms.json";
constexpr const char* kPose = R"("transform_matrix": [[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";
constexpr const char* kNumbers = R"("fl_x": 500.0, "fl_y": 510.0, "cx": 321.0, "cy": 239.0, "w": 640, "h": 480)";

const Format& nerfstudio() { return *find_format("nerfstudio"); }
Rig rig_of(const std::string& bytes) { return calibration_of(bytes, kName).rig; }

/// A frame with further keys ("\"k1\": 0.1").
std::string frame(const std::string& keys = "", const std::string& file = "a.png") {
  return "{\"file_path\": \"" + file + "\", " + keys + (keys.empty() ? "" : ", ") + kPose + "}";
}

std::string file(const std::string& top, const std::vector<std::string>& frames) {
  std::string text = "{" + top + (top.empty() ? "" : ", ") + "\"frames\": [";
  for (std::size_t i = 0; i < frames.size(); ++i) text += (i > 0 ? ", " : "") + frames[i];
  return text + "]}\n";
}

std::string at_top(const std::string& keys) { return file(std::string(kNumbers) + ", " + keys, {frame()}); }

std::string written_bytes(const Rig& rig, const text::Document* base = nullptr) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(nerfstudio(), base, rig, {}, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? written->files.front().document.bytes() : "";
}

std::string edited(const std::string& bytes, const std::function<void(Rig&)>& edit) {
  Rig rig = rig_of(bytes);
  edit(rig);
  const text::Document base = document_of(bytes, kName);
  return written_bytes(rig, &base);
}

consumers::ConsumerView view_of(const char* program, const std::string& bytes) {
  return consumers::find_consumer(program)->load(bytes, {});
}

std::vector<Code> codes_of(const std::vector<consumers::Complaint>& complaints) {
  std::vector<Code> codes;
  for (const consumers::Complaint& complaint : complaints) codes.push_back(complaint.facts.code);
  return codes;
}

double number_of(const Camera& camera, ParameterId id) { return parameter(camera.model, id).value(); }

// ---------------------------------------------------------------- what numbers mean

constexpr double kX = 0.3;
constexpr double kY = -0.2;
constexpr double kR2 = kX * kX + kY * kY;

struct ByFormula {
  std::string keys;
  const char* model;
  double x;  ///< The point (0.3, -0.2, 1) on the plane, bent.
  double y;
  bool in_instant_ngp = true;
};

TEST(Nerfstudio, NumbersMeanWhatItsFormulasSay) {
  const double theta = std::atan(std::sqrt(kR2));
  const double t2 = theta * theta;
  const double fisheye = theta * (1.0 + t2 * (0.01 + t2 * (-0.02 + t2 * (0.003 - t2 * 0.0004)))) / std::sqrt(kR2);
  const auto brown = [](double k3) {
    const double radial = 1.0 + kR2 * (-0.1 + kR2 * (0.02 + kR2 * k3));
    return std::array{kX * radial + 2.0 * 0.001 * kX * kY - 0.002 * (kR2 + 2.0 * kX * kX),
                      kY * radial + 0.001 * (kR2 + 2.0 * kY * kY) + 2.0 * -0.002 * kX * kY};
  };
  const std::string lens = R"("k1": -0.1, "k2": 0.02, "p1": 0.001, "p2": -0.002)";
  const std::vector<ByFormula> rows = {
      {R"("camera_model": "PINHOLE")", "pinhole", kX, kY},
      {R"("camera_model": "OPENCV", )" + lens, "radtan", brown(0.0)[0], brown(0.0)[1]},
      {lens + R"(, "k3": 0.5)", "radtan", brown(0.5)[0], brown(0.5)[1], false},
      {R"("camera_model": "SIMPLE_RADIAL", )" + lens, "radtan", brown(0.0)[0], brown(0.0)[1]},
      // Whatever stands next to it.
      {R"("distortion_params": [-0.1, 0.02, 0.5, 0, 0.001, -0.002], "k1": 0.3)", "radtan", brown(0.5)[0], brown(0.5)[1], false},
      {R"("camera_model": "OPENCV_FISHEYE", "distortion_params": [0.01, -0.02, 0.003, -0.0004, 0, 0])", "kb4", fisheye * kX,
       fisheye * kY, false},
      {R"("camera_model": "OPENCV_FISHEYE", "is_fisheye": true, "k1": 0.01, "k2": -0.02, "k3": 0.003, "k4": -0.0004)", "kb4",
       fisheye * kX, fisheye * kY}};
  for (const ByFormula& row : rows) {
    const std::string bytes = at_top(row.keys);
    const Rig rig = rig_of(bytes);
    ASSERT_EQ(rig.cameras.size(), 1U) << bytes;
    EXPECT_EQ(model_info(rig.cameras.front().model).id, row.model) << bytes;
    EXPECT_EQ(rig.cameras.front().image_size, (ImageSize{640, 480}));
    const double u = 500.0 * row.x + 321.0 - 0.5;
    const double v = 510.0 * row.y + 239.0 - 0.5;
    const std::optional<Pixel> pixel = project(rig.cameras.front().model, {kX, kY, 1.0});
    ASSERT_TRUE(pixel) << bytes;
    EXPECT_NEAR((*pixel)[0], u, 1e-10) << bytes;
    EXPECT_NEAR((*pixel)[1], v, 1e-10) << bytes;
    for (const char* program : {"nerfstudio", "instant-ngp"}) {
      const consumers::ConsumerView view = view_of(program, bytes);
      ASSERT_EQ(view.cameras.size(), 1U) << bytes;
      const auto seen = view.cameras.front().project({2.0 * kX, 2.0 * kY, 2.0});
      ASSERT_TRUE(seen) << bytes;
      const bool right = std::string(program) == "nerfstudio" || row.in_instant_ngp;
      EXPECT_EQ(std::abs((*seen)[0] - u) < 2e-4 && std::abs((*seen)[1] - v) < 2e-4, right) << program << bytes;
    }
  }
}

TEST(Nerfstudio, OnlyItsOwnFisheyeSeesBeyond90Degrees) {
  const std::string bytes = at_top(R"("camera_model": "OPENCV_FISHEYE", "is_fisheye": true, "k1": 0.01)");
  EXPECT_TRUE(view_of("nerfstudio", bytes).cameras.at(0).project({1.0, 0.0, -0.2}));
  EXPECT_FALSE(view_of("instant-ngp", bytes).cameras.at(0).project({1.0, 0.0, -0.2}));
}

// ---------------------------------------------------------------- where they stand

TEST(Nerfstudio, FramesWithTheSameNumbersAreOneCamera) {
  const std::string a = std::string(kNumbers) + R"(, "k1": 0.1)";
  const std::string b = with_replaced(a, "500.0", "501.0");
  const Rig rig = rig_of(file("", {frame(a), frame(b), frame(a), frame(with_replaced(b, "501.0", "5.01e2"))}));
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(number_of(rig.cameras[0], "fx"), 500.0);
  EXPECT_EQ(number_of(rig.cameras[1], "fx"), 501.0);
  EXPECT_EQ(rig.cameras[1].name, "cam1");
  ASSERT_NE(rig.find_extra_field("", "frames"), nullptr);
  EXPECT_EQ(rig.find_extra_field("", "frames")->value, "4");
  EXPECT_TRUE(rig.poses.empty()) << "poses of images are none of cameras";
}

TEST(Nerfstudio, TheTopCountsBeforeAFrame) {
  const std::string other = with_replaced(kNumbers, "500.0", "700.0");
  const Rig rig = rig_of(file(kNumbers, {frame(other)}));
  ASSERT_EQ(rig.cameras.size(), 1U);
  EXPECT_EQ(number_of(rig.cameras[0], "fx"), 500.0);
  // k4 alone at the top keeps no frame's coefficients from being read.
  const std::string fisheye = R"("camera_model": "OPENCV_FISHEYE", )" + std::string(kNumbers);
  EXPECT_EQ(number_of(rig_of(file(fisheye + R"(, "k4": 0.5)", {frame(R"("k1": 0.25)")})).cameras[0], "k1"), 0.25);
  EXPECT_EQ(number_of(rig_of(file(fisheye + R"(, "k3": 0.0)", {frame(R"("k1": 0.25)")})).cameras[0], "k1"), 0.0);
}

TEST(Nerfstudio, AnglesAndTheMiddleStandForWhatIsNotStated) {
  const std::string size = R"("w": 640, "h": 480)";
  const Camera radians = rig_of(file(R"("camera_angle_x": 1.0, )" + size, {frame()})).cameras.at(0);
  EXPECT_NEAR(number_of(radians, "fx"), 320.0 / std::tan(0.5), 1e-12);
  EXPECT_EQ(number_of(radians, "fy"), number_of(radians, "fx"));
  EXPECT_EQ(number_of(radians, "cx"), 319.5);
  EXPECT_EQ(number_of(radians, "cy"), 239.5);
  const Camera degrees = rig_of(file(R"("y_fov": 90.0, )" + size, {frame()})).cameras.at(0);
  EXPECT_NEAR(number_of(degrees, "fx"), 240.0, 1e-12);
  const consumers::ConsumerView seen = view_of("instant-ngp", file(R"("camera_angle_x": 1.0, )" + size, {frame()}));
  ASSERT_EQ(seen.cameras.size(), 1U);
  EXPECT_NEAR((*seen.cameras[0].project({0.1, 0.0, 1.0}))[0], 319.5 + 32.0 / std::tan(0.5), 2e-4);
}

// ---------------------------------------------------------------- written

TEST(Nerfstudio, AFreshFileIsReadAsTheSameRigByAll) {
  for (const char* model : {"pinhole", "radtan", "kb4"}) {
    for (const bool pair : {false, true}) {
      Rig rig = sample_rig(model, {pair, false});
      const std::string bytes = written_bytes(rig);
      const Rig again = rig_of(bytes);
      ASSERT_EQ(again.cameras.size(), rig.cameras.size()) << bytes;
      for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        EXPECT_EQ(again.cameras[i].name, rig.cameras[i].name);
        EXPECT_EQ(again.cameras[i].image_size, rig.cameras[i].image_size);
        const std::span<const double> wanted = parameter_values(rig.cameras[i].model);
        const std::span<const double> there = parameter_values(again.cameras[i].model);
        ASSERT_EQ(there.size(), wanted.size());
        for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(there[k], wanted[k], 1e-13) << model << " " << k;
      }
      for (const char* program : {"nerfstudio", "instant-ngp"}) {
        const consumers::ConsumerView view = view_of(program, bytes);
        EXPECT_TRUE(view.loads()) << program << bytes;
        EXPECT_TRUE(view.warnings.empty()) << program << bytes;
        ASSERT_EQ(view.cameras.size(), rig.cameras.size());
        for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
          const Pixel ours = *project(rig.cameras[i].model, {kX, kY, 1.0});
          EXPECT_NEAR((*view.cameras[i].project({kX, kY, 1.0}))[0], ours[0], 2e-4) << program << bytes;
        }
      }
    }
  }
}

TEST(Nerfstudio, CamerasWithTheSameNumbersStayTwo) {
  Rig rig = sample_rig("kb4", {true, false});
  rig.cameras[1].model = rig.cameras[0].model;
  rig.cameras[0].name = "left";
  rig.cameras[1].name = "right";
  rig.poses.clear();
  const std::string bytes = written_bytes(rig);
  const Rig again = rig_of(bytes);
  ASSERT_EQ(again.cameras.size(), 2U) << bytes;
  EXPECT_EQ(again.cameras[1].name, "right");
  EXPECT_EQ(view_of("nerfstudio", bytes).cameras.size(), 2U);
}

TEST(Nerfstudio, WhatHasNoPlaceIsLost) {
  const Rig rig = sample_rig("radtan", {true, true});
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(nerfstudio(), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_TRUE(loses(*written, Code::kImuDropped));
  EXPECT_TRUE(std::ranges::any_of(written->losses, [](const Loss& loss) { return info(loss.kind).id == "pose-dropped"; }));
  EXPECT_EQ(written->defaults.size(), 1U) << "frames";
}

TEST(Nerfstudio, AFisheyeAndAnotherLensDoNotGoTogether) {
  Rig rig = sample_rig("kb4", {true, false});
  rig.cameras[1].model = sample_model("radtan");
  Diagnostics diagnostics;
  EXPECT_FALSE(write_calibration(nerfstudio(), nullptr, rig, {}, diagnostics));
  EXPECT_EQ(diagnostics.entries().at(0).facts.code, Code::kNerfKindsDiffer);
}

// ---------------------------------------------------------------- edited

void set(Rig& rig, std::size_t camera, ParameterId id, double value) {
  EXPECT_TRUE(set_parameter(rig.cameras.at(camera).model, id, value));
}

TEST(Nerfstudio, AnEditOfTheTopTouchesOneNumber) {
  const std::string bytes = at_top(R"("k1": -0.10, "k2": 2e-2, "k3": 0, "k4": 0, "p1": 0.001, "p2": -0.002, "aabb_scale": 16)");
  EXPECT_EQ(edited(bytes, [](Rig&) {}), bytes);
  EXPECT_EQ(edited(bytes, [](Rig& rig) { set(rig, 0, "k1", -0.2); }), with_replaced(bytes, "-0.10", "-0.2"));
  EXPECT_EQ(edited(bytes, [](Rig& rig) { set(rig, 0, "cx", 320.0); }), with_replaced(bytes, "321.0", "320.5"));
  EXPECT_EQ(edited(bytes,
                   [](Rig& rig) {
                     rig.cameras[0].image_size = ImageSize{640, 360};
                   }),
            with_replaced(bytes, "480", "360"));
}

TEST(Nerfstudio, AnEditOfACameraTouchesItsFrames) {
  const std::string other = with_replaced(kNumbers, "500.0", "501.0");
  const std::string bytes = file("", {frame(kNumbers), frame(other), frame(kNumbers)});
  EXPECT_EQ(edited(bytes, [](Rig& rig) { set(rig, 1, "fx", 502.0); }), with_replaced(bytes, "501.0", "502.0"));
  const std::string both = edited(bytes, [](Rig& rig) { set(rig, 0, "fx", 499.0); });
  EXPECT_EQ(both, file("", {frame(with_replaced(kNumbers, "500.0", "499.0")), frame(other),
                            frame(with_replaced(kNumbers, "500.0", "499.0"))}));
}

// It was one number for all cameras, and now there are two.
TEST(Nerfstudio, ANumberThatIsNoLongerOfAllCamerasGoesToTheFrames) {
  const std::string bytes = file(R"("cx": 321.0, "cy": 239.0, "w": 640, "h": 480, "k1": 0.0, "p1": 0.0)",
                                 {frame(R"("fl_x": 500.0, "fl_y": 500.0)"), frame(R"("fl_x": 510.0, "fl_y": 510.0)")});
  const std::string now = edited(bytes, [](Rig& rig) {
    set(rig, 1, "cx", 318.0);
    set(rig, 1, "k1", 0.25);
  });
  const Rig rig = rig_of(now);
  ASSERT_EQ(rig.cameras.size(), 2U) << now;
  EXPECT_EQ(number_of(rig.cameras[0], "cx"), 320.5) << now;
  EXPECT_EQ(number_of(rig.cameras[1], "cx"), 318.0) << now;
  EXPECT_EQ(number_of(rig.cameras[0], "k1"), 0.0) << now;
  EXPECT_EQ(number_of(rig.cameras[1], "k1"), 0.25) << now;
  for (const char* program : {"nerfstudio", "instant-ngp"}) {
    const consumers::ConsumerView view = view_of(program, now);
    ASSERT_EQ(view.cameras.size(), 2U) << program << now;
    const Pixel ours = *project(rig.cameras[1].model, {kX, kY, 1.0});
    EXPECT_NEAR((*view.cameras[1].project({kX, kY, 1.0}))[0], ours[0], 2e-4) << program << now;
  }
}

// Found by mutation: half of a size at the top, the other half in one of the frames.
TEST(Nerfstudio, ASizeInTwoPlacesStaysWhereItIs) {
  const std::string bytes =
      file(R"("fl_x": 500.0, "fl_y": 500.0, "cx": 320.0, "cy": 240.0, "w": 640, "k1": 0.1)", {frame(R"("h": 480)"), frame()});
  EXPECT_EQ(edited(bytes, [](Rig&) {}), bytes);
}

TEST(Nerfstudio, AnglesFollowTheFocalLength) {
  const std::string bytes = at_top(R"("camera_angle_x": 1.138, "camera_angle_y": 0.88)");
  const std::string now = edited(bytes, [](Rig& rig) { set(rig, 0, "fx", 320.0); });
  EXPECT_EQ(now, with_replaced(with_replaced(bytes, "500.0", "320.0"), "1.138", text::format_real(std::numbers::pi / 2.0)));
}

TEST(Nerfstudio, AnotherLensGetsAnotherName) {
  const std::string bytes = at_top(R"("camera_model": "OPENCV", "k1": 0.1, "k2": 0.0, "p1": 0.0, "p2": 0.0)");
  const std::string now = edited(bytes, [](Rig& rig) { rig.cameras[0].model = sample_model("kb4"); });
  EXPECT_EQ(model_info(rig_of(now).cameras.at(0).model).id, "kb4") << now;
  EXPECT_EQ(now.find("\"p1\""), std::string::npos) << "it would take k3's place in instant-ngp";
  EXPECT_TRUE(view_of("instant-ngp", now).warnings.empty()) << now;
  EXPECT_TRUE(view_of("nerfstudio", now).warnings.empty()) << now;
  EXPECT_NE(now.find("[[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"), std::string::npos) << "the pose stays";
}

TEST(Nerfstudio, WhatWasImpliedIsStatedWhenItChanges) {
  const std::string bytes = file(R"("fl_x": 500.0, "w": 640, "h": 480)", {frame()});
  const Rig rig = rig_of(edited(bytes, [](Rig& changed) {
    set(changed, 0, "fx", 510.0);
    set(changed, 0, "cy", 240.0);
  }));
  EXPECT_EQ(number_of(rig.cameras[0], "fx"), 510.0);
  EXPECT_EQ(number_of(rig.cameras[0], "fy"), 500.0);
  EXPECT_EQ(number_of(rig.cameras[0], "cx"), 319.5);
  EXPECT_EQ(number_of(rig.cameras[0], "cy"), 240.0);
}

TEST(Nerfstudio, AnEditChangesTheListThatCounts) {
  const std::string bytes = at_top(R"("distortion_params": [-0.10, 2e-2, 0, 0, 0.001, -0.002], "k2": 0.02)");
  EXPECT_EQ(edited(bytes, [](Rig&) {}), bytes);
  EXPECT_EQ(edited(bytes, [](Rig& rig) { set(rig, 0, "k1", -0.2); }), with_replaced(bytes, "-0.10", "-0.2"));
  EXPECT_EQ(edited(bytes, [](Rig& rig) { set(rig, 0, "k2", 0.03); }),
            with_replaced(with_replaced(bytes, "2e-2", "0.03"), "\"k2\": 0.02", "\"k2\": 0.03"));
  const Rig fisheye = rig_of(edited(bytes, [](Rig& rig) { rig.cameras[0].model = sample_model("kb4"); }));
  EXPECT_EQ(fisheye.cameras.at(0).model, sample_model("kb4"));
}

TEST(Nerfstudio, AListThatIsNoLongerOfAllCamerasGoesToTheFrames) {
  const std::string other = with_replaced(kNumbers, "500.0", "501.0");
  const std::string bytes = file(R"("distortion_params": [-0.1, 0.02, 0, 0, 0, 0])", {frame(kNumbers), frame(other)});
  ASSERT_EQ(rig_of(bytes).cameras.size(), 2U);
  const std::string now = edited(bytes, [](Rig& rig) { set(rig, 1, "k1", -0.3); });
  const Rig rig = rig_of(now);
  ASSERT_EQ(rig.cameras.size(), 2U) << now;
  EXPECT_EQ(number_of(rig.cameras[0], "k1"), -0.1) << now;
  EXPECT_EQ(number_of(rig.cameras[1], "k1"), -0.3) << now;
  EXPECT_EQ(number_of(rig.cameras[1], "k2"), 0.02) << now;
  EXPECT_EQ(view_of("nerfstudio", now).cameras.size(), 2U) << now;
}

TEST(Nerfstudio, FramesWithTheSameListAreOneCamera) {
  const std::string a = std::string(kNumbers) + R"(, "distortion_params": [0.1, 0, 0, 0, 0, 0])";
  const std::string b = with_replaced(a, "[0.1", "[0.2");
  const std::string bytes = file("", {frame(a), frame(b), frame(a)});
  const Rig rig = rig_of(bytes);
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(number_of(rig.cameras[1], "k1"), 0.2);
  EXPECT_EQ(view_of("nerfstudio", bytes).cameras.size(), 2U);
}

// A pinhole to instant-ngp if all were 0.
TEST(Nerfstudio, AFreshIdealFisheyeStaysOneToInstantNgp) {
  Rig rig = sample_rig("kb4", {false, false});
  for (const ParameterId id : {ParameterId("k1"), ParameterId("k2"), ParameterId("k3"), ParameterId("k4")})
    set(rig, 0, id, 0.0);
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(nerfstudio(), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  const std::string bytes = written->files.front().document.bytes();
  const consumers::ConsumerView view = view_of("instant-ngp", bytes);
  EXPECT_TRUE(view.warnings.empty()) << bytes;
  const Ray ray = {0.8, 0.3, 1.0};
  const Pixel ours = *project(rig.cameras[0].model, ray);
  EXPECT_NEAR((*view.cameras.at(0).project(ray))[0], ours[0], 2e-4);
  EXPECT_TRUE(std::ranges::any_of(written->defaults, [](const DefaultedValue& value) { return value.key.ends_with("k1"); }));
  // What stands there stays.
  const std::string base =
      at_top(R"("is_fisheye": true, "camera_model": "OPENCV_FISHEYE", "k1": 0, "k2": 0, "k3": 0, "k4": 0)");
  EXPECT_EQ(edited(base, [](Rig&) {}), base);
  const std::string resized =
      edited(base, [](Rig& smaller) { EXPECT_TRUE(set_parameter(smaller.cameras[0].model, "fx", 250.0)); });
  EXPECT_NE(resized.find("\"k1\": 0,"), std::string::npos) << resized;
}

// A list in a frame counts to nobody next to coefficients at the top; a key in a frame counts to instant-ngp alone.
TEST(Nerfstudio, AFramesCoefficientsThatContradictTheTopAreTold) {
  const auto codes = [](const std::string& top, const std::vector<std::string>& frames) {
    Parsed parsed = parse(file(std::string(kNumbers) + (top.empty() ? "" : ", ") + top, frames), kName);
    EXPECT_TRUE(parsed.document && read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
    return parsed.codes();
  };
  const std::string list = R"("distortion_params": [0.1, 0, 0, 0, 0, 0])";
  const std::string other = R"("distortion_params": [0.2, 0, 0, 0, 0, 0])";
  EXPECT_EQ(codes(list, {frame(list), frame(list)}), "");
  EXPECT_EQ(codes(list, {frame(other), frame(other)}), "duplicate-key");
  EXPECT_EQ(codes(list, {frame(list), frame(other)}), "duplicate-key");
  EXPECT_EQ(codes(R"("k1": 0.1)", {frame(other)}), "duplicate-key");
  EXPECT_EQ(codes(list, {frame(R"("k1": 0.3)")}), "duplicate-key");
  EXPECT_EQ(codes(R"("k1": 0.1)", {frame(R"("p1": 0.01)")}), "duplicate-key");
  EXPECT_EQ(codes(R"("k1": 0.1)", {frame(R"("k1": 1e-1, "p1": 0.0)")}), "");
  EXPECT_EQ(codes("", {frame(list), frame(other)}), "");
}

// What happens is of these two programs, not of those that read YAML.
TEST(Nerfstudio, AListThatContradictsKeysHasItsOwnConsequence) {
  for (const Code code : {Code::kNerfTwoValues, Code::kNerfListContradicts}) {
    EXPECT_FALSE(info(code).consequence.empty());
    EXPECT_NE(info(code).consequence, info(Code::kAnyDuplicateKey).consequence);
    EXPECT_NE(info(code).consequence.find("instant-ngp"), std::string_view::npos);
  }
}

// ---------------------------------------------------------------- the loaders

TEST(NerfLoaders, OnlyNerfstudioReadsTheList) {
  const std::string bytes = at_top(R"("distortion_params": [-0.1, 0.02, 0, 0, 0, 0])");
  EXPECT_TRUE(view_of("nerfstudio", bytes).warnings.empty());
  for (const char* program : {"instant-ngp", "lichtfeld"}) {
    const consumers::ConsumerView view = view_of(program, bytes);
    EXPECT_EQ(codes_of(view.warnings), std::vector{Code::kNerfSaysListNotRead}) << program;
    EXPECT_TRUE(view.cameras.at(0).misread) << program;
  }
  const std::string four = at_top(R"("distortion_params": [-0.1, 0.02, 0, 0])");
  EXPECT_EQ(codes_of(view_of("nerfstudio", four).refusals), std::vector{Code::kNerfSaysNoList});
}

// float(meta["fl_x"]) against nlohmann's numbers.
TEST(NerfLoaders, PythonReadsNumbersInQuotes) {
  const std::string bytes = with_replaced(at_top(R"("k1": " -1e-1 ")"), "500.0", "\"500.0\"");
  const consumers::ConsumerView view = view_of("nerfstudio", bytes);
  ASSERT_EQ(view.cameras.size(), 1U);
  EXPECT_NEAR((*view.cameras[0].project({1.0, 0.0, 1.0}))[0], 500.0 * 0.9 + 320.5, 2e-4);
  EXPECT_FALSE(view_of("instant-ngp", bytes).loads());
  for (const char* wrong : {"\"wide\"", "\"0x10\"", "\"\"", "\"1 2\"", "[500]"})
    EXPECT_FALSE(view_of("nerfstudio", with_replaced(bytes, "\"500.0\"", wrong)).loads()) << wrong;
}

TEST(NerfLoaders, ABomIsNoLineOfColmaps) {
  const std::string bytes = "\xEF\xBB\xBF" + at_top(R"("camera_angle_x": 1.0)");
  EXPECT_EQ(codes_of(view_of("3dgrut", bytes).refusals), std::vector{Code::kPythonJsonBom});
  EXPECT_EQ(codes_of(view_of("nerfstudio", bytes).refusals), std::vector{Code::kPythonJsonBom});
  EXPECT_TRUE(view_of("lichtfeld", bytes).loads());
  EXPECT_TRUE(view_of("instant-ngp", bytes).loads());
}

TEST(NerfLoaders, InstantNgpLosesK3AndK4WhereP1AndP2Stand) {
  const std::string fisheye =
      R"("is_fisheye": true, "camera_model": "OPENCV_FISHEYE", "k1": 0.1, "k2": 0.0, "k3": 0.5, "k4": 0.1)";
  EXPECT_TRUE(view_of("instant-ngp", at_top(fisheye)).warnings.empty());
  const consumers::ConsumerView view = view_of("instant-ngp", at_top(fisheye + R"(, "p1": 0, "p2": 0)"));
  EXPECT_EQ(codes_of(view.warnings), std::vector{Code::kNerfSaysSlots});
  EXPECT_TRUE(view.cameras.at(0).misread);
  EXPECT_TRUE(view_of("nerfstudio", at_top(fisheye + R"(, "p1": 0, "p2": 0)")).warnings.empty());
}

TEST(NerfLoaders, InstantNgpTakesAnIdealFisheyeForAPinhole) {
  const std::string bytes =
      at_top(R"("is_fisheye": true, "camera_model": "OPENCV_FISHEYE", "k1": 0, "k2": 0, "k3": 0, "k4": 0)");
  const consumers::ConsumerView view = view_of("instant-ngp", bytes);
  EXPECT_EQ(codes_of(view.warnings), std::vector{Code::kNerfSaysNoLens});
  EXPECT_NEAR((*view.cameras.at(0).project({1.0, 0.0, 1.0}))[0], 500.0 + 320.5, 2e-4);
  EXPECT_NEAR((*view_of("nerfstudio", bytes).cameras.at(0).project({1.0, 0.0, 1.0}))[0], 500.0 * std::numbers::pi / 4.0 + 320.5,
              2e-4);
}

TEST(NerfLoaders, EachGoesByItsOwnWordForAFisheye) {
  const std::string lens = R"("k1": 0.1, "k2": 0.01, "k3": 0.01, "k4": 0.01)";
  EXPECT_EQ(codes_of(view_of("nerfstudio", at_top(R"("is_fisheye": true, )" + lens)).warnings),
            std::vector{Code::kNerfSaysTakenForPerspective});
  EXPECT_EQ(codes_of(view_of("instant-ngp", at_top(R"("camera_model": "OPENCV_FISHEYE", )" + lens)).warnings),
            std::vector{Code::kNerfSaysTakenForPerspective});
  EXPECT_EQ(codes_of(view_of("lichtfeld", at_top(R"("camera_model": "OPENCV_FISHEYE", )" + lens)).warnings),
            std::vector{Code::kNerfSaysPinhole});
}

TEST(NerfLoaders, TheyRefuseWhatTheirSourcesDo) {
  const std::string no_centre = file(R"("fl_x": 500.0, "fl_y": 500.0, "w": 640, "h": 480)", {frame()});
  EXPECT_EQ(codes_of(view_of("nerfstudio", no_centre).refusals).at(0), Code::kNerfSaysLacks);
  EXPECT_TRUE(view_of("instant-ngp", no_centre).loads());
  EXPECT_TRUE(view_of("lichtfeld", no_centre).loads());
  const std::string centre_in_frame =
      file(R"("fl_x": 500.0, "fl_y": 500.0, "w": 640, "h": 480)", {frame(R"("cx": 320, "cy": 240)")});
  EXPECT_TRUE(view_of("nerfstudio", centre_in_frame).loads());
  EXPECT_EQ(codes_of(view_of("instant-ngp", centre_in_frame).refusals).at(0), Code::kNerfSaysCentreAlone);
  for (const char* program : {"nerfstudio", "instant-ngp", "lichtfeld", "3dgrut"}) {
    EXPECT_FALSE(view_of(program, file(kNumbers, {})).loads()) << program;
    EXPECT_FALSE(view_of(program, "{").loads()) << program;
    EXPECT_FALSE(view_of(program, "{\"frames\": [7]}").loads()) << program;
  }
  EXPECT_FALSE(view_of("lichtfeld", file(R"("fl_x": 500.0, "w": 640, "h": 480)", {frame()})).loads()) << "no fl_y, no square";
  EXPECT_FALSE(view_of("3dgrut", at_top(R"("k1": 0.0)")).loads()) << "no camera_angle_x";
  EXPECT_TRUE(view_of("3dgrut", at_top(R"("camera_angle_x": 1.0)")).cameras.at(0).misread);
}

TEST(NerfLoaders, TrainersOfSplatsTakeSomeOfColmapsCameras) {
  const auto line = [](const char* words) { return "1 " + std::string(words) + "\n"; };
  struct Row {
    const char* words;
    bool gsplat, grut, lichtfeld, nerfstudio;
  };
  const std::array rows = {Row{"OPENCV 640 480 500 510 321 239 -0.1 0.02 0 0", true, true, true, true},
                           Row{"OPENCV_FISHEYE 640 480 500 510 321 239 -0.1 0.02 0 0", true, true, true, true},
                           Row{"FULL_OPENCV 640 480 500 510 321 239 -0.1 0.02 0 0 0 0 0 0", false, true, true, false},
                           Row{"RADIAL_FISHEYE 640 480 500 321 239 -0.1 0.02", false, false, true, true},
                           Row{"FOV 640 480 500 510 321 239 0.9", false, false, false, false},
                           Row{"EUCM 640 480 500 510 321 239 0.6 1.1", false, false, false, false}};
  for (const Row& row : rows) {
    EXPECT_EQ(view_of("gsplat", line(row.words)).loads(), row.gsplat) << row.words;
    EXPECT_EQ(view_of("3dgrut", line(row.words)).loads(), row.grut) << row.words;
    EXPECT_EQ(view_of("lichtfeld", line(row.words)).loads(), row.lichtfeld) << row.words;
    EXPECT_EQ(view_of("nerfstudio", line(row.words)).loads(), row.nerfstudio) << row.words;
    // colmap2nerf.py goes on with a pinhole.
    const consumers::ConsumerView ngp = view_of("instant-ngp", line(row.words));
    ASSERT_TRUE(ngp.loads()) << row.words;
    EXPECT_EQ(ngp.cameras.at(0).misread, !row.nerfstudio) << row.words;
    if (row.nerfstudio) continue;
    EXPECT_NEAR((*ngp.cameras.at(0).project({0.5, 0.0, 1.0}))[0], 250.0 + 320.0 - 0.5, 2e-4) << row.words;
  }
}

// ncore's cameras: the factor of the radius lies between 0.8 and 1.2.
TEST(NerfLoaders, TheBorderOfAWideLensIsNoneTo3dgrut) {
  const auto sees = [](const char* words, double x) {
    return view_of("3dgrut", "1 " + std::string(words) + "\n").cameras.at(0).project({x, 0.0, 1.0}).has_value();
  };
  for (const char* words : {"OPENCV 640 480 500 500 320 240 -0.25 0 0 0", "SIMPLE_RADIAL 640 480 500 320 240 -0.25",
                            "FULL_OPENCV 640 480 500 500 320 240 0 0 0 0 0 0.25 0 0"}) {
    EXPECT_TRUE(sees(words, 0.85)) << words;
    EXPECT_FALSE(sees(words, 1.05)) << words;
  }
  EXPECT_TRUE(sees("OPENCV_FISHEYE 640 480 200 200 320 240 -0.25 0 0 0", 1.05));
}

// ---------------------------------------------------------------- the corpus

/// As a person reads it in the file.
struct Expected {
  const char* file;
  std::size_t cameras;
  const char* model;
  double fx;
  ImageSize size;
  double x;  ///< transform_matrix[0][3] of the first frame.
};

constexpr std::array kExpected = {
    Expected{"5697526__NeRF-TensoRF__TensoRF__data__transforms_test.json",
             1,
             "radtan",
             1831.9143095815152,
             {1080, 1920},
             -3.2532250525667323},
    Expected{"5697526__NeRF-TensoRF__transforms.json", 1, "radtan", 1831.9143095815152, {1080, 1920}, 3.004888283390566},
    Expected{"AspasZhang__NeRF__transforms_test.json", 1, "radtan", 1144.3995434592434, {1280, 720}, 3.045357110804678},
    Expected{"HexGP__nerf-prep__data_b__transforms.json", 1, "radtan", 1638.6417191904297, {1080, 1920}, 4.006016012849056},
    Expected{"HexGP__nerf-prep__transforms.json", 1, "radtan", 1027.7879529283434, {1080, 1920}, 3.7765586054440345},
    Expected{"NVlabs__instant-ngp__data__nerf__fox__transforms.json", 1, "radtan", 1375.52, {1080, 1920}, 3.168359405609479},
    // f1_x in place of fl_x: every program goes by camera_angle_x, which the file has of the image's height.
    Expected{"SeppeJ__instantngp__alpha__transforms.json", 7, "pinhole", 1927.7861402604726, {1920, 1080}, 215.23582324206086},
    Expected{"SeppeJ__instantngp__alphaundistorted__transforms.json",
             7,
             "pinhole",
             1295.494582104714,
             {1920, 1080},
             215.23582324206086},
    Expected{"hl-qiu__processData__transforms.json", 1, "pinhole", 166503.90624999997, {1024, 1024}, 0.24452},
    Expected{"sangminkim-99__COLMAP_multicam__transforms.json", 2, "radtan", 608.562030830161, {640, 480}, 0.4889635490753941},
    Expected{"yanhanruan__nerf-process-scripts__backup__transforms.json",
             1,
             "radtan",
             1545.923249064969,
             {1920, 1080},
             1.1815649215719275},
    Expected{
        "yanhanruan__nerf-process-scripts__transforms.json", 1, "radtan", 1545.923249064969, {1920, 1080}, 1.1815649215719275},
};

/// The first frame's element of that row and the last column.
std::string translation_in(const text::Document& document, std::size_t row) {
  const text::Node* frames = text::find(document.root(), "frames", text::Dialect::kPyYaml);
  return text::find(frames->items.at(0), "transform_matrix", text::Dialect::kPyYaml)->items.at(row).items.at(3).value;
}

TEST(Nerfstudio, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "transforms_json";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const std::string bytes = read_file(corpus / expected.file);
    const Calibration calibration = calibration_of(bytes, expected.file);
    Rig rig = calibration.rig;
    ASSERT_EQ(rig.cameras.size(), expected.cameras);
    const Camera& camera = rig.cameras.front();
    EXPECT_EQ(model_info(camera.model).id, expected.model);
    EXPECT_NEAR(number_of(camera, "fx"), expected.fx, 1e-9 * expected.fx);
    EXPECT_EQ(camera.image_size, expected.size);
    EXPECT_EQ(translation_in(calibration.documents.front(), 0), text::format_real(expected.x));
    const text::Document base = document_of(bytes, expected.file);
    EXPECT_EQ(written_bytes(rig, &base), bytes);
    // Another lens goes in, and every image keeps its pose.
    set(rig, 0, "cx", 333.25);
    const text::Document after = document_of(written_bytes(rig, &base), expected.file);
    EXPECT_EQ(number_of(calibration_of(after.source().bytes, expected.file).rig.cameras.front(), "cx"), 333.25);
    for (const std::size_t row : {0, 1, 2}) EXPECT_EQ(translation_in(after, row), translation_in(base, row));
    EXPECT_TRUE(view_of("instant-ngp", bytes).loads());
  }
  EXPECT_EQ(files_in(corpus).size(), kExpected.size());
}

// The size that the user had to say to read the base does not cost it its images.
TEST(Nerfstudio, ABaseWithoutASizeKeepsItsImages) {
  const std::string bytes =
      "{\"camera_angle_x\": 0.69, \"frames\": [{\"file_path\": \"a\", \"transform_matrix\": "
      "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 4], [0, 0, 0, 1]]}]}\n";
  ReadOptions options;
  options.image_size = ImageSize{800, 800};
  Diagnostics diagnostics;
  const text::Document base = document_of(bytes, "transforms.json");
  const std::optional<Calibration> calibration = read_calibration({base}, nullptr, options, diagnostics);
  ASSERT_TRUE(calibration);
  const std::optional<Written> written =
      write_calibration(*find_format("nerfstudio"), &base, calibration->rig, {}, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->files.front().document.bytes(), bytes);
}

}  // namespace
}  // namespace fca::test
