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

      error(Code::kColmapWrongSyntax, "wrong-syntax", "a cameras.txt consists of lines of words; this file does not"),
      with_consequence(error(Code::kColmapNoCamera, "wrong-count", "no line of the file is a camera",
                             "write  CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]  for each camera"),
                       kNoCamera),
      with_consequence(error(Code::kColmapShortLine, "wrong-count", "the line has {0} words, but a camera has more than four",
                             "write  CAMERA_ID MODEL WIDTH HEIGHT  and the model's parameters"),
                       kStops),
      with_consequence(error(Code::kColmapIdRange, "out-of-range", "{0} is {1}, but COLMAP counts from 0 to 4294967294",
                             "images.txt names cameras by ids from 1"),
                       "No image has this camera."),
      with_consequence(
          error(Code::kColmapIdTwice, "duplicate-key", "another camera above has the CAMERA_ID {0}", "give it another id"),
          "COLMAP 4 stops, and 3.8 keeps one of the two."),
      error(Code::kColmapUnknownModel, "unknown-model", "COLMAP has no camera model {0}", "write {1:or}"),
      error(Code::kColmapModelNotRead, "unknown-model", "fca-io does not read cameras of COLMAP's model {0}: {1}",
            "calibrate with OPENCV, FULL_OPENCV or OPENCV_FISHEYE"),
      clause(Code::kColmapEquirectangular, "such an image shows all directions and has no lens"),
      with_consequence(error(Code::kColmapParameterCount, "wrong-count", "{0} has {1} parameters, but the line has {2} numbers",
                             "write  {3}"),
                       kStops),
      with_consequence(error(Code::kColmapEucmAlpha, "out-of-range", "alpha is {0}, but EUCM's is between 0 and 1"),
                       "COLMAP reads the line, but its mapper drops the camera and its images."),
      about_reader(warning(Code::kColmapAfterParameters, "program-refuses",
                           "'{0}' after the parameters: COLMAP 3.8 stops, and 4 ignores it", "remove it")),
      about_reader(warning(Code::kColmapBlanks, "program-refuses",
                           "more than one space, or a TAB, between two words: COLMAP 3.8 stops, and 4 reads it",
                           "write one space between two words")),

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
      error(Code::kColmapNoFolder, "out-of-range", "image_prefix is not a folder of images: '{0}'",
            "write the folder with a '/' after it"),
      with_consequence(error(Code::kColmapPrefixTwice, "duplicate-key",
                             "another camera above has its images in the same folder: {0}", "give each camera its own folder"),
                       "COLMAP takes images for those of the wrong camera."),
      with_consequence(
          error(Code::kColmapReferenceCount, "wrong-count", "{0} cameras have ref_sensor: true, but a rig has one reference",
                "write  \"ref_sensor\": true  for the camera to which the poses refer"),
          kNoRig),
      with_consequence(error(Code::kColmapReferencePose, "wrong-count",
                             "{0} is the reference, to which the poses refer, but it has a pose itself", "remove it"),
                       kNoRig),
      warning(Code::kColmapHalf, "missing-key", "{0} without {1}: COLMAP ignores it", "give both, or none"),
      with_consequence(
          about_poses(warning(Code::kColmapQuaternionLength, "not-a-rotation",
                              "{0} has length {1:.4}, not 1, and COLMAP does not normalise it", "divide its numbers by that")),
          "The rotation also scales points."),
      with_consequence(error(Code::kColmapNoRotation, "not-a-rotation", "{0} has length {1:.4} and is not a rotation",
                             "write four numbers w x y z whose squares sum to 1"),
                       "COLMAP cannot place the camera."),
      clause(Code::kColmapRigHeadline, "a rig_config.json for COLMAP's rig_configurator"),

      // cameras.bin
      clause(Code::kColmapBinary, "cameras of COLMAP's models in binary"),
      clause(Code::kColmapBinaryHeadline, "a cameras.bin for COLMAP"),

      // rigs.txt, rigs.bin
      clause(Code::kColmapRigLines, "rigs of COLMAP's, each with its sensors"),
      with_consequence(error(Code::kColmapNoRigLine, "wrong-count", "no line of the file is a rig", kRigLine), kStopsAtRig),
      with_consequence(error(Code::kColmapRigShort, "wrong-count", "the rig ends where {0} must be", kRigLine), kStopsAtRig),
      about_reader(warning(Code::kColmapRigAfterLast, "wrong-count",
                           "{0} words after the {1} sensors that NUM_SENSORS counts: COLMAP ignores them",
                           "count the sensors again")),
      with_consequence(
          error(Code::kColmapRigIdTwice, "duplicate-key", "another rig above has the RIG_ID {0}", "give it another id"),
          kStopsAtRig),
      with_consequence(error(Code::kColmapSensorType, "out-of-range", "{0} is not a type of sensor", "write CAMERA or IMU"),
                       kStopsAtRig),
      with_consequence(error(Code::kColmapSensorTwice, "duplicate-key", "another rig above contains {0} {1}",
                             "a sensor is part of one rig, once"),
                       "COLMAP stops here, or puts the images of two rigs in one place."),
      error(Code::kColmapPoseFlag, "out-of-range", "HAS_POSE is {0}",
            "write 1 before a pose of seven numbers, 0 if there is none"),
      clause(Code::kColmapRigsHeadline, "COLMAP's file of rigs, with the poses of their sensors"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
