// SPDX-License-Identifier: BSD-3-Clause
// Kalibr's chains, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> kalibr_codes() {
  static constexpr std::array kRows = {
      // What speaks for the format.
      clause(Code::kCamchainWithKey, "a top-level {0} with {1}"),
      clause(Code::kCamchainBlock, "a top-level {0}"),
      clause(Code::kCamchainImuKeys, "the noise keys of Kalibr's imu.yaml"),

      warning(Code::kCamchainMisnamedCamera, "key-misspelt",
              "'{0}' holds a camera and is not read: cameras are cam0, cam1, ...", "rename it to the next free of them"),
      error(Code::kCamchainNoMapping, "not-a-mapping", "{0} contains no keys"),
      error(Code::kCamchainUnknownCamera, "unknown-model", "{0}: Kalibr has no camera_model '{1}'; it knows {2}", "{3}"),
      clause(Code::kCamchainNearNames, "did you mean {0:or}?"),
      clause(Code::kCamchainNearPair, "did you mean camera_model {0} with distortion_model {1}?"),
      error(Code::kCamchainUnknownDistortion, "unknown-model",
            "{0}: Kalibr has no camera_model {1} with distortion_model '{2}'", "{3}"),
      CodeInfo{.code = Code::kCamchainOutsideRange,
               .id = "program-refuses",
               .severity = Severity::kWarning,
               .about = About::kReader,
               .text = "{0}: {1} = {2}: {3}"},
      clause(Code::kCamchainAlphaBelowOne, "Kalibr demands alpha < 1"),
      clause(Code::kCamchainRadtanNoK3, "Kalibr's radtan has no k3"),
      error(Code::kCamchainWrongLength, "wrong-length", "{0} has {1} numbers; it must have {2}"),
      error(Code::kCamchainNoList, "wrong-length", "{0} must be a list of {1} numbers"),
      error(Code::kCamchainResolution, "wrong-length", "{0} must be [width, height]"),
      error(Code::kCamchainNothing, "no-calibration", "the file has neither a camera (cam0) nor an IMU's noise"),

      // Of OpenVINS' chains, too.
      bad_request(Code::kCamchainNoCamera, "no-camera", "{0} needs a camera, but the input has none"),
      bad_request(Code::kCamchainImuNotGiven, "no-camera", "{0} needs {1}, which the input does not contain"),
      loss(Code::kCamchainImuDropped, "imu-dropped", "{0} noise and rate", "{2}",
           "keep its file; converted to Kalibr's format, into a folder, a complete IMU gets a file there"),
      loss(Code::kCamchainImuIncomplete, "imu-dropped", "{0} noise and rate", "{2}", "also give the program what is missing"),
      clause(Code::kCamchainImuDemands, "{0} also needs {1}"),

      error(Code::kCamchainSizeMissing, "image-size-missing", "{0}: Kalibr needs a resolution, but the input has none",
            "give the image size"),
      loss(Code::kCamchainBaselineDropped, "baseline-dropped", "{1} {2} m of a rectified pair or depth sensor",
           "a camchain contains poses of cameras, and the second camera is not in the input",
           "keep it for programs that ask for the baseline separately"),
      clause(Code::kCamchainNoKey, "a camchain has no key for it"),
      clause(Code::kCamchainNoPlace, "the written camchain has no place for it"),
      clause(Code::kCamchainRewritten, "a fresh file is written, with what every camchain contains"),
      clause(Code::kCamchainOverlapsNoList, "it is not a list of this chain's cameras, which are renumbered"),
      clause(Code::kCamchainOverlapsOfAbsent, "it names a camera that is not in the written chain"),
      clause(Code::kCamchainOverlapsOfItsFile, "it counts the cameras of its own file"),
      clause(Code::kCamchainHeadline, "a camchain for Kalibr"),
      clause(Code::kCamchainImuHeadline, "an imu.yaml for Kalibr"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
