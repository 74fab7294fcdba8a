// SPDX-License-Identifier: BSD-3-Clause
// Files and formats, whichever.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kUnreadable = "cannot-read";
constexpr std::string_view kUnknown = "unknown-format";
constexpr std::string_view kSayWhichFormat = "name the format, if it is one that fca-io reads";
constexpr std::string_view kStatedTwice = "stated-twice";
constexpr std::string_view kContradict = "poses-contradict";

}  // namespace

std::span<const CodeInfo> file_codes() {
  static constexpr std::array kRows = {
      // Why a file is of a format.
      clause(Code::kFormatGiven, "as given"),
      clause(Code::kFoundKey, "the key {0}"),
      clause(Code::kFoundKeys, "{0}"),
      clause(Code::kFoundTopLevel, "top-level {0}"),
      clause(Code::kFoundMatrices, "{0} with rows, cols and data"),
      clause(Code::kFoundIniSections, "sections of an .ini"),

      error(Code::kFileUnreadable, kUnreadable, "cannot read the file: {0}"),
      clause(Code::kFileMissing, "it does not exist"),
      clause(Code::kFileIsDirectory, "it is a directory"),
      clause(Code::kFileReadingFailed, "reading failed"),
      error(Code::kFileTooLarge, "too-large", "larger than {0} MiB; no calibration is"),
      error(Code::kFileEmpty, "empty-file", "the file is empty"),
      error(Code::kFileBinary, "binary-file", "a zero byte: this is not a text file", "save it as UTF-8 text"),
      error(Code::kFileUtf16, "utf-16", "the file is UTF-16 text; programs read calibrations as UTF-8",
            "save it as UTF-8: iconv -f UTF-16 -t UTF-8 FILE > NEW"),
      error(Code::kFileCrOnly, "cr-line-ends", "its lines end in CR alone: OpenCV's and OCamCalib's readers see one line",
            "end the lines in LF: tr '\\r' '\\n' < FILE > NEW"),

      error(Code::kFormatUnknown, kUnknown, "fca-io knows no format with these keys", kSayWhichFormat),
      // {0} and {1}: words that stand in it.
      error(Code::kLooksLikeMultiCol, kUnknown, "looks like MultiCol-SLAM's lens ({0} and {1}), which fca-io does not read",
            "its polynomials are OCamCalib's: write them into a calib_results.txt"),
      error(Code::kLooksLikeOmniCam, kUnknown, "looks like omni_cam's line of numbers, which fca-io does not read",
            "write a0 to a4, cx, cy, c, d, e and b0 to b11 into OCamCalib's calib_results.txt: row and column change places"),
      error(Code::kLooksLikeAria, kUnknown,
            "looks like Project Aria's calibration of a device ({0} and {1}), which fca-io does not read",
            "FisheyeRadTanThinPrism is COLMAP's RAD_TAN_THIN_PRISM_FISHEYE: f f cu cv k0 to k5 p0 p1 s0 to s3; T_Device_Camera "
            "is T_device_camera"),
      error(Code::kLooksLikeWmr, kUnknown,
            "looks like a headset's calibration (Windows Mixed Reality) ({0} and {1}), which fca-io does not read",
            "write it for OpenCV: cx and fx times the width, cy and fy times the height, k1 to k6 as they are, p2 before p1; "
            "Rt is T_camera_device"),
      error(Code::kLooksLikeDriveWorks, kUnknown, "looks like DriveWorks' rig ({0} and {1}), which fca-io does not read",
            "write its polynomial ({1}) as a camera of NVIDIA NCore: it is pixeldist_to_angle_poly with reference_poly 1; "
            "nominalSensor2Rig_FLU is T_rig_sensor, of a sensor with x ahead and z up: t in metres, roll-pitch-yaw in degrees"),
      error(Code::kLooksLikeDriveWorksForward, kUnknown, "looks like DriveWorks' rig ({0} and {1}), which fca-io does not read",
            "write its polynomial ({1}) as a camera of NVIDIA NCore: it is angle_to_pixeldist_poly with reference_poly 2; "
            "nominalSensor2Rig_FLU is T_rig_sensor, of a sensor with x ahead and z up: t in metres, roll-pitch-yaw in degrees"),
      error(
          Code::kLooksLikeIsaac, kUnknown, "looks like a camera of Isaac Sim ({0} and {1}), which fca-io does not read",
          "write its polynomial as a camera of NVIDIA NCore: k0 to k4, or fthetaPolyA to fthetaPolyE, are "
          "pixeldist_to_angle_poly with reference_poly 1; its xformOps are T_parent_camera (xformOp:transform is transposed), "
          "with y up and z back"),
      error(Code::kLooksLikeIsaacOpenCv, kUnknown,
            "looks like a camera of Isaac Sim with a lens of OpenCV's ({0} and {1}), which fca-io does not read",
            "write it for OpenCV: fx fy cx cy, imageSize, and k1 k2 p1 p2 k3 to k6 s1 to s4, or k1 to k4 of the fisheye; its "
            "xformOps are T_parent_camera (xformOp:transform is transposed), with y up and z back"),
      error(
          Code::kLooksLikeIsaacLens, kUnknown, "looks like a camera of Isaac Sim ({0} and {1}), which fca-io does not read",
          "of RadTanThinPrism, k0 to k5, p0, p1 and s0 to s3 are COLMAP's RAD_TAN_THIN_PRISM_FISHEYE; of another lens, measure "
          "rays and their pixels; its xformOps are T_parent_camera (xformOp:transform is transposed), with y up and z back"),
      error(Code::kLooksLikeEdex, kUnknown, "looks like a rig of cuVSLAM's edex ({0} and {1}), which fca-io does not read",
            "write each camera for OpenCV: focal, principal, and of brown k1 k2 k3 p1 p2; transform is T_rig_camera, with y up "
            "and z back"),
      error(Code::kLooksLikeSpectacular, kUnknown,
            "looks like Spectacular AI's calibration ({0} and {1}), which fca-io does not read",
            "write it as a Kalibr camchain: imuToCamera is T_cam_imu, kannala-brandt4 equidistant"),
      error(Code::kLooksLikeMatlab, kUnknown, "looks like MATLAB's camera parameters ({0} and {1}), which fca-io does not read",
            "write them for OpenCV: IntrinsicMatrix is transposed, and the principal point counts from 1"),
      error(
          Code::kLooksLikeMatlabFisheye, kUnknown,
          "looks like MATLAB's fisheye parameters ({0} and {1}), which fca-io does not read",
          "write them as OCamCalib's calib_results.txt: MappingCoefficients are -a0 -a2 -a3 -a4, and the centre counts from 1"),
      error(Code::kLooksLikeAutoware, kUnknown,
            "looks like Autoware's poses of sensors ({0} and {1}), which fca-io does not read",
            "its lenses are ROS camera_info; the poses are T_kit_link, of a link with x ahead"),
      error(Code::kLooksLikePhotonVision, kUnknown,
            "looks like PhotonVision's calibration ({0} and {1}), which fca-io does not read",
            "write cameraIntrinsics and distCoeffs for OpenCV, number by number"),
      error(Code::kLooksLikeR3live, kUnknown, "looks like R3LIVE's configuration ({0} and {1}), which fca-io does not read",
            "write camera_intrinsic and camera_dist_coeffs for OpenCV; camera_ext_R and camera_ext_t are T_imu_camera, of the "
            "LiDAR's IMU"),
      error(Code::kLooksLikePhone, kUnknown,
            "looks like a phone's frames (Record3D, Polycam, 3D Scanner App) ({0} and {1}), which fca-io does not read",
            "a frame is a pinhole, and its pose (poses, t_00 to t_23, cameraPoseARFrame) is T_world_camera, with y up and z "
            "back: use what its app exports for nerfstudio or COLMAP"),
      error(
          Code::kLooksLikeOwnDump, kUnknown,
          "looks like a dump of a device's calibration, in no known program's layout ({0} and {1}), which fca-io does not read",
          "write each camera for OpenCV, or read the calibration out of the device again; rotation_left_to_right (R) and "
          "translation_left_to_right (t) are T_right_left: p_right = R p_left + t"),
      error(Code::kLooksLikeMultiColRig, kUnknown,
            "looks like MultiCol-SLAM's poses of its cameras ({0} and {1}), which fca-io does not read",
            "its lenses are in other files (InteriorOrientationFisheye0.yaml); each pose takes points of the camera to the "
            "rig: three Cayley parameters, and a translation"),
      error(Code::kLooksLikeOv2Slam, kUnknown, "looks like OV2SLAM's settings ({0} and {1}), which fca-io does not read",
            "write them as a Kalibr camchain: body_T_cam0 is T_imu_cam, and k1l to p2l are radtan's"),
      error(Code::kLooksLikeD2Slam, kUnknown, "looks like D2SLAM's settings ({0} and {1}), which fca-io does not read",
            "give the camera files that they name; body_T_cam0 is T_imu_cam"),
      error(Code::kLooksLikeLarvio, kUnknown, "looks like LARVIO's configuration ({0} and {1}), which fca-io does not read",
            "write it as a Kalibr camchain: its T_cam_imu is Kalibr's"),
      error(Code::kLooksLikeFastLivoPoses, kUnknown,
            "looks like FAST-LIVO's configuration ({0} and {1}), which fca-io does not read",
            "its camera is in another file (camera_pinhole.yaml); Rcl and Pcl are T_cam_lidar"),
      error(Code::kLooksLikeCuvslamRig, kUnknown,
            "looks like a rig of cuVSLAM's examples ({0} and {1}), but no camera in it has the keys that they read",
            "write transform, three rows of four numbers, in left_camera and right_camera; or focal_length in rgb_camera"),
      error(Code::kLooksLikeDepthaiBoard, kUnknown, "looks like the design of a DepthAI board, not a calibration ({0} and {1})",
            "save the calibration of the device's EEPROM"),
      error(Code::kLooksLikeTheia, kUnknown, "looks like Theia's priors of images ({0} and {1}), which fca-io does not read",
            "write the lens as an OpenCV file: fy is focal_length times aspect_ratio"),
      error(Code::kLooksLikePyOcamCalib, kUnknown, "looks like py-OCamCalib's JSON ({0} and {1}), which fca-io does not read",
            "write it as a calib_results.txt: its Taylor coefficients are OCamCalib's direct polynomial"),
      error(
          Code::kLooksLikeAdapterOcam, kUnknown,
          "looks like Fisheye-Calib-Adapter's file of an OCamCalib camera ({0} and {1}), which fca-io does not read",
          "write it as a calib_results.txt: unprojection is the direct polynomial with the other sign, projection the inverse"),
      error(Code::kLooksLikePlainLists, kUnknown,
            "looks like OpenCV's numbers in plain lists, which cv::FileStorage does not read as a matrix ({0} and {1}); fca-io "
            "does not read them, either",
            "write them as !!opencv-matrix, or as ROS camera_info"),
      error(Code::kLooksLikeRtabMap, kUnknown, "looks like RTAB-Map's parameters, not a calibration ({0} and {1})",
            "its cameras are in other files, ROS camera_info"),
      error(Code::kLooksLikeCalibrationInput, kUnknown,
            "looks like the settings of OpenCV's calibration program, not a calibration ({0} and {1})",
            "give the file that the program wrote"),
      error(Code::kLooksLikeImageList, kUnknown, "looks like a list of images, not a calibration ({0} and {1})",
            "give the file that was made from them"),
      error(Code::kLooksLikePoseAlone, kUnknown,
            "looks like one pose alone, 12 numbers as in KITTI-360's calib_cam_to_velo.txt, which fca-io does not read",
            "give perspective.txt and calib_cam_to_pose.txt; calib_cam_to_velo.txt is T_velo_cam, of image_00; other files "
            "with 12 numbers do not give their direction"),
      error(Code::kLooksLikeKittiRawPose, kUnknown,
            "looks like KITTI's pose of one sensor at another (R: and T:), which fca-io does not read",
            "give calib_cam_to_cam.txt; calib_velo_to_cam.txt is T_cam_velo (x_cam = R x_velo + T), calib_imu_to_velo.txt "
            "T_velo_imu"),
      error(
          Code::kLooksLikeRealsenseStream, kUnknown,
          "looks like the intrinsics of one stream of a RealSense camera, without its name ({0} and {1})",
          "put the stream's name before them in JSON, {{\"color\": {{...}}}}, or write them for OpenCV, with width and height: "
          "inverse_brown_conrady with zeros is a pinhole; they contain no pose"),
      error(Code::kLooksLikeMatlabPrint, kUnknown,
            "looks like MATLAB's printout of camera parameters ({0} and {1}), which fca-io does not read",
            "write its numbers for OpenCV, those of a fisheye as OCamCalib's calib_results.txt; let MATLAB print the numbers "
            "of each [1x2 double], too; the principal point counts from 1; the printout contains no pose"),
      error(Code::kLooksLikeRovio, kUnknown, "looks like ROVIO's configuration ({0} and {1}), which fca-io does not read",
            "its lenses are in the files that CalibrationFile names, ROS camera_info; qCM is the rotation of T_camera_imu "
            "(Hamilton), MrMC the translation of T_imu_camera"),
      error(Code::kLooksLikeOpenMvg, kUnknown, "looks like openMVG's sfm_data ({0} and {1}), which fca-io does not read",
            "export it for COLMAP (openMVG_main_openMVG2Colmap); of an image's pose, rotation is that of T_camera_world, and "
            "center is where the camera is in the world"),
      error(Code::kLooksLikeColmapImages, kUnknown, "looks like COLMAP's poses of images, not a calibration ({0} and {1})",
            "give cameras.txt, and rigs.txt if there is one; QW to TZ are T_camera_world, of one image"),
      error(Code::kLooksLikeKalibrReport, kUnknown, "looks like Kalibr's text report with something before it ({0} and {1})",
            "give the report as Kalibr wrote it, with its camchain; T_1_0 is T_cam1_cam0, T_ci T_cam_imu"),
      error(Code::kLooksLikeKalibrTarget, kUnknown, "looks like Kalibr's calibration target, not a calibration ({0} and {1})",
            "give the camchain that Kalibr wrote"),
      error(Code::kLooksLikeApex, kUnknown,
            "looks like a camera of apex-camera-models, with Kalibr's keys and other lenses ({0} {1}), which fca-io does not "
            "read",
            "write it as a Kalibr camchain: kannala_brandt is pinhole with equidistant; double_sphere is ds, but its list ends "
            "in alpha xi (in older files xi alpha), while Kalibr's begins with xi alpha; the file contains no pose"),
      error(Code::kLooksLikeKimeraTemplate, kUnknown,
            "looks like Kimera-VIO's template of a camera's file, whose numbers are not filled in ({0} and {1})",
            "give the Kalibr camchain that it is filled in from; T_BS is T_body_camera"),
      error(
          Code::kLooksLikeDepthaiByName, kUnknown,
          "looks like DepthAI's calibration in another spelling, cameraData as an object ({0} and {1}), which fca-io does not "
          "read",
          "write cameraData as a device's EEPROM has it, pairs of a socket's number and its camera (CAM_A is 0, CAM_B 1); "
          "extrinsics take points of a camera to toCameraSocket's: p_to = R p_this + t, in centimetres"),
      error(Code::kFormatAmbiguous, "ambiguous-format", "could be {0:or}", "name the format"),
      clause(Code::kFormatCandidate, "{0} ({1})"),

      error(Code::kTooManyCameras, "too-many-cameras", "{0} cameras; fca-io reads at most {1} of one rig", "split the file"),
      error(Code::kCameraInMainFile, kStatedTwice, "the camera {0} is here and in the main file"),
      error(Code::kImuInMainFile, kStatedTwice, "the IMU {0} is here and in the main file, with different numbers"),
      // {0} and {1}: frames, {3}: the largest difference.
      warning(Code::kPoseInTwoFiles, kContradict,
              "T_{0}_{1} is given here and in {2}, and the two differ by up to {3:.3} in an element",
              "fca-io uses the one of {4}; remove the one that is wrong"),
      warning(Code::kPoseContradictsOthers, kContradict,
              "T_{0}_{1} contradicts the other poses ({2}): what follows from them differs by {3:.3} deg and {4}",
              "one of them is wrong; fca-io uses poses of the file before computed ones"),
      warning(Code::kPoseOfEachMissing, "pose-unstated",
              "the files of {0} give the same pose for each camera, as a file of one camera does: their relative poses are "
              "unknown"),

      // {0}: a camera.
      bad_request(Code::kFormatHasNoModel, "model-not-storable", "{0}: {1} has no {2} model",
                  "convert the camera to a model of this format first"),
      bad_request(Code::kFormatHasNoValue, "parameter-not-storable",
                  "{0}: {1} = {2} cannot be stored as {3} ({4}); it must lie in [{5}, {6}]",
                  "convert the camera to this format's ranges first"),
      // A table of rays.
      error(Code::kRaysWrongSyntax, "wrong-syntax", "a table of rays consists of lines of numbers: u v x y z"),
      error(Code::kTooFewRays, "wrong-length", "too few rays: {0}; at least {1} are needed",
            "measure some hundred rays, spread over the image"),
      error(Code::kLensWithoutTable, "not-a-camera",
            "{0}: these numbers do not describe a usable lens: its axis has no pixel, or fewer than {1} rays reach the image",
            "copy the numbers again from their source; one is probably missing or in the wrong place"),
      error(Code::kRaysWithoutCentre, "not-a-camera",
            "the rays nearest to the axis (x = y = 0, z > 0) do not determine a focal length and principal point",
            "check the columns u v x y z: rays are x right, y down, z forward"),
      error(Code::kRaysOfOtherImage, "size-unlike-centre",
            "the pixels of the rays run from {0:.5} to {1:.5} and from {2:.5} to {3:.5}: they do not fit an image of {4} x {5}",
            "u and v are pixels, from (0, 0) at the centre of the first one; give the size of these images"),
      error(Code::kRaysOfOtherColumns, "wrong-syntax", "the columns are in another order", "write them as u v x y z"),
      error(Code::kRayWithoutDirection, "out-of-range", "x, y and z are 0 or too large: that is not a direction"),
      error(Code::kPixelOutOfRange, "out-of-range", "no image has the pixel ({0}, {1})"),

      bad_request(Code::kFormatIsReadOnly, "format-read-only", "fca-io reads {0}, but does not write it"),
      bad_request(Code::kFormatNeedsCamera, "no-camera", "{0}: this format needs a camera, but the input has none"),
      error(Code::kFormatNeedsSize, "image-size-missing", "{0}: {1} and the input has no size", "give the image size"),
      error(Code::kNotWrittenBecause, "not-written", "{0} cannot be written: {1}"),

      // {0}: a key.
      bad_request(Code::kSetWrongType, "set-wrong-type", "{0} wants {1}, not '{2}'"),
      bad_request(Code::kSetOutOfRange, "set-out-of-range", "{0} wants {1}, not {2}"),
      bad_request(Code::kSetNoSingleValue, "set-unknown-key", "you can set only single values, but '{0}' is {1}",
                  "change the input, if it is a part of the calibration"),
      bad_request(Code::kSetUnknownKey, "set-unknown-key", "the file written has no value under '{0}'{1}"),
      clause(Code::kSetDidYouMean, "; did you mean {0:or}?"),
      bad_request(Code::kSetLayout, "set-contradicts",
                  "{0} sets how the file stores its calibration; another value would destroy it", "leave it unchanged"),
      bad_request(Code::kSetCalibration, "set-contradicts", "{0} is a part of the calibration, and the input has another value",
                  "change the input; for images of another size, resize or crop the images"),
      clause(Code::kWantsFiniteNumber, "a number that a double can hold"),
      clause(Code::kWantsWholeNumber, "a whole number"),
      clause(Code::kWantsNumber, "a number"),
      clause(Code::kWantsWord, "a word"),
      clause(Code::kWantsPlainWord, "a word of letters, digits and ._-+/~"),
      clause(Code::kWantsPlainText, "letters, digits and ._-+/~ only"),
      clause(Code::kWantsNumberAboveZero, "a number above 0"),
      clause(Code::kWantsNumberBetween, "a number from {0} to {1}"),
      clause(Code::kValueIsGroup, "a group of values"),
      clause(Code::kIdentity, "identity"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
