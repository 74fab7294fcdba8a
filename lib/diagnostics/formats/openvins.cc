// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS' chains, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kNoKey = "OpenVINS' chains have no key for it";

/// A lens that the program takes for another one.
constexpr CodeInfo other_lens(Code code, std::string_view text) {
  return {.code = code,
          .id = "unknown-model",
          .severity = Severity::kError,
          .about = About::kReader,
          .text = text,
          .fix = "read as Kalibr's it is understood by its names: convert it as such to OpenVINS, and the lens is fitted"};
}

}  // namespace

std::span<const CodeInfo> openvins_codes() {
  static constexpr std::array kRows = {
      clause(Code::kOpenvinsChainRadtanNoK3, "OpenVINS' radtan has no k3"),
      clause(Code::kOpenvinsChainWithKey, "%YAML:1.0 and {0} below {1}"),
      other_lens(Code::kOpenvinsChainOtherLens,
                 "{0}: OpenVINS never reads camera_model: it would take the first four intrinsics of this {1} camera for fx fy "
                 "cx cy"),
      other_lens(Code::kOpenvinsChainTakenForRadtan, "{0}: OpenVINS takes distortion_model {1} for radtan"),
      clause(Code::kOpenvinsChainDemandsSize, "OpenVINS needs a resolution"),
      clause(Code::kOpenvinsChainPoseMadeUp, "{0}: its pose in the IMU is not in the input, and OpenVINS stops without it"),
      clause(Code::kOpenvinsChainPoseInFrame, "the pose in {0}"),
      clause(Code::kOpenvinsChainCalibratedImu, "those of a calibrated IMU"),
      loss(Code::kOpenvinsChainBaselineDropped, "baseline-dropped", "{1} {2} m", kNoKey,
           "keep it for programs that ask for the baseline separately"),
      clause(Code::kOpenvinsChainNoKey, kNoKey),
      clause(Code::kOpenvinsChainNoPlace, "OpenVINS' chains have no place for it"),
      clause(Code::kOpenvinsChainOneImu, "OpenVINS has one IMU"),
      clause(Code::kOpenvinsChainOneOffset, "OpenVINS takes that of the first camera for all"),
      clause(Code::kOpenvinsChainHeadline, "a chain for OpenVINS"),
      clause(Code::kOpenvinsChainImuHeadline, "an IMU's chain for OpenVINS"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
