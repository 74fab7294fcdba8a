// SPDX-License-Identifier: BSD-3-Clause
// Both cameras of a stereo pair fitted together, to what stereo feels: by how much the two images of a point miss each other's
// row after rectification.
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
/// by which matches differ, at infinity and at ten baselines. A difference is that of the cameras' errors along the normal of
/// the epipolar line: what both have in common goes unfelt. The cameras are turned, too, where that makes the difference at
/// least a tenth smaller than a fit without turns. Nothing where nothing was fitted, where the pair cannot be rectified, or
/// where the difference does not become smaller.
[[nodiscard]] std::optional<PairFit> fit_pair(const std::array<SeparateFit, 2>& cameras, const Transform& T_second_first);

}  // namespace fca
