// SPDX-License-Identifier: BSD-3-Clause
// How WoodScape's principal point and ours map onto each other.
#pragma once

namespace fca::woodscape {

/// The principal point's coordinate; `size`: width for cx, height for cy.
[[nodiscard]] double centre_of(double offset, int size);
/// The offset from which centre_of makes exactly that coordinate. Where no double does (a centre far to the left of the image's
/// middle has finer digits than its offset), the nearest.
[[nodiscard]] double offset_of(double centre, int size);

}  // namespace fca::woodscape
