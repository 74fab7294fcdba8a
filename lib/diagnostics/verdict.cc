// SPDX-License-Identifier: BSD-3-Clause
// Why a file is less than ready to use. {0} is the program as a rule.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> verdict_codes() {
  static constexpr std::array kRows = {
      reader_warning(Code::kVerdictPixelsOff, "pixels-off", "{0} sees it {1:px} px rms off (99 %: {2:px}, worst {3:px} px){4}"),
      clause(Code::kVerdictCause, "; {0}"),
      reader_warning(Code::kVerdictMisread, "program-misreads",
                     "{0} does not use the file's numbers: its worst pixel is {1:px} px off{2}"),
      reader_warning(Code::kVerdictNoRays, "no-right-rays",
                     "{0} has no right ray for {1:%} of the image{4}; {2:%} compared{3}"),
      clause(Code::kVerdictOfCircle, " and {0:%} of its inscribed circle"),
      about_reader(error(Code::kVerdictRefused, "program-refuses", "{0} refuses it: {1:and}{2}")),
      reader_warning(
          Code::kVerdictLensGiven, "little-compared",
          "{0:%} of the image lies outside the given lens: fca-io does not know how the program understands it there"),
      reader_warning(Code::kVerdictNeedsProgram, "needs-program", "only {0:and} reads it, {1} does not"),
      about_reader(error(Code::kVerdictPosesDiffer, "proof-failed", "an element of {0}'s poses differs by {1:.3}")),
      about_reader(error(Code::kVerdictNumbersDiffer, "proof-failed", "{0} reads other numbers: {1:and}")),
      warning(Code::kVerdictPosesContradict, "poses-contradict",
              "the input gives T_{0}_{1} twice, and the two differ by {2:.3} deg and {3}{4}"),
      clause(Code::kPoseWrittenAsGiven, "; the file has {0:and} as given"),
      clause(Code::kPoseWrittenAsDerived, "; the file has the {0} that follows from {1:and}"),
      clause(Code::kPosesWrittenBoth, "; the file has both"),
      clause(Code::kOthersAgree, ": {0} is left out, because all others agree without it"),
      clause(Code::kOrderOfThePair, ": {0} is left out, because it would put the right camera on the left"),
      reader_warning(Code::kVerdictNotAsked, "not-proven", "no program's reader was tried"),
      reader_warning(Code::kVerdictNoReader, "not-proven", "no program that fca-io knows reads it",
                     "rewrite it with the keys that {0} reads"),
      warning(Code::kVerdictLost, "lost", "{0}"),
      warning(Code::kVerdictInvented, "invented-value", "{0:and}: no input contains it, and it matters",
              "also give a file that contains it"),
      warning(Code::kVerdictNoPose, "pose-missing", "no input contains the pose between {0} and {1}",
              "also give a file that contains it"),
      warning(Code::kVerdictNoCommonView, "no-common-view",
              "{0} and {1} are written as a stereo pair, but have less than a quarter of their images in common",
              "leave out what asks for a pair"),
      warning(Code::kVerdictEpipolarError, "epipolar-error", "epipolar error of {0} and {1}: rms {2:px} px, max {3:px} px"),
      reader_warning(Code::kVerdictNeedsVersion, "needs-version",
                     "{0} reads {2} since version {1}; older versions refuse the file"),
      reader_warning(Code::kVerdictNeedsName, "needs-name", "{0} reads the file correctly only under the name {1}",
                     "rename the file"),
      clause(Code::kNameTheFile, "name the file {0}"),
      clause(Code::kOlderVersionsRead, "for older versions the model {0}: {1:rms}{2:worst}"),
      clause(Code::kFitInsideAngle,
             "the same model fitted up to {0} deg from the axis: {1:px} px rms inside, not {2:px}, and wrong pixels beyond"),
      clause(Code::kRewriteDemandsRate, "write a fresh file, which needs the IMU's rate"),
      clause(Code::kRewriteDemandsSize, "write a fresh file, which needs the size of the images"),
      clause(Code::kRewrittenFor, "write a fresh file, which is for {0}: {1:rms}{2:worst}"),
      clause(Code::kRewrittenIs, "a fresh file: {0:rms}{1:worst}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
