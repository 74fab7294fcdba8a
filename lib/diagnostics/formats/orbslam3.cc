// SPDX-License-Identifier: BSD-3-Clause
// ORB-SLAM3's settings, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

/// {0}: Camera.type; {1}, {2}: a type that the style knows, and clauses of the others.
constexpr std::string_view kUnknownType = "settings of this style do not know Camera.type '{0}', only {1}{2}";
constexpr std::string_view kIsItComplete = "check whether the file is complete";
constexpr std::string_view kSetAnother = "set the key to another value";
constexpr std::string_view kFileOfItsOwn = "write it to a file of its own";

}  // namespace

std::span<const CodeInfo> orbslam3_codes() {
  static constexpr std::array kRows = {
      clause(Code::kOrbslam3AlphaAboveHalf, "these programs reject every point below alpha = 0.5"),
      clause(Code::kOrbslam3Upstreams, "upstream's"),
      // As read.
      error(Code::kOrbslam3NoKeys, "not-settings", "no keys at the top level"),
      warning(Code::kOrbslam3VersionMissing, "file-version-missing",
              "Camera1.* keys without File.version: ORB-SLAM3 runs its old parser and finds no camera",
              "add the line  File.version: \"1.0\""),
      warning(Code::kOrbslam3VersionNotString, "file-version-not-string",
              "File.version is not the string \"1.0\": ORB-SLAM3 silently runs its old parser", "write \"1.0\" with quotes"),
      error(Code::kOrbslam3ModelOfStella, "unknown-model",
            "Camera.model '{0}' is a model of stella_vslam; of its settings only 'perspective' is read"),
      error(Code::kOrbslam3FisheyeWithoutType, "unknown-model",
            "k1 to k4 without p1 and p2 are a fisheye's, and there is no Camera.type",
            "if they are Kannala-Brandt's, write  Camera.type: \"KannalaBrandt8\""),
      error(Code::kOrbslam3TypeMissing, "missing-key", "there is no Camera.type",
            "write \"PinHole\", \"Rectified\" or \"KannalaBrandt8\""),
      error(Code::kOrbslam3TypeUnknown, "unknown-model", kUnknownType),
      error(Code::kOrbslam3TypeOfForks, "unknown-model", kUnknownType,
            "forks read this type from files with Camera.fx (not Camera1.fx) and without File.version"),
      error(Code::kOrbslam3KeyMissing, "missing-key", "there is no {0}"),
      reader_warning(Code::kOrbslam3StopsWithoutKeys, "missing-key", "there is no {0}: ORB-SLAM3 stops", kIsItComplete),
      warning(Code::kOrbslam3KeysReadAsZero, "missing-key", "there is no {0}; read as 0, as ORB-SLAM2 does (ORB-SLAM3 stops)",
              kIsItComplete),
      warning(Code::kOrbslam3EucmWithoutType, "eucm-without-type",
              "no Camera.type, so this is read as ORB-SLAM2's radial-tangential model; but k1 and k2 look like EUCM's alpha "
              "and beta, as fisheye-ORB-SLAM and slam_no_opt store them",
              "if so, add the line  Camera.type: \"EUCM\""),
      warning(Code::kOrbslam3PoseMissing, "pose-missing", "there is a second camera, but no {0}"),
      error(Code::kOrbslam3PoseOfOtherSize, "wrong-length", "{0} must be 4 x 4 (or 3 x 4)"),
      error(Code::kOrbslam3RightLensOfOtherSize, "wrong-length", "RIGHT.K must be 3 x 3 and RIGHT.D hold at least 4 numbers"),
      error(Code::kOrbslam3RightPoseOfOtherSize, "wrong-length", "CAMERA.R must be 3 x 3 and CAMERA.T hold 3 numbers"),

      // What cannot be written.
      error(Code::kOrbslam3NoCamera, "no-camera", "ORB-SLAM3 settings need a camera, but the input has none"),
      error(Code::kOrbslam3ModelNotStorable, "model-not-storable", "{0}: these settings cannot hold {1}",
            "take another model: ORB-SLAM2's settings hold radtan, slam_no_opt's eucm"),
      error(Code::kOrbslam3SizeMissing, "image-size-missing",
            "{0}: the settings need Camera.width and Camera.height, but the input has none", "give the image size"),
      error(Code::kOrbslam3SizesDiffer, "image-sizes-differ",
            "the settings have one image size for both cameras, but theirs differ"),
      error(Code::kOrbslam3TypesDiffer, "models-differ",
            "the settings have one Camera.type for both cameras, but theirs differ", "convert both to one model"),
      error(Code::kOrbslam3FrameRateNotStorable, "rate-not-storable",
            "a frame rate of {0} Hz cannot be stored: Camera.fps is a positive int"),
      error(Code::kOrbslam3ImuRateNotStorable, "rate-not-storable", "an IMU rate of {0} Hz cannot be stored in IMU.Frequency"),
      bad_request(Code::kOrbslam3UnknownMode, "unknown-sensor", "there is no sensor mode '{0}'"),
      bad_request(Code::kOrbslam3ModeNotServed, "sensor-not-served", "the sensor mode {0} lacks {1}"),
      bad_request(Code::kOrbslam3UnknownLayout, "unknown-layout", "ORB-SLAM3 settings have no layout '{0}'"),

      // Stereo pairs.
      error(Code::kOrbslam3PairNotStorable, "pose-not-storable",
            "settings of pinhole cameras in the style before ORB-SLAM3 V1.0 are for rectified pairs: they have no place for "
            "the pose between unrectified cameras, nor for a second camera's own intrinsics",
            "the layout v1 has both; the mode mono takes the first camera alone; or rectify the images"),
      // An error in a file for ORB-SLAM; the other programs that it is converted to do not mind.
      about_reader(error(Code::kOrbslam3PairVertical, "stereo-vertical",
                         "{0} sits {1:.3} cm {2} {3}, and ORB-SLAM3 looks for a pair's matches along the rows only",
                         "turn both images by 90 deg and calibrate those; the mode mono takes one camera")),
      warning(Code::kOrbslam3PairNotRectified, "not-rectified",
              "one camera with a baseline means a rectified pair, but {0} has distortion: ORB-SLAM3 would look for matches "
              "along the rows of images that are not rectified",
              "give the camera of the rectified images (P1 of cv::stereoRectify); the mode mono leaves the pair out"),
      warning(Code::kOrbslam3PairNotSynchronous, "pair-not-synchronous",
              "the time offsets of {0} and {1} differ by {2:.3} ms, but ORB-SLAM3 assumes that a pair's two images are taken "
              "at the same moment",
              "if both images have one exposure, give both cameras one offset"),
      warning(Code::kOrbslam3NothingShared, "nothing-shared",
              "{0} and {1} see nothing in common, but ORB-SLAM3 matches a pair only where both see",
              "check their pose; the mode mono takes one camera"),

      // Files that are written into.
      warning(Code::kOrbslam3OtherBaseline, "baseline-contradicts",
              "Camera.bf of the base is {0}, but its poses give {1:.4}: the written file follows the poses",
              "check which of the two is right"),
      warning(Code::kOrbslam3PoorerMode, "poorer-mode",
              "the base is for {0}, but with the input's cameras it serves only {1}; it lacks {2}"),
      note(Code::kOrbslam3ColumnsKept, "columns-kept",
           "{0}: the base's values stay; the values in brackets follow from the poses and fields of view", kSetAnother),
      clause(Code::kOrbslam3KeptColumn, "{0} {1} ({2})"),
      note(Code::kOrbslam3ColumnsComputed, "columns-computed",
           "{0} of the base are for other images, so the columns are recomputed", kSetAnother),
      clause(Code::kOrbslam3GoneColumn, "{0} {1}"),

      // What a rig lacks for a sensor mode.
      clause(Code::kOrbslam3LacksSecond, "a second camera"),
      clause(Code::kOrbslam3LacksSecondOrBaseline, "a second camera, or the baseline for one of a rectified pair"),
      clause(Code::kOrbslam3LacksSecondRectified,
             "a second camera: one camera and a baseline are a pair only where the images are rectified, without distortion, "
             "and {0} is {1} with distortion (rectify with cv::stereoRectify, or take the mode rgbd for a depth sensor)"),
      clause(Code::kOrbslam3LacksRectifiedPair,
             "rectified images: before V1.0 the settings of pinhole cameras have no place for the pose between two lenses"),
      clause(Code::kOrbslam3LacksPose, "the pose of {0} to {1}"),
      clause(Code::kOrbslam3LacksOneSize, "one image size for both cameras"),
      clause(Code::kOrbslam3LacksBaseline, "the baseline"),
      clause(Code::kOrbslam3LacksBaselineOfOne, "the baseline of {0} alone"),
      clause(Code::kOrbslam3LacksLensForDepth,
             "a lens that ORB-SLAM3 takes in this mode: with KannalaBrandt8 it crashes (not in the mode rgbd)"),
      clause(Code::kOrbslam3LacksInertialMode, "an inertial mode in {0}"),
      clause(Code::kOrbslam3LacksImuPose, "the pose of {0} to the IMU (T_cam_imu, in Kalibr's camchain-imucam.yaml)"),
      clause(Code::kOrbslam3LacksImu, "the IMU's noise and rate"),
      clause(Code::kOrbslam3LacksImuNoise, "the IMU's noise densities and random walks"),
      clause(Code::kOrbslam3LacksImuRate, "the IMU's rate (update_rate)"),
      clause(Code::kOrbslam3Further, ", {0}"),
      clause(Code::kOrbslam3AndLast, " and {0}"),

      // What the settings cannot hold.
      loss(Code::kOrbslam3FrameRateRounded, "frame-rate-rounded", "{2} Hz", "{1} must be an int: {3} is written",
           "give another frame rate"),
      loss(Code::kOrbslam3ImuRateRounded, "imu-rate-rounded", "{2} Hz", "{1} must be an int in this style: {3} is written",
           "nothing to do below one percent: the noise scales with the square root of the rate"),
      loss(Code::kOrbslam3SecondCameraDropped, "camera-dropped", "{0}", "{2} settings hold one camera", kFileOfItsOwn),
      loss(Code::kOrbslam3ThirdCameraDropped, "camera-dropped", "{0}", "{2} settings hold two cameras", kFileOfItsOwn),
      clause(Code::kOrbslam3DelayNotGiven, "the settings do not contain it ({0})"),
      clause(Code::kOrbslam3NoKeyForIt, "{0} has no key for it"),
      clause(Code::kOrbslam3TopicsOnCommandLine, "{0} takes topics on its command line"),
      loss(Code::kOrbslam3ImageTopicDropped, "topic-dropped", "{0} {2}", "the keys of the calibration do not hold it",
           "the files that come with slam_no_opt name it in a line of its own: imagetopic: \"{2}\""),
      loss(Code::kOrbslam3ImuDropped, "imu-dropped", "{0} noise and rate", "{2}",
           "keep its file; as Kalibr's a complete IMU is a file of its own"),
      clause(Code::kOrbslam3NoKeysForImu, "slam_no_opt has no keys for them"),
      clause(Code::kOrbslam3NoImu, "{0} settings hold no IMU"),
      clause(Code::kOrbslam3OneImu, "the settings hold one IMU"),
      loss(Code::kOrbslam3BaselineDropped, "baseline-dropped", "{1} {2} m", "{3} settings hold none", "the mode rgbd holds it"),
      clause(Code::kOrbslam3NoSuchKey, "{0} settings have no such key"),
      clause(Code::kOrbslam3NoPlace, "the settings have no place for it"),
      clause(Code::kOrbslam3NoPlaceInNew, "the new settings have no place for it"),

      // Headlines: who reads the file ({0} programs, {1} how the stock program's is to be had), in which mode, and what a
      // richer
      // one lacks.
      clause(Code::kOrbslam3Headline, "{0}, {1}{2}"),
      clause(Code::kOrbslam3ModeLacks, "; {0} lacks {1}"),
      clause(Code::kOrbslam3ReadBy, "read by {0}, NOT by stock ORB-SLAM3{1}"),
      clause(Code::kOrbslam3For, "settings for {0}"),
      clause(Code::kOrbslam3ForNotStock, "settings for {0}, NOT for stock ORB-SLAM3{1}"),
      clause(Code::kOrbslam3StyleBefore, "settings for {0} in its older layout"),
      clause(Code::kOrbslam3StockByModel, " (another model for that)"),
      clause(Code::kOrbslam3StockByLayout, " (the layout v1 for that)"),

      // What to do, and why.
      clause(Code::kOrbslam3NoPair, "; not stereo: {0} and {1} have less than a quarter of their images in common"),
      clause(Code::kOrbslam3NoRows,
             "; not stereo: {0} and {1} sit one above the other, and its matches of a pair lie next to each other"),
      clause(Code::kOrbslam3FirstIsLeft, "ORB-SLAM3 takes the first camera of a stereo pair for the left one"),
      clause(Code::kOrbslam3Layouts,
             "v1 (stock V1.0), v1-common (with one k1 to k4 for two fisheyes, as V1.0 uses them), old (before V1.0), orbslam2 "
             "or slam_no_opt (default: the input's, else what V1.0 reads best)"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
