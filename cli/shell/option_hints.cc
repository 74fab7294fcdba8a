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
constexpr std::string_view kImuAsFile = "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one";
constexpr std::string_view kIntoConfiguration = "--into CONFIG.yaml -o FOLDER/ writes it into VINS-Fusion's own configuration";

constexpr std::array kHints = {
    OptionHint{Code::kImageSizeNotStated, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},

    // ORB-SLAM3's settings.
    OptionHint{Code::kOrbslam3SizeMissing, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    OptionHint{Code::kOrbslam3TypesDiffer, text::Part::kFix, "convert both with --model"},
    OptionHint{Code::kOrbslam3PairNotStorable, text::Part::kFix,
               "--orbslam3-layout v1 has both; --sensor mono writes the first camera alone; or rectify the images"},
    OptionHint{Code::kOrbslam3PairVertical, text::Part::kFix,
               "turn both images by 90 deg and calibrate those; --sensor mono takes one camera"},
    OptionHint{Code::kOrbslam3PairNotRectified, text::Part::kFix,
               "give the camera of the rectified images (P1 of cv::stereoRectify); --sensor mono leaves the pair out"},
    OptionHint{Code::kOrbslam3NothingShared, text::Part::kFix,
               "is their pose right (show says it in words)? --sensor mono takes one camera"},
    OptionHint{Code::kOrbslam3ColumnsKept, text::Part::kFix, "--set KEY=VALUE writes another"},
    OptionHint{Code::kOrbslam3ColumnsComputed, text::Part::kFix, "--set KEY=VALUE writes another"},
    OptionHint{Code::kOrbslam3LacksSecond, text::Part::kText, "a second camera (--join CAM0 CAM1)"},
    OptionHint{Code::kOrbslam3LacksSecondOrBaseline, text::Part::kText,
               "a second camera (--join CAM0 CAM1, or --baseline METRES for one of a rectified pair)"},
    OptionHint{Code::kOrbslam3LacksSecondRectified, text::Part::kText,
               "a second camera (--join CAM0 CAM1): one camera and a baseline are a pair only where the images are rectified, "
               "without distortion, and {0} is {1} with distortion (rectify with cv::stereoRectify, or --sensor rgbd for a "
               "depth sensor)"},
    OptionHint{Code::kOrbslam3LacksPose, text::Part::kText, "the pose of {0} to {1} (--with extrinsics.yml)"},
    OptionHint{Code::kOrbslam3LacksOneSize, text::Part::kText, "one image size for both cameras (--resize WxH)"},
    OptionHint{Code::kOrbslam3LacksBaseline, text::Part::kText, "the baseline (--baseline METRES)"},
    OptionHint{Code::kOrbslam3LacksBaselineOfOne, text::Part::kText,
               "the baseline of one camera (--camera {0} --baseline METRES)"},
    OptionHint{Code::kOrbslam3LacksLensForDepth, text::Part::kText,
               "a lens that ORB-SLAM3 takes in this mode: with KannalaBrandt8 it crashes (--sensor rgbd)"},
    OptionHint{Code::kOrbslam3LacksImu, text::Part::kText, "the IMU's noise and rate (--with imu.yaml)"},
    OptionHint{Code::kOrbslam3LacksImuNoise, text::Part::kText,
               "the IMU's noise densities and random walks (add them to the file of --with imu.yaml)"},
    OptionHint{Code::kOrbslam3LacksImuRate, text::Part::kText, "the IMU's rate (update_rate in the file of --with imu.yaml)"},
    OptionHint{Code::kOrbslam3FrameRateRounded, text::Part::kFix, "--fps N writes another one"},
    OptionHint{Code::kOrbslam3SecondCameraDropped, text::Part::kFix, "write it to a file of its own with --camera {0}"},
    OptionHint{Code::kOrbslam3ThirdCameraDropped, text::Part::kFix, "write it to a file of its own with --camera {0}"},
    OptionHint{Code::kOrbslam3ImuDropped, text::Part::kFix, kImuAsFile},
    OptionHint{Code::kOrbslam3BaselineDropped, text::Part::kFix, "--sensor rgbd writes it"},
    OptionHint{Code::kOrbslam3StockByModel, text::Part::kText, " (leave out --model for that)"},
    OptionHint{Code::kOrbslam3StockByLayout, text::Part::kText, " (--orbslam3-layout v1 for that)"},
    OptionHint{Code::kOrbslam3WriteOldStyle, text::Part::kText,
               "--orbslam3-layout old: V1.0 also reads the older style, and there both cameras rightly"},
    OptionHint{
        Code::kOrbslam3RectifyFirst, text::Part::kText,
        "rectify the images first (cv::stereoRectify) and convert one camera of the rectified pair with --baseline METRES "
        "--sensor stereo; or --model kb4 --orbslam3-layout old, where V1.0 reads both cameras rightly"},

    // VINS-Fusion's files.
    OptionHint{Code::kVinsSizeMissing, text::Part::kFix, "--size WIDTHxHEIGHT gives it"},
    OptionHint{Code::kVinsInverseMissing, text::Part::kFix, "fca-io convert FILE --to vins fits it to poly_parameters"},
    OptionHint{Code::kVinsInverseStale, text::Part::kFix, "fca-io convert FILE --to vins --anew rebuilds it"},
    OptionHint{Code::kVinsInverseInexact, text::Part::kFix,
               "--max-angle DEG leaves out the border, where the direct polynomial turns; or another model"},
    OptionHint{Code::kVinsSizesDiffer, text::Part::kFix, "--resize WxH"},
    OptionHint{Code::kVinsCameraMisplaced, text::Part::kFix, "give both cameras (no --camera), or write  num_of_cam: 1"},
    OptionHint{Code::kVinsOtherImages, text::Part::kFix, "--resize {0}x{1} if its images are the input's, scaled"},
    OptionHint{Code::kVinsImuDropped, text::Part::kFix, kIntoConfiguration},
    OptionHint{Code::kVinsSecondImuDropped, text::Part::kFix, kImuAsFile},
    OptionHint{Code::kVinsCameraDropped, text::Part::kFix, "--camera chooses which"},
    OptionHint{Code::kVinsTimeOffsetDropped, text::Part::kFix,
               "add {2:.12} s to every image time stamp of {0}, or --into CONFIG.yaml -o FOLDER/ writes it into VINS-Fusion's "
               "own configuration"},
    OptionHint{Code::kVinsIntoConfiguration, text::Part::kText, kIntoConfiguration},

    // ROS camera_info files.
    OptionHint{Code::kRosIniHasNoModel, text::Part::kFix,
               "name the file .yaml, which holds it, or convert the camera with --model radtan"},

    // What a check finds.
    OptionHint{Code::kImageNotJudged, text::Part::kWhy, "no image size in the file: give --size WxH"},
    OptionHint{Code::kSizeToldDiffers, text::Part::kFix, "--size is for files that state no size"},
    OptionHint{Code::kAsLensNoSize, text::Part::kText, "; as {0}: field of view not decidable without the image size (--size)"},
    OptionHint{
        Code::kUndistortionDiverges, text::Part::kFix,
        "its iteration never arrives there: undistort with fca-io unproject or another solver, or leave those pixels out"},
    OptionHint{Code::kReadByAnother, text::Part::kFix, "{4} writes {1}'s own"},
    OptionHint{Code::kConvertFor, text::Part::kText, "fca-io convert {0:shell} --to {1}{2}"},
    OptionHint{Code::kConvertWithModel, text::Part::kText, " --model {0}"},
    OptionHint{Code::kConvertWithLayout, text::Part::kText, " --{0}-layout {1}"},
    OptionHint{Code::kConvertToFiles, text::Part::kText, " -o FOLDER/"},
    OptionHint{Code::kConvertUnderName, text::Part::kText, " -o {0}"},
    OptionHint{Code::kAnyModelContradicts, text::Part::kFix, "leave --opencv-model out, or correct the file's own words"},
    OptionHint{Code::kAnyProgramMisreads, text::Part::kFix,
               "see what it costs in pixels, with  fca-io show FILE --for PROGRAM,  and change what the message names if that "
               "is too much"},
    OptionHint{Code::kAnyUnknownFormat, text::Part::kFix, "fca-io formats lists what is read; --from FORMAT forces one"},
    OptionHint{Code::kAnyUnknownModel, text::Part::kFix,
               "write the program's own name; `fca-io models` has what each is called elsewhere"},
};

}  // namespace

std::string_view with_options(Code code, text::Part part) {
  const auto* const hint =
      std::ranges::find_if(kHints, [&](const OptionHint& each) { return each.code == code && each.part == part; });
  return hint != kHints.end() ? hint->words : text::table_wording(code, part);
}

}  // namespace fca::cli
