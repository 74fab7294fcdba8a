// SPDX-License-Identifier: BSD-3-Clause
// The verdict on a file, for people.
#pragma once

#include <fca/formats/proof.h>
#include <fca/formats/verdict_value.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// "ready", "use with care", "do not use"
[[nodiscard]] std::string_view in_words(VerdictWord word);

/// A line of a summary: what it is about, and the rest.
struct SummaryLine {
  std::string about;
  std::string text;
  bool operator==(const SummaryLine&) const = default;
};

/// Equal lines about several cameras are one; in 80 columns, each after two blanks.
[[nodiscard]] std::string summary_text(const std::vector<SummaryLine>& lines);

/// One sentence in lines of 80 columns; all but the first stand after two blanks.
[[nodiscard]] std::string wrapped_line(const std::string& sentence);

/// The reasons, and how to write the file all the same. `with_distances`: those in pixels, too, which a summary has with its
/// cameras.
[[nodiscard]] std::vector<SummaryLine> lines_of(const Verdict& verdict, bool with_distances = true);

/// "understood within 0.001 px", "0.12 px rms off (99 %: 0.4, worst 2.9 px)"
[[nodiscard]] std::string distance_in_words(const PixelDistance& distance);

/// "inside the circle that fits into the image; 7.9 px rms over all of it": where that distance was measured.
[[nodiscard]] std::string region_in_words(const CameraDistance& distance);
/// "in the whole image" or "where it has rays": of which part of it CameraDistance::in_image is.
[[nodiscard]] std::string_view image_in_words(const CameraDistance& distance);
/// The share of the image, outside the circle that decides, for which the program has no right ray; 0 where it decides anyway.
[[nodiscard]] double share_without_rays(const CameraDistance& distance);
/// What to do about it, in the command's words; empty: nothing is known.
[[nodiscard]] std::string remedy_of(const Reason& reason);
/// "wrong rays outside the inscribed circle: 20.2 % of the image"
[[nodiscard]] std::string no_rays_outside_in_words(double share);
/// What the line of lines_of() is about that says how to overrule the verdict.
inline constexpr std::string_view kAnyway = "anyway";
/// How many files got each word.
class VerdictCounts {
 public:
  void add(VerdictWord word) { ++counts_.at(static_cast<std::size_t>(word)); }
  /// "9 ready, 0 use with care, 1 do not use"
  [[nodiscard]] std::string in_words() const;

 private:
  std::array<std::size_t, 3> counts_{};  ///< By the word's place in the enumeration.
};

/// The text with the first ": ready" (or whatever the word is) in the verdict's colour, for terminals.
[[nodiscard]] std::string with_colour(std::string text, VerdictWord word);

}  // namespace fca::cli
