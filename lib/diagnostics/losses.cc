// SPDX-License-Identifier: BSD-3-Clause
// What formats cannot hold. {0} is the owner (a camera, a file), {1} the key; the values follow, as a rule first why.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> loss_codes() {
  static constexpr std::string_view kCopyThem = "copy those that still hold from the old file";
  static constexpr std::array kRows = {
      loss(Code::kNotCarried, "not-carried", "{0:_}{1}", "{2}"),
      loss(Code::kNotCarriedValue, "not-carried", "{0:_}{1} {3:short}", "{2}"),
      loss(Code::kNotCarriedGroup, "not-carried", "{1}* ({3} keys)", "{2}"),
      loss(Code::kTopicDropped, "topic-dropped", "{0} {3}", "{2}",
           "remap the program's topic to it when you start the program"),
      loss(Code::kFrameRateDropped, "frame-rate-dropped", "{0} {3} Hz", "{2}",
           "give it to the program, if the program has an option for it"),
      loss(Code::kOtherTimeOffset, "time-offset-dropped", "{0} time offset {3:.9} s", "{2}, {4:.9} s",
           "add {5:.9} s to every image time stamp of {0}"),
      loss(Code::kCommentsReplaced, "comments-dropped", "comment{3:s} {3}", "{2}", kCopyThem),
      loss(Code::kManyCommentsReplaced, "comments-dropped", "comments {3:,} and {4} more", "{2}", kCopyThem),
      loss(Code::kCommentsOfFileDropped, "comments-dropped", "comments of {0}", "{2}", kCopyThem),
      loss(Code::kHeaderDropped, "header-dropped", "first line {3} of {0}", "{2}",
           "cv::FileStorage (OpenVINS) reads no file without it"),
      clause(Code::kFileRewritten, "a fresh file is written"),
      clause(Code::kFileRewrittenBecause, "a fresh file is written: {0}"),
      clause(Code::kReplacedOrRemoved, "the old content there is replaced or removed"),
      clause(Code::kKeepsItsOwnValue, "the base file keeps its own value"),
      loss(Code::kTimeOffsetDropped, "time-offset-dropped", "{0} {1} {2:.12} s", "{3}",
           "add {2:.12} s to every image time stamp of {0}"),
      clause(Code::kTumviHasNoTimeOffset, "TUM-VI's chains have none: the dataset's offsets are removed from its time stamps"),
      loss(Code::kPoseRecomputed, "pose-recomputed", "pose of {0} in {2}",
           "its matrix is not an exact rotation, and {1} holds the nearest one",
           "nothing to do: the nearest rotation is the right one"),
      loss(Code::kTumviPoseRecomputed, "pose-recomputed", "{0} {1}",
           "in the input it differs from T_cn_cnm1 times the pose of {2} by up to {3:.3} in an element; in TUM-VI's files the "
           "two agree",
           "check which of the two is right"),
      loss(Code::kWoodscapeStaleTranslation, "stale-derived", "extrinsic.{1}", "it keeps its old value next to a new pose",
           "remove it, or write the new pose's translation"),
      clause(Code::kSeveralFilesBecomeOne, "several files become one"),
      clause(Code::kFilesHaveNoPlace, "files of {0} have no place for it"),
      loss(Code::kImuDropped, "imu-dropped", "{0} noise and rate", "{2}",
           "keep its file, or write it to a file of its own, in a format that holds a complete IMU"),
      loss(Code::kBaselineDropped, "baseline-dropped", "{1} {3} m", "{2}",
           "keep it for programs that ask for the baseline separately"),
      loss(Code::kRectificationDropped, "rectification-dropped",
           "the rectified pair of {0} and {2} (fx {3:.6} px, baseline {4:.4} m)", "{5}",
           "keep the input, or write settings of rectified images"),
      // {2}: the poses' names, {3}: a program, {4} and {5}: clauses.
      loss(Code::kPoseDropped, "pose-dropped", "{2}", "the file for {3} does not contain it{4}", "{5}"),
      clause(Code::kPosesOfGroupsKept, "; {0:and} keep their relative poses"),
      clause(Code::kPosesOfGroup, "{0}"),
      clause(Code::kKeepTheInput, kKeepTheInput),
  };
  return kRows;
}

}  // namespace fca::diagnostics
