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
                     "{0} takes other numbers than the file's: worst pixel {1:px} px off{2}"),
      reader_warning(Code::kVerdictNoRays, "no-right-rays",
                     "{0} has no right ray for {1:%} of the image{4}; {2:%} compared{3}"),
      clause(Code::kVerdictOfCircle, " and {0:%} of its inscribed circle"),
      about_reader(error(Code::kVerdictRefused, "program-refuses", "{0} refuses it: {1:and}{2}")),
      reader_warning(
          Code::kVerdictLensGiven, "little-compared",
          "{0:%} of the image lies outside the lens as it was given: nothing is known of how it is understood there"),
      reader_warning(Code::kVerdictNeedsProgram, "needs-program", "only {0:and} reads it, {1} does not"),
      about_reader(error(Code::kVerdictPosesDiffer, "proof-failed", "an element of {0}'s poses differs by {1:.3}")),
      about_reader(error(Code::kVerdictNumbersDiffer, "proof-failed", "{0} holds other numbers: {1:and}")),
      warning(Code::kVerdictPosesContradict, "poses-contradict", "two statements of T_{0}_{1} differ by {2:.3} deg and {3}{4}"),
      clause(Code::kPoseWrittenAsStated, "; the file has {0:and} as given"),
      clause(Code::kPoseWrittenAsDerived, "; the file has {0} as it follows from {1:and}"),
      clause(Code::kPosesWrittenBoth, "; the file has both"),
      clause(Code::kOthersAgree, ": {0} is left out, as all others agree without it"),
      clause(Code::kOrderOfThePair, ": {0} is left out, as it would put the right camera on the left"),
      reader_warning(Code::kVerdictNotAsked, "not-proven", "no program's reader was tried"),
      reader_warning(Code::kVerdictNoReader, "not-proven", "no program that fca-io knows reads it",
                     "rewrite it with the keys that {0} reads"),
      warning(Code::kVerdictLost, "lost", "{0}"),
      warning(Code::kVerdictInvented, "invented-value", "{0:and}: no input contains it, and it matters",
              "give a file that contains it, too"),
      warning(Code::kVerdictNoPose, "pose-missing", "no input contains the pose between {0} and {1}",
              "give a file that contains it, too"),
      warning(Code::kVerdictNoCommonView, "no-common-view",
              "{0} and {1} have less than a quarter of their images in common, and are written as a stereo pair",
              "leave out what asks for a pair"),
      warning(Code::kVerdictEpipolarError, "epipolar-error", "epipolar error of {0} and {1}: rms {2:px} px, max {3:px} px"),
      reader_warning(Code::kVerdictNeedsVersion, "needs-version",
                     "{0} reads {2} since {1}; its readers before refuse the file"),
      reader_warning(Code::kVerdictNeedsName, "needs-name", "{0} reads it as meant only in a file named {1}",
                     "give it that name"),
      clause(Code::kNameTheFile, "name the file {0}"),
      clause(Code::kOlderVersionsRead, "for those the model {0}: {1:rms}{2:worst}"),
      clause(Code::kFitInsideAngle, "the same model fitted up to {0} deg from the axis: {1:px} px rms inside, not {2:px}"),
      clause(Code::kRewriteDemandsRate, "write a fresh file, which demands the IMU's rate"),
      clause(Code::kRewriteDemandsSize, "write a fresh file, which demands the size of the images"),
      clause(Code::kRewrittenFor, "write a fresh file, which is for {0}: {1:rms}{2:worst}"),
      clause(Code::kRewrittenIs, "a fresh file: {0:rms}{1:worst}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
