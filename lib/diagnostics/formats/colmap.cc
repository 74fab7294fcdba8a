// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras.txt, as read and written.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kStops = "COLMAP stops here, and reads no camera.";
constexpr std::string_view kNoRig = "COLMAP's rig_configurator stops here.";
constexpr std::string_view kStopsAtRig = "COLMAP stops here, and does not open the folder.";
constexpr std::string_view kRigLine =
    "RIG_ID NUM_SENSORS TYPE ID, and for each further sensor  TYPE ID HAS_POSE [QW QX QY QZ TX TY TZ]";
constexpr std::string_view kNoCamera = "COLMAP has no camera for its images.";

}  // namespace

std::span<const CodeInfo> colmap_codes() {
  static constexpr std::array kRows = {
      // What speaks for the format.
      clause(Code::kColmapNamedModel, "a line of a camera whose model is COLMAP's {0}"),
      clause(Code::kColmapHeader, "a comment with CAMERA_ID, MODEL, WIDTH and PARAMS"),

      error(Code::kColmapWrongSyntax, "wrong-syntax", "a cameras.txt is one file of lines; this is none"),
      with_consequence(error(Code::kColmapNoCamera, "wrong-count", "no line of the file is a camera",
                             "write  CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]  for each camera"),
                       kNoCamera),
      with_consequence(error(Code::kColmapShortLine, "wrong-count", "{0} words, and a camera has more than four",
                             "write  CAMERA_ID MODEL WIDTH HEIGHT  and the model's parameters"),
                       kStops),
      with_consequence(error(Code::kColmapIdRange, "out-of-range", "{0} is {1}, and COLMAP counts from 0 to 4294967294",
                             "images.txt names cameras by ids from 1"),
                       "No image has this camera."),
      with_consequence(
          error(Code::kColmapIdTwice, "duplicate-key", "a camera with CAMERA_ID {0} stands above", "give it another id"),
          "COLMAP 4 stops, and 3.8 keeps one of the two."),
      error(Code::kColmapUnknownModel, "unknown-model", "COLMAP has no camera model {0}", "{1:or}"),
      error(Code::kColmapModelNotRead, "unknown-model", "fca-io does not read cameras of COLMAP's model {0}: {1}",
            "calibrate with OPENCV, FULL_OPENCV or OPENCV_FISHEYE"),
      clause(Code::kColmapEquirectangular, "such an image shows all directions and has no lens"),
      with_consequence(error(Code::kColmapParameterCount, "wrong-count", "{0} has {1} parameters, and the line has {2} numbers",
                             "they are  {3}"),
                       kStops),
      with_consequence(error(Code::kColmapEucmAlpha, "out-of-range", "alpha is {0}, and EUCM's lies from 0 to 1"),
                       "COLMAP reads the line, but its mapper drops the camera and its images."),
      about_reader(warning(Code::kColmapAfterParameters, "program-refuses",
                           "'{0}' after the parameters: COLMAP 3.8 stops, and 4 ignores it", "remove it")),
      about_reader(warning(Code::kColmapBlanks, "program-refuses",
                           "more than one blank, or a tab, between two words: COLMAP 3.8 stops, and 4 reads it",
                           "one blank between two words")),

      clause(Code::kColmapDemandsSize, "the line of a camera contains its image size"),
      clause(Code::kColmapNoK3, "COLMAP's OPENCV has no k3"),
      clause(Code::kColmapNoPlace, "a cameras.txt has no place for it"),
      clause(Code::kColmapHeadline, "a cameras.txt for COLMAP"),

      // rig_config.json
      clause(Code::kColmapRigs, "a list of rigs whose cameras have an image_prefix"),
      with_consequence(error(Code::kColmapNoRig, "wrong-syntax", "no list of rigs, each an object with its cameras"), kNoRig),
      with_consequence(error(Code::kColmapOldRigs, "missing-key",
                             "{0} is a key of rig_bundle_adjuster's file of rigs, which COLMAP read until version 3.11",
                             "write  \"ref_sensor\": true  for the reference, and no ids of cameras"),
                       kNoRig),
      error(Code::kColmapNoFolder, "out-of-range", "image_prefix is no folder of images: '{0}'",
            "the folder with a '/' after it"),
      with_consequence(
          error(Code::kColmapPrefixTwice, "duplicate-key",
                "a camera whose images are in a folder of that name stands above: {0}", "give each camera a folder"),
          "COLMAP takes images for those of the wrong camera."),
      with_consequence(
          error(Code::kColmapReferenceCount, "wrong-count", "{0} cameras have ref_sensor: true, and a rig has one reference",
                "write  \"ref_sensor\": true  for the camera from which the poses are counted"),
          kNoRig),
      with_consequence(error(Code::kColmapReferencePose, "wrong-count",
                             "{0} is the reference, from which poses are counted, and has a pose of its own", "remove it"),
                       kNoRig),
      warning(Code::kColmapHalf, "missing-key", "{0} without {1}: COLMAP ignores it", "give both, or none"),
      with_consequence(
          about_poses(warning(Code::kColmapQuaternionLength, "not-a-rotation",
                              "{0} has length {1:.4}, not 1, and COLMAP does not normalise it", "divide its numbers by that")),
          "The rotation scales what it turns."),
      with_consequence(error(Code::kColmapNoRotation, "not-a-rotation", "{0} has length {1:.4} and is no rotation",
                             "four numbers w x y z whose squares sum to 1"),
                       "Such a pose places the camera nowhere."),
      clause(Code::kColmapRigHeadline, "a rig_config.json for COLMAP's rig_configurator"),

      // cameras.bin
      clause(Code::kColmapBinary, "cameras of COLMAP's models in binary"),
      clause(Code::kColmapBinaryHeadline, "a cameras.bin for COLMAP"),

      // rigs.txt, rigs.bin
      clause(Code::kColmapRigLines, "rigs of COLMAP's, each with its sensors"),
      with_consequence(error(Code::kColmapNoRigLine, "wrong-count", "no line of the file is a rig", kRigLine), kStopsAtRig),
      with_consequence(error(Code::kColmapRigShort, "wrong-count", "the rig ends where {0} is wanted", kRigLine), kStopsAtRig),
      about_reader(warning(Code::kColmapRigBehind, "wrong-count",
                           "{0} words after the {1} sensors that NUM_SENSORS counts: COLMAP ignores them",
                           "count the sensors again")),
      with_consequence(
          error(Code::kColmapRigIdTwice, "duplicate-key", "a rig with RIG_ID {0} stands above", "give it another id"),
          kStopsAtRig),
      with_consequence(error(Code::kColmapSensorType, "out-of-range", "{0} is no type of sensor", "CAMERA or IMU"),
                       kStopsAtRig),
      with_consequence(error(Code::kColmapSensorTwice, "duplicate-key", "{0} {1} stands in a rig above",
                             "a sensor is part of one rig, once"),
                       "COLMAP stops here, or has the images of two rigs in one place."),
      error(Code::kColmapPoseFlag, "out-of-range", "HAS_POSE is {0}",
            "1 before a pose of seven numbers, 0 where there is none"),
      clause(Code::kColmapRigsHeadline, "COLMAP's file of rigs: how its sensors sit to each other"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
