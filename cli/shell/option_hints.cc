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

constexpr std::string_view kListedFormats = "fca-io formats lists the formats that it reads; --from FORMAT chooses one";
constexpr std::string_view kImuAsFile = "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one";
constexpr std::string_view kFromKalibr =
    "convert it with --from kalibr, which reads the names, and --to openvins: fca-io then fits the lens";
constexpr std::string_view kIntoConfiguration = "--into CONFIG.yaml -o FOLDER/ writes it into VINS-Fusion's own configuration";

constexpr std::array kHints = {
    OptionHint{Code::kImageSizeNotGiven, text::Part::kFix, "give the image size: --size WIDTHxHEIGHT"},
    OptionHint{Code::kSizeUnlikeCentre, text::Part::kFix,
               "correct the size in the file to that of the images that were calibrated (--size, where it contains none); for "
               "images that were scaled since, with --resize {3}x{4}"},
    // Conversion.
    OptionHint{Code::kGiveFileAndUnit, text::Part::kText,
               "also give a file that contains it (--with FILE), and the unit of the translations (--unit m, cm or mm)"},
    OptionHint{Code::kGiveLengthUnit, text::Part::kText, "give the unit of the translations: --unit m, --unit cm or --unit mm"},
    OptionHint{Code::kDeviceSizeNeeded, text::Part::kFix, "give the size of your images: --size WIDTHxHEIGHT"},
    OptionHint{Code::kDeviceSizeUnknown, text::Part::kFix,
               "--size is the size at which the device recorded; --resize with it is for images that were scaled since"},
    OptionHint{Code::kNerfNeedsSize, text::Part::kFix, "write w and h, in pixels, or give them: --size WIDTHxHEIGHT"},
    OptionHint{Code::kImageSizeNotKnown, text::Part::kFix, "give the image size: --size WIDTHxHEIGHT"},
    OptionHint{Code::kNoPixelInTheLens, text::Part::kFix, "give a larger --max-angle"},
    OptionHint{Code::kTargetCannotReach, text::Part::kFix,
               "another model may have a larger maximum angle: fca-io models FILE compares all models"},
    OptionHint{Code::kPairFitWithOthers, text::Part::kText,
               "--pair minimises the rms of all pixels with all parameters and turns: leave out --absorb-rotation, --fix, "
               "--weight, --objective max, --into and --orbslam3-layout v1-common"},
    OptionHint{Code::kTurnWouldHelp, text::Part::kFix, "--absorb-rotation also fits the turn"},
    OptionHint{Code::kParameterUnusual, text::Part::kFix,
               "--fix {2}={5:.3} keeps it within the range, or another --model may need no such number: programs that search "
               "from it may fail"},
    OptionHint{Code::kFieldOfViewGiven, text::Part::kText, "given (--max-angle)"},
    OptionHint{Code::kFieldOfViewInsideGiven, text::Part::kText, "the whole image (it ends before --max-angle)"},
    OptionHint{Code::kSigmaUnknown, text::Part::kFix,
               "set the limit in pixels (--max-error PX), or give the covariance of the camera's parameters (--with FILE)"},
    // Comparison.
    OptionHint{Code::kResolutionDiffers, text::Part::kFix,
               "give the change from the reference's images to the other's: --crop X,Y,W,H, --binning N, --resize {3}x{4}"},
    // Fields.
    OptionHint{Code::kPoseMirrors, text::Part::kFix,
               "correct the sign or the order of its rows first; fca-io check shows the place"},

    // Files and formats, whichever, and what they cannot hold.
    OptionHint{Code::kFormatUnknown, text::Part::kFix, kListedFormats},
    OptionHint{Code::kFormatAmbiguous, text::Part::kFix, "name the format with --from"},
    OptionHint{Code::kFormatNeedsSize, text::Part::kFix, "give the image size: --size WIDTHxHEIGHT"},
    OptionHint{Code::kSetWrongType, text::Part::kText, "--set {0} wants {1}, not '{2}'"},
    OptionHint{Code::kSetOutOfRange, text::Part::kText, "--set {0} wants {1}, not {2}"},
    OptionHint{Code::kSetNoSingleValue, text::Part::kText, "--set sets only single values, but '{0}' is {1}"},
    OptionHint{Code::kSetUnknownKey, text::Part::kText, "--set: the file written has no value under '{0}'{1}"},
    OptionHint{Code::kSetLayout, text::Part::kText,
               "--set: {0} sets how the file stores its calibration; another value would destroy it"},
    OptionHint{Code::kSetCalibration, text::Part::kText,
               "--set: {0} is a part of the calibration, and the input has another value"},
    OptionHint{Code::kSetCalibration, text::Part::kFix,
               "change the input; --resize, --crop and --binning are for other images"},
    OptionHint{Code::kImuDropped, text::Part::kFix, "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    // Kalibr's, OpenVINS' and OCamCalib's files.
    OptionHint{Code::kCamchainSizeMissing, text::Part::kFix, "give the image size: --size WIDTHxHEIGHT"},
    OptionHint{Code::kCamchainImuDropped, text::Part::kFix,
               "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    OptionHint{Code::kCamchainImuIncomplete, text::Part::kFix,
               "--imu-rate HZ gives the rate, --with FILE what else is missing"},
    OptionHint{Code::kOpenvinsChainOtherLens, text::Part::kFix, kFromKalibr},
    OptionHint{Code::kOpenvinsChainTakenForRadtan, text::Part::kFix, kFromKalibr},
    OptionHint{Code::kCalibResultsInverseMissing, text::Part::kFix,
               "fca-io convert FILE --to ocamcalib fits one to the direct polynomial"},
    OptionHint{Code::kCalibResultsInverseStale, text::Part::kFix, "fca-io convert FILE --to ocamcalib rebuilds it"},
    OptionHint{Code::kCalibResultsInverseInexact, text::Part::kFix,
               "leave out the border, where the direct polynomial turns, with --max-angle DEG; or take another model"},

    // OpenCV's and Basalt's files.
    OptionHint{
        Code::kOpencvForeignModel, text::Part::kFix,
        "if the numbers are nevertheless one of theirs, name the model: --opencv-model pinhole or --opencv-model fisheye"},
    OptionHint{Code::kOpencvAmbiguousModel, text::Part::kFix,
               "name the model: --opencv-model pinhole or --opencv-model fisheye"},
    OptionHint{Code::kOpencvGivenInVain, text::Part::kText,
               "{0}: --opencv-model fisheye, which is for four coefficients, has no effect on this camera"},
    OptionHint{Code::kOpencvWrittenAmbiguous, text::Part::kFix, "--opencv-model {0} reads it so"},
    OptionHint{Code::kOpencvUnitsNotGiven, text::Part::kFix, "--unit mm if they are millimetres"},
    OptionHint{Code::kOpencvLayoutNotServed, text::Part::kFix, "leave out --opencv-layout, or choose {2}"},
    OptionHint{Code::kOpencvImuDropped, text::Part::kFix, "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    OptionHint{Code::kOpencvCameraDropped, text::Part::kFix,
               "--to opencv -o OTHER.yml writes the cameras into a file of their own"},
    OptionHint{Code::kOpencvSizeDropped, text::Part::kFix, "--opencv-layout cameras has a size for each"},
    OptionHint{Code::kBasaltImuDropped, text::Part::kFix, "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    // ORB-SLAM3's settings.
    OptionHint{Code::kOrbslam3SizeMissing, text::Part::kFix, "give the image size: --size WIDTHxHEIGHT"},
    OptionHint{Code::kOrbslam3TypesDiffer, text::Part::kFix, "convert both with --model"},
    OptionHint{Code::kOrbslam3ModelNotStorable, text::Part::kFix,
               "--model radtan for ORB-SLAM2, --model eucm for slam_no_opt; or leave out the layout"},
    OptionHint{Code::kOrbslam3PairNotStorable, text::Part::kFix,
               "--orbslam3-layout v1 has both; --sensor mono writes the first camera alone; fca-io rectify rectifies the pair"},
    OptionHint{Code::kOrbslam3PairVertical, text::Part::kFix,
               "turn both images by 90 deg and calibrate those; --sensor mono takes one camera"},
    OptionHint{
        Code::kOrbslam3PairNotRectified, text::Part::kFix,
        "fca-io rectify makes the camera of rectified images (P1 of cv::stereoRectify); --sensor mono leaves the pair out"},
    OptionHint{Code::kOrbslam3NothingShared, text::Part::kFix,
               "check their pose (fca-io show describes it); --sensor mono takes one camera"},
    OptionHint{Code::kOrbslam3ColumnsKept, text::Part::kFix, "--set KEY=VALUE writes another"},
    OptionHint{Code::kOrbslam3ColumnsComputed, text::Part::kFix, "--set KEY=VALUE writes another"},
    OptionHint{Code::kOrbslam3LacksSecond, text::Part::kText, "a second camera (--join CAM0 CAM1)"},
    OptionHint{Code::kOrbslam3LacksSecondOrBaseline, text::Part::kText,
               "a second camera (--join CAM0 CAM1, or --baseline METRES for one of a rectified pair)"},
    OptionHint{Code::kOrbslam3LacksSecondRectified, text::Part::kText,
               "a second camera (--join CAM0 CAM1): one camera and a baseline are a pair only where the images are rectified, "
               "without distortion, and {0} is {1} with distortion (fca-io rectify does that; --sensor rgbd for a "
               "depth sensor)"},
    OptionHint{Code::kVerdictNoCommonView, text::Part::kFix, "leave out --sensor, or choose others with --camera"},
    OptionHint{Code::kVerdictNoPose, text::Part::kFix, "also give a file that contains it: --with FILE"},
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

    // VINS-Fusion's files.
    OptionHint{Code::kVinsSizeMissing, text::Part::kFix, "give the image size: --size WIDTHxHEIGHT"},
    OptionHint{Code::kVinsInverseMissing, text::Part::kFix, "fca-io convert FILE --to vins fits it to poly_parameters"},
    OptionHint{Code::kVinsInverseStale, text::Part::kFix, "fca-io convert FILE --to vins --rewrite rebuilds it"},
    OptionHint{Code::kVinsInverseInexact, text::Part::kFix,
               "leave out the border, where the direct polynomial turns, with --max-angle DEG; or take another model"},
    OptionHint{Code::kVinsSizesDiffer, text::Part::kFix, "--resize WxH"},
    OptionHint{Code::kVinsCameraMisplaced, text::Part::kFix, "give both cameras (no --camera), or write  num_of_cam: 1"},
    OptionHint{Code::kVinsIfScaled, text::Part::kText, "; --resize {0}x{1} if they are the input's, scaled"},
    OptionHint{Code::kVinsNoiseOfUnknownRate, text::Part::kFix, "give the IMU's rate: --imu-rate HZ"},
    OptionHint{Code::kVinsImuDropped, text::Part::kFix, kIntoConfiguration},
    OptionHint{Code::kVinsSecondImuDropped, text::Part::kFix, kImuAsFile},
    OptionHint{Code::kVinsCameraDropped, text::Part::kFix, "--camera chooses which"},
    OptionHint{Code::kVinsTimeOffsetDropped, text::Part::kFix, kIntoConfiguration},
    OptionHint{Code::kVinsIntoConfiguration, text::Part::kText, kIntoConfiguration},

    // ROS camera_info files.
    OptionHint{Code::kRosIniHasNoModel, text::Part::kFix,
               "name the file .yaml, which holds it, or convert the camera with --model radtan"},

    // What a check finds.
    OptionHint{Code::kImageNotEvaluated, text::Part::kWhy, "the file contains no image size: give --size WxH"},
    OptionHint{Code::kSizeGivenDiffers, text::Part::kFix, "give --size only for files that contain no size"},
    OptionHint{Code::kAsLensNoSize, text::Part::kText, "; as {0}: field of view unknown without the image size (--size)"},
    OptionHint{
        Code::kUndistortionDiverges, text::Part::kFix,
        "its iteration does not converge there: undistort with fca-io unproject or another solver, or leave those pixels out"},
    OptionHint{Code::kReadByAnother, text::Part::kFix, "to get a file for {1}: {4}"},
    OptionHint{Code::kConvertFor, text::Part::kText, "fca-io convert {0:shell} --to {1}{2}"},
    OptionHint{Code::kConvertWithModel, text::Part::kText, " --model {0}"},
    OptionHint{Code::kConvertWithLayout, text::Part::kText, " --{0}-layout {1}"},
    OptionHint{Code::kConvertWithRewrite, text::Part::kText, " --rewrite"},
    OptionHint{Code::kConvertWithSize, text::Part::kText, " --size WxH"},
    OptionHint{Code::kConvertToFile, text::Part::kText, " -o OUT{0}"},
    OptionHint{Code::kConvertToFiles, text::Part::kText, " -o FOLDER/"},
    OptionHint{Code::kConvertUnderName, text::Part::kText, " -o {0}"},
    OptionHint{Code::kAnyModelContradicts, text::Part::kFix, "leave out --opencv-model, or correct the file"},
    OptionHint{
        Code::kAnyProgramMisreads, text::Part::kFix,
        "get the error in pixels with  fca-io show FILE --for PROGRAM,  and change what the message names if it is too large"},
    OptionHint{
        Code::kAnyProgramRefuses, text::Part::kFix,
        "correct what the message names, or rewrite the file for the program: fca-io convert FILE --to FORMAT --rewrite"},
    OptionHint{Code::kAnyUnknownFormat, text::Part::kFix,
               "fca-io formats lists the formats that it reads; --from FORMAT chooses one"},
    OptionHint{Code::kAnyUnknownModel, text::Part::kFix,
               "write the model's name as the program spells it; fca-io models lists the names of each model"},

    // Requests.
    OptionHint{Code::kModeWithoutUse, text::Part::kText, "--sensor is for --to {0:or}, not {1}"},
    OptionHint{Code::kRateWithoutUse, text::Part::kText, "--fps is for --to {0:or}, not {1}"},
    OptionHint{Code::kBaselineWithoutUse, text::Part::kText, "--baseline is for --to {0:or}, not {1}"},
    OptionHint{Code::kDegreeWithoutUse, text::Part::kText, "--degree is for --to {0:or}, not {1}"},
    OptionHint{Code::kLayoutWithoutUse, text::Part::kText, "--{0}-layout is for --to {0}, not {1}"},
    OptionHint{Code::kOtherFormInFolder, text::Part::kFix,
               "give another -o FOLDER/, or --into FOLDER, which changes that model itself"},
    OptionHint{Code::kNothingToConvert, text::Part::kFix,
               "it belongs to a file with cameras, for example: fca-io convert {1:shell} --with {2:shell} {3}"},
    OptionHint{Code::kAsFormat, text::Part::kText, "--to {0}"},
    OptionHint{Code::kIntoFile, text::Part::kText, "--into {0}"},
    OptionHint{
        Code::kBaselineOfSeveral, text::Part::kText,
        "--baseline is for one camera of a rectified pair or depth sensor, but these are {0} cameras with poses of their own"},
    OptionHint{Code::kBaselineOfSeveral, text::Part::kFix, "choose one with --camera"},
    OptionHint{Code::kSettingContradictsRate, text::Part::kText, "--set {0}={1} and --fps {2} contradict each other"},
    OptionHint{Code::kIntoWithoutCamera, text::Part::kFix,
               "give --into the file that contains the cameras; -o FILE writes a new one"},
    OptionHint{Code::kIntoAnotherFormat, text::Part::kText, "the file is {0}, but --to is {1}"},
    OptionHint{Code::kIntoAnotherFormat, text::Part::kFix, "leave out --to"},
    OptionHint{Code::kIntoWithoutPose, text::Part::kFix,
               "give an input with one of these poses; --to opencv -o OTHER.yml writes the cameras"},
    OptionHint{Code::kModelsDiffer, text::Part::kFix, "give --model {0}, or an input that has all cameras"},
    OptionHint{Code::kLayoutWithoutModel, text::Part::kFix, "--model {2} keeps the file's text, --rewrite writes another file"},
    OptionHint{Code::kSizesContradict, text::Part::kFix,
               "--resize {1}x{2} if the base's images are scaled copies of the input's; --resize {3}x{4} if the base should be "
               "for the input's images"},
    OptionHint{Code::kIntoDoesNotFit, text::Part::kFix, "--rewrite writes a fresh file and lists what it drops"},
    OptionHint{Code::kIntoDoesNotFitWords, text::Part::kFix, "--to {0} -o OTHER.yaml writes another file"},
    OptionHint{Code::kStaleOfImages, text::Part::kFix, "compute it for the new images, or --rewrite leaves it out"},
    OptionHint{Code::kStaleOfImagesLost, text::Part::kFix, "compute it for the new images, or --rewrite leaves it out"},
    OptionHint{Code::kStaleOfLenses, text::Part::kFix,
               "compute it for the new cameras (cv::stereoRectify), or --rewrite leaves it out"},
    OptionHint{Code::kStaleOfLensesLost, text::Part::kFix,
               "compute it for the new cameras (cv::stereoRectify), or --rewrite leaves it out"},
    OptionHint{Code::kEachIsLeft, text::Part::kFix,
               "check their pose (fca-io show describes it); if it is right, they are not a left and a right camera"},
    OptionHint{Code::kPoorFit, text::Part::kFix,
               "fca-io models {4:shell} compares all models; --max-angle DEG if the corners are black"},
    OptionHint{Code::kBetterModelsExist, text::Part::kText, "{0}; fca-io models FILE compares all models"},
    OptionHint{Code::kFormatGiven, text::Part::kText, "--from"},
    OptionHint{Code::kMisreadBeyondLimit, text::Part::kText,
               "{0} misreads a camera by up to {1:px} px, more than --max-error {2:px}"},
    OptionHint{Code::kMissingBeyondLimit, text::Part::kText,
               "{0}: as {2}, {1:%} of the image has no pixel or a wrong one, and --max-error is given"},
    OptionHint{Code::kMissingBeyondLimit, text::Part::kFix, "--max-angle {3:.3}{4} if you need nothing beyond that angle"},
    OptionHint{Code::kInPlaceOfCircle, text::Part::kText, " in place of --lens-circle"},
    OptionHint{Code::kErrorBeyondLimit, text::Part::kText,
               "{0}: the worst pixel is off by {1:px} px, more than --max-error {2}"},
    OptionHint{Code::kLossesNotAllowed, text::Part::kText, "the target cannot carry {0:and}, and --strict is given"},
    OptionHint{Code::kSeveralFiles, text::Part::kFix, "-o FOLDER/, or -o FILE: the others go next to it"},
    OptionHint{Code::kOneCameraPerFile, text::Part::kFix,
               "-o FOLDER/, a pattern such as -o '{{stem}}.{{camera}}{2}', or --camera to choose one"},
    OptionHint{Code::kPartHasNoRoom, text::Part::kFix, "-o FOLDER/"},
    OptionHint{Code::kImuFileDropped, text::Part::kFix, "-o FOLDER/ writes it next to the cameras' files"},
    OptionHint{Code::kProvenanceHasNoRoom, text::Part::kText,
               "--provenance: the comment at the beginning of the file has no room for it"},
    OptionHint{Code::kProvenanceInBinary, text::Part::kText, "--provenance: a binary file has no comments that could hold it"},
    OptionHint{Code::kProvenanceInJson, text::Part::kText, "--provenance: JSON has no comments that could hold it"},
    OptionHint{Code::kInputRefused, text::Part::kFix, "fca-io check {0:shell} shows where, and how to fix it"},
    OptionHint{Code::kInputNotUnderstood, text::Part::kFix, "--rewrite writes a fresh file"},
    OptionHint{Code::kEditNotProven, text::Part::kFix, "--rewrite writes a fresh file"},
    OptionHint{Code::kProofOfBaseFailed, text::Part::kFix,
               "fca-io check {2:shell} checks the base file itself; if it is right, choose a simpler mode with --sensor"},
    OptionHint{Code::kVerdictNoReader, text::Part::kFix, "fca-io convert --rewrite writes the keys that {0} reads"},
    OptionHint{Code::kImuNoiseTooSmall, text::Part::kFix,
               "write the density, not its square; convert --imu-noise variance reads it so"},
    OptionHint{Code::kVerdictInvented, text::Part::kFix, "also give a file that contains it: --with FILE"},
    OptionHint{Code::kRewriteDemandsRate, text::Part::kText, "--rewrite --imu-rate HZ writes a fresh file"},
    OptionHint{Code::kRewriteDemandsSize, text::Part::kText, "--rewrite --size WIDTHxHEIGHT writes a fresh file"},
    OptionHint{Code::kRewrittenFor, text::Part::kText, "--rewrite writes one for {0}: {1:rms}{2:worst}"},
    OptionHint{Code::kRewrittenIs, text::Part::kText, "--rewrite writes a fresh file: {0:rms}{1:worst}"},
    OptionHint{Code::kNotProven, text::Part::kFix, "--rewrite writes the keys that {1} reads"},
    OptionHint{Code::kPartMissing, text::Part::kFix, "put that file there; --into needs it only for cameras that stay"},
    OptionHint{Code::kGivenSizeContradicts, text::Part::kText, "{0} has {1} x {2} px in the file, but --size is {3} x {4} px"},
    OptionHint{Code::kGivenSizeContradicts, text::Part::kFix, "give --size only for files that contain no size"},
    OptionHint{Code::kOlderVersionsRead, text::Part::kText, "for older versions --model {0}: {1:rms}{2:worst}"},
    OptionHint{Code::kFitInsideAngle, text::Part::kText, "--max-angle {0}: {1:px} px rms, not {2:px}; wrong beyond"},
    OptionHint{Code::kSayWhatWasDone, text::Part::kText,
               "--crop, --binning and --resize describe changes of the given images; leave out those that were not made"},
    OptionHint{Code::kIfScaled, text::Part::kText, "if it is the calibrated image, scaled: --resize {0}x{1}"},
    OptionHint{Code::kIfPart, text::Part::kText, "if it is a part of the calibrated image: --crop X,Y,{0},{1}"},
    OptionHint{Code::kNoiseWithoutImu, text::Part::kText, "--imu-noise is for an IMU, but the input has none"},
    OptionHint{Code::kNoiseWithoutImu, text::Part::kFix, "--with imu.yaml"},
    OptionHint{Code::kNoiseWithoutRate, text::Part::kText, "--imu-noise {0} needs the rate of {1}, and no input contains it"},
    OptionHint{Code::kNoiseWithoutRate, text::Part::kFix, "--imu-rate HZ"},
    OptionHint{Code::kRateWithoutImu, text::Part::kText, "--imu-rate is for an IMU, but the input has none"},
    OptionHint{Code::kRateWithoutImu, text::Part::kFix, "--with imu.yaml"},
    OptionHint{Code::kRateContradicts, text::Part::kText, "{0} has {1} Hz in the file, but --imu-rate is {2} Hz"},
    OptionHint{Code::kRateContradicts, text::Part::kFix, "give --imu-rate only for files that contain no rate"},
    OptionHint{Code::kCircleWithoutImage, text::Part::kText, "--lens-circle {0} names no image"},
    OptionHint{Code::kCircleWithoutImage, text::Part::kFix, "--lens-circle {0}IMAGE"},
    OptionHint{Code::kCircleOfNoCamera, text::Part::kText, "--lens-circle {0} does not name the camera of the image"},
    OptionHint{Code::kCircleOfNoCamera, text::Part::kFix, "cameras: {1}; --lens-circle {2}=IMAGE"},
    OptionHint{Code::kCircleOfUnknownCamera, text::Part::kText, "--lens-circle {0}: there is no camera '{3}'"},
    OptionHint{Code::kCircleOfUnknownCamera, text::Part::kFix, "cameras: {1}; --lens-circle {2}=IMAGE"},
    OptionHint{Code::kCircleOffCentre, text::Part::kFix,
               "check that it is this camera's lens and not a lamp; fca-io report draws it"},
    OptionHint{Code::kCircleSmall, text::Part::kFix,
               "check that it is this camera's lens and not something bright in front of it; fca-io report draws it"},
    OptionHint{Code::kCircleUncertain, text::Part::kFix,
               "check that it is a lens's edge; fca-io report draws it, and further images of brighter scenes, each with "
               "--lens-circle, show more of it"},
    OptionHint{Code::kImageWithoutCircle, text::Part::kFix,
               "give images of a bright scene, or several images; or give the angle at which the lens ends: --max-angle DEG"},
    OptionHint{Code::kImagesWithoutCircle, text::Part::kFix,
               "give images of a bright scene, or several images; or give the angle at which the lens ends: --max-angle DEG"},
    OptionHint{Code::kDifferenceBeyondLimit, text::Part::kText,
               "{0}: the worst pixel is off by {1:px} px, more than --max-error {2:px}"},
    OptionHint{Code::kPixelsMissing, text::Part::kFix, "if the lens ends earlier, give the angle: --max-angle DEG{2}"},
    OptionHint{Code::kCamerasMissing, text::Part::kFix, "--camera chooses those to compare"},
    OptionHint{Code::kInversesBeyondLimit, text::Part::kText,
               "the inverse polynomials differ by up to {0:px} px, more than --max-error {1:px}"},
    OptionHint{Code::kPoseBeyondLimit, text::Part::kText,
               "{0}, more than --strict allows (0.5 deg, and 5 mm or 5 % of the distance)"},
    OptionHint{Code::kFactBeyondLimit, text::Part::kText, "{0}, more than --strict allows (1 ms for times, else 5 %)"},
    OptionHint{Code::kWhichCamera, text::Part::kFix, "choose one with --camera: {1}"},
    OptionHint{Code::kSeveralCameras, text::Part::kFix, "choose one with --camera"},
    OptionHint{Code::kFileWithoutSize, text::Part::kFix, "give the image size: --size WxH"},
    OptionHint{Code::kCameraWithoutSize, text::Part::kFix, "give --like a file that contains one"},
    OptionHint{Code::kViewOfSeveralCameras, text::Part::kText,
               "the file for --like must have one camera, or one named {0}; this file has {1}"},
    OptionHint{Code::kLedgerSizeAsked, text::Part::kText, "nothing: the error asks for the image size (--size)"},
    OptionHint{Code::kRectifyNeedsPair, text::Part::kFix, "also give the file of the other camera: --with FILE"},
    OptionHint{Code::kRectifyNoPose, text::Part::kFix, "also give a file that contains it: --with FILE"},
    OptionHint{Code::kRectifyNothingShared, text::Part::kFix, "choose two that look in the same direction: --camera A,B"},
    OptionHint{Code::kRectifyWhichPair, text::Part::kFix, "choose the two: --camera A,B"},
    OptionHint{Code::kRectifyViewTooWide, text::Part::kFix, "--pinhole 100, or less"},
    OptionHint{Code::kRectifyNoValidPart, text::Part::kFix, "check the pose, or give the width of the view: --pinhole 90"},
    OptionHint{Code::kRectifyCentresDiffer, text::Part::kFix, "--alpha 0 or --pinhole DEG computes another view"},
    OptionHint{Code::kRectifyModelNotKnown, text::Part::kFix, "--to orbslam3 writes settings for rectified images"},
    OptionHint{
        Code::kOrbslam3LacksRectifiedPair, text::Part::kText,
        "rectified images (fca-io rectify --to orbslam2 writes their settings): before V1.0 the settings of pinhole cameras "
        "have no place for the pose between two lenses"},
    OptionHint{Code::kRectificationDropped, text::Part::kFix, "fca-io rectify --to orbslam3, ros or opencv writes it"},
    OptionHint{Code::kRectificationOfOtherImages, text::Part::kFix, "fca-io rectify computes another one"},
    OptionHint{Code::kFileExists, text::Part::kText, "{0} exists; --force overwrites it"},
};

}  // namespace

std::string_view with_options(Code code, text::Part part) {
  const auto* const hint =
      std::ranges::find_if(kHints, [&](const OptionHint& each) { return each.code == code && each.part == part; });
  return hint != kHints.end() ? hint->words : text::table_wording(code, part);
}

}  // namespace fca::cli
