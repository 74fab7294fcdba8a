// SPDX-License-Identifier: BSD-3-Clause
// How large a document may be, besides kMaxFileBytes (source.h) and kMaxDepth (node.h).
#pragma once

#include <cstddef>

namespace fca::text {

/// Values of a list, keys of a mapping, lines of words, words of a line. A calibration's longest lists are the detected corners
/// that OpenCV's calibrators keep: some 10,000 numbers. A node takes 200 bytes, so that a file of kMaxFileBytes full of commas
/// would take hundreds of megabytes.
inline constexpr std::size_t kLongestList = 100'000;

}  // namespace fca::text
