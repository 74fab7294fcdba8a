// SPDX-License-Identifier: BSD-3-Clause
// Private: cv::FileStorage for bytes that nobody vouches for. OpenCV 4.6 recurses with some 6 kB of stack per nested list and
// has no limit of its own: 100,000 brackets end the process. It allocates a matrix of the size a file specifies before it looks
// at the numbers: `rows: 1073741824` takes 34 GB.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "fca/code.h"
#include "fca/formats/consumers/consumer.h"

namespace fca::consumers::storage {

/// Why the bytes are not given to cv::FileStorage (too large, no text, nested too deep); kNone if they are.
[[nodiscard]] Code obstacle_of(std::string_view bytes);

/// Runs `body` on the file as a program holds it that reads it with cv::FileStorage. What keeps OpenCV from opening it, and
/// what it or `body` throws, is a refusal, and a refused view holds neither cameras nor poses. `reader`, a name or reader_of():
/// who does not take the file.
[[nodiscard]] ConsumerView read(std::string_view bytes, std::string_view program, const Argument& reader,
                                const std::function<void(const cv::FileStorage&, ConsumerView&)>& body);

/// "OpenCV's reader, which OpenVINS uses,".
[[nodiscard]] inline Message reader_of(std::string_view program) { return {Code::kStorageReaderOf, {program}}; }

/// fs[key] >> Mat for a map: what OpenCV would allocate in vain or write past is asked first.
/// Throws cv::Exception: fault_of() says what keeps OpenCV from reading it.
[[nodiscard]] cv::Mat read_matrix(const cv::FileNode& node);

[[nodiscard]] bool is_number(const cv::FileNode& node);
/// "20.0", "the string \"x\"", "a list": a node for sentences, a number or a clause. Reals keep a '.', so that they differ from
/// ints.
[[nodiscard]] Argument description_of(const cv::FileNode& node);

/// Why OpenCV threw, or read_matrix(): a clause, or OpenCV's own words.
[[nodiscard]] Argument fault_of(const cv::Exception& error);

/// A text of others for a sentence: without its line ends.
[[nodiscard]] std::string one_line(std::string text);

}  // namespace fca::consumers::storage
