// SPDX-License-Identifier: BSD-3-Clause
// Files whose meaning a check once took for another: each is written here, and what is found of it holds.
#include "check_files.h"

#include <fca/code.h>

namespace fca::test {
namespace {

CheckReport checked_as(const std::string& name, const std::string& bytes) { return checked(text::Source{name, bytes}); }

std::string radtan_camera(const std::string& intrinsics, const std::string& coefficients) {
  return "cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n  intrinsics: [" + intrinsics +
         "]\n  distortion_coeffs: [" + coefficients + "]\n  resolution: [752, 480]\n  rostopic: /cam0/image_raw\n";
}

/// ORB-SLAM3's settings of rectified images.
const std::string kRectified =
    "%YAML:1.0\n"
    "File.version: \"1.0\"\n"
    "Camera.type: \"Rectified\"\n"
    "Camera1.fx: 458.5\nCamera1.fy: 458.5\nCamera1.cx: 367.25\nCamera1.cy: 248.5\n"
    "Camera1.k1: 0.1\n"
    "Camera.width: 752\nCamera.height: 480\nCamera.fps: 20\nCamera.RGB: 1\n"
    "Stereo.ThDepth: 40.0\nStereo.b: 0.11\n"
    "ORBextractor.nFeatures: 1200\nORBextractor.scaleFactor: 1.2\nORBextractor.nLevels: 8\n"
    "ORBextractor.iniThFAST: 20\nORBextractor.minThFAST: 7\n"
    "Viewer.KeyFrameSize: 0.05\nViewer.KeyFrameLineWidth: 1.0\nViewer.GraphLineWidth: 0.9\nViewer.PointSize: 2.0\n"
    "Viewer.CameraSize: 0.08\nViewer.CameraLineWidth: 3.0\nViewer.ViewpointX: 0.0\nViewer.ViewpointY: -0.7\n"
    "Viewer.ViewpointZ: -1.8\nViewer.ViewpointF: 500.0\n";

// A number in quotes is no number to the program, which only stops complaining.
TEST(Fixes, HideNoNumberThatIsOnlyIgnored) {
  const CheckReport report = checked_as("rectified.yaml", kRectified);
  ASSERT_FALSE(report.findings.empty());
  for (const Finding& finding : report.findings) EXPECT_FALSE(finding.edit) << message_of(finding);
}

/// A matrix of cv::FileStorage.
std::string matrix(const std::string& name, int rows, int columns, const std::string& numbers) {
  return name + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(columns) +
         "\n   dt: d\n   data: [ " + numbers + " ]\n";
}

const std::string kCamera = matrix("camera_matrix", 3, 3, "305.1, 0., 480.2, 0., 305.9, 270.3, 0., 0., 1.");

// Its program calls cv::fisheye: the reader and the imitated program both know it by the other keys.
TEST(SurroundView, IsProvenAsTheFisheyeThatItIsReadAs) {
  const CheckReport report =
      checked_as("front.yaml", "%YAML:1.0\n" + kCamera + matrix("dist_coeffs", 4, 1, "-0.04, -0.015, 0.008, -0.002") +
                                   matrix("project_matrix", 3, 3, "-0.7, -1.8, 1100., 0.001, -1.5, 800., 0., -0.003, 1.") +
                                   matrix("scale_xy", 2, 1, "0.7, 0.8") + matrix("shift_xy", 2, 1, "-150., -100.") +
                                   matrix("resolution", 2, 1, "960., 540."));
  ASSERT_TRUE(report.proof);
  EXPECT_TRUE(report.proof->agrees());
  EXPECT_NE(report.verdict.word, VerdictWord::kDoNotUse);
}

// The word of the caller is about four numbers.
TEST(FiveCoefficients, AreThoseOfProjectPointsWhateverTheCallerSays) {
  CheckOptions options;
  options.reading.opencv_model = OpenCvModel::kFisheye;
  const text::Source source = {"five.yml", "%YAML:1.0\nimage_width: 960\nimage_height: 540\n" + kCamera +
                                               matrix("distortion_coefficients", 1, 5, "-0.28, 0.07, 0.0002, 0.00002, 0.01")};
  const CheckReport report = checked(source, options);
  EXPECT_FALSE(report.has(Severity::kError));
  ASSERT_TRUE(report.proof);
  EXPECT_TRUE(report.proof->agrees());
}

// MEI's numbers without their xi: those of eleven real cameras with an xi above 3 look so.
TEST(MeiUnderRadtan, IsRecognisedByItsLargeCoefficients) {
  EXPECT_TRUE(says(checked_as("c.yaml", radtan_camera("2138.7, 2137.2, 357.2, 250.1", "1.176, 15.49, -0.0007, 0.000004")),
                   "wrong-family"));
  EXPECT_FALSE(
      says(checked_as("c.yaml", radtan_camera("458.654, 457.296, 367.215, 248.375", "-0.283, 0.0739, 0.0002, 0.00002")),
           "wrong-family"));
}

// A lens that fills the image does not end inside its largest centred circle, whatever the model.
TEST(Folds, InsideTheCircleAreErrorsOfEveryModel) {
  const CheckReport report =
      checked_as("c.yaml",
                 "cam0:\n  camera_model: pinhole\n  distortion_model: equidistant\n  intrinsics: [300.0, 300.0, 320.0, 240.0]\n"
                 "  distortion_coeffs: [-0.5, 0.0, 0.0, 0.0]\n  resolution: [640, 480]\n  rostopic: /cam0/image_raw\n");
  const auto fold =
      std::ranges::find_if(report.findings, [](const Finding& finding) { return id_of(finding) == "folds-inside-image"; });
  ASSERT_NE(fold, report.findings.end());
  EXPECT_EQ(fold->severity, Severity::kError);
}

const std::string kFlat =
    "  T_cam_imu: [1.0, 0.0, 0.0, 0.1, 0.0, 1.0, 0.0, 0.0,\n    0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]\n";

// msckf_vio's: the fix puts the brackets in, and changes nothing else.
TEST(FlatPose, GetsItsRows) {
  const text::Source source = {"chain.yaml",
                               radtan_camera("458.654, 457.296, 367.215, 248.375", "-0.283, 0.0739, 0.0, 0.0") + kFlat};
  const CheckReport report = checked(source);
  const auto flat = std::ranges::find_if(report.findings, [](const Finding& finding) { return finding.edit.has_value(); });
  ASSERT_NE(flat, report.findings.end());
  std::string bytes = source.bytes;
  bytes.replace(flat->edit->span.offset, flat->edit->span.length, flat->edit->text);
  EXPECT_TRUE(checked(text::Source{"chain.yaml", bytes}).findings.empty());
  EXPECT_EQ(*rig_of({"chain.yaml", bytes}), *rig_of(source));
  std::erase_if(bytes, [](char c) { return c == '[' || c == ']'; });
  std::string flat_bytes = source.bytes;
  std::erase_if(flat_bytes, [](char c) { return c == '[' || c == ']'; });
  EXPECT_EQ(bytes, flat_bytes);
}

/// What a message's clauses name: "did you mean {0} ... {1}".
std::vector<std::string> names_in(const Message& message) {
  std::vector<std::string> names;
  for (const Argument& argument : message.arguments) {
    if (const auto* name = std::get_if<std::string>(&argument.value)) names.push_back(*name);
    if (const auto* list = std::get_if<std::vector<std::string>>(&argument.value))
      names.insert(names.end(), list->begin(), list->end());
  }
  return names;
}

/// The names that are proposed for those two of a camera.
std::vector<std::string> proposed(const std::string& camera_model, const std::string& distortion_model) {
  const CheckReport report =
      checked_as("chain.yaml", "cam0:\n  camera_model: " + camera_model + "\n  distortion_model: " + distortion_model +
                                   "\n  intrinsics: [458.6, 457.2, 367.2, 248.3]\n  distortion_coeffs: [-0.2, 0.07, 0.0, 0.0]\n"
                                   "  resolution: [752, 480]\n  rostopic: /cam0/image_raw\n");
  for (const Finding& finding : report.findings) {
    if (id_of(finding) != "unknown-model" || finding.facts.arguments.size() < 4) continue;
    const auto* clauses = std::get_if<std::vector<Message>>(&finding.facts.arguments[3].value);
    if (clauses != nullptr && !clauses->empty()) return names_in(clauses->front());
  }
  return {};
}

TEST(UnknownModel, IsComparedPartByPart) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(proposed("pinhole/radial", "radial"), (Names{"pinhole", "radtan"}));
  EXPECT_EQ(proposed("onmi/radial", "radial"), (Names{"omni", "radtan"}));
  EXPECT_EQ(proposed("pinhole-equidistent", "none"), (Names{"pinhole", "equidistant"}));
  EXPECT_EQ(proposed("omni", "radtn"), (Names{"omni", "radtan"}));
  EXPECT_EQ(proposed("pinhole", "equi"), (Names{"pinhole", "equidistant"}));
  EXPECT_EQ(proposed("lightfield", "none"), Names{});
}

const std::string kMessage =
    "header:\n  seq: 12\n  frame_id: \"camera\"\nheight: 480\nwidth: 640\ndistortion_model: \"plumb_bob\"\n"
    "D: [0.1, -0.2, 0.001, 0.0002, 0.0]\nK: [615.1, 0.0, 320.2, 0.0, 615.3, 240.1, 0.0, 0.0, 1.0]\n"
    "R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\n"
    "P: [615.1, 0.0, 320.2, 0.0, 0.0, 615.3, 240.1, 0.0, 0.0, 0.0, 1.0, 0.0]\n";

TEST(RosMessages, AreToldApartFromOtherDocuments) {
  EXPECT_TRUE(rig_of({"echo.txt", kMessage + "---\n"}));
  const CheckReport report = checked_as("echo.txt", kMessage + "---\n" + kMessage + "---\n");
  ASSERT_FALSE(report.findings.empty());
  EXPECT_EQ(report.findings.front().facts.code, Code::kYamlMessages);
}

TEST(ForeignFiles, AreNotOfTheFormatThatTheyResemble) {
  const CheckReport d2slam =
      checked_as("d2slam.yaml",
                 "%YAML:1.0\nimu: 1\nnum_of_cam: 2\ncam0_calib: \"cam0.yaml\"\ncam1_calib: \"cam1.yaml\"\n"
                 "image_width: 752\nimage_height: 480\nestimation_mode: 1\nself_id: 1\n");
  EXPECT_FALSE(d2slam.is_calibration);
  EXPECT_TRUE(says(d2slam, "unknown-format"));
  EXPECT_FALSE(checked_as("notes.txt", "#polynomial coefficients\nsome text\n").is_calibration);
}

}  // namespace
}  // namespace fca::test
