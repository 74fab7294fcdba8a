// SPDX-License-Identifier: BSD-3-Clause
// Both cameras of a stereo pair fitted together, to what stereo feels: the error across epipolar lines.
#pragma once

#include <fca/convert/convert.h>
#include <fca/rectify/vertical_disparity.h>

#include <array>
#include <optional>

namespace fca {

/// One camera of a pair, converted without regard to the other.
struct SeparateFit {
  Camera source;
  Conversion conversion;
  ConvertOptions options;  ///< Those of the conversion.
};

struct PairFit {
  std::array<Conversion, 2> conversions;  ///< A turn is in the report (ConversionReport::turn).
  PairError before;                       ///< Of the two separate fits.
  PairError after;
};

/// Starts at the two fits and minimises the sum of squares of both cameras' pixel errors and, nine times as much, of the rows
/// by which matches differ after rectification, of points at infinity and at ten baselines, up to 60 deg from the rectified
/// axes. What both cameras are off alike makes no difference. With `may_turn` the cameras are turned, too, where a pair's error
/// (PairError) above 0.02 px becomes at least a tenth smaller than without turns. Nothing where a camera's conversion is exact,
/// where the pair cannot be rectified, or where the pair's error does not become smaller.
[[nodiscard]] std::optional<PairFit> fit_pair(const std::array<SeparateFit, 2>& cameras, const Transform& T_second_first,
                                              bool may_turn = true);

}  // namespace fca
