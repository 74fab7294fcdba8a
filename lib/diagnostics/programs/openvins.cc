// SPDX-License-Identifier: BSD-3-Clause
// What OpenVINS reports about a file. {0} is the key.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> openvins_program_codes() {
  static constexpr std::array kRows = {
      named_refusal(Code::kOpenVinsSaysKeyMissing, "{0} is missing; OpenVINS stops", kAddTheKey),
      named_refusal(Code::kOpenVinsSaysTooFewNumbers, "{0} has {1} numbers; OpenVINS takes {2} and stops"),
      named_refusal(Code::kOpenVinsSaysNoNumbers, "{0} is not a list of numbers; OpenVINS stops"),
      named_refusal(Code::kOpenVinsSaysPoseMissing,
                    "{0} is missing, and so is T_imu_cam; OpenVINS wants one for every camera (it does not read T_cn_cnm1)",
                    kAddTheKey),
      named_misreading(Code::kOpenVinsSaysPoseNotWhole,
                       "{0} is not a 4 x 4 list of rows; OpenVINS fills what is missing from the identity"),
      named_misreading(Code::kOpenVinsSaysModelNotRead,
                       "{0} is {1}, which OpenVINS does not read: it takes the first four intrinsics for fx fy cx cy"),
      named_misreading(Code::kOpenVinsSaysDistortionNotRead,
                       "{0} is {1}; OpenVINS takes every name but equidistant for radtan"),
      named_misreading(Code::kOpenVinsSaysTimeshiftNotRead, "{0} is not read: OpenVINS takes cam0's for all cameras"),
      named_refusal(Code::kOpenVinsSaysImuMissing,
                    "{0} is missing: OpenVINS looks for the noise below it; Kalibr's own imu.yaml has it at the top",
                    kAddTheKey),
  };
  return kRows;
}

}  // namespace fca::diagnostics
