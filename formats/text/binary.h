// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras.bin and rigs.bin as the lines of words that cameras.txt and rigs.txt have. All numbers are little endian
// (colmap@5d968cf, scene/reconstruction_io_binary.cc):
//   cameras  uint64 how many; of each  uint32 id, int32 model, uint64 width, uint64 height, its model's parameters as doubles
//   rigs     uint64 how many; of each  uint32 id, uint32 sensors; of the first sensor  int32 type, uint32 id; of the others
//            int32 type, uint32 id, uint8 has_pose, and 7 doubles if that is 1
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::text {

/// The tag of a document's root: what it holds.
inline constexpr std::string_view kCamerasTag = "cameras";
inline constexpr std::string_view kRigsTag = "rigs";

/// The root is a sequence with one item for each camera or rig, a sequence of words. A word's value is what the text file would
/// have there (of models and types of sensors their names), its span its bytes, and its tag how they are encoded. A file is
/// what it is as a whole; one that is neither is refused as what its name says.
[[nodiscard]] std::optional<Node> parse_binary(const Source& source, Diagnostics& diagnostics);

/// The bytes of a word with that tag that says `text`: a number or name that such a word can say.
[[nodiscard]] std::string encoded(std::string_view tag, std::string_view text);

/// The tag of numbers behind a camera's height and of a pose.
inline constexpr std::string_view kRealTag = "double";

/// A file of such lines. `what`: kCamerasTag or kRigsTag.
[[nodiscard]] std::string binary_file(std::string_view what, std::span<const std::vector<std::string>> lines);

}  // namespace fca::text
