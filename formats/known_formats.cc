// SPDX-License-Identifier: BSD-3-Clause
#include "known_formats.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace fca {

namespace {

/// A program's file, and two words that stand in it, and together in no other that is known. The rows are tried in this order.
struct Known {
  Code what;
  std::string_view word;
  std::string_view second_word;
  bool has_no_syntax = false;  ///< It is neither YAML, JSON, lines of words nor OpenCV's XML, or may be too long for fca-io.
  bool may_go_on = false;      ///< `word` is the beginning of one.
};

constexpr std::array kKnown = {
    Known{Code::kLooksLikeMultiCol, "Camera.nrpol", "Camera.nrinvpol"},
    Known{Code::kLooksLikeMultiColRig, "CameraSystem.nrCams", "CameraSystem.cam1_1"},
    Known{Code::kLooksLikeOv2Slam, "Camera.fxl", "Camera.model_left"},
    Known{Code::kLooksLikeD2Slam, "estimation_mode", "self_id"},
    Known{Code::kLooksLikeD2Slam, "estimation_mode", "double_counting_common_feature"},
    Known{Code::kLooksLikeLarvio, "T_cam_imu", "if_FEJ"},
    Known{Code::kLooksLikeFastLivoPoses, "extrin_calib", "Pcl"},
    Known{Code::kLooksLikeFastLivoPoses, "Rcl", "Pcl"},
    Known{Code::kLooksLikeCuvslamRig, "stereo_cameras", "left_camera"},
    Known{Code::kLooksLikeCuvslamRig, "rgb_camera", "depth_camera"},
    Known{Code::kLooksLikeAria, "CameraCalibrations", "Projection"},
    Known{Code::kLooksLikeWmr, "CalibrationInformation", "ModelParameters"},
    Known{Code::kLooksLikeDriveWorks, "rig", "bw-poly"},
    Known{Code::kLooksLikeDriveWorks, "rig", "pixeldistance-to-angle"},
    Known{Code::kLooksLikeDriveWorksForward, "rig", "angle-to-pixeldistance"},
    Known{Code::kLooksLikeIsaac, "OmniLensDistortionFthetaAPI", "Camera", true},
    Known{Code::kLooksLikeIsaacOpenCv, "OmniLensDistortionOpenCvPinholeAPI", "Camera", true},
    Known{Code::kLooksLikeIsaacOpenCv, "OmniLensDistortionOpenCvFisheyeAPI", "Camera", true},
    Known{Code::kLooksLikeIsaacLens, "OmniLensDistortion", "Camera", true, true},
    Known{Code::kLooksLikeIsaac, "cameraProjectionType", "Camera", true},
    Known{Code::kLooksLikeEdex, "distortion_params", "principal"},
    Known{Code::kLooksLikeSpectacular, "focalLengthX", "imuToCamera"},
    Known{Code::kLooksLikeMatlabPrint, "cameraParameters", "with properties:", true},
    Known{Code::kLooksLikeMatlabPrint, "cameraIntrinsics", "with properties:", true},
    Known{Code::kLooksLikeMatlabPrint, "fisheyeParameters", "with properties:", true},
    Known{Code::kLooksLikeMatlabPrint, "fisheyeIntrinsics", "with properties:", true},
    Known{Code::kLooksLikeMatlab, "RadialDistortion", "IntrinsicMatrix"},
    Known{Code::kLooksLikeMatlab, "RadialDistortion", "ImageSize"},
    Known{Code::kLooksLikeMatlabFisheye, "MappingCoefficients", "DistortionCenter"},
    Known{Code::kLooksLikeAutoware, "sensor_kit_base_link", "roll"},
    Known{Code::kLooksLikePhotonVision, "cameraIntrinsics", "distCoeffs"},
    Known{Code::kLooksLikeR3live, "r3live_vio", "camera_intrinsic"},
    Known{Code::kLooksLikePhone, "perFrameIntrinsicCoeffs", "poses"},
    Known{Code::kLooksLikePhone, "cameraPoseARFrame", "intrinsics"},
    Known{Code::kLooksLikePhone, "t_00", "fx"},
    Known{Code::kLooksLikeOwnDump, "left_intrinsics", "right_intrinsics"},
    Known{Code::kLooksLikeDepthaiByName, "cameraData", "intrinsicMatrix"},
    Known{Code::kLooksLikeDepthaiBoard, "board_config", "cameras"},
    Known{Code::kLooksLikeDepthaiBoard, "boardConf", "boardName"},
    Known{Code::kLooksLikeTheia, "CameraIntrinsicsPrior", "focal_length"},
    Known{Code::kLooksLikePyOcamCalib, "taylor_coefficient", "distortion_center"},
    Known{Code::kLooksLikeAdapterOcam, "unprojection", "projection"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "distortion_coefficients"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "dist_coeff"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "dist_coeffs"},
    Known{Code::kLooksLikeRtabMap, "Rtabmap\\", "[Core]"},
    Known{Code::kLooksLikeRtabMap, "Mem\\", "[Core]"},
    Known{Code::kLooksLikeRtabMap, "Kp\\", "[Core]"},
    Known{Code::kLooksLikeRtabMap, "Vis\\", "[Core]"},
    Known{Code::kLooksLikeCalibrationInput, "BoardSize_Width", "Calibrate_Pattern"},
    Known{Code::kLooksLikeImageList, "<opencv_storage>", "<imagelist>"},
    Known{Code::kLooksLikeImageList, "<opencv_storage>", "<images>"},
    Known{Code::kLooksLikeRealsenseStream, "ppx", "coeffs"},
    Known{Code::kLooksLikeRovio, "qCM_x", "MrMC_x", true},
    Known{Code::kLooksLikeOpenMvg, "sfm_data_version", "intrinsics", true},
    Known{Code::kLooksLikeColmapImages, "IMAGE_ID", "QW", true},
    Known{Code::kLooksLikeKalibrReport, "Calibration results", "Camera-system parameters:", true},
    Known{Code::kLooksLikeKalibrReport, "Calibration results", "Normalized Residuals", true},
    Known{Code::kLooksLikeKalibrTarget, "target_type", "tagCols"},
    Known{Code::kLooksLikeKalibrTarget, "target_type", "targetCols"},
    Known{Code::kLooksLikeKimeraTemplate, "{{ camera_id }}", "{{ camera_model }}", true},
};

constexpr std::size_t kLongestOfNumbers = 4096;

bool is_of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Does it stand there with nothing before and after it that would make it another word? What `may_go_on` may be the beginning
/// of one.
bool has_word(std::string_view text, std::string_view word, bool may_go_on = false) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_of_a_word(word.front()) || !is_of_a_word(text[at - 1]);
    const bool ends = may_go_on || end == text.size() || !is_of_a_word(word.back()) || !is_of_a_word(text[end]);
    if (begins && ends) return true;
  }
  return false;
}

/// What the text is, if it is numbers and nothing else.
std::vector<double> numbers_alone(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const std::optional<double> number = text::parse_real(word);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// omni_cam's lens: nothing but 22 numbers, of which the first is a0; in newer files width and height stand before them.
bool is_omni_cam(const std::vector<double>& numbers) {
  constexpr std::size_t kWithSize = 24;
  constexpr std::size_t kWithoutSize = 22;
  const auto is_size = [](double number) { return number >= 1.0 && number == std::floor(number); };
  if (numbers.size() == kWithoutSize) return numbers[0] < 0.0;
  return numbers.size() == kWithSize && is_size(numbers[0]) && is_size(numbers[1]) && numbers[2] < 0.0;
}

/// Three rows of a rotation and a translation.
bool is_pose(const std::vector<double>& numbers) {
  constexpr std::size_t kColumns = 4;
  constexpr double kRounding = 1e-3;
  if (numbers.size() != 3 * kColumns) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double product = 0.0;
      for (std::size_t k = 0; k < 3; ++k) product += numbers[kColumns * i + k] * numbers[kColumns * j + k];
      const bool is_right = std::abs(product - (i == j ? 1.0 : 0.0)) <= kRounding;
      if (!is_right) return false;
    }
  }
  return true;
}

/// KITTI's calib_velo_to_cam.txt and calib_imu_to_velo.txt: a line of a rotation, and one of a translation.
bool is_kitti_raw_pose(std::string_view text) {
  constexpr std::size_t kRotation = 9;
  constexpr std::size_t kTranslation = 3;
  std::istringstream lines{std::string(text)};
  bool has_rotation = false;
  bool has_translation = false;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t key = std::string_view("R:").size();
    has_rotation = has_rotation || (line.starts_with("R:") && numbers_alone(line.substr(key)).size() == kRotation);
    has_translation = has_translation || (line.starts_with("T:") && numbers_alone(line.substr(key)).size() == kTranslation);
  }
  return has_rotation && has_translation;
}

/// Record3D's metadata, which need not have perFrameIntrinsicCoeffs: other programs' have fewer of these keys.
bool is_record3d(std::string_view text) {
  constexpr std::array<std::string_view, 5> kKeys = {"\"K\"", "\"poses\"", "\"fps\"", "\"w\"", "\"h\""};
  return std::ranges::all_of(kKeys, [text](std::string_view key) { return has_word(text, key); });
}

/// The lens of a camera of apex-camera-models, whose files are Kalibr's chains without distortion_model and distortion_coeffs.
/// Nothing if Kalibr has a lens of that name (pinhole, eucm): such a file may be a chain that lacks the two keys.
std::string_view lens_of_apex(std::string_view text) {
  constexpr std::string_view kKey = "camera_model:";
  constexpr std::array<std::string_view, 5> kLenses = {"double_sphere", "kannala_brandt", "ucm", "fov", "radtan"};
  const std::size_t at = text.find(kKey);
  if (at == std::string_view::npos || !has_word(text, "cam0") || !has_word(text, "intrinsics")) return {};
  if (has_word(text, "distortion_model") || has_word(text, "distortion_coeffs")) return {};
  std::string_view value = text.substr(at + kKey.size());
  value.remove_prefix(std::min(value.find_first_not_of(" \t\"'"), value.size()));
  for (const std::string_view lens : kLenses) {
    if (value.starts_with(lens) && (value.size() == lens.size() || !is_of_a_word(value[lens.size()]))) return lens;
  }
  return {};
}

/// By more than two words.
Message by_its_shape(std::string_view text, Parsed parsed) {
  if (text.size() <= kLongestOfNumbers) {
    const std::vector<double> numbers = numbers_alone(text);
    if (is_omni_cam(numbers)) return {Code::kLooksLikeOmniCam};
    if (is_pose(numbers)) return {Code::kLooksLikePoseAlone};
    if (is_kitti_raw_pose(text)) return {Code::kLooksLikeKittiRawPose};
  }
  if (is_record3d(text)) return {Code::kLooksLikePhone, {"K", "poses"}};
  const std::string_view lens = parsed == Parsed::kYes ? lens_of_apex(text) : std::string_view();
  return lens.empty() ? Message{} : Message{Code::kLooksLikeApex, {"camera_model", lens}};
}

}  // namespace

Message looks_like(std::string_view text, Parsed parsed) {
  const Message shaped = by_its_shape(text, parsed);
  if (shaped.is_said()) return shaped;
  for (const Known& known : kKnown) {
    if (parsed == Parsed::kNo && !known.has_no_syntax) continue;
    if (has_word(text, known.word, known.may_go_on) && has_word(text, known.second_word))
      return {known.what, {known.word, known.second_word}};
  }
  return {};
}

}  // namespace fca
