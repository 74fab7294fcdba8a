// SPDX-License-Identifier: BSD-3-Clause
#include "option_hints.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

/// The words of one column of the table where the command's differ.
struct OptionHint {
  Code code;
  text::Part part;
  std::string_view words;
};

constexpr std::string_view kListedFormats = "'fca-io formats' lists them; --from FORMAT forces one";

constexpr std::array kHints = {
    OptionHint{Code::kImageSizeNotStated, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    // Conversion.
    OptionHint{Code::kImageSizeNotKnown, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    OptionHint{Code::kNoPixelInTheLens, text::Part::kFix, "a larger --max-angle"},
    OptionHint{Code::kTargetCannotReach, text::Part::kFix,
               "another model may reach further: fca-io models FILE compares all models"},
    OptionHint{Code::kDomainGiven, text::Part::kText, "given (--max-angle)"},
    OptionHint{Code::kDomainInsideGiven, text::Part::kText, "the whole image (it ends inside --max-angle)"},
    // Comparison.
    OptionHint{Code::kResolutionDiffers, text::Part::kFix,
               "say how the reference's images become the other's: --crop X,Y,W,H, --binning N, --resize {3}x{4}"},
    // Fields.
    OptionHint{Code::kPoseMirrors, text::Part::kFix,
               "mend the sign or the order of its rows first; fca-io check shows the place"},

    // Files and formats, whichever, and what they cannot hold.
    OptionHint{Code::kFormatUnknown, text::Part::kFix, kListedFormats},
    OptionHint{Code::kFormatLooksLikeKeysBeside, text::Part::kFix, kListedFormats},
    OptionHint{Code::kFormatLooksLikeKeysInside, text::Part::kFix, kListedFormats},
    OptionHint{Code::kFormatAmbiguous, text::Part::kFix, "say which with --from"},
    OptionHint{Code::kFormatNeedsSize, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    OptionHint{Code::kSetWrongType, text::Part::kText, "--set {0} wants {1}, not '{2}'"},
    OptionHint{Code::kSetOutOfRange, text::Part::kText, "--set {0} wants {1}, not {2}"},
    OptionHint{Code::kSetNoSingleValue, text::Part::kText, "--set sets single values, and '{0}' is {1}"},
    OptionHint{Code::kSetUnknownKey, text::Part::kText, "--set: the file written has no value under '{0}'{1}"},
    OptionHint{Code::kSetLayout, text::Part::kText, "--set: {0} is how the file states its calibration, which would be lost"},
    OptionHint{Code::kSetCalibration, text::Part::kText, "--set: {0} is a part of the calibration, which says otherwise"},
    OptionHint{Code::kSetCalibration, text::Part::kFix,
               "change the input; --resize, --crop and --binning are for other images"},
    OptionHint{Code::kImuDropped, text::Part::kFix, "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
constexpr std::string_view kFromKalibr =
    "--from kalibr reads it by its names: convert it with that and --to openvins, and the lens is fitted";

constexpr std::array kHints = {
    OptionHint{Code::kImageSizeNotStated, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    // Kalibr's, OpenVINS' and OCamCalib's files.
    OptionHint{Code::kCamchainSizeMissing, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    OptionHint{Code::kCamchainImuDropped, text::Part::kFix,
               "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    OptionHint{Code::kOpenvinsChainOtherLens, text::Part::kFix, kFromKalibr},
    OptionHint{Code::kOpenvinsChainTakenForRadtan, text::Part::kFix, kFromKalibr},
    OptionHint{Code::kCalibResultsInverseMissing, text::Part::kFix,
               "fca-io convert FILE --to ocamcalib fits one to the direct polynomial"},
    OptionHint{Code::kCalibResultsInverseStale, text::Part::kFix, "fca-io convert FILE --to ocamcalib rebuilds it"},
    OptionHint{Code::kCalibResultsInverseInexact, text::Part::kFix,
               "--max-angle DEG leaves out the border, where the direct polynomial turns; or another model"},

    // OpenCV's and Basalt's files.
    OptionHint{Code::kOpencvForeignModel, text::Part::kFix,
               "if the numbers are one of theirs all the same, say which: --opencv-model pinhole or --opencv-model fisheye"},
    OptionHint{Code::kOpencvAmbiguousModel, text::Part::kFix, "say which: --opencv-model pinhole or --opencv-model fisheye"},
    OptionHint{Code::kOpencvToldInVain, text::Part::kText,
               "{0}: --opencv-model fisheye, which is about four coefficients, has no effect on this camera"},
    OptionHint{Code::kOpencvWrittenAmbiguous, text::Part::kFix, "--opencv-model {0} reads it so"},
    OptionHint{Code::kOpencvLayoutNotServed, text::Part::kFix, "leave out --opencv-layout, or choose {2}"},
    OptionHint{Code::kOpencvImuDropped, text::Part::kFix, "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    OptionHint{Code::kOpencvCameraDropped, text::Part::kFix,
               "--to opencv -o OTHER.yml writes the cameras into a file of their own"},
    OptionHint{Code::kOpencvSizeDropped, text::Part::kFix, "--opencv-layout cameras has a size for each"},
    OptionHint{Code::kBasaltImuDropped, text::Part::kFix, "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
};

}  // namespace

std::string_view with_options(Code code, text::Part part) {
  const auto* const hint =
      std::ranges::find_if(kHints, [&](const OptionHint& each) { return each.code == code && each.part == part; });
  return hint != kHints.end() ? hint->words : text::table_wording(code, part);
}

}  // namespace fca::cli
