// SPDX-License-Identifier: BSD-3-Clause
// TUM-VI's chains and camera.txt, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

/// What DSO reads from the file, which is right but for that.
constexpr std::string_view kLenses =
    "EquiDistant, KannalaBrandt or RadTan with 8 numbers (fx fy cx cy and four coefficients), FOV or Pinhole with 5";

}  // namespace

std::span<const CodeInfo> tumvi_codes() {
  static constexpr std::array kRows = {
      // What speaks for a camera.txt.
      clause(Code::kCameraTxtNamedLens, "a first line {0} as in DSO's camera.txt"),
      clause(Code::kCameraTxtWithMode, "a line of numbers, a size and a mode as in DSO's camera.txt"),
      clause(Code::kCameraTxtNumbers, "a line of numbers and a size as in DSO's camera.txt"),

      reader_warning(Code::kCameraTxtAtan, "program-refuses",
                     "DSO knows no lens ATAN and stops; ATAN is PTAM's name for DSO's FOV", "write FOV"),
      error(Code::kCameraTxtNotANumber, "not-a-number", "line 1: '{0}' is not a number"),
      error(Code::kCameraTxtNoLens, "unknown-model", "line 1 is not a lens that DSO knows", kLenses),
      error(Code::kCameraTxtTooFewNumbers, "unknown-model", "line 1 has {0} numbers; {1} has {2}", kLenses),
      error(Code::kCameraTxtSize, "missing-block", "line 2 must be the image's width and height, two whole numbers"),
      error(Code::kCameraTxtSharesByCentre, "relative-by-centre",
            "cx and cy are below 1, so DSO also takes fx and fy as fractions of the image's width and height: no lens is that "
            "long",
            "write all four in pixels, or all four as fractions"),
      reader_warning(Code::kCameraTxtFifthNumber, "program-ignores",
                     "DSO reads the fifth number of Pinhole and does not use it"),
      reader_warning(
          Code::kCameraTxtNoOutput, "program-refuses",
          "DSO wants a line 3 (crop, none or five numbers) and a line 4 (width and height of its images), and stops"),
      reader_warning(Code::kCameraTxtFull, "program-refuses", "DSO does not implement \"full\" yet, and stops", "write  crop"),
      reader_warning(Code::kCameraTxtMode, "program-refuses",
                     "line 3 must be exactly crop or none (no space, no CR after it) or five numbers; DSO stops"),
      reader_warning(Code::kCameraTxtSizesDiffer, "program-refuses",
                     "line 3 is none, but the sizes of the lines 2 and 4 differ: DSO stops"),
      reader_warning(Code::kCameraTxtNotRectified, "program-ignores",
                     "line 3 is none: DSO takes the images as they are, and ignores the distortion of line 1", "write  crop"),

      // Why a camera.txt cannot say a rig.
      clause(Code::kCameraTxtManyCameras, "it holds one camera, but there are {0}"),
      clause(Code::kCameraTxtUnknownModel, "DSO knows no model {0} (it reads pinhole, radtan, kb4 and fov)"),
      clause(Code::kCameraTxtNoK3, "DSO's RadTan has no k3"),
      clause(Code::kCameraTxtSizeMissing, "it contains the image's size, but the input has none"),
      clause(Code::kCameraTxtCentreBelowOne, "DSO takes a centre below (1, 1) as fractions of the image's size"),
      clause(Code::kCameraTxtCentreNoShare, "its numbers are fractions of the image's size, and these cannot be"),
      CodeInfo{.code = Code::kCameraTxtCamchainInstead,
               .id = "not-a-camera-txt",
               .severity = Severity::kNote,
               .about = About::kUse,
               .text = "a camchain, not DSO's camera.txt: {0}"},
      error(Code::kCameraTxtNotWritten, "not-a-camera-txt", "no camera.txt is written: {0}"),

      clause(Code::kCameraTxtNoPlace, "a camera.txt has no place for it"),
      clause(Code::kCameraTxtSizeOfCamera, "the camera's"),
      clause(Code::kCameraTxtHeadline, "a camera.txt for DSO"),
      clause(Code::kCameraTxtHeadlineEach, "a camera.txt for DSO per camera"),
      clause(Code::kTumviHeadline, "a camchain as TUM-VI's, for Kalibr"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
