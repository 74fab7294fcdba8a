// SPDX-License-Identifier: BSD-3-Clause
// OCamCalib's files, as read and written. What lies where in a calib_results.txt is an argument: "inverse polynomial".
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> ocamcalib_codes() {
  static constexpr std::array kRows = {
      // What speaks for the format.
      clause(Code::kCalibResultsDirectComment, "a comment on the direct mapping function"),
      clause(Code::kCalibResultsBlocks, "five blocks of numbers after one line each"),
      clause(Code::kCalibResultsShape, "lines of numbers that end with a centre, three affine parameters and a size"),
      clause(Code::kCalibResultsComment, "a comment on a polynomial or affine parameters"),

      error(Code::kCalibResultsNoLines, "wrong-syntax", "a calib_results.txt consists of lines of numbers; this file does not"),
      error(Code::kCalibResultsManyDocuments, "one-camera",
            "a calib_results.txt holds one camera, but these are {0} documents"),

      // Where the program loses its way through the blocks.
      error(Code::kCalibResultsEndsBefore, "missing-block", "the file ends before the {0}",
            "write five blocks: direct polynomial, inverse polynomial, centre, affine parameters, image size"),
      clause(Code::kCalibResultsLastCoefficient, "last of the {0} coefficients of the {1}"),
      clause(Code::kCalibResultsLastNumber, "last number of the {0}"),
      error(Code::kCalibResultsMoreNumbers, "wrong-count",
            "more numbers than announced: OCamCalib's reader takes the rest of this line for the comment before the {0}",
            "correct the number of coefficients, or remove the superfluous numbers"),
      error(Code::kCalibResultsCommentMissing, "comment-missing",
            "no comment line before the {0}: OCamCalib's reader skips one line there, and these numbers with it",
            "put one line of text before them, such as  #{0}"),
      error(Code::kCalibResultsCommentTooLong, "comment-too-long",
            "the comment before the {0} has more than 1023 characters, of which OCamCalib's reader skips only the first ones",
            "shorten it"),
      error(Code::kCalibResultsBlankLine, "comment-lines",
            "a blank line before the first comment: OCamCalib's reader skips that one instead and takes '{0}' for a number",
            "remove the blank line"),
      error(Code::kCalibResultsCommentLines, "comment-lines",
            "OCamCalib's reader skips exactly one line before the {0}{1}, and takes '{2}' for a number",
            "keep one line of comment"),
      clause(Code::kCalibResultsRestOfLine, ", the rest of the one above"),
      error(Code::kCalibResultsNotFinite, "not-a-number", "{0}: '{1}' is not a finite number", "{2}"),
      clause(Code::kCalibResultsDecimalPoint, "write a decimal point"),
      error(Code::kCalibResultsNotWhole, "not-an-integer", "{0}: '{1}'; OCamCalib's reader takes only whole numbers here",
            "{2}"),
      clause(Code::kCalibResultsWithoutPoint, "write it without a point"),
      clause(Code::kCalibResultsCountOf, "number of coefficients of the {0}"),
      error(Code::kCalibResultsCountOutside, "wrong-count",
            "the {0} announces {1} coefficients; OCamCalib's reader has places for 1 to 64 and does not check"),
      error(Code::kCalibResultsDegreeTooHigh, "degree-too-high",
            "the {0} has degree {1}; fca-io's model ends at degree {2} (the toolbox's default is 4)",
            "calibrate with a lower degree"),
      error(Code::kCalibResultsTooFewNumbers, "wrong-count", "'{0}' is where number {1} of {2} of the {3} must be"),

      CodeInfo{.code = Code::kCalibResultsInverseMissing,
               .id = "inverse-missing",
               .severity = Severity::kWarning,
               .about = About::kReader,
               .text = "there is no inverse polynomial: OCamCalib's world2cam cannot project without it",
               .fix = "convert the file to OCamCalib's format: fca-io then fits one to the direct polynomial"},
      warning(Code::kCalibResultsInverseStale, "stale-inverse",
              "the inverse polynomial is up to {0:.3} px from the inverse of the direct one: programs that project (world2cam) "
              "and those that unproject (cam2world) see two different lenses; fca-io uses the direct one",
              "convert the file to OCamCalib's format: fca-io then rebuilds it"),
      clause(Code::kCalibResultsInverse,
             "{0} coefficients, up to {1:.3} px from the exact inverse of the direct polynomial: {2}"),
      error(Code::kCalibResultsSign, "polynomial-sign",
            "a0 = {0} is positive: OCamCalib's z points to the back of the lens, so a0 is negative",
            "change the sign of all direct and of the odd inverse coefficients (b1, b3, ...)"),
      error(Code::kCalibResultsMirrors, "not-a-camera", "c - d e is not positive: [c d; e 1] mirrors the image or is singular"),
      error(Code::kCalibResultsCentreOutside, "centre-outside",
            "the centre is row {0}, column {1}, far outside an image of {2} rows and {3} columns",
            "check the image size (height, then width): one of the two numbers may be cut short"),
      warning(Code::kCalibResultsCentreSwapped, "centre-swapped",
              "the centre is row {0}, column {1} of an image of {2} rows and {3} columns; the other way round it would be "
              "nearer to the middle",
              "one of the two pairs is swapped: write  {1} {0}  for the centre, or  {3} {2}  (height width) for the image's "
              "size; most images are wider than high"),

      clause(Code::kCalibResultsInverseFitted, "{0} coefficients, fitted to the direct one within {1:.2} px"),
      reader_warning(
          Code::kCalibResultsInverseInexact, "inverse-inexact",
          "{0}: no inverse polynomial of up to 64 coefficients comes nearer to the direct one than {1:.2} px; OCamCalib's "
          "world2cam is off by that much",
          "leave out the border, where the direct polynomial turns, with a smaller maximum angle; or take another model"),
      clause(Code::kCalibResultsEndsWithSize, "a calib_results.txt ends with the image size"),
      clause(Code::kCalibResultsNoPlace, "a calib_results.txt has no place for it"),
      clause(Code::kCalibResultsHeadline, "a calib_results.txt for OCamCalib"),
      clause(Code::kCalibResultsHeadlineEach, "one calib_results.txt for OCamCalib per camera"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
