// SPDX-License-Identifier: BSD-3-Clause
// What COLMAP reports about a cameras.txt.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> colmap_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kColmapSaysNoCamera, "the file contains no camera"),
      named_refusal(Code::kColmapSaysLine, "line {0} does not begin with an id, a model, a width and a height: COLMAP stops"),
      named_refusal(Code::kColmapSaysUnknownModel, "line {0} names the model {1}, which COLMAP does not know: it stops"),
      named_refusal(Code::kColmapSaysParameterCount, "line {0}: COLMAP reads {1} parameters of {2}, wants {3} and stops"),
      named_refusal(Code::kColmapSaysIdTwice, "line {0}: another camera has the id {1}, and COLMAP stops"),
      named_misreading(Code::kColmapSaysNewModel, "COLMAP before version {1} does not know {0}, and stops"),
      refusal(Code::kColmapSaysNoRig, "the file contains no list of rigs with cameras"),
      refusal(Code::kColmapSaysNoPrefix, "a camera has no image_prefix"),
      refusal(Code::kColmapSaysReferences, "{0} cameras of a rig have ref_sensor: true, but exactly one must"),
      refusal(Code::kColmapSaysReferencePose, "the reference sensor has a pose"),
      named_misreading(Code::kColmapSaysHalf, "COLMAP ignores {0} without {1}"),
      named_refusal(Code::kColmapSaysModelNotTaken, "{0} does not take cameras of {1}, but {2:and}",
                    "write one of these, or undistort the images (colmap image_undistorter)"),
      named_refusal(Code::kColmapSaysRigFile, "{0} reads cameras, but no file of rigs"),
      named_refusal(Code::kColmapSaysTextOnly, "{0} reads only the text files of a model",
                    "write cameras.txt (colmap model_converter)"),
      named_refusal(Code::kColmapSaysEnds, "the file ends inside camera or rig {0}: COLMAP stops, or reads what is not there"),
      named_refusal(Code::kColmapSaysModelNumber, "camera {0} has the model number {1}, which COLMAP does not know: it stops"),
      named_refusal(Code::kColmapSaysNoRigLine, "rig {0} does not contain as many sensors as it announces: COLMAP stops"),
      named_refusal(Code::kColmapSaysSensorTwice, "rig {0} contains a sensor twice: COLMAP stops"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
