// SPDX-License-Identifier: BSD-3-Clause
// Which program's YAML: the same bytes mean different things to PyYAML (Kalibr) and to cv::FileStorage (ORB-SLAM3, OpenCV).
#pragma once

#include <fca/formats/text/node.h>

#include <optional>
#include <string_view>
#include <vector>

namespace fca::text {

enum class Dialect {
  kPyYaml,  ///< Kalibr. The last of duplicate keys counts; 1e-5 is a string.
  kOpenCv,  ///< cv::FileStorage. The first of duplicate keys counts; 1e-5 is a real, 017 is 15.
};

/// What a scalar is to the program.
enum class ScalarType { kText, kInteger, kReal };

[[nodiscard]] ScalarType scalar_type(const Node& scalar, Dialect dialect);

/// The entry that counts under that key; null if there is none or `mapping` is no mapping.
[[nodiscard]] const Node* find(const Node& mapping, std::string_view key, Dialect dialect);
/// The same with its key.
[[nodiscard]] const Entry* find_entry(const Node& mapping, std::string_view key, Dialect dialect);

/// The entries of a mapping that do not count, because another with the same key does; in file order.
[[nodiscard]] std::vector<const Entry*> shadowed_entries(const Node& mapping, Dialect dialect);

}  // namespace fca::text
