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
  kNone,  ///< Says nothing.

  // Rigs and their images.
  kCropOutside,
  kBinningImpossible,
  kResizeImpossible,
  kImageSizeNotStated,
  kLensCircleStretched,

  // What a format cannot hold.
  kTimeOffsetDropped,
  kTumviHasNoTimeOffset,
  kTumviPoseRecomputed,
  kWoodscapeStaleTranslation,

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
