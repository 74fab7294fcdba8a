// SPDX-License-Identifier: BSD-3-Clause
// What readers and writers of formats that are tables (formats/schema) say, whatever the format.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> table_codes() {
  static constexpr std::array kRows = {
      // Read.
      error(Code::kTableWrongSyntax, "wrong-syntax", "the file does not contain keys and values"),
      error(Code::kTableNoObject, "not-a-mapping", "{0} is not a mapping of keys and values"),
      error(Code::kTableNoCameraList, "not-a-list", "{0} is not a list of cameras"),
      error(Code::kTableUnknownLens, "unknown-model", "{0}: there is no camera_model '{1}' with distortion_model '{2}'",
            "write pinhole with radial-tangential, equidistant or none"),
      // {2}: the words that are known.
      error(Code::kTableUnknownWord, "unknown-model", "{0} is '{1}'; it must be {2:or}"),
      error(Code::kTableCoefficientCount, "wrong-length", "{0} has {1} numbers; {3} has {2:or}"),
      error(Code::kTableNoSize, "wrong-length", "{0} resolution is not a list of width and height"),
      error(Code::kTableSideNotFour, "wrong-length", "{0} is {1}, but a pose is a matrix of 4 x 4"),
      error(Code::kTableNoIdentity, "poses-contradict",
            "{0} is not the identity, but all poses of such files are in the frame of this sensor",
            "multiply the poses of all sensors by its inverse from the left, and write the identity here"),
      // {1}: the program.
      reader_warning(Code::kTableMissingKeys, "missing-key", "the file has no {0:or}: {1} stops"),
      // {0}: whose pose or lens.
      note(Code::kTableNotCalibrated, "not-calibrated", "{0}: all numbers are 0: it is not calibrated"),

      // Written. {0}: the title of the format, {1}: its program.
      clause(Code::kTableWrote, "{0} for {1}"),
      clause(Code::kTableDemandsSize, "the file of a camera contains its resolution"),
      clause(Code::kTableIdentity, "identity: its pose in the IMU is not in the input"),
      clause(Code::kTablePoseInFrame, "the pose in {0}: its pose in the IMU is not in the input"),
      clause(Code::kTableInitialValue, "{0} (of {1}'s example: the input does not contain it)"),
      clause(Code::kStellaLayouts, "stella_vslam (the default) or openvslam (keys with points: Camera.fx)"),
      clause(Code::kOkvisLayouts, "okvis2 (OKVIS2 and OKVIS2-X, the default) or okvis1 (the first OKVIS)"),
      clause(Code::kTableStockValue, "as in {0}'s example"),
      clause(Code::kTableOneOffset, "the file has one for all cameras"),
      // {0}: the program.
      clause(Code::kTableMadeUpId, "made up: {0} tells sensors apart by it"),
      loss(Code::kTableFurtherImu, "imu-dropped", "{0} noise and rate", "one IMU is written", "keep its file"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
