// SPDX-License-Identifier: BSD-3-Clause
// What happens when a model is fitted and judged.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> conversion_codes() {
  static constexpr std::array kRows = {
      bad_request(Code::kUnknownModel, "unknown-model", "there is no camera model '{0}'"),
      bad_request(Code::kSamplesInvalid, "samples-invalid", "a fit wants between 1 and {0} samples"),
      bad_request(Code::kModelHasNoDegree, "degree-invalid", "{0} is no polynomial whose degree can be chosen"),
      bad_request(Code::kDegreeOutside, "degree-invalid", "{0} has a degree from {1} to {2}"),
      bad_request(Code::kModelHasNoParameter, "unknown-parameter", "{0} has no parameter '{1}'"),
      bad_request(Code::kRangeEmpty, "range-empty", "the range of {0} holds no number"),
      bad_request(Code::kMaxAngleInvalid, "max-angle-invalid", "the largest angle from the axis must lie in (0, 180] degrees"),
      error(Code::kImageSizeNotKnown, "image-size-missing", "{0}: the image size is not known", "give it"),
      bad_request(Code::kNoPixelInTheLens, "no-pixel-in-the-lens",
                  "{0}: no pixel of the image lies within that angle of the axis", "a larger angle"),
      error(Code::kNoPixelHasARay, "no-pixel-has-a-ray",
            "{0}: the model gives no ray for any pixel of the {1} x {2} image; are focal length and principal point in pixels "
            "of this image?"),
      error(Code::kTooFewRaysToFit, "domain-too-small",
            "{0}: {1} cannot be fitted: too few pixels of the image have a ray and, by a weight image, a weight"),
      error(Code::kTooFewPixelsToFit, "domain-too-small",
            "{0}: too few pixels of the image lie in the domain to fit {1}, however many samples are taken between them"),
      error(Code::kFitFailed, "fit-failed", "{0}: no {1} camera comes near this one"),
      error(
          Code::kStretchOfNoLens, "stretch-of-no-lens",
          "{0}: on its axis a radian has {1:.3} times as many pixels in one direction as in another; no lens and sensor do so, "
          "and no model is fitted to it",
          "compare the focal lengths (or c, d and e) with the calibration's result"),
      note(Code::kParameterUnusual, "parameter-unusual",
           "{0}: the best {1} has {2} = {3:.4}, and published cameras lie within [{4:.3}, {5:.3}]; inside that range the "
           "error is {6:.3} px rms instead of {7:.3}",
           "keep it inside the range, or take another model: programs that search from such numbers may fail"),
      bad_request(Code::kNothingToKeep, "unknown-parameter", "{0} ({1}) has no parameter '{2}' whose value could be kept"),
      bad_request(Code::kTiesFocalLengthsOnly, "unknown-parameter", "{0} has no fx and fy that could be one number"),
      bad_request(Code::kOneFocalLengthOfRays, "rays-fitted-freely",
                  "{0} is a table of rays, to which fx and fy are fitted each for itself"),
      note(Code::kTurnedIntoPose, "turned-into-pose",
           "{0}: {1:.3} deg of the lens are written into its poses: the error is {2:.3} px rms instead of {3:.3}"),
      warning(
          Code::kTurnHasNoPose, "turned-into-pose",
          "{0}: the file has no pose of it to hold a turn of {1:.3} deg, and its images are seen so much turned",
          "turn by the rotation vector ({2:.6}, {3:.6}, {4:.6}) rad, from the calibrated camera's rays to the written one's"),
      note(Code::kTurnDoesNotHelp, "turn-does-not-help", "{0}: no turn of the camera makes this fit better"),
      note(Code::kTurnWouldHelp, "turn-would-help",
           "{0}: with {1:.2} deg written into its poses the error would be about {2:.2} px rms instead of {3:.3}",
           "fit the turn, too"),
      bad_request(Code::kTurnedForRms, "turn-needs-rms", "a turn of the camera is fitted for the rms only"),
      bad_request(Code::kWeightedForRms, "weight-needs-rms", "weights are those of the rms: the largest error has none"),
      error(Code::kWeightsBlack, "weights-black",
            "{0}: the image of weights is black wherever there is lens, so no pixel counts",
            "paint what is to count white or grey"),
      error(Code::kNoPartCompared, "nothing-to-compare", "{0}: no part of the image could be compared with {1}"),
      note(Code::kOnlyRaysCompared, "only-rays-compared",
           "{0} is a table of {1} rays: errors are those at its rays, and nothing is known between them"),
      clause(Code::kRaysEndThere, "the table of rays ends there"),
      bad_request(Code::kRaysFittedForRms, "rays-fitted-for-rms", "{0} is a table of rays, which is fitted for the rms only"),
      bad_request(Code::kRaysCountAlike, "rays-count-alike",
                  "{0} is a table of rays, which count alike: a fit of them has no other weights"),
      error(Code::kOnlyRaysKnown, "only-rays-known", "{0} is a table of rays, no camera model",
            "convert it to a model first, and use that"),
      error(Code::kRaysAllAround, "fit-failed",
            "{0} shows all directions ({1:.0f} % of its image lies more than 150 degrees from the axis): no lens does",
            "fit a part of it, up to a smaller angle; or cut the images of lenses out of the panorama first"),
      warning(Code::kRayApart, "lens-in-doubt",
              "{0}: the ray of pixel ({1:.5}, {2:.5}) is {3:.3} px from the lens of the others, which are within {4:.2} px",
              "look at that line of the table, and leave it out if it is wrong"),
      warning(Code::kRayOutside, "lens-in-doubt",
              "{0}: the lens of the others has no pixel for the ray of pixel ({1:.5}, {2:.5})",
              "look at that line of the table, and leave it out if it is wrong"),
      warning(Code::kTargetCannotReach, "target-cannot-reach",
              "{0}: {1} cannot describe this lens as far as the domain goes; it was fitted inside {2:.0f} deg from the axis, "
              "is scored there, and gives wrong pixels or none beyond",
              "another model may reach further: compare all models"),
      warning(Code::kFoldsInsideImage, "folds-inside-image",
              "{0}: its distortion folds at {1:.0f} deg from the axis, inside the image: {2:%} of the image has no ray",
              "calibrate again with observations up to the corners, or with a model for wide lenses (kb4, ds, eucm)"),
      warning(
          Code::kFocalLengthsDiffer, "focal-lengths-differ",
          "{0}: the focal lengths along u and v, {1:.4} and {2:.4} px, differ more than the sides of any sensor's pixels do",
          "compare both with the calibration's result"),
      warning(Code::kCentreOutside, "centre-outside", "{0}: the principal point ({1}, {2}) lies outside the {3} x {4} image",
              "right for a part cut out of a larger image; else compare it with the calibration's result"),
      clause(Code::kDomainGiven, "given"),
      clause(Code::kDomainInsideGiven, "the whole image (it ends inside the given angle)"),
      clause(Code::kDomainModelEnds, "the source model ends there, inside the image"),
      clause(Code::kDomainWholeImage, "the whole image (no input contains the lens's angle)"),
      clause(Code::kDomainInsideCircle, "the whole image (it ends inside {0})"),
      clause(Code::kDomainAndInsideCircle, "{0}, and inside {1}"),
      clause(Code::kDomainAndCircle, "{0}, and {1}"),
      clause(Code::kDomainWithoutRay, "no pixel has a ray"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
