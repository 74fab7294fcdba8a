// SPDX-License-Identifier: BSD-3-Clause
// What happens when a model is fitted and evaluated.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> conversion_codes() {
  static constexpr std::array kRows = {
      bad_request(Code::kUnknownModel, "unknown-model", "there is no camera model '{0}'"),
      bad_request(Code::kSamplesInvalid, "samples-invalid", "a fit takes between 1 and {0} samples"),
      bad_request(Code::kModelHasNoDegree, "degree-invalid", "{0} is not a polynomial with a degree that you can choose"),
      bad_request(Code::kDegreeOutside, "degree-invalid", "{0} has a degree from {1} to {2}"),
      bad_request(Code::kModelHasNoParameter, "unknown-parameter", "{0} has no parameter '{1}'"),
      bad_request(Code::kRangeEmpty, "range-empty", "the range of {0} holds no number"),
      bad_request(Code::kMaxAngleInvalid, "max-angle-invalid", "the largest angle from the axis must lie in (0, 180] degrees"),
      error(Code::kImageSizeNotKnown, "image-size-missing", "{0}: the image size is not known", "give the image size"),
      bad_request(Code::kNoPixelInTheLens, "no-pixel-in-the-lens",
                  "{0}: no pixel of the image lies within that angle of the axis", "give a larger angle"),
      error(Code::kNoPixelHasARay, "no-pixel-has-a-ray",
            "{0}: the model gives no ray for any pixel of the {1} x {2} image; are focal length and principal point in pixels "
            "of this image?"),
      error(Code::kTooFewRaysToFit, "domain-too-small",
            "{0}: {1} cannot be fitted: too few pixels of the image have a ray and, by a weight image, a weight"),
      error(Code::kTooFewPixelsToFit, "domain-too-small",
            "{0}: too few pixels of the image lie within the lens to fit {1}, with any number of samples"),
      error(Code::kFitFailed, "fit-failed", "{0}: {1} cannot describe this camera"),
      error(Code::kStretchOfNoLens, "stretch-of-no-lens",
            "{0}: at the axis, the camera has {1:.3} times as many pixels per radian in one direction as in another; no real "
            "camera has, and fca-io fits no model to it",
            "compare the focal lengths (or c, d and e) with the calibration's result"),
      note(Code::kParameterUnusual, "parameter-unusual",
           "{0}: the best {1} has {2} = {3:.4}, but published cameras have [{4:.3}, {5:.3}]; within that range the error is "
           "{6:.3} px rms instead of {7:.3} px",
           "keep it within the range, or take another model: programs that search from such numbers may fail"),
      bad_request(Code::kNothingToKeep, "unknown-parameter", "{0} ({1}) has no parameter '{2}' whose value could be kept"),
      bad_request(Code::kTiesFocalLengthsOnly, "unknown-parameter", "{0} has no fx and fy that could be one number"),
      bad_request(Code::kOneFocalLengthOfRays, "rays-fitted-freely",
                  "{0} is a table of rays: a fit to it determines fx and fy independently"),
      note(Code::kTurnedIntoPose, "turned-into-pose",
           "{0}: a turn of {1:.3} deg is moved from the lens into the poses: the error is {2:.3} px rms instead of {3:.3} px"),
      warning(
          Code::kTurnHasNoPose, "turned-into-pose",
          "{0}: the fit turns the camera by {1:.3} deg, but the file has no pose that could hold the turn: its images appear "
          "turned by that angle",
          "turn by the rotation vector ({2:.6}, {3:.6}, {4:.6}) rad, from the calibrated camera's rays to the written one's"),
      note(Code::kTurnDoesNotHelp, "turn-does-not-help", "{0}: no turn of the camera makes this fit better"),
      note(Code::kTurnWouldHelp, "turn-would-help",
           "{0}: with a turn of {1:.2} deg in its poses, the error would be about {2:.2} px rms instead of {3:.3} px",
           "also fit the turn"),
      bad_request(Code::kTurnedForRms, "turn-needs-rms", "a turn of the camera can be fitted only for the rms"),
      bad_request(Code::kWeightedForRms, "weight-needs-rms", "weights apply to the rms; the largest error has no weights"),
      error(Code::kWeightsBlack, "weights-black",
            "{0}: the image of weights is black everywhere within the lens, so no pixel counts",
            "paint the pixels that should count white or grey"),
      error(Code::kNoPartCompared, "nothing-to-compare", "{0}: no part of the image could be compared with {1}"),
      note(Code::kOnlyRaysCompared, "only-rays-compared",
           "{0} is a table of {1} rays: errors are those at its rays, and nothing is known between them"),
      clause(Code::kRaysEndThere, "the table of rays ends there"),
      bad_request(Code::kRaysFittedForRms, "rays-fitted-for-rms",
                  "{0} is a table of rays, which can be fitted only for the rms"),
      bad_request(Code::kRaysCountAlike, "rays-count-alike",
                  "{0} is a table of rays, which all count alike: a fit of them takes no weights"),
      error(Code::kOnlyRaysKnown, "only-rays-known", "{0} is a table of rays, not a camera model",
            "convert it to a model first, and use that"),
      error(Code::kRaysAllAround, "fit-failed",
            "{0} shows all directions ({1:.0f} % of its image lies more than 150 degrees from the axis): no lens does",
            "fit a part of it, up to a smaller angle; or cut the images of lenses out of the panorama first"),
      warning(Code::kRayApart, "lens-in-doubt",
              "{0}: the ray of pixel ({1:.5}, {2:.5}) is {3:.3} px off the lens that fits the other rays; those are within "
              "{4:.2} px",
              "check that line of the table, and remove it if it is wrong"),
      warning(Code::kRayOutside, "lens-in-doubt",
              "{0}: the lens that fits the other rays has no pixel for the ray of pixel ({1:.5}, {2:.5})",
              "check that line of the table, and remove it if it is wrong"),
      warning(Code::kTargetCannotReach, "target-cannot-reach",
              "{0}: {1} cannot describe the whole lens; it was fitted and scored up to {2:.0f} deg from the axis, and gives "
              "wrong pixels or none beyond",
              "another model may have a larger maximum angle: compare all models"),
      warning(Code::kFoldsInsideImage, "folds-inside-image",
              "{0}: its distortion folds at {1:.0f} deg from the axis, inside the image: {2:%} of the image has no ray",
              "calibrate again with observations up to the corners, or with a model for wide lenses (kb4, ds, eucm)"),
      warning(
          Code::kFocalLengthsDiffer, "focal-lengths-differ",
          "{0}: the focal lengths along u and v, {1:.4} and {2:.4} px, differ more than the sides of any sensor's pixels do",
          "compare both with the calibration's result"),
      warning(Code::kCentreOutside, "centre-outside", "{0}: the principal point ({1}, {2}) lies outside the {3} x {4} image",
              "this is right for a part cut out of a larger image; otherwise compare it with the calibration's result"),
      clause(Code::kFieldOfViewGiven, "given"),
      clause(Code::kFieldOfViewInsideGiven, "the whole image (it ends inside the given angle)"),
      clause(Code::kFieldOfViewModelEnds, "the source model ends there, inside the image"),
      clause(Code::kFieldOfViewWholeImage, "the whole image (no input contains the lens's angle)"),
      clause(Code::kFieldOfViewInsideCircle, "the whole image (it ends inside {0})"),
      clause(Code::kFieldOfViewAndInsideCircle, "{0}, and inside {1}"),
      clause(Code::kFieldOfViewAndCircle, "{0}, and {1}"),
      clause(Code::kFieldOfViewWithoutRay, "no pixel has a ray"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
