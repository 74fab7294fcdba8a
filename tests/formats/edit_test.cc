// SPDX-License-Identifier: BSD-3-Clause
// Writing a rig over the file it came from changes what differs and no other byte.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <cmath>

namespace fca::test {
namespace {

std::string written_over(const Calibration& base, const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written = base.format->write(&base.documents.front(), rig, {}, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? written->files.front().document.bytes() : "";
}

struct Case {
  const char* file;
  const char* spelling;  ///< The number as the file spells it; must stand there once.
  std::size_t camera;
  ParameterId parameter;
};

constexpr Case kCases[] = {
    {"kalibr/good/tumvi.yaml", "190.9733070521226", 0, "fy"},
    {"kalibr/good/tumvi.yaml", "0.00020293673591811182", 0, "k4"},  // on a continuation line
    {"kalibr/good/tumvi.yaml", "-0.00266312569781606", 1, "k3"},
    {"kalibr/good/crlf.yaml", "254.93170605935475", 0, "cx"},
    {"kalibr/good/crlf.yaml", "0.0003299517423931039", 1, "k4"},
    {"kalibr/good/block-style.yaml", "+460.152", 0, "fy"},
    {"kalibr/good/block-style.yaml", "3.62680e+02", 0, "cx"},
    {"kalibr/good/block-style.yaml", "0.00011556", 0, "p2"},
    {"kalibr/good/bom-latin1.yaml", "379.5", 0, "fy"},
    {"kalibr/good/omni.yaml", "749.25", 0, "fy"},
    {"kalibr/good/opencv-header.yaml", "1.76187114e-05", 0, "p2"},
    {"orbslam3/good/v1-stereo-inertial.yaml", "0.0034823894022493434", 0, "k1"},
    {"orbslam3/good/v1-stereo-inertial.yaml", "254.91723064636983", 1, "cy"},
    {"orbslam3/good/v1-pinhole.yaml", "0.07395907", 0, "k2"},
    {"orbslam3/good/v1-pinhole.yaml", "-1.5e-3", 0, "k3"},
    {"orbslam3/good/orbslam2-tight.yaml", "516.469215", 0, "fy"},
    {"orbslam3/good/orbslam2-tight.yaml", "0.262383", 0, "k1"},
    {"orbslam3/good/crlf.yaml", "318.643040", 0, "cx"},
    {"orbslam3/good/old-doublesphere.yaml", "-0.17213086034353243", 0, "xi"},
    {"orbslam3/good/slam-no-opt-eucm.yaml", "1.0418067381860868", 0, "beta"},
};

TEST(Edit, OneIntrinsicChangesItsOwnBytesOnly) {
  for (const Case& row : kCases) {
    SCOPED_TRACE(std::string(row.file) + " " + std::string(row.parameter.name()));
    const std::string bytes = read_file(testdata_dir() / row.file);
    const Calibration calibration = calibration_of(bytes);
    Rig rig = calibration.rig;
    const double changed = parameter(rig.cameras.at(row.camera).model, row.parameter).value() + 0.125;
    ASSERT_TRUE(set_parameter(rig.cameras[row.camera].model, row.parameter, changed));
    EXPECT_EQ(written_over(calibration, rig), with_replaced(bytes, row.spelling, text::format_real(changed)));
  }
}

// A number that is spelled otherwise than we would is left alone when its value is the same.
TEST(Edit, OtherSpellingsOfTheSameNumbersStay) {
  const std::string bytes = read_file(testdata_dir() / "kalibr/good/block-style.yaml");
  const Calibration calibration = calibration_of(bytes);
  Rig rig = calibration.rig;
  set_parameter(rig.cameras[0].model, "cy", 250.5);
  const std::string result = written_over(calibration, rig);
  EXPECT_EQ(result, with_replaced(bytes, "246.049", "250.5"));
}

TEST(Edit, ASecondEditUndoesTheFirst) {
  const std::string bytes = read_file(testdata_dir() / "kalibr/good/tumvi.yaml");
  const Calibration calibration = calibration_of(bytes);
  Rig rig = calibration.rig;
  set_parameter(rig.cameras[1].model, "fx", 200.0);
  const Calibration changed = calibration_of(written_over(calibration, rig));
  EXPECT_EQ(written_over(changed, calibration.rig), bytes);
}

/// Everything a base may be asked to say again: the result reads as the rig that was requested.
struct Change {
  const char* what;
  void (*apply)(Rig& rig);
};

const Change kChanges[] = {
    {"a time offset appears or changes", [](Rig& rig) { rig.cameras[0].time_offset_s = 0.0125; }},
    {"the time offset vanishes", [](Rig& rig) { rig.cameras[0].time_offset_s.reset(); }},
    {"a topic appears or changes", [](Rig& rig) { rig.cameras[0].topic = "/front/image"; }},
    {"the topic vanishes", [](Rig& rig) { rig.cameras[0].topic.clear(); }},
    {"the size changes",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras) camera.image_size = ImageSize{320, 200};
     }},
    {"every parameter changes",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras) {
         for (const Parameter& each : model_info(camera.model).parameters) {
           const bool stored =
               each.name != "k3" || model_info(camera.model).id != "radtan";  // Kalibr has none (FORMATS.md 1.1)
           if (stored)
             set_parameter(camera.model, ParameterId(each), parameter(camera.model, ParameterId(each)).value() + 0.015625);
         }
       }
     }},
    {"the model changes",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras) camera.model = sample_model("kb4");
     }},
    {"the model changes to one with fewer numbers",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras) camera.model = sample_model("eucm");
     }},
};

TEST(Edit, KalibrFilesSayWhatTheyWereAskedToSay) {
  for (const fs::path& path : files_in(testdata_dir() / "kalibr" / "good", ".yaml")) {
    const Calibration calibration = calibration_of(read_file(path));
    if (calibration.rig.cameras.empty()) continue;
    for (const Change& change : kChanges) {
      SCOPED_TRACE(path.filename().string() + ": " + change.what);
      Rig rig = calibration.rig;
      change.apply(rig);
      const std::string bytes = written_over(calibration, rig);
      Parsed parsed = parse(bytes);
      EXPECT_TRUE(parsed.document) << parsed.rendered() << bytes;
      if (!parsed.document) continue;
      const std::optional<Calibration> back = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
      EXPECT_TRUE(back) << parsed.rendered() << bytes;
      if (!back) continue;
      EXPECT_TRUE(back->rig.cameras == rig.cameras) << bytes;
      EXPECT_TRUE(back->rig.poses == rig.poses) << bytes;
    }
  }
}

TEST(Edit, PosesOfAKalibrFile) {
  for (const fs::path& path : files_in(testdata_dir() / "kalibr" / "good", ".yaml")) {
    const Calibration calibration = calibration_of(read_file(path));
    Rig rig = calibration.rig;
    if (rig.cameras.empty() || rig.poses.empty()) continue;
    SCOPED_TRACE(path);
    // All of it moves with the IMU: T_cam_imu changes, the chain does not.
    Transform T_imu_imu;
    T_imu_imu(0, 3) = 0.5;
    T_imu_imu(2, 3) = -0.25;
    for (PoseEdge& edge : rig.poses) {
      if (edge.b == "imu0") edge.T_a_b = edge.T_a_b * T_imu_imu;
      if (edge.a == "imu0") edge.T_a_b = inverse(T_imu_imu).value() * edge.T_a_b;
    }
    const Rig back = calibration_of(written_over(calibration, rig)).rig;
    for (const Camera& camera : rig.cameras) {
      if (!rig.resolve(camera.name, "imu0")) continue;
      ASSERT_TRUE(back.resolve(camera.name, "imu0"));
      EXPECT_LE(element_difference(*back.resolve(camera.name, "imu0"), *rig.resolve(camera.name, "imu0")), 1e-12)
          << camera.name;
    }
  }
}

TEST(Edit, OrbSlam3FilesSayWhatTheyWereAskedToSay) {
  for (const fs::path& path : files_in(testdata_dir() / "orbslam3" / "good", ".yaml")) {
    const Calibration calibration = calibration_of(read_file(path));
    for (const double scale : {0.5, 2.0}) {
      SCOPED_TRACE(path.filename());
      Rig rig = calibration.rig;
      for (Camera& camera : rig.cameras) {
        for (const ParameterId name : ParameterIds{"fx", "fy", "cx", "cy"})
          set_parameter(camera.model, name, parameter(camera.model, name).value() * scale);
        camera.image_size =
            ImageSize{static_cast<int>(camera.image_size->width * scale), static_cast<int>(camera.image_size->height * scale)};
        camera.frame_rate_hz = 15.0;
      }
      if (!rig.imus.empty()) rig.imus[0].rate_hz = 400.0;
      const std::string bytes = written_over(calibration, rig);
      const Rig back = calibration_of(bytes).rig;
      EXPECT_TRUE(back.cameras == rig.cameras) << bytes;
      EXPECT_TRUE(back.imus == rig.imus) << bytes;
      EXPECT_TRUE(back.poses == rig.poses) << bytes;
      EXPECT_EQ(document_of(bytes).syntax(), text::Syntax::kOpenCvYaml);
      const bool crlf = read_file(path).find("\r\n") != std::string::npos;
      const auto breaks = std::ranges::count(bytes, '\n');
      EXPECT_EQ(std::ranges::count(bytes, '\r'), crlf ? breaks : 0) << "line breaks of another kind";
    }
  }
}

// A V1.0 file is read by a parser with strict types: an edit must not turn a real into an int or a quoted string into a bare
// one.
TEST(Edit, EditedSettingsStayLoadable) {
  const std::string bytes = read_file(testdata_dir() / "orbslam3/good/v1-stereo-inertial.yaml");
  const Calibration calibration = calibration_of(bytes);
  Rig rig = calibration.rig;
  for (Camera& camera : rig.cameras) {
    for (double& value : parameter_values(camera.model)) value = std::round(value);
    camera.frame_rate_hz = 30.0;
  }
  rig.imus[0].rate_hz = 100.0;
  rig.imus[0].gyroscope_noise_density = 1.0;
  rig.poses.front().T_a_b = Transform{};
  const std::string edited = written_over(calibration, rig);
  const consumers::ConsumerView view = consumers::find_consumer("orbslam3")->load(edited, {"stereo-inertial"});
  EXPECT_TRUE(view.loads()) << (view.refusals.empty() ? "" : sentence_of(view.refusals.front())) << "\n" << edited;
}

}  // namespace
}  // namespace fca::test
