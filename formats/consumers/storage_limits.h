// SPDX-License-Identifier: BSD-3-Clause
// Private: what bytes must be before cv::FileStorage sees them. OpenCV 4.6 recurses with some 6 kB of stack per nested list and
// has no limit of its own: 100,000 brackets end the process. It allocates a matrix of the size a file states before it looks at
// the numbers: `rows: 1073741824` takes 34 GB.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <string_view>

namespace fca::consumers::storage {

/// Why the bytes are not given to cv::FileStorage (too large, no text, nested too deep), or "".
[[nodiscard]] std::string find_obstacle(std::string_view bytes);

/// fs[key] >> Mat for a map: what OpenCV would allocate in vain or write past is asked first.
/// Throws cv::Exception: `err` says what keeps OpenCV from reading it.
[[nodiscard]] cv::Mat read_matrix(const cv::FileNode& node);

/// A message of OpenCV for a sentence: without its line ends.
[[nodiscard]] std::string one_line(std::string text);

}  // namespace fca::consumers::storage
