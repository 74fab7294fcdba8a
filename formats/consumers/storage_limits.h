// SPDX-License-Identifier: BSD-3-Clause
// Private: what bytes must be before cv::FileStorage sees them. OpenCV 4.6 recurses with some 6 kB of stack per nested list and
// has no limit of its own: 100,000 brackets end the process.
#pragma once

#include <string>
#include <string_view>

namespace fca::consumers::storage {

/// Why the bytes are not given to cv::FileStorage (too large, no text, nested too deep), or "".
[[nodiscard]] std::string find_obstacle(std::string_view bytes);

/// A message of OpenCV for a sentence: without its line ends.
[[nodiscard]] std::string one_line(std::string text);

}  // namespace fca::consumers::storage
