// SPDX-License-Identifier: BSD-3-Clause
// Numbers that no camera, rig or image can have.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kNoCamera = "not-a-camera";
constexpr std::string_view kRange = "out-of-range";
constexpr std::string_view kImageSize = "image-size-invalid";
constexpr std::string_view kNoRotation = "not-a-rotation";

}  // namespace

std::span<const CodeInfo> limit_codes() {
  static constexpr std::array kRows = {
      error(Code::kNotACamera, kNoCamera, "{0}: {1}"),
      error(Code::kParameterNotFinite, kNoCamera, "{0} is {1:all}, not a finite number"),
      error(Code::kParameterTooLarge, kNoCamera, "{0} is {1:all}, too large to compute with"),
      error(Code::kParameterTooSmall, kNoCamera, "{0} is {1:all}, too small to compute with"),
      error(Code::kFocalLengthNotPositive, kNoCamera, "{0} is {1:all}; a focal length is positive"),
      error(Code::kParameterOutOfRange, kNoCamera, "{0} is {1:all}; it must {2}"),
      clause(Code::kBeLessThan, "be less than {0:all}"),
      clause(Code::kBeAtMost, "be at most {0:all}"),
      clause(Code::kBeGreaterThan, "be greater than {0:all}"),
      clause(Code::kBeAtLeast, "be at least {0:all}"),
      clause(Code::kLieWithin, "lie in [{0:all}, {1:all}]"),
      clause(Code::kLieBetween, "lie in ({0:all}, {1:all})"),
      error(Code::kRigOutOfRange, kRange, "{0}: {1}"),
      error(Code::kRigNumberNotFinite, kRange, "{0}: {1} is {2:.3}, not a finite number"),
      clause(Code::kTheRig, "rig"),
      clause(Code::kTheFrameRate, "the frame rate"),
      clause(Code::kTheRate, "the rate"),
      clause(Code::kGyroscopeNoise, "the gyroscope's noise density"),
      clause(Code::kGyroscopeWalk, "the gyroscope's random walk"),
      clause(Code::kAccelerometerNoise, "the accelerometer's noise density"),
      clause(Code::kAccelerometerWalk, "the accelerometer's random walk"),
      error(Code::kImageSizeInvalid, kImageSize, "{0}: {1}"),
      error(Code::kImageOfNoSize, kImageSize, "an image cannot have {0} x {1} pixels"),
      error(Code::kImageTooLarge, kImageSize, "an image cannot have {0} x {1} pixels: no image is larger than {2} x {2}"),
      error(Code::kTranslationTooLong, kRange, "a translation of {0:.3} m; no rig is longer than {1:.0f} m"),
      error(Code::kBaselineImpossible, kRange, "a baseline of {0:.3} m; it must be greater than 0 and less than {1:.0f} m"),
      error(Code::kTimeOffsetImpossible, kRange, "a time offset of {0:.3} s; it must lie within {1:.0f} s"),
      error(Code::kRotationElementTooLarge, kNoRotation, "its 3 x 3 part is not a rotation: an element is {0:.3}"),
      error(Code::kNotOrthonormal, kNoRotation, "its 3 x 3 part is not a rotation: R^T R differs from the identity by {0:.3}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
