// SPDX-License-Identifier: BSD-3-Clause
// Pages made as a user makes them, and what is in them.
#pragma once

#include "cli/run_program.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace fca::test {

inline const std::string kEquidistant = R"(cam0:
  camera_model: pinhole
  intrinsics: [100.0, 100.0, 199.5, 149.5]
  distortion_model: equidistant
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
  resolution: [400, 300]
)";

/// The page on standard output.
inline std::string page(const std::vector<std::string>& words, const RunOptions& options = {}) {
  std::vector<std::string> all = {"report"};
  all.insert(all.end(), words.begin(), words.end());
  const RunResult run = run_program(all, options);
  EXPECT_LE(run.code, 1) << run.err;  // 1: the verdict is against the file, and the page says so
  return run.out;
}

inline std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// What stands between each `before` and the next `after`.
inline std::vector<std::string> all_between(std::string_view text, std::string_view before, std::string_view after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string_view::npos; at = text.find(before, at)) {
    at += before.size();
    found.emplace_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

/// With the opacity that it leaves out where all of it is opaque.
inline cv::Mat4b with_opacity(const cv::Mat& picture) {
  if (picture.type() == CV_8UC4) return picture;
  EXPECT_EQ(picture.type(), CV_8UC3);
  cv::Mat4b result(picture.size());
  std::transform(picture.begin<cv::Vec3b>(), picture.end<cv::Vec3b>(), result.begin(),
                 [](const cv::Vec3b& pixel) { return cv::Vec4b(pixel[0], pixel[1], pixel[2], 0xFF); });
  return result;
}

/// The pictures of a page, decoded: four channels.
inline std::vector<cv::Mat4b> pictures(const std::string& page) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<cv::Mat4b> decoded;
  for (const std::string& text : all_between(page, "data:image/png;base64,", "\"")) {
    std::vector<std::uint8_t> bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char digit : text.substr(0, text.find('='))) {
      bits = bits << 6U | static_cast<unsigned>(kDigits.find(digit));
      count += 6;
      if (count < 8) continue;
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count)));
    }
    decoded.push_back(with_opacity(cv::imdecode(bytes, cv::IMREAD_UNCHANGED)));
  }
  return decoded;
}

}  // namespace fca::test
