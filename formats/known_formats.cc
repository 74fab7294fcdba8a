// SPDX-License-Identifier: BSD-3-Clause
#include "known_formats.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

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
  bool has_no_syntax = false;  ///< It is neither YAML, JSON, lines of words nor OpenCV's XML.
};

constexpr std::array kKnown = {
    Known{Code::kLooksLikeMultiCol, "Camera.nrpol", "Camera.nrinvpol"},
    Known{Code::kLooksLikeMultiColRig, "CameraSystem.nrCams", "CameraSystem.cam1_1"},
    Known{Code::kLooksLikeOv2Slam, "Camera.fxl", "Camera.model_left"},
    Known{Code::kLooksLikeD2Slam, "estimation_mode", "self_id"},
    Known{Code::kLooksLikeD2Slam, "estimation_mode", "double_counting_common_feature"},
    Known{Code::kLooksLikeLarvio, "T_cam_imu", "if_FEJ"},
    Known{Code::kLooksLikeFastLivoPoses, "extrin_calib", "Pcl"},
    Known{Code::kLooksLikeCuvslamRig, "stereo_cameras", "left_camera"},
    Known{Code::kLooksLikeCuvslamRig, "rgb_camera", "depth_camera"},
    Known{Code::kLooksLikeAria, "CameraCalibrations", "Projection"},
    Known{Code::kLooksLikeWmr, "CalibrationInformation", "ModelParameters"},
    Known{Code::kLooksLikeDriveWorks, "rig", "bw-poly"},
    Known{Code::kLooksLikeDriveWorks, "rig", "pixeldistance-to-angle"},
    Known{Code::kLooksLikeIsaac, "OmniLensDistortionFthetaAPI", "Camera", true},
    Known{Code::kLooksLikeIsaac, "cameraProjectionType", "Camera", true},
    Known{Code::kLooksLikeEdex, "distortion_params", "principal"},
    Known{Code::kLooksLikeSpectacular, "focalLengthX", "imuToCamera"},
    Known{Code::kLooksLikeMatlab, "RadialDistortion", "IntrinsicMatrix"},
    Known{Code::kLooksLikeMatlab, "RadialDistortion", "ImageSize"},
    Known{Code::kLooksLikeMatlabFisheye, "MappingCoefficients", "DistortionCenter"},
    Known{Code::kLooksLikeAutoware, "sensor_kit_base_link", "roll"},
    Known{Code::kLooksLikePhotonVision, "cameraIntrinsics", "distCoeffs"},
    Known{Code::kLooksLikeR3live, "r3live_vio", "camera_intrinsic"},
    Known{Code::kLooksLikePhone, "perFrameIntrinsicCoeffs", "poses"},
    Known{Code::kLooksLikePhone, "t_00", "fx"},
    Known{Code::kLooksLikeOwnDump, "left_intrinsics", "right_intrinsics"},
    Known{Code::kLooksLikeDepthaiBoard, "board_config", "cameras"},
    Known{Code::kLooksLikeDepthaiBoard, "boardConf", "boardName"},
    Known{Code::kLooksLikeTheia, "CameraIntrinsicsPrior", "focal_length"},
    Known{Code::kLooksLikePyOcamCalib, "taylor_coefficient", "distortion_center"},
    Known{Code::kLooksLikeAdapterOcam, "unprojection", "projection"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "distortion_coefficients"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "dist_coeff"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "dist_coeffs"},
    Known{Code::kLooksLikeRtabMap, "Rtabmap\\", "[Core]"},
    Known{Code::kLooksLikeCalibrationInput, "BoardSize_Width", "Calibrate_Pattern"},
    Known{Code::kLooksLikeImageList, "<opencv_storage>", "<imagelist>"},
    Known{Code::kLooksLikeImageList, "<opencv_storage>", "<images>"},
};

constexpr std::size_t kLongestOfNumbers = 4096;

bool is_of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Does it stand there with nothing before and behind it that would make it another word?
bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_of_a_word(word.front()) || !is_of_a_word(text[at - 1]);
    if (begins && (end == text.size() || !is_of_a_word(word.back()) || !is_of_a_word(text[end]))) return true;
  }
  return false;
}

/// omni_cam's lens: nothing but 22 numbers, of which the first is a0; in newer files width and height stand before them.
bool is_omni_cam(std::string_view text) {
  constexpr std::size_t kWithSize = 24;
  constexpr std::size_t kWithoutSize = 22;
  std::istringstream words{std::string(text)};
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const std::optional<double> number = text::parse_real(word);
    if (!number || numbers.size() == kWithSize) return false;
    numbers.push_back(*number);
  }
  const auto is_size = [](double number) { return number >= 1.0 && number == std::floor(number); };
  if (numbers.size() == kWithoutSize) return numbers[0] < 0.0;
  return numbers.size() == kWithSize && is_size(numbers[0]) && is_size(numbers[1]) && numbers[2] < 0.0;
}

}  // namespace

Message looks_like(std::string_view text, Parsed parsed) {
  if (text.size() <= kLongestOfNumbers && is_omni_cam(text)) return {Code::kLooksLikeOmniCam};
  for (const Known& known : kKnown) {
    if (parsed == Parsed::kNo && !known.has_no_syntax) continue;
    if (has_word(text, known.word) && has_word(text, known.second_word)) return {known.what, {known.word, known.second_word}};
  }
  return {};
}

}  // namespace fca
