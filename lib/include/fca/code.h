// SPDX-License-Identifier: BSD-3-Clause
// The codes of all messages, and the table that words them. How to add one: lib/diagnostics/README.md.
#pragma once

#include <fca/diagnostics.h>
#include <fca/message.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace fca {

/// One for each sentence or clause. Sentences about the same defect share an id ("missing-key"); the numbers mean nothing.
enum class Code : std::uint16_t {
  kNone,     ///< Says nothing.
  kInWords,  ///< For the time being: words that their writer brings, as argument 0.

  // Rigs and their images.
  kCropOutside,
  kBinningImpossible,
  kResizeImpossible,
  kImageSizeNotStated,
  kLensCircleStretched,

  // What a format cannot hold.
  kNotCarried,
  kNotCarriedValue,
  kNotCarriedGroup,
  kTopicDropped,
  kFrameRateDropped,
  kOtherTimeOffset,
  kCommentsReplaced,
  kCommentsOfFileDropped,
  kHeaderDropped,
  kComposedAnew,
  kComposedAnewBecause,
  kReplacedOrRemoved,
  kKeepsItsOwnValue,
  kTimeOffsetDropped,
  kTumviHasNoTimeOffset,
  kTumviPoseRecomputed,
  kWoodscapeStaleTranslation,
  kManyCommentsReplaced,
  kSeveralFilesBecomeOne,
  kFilesHaveNoPlace,
  kImuDropped,
  kBaselineDropped,
  kPoseDropped,
  kPosesOfGroupsKept,
  kPosesOfGroup,
  kKeepTheInput,

  // What DSO says to a camera.txt.
  kDsoFileEmpty,
  kDsoFileTooLarge,
  kDsoLineTooLong,
  kDsoUnknownLens,
  kDsoNumberNotFinite,
  kDsoSizeNotRead,
  kDsoOutputUnknown,
  kDsoFullUnfinished,
  kDsoSizesDiffer,
  kDsoFifthNumberIgnored,
  kDsoPixelsBelowOne,
  kDsoSharesByCentre,
  kDsoOutputShares,
  kDsoNotRectified,

  // What a check finds about an IMU and about time.
  kImuNoiseTooSmall,
  kImuNoiseTooLarge,
  kImuNoiseOfSamples,
  kImuNoiseOfUnknownKind,
  kImuNoiseOfUnknownRate,
  kImuWalkAboveNoise,
  kImuSensorsSwapped,
  kImuRate,
  kTimeOffsetLarge,
  kTimeOffsetOfUnknownRate,
  kTimeOffsetOfMilliseconds,
  kTimeOffsetUndecided,

  // Numbers that no camera, rig or image can have.
  kNotACamera,
  kParameterNotFinite,
  kParameterTooLarge,
  kParameterTooSmall,
  kFocalLengthNotPositive,
  kParameterOutOfRange,
  kBeLessThan,
  kBeAtMost,
  kBeGreaterThan,
  kBeAtLeast,
  kLieWithin,
  kLieBetween,
  kRigOutOfRange,
  kRigNumberNotFinite,
  kImageSizeInvalid,
  kImageOfNoSize,
  kImageTooLarge,
  kTranslationTooLong,
  kBaselineImpossible,
  kTimeOffsetImpossible,
  kRotationElementTooLarge,
  kNotOrthonormal,

  // What happens when a model is fitted and judged.
  kUnknownModel,
  kSamplesInvalid,
  kModelHasNoParameter,
  kRangeEmpty,
  kMaxAngleInvalid,
  kImageSizeNotKnown,
  kNoPixelInTheLens,
  kNoPixelHasARay,
  kTooFewRaysToFit,
  kTooFewPixelsToFit,
  kFitFailed,
  kNoPartCompared,
  kTargetCannotReach,
  kFoldsInsideImage,
  kFocalLengthsDiffer,
  kCentreOutside,
  kDomainGiven,
  kDomainInsideGiven,
  kDomainModelEnds,
  kDomainWholeImage,
  kDomainInsideCircle,
  kDomainAndInsideCircle,
  kDomainAndCircle,
  kDomainWithoutRay,

  // How two calibrations differ, and by which mistake.
  kResolutionDiffers,
  kSidesExchanged,
  kNotScaled,
  kNothingInCommon,
  kCamerasAndImus,
  kSoMany,
  kNoSuch,
  kOnlyThing,
  kOnlyFact,
  kOnlyPose,
  kOnlyPoseBetween,
  kPoseHoldsInverse,
  kPoseTransposed,
  kPoseInMillimetres,
  kPoseInKilometres,
  kPoseInverted,
  kPoseOfAnotherCamera,
  kCamerasExchanged,
  kIntrinsicsExchanged,
  kPosesExchanged,
  kHalfPixelTooFar,
  kHalfPixelTooNear,
  kOnePixelTooFar,
  kOnePixelTooNear,
  kScaledWithoutHalfPixel,
  kCentreSwapped,
  kOfImagesTwiceThatSize,
  kOfImagesHalfThatSize,
  kOfImagesOfTheReference,
  kParametersExchanged,
  kCoefficientsInOrder,
  kUnderAnotherName,
  kTimeOffsetOfOtherSign,
  kNoiseDiscrete,
  kNoiseDividedByRate,
  kNoiseVariance,
  kNoiseOfVariances,
  kBaselineInMillimetres,
  kBaselineTooSmall,

  // What cannot be parsed.
  kTooDeep,
  kListTooLong,
  kMergeConflict,
  kYamlQuoteOpen,
  kYamlAlias,
  kYamlAnchor,
  kYamlKeyIsNoName,
  kYamlKeyWithoutColon,
  kYamlBlankMissing,
  kYamlTab,
  kYamlDocuments,
  kYamlNothingBegins,
  kYamlMapValue,
  kYamlSyntax,
  kYamlError,
  kJsonMisread,
  kJsonNotANumber,
  kJsonPlus,
  kJsonPointFirst,
  kJsonPointLast,
  kJsonLeadingZeros,
  kJsonNoNumber,
  kJsonExponentEmpty,
  kJsonNumberTooBig,
  kJsonValueMissing,
  kJsonNoValue,
  kJsonStringOpen,
  kJsonStringOfLines,
  kJsonControlCharacter,
  kJsonNotUtf8,
  kJsonWrongEscape,
  kJsonBracketOpen,
  kJsonEndsEarly,
  kJsonCommaBehindLast,
  kJsonSingleQuotes,
  kJsonComment,
  kJsonBehindRoot,
  kJsonKeyWanted,
  kJsonColonMissing,
  kJsonCommaMissing,
  kJsonSyntax,
  kXmlMisread,
  kXmlElementOpen,
  kXmlNoElement,
  kXmlTextOutside,
  kXmlTagOpen,
  kXmlInstruction,
  kXmlDeclaration,
  kXmlTagWithoutName,
  kXmlSecondRoot,
  kXmlClosesNothing,
  kXmlClosesAnother,
  kXmlRoot,
  kXmlUnknownEntity,
  kXmlQuoteOpen,
  kXmlBlankMissing,
  kXmlQuoteInWord,
  kXmlMixed,
  kXmlAttribute,
  kXmlLine,

  // Values under the keys of a file, in every format.
  kKeyTwiceAlike,
  kKeyTwiceUnlike,
  kKeyTwice,
  kMoreKeysTwice,
  kKeyMisspelt,
  kKeyMissing,
  kValueEmpty,
  kValueText,
  kValueList,
  kValueMapping,
  kValueOctal,
  kValueNoNumber,
  kValueNotFinite,
  kValueNotPositive,
  kAndTooLarge,
  kValueNoInteger,
  kOf32Bits,
  kValueNoName,
  kValueNoNameUnread,
  kNameReadAs,
  kValueNoList,
  kNumbersWanted,
  kRowsWanted,
  kBaselineOutOfRange,
  kBaselineTimesFocalLength,
  kTimeOffsetOutOfRange,
  kTranslationOutOfRange,
  kLastRowWrong,
  kRotationImpossible,
  kRotationRough,
  kRotationMirrors,
  kValueNoMatrix,
  kMatrixOfSize,
  kNameUnprintable,
  kPoseMirrors,
  kNumberWouldNotBeFinite,

  // Files and formats, whichever.
  kFileUnreadable,
  kFileMissing,
  kFileIsDirectory,
  kFileReadingFailed,
  kFileTooLarge,
  kFileEmpty,
  kFileBinary,
  kFormatUnknown,
  kFormatLooksLikeKeysBeside,
  kFormatLooksLikeKeysInside,
  kLooksLikeMultiCol,
  kLooksLikePlainLists,
  kLooksLikePyOcamCalib,
  kFormatAmbiguous,
  kFormatCandidate,
  kTooManyCameras,
  kCameraInMainFile,
  kImuInMainFile,
  kPoseInTwoFiles,
  kPoseContradictsOthers,
  kPoseOfEachUnstated,
  kFormatHasNoModel,
  kFormatHasNoValue,
  kFormatNeedsCamera,
  kFormatNeedsSize,
  kNotWrittenBecause,
  kSetWrongType,
  kSetOutOfRange,
  kSetNoSingleValue,
  kSetUnknownKey,
  kSetDidYouMean,
  kSetLayout,
  kSetCalibration,
  kWantsFiniteNumber,
  kWantsWholeNumber,
  kWantsNumber,
  kWantsWord,
  kWantsPlainWord,
  kWantsPlainText,
  kWantsNumberAboveZero,
  kWantsNumberBetween,
  kValueIsList,
  kValueIsGroup,

  // Kalibr's chains, as read and written.
  kCamchainWithKey,
  kCamchainBlock,
  kCamchainImuKeys,
  kCamchainMisnamedCamera,
  kCamchainNoMapping,
  kCamchainMissingKey,
  kCamchainUnknownCamera,
  kCamchainNearNames,
  kCamchainUnknownDistortion,
  kCamchainOutsideRange,
  kCamchainAlphaBelowOne,
  kCamchainRadtanNoK3,
  kCamchainWrongLength,
  kCamchainNoList,
  kCamchainResolution,
  kCamchainNothing,
  kCamchainNoCamera,
  kCamchainSizeMissing,
  kCamchainImuNotStated,
  kCamchainImuDropped,
  kCamchainImuDemands,
  kCamchainBaselineDropped,
  kCamchainNoKey,
  kCamchainNoPlace,
  kCamchainComposedAnew,
  kCamchainOverlapsNoList,
  kCamchainOverlapsOfAbsent,
  kCamchainOverlapsOfItsFile,
  kCamchainHeadline,
  kCamchainImuHeadline,

  // OpenVINS' chains, as read and written.
  kOpenvinsChainWithKey,
  kOpenvinsChainOtherLens,
  kOpenvinsChainTakenForRadtan,
  kOpenvinsChainDemandsSize,
  kOpenvinsChainPoseMadeUp,
  kOpenvinsChainPoseInFrame,
  kOpenvinsChainCalibratedImu,
  kOpenvinsChainBaselineDropped,
  kOpenvinsChainNoKey,
  kOpenvinsChainNoPlace,
  kOpenvinsChainOneImu,
  kOpenvinsChainOneOffset,
  kOpenvinsChainHeadline,
  kOpenvinsChainImuHeadline,

  // TUM-VI's chains and camera.txt, as read and written.
  kCameraTxtNamedLens,
  kCameraTxtWithMode,
  kCameraTxtNumbers,
  kCameraTxtAtan,
  kCameraTxtNotANumber,
  kCameraTxtNoLens,
  kCameraTxtTooFewNumbers,
  kCameraTxtSize,
  kCameraTxtSharesByCentre,
  kCameraTxtFifthNumber,
  kCameraTxtNoOutput,
  kCameraTxtFull,
  kCameraTxtMode,
  kCameraTxtSizesDiffer,
  kCameraTxtNotRectified,
  kCameraTxtManyCameras,
  kCameraTxtUnknownModel,
  kCameraTxtNoK3,
  kCameraTxtSizeMissing,
  kCameraTxtCentreBelowOne,
  kCameraTxtCentreNoShare,
  kCameraTxtCamchainInstead,
  kCameraTxtNoPlace,
  kCameraTxtSizeOfCamera,
  kCameraTxtHeadline,
  kCameraTxtHeadlineEach,
  kTumviHeadline,

  // OCamCalib's files, as read and written.
  kCalibResultsDirectComment,
  kCalibResultsBlocks,
  kCalibResultsShape,
  kCalibResultsComment,
  kCalibResultsNoLines,
  kCalibResultsManyDocuments,
  kCalibResultsEndsBefore,
  kCalibResultsLastCoefficient,
  kCalibResultsLastNumber,
  kCalibResultsMoreNumbers,
  kCalibResultsCommentMissing,
  kCalibResultsCommentTooLong,
  kCalibResultsBlankLine,
  kCalibResultsCommentLines,
  kCalibResultsRestOfLine,
  kCalibResultsNotFinite,
  kCalibResultsDecimalPoint,
  kCalibResultsNotWhole,
  kCalibResultsWithoutPoint,
  kCalibResultsCountOf,
  kCalibResultsCountOutside,
  kCalibResultsDegreeTooHigh,
  kCalibResultsTooFewNumbers,
  kCalibResultsInverseMissing,
  kCalibResultsInverseStale,
  kCalibResultsInverse,
  kCalibResultsSign,
  kCalibResultsMirrors,
  kCalibResultsCentreOutside,
  kCalibResultsCentreSwapped,
  kCalibResultsInverseFitted,
  kCalibResultsInverseInexact,
  kCalibResultsEndsWithSize,
  kCalibResultsNoPlace,
  kCalibResultsHeadline,
  kCalibResultsHeadlineEach,

  // WoodScape's files, as read and written.
  kWoodscapeJsonWithKey,
  kWoodscapeJsonWithQuaternion,
  kWoodscapeJsonOneObject,
  kWoodscapeJsonMissing,
  kWoodscapeJsonNoObject,
  kWoodscapeJsonMissingKey,
  kWoodscapeJsonPoseNotKnown,
  kWoodscapeJsonOtherModel,
  kWoodscapeJsonOtherOrder,
  kWoodscapeJsonPerDegree,
  kWoodscapeJsonKannalaBrandt,
  kWoodscapeJsonReadByNobody,
  kWoodscapeJsonQuaternionZero,
  kWoodscapeJsonQuaternionLength,
  kWoodscapeJsonQuaternionNormalised,
  kWoodscapeJsonCarla,
  kWoodscapeJsonCentreFromMiddle,
  kWoodscapeJsonNoPlace,
  kWoodscapeJsonHalfAPose,
  kWoodscapeJsonPoseMadeUp,
  kWoodscapeJsonHeadline,
  kWoodscapeJsonHeadlineEach,
  kWoodscapeJsonHeadlineNoPose,

  // OpenCV's files, as read and written.

  // Basalt's calibrations, as read and written.

  // ORB-SLAM3's settings, as read and written.

  // VINS-Fusion's files, as read and written.

  // ROS camera_info files, as read and written.

  // What Kalibr says to a file.

  // What OpenVINS says to a file.

  // What cv::FileStorage and PyYAML say to a file.

  // What ROS says to a file.

  // What VINS-Fusion says to a file.

  // What Basalt says to a file.

  // What OpenCV's functions make of a file.

  // What OCamCalib's reader says to a file.

  // What WoodScape's readers say to a file.

  // What the ORB-SLAM programs say to a file.

  // What is said of every program.

  // What a check finds in a file's bytes, and of the programs that read it.

  // What a check finds about lenses and images.

  // What a check finds about poses.

  // What is said of inputs.

  // What is said of a conversion as it was asked for.

  // What is said of the other requests, and of files that are saved.

  kCount  ///< No code: how many there are.
};

/// What a message is about.
enum class About : std::uint8_t {
  kMeaning,  ///< What a file says of the cameras.
  kReader,   ///< What a program makes of a file.
  kUse,      ///< What was asked for.
};

/// A row of the table. {0}, {1} ... stand for the message's arguments (fca/formats/text/message.h says how they are written).
struct CodeInfo {
  Code code;
  std::string_view id;  ///< Public and stable, kebab-case.
  Severity severity = Severity::kError;
  About about = About::kMeaning;
  std::string_view text;              ///< One sentence or clause. Of a loss: what is lost. Of an open question: the question.
  std::string_view why = {};          ///< Of a loss: why the target cannot hold it. Of an open question: why it is open.
  std::string_view consequence = {};  ///< What happens if the file is used as it is; may be empty.
  std::string_view fix = {};          ///< What to do: the fact that is missing, not an option of the command; may be empty.
};

/// The table: one row for each code but kNone.
[[nodiscard]] std::span<const CodeInfo> all_codes();
/// The row of a code. kNone, and what is no code, has an empty one.
[[nodiscard]] const CodeInfo& info(Code code);

}  // namespace fca
